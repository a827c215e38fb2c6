//! Errors of studies, by kind.

use thiserror::Error;

use cmra_engine::model::units::UnitError;
use cmra_engine::model::variables::{VariableError, find};

/// Returns the message for a refused value, with the word that the variable takes in place of a number.
pub fn refusal(error: &VariableError) -> String {
    let word_of = |key| find(key).ok()?.number()?.absent;
    let with = |key, text: &str| {
        word_of(key).map_or_else(|| text.to_owned(), |word| format!("{text}, or `{word}`"))
    };
    match error {
        VariableError::Unreadable { key, .. } => with(key, &error.to_string()),
        VariableError::Impossible { symbol, key, value, meaning, allowed, cure } => {
            let (value, allowed, cure) = (value.clone(), with(key, allowed), cure.clone());
            VariableError::Impossible { symbol, key, value, meaning, allowed, cure }.to_string()
        }
        _ => error.to_string(),
    }
}

/// Why a study over variables is refused before anything runs, or has no answer.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum StudyError {
    /// The scene is refused.
    #[error(transparent)]
    Variable(#[from] VariableError),
    /// A quantity is refused.
    #[error(transparent)]
    Quantity(#[from] QuantityError),
    /// An axis is refused.
    #[error("axis {axis}: {problem}")]
    Axis {
        /// Axis as it was written.
        axis: String,
        /// Reason, with the remedy.
        problem: Box<AxisProblem>,
    },
    /// A scene that is to be swept has no axis.
    #[error("a sweep needs at least one axis, for example gamma=0.8..7:101")]
    NoAxis,
    /// No default axis has an effect on the scene.
    #[error(
        "no variable of Table 9.2 has an effect on this scene: name one, for example --over v_i=80..120"
    )]
    NoUsualAxis,
    /// More axes than a study can have.
    #[error("{count} axes are too many: a sweep has at most {most}; hold some of the variables")]
    TooManyAxes {
        /// Number of axes.
        count: usize,
        /// Maximum number of axes.
        most: usize,
    },
    /// More points than can be counted.
    #[error(
        "{points} points are too many: a sweep has at most {most}; take fewer points along the axes"
    )]
    TooManyPoints {
        /// Number of points.
        points: String,
        /// Maximum number of points.
        most: String,
    },
    /// More points than a grid in memory can have.
    #[error(
        "{points} points are too many for the screen, which keeps at most {most}: take fewer along the axes, or use `cmra sweep`"
    )]
    TooManyForScreen {
        /// Number of points.
        points: u64,
        /// Maximum number of points.
        most: u64,
    },
    /// The part of a sweep is not `I/N`.
    #[error(
        "shard {shard}: write I/N with 1 <= I <= N, for example 2/8 for the second of eight parts"
    )]
    Shard {
        /// Part as it was written.
        shard: String,
    },
    /// A corner of the axes makes no physical sense.
    #[error("the sweep reaches an impossible scene ({place}): {source}")]
    Corner {
        /// Values of the axes.
        place: String,
        /// Reason why the scene makes no sense.
        source: Box<VariableError>,
    },
    /// An axis and a value of the scene both give the plate's size.
    #[error(
        "{axis} varies, but the scene has {symbol} = {value}, and both give the plate's size: vary {symbol}, or set {axis} in \
         place of {symbol}"
    )]
    TwoSizes {
        /// Symbol of the axis.
        axis: &'static str,
        /// Symbol of the variable that the scene has.
        symbol: &'static str,
        /// Value of that variable, with its unit.
        value: String,
    },
    /// A map of the mass efficiency over the thickness, which it sizes itself.
    #[error(
        "the map does not depend on h: each point sizes h to just stop its shot; take another variable, or \
         `cmra sweep --over h --outputs limit_if_spring_survives_m_s`"
    )]
    MapOverThickness,
    /// A Monte Carlo study has no scattered input.
    #[error("nothing scatters: name an input, for example v_i=normal:2%")]
    NothingScatters,
    /// An input has two distributions.
    #[error("{symbol} scatters twice: give each input one distribution")]
    ScattersTwice {
        /// Symbol of the input.
        symbol: &'static str,
    },
    /// The number of samples is out of range.
    #[error("samples = {samples} is outside {least} to {most}: {usual} is usual")]
    Samples {
        /// Number of samples.
        samples: usize,
        /// Minimum number of samples.
        least: usize,
        /// Maximum number of samples.
        most: usize,
        /// Default number of samples.
        usual: usize,
    },
    /// Scattered values never make physical sense together.
    #[error("none of {draws} draws makes physical sense, the last because {last}")]
    NoDraw {
        /// Number of draws.
        draws: usize,
        /// Reason of the last draw.
        last: String,
    },
}

impl StudyError {
    /// Creates the error of an axis.
    pub(in crate::study) fn axis(axis: impl Into<String>, problem: AxisProblem) -> Self {
        Self::Axis { axis: axis.into(), problem: Box::new(problem) }
    }
}

/// Syntax of an axis.
const FORM: &str =
    "write NAME=LO..HI:COUNT[:log] or NAME=A,B,C, for example gamma=0.8..7:101 or k=1e4,1e5";

/// Why an axis is refused.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum AxisProblem {
    /// The text is neither a range nor a list.
    #[error("{FORM}")]
    NoAxis,
    /// A range has no number of points.
    #[error("COUNT is missing; {FORM}")]
    NoCount,
    /// The number of points is no number in the range.
    #[error("COUNT = `{count}` must be a whole number, {least} to {most}; {FORM}")]
    UnreadableCount {
        /// Text in place of the number.
        count: String,
        /// Minimum number of points.
        least: u64,
        /// Maximum number of points.
        most: u64,
    },
    /// A part after the ends is unknown.
    #[error("`{part}` is neither COUNT nor log; {FORM}")]
    UnknownPart {
        /// Part as it was written.
        part: String,
    },
    /// A value cannot be read.
    #[error("{place}: {source}")]
    Unreadable {
        /// Place of the value.
        place: &'static str,
        /// Reason, with the remedy.
        source: UnitError,
    },
    /// The units of the ends do not go together.
    #[error(transparent)]
    Unit(#[from] UnitError),
    /// Only some values of a list have a unit.
    #[error("give all values of the list a unit, or none")]
    UnitsInList,
    /// A list in a study of ranges.
    #[error("a list of values is for `cmra sweep`; write a range here, for example {cure}")]
    List {
        /// The range of the list.
        cure: String,
    },
    /// The name is not that of a variable.
    #[error(transparent)]
    Variable(#[from] VariableError),
    /// The variable has no numbers.
    #[error("it has no numbers to sweep over, only {choices}; sweep a numeric variable")]
    NoNumbers {
        /// Values of the variable.
        choices: String,
    },
    /// A value is physically impossible.
    #[error("the range reaches {value}, which is impossible: {meaning} must be {allowed}; {cure}")]
    Impossible {
        /// Value with its unit.
        value: String,
        /// Meaning of the variable.
        meaning: &'static str,
        /// Allowed values.
        allowed: String,
        /// Suggested end.
        cure: String,
    },
    /// A list has a value twice.
    #[error("{value} occurs twice in the list; omit one of them")]
    ListedTwice {
        /// The value.
        value: String,
    },
    /// The ends are equal.
    #[error(
        "both ends are {value}: the two ends must differ; widen the range, or hold {symbol} at one value"
    )]
    EqualEnds {
        /// Symbol of the variable.
        symbol: String,
        /// Value of both ends.
        value: String,
    },
    /// Equal ratios do not reach zero.
    #[error(
        "{from} to {to} at equal ratios: both ends must be greater than 0; omit log, or start above 0, for example at {cure}"
    )]
    RatiosFromZero {
        /// First end.
        from: String,
        /// Second end.
        to: String,
        /// Suggested first end.
        cure: String,
    },
    /// The number of points is out of range.
    #[error(
        "count = {count} is impossible: an axis has {least} to {most} points here; to hold {symbol}, set it to one value \
         ({symbol}={value})"
    )]
    Count {
        /// Number of points.
        count: usize,
        /// Minimum number of points.
        least: u64,
        /// Maximum number of points.
        most: u64,
        /// Symbol of the variable.
        symbol: String,
        /// A value to hold.
        value: String,
    },
    /// Another axis has the same variable.
    #[error("it is swept twice; give each variable one axis")]
    SweptTwice,
    /// Another range has the same variable.
    #[error("it is given twice; give each variable one range")]
    GivenTwice,
    /// Another axis sets the plate's size, too.
    #[error("{other} is an axis too, and both set the plate's size; omit one of them")]
    TwoSizes {
        /// Symbol of the other axis.
        other: &'static str,
    },
}

/// Why a quantity is refused.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum QuantityError {
    /// No quantity has this name.
    #[error("output {name}: not a result of a run: {cure}")]
    Unknown {
        /// Name as it was written.
        name: String,
        /// The nearest names.
        cure: String,
    },
    /// A stack does not have the quantity.
    #[error("{title}: a stack has none; take {instead}, for example")]
    NotOfStacks {
        /// Title of the quantity.
        title: String,
        /// Quantity that a stack has.
        instead: &'static str,
    },
}

/// Why the distribution of an input is refused.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum ToleranceError {
    /// The input is refused.
    #[error(transparent)]
    Axis(#[from] StudyError),
    /// The scene has no value for the centre.
    #[error("{symbol} is absent in the scene: write uniform:LO..HI")]
    Absent {
        /// Symbol of the input.
        symbol: &'static str,
    },
    /// The centre has no logarithm.
    #[error("{symbol} = {value}: a lognormal needs a value above 0; write normal or uniform")]
    NoLogarithm {
        /// Symbol of the input.
        symbol: &'static str,
        /// Value of the scene.
        value: String,
    },
    /// The ends of a uniform distribution are not `LO..HI`.
    #[error("write {symbol}=uniform:LO..HI")]
    NoEnds {
        /// Symbol of the input.
        symbol: &'static str,
    },
    /// An end cannot be read.
    #[error(transparent)]
    End(#[from] AxisProblem),
    /// The keyword is that of no distribution.
    #[error("`{word}` is not a distribution: write normal:2%, lognormal:5% or uniform:LO..HI")]
    Unknown {
        /// Keyword as it was written.
        word: String,
    },
    /// The width cannot be read.
    #[error(transparent)]
    Unreadable(#[from] UnitError),
    /// The width is not positive.
    #[error(
        "the width `{width}`{} must be greater than 0: write for example 2% or a value with a unit",
        if *is_of_zero { " (a percentage of 0)" } else { "" }
    )]
    Width {
        /// Width as it was written.
        width: String,
        /// Whether it is a percentage of 0.
        is_of_zero: bool,
    },
    /// The ends are equal or reversed.
    #[error("{low} to {high}: the first end must be the lower one")]
    Reversed {
        /// First end.
        low: String,
        /// Second end.
        high: String,
    },
    /// No value between the ends is allowed.
    #[error("{low} to {high} holds nothing that is allowed: {meaning} must be {allowed}")]
    Impossible {
        /// First end.
        low: String,
        /// Second end.
        high: String,
        /// Meaning of the variable.
        meaning: &'static str,
        /// Allowed values.
        allowed: String,
    },
}

/// Why a goal or a bound of a quantity is refused.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum TargetError {
    /// The text is no goal.
    #[error("write QUANTITY=VALUE, for example percent_of_baseline=60 or stroke_m=45mm")]
    NoGoal,
    /// The text is no bound.
    #[error("write QUANTITY<=VALUE or QUANTITY>=VALUE, for example 'stroke_m<=50mm'")]
    NoBound,
    /// The quantity is refused.
    #[error(transparent)]
    Quantity(#[from] QuantityError),
    /// The value cannot be read.
    #[error(transparent)]
    Unreadable(#[from] UnitError),
}
