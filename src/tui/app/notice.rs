//! Messages to the user: the message row shows the newest, the Log tab stores all.

use cmra_studies::enumeration;

use crate::tui::app::App;
use crate::tui::theme::Role;
use cmra_engine::model::run::envelope::{self, Breach, Check};
use cmra_engine::model::run::{Run, RunWarning};
use cmra_engine::model::units::{fixed_significant, scientific};

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

/// Returns the status part for validity checks that fail at the ends of axes. Wide axes fail many checks; the Log tab lists all.
pub(crate) fn outside_at_ends(checks: impl Iterator<Item = Check>) -> Option<StatusPart> {
    let labels = labels(checks);
    let text = match labels[..] {
        [] => return None,
        [first, ..] if labels.len() > AT_ENDS_NAMED => {
            format!("! at the ends: {first}, {} more", labels.len() - 1)
        }
        _ => format!("! validity at the ends: {}", labels.join(", ")),
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
        RunWarning::InterfacePull { ratio, .. } if !ratio.is_finite() => {
            Some("! pulls without a grip".to_owned())
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
