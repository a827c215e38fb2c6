//! Where the panes of the Limit tab stand.

use ratatui::layout::Rect;

use crate::tui::app::App;
use crate::tui::app::layout::{NARROW, split_bottom, split_left};
use crate::tui::keymap::Pane;
use crate::tui::pages::limit::{COMPARISON, EFFICIENCY_MAP, RESIDUAL};

/// The panes of the Limit tab: those that have room.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct LimitPanes {
    /// The comparison at equal areal mass.
    pub comparison: Option<Rect>,
    /// The residual velocity, and the limit in words.
    pub residual: Option<Rect>,
    /// The map of mass efficiency.
    pub map: Option<Rect>,
}

/// Where they stand on the screen as it is.
pub(crate) fn panes(app: &App, body: Rect) -> LimitPanes {
    limit(body, app.pane(), app.is_full())
}

/// The comparison above the residual velocity and the map; the pane that has the keys alone where there is no room for three.
fn limit(body: Rect, focus: Pane, full_pane: bool) -> LimitPanes {
    let rows = if body.height < ROOM_FOR_FIGURES { VERDICT_ROWS } else { COMPARISON_ROWS };
    let alone = full_pane || body.height < rows + 8;
    if alone {
        let of = |pane| (focus == pane).then_some(body);
        return LimitPanes {
            comparison: of(COMPARISON),
            residual: of(RESIDUAL),
            map: of(EFFICIENCY_MAP),
        };
    }
    let (comparison, below) = split_bottom(body, body.height - rows);
    if body.width < NARROW {
        let map = focus == EFFICIENCY_MAP;
        return LimitPanes {
            comparison: Some(comparison),
            residual: (!map).then_some(below),
            map: map.then_some(below),
        };
    }
    let (left, right) = split_left(below, below.width / 2);
    LimitPanes { comparison: Some(comparison), residual: Some(left), map: Some(right) }
}

/// Rows of the comparison, frame included; of the verdict alone where the body is lower than this, so that charts can be read.
const COMPARISON_ROWS: u16 = 10;
const VERDICT_ROWS: u16 = 6;
const ROOM_FOR_FIGURES: u16 = 26;
