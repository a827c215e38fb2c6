//! Warnings that a run records.

use std::fmt;

use crate::model::mechanism::load::Limit;
use crate::model::run::check::Warning;
use crate::model::run::outcome::{AtLeast, EndReason, Outcome};
use crate::model::units::{engineering, significant};

/// Warning that a run records.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "the sentence of each says what it means")]
pub enum RunWarning {
    InterfacePush { ratio: f64, t_s: f64 },
    InterfacePull { ratio: f64, t_s: f64, has_grip: bool },
    InterfaceRebound { ratio: f64, has_grip: bool },
    InterfaceWithoutStrength,
    PenetrationResumed { t_s: f64, is_deeper: bool },
    EnergyDrift { residual: f64 },
    EndedEarly(EndReason),
    StillMoving { outcome: Outcome, at_least: AtLeast },
    HorizonNotReached { reason: EndReason, t_s: f64, horizon_s: f64 },
    NoBaseline,
    NoHardening { tensile_pa: Option<f64>, yield_pa: f64 },
    PlugStopped,
    WeightOmitted { fraction: f64 },
    Overruns { t_s: f64, duration_s: f64 },
    NotModelled(NotModelled),
    Limit(Limit),
    PlateMeetsNext { plate: usize, travel_m: f64, gap_m: f64 },
}

/// Effect that the contact model neglects although it occurs in the scene or the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the sentence of each says what it means")]
pub enum NotModelled {
    RearFace,
    PlasticLaw,
    Stop,
    PartingBehindHole,
}

impl NotModelled {
    /// Value and meaning.
    fn sentence(self) -> (&'static str, &'static str) {
        match self {
            Self::RearFace => (
                "the depth is beyond the rear face, of which this model knows nothing",
                ": the plate would be perforated",
            ),
            Self::PlasticLaw => (
                "interface = plastic is ignored",
                ": only the hydrodynamic model has an interface that can yield",
            ),
            Self::Stop => ("the stop is ignored", ": the listing of Appendix A has none"),
            Self::PartingBehindHole => (
                "as printed, projectile and plate move on as one body although the plate is perforated",
                "",
            ),
        }
    }
}

fn still_moving(outcome: Outcome, at_least: AtLeast) -> (String, String) {
    let is_decided = if outcome == Outcome::Moving { "is not" } else { "is" };
    let decided = format!("the outcome {is_decided} decided");
    let bounds = match (at_least.penetration_m, at_least.plate_displacement_m) {
        (None, None) => {
            return (
                "still oscillating at the end of the run".to_owned(),
                format!("; {decided}, and depth and greatest displacement cannot grow later"),
            );
        }
        (Some(_), None) => "depth",
        (None, Some(_)) => "greatest displacement",
        (Some(_), Some(_)) => "depth and greatest displacement",
    };
    (
        format!("still moving when the run ended; {decided}"),
        format!("; lower bounds (values so far): {bounds}"),
    )
}

/// The load of the interface over its strength in words.
fn times(ratio: f64, strength: &str, unbounded: &str) -> String {
    if !ratio.is_finite() {
        return unbounded.to_owned();
    }
    // A hole that is nearly through has hardly any area left: its digits say nothing.
    if ratio > 1e6 {
        return format!("is more than a million times its strength {strength}");
    }
    format!("is {} times its strength {strength}", significant(ratio, 4))
}

/// Why the plate does not harden.
fn no_hardening(tensile_pa: Option<f64>, yield_pa: f64) -> String {
    let mega = |pa: f64| significant(1e-6 * pa, 4);
    tensile_pa.map_or_else(
        || "UTS is not given".to_owned(),
        |pa| format!("UTS = {} MPa is not above Y = {} MPa", mega(pa), mega(yield_pa)),
    )
}

/// Load of the interface in tension, in words.
fn tension(ratio: f64, has_grip: bool) -> String {
    let unbounded = if has_grip { "is unbounded" } else { "has no grip (g = 0) to hold it" };
    times(ratio, "g A S_y", unbounded)
}

fn pushes(ratio: f64, t_s: f64) -> (String, String) {
    let meaning = format!(
        "; first at t = {}, penetration would resume: try interface = plastic",
        engineering(t_s, "s", 4)
    );
    (format!("interface push {}", times(ratio, "A S_y", "is unbounded")), meaning)
}

fn pulls(ratio: f64, t_s: f64, has_grip: bool) -> (String, String) {
    let meaning = format!(
        "; first at t = {}, the projectile would be pulled out (the grip g is an assumption): try interface = plastic",
        engineering(t_s, "s", 4)
    );
    (format!("interface pull {}", tension(ratio, has_grip)), meaning)
}

fn rebounds(ratio: f64, has_grip: bool) -> (String, String) {
    let meaning = "; after this run the plate comes back and the projectile may come loose and strike again (the grip g is an \
                   assumption): try interface = plastic";
    (format!("rebound pull {}", tension(ratio, has_grip)), meaning.to_owned())
}

fn resumed(t_s: f64, is_deeper: bool) -> (String, String) {
    let depth = if is_deeper {
        "is greater than that first one"
    } else {
        "is that first one within the tolerance"
    };
    (
        format!("penetration resumed at t = {}", engineering(t_s, "s", 4)),
        format!("; the projectile had stopped in the plate, and the final depth {depth}"),
    )
}

fn horizon_not_reached(reason: EndReason, t_s: f64, horizon_s: f64) -> (String, String) {
    let t = engineering(t_s, "s", 4);
    (
        format!("the horizon of {} was not reached", engineering(horizon_s, "s", 4)),
        format!(": the run stopped at t = {t} ({})", reason.words()),
    )
}

fn meets_next(plate: usize, travel_m: f64, gap_m: f64) -> (String, String) {
    let value = format!(
        "plate {} travels {} m, farther than the gap of {} m behind it",
        plate + 1,
        significant(travel_m, 4),
        significant(gap_m, 4)
    );
    (value, ": plates that meet are not in the model".to_owned())
}

/// The displacement of a spring beyond a limit, in words.
fn beyond(Limit { required_m, limit_m, what }: Limit) -> (String, String) {
    let by = if required_m.is_finite() {
        format!("by {} m", significant(required_m, 4))
    } else {
        "without end".to_owned()
    };
    (
        format!("spring is displaced {by}, beyond {} m", significant(limit_m, 4)),
        format!("; there {what}"),
    )
}

impl RunWarning {
    /// Value and meaning of the sentence, the meaning from its punctuation mark on.
    pub fn sentence(&self) -> (String, String) {
        let owned = |(value, meaning): (&str, &str)| (value.to_owned(), meaning.to_owned());
        match *self {
            Self::InterfacePush { ratio, t_s } => pushes(ratio, t_s),
            Self::InterfacePull { ratio, t_s, has_grip } => pulls(ratio, t_s, has_grip),
            Self::InterfaceRebound { ratio, has_grip } => rebounds(ratio, has_grip),
            Self::InterfaceWithoutStrength => {
                owned(("the interface has no strength (S_y = 0)", ": no demand ratio exists"))
            }
            Self::PenetrationResumed { t_s, is_deeper } => resumed(t_s, is_deeper),
            Self::EnergyDrift { residual } if residual.is_finite() => (
                format!(
                    "the energy balance has an error of {residual:.1e} of the energy at the start"
                ),
                String::new(),
            ),
            Self::EnergyDrift { .. } => owned((
                "the solution diverged: the method does not resolve this scene",
                "; its results are invalid",
            )),
            Self::EndedEarly(reason) => owned((reason.words(), "")),
            Self::StillMoving { outcome, at_least } => still_moving(outcome, at_least),
            Self::HorizonNotReached { reason, t_s, horizon_s } => {
                horizon_not_reached(reason, t_s, horizon_s)
            }
            Self::Overruns { t_s, duration_s } => (
                format!(
                    "equal velocities at {}, before t_d = {}",
                    engineering(t_s, "s", 4),
                    engineering(duration_s, "s", 4)
                ),
                ": the half-sine history is that of a fixed plate, and the force goes on to t_d"
                    .to_owned(),
            ),
            Self::NotModelled(what) => owned(what.sentence()),
            Self::PlateMeetsNext { plate, travel_m, gap_m } => meets_next(plate, travel_m, gap_m),
            Self::Limit(limit) => beyond(limit),
            Self::NoHardening { tensile_pa, yield_pa } => (
                no_hardening(tensile_pa, yield_pa),
                ": the plate is taken not to harden (n = 0)".to_owned(),
            ),
            Self::WeightOmitted { fraction } => (
                "a shot that falls presses on by its weight, which is not counted".to_owned(),
                format!(
                    ": along the stroke {} % of the impact's energy (unconservative); set weight = on",
                    significant(100.0 * fraction, 2)
                ),
            ),
            Self::PlugStopped => owned((
                "depth and forces are indicative",
                ": the plug law picks the plug up at any speed, though a slow shot shears nothing",
            )),
            Self::NoBaseline => owned((
                "the same shot also perforates the plate on a rigid mount",
                ": there is no depth to compare with",
            )),
        }
    }
}

impl From<&RunWarning> for Warning {
    fn from(warning: &RunWarning) -> Self {
        let (value, meaning) = warning.sentence();
        Self::remark(value, meaning)
    }
}

impl fmt::Display for RunWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Warning::from(self).fmt(f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hole_without_area_has_a_load_without_digits() {
        let text = RunWarning::InterfacePush { ratio: 3.906e15, t_s: 1e-3 }.to_string();
        assert!(text.starts_with("interface push is more than a million times its strength A S_y"));
        let text = RunWarning::InterfacePush { ratio: 2.8752, t_s: 1e-3 }.to_string();
        assert!(text.starts_with("interface push is 2.875 times its strength A S_y"), "{text}");
    }

    /// An early time keeps its digits, a pull without bound is not one without a grip, and only a greater depth is called so.
    #[test]
    fn sentences_say_what_is_so() {
        let ratio = f64::INFINITY;
        let text = RunWarning::InterfacePull { ratio, t_s: 2.5e-8, has_grip: true }.to_string();
        assert!(text.starts_with("interface pull is unbounded; first at t = 25.00 ns"), "{text}");
        let text = RunWarning::InterfaceRebound { ratio, has_grip: false }.to_string();
        assert!(text.starts_with("rebound pull has no grip (g = 0) to hold it"), "{text}");
        for (is_deeper, says) in [(true, "greater than"), (false, "is that first one")] {
            let text = RunWarning::PenetrationResumed { t_s: 2.5e-8, is_deeper }.to_string();
            assert!(text.starts_with("penetration resumed at t = 25.00 ns"), "{text}");
            assert!(text.contains(says), "{text}");
        }
    }
}
