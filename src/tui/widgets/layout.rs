//! Layout of the rows and the body of the screen, for every size.

use ratatui::layout::{self, Constraint, Rect};

/// Minimum screen size, columns and rows.
pub(crate) const SMALLEST: (u16, u16) = (60, 16);

/// Minimum rows of a readable chart.
pub(crate) const CHART_ROWS: u16 = 9;
/// Minimum width for a setup and its results side by side.
pub(crate) const NARROW: u16 = 72;
/// Minimum width for long labels in a setup.
pub(crate) const WIDE: u16 = 100;
/// Minimum width for full names of runs beside their results.
pub(crate) const ROOMY: u16 = 120;

/// Minimum height for a row with the names of the pages.
const WITH_PAGES: u16 = 18;

/// Minimum height for two message rows. The number is constant, so that the panes do not move.
const TWO_MESSAGE_ROWS: u16 = 20;

/// Areas common to all tabs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Layout {
    /// Row of tabs and preset.
    pub title: Rect,
    /// Row of the names of the tab's pages, if there are several.
    pub pages: Option<Rect>,
    /// Area of the panes; `None` if the screen is too small.
    pub body: Option<Rect>,
    pub message: Rect,
    pub status: Rect,
    pub keys: Rect,
}

/// Computes the layout for a screen size, a tab with one or several pages, and an optional row for hints.
pub(crate) fn layout((width, height): (u16, u16), has_pages: bool, has_hint: bool) -> Layout {
    let messages = if height < TWO_MESSAGE_ROWS || !has_hint { 1 } else { 2 };
    // On the lowest screens the frame of the pane names the page.
    let with_pages = has_pages && height >= WITH_PAGES;
    let rows = layout::Layout::vertical([
        Constraint::Length(1),
        Constraint::Length(u16::from(with_pages)),
        Constraint::Fill(1),
        Constraint::Length(messages),
        Constraint::Length(1),
        Constraint::Length(1),
    ]);
    let [title, pages, body, message, status, keys] = rows.areas(Rect::new(0, 0, width, height));
    Layout {
        title,
        pages: with_pages.then_some(pages),
        body: (width >= SMALLEST.0 && height >= SMALLEST.1).then_some(body),
        message,
        status,
        keys,
    }
}

/// Returns the width of a setup beside its results, in a body of this width.
pub(crate) fn setup_width(width: u16) -> u16 {
    match width {
        0..NARROW => 24,
        NARROW..WIDE => 27,
        WIDE.. => 34,
    }
}

/// Splits off the left columns, at most this many; returns them and the rest.
pub(crate) fn split_left(area: Rect, width: u16) -> (Rect, Rect) {
    let width = width.min(area.width);
    (Rect { width, ..area }, Rect { x: area.x + width, width: area.width - width, ..area })
}

/// Splits off the top rows, at most this many; returns them and the rest.
pub(crate) fn split_top(area: Rect, height: u16) -> (Rect, Rect) {
    split_bottom(area, area.height.saturating_sub(height))
}

/// Splits off the bottom rows, at most this many; returns the rest and them.
pub(crate) fn split_bottom(area: Rect, height: u16) -> (Rect, Rect) {
    let height = height.min(area.height);
    let top = Rect { height: area.height - height, ..area };
    (top, Rect { y: area.y + area.height - height, height, ..area })
}
