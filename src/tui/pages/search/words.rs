//! The Search tab in words: its results as lines and tables, of which the rows are listed that match a text.

use crate::report::front::table as front_table;
use crate::report::monte_carlo::{perforation, table};
use crate::report::sensitivity::{indices, tornado};
use crate::report::table::{Cells, Table};
use crate::report::{self, Remark};
use crate::study::search::front::Front;
use crate::study::search::seek;
use crate::study::validity::counted;
use crate::study::{monte_carlo, sensitivity};
use crate::tui::app::status::outside;
use crate::tui::pages::prelude::*;
use crate::tui::pages::search::setup::brief;
use crate::tui::pages::search::state::{Searching, StudyResult};
use crate::tui::widgets::table::{Grid, Listing, NO_MATCH};
use crate::tui::widgets::text::broken;

fn note(text: String) -> TextLine {
    (text, Role::Text)
}

impl App {
    /// What the page shown says in words, without what its chart draws.
    pub fn search_lines(&self, width: usize) -> Vec<TextLine> {
        let Some(found) = self.pages.search.shown() else { return Vec::new() };
        match &*found.answer {
            StudyResult::Seek(report) => broken(self.sought_lines(report), width),
            StudyResult::Front(front) => {
                let mut lines = self.designs_table(front, width);
                let lacks = report::front::lacks(front).into_iter();
                lines.extend(broken(lacks.map(|text| (text, Role::Warning)).collect(), width));
                lines
            }
            StudyResult::Sensitivity(report) if report.is_empty() => {
                broken(self.matters(report, width), width)
            }
            StudyResult::Sensitivity(report) => self.matters(report, width),
            StudyResult::MonteCarlo(report) => self.samples(report, width),
        }
    }
}

impl App {
    /// The designs of the front as a table: a heading, then one row for each design; `*` marks the column it is sorted by.
    fn designs_table(&self, front: &Front, width: usize) -> Vec<TextLine> {
        let tab = &self.pages.search;
        let (order, selected) = (tab.order(), tab.selected());
        let mut columns = design_cells(tab, front);
        for column in &mut columns {
            column.cells = order.iter().map(|at| column.cells[*at].clone()).collect();
        }
        let room = u16::try_from(width.saturating_sub(2)).unwrap_or(u16::MAX);
        let grid = Grid::of(columns, room, 0);
        let mut lines = vec![note(format!("  {}", grid.line(None)))];
        for at in 0..order.len() {
            let mark = if at == selected { ">" } else { " " };
            lines.push(note(format!("{mark} {}", grid.line(Some(at)))));
        }
        lines.extend(self.no_match(order.is_empty() && !front.designs.is_empty()));
        lines
    }

    /// A line that says that no row matches, where that is so.
    fn no_match(&self, is_so: bool) -> Option<TextLine> {
        is_so.then(|| (self.keymap.shown(NO_MATCH), Role::Dim))
    }
}

impl App {
    fn sought_lines(&self, report: &seek::Report) -> Vec<TextLine> {
        let tab = &self.pages.search;
        let (order, selected) = (tab.order(), tab.selected());
        let all: Vec<_> = report.solutions().zip(&report.checked).collect();
        let is_empty = order.is_empty() && !all.is_empty();
        let listed = order.iter().map(|at| all[*at]).enumerate();
        let solutions = listed.flat_map(|(index, (found, checked))| {
            let mark = if index == selected { ">" } else { " " };
            let solution =
                note(format!("{mark} {}", report::seek::solution(report, found, checked)));
            let warnings = checked.new.iter().map(|text| (format!("! {text}"), Role::Warning));
            // There is room for the warnings of one solution; the status has every check that fails.
            let warnings = warnings.filter(move |_| index == selected);
            std::iter::once(solution).chain(warnings)
        });
        let solutions = solutions.chain(self.no_match(is_empty));
        solutions.chain(report::seek::remarks(report).into_iter().map(line)).collect()
    }

    fn matters(&self, report: &sensitivity::Report, width: usize) -> Vec<TextLine> {
        let output = report.output;
        let own = output.show_any(report.own, 3);
        let mut lines = vec![note(format!("{}; the scene: {own}", output.title()))];
        let condition = report::sensitivity::condition(report);
        lines.extend(condition.map(|text| (text, Role::Warning)));
        lines.push(note(String::new()));
        lines.push(note("one variable at a time, from low to high end".to_owned()));
        if report.is_empty() {
            let text = "nothing to compare: no run has this result; <next-pane>, then Of: choose another one";
            return vec![lines.remove(0), (self.keymap.shown(text), Role::Warning)];
        }
        let listing = self.pages.search.listing();
        let bar = width.saturating_sub(36).clamp(4, 40);
        lines.extend(table_lines(&tornado(report, bar), &TORNADO, listing, width));
        lines.push(note(String::new()));
        lines.extend(table_lines(&indices(report), &INDICES, listing, width));
        lines
    }

    fn samples(&self, report: &monte_carlo::Report, width: usize) -> Vec<TextLine> {
        let mut lines = Vec::new();
        lines.extend(perforation(report).map(note));
        let again: usize = report.redrawn.iter().sum();
        let again = if again > 0 {
            format!("; {again} impossible samples drawn again")
        } else {
            String::new()
        };
        lines.push(note(format!("{}{again}", report.outcomes)));
        let mut lines = broken(lines, width);
        let mut table = table("", report);
        table.rows.retain(|summary| summary.deviation.is_some());
        let listing = self.pages.search.listing();
        let listed = listing.order(&table, &QUANTILES);
        let output = self.pages.search.setup.output;
        let selected = listed.iter().position(|at| table.rows[*at].measure.name == output);
        let mut rows: Vec<TextLine> = table_lines(&table, &QUANTILES, listing, width).collect();
        if let Some((row, _)) = selected.and_then(|at| rows.get_mut(at + 1)) {
            row.replace_range(..1, ">");
        }
        rows.extend(self.no_match(listed.is_empty() && !table.rows.is_empty()));
        lines.extend(rows);
        lines
    }
}

/// What of the designs of an answer is outside validity; the scene, where the answer is no design.
pub(super) fn validity_of(app: &App, answer: Option<&StudyResult>) -> Option<StatusPart> {
    match answer {
        Some(StudyResult::Seek(report)) => {
            let fails = report.checked.iter().flat_map(|checked| &checked.fails);
            let place = if report.checked.len() > 1 { " of solutions" } else { " of the solution" };
            outside(fails.copied(), place, "")
        }
        Some(StudyResult::Front(front)) if front.designs.len() == 1 => {
            outside(front.outside.iter().map(|(check, _)| *check), " of the design", "")
        }
        Some(StudyResult::Front(front)) => (!front.outside.is_empty()).then(|| {
            let list = format!("of {} designs: {}", front.designs.len(), counted(&front.outside));
            (Severity::Warning, format!("! outside validity, {list}"), format!("! {list}"))
        }),
        Some(StudyResult::Sensitivity(_) | StudyResult::MonteCarlo(_)) | None => {
            app.validity_part()
        }
    }
}

/// Words about a result as a line.
fn line(remark: Remark) -> TextLine {
    (remark.text, if remark.is_caution { Role::Warning } else { Role::Text })
}

/// The two results whose knee it is.
pub(super) fn of_knee(tab: &Searching, front: &Front) -> String {
    let (across, up) = tab.across(front);
    let [across, up] = [across, up].map(|axis| brief(front.request.measures()[axis]));
    format!(", knee of {across} and {up}")
}

/// The columns of the table of designs, by their places; `*` marks the one it is sorted by.
pub(crate) fn design_cells(tab: &Searching, front: &Front) -> Vec<Cells> {
    let measures = front.request.measures();
    let objectives = front.request.objectives.len();
    let mut keys = report::front::page_keys(front);
    // The objectives first, then the variables.
    keys[..front.request.over.len() + objectives].rotate_left(front.request.over.len());
    let count = front.designs.len();
    let mut names = vec![String::new(); count];
    let knee = tab.knee();
    for (number, at) in tab.sorted_places(front).into_iter().enumerate() {
        let is_knee = knee == Some(at);
        names[at] = if is_knee { "knee".to_owned() } else { (number + 1).to_string() };
    }
    let mut columns = front_table("", front).cells(&keys);
    if let Some(sorted) = keys.iter().position(|key| *key == measures[tab.sorted(front)].name) {
        columns[sorted].head.insert(0, '*');
    }
    columns.insert(0, Cells { head: "no.".to_owned(), is_text: true, cells: names });
    columns
}

/// The columns shown of a sensitivity study, and of a Monte Carlo one.
const TORNADO: [&str; 4] = ["variable", "output_at_low", "output_at_high", "bar"];
const INDICES: [&str; 3] = ["variable", "sobol_first", "sobol_total"];
const QUANTILES: [&str; 5] = ["output", "q05", "q50", "q95", "nominal"];

/// The places in the exported table of the rows that are listed; `None` where all are.
pub(super) fn listed_rows(tab: &Searching) -> Option<Vec<usize>> {
    let listing = tab.listing();
    if listing.filter.is_empty() {
        return None;
    }
    Some(match &*tab.shown()?.answer {
        StudyResult::Front(..) => tab.order(),
        StudyResult::Seek(report) => {
            let lines = report.lines.iter().enumerate().filter(|(_, it)| it.kind.is_solution());
            let solutions: Vec<usize> = lines.map(|(at, _)| at).collect();
            tab.order().into_iter().map(|at| solutions[at]).collect()
        }
        StudyResult::Sensitivity(report) => {
            let (bars, indices) = (tornado(report, 0), indices(report));
            let listed = |rows: &[usize], places: Vec<usize>| {
                places.into_iter().map(|at| rows[at]).collect::<Vec<usize>>()
            };
            let mut axes = listed(&bars.rows, listing.order(&bars, &TORNADO));
            axes.extend(listed(&indices.rows, listing.order(&indices, &INDICES)));
            let order = report.order().into_iter().enumerate();
            order.filter(|(_, axis)| axes.contains(axis)).map(|(at, _)| at).collect()
        }
        StudyResult::MonteCarlo(report) => {
            let table = table("", report);
            let mut listed = listing.order(&table, &QUANTILES);
            listed.retain(|at| table.rows[*at].deviation.is_some());
            listed
        }
    })
}

/// The rows of a table that are listed, in a given number of columns, below their headings.
fn table_lines<R>(
    table: &Table<'_, R>,
    keys: &[&str],
    listing: &Listing,
    width: usize,
) -> impl Iterator<Item = TextLine> {
    let rows = listing.order(table, keys);
    let room = u16::try_from(width.saturating_sub(2)).unwrap_or(u16::MAX);
    let grid = Grid::shortened(table.cells(keys), room);
    std::iter::once(None)
        .chain(rows.into_iter().map(Some))
        .map(move |row| note(format!("  {}", grid.line(row)).trim_end().to_owned()))
}
