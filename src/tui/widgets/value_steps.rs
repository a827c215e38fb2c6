//! Steps of a number by arrow keys: by the last displayed digit, or by a factor of 10^0.1, within the allowed values.

use cmra_engine::model::scene::Scene;
use cmra_engine::model::units::{self, Dimension, significant};
use cmra_engine::model::variables::{Allowed, Number, Variable};

/// Formats a number with at most `width` characters.
pub(crate) fn shown_number(number: f64, width: usize) -> String {
    (1..=6)
        .rev()
        .map(|digits| significant(number, digits))
        .find(|text| text.len() <= width)
        .unwrap_or_else(|| format!("{number:.0e}"))
}

/// Formats a value with prefix and unit, four digits: `19.26 kN`; a pure number has no prefix.
pub(crate) fn engineering(value: f64, unit: &'static str) -> String {
    if unit.is_empty() { significant(value, 4) } else { units::engineering(value, unit, 4) }
}

/// Input that changes the value of a row.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Input<'a> {
    /// Arrow keys.
    Step(StepKey),
    /// Text typed into the field.
    Text(&'a str),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct StepKey {
    /// Whether the step is upward.
    pub up: bool,
    /// Whether to take ten steps at once.
    pub is_far: bool,
}

impl StepKey {
    pub(crate) const NEXT: Self = Self { up: true, is_far: false };

    /// Returns the number of choices by which the step moves.
    pub(crate) fn by(self) -> isize {
        if self.up { 1 } else { -1 }
    }
}

/// Returns the decade of a linear step from this value: the last displayed digit; finer if that is a fifth of the value or more.
pub(crate) fn decade(variable: &Variable, value: f64) -> i32 {
    if value == 0.0 {
        return decade_at_zero(variable);
    }
    let text = shown_number(value.abs(), 8);
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text.as_str(), "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let places = mantissa.split_once('.').map_or(0, |(_, tail)| tail.len());
    let last = exponent - i32::try_from(places).unwrap_or(0);
    if 10f64.powi(last) >= 0.2 * value.abs() { last - 1 } else { last }
}

fn decade_at_zero(variable: &Variable) -> i32 {
    if let Some((_, high)) = variable.thesis_range {
        return format!("{}", (0.02 * high).log10().floor()).parse().unwrap_or(0);
    }
    match variable.number().map(|number| number.quantity) {
        Some(Dimension::Angle | Dimension::Velocity | Dimension::Density) => 0,
        Some(Dimension::Length | Dimension::Mass | Dimension::Time) => -3,
        Some(Dimension::Pressure) => 6,
        _ => -1,
    }
}

/// Returns the value after one step; `None` if it would make no physical sense.
///
/// `plain` is the decade of a linear step ([`decade`]). Equal steps up and down return to the same value.
pub(crate) fn stepped(variable: &Variable, value: f64, press: StepKey, plain: i32) -> Option<f64> {
    let number = variable.number()?;
    let next = if variable.is_log {
        logarithmic(variable, value, press)
    } else {
        linear(value, press.up, plain + i32::from(press.is_far))
    };
    let next = clamp(number, value, next);
    (number.allowed.contains(next) && next.to_bits() != value.to_bits()).then_some(next)
}

/// Returns the initial value of a missing number; for the plate's size its present value in three digits.
pub(crate) fn first_value(variable: &Variable, number: &Number, scene: &Scene) -> f64 {
    let now = match variable.key {
        "plate.mass_kg" => scene.plate_mass_kg(),
        "plate.face_m" => scene.plate_face_m(),
        _ if matches!(number.quantity, Dimension::Length | Dimension::Time) => return 0.01,
        _ => return 1.0,
    };
    significant(now, 3).parse().unwrap_or(now)
}

fn linear(value: f64, up: bool, decade: i32) -> f64 {
    let step = 10f64.powi(decade);
    let raw = if up { value + step } else { value - step };
    if decade >= 0 {
        return (raw / step).round() * step;
    }
    // Round as text, so that 0.3 + 0.1 is 0.4 and not 0.4000000000000001.
    let places = usize::try_from(-decade).unwrap_or(0) + 1;
    let rounded: f64 = format!("{raw:.places$}").parse().unwrap_or(raw);
    if rounded == 0.0 { 0.0 } else { rounded }
}

fn logarithmic(variable: &Variable, value: f64, StepKey { up, is_far }: StepKey) -> f64 {
    let high = variable.thesis_range.map_or(1e6, |(_, high)| high);
    // First value above zero.
    let smallest = 10f64.powf((high * 1e-3).log10().floor());
    if value == 0.0 {
        return if up { smallest } else { 0.0 };
    }
    let may_be_zero = variable.number().is_some_and(|number| number.allowed.contains(0.0));
    if !up && value <= smallest * 1.001 && may_be_zero {
        return 0.0;
    }
    let size = if is_far { 10.0 } else { 1.0 };
    let tenths = if up { size } else { -size };
    let exponent = value.log10() * 10.0 + tenths;
    // Snap to tenths of a decade, so that up and down return to the same value.
    let snapped = exponent.round();
    let exponent = if (exponent - snapped).abs() < 0.05 { snapped } else { exponent };
    let exact = 10f64.powf(exponent / 10.0);
    format!("{exact:.2e}").parse().unwrap_or(exact)
}

/// Limits a step across the end of a closed range to the end.
fn clamp(number: &Number, value: f64, next: f64) -> f64 {
    match number.allowed {
        Allowed::Between(low, high) => next.clamp(low, high),
        Allowed::Below(low, _) if next < low => low,
        Allowed::NonNegative if next < 0.0 && value > 0.0 => 0.0,
        _ => next,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cmra_engine::model::variables::find;

    const BACK: StepKey = StepKey { up: false, is_far: false };

    fn up(symbol: &str, value: f64, is_far: bool) -> Option<f64> {
        let variable = find(symbol).unwrap();
        stepped(variable, value, StepKey { up: true, is_far }, decade(variable, value))
    }

    #[test]
    fn linear_steps_follow_the_last_figure_shown() {
        assert_eq!(up("m_p", 0.0295, false), Some(0.0296));
        assert_eq!(up("v_i", 100.0, false), Some(101.0));
        assert_eq!(up("v_i", 100.0, true), Some(110.0));
        assert_eq!(up("S_y", 1.52e8, false), Some(1.53e8));
        assert_eq!(up("gamma", 1.0, false), Some(1.1));
        assert_eq!(up("theta", 0.0, false), Some(1.0));
        assert_eq!(up("d", 0.0, false), Some(0.01));
    }

    #[test]
    fn logarithmic_steps_keep_to_tenths_of_a_decade() {
        let k = find("k").unwrap();
        let mut value = 1e5;
        for expected in [1.26e5, 1.58e5, 2e5, 2.51e5, 3.16e5] {
            value = stepped(k, value, StepKey::NEXT, 0).unwrap();
            assert_eq!(value.to_bits(), f64::to_bits(expected));
        }
        assert_eq!(stepped(k, 0.0, StepKey::NEXT, 0), Some(1e3));
        assert_eq!(stepped(k, 1e3, BACK, 0), Some(0.0));
        assert_eq!(stepped(k, 0.0, BACK, 0), None);
    }

    #[test]
    fn no_step_leads_to_an_impossible_value() {
        let theta = find("theta").unwrap();
        assert_eq!(stepped(theta, 89.5, StepKey::NEXT, 0), None);
        assert_eq!(stepped(theta, 0.5, BACK, 0), Some(0.0));
        let gamma = find("gamma").unwrap();
        assert_eq!(stepped(gamma, 0.1, BACK, -1), None);
        let restitution = find("e").unwrap();
        assert_eq!(stepped(restitution, 0.95, StepKey::NEXT, -1), Some(1.0));
    }
}
