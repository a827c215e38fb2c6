//! Messages to the user: the message row shows the newest, the Log tab stores all.

use cmra_studies::enumeration;

use crate::tui::app::App;
use crate::tui::theme::Role;
use cmra_engine::model::run::{Run, RunWarning};
use cmra_engine::model::units::{fixed_significant, scientific};
use cmra_studies::study::envelope::{self, Breach, Check};

enumeration! {
    pub enum Severity in SeverityRow {
        /// Mark before the text, so that colour is not the only indication.
        mark: &'static str,
        /// Keyword in the Log tab.
        word: &'static str,
        role: Role,
    }
    /// Information.
    Note { mark: " ", word: "note", role: Role::Text }
    /// Legal, but may need attention.
    Warning { mark: "!", word: "warning", role: Role::Warning }
    /// Failed action.
    Error { mark: "error:", word: "error", role: Role::Error }
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notice {
    pub severity: Severity,
    pub text: String,
}

/// Part of the status row: severity and text.
pub type StatusPart = (Severity, String);

pub(crate) fn part(severity: Severity, text: impl Into<String>) -> StatusPart {
    (severity, text.into())
}

/// Text of a pane and its status row before the first result.
pub(crate) const NO_RESULTS: &str = "no results yet: press <run>";

/// Returns the text for results of another scene or setup than the current one.
pub(crate) fn old(whose: &str) -> String {
    format!("another {whose}'s results: press <run>")
}

/// Returns the distinct labels of checks.
fn labels(checks: impl Iterator<Item = Check>) -> Vec<&'static str> {
    let mut labels: Vec<&str> = Vec::new();
    for label in checks.map(Check::label) {
        if !labels.contains(&label) {
            labels.push(label);
        }
    }
    labels
}

/// Returns the status part for failed validity checks at a place.
pub(crate) fn outside(checks: impl Iterator<Item = Check>, place: &str) -> Option<StatusPart> {
    let labels = labels(checks);
    let text = format!("! validity{place}: {}", labels.join(", "));
    (!labels.is_empty()).then_some((Severity::Warning, text))
}

/// Maximum number of checks at the ends of axes that are named individually.
const AT_ENDS_NAMED: usize = 3;

/// Adds the validity checks that fail at the ends of axes to the status part of those that fail anyway, and names no check twice. Wide axes
/// fail many checks; the Log tab lists all.
pub(crate) fn with_ends(
    validity: Option<StatusPart>,
    ends: impl Iterator<Item = Check>,
) -> Option<StatusPart> {
    let known = validity.as_ref().map_or("", |part| &part.1);
    let known: Vec<&str> = known.split([':', ',']).map(str::trim).collect();
    let mut labels = labels(ends);
    labels.retain(|label| !known.contains(label));
    let named = match labels[..] {
        [] => return validity,
        [first, ..] if labels.len() > AT_ENDS_NAMED => {
            format!("{first}, {} more", labels.len() - 1)
        }
        _ => labels.join(", "),
    };
    let text = match validity {
        Some((_, text)) => format!("{text}; at the ends: {named}"),
        None => format!("! validity at the ends: {named}"),
    };
    Some((Severity::Warning, text))
}

impl App {
    /// Returns the breaches of the scene, including those of its run, if available, for all struck plates.
    pub(crate) fn breaches(&self) -> Vec<Breach> {
        let run = self.shown.as_ref().map(|shown| &shown.run).filter(|_| !self.shows_old());
        run.map_or_else(|| envelope::of_scene(&self.scene), |run| envelope::of_run(run))
    }

    /// Formats the validity for the status row.
    pub(crate) fn validity_part(&self) -> Option<StatusPart> {
        let found = self.breaches();
        // The status row of a run already contains the interface load.
        let of_run = self.shows_runs();
        let is_shown = |check: &Check| *check == Check::Interface && of_run;
        let checks = found.iter().map(|breach| breach.check);
        outside(checks.filter(|check| !is_shown(check)), "")
    }
}

/// Formats the first warning of a run briefly for the status row.
pub(crate) fn demand(run: &Run) -> Option<String> {
    run.warnings.iter().find_map(|warning| match warning {
        RunWarning::InterfacePush { ratio, .. } if !ratio.is_finite() => {
            Some("! interface force unbounded".to_owned())
        }
        RunWarning::InterfacePush { ratio, .. } => {
            Some(format!("! interface {} x A S_y", fixed_significant(*ratio, 3)))
        }
        RunWarning::InterfacePull { ratio, has_grip, .. } if !ratio.is_finite() => {
            let text =
                if *has_grip { "! interface pull unbounded" } else { "! pulls without a grip" };
            Some(text.to_owned())
        }
        RunWarning::InterfacePull { ratio, .. } => {
            Some(format!("! interface {} x g A S_y", fixed_significant(*ratio, 3)))
        }
        RunWarning::PenetrationResumed { .. } => Some("! penetration resumed".to_owned()),
        RunWarning::EnergyDrift { residual } => {
            Some(format!("! energy off by {}", scientific(*residual, 0)))
        }
        RunWarning::Limit(_) => Some("! a spring is beyond its limit".to_owned()),
        RunWarning::PlateMeetsNext { .. } => Some("! plates meet".to_owned()),
        RunWarning::HorizonNotReached { .. } => Some("! horizon not reached".to_owned()),
        _ => None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_check_is_named_twice_in_a_status_row() {
        let checks = [Check::Thickness, Check::Interface];
        let own = outside([Check::Thickness].into_iter(), "");
        let [thickness, interface] = checks.map(Check::label);
        let (_, both) = with_ends(own.clone(), checks.into_iter()).expect("a part");
        assert_eq!(both, format!("! validity: {thickness}; at the ends: {interface}"));
        assert_eq!(with_ends(own.clone(), [Check::Thickness].into_iter()), own);
        let (_, ends) = with_ends(None, checks.into_iter()).expect("a part");
        assert_eq!(ends, format!("! validity at the ends: {thickness}, {interface}"));
    }
}
