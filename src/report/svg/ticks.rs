//! The numbers of an axis: round values in the unit in which they are short.

use crate::model::units;
use crate::report::chart::{Axis, Scale};
use crate::report::steps::Step;
use crate::report::unit::Unit;

/// The unit in which the numbers of an axis are short.
pub(super) fn unit_of(axis: &Axis) -> Unit<'_> {
    Unit::with_prefix(axis.size, &axis.unit)
}

/// The values at which an axis has numbers, and the numbers.
pub(super) fn ticks(axis: &Axis, unit: &Unit<'_>, most: usize) -> Vec<(f64, String)> {
    let (low, high) = (axis.low * unit.factor, axis.high * unit.factor);
    let values = match axis.scale {
        Scale::Linear => even(low, high, most),
        Scale::Log10 => decades(low, high, most),
    };
    let label = |value: f64| units::significant(value, 6);
    values.into_iter().map(|value| (value / unit.factor, label(value))).collect()
}

/// Round values at equal differences.
pub(super) fn even(low: f64, high: f64, most: usize) -> Vec<f64> {
    // A hair less than the room for a step: rounding must not make it the next longer one.
    let step = Step::at_least((high - low) / most as f64 * (1.0 - 1e-12)).size();
    let first = (low / step - 1e-9).ceil();
    (0..=most)
        .map(|number| (first + number as f64) * step)
        .take_while(|value| *value <= high + 1e-9 * step)
        // Rounding of the products, and a zero with a sign.
        .map(|value| if value.abs() < 1e-9 * step { 0.0 } else { value })
        .collect()
}

/// Decades, with 2 and 5 between them where there are few, or round values where there is less than one.
fn decades(low: f64, high: f64, most: usize) -> Vec<f64> {
    let within = |value: &f64| *value >= low * (1.0 - 1e-9) && *value <= high * (1.0 + 1e-9);
    let powers = || {
        let (first, span) = (low.log10().floor(), (high / low).log10().ceil() + 1.0);
        (0..=400).map(f64::from).take_while(move |number| *number <= span).map(move |n| first + n)
    };
    let whole: Vec<f64> = powers().map(|power| 10_f64.powf(power)).filter(within).collect();
    if whole.len() > most {
        let every = whole.len().div_ceil(most);
        return whole.into_iter().step_by(every).collect();
    }
    let finer = |parts: &[f64]| -> Vec<f64> {
        let values = powers().flat_map(|power| parts.iter().map(move |it| it * 10_f64.powf(power)));
        values.filter(within).collect()
    };
    let fine = finer(&[1.0, 2.0, 5.0]);
    match (whole.len(), fine.len()) {
        (_, 3..) if fine.len() <= most => fine,
        (2.., _) => whole,
        _ => even(low, high, most),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axis(low: f64, high: f64, scale: Scale) -> Axis {
        Axis::over("x", "m", scale, [low, high]).unwrap()
    }

    fn labels(axis: &Axis) -> Vec<String> {
        ticks(axis, &unit_of(axis), 8).into_iter().map(|(_, label)| label).collect()
    }

    #[test]
    fn ticks_are_round_numbers_within_the_axis() {
        assert_eq!(
            labels(&axis(0.0, 0.007, Scale::Linear)),
            ["0", "1", "2", "3", "4", "5", "6", "7"]
        );
        assert_eq!(labels(&axis(-0.5, 1.2, Scale::Linear)), ["-0.5", "0", "0.5", "1"]);
        assert_eq!(labels(&axis(1e-3, 1e3, Scale::Log10)).len(), 7);
        assert_eq!(labels(&axis(2.0, 60.0, Scale::Log10)), ["2", "5", "10", "20", "50"]);
        assert_eq!(
            labels(&axis(2.1, 2.4, Scale::Log10)),
            ["2.1", "2.15", "2.2", "2.25", "2.3", "2.35", "2.4"]
        );
    }
}
