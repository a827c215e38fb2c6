//! The plain steps of a single contact: the kernel compiled for its kinds of spring and damper.

use pulp::{Arch, Simd, WithSimd};

use crate::model::contact_kernel::expansion::Clock;
use crate::model::contact_kernel::integration::{Plan, Sides, Track};
use crate::model::contact_kernel::lane_buffer::has_lanes;
use crate::model::contact_kernel::law::{Law, Linear, Power, Whole};
use crate::model::contact_kernel::{
    Contact, ContactEnd, SPRING_POWERS, TERMS, is_linear, is_singular,
};
use crate::model::mechanism::PowerKind;

impl Contact {
    /// Go on by plain steps to the end; `None` where the simulation is needed.
    pub(super) fn plan(&self, plan: &Plan) -> Option<ContactEnd> {
        if !self.has_common_laws() {
            return self.with_spring::<TERMS>(plan);
        }
        let damper = Linear(self.damper.coefficient);
        by_terms!(plan.terms, N => match (is_linear(self.spring), plan.track.clock) {
            (true, _) => {
                self.with_laws::<N, false>(Linear(self.spring.coefficient), damper, plan)
            }
            (false, Clock::Graded { .. }) => {
                self.with_laws::<N, true>(Power::<N>::of(self.spring), damper, plan)
            }
            (false, Clock::Even { .. }) => {
                self.with_laws::<N, false>(Power::<N>::of(self.spring), damper, plan)
            }
        })
    }

    /// Whether the laws are those of most scenes: a linear damper, and a spring that is linear or a power compiled as any other.
    /// They are compiled for each number of terms, the rest for one.
    pub(super) fn has_common_laws(&self) -> bool {
        is_linear(self.damper)
            && (is_linear(self.spring) || is_singular(self.spring, SPRING_POWERS))
    }

    fn with_spring<const N: usize>(&self, plan: &Plan) -> Option<ContactEnd> {
        let law = self.spring;
        let side = if self.start_m < 0.0 { -1.0 } else { 1.0 };
        match law.kind() {
            PowerKind::Absent | PowerKind::Linear => {
                self.with_damper::<N, false>(Linear(law.coefficient), plan)
            }
            PowerKind::Whole(2) => {
                self.with_damper::<N, false>(Whole::<N, 2>::new(law, side), plan)
            }
            PowerKind::Whole(3) => {
                self.with_damper::<N, false>(Whole::<N, 3>::new(law, side), plan)
            }
            // The singular start serves them, too: a high power of a small displacement is next to nothing.
            PowerKind::Whole(_) | PowerKind::General => {
                let spring = Power::<N>::of(law);
                match plan.track.clock {
                    Clock::Graded { .. } => self.with_damper::<N, true>(spring, plan),
                    Clock::Even { .. } => self.with_damper::<N, false>(spring, plan),
                }
            }
        }
    }

    /// `GRADED` tells the clock, unless the damper does: a singular one always starts on a graded clock.
    fn with_damper<const N: usize, const GRADED: bool>(
        &self,
        spring: impl Law<N>,
        plan: &Plan,
    ) -> Option<ContactEnd> {
        let law = self.damper;
        match law.kind() {
            PowerKind::Absent | PowerKind::Linear => {
                self.with_laws::<N, GRADED>(spring, Linear(law.coefficient), plan)
            }
            // From rest the plate only goes forward.
            PowerKind::Whole(2) => {
                self.with_laws::<N, GRADED>(spring, Whole::<N, 2>::new(law, 1.0), plan)
            }
            PowerKind::Whole(_) | PowerKind::General => {
                self.with_laws::<N, true>(spring, Power::<N>::of(law), plan)
            }
        }
    }

    fn with_laws<const N: usize, const GRADED: bool>(
        &self,
        spring: impl Law<N>,
        damper: impl Law<N>,
        plan: &Plan,
    ) -> Option<ContactEnd> {
        debug_assert!(GRADED || matches!(plan.track.clock, Clock::Even { .. }));
        Arch::new().dispatch(Single::<N, GRADED, _, _> { contact: self, spring, damper, plan })
    }
}

/// A contact by itself, compiled for the instructions of the machine.
struct Single<'c, const N: usize, const GRADED: bool, K, D> {
    contact: &'c Contact,
    spring: K,
    damper: D,
    plan: &'c Plan,
}

impl<const N: usize, const GRADED: bool, K: Law<N>, D: Law<N>> WithSimd
    for Single<'_, N, GRADED, K, D>
{
    type Output = Option<ContactEnd>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, _simd: S) -> Option<ContactEnd> {
        // Each number of terms is compiled in full: processors without vectors have one, which serves every tolerance.
        if const { !has_lanes::<S>() && N != TERMS } {
            return self.contact.with_spring::<TERMS>(self.plan);
        }
        let expand = |track: &Track, area| {
            let rates = track.clock.rates();
            let (spring, damper) = (self.spring, self.damper);
            self.contact.constants.expand::<N, GRADED>(spring, damper, track.state, rates, area)
        };
        let sides = Sides { spring: K::TWO_SIDED, damper: D::TWO_SIDED };
        self.contact.go_on(expand, sides, self.plan)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::contact_kernel::TERMS_TIGHT;
    use crate::model::contact_kernel::integration::InitialPhase;
    use crate::model::scene::Scene;

    /// What processors without vectors do. The depth at the first arrest is row S2 of `reference.csv`.
    #[test]
    fn valid_one_number_of_terms_serves_every_tolerance() {
        let contact = Contact::of(&Scene::default());
        let mut numbers = Vec::new();
        for tolerance in [1e-4, 1e-8, 1e-11] {
            let InitialPhase::Steps(plan) = contact.initial_phase(tolerance) else {
                panic!("no plain steps")
            };
            numbers.push(plan.terms);
            let depth_m = contact.with_spring::<TERMS>(&plan).unwrap().penetration_m;
            let error = (depth_m / 0.004_571_788_754_106_379 - 1.0).abs();
            assert!(error < tolerance, "{tolerance:e}: {error:e}");
        }
        assert!(numbers.iter().any(|terms| *terms != TERMS) && numbers.contains(&TERMS_TIGHT));
    }
}
