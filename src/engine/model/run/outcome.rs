//! Outcome of a shot, reason for the end of its computation, and bounds of results that are not final.

use crate::model::labelled_enum::labelled_enum;

labelled_enum! {
    /// Outcome of the shot.
    #[derive(Default)]
    pub enum Outcome: word {
        Arrested = "arrested",
        Perforated = "perforated",
        /// The projectile left through the entry face and does not come back.
        Separated = "separated",
        #[default]
        Moving = "moving",
        /// The run perforates, but its law underestimates the limit, and there are no measurements.
        Unmeasured = "not-measured",
    }

    /// Reason for the end of a computation.
    #[derive(Default)]
    pub enum EndReason: words {
        #[default]
        Decided = "outcome decided",
        Horizon = "horizon reached",
        /// Without a horizon: the outcome is undecided after many oscillations or contacts.
        Oscillates = "undecided after many turns and touches",
        StepBudget = "ended early: the step budget was used up",
        StepUnderflow = "ended early: steps became too small to move time forward",
        NonFinite = "ended early: a value stopped being finite",
        BreaksOff = "ended early: the printed listing breaks off at a negative depth",
        Cancelled = "cancelled: what was finished is kept",
    }
}

impl EndReason {
    /// Returns `true` if the run is decided, or reached its horizon.
    pub fn is_complete(self) -> bool {
        matches!(self, Self::Decided | Self::Horizon | Self::Oscillates)
    }
}

/// Lower bounds of the results of an undecided run; `None` for a final or unknown value.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct AtLeast {
    /// Depth of the hole so far, m.
    pub penetration_m: Option<f64>,
    /// Maximum displacement of the plate so far, m.
    pub plate_displacement_m: Option<f64>,
}
