//! `cmra accuracy [SCENE]...`: error against run time of every method, as a chart with a table and answers, CSV or JSON.

mod page;

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;
use std::time::Instant;

use clap::Args;

use crate::cli::scene;
use crate::cli::{CliError, output};
use crate::files::accuracy::{self as rows, Named};
use crate::files::atomic::{self, Existing};
use crate::files::bundled;
use crate::files::error::FileError;
use crate::study::accuracy::{Effort, compare};

#[derive(Debug, Args)]
pub(super) struct AccuracyArguments {
    /// Presets' names or paths of TOML files [default: thesis-baseline]
    #[arg(value_name = "SCENE")]
    scenes: Vec<String>,
    #[arg(
        long,
        value_name = "NAME=VALUE",
        allow_hyphen_values = true,
        help = "Change a variable of every scene: NAME=VALUE as for `cmra run`; may be repeated"
    )]
    set: Vec<String>,
    /// Fewer points and shorter timings
    #[arg(long)]
    quick: bool,
    /// Print JSON: one object a scene, in a list
    #[arg(long)]
    json: bool,
    /// Write every point to this file; `-` writes to standard output instead of the page
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// Replace an existing file
    #[arg(long, requires = "csv")]
    force: bool,
}

/// Compare the methods on each scene; exit status 1 when `auto` gave no answer somewhere.
pub(super) fn run(arguments: &AccuracyArguments) -> Result<ExitCode, CliError> {
    let baseline = [bundled::BASELINE.to_owned()];
    let names = if arguments.scenes.is_empty() { &baseline[..] } else { &arguments.scenes };
    let effort = if arguments.quick { Effort::QUICK } else { Effort::FULL };
    let mut presets = Vec::new();
    for name in names {
        let mut preset = scene::named(name)?;
        scene::change(&mut preset.scene, &arguments.set)?;
        presets.push(preset);
    }
    let start = Instant::now();
    let mut clock = || start.elapsed().as_secs_f64();
    let mut reports: Vec<Named> = Vec::new();
    for preset in presets {
        let watch = &mut |_done, _total| ControlFlow::Continue(());
        let report = compare(&Arc::new(preset.scene), effort, &mut clock, watch)?;
        reports.push((preset.name, report));
    }
    let to_stdout = arguments.csv.as_deref() == Some(Path::new("-"));
    if let Some(path) = &arguments.csv {
        let table = rows::csv(&reports)?;
        if to_stdout {
            output::print(&table)?;
        } else {
            write(path, &table, arguments.force)?;
        }
    }
    if !to_stdout {
        let text = if arguments.json { rows::json(&reports) } else { page::text(&reports) };
        output::print(&text)?;
    }
    Ok(if reports.iter().all(|(_, report)| rows::auto_answers(report)) {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    })
}

fn write(path: &Path, table: &str, force: bool) -> Result<(), CliError> {
    let existing = if force { Existing::Replace } else { Existing::Keep };
    atomic::write(path, table.as_bytes(), existing).map_err(|error| match error {
        FileError::Exists(path) => CliError::Exists { path: path.display().to_string() },
        other => CliError::File(other),
    })?;
    output::note(&format!("wrote {}", path.display()));
    Ok(())
}
