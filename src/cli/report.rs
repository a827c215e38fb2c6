//! `cmra report SCENE -o FILE`: a self-contained HTML file with the scene, results, charts and warnings.

use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;

use clap::Args;

use crate::cli::run::{compute, exit_code};
use crate::cli::scene::SceneArguments;
use crate::cli::study::Threads;
use crate::cli::sweep::page::KEPT_MAX;
use crate::cli::{CliError, output, progress};
use crate::files::atomic::{self, OverwritePolicy};
use crate::files::export;
use crate::files::report::{html, is_report};
use cmra_engine::model::scene::Scene;
use cmra_studies::study::limit;
use cmra_studies::study::sweep::grid::{Grid, PIECE};
use cmra_studies::study::sweep::{Axis, Plan};

#[derive(Debug, Args)]
#[command(
    after_help = "The report has the changed inputs, the results with their estimated errors, charts, the ballistic limit, the scene's \
                  own sweep (one or two axes), every warning, and how to run it again. The file is self-contained."
)]
pub(super) struct ReportArguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// Where to write the report, for example report.html; `-` writes it to standard output
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    /// Replace an existing file
    #[arg(long)]
    force: bool,
    #[command(flatten)]
    threads: Threads,
}

/// Writes a report; exit status 1 for a run that ended early, or after an interrupt.
pub(super) fn run(arguments: &ReportArguments) -> Result<ExitCode, CliError> {
    let path = &arguments.output;
    let existing = OverwritePolicy::replaced(arguments.force);
    let is_stdout = output::is_stdout(path);
    if !is_stdout {
        if !is_report(path) {
            let (path, example) = (path.display(), path.with_extension("html"));
            let example = example.display();
            let text = format!("-o {path}: a report is .html, for example -o {example}");
            return Err(CliError::Option(text));
        }
        export::check(path, "html", existing)?;
    }
    let preset = arguments.scene.read()?;
    let axes = preset.scene.sweep.as_ref().map(Axis::all_of).transpose()?.unwrap_or_default();
    arguments.scene.changes.say_unused(&preset.scene, axes.iter().map(Axis::variable));
    let scene = Arc::new(preset.scene);
    let run = compute(&scene)?;
    let threads = arguments.threads.count();
    let (limit, _) =
        progress::study(threads, "shots or so", |context| limit::find(&scene, context));
    let limit = limit?;
    let sweep = own_sweep(&scene, threads)?;
    if progress::was_interrupted() {
        output::note("interrupted: no report was written");
        return Ok(ExitCode::FAILURE);
    }
    let text = html((&preset.heading, &scene), &run, &limit, sweep.as_ref());
    if is_stdout {
        output::print(&text)?;
    } else {
        atomic::write(path, text.as_bytes(), existing)?;
        output::note_written(std::slice::from_ref(path));
    }
    Ok(exit_code(&run))
}

/// Computes the sweep stored in the scene.
fn own_sweep(scene: &Scene, threads: usize) -> Result<Option<Grid>, CliError> {
    if scene.sweep.is_none() {
        return Ok(None);
    }
    let plan = Arc::new(Plan::from_scene(scene)?);
    let grid = Grid::new(Arc::clone(&plan)).filter(|_| plan.points() <= KEPT_MAX);
    Ok(grid.map(|grid| progress::study(threads, "points", |it| grid.fill(PIECE, it)).0))
}
