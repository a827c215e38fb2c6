//! The Search tab: the setup, a chart where there is one to draw, and what was found in words.

use ratatui::layout::Rect;

use crate::report::figures::axis_of;
use crate::study::quantities::Quantity;
use crate::study::search::front::{Candidate, Design};
use crate::study::search::seek;
use crate::study::sweep::PointOutcome;
use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::app::status::clip;
use crate::tui::chart::{Axis, Chart, Curve, Draw, Emphasis, Layout, Mark, Scale, Unit, ViewRange};
use crate::tui::message::Target;
use crate::tui::pages::search::lines::LETTERS;
use crate::tui::pages::search::request::{Answer, Request};
use crate::tui::pages::search::setup::brief;
use crate::tui::pages::search::state::{Page, Searching};
use crate::tui::pages::search::{RESULTS, SETUP};
use crate::tui::theme::{PaneFrame, Role};
use crate::tui::widgets::Canvas;
use crate::tui::widgets::text::{columns, first_row, paint_row, put, put_centred, text_role};

/// Columns of the histogram's bins.
const BINS: usize = 40;

/// Draw setup and findings.
pub(in crate::tui) fn render(app: &App, (left, right): (Rect, Rect), canvas: &mut Canvas<'_>) {
    canvas.pane(right, RESULTS);
    app.search_form().render(app, SETUP, left, canvas);
    let lines = app.search_lines(usize::from(right.width.saturating_sub(2)));
    let Some(found) = app.pages.search.shown() else {
        nothing(app, right, canvas);
        return;
    };
    let below = app.pages.search.words_height(right.height, lines.len());
    if below == right.height {
        lines_below(app, &lines, right, canvas);
        return;
    }
    let top = Rect { height: right.height - below, ..right };
    let focused = below == 0 && app.has_focus(RESULTS);
    match &*found.answer {
        Answer::Seek(report) => sought(app, report, top, focused, canvas),
        Answer::Front(_) => front(app, top, focused, canvas),
        Answer::MonteCarlo(_) => histogram(app, top, focused, canvas),
        Answer::Sensitivity(_) => {}
    }
    if below == 0 {
        turn(app, top, canvas);
    } else {
        let rest = Rect { y: right.y + top.height, height: below, ..right };
        lines_below(app, &lines, rest, canvas);
    }
}

/// Where else to look, in the lower line of a chart that stands alone.
fn turn(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let hint = if app.pane() == SETUP { " Tab " } else { " z: in words " };
    let column = area.width.saturating_sub(columns(hint) + 1);
    put(canvas, area, (column, area.height - 1), hint, app.theme.style(Role::Dim));
}

/// What stands where nothing has been found yet.
fn nothing(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let title = app.pages.search.page.title();
    let alone = area.width == app.size.0 && !app.is_full();
    let hint = if alone { "Tab: setup" } else { "" };
    let inner = PaneFrame::new(title).right(hint).render(area, canvas, app.theme);
    let text = match (app.jobs.running::<Request>(), &app.pages.search.problem) {
        (Some(_), _) => "searching",
        (None, Some(_)) => "see the message below",
        (None, None) => "No results yet. Press r to search.",
    };
    put_centred(canvas, inner, text, app.theme.style(Role::Dim));
}

fn lines_below(app: &App, lines: &[(Severity, String)], area: Rect, canvas: &mut Canvas<'_>) {
    let old = if app.search_is_old() { ", of another setup: press r" } else { "" };
    let title = format!("{}{old}", app.pages.search.page.title());
    let focused = app.has_focus(RESULTS);
    let height = usize::from(area.height.saturating_sub(2));
    let (has_choices, more) = (app.pages.search.choices() > 0, lines.len() > height);
    let hint = if more && !has_choices { "j/k: more" } else { "" };
    // Where the setup has no room beside, nothing else tells of it.
    let alone = area.width == app.size.0 && !app.is_full();
    let hint = if alone { format!("Tab: setup  {hint}") } else { hint.to_owned() };
    let inner = PaneFrame::new(title).right(hint).focused(focused).render(area, canvas, app.theme);
    // The heading of a table stays.
    let is_table = app.pages.search.page == Page::Front && has_choices;
    let (head, lines) =
        if is_table { lines.split_at(1.min(lines.len())) } else { (&[][..], lines) };
    let height = height.saturating_sub(head.len());
    let selected = app.pages.search.selected();
    let first = match (more, has_choices) {
        (false, _) => 0,
        (true, true) => first_row(selected.min(lines.len()), height, lines.len()),
        (true, false) => app.pages.search.scrolled().min(lines.len().saturating_sub(height)),
    };
    if let Some((_, text)) = head.first() {
        put(
            canvas,
            inner,
            (0, 0),
            &clip(text, usize::from(inner.width)),
            app.theme.style(Role::Title),
        );
    }
    let top = u16::try_from(head.len()).unwrap_or(0);
    let inner = Rect { y: inner.y + top, height: inner.height.saturating_sub(top), ..inner };
    for (row, (severity, text)) in (0..inner.height).zip(lines.iter().skip(first)) {
        let role = text_role(*severity);
        let text = clip(text, usize::from(inner.width));
        put(canvas, inner, (0, row), &text, app.theme.style(role));
        if has_choices && first + usize::from(row) == selected {
            paint_row(canvas, inner, row, app.theme.style(Role::Selection));
        }
    }
}

/// An axis of a measure over values.
fn measure_axis(
    column: &Quantity,
    values: impl Iterator<Item = f64> + Clone,
    log: bool,
    label: String,
) -> Option<Axis<'static>> {
    let scale = if log { Scale::Log10 } else { Scale::Linear };
    Axis::fitted(label, column.unit(), scale, values)
}

fn sought(app: &App, report: &seek::Report, area: Rect, focused: bool, canvas: &mut Canvas<'_>) {
    let points: Vec<(f64, f64)> =
        report.scan.iter().map(|(x, y)| (*x, y.unwrap_or(f64::NAN))).collect();
    let values = report.scan.iter().filter_map(|point| point.1).chain([report.target]);
    let y = measure_axis(report.measure, values, app.pages.search.log.1, String::new());
    let Some(y) = y.filter(|_| points.iter().any(|point| point.1.is_finite())) else {
        return lines_below(
            app,
            &[(Severity::Warning, "no point has a value".to_owned())],
            area,
            canvas,
        );
    };
    let x = axis_of(&report.axis);
    let x = Axis { view: app.pages.search.zoomed.unwrap_or(x.view), ..x };
    let old = app.search_is_old();
    let emphasis = if old { Emphasis::Stale } else { Emphasis::Normal };
    let curve = Curve::new('*', "", &points).emphasis(emphasis);
    let selected = report.solutions.get(app.pages.search.selected());
    let lines = report.solutions.iter().map(|found| Mark::new(found.place.at, ""));
    let chart = Chart {
        focused,
        marks: lines.collect(),
        levels: vec![Mark::new(
            report.target,
            format!("goal {}", report.measure.show(report.target, 4)),
        )],
        crosshair: selected.map(|found| found.place.at),
        ..Chart::new(report.measure.title(), x, y, vec![curve])
    };
    let layout = chart.render(area, canvas, app.theme);
    for (x, value) in &report.scan {
        let outcome = report.gaps.iter().find(|gap| {
            let (a, b) = if gap.from < gap.to { (gap.from, gap.to) } else { (gap.to, gap.from) };
            (a..=b).contains(x)
        });
        let outcome: Option<PointOutcome> =
            outcome.map(|gap| gap.outcome).filter(|_| value.is_none());
        let Some((outcome, cell)) = outcome.zip(layout.x.cell(*x)) else { continue };
        let foot = (cell, layout.plot.height.saturating_sub(1));
        put(
            canvas,
            layout.plot,
            foot,
            &outcome.letter().to_string(),
            app.theme.style(Role::Warning),
        );
    }
}

/// The axis across of the chart shown, all of it, and where the selected point is on it.
pub(super) fn across(tab: &Searching) -> Option<(Axis<'static>, Option<f64>)> {
    match &*tab.shown()?.answer {
        Answer::Seek(report) => {
            let about = report.solutions.get(tab.selected()).map(|it| it.place.at);
            Some((axis_of(&report.axis), about))
        }
        Answer::Front(_) => {
            let (_, task) = tab.front()?;
            let (at, designs) = (tab.across(task).0, tab.designs());
            let value = |design: &&Design| design.measures.get(at).copied().flatten();
            let measure = task.measures()[at];
            let values: Vec<f64> = designs.iter().filter_map(value).collect();
            let x = measure_axis(measure, values.into_iter(), tab.log.0, brief(measure))?;
            Some((x, designs.get(tab.selected()).and_then(value)))
        }
        _ => None,
    }
}

/// Designs as points, the scene and the thesis's designs as letters.
fn front(app: &App, area: Rect, focused: bool, canvas: &mut Canvas<'_>) {
    let tab = &app.pages.search;
    let Some((found, task)) = tab.front() else { return };
    let (across, up) = tab.across(task);
    let measures = task.measures();
    let value = |list: &[Option<f64>], at: usize| list.get(at).copied().flatten();
    let designs = tab.designs();
    let all = |at: usize| {
        let own = designs.iter().filter_map(move |design| value(&design.measures, at));
        own.collect::<Vec<f64>>()
    };
    let x = self::across(tab).map(|(x, _)| x);
    let y = measure_axis(measures[up], all(up).into_iter(), tab.log.1, String::new());
    let Some((x, y)) = x.zip(y) else {
        let text = "no design keeps every constraint".to_owned();
        return lines_below(app, &[(Severity::Warning, text)], area, canvas);
    };
    let x = Axis { view: tab.zoomed.unwrap_or(x.view), ..x };
    let title = format!("{} designs: {}", found.designs.len(), brief(measures[up]));
    let title = if app.search_is_old() { format!("{title}, of another setup") } else { title };
    let selected = designs.get(tab.selected()).and_then(|design| value(&design.measures, across));
    let chart = Chart { focused, crosshair: selected, ..Chart::new(title, x, y, Vec::new()) };
    let layout = chart.render(area, canvas, app.theme);
    let place = |list: &[Option<f64>]| Some((value(list, across)?, value(list, up)?));
    for design in &designs {
        mark(app, place(&design.measures), "o", Role::Curve(1), &layout, canvas);
    }
    for (letter, candidate) in LETTERS.iter().zip(&found.candidates) {
        let candidate: &Candidate = candidate;
        let letter = letter.to_string();
        mark(app, place(&candidate.measures), &letter, Role::Curve(3), &layout, canvas);
    }
    if let Some(design) = designs.get(tab.selected()) {
        let design: &Design = design;
        mark(app, place(&design.measures), "X", Role::Crosshair, &layout, canvas);
    }
    canvas.points(&layout, designs.iter().map(|it| place(&it.measures)), |at| {
        Target::Row(RESULTS, at)
    });
}

fn mark(
    app: &App,
    at: Option<(f64, f64)>,
    text: &str,
    role: Role,
    layout: &Layout,
    canvas: &mut Canvas<'_>,
) {
    if let Some(place) = at.and_then(|(across, up)| layout.place(across, up)) {
        put(canvas, layout.plot, place, text, app.theme.style(role));
    }
}

/// How often a value falls into each of some bins, as steps.
fn histogram(app: &App, area: Rect, focused: bool, canvas: &mut Canvas<'_>) {
    let Some((_, summary)) = app.sampled() else { return };
    let sorted = &summary.sorted;
    let (Some(least), Some(most)) = (sorted.first(), sorted.last()) else {
        let text = "no sample has this result: Tab, then another one under Show".to_owned();
        return lines_below(app, &[(Severity::Warning, text)], area, canvas);
    };
    let width = (most - least) / BINS as f64;
    let mut steps = Vec::new();
    for bin in 0..BINS {
        let (from, to) = (least + width * bin as f64, least + width * (bin + 1) as f64);
        let below = |value: f64| sorted.partition_point(|other| *other < value);
        let until = if bin + 1 == BINS { sorted.len() } else { below(to) };
        let percent = 100.0 * (until - below(from)) as f64 / sorted.len() as f64;
        steps.extend([(from, percent), (to, percent)]);
    }
    // Room above for the tags.
    let highest = steps.iter().map(|step| 1.3 * step.1);
    let label = summary.measure.title();
    let x = measure_axis(summary.measure, sorted.iter().copied(), false, label);
    let y = ViewRange::of(Scale::Linear, highest.chain([0.0]));
    let Some((x, y)) = x.zip(y) else { return };
    let y = Axis::new("", y.padded(Scale::Linear, 0.04)).unit(Unit::new("%"));
    let at = |share: f64, tag: &'static str| {
        summary.quantile(share).map(|quantile| Mark::new(quantile.value, tag))
    };
    let chart = Chart {
        focused,
        marks: [at(0.05, "5 %"), at(0.5, "median"), at(0.95, "95 %")]
            .into_iter()
            .flatten()
            .collect(),
        ..Chart::new("samples a bin", x, y, vec![Curve::new('*', "", &steps)])
    };
    chart.render(area, canvas, app.theme);
}
