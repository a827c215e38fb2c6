//! The first step of a contact whose singular laws have little effect yet, taken from first contact itself.
//!
//! From rest the plate is pushed like t, moves like t² and comes like t³, so that a spring x^n with n > 1/3 and a damper w^m with
//! m > 1/2 hold back a part of the push that vanishes towards first contact, with the powers 3n - 1 and 2m - 1 of time. Up to
//! where that part is small the contact is expanded without them, and what they have taken from the plate is put in afterwards,
//! by their powers of time there. A damper with m = 1/2 needs no such thing: the root of a velocity that starts like t² is as
//! smooth as the rest, and belongs into the expansion (`law.rs`).

use std::ops::ControlFlow;

use crate::model::contact_kernel::expansion::{Constants, Series, StepTime, trusted};
use crate::model::contact_kernel::integration::{
    InitialPhase, IntegrationState, Plan, Sides, StepEnd, plate_scale_m,
};
use crate::model::contact_kernel::law::{Damping, Linear, RootFromRest};
use crate::model::contact_kernel::similarity_start;
use crate::model::contact_kernel::{Contact, GRADED_UNIT, TERMS, is_linear};
use crate::model::mechanism::PowerLaw;
use crate::numerics::smaller;

/// Power of time above which a force vanishes fast enough against a push that grows with the first.
const VANISHES_ABOVE: f64 = 1.2;
/// The exponent of a damper that is expanded from rest.
const ROOT: f64 = 0.5;
/// Part of the tolerance that may be left of what is put in afterwards.
const RESIDUAL_PART: f64 = 0.2;
/// How wrong that is per unit by which the plate's displacement is not a pure power of time.
const CURVATURE_ERROR: f64 = 0.2;
/// How much later than the start by balance (`similarity_start.rs`) it must come to be worth its expansion.
const LATER_MIN: f64 = 4.0;
/// Rounds for the length of the step.
const ROUNDS: usize = 4;

/// A law that is omitted from the first step.
#[derive(Clone, Copy)]
struct OmittedLaw {
    law: PowerLaw,
    /// With which power of time its argument grows from rest: a spring's 3, a damper's 2.
    argument: f64,
}

/// How far its argument has come, and with which power of time it grows there.
#[derive(Clone, Copy)]
struct Growth {
    z: f64,
    power: f64,
}

/// The impulse it has taken from the plate by some time.
#[derive(Clone, Copy)]
struct Impulse {
    /// Of its velocity, m/s.
    w_m_s: f64,
    /// Of its displacement, m.
    x_m: f64,
    /// By how much that velocity may be wrong, m/s.
    doubt_m_s: f64,
}

impl OmittedLaw {
    fn power(self) -> f64 {
        self.law.exponent * self.argument
    }

    /// What it takes by `t_s`, where its argument has grown so far, from a plate of this mass whose velocity there would be
    /// `w_m_s`.
    fn taken(self, at: Growth, t_s: f64, plate_kg: f64, w_m_s: f64) -> Impulse {
        let power = self.law.exponent * at.power;
        let taken = self.law.force(at.z) * t_s / ((power + 1.0) * plate_kg);
        let curvature = CURVATURE_ERROR * (at.power - self.argument).abs();
        Impulse {
            w_m_s: taken,
            x_m: taken * t_s / (power + 2.0),
            doubt_m_s: taken * (taken / w_m_s + curvature),
        }
    }
}

impl Contact {
    /// The contact after such a step; `None` where another start is the better one.
    pub(super) fn early(&self, tolerance: f64, terms: usize) -> Option<InitialPhase> {
        by_terms!(terms, N => self.early_by::<N>(tolerance))
    }

    fn early_by<const N: usize>(&self, tolerance: f64) -> Option<InitialPhase> {
        let (spring, damper) = (self.spring, self.damper);
        let is_root = damper.exponent.to_bits() == ROOT.to_bits() && !is_linear(damper);
        let omitted = [
            (!is_linear(spring)).then_some(OmittedLaw { law: spring, argument: 3.0 }),
            (!is_linear(damper) && !is_root).then_some(OmittedLaw { law: damper, argument: 2.0 }),
        ];
        let state = [0.0, self.constants.velocity_m_s, self.start_m, 0.0];
        let mut progress = self.begin(0.0, state, StepTime::Even { unit_s: 0.5 * self.scale_s? });
        let until = self.matters_at(&omitted, tolerance)?;
        let kept = |law: PowerLaw| if is_linear(law) { law.coefficient } else { 0.0 };
        // Dampers that are not linear are compiled for one number of terms.
        let series = if const { N == TERMS } && is_root {
            let root = RootFromRest::<N>::new(damper.coefficient);
            self.first(kept(spring), root, &progress)?
        } else {
            self.first::<N>(kept(spring), Linear(kept(damper)), &progress)?
        };
        let last_terms = self.constants.last_terms(&series, plate_scale_m(0.0, None));
        let span = trusted::<N>(last_terms, tolerance);
        progress.steps = 1;
        let progress = if omitted.iter().all(Option::is_none) {
            let end_of_step = StepEnd::of(&series, span);
            let sides = Sides { spring: true, damper: false };
            match self.advance(&mut progress, sides, &end_of_step, &series) {
                ControlFlow::Break(end) => return Some(InitialPhase::without_steps(end)),
                ControlFlow::Continue(()) => Some(progress).filter(|it| it.t_s > 0.0),
            }
        } else {
            self.put_in(&series, &omitted, smaller(span, until), tolerance, progress)
        };
        let plan = Plan { progress: progress?, tolerance, reach_m: None, terms: N };
        Some(InitialPhase::Steps(plan))
    }

    fn first<const N: usize>(
        &self,
        spring_n_m: f64,
        damping: impl Damping<N>,
        progress: &IntegrationState,
    ) -> Option<Series<N>> {
        let (rates, area) = (progress.clock.rates(), self.area_law(progress.piece)?);
        let spring = Linear(spring_n_m);
        Some(self.constants.expand::<N, false>(spring, damping, progress.state, rates, area))
    }

    /// In units of the clock, when the laws that are omitted begin to matter, by the powers of time of first contact; `None`
    /// where that is too early.
    fn matters_at(&self, omitted: &[Option<OmittedLaw>; 2], tolerance: f64) -> Option<f64> {
        let Constants { plate_mobility, cos, velocity_m_s, .. } = self.constants;
        let scale_s = self.scale_s?;
        let w_m_s = 0.5 * self.growth_n_s()? * cos * scale_s * scale_s * plate_mobility;
        let at = [w_m_s * scale_s / 3.0, w_m_s];
        let left_m_s = RESIDUAL_PART * tolerance * velocity_m_s / cos;
        let mut part = 1.0;
        for (omitted, z) in omitted.iter().zip(at) {
            let Some(omitted) = omitted else { continue };
            let power = omitted.power();
            if power <= VANISHES_ABOVE {
                return None;
            }
            let growth = Growth { z, power: omitted.argument };
            let by = omitted.taken(growth, scale_s, 1.0 / plate_mobility, w_m_s);
            part = smaller(part, (left_m_s / by.doubt_m_s).powf(0.5 / power));
        }
        let by_balance = similarity_start::part(tolerance, false);
        (part > LATER_MIN * by_balance).then_some(2.0 * part)
    }

    /// Go to about `span` and put in what the laws that were omitted have taken up to there.
    fn put_in<const N: usize>(
        &self,
        series: &Series<N>,
        omitted: &[Option<OmittedLaw>; 2],
        mut span: f64,
        tolerance: f64,
        progress: IntegrationState,
    ) -> Option<IntegrationState> {
        let Constants { plate_mobility, cos, velocity_m_s, .. } = self.constants;
        for _ in 0..ROUNDS {
            let [travel, slip, x, w] = series.state(span);
            let t_s = progress.clock.elapsed_s(span);
            let inside = slip > 0.0 && travel < self.geometry.pieces()[progress.piece].to_m;
            if !(inside && x > 0.0 && w > 0.0) {
                span *= 0.5;
                continue;
            }
            let argument = w * t_s / x;
            let at = [Growth { z: x, power: argument }, Growth { z: w, power: argument - 1.0 }];
            let mut sum = Impulse { w_m_s: 0.0, x_m: 0.0, doubt_m_s: 0.0 };
            let mut power = f64::INFINITY;
            for (omitted, at) in omitted.iter().zip(at) {
                let Some(omitted) = omitted else { continue };
                let taken = omitted.taken(at, t_s, 1.0 / plate_mobility, w);
                sum.w_m_s += taken.w_m_s;
                sum.x_m += taken.x_m;
                sum.doubt_m_s += taken.doubt_m_s;
                power = smaller(power, omitted.power());
            }
            let doubt = cos * sum.doubt_m_s / velocity_m_s;
            if doubt > RESIDUAL_PART * tolerance {
                span *= 0.9 * (RESIDUAL_PART * tolerance / doubt).powf(1.0 / (power + 2.0));
                continue;
            }
            let state =
                [travel + cos * sum.x_m, slip + cos * sum.w_m_s, x - sum.x_m, w - sum.w_m_s];
            let s = t_s.cbrt();
            let clock = StepTime::Graded { s, unit: GRADED_UNIT * s };
            return Some(IntegrationState { t_s, state, clock, ..progress });
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::contact_kernel::{Singular, TERMS_TIGHT};
    use crate::model::variables::scene_without_spring as scene;

    fn contact(pairs: &str) -> Contact {
        Contact::of(&scene(pairs))
    }

    fn progress(initial_phase: Option<&InitialPhase>) -> IntegrationState {
        match initial_phase {
            Some(InitialPhase::Steps(plan)) => plan.progress,
            _ => panic!("no steps"),
        }
    }

    /// Two starts that share no formula: both go on to the same end, this one from later.
    #[test]
    fn it_ends_where_the_start_by_balance_ends_and_begins_its_steps_later() {
        for pairs in ["k=1e5 n=1.4", "k=1e6 n=1.5", "k=1e9 n=2.5 gamma=3", "b=50 m=1.3 k=1e5"] {
            let contact = contact(pairs);
            let (spring, damper) = (contact.spring.exponent > 1.0, contact.damper.exponent > 1.0);
            let singular = Singular { spring, damper };
            for tolerance in [1e-6, 1e-8, 1e-10] {
                let early = progress(contact.early(tolerance, TERMS).as_ref());
                let other = contact.first_step(singular, 1e-12, TERMS_TIGHT).unwrap();
                assert!(
                    early.t_s
                        > 3.0 * similarity_start::part(tolerance, false) * contact.scale_s.unwrap()
                );
                let plan = Plan { progress: early, tolerance, reach_m: None, terms: TERMS };
                let ends = (contact.plan(&plan).unwrap(), contact.plan(&other).unwrap());
                let errors = [
                    ends.0.t_s / ends.1.t_s - 1.0,
                    ends.0.penetration_m / ends.1.penetration_m - 1.0,
                ];
                let holds = errors.iter().all(|e| e.abs() < tolerance);
                assert!(holds, "{pairs} {tolerance:e}: {errors:?}");
            }
        }
    }

    /// Before the contact force has slowed anything the plate obeys m w' + b sqrt(w) = G t, solved by w = (y t)² with
    /// 2 m y² + b y = G.
    #[test]
    fn the_root_of_a_velocity_from_rest_is_expanded_exactly() {
        let contact = contact("b=3000 m=0.5");
        let start_s = 1e-6 * contact.scale_s.unwrap();
        let begin = contact.begin(
            0.0,
            [0.0, contact.constants.velocity_m_s, 0.0, 0.0],
            StepTime::Even { unit_s: start_s },
        );
        let series = contact.first::<14>(0.0, RootFromRest::new(3000.0), &begin).unwrap();
        let mass = 1.0 / contact.constants.plate_mobility;
        let growth = contact.growth_n_s().unwrap() * contact.constants.cos;
        let y = series.speed[2].sqrt() / start_s;
        assert!((2.0 * mass * y * y + 3000.0 * y - growth).abs() < 1e-12 * growth);
        assert!(series.speed[1].abs() < 1e-300 && series.speed[3].abs() < 1e-3 * series.speed[2]);
    }

    #[test]
    fn laws_that_matter_from_the_start_are_left_to_the_other_starts() {
        for pairs in ["k=1e6 n=0.35", "k=1e5 n=0.2", "b=1000 m=0.4"] {
            assert!(contact(pairs).early(1e-8, TERMS).is_none(), "{pairs}");
        }
    }
}
