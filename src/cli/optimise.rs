//! `cmra optimise [SCENE] --over ...`: the Pareto front, as a page, CSV or JSON.

use std::fmt::Write as _;
use std::ops::RangeInclusive;
use std::process::ExitCode;

use clap::{Args, ValueEnum};

use crate::cli::amount::count;
use crate::cli::study::{Random, StudyArguments, StudyOutput, bounds};
use crate::cli::text::{hanging, width};
use crate::cli::{CliError, progress};
use crate::model::scene::{InterfaceLaw, Scene};
use crate::model::units::significant;
use crate::report::front;
use crate::report::front::{designs, standing};
use crate::report::table::{Cells, grid};
use crate::study::search::front::{
    Candidate, Constraint, Front, STEPS_MAX, Task, feasibility, objectives, optimise,
};
use crate::study::search::nsga::EvolutionOptions;
use crate::study::sensitivity::thesis_axes;
use crate::study::sweep::{Axis, Spacing};

/// Designs of a front that are listed.
const LISTED: usize = 16;
/// Points of a generation, and generations.
const POPULATION: RangeInclusive<usize> = 8..=2000;
const GENERATIONS_MAX: u64 = 100_000;

/// Interface laws to search.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Laws {
    /// One after the other
    Both,
    /// Projectile and plate stay joined after the first arrest
    Fused,
    /// The interface yields above its strength
    Plastic,
}

#[derive(Debug, Args)]
#[command(after_help = "QUANTITY is any quantity: `cmra explain` lists all. \
    Without --minimise and --maximise: depth, stroke, system mass and mount force are minimised.\n\
    Only feasible designs count (`--no-feasibility` switches this off): the interface carries its load (demand and tension at most 1), no beam yields, no spring \
    leaves the range of its law, no rigid stop is hit under a fused interface, and the plate's face is at least 3 diameters wide.\n\
    Several objectives: NSGA-II finds the Pareto front. One objective: NSGA-II, then COBYLA from the best design.\n\
    Exit status 1 when no design satisfies every constraint.")]
pub(super) struct OptimiseArguments {
    /// A variable and its bounds; may be repeated [default: the ranges of Table 9.2]
    #[arg(long, value_name = "NAME=LO..HI[:log]", allow_hyphen_values = true)]
    over: Vec<String>,
    /// Quantities to minimise, separated by commas
    #[arg(long, value_name = "QUANTITIES", value_delimiter = ',', visible_alias = "minimize")]
    minimise: Vec<String>,
    /// Quantities to maximise, separated by commas
    #[arg(long, value_name = "QUANTITIES", value_delimiter = ',', visible_alias = "maximize")]
    maximise: Vec<String>,
    /// A bound to keep; may be repeated.
    #[arg(
        long,
        value_name = "QUANTITY<=VALUE",
        allow_hyphen_values = true,
        help = "A constraint, SI or with a unit: 'stroke_m<=50mm', 'percent_of_baseline<=60', 'limit_velocity_m_s>=300'; may be repeated [default: 'stroke_m<=1m' where the stroke is minimised]"
    )]
    subject_to: Vec<String>,
    /// Ignore the feasibility constraints: interface demand and tension, yield and travel of the spring, rigid stop, plate face
    #[arg(long)]
    no_feasibility: bool,
    /// Interface laws to search
    #[arg(long, value_enum, default_value = "both")]
    laws: Laws,
    /// Number of designs in a generation, even; also the maximum size of the front
    #[arg(long, value_name = "COUNT", allow_negative_numbers = true, default_value_t = 100, value_parser = population)]
    population: usize,
    /// Number of generations after the first
    #[arg(long, value_name = "COUNT", allow_negative_numbers = true, default_value_t = 100, value_parser = count(0..=GENERATIONS_MAX))]
    generations: usize,
    #[command(flatten)]
    random: Random,
    #[command(flatten)]
    study: StudyArguments,
}

impl OptimiseArguments {
    fn task(&self, scene: &Scene) -> Result<Task, CliError> {
        let objectives = objectives(&self.minimise, &self.maximise)?;
        // As in the workbench: without a bound, the stroke of some designs is kilometres.
        let has_stroke = objectives.iter().any(|it| it.measure.name == "stroke_m" && !it.maximise);
        let usual = (self.subject_to.is_empty() && has_stroke).then_some("stroke_m<=1m");
        let named = self.subject_to.iter().map(String::as_str).chain(usual).map(|text| {
            Constraint::parse(text)
                .map_err(|why| CliError::Option(format!("--subject-to {text}: {why}")))
        });
        let mut constraints: Vec<Constraint> = named.collect::<Result<_, _>>()?;
        if !self.no_feasibility {
            constraints.extend(feasibility());
        }
        Ok(Task {
            axes: bounds(&self.over, scene, thesis_axes)?,
            objectives,
            constraints,
            laws: match self.laws {
                Laws::Both => vec![InterfaceLaw::Fused, InterfaceLaw::Plastic],
                Laws::Fused => vec![InterfaceLaw::Fused],
                Laws::Plastic => vec![InterfaceLaw::Plastic],
            },
            effort: EvolutionOptions {
                population: self.population,
                generations: self.generations,
                seed: self.random.seed,
            },
        })
    }
}

fn population(text: &str) -> Result<usize, String> {
    let is_usable = |it: &usize| POPULATION.contains(it) && it.is_multiple_of(2);
    text.parse().ok().filter(is_usable).ok_or_else(|| {
        let (least, most) = (POPULATION.start(), POPULATION.end());
        format!("not an even number in {least}..{most}: 100 is usual")
    })
}

/// Runs the search; exit status 1 when no design keeps every constraint, or after an interrupt.
pub(super) fn run(arguments: &OptimiseArguments) -> Result<ExitCode, CliError> {
    let preset = arguments.study.load()?;
    let task = arguments.task(&preset.scene)?;
    let fronts = arguments.study.run("runs", |context| optimise(&preset.scene, &task, context))?;
    let name = preset.name.as_str();
    let warnings = front::warnings(&preset.scene, &task, &fronts);
    let (page, object) = (page(name, &task, &fronts), front::json(name, &task, &fronts));
    let answer = StudyOutput { warnings, page, object, rows: front::table(name, &task, &fronts) };
    arguments.study.deliver(&preset.scene, answer)?;
    Ok(progress::exit_code(fronts.iter().all(|front| !front.designs.is_empty())))
}

fn page(name: &str, task: &Task, fronts: &[Front]) -> String {
    let objective = |it: &crate::study::search::front::Objective| {
        let most = if it.maximise { "greatest " } else { "least " };
        most.to_owned() + &it.measure.title()
    };
    let objectives: Vec<String> = task.objectives.iter().map(objective).collect();
    let mut page = format!("{name}: {}\n", objectives.join(", "));
    let (feasible, named): (Vec<&Constraint>, Vec<&Constraint>) =
        task.constraints.iter().partition(|constraint| constraint.is_feasibility);
    for constraint in named {
        let _ = writeln!(page, "  subject to {}", constraint.words());
    }
    if !feasible.is_empty() {
        let words: Vec<String> = feasible.iter().map(|constraint| constraint.words()).collect();
        let _ = writeln!(page, "  feasible: {}", words.join(", "));
        page.push_str("            (--no-feasibility switches this off)\n");
    }
    for axis in &task.axes {
        let (low, high) = axis.ends();
        let log = if axis.spacing() == Spacing::Log { " (log)" } else { "" };
        let (low, high) = (significant(low, 4), axis.show(high, 4));
        let _ = writeln!(page, "  {:8}{low} .. {high}{log}", axis.symbol());
    }
    for front in fronts {
        front_lines(&mut page, task, front);
    }
    page
}

fn front_lines(page: &mut String, task: &Task, front: &Front) {
    let count = front.designs.len();
    let kind = match (task.objectives.len(), count) {
        (_, 0) if front.lacks.iter().any(|it| it.count == front.runs) => "no design".to_owned(),
        (_, 0) => "no design satisfies every constraint".to_owned(),
        (1, _) => "the best design".to_owned(),
        (_, _) => format!("a front of {count} designs"),
    };
    let early = if front.is_complete { "" } else { ", stopped early" };
    let Front { runs, generations, .. } = front;
    let (law, seed) = (front.law.word(), task.effort.seed);
    let _ = writeln!(
        page,
        "\ninterface {law}: {kind} ({runs} runs, {generations} generations, seed {seed}{early})"
    );
    if front.given_up > 0 {
        let count = front.given_up;
        let _ = writeln!(
            page,
            "  {count} runs stopped after {STEPS_MAX} steps: such designs count as failed"
        );
    }
    for lack in front::lacks(front) {
        *page += &hanging("  ", &lack, 2);
    }
    // Spread over the front, the first and the last among them.
    let listed = count.min(LISTED);
    if count > 0 {
        let place = |at: usize| if listed > 1 { at * (count - 1) / (listed - 1) } else { 0 };
        let table = designs(task, front, (0..listed).map(place));
        let numbers = (0..listed).map(|at| (place(at) + 1).to_string()).collect();
        let measures = task.measures();
        let shown = task.shown().into_iter().map(|at| measures[at].name);
        let keys: Vec<&str> = task.axes.iter().map(Axis::symbol).chain(shown).collect();
        let mut cells = vec![Cells { head: String::new(), is_text: false, cells: numbers }];
        cells.extend(table.cells(&keys));
        *page += &grid(&cells, width());
    }
    if listed < count {
        let _ = writeln!(page, "      ({listed} of {count}; --csv FILE has them all)");
    }
    page.push('\n');
    for candidate in &front.candidates {
        stands(page, task, candidate);
    }
}

fn stands(page: &mut String, task: &Task, candidate: &Candidate) {
    let measures = task.measures();
    let found = task.shown().into_iter();
    let found = found.map(|at| measures[at].show_any(candidate.measures[at], 4));
    let found: Vec<String> = found.collect();
    let words = standing(candidate, task).text;
    let _ = writeln!(page, "  {:20}{words}\n  {:20}{}", candidate.name, "", found.join("  "));
    if candidate.source != "as it is" {
        let _ = writeln!(page, "  {:20}{}", "", candidate.source);
    }
}
