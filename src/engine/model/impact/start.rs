//! The first moments of a run whose spring or damper is singular at zero, where every uncocked run begins.
//!
//! With F = f t the plate first moves like t³/6 by inertia, unless the spring is so steep at zero (n < 1/3, or very stiff) that
//! the plate follows the balance of forces: x = (F/k)^(1/n). The smaller of the two is right up to a factor near one, and that is
//! enough: the start is placed so early that the momentum in question is below the tolerance.

use crate::model::impact::record::Setting;
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
/// Momentum omitted at the start, relative to the projectile's, per tolerance.
const OMITTED_MOMENTUM: f64 = 1e-4;

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
            let omitted_n = smaller(spring.abs() + damper.abs(), drive_n(&motion, &e));
            let inside = state.slip_m_s > 0.0 && state.travel_m < first_m;
            inside && omitted_n * t_s / problem.plate_kg <= allowed && self.trusted(&e) >= 1.0
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
        self.record.step(&Setting { body: &self.body, motion }, &e, 1.0);
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
