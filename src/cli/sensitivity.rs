//! `cmra sensitivity [SCENE]`: effect of each variable on a quantity, as a page, CSV or JSON.

use std::process::ExitCode;

use clap::Args;

use crate::cli::study::{StudyArguments, axes};
use crate::cli::{CliError, Glyphs};
use crate::tui::theme::GlyphSet;
use cmra_studies::report::sensitivity::{self, ASCII, BLOCKS, page, table};
use cmra_studies::study::quantities::named;
use cmra_studies::study::sensitivity::{OUTPUT, Request, default_axes, run as analyse};
use cmra_studies::study::sweep::Axis;
use cmra_studies::study::sweep::default_axes::or_usual;
use cmra_studies::study::validity;

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
    let preset = arguments.study.read()?;
    let over = or_usual(&request.over, || Ok(default_axes(&preset.scene)))?;
    arguments.study.say_unused(&preset.scene, &over);
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
