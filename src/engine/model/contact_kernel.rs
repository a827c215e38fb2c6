//! Contact kernel: first contact up to first arrest or exit, without time series, energy balance and events, for sweeps and searches.
//!
//! Each step is a Taylor expansion (`expansion.rs`). A law that is singular at the start of the plate is treated analytically for the first
//! moment (`singular_start.rs`). [`Contact::from_scene`] or [`Contact::run`] returns `None` for scenes that need the simulation: a stop, an
//! oblique section across the cylinder, a plate that returns through a singular point, a spring or damper that is too stiff. Free and rigid
//! plates are integrated, too: their closed form is slower, since its time is a quadrature.

use crate::model::contact::{AreaLaw, Geometry};
use crate::model::mechanism::{Mechanism, PowerLaw, Spring, moving_plate_kg};
use crate::model::scene::{ContactModel, Scene};
use crate::numerics::series_root::{dips, rise, zero};
use crate::numerics::{larger, smaller};
use expansion::State;

mod expansion;
mod singular_start;

/// Minimum ratio of the contact force to its linear extrapolation from first contact, for the estimate of the duration.
const GROWN_PART: f64 = 0.3;
/// Maximum number of steps, and maximum phase of oscillation or decay of the plate, rad; beyond, the simulation is faster.
const STEPS_MAX: usize = 6000;
/// Spring exponent below which the initial oscillation of the plate limits every step.
const STEEP_BELOW: f64 = 0.5;
/// Ratio of the tolerances of two computations whose difference estimates the error of the less accurate one.
const LOOSER: f64 = 10.0;
/// Required agreement of both computations, relative to the tolerance; a safety factor for slow convergence.
const AGREES: f64 = 0.3;
/// Maximum number of tolerances for a singular start.
const TRIES: usize = 3;
/// Fraction of the tolerance for a step of a rapidly oscillating plate, which takes many steps.
const STEEP_PART: f64 = 0.2;

/// Parameters of a contact.
#[derive(Clone, Debug)]
pub struct Contact {
    geometry: Geometry,
    spring: PowerLaw,
    damper: PowerLaw,
    strength_pa: f64,
    drag_kg_m3: f64,
    /// Deceleration of the relative velocity for a unit contact force, 1/kg.
    slip_mobility: f64,
    /// Acceleration of the plate for a unit force, 1/kg; 0 on a rigid mount.
    plate_mobility: f64,
    cos: f64,
    velocity_m_s: f64,
    start_m: f64,
    /// Time scale, s: time to stop the relative motion with a force that grows as at first contact, or with the preload.
    scale_s: f64,
    /// Lower bound of the displacement of an uncocked plate, m; infinite without a spring.
    reach_m: f64,
}

/// End of a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactEnd {
    /// First arrest if `true`, else exit from the rear face.
    pub arrested: bool,
    /// Time, s.
    pub t_s: f64,
    /// Depth, m.
    pub penetration_m: f64,
    /// Displacement of the plate, m.
    pub plate_displacement_m: f64,
    /// Velocity of the plate, m/s.
    pub plate_velocity_m_s: f64,
    /// Maximum displacement of the plate so far, m.
    pub max_displacement_m: f64,
    /// Number of steps.
    pub steps: usize,
}

impl ContactEnd {
    /// Returns the maximum relative difference of depth, time and displacement; infinite if the ends differ in kind.
    fn differs(&self, other: &Self) -> f64 {
        if self.arrested != other.arrested {
            return f64::INFINITY;
        }
        let pairs = [
            (self.t_s, other.t_s),
            (self.penetration_m, other.penetration_m),
            (self.plate_displacement_m, other.plate_displacement_m),
        ];
        let apart = pairs.map(|(own, other)| {
            if own.to_bits() == other.to_bits() { 0.0 } else { (own / other - 1.0).abs() }
        });
        apart.into_iter().fold(0.0, larger)
    }
}

impl Contact {
    /// Creates the contact of a valid scene; `None` for a spring that is not a power law, a stop, another contact model, a plug, the weight
    /// of the projectile, a plate that moves at first contact, an area that does not start as a polynomial, or a contact without a time
    /// scale.
    pub fn from_scene(scene: &Scene) -> Option<Self> {
        let mechanism = Mechanism::from_scene(scene);
        let Mechanism { spring: Spring::Power(spring), damper, stop: None, .. } = mechanism else {
            return None;
        };
        let is_other =
            scene.contact.model != ContactModel::Hydrodynamic || scene.projectile.nose.shears();
        if is_other || scene.plate_velocity_m_s() != 0.0 || scene.weight_n() > 0.0 {
            return None;
        }
        let geometry = Geometry::from_scene(scene);
        let AreaLaw::Quadratic { a, .. } = geometry.pieces().first()?.law else { return None };
        let plate_mobility = if scene.is_sprung() { 1.0 / moving_plate_kg(scene) } else { 0.0 };
        let (cos, v) = (geometry.nose.cos, scene.projectile.velocity_m_s);
        let slip_mobility = 1.0 / scene.projectile.mass_kg + cos * cos * plate_mobility;
        let (strength_pa, drag_kg_m3) = (scene.flow_strength_pa(), scene.drag_kg_m3());
        // Time derivative of the contact force at first contact, N/s.
        let growth_n_s = a[1] * v * (strength_pa + drag_kg_m3 * v * v);
        let start_m = scene.start_m();
        let preload = spring.force(start_m).abs() * plate_mobility;
        let by_contact = (2.0 * v / (growth_n_s * slip_mobility)).sqrt();
        let scale_s = smaller(smaller(by_contact, v / preload), geometry.exit_m / v);
        let reached_n = GROWN_PART * growth_n_s * scale_s * cos;
        let on_spring_m = if start_m == 0.0 { spring.at_force(reached_n) } else { f64::INFINITY };
        let reach_m = smaller(on_spring_m, v * scale_s);
        (scale_s > 0.0 && scale_s.is_finite()).then_some(Self {
            geometry,
            spring,
            damper,
            strength_pa,
            drag_kg_m3,
            slip_mobility,
            plate_mobility,
            cos,
            velocity_m_s: v,
            start_m,
            scale_s,
            reach_m,
        })
    }

    /// Computes the contact with a relative tolerance of depth, time and displacement; `None` if the simulation is needed.
    ///
    /// The error of a singular start is not bounded by the local errors of its steps. A second computation estimates it; the tolerance is
    /// reduced until both agree.
    pub fn run(&self, tolerance: f64) -> Option<ContactEnd> {
        let from_zero = self.start_m == 0.0;
        let is_regular = self.damper.is_linear() && (self.spring.is_linear() || !from_zero);
        if is_regular {
            return self.run_once(tolerance);
        }
        let mut looser = self.run_once(LOOSER * tolerance)?;
        let mut own_tolerance = tolerance;
        for _ in 0..TRIES {
            let end = self.run_once(own_tolerance)?;
            if end.differs(&looser) <= AGREES * tolerance {
                return Some(end);
            }
            (looser, own_tolerance) = (end, own_tolerance / LOOSER);
        }
        None
    }

    /// Computes the contact once, with a tolerance for steps and start.
    fn run_once(&self, tolerance: f64) -> Option<ContactEnd> {
        let (mut t_s, mut state, mut clock) = self.begin(tolerance)?;
        // A singular law is stiffest at the start.
        let span_s = if t_s > 0.0 { t_s } else { self.scale_s };
        if self.rate_per_s(&state) * span_s > STEPS_MAX as f64 {
            return None;
        }
        let (mut pieces, mut max_displacement_m) = (self.geometry.pieces().iter(), self.start_m);
        let mut piece = pieces.next()?;
        // The first moment of a singular law counts as a step.
        for steps in 1 + usize::from(t_s > 0.0)..=STEPS_MAX {
            let series = self.expand([self.spring, self.damper], state, clock, piece.law)?;
            let plate_m = self.plate_scale_m(state[2]);
            let trusted = series.trusted(tolerance, self.velocity_m_s, plate_m);
            let (mut span, mut next) = (trusted, series.state(trusted));
            let stops = next[1] <= 0.0;
            if stops {
                span = zero(&series.slip, span);
                next = series.state(span);
            } else if dips(&series.slip, span) {
                return None;
            }
            // Travel increases up to the arrest: the piece can end before.
            let at_end = next[0] >= piece.to_m;
            if at_end {
                span = rise(&series.travel, piece.to_m, span);
                next = series.state(span);
                next[0] = piece.to_m;
            }
            // A step is shorter than half an oscillation, so there is one maximum at most.
            if state[3] > 0.0 && next[3] < 0.0 {
                let top = series.state(zero(&series.speed, span));
                max_displacement_m = larger(max_displacement_m, top[2]);
            }
            max_displacement_m = larger(max_displacement_m, next[2]);
            t_s += clock.elapsed_s(span);
            (state, clock) = (next, clock.next(span, trusted));
            if !self.holds_at(&state) {
                return None;
            }
            let is_out = at_end && pieces.len() == 0;
            if is_out || (stops && !at_end) {
                let [travel_m, _, plate_displacement_m, plate_velocity_m_s] = state;
                return Some(ContactEnd {
                    arrested: !is_out,
                    t_s,
                    penetration_m: self.geometry.depth_m(travel_m),
                    plate_displacement_m,
                    plate_velocity_m_s,
                    max_displacement_m,
                    steps,
                });
            }
            if at_end {
                piece = pieces.next()?;
            }
        }
        None
    }

    /// Returns the error scale of the displacement at `plate_m`, m. On a singular spring the plate oscillates about a displacement that is
    /// tiny at first. The oscillation decays more slowly than that displacement grows: each step has to resolve it.
    fn plate_scale_m(&self, plate_m: f64) -> f64 {
        let is_steep = self.spring.is_steep_at_zero() && self.spring.exponent < STEEP_BELOW;
        if self.start_m == 0.0 && is_steep {
            STEEP_PART * (plate_m * larger(self.reach_m, plate_m)).sqrt()
        } else {
            self.reach_m
        }
    }

    /// Returns the rate of oscillation and decay of the plate at a state, rad/s.
    fn rate_per_s(&self, [_, _, plate_m, speed_m_s]: &State) -> f64 {
        let by_spring = self.spring.tangent(*plate_m) * self.plate_mobility;
        by_spring.sqrt() + self.damper.tangent(*speed_m_s) * self.plate_mobility
    }

    /// Returns `true` if the expansion is valid at a state: with nonlinear laws the plate stays on its side of zero and moves forward.
    fn holds_at(&self, [travel_m, _, plate_m, speed_m_s]: &State) -> bool {
        let on_its_side = if self.start_m < 0.0 { *plate_m < 0.0 } else { *plate_m > 0.0 };
        travel_m.is_finite()
            && (on_its_side || self.spring.is_linear())
            && (*speed_m_s > 0.0 || self.damper.is_linear())
    }
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;
    use std::sync::Arc;

    use super::*;
    use crate::model::impact::{IntegrationMethod, step_by};
    use crate::model::reference::Stored;
    use crate::model::run::{Run, RunSnapshot};
    use crate::model::simulate::bare_run;
    use crate::model::variables::changed_free_plate;

    fn scene(pairs: &str) -> Scene {
        changed_free_plate(pairs).unwrap()
    }

    /// (time, depth) by the simulation.
    fn full(scene: &Scene) -> (f64, f64) {
        let run = bare_run(scene);
        let arrest = run.first_arrest.map(|arrest| (arrest.t_s, arrest.penetration_m));
        arrest.unwrap_or_else(|| {
            (run.departure.exit_time_s.unwrap(), run.penetration.final_m.unwrap())
        })
    }

    /// Random scenes of a test.
    const RANDOM: usize = 200;

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
                let end = Contact::from_scene(&scene).unwrap().run(tolerance).unwrap();
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
                let end = Contact::from_scene(&scene).unwrap().run(tolerance).unwrap();
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
            let kernel = Contact::from_scene(&scene).unwrap().run(1e-9).unwrap().max_displacement_m;
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
            let end = Contact::from_scene(&scene(pairs)).and_then(|contact| contact.run(1e-9));
            assert_eq!(end, None, "{pairs}");
        }
    }

    #[test]
    fn valid_the_kernel_against_the_stored_digits() {
        for row in Stored::rows() {
            let contact = Contact::from_scene(&scene(&row.changes)).unwrap();
            let Some(found) = contact.run(1e-9) else {
                // Held as by a rigid mount: the steps would be too many.
                assert!(row.changes.contains("n=0.1"), "{}", row.changes);
                continue;
            };
            let parts = [found.t_s / row.t_s, found.penetration_m / row.depth_m];
            let errors = parts.map(|part| (part - 1.0).abs());
            assert!(errors.iter().all(|error| *error < 1e-9), "{}: {errors:?}", row.changes);
        }
    }

    /// Worst relative error of depth, time and displacement, against a run.
    fn error(run: &Run, end: &ContactEnd) -> f64 {
        let Some(arrest) = run.first_arrest.filter(|_| end.arrested) else {
            let (t_s, depth_m) =
                (run.departure.exit_time_s.unwrap(), run.penetration.final_m.unwrap());
            return larger((end.t_s / t_s - 1.0).abs(), (end.penetration_m / depth_m - 1.0).abs());
        };
        let exact = ContactEnd {
            t_s: arrest.t_s,
            penetration_m: arrest.penetration_m,
            plate_displacement_m: arrest.plate_displacement_m,
            ..*end
        };
        end.differs(&exact)
    }

    /// The displacement was off by 1.1e-5 and the time by 6e-9. The reference is an explicit method.
    #[test]
    fn valid_a_singular_start_keeps_depth_time_and_displacement() {
        for (pairs, tolerance) in [
            ("k=2.0591e7 n=0.5 gamma=1.317 v_i=34.472 h=2.254mm", 1e-6),
            ("k=7417.8 n=0.2 gamma=5.097 v_i=94.479 h=2.108mm", 1e-9),
        ] {
            let scene = scene(pairs);
            let Some(end) = Contact::from_scene(&scene).unwrap().run(tolerance) else { continue };
            let go_on = &mut |_: &RunSnapshot<'_>| ControlFlow::Continue(());
            let run = step_by(IntegrationMethod::Dop853(1e-13), &Arc::new(scene), go_on);
            let error = error(&run.unwrap().unwrap(), &end);
            assert!(error <= tolerance, "{pairs} {tolerance:e}: {error:e}");
        }
    }

    /// Random scenes keep the promise, or are left to the simulation.
    #[test]
    fn random_contacts_keep_depth_time_and_displacement() {
        let mut random = crate::numerics::random::Random::new(2007);
        let mut log = |low: f64, high: f64| low * (high / low).powf(random.unit());
        let (mut wrong, mut left, mut regular) = (Vec::new(), 0, 0);
        for _ in 0..RANDOM {
            let pairs = format!(
                "k={:.4e} n={:.3} gamma={:.4} v_i={:.4} h={:.4e} b={:.4} m={:.3}",
                log(1e3, 1e8),
                log(0.15, 3.0),
                log(0.3, 10.0),
                log(20.0, 300.0),
                log(2e-3, 0.03),
                larger(log(1e-2, 2e3) - 1.0, 0.0),
                log(0.5, 2.0)
            );
            let mut scene = scene(&pairs);
            scene.run.tolerance = 1e-13;
            let run = bare_run(&scene);
            for tolerance in [1e-6, 1e-9] {
                let contact = Contact::from_scene(&scene).unwrap();
                let Some(end) = contact.run(tolerance) else {
                    left += 1;
                    continue;
                };
                regular += 1;
                let error = error(&run, &end);
                if error > tolerance {
                    let once = contact.run_once(tolerance).map(|end| self::error(&run, &end));
                    wrong.push(format!("{pairs} {tolerance:e}: {error:e}, once {once:?}"));
                }
            }
        }
        assert!(
            wrong.is_empty(),
            "{} of {regular}, {left} left:\n{}",
            wrong.len(),
            wrong.join("\n")
        );
    }
}
