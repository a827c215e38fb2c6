//! An axis as text: `NAME=LO..HI:COUNT[:log]` or `NAME=A,B,C`, with units or without.

use std::ops::RangeInclusive;

use crate::study::error::{AxisProblem, StudyError};
use crate::study::sweep::axis::{Axis, Spacing, numeric};
use cmra_engine::model::scene::SweepAxis;
use cmra_engine::model::units::{self, Bare, Dimension};

impl Axis {
    /// Parses `NAME=LO..HI:COUNT[:log]` or a list of values, `NAME=A,B,C`; COUNT is optional if there is a default.
    pub fn read(
        argument: &str,
        usual: Option<u64>,
        counts: &RangeInclusive<u64>,
    ) -> Result<Self, StudyError> {
        let form = || StudyError::axis(argument, AxisProblem::NoAxis);
        let (name, rest) = argument.split_once('=').ok_or_else(form)?;
        let name = name.trim();
        let (variable, _) = numeric(name)?;
        Self::read_values(name, rest, variable.bare(name), usual, counts)
    }

    /// Parses the values of the axis NAME, with a unit for bare numbers.
    fn read_values(
        name: &str,
        rest: &str,
        bare: Bare<'_>,
        usual: Option<u64>,
        counts: &RangeInclusive<u64>,
    ) -> Result<Self, StudyError> {
        let refuse = |problem: AxisProblem| StudyError::axis(format!("{name}={rest}"), problem);
        let (_, number) = numeric(name)?;
        let quantity = number.quantity;
        if let Some((low, rest)) = rest.split_once("..") {
            let (high, count, log) = high_end(rest, counts).map_err(refuse)?;
            let count = count.or(usual).ok_or_else(|| refuse(AxisProblem::NoCount))?;
            let (from, to) = ends(low, high, quantity, bare).map_err(refuse)?;
            let count = usize::try_from(count).unwrap_or(usize::MAX);
            let axis = SweepAxis { log, ..SweepAxis::linear(name, from, to, count) };
            return Self::from_sweep_axis(&axis, counts);
        }
        let parts: Vec<&str> = rest.split(',').map(str::trim).collect();
        let [first, others @ ..] = &parts[..] else {
            return Err(refuse(AxisProblem::NoAxis));
        };
        if others.is_empty() {
            return Err(refuse(AxisProblem::NoAxis));
        }
        let read = |text: &&str| value(text, "the list", quantity, bare).map_err(refuse);
        let values = parts.iter().map(read).collect::<Result<Vec<f64>, _>>()?;
        if others.iter().any(|it| units::one_bare_end(first, it, quantity).is_some()) {
            return Err(refuse(AxisProblem::UnitsInList));
        }
        Self::from_sweep_axis(&SweepAxis { values, ..SweepAxis::linear(name, 0.0, 0.0, 0) }, counts)
    }

    /// Parses a range; a list of values is an error.
    pub fn read_range(
        argument: &str,
        usual: Option<u64>,
        counts: &RangeInclusive<u64>,
    ) -> Result<Self, StudyError> {
        Self::read(argument, usual, counts)?.only_a_range(argument)
    }

    /// Parses `LO..HI[:COUNT][:log]` for the axis NAME; bare numbers have the unit of the form field.
    pub fn read_range_in(
        unit: &str,
        (name, text): (&str, &str),
        usual: Option<u64>,
        counts: &RangeInclusive<u64>,
    ) -> Result<Self, StudyError> {
        let axis = Self::read_values(name, text, Bare::In(unit), usual, counts)?;
        axis.only_a_range(&format!("{name}={text}"))
    }

    fn only_a_range(self, argument: &str) -> Result<Self, StudyError> {
        if self.spacing() != Spacing::Listed {
            return Ok(self);
        }
        let (low, high) = self.ends();
        let (low, high) = (units::shortest(low), units::shortest(high));
        let cure = format!("{}={low}..{high}", self.symbol());
        Err(StudyError::axis(argument, AxisProblem::List { cure }))
    }
}

/// Parses the text after `..`: upper end, number of points, and whether the ratios are equal.
fn high_end<'t>(
    text: &'t str,
    counts: &RangeInclusive<u64>,
) -> Result<(&'t str, Option<u64>, bool), AxisProblem> {
    let mut parts = text.split(':');
    let high = parts.next().unwrap_or_default();
    let (mut count, mut log) = (None, false);
    for part in parts {
        match part.trim() {
            "log" => log = true,
            "lin" | "linear" => log = false,
            text if count.is_none() => {
                let (least, most) = (*counts.start(), *counts.end());
                let wrong = || AxisProblem::UnreadableCount { count: text.to_owned(), least, most };
                count = Some(text.parse::<u64>().map_err(|_not_a_number| wrong())?);
            }
            text => return Err(AxisProblem::UnknownPart { part: text.to_owned() }),
        }
    }
    Ok((high, count, log))
}

/// Parses the ends of `LO..HI` into the stored unit; refused unless both have a unit or neither.
pub(in crate::study) fn ends(
    low: &str,
    high: &str,
    quantity: Dimension,
    bare: Bare<'_>,
) -> Result<(f64, f64), AxisProblem> {
    let ends = (value(low, "LO", quantity, bare)?, value(high, "HI", quantity, bare)?);
    let mixed = units::one_bare_end(low, high, quantity);
    mixed.map_or(Ok(ends), |problem| Err(problem.into()))
}

fn value(
    text: &str,
    place: &'static str,
    quantity: Dimension,
    bare: Bare<'_>,
) -> Result<f64, AxisProblem> {
    let unreadable = |source| AxisProblem::Unreadable { place, source };
    units::parse(text, quantity, bare).map_err(unreadable)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::sweep::COUNTS;

    #[test]
    fn axes_are_read_with_units_and_spacing() {
        let axis = Axis::read("k=0.1MN/m..7.5 MN/m:4:log", None, &COUNTS).unwrap();
        assert_eq!((axis.symbol(), axis.count(), axis.spacing()), ("k", 4, Spacing::Log));
        assert!((axis.ends().0 - 1e5).abs() < 1e-9 && (axis.ends().1 - 7.5e6).abs() < 1e-9);
        let axis = Axis::read("plate.cocking_m=0..50mm:11", None, &COUNTS).unwrap();
        assert_eq!((axis.symbol(), axis.ends().1.to_bits()), ("d", 0.05f64.to_bits()));
        let axis = Axis::read("theta=0..45deg:4", None, &COUNTS).unwrap();
        assert_eq!(axis.ends().1.to_bits(), 45f64.to_bits());
        // The full key ends in its unit.
        let axis = Axis::read("projectile.obliquity_deg=10..45:4", None, &COUNTS).unwrap();
        assert_eq!(axis.ends().0.to_bits(), 10f64.to_bits());
        assert_eq!(Axis::read("n=3..0.1:log", Some(2), &COUNTS).unwrap().spacing(), Spacing::Log);
    }

    #[test]
    fn lists_are_read_with_units_in_their_order() {
        let axis = Axis::read("k=1e5,0.01 MN/m,2.5e4", None, &COUNTS);
        assert!(axis.unwrap_err().to_string().contains("all values of the list a unit, or none"));
        let axis = Axis::read("k = 100kN/m,10 kN/m,1MN/m", None, &COUNTS).unwrap();
        assert_eq!(axis.list(), [1e5, 1e4, 1e6]);
        let axis = Axis::read("thickness=25.4mm,0,1in", None, &COUNTS).unwrap_err().to_string();
        assert!(axis.contains("reaches 0 m"), "{axis}");
        assert!(
            Axis::read_range("gamma=1,2", None, &COUNTS)
                .unwrap_err()
                .to_string()
                .contains("gamma=1..2")
        );
    }

    #[test]
    fn bad_axes_are_refused_with_the_form_to_write() {
        for (text, fragments) in [
            ("gamma", &["axis gamma", "NAME=LO..HI:COUNT"][..]),
            ("gamma=1:5", &["NAME=LO..HI:COUNT", "NAME=A,B,C"]),
            ("gamma=1,two", &["the list", "not a number"]),
            ("gamma=1,", &["the list"]),
            ("gamma=1..2", &["COUNT is missing"]),
            ("gamma=1..2:many", &["COUNT = `many`", "whole number"]),
            ("gamma=1..2:-3", &["COUNT = `-3`"]),
            ("gamma=1..2:3:4", &["`4` is neither"]),
            ("d=0..5kg:5", &["HI", "`kg` is not a unit", "mm"]),
            ("d=zero..5mm:5", &["LO", "not a number"]),
            ("h=1..2mm:3", &["`1` has no unit and `2mm` has one", "`1 mm..2mm` or `1 m..2mm`"]),
            ("h=1mm..2:3", &["`2` has no unit and `1mm` has one", "`1mm..2 mm` or `1mm..2 m`"]),
            ("v_i=100..3 kfps:3", &["`100 kfps..3 kfps` or `100 m/s..3 kfps`"]),
            ("theta=10..45:4", &["LO", "angle without a unit", "`10 deg` or `10 rad`"]),
            ("projectile.obliquity_deg=10..0.5rad:4", &["`10` has no unit"]),
        ] {
            let error = Axis::read(text, None, &COUNTS).unwrap_err().to_string();
            for fragment in fragments {
                assert!(error.contains(fragment), "{text}: {error} lacks {fragment}");
            }
        }
    }
}
