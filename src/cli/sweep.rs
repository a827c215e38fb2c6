//! `cmra sweep SCENE --over ...`: results over one or more axes, as a page, CSV or JSON.
//!
//! Rows are written as they are computed: the memory does not grow with the sweep, and an interrupt keeps the finished rows.

pub(super) mod axes;
pub(super) mod page;

use std::ops::Range;
use std::process::ExitCode;
use std::sync::Arc;
use std::time::Instant;

use clap::Args;

use crate::cli::charts::ChartArguments;
use crate::cli::progress::interruptible;
use crate::cli::scene::SceneArguments;
use crate::cli::study::Threads;
use crate::cli::table::TableArguments;
use crate::cli::{CliError, output, progress, text};
use crate::files::atomic::PartialFile;
use crate::files::export::{self, Sidecar};
use crate::files::preset::Preset;
use crate::tui::plain;
use axes::PointArguments;
use cmra_engine::model::scene::Scene;
use cmra_studies::report::page::{Block, Page};
use cmra_studies::report::sweep::{self as report, Columns, Piece, SweepWriter, json_tail};
use cmra_studies::study::context::{Context, Progress, Reach, Work};
use cmra_studies::study::outcome::OutcomeCounts;
use cmra_studies::study::quantities;
use cmra_studies::study::sweep::grid::{Grid, PIECE};
use cmra_studies::study::sweep::{Axis, Evaluator, Plan, Shard};
use cmra_studies::study::validity;

#[derive(Debug, Args)]
#[command(
    after_help = format!(
        "Without --over, computes the scene's own [sweep], for example `cmra sweep figure-9.7`.\n\
        Columns: the axes' values, then every quantity of a run that needs neither its time series nor a limit search; \
        with --outputs, or for a scene's own [sweep], only the outcome, those outputs and `lower_bounds`, which names the values of \
        undecided runs. `error` comes last: a failed point \
        keeps its row and says why.\n\
        Shards: part I of N has every N-th row, beginning with row I. `cmra help sweeps` shows parts on many cores and in a cluster, \
        and how to put them together.\n\n\
        --outputs takes any of these:\n{}",
        quantities::listing()
    )
)]
pub(super) struct SweepArguments {
    #[command(flatten)]
    scene: SceneArguments,
    #[command(flatten)]
    points: PointArguments,
    /// Compute only every N-th row, beginning with row I
    #[arg(long, value_name = "I/N", default_value = "1/1")]
    shard: String,
    #[command(flatten)]
    threads: Threads,
    #[command(flatten)]
    pictures: ChartArguments,
    #[command(flatten)]
    table: TableArguments,
}

#[cfg(test)]
impl SweepArguments {
    /// Why it could not run.
    pub(super) fn problem(&self) -> Option<String> {
        let planned = self.scene.load().and_then(|preset| self.points.plan(&preset, true));
        planned.err().map(|error| error.to_string())
    }
}

/// Runs the sweep; exit status 1 when a point failed or the sweep was interrupted.
pub(super) fn run(arguments: &SweepArguments) -> Result<ExitCode, CliError> {
    arguments.table.check_stdout()?;
    arguments.pictures.check(&arguments.table)?;
    let preset = arguments.scene.read()?;
    let rows_wanted = arguments.table.json || arguments.table.is_wanted();
    let (plan, columns) = arguments.points.plan(&preset, !rows_wanted)?;
    let plan = Arc::new(plan);
    arguments.scene.changes.say_unused(&preset.scene, plan.axes().iter().map(Axis::variable));
    let shard = Shard::parse(&arguments.shard)?;
    let draws = arguments.pictures.is_wanted();
    if draws && !(shard == Shard::WHOLE && page::is_drawable(&plan)) {
        let most = page::KEPT_MAX;
        return Err(CliError::Option(format!(
            "--svg: a picture shows one or two axes and at most {most} points; omit --svg or use fewer points"
        )));
    }
    let is_swept = |key: &str| plan.axes().iter().any(|axis| axis.variable().key == key);
    if let Some(set) = arguments.scene.changes.set_of(is_swept) {
        output::note(&format!("--set {set} has no effect: the sweep varies it"));
    }
    let threads = arguments.threads.count();
    let job = Job { plan: &plan, shard, threads, preset: &preset };
    let file = arguments.table.file().map(|to| to.begin()).transpose()?;
    let start = Instant::now();
    let keeps = (draws || !rows_wanted) && shard == Shard::WHOLE && page::is_drawable(&plan);
    let mut kept = if keeps { Grid::new(Arc::clone(&plan)) } else { None };
    let ended = job.rows(arguments, columns, file, &mut kept)?;
    if !rows_wanted && !arguments.pictures.is_stdout() {
        let mut page = job.page(ended, kept.as_ref(), start.elapsed().as_secs_f64());
        page.push(Block::Warnings(validity::of_plan(&plan)));
        let missing = job.missing(ended).map_or_else(String::new, |it| it + "\n\n");
        let head = arguments.scene.changes.changed() + &missing;
        output::print(&(head + &text::plain(&page, arguments.table.style())))?;
    }
    let reach = Reach::new(job.missing(ended).is_some(), Progress::default());
    arguments.pictures.write(&arguments.table, reach, || page::pictures(kept.as_ref(), columns))?;
    Ok(job.ended(ended, columns, &arguments.table, start))
}

/// A sweep and who makes it.
struct Job<'a> {
    plan: &'a Plan,
    shard: Shard,
    threads: usize,
    preset: &'a Preset,
}

impl Job<'_> {
    fn count(&self) -> u64 {
        self.shard.count(self.plan.points())
    }

    /// Describes the points that are missing after an interrupt; `None` if every point was computed.
    fn missing(&self, ended: OutcomeCounts) -> Option<String> {
        let (done, all) = (ended.total(), self.count());
        (done < all).then(|| format!("not complete: {done} of {all} points"))
    }

    /// Say what it came to beside the result; 0 where every point was computed.
    fn ended(
        &self,
        ended: OutcomeCounts,
        columns: Columns,
        table: &TableArguments,
        start: Instant,
    ) -> ExitCode {
        if self.missing(ended).is_some() {
            let (done, all) = (ended.total(), self.count());
            output::note(&format!(
                "interrupted: {done} of {all} points were finished and are kept"
            ));
            return ExitCode::FAILURE;
        }
        if table.is_wanted() && !table.json {
            // Rows with all columns have their own.
            let chosen = columns == Columns::Chosen;
            let warnings = if chosen { validity::of_plan(self.plan) } else { Vec::new() };
            if !warnings.is_empty() {
                output::note(plain::warnings(&warnings, table.style()).join("\n").trim());
            }
            let took = page::duration(start.elapsed().as_secs_f64());
            output::note(&format!("{} points in {took}: {}", ended.total(), ended));
        }
        if ended.failed > 0 {
            output::note(&format!("{} points failed: see the column `error`", ended.failed));
            return ExitCode::FAILURE;
        }
        ExitCode::SUCCESS
    }

    fn page(&self, ended: OutcomeCounts, kept: Option<&Grid>, took_s: f64) -> Page {
        let (took, threads) = (page::duration(took_s), self.threads);
        let plural = if threads == 1 { "" } else { "s" };
        let how = format!("in {took} on {threads} thread{plural}");
        report::page(&self.preset.heading, self.plan, (ended, &how), kept)
    }

    /// Computes all points, and writes their rows where they are to go.
    fn rows(
        &self,
        arguments: &SweepArguments,
        columns: Columns,
        mut file: Option<PartialFile>,
        kept: &mut Option<Grid>,
    ) -> Result<OutcomeCounts, CliError> {
        let (has_csv, has_json) = (arguments.table.is_wanted(), arguments.table.json);
        let scene = self.preset.name.as_str();
        let sheet = SweepWriter { plan: self.plan, scene, columns, has_csv, has_json };
        let mut write = |csv: &[u8], json: &str| -> Result<(), CliError> {
            match &mut file {
                Some(file) => file.add(csv)?,
                None => output::print_bytes(csv)?,
            }
            output::print_bytes(json.as_bytes())
        };
        let head = if has_csv { sheet.header() } else { String::new() };
        write(
            head.as_bytes(),
            &if has_json { sheet.json_head(self.shard) } else { String::new() },
        )?;
        let mut is_first = true;
        let streamed = self.stream(&sheet, |piece| {
            if let Some(grid) = kept {
                grid.extend(&piece.points);
            }
            if !piece.json.is_empty() && !std::mem::take(&mut is_first) {
                write(b"", ",\n")?;
            }
            write(piece.csv.as_bytes(), &piece.json)
        });
        let ended = match (streamed, &file) {
            (Err(CliError::File(problem)), Some(file)) => {
                return Err(export::kept(file, problem).into());
            }
            (streamed, _) => streamed?,
        };
        let missing = self.missing(ended);
        let tail = json_tail(ended.total(), missing.is_none());
        output::print(if has_json { &tail } else { "" })?;
        if let (Some(file), Some(to)) = (file, arguments.table.file()) {
            let sweep = Some(columns.sweep(self.plan));
            let scene = Scene { sweep, ..self.preset.scene.clone() };
            let notes = export::sweep_notes(self.plan, missing.as_deref());
            let is_part = self.shard != Shard::WHOLE;
            let part = if is_part { format!(" --shard {}", self.shard) } else { String::new() };
            let command = format!("sweep{part}");
            let scenes = [Sidecar { run: None, scene: &scene, notes, command }];
            output::note_written(&match missing {
                None => to.finish(file, &scenes)?,
                Some(_) => export::leave(&file, &scenes)?,
            });
        }
        Ok(ended)
    }

    /// Compute all points, give each piece away in order, and show how far it is.
    fn stream(
        &self,
        sheet: &SweepWriter<'_>,
        mut take: impl FnMut(&Piece) -> Result<(), CliError>,
    ) -> Result<OutcomeCounts, CliError> {
        let mut counts = OutcomeCounts::default();
        let mut problem = None;
        let (shard, count) = (self.shard, self.count());
        let stop = interruptible();
        let worker = || {
            let mut evaluator = Evaluator::new(self.plan, &stop);
            move |piece: Range<u64>| {
                let points: Vec<u64> = piece.map(|row| shard.point(row)).collect();
                sheet.piece(&mut evaluator, &points)
            }
        };
        let work = Work { count, at_once: PIECE };
        let ((), _) = progress::study(self.threads, "points", |context: &mut Context<'_>| {
            context.expect(usize::try_from(count).unwrap_or(usize::MAX));
            context.each(work, worker, |context, piece, found| {
                found.points.iter().for_each(|point| counts.add(point.outcome));
                context.count(found.points.len());
                let is_whole = found.points.len() as u64 == piece.end - piece.start;
                problem = take(&found).err();
                // A piece by the contact kernel is done before it looks whether it should stop.
                context.should_continue() && is_whole && problem.is_none()
            });
        });
        problem.map_or(Ok(counts), Err)
    }
}
