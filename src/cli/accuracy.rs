//! `cmra accuracy [SCENE]`: error and run time of every method, as a page with a chart, CSV or JSON.

use std::fmt::Write as _;
use std::process::ExitCode;
use std::sync::Arc;

use clap::Args;

use crate::cli::scene::SceneArguments;
use crate::cli::table::TableArguments;
use crate::cli::text::{chart_size, width};
use crate::cli::{CliError, draw, progress};
use crate::files::preset::Preset;
use crate::tui::theme::Theme;
use crate::worker::clock;
use cmra_engine::model::run::Outcome;
use cmra_engine::model::units::engineering;
use cmra_studies::report::accuracy::{
    self, ANSWERS, TARGETS, advice, by, error_over_time, methods, printed_scheme, savings, seconds,
};
use cmra_studies::study::accuracy::method::Method;
use cmra_studies::study::accuracy::reference::Reference;
use cmra_studies::study::accuracy::{
    AccuracyReport, Compared, ComparisonOptions, MethodReport, compare,
};
use cmra_studies::study::context::Reach;

const SIZE: draw::Size = (80, 20);
/// Columns of the table of methods.
const KEYS: [&str; 6] =
    ["letter", "method", "least_error", "run_time_s_to_1e-6", "run_time_s_to_1e-9", "cheapest"];

#[derive(Debug, Args)]
pub(super) struct AccuracyArguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// Fewer points and shorter timings
    #[arg(long)]
    quick: bool,
    #[command(flatten)]
    table: TableArguments,
}

/// Compares the methods on the scene; exit status 1 if `auto` returns no result at a point.
pub(super) fn run(arguments: &AccuracyArguments) -> Result<ExitCode, CliError> {
    arguments.table.check(true)?;
    let Preset { name, scene, .. } = arguments.scene.load()?;
    let effort = if arguments.quick { ComparisonOptions::QUICK } else { ComparisonOptions::FULL };
    let (report, extent) = progress::study(1, "points", |context| {
        compare(&Arc::new(scene.clone()), effort, &mut clock::processor_s, context)
    });
    let report = report?;
    let reach = extent.reach;
    let table = &arguments.table;
    let page = page(&name, &report, reach) + &table.warnings(&accuracy::warnings(&report));
    let (object, rows) = (accuracy::json(&name, &report, reach), accuracy::table(&name, &report));
    let source = (&arguments.scene.changes, &scene, effort.to_string());
    table.deliver(extent, Some(source), &page, Some(object), rows)?;
    let auto = report.methods.iter().filter(|it| it.method == Method::Auto);
    Ok(extent.exit_code_after(auto.flat_map(|method| &method.points).filter_map(|point| {
        let why = point.result.as_ref().err()?.message();
        Some(format!("{name}: auto gave no answer at {}: {why}", point.parameter))
    })))
}

fn page(name: &str, report: &AccuracyReport, reach: Reach) -> String {
    let mut page = format!("{name}: error against run time\n\n");
    if reach.is_complete() {
        let _ = writeln!(page, "{}", advice(report));
    }
    if let Some(printed) = printed_scheme(report) {
        let _ = writeln!(page, "{printed}; T is the error of its step");
    }
    page.push('\n');
    match error_over_time(report) {
        Some(chart) => page += &draw::chart(&chart, chart_size(SIZE), Theme::PLAIN),
        None => page.push_str("no method gave a result to compare\n"),
    }
    let pick = report.cheapest(TARGETS[1]).filter(|_| reach.is_complete()).map(|pick| pick.method);
    let mark = |it: &&MethodReport| if pick == Some(it.method) { "<- cheapest" } else { "" };
    let table = methods(&report.methods).with("cheapest", "", "", mark);
    let _ = write!(page, "\n{}", table.page(&KEYS, width()));
    if !reach.is_complete() {
        return page + "\nnot complete: no answer is drawn from these points\n";
    }
    answers(&mut page, report);
    references(&mut page, report);
    refusals(&mut page, report);
    page
}

/// Appends the run times for some accuracies, and the gain from omitted terms.
fn answers(page: &mut String, report: &AccuracyReport) {
    page.push_str("\nrun time for a given accuracy\n");
    for target in ANSWERS {
        let found = report.cheapest(target).map_or_else(
            || "no method reaches it".to_owned(),
            |found| format!("{} {}", seconds(found.min_s), by(&found)),
        );
        let _ = writeln!(page, "  {target:>5.0e}: {found}");
    }
    if !report.savings.is_empty() {
        let keys = ["part", "with_s", "without_s", "gain"];
        let _ = write!(page, "\n{}", savings(&report.savings).page(&keys, width()));
    }
}

fn references(page: &mut String, report: &AccuracyReport) {
    page.push_str("\nreferences (depth, time, relative uncertainty: methods)\n");
    let mut compared: Vec<(Reference, String)> = Vec::new();
    for method in &report.methods {
        let Some(own) = method.reference else { continue };
        let letter = method.method.letter();
        match compared.iter_mut().find(|(reference, _)| reference.basis == own.basis) {
            Some((_, letters)) => letters.push(letter),
            None => compared.push((own, letter.to_string())),
        }
    }
    for (reference, letters) in compared {
        let [depth_m, time_s] =
            [Compared::Depth, Compared::Time].map(|of| reference.results.get(of));
        let depth = match reference.outcome {
            Outcome::Perforated => "perforated".to_owned(),
            _ => depth_m.map_or_else(|| "-".to_owned(), |depth_m| engineering(depth_m, "m", 6)),
        };
        let end = time_s.map_or_else(|| "-".to_owned(), |time_s| engineering(time_s, "s", 6));
        let sure = reference
            .uncertainty
            .map_or_else(|| "unknown".to_owned(), |uncertainty| format!("{uncertainty:.0e}"));
        let basis = reference.basis.label();
        let _ = writeln!(page, "  {basis:<23}{depth}, {end}, to {sure}: {letters}");
    }
}

fn refusals(page: &mut String, report: &AccuracyReport) {
    let mut heading = "\nwithout result\n";
    for method in &report.methods {
        for (words, points) in method.refusals() {
            let which = match points.as_slice() {
                [first, .., last] => format!("{} points, {first} to {last}", points.len()),
                one => one.iter().map(ToString::to_string).collect(),
            };
            page.push_str(std::mem::take(&mut heading));
            let _ = writeln!(page, "  {} {which}: {words}", method.method.letter());
        }
    }
}
