//! How a point of a study came out: as its shot ended, or without a result.

use std::fmt;

use crate::study::quantities::{Quantity, QuantityFlag};
use cmra_engine::model::run::{EndReason, Outcome, Run};

/// The outcome of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointOutcome {
    /// Outcome of the point's shot.
    Ended(Outcome),
    /// There is no result.
    Failed(Failure),
}

/// Why there is no result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Failure {
    /// The run ended early.
    Early(EndReason),
    /// The scene makes no sense.
    Refused,
    /// The program failed.
    Panicked,
}

impl Failure {
    /// The reason in words.
    pub fn message(self) -> &'static str {
        match self {
            Self::Early(reason) => reason.words(),
            Self::Refused => "the scene makes no physical sense",
            Self::Panicked => "internal error: please report this point",
        }
    }
}

impl PointOutcome {
    /// The word used in files and on screens.
    pub fn key(self) -> &'static str {
        match self {
            Self::Ended(outcome) => outcome.word(),
            Self::Failed(_) => "failed",
        }
    }

    /// The letter drawn where the point has no value.
    pub fn letter(self) -> char {
        match self {
            Self::Ended(Outcome::Arrested | Outcome::Separated) => 'n',
            Self::Ended(Outcome::Perforated) => 'P',
            Self::Ended(Outcome::Moving) => 'M',
            Self::Ended(Outcome::Unmeasured) => 'U',
            Self::Failed(_) => '?',
        }
    }

    /// The meaning of that letter for an output.
    pub fn without_value(self, output: &Quantity) -> &'static str {
        match self {
            Self::Ended(Outcome::Arrested | Outcome::Separated) => output.absence,
            Self::Ended(Outcome::Perforated) => "perforated",
            Self::Ended(Outcome::Moving) => "still moving",
            Self::Ended(Outcome::Unmeasured) => "not measured",
            Self::Failed(_) => "failed",
        }
    }

    /// The outcome of a run's shot.
    pub fn from_run(run: &Run) -> Self {
        if run.end.is_complete() {
            Self::Ended(run.shot_outcome())
        } else {
            Self::Failed(Failure::Early(run.end))
        }
    }

    /// Whether the shot goes through, by the law at least.
    pub fn is_through(self) -> bool {
        matches!(self, Self::Ended(Outcome::Perforated | Outcome::Unmeasured))
    }

    /// Whether the shot was stopped.
    pub fn is_stopped(self) -> bool {
        matches!(self, Self::Ended(Outcome::Arrested | Outcome::Separated))
    }

    /// Whether a number counts where a point ended like this, in tables, extremes and pictures alike: the depth of a perforation
    /// does not.
    pub fn counts(self, output: &Quantity) -> bool {
        match self {
            Self::Ended(Outcome::Perforated) => !output.has(QuantityFlag::OfHole),
            // A quantity that is not final has no value.
            Self::Ended(_) => true,
            Self::Failed(_) => false,
        }
    }
}

/// How many points ended how.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct OutcomeCounts {
    ended: [u64; Outcome::ALL.len()],
    /// There is no result.
    pub failed: u64,
}

impl OutcomeCounts {
    /// Count a point.
    pub fn add(&mut self, outcome: PointOutcome) {
        *match outcome {
            PointOutcome::Ended(outcome) => &mut self.ended[outcome as usize],
            PointOutcome::Failed(_) => &mut self.failed,
        } += 1;
    }

    /// How many shots ended like this.
    pub fn count(self, outcome: Outcome) -> u64 {
        self.ended[outcome as usize]
    }

    /// All points.
    pub fn total(self) -> u64 {
        self.each().map(|(_, count)| count).sum()
    }

    /// Each count with its word, those of no point among them.
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
