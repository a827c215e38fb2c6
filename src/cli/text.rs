//! Layout of pages for the width of the terminal, or for 80 columns without a terminal.

use std::io::{self, IsTerminal as _};

use crate::cli::draw;
use cmra_studies::report::wrap::wrap;

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

/// Limits the width of a chart to that of the page.
pub(super) fn chart_size((columns, rows): draw::Size) -> draw::Size {
    (columns.min(u16::try_from(width()).unwrap_or(columns)), rows)
}

/// Formats a lead and a text, wrapped with a hanging indent.
pub(super) fn hanging(lead: &str, text: &str, indent: usize) -> String {
    let room = width().saturating_sub(indent.max(lead.chars().count()));
    let words: Vec<&str> = text.split_whitespace().collect();
    let lines = wrap(&words.join(" "), room);
    format!("{lead}{}\n", lines.join(&format!("\n{:indent$}", "")))
}

/// Appends lines of a label and a text; skips empty texts.
pub(super) fn labelled_each(page: &mut String, lines: &[(&str, impl AsRef<str>)]) {
    for (label, text) in lines.iter().filter(|(_, text)| !text.as_ref().is_empty()) {
        page.push_str(&hanging(&format!("    {label:<12}"), text.as_ref(), 16));
    }
}

/// Wraps the lines of a page. A long line continues below its last column if that starts in the left half of the page, else indented.
pub(super) fn fitted(page: &str) -> String {
    let room = width();
    let fitted = |line: &str| {
        if line.chars().count() <= room {
            return line.to_owned();
        }
        let word_from = |at: usize| line.len() - line[at..].trim_start().len();
        let half = line.char_indices().nth(room / 2).map_or(line.len(), |(at, _)| at);
        let column = line[..half].rfind("  ").map_or(0, word_from);
        let is_column = column > word_from(0) && column <= half;
        let (lead, text) = line.split_at(if is_column { column } else { word_from(0) });
        let first = wrap(text, room.saturating_sub(lead.chars().count())).swap_remove(0);
        let rest = text[first.len()..].trim_start();
        let indent = lead.chars().count() + if is_column { 0 } else { 2 };
        let rest = wrap(rest, room.saturating_sub(indent)).join(&format!("\n{:indent$}", ""));
        format!("{lead}{first}\n{:indent$}{rest}", "")
    };
    let lines: Vec<String> = page.lines().map(fitted).collect();
    lines.join("\n") + if page.ends_with('\n') { "\n" } else { "" }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Tests have no terminal: 80 columns.
    #[test]
    fn a_long_line_continues_below_its_last_column() {
        let words = ["word"; 30].join(" ");
        let wide = format!("name{:50}", "");
        for (lead, indent) in [("  name    ", 10), ("    ", 6), ("", 2), (wide.as_str(), 2)] {
            let text = format!("short\n{lead}{words}\n");
            let page = fitted(&text);
            assert!(page.lines().all(|line| line.len() <= DEFAULT_WIDTH), "{page}");
            let second = page.lines().nth(2).unwrap();
            assert_eq!(second.len() - second.trim_start().len(), indent);
            let all = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
            assert_eq!(all(&page), all(&text));
        }
    }
}
