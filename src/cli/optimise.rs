//! `cmra optimise [SCENE] --over ...`: Pareto front, as a page, CSV or JSON.

use std::fmt::Write as _;
use std::process::ExitCode;

use clap::Args;

use crate::cli::CliError;
use crate::cli::study::{StudyArguments, axes};
use crate::cli::text::{hanging, width};
use crate::cli::value_parsers::count;
use cmra_engine::model::units::significant;
use cmra_studies::report::front;
use cmra_studies::report::table::{Cells, grid};
use cmra_studies::study::context::Reach;
use cmra_studies::study::search::front::{
    Constraint, FrontReport, Objective, Request, SAMPLES, STEPS_MAX, default_bounds, run as search,
};
use cmra_studies::study::sweep::Spacing;

/// Maximum number of designs that a page lists.
const LISTED: usize = 16;

#[derive(Debug, Args)]
#[command(after_help = "QUANTITY is any quantity: `cmra explain` lists all. \
    Without --minimise and --maximise: depth, stroke, system mass and mount force are minimised.\n\
    Only feasible designs count (`--no-feasibility` switches this off): the shot is slower than the band of the limit where such shots were \
    measured, its own run is not perforated, and the run has no warning that the answer errs on the unsafe side, such as an interface, a spring \
    or a stop that does not carry its load, or a plate's face below 3 diameters.\n\
    Designs are sampled by Sobol's sequence, first everywhere, then in shrinking boxes around the best. The same request gives the \
    same digits.\n\
    Exit status 1 when no design satisfies every constraint.")]
pub(super) struct OptimiseArguments {
    /// A variable and its bounds; may be repeated.
    #[arg(
        long,
        value_name = "NAME=LO..HI[:log]",
        allow_hyphen_values = true,
        help = "A variable and its bounds; may be repeated [default: the ranges of Table 9.2; for another projectile than that of the thesis, gamma of plates 3 to 12 diameters wide]"
    )]
    over: Vec<String>,
    /// Quantities to minimise, separated by commas
    #[arg(long, value_name = "QUANTITIES", value_delimiter = ',', visible_alias = "minimize")]
    minimise: Vec<String>,
    /// Quantities to maximise, separated by commas
    #[arg(long, value_name = "QUANTITIES", value_delimiter = ',', visible_alias = "maximize")]
    maximise: Vec<String>,
    /// Bounds to keep, separated by commas; may be repeated.
    #[arg(
        long,
        value_name = "QUANTITY<=VALUE",
        value_delimiter = ',',
        allow_hyphen_values = true,
        help = "Constraints, SI or with a unit, separated by commas: 'stroke_m<=50mm', 'limit_velocity_m_s>=300'; none: no constraint [default: 'stroke_m<=1m' where the stroke is minimised]"
    )]
    subject_to: Vec<String>,
    /// Count designs, too, whose run has warnings on the unsafe side
    #[arg(long)]
    no_feasibility: bool,
    /// Number of designs to try
    #[arg(long, value_name = "COUNT", allow_negative_numbers = true, default_value_t = Request::default().samples, value_parser = count(*SAMPLES.start() as u64..=*SAMPLES.end() as u64))]
    samples: usize,
    #[command(flatten)]
    study: StudyArguments,
}

impl OptimiseArguments {
    fn request(&self) -> Result<Request, CliError> {
        let small = self.minimise.iter().map(|name| Objective::new(name, false));
        let great = self.maximise.iter().map(|name| Objective::new(name, true));
        let mut objectives: Vec<Objective> = small.chain(great).collect::<Result<_, _>>()?;
        if objectives.is_empty() {
            objectives = Objective::usual();
        }
        let read = |text: &String| {
            let refuse = |why| CliError::Option(format!("--subject-to {text}: {why}"));
            text.parse::<Constraint>().map_err(refuse)
        };
        let named = self.subject_to.iter().filter(|text| *text != "none").map(read);
        let named: Vec<Constraint> = named.collect::<Result<_, _>>()?;
        let is_named = !self.subject_to.is_empty();
        Ok(Request {
            over: axes(&self.over)?,
            subject_to: if is_named { named } else { default_bounds(&objectives) },
            objectives,
            is_feasible: !self.no_feasibility,
            samples: self.samples,
        })
    }
}

/// Runs the search; exit status 1 if no design satisfies every constraint, or after an interrupt.
pub(super) fn run(arguments: &OptimiseArguments) -> Result<ExitCode, CliError> {
    let request = arguments.request()?;
    let preset = arguments.study.load()?;
    let (front, extent) =
        arguments.study.run("runs", |context| search(&preset.scene, &request, context));
    let front = front?;
    let name = preset.name.as_str();
    let (page, object) =
        (page(&preset.heading, &front, extent.reach), front::json(name, &front, extent.reach));
    let warnings = front::warnings(&front);
    let source = (&preset.scene, request.to_string());
    arguments.study.deliver(
        extent,
        source,
        &warnings,
        (page, object),
        front::table(name, &front),
    )?;
    Ok(extent.exit_code(!front.designs.is_empty()))
}

fn page(name: &str, front: &FrontReport, reach: Reach) -> String {
    let request = &front.request;
    let objective = |it: &Objective| {
        let most = if it.maximise { "greatest " } else { "least " };
        most.to_owned() + &it.measure.title()
    };
    let objectives: Vec<String> = request.objectives.iter().map(objective).collect();
    let mut page = format!("{name}: {}\n", objectives.join(", "));
    for constraint in &request.subject_to {
        let _ = writeln!(page, "  subject to {}", constraint.label());
    }
    if request.is_feasible {
        let _ = writeln!(page, "  {} (--no-feasibility switches this off)", front::FEASIBLE);
    }
    for axis in &request.over {
        let (low, high) = axis.ends();
        let log = if axis.spacing() == Spacing::Log { " (log)" } else { "" };
        let (low, high) = (significant(low, 4), axis.show(high, 4));
        let _ = writeln!(page, "  {:8}{low} .. {high}{log}", axis.symbol());
    }
    designs(&mut page, front, reach);
    page
}

fn designs(page: &mut String, front: &FrontReport, reach: Reach) {
    let count = front.designs.len();
    let kind = match (front.request.objectives.len(), count) {
        (_, 0) if front.lacks.iter().any(|it| it.count == front.runs) => "no design".to_owned(),
        (_, 0) => "no design satisfies every constraint".to_owned(),
        (1, _) => "the best design".to_owned(),
        (_, _) => format!("a front of {count} designs"),
    };
    let early = if reach.is_complete() { "" } else { ", stopped early" };
    let (law, runs) = (front.base.interface.law.word(), front.runs);
    let _ = writeln!(page, "\ninterface {law}: {kind} ({runs} runs{early})");
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
    // Evenly spaced along the front, including both ends.
    let listed = count.min(LISTED);
    if count > 0 {
        let place = |at: usize| if listed > 1 { at * (count - 1) / (listed - 1) } else { 0 };
        let mut table = front::table("", front);
        table.rows = (0..listed).map(place).collect();
        let numbers = (0..listed).map(|at| (place(at) + 1).to_string()).collect();
        let mut cells = vec![Cells { head: String::new(), is_text: false, cells: numbers }];
        cells.extend(table.cells(&front::page_keys(front)));
        *page += &grid(&cells, width());
    }
    if listed < count {
        let _ = writeln!(page, "      ({listed} of {count}; --csv FILE has them all)");
    }
}
