//! The Pareto front: its setup, its request, and what was found.

use crate::report::front::{lacks, page_keys, table, warnings};
use crate::report::table::Cells;
use crate::study::search::front::{self, Objective, Report, USUAL};
use crate::study::sweep;
use crate::study::validity::counted;
use crate::tui::app::notice::outside;
use crate::tui::chart::{Axis, Chart, Curve, Emphasis, Legend};
use crate::tui::pages::explore::state::placed;
use crate::tui::pages::page::prelude::*;
use crate::tui::pages::search::Study;
use crate::tui::pages::search::answer::{Answer, note};
use crate::tui::pages::search::draw::lines_below;
use crate::tui::pages::search::setup::{OBJECTIVES, brief};
use crate::tui::pages::search::state::{RESULTS, Row, Searching};
use crate::tui::widgets::table::Grid;
use crate::tui::widgets::text::broken;
use crate::worker::studies::SearchRequest;

pub(super) const STUDY: Study = Study {
    title: "Pareto front",
    synonyms: "optimise optimize best designs knee trade-off",
    file: "front.csv",
    rows,
    request,
};

fn rows(app: &App) -> Vec<Row> {
    let mut rows = vec![Row::Heading("Minimise")];
    rows.extend((0..OBJECTIVES.len()).map(Row::Objective));
    rows.extend([Row::Bounds, Row::Feasible, Row::Heading("Vary")]);
    rows.extend(app.bound_rows());
    rows.extend([Row::Heading("Effort"), Row::Designs]);
    rows
}

fn request(app: &App) -> Result<SearchRequest, String> {
    let over = app.varied()?;
    let setup = &app.pages.search.setup;
    let chosen = app.chosen_objectives().into_iter();
    let objectives = chosen.map(|at| Objective::of(USUAL[at], false));
    let objectives: Vec<Objective> =
        objectives.collect::<Result<_, _>>().map_err(|error| error.to_string())?;
    if objectives.is_empty() {
        return Err(
            "no objective is chosen: <right> on depth, stroke, mass or mount force".to_owned()
        );
    }
    Ok(SearchRequest::Front(front::Request {
        over,
        objectives,
        subject_to: setup.subject_to.clone(),
        is_feasible: setup.feasible,
        samples: setup.designs,
    }))
}

impl Answer for Report {
    fn over(&self) -> &[sweep::Axis] {
        &self.request.over
    }

    fn is_complete(&self) -> bool {
        self.is_complete
    }

    fn effort(&self) -> Option<String> {
        Some(format!("{} designs after {} runs", self.designs.len(), self.runs))
    }

    fn order(&self, tab: &Searching) -> Vec<usize> {
        tab.sorted_places(self)
    }

    fn design(&self, app: &App) -> Result<LabelledScene, String> {
        let tab = &app.pages.search;
        let (designs, none) = (tab.designs(), "no design to load: relax a constraint or a bound");
        let design = designs.get(tab.selected()).ok_or(none)?;
        let values = self.request.over.iter().zip(design.values.iter().copied());
        let number = tab.sorted_places(self).iter().position(|at| Some(*at) == tab.chosen());
        let label = format!("design {} of the front", number.unwrap_or(0) + 1);
        Ok(LabelledScene { label, ..placed((*app.scene).clone(), values) })
    }

    fn readout(&self, app: &App) -> Option<String> {
        let tab = &app.pages.search;
        let design = *tab.designs().get(tab.selected())?;
        let request = &self.request;
        let values = request.over.iter().zip(&design.values);
        let values =
            values.map(|(axis, value)| format!("{} {}", axis.symbol(), significant(*value, 3)));
        let values: Vec<String> = values.collect();
        let results = design.measures.iter().zip(request.measures());
        let results = results.filter_map(|(value, column)| {
            Some(format!("{} {}", brief(column), column.show((*value)?, 3)))
        });
        let (at, count) = (tab.selected() + 1, tab.choices());
        let results = results.collect::<Vec<String>>().join(", ");
        let knee = if tab.selects_knee() { of_knee(tab, self) } else { String::new() };
        Some(format!("#{at}/{count}{knee}, {}: {results}", values.join(" ")))
    }

    fn validity(&self, _app: &App) -> Option<StatusPart> {
        if self.designs.len() == 1 {
            return outside(self.outside.iter().map(|(check, _)| *check), " of the design", "");
        }
        (!self.outside.is_empty()).then(|| {
            let list = format!("of {} designs: {}", self.designs.len(), counted(&self.outside));
            (Severity::Warning, format!("! outside validity, {list}"), format!("! {list}"))
        })
    }

    /// The designs as a table: a heading, then one row for each design; then why there are none.
    fn lines(&self, app: &App, width: usize) -> Vec<TextLine> {
        let (front, tab) = (self, &app.pages.search);
        let (order, selected) = (tab.order(), tab.selected());
        let mut columns = design_cells(tab, front);
        for column in &mut columns {
            column.cells = order.iter().map(|at| column.cells[*at].clone()).collect();
        }
        let room = u16::try_from(width.saturating_sub(2)).unwrap_or(u16::MAX);
        let grid = Grid::new(columns, room, u16::MAX);
        let mut lines = vec![note(format!("  {}", grid.line(None)))];
        for at in 0..order.len() {
            let mark = if at == selected { ">" } else { " " };
            lines.push(note(format!("{mark} {}", grid.line(Some(at)))));
        }
        let lacks = lacks(front).into_iter();
        lines.extend(broken(lacks.map(|text| (text, Role::Warning)).collect(), width));
        lines
    }

    fn csv(&self, _scene: &Scene, name: &str) -> String {
        table(name, self).with_warnings(&warnings(self)).csv()
    }

    fn draws(&self, _tab: &Searching) -> bool {
        !self.designs.is_empty()
    }

    /// Designs as points.
    fn draw(&self, app: &App, area: Rect, canvas: &mut Canvas<'_>) {
        let (found, tab) = (self, &app.pages.search);
        let (across, up) = tab.across(found);
        let measures = found.request.measures();
        let value = |list: &[Option<f64>], at: usize| list.get(at).copied().flatten();
        let designs = tab.designs();
        let axis = |label: String, at: usize| {
            let values: Vec<f64> =
                found.designs.iter().filter_map(|it| value(&it.measures, at)).collect();
            let least = values.iter().copied().fold(f64::INFINITY, f64::min);
            let axis = Axis::fitted(label, measures[at].unit(), values)?;
            // Nothing that is never below zero has room there.
            let lo = if least < 0.0 { axis.view.lo() } else { axis.view.lo().max(0.0) };
            Some(Axis { view: ViewRange::new(lo, axis.view.hi()), ..axis })
        };
        let axes = axis(brief(measures[across]), across).zip(axis(String::new(), up));
        let Some((x, y)) = axes else {
            let text = "no design satisfies every constraint".to_owned();
            return lines_below(app, &[(text, Role::Warning)], area, canvas);
        };
        let title = format!("{} designs: {}", found.designs.len(), brief(measures[up]));
        let title = if app.search_is_old() { format!("{title}, of another setup") } else { title };
        let place = |list: &[Option<f64>]| Some((value(list, across)?, value(list, up)?));
        let selected = designs.get(tab.selected()).and_then(|design| place(&design.measures));
        let places = designs.iter().filter_map(|it| place(&it.measures));
        let curves = vec![
            Curve::points('o', "designs", places).colour(1),
            Curve::points('X', "", selected).emphasis(Emphasis::Selected),
        ];
        let chart = Chart {
            crosshair: selected.map(|place| place.0),
            legend: Legend::Hidden,
            ..Chart::new(title, x, y, curves)
        };
        let layout = canvas.draw(&chart, area);
        canvas.points(&layout, designs.iter().map(|it| place(&it.measures)), |at| {
            Target::Row(RESULTS, at)
        });
    }
}

/// The two results whose knee it is.
pub(super) fn of_knee(tab: &Searching, front: &Report) -> String {
    let (across, up) = tab.across(front);
    let [across, up] = [across, up].map(|axis| brief(front.request.measures()[axis]));
    format!(", knee of {across} and {up}")
}

/// The columns of the table of designs, by their places.
pub(crate) fn design_cells(tab: &Searching, front: &Report) -> Vec<Cells> {
    let objectives = front.request.objectives.len();
    let mut keys = page_keys(front);
    // The objectives first, then the variables.
    keys[..front.request.over.len() + objectives].rotate_left(front.request.over.len());
    let count = front.designs.len();
    let mut names = vec![String::new(); count];
    let knee = tab.knee();
    for (number, at) in tab.sorted_places(front).into_iter().enumerate() {
        let is_knee = knee == Some(at);
        names[at] = if is_knee { "knee".to_owned() } else { (number + 1).to_string() };
    }
    let mut columns = table("", front).cells(&keys);
    columns.insert(0, Cells { head: "no.".to_owned(), is_text: true, cells: names });
    columns
}
