//! Outcome of a point of a study: the outcome of its shot, or a failure.

use std::fmt;

use crate::study::quantities::{Quantity, QuantityFlag};
use cmra_engine::model::run::{EndReason, Outcome, Run};

/// Outcome of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointOutcome {
    /// Outcome of the point's shot.
    Ended(Outcome),
    /// No result.
    Failed(Failure),
}

/// Reason for a missing result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Failure {
    /// The run ended early.
    Early(EndReason),
    /// The scene is physically impossible.
    Refused,
    /// The computation panicked.
    Panicked,
}

impl Failure {
    /// Returns the reason as text.
    pub fn message(self) -> &'static str {
        match self {
            Self::Early(reason) => reason.words(),
            Self::Refused => "the scene makes no physical sense",
            Self::Panicked => "internal error: please report this point",
        }
    }
}

impl PointOutcome {
    /// Returns the word in files and on screens.
    pub fn key(self) -> &'static str {
        match self {
            Self::Ended(outcome) => outcome.word(),
            Self::Failed(_) => "failed",
        }
    }

    /// Returns the letter that a chart shows in place of a missing value.
    pub fn letter(self) -> char {
        match self {
            Self::Ended(Outcome::Arrested | Outcome::Separated) => 'n',
            Self::Ended(Outcome::Perforated) => 'P',
            Self::Ended(Outcome::Moving) => 'M',
            Self::Ended(Outcome::Unmeasured) => 'U',
            Self::Failed(_) => '?',
        }
    }

    /// Returns the meaning of that letter for a quantity.
    pub fn without_value(self, output: &Quantity) -> &'static str {
        match self {
            Self::Ended(Outcome::Arrested | Outcome::Separated) => output.absence,
            Self::Ended(Outcome::Perforated) => "perforated",
            Self::Ended(Outcome::Moving) => "still moving",
            Self::Ended(Outcome::Unmeasured) => "not measured",
            Self::Failed(_) => "failed",
        }
    }

    /// Returns the outcome of a run.
    pub fn from_run(run: &Run) -> Self {
        if run.end.is_complete() {
            Self::Ended(run.shot_outcome())
        } else {
            Self::Failed(Failure::Early(run.end))
        }
    }

    /// Returns `true` if the shot perforates, at least by the law.
    pub fn is_through(self) -> bool {
        matches!(self, Self::Ended(Outcome::Perforated | Outcome::Unmeasured))
    }

    /// Returns `true` if the shot was stopped.
    pub fn is_stopped(self) -> bool {
        matches!(self, Self::Ended(Outcome::Arrested | Outcome::Separated))
    }

    /// Returns `true` if a quantity has a value for this outcome, in tables, extremes and charts. The depth of a perforation has none.
    pub fn counts(self, output: &Quantity) -> bool {
        match self {
            Self::Ended(Outcome::Perforated) => !output.has(QuantityFlag::OfHole),
            // A quantity that is not final has no value.
            Self::Ended(_) => true,
            Self::Failed(_) => false,
        }
    }
}

/// Number of points by outcome.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct OutcomeCounts {
    ended: [u64; Outcome::ALL.len()],
    /// Number of points without a result.
    pub failed: u64,
}

impl OutcomeCounts {
    /// Adds a point.
    pub fn add(&mut self, outcome: PointOutcome) {
        *match outcome {
            PointOutcome::Ended(outcome) => &mut self.ended[outcome as usize],
            PointOutcome::Failed(_) => &mut self.failed,
        } += 1;
    }

    /// Returns the number of shots with an outcome.
    pub fn count(self, outcome: Outcome) -> u64 {
        self.ended[outcome as usize]
    }

    /// Returns the number of all points.
    pub fn total(self) -> u64 {
        self.each().map(|(_, count)| count).sum()
    }

    /// Returns each word with its count, zeros included.
    pub fn each(self) -> impl Iterator<Item = (&'static str, u64)> {
        Outcome::WORDS.into_iter().zip(self.ended).chain([("failed", self.failed)])
    }
}

impl fmt::Display for OutcomeCounts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let known = self.each().filter(|(_, count)| *count > 0);
        let parts: Vec<String> = known.map(|(word, count)| format!("{count} {word}")).collect();
        f.write_str(if parts.is_empty() { "no point" } else { "" })?;
        f.write_str(&parts.join(", "))
    }
}
