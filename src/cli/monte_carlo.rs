//! `cmra montecarlo [SCENE]`: distribution of results for random inputs, as a page, CSV or JSON.

use std::process::ExitCode;

use clap::Args;

use crate::cli::CliError;
use crate::cli::study::{Random, StudyArguments};
use crate::cli::value_parsers::{deviation, part};
use cmra_engine::model::scene::Scene;
use cmra_studies::report::monte_carlo::{self, page, table};
use cmra_studies::report::verdict::sentence;
use cmra_studies::study::monte_carlo::{
    DEFAULT_DEVIATION, DEFAULT_LIMIT_SAMPLES, DEFAULT_SAMPLES, LIMIT, Request, SAMPLES, Tolerance,
    run as study,
};
use cmra_studies::study::quantities::{Quantity, named};
use cmra_studies::study::sweep::PointOutcome;
use cmra_studies::study::verdict::Verdict;

#[derive(Debug, Args)]
#[command(
    after_help = format!("DISTRIBUTION is normal:WIDTH, where the scene's own value is the mean and WIDTH the standard deviation; lognormal:WIDTH, where the \
    scene's own value is the median and WIDTH over it the standard deviation of the natural logarithm; or uniform:LO..HI. WIDTH is a \
    percentage of the scene's own value, or has a unit: normal:2%, normal:0.1mm. \
    A draw outside the allowed range is repeated, which truncates the distribution; the page reports how often.\n\
    Memory: eight bytes for each sample and result; at most {} million samples.", SAMPLES.end() / 1_000_000)
)]
pub(super) struct MonteCarloArguments {
    /// An input and how it scatters; may be repeated.
    #[arg(
        long,
        value_name = "NAME=DISTRIBUTION",
        allow_hyphen_values = true,
        help = format!("An input and its distribution: v_i=normal:2%, h=uniform:24mm..27mm; may be repeated [default: velocity, masses, \
                lengths, strength, density, drag, spring and damper, each lognormal by {} %]", 100.0 * DEFAULT_DEVIATION)
    )]
    vary: Vec<String>,
    /// Quantities, separated by commas [default: all but those about the computation]
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    outputs: Vec<String>,
    /// Number of samples.
    #[arg(long, value_name = "COUNT", allow_negative_numbers = true, help = format!("Number of samples [default: {DEFAULT_SAMPLES}, or {DEFAULT_LIMIT_SAMPLES} where each takes a limit search]"))]
    samples: Option<usize>,
    /// Mean ratio of model to measurement, minus 1 (-0.04 or -4%); corrects `limit_velocity_m_s` [default: that of
    /// the scene's class in `cmra validate`, else 0]
    #[arg(long, value_name = "FRACTION", allow_negative_numbers = true, allow_hyphen_values = true, value_parser = bias)]
    model_bias: Option<f64>,
    /// Standard deviation of that ratio (0.08 or 8%); widens `limit_velocity_m_s` [default: as for the bias]
    #[arg(long, value_name = "FRACTION", allow_negative_numbers = true, value_parser = deviation)]
    model_spread: Option<f64>,
    #[command(flatten)]
    random: Random,
    #[command(flatten)]
    study: StudyArguments,
}

impl MonteCarloArguments {
    fn request(&self, scene: &Scene) -> Result<Request, CliError> {
        let vary = self.vary.iter().map(|text| vary(text, scene));
        let outputs = self.outputs.iter().map(|name| named(name.trim()));
        let outputs: Vec<&'static Quantity> = outputs.collect::<Result<_, _>>()?;
        let is_corrected = outputs.iter().any(|it| it.name == LIMIT);
        if !is_corrected && (self.model_bias.is_some() || self.model_spread.is_some()) {
            return Err(CliError::Option(format!(
                "--model-bias and --model-spread correct {LIMIT}: add --outputs {LIMIT}, or omit them"
            )));
        }
        Ok(Request {
            vary: vary.collect::<Result<_, _>>()?,
            outputs,
            samples: self.samples,
            seed: self.random.seed,
            model_bias: self.model_bias,
            model_spread: self.model_spread,
        })
    }
}

fn bias(text: &str) -> Result<f64, String> {
    let bias = part(text)?;
    let problem = || "must be above -1: -0.04 for 4 % low".to_owned();
    (bias > -1.0 && bias.is_finite()).then_some(bias).ok_or_else(problem)
}

fn vary(text: &str, scene: &Scene) -> Result<Tolerance, CliError> {
    let refuse = |why: &str| CliError::Option(format!("--vary {text}: {why}"));
    let (name, how) = text.split_once('=').ok_or_else(|| {
        refuse("write NAME=DISTRIBUTION, for example v_i=normal:2% or h=uniform:24mm..27mm")
    })?;
    Tolerance::parse(name.trim(), how, scene).map_err(|why| refuse(&why.to_string()))
}

/// Runs the samples; exit status 1 if a sample failed, or after an interrupt.
pub(super) fn run(arguments: &MonteCarloArguments) -> Result<ExitCode, CliError> {
    let preset = arguments.study.read()?;
    let request = arguments.request(&preset.scene)?;
    let varied = request.vary.iter().map(|it| it.variable);
    arguments.study.scene.changes.say_unused(&preset.scene, varied);
    let (report, extent) =
        arguments.study.run("runs", |context| study(&preset.scene, &request, context));
    let report = report?;
    let name = preset.name.as_str();
    let warnings = monte_carlo::warnings(&preset.scene, &report);
    let verdict = Verdict::from_scene(&preset.scene);
    let by_law = report.nominal.and_then(|outcome| match outcome {
        PointOutcome::Ended(outcome) => Some(outcome),
        PointOutcome::Failed(_) => None,
    });
    let answer = sentence(&preset.scene, &verdict, by_law);
    let page = page(&preset.heading, &report, (&answer, extent.reach));
    let object = monte_carlo::json(name, &report, &verdict, extent.reach);
    let source = (&preset.scene, request.to_string());
    arguments.study.deliver(extent, source, &warnings, (page, object), table(name, &report))?;
    let failed = Some(report.outcomes.failed).filter(|failed| *failed > 0);
    let failed = failed.map(|failed| format!("{failed} samples failed and are not counted"));
    Ok(extent.exit_code_after(failed))
}
