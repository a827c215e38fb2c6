//! Events at the present state already: put behind it by rounding, or on the very place where another one has put it.

use super::Body;
use crate::model::event_function::{ActiveEvents, EventId};
use crate::model::impact::TERMS;
use crate::model::motion::Expansion;
use crate::numerics::{larger, smaller};

/// The longest time unit of the series that tells which way a function goes, over the time the projectile takes for its tip's radius;
/// how many of its coefficients do; and the part of the greatest up to which one is rounding: an oblique section has no exact zero at
/// first contact.
const UNIT_MAX: f64 = 0.1;
const RATES: usize = 5;
const NOISE: f64 = 1e-9;

impl Body<'_> {
    /// The event whose function is at zero or below and goes on falling: no step would show it to change its sign. The next step
    /// takes about `step_s`.
    pub(in crate::model::impact) fn missed_event(
        &self,
        events: &ActiveEvents,
        step_s: f64,
    ) -> Option<EventId> {
        use EventId as E;
        let motion = self.motion();
        // Under a constant force a step may be without end.
        let longest_s = UNIT_MAX * self.problem.geometry.nose.radius_m / self.problem.velocity_m_s;
        let unit_s = smaller(step_s, longest_s);
        let missed = events.iter().find(|(event, form)| {
            let value = form.value_beyond_rounding(&motion, &self.state);
            let falls = || {
                let e: Expansion<TERMS> = motion.expand(&self.state, unit_s);
                let series = form.along(&motion, &e);
                // Those of a section's edge are not finite.
                let mut rates = series[1..RATES].iter().filter(|c| c.is_finite());
                let noise = NOISE * rates.clone().fold(0.0, |most, c| larger(c.abs(), most));
                rates.find(|c| c.abs() > noise).is_some_and(|c| *c < 0.0)
            };
            match event {
                // Each law of a power knows the side of its zero.
                E::PlateZero | E::PlateSpeedZero | E::PlateClear | E::PlateSpeedClear => false,
                E::SlipZero => value < 0.0,
                // The velocity may have jumped when the history of a contact ended.
                E::StopPressed if value < -form.rounding(&motion, &self.state) => true,
                E::StopReached if self.released => false,
                _ => value <= 0.0 && falls(),
            }
        });
        missed.map(|(event, _)| *event)
    }
}
