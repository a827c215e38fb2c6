//! The help overlay, which lists the key table, and the palette.

use crate::model::variables::Kind;
use crate::tui::app::layout::{split_bottom, split_top};
use crate::tui::app::status::clip;
use crate::tui::dialogs::{HelpRow, Picker, filter, frame, help_rows};
use crate::tui::pages::limit::COMPARISON;
use crate::tui::pages::limit::comparison::COMPARISON_WORDS;
use crate::tui::pages::numerics::STIFF_SCENES;
use crate::tui::pages::numerics::stability::stiff_scenes_words;
use crate::tui::pages::{self, run};
use crate::tui::prelude::*;
use crate::tui::widgets::RowList;
use crate::tui::widgets::text::{TextLine, wrapped};

const SENTENCE: u16 = 15;

/// Keys: what the selected variable means on top, then the keys of the focused pane, then the others.
pub(crate) fn help(app: &App, picker: &Picker, screen: Rect, canvas: &mut Canvas<'_>) {
    let title = format!("Keys of {}, then of every pane", pages::spec(app.pane()).label);
    let inner = frame(screen, (92, 48), PaneFrame::new(title).right("q closes"), canvas);
    let about = about(app, inner.width);
    let top = u16::try_from(about.len()).unwrap_or(u16::MAX);
    canvas.put_lines(inner, 0, about);
    let (_, rest) = split_top(inner, top);
    filter(picker, rest, canvas);
    let rows = help_rows(app, picker.filter.value());
    list(&rows, picker.selected, split_top(rest, 1).1, canvas);
}

/// The matches of `:`, and the effect of Enter on the selected one.
pub(crate) fn palette(app: &App, picker: &Picker, screen: Rect, canvas: &mut Canvas<'_>) {
    let pane =
        PaneFrame::new("Find an action, variable, quantity, preset or page").right("Esc closes");
    let inner = frame(screen, (76, 20), pane, canvas);
    filter(picker, inner, canvas);
    let (list, foot) = split_bottom(split_top(inner, 1).1, DOES);
    let found = app.palette(picker.filter.value());
    if found.is_empty() {
        canvas.put(list, (0, 0), "nothing has this name", Role::Dim);
    }
    let rows = RowList { count: found.len(), selected: picker.selected, painted: true };
    rows.in_dialog(canvas, list, |canvas, row, index| {
        let item = &found[index];
        let mark = if item.kind() == "broken" { "!" } else { " " };
        canvas.put(row, (0, 0), mark, Role::Warning);
        canvas.put(row, (2, 0), &clip(&item.name(), 40), Role::Text);
        let kind = row.width.saturating_sub(10);
        canvas.put(row, (kind, 0), item.kind(), Role::Dim);
    });
    let does = found.get(picker.selected).map_or_else(String::new, |item| app.palette_does(item));
    canvas.put_lines(foot, 0, wrapped(&does, foot.width, Role::Title));
}

/// Rows that say what Enter does.
const DOES: u16 = 2;

fn list(rows: &[HelpRow], selected: usize, area: Rect, canvas: &mut Canvas<'_>) {
    if rows.is_empty() {
        canvas.put(area, (0, 0), "nothing matches", Role::Dim);
    }
    let room = usize::from(area.width.saturating_sub(SENTENCE));
    RowList { count: rows.len(), selected, painted: true }.in_dialog(
        canvas,
        area,
        |canvas, row, index| {
            let line = &rows[index];
            let keys = clip(&line.keys, usize::from(SENTENCE) - 2);
            canvas.put(row, (0, 0), &keys, Role::Key);
            let role = if line.pane.is_empty() { Role::Dim } else { Role::Text };
            canvas.put(row, (SENTENCE, 0), &clip(&line.help, room), role);
        },
    );
}

/// What the words and signs of the focused pane mean.
fn about(app: &App, width: u16) -> Vec<TextLine> {
    let text = match app.pane() {
        run::VARIABLES => return variable(app, width),
        COMPARISON => COMPARISON_WORDS.to_owned(),
        STIFF_SCENES => stiff_scenes_words(),
        _ => return Vec::new(),
    };
    wrapped(&text, width, Role::Text).chain([(String::new(), Role::Text)]).collect()
}

/// Meaning, allowed values, range and source of the selected variable.
fn variable(app: &App, width: u16) -> Vec<TextLine> {
    let variable = app.pages.run.editor.variable();
    let mut lines = vec![(format!("{}  {}", variable.symbol, variable.key), Role::Title)];
    let mut text = |text: String| {
        let indented = wrapped(&text, width.saturating_sub(2), Role::Text);
        lines.extend(indented.map(|(line, role)| (format!("  {line}"), role)));
    };
    text(variable.meaning.to_owned());
    let range = match &variable.kind {
        Kind::Number(number) => number.thesis_range.map_or_else(String::new, |(low, high)| {
            let show = crate::model::units::shortest;
            format!("; the thesis searched {} to {} (Table 9.2, T9.2)", show(low), show(high))
        }),
        Kind::Choice(_) | Kind::Switch { .. } => String::new(),
    };
    text(format!("now {}; allowed: {}{range}", variable.show(&app.scene), variable.allowed()));
    text(format!("default: {}", variable.source));
    lines.push((String::new(), Role::Text));
    lines
}
