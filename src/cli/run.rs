//! `cmra run SCENE`: one impact, as a readable summary, as JSON, as CSV, or with charts in plain text.

use std::ops::ControlFlow;
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;
use std::time::Instant;

use clap::Args;

use crate::cli::charts::ChartArguments;
use crate::cli::progress::{Extent, ProgressLine};
use crate::cli::scene::SceneArguments;
use crate::cli::sweep::page::duration;
use crate::cli::table::TableArguments;
use crate::cli::value_parsers::above_zero;
use crate::cli::{CliError, Glyphs, output, text};
use crate::files::export::scenes;
use crate::files::preset::Preset;
use crate::files::read_traces::traces;
use crate::tui::plain::TextStyle;
use crate::tui::theme::{ColourDepth, GlyphSet, Theme};
use cmra_engine::model::run::{EVERY_ROWS_MAX, Run, Sample};
use cmra_engine::model::scene::{ContactModel, Scene};
use cmra_engine::model::simulate::{self, RunSnapshot, Settings};
use cmra_engine::model::units::{Dimension, engineering};
use cmra_engine::model::variables::{self, VariableError};
use cmra_studies::report::figures::run::selected;
use cmra_studies::report::run::models;
use cmra_studies::report::run::page::page;
use cmra_studies::report::run::{self as report, NamedRun};
use cmra_studies::report::svg::Picture;
use cmra_studies::report::traces::Traces;

#[derive(Debug, Args)]
#[command(
    after_help = "--csv FILE writes the series, and beside it NAME.toml: the scene that reproduces it to the last digit.\n\n\
        NAME is a variable's symbol, or its full key as in scene files: `cmra explain` lists all."
)]
pub(super) struct RunArguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// Compare the contact models of thesis section 8.2 on this scene: Table 8.1 with numbers
    #[arg(long, value_name = "WHAT", conflicts_with_all = ["plain", "svg"], value_parser = ["models"])]
    compare: Option<String>,
    /// Write the rows of --csv at equal time steps, for example 1us, and at the end, instead of at the solver's own steps; for a single
    /// plate with model=hydrodynamic
    #[arg(long, value_name = "TIME", requires = "csv", conflicts_with = "compare", value_parser = above_zero(Dimension::Time, "1us"))]
    dt: Option<f64>,
    /// Compare with measured traces or another program's histories: a CSV file with a column of time and any of penetration, plate
    /// displacement, plate or projectile velocity, contact or mount force, acceleration
    #[arg(long, value_name = "FILE.csv", conflicts_with = "compare")]
    with: Option<PathBuf>,
    /// Print charts as plain text below the summary
    #[arg(long, conflicts_with = "json")]
    plain: bool,
    #[command(flatten)]
    pictures: ChartArguments,
    #[command(flatten)]
    table: TableArguments,
    /// Choose the characters of the charts
    #[arg(long, value_enum, default_value = "auto", value_name = "GLYPHS")]
    glyphs: Glyphs,
}

/// Steps between two readings of the clock, each of which takes a fraction of a step.
const LOOK: u64 = 64;

/// Computes a scene and measures the time of the computation alone. The time series is always computed: it costs little, and all outputs
/// of a scene then have the digits and events of the same computation.
pub(super) fn compute(scene: &Arc<Scene>) -> Result<Run, VariableError> {
    compute_by(scene, Settings::default())
}

/// Runs the scene with the time series at equal time steps.
fn at_equal_steps(scene: &Arc<Scene>, dt_s: f64) -> Result<Run, CliError> {
    if scene.contact.model != ContactModel::Hydrodynamic || scene.is_stack() {
        let model = scene.contact.model.word();
        let found =
            if scene.is_stack() { "a stack".to_owned() } else { format!("model = {model}") };
        return Err(CliError::Option(format!(
            "--dt: rows at equal time steps are for a single plate with model = hydrodynamic, and this scene has {found}; omit --dt for the \
             rows that the run itself has, or change the scene"
        )));
    }
    let end = compute_by(scene, Settings::SERIES)?.series.pop();
    let end_s = end.as_ref().map_or(0.0, |row| row.t_s);
    let most = EVERY_ROWS_MAX as f64;
    if end_s >= most * dt_s {
        let least = engineering(end_s / most, "s", 2);
        return Err(CliError::Option(format!(
            "--dt: more than {EVERY_ROWS_MAX} rows; write {least} or more"
        )));
    }
    let mut run = compute_by(scene, Settings { every_s: Some(dt_s), ..Settings::default() })?;
    // Without it the last events would stand in a row before them.
    let is_before = |last: &Sample| last.t_s < end_s * (1.0 - 4.0 * f64::EPSILON);
    run.series.extend(end.filter(|_| run.series.last().is_some_and(is_before)));
    Ok(run)
}

fn compute_by(scene: &Arc<Scene>, settings: Settings) -> Result<Run, VariableError> {
    let mut line = ProgressLine::begin();
    let mut steps = 0_u64;
    let mut observer = |look: &RunSnapshot<'_>| {
        steps += 1;
        if !steps.is_multiple_of(LOOK) {
            return ControlFlow::Continue(());
        }
        line.update(|elapsed_s| {
            let at = engineering(look.t_s, "s", 4);
            format!("t = {at} after {}, {steps} steps", duration(elapsed_s))
        })
    };
    let start = Instant::now();
    let took_s = &mut || start.elapsed().as_secs_f64();
    let run = simulate::simulate_beside_plastic(scene, &settings, took_s, &mut observer)?;
    line.clear();
    Ok(run)
}

pub(super) fn run(arguments: &RunArguments) -> Result<ExitCode, CliError> {
    arguments.table.check(true)?;
    arguments.pictures.check(&arguments.table)?;
    if arguments.compare.is_some() {
        return compare_models(arguments);
    }
    let Preset { name, heading, scene, .. } = arguments.scene.load()?;
    let with = arguments.with.as_deref().map(traces).transpose()?;
    let with = with.as_ref();
    let scene = Arc::new(scene);
    let run = Arc::new(match arguments.dt {
        None => compute(&scene)?,
        Some(dt_s) => at_equal_steps(&scene, dt_s)?,
    });
    if arguments.table.is_stdout() {
        output::print(&report::csv(&named(&name, &run)))?;
        return Ok(exit_code(&run));
    }
    if let Some(to) = arguments.table.file() {
        let runs = named(&name, &run);
        let mut scenes = scenes(&runs);
        let dt = arguments.dt.map(|dt_s| format!(" --dt {dt_s}")).unwrap_or_default();
        if let Some(first) = scenes.first_mut() {
            first.command = format!("run{dt}");
        }
        let written = to.write(
            report::csv(&runs).as_bytes(),
            &scenes,
            Extent::of_runs(std::iter::once(&*run)).reach.is_complete(),
        );
        output::note_written(&written?);
    }
    let drawn = || selected(&run, with).into_iter().map(Picture::Chart).collect();
    arguments.pictures.write(
        &arguments.table,
        Extent::of_runs(std::iter::once(&*run)).reach,
        drawn,
    )?;
    if arguments.pictures.is_stdout() {
        return Ok(exit_code(&run));
    }
    if arguments.table.json {
        output::print(&report::json(&name, &run, with))?;
    } else {
        output::print(&arguments.scene.changes.changed())?;
        let charts = arguments.plain.then_some(arguments.glyphs);
        print_readable((&heading, &run, with), charts, &arguments.table)?;
    }
    Ok(exit_code(&run))
}

/// Prints the summary, the differences from traces, and charts if requested.
pub(super) fn print_readable(
    (name, run, with): (&str, &Run, Option<&Traces>),
    charts: Option<Glyphs>,
    table: &TableArguments,
) -> Result<(), CliError> {
    // ASCII is available in every locale.
    let glyphs = charts.and_then(Glyphs::chosen).unwrap_or(GlyphSet::Ascii);
    let theme = Theme { glyphs, depth: ColourDepth::None };
    let page = page(name, run, with, charts.is_some());
    output::print(&text::plain(&page, TextStyle { theme, ..table.style() }))
}

/// Returns exit code 0 for a complete run, 1 for a run that ended early.
pub(super) fn exit_code(run: &Run) -> ExitCode {
    if run.end.is_complete() {
        ExitCode::SUCCESS
    } else {
        output::note(&format!("the run is incomplete: {}", run.end.words()));
        ExitCode::FAILURE
    }
}

/// Returns the run with its name; for a stack the run of every plate that was struck.
fn named(name: &str, first: &Arc<Run>) -> Vec<NamedRun> {
    let Some(stack) = &first.stack else { return vec![(name.to_owned(), Arc::clone(first))] };
    std::iter::once(first)
        .chain(&stack.behind)
        .enumerate()
        .map(|(plate, run)| (stack.name(plate).replace(' ', "-"), Arc::clone(run)))
        .collect()
}

impl Glyphs {
    /// Returns the selected character set; `None` for `auto`.
    pub(super) fn chosen(self) -> Option<GlyphSet> {
        match self {
            Self::Auto => None,
            Self::Ascii => Some(GlyphSet::Ascii),
            Self::Block => Some(GlyphSet::Block),
            Self::Braille => Some(GlyphSet::Braille),
        }
    }
}

/// Runs the scene with every contact model; a model that does not apply has no row.
fn compare_models(arguments: &RunArguments) -> Result<ExitCode, CliError> {
    let preset = arguments.scene.read()?;
    arguments.scene.changes.say_unused(&preset.scene, variables::find("contact.model").ok());
    variables::require_single(&preset.scene)?;
    let mut runs: Vec<NamedRun> = Vec::new();
    for model in ContactModel::IN_TABLE_8_1 {
        let mut scene = preset.scene.clone();
        scene.contact.model = model;
        let word = model.word();
        match compute(&Arc::new(scene)) {
            Ok(run) => runs.push((word.to_owned(), Arc::new(run))),
            // The first model is the reference of the comparison.
            Err(problem) if runs.is_empty() => return Err(problem.into()),
            Err(problem) => output::note(&format!("not run: {word}: {problem}")),
        }
    }
    let page = models::page(&preset.heading, &runs);
    let source = (&arguments.scene.changes, &preset.scene, "run --compare models".to_owned());
    let extent = Extent::of_runs(runs.iter().map(|(_, run)| &**run));
    arguments.table.deliver(
        extent,
        Some(source),
        &page,
        None,
        report::results(&preset.name, &runs),
    )?;
    Ok(extent.exit_code(true))
}
