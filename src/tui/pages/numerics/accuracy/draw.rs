//! The Accuracy tab: error against run time as a chart with a letter for each method, their table, and what it means here.

use crate::report::accuracy::{self, TARGETS, axes};
use crate::study::accuracy::MethodReport;
use crate::study::accuracy::method::Method;
use crate::tui::app::layout::WIDE;
use crate::tui::chart::{Chart, Curve, Emphasis, Legend, Mark};
use crate::tui::pages::numerics::ACCURACY;
use crate::tui::pages::numerics::accuracy::Measurements;
use crate::tui::pages::prelude::*;
use crate::tui::widgets::table::Grid;
use crate::tui::widgets::text::{NEEDS_SINGLE, wrapped};

/// Columns of a method's letter before the table.
const LETTER: u16 = 2;
/// The columns of the table of methods.
const KEYS: [&str; 7] = [
    "method",
    "observed_order",
    "run_time_s_to_1e-6",
    "run_time_s_to_1e-9",
    "least_error",
    "run_time_spread",
    "reference_uncertainty",
];

/// The colour of slope guides: that of no method.
const GUIDE_COLOUR: usize = 9;
const GUIDE_POINTS: usize = 90;

/// Rows of what `auto` uses and what two accuracies cost.
const ANSWER_ROWS: u16 = 3;

/// The chart beside the methods, or alone, and a row for each answer below.
pub(crate) fn render(app: &App, body: Rect, canvas: &mut Canvas<'_>) {
    let (top, answers) = split_bottom(body, ANSWER_ROWS);
    let wanted = match body.width {
        _ if app.is_full() => 0,
        0..72 => 29,
        72..WIDE => 35,
        WIDE..116 => 54,
        116.. => 63,
    };
    let (left, right) = split_left(top, top.width - wanted.min(top.width));
    chart(app, left, canvas);
    methods(app, right, canvas);
    let lines = app.auto_sentence().into_iter().chain(app.accuracy_costs());
    for (row, line) in (0..answers.height).zip(lines) {
        let room = usize::from(answers.width.saturating_sub(2));
        // The cost with nothing omitted goes before it is cut in two.
        let brief = line.split(';').next().filter(|_| line.chars().count() > room);
        let line = clip(brief.unwrap_or(&line), room);
        canvas.put(answers, (1, row), &line, Role::Title);
    }
}

fn chart(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let tab = &app.pages.numerics.accuracy;
    let curves = tab.curves();
    let title = "Relative error";
    let (Some(times), Some(errors)) = (tab.times(), tab.errors()) else {
        let inner = PaneFrame::new(title).draw(area, canvas);
        let why = match &tab.report.found {
            Some(_) if tab.view.times.is_some() => {
                Some("nothing in view: <zoom-fit> shows everything")
            }
            Some(_) => Some("nothing to draw: no point, or all are hidden (<show-hide>)"),
            None => app.needs_single_plate().then_some(NEEDS_SINGLE),
        };
        let text = nothing::<Measurements>(app, "measuring the first points", why);
        return canvas.put_centred(inner, &text);
    };
    let old = tab.report.is_old(&app.accuracy_scene());
    let emphasis = |method: Method| {
        if old {
            Emphasis::Stale
        } else if method == tab.method() {
            Emphasis::Selected
        } else {
            Emphasis::Normal
        }
    };
    let drawn = curves.into_iter().map(|(method, curve)| curve.emphasis(emphasis(method)));
    let (guides, bars) =
        (guides(app, times, errors), if tab.view.bars { tab.spreads() } else { Vec::new() });
    let slopes = guides.iter().map(|(marker, points)| {
        Curve::new(*marker, "slope", points).colour(GUIDE_COLOUR).emphasis(Emphasis::Stale)
    });
    let spreads = bars.iter().map(|(method, points)| {
        Curve::new('-', "spread", points).colour(*method as usize).emphasis(Emphasis::Normal)
    });
    let (x, y) = axes(times, errors);
    let (x, y) = (x.scale(tab.view.time_scale), y.scale(tab.view.error_scale));
    let title = if old { "Relative error, of another scene" } else { title };
    let targets = TARGETS.iter().map(|y| Mark::new(*y, ""));
    // In a small chart the curves would run through the words.
    let floor = if area.width < 44 { "floor" } else { "reference's floor" };
    let floor = tab.floor().map(|y| Mark::new(y, floor));
    let chart = Chart {
        legend: Legend::Hidden,
        levels: targets.chain(floor).collect(),
        crosshair: tab.cursor_s,
        focused: app.dialog.is_none(),
        ..Chart::new(title, x, y, slopes.chain(spreads).chain(drawn).collect())
    };
    let layout = canvas.draw(&chart, area);
    canvas.plot_columns = Some(layout.plot.width);
    canvas.plot(&layout, |value, _| Some(Target::Value { pane: ACCURACY, chart: 0, value }));
}

type Line = Vec<(f64, f64)>;

/// Dashed lines of the slopes that orders make, from the upper left corner, each drawn with its order.
fn guides(app: &App, times: ViewRange, errors: ViewRange) -> Vec<(char, Line)> {
    let view = app.pages.numerics.accuracy.view;
    let logarithmic = view.time_scale == Scale::Log10 && view.error_scale == Scale::Log10;
    if !(view.guides && logarithmic) {
        return Vec::new();
    }
    let span = times.hi() / times.lo();
    let line = |order: i32| {
        let point = |i: usize| {
            let share = i as f64 / GUIDE_POINTS as f64;
            // Every third point is a gap: a dash.
            let gap = if i % 3 == 2 { f64::NAN } else { 1.0 };
            (times.lo() * span.powf(share), gap * errors.hi() * span.powf(share).powi(-order))
        };
        (0..=GUIDE_POINTS)
            .map(point)
            .filter(|point| point.1.is_nan() || point.1 >= errors.lo())
            .collect()
    };
    [('1', 1), ('2', 2), ('4', 4), ('8', 8)].map(|(marker, order)| (marker, line(order))).into()
}

/// The table, and below it a description of the selected method.
fn methods(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let tab = &app.pages.numerics.accuracy;
    let methods: &[MethodReport] = tab.report.found.as_ref().map_or(&[], |report| &report.methods);
    let cells = accuracy::methods(methods).cells(&KEYS);
    let grid = Grid::of(cells, area.width.saturating_sub(2 + LETTER), tab.table_page);
    let hint = grid.hint().unwrap_or_else(|| "<show-hide> hides".to_owned());
    let hint = app.keymap.shown(&hint);
    let inner = PaneFrame::new("Methods").right(hint).draw(area, canvas);
    canvas.put(inner, (LETTER, 0), &grid.line(None), Role::Dim);
    let count = Method::ALL.len();
    let height = u16::try_from(count).unwrap_or(u16::MAX).min(inner.height.saturating_sub(1));
    let list = Rect { y: inner.y + 1, height, ..inner };
    let rows = RowList { count, selected: tab.selected_row(), painted: app.dialog.is_none() };
    let target = |method| Some(Target::Row(ACCURACY, method));
    rows.render(canvas, list, target, |canvas, row, index| {
        let method = Method::ALL[index];
        let hidden = tab.hidden.contains(&method);
        let role = if hidden { Role::Dim } else { Role::Curve(index) };
        let letter = if hidden { ' ' } else { method.letter() };
        canvas.put(row, (0, 0), &letter.to_string(), role);
        let role = if hidden { Role::Dim } else { Role::Text };
        let at = methods.iter().position(|report| report.method == method);
        let text = at.map_or_else(|| method.name().to_owned(), |at| grid.line(Some(at)));
        canvas.put(row, (LETTER, 0), &text, role);
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
