//! Parts that several pages and dialogs are made of: the canvas they draw on, one-line fields, tables, text in cells.

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

/// The cells that are drawn on, and what the drawing says beside: where the cursor stands, and what is under the mouse.
pub(crate) struct Canvas<'a> {
    buffer: &'a mut Buffer,
    pub(crate) theme: Theme,
    /// Where the terminal's cursor stands, while a field is open.
    pub(crate) cursor: Option<(u16, u16)>,
    /// Where the selected row begins, of what was drawn last.
    pub(crate) selected: Option<(u16, u16)>,
    /// The charts and maps drawn, as SVG, where they are collected.
    pub(crate) pictures: Option<Vec<String>>,
    pointer: Option<(u16, u16)>,
    target: Option<Target>,
}

impl<'a> Canvas<'a> {
    /// A canvas over all cells of a buffer.
    pub(crate) fn new(buffer: &'a mut Buffer, theme: Theme) -> Self {
        let (cursor, selected, pictures) = (None, None, None);
        let (pointer, target) = (None, None);
        Self { buffer, theme, cursor, selected, pictures, pointer, target }
    }

    /// Builds a canvas that finds the item drawn at a cell.
    pub(crate) fn pointed(buffer: &'a mut Buffer, theme: Theme, at: (u16, u16)) -> Self {
        Self { pointer: Some(at), ..Self::new(buffer, theme) }
    }

    /// Write a text into a row of an area; gives the column after it. Rows and columns outside the area are left alone.
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

    /// Write lines below each other from a row on, as many as have room.
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

    /// Write what stands in the middle of an area that has nothing to show yet.
    pub(crate) fn put_centred(&mut self, area: Rect, text: &str) {
        let column = area.width.saturating_sub(columns(text)) / 2;
        self.put(area, (column, area.height / 2), text, Role::Dim);
    }

    /// Write a letter at the foot of a plot, where a curve has a gap.
    pub(crate) fn put_gap(&mut self, layout: &Layout, x: f64, letter: char) {
        if let Some(column) = layout.x.cell(x) {
            let foot = (column, layout.plot.height.saturating_sub(1));
            self.put(layout.plot, foot, &letter.to_string(), Role::Warning);
        }
    }

    pub(crate) fn put_line(&mut self, area: Rect, line: &Line<'_>) {
        line.render(area.intersection(self.buffer.area), self.buffer);
    }

    /// Show a row as the selected one.
    pub(crate) fn paint_row(&mut self, row: Rect) {
        self.selected = Some((row.x, row.y));
        let style = self.theme.style(Role::Selection);
        self.buffer.set_style(row.intersection(self.buffer.area), style);
    }

    /// Invert a cell of a row, on a selected row too.
    pub(crate) fn invert(&mut self, row: Rect, column: u16) {
        let at = (row.x + column, row.y);
        let is_inside = row.contains(at.into()) && self.buffer.area.contains(at.into());
        if let Some(cell) = self.buffer.cell_mut(at).filter(|_| is_inside) {
            cell.modifier.toggle(Modifier::REVERSED);
        }
    }

    /// Draw a chart or a map, and tell where everything lies.
    pub(crate) fn draw(&mut self, picture: &impl Draw, area: Rect) -> Layout {
        if let Some(pictures) = &mut self.pictures {
            pictures.push(picture.svg());
        }
        picture.render(area, self.buffer, self.theme)
    }

    /// The target under the pointer; `None` where a click has no effect.
    pub(crate) fn target(&self) -> Option<Target> {
        self.target
    }

    /// Say what an area is to the mouse; what is drawn later lies over it.
    pub(crate) fn hit(&mut self, area: Rect, target: impl FnOnce((u16, u16)) -> Option<Target>) {
        if let Some(at) = self.pointer.filter(|at| area.contains((*at).into())) {
            self.target = target(at).or(self.target);
        }
    }

    /// Say that an area is a pane, beside its parts.
    pub(crate) fn pane(&mut self, area: Rect, pane: Pane) {
        self.hit(area, |_| Some(Target::Pane(pane)));
    }

    /// Say what the rows of a list are, by their index: the first one shown, and how many there are.
    pub(crate) fn rows(
        &mut self,
        area: Rect,
        (first, count): (usize, usize),
        target: impl FnOnce(usize) -> Option<Target>,
    ) {
        self.hit(area, |at| {
            let index = first + usize::from(at.1 - area.y);
            (index < count).then(|| target(index)).flatten()
        });
    }

    /// Say what the cells of a plot are, by the values of its axes.
    pub(crate) fn plot(
        &mut self,
        layout: &Layout,
        target: impl FnOnce(f64, f64) -> Option<Target>,
    ) {
        let plot = layout.plot;
        self.hit(plot, |at| {
            target(layout.x.value(at.0 - plot.x), layout.y.value(plot.bottom() - 1 - at.1))
        });
    }

    /// A dialog takes all clicks from what is drawn so far.
    pub(crate) fn cover(&mut self) {
        self.target = None;
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

/// How many rows a list or a form has, which is selected, and how many are shown at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Rows {
    pub count: usize,
    pub selected: usize,
    pub shown: usize,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct RowList {
    pub count: usize,
    /// The row that is kept in sight.
    pub selected: usize,
    pub painted: bool,
}

impl RowList {
    pub(crate) fn first(self, height: u16) -> usize {
        first_row(self.selected, usize::from(height), self.count)
    }

    /// Draw the rows that have room: `draw` draws one into the row of the screen it is given; `target` is what a click on it means.
    pub(crate) fn render(
        self,
        canvas: &mut Canvas<'_>,
        area: Rect,
        target: impl FnOnce(usize) -> Option<Target>,
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
