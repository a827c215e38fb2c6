//! `cmra paths`: where this program keeps its files.

use crate::cli::commands::NoArguments;
use crate::cli::{CliError, output};
use crate::files::paths::Paths;

pub(super) fn run(_: &NoArguments) -> Result<(), CliError> {
    let paths = Paths::of_user()?;
    output::print(&format!(
        "config    {}\npresets   {}\nsession   {}\nprevious  {}\nlog       {}\n",
        paths.config.display(),
        paths.presets.display(),
        paths.session_file().display(),
        paths.previous_session_file().display(),
        paths.log_file().display()
    ))
}
