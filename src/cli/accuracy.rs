//! `cmra accuracy [SCENE]...`: error against run time of every method, as a chart with a table and answers, CSV or JSON.

mod page;

use std::ffi::OsString;
use std::process::ExitCode;
use std::sync::Arc;

use clap::Args;

use crate::cli::progress::ProgressLine;
use crate::cli::scene;
use crate::cli::table::TableArguments;
use crate::cli::{CliError, output};
use crate::files::bundled;
use crate::report::accuracy::{self, Named};
use crate::study::accuracy::method::Method;
use crate::study::accuracy::{Effort, compare};
use crate::worker::clock;

#[derive(Debug, Args)]
pub(super) struct AccuracyArguments {
    /// Presets' names or paths of TOML files [default: thesis-baseline]
    #[arg(value_name = "SCENE")]
    scenes: Vec<OsString>,
    #[command(flatten)]
    changes: scene::Changes,
    /// Fewer points and shorter timings
    #[arg(long)]
    quick: bool,
    #[command(flatten)]
    table: TableArguments,
}

/// Compare the methods on each scene; exit status 1 when `auto` gave no answer somewhere.
pub(super) fn run(arguments: &AccuracyArguments) -> Result<ExitCode, CliError> {
    if arguments.scenes.len() > 1 {
        arguments.table.check()?;
    } else {
        arguments.table.check_beside()?;
    }
    let baseline = [OsString::from(bundled::BASELINE)];
    let names = if arguments.scenes.is_empty() { &baseline[..] } else { &arguments.scenes };
    let effort = if arguments.quick { Effort::QUICK } else { Effort::FULL };
    let mut presets = Vec::new();
    for name in names {
        let mut preset = scene::named(name)?;
        arguments.changes.apply(&mut preset.scene)?;
        presets.push(preset);
    }
    let mut reports: Vec<Named> = Vec::new();
    let mut line = ProgressLine::begin();
    let scenes = presets.clone();
    for preset in presets {
        let report = line.study(1, "points", |context| {
            compare(&Arc::new(preset.scene), effort, &mut clock::processor_s, context)
        })?;
        let whole = report.is_complete;
        reports.push((preset.name, report));
        if !whole {
            break;
        }
    }
    let (page, json) = (|| page::text(&reports), || accuracy::json(&reports));
    let only = scenes.first().filter(|_| scenes.len() == 1);
    let (name, scene) = (only.map_or("", |it| it.name.as_str()), only.map(|it| &it.scene));
    let table = arguments.table.of_scene(name, &arguments.changes, scene);
    table.deliver_report(page, json, &accuracy::table(&reports))?;
    let failures: Vec<String> = reports.iter().flat_map(auto_failures).collect();
    for failure in &failures {
        output::note(failure);
    }
    Ok(line.exit_code(failures.is_empty()))
}

/// Where `auto` gave no answer, in words: the step or tolerance, and why.
fn auto_failures((scene, report): &Named) -> Vec<String> {
    let auto = report.methods.iter().filter(|it| it.method == Method::Auto);
    auto.flat_map(|method| &method.points)
        .filter_map(|point| {
            let why = point.result.as_ref().err()?.words();
            Some(format!("{scene}: auto gave no answer at {}: {why}", point.knob))
        })
        .collect()
}
