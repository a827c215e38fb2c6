//! The plain steps of a single contact: the kernel compiled for its kinds of spring and damper.

use crate::model::contact_kernel::expansion::StepTime;
use crate::model::contact_kernel::integration::{IntegrationState, Plan, Sides};
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
            return self.with_laws::<N, GRADED, _, _>(
                Linear(self.spring.coefficient),
                damper,
                plan,
            );
        }
        // The singular start serves whole powers, too: a high power of a small displacement is next to nothing.
        let spring = Power::<N>::of(self.spring);
        match plan.progress.clock {
            StepTime::Graded { .. } => self.with_laws::<N, true, _, _>(spring, damper, plan),
            StepTime::Even { .. } => self.with_laws::<N, GRADED, _, _>(spring, damper, plan),
        }
    }

    fn with_laws<const N: usize, const GRADED: bool, K: Law<N>, D: Law<N>>(
        &self,
        spring: K,
        damper: D,
        plan: &Plan,
    ) -> Option<ContactEnd> {
        debug_assert!(GRADED || matches!(plan.progress.clock, StepTime::Even { .. }));
        let expand = |progress: &IntegrationState, area| {
            let rates = progress.clock.rates();
            self.constants.expand::<N, GRADED>(spring, damper, progress.state, rates, area)
        };
        self.go_on(expand, Sides { spring: K::TWO_SIDED, damper: D::TWO_SIDED }, plan)
    }
}
