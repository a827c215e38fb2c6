//! Drawing of the Search tab: the setup, a chart if there is one, and the results as text.

use crate::tui::pages::page::draw_setup;
use crate::tui::pages::page::prelude::*;
use crate::tui::pages::search::results::{search_is_old, searching};
use crate::tui::pages::search::state::{RESULTS, SETUP};
use crate::tui::pages::search::study_page::Words;
use crate::tui::pages::search::study_page::search_words;
use crate::tui::widgets::text::first_row;

/// Maximum cells of the gauge of a search without results, and columns for its brackets and the remaining time.
const GAUGE: usize = 40;
const GAUGE_WORDS: u16 = 16;

pub(crate) fn render(app: &App, setup: Rect, results: Rect, canvas: &mut Canvas<'_>) {
    canvas.pane(results, RESULTS);
    draw_setup(app, &app.search_form(), SETUP, setup, canvas);
    let words = search_words(app, usize::from(results.width.saturating_sub(2)));
    let Some(answer) = app.pages.search.answer() else {
        waiting(app, results, canvas);
        return;
    };
    let (top, rest) = split_bottom(results, app.pages.search.words_height(results.height, &words));
    if top.height > 0 {
        answer.draw(app, top, canvas);
    }
    text(app, &words, rest, canvas);
}

/// Returns the frame of the results; it names the key to the setup if the setup is not drawn beside it.
fn frame(app: &App, title: String, more: &str, area: Rect) -> PaneFrame<'static> {
    let alone = area.width == app.size.0;
    let hint = if alone { format!("{more}  <next-pane>: setup") } else { more.to_owned() };
    PaneFrame::new(title).right(app.keymap.shown(hint.trim_start()))
}

/// Draws the progress before there are results, or how to start.
fn waiting(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let page = app.pages.search.page;
    let inner = frame(app, page.title().to_owned(), "", area).draw(area, canvas);
    let why = app.pages.search.problem().map(|_| "see the message below");
    let Some(running) = searching(app, page) else {
        return canvas.put_centred(inner, &app.keymap.shown(why.unwrap_or(NO_RESULTS)));
    };
    let cells = usize::from(inner.width.saturating_sub(GAUGE_WORDS)).min(GAUGE);
    canvas.put_centred(inner, "searching");
    if let Some(gauge) = running.gauge(cells) {
        let (_, below) = split_top(inner, 2);
        canvas.put_centred(below, &gauge);
    }
}

/// Draws the answer and the heading of the table, then as much of the rows and remarks as fits.
fn text(app: &App, words: &Words, area: Rect, canvas: &mut Canvas<'_>) {
    let tab = &app.pages.search;
    let old = if search_is_old(app) { ", of another setup" } else { "" };
    let title = format!("{}{old}", tab.page.title());
    let focused = app.has_focus(RESULTS);
    let has_choices = tab.choices() > 0;
    let height = usize::from(area.height.saturating_sub(2));
    let more = if words.count() > height && !has_choices { "<down>/<up>: more" } else { "" };
    let inner = frame(app, title, more, area).focused(focused).draw(area, canvas);
    let room = usize::from(inner.width);
    let clipped = |(text, role): &TextLine| (clip(text, room), *role);
    canvas.put_lines(inner, 0, words.head.iter().map(clipped));
    let (_, inner) = split_top(inner, u16::try_from(words.head.len()).unwrap_or(u16::MAX));
    let (height, count, selected) = (usize::from(inner.height), words.body.len(), tab.selected());
    let first = if has_choices {
        first_row(selected, height, count)
    } else {
        tab.scrolled().min(count.saturating_sub(height))
    };
    let choices = tab.choices();
    canvas
        .rows(inner, (first, count), |line| (line < choices).then_some(Target::Row(RESULTS, line)));
    for (row, (at, line)) in inner.rows().zip(words.body.iter().enumerate().skip(first)) {
        let (text, role) = clipped(line);
        canvas.put(row, (0, 0), &text, role);
        if focused && has_choices && at == selected {
            canvas.paint_row(row);
        }
    }
}
