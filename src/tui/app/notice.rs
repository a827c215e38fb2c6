//! Messages to the person: the message row shows the newest, the Log tab keeps them all.

use cmra_studies::enumeration;

use crate::tui::app::App;
use crate::tui::theme::Role;
use cmra_engine::model::run::envelope::{self, Breach, Check};
use cmra_engine::model::run::{Run, RunWarning};
use cmra_engine::model::units::{fixed_significant, scientific};

enumeration! {
    pub enum Severity in SeverityRow {
        /// The mark in front of the text; colour is never the only channel.
        mark: &'static str,
        /// The word in the Log tab.
        word: &'static str,
        role: Role,
    }
    /// Good to know.
    Note { mark: " ", word: "note", role: Role::Text }
    /// Legal, yet worth a second look.
    Warning { mark: "!", word: "warning", role: Role::Warning }
    /// Failed action.
    Error { mark: "error:", word: "error", role: Role::Error }
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notice {
    pub severity: Severity,
    pub text: String,
}

/// A part of the status row: how serious, and the text.
pub type StatusPart = (Severity, String);

pub(crate) fn part(severity: Severity, text: impl Into<String>) -> StatusPart {
    (severity, text.into())
}

/// The words of a pane, and of its row of status, before anything was computed.
pub(crate) const NO_RESULTS: &str = "no results yet: press <run>";

/// The words for results that belong to another scene or setup than the one on the screen.
pub(crate) fn old(whose: &str) -> String {
    format!("another {whose}'s results: press <run>")
}

/// Labels of checks, each once.
fn labels(checks: impl Iterator<Item = Check>) -> Vec<&'static str> {
    let mut labels: Vec<&str> = Vec::new();
    for label in checks.map(Check::label) {
        if !labels.contains(&label) {
            labels.push(label);
        }
    }
    labels
}

/// The checks of the model's validity that fail there.
pub(crate) fn outside(checks: impl Iterator<Item = Check>, place: &str) -> Option<StatusPart> {
    let labels = labels(checks);
    let text = format!("! validity{place}: {}", labels.join(", "));
    (!labels.is_empty()).then_some((Severity::Warning, text))
}

/// Labels of checks at the ends of axes that are named one by one.
const AT_ENDS_NAMED: usize = 3;

/// The checks of the model's validity that fail at the ends of axes: many fail at those of wide ranges, and the Log tab has all.
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
    /// The rules of the model's validity that the scene does not keep: by its run where that is there, with every plate struck.
    pub(crate) fn breaches(&self) -> Vec<Breach> {
        let run = self.shown.as_ref().map(|shown| &shown.run).filter(|_| !self.shows_old());
        run.map_or_else(|| envelope::of_scene(&self.scene), |run| envelope::of_run(run))
    }

    /// Formats the validity for the status row.
    pub(crate) fn validity_part(&self) -> Option<StatusPart> {
        let found = self.breaches();
        // The status row of a run has the load of the interface already, with its number.
        let of_run = self.shows_runs();
        let is_shown = |check: &Check| *check == Check::Interface && of_run;
        let checks = found.iter().map(|breach| breach.check);
        outside(checks.filter(|check| !is_shown(check)), "")
    }
}

/// The first warning of a run in a few words, for the status row.
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
