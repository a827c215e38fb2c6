//! Pareto front: setup, request, and presentation of the result.

use crate::tui::app::notice::outside;
use crate::tui::chart::{Axis, Chart, Curve, Emphasis, Legend};
use crate::tui::pages::explore::state::placed;
use crate::tui::pages::page::prelude::*;
use crate::tui::pages::search::Study;
use crate::tui::pages::search::results::search_is_old;
use crate::tui::pages::search::results::{axes, place};
use crate::tui::pages::search::setup::{OBJECTIVES, brief};
use crate::tui::pages::search::state::{RESULTS, Row, Searching};
use crate::tui::pages::search::study_page::{Answer, note};
use crate::worker::studies::SearchRequest;
use cmra_studies::report::front::{lacks, name, page_keys, table, unheld, warnings};
use cmra_studies::report::table::Cells;
use cmra_studies::study::quantities::named;
use cmra_studies::study::search::front::{self, DEFAULT, Design, FrontReport, Objective};
use cmra_studies::study::sweep;
use cmra_studies::study::validity::counted;

pub(super) const STUDY: Study = Study {
    synonyms: "optimise optimize best designs knee trade-off",
    file: "front",
    rows,
    request,
};

fn rows(app: &App) -> Vec<Row> {
    let mut rows = vec![Row::Heading("Minimise")];
    let exists = |at: &usize| named(DEFAULT[*at]).is_ok_and(|it| it.exists(&app.scene));
    rows.extend((0..OBJECTIVES.len()).filter(exists).map(Row::Objective));
    rows.extend([Row::Bounds, Row::Feasible, Row::Heading("Vary")]);
    rows.extend(app.bound_rows());
    rows.extend([Row::Heading("Effort"), Row::Designs]);
    rows
}

fn request(app: &App) -> Result<SearchRequest, String> {
    let over = app.varied()?;
    let setup = &app.pages.search.setup;
    let chosen = DEFAULT.into_iter().zip(setup.objectives).filter(|(_, is_chosen)| *is_chosen);
    let objectives = chosen.map(|(name, _)| Objective::new(name, false));
    let objectives: Vec<Objective> =
        objectives.collect::<Result<_, _>>().map_err(|error| error.to_string())?;
    let exists = |it: &Objective| it.measure.exists(&app.scene);
    let objectives: Vec<Objective> = objectives.into_iter().filter(exists).collect();
    if objectives.is_empty() {
        return Err(
            "no objective is chosen: <right> on depth, stroke, mass or mount force".to_owned()
        );
    }
    Ok(SearchRequest::Front(front::Request {
        over,
        objectives,
        subject_to: app.search_constraints(),
        is_feasible: setup.feasible,
        samples: setup.designs,
    }))
}

impl Answer for FrontReport {
    fn over(&self) -> &[sweep::Axis] {
        &self.request.over
    }

    fn effort(&self) -> Option<String> {
        Some(format!("{} designs after {} runs", self.designs.len(), self.runs))
    }

    fn choices(&self) -> usize {
        self.designs.len()
    }

    fn design(&self, app: &App) -> Result<LabelledScene, String> {
        let selected = app.pages.search.selected();
        let none = "no design to load: relax a constraint or a bound";
        let design = self.designs.get(selected).ok_or(none)?;
        let values = self.request.over.iter().zip(design.values.iter().copied());
        let label = format!("design {} of the front", selected + 1);
        Ok(LabelledScene { label, ..placed((*app.scene).clone(), values) })
    }

    fn readout(&self, app: &App) -> Option<String> {
        let tab = &app.pages.search;
        let design = self.designs.get(tab.selected())?;
        let request = &self.request;
        let values = request.over.iter().zip(&design.values);
        let values =
            values.map(|(axis, value)| format!("{} {}", axis.symbol(), significant(*value, 3)));
        let values: Vec<String> = values.collect();
        let (at, count) = (tab.selected() + 1, self.designs.len());
        let results = self::values(self, design, usize::MAX);
        let knee = if tab.knee() == Some(tab.selected()) {
            let (across, up) = axes(self);
            let [across, up] = [across, up].map(|axis| brief(request.measures()[axis]));
            format!(", knee of {across} and {up}")
        } else {
            String::new()
        };
        Some(format!("#{at}/{count}{knee}, {}: {results}", values.join(" ")))
    }

    fn validity(&self, _app: &App) -> Option<StatusPart> {
        if self.designs.len() == 1 {
            return outside(self.outside.iter().map(|(check, _)| *check), " of the design");
        }
        (!self.outside.is_empty()).then(|| {
            let list = format!("of {} designs: {}", self.designs.len(), counted(&self.outside));
            part(Severity::Warning, format!("! validity {list}"))
        })
    }

    fn answer(&self, app: &App, _width: usize) -> Vec<TextLine> {
        let tab = &app.pages.search;
        if self.designs.is_empty() {
            let lacks = lacks(self).into_iter();
            return lacks.map(|text| (text, Role::Warning)).collect();
        }
        let knee = tab.knee().and_then(|at| self.designs.get(at));
        let knee = knee.map(|design| format!("knee: {}", values(self, design, 2)));
        let count = match self.designs.len() {
            1 => "1 design".to_owned(),
            count => format!("{count} designs"),
        };
        let all = note([Some(count), knee].into_iter().flatten().collect::<Vec<_>>().join(", "));
        let unheld = unheld(self, 0..self.designs.len());
        let unheld = unheld.map(|text| (text.to_owned(), Role::Warning));
        std::iter::once(all).chain(unheld).collect()
    }

    fn table(&self, app: &App) -> Vec<Cells> {
        if self.designs.is_empty() { Vec::new() } else { design_cells(&app.pages.search, self) }
    }

    fn csv(&self, _scene: &Scene, name: &str, reach: Reach) -> String {
        table(name, self).with_warnings(&warnings(self)).with_reach(reach).csv()
    }

    fn draws(&self, _tab: &Searching) -> bool {
        !self.designs.is_empty()
    }

    /// Draws the designs as points.
    fn draw(&self, app: &App, area: Rect, canvas: &mut Canvas<'_>) {
        let (across, up) = axes(self);
        let measures = self.request.measures();
        let axis = |label: String, at: usize| {
            let values =
                || self.designs.iter().filter_map(|it| it.measures.get(at).copied().flatten());
            let axis = Axis::fitted(label, measures[at].unit(), values())?;
            // Do not extend the axis below zero for values that are never negative.
            let has_room = values().any(|value| value < 0.0);
            let lo = if has_room { axis.view.lo() } else { axis.view.lo().max(0.0) };
            Some(Axis { view: ViewRange::new(lo, axis.view.hi()), ..axis })
        };
        let axes = axis(brief(measures[across]), across).zip(axis(String::new(), up));
        let Some((x, y)) = axes else { return };
        let title = format!("{} designs: {}", self.designs.len(), brief(measures[up]));
        let title = if search_is_old(app) { format!("{title}, of another setup") } else { title };
        let places = || self.designs.iter().map(|design| place(self, design));
        let selected = places().nth(app.pages.search.selected()).flatten();
        let curves = vec![
            Curve::points('o', "designs", places().flatten()).colour(1),
            Curve::points('X', "", selected).emphasis(Emphasis::Selected),
        ];
        let chart = Chart {
            crosshair: selected.map(|place| place.0),
            legend: Legend::Hidden,
            ..Chart::new(title, x, y, curves)
        };
        let layout = canvas.draw(&chart, area);
        canvas.plot(&layout, |x, _| {
            let away =
                |place: Option<(f64, f64)>| place.map_or(f64::INFINITY, |it| (it.0 - x).abs());
            let near = places().enumerate().min_by(|a, b| away(a.1).total_cmp(&away(b.1)));
            near.map(|(at, _)| Target::Row(RESULTS, at))
        });
    }
}

/// Lists the first results of a design: `depth 1.5 mm, stroke 133 mm`.
fn values(front: &FrontReport, design: &Design, count: usize) -> String {
    let results = design.measures.iter().zip(front.request.measures()).take(count);
    let results = results.filter_map(|(value, column)| {
        Some(format!("{} {}", brief(column), column.show((*value)?, 3)))
    });
    results.collect::<Vec<String>>().join(", ")
}

/// Returns the columns of the table of designs.
fn design_cells(tab: &Searching, front: &FrontReport) -> Vec<Cells> {
    let objectives = front.request.objectives.len();
    let mut keys = page_keys(front);
    // Objectives first, then variables.
    keys[..front.request.over.len() + objectives].rotate_left(front.request.over.len());
    let knee = tab.knee();
    let names = (0..front.designs.len()).map(|at| name(front, at, knee == Some(at))).collect();
    let mut columns = table("", front).cells(&keys);
    columns.insert(0, Cells { head: "no.".to_owned(), is_text: true, cells: names });
    columns
}
