//! Common elements of pages and dialogs: canvas, single-line fields, tables, text in cells.

pub(crate) mod axis;
pub(crate) mod find;
pub(crate) mod form;
pub(crate) mod input;
pub(crate) mod layout;
mod map;
mod navigation;
pub(crate) mod place;
pub(crate) mod table;
pub(crate) mod text;
pub(crate) mod value_steps;

use std::ops::{Deref, DerefMut};

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Modifier, Style};
use ratatui::text::Line;
use ratatui::widgets::Widget;
use text::columns;

use crate::tui::chart::{Draw, Layout};
use crate::tui::keymap::{Pane, Target};
use crate::tui::theme::{PaneFrame, Role, Theme};
use crate::tui::widgets::text::{TextLine, first_row};

pub(crate) use layout::{split_bottom, split_left, split_top};
pub(crate) use navigation::{along, around, cursor_moved, cycled, moved, rows_moved, step_of};

/// Cells for drawing, with the cursor position and the mouse targets.
pub(crate) struct Canvas<'a> {
    buffer: &'a mut Buffer,
    pub(crate) theme: Theme,
    /// Position of the terminal's cursor, while a field is open.
    pub(crate) cursor: Option<(u16, u16)>,
    /// Start of the selected row that was drawn last.
    pub(crate) selected: Option<(u16, u16)>,
    /// Drawn charts and maps as SVG; `None` if they are not collected.
    pub(crate) pictures: Option<Vec<String>>,
    /// Mouse targets of the drawn cells; `None` if they are not recorded.
    targets: Option<&'a mut Targets>,
}

/// Mouse targets of the cells of a drawn screen.
#[derive(Debug, Default)]
pub struct Targets {
    width: u16,
    cells: Vec<Option<Target>>,
}

impl Targets {
    /// Removes all targets, for a screen of this size.
    fn clear(&mut self, (width, height): (u16, u16)) {
        self.width = width;
        self.cells.clear();
        self.cells.resize(usize::from(width) * usize::from(height), None);
    }

    fn index(&self, (column, row): (u16, u16)) -> Option<usize> {
        (column < self.width)
            .then(|| usize::from(row) * usize::from(self.width) + usize::from(column))
    }

    /// Returns the target at a column and a row; `None` if a click has no effect.
    pub fn at(&self, at: (u16, u16)) -> Option<Target> {
        *self.cells.get(self.index(at)?)?
    }
}

impl<'a> Canvas<'a> {
    /// Creates a canvas over all cells of a buffer.
    pub(crate) fn new(buffer: &'a mut Buffer, theme: Theme) -> Self {
        let (cursor, selected, pictures) = (None, None, None);
        Self { buffer, theme, cursor, selected, pictures, targets: None }
    }

    /// Creates a canvas that records the mouse targets of what it draws.
    pub(crate) fn recorded(buffer: &'a mut Buffer, theme: Theme, targets: &'a mut Targets) -> Self {
        targets.clear((buffer.area.width, buffer.area.height));
        Self { targets: Some(targets), ..Self::new(buffer, theme) }
    }

    /// Draws a text into a row of an area; returns the column after it. Clips to the area.
    pub(crate) fn put(&mut self, area: Rect, at: (u16, u16), text: &str, role: Role) -> u16 {
        self.put_styled(area, at, text, self.theme.style(role))
    }

    pub(crate) fn put_styled(
        &mut self,
        area: Rect,
        (column, row): (u16, u16),
        text: &str,
        style: Style,
    ) -> u16 {
        let area = area.intersection(self.buffer.area);
        if row >= area.height || column >= area.width {
            return column;
        }
        let room = usize::from(area.width - column);
        self.buffer.set_stringn(area.x + column, area.y + row, text, room, style).0 - area.x
    }

    /// Draws consecutive lines, starting at a row, as many as fit.
    pub(crate) fn put_lines(
        &mut self,
        area: Rect,
        from: u16,
        lines: impl IntoIterator<Item = TextLine>,
    ) {
        for (row, (text, role)) in (from..area.height).zip(lines) {
            self.put(area, (0, row), &text, role);
        }
    }

    /// Draws the text of an empty pane in its middle.
    pub(crate) fn put_centred(&mut self, area: Rect, text: &str) {
        let column = area.width.saturating_sub(columns(text)) / 2;
        self.put(area, (column, area.height / 2), text, Role::Dim);
    }

    /// Draws a letter at the foot of a plot, at a gap of a curve.
    pub(crate) fn put_gap(&mut self, layout: &Layout, x: f64, letter: char) {
        if let Some(column) = layout.x.cell(x) {
            let foot = (column, layout.plot.height.saturating_sub(1));
            self.put(layout.plot, foot, &letter.to_string(), Role::Warning);
        }
    }

    pub(crate) fn put_line(&mut self, area: Rect, line: &Line<'_>) {
        line.render(area.intersection(self.buffer.area), self.buffer);
    }

    /// Draws a row as selected.
    pub(crate) fn paint_row(&mut self, row: Rect) {
        self.selected = Some((row.x, row.y));
        let style = self.theme.style(Role::Selection);
        self.buffer.set_style(row.intersection(self.buffer.area), style);
    }

    /// Inverts a cell of a row, also on a selected row.
    pub(crate) fn invert(&mut self, row: Rect, column: u16) {
        let at = (row.x + column, row.y);
        let is_inside = row.contains(at.into()) && self.buffer.area.contains(at.into());
        if let Some(cell) = self.buffer.cell_mut(at).filter(|_| is_inside) {
            cell.modifier.toggle(Modifier::REVERSED);
        }
    }

    /// Draws a chart or a map; returns its layout.
    pub(crate) fn draw(&mut self, picture: &impl Draw, area: Rect) -> Layout {
        if let Some(pictures) = &mut self.pictures {
            pictures.push(picture.svg());
        }
        picture.render(area, self.buffer, self.theme)
    }

    /// Sets the mouse targets of the cells of an area; areas drawn later take precedence.
    pub(crate) fn hit(&mut self, area: Rect, target: impl Fn((u16, u16)) -> Option<Target>) {
        let Some(targets) = &mut self.targets else { return };
        for position in area.intersection(self.buffer.area).positions() {
            let at = (position.x, position.y);
            if let Some((index, target)) = targets.index(at).zip(target(at)) {
                targets.cells[index] = Some(target);
            }
        }
    }

    /// Sets a pane as the mouse target of an area, in addition to its parts.
    pub(crate) fn pane(&mut self, area: Rect, pane: Pane) {
        self.hit(area, |_| Some(Target::Pane(pane)));
    }

    /// Sets the mouse targets of the rows of a list, by index; takes the first visible row and the number of rows.
    pub(crate) fn rows(
        &mut self,
        area: Rect,
        (first, count): (usize, usize),
        target: impl Fn(usize) -> Option<Target>,
    ) {
        self.hit(area, |at| {
            let index = first + usize::from(at.1 - area.y);
            (index < count).then(|| target(index)).flatten()
        });
    }

    /// Sets the mouse targets of the cells of a plot, by axis values.
    pub(crate) fn plot(&mut self, layout: &Layout, target: impl Fn(f64, f64) -> Option<Target>) {
        let plot = layout.plot;
        self.hit(plot, |at| {
            target(layout.x.value(at.0 - plot.x), layout.y.value(plot.bottom() - 1 - at.1))
        });
    }

    /// Removes all previous mouse targets, because a dialog covers them.
    pub(crate) fn cover(&mut self) {
        if let Some(targets) = &mut self.targets {
            targets.cells.fill(None);
        }
    }
}

impl Deref for Canvas<'_> {
    type Target = Buffer;

    fn deref(&self) -> &Buffer {
        self.buffer
    }
}

impl DerefMut for Canvas<'_> {
    fn deref_mut(&mut self) -> &mut Buffer {
        self.buffer
    }
}

impl PaneFrame<'_> {
    pub(crate) fn draw(&self, area: Rect, canvas: &mut Canvas<'_>) -> Rect {
        self.render(area, canvas.buffer, canvas.theme)
    }
}

/// Number of rows of a list or form, the selected row, and the number of visible rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Rows {
    pub count: usize,
    pub selected: usize,
    pub shown: usize,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct RowList {
    pub count: usize,
    /// Selected row, kept visible.
    pub selected: usize,
    pub painted: bool,
}

impl RowList {
    pub(crate) fn first(self, height: u16) -> usize {
        first_row(self.selected, usize::from(height), self.count)
    }

    /// Draws the visible rows: `draw` draws a row at its screen row; `target` returns its mouse target.
    pub(crate) fn render(
        self,
        canvas: &mut Canvas<'_>,
        area: Rect,
        target: impl Fn(usize) -> Option<Target>,
        mut draw: impl FnMut(&mut Canvas<'_>, Rect, usize),
    ) {
        let first = self.first(area.height);
        for (row, index) in area.rows().zip(first..self.count) {
            draw(canvas, row, index);
            if self.painted && index == self.selected {
                canvas.paint_row(row);
            }
        }
        canvas.rows(area, (first, self.count), target);
    }
}
