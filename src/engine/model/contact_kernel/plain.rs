//! The plain steps of a single contact: the kernel compiled for its kinds of spring and damper.

use pulp::{Arch, Simd, WithSimd};

use crate::model::contact_kernel::expansion::StepTime;
use crate::model::contact_kernel::integration::{IntegrationState, Plan, Sides};
use crate::model::contact_kernel::lane_buffer::has_lanes;
use crate::model::contact_kernel::law::{Law, Linear, Power, Square};
use crate::model::contact_kernel::{Contact, ContactEnd, TERMS, is_linear};
use crate::model::mechanism::PowerKind;

impl Contact {
    /// Go on by plain steps to the end; `None` where the simulation is needed.
    pub(super) fn plan(&self, plan: &Plan) -> Option<ContactEnd> {
        let law = self.damper;
        match law.kind() {
            PowerKind::Absent | PowerKind::Linear => {
                by_terms!(plan.terms, N => self.with_linear_damper::<N>(plan))
            }
            // From rest the plate only goes forward.
            PowerKind::Whole(2) => self.with_damper::<TERMS, false>(Square::<TERMS>::of(law), plan),
            PowerKind::Whole(_) | PowerKind::General => {
                self.with_damper::<TERMS, true>(Power::<TERMS>::of(law), plan)
            }
        }
    }

    fn with_linear_damper<const N: usize>(&self, plan: &Plan) -> Option<ContactEnd> {
        self.with_damper::<N, false>(Linear(self.damper.coefficient), plan)
    }

    /// `GRADED` decides the clock, unless the spring does: a singular damper always starts on a graded clock.
    fn with_damper<const N: usize, const GRADED: bool>(
        &self,
        damper: impl Law<N>,
        plan: &Plan,
    ) -> Option<ContactEnd> {
        if is_linear(self.spring) {
            return self.with_laws::<N, GRADED>(Linear(self.spring.coefficient), damper, plan);
        }
        // The singular start serves whole powers, too: a high power of a small displacement is next to nothing.
        let spring = Power::<N>::of(self.spring);
        match plan.progress.clock {
            StepTime::Graded { .. } => self.with_laws::<N, true>(spring, damper, plan),
            StepTime::Even { .. } => self.with_laws::<N, GRADED>(spring, damper, plan),
        }
    }

    fn with_laws<const N: usize, const GRADED: bool>(
        &self,
        spring: impl Law<N>,
        damper: impl Law<N>,
        plan: &Plan,
    ) -> Option<ContactEnd> {
        debug_assert!(GRADED || matches!(plan.progress.clock, StepTime::Even { .. }));
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
        // Each number of terms is compiled in full: processors without vectors have one, as rare laws have, which serves every
        // tolerance.
        if const { !has_lanes::<S>() && N != TERMS } {
            return self.contact.with_linear_damper::<TERMS>(self.plan);
        }
        let expand = |progress: &IntegrationState, area| {
            let rates = progress.clock.rates();
            let (spring, damper) = (self.spring, self.damper);
            self.contact.constants.expand::<N, GRADED>(spring, damper, progress.state, rates, area)
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

    /// The path of processors without vectors. The depth at the first arrest is row S2 of `reference.csv`.
    #[test]
    fn valid_one_number_of_terms_serves_every_tolerance() {
        let contact = Contact::of(&Scene::default());
        let mut numbers = Vec::new();
        for tolerance in [1e-4, 1e-8, 1e-11] {
            let InitialPhase::Steps(plan) = contact.initial_phase(tolerance) else {
                panic!("no plain steps")
            };
            numbers.push(plan.terms);
            let depth_m = contact.with_linear_damper::<TERMS>(&plan).unwrap().penetration_m;
            let error = (depth_m / 0.004_571_788_754_106_379 - 1.0).abs();
            assert!(error < tolerance, "{tolerance:e}: {error:e}");
        }
        assert!(numbers.iter().any(|terms| *terms != TERMS) && numbers.contains(&TERMS_TIGHT));
    }
}
