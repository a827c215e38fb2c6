//! The commands of the program, a row each: what it is for, its name, what it does, and the function that carries it out.

use std::process::{ExitCode, Termination as _};

use clap::{ArgMatches, Args, Command, CommandFactory as _};

use crate::cli::{self, Arguments, CliError};

pub(super) struct Row {
    /// The heading of its group in `cmra --help`.
    pub(super) group: &'static str,
    pub(super) name: &'static str,
    pub(super) about: &'static str,
    /// An old name that still works.
    old_name: Option<&'static str>,
    /// Another spelling, which `--help` names.
    spelling: Option<&'static str>,
    /// Adds its arguments, which is put off until they are needed.
    arguments: fn(Command) -> Command,
    /// Reads them and carries it out.
    run: fn(&ArgMatches) -> Result<ExitCode, CliError>,
}

macro_rules! commands {
    ($($group:literal $name:literal $(old $old:literal)? $(or $or:literal)? $about:literal $module:ident;)*) => {
        /// Every command, in the order of `cmra --help`.
        pub(super) const COMMANDS: &[Row] = &[$(Row {
            group: $group,
            name: $name,
            about: $about,
            old_name: [$($old,)?].first().copied(),
            spelling: [$($or,)?].first().copied(),
            // The descriptions of shared arguments would replace its own.
            arguments: |command| augmented(command, cli::$module::run).about($about).long_about(None::<&str>),
            // Nothing to say of the end is success.
            run: |matches| cli::$module::run(&read(matches)?).map(|end| end.report()),
        }),*];
    };
}

commands! {
    "Run and explore" "run" "Run one scene and print what happened" run;
    "Run and explore" "sweep" "Run a scene at every point of one or more axes" sweep;
    "Decide" "limit" "Find the ballistic limit and the residual velocity beyond it" limit;
    "Decide" "compare" old "worth" "Compare with a solid plate of the same areal mass; draw a map" compare;
    "Decide" "seek" "Find the values of a variable that reach a goal" seek;
    "Decide" "optimise" or "optimize" "Find the best design under constraints, or a Pareto front" optimise;
    "Decide" "sensitivity" "Find which variables matter most" sensitivity;
    "Decide" "montecarlo" old "scatter" "Show how results spread when inputs do" monte_carlo;
    "Decide" "report" "Write one file with scene, results, charts and warnings" report;
    "Check" "accuracy" "Compare the error and the run time of every method" accuracy;
    "Check" "stability" "Check stiff and extreme scenes; map where a fixed step is stable" stability;
    "Check" "reproduce" "Compute again what the thesis prints" reproduce;
    "Check" "validate" "Compare the model with measurements from the literature" validate;
    "Data" "presets" "List the presets and where your own lie, or show one" presets;
    "Data" "explain" "Explain a variable or a quantity, or list all of them" explain;
    "Data" "libraries" "List threats, materials and absorbers with their sources" libraries;
    "Data" "design" "Print a shot's formulas: ricochet, collisions, mass of a spring" design;
    "Data" "help" "Explain a topic (scenes, csv, equations, ...) or a command" help;
    "Data" "completions" "Print a completion script for a shell" completions;
    "Data" "install" "Install manual pages and shell completions" install;
}

/// A command with the arguments that its function takes.
fn augmented<A: Args, T>(command: Command, _: fn(&A) -> T) -> Command {
    A::augment_args(command)
}

/// The arguments as written; the parser has checked them.
pub(super) fn read<A: Args>(matches: &ArgMatches) -> Result<A, CliError> {
    A::from_arg_matches(matches).map_err(|error| CliError::Option(error.to_string()))
}

/// The whole command line. The arguments of a command are added when it is named, or by `build`.
pub(super) fn program() -> Command {
    let command = |row: &Row| {
        let command = Command::new(row.name).about(row.about).defer(row.arguments);
        command.aliases(row.old_name).visible_aliases(row.spelling)
    };
    Arguments::command().subcommands(COMMANDS.iter().map(command))
}

/// The whole command line with the arguments of every command, for those that look them up.
pub(super) fn whole() -> Command {
    let mut program = program();
    program.build();
    program
}

/// Carry out the command that was named; nothing if none was.
pub(super) fn carry_out(matches: &ArgMatches) -> Option<Result<ExitCode, CliError>> {
    let (name, matches) = matches.subcommand()?;
    let row = COMMANDS.iter().find(|row| row.name == name)?;
    Some((row.run)(matches))
}

pub(super) fn names() -> Vec<&'static str> {
    COMMANDS.iter().map(|row| row.name).collect()
}
