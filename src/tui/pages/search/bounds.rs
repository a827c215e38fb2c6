//! A variable with its bounds, as the setup of a search has it, and how its text is read. No drawing.

use crate::model::scene::Scene;
use crate::model::units::{self, Bare, significant};
use crate::model::variables::{self, Kind};
use crate::study::sweep::{Axis, Spacing};

/// A variable with its bounds.
#[derive(Clone, Debug, PartialEq)]
pub struct Bound {
    /// Its symbol.
    pub name: &'static str,
    /// First and last value, in the stored unit.
    pub ends: (f64, f64),
    /// At equal ratios.
    pub log: bool,
    /// It is varied; otherwise held.
    pub on: bool,
}

/// The bounds a variable gets when it is chosen: Table 9.2's, or half to double of what the scene has.
///
/// # Errors
/// Why there is no such variable, or none with numbers.
pub fn bound(scene: &Scene, name: &str) -> Result<Bound, String> {
    let variable = variables::find(name).map_err(|error| error.to_string())?;
    let Kind::Number(number) = &variable.kind else {
        return Err(format!("{} has no numbers, only {}", variable.symbol, variable.allowed()));
    };
    let ends = number.thesis_range.unwrap_or_else(|| match (number.get)(scene) {
        Some(value) if value > 0.0 => {
            let double = 2.0 * value;
            (0.5 * value, if number.allowed.contains(double) { double } else { value })
        }
        Some(_) | None => (0.0, 1.0),
    });
    Ok(Bound { name: variable.symbol, ends, log: false, on: true })
}

/// Read `0.8..7`, `1e3..7.5e6:log`, with units or without; `off` and `on`.
///
/// # Errors
/// What is wrong with the text.
pub fn read_bound(old: &Bound, text: &str) -> Result<Bound, String> {
    match text.trim() {
        "off" => return Ok(Bound { on: false, ..old.clone() }),
        "on" => return Ok(Bound { on: true, ..old.clone() }),
        _ => {}
    }
    let (range, log) = match text.trim().strip_suffix(":log") {
        Some(range) => (range, true),
        None => (text.trim(), false),
    };
    let (low, high) = range.split_once("..").ok_or("write LO..HI, LO..HI:log or off: 0.8..7")?;
    let variable = variables::find(old.name).map_err(|error| error.to_string())?;
    let Kind::Number(number) = &variable.kind else { return Err("no numbers".to_owned()) };
    let read = |text: &str| {
        units::parse(text, number.quantity, Bare::Stored).map_err(|problem| problem.to_string())
    };
    let ends = (read(low)?, read(high)?);
    if let Some(problem) = units::one_bare_end(low, high, number.quantity) {
        return Err(problem);
    }
    let new = Bound { ends, log, on: true, ..old.clone() };
    axis(&new, 2).map(|_| new)
}

/// Read one end of a bound, the low or the high one, with a unit or without; the other end stays.
///
/// # Errors
/// What is wrong with the text.
pub fn read_end(old: &Bound, low: bool, text: &str) -> Result<Bound, String> {
    let variable = variables::find(old.name).map_err(|error| error.to_string())?;
    let Kind::Number(number) = &variable.kind else { return Err("no numbers".to_owned()) };
    let end =
        units::parse(text, number.quantity, Bare::Stored).map_err(|problem| problem.to_string())?;
    let ends = if low { (end, old.ends.1) } else { (old.ends.0, end) };
    let new = Bound { ends, on: true, ..old.clone() };
    axis(&new, 2).map(|_| new)
}

/// A checked axis of a bound.
pub(in crate::tui) fn axis(bound: &Bound, count: u64) -> Result<Axis, String> {
    let spacing = if bound.log { Spacing::Log } else { Spacing::Linear };
    Axis::new(bound.name, bound.ends, count, spacing).map_err(|error| error.to_string())
}

/// `0.8..7` or `1e3..7.5e6:log`.
pub(in crate::tui) fn range(bound: &Bound) -> String {
    let (low, high) = bound.ends;
    let log = if bound.log { ":log" } else { "" };
    format!("{}..{}{log}", significant(low, 5), significant(high, 5))
}
