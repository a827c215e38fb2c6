//! Where the panes of the Explore tab stand.

use ratatui::layout::Rect;

use crate::tui::app::App;
use crate::tui::app::layout::{ROOMY, setup_width, split_bottom, split_left};
use crate::tui::keymap::Pane;
use crate::tui::pages::explore::SETUP;
use crate::tui::pages::explore::state::Picture;

/// The panes of the Explore tab.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct SweepPanes {
    /// Axes, output, held variables.
    pub setup: Option<Rect>,
    /// One chart or two, or the map.
    pub plots: Vec<Rect>,
    /// The scale of the map.
    pub scale: Option<Rect>,
    /// The slices through the cursor, along and up.
    pub slices: Vec<Rect>,
}

/// Where they stand on the screen as it is.
pub(crate) fn panes(app: &App, body: Rect) -> SweepPanes {
    match app.picture() {
        Picture::Line => lines(body, app.pane(), app.is_full()),
        Picture::Surface => surface(body, app.pane(), app.is_full()),
    }
}

/// The setup beside one chart, or two where there is room.
fn lines(body: Rect, focus: Pane, full_pane: bool) -> SweepPanes {
    if full_pane && focus == SETUP {
        return SweepPanes { setup: Some(body), ..SweepPanes::default() };
    }
    let (setup, rest) = if full_pane {
        (None, body)
    } else {
        let (left, right) = split_left(body, setup_width(body.width));
        (Some(left), right)
    };
    let plots = if rest.height >= 26 {
        let (top, bottom) = split_bottom(rest, rest.height / 2);
        vec![top, bottom]
    } else {
        vec![rest]
    };
    SweepPanes { setup, plots, ..SweepPanes::default() }
}

/// The map; setup at its left, scale and slices at its right. On a narrow screen the pane at the left is the one that is of
/// use: the setup while it has the keys, else scale and slices.
fn surface(body: Rect, focus: Pane, full_pane: bool) -> SweepPanes {
    let on_setup = focus == SETUP;
    if full_pane && on_setup {
        return SweepPanes { setup: Some(body), ..SweepPanes::default() };
    }
    if full_pane {
        return SweepPanes { plots: vec![body], ..SweepPanes::default() };
    }
    let (left, rest) = split_left(body, setup_width(body.width));
    if body.width < ROOMY && on_setup {
        return SweepPanes { setup: Some(left), plots: vec![rest], ..SweepPanes::default() };
    }
    let (setup, map, side) = if body.width < ROOMY {
        (None, rest, left)
    } else {
        let (map, side) = split_left(rest, rest.width - 32.min(rest.width));
        (Some(left), map, side)
    };
    // Ten bands and the marks, within a frame; what is left goes to the slices, one where two would be too low.
    let (scale, below) = split_bottom(side, side.height - side.height.min(13));
    let slices = match below.height {
        0..=5 => Vec::new(),
        6..=15 => vec![below],
        _ => {
            let (top, bottom) = split_bottom(below, below.height / 2);
            vec![top, bottom]
        }
    };
    SweepPanes { setup, plots: vec![map], scale: Some(scale), slices }
}
