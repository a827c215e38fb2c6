//! The Search tab: the setup, a chart where there is one to draw, and what was found in words.

use crate::report::figures::axis_of;
use crate::study::monte_carlo;
use crate::study::search::front::Design;
use crate::study::search::seek;
use crate::study::sweep::PointOutcome;
use crate::tui::chart::{Axis, Chart, Curve, Emphasis, Layout, Mark, Unit};
use crate::tui::pages::prelude::*;
use crate::tui::pages::search::setup::brief;
use crate::tui::pages::search::state::{Page, Request, Searching, StudyResult};
use crate::tui::pages::search::{RESULTS, SETUP};
use crate::tui::widgets::text::first_row;

/// Columns of the histogram's bins.
const BINS: usize = 40;

pub(crate) fn render(app: &App, setup: Rect, results: Rect, canvas: &mut Canvas<'_>) {
    canvas.pane(results, RESULTS);
    app.search_form().render(app, SETUP, setup, canvas);
    let lines = app.search_lines(usize::from(results.width.saturating_sub(2)));
    let Some(found) = app.pages.search.shown() else {
        waiting(app, results, canvas);
        return;
    };
    let below = app.pages.search.words_height(results.height, lines.len());
    if below == results.height {
        lines_below(app, &lines, results, canvas);
        return;
    }
    let (top, rest) = split_bottom(results, below);
    let focused = below == 0 && app.has_focus(RESULTS);
    match &*found.answer {
        StudyResult::Seek(report) => sought(app, report, top, focused, canvas),
        StudyResult::Front(..) => front(app, top, focused, canvas),
        StudyResult::MonteCarlo(_) => histogram(app, top, focused, canvas),
        StudyResult::Sensitivity(_) => {}
    }
    if below == 0 {
        turn(app, top, canvas);
    } else {
        lines_below(app, &lines, rest, canvas);
    }
}

/// Where else to look, in the lower line of a chart that stands alone.
fn turn(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let hint = if app.pane() == SETUP { " <next-pane> " } else { " <full-pane>: in words " };
    let hint = &app.keymap.shown(hint);
    let column = area.width.saturating_sub(columns(hint) + 1);
    canvas.put(area, (column, area.height - 1), hint, Role::Dim);
}

/// The text shown before there are results.
fn waiting(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let title = app.pages.search.page.title();
    let alone = area.width == app.size.0 && !app.is_full();
    let hint = app.keymap.shown(if alone { "<next-pane>: setup" } else { "" });
    let inner = PaneFrame::new(title).right(hint).draw(area, canvas);
    let problem = app.pages.search.problem().map(|_| "see the message below");
    let why = problem.unwrap_or(NO_RESULTS);
    let running = app.jobs.study::<Request>().map(|(_, request)| request.page());
    let is_own = running.is_none_or(|page| page == app.pages.search.page);
    let searching = if is_own { "searching" } else { "waits for another search" };
    canvas.put_centred(inner, &nothing::<Request>(app, searching, Some(why)));
}

fn lines_below(app: &App, lines: &[TextLine], area: Rect, canvas: &mut Canvas<'_>) {
    let old = if app.search_is_old() { ", of another setup" } else { "" };
    let title = format!("{}{old}", app.pages.search.page.title());
    let title = app.pages.search.listing().titled(&title);
    let focused = app.has_focus(RESULTS);
    let height = usize::from(area.height.saturating_sub(2));
    let (has_choices, more) = (app.pages.search.choices() > 0, lines.len() > height);
    let is_table = app.pages.search.page == Page::Front && has_choices;
    let hint = if more && !has_choices { "<down>/<up>: more" } else { "" };
    // Where the setup has no room beside, nothing else tells of it.
    let alone = area.width == app.size.0 && !app.is_full();
    let hint = if alone { format!("<next-pane>: setup  {hint}") } else { hint.to_owned() };
    let hint = app.keymap.shown(&hint);
    let inner = PaneFrame::new(title).right(hint).focused(focused).draw(area, canvas);
    // The heading of a table stays.
    let (head, lines) =
        if is_table { lines.split_at(1.min(lines.len())) } else { (&[][..], lines) };
    let height = height.saturating_sub(head.len());
    let selected = app.pages.search.selected();
    let first = match (more, has_choices) {
        (false, _) => 0,
        (true, true) => first_row(selected.min(lines.len()), height, lines.len()),
        (true, false) => app.pages.search.scrolled().min(lines.len().saturating_sub(height)),
    };
    if let Some((text, _)) = head.first() {
        canvas.put(inner, (0, 0), &clip(text, usize::from(inner.width)), Role::Title);
    }
    let (_, inner) = split_top(inner, u16::try_from(head.len()).unwrap_or(0));
    // The warnings of a solution stand below it.
    let choices = lines.iter().enumerate().filter(|(_, line)| line.1 != Role::Warning);
    let mut choices = choices.map(|(at, _)| at).take(app.pages.search.choices());
    canvas.rows(inner, (first, lines.len()), |line| {
        Some(Target::Row(RESULTS, choices.position(|at| at == line)?))
    });
    for (row, (text, role)) in (0..inner.height).zip(lines.iter().skip(first)) {
        let text = clip(text, usize::from(inner.width));
        canvas.put(inner, (0, row), &text, *role);
        if focused && has_choices && first + usize::from(row) == selected {
            canvas.paint_row(inner, row);
        }
    }
}

fn sought(app: &App, report: &seek::Report, area: Rect, focused: bool, canvas: &mut Canvas<'_>) {
    let points: Vec<(f64, f64)> =
        report.scan.iter().map(|(x, y)| (*x, y.unwrap_or(f64::NAN))).collect();
    let zoomed = app.pages.search.zoomed();
    let seen = report.scan.iter().filter(|point| zoomed.is_none_or(|view| view.contains(point.0)));
    let values = seen.filter_map(|point| point.1).chain([report.target]);
    let (_, scale) = app.pages.search.scales;
    let y = Axis::fitted("", report.measure.unit(), scale, values);
    let Some(y) = y.filter(|_| points.iter().any(|point| point.1.is_finite())) else {
        let text = "no point has a value".to_owned();
        return lines_below(app, &[(text, Role::Warning)], area, canvas);
    };
    let x = axis_of(&report.axis);
    let x = Axis { view: zoomed.unwrap_or(x.view), ..x };
    let old = app.search_is_old();
    let emphasis = if old { Emphasis::Stale } else { Emphasis::Normal };
    let curve = Curve::new('*', "", &points).emphasis(emphasis);
    let selected = app.pages.search.chosen().and_then(|at| report.solutions().nth(at));
    let lines = report.solutions().map(|found| Mark::new(found.place.at, ""));
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
    let layout = canvas.draw(&chart, area);
    for (x, value) in &report.scan {
        let gap = report.of(seek::Kind::Gap).find(|gap| {
            let (a, b) = (gap.place.at, gap.until.map_or(gap.place.at, |it| it.at));
            (a.min(b)..=a.max(b)).contains(x)
        });
        let outcome: Option<PointOutcome> =
            gap.and_then(|gap| gap.outcome).filter(|_| value.is_none());
        if let Some(outcome) = outcome {
            canvas.put_gap(&layout, *x, outcome.letter());
        }
    }
}

/// The axis across of the chart shown, all of it, and where the selected point is on it.
pub(super) fn across(tab: &Searching) -> Option<(Axis<'static>, Option<f64>)> {
    match &*tab.shown()?.answer {
        StudyResult::Seek(report) => {
            let about = tab.chosen().and_then(|at| report.solutions().nth(at));
            let about = about.map(|it| it.place.at);
            Some((axis_of(&report.axis), about))
        }
        StudyResult::Front(front) => {
            let at = tab.across(front).0;
            let value = |design: &Design| design.measures.get(at).copied().flatten();
            let measure = front.request.measures()[at];
            let values: Vec<f64> = front.designs.iter().filter_map(value).collect();
            let x = Axis::fitted(brief(measure), measure.unit(), tab.scales.0, values)?;
            Some((x, tab.chosen().and_then(|at| value(&front.designs[at]))))
        }
        StudyResult::MonteCarlo(_) => {
            let monte_carlo::Summary { measure, sorted, .. } = tab.sampled()?;
            let values = sorted.iter().copied();
            let x = Axis::fitted(measure.title(), measure.unit(), Scale::Linear, values);
            Some((x?, None))
        }
        StudyResult::Sensitivity(_) => None,
    }
}

/// Designs as points.
fn front(app: &App, area: Rect, focused: bool, canvas: &mut Canvas<'_>) {
    let tab = &app.pages.search;
    let Some(found) = tab.front() else { return };
    let (across, up) = tab.across(found);
    let measures = found.request.measures();
    let value = |list: &[Option<f64>], at: usize| list.get(at).copied().flatten();
    let designs = tab.designs();
    let x = self::across(tab).map(|(x, _)| x);
    let ups: Vec<f64> = found.designs.iter().filter_map(|it| value(&it.measures, up)).collect();
    let y = Axis::fitted("", measures[up].unit(), tab.scales.1, ups);
    let Some((x, y)) = x.zip(y) else {
        let text = "no design satisfies every constraint".to_owned();
        return lines_below(app, &[(text, Role::Warning)], area, canvas);
    };
    let x = Axis { view: tab.zoomed().unwrap_or(x.view), ..x };
    let title = format!("{} designs: {}", found.designs.len(), brief(measures[up]));
    let title = if app.search_is_old() { format!("{title}, of another setup") } else { title };
    let selected = designs.get(tab.selected()).and_then(|design| value(&design.measures, across));
    let chart = Chart { focused, crosshair: selected, ..Chart::new(title, x, y, Vec::new()) };
    let place = |list: &[Option<f64>]| Some((value(list, across)?, value(list, up)?));
    let curves = || {
        // A gap after every point: no line goes from one to the next.
        let places = designs.iter().filter_map(|it| place(&it.measures));
        let points: Vec<_> = places.flat_map(|it| [it, (f64::NAN, f64::NAN)]).collect();
        vec![Curve::new('o', "designs", points)]
    };
    let layout = canvas.draw_with_picture(&chart, area, curves);
    for design in &designs {
        mark(place(&design.measures), "o", Role::Curve(1), &layout, canvas);
    }
    if let Some(design) = designs.get(tab.selected()) {
        mark(place(&design.measures), "X", Role::Crosshair, &layout, canvas);
    }
    canvas.points(&layout, designs.iter().map(|it| place(&it.measures)), |at| {
        Target::Row(RESULTS, at)
    });
}

fn mark(at: Option<(f64, f64)>, text: &str, role: Role, layout: &Layout, canvas: &mut Canvas<'_>) {
    if let Some(place) = at.and_then(|(across, up)| layout.place(across, up)) {
        canvas.put(layout.plot, place, text, role);
    }
}

/// How often a value falls into each of some bins, as steps.
fn histogram(app: &App, area: Rect, focused: bool, canvas: &mut Canvas<'_>) {
    let tab = &app.pages.search;
    let Some(summary) = tab.sampled() else { return };
    let sorted = &summary.sorted;
    let (Some(least), Some(most)) = (sorted.first(), sorted.last()) else {
        let text = "no sample has this result: <next-pane>, then another one under Show";
        let text = app.keymap.shown(text);
        return lines_below(app, &[(text, Role::Warning)], area, canvas);
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
    let x = across(tab).map(|(x, _)| Axis { view: tab.zoomed().unwrap_or(x.view), ..x });
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
        ..Chart::new("samples per bin", x, y, vec![Curve::new('*', "", &steps)])
    };
    canvas.draw(&chart, area);
}
