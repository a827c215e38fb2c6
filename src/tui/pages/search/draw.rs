//! Drawing of the Search tab: the setup, a chart if there is one, and the results as text.

use crate::tui::pages::page::draw_setup;
use crate::tui::pages::page::prelude::*;
use crate::tui::pages::search::state::{Page, RESULTS, SETUP};
use crate::tui::widgets::text::first_row;

pub(crate) fn render(app: &App, setup: Rect, results: Rect, canvas: &mut Canvas<'_>) {
    canvas.pane(results, RESULTS);
    draw_setup(app, &app.search_form(), SETUP, setup, canvas);
    let lines = app.search_lines(usize::from(results.width.saturating_sub(2)));
    let Some(answer) = app.pages.search.answer() else {
        waiting(app, results, canvas);
        return;
    };
    let below = app.pages.search.words_height(results.height, lines.len());
    if below == results.height {
        lines_below(app, &lines, results, canvas);
        return;
    }
    let (top, rest) = split_bottom(results, below);
    answer.draw(app, top, canvas);
    lines_below(app, &lines, rest, canvas);
}

/// The text shown before there are results.
fn waiting(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let title = app.pages.search.page.title();
    let alone = area.width == app.size.0;
    let hint = app.keymap.shown(if alone { "<next-pane>: setup" } else { "" });
    let inner = PaneFrame::new(title).right(hint).draw(area, canvas);
    let why = app.pages.search.problem().map(|_| "see the message below");
    let is_running = app.searching(app.pages.search.page).is_some();
    let text = if is_running { "searching" } else { why.unwrap_or(NO_RESULTS) };
    canvas.put_centred(inner, &app.keymap.shown(text));
}

fn lines_below(app: &App, lines: &[TextLine], area: Rect, canvas: &mut Canvas<'_>) {
    let old = if app.search_is_old() { ", of another setup" } else { "" };
    let title = format!("{}{old}", app.pages.search.page.title());
    let focused = app.has_focus(RESULTS);
    let height = usize::from(area.height.saturating_sub(2));
    let (has_choices, more) = (app.pages.search.choices() > 0, lines.len() > height);
    let is_table = app.pages.search.page == Page::Front && has_choices;
    let hint = if more && !has_choices { "<down>/<up>: more" } else { "" };
    // If the setup is not displayed beside it, the pane describes it.
    let alone = area.width == app.size.0;
    let hint = if alone { format!("<next-pane>: setup  {hint}") } else { hint.to_owned() };
    let hint = app.keymap.shown(&hint);
    let inner = PaneFrame::new(title).right(hint).focused(focused).draw(area, canvas);
    // The heading of a table stays visible.
    let (head, lines) = lines.split_at(usize::from(is_table).min(lines.len()));
    let height = height.saturating_sub(head.len());
    let selected = app.pages.search.selected();
    let first = if has_choices {
        first_row(selected, height, lines.len())
    } else {
        app.pages.search.scrolled().min(lines.len().saturating_sub(height))
    };
    if let Some((text, _)) = head.first() {
        canvas.put(inner, (0, 0), &clip(text, usize::from(inner.width)), Role::Title);
    }
    let (_, inner) = split_top(inner, u16::try_from(head.len()).unwrap_or(0));
    // The warnings of a solution are below it.
    let choices = lines.iter().enumerate().filter(|(_, line)| line.1 != Role::Warning);
    let mut choices = choices.map(|(at, _)| at).take(app.pages.search.choices());
    canvas.rows(inner, (first, lines.len()), |line| {
        Some(Target::Row(RESULTS, choices.position(|at| at == line)?))
    });
    for (row, (at, (text, role))) in inner.rows().zip(lines.iter().enumerate().skip(first)) {
        canvas.put(row, (0, 0), &clip(text, usize::from(inner.width)), *role);
        if focused && has_choices && at == selected {
            canvas.paint_row(row);
        }
    }
}
