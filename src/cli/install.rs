//! `cmra install`: manual pages and completion scripts in the folders that `man` and the shells search.

use std::path::{Path, PathBuf};

use clap::{Args, Command};
use clap_complete::Shell;

use crate::cli::{CliError, completions, output};
use crate::files::atomic::{self, OverwritePolicy};
use crate::files::paths;

#[derive(Debug, Args)]
pub(super) struct InstallArguments {
    /// Install below DIR/share for all users, for example /usr/local, instead of below the home directory
    #[arg(long, value_name = "DIR")]
    prefix: Option<PathBuf>,
}

/// Path of the completion script of each shell, below `share`.
const SCRIPTS: [(Shell, &str); 3] = [
    (Shell::Bash, "bash-completion/completions/cmra"),
    (Shell::Zsh, "zsh/site-functions/_cmra"),
    (Shell::Fish, "fish/vendor_completions.d/cmra.fish"),
];

pub(super) fn run(arguments: &InstallArguments, program: &Command) -> Result<(), CliError> {
    let share = match &arguments.prefix {
        Some(prefix) => prefix.join("share"),
        None => paths::share_of_user()?,
    };
    let pages = share.join("man/man1");
    let mut files = Vec::new();
    for command in std::iter::once(program).chain(program.get_subcommands()) {
        files.push(manual_page(command.clone(), &pages)?);
    }
    let page_count = files.len();
    for (shell, path) in SCRIPTS {
        files.push((share.join(path), completions::script(shell, program.clone())));
    }
    for (path, content) in &files {
        atomic::make_folder_of(path)?;
        atomic::write(path, content, OverwritePolicy::Replace)?;
    }
    output::print(&format!("manual pages  {} ({page_count})\n", pages.display()))?;
    for (shell, path) in SCRIPTS {
        output::print(&format!("{:12}  {}\n", shell.to_string(), share.join(path).display()))?;
    }
    let zsh = share.join("zsh/site-functions");
    output::note(&format!("zsh needs `fpath+=({})` before `compinit` in ~/.zshrc", zsh.display()));
    Ok(())
}

/// Returns path and text (roff) of the manual page of the program or of a command.
fn manual_page(command: Command, folder: &Path) -> Result<(PathBuf, Vec<u8>), CliError> {
    let title = command.get_display_name().unwrap_or("cmra").to_owned();
    let mut content = Vec::new();
    clap_mangen::Man::new(command)
        .title(title.clone())
        .render(&mut content)
        .map_err(CliError::Stdout)?;
    Ok((folder.join(format!("{title}.1")), content))
}
