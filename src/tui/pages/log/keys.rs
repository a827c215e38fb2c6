//! The Log tab: scrolling.

use crate::tui::app::App;
use crate::tui::keymap::Action;
use crate::tui::message::Effect;
use crate::tui::update::act::rows_moved;

/// What an action does here; `None` where it means nothing of its own.
pub(in crate::tui) fn act(app: &mut App, action: Action) -> Option<Vec<Effect>> {
    let rows = app.list_rows();
    let by = rows_moved(action, rows)?;
    let most = app.log_lines(usize::from(app.size.0)).len().saturating_sub(rows);
    app.log_scroll = app.log_scroll.saturating_add_signed(by).min(most);
    Some(Vec::new())
}
