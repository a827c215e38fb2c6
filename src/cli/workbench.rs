//! `cmra [SCENE]`: the workbench, or a page of text without a terminal.

use std::ffi::{OsStr, OsString};
use std::io::{self, IsTerminal as _};
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;

use clap::{Args, Command};

use crate::cli::run::{compute, print_readable};
use crate::cli::table::TableArguments;
use crate::cli::{CliError, Glyphs, commands, output, scene};
use crate::files::bundled;
use crate::files::error::{FileError, did_you_mean_the};
use crate::files::preset::Preset;
use crate::files::read_traces::traces;
use crate::tui;
use cmra_studies::report::traces::Traces;

#[derive(Debug, Args)]
pub(super) struct WorkbenchArguments {
    /// A preset's name or the path of a TOML file; without one the last session is restored
    scene: Option<OsString>,
    /// Compare with measured traces or another program's histories: see `cmra run --help`
    #[arg(long, value_name = "FILE.csv")]
    with: Option<PathBuf>,
    /// Start on the baseline instead of the last session
    #[arg(long, conflicts_with = "scene")]
    fresh: bool,
    /// Choose the characters of the charts
    #[arg(long, value_enum, default_value = "auto", value_name = "GLYPHS")]
    glyphs: Glyphs,
}

/// Opens the workbench; without a terminal prints the page of `cmra run --plain`.
pub(super) fn run(arguments: &WorkbenchArguments) -> Result<ExitCode, CliError> {
    let preset = arguments.scene.as_deref().map(scene_or_command).transpose()?;
    let with = arguments.with.as_deref().map(traces).transpose()?;
    // Standard input and output have to be terminals with cursor movement.
    let is_dumb = std::env::var_os("TERM").is_some_and(|term| term == "dumb");
    if is_dumb || !io::stdin().is_terminal() || !io::stdout().is_terminal() {
        return print_plain(preset, with.as_ref(), arguments.glyphs);
    }
    let status = tui::run(tui::Options {
        scene: preset,
        with,
        fresh: arguments.fresh,
        glyphs: arguments.glyphs.chosen(),
    })
    .map_err(CliError::Workbench)?;
    Ok(ExitCode::from(status))
}

/// Loads the scene. A misspelt subcommand is parsed as a scene, and reported here.
fn scene_or_command(name: &OsStr) -> Result<Preset, CliError> {
    scene::named(name).map_err(|error| {
        let commands = commands::whole();
        let names: Vec<&str> = commands.get_subcommands().map(Command::get_name).collect();
        match (error, did_you_mean_the("the subcommand ", &name.to_string_lossy(), &names)) {
            (CliError::File(FileError::UnknownScene { name, .. }), Some(hint)) => {
                CliError::File(FileError::UnknownScene { name, hint })
            }
            (error, _) => error,
        }
    })
}

fn print_plain(
    preset: Option<Preset>,
    with: Option<&Traces>,
    glyphs: Glyphs,
) -> Result<ExitCode, CliError> {
    let preset = preset.map_or_else(|| scene::named(bundled::BASELINE.as_ref()), Ok)?;
    output::note(
        "the workbench needs a terminal; without one, this is what `cmra run --plain` prints",
    );
    let run = compute(&Arc::new(preset.scene))?;
    print_readable((&preset.name, &run, with), Some(glyphs), &TableArguments::default())?;
    Ok(ExitCode::SUCCESS)
}
