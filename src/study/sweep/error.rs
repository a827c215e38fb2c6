//! Why a sweep is refused before anything runs: axis, value, rule, cure.

use thiserror::Error;

use crate::model::variables::VariableError;

/// What is wrong with a sweep.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum SweepError {
    /// There is no such variable.
    #[error("axis {axis}: {source}")]
    Axis {
        /// What was written.
        axis: String,
        /// Why not.
        source: Box<VariableError>,
    },
    /// The variable has words, not numbers.
    #[error(
        "axis {axis}: it has no numbers to sweep over, only {choices}; sweep a numeric variable"
    )]
    NoNumbers {
        /// The variable's symbol.
        axis: &'static str,
        /// What it may be.
        choices: String,
    },
    /// Too few or too many points.
    #[error(
        "axis {axis}: count = {count} is impossible: an axis has {least} to {most} points here; to hold {axis}, set it \
         to one value ({axis}={value})"
    )]
    Count {
        /// The variable's symbol.
        axis: &'static str,
        /// What was asked.
        count: u64,
        /// The fewest.
        least: u64,
        /// The most.
        most: u64,
        /// The axis's first value.
        value: String,
    },
    /// The two ends are one.
    #[error(
        "axis {axis}: both ends are {value}: the two ends must differ; widen the range, or hold {axis} at one value"
    )]
    SameEnds {
        /// The variable's symbol.
        axis: &'static str,
        /// Both ends.
        value: String,
    },
    /// The range reaches values without physical sense.
    #[error(
        "axis {axis}: the range reaches {value}, which is impossible: {meaning} must be {allowed}; {cure}"
    )]
    ImpossibleEnd {
        /// The variable's symbol.
        axis: &'static str,
        /// The end with its unit.
        value: String,
        /// What the variable is.
        meaning: &'static str,
        /// What is allowed.
        allowed: String,
        /// What to do.
        cure: String,
    },
    /// Equal ratios from or to nothing.
    #[error(
        "axis {axis}: {from} to {to} at equal ratios: both ends must be greater than 0; leave out log, or start above 0, for \
         example at {start}"
    )]
    LogFrom {
        /// The variable's symbol.
        axis: &'static str,
        /// First end.
        from: String,
        /// Last end.
        to: String,
        /// A value that would do.
        start: String,
    },
    /// One variable on two axes.
    #[error("axis {axis}: it is swept twice; give each variable one axis")]
    Twice {
        /// The variable's symbol.
        axis: &'static str,
    },
    /// A value stands twice in a list.
    #[error("axis {axis}: {value} stands twice in the list; leave one of them out")]
    ListedTwice {
        /// The variable's symbol.
        axis: &'static str,
        /// The value.
        value: String,
    },
    /// No axis at all.
    #[error("a sweep needs at least one axis, for example gamma=0.8..7:101")]
    NoAxis,
    /// More axes than designs are made for.
    #[error("{count} axes are too many: a sweep has at most {most}; hold some of the variables")]
    TooManyAxes {
        /// What was asked.
        count: usize,
        /// What is allowed.
        most: usize,
    },
    /// More points than can be counted.
    #[error(
        "{points} points are too many: a sweep has at most {most:e}; take fewer points along the axes"
    )]
    TooManyPoints {
        /// What was asked.
        points: String,
        /// What is allowed.
        most: f64,
    },
    /// More points than a screen keeps.
    #[error(
        "{points} points are too many for the screen, which keeps at most {most}: take fewer along the axes, or use `cmra sweep`"
    )]
    TooManyShown {
        /// What was asked.
        points: u64,
        /// What is allowed.
        most: u64,
    },
    /// A design of too few or too many points.
    #[error(
        "points = {points} is impossible: this design has 2 to {most} points; write for example --points 1000"
    )]
    Points {
        /// What was asked.
        points: u64,
        /// What is allowed.
        most: u64,
    },
    /// Somewhere in the design two values make no sense together, or the scene makes none.
    #[error("the sweep reaches an impossible scene ({place}): {source}")]
    Corner {
        /// Where.
        place: String,
        /// Why.
        source: Box<VariableError>,
    },
    /// A part of a whole that does not exist.
    #[error(
        "shard {text}: write I/N with 1 <= I <= N, for example 2/8 for the second of eight parts"
    )]
    Shard {
        /// What was written.
        text: String,
    },
    /// There is no such result.
    #[error("output {name}: not a result of a run: {hint}")]
    Output {
        /// What was written.
        name: String,
        /// The nearest, or all there are.
        hint: String,
    },
}
