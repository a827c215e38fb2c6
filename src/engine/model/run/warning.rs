//! Warnings of a run, as sentences.

use std::fmt;

use crate::model::mechanism::load::Limit;
use crate::model::run::{AtLeast, EndReason, EnergyLedger, Outcome};
use crate::model::units::{self, engineering};
use crate::model::worded::worded;

/// A warning about a run.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "the sentence of each says what it means")]
pub enum Warning {
    InterfacePush { ratio: f64, t_s: f64 },
    InterfacePull { ratio: f64, t_s: f64 },
    InterfaceRebound { ratio: f64 },
    InterfaceWithoutStrength,
    PenetrationResumed { t_s: f64 },
    EnergyDrift { residual: f64 },
    EndedEarly(EndReason),
    StillMoving { outcome: Outcome, at_least: AtLeast },
    HorizonNotReached { reason: EndReason, t_s: f64, horizon_s: f64 },
    NoBaseline,
    Overruns { t_s: f64, duration_s: f64 },
    NotModelled(NotModelled),
    Limit(Limit),
    PlateMeetsNext { plate: usize, travel_m: f64, gap_m: f64 },
}

worded! {
    /// What a contact model does not contain, although the scene has it or the run comes to it.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum NotModelled: words {
        RearFace = "the depth is beyond the rear face, of which this model knows nothing: the plate would be perforated",
        PlasticLaw = "interface = plastic is ignored: only the hydrodynamic model has an interface that can yield",
        Stop = "the stop is ignored: the listing of Appendix A has none",
        PartingBehindHole = "as printed, projectile and plate move on as one body although the plate is perforated",
    }
}

/// An energy residual above this earns a warning.
const DRIFT: f64 = 1e-8;

impl Warning {
    /// That a ledger does not close, if it does not.
    pub fn of_ledger(ledger: &EnergyLedger) -> Option<Self> {
        let residual = ledger.residual();
        let is_closed = residual.abs() < DRIFT;
        (!is_closed).then_some(Self::EnergyDrift { residual })
    }
}

fn still_moving(outcome: Outcome, at_least: &AtLeast) -> String {
    let is_decided = if outcome == Outcome::Moving { "is not" } else { "is" };
    let decided = format!("the outcome {is_decided} decided");
    let bounds = match (at_least.penetration_m, at_least.plate_displacement_m) {
        (None, None) => {
            return format!(
                "still oscillating at the end of the run; {decided}, and depth and greatest displacement cannot grow later"
            );
        }
        (Some(_), None) => "depth",
        (None, Some(_)) => "greatest displacement",
        (Some(_), Some(_)) => "depth and greatest displacement",
    };
    format!("still moving when the run ended; {decided}; lower bounds (values so far): {bounds}")
}

fn overruns(t_s: f64, duration_s: f64) -> String {
    format!(
        "equal velocities at {:.4} us, before t_d = {:.4} us: the half-sine history is that of a fixed plate, and the force \
         goes on to t_d",
        t_s * 1e6,
        duration_s * 1e6
    )
}

/// The load of the interface over its strength in words.
fn times(ratio: f64, strength: &str) -> String {
    if ratio.is_finite() {
        format!("is {} times its strength {strength}", units::significant(ratio, 4))
    } else if strength == PUSH {
        "is unbounded".to_owned()
    } else {
        "has no grip (g = 0) to hold it".to_owned()
    }
}

/// The strength of the interface against push and against pull.
const PUSH: &str = "A S_y";
const PULL: &str = "g A S_y";

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::InterfacePush { ratio, t_s } => write!(
                f,
                "interface push {}; first at t = {:.4} ms, penetration would resume: try interface = plastic",
                times(*ratio, PUSH),
                t_s * 1e3
            ),
            Self::InterfacePull { ratio, t_s } => write!(
                f,
                "interface pull {}; first at t = {:.4} ms, the projectile would be pulled out (the grip g is an assumption): try \
                 interface = plastic",
                times(*ratio, PULL),
                t_s * 1e3
            ),
            Self::InterfaceRebound { ratio } => write!(
                f,
                "rebound pull {}; after this run the plate comes back and the projectile may come loose and strike again (the grip g \
                 is an assumption): try interface = plastic",
                times(*ratio, PULL)
            ),
            Self::InterfaceWithoutStrength => {
                f.write_str("the interface has no strength (S_y = 0): no demand ratio exists")
            }
            Self::PenetrationResumed { t_s } => write!(
                f,
                "penetration resumed at t = {:.4} ms; the projectile had stopped in the plate, and the final depth is greater than that first one",
                t_s * 1e3
            ),
            Self::EnergyDrift { residual } if !residual.is_finite() => f.write_str(
                "the solution diverged: the method does not resolve this scene; its results are invalid",
            ),
            Self::EnergyDrift { residual } => {
                write!(f, "the energy balance has an error of {residual:.1e} of the energy at the start")
            }
            Self::EndedEarly(reason) => f.write_str(reason.words()),
            Self::StillMoving { outcome, at_least } => {
                f.write_str(&still_moving(*outcome, at_least))
            }
            Self::HorizonNotReached { reason, t_s, horizon_s } => write!(
                f,
                "the horizon of {} was not reached: the run stopped at t = {} ({})",
                engineering(*horizon_s, "s", 4),
                engineering(*t_s, "s", 4),
                reason.words()
            ),
            Self::Overruns { t_s, duration_s } => f.write_str(&overruns(*t_s, *duration_s)),
            Self::NotModelled(what) => f.write_str(what.words()),
            Self::PlateMeetsNext { plate, travel_m, gap_m } => write!(
                f,
                "plate {} travels {} m, farther than the gap of {} m behind it: plates that meet are not in the model",
                plate + 1,
                units::significant(*travel_m, 4),
                units::significant(*gap_m, 4)
            ),
            Self::Limit(limit) => write!(
                f,
                "spring is displaced by {} m, beyond {} m; there {}",
                units::significant(limit.required_m, 4),
                units::significant(limit.limit_m, 4),
                limit.what
            ),
            Self::NoBaseline => f.write_str(
                "the same shot also perforates the plate on a rigid mount: there is no depth to compare with",
            ),
        }
    }
}
