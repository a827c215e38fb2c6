//! The comparison at equal areal mass: its verdict and figures, and the map of mass efficiency.

use ratatui::layout::Rect;

use crate::model::units::significant;
use crate::report::figures::{column_of, efficiency};
use crate::report::map::Map;
use crate::study::sweep::Axis;
use crate::tui::app::App;
use crate::tui::chart::{Draw, heatmap};
use crate::tui::message::Target;
use crate::tui::pages::limit::comparison::EqualMass;
use crate::tui::pages::limit::comparison::GOES_ON;
use crate::tui::pages::limit::{COMPARISON, EFFICIENCY_MAP};
use crate::tui::pages::search::lines::Line;
use crate::tui::theme::{PaneFrame, Role};
use crate::tui::widgets::Canvas;
use crate::tui::widgets::text::{columns, put, put_centred, text_role};

/// The verdict first, then the figures beside each other; scrolled by j and k.
pub(in crate::tui) fn render(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    canvas.pane(area, COMPARISON);
    let focused = app.has_focus(COMPARISON);
    let old = if app.comparison_is_old() { ", of another scene: press r" } else { "" };
    let with = app.absorber().map_or_else(String::new, |one| format!(" with {}", one.name));
    let title = format!("Does moving armour pay?{with}{old}");
    let lines = app.comparison_lines(usize::from(area.width.saturating_sub(2)));
    let height = usize::from(area.height.saturating_sub(2));
    let more = lines.len() > height;
    let right = match (more, focused) {
        (true, true) => "j/k: more",
        (true, false) => "Tab, j/k: more",
        (false, _) => "",
    };
    let frame = PaneFrame::new(title).right(right).focused(focused);
    let inner = frame.render(area, canvas, app.theme);
    if lines.is_empty() {
        nothing(app, inner, canvas);
    }
    let first = app.pages.limit.scrolled.min(lines.len().saturating_sub(height));
    let shown = whole(&lines[first..], height);
    for (line, (severity, text)) in inner.rows().zip(shown) {
        put(canvas, line, (0, 0), text, app.theme.style(text_role(*severity)));
    }
}

/// So many lines at most, without the beginning of a sentence whose end has no room.
fn whole(lines: &[Line], height: usize) -> &[Line] {
    let ends = |at: &usize| lines.get(*at).is_none_or(|next| !next.1.starts_with(GOES_ON));
    let room = height.min(lines.len());
    &lines[..(1..=room).rev().find(ends).unwrap_or(room)]
}

fn nothing(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let text = match app.jobs.running::<EqualMass>() {
        Some(_) => "comparing with a rigid mount and a solid plate of the same areal mass",
        None => "no results yet: press r",
    };
    put_centred(canvas, area, text, app.theme.style(Role::Dim));
}

/// The map of mass efficiency with the line of 1, and below it what its colours mean.
pub(in crate::tui) fn map(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    canvas.pane(area, EFFICIENCY_MAP);
    let focused = app.has_focus(EFFICIENCY_MAP);
    let found = app.comparison().and_then(|found| found.map.as_ref());
    let Some((found, map)) = found.and_then(|it| Some((it, efficiency::map(it)?))) else {
        let frame = PaneFrame::new("Mass efficiency").focused(focused);
        let inner = frame.render(area, canvas, app.theme);
        let text = match (app.jobs.running::<EqualMass>().is_some(), found) {
            (true, _) => "computing the map",
            (false, Some(_)) => "no point has a mass efficiency",
            (false, None) => "no map: press r",
        };
        put_centred(canvas, inner, text, app.theme.style(Role::Dim));
        return;
    };
    let above = Rect { height: area.height.saturating_sub(1), ..area };
    let cursor = app.efficiency_cursor();
    let cursor =
        cursor.and_then(|(x, y)| Some((column_of(found.x(), x)?, column_of(found.y(), y)?)));
    let title = format!("mass efficiency, up: {}", found.y().symbol()).into();
    let map = Map { title, cursor, focused, ..map };
    let layout = map.render(above, canvas, app.theme);
    let mut column =
        put(canvas, area, (1, above.height), "O line of 1 ", app.theme.style(Role::Text));
    let Some(levels) = &map.levels else { return };
    for band in 0..levels.bands() {
        let (symbol, style) = heatmap::swatch(band, levels.bands(), app.theme);
        let from = format!(" {}", significant(levels.band(band).0, 3));
        // Half a number would be another one.
        if column + 2 + columns(&from) > area.width {
            break;
        }
        column = put(canvas, area, (column + 1, above.height), &symbol.to_string(), style);
        column = put(canvas, area, (column, above.height), &from, app.theme.style(Role::Text));
    }
    canvas.plot(&layout, |x, y| {
        let nearest = |axis: &Axis, value: f64| usize::try_from(axis.nearest(value)).ok();
        Some(Target::Cell(EFFICIENCY_MAP, (nearest(found.x(), x)?, nearest(found.y(), y)?)))
    });
}
