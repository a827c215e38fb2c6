//! The Accuracy tab: error against run time as a chart with a letter for each method, their table, and what it means here.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::rect;
use super::text::{columns, paint_row, put};
use crate::study::accuracy::MethodReport;
use crate::study::accuracy::method::Method;
use crate::tui::app::App;
use crate::tui::app::accuracy::{TARGETS, seconds};
use crate::tui::app::layout::AccuracyPanes;
use crate::tui::app::notice::Severity;
use crate::tui::app::status::{clip, wrap};
use crate::tui::chart::{Axis, Chart, Curve, Emphasis, Legend, Level, Scale, Unit, ViewRange};
use crate::tui::theme::{Pane, Role};

/// Columns of a method's letter and name in the table.
const NAME: u16 = 19;

/// A column of the table: heading, width, value.
type Column = (&'static str, u16, fn(&MethodReport) -> String);

const TABLE: [Column; 4] = [
    ("order", 6, |report| {
        // Adding zero takes the sign off a negative zero.
        let shown = |order: f64| format!("{:.1}", (10.0 * order).round() / 10.0 + 0.0);
        report.observed_order().map_or_else(|| "-".to_owned(), shown)
    }),
    ("t(1e-6)", 8, |report| time(report, TARGETS[0])),
    ("t(1e-9)", 8, |report| time(report, TARGETS[1])),
    ("least", 7, |report| {
        report.least_error().map_or_else(|| "-".to_owned(), |error| format!("{error:.0e}"))
    }),
];

fn time(report: &MethodReport, target: f64) -> String {
    report.cheapest(target).map_or_else(|| "-".to_owned(), |found| seconds(found.min_s))
}

/// Draw the tab.
pub(super) fn render(app: &App, panes: &AccuracyPanes, buffer: &mut Buffer) {
    chart(app, rect(panes.chart), buffer);
    methods(app, rect(panes.methods), buffer);
    let answers = rect(panes.answers);
    for (row, line) in (0..answers.height).zip(app.accuracy_answers()) {
        let line = clip(&line, usize::from(answers.width.saturating_sub(2)));
        put(buffer, answers, (1, row), &line, app.theme.style(Role::Title));
    }
}

fn chart(app: &App, area: Rect, buffer: &mut Buffer) {
    let curves = app.accuracy.curves();
    let points = || curves.iter().flat_map(|(_, points)| points);
    let times = ViewRange::of(Scale::Log10, points().map(|point| point.0));
    let errors = ViewRange::of(Scale::Log10, points().map(|point| point.1));
    let title = "Relative error";
    let (Some(times), Some(errors)) = (times, errors) else {
        let inner = Pane::new(title).render(area, buffer, app.theme);
        let text = match (&app.accuracy.measuring, &app.accuracy.report) {
            (Some(_), _) => "measuring the first points",
            (None, Some(_)) => "nothing to draw: no point, or all are hidden (V)",
            (None, None) => "not measured yet: r measures",
        };
        let column = inner.width.saturating_sub(columns(text)) / 2;
        put(buffer, inner, (column, inner.height / 2), text, app.theme.style(Role::Dim));
        return;
    };
    let old = app.accuracy_is_old();
    let drawn = curves.iter().map(|(method, points)| {
        let index = Method::ALL.iter().position(|one| one == method).unwrap_or(0);
        Curve::new(method.letter(), method.name(), points).colour(index).emphasis(if old {
            Emphasis::Stale
        } else if *method == app.accuracy.method() {
            Emphasis::Selected
        } else {
            Emphasis::Normal
        })
    });
    let x = Axis::new("run time", times.rounded(Scale::Log10))
        .scale(Scale::Log10)
        .unit(Unit::scaled(1e6, "µs"));
    let y = Axis::new("", errors.rounded(Scale::Log10)).scale(Scale::Log10);
    let title = if old { "Relative error, old" } else { title };
    let chart = Chart {
        legend: Legend::Hidden,
        levels: TARGETS.iter().map(|y| Level { y: *y, tag: "".into() }).collect(),
        crosshair: app.accuracy.cursor_s,
        focused: app.dialog.is_none(),
        ..Chart::new(title, x, y, drawn.collect())
    };
    chart.render(area, buffer, app.theme);
}

/// The table, and below it what is to be said of the selected method.
fn methods(app: &App, area: Rect, buffer: &mut Buffer) {
    let inner = Pane::new("Methods").right("V hides").render(area, buffer, app.theme);
    let mut shown = 0;
    let mut end = NAME;
    for (title, width, _) in &TABLE {
        if end + width > inner.width {
            break;
        }
        end += width;
        let column = end - columns(title);
        put(buffer, inner, (column, 0), title, app.theme.style(Role::Dim));
        shown += 1;
    }
    for (row, (index, method)) in (1..inner.height).zip(Method::ALL.iter().enumerate()) {
        let hidden = app.accuracy.hidden.contains(method);
        let role = if hidden { Role::Dim } else { Role::Curve(index) };
        let letter = if hidden { ' ' } else { method.letter() };
        put(buffer, inner, (0, row), &letter.to_string(), app.theme.style(role));
        let style = app.theme.style(if hidden { Role::Dim } else { Role::Text });
        put(buffer, inner, (2, row), method.name(), style);
        let mut end = NAME;
        for (_, width, value) in &TABLE[..shown] {
            end += width;
            let text = app.accuracy.of(*method).map_or_else(String::new, value);
            put(buffer, inner, (end.saturating_sub(columns(&text)), row), &text, style);
        }
        if index == app.accuracy.selected && app.dialog.is_none() {
            paint_row(buffer, inner, row, app.theme.style(Role::Selection));
        }
    }
    let width = usize::from(inner.width);
    let mut row = u16::try_from(Method::ALL.len()).unwrap_or(0) + 2;
    for (index, (severity, text)) in app.accuracy_details().into_iter().enumerate() {
        let role = match severity {
            _ if index == 0 => Role::Title,
            Severity::Note => Role::Text,
            Severity::Warning => Role::Warning,
            Severity::Error => Role::Error,
        };
        for line in wrap(&text, width) {
            put(buffer, inner, (0, row), &line, app.theme.style(role));
            row += 1;
        }
    }
}
