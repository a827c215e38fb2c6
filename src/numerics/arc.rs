//! One accepted step of any method, as events and records see it. Knows no method.

/// A step that has been taken, from part 0 at its start to part 1 at its end.
pub(crate) trait Arc {
    type State;
    type Step;

    /// The state at a part of the step, by its dense output.
    fn dense(&self, part: f64) -> Self::State;

    /// A step from the same start that ends at this part; `None` where the method finds none.
    fn anew(&self, part: f64) -> Option<Self::Step>;

    /// The state at the end of such a step, which ends at this part.
    fn end(&self, part: f64, step: &Self::Step) -> Self::State;

    /// The state at a part of the step, as exact as the method is.
    fn exact(&self, part: f64) -> Self::State {
        self.anew(part).map_or_else(|| self.dense(part), |step| self.end(part, &step))
    }
}
