//! Scattered inputs: distribution and notation.

use std::fmt;

use super::{Axis, Number, Random, Scene, Spacing, StudyError, Variable};
use crate::study::error::ToleranceError;
use crate::study::sweep::axis::{ends, numeric};
use cmra_engine::model::units::{self, Bare, significant};

enumeration! {
    /// Distribution family of an input; determines the meaning of its two parameters.
    pub enum Kind in KindRow {
        /// Keyword on the command line and in files.
        word: &'static str,
    }
    /// Normal: mean, and standard deviation > 0.
    Normal { word: "normal" }
    /// Lognormal: median > 0, and standard deviation of the logarithm > 0.
    LogNormal { word: "lognormal" }
    /// Uniform between its ends, lower end first.
    Uniform { word: "uniform" }
}

/// Distribution of an input: the family and its two parameters, in the stored unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Distribution(pub Kind, pub (f64, f64));

impl Distribution {
    pub(super) fn draw(self, random: &mut Random) -> f64 {
        let Self(kind, (a, b)) = self;
        match kind {
            Kind::Normal => a + b * random.normal(),
            Kind::LogNormal => a * (b * random.normal()).exp(),
            Kind::Uniform => a + (b - a) * random.unit(),
        }
    }
}

/// Scattered input with its distribution.
#[derive(Clone, Copy)]
pub struct Tolerance {
    /// Scattered variable.
    pub variable: &'static Variable,
    pub(in crate::study) number: &'static Number,
    /// Distribution of the variable.
    pub distribution: Distribution,
}

impl fmt::Debug for Tolerance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {:?}", self.symbol(), self.distribution)
    }
}

/// Writes the notation of `--vary`, with numbers in the stored unit: `v_i=lognormal:2%`, `h=uniform:0.024m..0.027m`.
impl fmt::Display for Tolerance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // A shell would take blanks and brackets as its own; the number is then in the stored unit.
        let unit = self.variable.unit();
        let unit = if unit.contains([' ', '(']) { "" } else { unit };
        let show = |value: f64| significant(value, 12) + unit;
        let Distribution(kind, (a, b)) = self.distribution;
        write!(f, "{}={}:", self.symbol(), kind.word())?;
        match kind {
            Kind::Normal => f.write_str(&show(b)),
            Kind::LogNormal => write!(f, "{}%", significant(100.0 * b, 12)),
            Kind::Uniform => write!(f, "{}..{}", show(a), show(b)),
        }
    }
}

impl PartialEq for Tolerance {
    fn eq(&self, other: &Self) -> bool {
        self.symbol() == other.symbol() && self.distribution == other.distribution
    }
}

impl Tolerance {
    /// Creates a tolerance of the named input.
    pub fn new(name: &str, distribution: Distribution) -> Result<Self, StudyError> {
        let (variable, number) = numeric(name)?;
        Ok(Self { variable, number, distribution })
    }

    /// Parses `normal:2%`, `normal:0.5mm` and `lognormal:5%`, centred on the scene's own value, or `uniform:24mm..27mm`.
    pub fn parse(name: &str, text: &str, scene: &Scene) -> Result<Self, ToleranceError> {
        let (variable, number) = numeric(name)?;
        let symbol = variable.symbol;
        let own = || (number.get)(scene).ok_or(ToleranceError::Absent { symbol });
        let (kind, rest) = text.split_once(':').unwrap_or(("normal", text));
        let distribution = match kind.trim() {
            "normal" => {
                let mean = own()?;
                Distribution(Kind::Normal, (mean, width(rest, number, mean)?))
            }
            "lognormal" => {
                let median = own()?;
                if median <= 0.0 {
                    let value = units::shortest(median);
                    return Err(ToleranceError::NoLogarithm { symbol, value });
                }
                Distribution(Kind::LogNormal, (median, width(rest, number, median)? / median))
            }
            "uniform" => {
                let (low, high) = rest.split_once("..").ok_or(ToleranceError::NoEnds { symbol })?;
                let ends = ends(low, high, number.quantity, Bare::Si)?;
                check_ends(ends, variable, number)?;
                Distribution(Kind::Uniform, ends)
            }
            word => return Err(ToleranceError::Unknown { word: word.to_owned() }),
        };
        Ok(Self { variable, number, distribution })
    }

    /// Returns the symbol of the variable.
    pub fn symbol(&self) -> &'static str {
        self.variable.symbol
    }

    /// Returns an axis for the evaluation only. Its ends are the scene's own value and the nearest allowed one; the samples are listed and
    /// checked individually.
    pub(super) fn axis(&self, scene: &Scene) -> Result<Axis, StudyError> {
        let Distribution(_, (first, second)) = self.distribution;
        let own = (self.number.get)(scene).unwrap_or(0.5 * (first + second));
        let beside = [own.next_up(), own.next_down()];
        let other = beside.into_iter().find(|value| self.number.allowed.contains(*value));
        Axis::new(self.symbol(), (own, other.unwrap_or(own)), 2, Spacing::Linear)
    }
}

/// Parses a deviation: a fraction of the scene's own value, or a value with a unit.
fn width(text: &str, number: &Number, nominal: f64) -> Result<f64, ToleranceError> {
    let text = text.trim();
    let (value, quantity, whole) = match text.strip_suffix('%') {
        Some(percent) => (percent, units::Dimension::Number, nominal.abs() / 100.0),
        None => (text, number.quantity, 1.0),
    };
    let parsed = units::parse(value, quantity, Bare::Si)?;
    let width = parsed * whole;
    if width > 0.0 {
        return Ok(width);
    }
    let is_of_zero = text.ends_with('%') && nominal == 0.0;
    Err(ToleranceError::Width { width: text.to_owned(), is_of_zero })
}

fn check_ends(
    (low, high): (f64, f64),
    variable: &Variable,
    number: &Number,
) -> Result<(), ToleranceError> {
    let is_reversed = low >= high;
    let mut within = [low, high, 0.5 * (low + high)].into_iter();
    let is_possible = within.any(|value| number.allowed.contains(value));
    let [low, high] = [low, high].map(units::shortest);
    if is_reversed {
        return Err(ToleranceError::Reversed { low, high });
    }
    if is_possible {
        return Ok(());
    }
    let (meaning, allowed) = (variable.meaning, number.allowed.describe(number.quantity));
    Err(ToleranceError::Impossible { low, high, meaning, allowed })
}
