//! `cmra completions SHELL`: a completion script, generated from the parser.

use clap::{Args, Command};
use clap_complete::Shell;

use crate::cli::{CliError, output};

#[derive(Debug, Args)]
pub(super) struct CompletionsArguments {
    /// The shell
    shell: Shell,
}

pub(super) fn run(arguments: &CompletionsArguments, program: Command) -> Result<(), CliError> {
    output::print(&String::from_utf8_lossy(&script(arguments.shell, program)))
}

pub(super) fn script(shell: Shell, mut program: Command) -> Vec<u8> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut program, "cmra", &mut script);
    script
}
