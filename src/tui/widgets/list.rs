//! A list: rows below each other, the selected one in sight, what lies under the mouse noted.

use ratatui::layout::Rect;

use crate::tui::message::Target;
use crate::tui::theme::{Role, Theme};
use crate::tui::widgets::Canvas;
use crate::tui::widgets::text::{first_row, paint_row};

/// What of a list is shown.
#[derive(Clone, Copy, Debug)]
pub(in crate::tui) struct List {
    /// How many rows there are.
    pub count: usize,
    /// The row that is kept in sight.
    pub selected: usize,
    /// Whether it is painted as selected.
    pub painted: bool,
}

impl List {
    /// The first row shown in so many rows of the screen.
    pub(in crate::tui) fn first(self, height: u16) -> usize {
        first_row(self.selected, usize::from(height), self.count)
    }

    /// Draw the rows that have room: `draw` draws one into the row of the screen it is given; `target` is what a click on it means.
    pub(in crate::tui) fn render(
        self,
        canvas: &mut Canvas<'_>,
        area: Rect,
        theme: Theme,
        target: impl FnOnce(usize) -> Option<Target>,
        mut draw: impl FnMut(&mut Canvas<'_>, Rect, usize),
    ) {
        let first = self.first(area.height);
        for (row, index) in area.rows().zip(first..self.count) {
            draw(canvas, row, index);
            if self.painted && index == self.selected {
                paint_row(canvas, row, 0, theme.style(Role::Selection));
            }
        }
        canvas.rows(area, (first, self.count), target);
    }

    /// The same in a dialog.
    pub(in crate::tui) fn in_dialog(
        self,
        canvas: &mut Canvas<'_>,
        area: Rect,
        theme: Theme,
        draw: impl FnMut(&mut Canvas<'_>, Rect, usize),
    ) {
        self.render(canvas, area, theme, |row| Some(Target::DialogRow(row)), draw);
    }
}
