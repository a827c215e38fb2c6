//! The dialog on top of the panes: its frame, and which one it is.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::widgets::{Clear, Widget};

use super::text::{Rows, put, window};
use super::{Cursor, export, help, history, options, presets, save, words};
use crate::tui::app::App;
use crate::tui::app::dialog::{Dialog, Picker};
use crate::tui::theme::{PaneFrame, Role};

/// Draw the dialog, if one is open; gives where the rows of its list lie, if it has one.
pub(super) fn render(
    app: &App,
    screen: Rect,
    buffer: &mut Buffer,
    cursor: &mut Cursor,
) -> Option<Rows> {
    match &app.dialog {
        Some(Dialog::Help(picker)) => return Some(help::help(app, picker, screen, buffer, cursor)),
        Some(Dialog::Palette(picker)) => {
            return Some(help::palette(app, picker, screen, buffer, cursor));
        }
        Some(Dialog::Presets(picker)) => {
            return Some(presets::render(app, picker, screen, buffer, cursor));
        }
        Some(Dialog::History(picker)) => {
            return Some(history::render(app, picker, screen, buffer));
        }
        Some(Dialog::Options(picker)) => return Some(options::render(app, picker, screen, buffer)),
        Some(Dialog::Words(picker)) => return Some(words::render(app, picker, screen, buffer)),
        Some(Dialog::Export(state)) => {
            return Some(export::render(app, state, screen, buffer, cursor));
        }
        Some(Dialog::Save(state)) => save::render(app, state, screen, buffer, cursor),
        Some(Dialog::ExportTable(table, state)) => {
            let titles = (table.title(), "Enter writes");
            save::path(app, state, (screen, titles), buffer, cursor);
        }
        Some(Dialog::Curve(second, state)) => {
            save::curve(app, (*second, state), screen, buffer, cursor);
        }
        None => {}
    }
    None
}

/// Clear the middle of the body and draw a frame there, at most this large; gives what is inside, a column of air at each side.
pub(super) fn frame(
    app: &App,
    screen: Rect,
    (width, height): (u16, u16),
    (title, right): (&str, &str),
    buffer: &mut Buffer,
) -> Rect {
    // Title row above, message, status and keys below stay in sight.
    let body = Rect {
        y: screen.y + screen.height.min(1),
        height: screen.height.saturating_sub(4),
        ..screen
    };
    let width = width.min(body.width);
    let height = height.min(body.height);
    let area = Rect {
        x: body.x + (body.width - width) / 2,
        y: body.y + (body.height - height) / 2,
        width,
        height,
    };
    Clear.render(area, buffer);
    let inner = PaneFrame::new(title).right(right).focused(true).render(area, buffer, app.theme);
    Rect { x: inner.x + inner.width.min(1), width: inner.width.saturating_sub(2), ..inner }
}

/// The filter of a list in the first row of an area: `/gam_`, or how to search.
pub(super) fn filter(
    app: &App,
    picker: &Picker,
    area: Rect,
    buffer: &mut Buffer,
    cursor: &mut Cursor,
) {
    if picker.typing {
        let end = put(buffer, area, (0, 0), "> ", app.theme.style(Role::Key));
        let (shown, at) = window(&picker.filter, area.width.saturating_sub(end));
        put(buffer, area, (end, 0), &shown, app.theme.style(Role::Text));
        *cursor = Some((area.x + (end + at).min(area.width.saturating_sub(1)), area.y));
    } else {
        put(buffer, area, (0, 0), "/ to search", app.theme.style(Role::Dim));
    }
}
