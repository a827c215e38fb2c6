//! The motion with displacement, or velocity, of the plate as the independent variable.

use crate::model::event_function::EventId;
use crate::model::mechanism::{Elastic, sign};
use crate::model::motion::{Motion, State};
use crate::numerics::smaller;

/// Part of the displacement that a plate may come back from its greatest displacement within a crossing step, where its spring is
/// non-integer, too.
const OF_DISPLACEMENT: f64 = 0.3;

/// The law whose zero is passed, and with it what the variable is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum CrossedLaw {
    /// The spring's: the variable is x.
    Spring,
    /// The damper's: the variable is w.
    Damper,
}

/// Since the start of the crossing step: time, s; path of the projectile, travel and plate together, m; change of its velocity,
/// m/s; and of what the variable leaves of the plate: by x the energy of plate and spring per mass, J/kg; by w the displacement,
/// m.
pub(super) type Unknowns = [f64; 4];

pub(super) struct IndependentVariable<'a> {
    pub(super) law: CrossedLaw,
    pub(super) motion: &'a Motion<'a>,
    pub(super) from: State,
    /// The way in which the variable runs: the sign of its rate.
    pub(super) heading: f64,
}

impl<'a> IndependentVariable<'a> {
    pub(super) fn new(law: CrossedLaw, motion: &'a Motion<'a>, from: State) -> Self {
        let variable = Self { law, motion, from, heading: 0.0 };
        Self { heading: sign(variable.speed()), ..variable }
    }

    pub(super) fn now(&self) -> f64 {
        self.shown(&self.from)
    }

    pub(super) fn shown(&self, state: &State) -> f64 {
        match self.law {
            CrossedLaw::Spring => state.plate_m,
            CrossedLaw::Damper => state.plate_m_s,
        }
    }

    /// The event function that watches for the zero of this law.
    pub(super) fn own_trigger(&self) -> EventId {
        match self.law {
            CrossedLaw::Spring => EventId::PlateZero,
            CrossedLaw::Damper => EventId::PlateSpeedZero,
        }
    }

    /// The state when the variable shows `z`.
    pub(super) fn state(&self, z: f64, y: &Unknowns) -> State {
        let State { t_s, travel_m, slip_m_s, plate_m: x, plate_m_s: w } = self.from;
        let (moved_m, plate_m_s) = match self.law {
            CrossedLaw::Spring => {
                let half_square = self.energy() + y[3] - self.potential(z);
                (z - x, self.heading * (2.0 * half_square).sqrt())
            }
            CrossedLaw::Damper => (y[3], z),
        };
        let cos = self.motion.coupling;
        // A joined body has no coupling, and its speed may be beyond all bounds where the way is too long.
        let apart = if cos == 0.0 { 0.0 } else { cos * (plate_m_s - w) };
        State {
            t_s: t_s + y[0],
            travel_m: travel_m + (y[1] - cos * moved_m),
            slip_m_s: slip_m_s + (y[2] - apart),
            plate_m: if self.law == CrossedLaw::Spring { z } else { x + moved_m },
            plate_m_s,
        }
    }

    /// Energy of plate and spring at the start, per mass, J/kg.
    pub(super) fn energy(&self) -> f64 {
        let w = self.from.plate_m_s;
        0.5 * w * w + self.potential(self.from.plate_m)
    }

    pub(super) fn rate(&self, state: &State) -> Unknowns {
        let motion = self.motion;
        let (cos, w) = (motion.coupling, state.plate_m_s);
        let contact = motion.contact_force(state);
        let slowing = contact * (motion.slip_mobility - cos * cos * motion.plate_mobility);
        let velocity = state.projectile_m_s(cos);
        match self.law {
            CrossedLaw::Spring => {
                let push = cos * contact - motion.damper.force(w) - motion.stop_force(state);
                [1.0 / w, velocity / w, -slowing / w, push * motion.plate_mobility]
            }
            CrossedLaw::Damper => {
                let a = motion.accelerations(state).plate_m_s2;
                [1.0 / a, velocity / a, -slowing / a, w / a]
            }
        }
    }

    /// How fast the variable runs at the start, m/s or m/s².
    pub(super) fn speed(&self) -> f64 {
        match self.law {
            CrossedLaw::Spring => self.from.plate_m_s,
            CrossedLaw::Damper => self.motion.accelerations(&self.from).plate_m_s2,
        }
    }

    /// How far from zero a crossing step may begin or end: as far as no more than this part of the plate's energy, or of the
    /// force that turns it round, is exchanged on the way, and further singularities are further away still.
    pub(super) fn room(&self, part: f64) -> f64 {
        let motion = self.motion;
        let (x, w, mobility) = (self.from.plate_m, self.from.plate_m_s, motion.plate_mobility);
        let a = motion.accelerations(&self.from).plate_m_s2;
        match (self.law, motion.spring) {
            (CrossedLaw::Spring, Elastic::Power(spring)) => {
                let kinetic = 0.5 * w * w;
                let others = (a + spring.force(x) * mobility).abs();
                let by_spring = spring.at_integral(part * kinetic / mobility);
                smaller(by_spring, part * kinetic / others)
            }
            (CrossedLaw::Spring, Elastic::Piece(_)) => 0.0,
            (CrossedLaw::Damper, spring) => {
                let others = (a + motion.damper.force(w) * mobility).abs();
                let stiffness = spring.tangent(x).abs() + motion.stop.stiffness_n_m;
                let by_damper = motion.damper.at_force(part * others / mobility);
                let by_spring = (part * others * others / (mobility * stiffness)).sqrt();
                let singular = matches!(spring, Elastic::Power(law) if law.is_singular());
                let back_m = if singular { OF_DISPLACEMENT * x.abs() } else { f64::INFINITY };
                smaller(by_damper, smaller(by_spring, (2.0 * others * back_m).sqrt()))
            }
        }
    }

    /// Energy in the spring per mass of what it moves, J/kg.
    fn potential(&self, x: f64) -> f64 {
        match self.motion.spring {
            Elastic::Power(law) => law.integral(x) * self.motion.plate_mobility,
            Elastic::Piece(_) => 0.0,
        }
    }
}
