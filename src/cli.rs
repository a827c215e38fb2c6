//! The command line: arguments, and one file a subcommand.
//!
//! Results go to standard output, everything else to standard error; both through `cli::output` alone. A person who can
//! compute something in the workbench can compute it here, with the same code.

use std::ffi::OsString;
use std::process::ExitCode;

use clap::{Args, FromArgMatches as _, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;

use crate::files::clean;

mod accuracy;
mod again;
mod compare;
mod completions;
mod design;
mod draw;
mod error;
mod explain;
mod fit;
mod help;
mod install;
mod join;
mod libraries;
mod limit;
mod man;
mod models;
mod monte_carlo;
mod optimise;
mod outlook;
mod output;
mod pace;
mod paths;
mod pictures;
mod plain;
mod presets;
mod report;
mod reproduce;
mod run;
mod scene;
mod search;
mod seek;
mod sensitivity;
mod stability;
mod summary;
mod sweep;
mod table;
mod text;
mod usage;
mod validate;
mod variables;
mod workbench;

pub use error::CliError;
pub use output::fail;

/// Explore compliant mechanically reactive armour: what a projectile does to a plate on a spring and a damper.
///
/// Without a subcommand the workbench opens, on SCENE, on the last session, or on the baseline of the thesis.
#[derive(Debug, Parser)]
#[command(
    name = "cmra",
    version,
    args_conflicts_with_subcommands = true,
    disable_help_subcommand = true,
    max_term_width = 100,
    after_help = "SCENE is a preset's name (see `cmra presets`) or the path of a TOML file.\n\
                  Exit status: 0 done, 1 the computation fell short, 2 the command line or an\n\
                  input file is wrong."
)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    workbench: workbench::WorkbenchArguments,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Run one scene and print what happened
    Run(run::RunArguments),
    /// Run a scene at every point of one or more axes
    Sweep(sweep::SweepArguments),
    /// Join the parts of a sweep that was computed with --shard
    Join(join::JoinArguments),
    /// Compare the error and the run time of every method
    Accuracy(accuracy::AccuracyArguments),
    /// Check stiff and extreme scenes; map where a fixed step is stable
    Stability(stability::StabilityArguments),
    /// Find the ballistic limit and the residual velocity beyond it
    Limit(limit::LimitArguments),
    /// Find V50 from shots of a test, and the strength that gives it
    Fit(fit::FitArguments),
    /// Check every claim of the thesis
    Reproduce(reproduce::ReproduceArguments),
    /// Compare the model with measurements from the literature
    Validate(validate::ValidateArguments),
    /// Print formulas, the screening matrix and the design principles
    Design(design::DesignArguments),
    /// Compare with a solid plate of the same areal mass; draw a map
    #[command(alias = "worth")]
    Compare(compare::CompareArguments),
    /// Write one file with scene, results, charts and warnings
    Report(report::ReportArguments),
    /// Find the values of a variable that reach a goal
    Seek(seek::SeekArguments),
    /// Find the best design under constraints, or a Pareto front
    #[command(visible_alias = "optimize")]
    Optimise(optimise::OptimiseArguments),
    /// Show how results spread when inputs do
    #[command(name = "montecarlo", alias = "scatter")]
    MonteCarlo(monte_carlo::MonteCarloArguments),
    /// Find which variables matter most
    Sensitivity(sensitivity::SensitivityArguments),
    /// List the presets, or show one
    Presets(presets::PresetsArguments),
    /// List threats, materials and absorbers with their sources
    Libraries(libraries::LibrariesArguments),
    /// Print every key of the workbench
    Keys,
    /// Explain a topic (scenes, csv, equations, ...) or a command
    Help(help::HelpArguments),
    /// List every variable of a scene: symbol, name, default, meaning
    Variables(variables::VariablesArguments),
    /// Explain one variable or quantity
    Explain(explain::ExplainArguments),
    /// Print where this program keeps presets, session and log
    Paths,
    /// Print a completion script for a shell
    Completions(CompletionsArguments),
    /// Print the manual page, in roff
    Man(man::ManArguments),
    /// Install manual pages and shell completions
    Install(install::InstallArguments),
}

#[derive(Debug, Args)]
struct CompletionsArguments {
    /// Which shell
    shell: Shell,
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

/// Carry out a command line; the first argument is the program's name.
///
/// # Errors
/// [`CliError`], which knows its exit code; [`fail`] prints it.
pub fn run(arguments: impl Iterator<Item = OsString>) -> Result<ExitCode, CliError> {
    pace::survive_large_files();
    let written: Vec<OsString> = arguments.collect();
    let parsed = help::command()
        .try_get_matches_from(&written)
        .and_then(|matches| Arguments::from_arg_matches(&matches));
    let arguments = match parsed {
        Ok(arguments) => arguments,
        Err(error) => {
            match usage::line(&error, &help::command(), &written) {
                // The parser repeats what was written; a terminal would obey it.
                Some(line) => output::note(&clean::line(&format!("error: {line}"))),
                // Help and version; a closed pipe ends them quietly.
                None => {
                    let _ = error.print();
                }
            }
            return Ok(ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2)));
        }
    };
    match arguments.command {
        None => workbench::run(&arguments.workbench),
        Some(Command::Run(arguments)) => run::run(&arguments),
        Some(Command::Sweep(arguments)) => sweep::run(&arguments),
        Some(Command::Join(arguments)) => join::run(&arguments),
        Some(Command::Accuracy(arguments)) => accuracy::run(&arguments),
        Some(Command::Stability(arguments)) => stability::run(&arguments),
        Some(Command::Limit(arguments)) => limit::run(&arguments),
        Some(Command::Fit(arguments)) => fit::run(&arguments),
        Some(Command::Reproduce(arguments)) => reproduce::run(&arguments),
        Some(Command::Validate(arguments)) => validate::run(&arguments),
        Some(Command::Design(arguments)) => design::run(&arguments),
        Some(Command::Compare(arguments)) => compare::run(&arguments),
        Some(Command::Report(arguments)) => report::run(&arguments),
        Some(Command::Seek(arguments)) => seek::run(&arguments),
        Some(Command::Optimise(arguments)) => optimise::run(&arguments),
        Some(Command::MonteCarlo(arguments)) => monte_carlo::run(&arguments),
        Some(Command::Sensitivity(arguments)) => sensitivity::run(&arguments),
        Some(Command::Presets(arguments)) => presets::run(&arguments),
        Some(Command::Keys) => help::run_keys(),
        Some(Command::Help(arguments)) => help::run(&arguments),
        Some(Command::Libraries(arguments)) => libraries::run(&arguments),
        Some(Command::Variables(arguments)) => {
            variables::run(&arguments).map(|()| ExitCode::SUCCESS)
        }
        Some(Command::Explain(arguments)) => explain::run(&arguments).map(|()| ExitCode::SUCCESS),
        Some(Command::Paths) => paths::run(),
        Some(Command::Completions(arguments)) => completions::run(arguments.shell),
        Some(Command::Man(arguments)) => man::run(&arguments),
        Some(Command::Install(arguments)) => install::run(&arguments),
    }
}
