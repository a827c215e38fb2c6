//! Messages to the person: the message row shows the newest, the Log tab keeps them all.

use cmra_studies::enumeration;

use crate::model::run::envelope::Check;
use crate::model::run::{Run, Warning};
use crate::model::units::{fixed_significant, scientific};
use crate::tui::theme::Role;

enumeration! {
    pub enum Severity in SeverityRow {
        /// The mark in front of the text; colour is never the only channel.
        mark: &'static str,
        /// The word in the Log tab.
        word: &'static str,
    }
    /// Good to know.
    Note { mark: " ", word: "note" }
    /// Legal, yet worth a second look.
    Warning { mark: "!", word: "warning" }
    /// It did not work.
    Error { mark: "error:", word: "error" }
}

impl Severity {
    pub(crate) fn role(self) -> Role {
        match self {
            Self::Note => Role::Text,
            Self::Warning => Role::Warning,
            Self::Error => Role::Error,
        }
    }
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

/// The checks of the model's validity that fail there.
pub(crate) fn outside(checks: impl Iterator<Item = Check>, place: &str) -> Option<StatusPart> {
    let mut labels: Vec<&str> = Vec::new();
    for label in checks.map(Check::label) {
        if !labels.contains(&label) {
            labels.push(label);
        }
    }
    let text = format!("! validity{place}: {}", labels.join(", "));
    (!labels.is_empty()).then_some((Severity::Warning, text))
}

/// How many times too much, to three digits.
pub(crate) fn times(ratio: f64) -> String {
    fixed_significant(ratio, 3)
}

/// The first warning of a run in a few words, for the status row.
pub(crate) fn demand(run: &Run) -> Option<String> {
    run.warnings.iter().find_map(|warning| match warning {
        Warning::InterfacePush { ratio, .. } if !ratio.is_finite() => {
            Some("! interface force unbounded".to_owned())
        }
        Warning::InterfacePush { ratio, .. } => {
            Some(format!("! interface {} x A S_y", times(*ratio)))
        }
        Warning::InterfacePull { ratio, .. } if !ratio.is_finite() => {
            Some("! pulls without a grip".to_owned())
        }
        Warning::InterfacePull { ratio, .. } => {
            Some(format!("! interface {} x g A S_y", times(*ratio)))
        }
        Warning::PenetrationResumed { .. } => Some("! penetration resumed".to_owned()),
        Warning::EnergyDrift { residual } => {
            Some(format!("! energy off by {}", scientific(*residual, 0)))
        }
        Warning::Limit(_) => Some("! a spring is beyond its limit".to_owned()),
        Warning::PlateMeetsNext { .. } => Some("! plates meet".to_owned()),
        Warning::HorizonNotReached { .. } => Some("! horizon not reached".to_owned()),
        _ => None,
    })
}
