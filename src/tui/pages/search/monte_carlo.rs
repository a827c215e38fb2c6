//! Monte Carlo: setup, request, and presentation of the result.

use crate::tui::chart::{Axis, Chart, Curve, Mark};
use crate::tui::pages::page::prelude::*;
use crate::tui::pages::search::Study;
use crate::tui::pages::search::state::{Row, Searching, Setup};
use crate::tui::pages::search::study_page::{Answer, note};
use crate::worker::studies::SearchRequest;
use cmra_studies::report::monte_carlo::{
    QUANTILES, drawn_again, perforation, table, titles, warnings,
};
use cmra_studies::report::table::{Cells, Table};
use cmra_studies::study::monte_carlo::{
    DEFAULT_DEVIATION, Estimate, MonteCarloReport, Request, Summary, default_tolerances,
};

/// Number of bins of the histogram.
const BINS: usize = 40;
/// Displayed quantiles, and all displayed columns.
const SHOWN: [&str; 3] = ["q05", "q50", "q95"];
const COLUMNS: [&str; 5] = ["output", SHOWN[0], SHOWN[1], SHOWN[2], "nominal"];

pub(super) const STUDY: Study = Study {
    synonyms: "uncertainty scatter spread distribution histogram",
    file: "montecarlo",
    rows,
    request: |app| Ok(request(app)),
};

fn rows(_: &App) -> Vec<Row> {
    vec![Row::Heading("Every input"), Row::Percent, Row::Samples, Row::Heading("Show"), Row::Output]
}

fn request(app: &App) -> SearchRequest {
    let setup = &app.pages.search.setup;
    let deviation = setup.percent / 100.0;
    let is_usual = (deviation - DEFAULT_DEVIATION).abs() < 1e-12;
    let vary = if is_usual { Vec::new() } else { default_tolerances(&app.scene, deviation) };
    let samples = Some(setup.samples).filter(|it| *it != Setup::default().samples);
    SearchRequest::MonteCarlo(Request { vary, samples, ..Request::default() })
}

/// Returns the measure drawn on the page, with its values.
fn drawn<'r>(report: &'r MonteCarloReport, tab: &Searching) -> Option<&'r Summary> {
    report.summaries.iter().find(|summary| summary.measure.name == tab.setup.output)
}

/// Returns the table of the quantities with values.
fn known(report: &MonteCarloReport) -> Table<'_, &Summary> {
    let mut table = table("", report);
    table.rows.retain(|summary| summary.deviation.is_some());
    table
}

/// Returns the first of two texts if it fits into the columns, else the second one, which wraps.
fn or_wrapped([long, short]: [String; 2], width: usize) -> String {
    if usize::from(columns(&long)) <= width { long } else { short }
}

impl Answer for MonteCarloReport {
    fn effort(&self) -> Option<String> {
        Some(format!("{} samples", self.samples))
    }

    fn has_answer(&self) -> bool {
        self.samples > 0
    }

    fn answer(&self, app: &App, width: usize) -> Vec<TextLine> {
        let shown = drawn(self, &app.pages.search).and_then(|summary| {
            let [low, median, high] = [0.05, 0.5, 0.95].map(|share| summary.quantile(share));
            let show = |it: Estimate| summary.measure.show(it.value, 4);
            let spread = format!("{}, 90 %: {} to {}", show(median?), show(low?), show(high?));
            Some(or_wrapped(titles(self, summary).map(|name| format!("{name} {spread}")), width))
        });
        let through = perforation(self).map(|texts| or_wrapped(texts, width));
        shown.into_iter().chain(through).map(note).collect()
    }

    fn remarks(&self, _app: &App) -> Vec<TextLine> {
        let redrawn = self.redrawn.iter().sum::<usize>() + self.redrawn_together;
        let again = drawn_again(redrawn).map(|text| format!("; {text}"));
        vec![note(format!("{}{}", self.outcomes, again.unwrap_or_default()))]
    }

    fn table(&self, _app: &App) -> Vec<Cells> {
        known(self).cells(&COLUMNS)
    }

    fn brief_names(&self) -> Vec<String> {
        let brief = |summary: &&Summary| {
            let [_, brief] = titles(self, summary);
            brief
        };
        known(self).rows.iter().map(brief).collect()
    }

    fn marked(&self, app: &App) -> Option<usize> {
        let output = app.pages.search.setup.output;
        known(self).rows.iter().position(|row| row.measure.name == output)
    }

    fn csv(&self, scene: &Scene, name: &str, reach: Reach) -> String {
        table(name, self).with_warnings(&warnings(scene, self)).with_reach(reach).csv()
    }

    fn draws(&self, tab: &Searching) -> bool {
        drawn(self, tab).is_some_and(|it| !it.sorted.is_empty())
    }

    /// Draws the histogram of the values as steps.
    fn draw(&self, app: &App, area: Rect, canvas: &mut Canvas<'_>) {
        let tab = &app.pages.search;
        let Some(summary) = drawn(self, tab) else { return };
        let Summary { measure, sorted, .. } = summary;
        let Some((least, most)) = sorted.first().zip(sorted.last()) else { return };
        let width = (most - least) / BINS as f64;
        let mut steps = Vec::new();
        for bin in 0..BINS {
            let (from, to) = (least + width * bin as f64, least + width * (bin + 1) as f64);
            let below = |value: f64| sorted.partition_point(|other| *other < value);
            let until = if bin + 1 == BINS { sorted.len() } else { below(to) };
            let percent = 100.0 * (until - below(from)) as f64 / sorted.len() as f64;
            steps.extend([(from, percent), (to, percent)]);
        }
        // Leave room above for the tags.
        let highest = steps.iter().map(|step| 1.3 * step.1);
        let values = sorted.iter().copied();
        let x = Axis::fitted(measure.title(), measure.unit(), values);
        let y = Axis::over("", "%", Scale::Linear, highest.chain([0.0]));
        let Some((x, y)) = x.zip(y) else { return };
        let marks = QUANTILES.into_iter().filter(|it| SHOWN.contains(&it.0));
        let marks = marks.filter_map(|(_, tag, fraction)| {
            summary.quantile(fraction).map(|quantile| Mark::new(quantile.value, tag))
        });
        let curves = vec![Curve::new('*', "", &steps)];
        let chart = Chart {
            marks: marks.collect(),
            ..Chart::new("samples per bin", x, y.padded(0.04), curves)
        };
        canvas.draw(&chart, area);
    }
}
