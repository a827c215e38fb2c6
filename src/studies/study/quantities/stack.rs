//! The quantities of a stack from those of its plates.

use crate::model::run::Run;
use crate::numerics::{larger, smaller};

/// How a quantity of a stack follows from those of its plates.
#[derive(Clone, Copy, Debug)]
pub(super) enum OfStack {
    /// It has no meaning for a stack.
    Absent,
    /// As it stands: it has been made for stacks, too.
    Whole,
    /// From all plates that were struck, the base plate included; each must have it.
    Plates(Join),
    /// The same without the base plate, which does not move.
    Elements(Join),
    /// From the plates that have it.
    Known(Join),
}

/// How the values of plates are joined.
#[derive(Clone, Copy, Debug)]
pub(in crate::study) enum Join {
    Least,
    Greatest,
    Sum,
}

impl Join {
    /// One value from those of all plates; `None` where one has none, or there are no plates.
    pub(in crate::study) fn of(self, mut values: impl Iterator<Item = Option<f64>>) -> Option<f64> {
        let join = match self {
            Self::Least => smaller,
            Self::Greatest => larger,
            Self::Sum => |a, b| a + b,
        };
        let first = values.next()??;
        values.try_fold(first, |all, value| Some(join(all, value?)))
    }
}

impl OfStack {
    pub(super) fn value(self, run: &Run, own: impl Fn(&Run) -> Option<f64>) -> Option<f64> {
        match self {
            Self::Absent => None,
            Self::Whole => own(run),
            Self::Plates(join) => join.of(run.plates().map(own)),
            Self::Elements(join) => join.of(run.elements().map(own)),
            Self::Known(join) => join.of(run.plates().filter_map(own).map(Some)),
        }
    }
}
