//! The plain steps of a single contact: the kernel compiled for its kinds of spring and damper.

use crate::model::impact::lean::expansion::Clock;
use crate::model::impact::lean::law::{Law, Linear, Power, Whole};
use crate::model::impact::lean::way::{Track, Walk};
use crate::model::impact::lean::{Contact, ContactEnd, TERMS, TERMS_LOOSE, TERMS_TIGHT};
use crate::model::mechanism::PowerKind;

impl Contact {
    /// Go on by plain steps to the end; `None` where the full track is needed.
    pub(super) fn walk(&self, walk: &Walk) -> Option<ContactEnd> {
        match walk.terms {
            TERMS_LOOSE => self.with_spring::<TERMS_LOOSE>(walk),
            TERMS => self.with_spring::<TERMS>(walk),
            _ => self.with_spring::<TERMS_TIGHT>(walk),
        }
    }

    fn with_spring<const N: usize>(&self, walk: &Walk) -> Option<ContactEnd> {
        let law = self.spring;
        let side = if self.start_m < 0.0 { -1.0 } else { 1.0 };
        match law.kind() {
            PowerKind::Absent | PowerKind::Linear => {
                self.with_damper::<N>(Linear(law.coefficient), walk)
            }
            PowerKind::Whole(2) => self.with_damper::<N>(Whole::<N, 2>::new(law, side), walk),
            PowerKind::Whole(3) => self.with_damper::<N>(Whole::<N, 3>::new(law, side), walk),
            // The singular start serves them, too: a high power of a small displacement is next to nothing.
            PowerKind::Whole(_) | PowerKind::General => {
                self.with_damper::<N>(Power::<N>::of(law), walk)
            }
        }
    }

    fn with_damper<const N: usize>(&self, spring: impl Law<N>, walk: &Walk) -> Option<ContactEnd> {
        let law = self.damper;
        match law.kind() {
            PowerKind::Absent | PowerKind::Linear => {
                self.with_laws(spring, Linear(law.coefficient), walk)
            }
            // From rest the plate only goes forward.
            PowerKind::Whole(2) => self.with_laws(spring, Whole::<N, 2>::new(law, 1.0), walk),
            PowerKind::Whole(_) | PowerKind::General => {
                self.with_laws(spring, Power::<N>::of(law), walk)
            }
        }
    }

    fn with_laws<const N: usize, K: Law<N>, D: Law<N>>(
        &self,
        spring: K,
        damper: D,
        walk: &Walk,
    ) -> Option<ContactEnd> {
        let laws = (spring, damper);
        let constants = &self.constants;
        let how = ((K::TWO_SIDED, D::TWO_SIDED), walk.tolerance, walk.reach_m);
        if matches!(walk.track.clock, Clock::Graded { .. }) {
            let expand = |track: &Track, (origin_m, a)| {
                let rates = track.clock.rates();
                Some(constants.expand::<N, true>(laws, track.state, rates, (origin_m, a)))
            };
            self.go_on(expand, walk.track, how).ended()
        } else {
            let expand = |track: &Track, (origin_m, a)| {
                let rates = track.clock.rates();
                Some(constants.expand::<N, false>(laws, track.state, rates, (origin_m, a)))
            };
            self.go_on(expand, walk.track, how).ended()
        }
    }
}
