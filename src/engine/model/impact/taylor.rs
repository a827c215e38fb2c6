//! Taylor steps: expand the motion, go as far as the expansion is trusted, stop at the first event.

use std::ops::ControlFlow;

use crate::model::event_function::EventId;
use crate::model::impact::record::Setting;
use crate::model::impact::simulation::{Simulation, is_finite};
use crate::model::motion::{Expansion, Motion};
use crate::model::run::{EndReason, Mode};
use crate::numerics::root::first_down_crossing;
use crate::numerics::series::evaluate_slope;
use crate::numerics::taylor::trusted_step;
use crate::numerics::{larger, smaller};

/// Defect at the end of a step, per local tolerance, above which the step is shortened, and what rounding alone may cause.
const DEFECT: f64 = 100.0;
const DEFECT_ROUNDING: f64 = 1e-12;
/// Roundings in the sum of the forces on the plate, with some reserve.
const ROUNDINGS: f64 = 4.0;
/// Part of the interface's strength below which errors of the force it carries do not matter, per tolerance.
const FORCE_TOLERANCE: f64 = 1e-2;
/// Rounds in which the sizes are taken again, and the part of the last result from which on they fit.
const SCALE_ROUNDS: usize = 6;
const SCALE_SETTLED: f64 = 0.7;
/// An expansion of which less than this part of its time unit can be used is made again with a shorter unit.
const USED_PART_MIN: f64 = 0.02;

/// Decays of the damper within a step, and part of the damper's force that is left for inertia, from which on the plate creeps.
const CREEP_STEP_DECAYS: f64 = 0.5;
const CREEP_INERTIA: f64 = 0.02;
/// Errors that a step may make of the plate's velocity from which on it is followed.
const UNRESOLVED: f64 = 100.0;
/// Radians of the spring within a step, and part of its force that is left for inertia, from which on the plate follows the slow
/// manifold: an oscillation that small has 1e-12 of the energy in the spring.
const MANIFOLD_STEP_RAD: f64 = 0.5;
const MANIFOLD_INERTIA: f64 = 1e-6;
/// Ulps of the time up to which a step counts as one that gets nowhere.
const STALLED_TICKS: f64 = 4096.0;
/// Such steps in a row after which the implicit method takes over.
const STIFF_SIGNS: usize = 50;
/// First step, relative to the time reached, of the implicit method when it takes over.
const FIRST_STIFF_STEP: f64 = 1e-9;

impl Simulation<'_> {
    /// One Taylor step, shortened to the first event.
    pub(super) fn taylor_step<const N: usize>(
        &mut self,
    ) -> ControlFlow<EndReason, Option<EventId>> {
        let motion = self.body.motion();
        let h = self.control.unit_s;
        let e: Expansion<N> = motion.expand(&self.body.state, h);
        self.control.evaluations += 1;
        self.control.worked(1);
        let trusted = self.trusted(&e);
        if trusted < USED_PART_MIN {
            // The unit is far too long for what happens now: sizes measured with it mean nothing.
            self.control.unit_s = h * larger(2.0 * trusted, 1e-3);
            self.control.rejected += 1;
            if self.control.unit_s <= 0.5 * f64::EPSILON * self.body.state.t_s {
                // Shorter than the time resolves: a plate that creeps against its damper. The implicit method steps over it.
                self.control.stiff = true;
                self.control.unit_s = FIRST_STIFF_STEP * self.body.state.t_s;
            }
            return ControlFlow::Continue(None);
        }
        let left = (self.until_s() - self.body.state.t_s) / h;
        let mut reach = self.checked(&motion, &e, smaller(left, trusted));
        let (span, detected) = loop {
            let (span, detected) = self.first_event(&motion, &e, reach);
            // An expansion that solves the equations again at its end, back on another piece, need not have done so on the way.
            let checked = if detected.is_some() { self.checked(&motion, &e, span) } else { span };
            if checked >= span {
                break (span, detected);
            }
            reach = checked;
        };
        let state = e.state(span);
        if !is_finite(&state) {
            return ControlFlow::Break(EndReason::NonFinite);
        }
        if state.t_s <= self.body.state.t_s && detected.is_none() {
            self.control.stiff = true;
            self.control.unit_s = FIRST_STIFF_STEP * self.body.state.t_s;
            return ControlFlow::Continue(None);
        }
        self.record.step(&Setting { body: &self.body, motion: &motion }, &e, span);
        self.control.unit_s = h * if detected.is_some() { trusted } else { span };
        self.control.steps += 1;
        self.control.stretch_steps += 1;
        self.notice_stiffness(&motion, &e, span * h);
        self.control.count_turns(e.plate_speed[1]);
        self.arrive(state, &motion, detected);
        ControlFlow::Continue(detected)
    }

    /// How far the expansion goes up to the first event before `reach`, in its time unit, and which event that is.
    fn first_event<const N: usize>(
        &self,
        motion: &Motion<'_>,
        e: &Expansion<N>,
        reach: f64,
    ) -> (f64, Option<EventId>) {
        let (mut span, mut detected) = (reach, None);
        for (event, form) in self.active_events().iter() {
            if let Some(s) = first_down_crossing(&form.along(motion, e), span) {
                (span, detected) = (s, Some(*event));
            }
        }
        (span, detected)
    }

    /// A plate that creeps against its damper, or follows the slow manifold of its spring without oscillating: the steps follow
    /// the decay rate, or the spring's frequency, although nothing decays or oscillates any more. After some such steps in a row
    /// the implicit method takes over, which follows only what changes.
    fn notice_stiffness<const N: usize>(
        &mut self,
        motion: &Motion<'_>,
        e: &Expansion<N>,
        step_s: f64,
    ) {
        let (mobility, stop) = (motion.plate_mobility, motion.stop);
        if mobility == 0.0 {
            return;
        }
        let noise_n = ROUNDINGS * plate_noise(motion, e) / mobility;
        let net_n = larger((motion.coupling * e.contact[0] - e.mechanism[0]).abs() - noise_n, 0.0);
        let damping_n = e.damper[0] + stop.damping_n_s_m * e.plate_speed[0];
        let spring_n = e.mechanism[0] - damping_n;
        // A velocity that a step may be wrong by says nothing of what is left for inertia.
        let unresolved = e.plate_speed[0].abs()
            <= UNRESOLVED
                * self.body.local_tolerance()
                * self.body.resolved_part()
                * self.body.problem.velocity_m_s;
        let creeps = (unresolved || net_n <= CREEP_INERTIA * damping_n.abs()) && {
            let damper = motion.damper.tangent(e.plate_speed[0]) + stop.damping_n_s_m;
            damper * mobility * step_s >= CREEP_STEP_DECAYS
        };
        let on_manifold = net_n <= MANIFOLD_INERTIA * spring_n.abs() && {
            let stiffness = motion.spring.tangent(e.plate[0]) + stop.stiffness_n_m;
            stiffness * mobility * step_s * step_s >= MANIFOLD_STEP_RAD * MANIFOLD_STEP_RAD
        };
        let is_short = step_s <= STALLED_TICKS * f64::EPSILON * self.body.state.t_s;
        self.control.stiffness_signs =
            if creeps || on_manifold || is_short { self.control.stiffness_signs + 1 } else { 0 };
        if self.control.stiffness_signs > STIFF_SIGNS {
            self.control.stiffness_signs = 0;
            self.control.stiff = true;
        }
    }

    /// How far the expansion is trusted, in time units: sizes are taken where it ends, so that a far too long unit does not
    /// make them look greater than they are.
    pub(super) fn trusted<const N: usize>(&self, e: &Expansion<N>) -> f64 {
        let mut trusted = 1.0;
        for _ in 0..SCALE_ROUNDS {
            let at = smaller(trusted, 1.0);
            let tolerance = self.body.local_tolerance();
            let mut next = trusted_step(&self.scales(e, at), tolerance);
            if self.body.mode == Mode::Fused && self.body.problem.plastic {
                // The interface yields by the force it carries: that has to be right, too.
                let limit = FORCE_TOLERANCE * self.body.interface_limits_n().0
                    / self.body.problem.interface_fraction;
                let scale = own(&e.mechanism, at) + limit + f64::MIN_POSITIVE;
                next = smaller(next, trusted_step(&[(&e.mechanism, scale)], tolerance));
            }
            if next >= SCALE_SETTLED * at {
                return next;
            }
            trusted = next;
        }
        trusted
    }

    /// The span, shortened until the expansion still solves the equations at its end.
    ///
    /// The last coefficients alone can be deceived: the solution may be close to a polynomial and yet end in a singularity.
    fn checked<const N: usize>(&mut self, motion: &Motion<'_>, e: &Expansion<N>, span: f64) -> f64 {
        let allowed = larger(DEFECT * self.body.local_tolerance(), DEFECT_ROUNDING);
        let [_, (_, speed), _, (_, plate_speed)] = self.scales(e, smaller(span, 1.0));
        // Forces that hold each other are known to their own rounding only: no shorter step makes their difference better.
        let noise = ROUNDINGS * plate_noise(motion, e);
        let mut span = span;
        for _ in 0..60 {
            let at_end = motion.accelerations(&e.state(span));
            let time = span * self.control.unit_s;
            let slip_noise = motion.coupling * noise * time / speed;
            let plate_noise = noise * time / plate_speed;
            let slip_defect =
                (at_end.slip_m_s2 * time - evaluate_slope(&e.slip, span) * span) / speed;
            let plate_defect = (at_end.plate_m_s2 * time
                - evaluate_slope(&e.plate_speed, span) * span)
                / plate_speed;
            if slip_defect.abs() <= allowed + slip_noise
                && plate_defect.abs() <= allowed + plate_noise
            {
                break;
            }
            span *= 0.5;
            self.control.rejected += 1;
        }
        span
    }

    /// Scales against which truncation errors are measured: each quantity's own size over the step, but not less than
    /// what matters to the depth while there is contact.
    fn scales<'e, const N: usize>(&self, e: &'e Expansion<N>, s: f64) -> [(&'e [f64; N], f64); 4] {
        let part = self.body.resolved_part();
        let travel = e.travel[0].abs() + s * e.travel[1].abs() + f64::MIN_POSITIVE;
        let speed = self.body.problem.velocity_m_s;
        [
            (&e.travel, travel),
            (&e.slip, speed),
            (&e.plate, own(&e.plate, s) + part * travel + f64::MIN_POSITIVE),
            (&e.plate_speed, own(&e.plate_speed, s) + part * speed + f64::MIN_POSITIVE),
        ]
    }
}

/// The effect of one rounding of the forces on the plate at the start of an expansion, m/s².
fn plate_noise<const N: usize>(motion: &Motion<'_>, e: &Expansion<N>) -> f64 {
    let mechanism_n = motion.mechanism_size(&e.start(), e.mechanism[0], e.damper[0]);
    let contact_n = motion.coupling * e.contact[0].abs();
    f64::EPSILON * motion.plate_mobility * (mechanism_n + contact_n)
}

/// The size of a series over the first `s` of its unit, by its first terms.
fn own<const N: usize>(c: &[f64; N], s: f64) -> f64 {
    c[0].abs() + s * (c[1].abs() + s * (c[2].abs() + s * c[3].abs()))
}
