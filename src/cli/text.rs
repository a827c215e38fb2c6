//! Layout of pages for the width of the terminal, or for 80 columns without a terminal.

use std::io::{self, IsTerminal as _};

use crate::tui::plain::{self, TextStyle};
use cmra_studies::report::page::Page;

/// Columns of a page that is written to a file or a pipe.
const DEFAULT_WIDTH: usize = 80;
/// Minimum and maximum number of columns of a page.
const WIDTHS: (usize, usize) = (40, 120);

/// Returns `true` if standard output is a terminal.
pub(super) fn is_screen() -> bool {
    io::stdout().is_terminal()
}

/// Returns the number of columns of a page.
pub(super) fn width() -> usize {
    if !is_screen() {
        return DEFAULT_WIDTH;
    }
    let size = crossterm::terminal::size().map_or(DEFAULT_WIDTH, |size| usize::from(size.0));
    size.clamp(WIDTHS.0, WIDTHS.1)
}

/// Writes a report as text.
pub(super) fn plain(page: &Page, style: TextStyle) -> String {
    plain::lines(page, style).into_iter().fold(String::new(), |text, (line, _)| text + &line + "\n")
}

/// Formats a lead and a text, wrapped with a hanging indent.
pub(super) fn hanging(lead: &str, text: &str, indent: usize) -> String {
    plain::hanging(lead, text, indent, width()).join("\n") + "\n"
}
