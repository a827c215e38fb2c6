//! The screen: five regions, panes, and a dialog on top. Reads the state, changes nothing.

use ratatui::Frame;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::tui::app::App;
use crate::tui::app::layout::{Area, Body, LimitPanes, Panes, SMALLEST, SweepPanes};
use crate::tui::app::sweep::Picture;
use crate::tui::keymap::Pane;
use crate::tui::theme::{GlyphSet, Role, ascii_pass};

mod accuracy;
mod charts;
mod comparison;
mod efficiency_map;
mod export;
mod help;
mod history;
mod keys;
mod limit;
mod log;
mod mechanism;
mod options;
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
        Body::Explore(panes) => explore(app, panes, buffer, cursor),
        Body::Accuracy(panes) => drop(accuracy::render(app, panes, buffer)),
        Body::Stability(area) => stability::render(app, rect(*area), buffer),
        Body::Log(area) => log::render(app, rect(*area), buffer),
        Body::Limit(panes) => limit_tab(app, panes, buffer),
        Body::Search(setup, found) => {
            drop(search::render(app, (rect(*setup), rect(*found)), buffer, cursor));
        }
        Body::Thesis(area) => thesis::render(app, rect(*area), buffer),
    }
    rows::title(app, rect(layout.title), buffer);
    if let Some(area) = layout.pages {
        rows::pages(app, rect(area), buffer);
    }
    rows::message(app, rect(layout.message), buffer);
    rows::status(app, rect(layout.status), buffer);
    keys::render(app, rect(layout.keys), buffer, cursor);
    let _ = popup::render(app, area, buffer, cursor);
}

fn run_tab(app: &App, panes: &Panes, buffer: &mut Buffer, cursor: &mut Cursor) {
    let has = |pane: Pane| app.has_focus(pane);
    if let Some(area) = panes.variables {
        variables::render(app, rect(area), has(Pane::Variables), buffer, cursor);
    }
    let areas: Vec<Rect> = panes.charts.iter().copied().map(rect).collect();
    let _ = charts::render(app, &areas, has(Pane::Charts), buffer);
    if let Some(area) = panes.runs {
        let _ = runs::render(app, rect(area), has(Pane::Runs), buffer);
    }
    if let Some(area) = panes.events {
        let _ = side::events(app, rect(area), buffer);
    }
    if let Some(area) = panes.mechanism {
        mechanism::render(app, rect(area), buffer);
    }
    if let Some(area) = panes.ledger {
        side::ledger(app, rect(area), buffer);
    }
}

/// The panes of the Limit tab that have room.
fn limit_tab(app: &App, panes: &LimitPanes, buffer: &mut Buffer) {
    if let Some(area) = panes.comparison {
        comparison::render(app, rect(area), buffer);
    }
    if let Some(area) = panes.residual {
        let _ = limit::render(app, rect(area), buffer);
    }
    if let Some(area) = panes.map {
        let _ = comparison::map(app, rect(area), buffer);
    }
}

fn explore(app: &App, panes: &SweepPanes, buffer: &mut Buffer, cursor: &mut Cursor) {
    let picture = app.picture();
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
        buffer.set_stringn(x, row, line, usize::from(area.width), app.theme.style(Role::Text));
    }
}

fn rect(area: Area) -> Rect {
    Rect::new(area.x, area.y, area.width, area.height)
}
