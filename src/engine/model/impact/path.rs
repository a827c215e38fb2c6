//! The way of a step: its states by the part of it.

use crate::model::impact::equations::State;

/// Parts of a step at whose ends events are looked for, forces compared and rows drawn: its polynomial has no wiggles that they miss.
pub(super) const LOOKS: usize = 16;

/// The states on a step; those at the looks are computed once.
pub(super) struct Path<'a> {
    at: &'a dyn Fn(f64) -> State,
    looks: [State; LOOKS + 1],
}

impl<'a> Path<'a> {
    /// From what gives the state at a part of the step, 0 to 1.
    pub(super) fn of(at: &'a dyn Fn(f64) -> State) -> Self {
        Self { at, looks: std::array::from_fn(|look| at(look as f64 / LOOKS as f64)) }
    }

    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::float_cmp,
        reason = "only what comes back the same is a look"
    )]
    pub(super) fn at(&self, part: f64) -> State {
        let place = part * LOOKS as f64;
        let look = place as usize;
        match self.looks.get(look) {
            Some(state) if look as f64 == place => *state,
            _ => (self.at)(part),
        }
    }

    pub(super) fn start(&self) -> &State {
        &self.looks[0]
    }

    pub(super) fn end(&self) -> &State {
        &self.looks[LOOKS]
    }
}
