//! `cmra seek [SCENE] --over k=0..7.5e6 --goal percent_of_baseline=60`: which values of one variable reach a goal.

use std::fmt::Write as _;
use std::process::ExitCode;

use clap::Args;

use crate::cli::study::{StudyArguments, StudyOutput, on_plastic};
use crate::cli::sweep::axes::range;
use crate::cli::{CliError, output, progress};
use crate::model::scene::InterfaceLaw;
use crate::model::units::shortest;
use crate::report::seek::{self, remarks, solution};
use crate::study::quantities::named;
use crate::study::search::seek::{Goal, Report, SCAN, SCAN_USUAL, seek as solve};
use crate::study::sweep::Spacing;

#[derive(Debug, Args)]
#[command(
    after_help = "The interval is scanned at COUNT points, then every crossing of the goal is located by root finding. \
    Solutions closer together than the points of the scan may be missed: raise COUNT.\n\
    QUANTITY is any quantity: `cmra explain` lists all.\n\
    Exit status 1 when nothing reaches the goal."
)]
pub(super) struct SeekArguments {
    /// The variable and its bounds; COUNT points of the scan [default: 65]
    #[arg(long, value_name = "NAME=LO..HI[:COUNT][:log]", allow_hyphen_values = true)]
    over: String,
    /// The quantity and the value it should have.
    #[arg(
        long,
        value_name = "QUANTITY=VALUE",
        allow_hyphen_values = true,
        help = "The quantity and the value it should have, SI or with a unit: percent_of_baseline=60, stroke_m=45mm"
    )]
    goal: String,
    #[command(flatten)]
    study: StudyArguments,
}

impl SeekArguments {
    fn goal(&self) -> Result<Goal, CliError> {
        let refuse = |why: &str| CliError::Option(format!("--goal {}: {why}", self.goal));
        let (name, value) = self.goal.split_once('=').ok_or_else(|| {
            refuse("write QUANTITY=VALUE, for example percent_of_baseline=60 or stroke_m=45mm")
        })?;
        let column = named(name)?;
        let target = column.parse(value).map_err(|why| refuse(&why))?;
        let axis = range(&self.over, Some(SCAN_USUAL), &SCAN)?;
        Ok(Goal { axis, measure: column.name.to_owned(), target })
    }
}

/// Runs the goal seek; exit status 1 when nothing reaches the goal.
pub(super) fn run(arguments: &SeekArguments) -> Result<ExitCode, CliError> {
    let goal = arguments.goal()?;
    let mut preset = arguments.study.load()?;
    let law = on_plastic(&arguments.study.scene, &mut preset.scene);
    let report = arguments.study.run("runs", |context| solve(&preset.scene, &goal, context))?;
    let name = preset.name.as_str();
    if let Some(law) = &law {
        output::note(law);
    }
    let warnings = seek::warnings(&preset.scene, &report);
    let (page, object) = (page(name, &report, law.is_some()), seek::json(name, &report));
    let answer = StudyOutput { warnings, page, object, rows: seek::table(name, &report) };
    arguments.study.deliver(&preset.scene, answer)?;
    Ok(progress::exit_code(report.solutions().next().is_some()))
}

/// The page; of a search that has taken the plastic interface by itself, what runs a solution names that too.
fn page(name: &str, report: &Report, is_plastic: bool) -> String {
    let axis = &report.axis;
    let (low, high) = axis.ends();
    let spacing = if axis.spacing() == Spacing::Log { ", at equal ratios" } else { "" };
    let (symbol, measure, points) = (axis.symbol(), report.measure.title(), report.scan.len());
    let (target, runs) = (report.measure.show(report.target, 6), report.runs);
    let [low, high] = [low, high].map(|end| axis.show(end, 6));
    let mut page = format!(
        "{name}: which {symbol} gives {measure} = {target}?\n{points} points from {low} to {high}{spacing}, {runs} runs in all\n\n"
    );
    let solutions = report.solutions().map(|found| solution(report, found));
    let law = if is_plastic { InterfaceLaw::Plastic } else { InterfaceLaw::Fused };
    let law = seek::other_law(law, InterfaceLaw::Fused);
    for line in solutions.chain(law).chain(remarks(report).into_iter().map(|remark| remark.text)) {
        let _ = writeln!(page, "  {line}");
    }
    if let Some(solution) = report.solutions().next() {
        let set = format!("{symbol}={}", shortest(solution.place.at));
        let law = if is_plastic { " --set interface=plastic" } else { "" };
        let _ = writeln!(page, "\n`--set {set}{law}` runs it");
    }
    page
}
