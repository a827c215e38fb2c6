//! `cmra optimise [SCENE] --over ...`: the designs that nothing beats, as a page, CSV or JSON.

mod page;

use std::process::ExitCode;

use clap::{Args, ValueEnum};

use crate::cli::CliError;
use crate::cli::outlook::say_if_long;
use crate::cli::progress::ProgressLine;
use crate::cli::scene::SceneArguments;
use crate::cli::search::{Random, Threads, bounds};
use crate::cli::table::TableArguments;
use crate::model::scene::{InterfaceLaw, Scene};
use crate::report::front;
use crate::study::quantities::named;
use crate::study::search::front::{Constraint, STEPS_MAX, Task, feasibility, objectives, optimise};
use crate::study::search::nsga::Effort;
use crate::study::sweep::Plan;
use crate::study::validity;

/// Points of a generation, and generations.
const POPULATION: (usize, usize) = (8, 2000);
const GENERATIONS_MAX: usize = 100_000;

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
#[command(after_help = "RESULT is any quantity: `cmra explain quantities` lists all. \
    Without --minimise and --maximise: depth, stroke, system mass and mount force are minimised.\n\
    Only feasible designs count (`--no-feasibility` switches this off): the interface demand is at most 1, no beam yields, no spring \
    leaves the range of its law, no rigid stop is hit under a fused interface, and the plate's face is at least 3 diameters wide.\n\
    Several objectives: NSGA-II finds the Pareto front. One objective: NSGA-II, then COBYLA from the best design.\n\
    Exit status 1 when no design satisfies every constraint.")]
pub(super) struct OptimiseArguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// A variable and its bounds; may be repeated [default: the ranges of Table 9.2]
    #[arg(long, value_name = "NAME=LO..HI[:log]", allow_hyphen_values = true)]
    over: Vec<String>,
    /// Quantities to minimise, separated by commas
    #[arg(long, value_name = "RESULTS", value_delimiter = ',', visible_alias = "minimize")]
    minimise: Vec<String>,
    /// Quantities to maximise, separated by commas
    #[arg(long, value_name = "RESULTS", value_delimiter = ',', visible_alias = "maximize")]
    maximise: Vec<String>,
    /// A bound to keep; may be repeated.
    #[arg(
        long,
        value_name = "RESULT<=VALUE",
        allow_hyphen_values = true,
        help = "A constraint, SI or with a unit: 'stroke_m<=50mm', 'percent_of_baseline<=60', 'limit_velocity_m_s>=300'; may be repeated"
    )]
    subject_to: Vec<String>,
    /// Ignore the feasibility constraints: interface demand, yield and travel of the spring, rigid stop, plate face
    #[arg(long)]
    no_feasibility: bool,
    /// Interface laws to search
    #[arg(long, value_enum, default_value = "both")]
    laws: Laws,
    /// Number of designs in a generation, even; also the maximum size of the front
    #[arg(long, value_name = "COUNT", allow_negative_numbers = true, default_value_t = 100)]
    population: usize,
    /// Number of generations after the first
    #[arg(long, value_name = "COUNT", allow_negative_numbers = true, default_value_t = 100)]
    generations: usize,
    #[command(flatten)]
    random: Random,
    #[command(flatten)]
    threads: Threads,
    #[command(flatten)]
    table: TableArguments,
}

impl OptimiseArguments {
    fn effort(&self) -> Result<Effort, CliError> {
        let (population, generations) = (self.population, self.generations);
        let (least, most) = POPULATION;
        if !(least..=most).contains(&population) || population % 2 == 1 {
            return Err(CliError::Option(format!(
                "--population {population} is not an even number in {least}..{most}: 100 is usual"
            )));
        }
        if generations > GENERATIONS_MAX {
            return Err(CliError::Option(format!(
                "--generations {generations} is more than {GENERATIONS_MAX}: 100 is usual"
            )));
        }
        Ok(Effort { population, generations, seed: self.random.seed })
    }

    fn task(&self, scene: &Scene) -> Result<Task, CliError> {
        let named = self.subject_to.iter().map(|text| constraint(text));
        let mut constraints: Vec<Constraint> = named.collect::<Result<_, _>>()?;
        if !self.no_feasibility {
            constraints.extend(feasibility());
        }
        Ok(Task {
            axes: bounds(&self.over, scene)?,
            objectives: objectives(&self.minimise, &self.maximise)?,
            constraints,
            laws: match self.laws {
                Laws::Both => vec![InterfaceLaw::Fused, InterfaceLaw::Plastic],
                Laws::Fused => vec![InterfaceLaw::Fused],
                Laws::Plastic => vec![InterfaceLaw::Plastic],
            },
            effort: self.effort()?,
        })
    }
}

fn constraint(text: &str) -> Result<Constraint, CliError> {
    let refuse = |why: &str| CliError::Option(format!("--subject-to {text}: {why}"));
    let split = |sign: &str| text.split_once(sign);
    let (name, value, at_most) = split("<=")
        .map(|(name, value)| (name, value, true))
        .or_else(|| split(">=").map(|(name, value)| (name, value, false)))
        .ok_or_else(|| {
            refuse("write RESULT<=VALUE or RESULT>=VALUE, for example 'stroke_m<=50mm'")
        })?;
    let measure = named(name)?;
    let bound = measure.parse(value).map_err(|why| refuse(&why))?;
    Ok(Constraint { measure, at_most, bound, is_feasibility: false })
}

/// Runs the search; exit status 1 when no design keeps every constraint, or after an interrupt.
pub(super) fn run(arguments: &OptimiseArguments) -> Result<ExitCode, CliError> {
    arguments.table.check_beside()?;
    let preset = arguments.scene.load()?;
    let task = arguments.task(&preset.scene)?;
    let names: Vec<&str> = task.measures().iter().map(|column| column.name).collect();
    // The slower law stands for both.
    let mut slowest = preset.scene.clone();
    slowest.interface.law = task.laws.last().copied().unwrap_or(InterfaceLaw::Fused);
    let space = Plan::for_designs(&slowest, task.axes.clone(), &names)?.limited(STEPS_MAX);
    let mut line = ProgressLine::begin();
    let threads = arguments.threads.count();
    say_if_long(&space, task.runs() as u64, "runs", threads);
    let fronts = line.study(threads, "runs", |context| optimise(&preset.scene, &task, context))?;
    let name = preset.name.as_str();
    let mut warnings = Vec::new();
    for front in &fronts {
        let scenes = front.designs.iter().map(|design| front.scene(&task, design));
        warnings.extend(validity::of_designs(front.law.word(), scenes, &task.axes));
    }
    let object = || front::json(name, &task, &fronts);
    let page = || page::text(name, &task, &fronts);
    let rows = front::table(name, &task, &fronts);
    let table = arguments.table.of(&arguments.scene, &preset.scene);
    table.deliver_warned(&warnings, page, object, rows)?;
    let found = fronts.iter().all(|front| !front.designs.is_empty());
    Ok(line.exit_code(found))
}
