//! What was found, as lines of text. No drawing.

use crate::report::front::{designs, standing};
use crate::report::monte_carlo::{perforation, table};
use crate::report::sensitivity::{indices, tornado};
use crate::report::table::Cells;
use crate::report::{self, Remark};
use crate::study::quantities::Quantity;
use crate::study::search::front::{Front, Task};
use crate::study::sensitivity;
use crate::study::sweep::Axis;
use crate::study::{monte_carlo, search::seek};
use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::app::status::wrap;
use crate::tui::pages::search::request::{Answer, Request};
use crate::tui::pages::search::setup::brief;
use crate::tui::pages::search::state::Page;
use crate::tui::widgets::table::Grid;

/// A line, and how it is meant.
pub type Line = (Severity, String);

/// Letters of the scene and the designs of the thesis on a front.
pub const LETTERS: [char; 6] = ['S', 'A', 'B', 'C', 'D', 'E'];

fn note(text: String) -> Line {
    (Severity::Note, text)
}

impl App {
    /// The lines of the page shown; with what is drawn beside them left out.
    pub fn search_lines(&self, width: usize) -> Vec<Line> {
        let Some(found) = self.pages.search.shown() else { return Vec::new() };
        match (&*found.answer, &found.request) {
            (Answer::Seek(report), _) => {
                wrapped(sought(report, self.pages.search.selected()), width)
            }
            (Answer::Front(front), Request::Front(task)) => {
                let mut lines = self.designs_table(front, task, width);
                lines.extend(wrapped(candidates(front, task, width), width));
                lines
            }
            (Answer::Front(_), _) => Vec::new(),
            (Answer::Sensitivity(report), _) if is_empty(report) => {
                wrapped(matters(report, width), width)
            }
            (Answer::Sensitivity(report), _) => matters(report, width),
            (Answer::MonteCarlo(report), _) => {
                sampled(report, self.pages.search.setup.output, width)
            }
        }
    }

    /// The measure that the Monte Carlo page draws, with its values.
    pub fn sampled(&self) -> Option<(&monte_carlo::Report, &monte_carlo::Summary)> {
        let found = self.pages.search.found[Page::MonteCarlo.index()].as_ref();
        let Some(Answer::MonteCarlo(report)) = found.map(|found| &*found.answer) else {
            return None;
        };
        let name = self.pages.search.setup.output;
        let summary = report.summaries.iter().find(|summary| summary.measure.name == name)?;
        Some((report, summary))
    }
}

impl App {
    /// The designs of the front as a table: a heading, then a row a design; `*` marks the column it is sorted by.
    fn designs_table(&self, front: &Front, task: &Task, width: usize) -> Vec<Line> {
        let tab = &self.pages.search;
        let measures: Vec<&'static str> = task.measures().iter().map(|it| it.name).collect();
        let (objectives, others) = measures.split_at(task.objectives.len().min(measures.len()));
        let axes = task.axes.iter().map(Axis::symbol);
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
}

/// Sentences over as many lines as they need.
pub(in crate::tui) fn wrapped(lines: Vec<Line>, width: usize) -> Vec<Line> {
    let split = |(severity, text): Line| {
        let lines = if text.chars().count() <= width { vec![text] } else { wrap(&text, width) };
        lines.into_iter().map(move |line| (severity, line))
    };
    lines.into_iter().flat_map(split).collect()
}

fn sought(report: &seek::Report, selected: usize) -> Vec<Line> {
    let solutions = report.solutions.iter().enumerate().map(|(index, found)| {
        let mark = if index == selected { ">" } else { " " };
        note(format!("{mark} {}", report::seek::solution(report, found)))
    });
    solutions.chain(report::seek::remarks(report).into_iter().map(line)).collect()
}

/// Words about a result as a line.
fn line(remark: Remark) -> Line {
    (if remark.is_caution { Severity::Warning } else { Severity::Note }, remark.text)
}

fn candidates(front: &Front, task: &Task, width: usize) -> Vec<Line> {
    if front.candidates.is_empty() {
        return vec![note(format!("generation {}: the front so far", front.generations))];
    }
    let mut lines = Vec::new();
    for (letter, candidate) in LETTERS.iter().zip(&front.candidates) {
        let (severity, words) = line(standing(candidate, task));
        let name = format!("{letter} {:18}", candidate.name);
        let measures = task.measures();
        let value = |at: usize| {
            let found = candidate.measures.get(at).copied().flatten();
            format!("{} {}", brief(measures[at]), shown(measures[at], found))
        };
        let found: Vec<String> = task.shown().into_iter().map(value).collect();
        let values = found.join(", ");
        let long = format!("{name} {words}; {values}");
        let text = if long.chars().count() <= width { long } else { format!("{name} {words}") };
        lines.push((severity, text));
    }
    lines
}

fn shown(column: &Quantity, value: Option<f64>) -> String {
    value.map_or_else(|| "-".to_owned(), |value| column.show(value, 3))
}

/// Whether neither the scene nor any end of a variable has the result.
fn is_empty(report: &sensitivity::Report) -> bool {
    report.own.is_none() && report.bars.iter().all(|bar| bar.swing().is_none())
}

fn matters(report: &sensitivity::Report, width: usize) -> Vec<Line> {
    let output = report.output;
    let own = shown(output, report.own);
    let mut lines =
        vec![note(format!("{}; the scene: {own}", output.title())), note(String::new())];
    lines.push(note("one at a time, low to high end".to_owned()));
    if is_empty(report) {
        let text = "nothing to compare: no run of these has this result; Tab, then Of: another one";
        return vec![lines.remove(0), (Severity::Warning, text.to_owned())];
    }
    let keys = ["variable", "output_at_low", "output_at_high"];
    let bar = width.saturating_sub(34).clamp(4, 40);
    lines.extend(table_lines(tornado(report, &keys, bar), width));
    lines.push(note(String::new()));
    let keys = ["variable", "morris_mu_star", "sobol_first", "sobol_total"];
    lines.extend(table_lines(indices(report).cells(&keys), width));
    if let Some(sobol) = &report.sobol {
        let left = sobol.rows - sobol.used;
        if left > 0 {
            let text = format!("{left} of {} rows without a value are not drawn", sobol.rows);
            lines.push((Severity::Warning, text));
        }
    }
    lines
}

fn sampled(report: &monte_carlo::Report, output: &str, width: usize) -> Vec<Line> {
    let mut lines = Vec::new();
    lines.extend(perforation(report).map(note));
    let again: usize = report.redrawn.iter().sum();
    let again =
        if again > 0 { format!("; {again} impossible draws made again") } else { String::new() };
    lines.push(note(format!("{}{again}", report.outcomes)));
    let mut table = table("", report);
    table.rows.retain(|summary| !summary.quantiles.is_empty());
    let selected = table.rows.iter().position(|summary| summary.measure.name == output);
    let cells = table.cells(&["output", "q05", "q50", "q95", "nominal"]);
    let mut rows: Vec<Line> = table_lines(cells, width).collect();
    if let Some((_, row)) = selected.and_then(|at| rows.get_mut(at + 1)) {
        row.replace_range(..1, ">");
    }
    lines.extend(rows);
    lines
}

/// A table in so many columns: its headings, and its rows.
fn table_lines(cells: Vec<Cells>, width: usize) -> impl Iterator<Item = Line> {
    let rows = cells.first().map_or(0, |column| column.cells.len());
    let room = u16::try_from(width.saturating_sub(2)).unwrap_or(u16::MAX);
    let grid = Grid::shortened(cells, room);
    std::iter::once(None)
        .chain((0..rows).map(Some))
        .map(move |row| note(format!("  {}", grid.line(row)).trim_end().to_owned()))
}
