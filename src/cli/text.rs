//! Pages as wide as the terminal, or 80 columns where there is none.

use std::io::{self, IsTerminal as _};

use crate::tui::app::status::wrap;

/// Columns of a page that is no terminal's, and the most and the fewest of any.
const USUAL: usize = 80;
const WIDTHS: (usize, usize) = (40, 120);

/// Columns to write for.
pub(super) fn width() -> usize {
    if !io::stdout().is_terminal() {
        return USUAL;
    }
    let size = crossterm::terminal::size().map_or(USUAL, |size| usize::from(size.0));
    size.clamp(WIDTHS.0, WIDTHS.1)
}

/// A text after a lead, in as many lines as it needs; those after the first are indented.
pub(super) fn hanging(lead: &str, text: &str, indent: usize) -> String {
    let room = width().saturating_sub(indent.max(lead.chars().count()));
    let words: Vec<&str> = text.split_whitespace().collect();
    let lines = wrap(&words.join(" "), room);
    format!("{lead}{}\n", lines.join(&format!("\n{:indent$}", "")))
}

/// A label in a column of its own, and a text beside it.
pub(super) fn labelled(page: &mut String, label: &str, text: &str) {
    page.push_str(&hanging(&format!("    {label:<12}"), text, 16));
}
