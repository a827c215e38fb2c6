//! Quantities in user notation: `25.4mm`, `7.5 MN/m`, `30deg`, `1/3`, `pi/6`, `*2`, `+5%`.
//!
//! All other modules use SI. This module parses text into SI numbers, formats numbers as text, and defines the units of each dimension. It
//! does not depend on scenes or the terminal.

mod error;
mod table;

pub use error::UnitError;
pub use table::Dimension;
use table::UNITS;

/// Returns the error for NaN, an infinity, or an overflow such as `1e999`.
fn not_finite(text: &str, quantity: Dimension) -> UnitError {
    UnitError::NotFinite { text: quoted(text), example: quantity.example() }
}

/// Quotes the text as written, shortened if it is long.
fn quoted(text: &str) -> String {
    const SHOWN_MAX: usize = 40;
    match text.char_indices().nth(SHOWN_MAX) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text.to_owned(),
    }
}

/// Unit of a bare number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bare<'u> {
    /// SI, on the command line; an angle needs a unit there.
    Si,
    /// Stored unit (degrees for angles), if a field displays it or a name contains it, as in files.
    Stored,
    /// Unit displayed next to the field.
    In(&'u str),
}

/// Parses a quantity; the result is in the stored unit (SI, degrees for angles). Errors contain the remedy and count columns from 1.
pub fn parse(text: &str, quantity: Dimension, bare: Bare<'_>) -> Result<f64, UnitError> {
    let trimmed = text.trim();
    let example = quantity.example();
    if trimmed.is_empty() {
        return Err(UnitError::Empty { example });
    }
    let column = |rest: &str| 1 + text.trim_end().chars().count() - rest.chars().count();
    let (value, rest) = expression(trimmed).ok_or_else(|| {
        let column = column(&trimmed[number_prefix(trimmed)..]);
        UnitError::NotANumber { text: quoted(trimmed), column, example }
    })?;
    if let Some(cure) = with_point(trimmed, rest) {
        return Err(UnitError::Comma { text: quoted(trimmed), column: column(rest), cure });
    }
    let unit = match (rest.trim(), bare) {
        ("", Bare::In(shown)) => shown,
        (written, _) => written,
    };
    let needs_unit = bare == Bare::Si && quantity == Dimension::Angle;
    // Zero needs no unit.
    if unit.is_empty() && needs_unit && value != 0.0 {
        return Err(UnitError::AngleWithoutUnit { text: quoted(trimmed) });
    }
    let (times, over) = factor(unit, quantity).ok_or_else(|| {
        let bare = match bare {
            _ if needs_unit => String::new(),
            Bare::Si | Bare::Stored => no_unit_for(quantity.unit()),
            Bare::In(shown) => no_unit_for(shown),
        };
        let allowed = format!("{}{bare}", quantity.accepted());
        UnitError::NotAUnit { unit: quoted(unit), column: column(unit), allowed }
    })?;
    let scaled = value * times / over;
    if scaled.is_finite() { Ok(scaled) } else { Err(not_finite(trimmed, quantity)) }
}

/// Returns the unit of a bare number, as the end of a sentence.
fn no_unit_for(unit: &str) -> String {
    if unit.is_empty() { ", or no unit".to_owned() } else { format!(", or no unit for {unit}") }
}

/// Returns the remedy if a decimal comma or a thousands separator follows the parsed number.
fn with_point(text: &str, rest: &str) -> Option<String> {
    let digits = number_prefix(rest.strip_prefix(',')?);
    let point = quoted(&text.replacen(',', ".", 1));
    match digits {
        0 => None,
        3 => Some(format!("write `{point}`, or `{}`", quoted(&text.replacen(',', "", 1)))),
        _ => Some(format!("write `{point}`")),
    }
}

/// Returns the error for a range with a unit at one end only; `None` if both ends have one. Zero needs no unit.
pub fn one_bare_end(low: &str, high: &str, quantity: Dimension) -> Option<UnitError> {
    let (low, high) = (low.trim(), high.trim());
    let unit_of = |text| {
        let (value, rest) = expression(text)?;
        (value != 0.0).then_some(rest.trim())
    };
    let (bare, other, unit) = match (unit_of(low)?, unit_of(high)?) {
        ("", unit) if !unit.is_empty() => (low, high, unit),
        (unit, "") if !unit.is_empty() => (high, low, unit),
        _ => return None,
    };
    let range = |unit: &str| {
        if bare == low { format!("{bare} {unit}..{high}") } else { format!("{low}..{bare} {unit}") }
    };
    let or = if unit == quantity.unit() {
        String::new()
    } else {
        format!(" or `{}`", range(quantity.unit()))
    };
    let cure = format!("`{}`{or}", range(unit));
    Some(UnitError::UnitAtOneEnd { bare: bare.to_owned(), other: other.to_owned(), cure })
}

/// Parses a quantity that may be relative to `old`: `*2`, `/3`, `+5%`, `-5%`, else as [`parse`].
///
/// A leading sign without `%` is an ordinary number, so that `-3` stays minus three.
pub fn parse_relative(
    text: &str,
    old: f64,
    quantity: Dimension,
    bare: Bare<'_>,
) -> Result<f64, UnitError> {
    let trimmed = text.trim();
    let plain = |rest: &str| parse(rest, Dimension::Number, Bare::Stored);
    let new = if let Some(rest) = trimmed.strip_prefix('*') {
        old * plain(rest)?
    } else if let Some(rest) = trimmed.strip_prefix('/') {
        old / plain(rest)?
    } else if trimmed.starts_with(['+', '-']) && trimmed.ends_with('%') {
        old * (1.0 + plain(trimmed)?)
    } else {
        return parse(text, quantity, bare);
    };
    if new.is_finite() { Ok(new) } else { Err(not_finite(trimmed, quantity)) }
}

/// Converts a value from the stored unit to another one; `None` if the unit has another dimension.
pub fn in_unit(value: f64, unit: &str, quantity: Dimension) -> Option<f64> {
    let (times, over) = factor(unit, quantity)?;
    Some(value * over / times)
}

/// Returns the standard name of a unit other than the stored one; `None` for another dimension, or an unusual prefix.
pub fn unit_named(name: &str, quantity: Dimension) -> Option<&'static str> {
    let name = squeezed(name);
    let mut accepted = quantity.accepted().split(", ").filter(|_| name != quantity.unit());
    accepted.find(|accepted| squeezed(accepted) == name)
}

/// Returns the unit after a number, empty if there is none; `None` if the text is not a number.
pub fn written_unit(text: &str) -> Option<&str> {
    expression(text.trim()).map(|(_, rest)| rest.trim())
}

/// Normalises the name of a unit: without blanks, in ASCII.
fn squeezed(unit: &str) -> String {
    let mut name: String = unit.chars().filter(|c| !c.is_whitespace()).collect();
    for (sign, plain) in [
        ("µ", "u"),
        ("μ", "u"),
        ("·", "*"),
        ("°", "deg"),
        ("²", "2"),
        ("³", "3"),
        ("^2", "2"),
        ("^3", "3"),
    ] {
        name = name.replace(sign, plain);
    }
    name
}

/// Returns numerator and denominator of the factor from a named unit to the stored unit; an empty name is the stored unit.
fn factor(unit: &str, quantity: Dimension) -> Option<(f64, f64)> {
    let (name, stored) = (squeezed(unit), squeezed(quantity.unit()));
    if name.is_empty() || name == stored {
        return Some((1.0, 1.0));
    }
    let is_accepted = unit_named(&name, quantity).is_some();
    // Values are displayed with any prefix; kg already has one.
    let takes_prefix = !stored.is_empty() && !stored.starts_with("kg");
    Prefix::ALL.iter().find_map(|prefix| {
        let base = name.strip_prefix(prefix.letter)?;
        let (_, times, over) = if base == stored && (is_accepted || takes_prefix) {
            &("", 1.0, 1.0)
        } else {
            UNITS.iter().find(|(unit, ..)| is_accepted && squeezed(unit) == base)?
        };
        let is_part = prefix.size < 1.0;
        Some(if is_part { (*times, over * prefix.in_one) } else { (times * prefix.size, *over) })
    })
}

/// Parses `number [(*|/) number]`, where a number may be `pi`; returns the value and the rest of the text.
fn expression(text: &str) -> Option<(f64, &str)> {
    let (mut value, mut rest) = number(text)?;
    while let Some(sign @ ('*' | '/')) = rest.trim_start().chars().next() {
        let (operand, after) = number(rest.trim_start()[1..].trim_start())?;
        value = if sign == '/' { value / operand } else { value * operand };
        rest = after;
    }
    Some((value, rest))
}

fn number(text: &str) -> Option<(f64, &str)> {
    if let Some(rest) = text.strip_prefix("pi").or_else(|| text.strip_prefix('π')) {
        return Some((std::f64::consts::PI, rest));
    }
    let (number, rest) = text.split_at(number_prefix(text));
    Some((number.parse().ok()?, rest))
}

/// Returns the length in bytes of the longest prefix that is a decimal number.
fn number_prefix(text: &str) -> usize {
    let is_of_number = |c: char| c.is_ascii_digit() || "+-.eE".contains(c);
    let most = text.find(|c| !is_of_number(c)).unwrap_or(text.len());
    (1..=most).rev().find(|end| text[..*end].parse::<f64>().is_ok()).unwrap_or(0)
}

/// Text for a missing number; NaN and infinity are never displayed.
pub const NO_NUMBER: &str = "-";

/// Formats a number with a fixed number of decimals: `69.10`.
pub fn decimals(value: f64, places: usize) -> String {
    if value.is_finite() { format!("{value:.places$}") } else { NO_NUMBER.to_owned() }
}

/// Formats a number in scientific notation with a fixed number of decimals: `1.2e-9`.
pub fn scientific(value: f64, places: usize) -> String {
    if value.is_finite() { format!("{value:.places$e}") } else { NO_NUMBER.to_owned() }
}

/// Formats an upper bound of a positive number with one digit: `< 2e-10` for 1.2e-10.
pub fn below(value: f64) -> String {
    let nearest = scientific(value, 0);
    let parts = nearest.split_once('e').map(|(digit, power)| (digit.parse(), power.parse()));
    let Some((Ok(digit), Ok(power))) = parts else { return NO_NUMBER.to_owned() };
    let is_above = nearest.parse().is_ok_and(|nearest: f64| nearest >= value);
    let digit: f64 = if is_above { digit } else { digit + 1.0 };
    format!("< {}", scientific(digit * 10f64.powi(power), 0))
}

/// Formats a number with the fewest digits that parse to the same float: `1e5`, `0.0295`, `1.52e8`.
///
/// Uses decimal notation between 1e-4 and 1e5, else an exponent.
pub fn shortest(value: f64) -> String {
    let magnitude = value.abs();
    if !value.is_finite() {
        NO_NUMBER.to_owned()
    } else if magnitude == 0.0 || (1e-4..1e5).contains(&magnitude) {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}

/// Formats a number with `digits` significant figures, without trailing zeros.
pub fn significant(value: f64, digits: usize) -> String {
    let rounded: f64 = format!("{value:.*e}", digits.saturating_sub(1)).parse().unwrap_or(value);
    shortest(rounded)
}

/// Formats a value in an SI unit with a suitable prefix: `7.113 mm`, `19.26 kN`, `113.4 us`. Units that do not take prefixes have none.
pub fn engineering(value: f64, unit: &str, digits: usize) -> String {
    if !value.is_finite() {
        return NO_NUMBER.to_owned();
    }
    if unit == "kg" && value.abs() < 1e3 {
        return engineering(1e3 * value, "g", digits);
    }
    let value = if takes_prefix(unit) { without_rounding(value) } else { value };
    let prefix = Prefix::for_unit(value, unit);
    let number = fixed_significant(value / prefix.size, digits);
    format!("{number} {}{unit}", prefix.letter).trim_end().to_owned()
}

/// Smallest value with a prefix on pages, a thousandth of the smallest prefix: less is left by rounding alone.
const LEAST: f64 = 1e-18;

/// Returns a value in an SI unit as pages show it: zero in place of what rounding leaves.
pub fn without_rounding(value: f64) -> f64 {
    if value.abs() < LEAST { 0.0 } else { value }
}

/// Returns `true` for a unit before which a prefix stands: not kg, powers, angles, numbers and pure numbers. km3 is not 1000 m3.
fn takes_prefix(unit: &str) -> bool {
    let leading = unit.split(['/', ' ', '*', '·']).next().unwrap_or("");
    leading.chars().all(char::is_alphabetic) && !matches!(leading, "" | "kg" | "deg" | "rad")
}

/// Formats a velocity: `230.0 m/s`.
pub fn velocity(value_m_s: f64, digits: usize) -> String {
    format!("{} m/s", fixed_significant(value_m_s, digits))
}

/// SI prefix.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prefix {
    /// Factor of the prefix: 1e-3.
    pub size: f64,
    /// Inverse of the factor: 1e3. Stored separately, because 1/1e-6 is not 1e6.
    pub in_one: f64,
    /// Letter of the prefix: m.
    pub letter: &'static str,
}

impl Prefix {
    /// No prefix.
    pub const NONE: Self = Self { size: 1.0, in_one: 1.0, letter: "" };
    const ALL: [Self; 9] = [
        Self { size: 1e9, in_one: 1e-9, letter: "G" },
        Self { size: 1e6, in_one: 1e-6, letter: "M" },
        Self { size: 1e3, in_one: 1e-3, letter: "k" },
        Self::NONE,
        Self { size: 1e-3, in_one: 1e3, letter: "m" },
        Self { size: 1e-6, in_one: 1e6, letter: "u" },
        Self { size: 1e-9, in_one: 1e9, letter: "n" },
        Self { size: 1e-12, in_one: 1e12, letter: "p" },
        Self { size: 1e-15, in_one: 1e15, letter: "f" },
    ];

    /// Chooses the prefix for a value in a unit; none for a unit that takes none.
    pub fn for_unit(value: f64, unit: &str) -> Self {
        if takes_prefix(unit) { Self::for_value(value) } else { Self::NONE }
    }

    /// Chooses the prefix that brings a value into the range 1 to 1000.
    pub fn for_value(value: f64) -> Self {
        let magnitude = without_rounding(value).abs();
        if magnitude == 0.0 || !magnitude.is_finite() {
            return Self::NONE;
        }
        let fits = |prefix: &Self| magnitude >= prefix.size * 0.999_999_5;
        Self::ALL.into_iter().find(fits).unwrap_or(Self::ALL[Self::ALL.len() - 1])
    }
}

/// Formats a number with `digits` significant figures in decimal notation, with trailing zeros: `7.113`, `50.00`.
pub fn fixed_significant(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return NO_NUMBER.to_owned();
    }
    if value == 0.0 {
        return "0".to_owned();
    }
    let scientific = format!("{value:.*e}", digits.saturating_sub(1));
    let exponent: i64 =
        scientific.rsplit_once('e').and_then(|(_, it)| it.parse().ok()).unwrap_or(0);
    if !(-4..=6).contains(&exponent) {
        return scientific;
    }
    let places = i64::try_from(digits).unwrap_or(6) - 1 - exponent;
    format!("{value:.*}", usize::try_from(places).unwrap_or(0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_upper_bound_is_rounded_up() {
        let cases = [(2e-10, "2e-10"), (1.2e-10, "2e-10"), (9.4e-10, "1e-9"), (1e-12, "1e-12")];
        for (value, bound) in cases {
            assert_eq!(below(value), format!("< {bound}"));
        }
        assert_eq!([0.96, 3.0, 11.0].map(below), ["< 1e0", "< 3e0", "< 2e1"].map(str::to_owned));
    }

    /// A swing of 3.3e-18 m on a steep spring is one; 1e-27 m is what rounding leaves of zero.
    #[test]
    fn what_rounding_leaves_is_shown_as_zero() {
        for (value, unit, shown) in [
            (1.005_96e-27, "m", "0 m"),
            (-9.122e-26, "m", "0 m"),
            (1.8e-54, "J", "0 J"),
            (3.3e-18, "m", "0.003300 fm"),
            (1.947e-9, "m", "1.947 nm"),
            (1e-27, "", "1.000e-27"),
        ] {
            assert_eq!(engineering(value, unit, 4), shown);
        }
    }

    #[test]
    fn values_that_are_not_numbers_are_not_shown() {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let shown = [
                shortest(value),
                significant(value, 4),
                fixed_significant(value, 4),
                decimals(value, 2),
                scientific(value, 1),
                below(value),
                engineering(value, "J", 4),
            ];
            assert_eq!(shown, [NO_NUMBER; 7]);
        }
        assert_eq!((decimals(69.1, 2), scientific(1.234e-9, 1)), ("69.10".into(), "1.2e-9".into()));
    }

    #[test]
    fn units_are_those_of_their_definitions() {
        // The international yard and pound agreement of 1959 (1 in = 25.4 mm, 1 lb = 0.45359237 kg), 9.80665 m/s^2.
        let lbf = 4.448_221_615_260_5;
        let square_inch = 0.0254 * 0.0254;
        let cases = [
            ("6.35 mm", Dimension::Length, 0.00635),
            ("29.5g", Dimension::Mass, 0.0295),
            ("7.5MN/m", Dimension::SpringCoefficient, 7.5e6),
            ("1e5 N/m^n", Dimension::SpringCoefficient, 1e5),
            ("150 µs", Dimension::Time, 150e-6),
            ("151.6 MPa", Dimension::Pressure, 151.6e6),
            ("30°", Dimension::Angle, 30.0),
            ("1/3", Dimension::Number, 1.0 / 3.0),
            ("2 kN s/m", Dimension::DamperCoefficient, 2000.0),
            ("2.71 g/cm3", Dimension::Density, 2710.0),
            ("1in", Dimension::Length, 0.0254),
            ("1ft", Dimension::Length, 0.3048),
            ("1000mil", Dimension::Length, 0.0254),
            ("7000gr", Dimension::Mass, 0.453_592_37),
            ("1lb", Dimension::Mass, 0.453_592_37),
            ("16oz", Dimension::Mass, 0.453_592_37),
            ("1fps", Dimension::Velocity, 0.3048),
            ("2780 ft/s", Dimension::Velocity, 847.344),
            ("2.78kfps", Dimension::Velocity, 847.344),
            ("3.6km/h", Dimension::Velocity, 1.0),
            ("1mph", Dimension::Velocity, 1609.344 / 3600.0),
            ("1psi", Dimension::Pressure, lbf / square_inch),
            ("40ksi", Dimension::Pressure, 40_000.0 * lbf / square_inch),
            ("10Msi", Dimension::Pressure, 1e7 * lbf / square_inch),
            ("1lbf", Dimension::Force, lbf),
            ("1 lbf/in", Dimension::Stiffness, lbf / 0.0254),
            ("570lbf/in", Dimension::SpringCoefficient, 570.0 * lbf / 0.0254),
            ("1 lbf s/in", Dimension::Damping, lbf / 0.0254),
            ("0.098 lb/in3", Dimension::Density, 0.098 * 0.453_592_37 / (square_inch * 0.0254)),
            ("0.098 lb/in^3", Dimension::Density, 0.098 * 0.453_592_37 / (square_inch * 0.0254)),
            // Water at 4 degrees Celsius: 62.43 lb/ft3 are 1000 kg/m3.
            ("62.43 lb/ft3", Dimension::Density, 62.43 * 0.453_592_37 / (0.3048 * 0.3048 * 0.3048)),
            ("1 lb/ft^3", Dimension::Density, 16.018_463_373_960_14),
            ("20 J/g", Dimension::SpecificEnergy, 20_000.0),
            // One kilobar is 100 MPa, one N/mm2 is 1 MPa, and a turn is 2 pi rad or 360 deg.
            ("15.2 kbar", Dimension::Pressure, 1.52e9),
            ("276 N/mm2", Dimension::Pressure, 276e6),
            ("2.71 t/m3", Dimension::Density, 2710.0),
            ("50 rad/m", Dimension::Twist, 50.0),
            ("360 deg/mm", Dimension::Twist, 2000.0 * std::f64::consts::PI),
            ("5 kg cm2", Dimension::Inertia, 5e-4),
            ("5 kg cm^2", Dimension::Inertia, 5e-4),
            ("5 g mm^2", Dimension::Inertia, 5e-9),
            ("pi/6 rad", Dimension::Angle, 30.0),
            ("1 lbf s", Dimension::Impulse, lbf),
            ("1 ft lbf", Dimension::Energy, 0.3048 * lbf),
            ("1.5kJ", Dimension::Energy, 1500.0),
            ("1 lb/ft2", Dimension::ArealMass, 0.453_592_37 / (0.3048 * 0.3048)),
            ("1 lb/ft^2", Dimension::ArealMass, 0.453_592_37 / (0.3048 * 0.3048)),
            ("4 g/cm2", Dimension::ArealMass, 40.0),
            // Any prefix of the stored unit.
            ("2 GN", Dimension::Force, 2e9),
            ("3 mN s", Dimension::Impulse, 3e-3),
            ("5 nJ", Dimension::Energy, 5e-9),
        ];
        for (text, quantity, expected) in cases {
            let value = parse(text, quantity, Bare::Si).unwrap();
            assert!((value - expected).abs() <= 4.0 * f64::EPSILON * expected, "{text}: {value}");
        }
        // Nearest floats.
        for (text, exact) in [("3in", 0.0762), ("25.4mm", 0.0254)] {
            assert_eq!(parse(text, Dimension::Length, Bare::Si), Ok(exact));
        }
    }

    #[test]
    fn relative_edits_use_the_old_value() {
        let edit = |text| parse_relative(text, 8.0, Dimension::Length, Bare::Stored).unwrap();
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
            ("12,5mm", "`12,5mm` has a comma (column 3): write `12.5mm`"),
            (" -0,25 m", "`-0,25 m` has a comma (column 4): write `-0.25 m`"),
            ("1,250mm", "write `1.250mm`, or `1250mm`"),
            ("1, 2", "`, 2` is not a unit"),
            ("2 mkg", "`mkg` is not a unit"),
        ];
        for (text, fragment) in cases {
            let error = parse(text, Dimension::Length, Bare::Stored).unwrap_err().to_string();
            assert!(error.contains(fragment), "{text}: {error}");
        }
        for (quantity, cure) in [
            (Dimension::Number, "use %, or no unit"),
            (Dimension::Twist, "use rad/m, rad/mm, deg/m, deg/mm, or no unit for rad/m"),
        ] {
            let error = parse("5 lb", quantity, Bare::Si).unwrap_err().to_string();
            assert!(error.ends_with(cure), "{error}");
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

    /// 52 km3/s2 are 5.2e10 m3/s2, and 63 kkg is no mass.
    #[test]
    fn engineering_picks_the_prefix_where_the_unit_takes_one() {
        for (value, unit, expected) in [
            (0.007_113_055, "m", "7.1131 mm"),
            (19_257.0, "N", "19.257 kN"),
            (113.407e-6, "s", "113.41 us"),
            (0.0, "m", "0 m"),
            (0.999_999_9, "m", "1.0000 m"),
            (52_362.0, "m3/s2", "52362 m3/s2"),
            (63_522.0, "kg", "63522 kg"),
            (29.5e-9, "kg", "29.500 ug"),
            (1.4822e11, "kg/m2", "1.4822e11 kg/m2"),
            (7.5e6, "N/m", "7.5000 MN/m"),
            (30.0, "deg", "30.000 deg"),
        ] {
            assert_eq!(engineering(value, unit, 5), expected);
        }
    }
}
