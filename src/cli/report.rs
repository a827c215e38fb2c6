//! `cmra report SCENE -o FILE`: one self-contained file with the scene, its results, charts and warnings.

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;

use clap::Args;

use crate::cli::run::{self, Computed};
use crate::cli::scene::SceneArguments;
use crate::cli::study::Threads;
use crate::cli::sweep::page::KEPT_MAX;
use crate::cli::{CliError, draw, output, progress};
use crate::files::atomic::{self, Existing};
use crate::files::{clean, write};
use crate::model::run::{Run, envelope};
use crate::model::scene::Scene;
use crate::model::units;
use crate::model::variables::{VARIABLES, Variable, is_used};
use crate::report::document::{Block, Document};
use crate::report::figures::run::selected;
use crate::report::figures::sweeps::picture;
use crate::report::limit::{remarks, residual};
use crate::report::run::page::sentence;
use crate::report::svg::Picture;
use crate::study::limit::{self, Criterion, Effort};
use crate::study::quantities::{Quantity, of_runs};
use crate::study::sweep::Plan;
use crate::study::sweep::grid::{Grid, PIECE};
use crate::study::validity;

/// Digits of a result.
const DIGITS: usize = 6;

#[derive(Debug, Args)]
#[command(
    after_help = "The report has the changed inputs, the results with their estimated errors, charts, the ballistic limit, the scene's \
                  own sweep (one or two axes), every warning, and how to run it again. The file is self-contained."
)]
pub(super) struct ReportArguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// Where to write the report: FILE.html has its charts as SVG, FILE.md as text
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    /// Replace an existing file
    #[arg(long)]
    force: bool,
    #[command(flatten)]
    threads: Threads,
}

/// Whether a report of this name is HTML; it is Markdown otherwise.
fn is_html(path: &Path) -> Result<bool, CliError> {
    let ending = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
    match ending.as_str() {
        "html" | "htm" | "xhtml" => Ok(true),
        "md" | "markdown" => Ok(false),
        _ => Err(CliError::Option(format!(
            "-o {}: a report is .html or .md, for example -o {}",
            path.display(),
            path.with_extension("html").display()
        ))),
    }
}

/// Write a report; exit status 1 for a run that ended early, or after an interrupt.
pub(super) fn run(arguments: &ReportArguments) -> Result<ExitCode, CliError> {
    let path = &arguments.output;
    let existing = Existing::replaced(arguments.force);
    let is_html = is_html(path)?;
    atomic::check(path, existing)?;
    let preset = arguments.scene.load()?;
    let scene = preset.scene.clone();
    let computed = run::compute(preset)?;
    let mut document = head(&computed, &scene);
    results(&mut document, &computed.run);
    let charts = selected(&computed.run).into_iter().map(Picture::Chart).map(block);
    section(&mut document, "Charts", charts.collect());
    section(&mut document, "Ballistic limit", ballistic_limit(&scene, arguments.threads.count())?);
    section(&mut document, "Sweep", own_sweep(&scene, arguments.threads.count())?);
    section(&mut document, "Run it again", again(&computed, &scene));
    if progress::exit_code(true) != ExitCode::SUCCESS {
        output::note("no report was written");
        return Ok(ExitCode::FAILURE);
    }
    let text = if is_html { document.html() } else { document.markdown(draw::picture) };
    atomic::write(path, clean::page(&text).as_bytes(), existing)?;
    output::note_written(std::slice::from_ref(path));
    Ok(run::exit_code(&computed.run))
}

fn block(picture: Picture) -> Block {
    Block::Picture(Box::new(picture))
}

/// Adds a section unless it is empty.
fn section(document: &mut Document, title: &str, blocks: Vec<Block>) {
    if !blocks.is_empty() {
        document.blocks.push(Block::Heading(title.to_owned()));
        document.blocks.extend(blocks);
    }
}

/// The title, the warnings, and the changed inputs.
fn head(computed: &Computed, scene: &Scene) -> Document {
    let run = &computed.run;
    let name = &computed.preset.name;
    let title = clean::line(&scene.title);
    let title = if title.is_empty() { name.clone() } else { format!("{name}: {title}") };
    let mut document = Document { title, blocks: vec![Block::Paragraph(sentence(run))] };
    if !scene.notes.is_empty() {
        document.blocks.push(Block::Paragraph(scene.notes.clone()));
    }
    let warnings = envelope::warnings(run);
    let warnings = if warnings.is_empty() {
        vec![Block::Paragraph(
            "No warning: the scene is within the validity of the model.".to_owned(),
        )]
    } else {
        vec![Block::List(warnings)]
    };
    section(&mut document, "Warnings and validity", warnings);
    let usual = Scene::default();
    let changed = |one: &&Variable| is_used(one, scene) && one.show(scene) != one.show(&usual);
    let row = |one: &Variable| {
        let unit = one.unit().to_owned();
        vec![one.symbol.to_owned(), one.meaning.to_owned(), one.show(scene), one.show(&usual), unit]
    };
    let rows: Vec<Vec<String>> = VARIABLES.iter().filter(changed).map(row).collect();
    let inputs = if rows.is_empty() {
        Block::Paragraph("Every input has the value of the baseline.".to_owned())
    } else {
        let head = ["symbol", "input", "value", "baseline", "unit"].map(str::to_owned).to_vec();
        Block::Table { head, rows }
    };
    section(&mut document, "Changed inputs", vec![inputs]);
    document
}

/// The results, each with the estimate of its error.
fn results(document: &mut Document, run: &Run) {
    let error = |name: &str| {
        run.error_of(name).map_or_else(|| "-".to_owned(), |error| units::scientific(error, 1))
    };
    let row = |column: &Quantity| {
        let value = column.value(run)?;
        Some(vec![
            column.title(),
            column.show(value, DIGITS),
            error(column.name),
            column.name.to_owned(),
        ])
    };
    let head = ["result", "value", "relative error", "key"].map(str::to_owned).to_vec();
    let mut blocks = vec![Block::Table { head, rows: of_runs().filter_map(row).collect() }];
    let events = run.events.iter().map(|event| {
        let time = units::engineering(event.t_s, "s", DIGITS);
        format!("{time}: {}", event.kind.words())
    });
    let events: Vec<String> = events.collect();
    if !events.is_empty() {
        blocks.push(Block::List(events));
    }
    section(document, "Results", blocks);
}

/// The ballistic limit with its curve.
fn ballistic_limit(scene: &Scene, threads: usize) -> Result<Vec<Block>, CliError> {
    let effort = Effort { criterion: Criterion::Passage, sampling: None };
    let scene = Arc::new(scene.clone());
    let report = progress::study(threads, "shots or so", |it| limit::find(&scene, effort, it))?;
    let mut lines = Vec::new();
    match report.limit.velocity_m_s() {
        Some(velocity) => lines.push(units::velocity(velocity, DIGITS)),
        None => lines.extend(report.limit.absence()),
    }
    lines.push(format!("criterion: {}", report.criterion.label()));
    if let Some(margin) = report.margin() {
        lines.push(format!("{:+.1} % over the scene's own velocity", 100.0 * margin));
    }
    let remarks = remarks(&report).into_iter();
    lines.extend(remarks.map(|remark| format!("{}: {}", remark.about, remark.text)));
    let warnings = report.at_limit.as_ref().map_or(&[][..], |it| &it.warnings);
    lines.extend(warnings.iter().map(|warning| format!("at the limit: {warning}")));
    let chart = residual(&report, None).map(Picture::Chart).map(block);
    Ok(std::iter::once(Block::List(lines)).chain(chart).collect())
}

/// The pictures of the sweep that is kept with the scene.
fn own_sweep(scene: &Scene, threads: usize) -> Result<Vec<Block>, CliError> {
    if scene.sweep.is_none() {
        return Ok(Vec::new());
    }
    let plan = Arc::new(Plan::of(scene)?);
    let grid = Grid::new(Arc::clone(&plan)).filter(|_| plan.points() <= KEPT_MAX);
    let Some(grid) = grid else { return Ok(Vec::new()) };
    let grid = progress::study(threads, "points", |context| grid.fill(PIECE, context));
    let pictures = (0..plan.outputs().len()).filter_map(|output| picture(&grid, output));
    let mut blocks: Vec<Block> = pictures.map(block).collect();
    let warnings = validity::of_axes(plan.base(), plan.axes());
    blocks.extend((!warnings.is_empty()).then_some(Block::List(warnings)));
    Ok(blocks)
}

/// The version, the scene as a file, and what to do with it.
fn again(computed: &Computed, scene: &Scene) -> Vec<Block> {
    let run = &computed.run;
    vec![
        Block::Paragraph(format!(
            "Computed by cmra {} ({}, {} steps). Save these lines as scene.toml and run `cmra run scene.toml`; \
             `cmra report scene.toml -o report.html` makes this report again.",
            env!("CARGO_PKG_VERSION"),
            run.cost.method,
            run.cost.steps
        )),
        Block::Code(write::fresh(scene)),
    ]
}
