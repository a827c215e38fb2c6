//! Subcommands: description, arguments and function of each.

use std::process::ExitCode;

use clap::{Command, CommandFactory as _, Subcommand};

use crate::cli::{
    Arguments, CliError, accuracy, compare, completions, design, explain, help, install, libraries,
    limit, monte_carlo, optimise, presets, report, reproduce, run, seek, sensitivity, stability,
    sweep, validate,
};

/// Subcommands in the order of `cmra --help`. The descriptions are attributes: doc comments of shared arguments would replace them.
#[derive(Debug, Subcommand)]
pub(super) enum Commands {
    #[command(about = "Run one scene and print what happened", long_about = None)]
    Run(run::RunArguments),
    #[command(about = "Run a scene at every point of one or more axes", long_about = None)]
    Sweep(sweep::SweepArguments),
    #[command(about = "Find the ballistic limit and the residual velocity beyond it", long_about = None)]
    Limit(limit::LimitArguments),
    #[command(about = "Compare with a solid plate of the same areal mass; draw a map", long_about = None)]
    Compare(compare::CompareArguments),
    #[command(about = "Find the values of a variable that reach a goal", long_about = None)]
    Seek(seek::SeekArguments),
    #[command(
        about = "Find the best design under constraints, or a Pareto front", long_about = None,
        visible_alias = "optimize"
    )]
    Optimise(optimise::OptimiseArguments),
    #[command(about = "Compare the error and the run time of every method", long_about = None)]
    Accuracy(accuracy::AccuracyArguments),
    #[command(about = "Check stiff and extreme scenes; map where a fixed step is stable", long_about = None)]
    Stability(stability::StabilityArguments),
    #[command(about = "List the presets and where your own lie, or show one", long_about = None)]
    Presets(presets::PresetsArguments),
    #[command(about = "Find which variables matter most", long_about = None)]
    Sensitivity(sensitivity::SensitivityArguments),
    #[command(name = "montecarlo", about = "Show how results spread when inputs do", long_about = None)]
    MonteCarlo(monte_carlo::MonteCarloArguments),
    #[command(about = "Write one file with scene, results, charts and warnings", long_about = None)]
    Report(report::ReportArguments),
    #[command(about = "Compute again what the thesis prints", long_about = None)]
    Reproduce(reproduce::ReproduceArguments),
    #[command(about = "Compare the model with measurements from the literature", long_about = None)]
    Validate(validate::ValidateArguments),
    #[command(about = "Explain a variable, a quantity or a word of a screen", long_about = None)]
    Explain(explain::ExplainArguments),
    #[command(about = "List threats, materials and absorbers with their sources", long_about = None)]
    Libraries(libraries::LibrariesArguments),
    #[command(about = "Print a shot's formulas: ricochet, collisions, mass of a spring", long_about = None)]
    Design(design::DesignArguments),
    #[command(about = "Explain a topic (scenes, csv, equations, ...) or a command", long_about = None)]
    Help(help::HelpArguments),
    #[command(about = "Print a completion script for a shell", long_about = None)]
    Completions(completions::CompletionsArguments),
    #[command(about = "Install manual pages and shell completions", long_about = None)]
    Install(install::InstallArguments),
}

impl Commands {
    /// Runs the command.
    pub(super) fn carry_out(&self) -> Result<ExitCode, CliError> {
        let done = |()| ExitCode::SUCCESS;
        match self {
            Self::Run(it) => run::run(it),
            Self::Sweep(it) => sweep::run(it),
            Self::Limit(it) => limit::run(it),
            Self::Compare(it) => compare::run(it),
            Self::Seek(it) => seek::run(it),
            Self::Optimise(it) => optimise::run(it),
            Self::Accuracy(it) => accuracy::run(it),
            Self::Stability(it) => stability::run(it),
            Self::Presets(it) => presets::run(it).map(done),
            Self::Sensitivity(it) => sensitivity::run(it),
            Self::MonteCarlo(it) => monte_carlo::run(it),
            Self::Report(it) => report::run(it),
            Self::Reproduce(it) => reproduce::run(it),
            Self::Validate(it) => validate::run(it),
            Self::Explain(it) => explain::run(it).map(done),
            Self::Libraries(it) => libraries::run(it).map(done),
            Self::Design(it) => design::run(it).map(done),
            Self::Help(it) => help::run(it, Arguments::command()).map(done),
            Self::Completions(it) => completions::run(it, whole()).map(done),
            Self::Install(it) => install::run(it, &whole()).map(done),
        }
    }
}

/// Returns the complete parser, with all subcommands built.
pub(super) fn whole() -> Command {
    let mut program = Arguments::command();
    program.build();
    program
}
