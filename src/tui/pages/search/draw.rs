//! The Search tab: the setup, a chart where there is one to draw, and what was found in words.

use crate::report::figures::axis_of;
use crate::report::front::{designs, standing};
use crate::report::monte_carlo::{perforation, table};
use crate::report::sensitivity::{indices, tornado};
use crate::report::table::Cells;
use crate::report::{self, Remark};
use crate::study::search::front::{Design, Front, Task};
use crate::study::search::seek;
use crate::study::sweep::{self, PointOutcome};
use crate::study::{monte_carlo, sensitivity};
use crate::tui::chart::{Axis, Chart, Curve, Emphasis, Layout, Mark, Unit};
use crate::tui::pages::prelude::*;
use crate::tui::pages::search::setup::brief;
use crate::tui::pages::search::state::{Answer, Page, Request, Searching};
use crate::tui::pages::search::{RESULTS, SETUP};
use crate::tui::widgets::table::Grid;
use crate::tui::widgets::text::{broken, first_row};

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
        Answer::Seek(report) => sought(app, report, top, focused, canvas),
        Answer::Front(..) => front(app, top, focused, canvas),
        Answer::MonteCarlo(_) => histogram(app, top, focused, canvas),
        Answer::Sensitivity(_) => {}
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
    let focused = app.has_focus(RESULTS);
    let height = usize::from(area.height.saturating_sub(2));
    let (has_choices, more) = (app.pages.search.choices() > 0, lines.len() > height);
    let is_table = app.pages.search.page == Page::Front && has_choices;
    let hint = match (is_table, more && !has_choices) {
        // The letters of the chart above.
        (true, _) => format!("S {}, A-E thesis", app.start_word()),
        (false, true) => "<down>/<up>: more".to_owned(),
        (false, false) => String::new(),
    };
    // Where the setup has no room beside, nothing else tells of it.
    let alone = area.width == app.size.0 && !app.is_full();
    let hint = if alone { format!("<next-pane>: setup  {hint}") } else { hint };
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
    let values = report.scan.iter().filter_map(|point| point.1).chain([report.target]);
    let (_, scale) = app.pages.search.scales;
    let y = Axis::fitted("", report.measure.unit(), scale, values);
    let Some(y) = y.filter(|_| points.iter().any(|point| point.1.is_finite())) else {
        let text = "no point has a value".to_owned();
        return lines_below(app, &[(text, Role::Warning)], area, canvas);
    };
    let x = axis_of(&report.axis);
    let x = Axis { view: app.pages.search.zoomed().unwrap_or(x.view), ..x };
    let old = app.search_is_old();
    let emphasis = if old { Emphasis::Stale } else { Emphasis::Normal };
    let curve = Curve::new('*', "", &points).emphasis(emphasis);
    let selected = report.solutions().nth(app.pages.search.selected());
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
        Answer::Seek(report) => {
            let about = report.solutions().nth(tab.selected()).map(|it| it.place.at);
            Some((axis_of(&report.axis), about))
        }
        Answer::Front(_, task) => {
            let (at, designs) = (tab.across(task).0, tab.designs());
            let value = |design: &&Design| design.measures.get(at).copied().flatten();
            let measure = task.measures()[at];
            let values: Vec<f64> = designs.iter().filter_map(value).collect();
            let x = Axis::fitted(brief(measure), measure.unit(), tab.scales.0, values)?;
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
    let x = self::across(tab).map(|(x, _)| x);
    let ups: Vec<f64> = designs.iter().filter_map(|it| value(&it.measures, up)).collect();
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
    let dots = |name: &'static str, colour: usize, places: Vec<Option<(f64, f64)>>| {
        // A gap after every point: no line goes from one to the next.
        let gap = (f64::NAN, f64::NAN);
        let points: Vec<_> = places.into_iter().flatten().flat_map(|it| [it, gap]).collect();
        Curve::new('o', name, points).colour(colour)
    };
    let curves = || {
        let own = designs.iter().map(|it| place(&it.measures)).collect();
        let others = found.candidates.iter().map(|it| place(&it.measures)).collect();
        vec![dots("designs", 0, own), dots("the scene and the thesis's designs", 1, others)]
    };
    let layout = canvas.draw_with_picture(&chart, area, curves);
    for design in &designs {
        mark(place(&design.measures), "o", Role::Curve(1), &layout, canvas);
    }
    for (letter, candidate) in LETTERS.iter().zip(&found.candidates) {
        let letter = letter.to_string();
        mark(place(&candidate.measures), &letter, Role::Curve(3), &layout, canvas);
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
    let Some((_, summary)) = app.sampled() else { return };
    let sorted = &summary.sorted;
    let (Some(least), Some(most)) = (sorted.first(), sorted.last()) else {
        let text = "no sample has this result: Tab, then another one under Show".to_owned();
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
    let label = summary.measure.title();
    let values = sorted.iter().copied();
    let x = Axis::fitted(label, summary.measure.unit(), Scale::Linear, values);
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

/// Letters of the scene and the designs of the thesis on a front.
pub(crate) const LETTERS: [char; 6] = ['S', 'A', 'B', 'C', 'D', 'E'];

fn note(text: String) -> TextLine {
    (text, Role::Text)
}

impl App {
    /// What the page shown says in words, without what its chart draws.
    pub fn search_lines(&self, width: usize) -> Vec<TextLine> {
        let Some(found) = self.pages.search.shown() else { return Vec::new() };
        match &*found.answer {
            Answer::Seek(report) => {
                broken(sought_lines(report, self.pages.search.selected()), width)
            }
            Answer::Front(front, task) => {
                let mut lines = self.designs_table(front, task, width);
                lines.extend(broken(self.candidates(front, task, width), width));
                lines
            }
            Answer::Sensitivity(report) if report.is_empty() => {
                broken(matters(report, width), width)
            }
            Answer::Sensitivity(report) => matters(report, width),
            Answer::MonteCarlo(report) => sampled(report, self.pages.search.setup.output, width),
        }
    }

    /// The measure that the Monte Carlo page draws, with its values.
    pub fn sampled(&self) -> Option<(&monte_carlo::Report, &monte_carlo::Summary)> {
        let found = self.pages.search.found[Page::MonteCarlo as usize].as_ref();
        let Some(Answer::MonteCarlo(report)) = found.map(|found| &*found.answer) else {
            return None;
        };
        let name = self.pages.search.setup.output;
        let summary = report.summaries.iter().find(|summary| summary.measure.name == name)?;
        Some((report, summary))
    }
}

impl App {
    /// The designs of the front as a table: a heading, then one row for each design; `*` marks the column it is sorted by.
    fn designs_table(&self, front: &Front, task: &Task, width: usize) -> Vec<TextLine> {
        let tab = &self.pages.search;
        let measures: Vec<&'static str> = task.measures().iter().map(|it| it.name).collect();
        let (objectives, others) = measures.split_at(task.objectives.len().min(measures.len()));
        let axes = task.axes.iter().map(sweep::Axis::symbol);
        let keys: Vec<&str> =
            objectives.iter().copied().chain(axes).chain(others.iter().copied()).collect();
        let order = tab.order();
        let knee = tab.knee();
        let name =
            |at: usize| if knee == Some(at) { "knee".to_owned() } else { (at + 1).to_string() };
        let names = (0..order.len()).map(name).collect();
        let mut columns = designs(task, front, order.into_iter()).cells(&keys);
        if let Some(sorted) =
            keys.iter().position(|key| Some(key) == measures.get(tab.sorted(task)))
        {
            columns[sorted].head.insert(0, '*');
        }
        columns.insert(0, Cells { head: "no.".to_owned(), is_text: true, cells: names });
        let room = u16::try_from(width.saturating_sub(2)).unwrap_or(u16::MAX);
        let rows = columns[0].cells.len();
        let grid = Grid::of(columns, room, 0);
        let mut lines = vec![note(format!("  {}", grid.line(None)))];
        for at in 0..rows {
            let mark = if at == tab.selected() { ">" } else { " " };
            lines.push(note(format!("{mark} {}", grid.line(Some(at)))));
        }
        lines.push(note("X cursor, o design; and for comparison:".to_owned()));
        lines
    }

    /// What the first letter of a front stands for: the scene, until another design of the front is loaded.
    fn start_word(&self) -> &'static str {
        let here = self.pages.search.front().is_none_or(|(front, task)| {
            task.axes.iter().all(|axis| axis.get(&front.base) == axis.get(&self.scene))
        });
        if here { "scene" } else { "start of search" }
    }

    fn candidates(&self, front: &Front, task: &Task, width: usize) -> Vec<TextLine> {
        if front.candidates.is_empty() {
            return vec![note(format!("generation {}: the front so far", front.generations))];
        }
        let mut lines = Vec::new();
        for (letter, candidate) in LETTERS.iter().zip(&front.candidates) {
            let (words, role) = line(standing(candidate, task));
            let is_start = *letter == LETTERS[0];
            let name = if is_start { self.start_word() } else { candidate.name };
            let name = format!("{letter} {name:18}");
            let measures = task.measures();
            let value = |at: usize| {
                let found = candidate.measures.get(at).copied().flatten();
                format!("{} {}", brief(measures[at]), measures[at].show_any(found, 3))
            };
            let found: Vec<String> = task.shown().into_iter().map(value).collect();
            let values = found.join(", ");
            let long = format!("{name} {words}; {values}");
            let text = if long.chars().count() <= width { long } else { format!("{name} {words}") };
            lines.push((text, role));
        }
        lines
    }
}

fn sought_lines(report: &seek::Report, selected: usize) -> Vec<TextLine> {
    let all = report.solutions().zip(&report.warnings).enumerate();
    let solutions = all.flat_map(|(index, (found, warnings))| {
        let mark = if index == selected { ">" } else { " " };
        let solution = note(format!("{mark} {}", report::seek::solution(report, found)));
        let warnings = warnings.iter().map(|text| (format!("! {text}"), Role::Warning));
        // There is room for the warnings of one solution.
        let warnings = warnings.filter(move |_| index == selected);
        std::iter::once(solution).chain(warnings)
    });
    solutions.chain(report::seek::remarks(report).into_iter().map(line)).collect()
}

/// Words about a result as a line.
fn line(remark: Remark) -> TextLine {
    (remark.text, if remark.is_caution { Role::Warning } else { Role::Text })
}

fn matters(report: &sensitivity::Report, width: usize) -> Vec<TextLine> {
    let output = report.output;
    let own = output.show_any(report.own, 3);
    let mut lines =
        vec![note(format!("{}; the scene: {own}", output.title())), note(String::new())];
    lines.push(note("one variable at a time, from low to high end".to_owned()));
    if report.is_empty() {
        let text = "nothing to compare: no run has this result; Tab, then Of: choose another one";
        return vec![lines.remove(0), (text.to_owned(), Role::Warning)];
    }
    let keys = ["variable", "output_at_low", "output_at_high", "bar"];
    let bar = width.saturating_sub(36).clamp(4, 40);
    lines.extend(table_lines(tornado(report, bar).cells(&keys), width));
    lines.push(note(String::new()));
    let keys = ["variable", "morris_mu_star", "sobol_first", "sobol_total"];
    lines.extend(table_lines(indices(report).cells(&keys), width));
    if let Some(sobol) = &report.sobol {
        let left = sobol.rows - sobol.used;
        if left > 0 {
            let text = format!("{left} of {} rows without a value are not drawn", sobol.rows);
            lines.push((text, Role::Warning));
        }
    }
    lines
}

fn sampled(report: &monte_carlo::Report, output: &str, width: usize) -> Vec<TextLine> {
    let mut lines = Vec::new();
    lines.extend(perforation(report).map(note));
    let again: usize = report.redrawn.iter().sum();
    let again =
        if again > 0 { format!("; {again} impossible samples drawn again") } else { String::new() };
    lines.push(note(format!("{}{again}", report.outcomes)));
    let mut lines = broken(lines, width);
    let mut table = table("", report);
    table.rows.retain(|summary| summary.deviation.is_some());
    let selected = table.rows.iter().position(|summary| summary.measure.name == output);
    let cells = table.cells(&["output", "q05", "q50", "q95", "nominal"]);
    let mut rows: Vec<TextLine> = table_lines(cells, width).collect();
    if let Some((row, _)) = selected.and_then(|at| rows.get_mut(at + 1)) {
        row.replace_range(..1, ">");
    }
    lines.extend(rows);
    lines
}

/// A table in a given number of columns: its headings, and its rows.
fn table_lines(cells: Vec<Cells>, width: usize) -> impl Iterator<Item = TextLine> {
    let rows = cells.first().map_or(0, |column| column.cells.len());
    let room = u16::try_from(width.saturating_sub(2)).unwrap_or(u16::MAX);
    let grid = Grid::shortened(cells, room);
    std::iter::once(None)
        .chain((0..rows).map(Some))
        .map(move |row| note(format!("  {}", grid.line(row)).trim_end().to_owned()))
}
