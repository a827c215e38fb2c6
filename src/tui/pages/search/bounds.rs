//! A variable with its bounds, as the setup of a search has it, and how its text is read. No drawing.

use crate::model::units::{self, Bare, significant};
use crate::study::sweep::{Axis, Spacing};
use crate::tui::theme::Role;
use crate::tui::widgets::axis::meaning;
use crate::tui::widgets::form::Line;

/// A variable with its bounds.
#[derive(Clone, Debug, PartialEq)]
pub struct Bound {
    /// The variable, and its bounds as the ends of an axis.
    pub axis: Axis,
    /// It is varied; otherwise held.
    pub on: bool,
}

/// Its row in a form: `0.8..7` or `1e3..7.5e6:log`.
pub(in crate::tui) fn bound_line(bound: &Bound) -> Line {
    let (low, high) = bound.axis.ends();
    let log = if bound.axis.spacing() == Spacing::Log { ":log" } else { "" };
    let range = format!("{}..{}{log}", significant(low, 5), significant(high, 5));
    let shown = if bound.on { range.clone() } else { "held".to_owned() };
    let meaning = meaning(bound.axis.variable());
    Line {
        text: Some(range),
        takes_unit: true,
        role: if bound.on { Role::Text } else { Role::Dim },
        ..Line::word(bound.axis.symbol(), shown)
    }
    .means(format!("{meaning} (Enter: LO..HI, LO..HI:log; h/l held or varied)"))
}

/// Read `0.8..7`, `1e3..7.5e6:log`, with units or without; `off` and `on`.
///
/// # Errors
/// What is wrong with the text.
pub(in crate::tui) fn read_bound(old: &Bound, text: &str) -> Result<Bound, String> {
    if let "on" | "off" = text {
        return Ok(Bound { on: text == "on", ..old.clone() });
    }
    let (range, spacing) = match text.strip_suffix(":log") {
        Some(range) => (range, Spacing::Log),
        None => (text, Spacing::Linear),
    };
    let (low, high) = range.split_once("..").ok_or("write LO..HI, LO..HI:log or off: 0.8..7")?;
    let quantity = old.axis.number().quantity;
    let read = |text: &str| {
        units::parse(text, quantity, Bare::Stored).map_err(|problem| problem.to_string())
    };
    let ends = (read(low)?, read(high)?);
    if let Some(problem) = units::one_bare_end(low, high, quantity) {
        return Err(problem);
    }
    let axis = Axis::new(old.axis.symbol(), ends, old.axis.count(), spacing);
    Ok(Bound { axis: axis.map_err(|error| error.to_string())?, on: true })
}
