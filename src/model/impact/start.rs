//! The first moments of a run whose spring or damper is singular at zero, where every uncocked run begins.
//!
//! With F = f t the plate first moves like t³/6 by inertia, unless the spring is so steep at zero (n < 1/3, or very stiff) that
//! the plate follows the balance of forces: x = (F/k)^(1/n). The smaller of the two is right up to a factor near one, and that is
//! enough: the start is placed so early that the momentum in question is below the tolerance.

use crate::model::contact_models::Scales;
use crate::model::impact::problem::Problem;
use crate::model::impact::simulation::Simulation;
use crate::model::mechanism::PowerLaw;
use crate::model::motion::{Expansion, Motion};
use crate::numerics::{larger, smaller};

/// Radians (or time constants) of the mechanism within the starting time from which on it is stiff.
const STIFF_FROM: f64 = 300.0;
/// Where the search for the start begins, and where it ends at the latest at tolerance 1, in units of the contact's duration; and
/// how both fall with the tolerance: two computations do not share their start, and with it its error.
const FIRST_GUESS: f64 = 1e-9;
const LATEST: f64 = 3e-3;
const START_POWER: f64 = 0.125;
/// No start is earlier than this, s.
const START_MIN_S: f64 = 1e-40;
/// Oscillations (in radians) within the contact that Taylor steps can still follow.
const OSCILLATION_MAX_RAD: f64 = 1e5;
/// Time constants of the damper within the contact up to which Taylor steps are the cheaper way.
const DECAYS_MAX: f64 = 3e3;
/// Momentum omitted at the start, relative to the projectile's, per tolerance.
const OMITTED_MOMENTUM: f64 = 1e-4;

/// How fast things happen.
#[derive(Clone, Copy, Debug)]
pub(super) struct TimeScales {
    pub(super) contact_s: f64,
    /// How far the mechanism yields to the contact force, relative to the travel.
    pub(super) yields_part: f64,
    /// Angular frequency of the plate on its spring, 1/s.
    frequency_rad_s: f64,
    /// Decay rate of the plate's velocity by its damper, 1/s.
    decay_per_s: f64,
}

impl TimeScales {
    /// Whether the implicit method should have the contact from the start. NaN counts as stiff.
    pub(super) fn is_stiff(&self) -> bool {
        let oscillations = self.frequency_rad_s * self.contact_s;
        let decays = self.decay_per_s * self.contact_s;
        !(oscillations < OSCILLATION_MAX_RAD && decays < DECAYS_MAX)
    }
}

impl Problem {
    /// How long the contact lasts, and how fast the mechanism answers within it, by order of magnitude.
    pub(super) fn time_scales(&self) -> TimeScales {
        let (spring, damper) = (&self.mechanism.spring, self.mechanism.damper);
        let (v, m_2) = (self.velocity_m_s, self.plate_kg);
        let Scales { travel_m, duration_s, force_n: contact_n } = self.contact.scales();
        let mut contact_s = duration_s;
        let preload = spring.force(self.start_m).abs();
        // A cocked plate that is thrown forward at the projectile's speed ends the contact.
        if preload > 0.0 && damper.at_force(preload) > v {
            contact_s = smaller(contact_s, m_2 * v / preload);
        }
        let drive = larger(contact_n, preload);
        let thrown = drive * contact_s / m_2;
        let yields = smaller(spring.at_force(contact_n), 0.5 * thrown * contact_s);
        let x = larger(yields, self.start_m.abs());
        let w = smaller(damper.at_force(drive), thrown);
        TimeScales {
            contact_s,
            yields_part: smaller(yields / travel_m, 1.0),
            frequency_rad_s: (spring.tangent(x).abs() / m_2).sqrt(),
            decay_per_s: damper.tangent(w) / m_2,
        }
    }
}

impl Simulation<'_> {
    /// Step over the singular start, if there is one.
    pub(super) fn start(&mut self) {
        let problem = self.body.problem;
        let mechanism = &problem.mechanism;
        let spring_singular = mechanism.spring.is_singular() && self.body.state.plate_m == 0.0;
        let damper_singular = mechanism.damper.is_singular();
        if self.body.rests_on_stop || problem.rigid || !(spring_singular || damper_singular) {
            return;
        }
        if !spring_singular && self.cross_singularity() {
            return;
        }
        self.body.x_zero.omitted = spring_singular;
        self.body.w_zero.omitted = damper_singular;
        let motion = self.body.motion();
        self.body.x_zero.omitted = false;
        self.body.w_zero.omitted = false;
        let allowed = OMITTED_MOMENTUM * self.body.tolerance * problem.velocity_m_s;
        // The area changes there.
        let first_m = problem.geometry.piece(0.0).to_m;
        let is_early = |t_s: f64| {
            let e: Expansion<17> = motion.expand(&self.body.state, t_s);
            let state = e.state(1.0);
            let spring = if spring_singular { mechanism.spring.force(state.plate_m) } else { 0.0 };
            let damper =
                if damper_singular { mechanism.damper.force(state.plate_m_s) } else { 0.0 };
            let left_out = smaller(spring.abs() + damper.abs(), drive_n(&motion, &e));
            let inside = state.slip_m_s > 0.0 && state.travel_m < first_m;
            inside && left_out * t_s / problem.plate_kg <= allowed && self.trusted(&e) >= 1.0
        };
        let scale_s = self.body.tolerance.powf(START_POWER) * problem.time_scales().contact_s;
        let mut t_s = FIRST_GUESS * scale_s;
        while !is_early(t_s) && t_s > START_MIN_S {
            t_s *= 0.25;
        }
        while is_early(4.0 * t_s) && 4.0 * t_s < LATEST * scale_s {
            t_s *= 4.0;
        }
        self.place(&motion, t_s, spring_singular, damper_singular);
    }

    /// Put the state at the early time `t_s`.
    fn place(
        &mut self,
        motion: &Motion<'_>,
        t_s: f64,
        spring_singular: bool,
        damper_singular: bool,
    ) {
        let mechanism = &self.body.problem.mechanism;
        let e: Expansion<17> = motion.expand(&self.body.state, t_s);
        let mut state = e.state(1.0);
        let drive = drive_n(motion, &e);
        if damper_singular && mechanism.damper.force(state.plate_m_s).abs() > drive {
            let (w, m) = (mechanism.damper.at_force(drive), mechanism.damper.exponent);
            state.plate_m += (w / (1.0 + 1.0 / m) - 0.25 * state.plate_m_s) * t_s;
            state.plate_m_s = w;
        }
        if spring_singular && mechanism.spring.force(state.plate_m).abs() > drive {
            let (x, n) = (mechanism.spring.at_force(drive), self.body.spring().exponent);
            state.plate_m = x;
            state.plate_m_s = smaller(x / (n * t_s), state.plate_m_s);
        }
        let rate =
            stiffness_per_s(self.body.spring(), state.plate_m, self.body.problem.plate_kg).sqrt();
        let decay = stiffness_per_s(mechanism.damper, state.plate_m_s, self.body.problem.plate_kg);
        let radians = larger(rate, decay) * t_s;
        // NaN (an infinite tangent at zero) is stiff, too.
        self.control.stiff = radians.is_nan() || radians >= STIFF_FROM || state.plate_m == 0.0;
        self.control.unit_s = t_s;
        if self.control.stiff {
            // The implicit method starts from the very beginning: it has no trouble with zero.
            return;
        }
        self.record.step(&self.body.setting(motion), &e, 1.0);
        self.arrive(state, motion, None);
        self.control.steps += 1;
    }
}

/// The force that drives the plate at the end of an expansion, N.
fn drive_n<const N: usize>(motion: &Motion<'_>, e: &Expansion<N>) -> f64 {
    let state = e.state(1.0);
    (motion.contact_force(&state) * motion.coupling - motion.mechanism_force(&state)).abs()
}

/// Tangent per mass: the square of a frequency for a spring, a rate for a damper.
fn stiffness_per_s(law: PowerLaw, z: f64, mass_kg: f64) -> f64 {
    if law.is_singular() { law.tangent(z) / mass_kg } else { 0.0 }
}
