//! Small helpers for writing text into cells.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use ratatui::text::{Line, Span};

/// What stands in a tab that studies one plate while the scene is a stack.
pub(super) const NEEDS_SINGLE: &str = "this tab needs a single plate";

/// The rows of a list as they are drawn.
#[derive(Clone, Copy)]
pub(super) struct Rows {
    /// Where they stand.
    pub area: Rect,
    /// The index of the first one shown.
    pub first: usize,
    /// How many there are in all.
    pub count: usize,
}

impl Rows {
    /// The index of the row at a cell of the screen.
    pub(super) fn at(self, at: (u16, u16)) -> Option<usize> {
        let index = self.first + usize::from(at.1.saturating_sub(self.area.y));
        (self.area.contains(at.into()) && index < self.count).then_some(index)
    }
}

/// The columns a text takes.
pub(super) fn columns(text: &str) -> u16 {
    u16::try_from(Span::raw(text).width()).unwrap_or(u16::MAX)
}

/// Write a text into a row of an area; gives the column after it. Rows and columns outside the area are left alone.
pub(super) fn put(
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

/// Write a line into a row of an area.
pub(super) fn put_line(buffer: &mut Buffer, area: Rect, row: u16, line: &Line<'_>) {
    let area = area.intersection(buffer.area);
    if row < area.height {
        buffer.set_line(area.x, area.y + row, line, area.width);
    }
}

/// Give a whole row of an area a style.
pub(super) fn paint_row(buffer: &mut Buffer, area: Rect, row: u16, style: Style) {
    if row < area.height {
        let row = Rect::new(area.x, area.y + row, area.width, 1);
        buffer.set_style(row.intersection(buffer.area), style);
    }
}

/// The first row of a list to show so that the selected one is in sight.
pub(super) fn first_row(selected: usize, height: usize, count: usize) -> usize {
    let most = count.saturating_sub(height);
    selected.saturating_sub(height.saturating_sub(1) * 2 / 3).min(most)
}
