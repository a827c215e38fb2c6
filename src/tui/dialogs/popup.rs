//! The dialog on top of the panes: its frame, and which one it is.

use ratatui::layout::Rect;
use ratatui::widgets::{Clear, Widget};

use crate::tui::app::App;
use crate::tui::dialogs::{
    Dialog, List, Picker, ask, export, help, history, options, presets, words,
};
use crate::tui::theme::{PaneFrame, Role};
use crate::tui::widgets::Canvas;
use crate::tui::widgets::text::put;

/// Draw the dialog, if one is open.
pub(in crate::tui) fn render(app: &App, screen: Rect, canvas: &mut Canvas<'_>) {
    match &app.dialog {
        Some(Dialog::List(list, picker)) => {
            let draw = match list {
                List::Help => help::help,
                List::Palette => help::palette,
                List::Presets => presets::render,
                List::History => history::render,
                List::Options => options::render,
                List::Words => words::render,
            };
            draw(app, picker, screen, canvas);
        }
        Some(Dialog::Export(state)) => export::draw::render(app, state, screen, canvas),
        Some(Dialog::Ask(state)) => ask::render(app, state, screen, canvas),
        None => {}
    }
}

/// Clear the middle of the body and draw a frame there, at most this large; gives what is inside, a column of air at each side.
pub(in crate::tui) fn frame(
    app: &App,
    screen: Rect,
    (width, height): (u16, u16),
    (title, right): (&str, &str),
    canvas: &mut Canvas<'_>,
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
    canvas.cover(area);
    Clear.render(area, canvas);
    let inner = PaneFrame::new(title).right(right).focused(true).render(area, canvas, app.theme);
    Rect { x: inner.x + inner.width.min(1), width: inner.width.saturating_sub(2), ..inner }
}

/// The filter of a list in the first row of an area: `/gam_`, or how to search.
pub(in crate::tui) fn filter(app: &App, picker: &Picker, area: Rect, canvas: &mut Canvas<'_>) {
    if picker.typing {
        let end = put(canvas, area, (0, 0), "> ", app.theme.style(Role::Key));
        let room = area.width.saturating_sub(end);
        picker.filter.draw(canvas, Rect { x: area.x + end, width: room, ..area }, app.theme);
    } else {
        put(canvas, area, (0, 0), "/ to search", app.theme.style(Role::Dim));
    }
}
