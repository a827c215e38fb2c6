//! `cmra presets [show NAME]`: presets, bundled or the user's own.

use std::fmt::Write as _;

use clap::{Args, Subcommand};

use crate::cli::{CliError, output, scene};
use crate::files::paths::Paths;
use crate::files::preset::{self, Origin, Preset};
use crate::files::{clean, write};

#[derive(Debug, Args)]
pub(super) struct PresetsArguments {
    #[command(subcommand)]
    action: Option<Action>,
}

#[derive(Debug, Subcommand)]
enum Action {
    /// Print a preset's file: where its numbers come from, what to expect, and every value
    Show {
        /// The preset's name
        name: String,
    },
}

pub(super) fn run(arguments: &PresetsArguments) -> Result<(), CliError> {
    match &arguments.action {
        None => list(),
        Some(Action::Show { name }) => output::print(&whole(&scene::named(name.as_ref())?)),
    }
}

/// Returns the file of a preset with every value. A user's own file may contain only values that differ from the baseline.
fn whole(preset: &Preset) -> String {
    if preset.origin == Origin::Bundled {
        return preset.text.clone();
    }
    let fresh = write::fresh(&preset.scene);
    match preset.comment.trim_end() {
        "" => fresh,
        comment => format!("# {}\n{fresh}", comment.replace('\n', "\n# ")),
    }
}

fn list() -> Result<(), CliError> {
    let paths = Paths::of_user().ok();
    let (presets, unreadable) = preset::list(paths.as_ref());
    let width = presets.iter().map(|preset| preset.name.chars().count()).max().unwrap_or(0);
    let (bundled, own): (Vec<_>, Vec<_>) =
        presets.iter().partition(|preset| preset.origin == Origin::Bundled);
    let row = |preset: &&Preset| {
        let title = clean::line(&preset.scene.title);
        format!("{:width$}  {title}", preset.name).trim_end().to_owned() + "\n"
    };
    let mut text: String = bundled.iter().map(row).collect();
    if let Some(paths) = &paths {
        let none = if own.is_empty() { " (none yet)" } else { "" };
        let _ = writeln!(text, "\nyour own, in {}{none}", paths.presets.display());
        text.extend(own.iter().map(row));
    }
    output::print(&text)?;
    for (_, error) in unreadable {
        output::note(&format!("not listed: {error}"));
    }
    Ok(())
}
