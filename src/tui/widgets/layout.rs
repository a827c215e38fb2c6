//! Where the rows and the body of the screen stand: a total function of the size.

use ratatui::layout::{self, Constraint, Rect};

/// The smallest size that can be worked with: columns and rows.
pub(crate) const SMALLEST: (u16, u16) = (60, 16);

/// Least rows of a chart that can be read.
pub(crate) const CHART_ROWS: u16 = 9;
/// Below this width the setup and what it is about get in each other's way.
pub(crate) const NARROW: u16 = 72;
/// From this width on a setup has room for long words.
pub(crate) const WIDE: u16 = 100;
/// From this width on names of runs stand in full beside their results.
pub(crate) const ROOMY: u16 = 120;

/// From this height on the names of the pages have a row.
const WITH_PAGES: u16 = 18;

/// From this height on messages have two rows: always the same number, so that the panes never move.
const TWO_MESSAGE_ROWS: u16 = 20;

/// Where everything stands that every tab has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Layout {
    /// Tabs and preset.
    pub title: Rect,
    /// The names of the tab's pages, where it has several.
    pub pages: Option<Rect>,
    /// The panes; `None` where nothing fits.
    pub body: Option<Rect>,
    pub message: Rect,
    pub status: Rect,
    pub keys: Rect,
}

/// Where everything stands at a size, for a tab with several pages or one, with a row for hints or without.
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

/// Columns of a setup beside what it is about, in a body so wide.
pub(crate) fn setup_width(width: u16) -> u16 {
    match width {
        0..NARROW => 24,
        NARROW..WIDE => 27,
        WIDE.. => 34,
    }
}

/// The columns at the left, at most this many, and the rest.
pub(crate) fn split_left(area: Rect, width: u16) -> (Rect, Rect) {
    let width = width.min(area.width);
    (Rect { width, ..area }, Rect { x: area.x + width, width: area.width - width, ..area })
}

/// The rows at the top, at most so many, and the rest.
pub(crate) fn split_top(area: Rect, height: u16) -> (Rect, Rect) {
    split_bottom(area, area.height.saturating_sub(height))
}

/// The rows above, and those at the bottom, at most this many.
pub(crate) fn split_bottom(area: Rect, height: u16) -> (Rect, Rect) {
    let height = height.min(area.height);
    let top = Rect { height: area.height - height, ..area };
    (top, Rect { y: area.y + area.height - height, height, ..area })
}
