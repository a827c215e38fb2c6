//! `cmra install`: manual pages and completion scripts, where `man` and the shells look for them.

use std::path::PathBuf;

use clap::Args;
use clap_complete::Shell;

use crate::cli::{CliError, completions, man, output};
use crate::files::atomic::{self, Existing};
use crate::files::paths;

#[derive(Debug, Args)]
pub(super) struct InstallArguments {
    /// Install below DIR/share for all users, for example /usr/local, instead of below the home directory
    #[arg(long, value_name = "DIR")]
    prefix: Option<PathBuf>,
}

/// Where each shell looks below `share`.
const SCRIPTS: [(Shell, &str); 3] = [
    (Shell::Bash, "bash-completion/completions/cmra"),
    (Shell::Zsh, "zsh/site-functions/_cmra"),
    (Shell::Fish, "fish/vendor_completions.d/cmra.fish"),
];

pub(super) fn run(arguments: &InstallArguments) -> Result<(), CliError> {
    let share = match &arguments.prefix {
        Some(prefix) => prefix.join("share"),
        None => paths::share_of_user()?,
    };
    let pages = share.join("man/man1");
    let mut files = Vec::new();
    for page in man::pages()? {
        files.push((pages.join(format!("{}.1", page.title)), page.content));
    }
    let page_count = files.len();
    for (shell, path) in SCRIPTS {
        files.push((share.join(path), completions::script(shell)));
    }
    for (path, content) in &files {
        atomic::make_folder_of(path)?;
        atomic::write(path, content, Existing::Replace)?;
    }
    output::print(&format!("manual pages  {} ({page_count})\n", pages.display()))?;
    for (shell, path) in SCRIPTS {
        output::print(&format!("{:12}  {}\n", shell.to_string(), share.join(path).display()))?;
    }
    let zsh = share.join("zsh/site-functions");
    output::note(&format!("zsh needs `fpath+=({})` before `compinit` in ~/.zshrc", zsh.display()));
    Ok(())
}
