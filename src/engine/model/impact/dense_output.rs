//! The way of a step: its states by the part of it.

use std::array;

use crate::model::impact::state::State;
use crate::numerics::event_location::CELLS;
use crate::numerics::maximum;

/// The states on a step.
pub(super) struct DenseOutput<'a> {
    at: &'a dyn Fn(f64) -> State,
    /// At the ends of equal parts, from its start to its end: there events are looked for, forces compared and rows drawn, for its
    /// polynomial has no wiggles that they miss.
    pub(super) looks: [State; CELLS + 1],
}

impl<'a> DenseOutput<'a> {
    /// From what gives the state at a part of the step, 0 to 1.
    pub(super) fn new(at: &'a dyn Fn(f64) -> State) -> Self {
        Self { at, looks: array::from_fn(|look| at(look as f64 / CELLS as f64)) }
    }

    pub(super) fn at(&self, fraction: f64) -> State {
        (self.at)(fraction)
    }

    pub(super) fn end(&self) -> &State {
        &self.looks[CELLS]
    }

    /// The greatest value of a function of its states, located only if it may exceed what is known.
    pub(super) fn greatest(&self, known: f64, of: impl Fn(&State) -> f64) -> f64 {
        let values = array::from_fn(|i| of(&self.looks[2 * i]));
        maximum::greatest(&values, known, &|fraction| of(&self.at(fraction)), None)
    }

    /// Returns the greatest value on the step of a function whose rate is known.
    pub(super) fn greatest_by_rate(
        &self,
        known: f64,
        of: impl Fn(&State) -> f64,
        rate: impl Fn(&State) -> f64,
    ) -> f64 {
        let values = array::from_fn(|i| of(&self.looks[2 * i]));
        let rate = |fraction: f64| rate(&self.at(fraction));
        maximum::greatest(&values, known, &|fraction| of(&self.at(fraction)), Some(&rate))
    }
}
