//! The setup of a sweep as a list of rows, with the open field.

use ratatui::layout::Rect;

use crate::model::variables::{self, VARIABLES};
use crate::tui::app::App;
use crate::tui::app::status::clip;
use crate::tui::keymap::Pane;
use crate::tui::message::Target;
use crate::tui::pages::explore::state::{Picture, SetupRow};
use crate::tui::theme::{PaneFrame, Role};
use crate::tui::widgets::Canvas;
use crate::tui::widgets::text::{columns, first_row, paint_row, put};

/// Columns within a row: cursor, `*`, label, value, unit.
const LABEL: u16 = 2;
const VALUE: u16 = 10;
const VALUE_WIDTH: u16 = 7;
const UNIT: u16 = VALUE + VALUE_WIDTH + 1;

/// Draw the pane.
pub(in crate::tui) fn render(app: &App, picture: Picture, area: Rect, canvas: &mut Canvas<'_>) {
    let on = app.pane() == Pane::ExploreSetup;
    let focused = app.has_focus(Pane::ExploreSetup);
    let hint = if on { "" } else { "Tab" };
    let inner =
        PaneFrame::new("Setup").right(hint).focused(focused).render(area, canvas, app.theme);
    let rows = app.setup_rows(picture);
    let selected = app.setup_row(picture);
    let here = rows.iter().position(|row| *row == selected).unwrap_or(0);
    let height = usize::from(inner.height);
    let first = if on { first_row(here, height, rows.len()) } else { 0 };
    canvas.pane(area, Pane::ExploreSetup);
    canvas.rows(inner, (first, rows.len()), |at| match rows[at] {
        SetupRow::Heading(_) => None,
        row => Some(Target::Setup(row)),
    });
    for (at, row) in (0..inner.height).zip(rows.iter().skip(first)) {
        line(app, picture, *row, (inner, at), canvas);
        if on && *row == selected {
            put(canvas, inner, (0, at), ">", app.theme.style(Role::Title));
            match app.sweeping.field.as_ref().filter(|field| field.row == *row) {
                Some(field) => {
                    let start = if field.row == SetupRow::Output { LABEL } else { VALUE };
                    let room = inner.width.saturating_sub(start + 1);
                    field.draw_boxed(canvas, (inner, at), (start, room), app.theme);
                }
                None => paint_row(canvas, inner, at, app.theme.style(Role::Selection)),
            }
        }
    }
}

fn line(
    app: &App,
    picture: Picture,
    row: SetupRow,
    (area, at): (Rect, u16),
    canvas: &mut Canvas<'_>,
) {
    let style = |role| app.theme.style(role);
    let shown = app.setup_shown(picture, row, usize::from(VALUE_WIDTH));
    if let SetupRow::Heading(text) = row {
        put(canvas, area, (0, at), text, style(Role::Title));
        return;
    }
    if row == SetupRow::Output {
        let title = crate::model::results::find(&shown.label)
            .map_or_else(|| shown.label.clone(), crate::model::results::ResultColumn::title);
        let text = clip(&title, usize::from(area.width.saturating_sub(LABEL)));
        put(canvas, area, (LABEL, at), &text, style(Role::Text));
        return;
    }
    let mut role = Role::Text;
    if let SetupRow::Held(index) = row {
        let variable = &VARIABLES[index];
        if !variables::is_used(variable, &app.scene) {
            role = Role::Dim;
        }
        if variable.value(&app.scene) != variable.value(&app.base.scene) {
            put(canvas, area, (1, at), "*", style(Role::Note));
        }
    }
    let label = put(canvas, area, (LABEL, at), &shown.label, style(role));
    // A long name moves its value: a blank stays between them.
    let start = (VALUE + VALUE_WIDTH).saturating_sub(columns(&shown.value)).max(VALUE);
    let start = start.max(label + 1);
    let end = put(canvas, area, (start, at), &shown.value, style(role));
    // Half a unit would be another one.
    if end < UNIT && UNIT + columns(shown.unit) <= area.width {
        put(canvas, area, (UNIT, at), shown.unit, style(Role::Dim));
    }
}
