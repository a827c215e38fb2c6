//! The contact kernel: from first contact to first arrest or exit, without series, energy ledger, events or outcome. For sweeps
//! and searches that request nothing else.
//!
//! The contact's Taylor recurrence is unrolled at compile time for each kind of spring and damper (`law.rs`, `expansion.rs`) and
//! integrated step by step (`integration.rs`). A law that is singular where the plate starts is put in a moment later (`start.rs`).
//! Scenes it is not made for (a stop, an oblique section across the cylinder, a plate that comes back through a singular point, one
//! that a spring or damper holds too stiffly for its steps) are left to the simulation: [`Contact::of`] or [`Contact::run`] returns
//! `None`. Free and rigid plates are integrated like others: their closed form takes longer, for its time is a quadrature.

use crate::model::contact::{AreaLaw, Geometry};
use crate::model::mechanism::{Mechanism, PowerLaw, Spring};
use crate::model::scene::{ContactModel, Scene};
use crate::numerics::{larger, smaller};
use expansion::{Constants, Series, Clock};
use integration::{Accuracy, Progress};
use law::Law;
use start::Start;

mod expansion;
mod integration;
mod law;
mod start;

/// Part of the force that is reached at least, if it grew as at first contact.
const GROWN_PART: f64 = 0.3;
/// The least velocity of the plate that counts, as part of that of the projectile: less is within rounding.
const PLATE_PART_MIN: f64 = 1e-4;
/// First unit of a step, relative to the contact's duration and, on a graded clock, to where it starts.
const EVEN_UNIT: f64 = 0.5;
const GRADED_UNIT: f64 = 0.6;
/// Time up to which a plate is expanded without its singular laws, as part of the contact's duration.
const MOMENT_MAX: f64 = 0.1;

/// Exponent below which the plate oscillates on its spring so fast at first that every step must follow it.
const STEEP_BELOW: f64 = 0.5;
/// Radians by which a plate may oscillate ahead.
const RADIANS_MAX: f64 = 2.0 * integration::STEPS_MAX as f64;

/// One contact, prepared: everything that does not change during the contact.
#[derive(Clone, Debug)]
pub struct Contact {
    geometry: Geometry,
    spring: PowerLaw,
    damper: PowerLaw,
    /// Or none at all.
    has_linear_spring: bool,
    has_linear_damper: bool,
    constants: Constants,
    start_m: f64,
    /// The time in which a force growing as at first contact, or the preload, would stop the slip, s.
    scale_s: f64,
    /// A part of the contact force that is reached for certain, along the plate's way, N.
    reached_n: f64,
    /// How far the plate comes at least on a spring that starts steep at zero, m.
    steep_reach_m: Option<f64>,
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
    /// Prepare the contact of a scene that has been validated; `None` of a spring that is not a power law, a stop, another interaction
    /// model, a plate that moves at first contact, an area that does not begin as a polynomial, or a contact without a time scale.
    pub fn of(scene: &Scene) -> Option<Self> {
        let mechanism = Mechanism::of(scene);
        let Mechanism { spring: Spring::Power(spring), damper, stop: None, .. } = mechanism else {
            return None;
        };
        let is_other = scene.contact.model != ContactModel::Hydrodynamic;
        if is_other || scene.plate_velocity_m_s() != 0.0 {
            return None;
        }
        let geometry = Geometry::of(scene);
        let AreaLaw::Quadratic { a, .. } = geometry.pieces().first()?.law else { return None };
        let constants = Constants::of(scene, geometry.nose.cos);
        let Constants { strength_pa, drag_kg_m3, velocity_m_s: v, .. } = constants;
        // How fast the contact force grows at first, N/s.
        let growth_n_s = a[1] * v * (strength_pa + drag_kg_m3 * v * v);
        let start_m = scene.start_m();
        let preload = spring.force(start_m).abs() * constants.plate_mobility;
        let by_contact = (2.0 * v / (growth_n_s * constants.slip_mobility)).sqrt();
        let scale_s = smaller(smaller(by_contact, v / preload), geometry.exit_m / v);
        if !(scale_s > 0.0 && scale_s.is_finite()) {
            return None;
        }
        let mut contact = Self {
            spring,
            damper,
            has_linear_spring: spring.is_linear(),
            has_linear_damper: damper.is_linear(),
            start_m,
            scale_s,
            reached_n: GROWN_PART * growth_n_s * scale_s * constants.cos,
            steep_reach_m: None,
            geometry,
            constants,
        };
        let is_steep = contact.is_singular_spring() && spring.exponent < STEEP_BELOW;
        contact.steep_reach_m = is_steep.then(|| contact.reach_m());
        Some(contact)
    }

    /// Run it to the relative accuracy `tolerance`; `None` where the simulation is needed.
    pub fn run(&self, tolerance: f64) -> Option<ContactEnd> {
        self.run_minding_plate(tolerance)
    }

    /// As [`Contact::run`], with the plate's displacement, too, to this accuracy relative to itself.
    pub fn run_minding_plate(&self, tolerance: f64) -> Option<ContactEnd> {
        let moves = self.constants.plate_mobility > 0.0 && self.start_m == 0.0;
        let minds = moves && !self.spring.is_absent();
        self.run_to(Accuracy {
            tolerance,
            plate_m: if minds { self.reach_m() } else { f64::INFINITY },
        })
    }

    fn run_to(&self, accuracy: Accuracy) -> Option<ContactEnd> {
        self.integrate(self.begin(accuracy)?, accuracy)
    }

    /// Whether the spring is singular where the plate starts.
    fn is_singular_spring(&self) -> bool {
        self.start_m == 0.0 && !self.has_linear_spring
    }

    /// The first moment of the contact: first contact itself, or a little later where a law is singular there.
    fn begin(&self, accuracy: Accuracy) -> Option<Progress> {
        let Constants { plate_mobility, cos, velocity_m_s, .. } = self.constants;
        let (start_m, scale_s) = (self.start_m, self.scale_s);
        let unit_s = EVEN_UNIT * scale_s;
        let begin = Progress {
            t_s: 0.0,
            state: [0.0, velocity_m_s, start_m, 0.0],
            clock: Clock { unit_s, grade: 0.0 },
            piece: 0,
            max_displacement_m: start_m,
            steps: 0,
        };
        if self.has_linear_damper && !self.is_singular_spring() {
            return Some(begin);
        }
        let series = self.without_laws(&begin)?;
        let plate_m_s = smaller(accuracy.plate_m / scale_s, velocity_m_s);
        let start = Start {
            spring: self.spring.only_if(start_m == 0.0),
            damper: self.damper,
            plate_kg: 1.0 / plate_mobility,
            cos,
            from_m: start_m,
            tolerance: accuracy.tolerance,
            scale_m_s: larger(plate_m_s, PLATE_PART_MIN * velocity_m_s),
            duration_s: scale_s,
        };
        let trusted = series.trusted(accuracy.tolerance, velocity_m_s, f64::INFINITY);
        let (t_s, state) =
            start.place(&series, unit_s, smaller(trusted, MOMENT_MAX / EVEN_UNIT))?;
        if self.steep_reach_m.is_some() && self.radians_ahead(t_s, state[2]) > RADIANS_MAX {
            return None;
        }
        let inside = state[0] < self.geometry.pieces().first()?.to_m && state[1] > 0.0;
        let clock = Clock { unit_s: 3.0 * GRADED_UNIT * t_s, grade: GRADED_UNIT };
        inside.then_some(Progress { t_s, state, clock, steps: 1, ..begin })
    }

    /// The contact from its beginning without spring and damper, but with the preload of a cocked spring.
    fn without_laws(&self, begin: &Progress) -> Option<Series> {
        let area = self.area_law(begin.piece)?;
        let none = Law::of(PowerLaw::NONE);
        let spring = Law::of(self.spring.only_if(self.start_m != 0.0));
        Some(self.constants.expand(spring, none, begin.state, begin.clock, area))
    }

    /// By how many radians the plate will oscillate on a spring that starts at zero, if it is at `plate_m` by the time `t_s`: the
    /// rate grows with the power (n - 1)/(2 n) of time.
    fn radians_ahead(&self, t_s: f64, plate_m: f64) -> f64 {
        let rate = (self.spring.tangent(plate_m) * self.constants.plate_mobility).sqrt();
        let power = 1.5 - 0.5 / self.spring.exponent;
        rate * t_s * ((self.scale_s / t_s).powf(power) - 1.0) / power
    }

    /// How far the plate comes at least, m.
    fn reach_m(&self) -> f64 {
        self.spring.at_force(self.reached_n)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::reference::Stored;
    use crate::model::simulate::bare_run;
    use crate::model::variables::changed_free_plate;

    fn scene(pairs: &str) -> Scene {
        changed_free_plate(pairs).unwrap()
    }

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
                let end = Contact::of(&scene).unwrap().run(tolerance).unwrap();
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

    /// A plate that moves freely before its spring holds it, one with a damper, one that is perforated, one that oscillates hundreds of
    /// times, one in between inertia and spring for all the time.
    #[test]
    fn a_plate_on_a_spring_below_a_third_moves_as_far_as_by_the_simulation() {
        for pairs in [
            "k=1e5 n=0.187 gamma=3",
            "k=5e4 n=0.187 b=500",
            "k=1e5 n=0.2 h=0.004 v_i=300",
            "k=1e6 n=0.303",
            "k=2.25e6 n=0.332",
        ] {
            let mut scene = scene(pairs);
            scene.run.tolerance = 1e-12;
            let (t_s, depth_m) = full(&scene);
            for tolerance in [1e-6, 1e-8, 1e-10] {
                let end = Contact::of(&scene).unwrap().run_minding_plate(tolerance).unwrap();
                let errors = [end.t_s / t_s - 1.0, end.penetration_m / depth_m - 1.0];
                let holds = errors.iter().all(|e| e.abs() < tolerance);
                assert!(holds, "{pairs} {tolerance:e} {errors:?}");
                let Some(arrest) = bare_run(&scene).first_arrest else { continue };
                let error = end.plate_displacement_m / arrest.plate_displacement_m - 1.0;
                assert!(error.abs() < 30.0 * tolerance + 1e-9, "{pairs} {tolerance:e} {error:e}");
            }
        }
    }

    /// Two kernels that share no step. The plate oscillates fast and touches rest before it turns at its farthest.
    #[test]
    fn the_simulation_sees_the_greatest_displacement_after_a_touch_of_rest() {
        for tolerance in [1e-11, 1e-12, 1e-13] {
            let mut scene = scene("k=1.725e6 n=0.332");
            scene.run.tolerance = tolerance;
            let kernel = Contact::of(&scene).unwrap().run(1e-9).unwrap().max_displacement_m;
            let full = bare_run(&scene).max_plate_displacement_m.unwrap();
            assert!((full / kernel - 1.0).abs() < 1e-6, "{tolerance:e}: {full} {kernel}");
        }
    }

    #[test]
    fn scenes_it_is_not_made_for_are_left_to_the_simulation() {
        for pairs in [
            "k=1e5 x_stop=0.01",
            "d=0.001 k=1e6 n=0.5",
            "theta=30deg k=1e5 v_i=150",
            "b=1e8 k=1e7",
            "k=1e6 n=0.158",
        ] {
            let end = Contact::of(&scene(pairs)).and_then(|contact| contact.run(1e-9));
            assert_eq!(end, None, "{pairs}");
        }
    }

    #[test]
    fn valid_the_kernel_against_the_stored_digits() {
        for row in Stored::rows() {
            let contact = Contact::of(&row.scene().unwrap()).unwrap();
            let Some(found) = contact.run(1e-9) else {
                // Held as by a rigid mount: the steps would be too many.
                assert!(row.changes.contains("n=0.1"), "{}", row.changes);
                continue;
            };
            let [t_s, depth_m, _] = row.values();
            let errors =
                [(found.t_s / t_s - 1.0).abs(), (found.penetration_m / depth_m - 1.0).abs()];
            assert!(errors.iter().all(|error| *error < 1e-9), "{}: {errors:?}", row.changes);
        }
    }
}
