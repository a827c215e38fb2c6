//! Goal seek: setup, request, and presentation of the result.

use crate::tui::app::notice::outside;
use crate::tui::chart::{Axis, Chart, Curve, Mark, emphasis};
use crate::tui::pages::explore::state::placed;
use crate::tui::pages::page::prelude::*;
use crate::tui::pages::search::Study;
use crate::tui::pages::search::state::{RESULTS, Row, Searching};
use crate::tui::pages::search::study_page::{Answer, line, note};
use crate::tui::widgets::axis::Part;
use crate::tui::widgets::text::broken;
use crate::worker::studies::SearchRequest;
use cmra_studies::report::figures::axis_of;
use cmra_studies::report::seek::{remarks, solution, table, warnings};
use cmra_studies::study::quantities::named;
use cmra_studies::study::search::seek::{self, Goal, SCAN, SeekReport};
use cmra_studies::study::sweep;

pub(super) const STUDY: Study = Study {
    title: "Goal seek",
    synonyms: "seek target solve inverse root",
    file: "seek.csv",
    rows,
    request,
};

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

    fn design(&self, app: &App) -> Result<LabelledScene, String> {
        let chosen = self.solutions().nth(app.pages.search.selected());
        let solution = chosen.ok_or("no solution to load: change the goal or the range")?;
        Ok(placed((*app.scene).clone(), [(&self.axis, solution.place.at)]))
    }

    fn readout(&self, app: &App) -> Option<String> {
        let solution = self.solutions().nth(app.pages.search.selected())?;
        let at = self.axis.display(solution.place.at, 5);
        let value = self.measure.show(solution.place.value, 4);
        let loads = if app.pane() == RESULTS { "; <enter> loads it" } else { "" };
        Some(format!("{} {at}: {value}{loads}", self.axis.symbol()))
    }

    fn validity(&self, _app: &App) -> Option<StatusPart> {
        let fails = self.checked.iter().flat_map(|checked| &checked.fails);
        let place = if self.checked.len() > 1 { " of solutions" } else { " of the solution" };
        outside(fails.copied(), place)
    }

    fn lines(&self, app: &App, width: usize) -> Vec<TextLine> {
        let selected = app.pages.search.selected();
        let all = self.solutions().zip(&self.checked).enumerate();
        let solutions = all.flat_map(|(index, (found, checked))| {
            let mark = if index == selected { ">" } else { " " };
            let solution = note(format!("{mark} {}", solution(self, found, checked)));
            let warnings = checked.new.iter().map(|text| (format!("! {text}"), Role::Warning));
            // Only the warnings of the selected solution fit; the status row lists all failed checks.
            let warnings = warnings.filter(move |_| index == selected);
            std::iter::once(solution).chain(warnings)
        });
        let reach = app.pages.search.shown().map_or(Reach::Complete, |kept| kept.reach);
        let lines = solutions.chain(remarks(self, reach).into_iter().map(line)).collect();
        broken(lines, width)
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
        let curve = Curve::new('*', "", &points).emphasis(emphasis(app.search_is_old(), false));
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
