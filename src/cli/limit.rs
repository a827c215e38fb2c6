//! `cmra limit [SCENE]`: the ballistic limit and the residual-velocity curve, as a page, CSV or JSON.

use std::fmt::Write as _;
use std::process::ExitCode;
use std::sync::Arc;

use clap::Args;

use crate::cli::amount::{count, deviation, part};
use crate::cli::pictures::PictureArguments;
use crate::cli::study::{Random, StudyArguments, StudyOutput};
use crate::cli::table::choice;
use crate::cli::text::{chart_size, hanging};
use crate::cli::{CliError, draw, progress};
use crate::model::units::velocity;
use crate::report::limit::{self, remarks, residual, taken_to_hold};
use crate::report::svg::Picture;
use crate::study::limit::monte_carlo::{ModelError, Sampling};
use crate::study::limit::{Criterion, Limit, LimitOptions, Report, find};
use crate::tui::theme::Theme;

const SAMPLES_MAX: u64 = 1_000_000;

#[derive(Debug, Args)]
pub(super) struct LimitArguments {
    /// Relative standard deviation of the inputs (0.02 or 2%), for V50 and its spread; 0 skips this
    #[arg(long, alias = "scatter", value_name = "FRACTION", allow_negative_numbers = true, default_value = "0.02", value_parser = deviation)]
    monte_carlo: f64,
    /// Mean ratio of model to measurement, minus 1, from `cmra validate` (-0.04 or -4%); corrects V50
    #[arg(long, value_name = "FRACTION", allow_negative_numbers = true, allow_hyphen_values = true, default_value = "0", value_parser = bias)]
    model_bias: f64,
    /// Standard deviation of the ratio of model to measurement (0.08 or 8%); widens the band of V50
    #[arg(long, value_name = "FRACTION", allow_negative_numbers = true, default_value = "0", value_parser = deviation)]
    model_spread: f64,
    /// Number of Monte Carlo samples
    #[arg(long, value_name = "COUNT", allow_negative_numbers = true, default_value_t = 200, value_parser = count(2..=SAMPLES_MAX))]
    samples: usize,
    #[command(flatten)]
    random: Random,
    /// What counts as a perforation
    #[arg(long, value_name = "WORD", default_value = "passage", value_parser = choice(&Criterion::ALL, Criterion::word, Criterion::label))]
    criterion: Criterion,
    #[command(flatten)]
    pictures: PictureArguments,
    #[command(flatten)]
    study: StudyArguments,
}

fn bias(text: &str) -> Result<f64, String> {
    let bias = part(text)?;
    let problem = || "must be above -1: -0.04 for 4 % low".to_owned();
    (bias > -1.0 && bias.is_finite()).then_some(bias).ok_or_else(problem)
}

impl LimitArguments {
    fn sampling(&self) -> Option<Sampling> {
        let (deviation, samples, seed) = (self.monte_carlo, self.samples, self.random.seed);
        let model = ModelError { bias: self.model_bias, spread: self.model_spread };
        (deviation > 0.0).then_some(Sampling { deviation, samples, seed, model })
    }
}

/// Finds the limit; "no limit" is a valid result. Exit status 1 after an interrupt.
pub(super) fn run(arguments: &LimitArguments) -> Result<ExitCode, CliError> {
    let LimitArguments { study, pictures, .. } = arguments;
    pictures.check(&study.table)?;
    if arguments.monte_carlo == 0.0 && (arguments.model_bias != 0.0 || arguments.model_spread > 0.0)
    {
        let text = "--model-bias and --model-spread correct V50, which --monte-carlo 0 skips: omit them, or give --monte-carlo a \
                    fraction above 0";
        return Err(CliError::Option(text.to_owned()));
    }
    let effort = LimitOptions { criterion: arguments.criterion, sampling: arguments.sampling() };
    let preset = study.load()?;
    let scene = Arc::new(preset.scene);
    let report = study.run("shots or so", |context| find(&scene, effort, context))?;
    let name = preset.name.as_str();
    let warnings = limit::warnings(&report, effort.sampling);
    if !pictures.is_stdout() {
        let (page, object) = (page(name, &report), limit::json(name, &report));
        let answer = StudyOutput { warnings, page, object, rows: limit::shots(name, &report) };
        study.deliver(&report.scene, answer)?;
    }
    let chart = || {
        residual(&report, report.scene.projectile.velocity_m_s, None)
            .map(Picture::Chart)
            .into_iter()
            .collect()
    };
    pictures.write(&study.table, chart)?;
    Ok(progress::exit_code(true))
}

const WIDTH: u16 = 80;
const HEIGHT: u16 = 18;
/// Columns of a label.
const LABEL: usize = 16;

fn page(name: &str, report: &Report) -> String {
    let mut page = format!("{name}: ballistic limit\n\n");
    head(&mut page, report);
    if let Some(chart) = residual(report, report.scene.projectile.velocity_m_s, None) {
        page.push_str(&draw::chart(&chart, chart_size((WIDTH, HEIGHT)), Theme::PLAIN));
    }
    page.push('\n');
    for remark in remarks(report).into_iter().chain(taken_to_hold(report)) {
        page += &hanging(&format!("{:LABEL$}", remark.about), &remark.text, LABEL);
    }
    page
}

fn head(page: &mut String, report: &Report) {
    let own = report.scene.projectile.velocity_m_s;
    match report.limit {
        Limit::Found { velocity_m_s, basis, .. } => {
            let _ =
                writeln!(page, "limit velocity  {}, {}", velocity(velocity_m_s, 6), basis.words());
        }
        Limit::Between { .. } | Limit::Never | Limit::Always | Limit::Unknown => {
            let _ = writeln!(page, "{}", report.limit.absence().unwrap_or_default());
        }
    }
    *page += &hanging("criterion       ", report.criterion.label(), LABEL);
    if let Some(margin) = report.margin() {
        let side = if margin < 0.0 { "which perforates" } else { "which is stopped" };
        let (percent, own) = (100.0 * margin, velocity(own, 6));
        let _ =
            writeln!(page, "margin          {percent:+.1} % relative to the scene's {own}: {side}");
    }
    page.push('\n');
}
