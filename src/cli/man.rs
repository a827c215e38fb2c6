//! `cmra man [SUBCOMMAND]`: the manual pages, made from the arguments themselves.

use std::process::ExitCode;

use clap::{Args, CommandFactory as _};

use crate::cli::{Arguments, CliError, output};
use crate::files::error::did_you_mean;

#[derive(Debug, Args)]
pub(super) struct ManArguments {
    /// The page of a subcommand instead of the program's
    subcommand: Option<String>,
}

/// Print a page.
pub(super) fn run(arguments: &ManArguments) -> Result<ExitCode, CliError> {
    let mut command = Arguments::command();
    command.build();
    if let Some(name) = &arguments.subcommand {
        let found = command.find_subcommand(name).cloned();
        let known = || {
            let names: Vec<&str> = command.get_subcommands().map(clap::Command::get_name).collect();
            did_you_mean(name, &names).unwrap_or_else(|| format!("use one of {}", names.join(", ")))
        };
        let page =
            found.ok_or_else(|| CliError::Subcommand { name: name.clone(), known: known() })?;
        command = page;
    }
    let mut page = Vec::new();
    let title = command.get_display_name().unwrap_or("cmra").to_owned();
    clap_mangen::Man::new(command).title(title).render(&mut page).map_err(CliError::Stdout)?;
    output::print(&String::from_utf8_lossy(&page))?;
    Ok(ExitCode::SUCCESS)
}
