//! `cmra stability`: stiff and extreme test scenes, or the stability map of a method with a fixed step size.

use std::fmt::Write as _;
use std::process::ExitCode;
use std::time::Instant;

use clap::Args;

use crate::cli::progress::Extent;
use crate::cli::study::StudyArguments;
use crate::cli::table::choice;
use crate::cli::{CliError, draw, text};
use cmra_engine::model::library;
use cmra_engine::model::run::Warning;
use cmra_studies::report::stability as tables;
use cmra_studies::report::stability::{HOW_IT_RAN, table};
use cmra_studies::study::stability;
use cmra_studies::study::stability::map::{self, Axis, FixedStep, Map, StabilityMapRequest};
use cmra_studies::study::stability::{ERROR_MAX, RESIDUAL_MAX, Row};

/// Minimum width of a page with the column `difficulty`.
const WIDE: usize = 118;

#[derive(Debug, Args)]
#[command(
    after_help = "Without --map, runs stiff and extreme scenes of its own with the default solver (`auto`). Exit status 1 if it fails on any of them.\nSCENE and --set are for --map."
)]
pub(super) struct StabilityArguments {
    /// Map where a fixed-step method is stable on SCENE, over its step and this variable
    #[arg(long, value_name = "k|n|b", value_parser = choice(&Axis::ALL, Axis::symbol, Axis::about))]
    map: Option<Axis>,
    /// The method of the map
    #[arg(long, default_value = "thesis", requires = "map", value_parser = choice(&FixedStep::ALL, FixedStep::word, FixedStep::about))]
    method: FixedStep,
    /// Check a fifth of the stiff scenes, or compute a coarser map
    #[arg(long)]
    quick: bool,
    #[command(flatten)]
    study: StudyArguments,
}

pub(super) fn run(arguments: &StabilityArguments) -> Result<ExitCode, CliError> {
    if let Some(axis) = arguments.map {
        return draw_map(arguments, axis);
    }
    arguments.study.table.check(false)?;
    if arguments.study.scene.is_given() {
        return Err(CliError::Option(
            "SCENE and --set belong to --map: the check of stiff scenes has its own scenes; add --map k (or n, b), or omit SCENE and --set"
                .to_owned(),
        ));
    }
    let cases = stability::battery(arguments.quick);
    let start = Instant::now();
    let now_s = || start.elapsed().as_secs_f64();
    let (rows, extent) =
        arguments.study.run("scenes", |context| stability::run(&cases, &now_s, context));
    let rows = rows?;
    let took_s = now_s();
    let (page, object) = (battery_page(&rows, took_s, text::width(), extent), tables::json(&rows));
    arguments.study.table.deliver(extent, None, &page, Some(object), table(&rows))?;
    Ok(extent.exit_code_after(failures(&rows)))
}

/// Returns a sentence for each scene that fails.
fn failures(rows: &[Row]) -> impl Iterator<Item = String> {
    rows.iter().filter_map(|row| {
        let (name, end) = (row.case.name, row.run.end.words());
        Some(format!("{name} fails: {} ({end})", row.shortfall?.words()))
    })
}

fn draw_map(arguments: &StabilityArguments, axis: Axis) -> Result<ExitCode, CliError> {
    let preset = arguments.study.load()?;
    map::accepts(&preset.scene)?;
    let size = if arguments.quick { map::QUICK } else { map::SIZE };
    let wanted = StabilityMapRequest { method: arguments.method, axis, size };
    let (map, extent) =
        arguments.study.run("rows", |context| map::map(&preset.scene, wanted, context));
    let name = preset.name.as_str();
    let warnings: Vec<Warning> = library::warnings(&preset.scene).collect();
    let (page, object) = (map_page(&map, &preset.heading), tables::map_json(name, &map));
    let (source, rows) = ((&preset.scene, wanted.to_string()), tables::map_table(name, &map));
    arguments.study.deliver(extent, source, &warnings, (page, object), rows)?;
    Ok(extent.exit_code(true))
}

/// Returns the page of the test scenes: table, legend and a summary line.
fn battery_page(rows: &[Row], took_s: f64, width: usize, extent: Extent) -> String {
    let mut keys = vec!["scene"];
    keys.extend(HOW_IT_RAN);
    if width >= WIDE {
        keys.extend(["reference", "why_hard"]);
    }
    let mut text = table(rows).page(&keys, if width >= WIDE { usize::MAX } else { width });
    text.extend(failures(rows).map(|failure| failure + "\n"));
    text.push('\n');
    text.push_str(LEGEND);
    summary(&mut text, rows, took_s, extent);
    text
}

/// Legend of the columns, a line each.
const LEGEND: &str = "\
ends        arrested, perforated, separated, moving (undecided), or CUT
error       the greatest of depth, times, displacement, velocity and forces, against s stored digits, D DOP853 at 1e-13 \
or R Radau IIA of order 5 at 1e-12, or t this solver at 1e-13 where both fail

";

fn summary(text: &mut String, rows: &[Row], took_s: f64, extent: Extent) {
    if let Some(missing) = extent.missing() {
        let _ = writeln!(text, "{missing}");
        return;
    }
    let short: Vec<&str> =
        rows.iter().filter(|row| row.shortfall.is_some()).map(|row| row.case.name).collect();
    let without = rows.iter().filter(|row| row.basis.is_none()).count();
    let (all, passed) = (rows.len(), rows.len() - short.len());
    let _ = writeln!(
        text,
        "{passed} of {all} scenes pass (energy and error within {RESIDUAL_MAX:e} and {ERROR_MAX:e}; {without} without a reference); {took_s:.1} s"
    );
    if !short.is_empty() {
        let _ = writeln!(text, "auto fails on: {}", short.join("; "));
    }
}

fn map_page(map: &Map, scene: &str) -> String {
    let picture = draw::map(&tables::picture(map), text::chart_size(draw::MAP));
    let (method, symbol) = (map.method.name(), map.axis.symbol());
    format!(
        "{method} on {scene}: time step against {symbol}; a run uses auto, for which see cmra accuracy\n\n{picture}"
    )
}
