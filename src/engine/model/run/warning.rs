//! Warnings of a run, as sentences.

use std::fmt;

use crate::model::labelled_enum::labelled_enum;
use crate::model::mechanism::load::Limit;
use crate::model::run::{AtLeast, EndReason, Outcome};
use crate::model::units::{engineering, significant};

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
    NoHardening { tensile_pa: Option<f64>, yield_pa: f64 },
    PlugStopped,
    WeightOmitted { share: f64 },
    Overruns { t_s: f64, duration_s: f64 },
    NotModelled(NotModelled),
    Limit(Limit),
    PlateMeetsNext { plate: usize, travel_m: f64, gap_m: f64 },
}

labelled_enum! {
    /// Effect that the contact model neglects although it occurs in the scene or the run.
    pub enum NotModelled: words {
        RearFace = "the depth is beyond the rear face, of which this model knows nothing: the plate would be perforated",
        PlasticLaw = "interface = plastic is ignored: only the hydrodynamic model has an interface that can yield",
        Stop = "the stop is ignored: the listing of Appendix A has none",
        PartingBehindHole = "as printed, projectile and plate move on as one body although the plate is perforated",
    }
}

fn still_moving(outcome: Outcome, at_least: AtLeast) -> String {
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

/// The load of the interface over its strength in words.
fn times(ratio: f64, strength: &str, unbounded: &str) -> String {
    if !ratio.is_finite() {
        return unbounded.to_owned();
    }
    format!("is {} times its strength {strength}", significant(ratio, 4))
}

/// Why the plate does not harden.
fn no_hardening(tensile_pa: Option<f64>, yield_pa: f64) -> String {
    let mega = |pa: f64| significant(1e-6 * pa, 4);
    let why = tensile_pa.map_or_else(
        || "UTS is not given".to_owned(),
        |pa| format!("UTS = {} MPa is not above Y = {} MPa", mega(pa), mega(yield_pa)),
    );
    format!("{why}: the plate is taken not to harden (n = 0)")
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let pull = |ratio| times(ratio, "g A S_y", "has no grip (g = 0) to hold it");
        let text = match *self {
            Self::InterfacePush { ratio, t_s } => format!(
                "interface push {}; first at t = {:.4} ms, penetration would resume: try interface = plastic",
                times(ratio, "A S_y", "is unbounded"),
                t_s * 1e3
            ),
            Self::InterfacePull { ratio, t_s } => format!(
                "interface pull {}; first at t = {:.4} ms, the projectile would be pulled out (the grip g is an assumption): try \
                 interface = plastic",
                pull(ratio),
                t_s * 1e3
            ),
            Self::InterfaceRebound { ratio } => format!(
                "rebound pull {}; after this run the plate comes back and the projectile may come loose and strike again (the grip g \
                 is an assumption): try interface = plastic",
                pull(ratio)
            ),
            Self::InterfaceWithoutStrength => {
                "the interface has no strength (S_y = 0): no demand ratio exists".to_owned()
            }
            Self::PenetrationResumed { t_s } => format!(
                "penetration resumed at t = {:.4} ms; the projectile had stopped in the plate, and the final depth is greater than that \
                 first one",
                t_s * 1e3
            ),
            Self::EnergyDrift { residual } if residual.is_finite() => {
                format!("the energy balance has an error of {residual:.1e} of the energy at the start")
            }
            Self::EnergyDrift { .. } => {
                "the solution diverged: the method does not resolve this scene; its results are invalid".to_owned()
            }
            Self::EndedEarly(reason) => reason.words().to_owned(),
            Self::StillMoving { outcome, at_least } => still_moving(outcome, at_least),
            Self::HorizonNotReached { reason, t_s, horizon_s } => format!(
                "the horizon of {} was not reached: the run stopped at t = {} ({})",
                engineering(horizon_s, "s", 4),
                engineering(t_s, "s", 4),
                reason.words()
            ),
            Self::Overruns { t_s, duration_s } => format!(
                "equal velocities at {:.4} us, before t_d = {:.4} us: the half-sine history is that of a fixed plate, and the force \
                 goes on to t_d",
                t_s * 1e6,
                duration_s * 1e6
            ),
            Self::NotModelled(what) => what.words().to_owned(),
            Self::PlateMeetsNext { plate, travel_m, gap_m } => format!(
                "plate {} travels {} m, farther than the gap of {} m behind it: plates that meet are not in the model",
                plate + 1,
                significant(travel_m, 4),
                significant(gap_m, 4)
            ),
            Self::Limit(Limit { required_m, limit_m, what }) => format!(
                "spring is displaced by {} m, beyond {} m; there {what}",
                significant(required_m, 4),
                significant(limit_m, 4)
            ),
            Self::NoHardening { tensile_pa, yield_pa } => no_hardening(tensile_pa, yield_pa),
            Self::PlugStopped => "depth and forces are indicative: the plug law picks the plug up at any speed, though a slow shot \
                                  shears nothing"
                .to_owned(),
            Self::WeightOmitted { share } => format!(
                "a shot that falls presses on by its weight, which is not counted: along the stroke {} % of the impact's energy \
                 (unconservative); set weight = on",
                significant(100.0 * share, 2)
            ),
            Self::NoBaseline => {
                "the same shot also perforates the plate on a rigid mount: there is no depth to compare with".to_owned()
            }
        };
        f.write_str(&text)
    }
}
