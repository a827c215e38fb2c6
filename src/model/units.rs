//! Quantities as people write them: `25.4mm`, `7.5 MN/m`, `30deg`, `1/3`, `pi/6`, `*2`, `+5%`.
//!
//! Everything inside the program is SI. This file turns text into SI numbers and back, and knows which
//! unit belongs to which kind of quantity. It knows nothing about scenes or screens.

use std::fmt;

use thiserror::Error;

/// The kind of a quantity: which units it can be written in.
///
/// `SpringCoefficient` and `DamperCoefficient` carry the unit `N/m^n` and `N(s/m)^m`, whose dimension depends
/// on an exponent; they accept the units of the linear case (`N/m`, `N s/m`) with SI prefixes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// A pure number.
    Number,
    /// kg
    Mass,
    /// m
    Length,
    /// m/s
    Velocity,
    /// deg (the SI unit is rad; angles are kept in degrees, see [`Quantity::si_unit`])
    Angle,
    /// kg/m³
    Density,
    /// Pa
    Pressure,
    /// s
    Time,
    /// N
    Force,
    /// J
    Energy,
    /// N/m, for a stop
    Stiffness,
    /// N s/m, for a stop
    Damping,
    /// N/m^n
    SpringCoefficient,
    /// N(s/m)^m
    DamperCoefficient,
}

/// One way of writing a quantity: the suffix and what one of it is in the stored unit.
type Unit = (&'static str, f64);

const DEG_PER_RAD: f64 = 180.0 / std::f64::consts::PI;

const STIFFNESS_UNITS: &[Unit] =
    &[("N/m", 1.0), ("kN/m", 1e3), ("MN/m", 1e6), ("GN/m", 1e9), ("N/mm", 1e3), ("kN/mm", 1e6)];
const DAMPING_UNITS: &[Unit] = &[
    ("N s/m", 1.0),
    ("Ns/m", 1.0),
    ("kN s/m", 1e3),
    ("kNs/m", 1e3),
    ("MN s/m", 1e6),
    ("MNs/m", 1e6),
];

impl Quantity {
    /// The units this kind may be written in, the stored one first.
    pub fn units(self) -> &'static [Unit] {
        match self {
            Self::Number => &[("", 1.0), ("%", 1e-2)],
            Self::Mass => &[("kg", 1.0), ("g", 1e-3), ("mg", 1e-6), ("t", 1e3)],
            Self::Length => &[
                ("m", 1.0),
                ("mm", 1e-3),
                ("cm", 1e-2),
                ("um", 1e-6),
                ("nm", 1e-9),
                ("km", 1e3),
                ("in", 0.0254),
            ],
            Self::Velocity => &[("m/s", 1.0), ("mm/s", 1e-3), ("km/s", 1e3), ("ft/s", 0.3048)],
            Self::Angle => &[("deg", 1.0), ("rad", DEG_PER_RAD), ("mrad", DEG_PER_RAD * 1e-3)],
            Self::Density => &[("kg/m3", 1.0), ("kg/m^3", 1.0), ("g/cm3", 1e3), ("g/cm^3", 1e3)],
            Self::Pressure => &[("Pa", 1.0), ("kPa", 1e3), ("MPa", 1e6), ("GPa", 1e9)],
            Self::Time => &[("s", 1.0), ("ms", 1e-3), ("us", 1e-6), ("ns", 1e-9), ("min", 60.0)],
            Self::Force => &[("N", 1.0), ("kN", 1e3), ("MN", 1e6)],
            Self::Energy => &[("J", 1.0), ("mJ", 1e-3), ("kJ", 1e3), ("MJ", 1e6)],
            Self::Stiffness | Self::SpringCoefficient => STIFFNESS_UNITS,
            Self::Damping | Self::DamperCoefficient => DAMPING_UNITS,
        }
    }

    /// The unit in which values of this kind are stored and shown beside a bare number.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Number => "-",
            Self::SpringCoefficient => "N/m^n",
            Self::DamperCoefficient => "N(s/m)^m",
            Self::Mass
            | Self::Length
            | Self::Velocity
            | Self::Angle
            | Self::Density
            | Self::Pressure
            | Self::Time
            | Self::Force
            | Self::Energy
            | Self::Stiffness
            | Self::Damping => self.units()[0].0,
        }
    }

    /// The unit a bare number has on the command line: SI, so radians for angles.
    pub fn si_unit(self) -> &'static str {
        match self {
            Self::Angle => "rad",
            other => other.unit(),
        }
    }

    fn accepted(self) -> String {
        let mut list = String::new();
        for (name, _) in self.units().iter().filter(|(name, _)| !name.is_empty()) {
            if !list.is_empty() {
                list.push_str(", ");
            }
            list.push_str(name);
        }
        list
    }
}

/// Why a text is not a quantity. Columns count characters from 1.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum QuantityError {
    /// Nothing was written.
    #[error("empty: write a number, for example `{example}`")]
    Empty {
        /// A text that would do.
        example: String,
    },
    /// The text does not begin with a number.
    #[error("`{}` is not a number (column {column}): write for example `{example}`", quoted(.text))]
    NotANumber {
        /// What was written.
        text: String,
        /// Where reading stopped.
        column: usize,
        /// A text that would do.
        example: String,
    },
    /// NaN, an infinity, or an overflow such as `1e999`.
    #[error("`{}` is not a finite number: write for example `{example}`", quoted(.text))]
    NotFinite {
        /// What was written.
        text: String,
        /// A text that would do.
        example: String,
    },
    /// The suffix is no unit of this kind.
    #[error(
        "`{}` is not a unit of this quantity (column {column}): use {accepted}, or no unit for {bare}",
        quoted(.unit)
    )]
    WrongUnit {
        /// The suffix.
        unit: String,
        /// Where it begins.
        column: usize,
        /// The units that are accepted.
        accepted: String,
        /// The unit of a bare number.
        bare: &'static str,
    },
}

/// What was written, cut short where it would hide the rest of the sentence.
fn quoted(text: &str) -> String {
    const SHOWN_MAX: usize = 40;
    match text.char_indices().nth(SHOWN_MAX) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text.to_owned(),
    }
}

/// Which unit a number without one has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bare {
    /// The SI unit: on the command line.
    Si,
    /// The stored unit: in files and in the editor, where it is shown beside the field (degrees for angles).
    Stored,
}

/// Read a quantity; the result is in the stored unit (SI, degrees for angles).
///
/// # Errors
/// [`QuantityError`] when the text is empty, no number, not finite, or has a unit of another kind.
pub fn parse(text: &str, quantity: Quantity, bare: Bare) -> Result<f64, QuantityError> {
    let trimmed = text.trim();
    let example = example_of(quantity);
    if trimmed.is_empty() {
        return Err(QuantityError::Empty { example });
    }
    let lead = text.chars().count() - text.trim_start().chars().count();
    let (value, rest) = expression(trimmed).ok_or_else(|| QuantityError::NotANumber {
        text: trimmed.to_owned(),
        column: lead + 1 + number_prefix(trimmed),
        example: example.clone(),
    })?;
    let unit = rest.trim();
    let factor = if unit.is_empty() {
        match bare {
            Bare::Si if quantity == Quantity::Angle => DEG_PER_RAD,
            Bare::Si | Bare::Stored => 1.0,
        }
    } else {
        unit_factor(unit, quantity).ok_or_else(|| QuantityError::WrongUnit {
            unit: unit.to_owned(),
            column: lead + 1 + trimmed.chars().count() - rest.trim_start().chars().count(),
            accepted: quantity.accepted(),
            bare: match bare {
                Bare::Si => quantity.si_unit(),
                Bare::Stored => quantity.unit(),
            },
        })?
    };
    let scaled = scale(value, factor);
    if scaled.is_finite() {
        Ok(scaled)
    } else {
        Err(QuantityError::NotFinite { text: trimmed.to_owned(), example })
    }
}

/// Read what may also be relative to `old`: `*2`, `/3`, `+5%`, `-5%`, else as [`parse`].
///
/// A leading sign without `%` is an ordinary number, so that `-3` stays minus three.
///
/// # Errors
/// As [`parse`].
pub fn parse_relative(
    text: &str,
    old: f64,
    quantity: Quantity,
    bare: Bare,
) -> Result<f64, QuantityError> {
    let trimmed = text.trim();
    let plain = |rest: &str| parse(rest, Quantity::Number, Bare::Stored);
    let new = if let Some(rest) = trimmed.strip_prefix('*') {
        old * plain(rest)?
    } else if let Some(rest) = trimmed.strip_prefix('/') {
        old / plain(rest)?
    } else if trimmed.starts_with(['+', '-']) && trimmed.ends_with('%') {
        old * (1.0 + plain(trimmed)?)
    } else {
        return parse(text, quantity, bare);
    };
    if new.is_finite() {
        Ok(new)
    } else {
        Err(QuantityError::NotFinite { text: trimmed.to_owned(), example: example_of(quantity) })
    }
}

/// `value * factor`, by division where the factor is below one, so that `25.4mm` is the float nearest to 0.0254.
fn scale(value: f64, factor: f64) -> f64 {
    let inverse = 1.0 / factor;
    if factor < 1.0 && (inverse - inverse.round()).abs() < 1e-6 * inverse {
        value / inverse.round()
    } else {
        value * factor
    }
}

fn unit_factor(unit: &str, quantity: Quantity) -> Option<f64> {
    let squeezed: String = unit
        .chars()
        .filter(|c| !c.is_whitespace())
        .map(|c| match c {
            'µ' | 'μ' => 'u',
            '·' => '*',
            other => other,
        })
        .collect();
    if squeezed == quantity.unit() {
        return Some(1.0);
    }
    if quantity == Quantity::Angle && squeezed == "°" {
        return Some(1.0);
    }
    if quantity == Quantity::Density && squeezed == "kg/m³" {
        return Some(1.0);
    }
    let same = |name: &str| name.chars().filter(|c| !c.is_whitespace()).eq(squeezed.chars());
    quantity.units().iter().find(|(name, _)| !name.is_empty() && same(name)).map(|unit| unit.1)
}

/// `number [(*|/) number]`, where a number may be `pi`; gives the value and what follows.
fn expression(text: &str) -> Option<(f64, &str)> {
    let (mut value, mut rest) = number(text)?;
    loop {
        let ahead = rest.trim_start();
        let (divide, tail) = match ahead.as_bytes().first() {
            Some(b'/') => (true, &ahead[1..]),
            Some(b'*') => (false, &ahead[1..]),
            _ => return Some((value, rest)),
        };
        let (operand, after) = number(tail.trim_start())?;
        value = if divide { value / operand } else { value * operand };
        rest = after;
    }
}

fn number(text: &str) -> Option<(f64, &str)> {
    for word in ["pi", "π"] {
        if let Some(rest) = text.strip_prefix(word) {
            return Some((std::f64::consts::PI, rest));
        }
    }
    let length = number_prefix(text);
    let value = text[..length].parse().ok()?;
    Some((value, &text[length..]))
}

/// Length in bytes of the longest prefix that reads as a decimal number.
fn number_prefix(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digits_from = |mut at: usize| {
        while bytes.get(at).is_some_and(u8::is_ascii_digit) {
            at += 1;
        }
        at
    };
    let start = usize::from(matches!(bytes.first(), Some(b'+' | b'-')));
    let whole = digits_from(start);
    let mut end = whole;
    let mut digits = whole - start;
    if bytes.get(whole) == Some(&b'.') {
        end = digits_from(whole + 1);
        digits += end - whole - 1;
    }
    if digits == 0 {
        return 0;
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = end + 1 + usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let exponent = digits_from(sign);
        if exponent > sign {
            end = exponent;
        }
    }
    end
}

fn example_of(quantity: Quantity) -> String {
    match quantity {
        Quantity::Number => "1.5",
        Quantity::Mass => "29.5g",
        Quantity::Length => "25.4mm",
        Quantity::Velocity => "100 m/s",
        Quantity::Angle => "30deg",
        Quantity::Density => "2710 kg/m3",
        Quantity::Pressure => "151.6 MPa",
        Quantity::Time => "150 us",
        Quantity::Force => "19kN",
        Quantity::Energy => "150J",
        Quantity::Stiffness | Quantity::SpringCoefficient => "7.5MN/m",
        Quantity::Damping | Quantity::DamperCoefficient => "2 kN s/m",
    }
    .to_owned()
}

/// A number as short as it can be and still read back to the same float: `1e5`, `0.0295`, `1.52e8`.
///
/// Plain digits between 1e-4 and 1e5, an exponent outside.
pub fn shortest(value: f64) -> String {
    let magnitude = value.abs();
    if !value.is_finite() {
        return format!("{value}");
    }
    if magnitude == 0.0 || (1e-4..1e5).contains(&magnitude) {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}

/// A number rounded to `digits` significant figures, without trailing zeros beyond them.
pub fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return shortest(value);
    }
    let rounded: f64 = format!("{value:.*e}", digits.saturating_sub(1)).parse().unwrap_or(value);
    shortest(rounded)
}

/// A quantity with an SI prefix that a person reads at a glance: `7.113 mm`, `19.26 kN`, `113.4 us`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Engineering {
    /// The value in the SI unit.
    pub value: f64,
    /// The SI unit without prefix, for example `m`.
    pub unit: &'static str,
    /// Significant figures.
    pub digits: usize,
}

impl fmt::Display for Engineering {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (factor, prefix) = prefix_of(self.value);
        let scaled = self.value / factor;
        let text = fixed_significant(scaled, self.digits);
        write!(f, "{text} {prefix}{}", self.unit)
    }
}

/// The SI prefix (its factor and letter) that brings `value` between 1 and 1000.
pub fn prefix_of(value: f64) -> (f64, &'static str) {
    const PREFIXES: [(f64, &str); 9] = [
        (1e9, "G"),
        (1e6, "M"),
        (1e3, "k"),
        (1.0, ""),
        (1e-3, "m"),
        (1e-6, "u"),
        (1e-9, "n"),
        (1e-12, "p"),
        (1e-15, "f"),
    ];
    let magnitude = value.abs();
    if magnitude == 0.0 || !magnitude.is_finite() {
        return (1.0, "");
    }
    PREFIXES
        .into_iter()
        .find(|(factor, _)| magnitude >= factor * 0.999_999_5)
        .unwrap_or(PREFIXES[PREFIXES.len() - 1])
}

/// `digits` significant figures in plain notation, zeros kept: `7.113`, `50.00`.
pub fn fixed_significant(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return format!("{value}");
    }
    if value == 0.0 {
        return "0".to_owned();
    }
    let exponent = format!("{value:.*e}", digits.saturating_sub(1))
        .rsplit_once('e')
        .and_then(|(_, exponent)| exponent.parse::<i64>().ok())
        .unwrap_or(0);
    if !(-4..=6).contains(&exponent) {
        return format!("{value:.*e}", digits.saturating_sub(1));
    }
    let places = i64::try_from(digits).unwrap_or(6) - 1 - exponent;
    format!("{value:.*}", usize::try_from(places).unwrap_or(0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_scale_to_the_nearest_float() {
        let cases = [
            ("25.4mm", Quantity::Length, 0.0254),
            ("6.35 mm", Quantity::Length, 0.00635),
            ("29.5g", Quantity::Mass, 0.0295),
            ("7.5MN/m", Quantity::SpringCoefficient, 7.5e6),
            ("1e5 N/m^n", Quantity::SpringCoefficient, 1e5),
            ("150 us", Quantity::Time, 150e-6),
            ("150 µs", Quantity::Time, 150e-6),
            ("151.6 MPa", Quantity::Pressure, 151.6e6),
            ("30deg", Quantity::Angle, 30.0),
            ("30°", Quantity::Angle, 30.0),
            ("1/3", Quantity::Number, 1.0 / 3.0),
            ("2 kN s/m", Quantity::DamperCoefficient, 2000.0),
            ("2.71 g/cm3", Quantity::Density, 2710.0),
        ];
        for (text, quantity, expected) in cases {
            let value = parse(text, quantity, Bare::Stored).unwrap();
            assert!((value - expected).abs() <= f64::EPSILON * expected, "{text}: {value}");
        }
    }

    #[test]
    fn a_bare_angle_is_radians_on_the_command_line_and_degrees_in_a_file() {
        let radians = parse("pi/6", Quantity::Angle, Bare::Si).unwrap();
        assert!((radians - 30.0).abs() < 1e-13);
        assert_eq!(parse("30", Quantity::Angle, Bare::Stored), Ok(30.0));
    }

    #[test]
    fn relative_edits_use_the_old_value() {
        let edit = |text| parse_relative(text, 8.0, Quantity::Length, Bare::Stored).unwrap();
        let cases = [("*2", 16.0), ("/4", 2.0), ("+50%", 12.0), ("-3", -3.0), ("1mm", 0.001)];
        for (text, expected) in cases {
            assert_eq!(edit(text).to_bits(), f64::to_bits(expected), "{text}");
        }
    }

    #[test]
    fn refusals_name_text_column_and_cure() {
        let cases = [
            ("", "empty"),
            ("abc", "column 1"),
            (&"1".repeat(1000), "111...` is not a finite number"),
            (&"x".repeat(1000), "xxx...` is not a number (column 1)"),
            ("12 kg", "`kg` is not a unit of this quantity (column 4): use m, mm"),
            ("NaN", "not a number"),
            ("inf", "not a number"),
            ("1e999", "not a finite number"),
            ("1/0", "not a finite number"),
            ("1..2", "not a unit"),
        ];
        for (text, fragment) in cases {
            let error = parse(text, Quantity::Length, Bare::Stored).unwrap_err().to_string();
            assert!(error.contains(fragment), "{text}: {error}");
        }
    }

    #[test]
    fn numbers_print_short_and_read_back() {
        for value in [1e5, 0.0295, 1.52e8, 1.0 / 3.0, 5e-324, -0.0, 7.5e6, 1e-4] {
            let text = shortest(value);
            let back: f64 = text.parse().unwrap();
            assert_eq!(back.to_bits(), value.to_bits(), "{text}");
        }
        assert_eq!(shortest(1e5), "1e5");
        assert_eq!(significant(0.007_113_055, 4), "0.007113");
    }

    #[test]
    fn engineering_picks_the_prefix() {
        let show = |value, unit| Engineering { value, unit, digits: 4 }.to_string();
        assert_eq!(show(0.007_113_055, "m"), "7.113 mm");
        assert_eq!(show(19_257.0, "N"), "19.26 kN");
        assert_eq!(show(113.407e-6, "s"), "113.4 us");
        assert_eq!(show(0.0, "m"), "0 m");
        assert_eq!(show(0.999_999_9, "m"), "1.000 m");
    }
}
