//! `cmra sensitivity [SCENE]`: which variables matter to one result, as a page, CSV or JSON.

use std::fmt::Write as _;
use std::num::ParseIntError;
use std::process::ExitCode;

use clap::Args;

use crate::cli::CliError;
use crate::cli::study::{Random, StudyArguments, axes};
use crate::cli::text::{hanging, width};
use crate::report::sensitivity;
use crate::report::sensitivity::{table, tornado};
use crate::study::quantities::named;
use crate::study::sensitivity::{Report, Request, SAMPLES, SCATTER, run as analyse};
use crate::study::validity;

/// Cells of the longest bar.
const BAR: usize = 20;

#[derive(Debug, Args)]
pub(super) struct SensitivityArguments {
    /// A variable and its bounds; may be repeated [default: the ranges of Table 9.2, and 4 % either way of every other input that
    /// `cmra montecarlo` scatters]
    #[arg(long, value_name = "NAME=LO..HI[:log]", allow_hyphen_values = true)]
    over: Vec<String>,
    #[arg(
        long,
        alias = "outputs",
        value_name = "NAME",
        help = "The quantity: `cmra explain` lists all [default: percent_of_baseline, of a stack final_penetration_m]"
    )]
    output: Option<String>,
    /// Base samples for Sobol's indices, a power of two; each takes two runs and one more per variable
    #[arg(long, value_name = "COUNT", allow_negative_numbers = true, default_value_t = Request::default().samples, value_parser = samples)]
    samples: usize,
    #[command(flatten)]
    random: Random,
    #[command(flatten)]
    study: StudyArguments,
}

fn samples(text: &str) -> Result<usize, String> {
    let rows: usize = text.parse().map_err(|error: ParseIntError| error.to_string())?;
    if SAMPLES.contains(&rows) && rows.is_power_of_two() {
        return Ok(rows);
    }
    let (least, most) = (*SAMPLES.start(), *SAMPLES.end());
    let near = rows.clamp(least, most).next_power_of_two();
    Err(format!("not a power of two in {least}..{most}: write {near}"))
}

pub(super) fn run(arguments: &SensitivityArguments) -> Result<ExitCode, CliError> {
    let request = Request {
        over: axes(&arguments.over)?,
        output: arguments.output.as_deref().map(named).transpose()?,
        samples: arguments.samples,
        seed: arguments.random.seed,
    };
    let preset = arguments.study.load()?;
    let (report, extent) =
        arguments.study.run("runs", |context| analyse(&preset.scene, &request, context));
    let report = report?;
    let name = preset.name.as_str();
    let warnings = validity::of_axes(&preset.scene, &report.axes);
    let page = page(name, &report, arguments.over.is_empty());
    let (source, object) = ((&preset.scene, request.to_string()), sensitivity::json(name, &report));
    arguments.study.deliver(extent, source, &warnings, page, object, table(name, &report))?;
    Ok(extent.exit_code(!report.is_empty()))
}

fn page(name: &str, report: &Report, is_usual: bool) -> String {
    let own = report.output.show_any(report.own, 4);
    let mut page = format!("{name}: what {} depends on", report.output.title());
    if let Some(condition) = sensitivity::condition(report) {
        hanging("", &format!("{page}, {condition}"), 2).trim_end().clone_into(&mut page);
    }
    let _ = writeln!(page, "\nthe scene itself: {own}");
    if is_usual {
        let varied = format!(
            "varied: the ranges of Table 9.2, and {:.0} % either way of what else a Monte Carlo study scatters; --over \
             NAME=LO..HI, repeated, varies others instead",
            100.0 * SCATTER
        );
        page += &hanging("", &varied, 2);
    }
    page.push('\n');
    if report.is_empty() {
        page.push_str("nothing to compare: no run has this result; choose another one: --output\n");
        return page;
    }
    let keys = ["variable", "low", "high", "output_at_low", "output_at_high", "bar"];
    let bars = tornado(report, BAR).page(&keys, width());
    let _ = writeln!(page, "one at a time, the others as in the scene\n{bars}");
    sobol(&mut page, report);
    page
}

fn sobol(page: &mut String, report: &Report) {
    let Some(found) = &report.sobol else { return };
    let _ = writeln!(
        page,
        "Sobol's indices: fractions of the variance, 95 % intervals ({} samples, seed {})",
        found.rows, report.seed
    );
    let mut keys = table("", report).keys();
    keys.retain(|key| *key == "variable" || key.starts_with("sobol_"));
    *page += &table("", report).page(&keys, width());
    let deviation = found.variance.is_finite().then(|| found.variance.sqrt());
    let mean = found.mean.is_finite().then_some(found.mean);
    let [mean, deviation] = [mean, deviation].map(|it| report.output.show_any(it, 4));
    let _ = writeln!(page, "  mean {mean}, standard deviation {deviation}");
    if found.inputs.iter().all(|input| input.first.is_none()) {
        page.push_str(
            "  no indices: the result does not vary, or has no value, over these bounds\n",
        );
    }
}
