//! The screen: five regions, panes, and a dialog on top. Reads the state, changes nothing.

use ratatui::Frame;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::tui::app::App;
use crate::tui::app::layout::{Area, Body, Panes, SMALLEST, SweepPanes};
use crate::tui::app::sweep::Picture;
use crate::tui::message::Place;
use crate::tui::theme::{GlyphSet, Role, ascii_pass};

mod accuracy;
mod charts;
mod export;
mod help;
mod history;
mod keys;
mod limit;
mod log;
pub mod pointer;
mod popup;
mod presets;
mod rows;
mod runs;
mod save;
mod search;
mod setup;
mod side;
mod stability;
mod surface;
mod sweep;
mod table;
mod text;
mod thesis;
mod variables;
mod words;

/// Draw everything.
pub fn view(app: &App, frame: &mut Frame<'_>) {
    let area = frame.area();
    let mut cursor = None;
    draw(app, area, frame.buffer_mut(), &mut cursor);
    if app.theme.glyphs == GlyphSet::Ascii {
        ascii_pass(frame.buffer_mut());
    }
    if let Some(cursor) = cursor {
        frame.set_cursor_position(cursor);
    }
}

/// Where the terminal's cursor stands, while a field is open.
type Cursor = Option<(u16, u16)>;

fn draw(app: &App, area: Rect, buffer: &mut Buffer, cursor: &mut Cursor) {
    let layout = app.layout_at((area.width, area.height));
    match &layout.body {
        Body::TooSmall => return too_small(app, area, buffer),
        Body::Run(panes) => run_tab(app, panes, buffer, cursor),
        Body::Sweep(panes) => sweep_tabs(app, panes, buffer, cursor),
        Body::Accuracy(panes) => drop(accuracy::render(app, panes, buffer)),
        Body::Stability(area) => stability::render(app, rect(*area), buffer),
        Body::Log(area) => log::render(app, rect(*area), buffer),
        Body::Limit(area) => drop(limit::render(app, rect(*area), buffer)),
        Body::Search(setup, found) => {
            drop(search::render(app, (rect(*setup), rect(*found)), buffer, cursor));
        }
        Body::Thesis(area) => thesis::render(app, rect(*area), buffer),
    }
    rows::title(app, rect(layout.title), buffer);
    rows::message(app, rect(layout.message), buffer);
    rows::status(app, rect(layout.status), buffer);
    keys::render(app, rect(layout.keys), buffer);
    let _ = popup::render(app, area, buffer, cursor);
}

fn run_tab(app: &App, panes: &Panes, buffer: &mut Buffer, cursor: &mut Cursor) {
    let has = |place: Place| app.focus == place && app.dialog.is_none();
    if let Some(area) = panes.variables {
        variables::render(app, rect(area), has(Place::Variables), buffer, cursor);
    }
    let areas: Vec<Rect> = panes.charts.iter().copied().map(rect).collect();
    let _ = charts::render(app, &areas, has(Place::Charts), buffer);
    if let Some(area) = panes.runs {
        let _ = runs::render(app, rect(area), has(Place::Runs), buffer);
    }
    if let Some(area) = panes.events {
        let _ = side::events(app, rect(area), buffer);
    }
    if let Some(area) = panes.ledger {
        side::ledger(app, rect(area), buffer);
    }
}

fn sweep_tabs(app: &App, panes: &SweepPanes, buffer: &mut Buffer, cursor: &mut Cursor) {
    let Some(picture) = app.picture() else {
        return;
    };
    if let Some(area) = panes.setup {
        setup::render(app, picture, rect(area), buffer, cursor);
    }
    match picture {
        // Where the charts lie matters only to the mouse.
        Picture::Line => drop(sweep::render(app, panes, buffer)),
        Picture::Surface => drop(surface::render(app, panes, buffer)),
    }
}

fn too_small(app: &App, area: Rect, buffer: &mut Buffer) {
    let (columns, rows) = SMALLEST;
    let lines = [
        "cmra needs more room:".to_owned(),
        format!("{columns}x{rows}, here {}x{}", area.width, area.height),
        String::new(),
        "make the terminal larger".to_owned(),
        "(q quits)".to_owned(),
    ];
    let top = area.height.saturating_sub(5) / 2;
    for (row, line) in (top..area.height).zip(&lines) {
        let width = text::columns(line).min(area.width);
        let x = (area.width - width) / 2;
        buffer.set_stringn(x, row, line, usize::from(area.width), app.theme.style(Role::Text));
    }
}

fn rect(area: Area) -> Rect {
    Rect::new(area.x, area.y, area.width, area.height)
}
