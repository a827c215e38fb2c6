//! Goal seek: setup, request, and presentation of the result.

use crate::tui::app::notice::outside;
use crate::tui::chart::{Axis, Chart, Curve, Mark, emphasis};
use crate::tui::pages::explore::state::placed;
use crate::tui::pages::page::prelude::*;
use crate::tui::pages::search::Study;
use crate::tui::pages::search::results::search_is_old;
use crate::tui::pages::search::state::{RESULTS, Row, Searching};
use crate::tui::pages::search::study_page::{Answer, line, note};
use crate::tui::widgets::axis::Part;
use crate::worker::studies::SearchRequest;
use cmra_studies::report::Remark;
use cmra_studies::report::figures::axis_of;
use cmra_studies::report::seek::{position, remarks, table, warnings};
use cmra_studies::report::table::Cells;
use cmra_studies::study::quantities::named;
use cmra_studies::study::search::seek::{self, Goal, SCAN, SeekReport, SeekResult};
use cmra_studies::study::sweep;
use cmra_studies::study::validity::DesignValidity;
use cmra_studies::study::verdict::Decision;

pub(super) const STUDY: Study =
    Study { synonyms: "seek target solve inverse root", file: "seek", rows, request };

fn rows(_: &App) -> Vec<Row> {
    let mut rows = vec![Row::Heading("Goal"), Row::Result, Row::Goal, Row::Heading("Vary")];
    let parts = [Part::Name, Part::From, Part::To, Part::Spacing, Part::Points];
    rows.extend(parts.map(Row::Axis));
    rows
}

fn request(app: &App) -> Result<SearchRequest, String> {
    let setup = &app.pages.search.setup;
    let over =
        sweep::Axis::from_sweep_axis(&setup.seek, &SCAN).map_err(|error| error.to_string())?;
    let measure = named(setup.goal.0).map_err(|error| error.to_string())?;
    let goal = Goal { measure, target: setup.goal.1 };
    Ok(SearchRequest::Seek(seek::Request { over, goal }))
}

/// Text of a column in the row of a solution.
type Cell<'c> = dyn Fn(&SeekResult, &DesignValidity) -> String + 'c;

/// Returns the remarks of the report: a missing solution, jumps, and gaps.
fn reasons(report: &SeekReport, app: &App) -> impl Iterator<Item = Remark> {
    let reach = app.pages.search.shown().map_or(Reach::Complete, |kept| kept.reach);
    remarks(report, reach).into_iter()
}

impl Answer for SeekReport {
    fn over(&self) -> &[sweep::Axis] {
        std::slice::from_ref(&self.axis)
    }

    fn effort(&self) -> Option<String> {
        Some(format!("{} runs", self.runs))
    }

    fn choices(&self) -> usize {
        self.solutions().count()
    }

    fn has_answer(&self) -> bool {
        self.solutions().chain(self.of_kind(seek::Kind::Jump)).next().is_some()
    }

    fn design(&self, app: &App) -> Result<LabelledScene, String> {
        let chosen = self.solutions().nth(app.pages.search.selected());
        let solution = chosen.ok_or("no solution to load: change the goal or the range")?;
        Ok(placed((*app.scene).clone(), [(&self.axis, solution.place.at)]))
    }

    fn readout(&self, app: &App) -> Option<String> {
        let (at, count) = (app.pages.search.selected() + 1, self.choices());
        let loads = if app.pane() == RESULTS { ": <enter> loads it" } else { "" };
        (count > 0).then(|| format!("solution {at} of {count}{loads}"))
    }

    fn validity(&self, _app: &App) -> Option<StatusPart> {
        let fails = self.checked.iter().flat_map(|checked| &checked.fails);
        let place = if self.checked.len() > 1 { " of solutions" } else { " of the solution" };
        outside(fails.copied(), place)
    }

    fn answer(&self, app: &App, _width: usize) -> Vec<TextLine> {
        let places: Vec<String> = self.solutions().map(|found| position(self, found)).collect();
        if places.is_empty() {
            return reasons(self, app).map(line).take(1).collect();
        }
        let goal = self.measure.show(self.target, 6);
        vec![note(format!("{goal} at {} = {}", self.axis.symbol(), places.join(" and ")))]
    }

    fn table(&self, _app: &App) -> Vec<Cells> {
        let found: Vec<(&SeekResult, &DesignValidity)> =
            self.solutions().zip(&self.checked).collect();
        let column = |head: String, is_text: bool, cell: &Cell<'_>| {
            let cells = found.iter().map(|(one, checked)| cell(one, checked)).collect();
            Cells { head, is_text, cells }
        };
        let at: &Cell<'_> = &|one, _| position(self, one);
        let value: &Cell<'_> = &|one, _| self.measure.show(one.place.value, 6);
        let outcome: &Cell<'_> =
            &|one, _| one.outcome.map_or_else(String::new, |it| it.key().to_owned());
        let plastic: &Cell<'_> =
            &|_, checked| checked.plastic.map_or_else(String::new, |it| it.result(self.measure));
        let verdict: &Cell<'_> = &|_, checked| checked.verdict.decision.word().to_owned();
        let columns = [
            (self.axis.symbol().to_owned(), false, at),
            (self.measure.heading(), false, value),
            ("outcome".to_owned(), true, outcome),
            ("plastic".to_owned(), true, plastic),
            ("verdict".to_owned(), true, verdict),
        ];
        // Columns of a plastic interface and of a verdict are needed only if a row has one.
        let is_needed = |head: &str| match head {
            "plastic" => found.iter().any(|(_, checked)| checked.plastic.is_some()),
            "verdict" => {
                let is_known = |it: &DesignValidity| it.verdict.decision != Decision::NotMeasured;
                found.iter().any(|(_, checked)| is_known(checked))
            }
            _ => true,
        };
        let columns = columns.into_iter().filter(|(head, ..)| is_needed(head));
        columns.map(|(head, is_text, cell)| column(head, is_text, cell)).collect()
    }

    fn remarks(&self, app: &App) -> Vec<TextLine> {
        // The warnings of the selected solution fit; the status row lists all failed checks.
        let checked = self.checked.get(app.pages.search.selected());
        let warnings = checked.into_iter().flat_map(|checked| &checked.new);
        let warnings = warnings.map(|text| (format!("! {text}"), Role::Warning));
        let answered = usize::from(self.solutions().next().is_none());
        warnings.chain(reasons(self, app).skip(answered).map(line)).collect()
    }

    fn csv(&self, scene: &Scene, name: &str, reach: Reach) -> String {
        table(name, self).with_warnings(&warnings(scene, self)).with_reach(reach).csv()
    }

    fn draws(&self, _tab: &Searching) -> bool {
        self.scan.iter().any(|point| point.1.is_some())
    }

    fn draw(&self, app: &App, area: Rect, canvas: &mut Canvas<'_>) {
        let points: Vec<(f64, f64)> =
            self.scan.iter().map(|(x, y)| (*x, y.unwrap_or(f64::NAN))).collect();
        let values = self.scan.iter().filter_map(|point| point.1).chain([self.target]);
        let Some(y) = Axis::fitted("", self.measure.unit(), values) else { return };
        let x = axis_of(&self.axis);
        let curve = Curve::new('*', "", &points).emphasis(emphasis(search_is_old(app), false));
        let selected = self.solutions().nth(app.pages.search.selected());
        let lines = self.solutions().map(|found| Mark::new(found.place.at, ""));
        let goal = format!("goal {}", self.measure.show(self.target, 4));
        let chart = Chart {
            marks: lines.collect(),
            levels: vec![Mark::new(self.target, goal)],
            crosshair: selected.map(|found| found.place.at),
            ..Chart::new(self.measure.title(), x, y, vec![curve])
        };
        let layout = canvas.draw(&chart, area);
        for (x, _) in self.scan.iter().filter(|point| point.1.is_none()) {
            let gap = self.of_kind(seek::Kind::Gap).find(|gap| {
                let (a, b) = (gap.place.at, gap.until.map_or(gap.place.at, |it| it.at));
                (a.min(b)..=a.max(b)).contains(x)
            });
            if let Some(outcome) = gap.and_then(|gap| gap.outcome) {
                canvas.put_gap(&layout, *x, outcome.letter());
            }
        }
    }
}
