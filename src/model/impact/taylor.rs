//! Taylor steps: expand the motion, go as far as the expansion is trusted, stop at the first event.

use std::ops::ControlFlow;

use crate::model::impact::guard::Trigger;
use crate::model::impact::track::{Track, is_finite};
use crate::model::motion::{Expansion, Motion};
use crate::model::run::{EndReason, Mode};
use crate::numerics::root::first_fall;
use crate::numerics::series::evaluate_slope;
use crate::numerics::taylor::trusted_step;
use crate::numerics::{larger, smaller};

/// Local tolerance per global tolerance: a run has some tens of steps, whose errors may grow a little.
const LOCAL: f64 = 1e-4;
/// Defect at the end of a step, per local tolerance, above which the step is shortened, and what rounding alone may cause.
const DEFECT: f64 = 100.0;
const DEFECT_ROUNDING: f64 = 1e-12;
/// Part of the interface's strength below which errors of the force it carries do not matter, per tolerance.
const FORCE: f64 = 1e-2;
/// Rounds in which the sizes are taken anew, and the part of the last result from which on they fit.
const SIZINGS: usize = 6;
const SIZED: f64 = 0.7;
/// An expansion of which less than this part of its time unit can be used is made anew with a shorter unit.
const UNIT_FITS: f64 = 0.02;

/// First step, relative to the time reached, of the implicit method when it takes over.
const RESUME: f64 = 1e-9;

impl Track<'_> {
    /// One Taylor step, shortened to the first event.
    pub(super) fn taylor_step<const N: usize>(
        &mut self,
    ) -> ControlFlow<EndReason, Option<Trigger>> {
        let motion = self.motion();
        let h = self.unit_s;
        let e: Expansion<N> = motion.expand(&self.state, h);
        self.evaluations += 1;
        let trusted = self.trusted(&e);
        if trusted < UNIT_FITS {
            // The unit is far too long for what happens now: sizes measured with it mean nothing.
            self.unit_s = h * larger(2.0 * trusted, 1e-3);
            self.rejected += 1;
            if self.unit_s <= 0.5 * f64::EPSILON * self.t_s {
                // Faster than the clock ticks: a plate that creeps against its damper. The implicit method steps over it.
                self.stiff = true;
                self.unit_s = RESUME * self.t_s;
            }
            return ControlFlow::Continue(None);
        }
        let left = (self.until_s() - self.t_s) / h;
        let mut span = self.checked(&motion, &e, smaller(left, trusted));
        let mut fired = None;
        for (trigger, form) in self.guards().iter() {
            let (series, noise) = form.along(&e);
            if let Some(s) = first_fall(&series, span, noise) {
                (span, fired) = (s, Some(*trigger));
            }
        }
        let state = e.state(span);
        if !is_finite(&state) {
            return ControlFlow::Break(EndReason::NonFinite);
        }
        let t_s = self.t_s + span * h;
        if t_s <= self.t_s && fired.is_none() {
            self.stiff = true;
            self.unit_s = RESUME * self.t_s;
            return ControlFlow::Continue(None);
        }
        let mut record = std::mem::take(&mut self.record);
        record.step(&self.setting(&motion), &e, (self.t_s, h, span));
        self.record = record;
        self.unit_s = h * if fired.is_some() { trusted } else { span };
        self.steps += 1;
        self.stretch_steps += 1;
        self.arrive(t_s, state, &motion, fired);
        ControlFlow::Continue(fired)
    }

    /// How far the expansion is trusted, in time units: sizes are taken where it ends, so that a far too long unit does not
    /// make them look greater than they are.
    pub(super) fn trusted<const N: usize>(&self, e: &Expansion<N>) -> f64 {
        let mut trusted = 1.0;
        for _ in 0..SIZINGS {
            let at = smaller(trusted, 1.0);
            let tolerance = self.tolerance * LOCAL;
            let mut next = trusted_step(&self.scales(e, at), tolerance);
            if self.mode == Mode::Fused && self.problem.plastic {
                // The interface gives way by the force it carries: that has to be right, too.
                let limit = FORCE * self.interface_limits_n().0 / self.problem.share;
                let scale = own(&e.mechanism, at) + limit + f64::MIN_POSITIVE;
                next = smaller(next, trusted_step(&[(&e.mechanism, scale)], tolerance));
            }
            if next >= SIZED * at {
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
        let allowed = larger(DEFECT * self.tolerance * LOCAL, DEFECT_ROUNDING);
        let [_, (_, speed), _, (_, plate_speed)] = self.scales(e, smaller(span, 1.0));
        let mut span = span;
        for _ in 0..60 {
            let (slip, plate) = motion.accelerations(&e.state(span));
            let time = span * self.unit_s;
            let slip_defect = (slip * time - evaluate_slope(&e.slip, span) * span) / speed;
            let plate_defect =
                (plate * time - evaluate_slope(&e.plate_speed, span) * span) / plate_speed;
            if slip_defect.abs() <= allowed && plate_defect.abs() <= allowed {
                break;
            }
            span *= 0.5;
            self.rejected += 1;
        }
        span
    }

    /// Scales against which truncation errors are measured: each quantity's own size over the step, but not less than
    /// what matters to the depth while there is contact.
    fn scales<'e, const N: usize>(&self, e: &'e Expansion<N>, s: f64) -> [(&'e [f64; N], f64); 4] {
        let contact = matches!(self.mode, Mode::Penetrating | Mode::Closing | Mode::Withdrawing);
        let part = if contact { 1e-3 } else { 0.0 };
        let travel = e.travel[0].abs() + s * e.travel[1].abs() + f64::MIN_POSITIVE;
        let speed = self.problem.velocity_m_s;
        [
            (&e.travel, travel),
            (&e.slip, speed),
            (&e.plate, own(&e.plate, s) + part * travel + f64::MIN_POSITIVE),
            (&e.plate_speed, own(&e.plate_speed, s) + part * speed + f64::MIN_POSITIVE),
        ]
    }
}

/// The size of a series over the first `s` of its unit, by its first terms.
fn own<const N: usize>(c: &[f64; N], s: f64) -> f64 {
    c[0].abs() + s * (c[1].abs() + s * (c[2].abs() + s * c[3].abs()))
}
