//! The numbers of an axis: round values, and the unit in which they are short.

use crate::model::units;
use crate::report::chart::{Axis, Scale};

/// How numbers of an axis are shown: times a factor, in a unit.
pub(super) struct Shown {
    pub(super) factor: f64,
    pub(super) unit: String,
}

pub(super) fn shown(axis: &Axis) -> Shown {
    let (factor, unit) = prefixed(axis.size, &axis.unit);
    Shown { factor, unit }
}

/// The factor and the unit in which numbers of this size are short; units that take no prefix are left alone.
pub(super) fn prefixed(size: f64, unit: &str) -> (f64, String) {
    let plain = unit.chars().next().is_some_and(char::is_alphabetic);
    if !plain || matches!(unit, "kg" | "kg/m2" | "deg" | "rad") {
        return (1.0, unit.to_owned());
    }
    let (power, prefix) = units::prefix_of(size);
    // Powers of ten below one are not exact; their reciprocals are.
    let factor = if power < 1.0 { (1.0 / power).round() } else { 1.0 / power };
    (factor, format!("{}{unit}", if prefix == "u" { "µ" } else { prefix }))
}

/// The values at which an axis has numbers, and the numbers.
pub(super) fn ticks(axis: &Axis, shown: &Shown, most: usize) -> Vec<(f64, String)> {
    let (low, high) = (axis.low * shown.factor, axis.high * shown.factor);
    let values = match axis.scale {
        Scale::Linear => even(low, high, most),
        Scale::Log10 => decades(low, high, most),
    };
    let label = |value: f64| units::significant(value, 6);
    values.into_iter().map(|value| (value / shown.factor, label(value))).collect()
}

/// Round values at equal differences.
pub(super) fn even(low: f64, high: f64, most: usize) -> Vec<f64> {
    let least = (high - low) / most as f64;
    let decade = 10_f64.powf(least.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].map(|size| size * decade);
    let step = step.into_iter().find(|step| *step >= least).unwrap_or(10.0 * decade);
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
        ticks(axis, &shown(axis), 8).into_iter().map(|(_, label)| label).collect()
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
