//! The setup of a sweep as a list of rows, with the open field.

use ratatui::layout::Rect;

use crate::model::variables::{self, VARIABLES};
use crate::tui::app::App;
use crate::tui::app::status::clip;
use crate::tui::pages::explore::SETUP;
use crate::tui::pages::explore::state::{Picture, SetupRow};
use crate::tui::theme::Role;
use crate::tui::widgets::Canvas;
use crate::tui::widgets::form::Form;
use crate::tui::widgets::text::{columns, put};

/// Columns within a row: cursor, `*`, label, value, unit.
const LABEL: u16 = 2;
const VALUE: u16 = 10;
const VALUE_WIDTH: u16 = 7;
const UNIT: u16 = VALUE + VALUE_WIDTH + 1;

/// Draw the pane.
pub(in crate::tui) fn render(app: &App, picture: Picture, area: Rect, canvas: &mut Canvas<'_>) {
    let selected = app.setup_row(picture);
    let form = Form {
        pane: SETUP,
        rows: &app.setup_rows(picture),
        choices: &app.setup_choices(picture),
        selected,
        field: if selected == SetupRow::Output { LABEL } else { VALUE },
    };
    form.render(app, area, canvas, |canvas, line, row| draw(app, picture, *row, line, canvas));
}

fn draw(app: &App, picture: Picture, row: SetupRow, area: Rect, canvas: &mut Canvas<'_>) {
    let style = |role| app.theme.style(role);
    let shown = app.setup_shown(picture, row, usize::from(VALUE_WIDTH));
    if let SetupRow::Heading(text) = row {
        put(canvas, area, (0, 0), text, style(Role::Title));
        return;
    }
    if row == SetupRow::Output {
        let title = crate::study::quantities::find(&shown.label)
            .map_or_else(|| shown.label.clone(), crate::study::quantities::Quantity::title);
        let text = clip(&title, usize::from(area.width.saturating_sub(LABEL)));
        put(canvas, area, (LABEL, 0), &text, style(Role::Text));
        return;
    }
    let mut role = Role::Text;
    if let SetupRow::Held(index) = row {
        let variable = &VARIABLES[index];
        if !variables::is_used(variable, &app.scene) {
            role = Role::Dim;
        }
        if variable.value(&app.scene) != variable.value(&app.base.scene) {
            put(canvas, area, (1, 0), "*", style(Role::Note));
        }
    }
    let label = put(canvas, area, (LABEL, 0), &shown.label, style(role));
    // A long name moves its value: a blank stays between them.
    let start = (VALUE + VALUE_WIDTH).saturating_sub(columns(&shown.value)).max(VALUE);
    let start = start.max(label + 1);
    let end = put(canvas, area, (start, 0), &shown.value, style(role));
    // Half a unit would be another one.
    if end < UNIT && UNIT + columns(shown.unit) <= area.width {
        put(canvas, area, (UNIT, 0), shown.unit, style(Role::Dim));
    }
}
