//! The quantities of a scene that expressions of the claims may name: the program's outputs, and a row for each other one.

use std::sync::Arc;

use crate::model::appendix::Scheme;
use crate::model::mechanism::{Mechanism, Spring};
use crate::model::run::{EventKind, Outcome, Run};
use crate::model::scene::Scene;
use crate::numerics::{larger, root};
use crate::study::compare::{self, Candidate, Hardware};
use crate::study::context::{Context, to_its_end};
use crate::study::limit;
use crate::study::quantities;
use crate::study::thesis::runs::{Algorithm, Runs, changed};
use crate::study::thesis::series;
use crate::study::thesis::value::Value;

#[derive(Clone, Copy)]
pub(super) enum ClaimQuantity {
    /// One of the program's outputs.
    Output(&'static quantities::Quantity),
    /// One of this study.
    Own(&'static Own),
}

pub(super) struct Own {
    name: &'static str,
    unit: &'static str,
    get: Get,
}

#[derive(Clone, Copy)]
enum Get {
    /// A run without its series.
    Run(fn(&Run) -> Value),
    Series(fn(&Run) -> Value),
    /// The scene alone, and a displacement, m.
    Scene(fn(&Scene, f64) -> Value),
    Several(fn(&Runs<'_>, Algorithm, &Scene) -> Value),
}

/// A row for each quantity: what it is of, its name, its unit, and how it is computed.
macro_rules! quantities {
    ($($of:ident $name:literal $unit:literal |$($own:pat_param),+| $get:expr;)*) => {
        /// The quantities of this study; SI units but for `percent` and `travel`.
        static OWN: &[Own] =
            &[$(Own { name: $name, unit: $unit, get: Get::$of(|$($own),+| $get.into()) }),*];
    };
}

quantities! {
    // Depth at the first arrest; infinite for a perforation.
    Several "depth" "m" |runs, method, scene| runs.depth_m(method, scene);
    // The same over that of the shot on a rigid mount.
    Several "percent" "%" |runs, method, scene| runs.percent(method, scene);
    // The plate's greatest displacement, mm; infinite where nothing stops the plate.
    Run "travel" "mm" |run| run.max_plate_displacement_m.map_or(f64::INFINITY, |x| 1e3 * x);
    // When the projectile is at rest: with the plate at its greatest displacement, or where nothing moves at the arrest.
    Run "rest_time" "s" |run| {
        let turn = run.events.iter().find(|it| it.kind == EventKind::GreatestDisplacement);
        turn.map(|it| it.t_s).or_else(|| run.first_arrest.map(|it| it.t_s))
    };
    Run "outcome" "-" |run| run.outcome.word();
    Run "end_reason" "-" |run| run.end.words();
    // Velocities behind the plates of a stack.
    Series "arriving" "m/s" |run| {
        let behind = run.stack.iter().flat_map(|stack| &stack.behind);
        Value::numbers(behind.map(|run| run.scene.projectile.velocity_m_s))
    };
    Series "start_velocity" "m/s" |run| run.series.first().map(|row| row.plate_velocity_m_s);
    // Millimetres; not of a plate that is perforated.
    Series "displacement_at_end" "mm" |run| series::displacement_at_end_mm(run);
    Series "last_force" "N" |run| series::last_force(run);
    Series "greatest_spring_force" "N" |run| {
        run.series.iter().map(|row| row.spring_force_n).fold(0.0, larger)
    };
    // What the projectile loses, and its force summed over time, N s.
    Series "momentum" "N s" |run| series::momentum(run);
    Series "impulse" "N s" |run| series::impulse(run);
    // m dv/dt over the force, early in the contact.
    Series "acceleration_ratio" "-" |run| series::acceleration_ratio(run);
    // The greatest distance of the force history from a half-sine of its peak and duration, over the peak.
    Series "off_half_sine" "-" |run| series::off_half_sine(run);
    Series "velocities_after_contact" "m/s" |run| series::velocities_after_contact(run);
    Series "velocity_at_neutral" "m/s" |run| series::velocity_at_neutral(run);
    // Of projectile and plate, N s.
    Series "momentum_at_arrest" "N s" |run| series::momentum_at_arrest(run);
    Series "jump_after_contact" "m" |run| series::jump_after_contact(run);
    Series "turns_in_contact" "-" |run| series::turns_in_contact(run);
    Series "speed_in_contact" "m/s" |run| series::speed_in_contact(run);
    // Energy when the plate comes back through neutral, over that at the first turn.
    Series "energy_after_return" "-" |run| series::energy_after_return(run);
    // The ballistic limit in closed form, of a fixed plate or of a free one.
    Scene "limit" "m/s" |scene, _| limit::closed_form(scene);
    Scene "flow_strength" "Pa" |scene, _| scene.flow_strength_pa();
    Scene "nose_pressure" "Pa" |scene, _| {
        let v = scene.projectile.velocity_m_s;
        scene.flow_strength_pa() + scene.drag_kg_m3() * v * v
    };
    Scene "spring_force" "N" |scene, x| spring(scene).force(x);
    Scene "spring_tangent" "N/m" |scene, x| spring(scene).tangent(x);
    Scene "spring_energy" "J" |scene, x| spring(scene).energy(x);
    Scene "yield_displacement" "m" |scene, _| scene.mechanism.spring.yields_at_m();
    // Depth over that of the solid plate of equal mass, and mass efficiency by the ballistic limit.
    Several "against_solid" "-" |_, _, scene| against_solid(scene);
    // Energy drawn into the spring for a fifth less depth than uncocked.
    Several "energy_for_a_fifth" "J" |runs, method, scene| energy_for_a_fifth_j(runs, method, scene);
    // The power law nearest to a spring's force up to where its plate goes: greatest distance over greatest force.
    Several "distance_from_power_law" "-" |runs, method, scene| distance_from_power_law(runs, method, scene);
    // The strength below which the plate is perforated.
    Several "least_strength" "Pa" |runs, method, scene| least_strength_pa(runs, method, scene);
    // The greatest percentage of the baseline over a grid of Table 9.2.
    Several "greatest_percent_of_table_9_2" "%" |runs, method, scene| greatest_percent(runs, method, scene);
    // The relative velocity with which the listing ends the contact.
    Several "listing_overshoot" "m/s" |_, _, scene| listing_overshoot(scene);
}

impl ClaimQuantity {
    pub(super) fn find(name: &str) -> Option<Self> {
        let own = OWN.iter().find(|it| it.name == name).map(Self::Own);
        own.or_else(|| quantities::find(name).map(Self::Output))
    }

    pub(super) fn unit(self) -> &'static str {
        match self {
            Self::Output(column) => column.unit(),
            Self::Own(own) => own.unit,
        }
    }

    /// Its value for a scene by a method, at a displacement where it depends on one.
    pub(super) fn of(self, runs: &Runs<'_>, method: Algorithm, scene: &Scene, x_m: f64) -> Value {
        let own = match self {
            Self::Output(it) if it.needs_course(scene) => {
                return it.value(&runs.run_with_series(method, scene)).into();
            }
            Self::Output(it) => return it.value(&runs.run(method, scene)).into(),
            Self::Own(own) => own,
        };
        match own.get {
            Get::Run(get) => get(&runs.run(method, scene)),
            Get::Series(get) => get(&runs.run_with_series(method, scene)),
            Get::Scene(get) => get(scene, x_m),
            Get::Several(get) => get(runs, method, scene),
        }
    }
}

fn spring(scene: &Scene) -> Spring {
    Mechanism::of(scene).spring
}

fn against_solid(scene: &Scene) -> Value {
    let mut watch = to_its_end;
    let context = &mut Context::new(1, &mut watch);
    let report = compare::compare(&Arc::new(scene.clone()), Hardware::default(), context).ok();
    let report = report.as_ref();
    let efficiency = report.and_then(|report| report.of(Candidate::Scene)?.mass_efficiency());
    let depth = report.and_then(compare::Report::depth_over_solid);
    Value::List(vec![depth.into(), efficiency.into()])
}

fn energy_for_a_fifth_j(runs: &Runs<'_>, method: Algorithm, scene: &Scene) -> f64 {
    let depth = |d: f64| runs.percent(method, &changed(scene, &[("d", d)]));
    let wanted = 0.8 * depth(0.0);
    let d = root::in_bracket(0.0, 0.5, |d| depth(d) - wanted);
    spring(scene).energy(d)
}

/// n from 0.1 to 3 as in Table 9.2, c at its best.
fn distance_from_power_law(runs: &Runs<'_>, method: Algorithm, scene: &Scene) -> f64 {
    let reach = runs.run(method, scene).max_plate_displacement_m.unwrap_or(f64::NAN);
    let spring = spring(scene);
    let points: Vec<(f64, f64)> = (1..=40)
        .map(|i| f64::from(i) / 40.0)
        .map(|part| (part, spring.force(part * reach)))
        .collect();
    let most = points.iter().map(|(_, force)| force.abs()).fold(0.0, larger);
    let mut best = f64::INFINITY;
    for n in 1..=30 {
        let powers: Vec<f64> = points.iter().map(|(x, _)| x.powf(0.1 * f64::from(n))).collect();
        for c in 0..=50 {
            let c = most * 0.03 * f64::from(c);
            let off =
                points.iter().zip(&powers).map(|((_, force), power)| (c * power - force).abs());
            let worst = off.fold(0.0, larger) / most;
            best = if worst < best { worst } else { best };
        }
    }
    best
}

fn least_strength_pa(runs: &Runs<'_>, method: Algorithm, scene: &Scene) -> f64 {
    let (mut low, mut high) = (1e7, 2e8);
    for _ in 0..30 {
        let middle = 0.5 * (low + high);
        let run = runs.run(method, &changed(scene, &[("S_y", middle)]));
        if run.outcome == Outcome::Perforated { low = middle } else { high = middle }
    }
    high
}

fn greatest_percent(runs: &Runs<'_>, method: Algorithm, scene: &Scene) -> f64 {
    let mut greatest = 0.0;
    for gamma in [0.8, 2.0, 7.0] {
        for (k, n) in [(0.0, 1.0), (1e5, 0.5), (1e5, 3.0), (1e6, 1.0), (7.5e6, 1.0), (7.5e6, 0.3)] {
            for (d, b) in [(0.0, 0.0), (0.0, 2000.0), (0.1, 0.0), (0.5, 200.0)] {
                let changes = [("gamma", gamma), ("k", k), ("n", n), ("d", d), ("b", b)];
                let percent = runs.percent(method, &changed(scene, &changes));
                // The printed scheme breaks off on the most violent designs.
                greatest = if percent > greatest { percent } else { greatest };
            }
        }
    }
    greatest
}

fn listing_overshoot(scene: &Scene) -> f64 {
    let scheme = Scheme::of(scene, scene.contact.appendix);
    let mut state = scheme.start();
    let mut steps = 0;
    while scheme.ended(&state).is_none_or(|_| steps == 0) && steps < 10_000 {
        steps += 1;
        if scheme.step(&mut state).is_err() {
            break;
        }
    }
    state.slip_m_s
}
