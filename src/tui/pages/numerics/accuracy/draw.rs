//! The Accuracy tab: error against run time as a chart with a letter for each method, their table, and what it means here.

use crate::report::accuracy;
use crate::study::accuracy::MethodReport;
use crate::study::accuracy::method::Method;
use crate::tui::chart::Emphasis;
use crate::tui::pages::numerics::state::ACCURACY;
use crate::tui::pages::page::prelude::*;
use crate::tui::widgets::layout::WIDE;
use crate::tui::widgets::table::Grid;
use crate::tui::widgets::text::wrapped;
use crate::worker::studies::Measurements;

/// Columns of a method's letter before the table.
const LETTER: u16 = 2;
/// The columns of the table of methods.
const KEYS: [&str; 4] = ["method", "run_time_s_to_1e-6", "least_error", "run_time_s_to_1e-9"];

/// Rows of the answer above the chart, and of what leaving out gains below it: one more where that is long.
const ANSWER_ROWS: u16 = 1;
const GAIN_ROWS: u16 = 3;

/// What to use first; the chart beside the methods, or alone; what leaving out gains last.
pub(crate) fn render(app: &App, body: Rect, canvas: &mut Canvas<'_>) {
    let (answer, rest) = split_top(body, ANSWER_ROWS);
    let room = usize::from(body.width.saturating_sub(2));
    let mut answers = app.accuracy_answers().into_iter();
    let first = answers.next().unwrap_or_default();
    let below: Vec<String> = answers.flat_map(|line| wrap(&line, room)).collect();
    let is_long = below.len() > usize::from(GAIN_ROWS);
    let (top, gains) = split_bottom(rest, GAIN_ROWS + u16::from(is_long));
    let wanted = match body.width {
        0..72 => 29,
        72..WIDE => 35,
        WIDE..116 => 54,
        116.. => 63,
    };
    let (left, right) = split_left(top, top.width - wanted.min(top.width));
    chart(app, left, canvas);
    methods(app, right, canvas);
    canvas.put(answer, (1, 0), &clip(&first, room), Role::Title);
    for (row, line) in (0..gains.height).zip(&below) {
        canvas.put(gains, (1, row), line, Role::Text);
    }
}

fn chart(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let tab = &app.pages.numerics.accuracy;
    let Some(mut chart) = tab.chart() else {
        let inner = PaneFrame::new("Relative error").draw(area, canvas);
        let text = nothing::<Measurements>(app, "measuring the first points", None);
        return canvas.put_centred(inner, &text);
    };
    let is_old = tab.report.is_old(&app.accuracy_scene());
    chart.title = if is_old { "Relative error, of another scene" } else { "Relative error" }.into();
    for (method, curve) in Method::ALL.into_iter().zip(&mut chart.curves) {
        curve.emphasis = match (is_old, method == tab.method()) {
            (true, _) => Emphasis::Stale,
            (false, true) => Emphasis::Selected,
            (false, false) => Emphasis::Normal,
        };
    }
    chart.focused = app.dialog.is_none();
    canvas.draw(&chart, area);
}

/// The table, and below it a description of the selected method.
fn methods(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let tab = &app.pages.numerics.accuracy;
    let methods: &[MethodReport] = tab.report.found.as_ref().map_or(&[], |report| &report.methods);
    let cells = accuracy::methods(methods).cells(&KEYS);
    let grid = Grid::new(cells, area.width.saturating_sub(2 + LETTER), u16::MAX);
    let inner = PaneFrame::new("Methods").draw(area, canvas);
    canvas.put(inner, (LETTER, 0), &grid.line(None), Role::Dim);
    let count = Method::ALL.len();
    let height = u16::try_from(count).unwrap_or(u16::MAX).min(inner.height.saturating_sub(1));
    let list = Rect { y: inner.y + 1, height, ..inner };
    let rows = RowList { count, selected: tab.selected_row(), painted: app.dialog.is_none() };
    let target = |method| Some(Target::Row(ACCURACY, method));
    rows.render(canvas, list, target, |canvas, row, index| {
        let method = Method::ALL[index];
        canvas.put(row, (0, 0), &method.letter().to_string(), Role::Curve(index));
        let at = methods.iter().position(|report| report.method == method);
        let text = at.map_or_else(|| method.name().to_owned(), |at| grid.line(Some(at)));
        canvas.put(row, (LETTER, 0), &text, Role::Text);
    });
    details(app, inner, canvas);
}

/// The description of the selected method, below all of them.
fn details(app: &App, inner: Rect, canvas: &mut Canvas<'_>) {
    let details = app.accuracy_details().into_iter();
    let lines = details.flat_map(|(text, role)| wrapped(&text, inner.width, role));
    let lines: Vec<TextLine> = lines.collect();
    let from = 1 + u16::try_from(Method::ALL.len()).unwrap_or(u16::MAX);
    let room = usize::from(inner.height.saturating_sub(from));
    let blank = u16::from(lines.len() < room);
    // A heading alone says nothing.
    if room > 1 {
        canvas.put_lines(inner, from + blank, lines);
    }
}
