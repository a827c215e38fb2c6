//! Command line: arguments, and one file for each subcommand.
//!
//! Results go to standard output and everything else to standard error, both through `cli::output`. Every result of the workbench has a
//! subcommand that computes it with the same code.

use std::ffi::OsString;
use std::process::ExitCode;

use clap::{CommandFactory as _, FromArgMatches as _, Parser, ValueEnum};

use crate::files::clean;
use crate::worker::clock::Clock;

mod accuracy;
mod charts;
mod commands;
mod compare;
mod completions;
mod design;
mod error;
mod explain;
mod help;
mod install;
mod libraries;
mod limit;
mod monte_carlo;
mod optimise;
mod output;
mod presets;
mod progress;
mod report;
mod reproduce;
mod run;
mod scene;
mod seek;
mod sensitivity;
mod stability;
mod study;
mod sweep;
mod table;
mod text;
mod usage;
mod validate;
mod value_parsers;
mod workbench;

pub use error::CliError;
pub use output::fail;

/// Explore compliant mechanically reactive armour: what a projectile does to a plate on a spring and a damper.
///
/// Without a subcommand the workbench opens, on SCENE, on the last session, or on the baseline of the thesis.
#[derive(Debug, Parser)]
#[command(
    name = "cmra",
    bin_name = "cmra",
    version,
    args_conflicts_with_subcommands = true,
    disable_help_subcommand = true,
    max_term_width = 100,
    after_help = "SCENE is a preset's name (see `cmra presets`) or the path of a TOML file.\n\
                  Exit status: 0 done, 1 the computation failed, 2 the command line or an\n\
                  input file is wrong."
)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    command: Option<commands::Commands>,
    #[command(flatten)]
    workbench: workbench::WorkbenchArguments,
}

/// Choose the characters of the charts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Glyphs {
    /// Whatever the locale allows; plain text stays ASCII
    Auto,
    /// Letters and punctuation only: works everywhere, and screen readers can follow
    Ascii,
    /// Block elements
    Block,
    /// Braille dots: the finest, where the font has them
    Braille,
}

/// Runs a command line as [`run()`] does, with a clock for the progress of long computations.
pub fn run_by(
    clock: Clock,
    arguments: impl Iterator<Item = OsString>,
) -> Result<ExitCode, CliError> {
    progress::use_clock(clock);
    run(arguments)
}

/// Runs a command line; the first argument is the name of the program.
pub fn run(arguments: impl Iterator<Item = OsString>) -> Result<ExitCode, CliError> {
    progress::survive_large_files();
    let written: Vec<OsString> = arguments.collect();
    let matches = match help::grouped(Arguments::command()).try_get_matches_from(&written) {
        Ok(matches) => matches,
        Err(error) => {
            if let Some(line) = usage::line(&error, &commands::whole(), &written) {
                // The message repeats the arguments, which can contain control sequences of the terminal.
                output::note(&clean::line(&format!("error: {line}")));
            } else {
                // Help and version.
                error.print().map_err(CliError::Stdout)?;
            }
            return Ok(ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2)));
        }
    };
    // The parser has checked the arguments.
    let arguments = Arguments::from_arg_matches(&matches)
        .map_err(|error| CliError::Option(error.to_string()))?;
    match arguments.command {
        Some(command) => command.carry_out(),
        None => workbench::run(&arguments.workbench),
    }
}
