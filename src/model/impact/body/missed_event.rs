//! Events at the present state already: put behind it by rounding, or on the very place where another one has put it.

use super::Body;
use crate::model::event_function::{ActiveEvents, EventId};
use crate::model::impact::TERMS;
use crate::model::motion::Expansion;

impl Body<'_> {
    /// The event whose function is at zero or below and goes on falling: no step would show it to change its sign. One unit of
    /// time is this long, s.
    pub(in crate::model::impact) fn missed_event(
        &self,
        events: &ActiveEvents,
        unit_s: f64,
    ) -> Option<EventId> {
        use EventId as E;
        let motion = self.motion();
        let missed = events.iter().find(|(event, form)| {
            let value = form.value_beyond_rounding(&motion, &self.state);
            let falls = || {
                let e: Expansion<TERMS> = motion.expand(&self.state, unit_s);
                let series = form.along(&motion, &e);
                series[1..].iter().find(|c| **c != 0.0).is_some_and(|c| *c < 0.0)
            };
            match event {
                // Each law of a power knows the side of its zero.
                E::PlateZero | E::PlateSpeedZero | E::PlateClear | E::PlateSpeedClear => false,
                E::SlipZero => value < 0.0,
                E::StopReached if self.released => false,
                _ => value <= 0.0 && falls(),
            }
        });
        missed.map(|(event, _)| *event)
    }
}
