//! The screen: five regions, panes, and a dialog on top. Reads the state, changes nothing.

use ratatui::Frame;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::tui::app::App;
use crate::tui::app::layout::SMALLEST;
use crate::tui::dialogs::popup;
use crate::tui::message::Target;
use crate::tui::pages;
use crate::tui::theme::{GlyphSet, Role, ascii_pass};
use crate::tui::widgets::{Canvas, text};

mod keys;
mod rows;

/// Draw everything.
pub fn view(app: &App, frame: &mut Frame<'_>) {
    let area = frame.area();
    let mut canvas = Canvas::new(frame.buffer_mut());
    if (area.width, area.height) == app.size {
        draw(app, area, &mut canvas);
    } else {
        // The terminal has a new size, and the message that says so is under way.
        draw(&App { size: (area.width, area.height), ..app.clone() }, area, &mut canvas);
    }
    let cursor = canvas.cursor;
    if app.theme.glyphs == GlyphSet::Ascii {
        ascii_pass(frame.buffer_mut());
    }
    if let Some(cursor) = cursor {
        frame.set_cursor_position(cursor);
    }
}

/// What is at a column and a row of the screen; `None` where a click means nothing.
pub fn target(app: &App, at: (u16, u16)) -> Option<Target> {
    let screen = Rect::new(0, 0, app.size.0, app.size.1);
    let mut buffer = Buffer::empty(screen);
    let mut canvas = Canvas::pointed(&mut buffer, at);
    draw(app, screen, &mut canvas);
    canvas.target()
}

/// The columns of the plot that the crosshair walks through, as it is drawn; `None` where there is none.
pub fn plot_columns(app: &App) -> Option<u16> {
    let screen = Rect::new(0, 0, app.size.0, app.size.1);
    let mut buffer = Buffer::empty(screen);
    let mut canvas = Canvas::new(&mut buffer);
    if let Some(body) = app.layout().body {
        pages::of(app.tab).draw(app, body, &mut canvas);
    }
    canvas.plot_columns.filter(|columns| *columns > 1)
}

fn draw(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let layout = app.layout();
    let Some(body) = layout.body else { return too_small(app, area, canvas) };
    pages::of(app.tab).draw(app, body, canvas);
    rows::title(app, layout.title, canvas);
    if let Some(area) = layout.pages {
        rows::pages(app, area, canvas);
    }
    rows::message(app, layout.message, canvas);
    rows::status(app, layout.status, canvas);
    keys::render(app, layout.keys, canvas);
    popup::render(app, area, canvas);
}

fn too_small(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let (columns, rows) = SMALLEST;
    let needed = format!("{columns}x{rows}, here {}x{}", area.width, area.height);
    let long = ["cmra needs more room:", &needed, "", "make the terminal larger", "(q quits)"];
    let short = ["too small", &needed, "q quits"];
    let fits = |lines: &[&str]| {
        lines.iter().all(|line| text::columns(line) <= area.width)
            && lines.len() <= usize::from(area.height)
    };
    let tiny = format!("{columns}x{rows}");
    let lines = if fits(&long) {
        long.to_vec()
    } else if fits(&short) {
        short.to_vec()
    } else {
        vec![tiny.as_str()]
    };
    let count = u16::try_from(lines.len()).unwrap_or(u16::MAX);
    let top = area.height.saturating_sub(count) / 2;
    for (row, line) in (top..area.height).zip(&lines) {
        let width = text::columns(line).min(area.width);
        let x = (area.width - width) / 2;
        canvas.set_stringn(x, row, line, usize::from(area.width), app.theme.style(Role::Text));
    }
}
