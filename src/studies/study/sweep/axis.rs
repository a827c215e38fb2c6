//! Axis of a sweep: a variable with its range and its points.
//!
//! All values of an `Axis` are valid: its ends are checked, and the valid values of a variable form an interval. `Plan` checks the rules
//! between variables.

use std::fmt;
use std::ops::{Range, RangeInclusive};

use crate::study::error::{AxisProblem, StudyError};
use cmra_engine::model::scene::{Scene, Sweep, SweepAxis};
use cmra_engine::model::units;
use cmra_engine::model::variables::{self, Allowed, Number, Variable};
use cmra_engine::numerics::larger;

mod text;

pub(in crate::study) use text::ends;

/// Allowed number of points of an axis of a streamed sweep; grids in memory and searches have smaller limits.
pub const COUNTS: RangeInclusive<u64> = 2..=1_000_000_000;

/// Spacing of the points of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spacing {
    /// Equal differences.
    Linear,
    /// Equal ratios.
    Log,
    /// Values of a list.
    Listed,
}

/// Validated axis.
#[derive(Clone)]
pub struct Axis {
    variable: &'static Variable,
    number: &'static Number,
    /// Range as in a scene file; the ends of a list are its smallest and largest value.
    range: SweepAxis,
}

impl fmt::Debug for Axis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}={}", self.variable.symbol, self.range())
    }
}

/// Formats the axis in the syntax of `--over`; angles by their full key, whose unit is that of the values.
impl fmt::Display for Axis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let variable = self.variable;
        let name = if variable.unit() == "deg" { variable.key } else { variable.symbol };
        write!(f, "{name}={}", self.range())
    }
}

impl PartialEq for Axis {
    fn eq(&self, other: &Self) -> bool {
        self.range == other.range
    }
}

impl Axis {
    /// Creates an axis over the variable `name`, in its stored unit; the ends may be in either order.
    pub fn new(
        name: &str,
        (from, to): (f64, f64),
        count: u64,
        spacing: Spacing,
    ) -> Result<Self, StudyError> {
        let count = usize::try_from(count).unwrap_or(usize::MAX);
        let log = spacing == Spacing::Log;
        Self::from_sweep_axis(
            &SweepAxis { log, ..SweepAxis::linear(name, from, to, count) },
            &COUNTS,
        )
    }

    /// Creates an axis from a scene file; its number of points has to be within `counts`.
    pub fn from_sweep_axis(
        asked: &SweepAxis,
        counts: &RangeInclusive<u64>,
    ) -> Result<Self, StudyError> {
        let (variable, number) = numeric(&asked.name)?;
        let mut range = SweepAxis { name: variable.symbol.to_owned(), ..asked.clone() };
        if !range.values.is_empty() {
            range.from = range.values.iter().copied().fold(f64::INFINITY, f64::min);
            range.to = range.values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            (range.count, range.log) = (range.values.len(), false);
        }
        let ends = [range.from, range.to];
        let values = if range.values.is_empty() { &ends } else { range.values.as_slice() };
        if let Some(end) = values.iter().find(|value| !number.allowed.contains(**value)) {
            return Err(StudyError::axis(variable.symbol, impossible(variable, number, *end)));
        }
        check_distinct(&range)
            .and_then(|()| check_count(&range, counts))
            .map_err(|problem| StudyError::axis(variable.symbol, problem))?;
        Ok(Self { variable, number, range })
    }

    /// Creates the axes of a sweep in a scene file.
    pub fn all_of(sweep: &Sweep) -> Result<Vec<Self>, StudyError> {
        sweep.axes.iter().map(|axis| Self::from_sweep_axis(axis, &COUNTS)).collect()
    }

    /// Returns the value of the variable in a scene; `None` if it is absent.
    pub fn get(&self, scene: &Scene) -> Option<f64> {
        (self.number.get)(scene)
    }

    /// The value that a scene has, also where another variable gives the plate its size.
    pub fn own_value(&self, scene: &Scene) -> Option<f64> {
        self.get(scene).or_else(|| match self.variable().key {
            "plate.mass_kg" => Some(scene.plate_mass_kg()),
            "plate.face_m" => Some(scene.plate_face_m()),
            _ => None,
        })
    }

    /// Gives a scene this value of the variable; NaN stands for a variable that is absent, such as a stop.
    pub fn set(&self, scene: &mut Scene, value: f64) {
        (self.number.set)(scene, (!value.is_nan()).then_some(value));
    }

    /// Returns the variable.
    pub fn variable(&self) -> &'static Variable {
        self.variable
    }

    /// Returns the symbol of the variable, the name of the axis in tables.
    pub fn symbol(&self) -> &'static str {
        self.variable.symbol
    }

    /// Formats a value in the unit that pages show: `240 mm`, `1500 kN/m^n`.
    pub fn display(&self, value: f64, digits: usize) -> String {
        let unit = self.number.quantity.shown_unit();
        let shown = units::in_unit(value, unit, self.number.quantity);
        shown.map_or_else(
            || self.show(value, digits),
            |shown| format!("{} {unit}", units::significant(shown, digits)).trim_end().to_owned(),
        )
    }

    /// Formats a value with its unit: `0.24 m`, `1.5e6 N/m^n`.
    pub fn show(&self, value: f64, digits: usize) -> String {
        let unit = self.variable.unit();
        format!("{} {unit}", units::significant(value, digits)).trim_end().to_owned()
    }

    /// Writes a value as `--set` takes it: `k=1e5`, `theta=18deg`.
    pub fn assignment(&self, value: f64) -> String {
        // An angle without a unit is refused.
        let unit = if self.variable.unit() == "deg" { "deg" } else { "" };
        format!("{}={}{unit}", self.symbol(), units::shortest(value))
    }

    /// Converts the axis to its form in a scene file.
    pub fn to_sweep_axis(&self) -> SweepAxis {
        self.range.clone()
    }

    /// Formats the values in the syntax of `--over`: `LO..HI:COUNT[:log]`, or a list.
    pub fn range(&self) -> String {
        let shown = units::shortest;
        if self.spacing() == Spacing::Listed {
            let values: Vec<String> = self.list().iter().map(|value| shown(*value)).collect();
            return values.join(",");
        }
        let SweepAxis { from, to, count, log, .. } = self.range;
        format!("{}..{}:{count}{}", shown(from), shown(to), if log { ":log" } else { "" })
    }

    /// Returns the values of a list in their order; empty for a range.
    pub fn list(&self) -> &[f64] {
        &self.range.values
    }

    /// Returns first and last value of a range, smallest and largest value of a list, in the stored unit.
    pub fn ends(&self) -> (f64, f64) {
        (self.range.from, self.range.to)
    }

    /// Returns the number of points.
    pub fn count(&self) -> u64 {
        self.range.count as u64
    }

    /// Returns the spacing of the points.
    pub fn spacing(&self) -> Spacing {
        match self.range.log {
            _ if !self.list().is_empty() => Spacing::Listed,
            true => Spacing::Log,
            false => Spacing::Linear,
        }
    }

    /// Returns the value of point `index`, counted from 0. The ends are exact, and a reversed axis has the same values in reverse order.
    pub fn value(&self, index: u64) -> f64 {
        let last = self.count() - 1;
        if self.spacing() == Spacing::Listed {
            return self.list()[usize::try_from(index.min(last)).unwrap_or(usize::MAX)];
        }
        match index {
            0 => self.range.from,
            _ if index >= last => self.range.to,
            _ => self.between(index as f64, (last - index) as f64),
        }
    }

    /// Returns the values of all points.
    pub fn values(&self) -> Vec<f64> {
        (0..self.count()).map(|index| self.value(index)).collect()
    }

    /// Returns the point with the closest value, on the scale of the spacing.
    pub fn nearest(&self, value: f64) -> u64 {
        let gap = |index: &u64| (self.place(self.value(*index)) - self.place(value)).abs();
        let near = |points: Range<u64>| points.min_by(|a, b| gap(a).total_cmp(&gap(b)));
        if self.spacing() == Spacing::Listed {
            return near(0..self.count()).unwrap_or(0);
        }
        let rising = self.range.from < self.range.to;
        // Bisection to the two neighbours of the value.
        let (mut low, mut high) = (0, self.count() - 1);
        while high - low > 1 {
            let middle = low + (high - low) / 2;
            if (self.value(middle) < value) == rising { low = middle } else { high = middle }
        }
        near(low..high + 1).unwrap_or(low)
    }

    /// Returns the value at a fraction of the range, 0 to 1.
    pub fn at_fraction(&self, fraction: f64) -> f64 {
        if self.spacing() == Spacing::Listed {
            // Each value of a list has an equal part of the range.
            let (count, list) = (self.count() as f64, self.list());
            let at = (1..list.len()).find(|at| fraction * count < *at as f64);
            return list[at.unwrap_or(list.len()) - 1];
        }
        self.between(fraction, 1.0 - fraction)
    }

    /// Returns the fraction of the range at a value; `None` outside the range.
    pub fn fraction(&self, value: f64) -> Option<f64> {
        let (from, to) = (self.place(self.range.from), self.place(self.range.to));
        let fraction = (self.place(value) - from) / (to - from);
        (0.0..=1.0).contains(&fraction).then_some(fraction)
    }

    /// Returns a value on the scale of the spacing.
    fn place(&self, value: f64) -> f64 {
        if self.range.log { value.log10() } else { value }
    }

    /// Returns the weighted mean of the ends. It multiplies before it divides: round numbers stay round.
    fn between(&self, gone: f64, left: f64) -> f64 {
        let (from, to) = self.ends();
        let mean = (self.place(from) * left + self.place(to) * gone) / (gone + left);
        let value = if self.range.log { nearest_short(10f64.powf(mean)) } else { mean };
        let (low, high) = if from < to { (from, to) } else { (to, from) };
        // Rounding errors, or an overflow of the products, could leave the range.
        if value.is_finite() { value.clamp(low, high) } else { low + 0.5 * (high - low) }
    }
}

/// Returns a scene with a value for each axis, in their stored units; NaN makes a variable absent.
pub fn scene_with(scene: &Scene, axes: &[Axis], values: &[f64]) -> Scene {
    let mut own = scene.clone();
    for (axis, value) in axes.iter().zip(values) {
        axis.set(&mut own, *value);
    }
    own
}

/// Checks that the values of an axis are distinct, and positive if they have equal ratios.
fn check_distinct(range: &SweepAxis) -> Result<(), AxisProblem> {
    let (symbol, shown) = (&range.name, units::shortest);
    let values = &range.values;
    if !values.is_empty() {
        let twice = |at: &usize| values[..*at].iter().any(|it| shown(*it) == shown(values[*at]));
        return (0..values.len())
            .find(twice)
            .map_or(Ok(()), |at| Err(AxisProblem::ListedTwice { value: shown(values[at]) }));
    }
    let [from, to] = [range.from, range.to].map(shown);
    if from == to {
        return Err(AxisProblem::EqualEnds { symbol: symbol.clone(), value: from });
    }
    if range.log && (range.from <= 0.0 || range.to <= 0.0) {
        let high = larger(range.from, range.to);
        let cure = units::significant(if high > 0.0 { 1e-3 * high } else { 1.0 }, 2);
        return Err(AxisProblem::RatiosFromZero { from, to, cure });
    }
    Ok(())
}

/// Checks the number of points of an axis.
fn check_count(range: &SweepAxis, counts: &RangeInclusive<u64>) -> Result<(), AxisProblem> {
    let SweepAxis { name, from, count, values, .. } = range;
    if counts.contains(&(*count as u64)) {
        return Ok(());
    }
    let value = units::shortest(values.first().copied().unwrap_or(*from));
    let (least, most) = (*counts.start(), *counts.end());
    Err(AxisProblem::Count { count: *count, least, most, symbol: name.clone(), value })
}

pub(in crate::study) fn numeric(
    name: &str,
) -> Result<(&'static Variable, &'static Number), StudyError> {
    let unknown = |source| StudyError::axis(name, AxisProblem::Variable(source));
    let variable = variables::find(name).map_err(unknown)?;
    let number = variable.number().ok_or_else(|| {
        let choices = variable.allowed();
        StudyError::axis(variable.symbol, AxisProblem::NoNumbers { choices })
    })?;
    Ok((variable, number))
}

/// Rounds to 15 digits, so that powers of ten are exact.
fn nearest_short(value: f64) -> f64 {
    let short: f64 = format!("{value:.14e}").parse().unwrap_or(value);
    if (short - value).abs() <= 1e-14 * value { short } else { value }
}

fn impossible(variable: &'static Variable, number: &Number, end: f64) -> AxisProblem {
    let unit = number.quantity.unit();
    let limit = match number.allowed {
        Allowed::Positive => Some("a value above 0".to_owned()),
        Allowed::From(least) => Some(units::shortest(least)),
        Allowed::NonNegative => Some("0".to_owned()),
        Allowed::Any | Allowed::Closing => None,
        Allowed::Between(low, high) => Some(units::shortest(if end < low { low } else { high })),
        Allowed::Below(low, _) if end < low => Some(units::shortest(low)),
        Allowed::Below(_, high) => Some(format!("a value below {}", units::shortest(high))),
    };
    // The message repeats the argument, which can be NaN or infinite.
    let value = if end.is_finite() { units::shortest(end) } else { end.to_string() };
    let cure = limit.map_or_else(
        || "write a finite number".to_owned(),
        |limit| format!("let the range end at {limit}"),
    );
    let value = format!("{value} {unit}").trim_end().to_owned();
    let allowed = number.allowed.describe(number.quantity);
    AxisProblem::Impossible { value, meaning: variable.meaning, allowed, cure }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axis(from: f64, to: f64, count: u64, spacing: Spacing) -> Axis {
        Axis::new("k", (from, to), count, spacing).unwrap()
    }

    #[test]
    fn values_are_round_where_they_can_be_and_end_on_the_ends() {
        let axis = Axis::new("gamma", (0.8, 7.0), 101, Spacing::Linear).unwrap();
        let values: Vec<f64> = (0..101).map(|index| axis.value(index)).collect();
        let picked = [values[0], values[50], values[100]].map(f64::to_bits);
        assert_eq!(picked, [0.8f64, 3.9, 7.0].map(f64::to_bits));
        assert!(values.windows(2).all(|pair| pair[0] < pair[1]));
        let decades: Vec<f64> =
            (0..5).map(|index| self::axis(1e2, 1e6, 5, Spacing::Log).value(index)).collect();
        assert_eq!(decades, [1e2, 1e3, 1e4, 1e5, 1e6]);
    }

    #[test]
    fn a_share_and_its_value_belong_together() {
        for spacing in [Spacing::Linear, Spacing::Log] {
            for axis in [axis(1.0, 1e4, 41, spacing), axis(1e4, 1.0, 41, spacing)] {
                for fraction in [0.0, 0.125, 0.7, 1.0] {
                    let back = axis.fraction(axis.at_fraction(fraction)).unwrap();
                    assert!((back - fraction).abs() < 1e-13, "{fraction} {back}");
                }
                assert!(axis.fraction(0.5).is_none() && axis.fraction(2e4).is_none());
            }
        }
    }

    #[test]
    fn the_nearest_point_is_found_in_either_direction() {
        for spacing in [Spacing::Linear, Spacing::Log] {
            for axis in [axis(1.0, 1e4, 41, spacing), axis(1e4, 1.0, 41, spacing)] {
                for index in 0..41 {
                    assert_eq!(axis.nearest(axis.value(index)), index);
                    assert_eq!(axis.nearest(axis.value(index) * 1.000_01), index);
                }
                let (first, last) = (axis.nearest(-5.0), axis.nearest(1e9));
                let rising = axis.ends().0 < axis.ends().1;
                assert_eq!(last, if rising { 40 } else { 0 });
                assert!(spacing == Spacing::Log || first == 40 - last);
            }
        }
    }
}
