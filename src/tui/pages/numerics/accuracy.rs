//! Accuracy page: chart of error over run time with a letter for each method, table of the methods, and recommendations.

use crate::tui::chart::emphasis;
use crate::tui::pages::numerics::state::ACCURACY;
use crate::tui::pages::page::prelude::*;
use crate::tui::widgets::layout::WIDE;
use crate::tui::widgets::table::Grid;
use crate::tui::widgets::text::wrapped;
use crate::worker::studies::MethodBenchmark;
use cmra_engine::model::scene::RunSettings;
use cmra_engine::model::units::engineering;
use cmra_studies::report::accuracy::{
    self, TARGETS, advice, error_over_time, gain, printed_scheme, seconds,
};
use cmra_studies::study::accuracy::method::Method;
use cmra_studies::study::accuracy::{Compared, ComparisonOptions, MethodReport};

/// Columns for a method's letter before the table.
const LETTER: u16 = 2;
/// Columns of the table of methods.
const KEYS: [&str; 4] = ["method", "run_time_s_to_1e-6", "least_error", "run_time_s_to_1e-9"];

/// Rows of the recommendation above the chart; minimum and maximum rows of the speed-ups from omitted terms below it.
const ANSWER_ROWS: u16 = 1;
const GAIN_ROWS: (u16, u16) = (3, 6);

/// Returns the current scene with the tolerance of the measurements, which vary it in any case.
pub(crate) fn accuracy_scene(app: &App) -> Scene {
    let RunSettings { tolerance, .. } = app.pages.numerics.accuracy.report.scene.run;
    let run = RunSettings { tolerance, ..app.scene.run };
    Scene { run, ..Scene::clone(&app.scene) }
}

pub fn accuracy_status(app: &App) -> Vec<StatusPart> {
    let tab = &app.pages.numerics.accuracy;
    let methods = tab.report.result.iter().flat_map(|report| &report.methods);
    let count: usize = methods.map(|one| one.points.len()).sum();
    let words = |it: &Running| format!("measuring{}", it.counted("of", " points"));
    let scene = accuracy_scene(app);
    let progress = progress::<MethodBenchmark, _>(app, &tab.report, &scene, words, "points");
    let done = || part(Severity::Note, format!("measured {count} points"));
    let mut parts = vec![progress.unwrap_or_else(done)];
    let Some(report) = &tab.report.result else { return parts };
    if let Some(reference) = report.references.any() {
        let sure = reference.uncertainty.map(|it| format!(", to {it:.0e}"));
        let words = reference.basis.label();
        let text = format!("reference {words}{}", sure.unwrap_or_default());
        parts.push(part(Severity::Note, text));
        let ending = match reference.results.get(Compared::Depth) {
            Some(depth_m) => format!("{} deep", engineering(depth_m, "m", 7)),
            None => reference.outcome.word().to_owned(),
        };
        parts.push(part(Severity::Note, ending));
    }
    parts
}

/// Returns the recommended method and its cost, the error of the printed scheme, and the gain of omitting terms.
pub(crate) fn accuracy_answers(app: &App) -> Vec<String> {
    let tab = &app.pages.numerics.accuracy;
    let Some(report) = &tab.report.result else { return Vec::new() };
    if !tab.report.is_complete() && tab.tolerance().is_none() {
        let running = app.jobs.running::<MethodBenchmark>();
        let counted = running.and_then(|it| it.points);
        let counted = counted.map(|(done, total)| format!(" ({done} of {total})"));
        let (counted, words) = (counted.unwrap_or_default(), not_yet(app, running));
        return vec![format!("error {:.0e}: {words}{counted}", TARGETS[0])];
    }
    let row = |[part, with, without, gain]: [&str; 4]| {
        format!("{part:<32}{with:>7}{without:>8}  {gain}").trim_end().to_owned()
    };
    let head = row(["what is left out", "with", "without", "gain"]);
    let gains = report.savings.iter().map(|it| {
        let [with, without] = [it.with_s, it.without_s].map(seconds);
        row([it.part, &with, &without, &gain(it)])
    });
    let head = (!report.savings.is_empty()).then_some(head);
    let gains: Vec<String> = head.into_iter().chain(gains).collect();
    let printed = printed_scheme(report);
    std::iter::once(format!("error {}", advice(report))).chain(printed).chain(gains).collect()
}

/// Describes the selected method: its example point, then the rejected points with reasons.
pub fn accuracy_details(app: &App) -> Vec<TextLine> {
    let tab = &app.pages.numerics.accuracy;
    let method = tab.method();
    let mut lines = vec![(format!("{} {}", method.letter(), method.name()), Role::Title)];
    let mut add = |role, text: String| lines.push((text, role));
    let Some(report) = tab.method_report(method) else {
        add(Role::Text, "not measured yet".to_owned());
        return lines;
    };
    if let Some((parameter, it)) = tab.example() {
        let floor = if it.is_at_floor() { " (floor)" } else { "" };
        add(Role::Text, format!("{parameter}: error {:.1e}{floor}", it.error()));
        let errors = it.errors.known();
        let errors: Vec<String> =
            errors.map(|(of, error)| format!("{} {error:.0e}", of.label())).collect();
        add(Role::Text, errors.join(", "));
    }
    let total = report.points.len();
    for (words, points) in report.refusals() {
        add(Role::Warning, format!("{} of {total}: {words}", points.len()));
    }
    if let Some((_, it)) = tab.example() {
        add(Role::Text, format!("{}, {} steps", seconds(it.min_s), it.answer.steps));
    }
    lines
}

/// Describes the selected row.
pub(crate) fn readout(app: &App) -> Option<String> {
    let tab = &app.pages.numerics.accuracy;
    let method = tab.method();
    let report = tab.method_report(method)?;
    let reached = TARGETS.into_iter().filter_map(|target| {
        let found = report.cheapest(target)?;
        Some(format!("{target:.0e} in {}", seconds(found.min_s)))
    });
    let reached = reached.collect::<Vec<_>>().join(", ");
    let is_complete = tab.report.is_complete();
    let text = match report.min_error() {
        None if is_complete => "no point is measured".to_owned(),
        None => not_yet(app, app.jobs.running::<MethodBenchmark>()),
        Some(least) if !reached.is_empty() => format!("error {reached}; least {least:.0e}"),
        Some(least) if is_complete => format!("error above {:.0e}; least {least:.0e}", TARGETS[0]),
        Some(least) => format!("least error so far {least:.0e}"),
    };
    Some(format!("{}: {text}", method.name()))
}

/// Starts the measurement unless this scene has been or is being measured.
pub(crate) fn enter(app: &mut App) {
    if app
        .jobs
        .lacks::<MethodBenchmark, _>(&app.pages.numerics.accuracy.report, &accuracy_scene(app))
    {
        jobs::look(app, jobs::LOOK, MethodBenchmark(ComparisonOptions::FULL));
    }
}

pub(crate) fn act(app: &mut App, action: Action) -> bool {
    match action {
        Action::Run => jobs::study(app, action, MethodBenchmark(ComparisonOptions::FULL)),
        Action::Enter => use_method(app),
        _ => return false,
    }
    true
}

/// Returns `true` if the selected method can run scenes and its tolerance is known for this scene.
pub(crate) fn can_use(app: &App) -> bool {
    let tab = &app.pages.numerics.accuracy;
    tab.usable().is_some() && !tab.report.is_stale(&accuracy_scene(app))
}

/// Sets the scene's tolerance to the one with which `auto` reaches the first target accuracy.
fn use_method(app: &mut App) {
    let tab = &app.pages.numerics.accuracy;
    let method = tab.method();
    if tab.report.is_stale(&accuracy_scene(app)) || tab.report.result.is_none() {
        return app.refuse(nothing::<MethodBenchmark>(app, BEING_COMPUTED, None));
    }
    let mut scene = (*app.scene).clone();
    let name = method.name();
    if method != Method::Auto {
        return app.refuse(format!(
            "{name} is here for comparison: a scene is run by auto, which chooses the method"
        ));
    }
    let Some(tolerance) = tab.usable() else {
        if !tab.report.is_complete() {
            return app.refuse(not_yet(app, app.jobs.running::<MethodBenchmark>()));
        }
        return app.refuse(format!("{name} does not reach an error of 1e-6 here"));
    };
    scene.run.tolerance = tolerance;
    let what = format!("{name}: tolerance {tolerance:.0e} gives 1e-6");
    if scene == *app.scene {
        return app.report_progress(format!("the scene has this already: {what}"));
    }
    edit::commit_scene(app, scene, format!("use {what}"), None);
    app.report_progress(format!("{what} (<undo> undoes)"));
}

pub(crate) fn report(app: &mut App, running: &Running, news: &ReportBody) {
    let tab = &mut app.pages.numerics.accuracy;
    let is_kept = tab.report.keep(running, news);
    if is_kept && news.is_last() && !tab.report.is_complete() && !running.is_look {
        app.report_progress(jobs::CANCELLED);
    }
}

/// Draws the recommendation, the chart beside the methods or alone, and the gain of omitting terms.
pub(crate) fn draw(app: &App, body: Rect, canvas: &mut Canvas<'_>) {
    let (answer, rest) = split_top(body, ANSWER_ROWS);
    let room = usize::from(body.width.saturating_sub(2));
    let mut answers = accuracy_answers(app).into_iter();
    let first = answers.next().unwrap_or_default();
    let below: Vec<String> = answers.flat_map(|line| wrap(&line, room)).collect();
    let lines = u16::try_from(below.len()).unwrap_or(u16::MAX);
    let (top, gains) = split_bottom(rest, lines.clamp(GAIN_ROWS.0, GAIN_ROWS.1));
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
    let Some(mut chart) = tab.report.result.as_deref().and_then(error_over_time) else {
        let inner = PaneFrame::new("Relative error").draw(area, canvas);
        let text = nothing::<MethodBenchmark>(app, "measuring the first points", None);
        return canvas.put_centred(inner, &text);
    };
    let is_old = tab.report.is_stale(&accuracy_scene(app));
    chart.title = if is_old { "Relative error, of another scene" } else { "Relative error" }.into();
    let methods = tab.report.result.iter().flat_map(|report| &report.methods);
    for (report, curve) in methods.zip(&mut chart.curves) {
        curve.emphasis = emphasis(is_old, report.method == tab.method());
    }
    chart.focused = app.dialog.is_none();
    canvas.draw(&chart, area);
}

/// Draws the table, and below it a description of the selected method.
fn methods(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let tab = &app.pages.numerics.accuracy;
    let methods: &[MethodReport] = tab.report.result.as_ref().map_or(&[], |report| &report.methods);
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
    let details = accuracy_details(app).into_iter();
    let lines = details.flat_map(|(text, role)| wrapped(&text, inner.width, role));
    let lines: Vec<TextLine> = lines.collect();
    let from = 1 + u16::try_from(count).unwrap_or(u16::MAX);
    let room = usize::from(inner.height.saturating_sub(from));
    let blank = u16::from(lines.len() < room);
    // Omit a heading without rows.
    if room > 1 {
        canvas.put_lines(inner, from + blank, lines);
    }
}
