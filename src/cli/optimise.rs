//! `cmra optimise [SCENE] --over ...`: Pareto front, as a page, CSV or JSON.

use std::process::ExitCode;

use clap::Args;

use crate::cli::CliError;
use crate::cli::study::{StudyArguments, axes};
use crate::cli::value_parsers::count;
use cmra_engine::model::scene::Scene;
use cmra_studies::report::front::{self, page};
use cmra_studies::study::search::front::{
    Constraint, Objective, Request, SAMPLES, default_bounds, run as search,
};
use cmra_studies::study::sweep::default_axes::{or_usual, thesis_axes};

#[derive(Debug, Args)]
#[command(after_help = "QUANTITY is any quantity: `cmra explain` lists all. \
    Without --minimise and --maximise: depth, stroke, system mass and mount force are minimised; of a stack the depth.\n\
    Only feasible designs count (`--no-feasibility` switches this off): the shot is slower than the band of the limit where such shots were \
    measured, its own run is not perforated, and the run has no warning that the answer errs on the unsafe side, such as an interface, a spring \
    or a stop that does not carry its load, or a plate's face below 3 diameters. Warnings of the scene itself are let pass, other than of \
    loads; the page names them.\n\
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
    fn request(&self, scene: &Scene) -> Result<Request, CliError> {
        let small = self.minimise.iter().map(|name| Objective::new(name, false));
        let great = self.maximise.iter().map(|name| Objective::new(name, true));
        let mut objectives: Vec<Objective> = small.chain(great).collect::<Result<_, _>>()?;
        if objectives.is_empty() {
            objectives = Objective::usual_for(scene);
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
    let preset = arguments.study.read()?;
    let request = arguments.request(&preset.scene)?;
    let over = or_usual(&request.over, || thesis_axes(&preset.scene))?;
    arguments.study.say_unused(&preset.scene, &over);
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
