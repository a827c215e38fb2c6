//! Report of a scene: its run, inputs, ballistic limit, measured limits, own sweep, and how to run it again.

use crate::report::Remark;
use crate::report::figures::run::selected;
use crate::report::page::{Block, CHART, Page};
use crate::report::run::page::{
    computation, energy, events, labelled, of_first, results, sentence, titled,
};
use crate::report::run::stack;
use crate::report::svg::Picture;
use crate::report::table::{Cells, Table};
use crate::report::{limit as limits, measured, sweep};
use crate::study::envelope;
use crate::study::library;
use crate::study::limit::LimitReport;
use crate::study::measured::left_out;
use crate::study::quantities::{Quantity, of_runs};
use crate::study::sweep::grid::Grid;
use crate::study::validity;
use cmra_engine::model::run::{Run, Warning};
use cmra_engine::model::scene::Scene;
use cmra_engine::model::units;
use cmra_engine::model::variables::{VARIABLES, Variable, is_used};

/// Significant digits of a result.
const DIGITS: usize = 6;
/// Column of a text beside its label.
const LABEL: usize = 16;

/// Results of a scene.
pub struct SceneReport<'r> {
    /// Name of the scene, and the scene.
    pub scene: (&'r str, &'r Scene),
    /// The scene as a file.
    pub file: String,
    /// Run of the scene.
    pub run: &'r Run,
    /// Ballistic limit of the scene.
    pub limit: &'r LimitReport,
    /// Sweep that the scene contains, over one or two axes.
    pub sweep: Option<&'r Grid>,
}

/// Returns the whole report: what the shot came to, then inputs, results and charts, then each study.
pub fn page(report: &SceneReport<'_>) -> Page {
    let ((name, scene), run) = (report.scene, report.run);
    let mut page = Page::new(titled(name, scene));
    page.line(run.stack.as_ref().map_or_else(|| sentence(run), |it| it.sentence()));
    page.line(limits::answer(report.limit));
    // Warnings have a section of their own.
    let notes = scene.notes.lines().filter(|line| !library::is_warning(line));
    page.lines(notes.map(str::to_owned));
    match envelope::warnings(run) {
        none if none.is_empty() => {
            page.heading("Warnings");
            page.line("No warning: the scene is within the validity of the model.");
        }
        warnings => page.push(Block::Warnings(warnings)),
    }
    inputs(&mut page, scene);
    of_run(&mut page, run);
    ballistic_limit(&mut page, report.limit);
    measured_limits(&mut page);
    if let Some(grid) = report.sweep {
        own_sweep(&mut page, grid);
    }
    page.heading("Run it again");
    let (version, method) = (env!("CARGO_PKG_VERSION"), run.cost.method);
    page.line(format!("Computed by cmra {version} ({method}). Save these lines as scene.toml:"));
    page.push(Block::Code(report.file.clone()));
    page.line("The first command prints the run, the second makes this report:");
    page.push(Block::Code("cmra run scene.toml\ncmra report scene.toml -o report.html".to_owned()));
    page
}

/// Appends the variables that the scene uses and that differ from the baseline.
fn inputs(page: &mut Page, scene: &Scene) {
    let usual = Scene::default();
    let changed = |one: &&Variable| is_used(one, scene) && one.show(scene) != one.show(&usual);
    let table = Table::new(VARIABLES.iter().filter(changed))
        .with("symbol", "symbol", "", |it| it.symbol)
        .with("input", "input", "", |it| it.meaning)
        .with("value", "value", "", |it| it.show(scene))
        .with("baseline", "baseline", "", |it| it.show(&usual))
        .with("unit", "unit", "", |it| it.unit());
    page.heading("Inputs that differ from the baseline");
    if table.rows.is_empty() {
        page.line("Every input has the value of the baseline.");
    } else {
        page.table(table.cells(&table.keys()));
    }
}

/// Appends results, plates, energy, events, computation and charts of the run.
fn of_run(page: &mut Page, run: &Run) {
    let first = of_first(run);
    if run.stack.is_some() {
        page.section("Stack: plate by plate", 0, stack::blocks(run));
    }
    page.section(format!("Results{first}"), 0, labelled(results(run)));
    page.heading("All results, with the estimate of their error");
    page.table(with_errors(run));
    page.section(format!("Energy{first}"), 0, energy(run));
    if !run.events.is_empty() {
        page.section(format!("Events{first}"), 0, events(run));
    }
    // Without the run time, two reports of a scene are equal.
    page.section(format!("Computation{first}"), 0, labelled(computation(run, None)));
    let charts = selected(run, None);
    if !charts.is_empty() {
        page.heading(format!("Charts{first}"));
        for chart in charts {
            page.picture(Picture::Chart(chart), CHART);
        }
    }
}

/// Returns the results with their error estimates and keys.
fn with_errors(run: &Run) -> Vec<Cells> {
    let error = |name: &str| run.error_of(name).map_or_else(|| "-".to_owned(), units::below);
    let known = of_runs().filter_map(|it| Some((it, it.show(it.value(run)?, DIGITS))));
    let table = Table::new(known)
        .with("result", "result", "", |row: &(&Quantity, String)| row.0.title())
        .with("value", "value", "", |row| row.1.clone())
        .with("error", "relative error", "", |row| error(row.0.name))
        .with("key", "key", "", |row| row.0.name);
    table.cells(&table.keys())
}

/// Appends the ballistic limit with its curve.
fn ballistic_limit(page: &mut Page, report: &LimitReport) {
    page.heading("Ballistic limit");
    // Without the title.
    page.blocks.extend(limits::page("", report).blocks.into_iter().skip(1));
    let warnings = report.at_limit.as_ref().map(envelope::warnings).unwrap_or_default();
    let known: Vec<Warning> = library::warnings(&report.scene).collect();
    let of_limit = warnings.iter().filter(|warning| !known.contains(warning));
    let of_limit = of_limit.map(|it| Remark::caution("warning", format!("at the limit: {it}")));
    page.remarks(of_limit, LABEL);
}

/// Appends the leave-one-paper-out errors of expected limits, with their picture.
fn measured_limits(page: &mut Page) {
    let rows = left_out();
    page.heading("Measured limits");
    page.line(
        "Limits of rigid plates that are expected from all other papers, over measured ones. No measured limit of a moving plate is public.",
    );
    measured::error_page(page, rows);
    if let Some(chart) = measured::picture(rows) {
        page.picture(Picture::Chart(chart), CHART);
    }
}

/// Appends the charts and, over one axis, the values of the sweep.
fn own_sweep(page: &mut Page, grid: &Grid) {
    let plan = grid.plan();
    page.blocks
        .extend(sweep::page("Sweep", plan, (grid.outcomes(), "computed"), Some(grid)).blocks);
    let warnings = validity::of_plan(plan).into_iter();
    page.remarks(warnings.map(|it| Remark::caution("warning", it.to_string())), LABEL);
}
