//! `cmra sensitivity [SCENE]`: effect of each variable on a quantity, as a page, CSV or JSON.

use std::fmt::Write as _;
use std::process::ExitCode;

use clap::Args;

use crate::cli::study::{StudyArguments, axes};
use crate::cli::text::{hanging, width};
use crate::cli::{CliError, Glyphs};
use crate::tui::theme::GlyphSet;
use cmra_studies::report::sensitivity::{self, ASCII, BLOCKS, table};
use cmra_studies::study::quantities::named;
use cmra_studies::study::sensitivity::{
    Effect, OUTPUT, Request, SensitivityReport, run as analyse,
};
use cmra_studies::study::sweep::Axis;
use cmra_studies::study::validity;

/// Keys of the columns of the page.
const KEYS: [&str; 5] = ["variable", "range", "bar", "span", "slope"];

#[derive(Debug, Args)]
pub(super) struct SensitivityArguments {
    /// A variable and its range; may be repeated [default: the design and analysis variables that the scene uses, over the ranges of
    /// Table 9.2, else a quarter to four times their values by logarithm]
    #[arg(long, value_name = "NAME=LO..HI[:log]", allow_hyphen_values = true)]
    over: Vec<String>,
    #[arg(
        long,
        alias = "outputs",
        value_name = "NAME",
        help = format!("The quantity: `cmra explain` lists all [default: {OUTPUT}]")
    )]
    output: Option<String>,
    /// Choose the characters of the bars
    #[arg(long, value_enum, default_value = "auto", value_name = "GLYPHS")]
    glyphs: Glyphs,
    #[command(flatten)]
    study: StudyArguments,
}

pub(super) fn run(arguments: &SensitivityArguments) -> Result<ExitCode, CliError> {
    let request = Request {
        over: axes(&arguments.over)?,
        output: arguments.output.as_deref().map(named).transpose()?,
    };
    let preset = arguments.study.load()?;
    let (report, extent) =
        arguments.study.run("runs", |context| analyse(&preset.scene, &request, context));
    let report = report?;
    let name = preset.name.as_str();
    let axes: Vec<Axis> = report.effects.iter().map(|effect| effect.axis.clone()).collect();
    let warnings = validity::of_axes(&preset.scene, &axes);
    let levels = match arguments.glyphs.chosen() {
        Some(GlyphSet::Block | GlyphSet::Braille) => BLOCKS,
        Some(GlyphSet::Ascii) | None => ASCII,
    };
    let page = page(&preset.heading, &report, levels, arguments.over.is_empty());
    let (source, object) = ((&preset.scene, request.to_string()), sensitivity::json(name, &report));
    arguments.study.deliver(extent, source, &warnings, (page, object), table(name, &report))?;
    Ok(extent.exit_code(!report.is_empty()))
}

fn page(name: &str, report: &SensitivityReport, levels: [char; 8], is_usual: bool) -> String {
    let own = report.output.show_any(report.own.and_then(|own| own.result), 4);
    let mut page = format!("{name}: what {} depends on\n", report.output.title());
    let _ = writeln!(page, "the scene itself: {own}");
    if is_usual {
        let varied = "one variable at a time: the ranges of Table 9.2, else a quarter to four times the scene's value by logarithm; \
                      --over NAME=LO..HI, repeated, varies others instead";
        page += &hanging("", varied, 2);
    }
    page.push('\n');
    let Some(scale) = report.scale().filter(|_| !report.is_empty()) else {
        page.push_str("nothing to compare: no run has this result; choose another one: --output\n");
        return page;
    };
    page += &sensitivity::page(report, levels).page(&KEYS, width());
    let top = report.output.show(scale, 3);
    let through = if report.effects.iter().any(Effect::perforates) {
        "; P: shots perforate within the range"
    } else {
        ""
    };
    let key = format!(
        "bars: 0 to {top}, the 95th percentile of all runs; here: by the slope at the scene's value{through}"
    );
    page.push('\n');
    page + &hanging("", &key, 2)
}
