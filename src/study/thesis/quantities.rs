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
pub(super) enum Quantity {
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
    /// A run without its series; `None` is not a number.
    Run(fn(&Run) -> Option<f64>),
    /// The word for the outcome of a run.
    Word(fn(&Run) -> &'static str),
    Series(fn(&Run) -> Value),
    /// The scene alone, and a displacement, m.
    Scene(fn(&Scene, f64) -> f64),
    Several(fn(&Runs<'_>, Algorithm, &Scene) -> Value),
}

/// A row for each quantity: what it is of, its name, its unit, and how it is computed.
macro_rules! quantities {
    ($($of:ident $name:literal $unit:literal $get:expr;)*) => {
        /// The quantities of this study; SI units but for `percent` and `travel`.
        static OWN: &[Own] = &[$(Own { name: $name, unit: $unit, get: Get::$of($get) }),*];
    };
}

quantities! {
    // Depth at the first arrest; infinite for a perforation.
    Several "depth" "m" |runs, method, scene| Value::Number(runs.depth_m(method, scene));
    // The same over that of the shot on a rigid mount.
    Several "percent" "%" |runs, method, scene| Value::Number(runs.percent(method, scene));
    // The plate's greatest displacement, mm; infinite where nothing stops the plate.
    Run "travel" "mm" |run| {
        Some(run.max_plate_displacement_m.map_or(f64::INFINITY, |x| 1e3 * x))
    };
    // When the projectile is at rest: with the plate at its greatest displacement, or where nothing moves at the arrest.
    Run "rest_time" "s" |run| {
        let turn = run.events.iter().find(|it| it.kind == EventKind::GreatestDisplacement);
        turn.map(|it| it.t_s).or_else(|| run.first_arrest.map(|it| it.t_s))
    };
    Word "outcome" "-" |run| run.outcome.word();
    Word "end_reason" "-" |run| run.end.words();
    // Velocities behind the plates of a stack.
    Series "arriving" "m/s" |run| {
        let behind = run.stack.iter().flat_map(|stack| &stack.behind);
        Value::numbers(behind.map(|run| run.scene.projectile.velocity_m_s))
    };
    Series "start_velocity" "m/s" |run| {
        Value::optional(run.series.first().map(|row| row.plate_velocity_m_s))
    };
    // Millimetres; not of a plate that is perforated.
    Series "displacement_at_end" "mm" series::displacement_at_end_mm;
    Series "last_force" "N" series::last_force;
    Series "greatest_spring_force" "N" |run| {
        Value::Number(run.series.iter().map(|row| row.spring_force_n).fold(0.0, larger))
    };
    // What the projectile loses, and its force summed over time, N s.
    Series "momentum" "N s" series::momentum;
    Series "impulse" "N s" series::impulse;
    // m dv/dt over the force, early in the contact.
    Series "acceleration_ratio" "-" series::acceleration_ratio;
    // The greatest distance of the force history from a half-sine of its peak and duration, over the peak.
    Series "off_half_sine" "-" series::off_half_sine;
    Series "velocities_after_contact" "m/s" series::velocities_after_contact;
    Series "velocity_at_neutral" "m/s" series::velocity_at_neutral;
    // Of projectile and plate, N s.
    Series "momentum_at_arrest" "N s" series::momentum_at_arrest;
    Series "jump_after_contact" "m" series::jump_after_contact;
    Series "turns_in_contact" "-" series::turns_in_contact;
    Series "speed_in_contact" "m/s" series::speed_in_contact;
    // Energy when the plate comes back through neutral, over that at the first turn.
    Series "energy_after_return" "-" series::energy_after_return;
    // The ballistic limit in closed form, of a fixed plate or of a free one.
    Scene "limit" "m/s" |scene, _| limit::closed_form(scene).unwrap_or(f64::NAN);
    Scene "flow_strength" "Pa" |scene, _| scene.flow_strength_pa();
    Scene "nose_pressure" "Pa" |scene, _| {
        let v = scene.projectile.velocity_m_s;
        scene.flow_strength_pa() + scene.drag_kg_m3() * v * v
    };
    Scene "spring_force" "N" |scene, x| spring(scene).force(x);
    Scene "spring_tangent" "N/m" |scene, x| spring(scene).tangent(x);
    Scene "spring_energy" "J" |scene, x| spring(scene).energy(x);
    Scene "yield_displacement" "m" |scene, _| {
        scene.mechanism.spring.yields_at_m().unwrap_or(f64::NAN)
    };
    // Depth over that of the solid plate of equal mass, and mass efficiency by the ballistic limit.
    Several "against_solid" "-" |_, _, scene| against_solid(scene);
    // Energy drawn into the spring for a fifth less depth than uncocked.
    Several "energy_for_a_fifth" "J" energy_for_a_fifth_j;
    // The power law nearest to a spring's force up to where its plate goes: greatest distance over greatest force.
    Several "distance_from_power_law" "-" distance_from_power_law;
    // The strength below which the plate is perforated.
    Several "least_strength" "Pa" least_strength_pa;
    // The greatest percentage of the baseline over a grid of Table 9.2.
    Several "greatest_percent_of_table_9_2" "%" greatest_percent;
    // The relative velocity with which the listing ends the contact.
    Several "listing_overshoot" "m/s" |_, _, scene| listing_overshoot(scene);
}

impl Quantity {
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
            Self::Output(column) if column.needs_course(scene) => {
                return Value::optional(column.value(&runs.run_with_series(method, scene)));
            }
            Self::Output(column) => {
                return Value::optional(column.value(&runs.run(method, scene)));
            }
            Self::Own(own) => own,
        };
        match own.get {
            Get::Run(get) => Value::optional(get(&runs.run(method, scene))),
            Get::Word(get) => Value::Text(get(&runs.run(method, scene)).to_owned()),
            Get::Series(get) => get(&runs.run_with_series(method, scene)),
            Get::Scene(get) => Value::Number(get(scene, x_m)),
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
    Value::List(vec![Value::optional(depth), Value::optional(efficiency)])
}

fn energy_for_a_fifth_j(runs: &Runs<'_>, method: Algorithm, scene: &Scene) -> Value {
    let depth = |d: f64| runs.percent(method, &changed(scene, &[("d", d)]));
    let wanted = 0.8 * depth(0.0);
    let d = root::in_bracket(0.0, 0.5, |d| depth(d) - wanted);
    Value::Number(spring(scene).energy(d))
}

/// n from 0.1 to 3 as in Table 9.2, c at its best.
fn distance_from_power_law(runs: &Runs<'_>, method: Algorithm, scene: &Scene) -> Value {
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
    Value::Number(best)
}

fn least_strength_pa(runs: &Runs<'_>, method: Algorithm, scene: &Scene) -> Value {
    let (mut low, mut high) = (1e7, 2e8);
    for _ in 0..30 {
        let middle = 0.5 * (low + high);
        let run = runs.run(method, &changed(scene, &[("S_y", middle)]));
        if run.outcome == Outcome::Perforated { low = middle } else { high = middle }
    }
    Value::Number(high)
}

fn greatest_percent(runs: &Runs<'_>, method: Algorithm, scene: &Scene) -> Value {
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
    Value::Number(greatest)
}

fn listing_overshoot(scene: &Scene) -> Value {
    let scheme = Scheme::of(scene, scene.contact.appendix);
    let mut state = scheme.start();
    let mut steps = 0;
    while scheme.ended(&state).is_none_or(|_| steps == 0) && steps < 10_000 {
        steps += 1;
        if scheme.step(&mut state).is_err() {
            break;
        }
    }
    Value::Number(state.slip_m_s)
}
