//! Event functions: what may end a stretch of smooth motion. Each is a linear form in the state and the forces that falls
//! through zero when its event happens, so that the Taylor and the implicit method locate the same events.

use crate::model::motion::{Expansion, Motion, State};

/// The events that end a stretch of smooth motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum EventId {
    /// The area law changes, going deeper.
    PieceEnd,
    /// The area law changes, coming out.
    PieceStart,
    HoleBottom,
    /// Common velocity.
    SlipZero,
    /// A projectile that had left touches again.
    Recontact,
    ContactLost,
    /// It pushes again a projectile that had not left its dent.
    ContactAgain,
    DentLeft,
    HistoryEnd,
    /// The plate's displacement changes sign (or comes so close to zero that its power law is omitted for a moment).
    PlateZero,
    /// The plate's velocity changes sign (or comes close to zero, as above).
    PlateSpeedZero,
    /// The displacement has left the neighbourhood of zero.
    PlateClear,
    /// The velocity has left the neighbourhood of zero.
    PlateSpeedClear,
    /// The spring's law changes, going forward.
    KnotAhead,
    /// The spring's law changes, going back.
    KnotBehind,
    StopReached,
    StopCleared,
    /// It presses again a plate that had not left its place.
    StopPressed,
    /// Nothing presses the plate on its stop any more.
    StopRelease,
    /// The interface is pushed beyond its strength.
    PushLimit,
    /// The interface is pulled beyond its grip.
    PullLimit,
}

impl EventId {
    /// Whether the event changes what the bodies do, rather than only the form of a law.
    pub(super) fn changes_course(self) -> bool {
        !matches!(
            self,
            Self::PieceEnd
                | Self::PieceStart
                | Self::DentLeft
                | Self::PlateZero
                | Self::PlateSpeedZero
                | Self::PlateClear
                | Self::PlateSpeedClear
                | Self::KnotAhead
                | Self::KnotBehind
        )
    }
}

/// offset + time·t + travel·q + slip·u + plate·x + `plate_speed·w` + contact·F + mechanism·G.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub(super) struct EventFunction {
    pub(super) offset: f64,
    pub(super) time: f64,
    pub(super) travel: f64,
    pub(super) slip: f64,
    pub(super) plate: f64,
    pub(super) plate_speed: f64,
    pub(super) contact: f64,
    pub(super) mechanism: f64,
}

/// The most events that are active at once.
const ACTIVE_MAX: usize = 12;

/// The events that may end one stretch.
#[derive(Clone, Debug)]
pub(super) struct ActiveEvents {
    list: [(EventId, EventFunction); ACTIVE_MAX],
    len: usize,
}

impl ActiveEvents {
    pub(super) fn none() -> Self {
        Self { list: [(EventId::SlipZero, EventFunction::default()); ACTIVE_MAX], len: 0 }
    }

    pub(super) fn add(&mut self, event: EventId, form: EventFunction) {
        debug_assert!(self.len < ACTIVE_MAX, "raise ACTIVE_MAX");
        self.list[self.len] = (event, form);
        self.len += 1;
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = &(EventId, EventFunction)> {
        self.list[..self.len].iter()
    }
}

impl EventFunction {
    pub(super) fn time_up_to(end_s: f64) -> Self {
        Self { offset: end_s, time: -1.0, ..Self::default() }
    }

    pub(super) fn travel_up_to(place_m: f64) -> Self {
        Self { offset: place_m, travel: -1.0, ..Self::default() }
    }

    pub(super) fn travel_down_to(place_m: f64) -> Self {
        Self { offset: -place_m, travel: 1.0, ..Self::default() }
    }

    /// Falls where a slip of this sign becomes zero.
    pub(super) fn slip(sign: f64) -> Self {
        Self { slip: sign, ..Self::default() }
    }

    /// A place plus or minus the plate's displacement.
    pub(super) fn plate(offset: f64, plate: f64) -> Self {
        Self { offset, plate, ..Self::default() }
    }

    /// A velocity plus or minus the plate's.
    pub(super) fn plate_speed(offset: f64, plate_speed: f64) -> Self {
        Self { offset, plate_speed, ..Self::default() }
    }

    /// The event function along an expansion, beyond rounding.
    pub(super) fn along<const N: usize>(&self, motion: &Motion<'_>, e: &Expansion<N>) -> [f64; N] {
        let mut sum = [0.0; N];
        let terms = [
            (self.travel, &e.travel),
            (self.slip, &e.slip),
            (self.plate, &e.plate),
            (self.plate_speed, &e.plate_speed),
            (self.contact, &e.contact),
            (self.mechanism, &e.mechanism),
        ];
        for (factor, series) in terms {
            if factor != 0.0 {
                for (sum, c) in sum.iter_mut().zip(series) {
                    *sum += factor * c;
                }
            }
        }
        sum[1] += self.time * e.unit_s;
        let forces =
            Forces { contact: e.contact[0], mechanism: e.mechanism[0], damper: e.damper[0] };
        sum[0] +=
            self.offset + self.time * e.t_s + self.rounding_allowance(motion, &e.start(), forces);
        sum
    }

    /// The event function at a state, beyond rounding: positions and speeds are put exactly on their event, but one of forces has
    /// fallen only where it is below zero by more than rounding. Forces that have died down, or hold each other, are of either
    /// sign.
    pub(super) fn value_beyond_rounding(&self, motion: &Motion<'_>, state: &State) -> f64 {
        let forces = self.forces(motion, state);
        self.value(state, forces) + self.rounding_allowance(motion, state, forces)
    }

    /// By how much it may be below zero without having fallen.
    fn rounding_allowance(&self, motion: &Motion<'_>, state: &State, forces: Forces) -> f64 {
        let has_force = self.contact != 0.0 || self.mechanism != 0.0;
        if has_force { self.rounding_of(motion, state, forces) } else { 0.0 }
    }

    /// The rounding error of the form at a state where it is zero.
    pub(super) fn rounding(&self, motion: &Motion<'_>, state: &State) -> f64 {
        self.rounding_of(motion, state, self.forces(motion, state))
    }

    /// The same where contact, mechanism and damper hold with these forces, N.
    fn rounding_of(&self, motion: &Motion<'_>, state: &State, forces: Forces) -> f64 {
        let mechanism_n = motion.mechanism_size(state, forces.mechanism, forces.damper);
        let terms = self.terms(state, Forces { mechanism: mechanism_n, ..forces });
        8.0 * f64::EPSILON * terms.iter().map(|term| term.abs()).sum::<f64>()
    }

    pub(super) fn at(&self, motion: &Motion<'_>, state: &State) -> f64 {
        self.value(state, self.forces(motion, state))
    }

    /// How fast a form without forces changes at a state.
    pub(super) fn rate(&self, motion: &Motion<'_>, state: &State) -> f64 {
        let accelerations = motion.accelerations(state);
        self.time
            + self.travel * state.slip_m_s
            + self.slip * accelerations.slip_m_s2
            + self.plate * state.plate_m_s
            + self.plate_speed * accelerations.plate_m_s2
    }

    /// The form where these forces act.
    pub(super) fn value(&self, state: &State, forces: Forces) -> f64 {
        self.terms(state, forces).iter().sum()
    }

    fn terms(&self, state: &State, forces: Forces) -> [f64; 8] {
        [
            self.offset,
            self.time * state.t_s,
            self.travel * state.travel_m,
            self.slip * state.slip_m_s,
            self.plate * state.plate_m,
            self.plate_speed * state.plate_m_s,
            self.contact * forces.contact,
            self.mechanism * forces.mechanism,
        ]
    }

    /// The forces at a state, as far as they are in the form; else zero.
    fn forces(&self, motion: &Motion<'_>, state: &State) -> Forces {
        let mut forces = Forces::default();
        if self.contact != 0.0 {
            forces.contact = motion.contact_force(state);
        }
        if self.mechanism != 0.0 {
            forces.mechanism = motion.mechanism_force(state);
            forces.damper = motion.damper.force(state.plate_m_s);
        }
        forces
    }
}

/// The forces that an event function may contain, N.
#[derive(Clone, Copy, Default)]
pub(super) struct Forces {
    contact: f64,
    mechanism: f64,
    damper: f64,
}
