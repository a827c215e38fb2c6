//! Report of a scene: a self-contained file with inputs, results, charts, ballistic limit, sweep and warnings.

use std::path::Path;

use crate::files::{clean, write};
use cmra_engine::model::library;
use cmra_engine::model::run::Warning;
use cmra_engine::model::run::{Run, envelope};
use cmra_engine::model::scene::Scene;
use cmra_engine::model::units;
use cmra_engine::model::variables::{VARIABLES, Variable, is_used};
use cmra_studies::report::document::Document;
use cmra_studies::report::figures::run::selected;
use cmra_studies::report::figures::sweeps::picture;
use cmra_studies::report::limit::{answer, page as limit_page};
use cmra_studies::report::measured;
use cmra_studies::report::run::page::{of_first, sentence, titled};
use cmra_studies::report::svg::Picture;
use cmra_studies::study::limit;
use cmra_studies::study::measured::{Errors, errors, left_out};
use cmra_studies::study::quantities::{Quantity, of_runs};
use cmra_studies::study::stack;
use cmra_studies::study::sweep::grid::Grid;
use cmra_studies::study::validity;

/// Significant digits of a result.
const DIGITS: usize = 6;

/// Returns `true` if a file has the extension of a report.
pub fn is_report(path: &Path) -> bool {
    let ending = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
    matches!(ending.as_str(), "html" | "htm" | "xhtml")
}

/// Returns the report of a scene as HTML: its run, its ballistic limit, and the sweep it contains (one or two axes).
pub fn html(
    (name, scene): (&str, &Scene),
    run: &Run,
    limit: &limit::LimitReport,
    sweep: Option<&Grid>,
) -> String {
    let mut page = Document::new(&titled(name, scene));
    page.paragraph(&run.stack.as_ref().map_or_else(|| sentence(run), |it| it.sentence()));
    page.paragraph(&answer(limit));
    // Warnings have a section of their own.
    for line in scene.notes.lines().filter(|line| !library::is_warning(line)) {
        page.paragraph(line);
    }
    page.heading("Warnings and validity");
    match &envelope::warnings(run)[..] {
        [] => page.paragraph("No warning: the scene is within the validity of the model."),
        warnings => page.list(warnings),
    }
    inputs(&mut page, scene);
    results(&mut page, run);
    let charts = selected(run, None);
    if !charts.is_empty() {
        page.heading(&format!("Charts{}", of_first(run)));
        charts.into_iter().map(Picture::Chart).for_each(|chart| page.picture(&chart));
    }
    ballistic_limit(&mut page, limit);
    measured_limits(&mut page);
    if let Some(grid) = sweep {
        own_sweep(&mut page, grid);
    }
    page.heading("Run it again");
    let (version, method) = (env!("CARGO_PKG_VERSION"), run.cost.method);
    page.paragraph(&format!(
        "Computed by cmra {version} ({method}). Save these lines as scene.toml:"
    ));
    page.code(&write::fresh(scene));
    page.paragraph("The first command prints the run, the second makes this report:");
    page.code("cmra run scene.toml\ncmra report scene.toml -o report.html");
    clean::page(&page.html()).into_owned()
}

fn inputs(page: &mut Document, scene: &Scene) {
    let usual = Scene::default();
    let changed = |one: &&Variable| is_used(one, scene) && one.show(scene) != one.show(&usual);
    let row = |one: &Variable| {
        let [symbol, meaning, unit] = [one.symbol, one.meaning, one.unit()].map(str::to_owned);
        [symbol, meaning, one.show(scene), one.show(&usual), unit]
    };
    let rows: Vec<_> = VARIABLES.iter().filter(changed).map(row).collect();
    page.heading("Inputs that differ from the baseline");
    if rows.is_empty() {
        page.paragraph("Every input has the value of the baseline.");
    } else {
        page.table(["symbol", "input", "value", "baseline", "unit"], rows.into_iter());
    }
}

/// Appends the results with their error estimates.
fn results(page: &mut Document, run: &Run) {
    let error = |name: &str| run.error_of(name).map_or_else(|| "-".to_owned(), units::below);
    let row = |column: &Quantity| {
        let value = column.show(column.value(run)?, DIGITS);
        Some([column.title(), value, error(column.name), column.name.to_owned()])
    };
    page.heading("Results");
    page.table(["result", "value", "relative error", "key"], of_runs().filter_map(row));
    if let Some(stack) = &run.stack {
        page.heading("Stack: plate by plate");
        page.code(&stack::table(run, stack).join("\n"));
    }
    let events = run.events.iter().map(|event| {
        let time = units::engineering(event.t_s, "s", DIGITS);
        format!("{time}: {}", event.kind.words())
    });
    let events: Vec<String> = events.collect();
    if !events.is_empty() {
        page.heading(&format!("Events{}", of_first(run)));
        page.list(&events);
    }
}

/// Appends the ballistic limit with its curve.
fn ballistic_limit(page: &mut Document, report: &limit::LimitReport) {
    let warnings = report.at_limit.as_ref().map(envelope::warnings).unwrap_or_default();
    let known: Vec<Warning> = library::warnings(&report.scene).collect();
    let of_limit = warnings.iter().filter(|warning| !known.contains(warning));
    let of_limit: Vec<String> =
        of_limit.map(|warning| format!("at the limit: {warning}")).collect();
    page.heading("Ballistic limit");
    let found = limit_page("", report);
    page.blocks(&found.blocks[1..]);
    if !of_limit.is_empty() {
        page.list(&of_limit);
    }
}

/// Appends the leave-one-paper-out errors of expected limits, with their picture.
fn measured_limits(page: &mut Document) {
    let rows = left_out();
    let percent = |value: f64| format!("{:+.1} %", 100.0 * value);
    let row = |it: &Errors| {
        let inside = it.share_inside().map_or_else(String::new, percent);
        [
            it.group.clone().unwrap_or_else(|| "all".to_owned()),
            format!("{} of {}", it.rows, it.papers),
            percent(it.bias),
            it.deviation.map_or_else(String::new, percent),
            inside.trim_start_matches('+').to_owned(),
        ]
    };
    page.heading("Measured limits");
    page.paragraph(
        "Limits of rigid plates that are expected from all other papers, over measured ones. No measured limit of a moving plate is public.",
    );
    let heads = ["class", "rows of papers", "bias", "standard deviation", "inside the band"];
    page.table(heads, errors(rows).iter().map(row));
    if let Some(chart) = measured::picture(rows) {
        page.picture(&Picture::Chart(chart));
    }
}

/// Appends the charts of the sweep.
fn own_sweep(page: &mut Document, grid: &Grid) {
    let plan = grid.plan();
    page.heading("Sweep");
    for output in 0..plan.outputs().len() {
        if let Some(picture) = &picture(grid, output) {
            page.picture(picture);
        }
    }
    let warnings = validity::of_plan(plan);
    if !warnings.is_empty() {
        page.list(&warnings);
    }
}
