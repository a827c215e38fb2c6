//! Small helpers for writing text into cells.

use ratatui::buffer::Buffer;
use ratatui::style::Style;

use crate::tui::app::status::wrap;
use crate::tui::prelude::*;
use crate::tui::theme;

/// The text of a tab that studies one plate while the scene is a stack.
pub(crate) const NEEDS_SINGLE: &str = "this tab needs a single plate";

pub(crate) fn text_role(severity: Severity) -> Role {
    match severity {
        Severity::Note => Role::Text,
        Severity::Warning => Role::Warning,
        Severity::Error => Role::Error,
    }
}

pub(crate) fn columns(text: &str) -> u16 {
    u16::try_from(theme::columns(text)).unwrap_or(u16::MAX)
}

/// Write a text into a row of an area; gives the column after it. Rows and columns outside the area are left alone.
pub(crate) fn put(
    buffer: &mut Buffer,
    area: Rect,
    at: (u16, u16),
    text: &str,
    style: Style,
) -> u16 {
    let (column, row) = at;
    let area = area.intersection(buffer.area);
    if row >= area.height || column >= area.width {
        return column;
    }
    let room = usize::from(area.width - column);
    let end = buffer.set_stringn(area.x + column, area.y + row, text, room, style).0;
    end - area.x
}

/// A line of text, and how it is drawn.
pub(crate) type TextLine = (String, Role);

/// Lines over as many rows of this many columns as each needs; a line that fits keeps its blanks.
pub(crate) fn broken(lines: Vec<TextLine>, width: usize) -> Vec<TextLine> {
    let parts = |(text, role): TextLine| {
        let fits = theme::columns(&text) <= width;
        let parts = if fits { vec![text] } else { wrap(&text, width) };
        parts.into_iter().map(move |part| (part, role))
    };
    lines.into_iter().flat_map(parts).collect()
}

/// The lines of a text of at most this many columns, all in one role.
pub(crate) fn wrapped(
    text: &str,
    width: u16,
    role: Role,
) -> impl Iterator<Item = TextLine> + use<> {
    wrap(text, usize::from(width)).into_iter().map(move |line| (line, role))
}

/// The first row of a list to show so that the selected one is in sight.
pub(crate) fn first_row(selected: usize, height: usize, count: usize) -> usize {
    let most = count.saturating_sub(height);
    selected.saturating_sub(height.saturating_sub(1) * 2 / 3).min(most)
}
