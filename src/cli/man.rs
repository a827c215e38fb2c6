//! `cmra man [SUBCOMMAND]`: the manual pages, made from the arguments themselves.

use clap::{Args, Command};

use crate::cli::{CliError, commands, output};
use crate::files::error::nearest;

#[derive(Debug, Args)]
pub(super) struct ManArguments {
    /// The page of a subcommand instead of the program's
    subcommand: Option<String>,
}

pub(super) fn run(arguments: &ManArguments) -> Result<(), CliError> {
    let mut command = commands::whole();
    if let Some(name) = &arguments.subcommand {
        let names: Vec<&str> = command.get_subcommands().map(Command::get_name).collect();
        let unknown =
            || format!("`{name}` is not a subcommand: {}", nearest(name, &names, "use one of"));
        let found = command.find_subcommand(name).cloned();
        command = found.ok_or_else(|| CliError::Option(unknown()))?;
    }
    output::print(&String::from_utf8_lossy(&page(command)?.content))
}

pub(super) struct Page {
    /// `cmra`, or `cmra-run` for a subcommand.
    pub(super) title: String,
    /// In roff.
    pub(super) content: Vec<u8>,
}

/// The page of the program, and one a subcommand.
pub(super) fn pages() -> Result<Vec<Page>, CliError> {
    let program = commands::whole();
    let subcommands = program.get_subcommands().cloned();
    std::iter::once(program.clone()).chain(subcommands).map(page).collect()
}

fn page(command: Command) -> Result<Page, CliError> {
    let title = command.get_display_name().unwrap_or("cmra").to_owned();
    let mut content = Vec::new();
    let man = clap_mangen::Man::new(command).title(title.clone());
    man.render(&mut content).map_err(CliError::Stdout)?;
    Ok(Page { title, content })
}
