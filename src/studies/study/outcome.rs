//! How a point of a study came out: as its shot ended, or without a result.

use crate::model::run::{EndReason, Outcome, Run};
use crate::study::quantities::Quantity;

/// The outcome of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointOutcome {
    /// That of its shot.
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
    pub fn words(self) -> &'static str {
        match self {
            Self::Early(reason) => reason.words(),
            Self::Refused => "the scene makes no physical sense",
            Self::Panicked => "internal error: please report this point",
        }
    }
}

impl PointOutcome {
    /// The word used in files and on screens.
    pub fn word(self) -> &'static str {
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
            Self::Failed(_) => '?',
        }
    }

    /// The meaning of that letter for an output.
    pub fn without_value(self, output: &Quantity) -> &'static str {
        match self {
            Self::Ended(Outcome::Arrested | Outcome::Separated) => output.absence,
            Self::Ended(Outcome::Perforated) => "perforated",
            Self::Ended(Outcome::Moving) => "still moving",
            Self::Failed(_) => "failed",
        }
    }

    /// The outcome of a run's shot.
    pub fn of(run: &Run) -> Self {
        if run.end.is_complete() {
            Self::Ended(run.shot_outcome())
        } else {
            Self::Failed(Failure::Early(run.end))
        }
    }

    /// Whether the shot was stopped.
    pub fn is_stopped(self) -> bool {
        matches!(self, Self::Ended(Outcome::Arrested | Outcome::Separated))
    }
    /// Whether a number counts where a point ended like this, in tables, extremes and pictures alike: the depth of a perforation
    /// does not.
    pub fn counts(self, output: &Quantity) -> bool {
        match self {
            Self::Ended(Outcome::Perforated) => output.exists_in_perforation(),
            // A quantity that is not final has no value.
            Self::Ended(_) => true,
            Self::Failed(_) => false,
        }
    }
}
