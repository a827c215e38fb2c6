//! Parts that several pages and dialogs are made of: the canvas they draw on, one-line fields, tables, text in cells.

use std::ops::{Deref, DerefMut};

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::tui::chart::Layout;
use crate::tui::keymap::Pane;
use crate::tui::message::Target;

pub(in crate::tui) mod axis;
pub(in crate::tui) mod form;
pub(in crate::tui) mod input;
pub(in crate::tui) mod list;
pub(in crate::tui) mod table;
pub(in crate::tui) mod text;

/// The cells that are drawn on, and what the drawing says beside: where the cursor stands, and what is under the mouse.
pub(in crate::tui) struct Canvas<'a> {
    buffer: &'a mut Buffer,
    /// Where the terminal's cursor stands, while a field is open.
    pub(in crate::tui) cursor: Option<(u16, u16)>,
    /// Columns of the plot that the crosshair walks through, where one is drawn.
    pub(in crate::tui) plot_columns: Option<u16>,
    pointer: Option<(u16, u16)>,
    target: Option<Target>,
}

impl<'a> Canvas<'a> {
    /// A canvas over all cells of a buffer.
    pub(in crate::tui) fn new(buffer: &'a mut Buffer) -> Self {
        Self { buffer, cursor: None, plot_columns: None, pointer: None, target: None }
    }

    /// The same, to learn what is drawn at a cell.
    pub(in crate::tui) fn pointed(buffer: &'a mut Buffer, at: (u16, u16)) -> Self {
        Self { pointer: Some(at), ..Self::new(buffer) }
    }

    /// What is under the pointer; `None` where a click means nothing.
    pub(in crate::tui) fn target(&self) -> Option<Target> {
        self.target
    }

    /// Say what an area is to the mouse; what is drawn later lies over it.
    pub(in crate::tui) fn hit(
        &mut self,
        area: Rect,
        target: impl FnOnce((u16, u16)) -> Option<Target>,
    ) {
        if let Some(at) = self.pointer.filter(|at| area.contains((*at).into())) {
            self.target = target(at).or(self.target);
        }
    }

    /// Say that an area is a pane, beside its parts.
    pub(in crate::tui) fn pane(&mut self, area: Rect, pane: Pane) {
        self.hit(area, |_| Some(Target::Pane(pane)));
    }

    /// Say what the rows of a list are, by their index: the first one shown, and how many there are.
    pub(in crate::tui) fn rows(
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
    pub(in crate::tui) fn plot(
        &mut self,
        layout: &Layout,
        target: impl FnOnce(f64, f64) -> Option<Target>,
    ) {
        let plot = layout.plot;
        self.hit(plot, |at| {
            target(layout.x.value(at.0 - plot.x), layout.y.value(plot.bottom() - 1 - at.1))
        });
    }

    /// Say what the points of a plot are, by their index: the one drawn nearest counts.
    pub(in crate::tui) fn points(
        &mut self,
        layout: &Layout,
        points: impl Iterator<Item = Option<(f64, f64)>>,
        target: impl FnOnce(usize) -> Target,
    ) {
        let plot = layout.plot;
        self.hit(plot, |at| {
            let (across, up) = (f64::from(at.0 - plot.x), f64::from(plot.bottom() - 1 - at.1));
            let away = |(x, y): (f64, f64)| {
                let (x, y) = layout.x.position(x).zip(layout.y.position(y))?;
                // A cell is twice as high as wide.
                Some((x - across).powi(2) + 4.0 * (y - up).powi(2))
            };
            let near = points.enumerate().filter_map(|(index, point)| Some((index, away(point?)?)));
            near.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(index, _)| target(index))
        });
    }

    /// A dialog covers all that is drawn so far: beside it a click closes it, in it nothing is hit yet.
    pub(in crate::tui) fn cover(&mut self, area: Rect) {
        if let Some(at) = self.pointer {
            self.target = (!area.contains(at.into())).then_some(Target::Beside);
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
