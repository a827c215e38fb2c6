//! `cmra completions SHELL`: a completion script, made from the arguments themselves, with the names of presets, variables and
//! quantities.

use clap::builder::PossibleValuesParser;
use clap::{Arg, Args, Command};
use clap_complete::Shell;

use crate::cli::{CliError, help, output};
use crate::files::library;
use crate::files::paths::Paths;
use crate::files::preset;
use crate::model::library::Library;
use crate::model::variables::VARIABLES;
use crate::study::quantities::QUANTITIES;

#[derive(Debug, Args)]
pub(super) struct CompletionsArguments {
    /// The shell
    shell: Shell,
}

pub(super) fn run(arguments: &CompletionsArguments, program: Command) -> Result<(), CliError> {
    output::print(&String::from_utf8_lossy(&script(arguments.shell, program)))
}

pub(super) fn script(shell: Shell, program: Command) -> Vec<u8> {
    let mut script = Vec::new();
    let topics: Vec<String> = help::names(&program).into_iter().map(str::to_owned).collect();
    clap_complete::generate(shell, &mut named(program, &topics), "cmra", &mut script);
    script
}

/// The commands with the words that each of their arguments may begin with. Only for completion: they accept more.
fn named(command: Command, topics: &[String]) -> Command {
    let owner = command.get_name().to_owned();
    let command = command.mut_args(|argument| with_names(&owner, argument, topics));
    command.mut_subcommands(|command| named(command, topics))
}

fn with_names(owner: &str, argument: Arg, topics: &[String]) -> Arg {
    let symbols = |end: &str| -> Vec<String> {
        VARIABLES.iter().map(|variable| format!("{}{end}", variable.symbol)).collect()
    };
    let quantities = |end: &str| -> Vec<String> {
        QUANTITIES.iter().map(|quantity| format!("{}{end}", quantity.name)).collect()
    };
    let words = match argument.get_id().as_str() {
        "scene" | "scenes" => presets(),
        "set" | "over" | "vary" => symbols("="),
        "map" => symbols(","),
        "outputs" | "output" | "minimise" | "maximise" => quantities(""),
        "goal" => quantities("="),
        "subject_to" => quantities("<="),
        "name" if owner == "show" => presets(),
        "name" if owner == "explain" => [symbols(""), quantities("")].concat(),
        "topic" => topics.to_vec(),
        "threat" => entries(Library::Threats),
        "material" => entries(Library::Materials),
        "absorber" => entries(Library::Absorbers),
        _ => return argument,
    };
    argument.value_parser(PossibleValuesParser::new(words))
}

fn presets() -> Vec<String> {
    let found = preset::list(Paths::of_user().ok().as_ref());
    found.presets.into_iter().map(|preset| preset.name).collect()
}

fn entries(wanted: Library) -> Vec<String> {
    let (found, _) = library::list(Paths::of_user().ok().as_ref());
    let found = found.into_iter().filter(|entry| entry.library == wanted);
    found.map(|entry| entry.name).collect()
}
