//! The contact kernel: from first contact to first arrest or exit, without series, energy ledger, events or outcome. For sweeps
//! and searches that request nothing else.
//!
//! A contact is planned before it is run ([`Contact::of`]). Without spring and damper it is done in closed form (`free.rs`). Else
//! the Taylor recurrence of `motion.rs` is unrolled at compile time for each kind of spring and damper (`law.rs`, `expansion.rs`)
//! and integrated step by step (`integration.rs`). A law that is singular at the start either hardly matters in the first step
//! (`perturbation_start.rs`), or the start is placed by a balance of powers (`similarity_start.rs`). The plate may follow the
//! slow manifold of a stiff spring (`slow_manifold.rs`, `slow_manifold_series.rs`). Scenes it is not made for (a stop, an oblique
//! section across the cylinder, a plate that comes back through a singular point, a damper too strong for its steps) are left to
//! the simulation: [`Contact::run`] returns `None`.

use crate::model::closed_form::Passage;
use crate::model::contact::{AreaLaw, AreaPiece, Geometry};
use crate::model::fixed_plate::plate_is_fixed;
use crate::model::mechanism::{Mechanism, PowerKind, PowerLaw, Spring};
use crate::model::scene::{ContactModel, Mount, Scene};
use crate::numerics::{larger, smaller};
use expansion::{Constants, StepTime};
use integration::{InitialPhase, Plan};
use similarity_start::Start;
use slow_manifold_series::MANIFOLD_BELOW;

/// An expression compiled for each number of terms.
macro_rules! by_terms {
    ($terms:expr, $n:ident => $expression:expr) => {
        match $terms {
            crate::model::contact_kernel::TERMS_LOOSE => {
                const $n: usize = crate::model::contact_kernel::TERMS_LOOSE;
                $expression
            }
            crate::model::contact_kernel::TERMS => {
                const $n: usize = crate::model::contact_kernel::TERMS;
                $expression
            }
            _ => {
                const $n: usize = crate::model::contact_kernel::TERMS_TIGHT;
                $expression
            }
        }
    };
}

mod expansion;
mod free;
mod integration;
mod law;
mod perturbation_start;
mod plain;
mod similarity_start;
mod slow_manifold;
mod slow_manifold_series;

/// Terms of the expansion, for tolerances from [`LOOSE`] up, down to [`TIGHT`], and below.
const TERMS_LOOSE: usize = 11;
const TERMS: usize = 14;
const TERMS_TIGHT: usize = 18;
const LOOSE: f64 = 3e-6;
const TIGHT: f64 = 3e-10;
/// How tight a singular start of a plate on the slow manifold of its spring can be made.
const MANIFOLD_TOLERANCE_MIN: f64 = 1e-11;
/// Part of the force that is reached at least, if it grew as at first contact.
const GROWN_PART: f64 = 0.3;
/// The least part of a tolerance that is used for the plate's sake: less is within rounding.
const PLATE_TOLERANCE_MIN: f64 = 1e-4;
/// First unit of a graded clock, relative to where it starts.
const GRADED_UNIT: f64 = 0.6;

/// One contact, prepared: everything that does not change during the contact.
#[derive(Clone, Debug)]
pub struct Contact {
    geometry: Geometry,
    spring: PowerLaw,
    damper: PowerLaw,
    constants: Constants,
    start_m: f64,
    /// The time in which a force growing as at first contact, or the preload, would stop the slip, s.
    scale_s: Option<f64>,
    /// A spring that is not a power law, a stop, or another interaction model.
    left_to_others: bool,
}

/// Which of the laws are singular where the contact starts.
#[derive(Clone, Copy)]
struct Singular {
    spring: bool,
    damper: bool,
}

/// Whether a law is linear, or none at all.
fn is_linear(law: PowerLaw) -> bool {
    matches!(law.kind(), PowerKind::Absent | PowerKind::Linear)
}

/// Whether a damper cannot be expanded at rest: any but a linear one and a square.
fn is_singular(damper: PowerLaw) -> bool {
    !is_linear(damper) && damper.kind() != PowerKind::Whole(2)
}

/// The contact of a valid scene to the relative accuracy `tolerance`, prepared no further than it needs; `None` where the
/// simulation is needed.
pub fn contact_end(scene: &Scene, tolerance: f64) -> Option<ContactEnd> {
    free::contact_end(scene, tolerance).or_else(|| Contact::of(scene).run(tolerance))
}

/// How a contact ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactEnd {
    /// Common velocity was reached; otherwise the nose is clear of the rear face.
    pub arrested: bool,
    /// When, s.
    pub t_s: f64,
    /// Depth then, m.
    pub penetration_m: f64,
    /// Plate displacement then, m.
    pub plate_displacement_m: f64,
    /// Plate velocity then, m/s.
    pub plate_velocity_m_s: f64,
    /// Greatest plate displacement up to then, m.
    pub max_displacement_m: f64,
    /// Steps taken.
    pub steps: usize,
}

impl Contact {
    /// Prepare the contact of a scene that has been validated.
    pub fn of(scene: &Scene) -> Self {
        let geometry = Geometry::of(scene);
        let mut mechanism = Mechanism::of(scene);
        let cos = geometry.nose.cos;
        let start_m = 0.0 - scene.plate.cocking_m;
        let rigid = Passage::rigid(scene, &geometry);
        let still = !mechanism.is_absent() && plate_is_fixed(&rigid, &mechanism, start_m);
        if still {
            mechanism.spring = Spring::NONE;
            mechanism.damper = PowerLaw::NONE;
        }
        let moves = scene.plate.mount == Mount::Sprung && !still;
        let mut contact = Self {
            geometry,
            spring: mechanism.spring.power().unwrap_or(PowerLaw::NONE),
            damper: mechanism.damper,
            constants: Constants::of(scene, cos, moves),
            start_m: if moves { start_m } else { 0.0 },
            scale_s: None,
            left_to_others: mechanism.spring.curve().is_some()
                || mechanism.stop.is_some()
                || scene.contact.model != ContactModel::Hydrodynamic,
        };
        contact.scale_s = contact.scale();
        contact
    }

    /// Run it to the relative accuracy `tolerance`; `None` where the simulation is needed.
    pub fn run(&self, tolerance: f64) -> Option<ContactEnd> {
        let mut initial_phase = self.initial_phase(tolerance);
        if let InitialPhase::OnManifold(manifold_run) = &initial_phase {
            initial_phase = self.end_of_manifold(manifold_run);
        }
        match initial_phase {
            InitialPhase::Ended(end) => Some(end),
            InitialPhase::Steps(plan) => self.plan(&plan),
            InitialPhase::OnManifold(_) | InitialPhase::Left => None,
        }
    }

    /// As [`Contact::run`], with the plate's displacement, too, to this accuracy relative to itself: where that is far shorter than the
    /// travel, to a tighter one.
    pub fn run_minding_plate(&self, tolerance: f64) -> Option<ContactEnd> {
        self.run(tolerance * self.plate_share().unwrap_or(1.0))
    }

    /// The plate's displacement over the travel, if it is the shorter and not known relative to itself anyway.
    fn plate_share(&self) -> Option<f64> {
        let moves = self.constants.plate_mobility > 0.0 && self.start_m == 0.0;
        if !moves || self.spring.is_absent() || self.spring_manifold().is_some() {
            return None;
        }
        let fraction = self.reach_m()? / (self.constants.velocity_m_s * self.scale_s?);
        Some(larger(smaller(fraction, 1.0), PLATE_TOLERANCE_MIN))
    }

    /// How far the plate comes at least: where the spring holds a part of the contact force that is reached for certain, m.
    fn reach_m(&self) -> Option<f64> {
        let force_n = GROWN_PART * self.growth_n_s()? * self.scale_s? * self.constants.cos;
        Some(self.spring.at_force(force_n))
    }

    /// The contact up to where plain steps begin, or to its end where it needs none.
    fn initial_phase(&self, tolerance: f64) -> InitialPhase {
        if self.left_to_others {
            return InitialPhase::Left;
        }
        if let Some(end) = self.closed(tolerance) {
            return InitialPhase::Ended(end);
        }
        let terms = self.terms(tolerance);
        if let Some(manifold) = self.spring_manifold()
            && let Some(manifold_run) = self.mounted(manifold, tolerance, terms)
        {
            return InitialPhase::OnManifold(manifold_run);
        }
        self.start(tolerance, terms)
    }

    /// Terms of the expansion. Dampers that are not linear are rare, and compiled for one number.
    fn terms(&self, tolerance: f64) -> usize {
        if !is_linear(self.damper) || (TIGHT..LOOSE).contains(&tolerance) {
            TERMS
        } else if tolerance >= LOOSE {
            TERMS_LOOSE
        } else {
            TERMS_TIGHT
        }
    }

    fn start(&self, tolerance: f64, terms: usize) -> InitialPhase {
        let starts = self.start_m == 0.0;
        let singular = Singular {
            spring: starts && !is_linear(self.spring),
            damper: is_singular(self.damper),
        };
        if starts
            && (singular.spring || singular.damper)
            && let Some(initial_phase) = self.early(tolerance, terms)
        {
            return initial_phase;
        }
        self.first_step(singular, tolerance, terms).map_or(InitialPhase::Left, InitialPhase::Steps)
    }

    fn first_step(&self, singular: Singular, tolerance: f64, terms: usize) -> Option<Plan> {
        let progress = if singular.spring || singular.damper {
            if singular.spring
                && self.spring.exponent < MANIFOLD_BELOW
                && tolerance < MANIFOLD_TOLERANCE_MIN
            {
                return None;
            }
            let (t_s, state) = self.moved(singular, tolerance)?;
            let s = t_s.cbrt();
            self.begin(t_s, state, StepTime::Graded { s, unit: GRADED_UNIT * s })
        } else {
            let state = [0.0, self.constants.velocity_m_s, self.start_m, 0.0];
            self.begin(0.0, state, StepTime::Even { unit_s: 0.5 * self.scale_s? })
        };
        Some(match self.spring_manifold() {
            Some(manifold) => manifold.plan(progress, tolerance, terms),
            None => Plan { progress, tolerance, reach_m: None, terms },
        })
    }

    /// The state a moment after a singular start.
    fn moved(&self, singular: Singular, tolerance: f64) -> Option<(f64, [f64; 4])> {
        let Constants { plate_mobility, cos, velocity_m_s: v, .. } = self.constants;
        let growth_n_s = self.growth_n_s()?;
        let start = Start {
            spring: self.spring.only_if(singular.spring),
            damper: self.damper.only_if(singular.damper),
            force_n: 0.0 - self.spring.force(self.start_m),
            growth_n_s: growth_n_s * cos,
            plate_kg: 1.0 / plate_mobility,
        };
        let moved = start.place(self.scale_s?, tolerance);
        let slowing = self.constants.slip_mobility - cos * cos * plate_mobility;
        let lost = 0.5 * growth_n_s * moved.t_s * moved.t_s * slowing;
        let slip = v - lost - cos * moved.w_m_s;
        let travel = (v - lost / 3.0) * moved.t_s - cos * moved.by_m;
        let state = [travel, slip, self.start_m + moved.by_m, moved.w_m_s];
        let inside = travel > 0.0 && travel < self.geometry.pieces().first()?.to_m;
        (slip > 0.0 && inside).then_some((moved.t_s, state))
    }

    /// How fast the contact force grows at first contact, N/s.
    fn growth_n_s(&self) -> Option<f64> {
        let AreaPiece { law: AreaLaw::Quadratic { a, .. }, .. } = self.geometry.pieces().first()?
        else {
            return None;
        };
        let Constants { strength_pa, drag_kg_m3, velocity_m_s: v, .. } = self.constants;
        Some(a[1] * v * (strength_pa + drag_kg_m3 * v * v))
    }

    fn scale(&self) -> Option<f64> {
        let Constants { slip_mobility, plate_mobility, velocity_m_s: v, .. } = self.constants;
        let preload = self.spring.force(self.start_m).abs() * plate_mobility;
        let by_contact = (2.0 * v / (self.growth_n_s()? * slip_mobility)).sqrt();
        let time = smaller(smaller(by_contact, v / preload), self.geometry.exit_m / v);
        (time > 0.0 && time.is_finite()).then_some(time)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::reference::Stored;
    use crate::model::simulate::bare_run;
    use crate::model::variables::scene_without_spring as scene;

    /// (time, depth) by the simulation.
    fn full(scene: &Scene) -> (f64, f64) {
        let run = bare_run(scene);
        let arrest = run.first_arrest.map(|arrest| (arrest.t_s, arrest.penetration_m));
        arrest.unwrap_or_else(|| (run.exit_time_s.unwrap(), run.final_penetration_m.unwrap()))
    }

    const SCENES: [&str; 19] = [
        "k=1e6 n=0.5",
        "k=1e5 n=0.3",
        "k=1e5 n=1.4",
        "k=1e7 n=2",
        "k=1e9 n=3",
        "b=1000 m=0.5",
        "b=100 m=2",
        "b=10 m=3",
        "b=500 m=1.3 k=1e6 n=1.5",
        "k=1e6 n=0.5 b=300 h=0.003 v_i=400",
        "gamma=1",
        "k=1e5",
        "gamma=3 k=1e6",
        "b=1000",
        "b=2000 k=1e5",
        "d=0.5 k=1e5",
        "k=1e9",
        "h=0.003 v_i=400 k=1e5",
        "d=0.1 k=1e5 n=1.4",
    ];

    #[test]
    fn the_difference_to_the_simulation_stays_below_the_tolerance() {
        for pairs in SCENES {
            let scene = scene(pairs);
            let (t_s, depth_m) = full(&scene);
            for tolerance in [1e-4, 1e-6, 1e-8, 1e-10, 1e-11] {
                let end = Contact::of(&scene).run(tolerance).unwrap();
                let error =
                    larger((end.t_s / t_s - 1.0).abs(), (end.penetration_m / depth_m - 1.0).abs());
                assert!(
                    error < tolerance,
                    "{pairs} {tolerance:e}: {error:e} in {} steps",
                    end.steps
                );
            }
        }
    }

    /// A plate that stays on its spring's slow manifold, one that is set oscillating where nose meets cylinder, one that leaves
    /// the manifold, one with a damper, one that is perforated, one that hardly moves.
    #[test]
    fn a_plate_on_its_springs_slow_manifold_moves_as_far_as_by_the_simulation() {
        for pairs in [
            "k=1e6 n=0.158 v_i=90",
            "k=5e5 n=0.187",
            "k=1e5 n=0.187 gamma=3",
            "k=1e5 n=0.15 b=500",
            "k=1e5 n=0.2 h=0.004 v_i=300",
            // It hardly moves: nothing may be lost between its velocity and the projectile's.
            "k=1e6 n=0.24 v_i=60 gamma=0.8",
            // It could reach the manifold only so late that it never does.
            "k=2.25e6 n=0.332",
        ] {
            let mut scene = scene(pairs);
            scene.run.tolerance = 1e-12;
            let (t_s, depth_m) = full(&scene);
            for tolerance in [1e-6, 1e-8] {
                let end = Contact::of(&scene).run(tolerance).unwrap();
                let errors = [end.t_s / t_s - 1.0, end.penetration_m / depth_m - 1.0];
                assert!(
                    errors.iter().all(|e| e.abs() < tolerance),
                    "{pairs} {tolerance:e} {errors:?}"
                );
                let Some(arrest) = bare_run(&scene).first_arrest else { continue };
                let error = end.plate_displacement_m / arrest.plate_displacement_m - 1.0;
                assert!(error.abs() < 30.0 * tolerance + 1e-7, "{pairs} {tolerance:e} {error:e}");
            }
        }
    }

    /// Two kernels that share no step. The plate oscillates fast and touches rest before it turns at its farthest.
    #[test]
    fn the_simulation_sees_the_greatest_displacement_after_a_touch_of_rest() {
        for tolerance in [1e-11, 1e-12, 1e-13] {
            let mut scene = scene("k=1.725e6 n=0.332");
            scene.run.tolerance = tolerance;
            let kernel = Contact::of(&scene).run(1e-9).unwrap().max_displacement_m;
            let full = bare_run(&scene).max_plate_displacement_m.unwrap();
            assert!((full / kernel - 1.0).abs() < 1e-6, "{tolerance:e}: {full} {kernel}");
        }
    }

    #[test]
    fn scenes_it_is_not_made_for_are_left_to_the_simulation() {
        for pairs in
            ["k=1e5 x_stop=0.01", "d=0.001 k=1e6 n=0.5", "theta=30deg k=1e5 v_i=150", "b=1e8 k=1e7"]
        {
            assert_eq!(Contact::of(&scene(pairs)).run(1e-9), None, "{pairs}");
        }
    }

    #[test]
    fn valid_the_kernel_against_the_stored_digits() {
        for row in Stored::rows() {
            let found = contact_end(&row.scene().unwrap(), 1e-9).unwrap();
            let [t_s, depth_m, _] = row.values();
            let errors =
                [(found.t_s / t_s - 1.0).abs(), (found.penetration_m / depth_m - 1.0).abs()];
            assert!(errors.iter().all(|error| *error < 1e-9), "{}: {errors:?}", row.changes);
        }
    }
}
