//! `cmra presets [show NAME]`: bundled and own presets.

use std::fmt::Write as _;
use std::process::ExitCode;

use clap::{Args, Subcommand};

use crate::cli::{CliError, output, scene};
use crate::files::clean;
use crate::files::paths::Paths;
use crate::files::preset::{self, Origin, Preset};

#[derive(Debug, Args)]
pub(super) struct PresetsArguments {
    #[command(subcommand)]
    action: Option<Action>,
}

#[derive(Debug, Subcommand)]
enum Action {
    /// List the presets
    List,
    /// Print a preset's file: where its numbers come from, what to expect, and every value
    Show {
        /// The preset's name
        name: String,
    },
}

/// List the presets, or show one.
pub(super) fn run(arguments: &PresetsArguments) -> Result<ExitCode, CliError> {
    match &arguments.action {
        None | Some(Action::List) => list(),
        Some(Action::Show { name }) => output::print(&scene::named(name.as_ref())?.text),
    }?;
    Ok(ExitCode::SUCCESS)
}

fn list() -> Result<(), CliError> {
    let paths = Paths::of_user().ok();
    let (presets, problems) = preset::list(paths.as_ref());
    let (bundled, own): (Vec<&Preset>, Vec<&Preset>) =
        presets.iter().partition(|preset| preset.origin == Origin::Bundled);
    let width = presets.iter().map(|preset| preset.name.chars().count()).max().unwrap_or(0);
    let mut text = String::new();
    rows(&mut text, &bundled, width);
    if let (Some(paths), false) = (&paths, own.is_empty()) {
        let _ = writeln!(text, "\nyour own, in {}", paths.presets.display());
        rows(&mut text, &own, width);
    }
    output::print(&text)?;
    for problem in problems {
        output::note(&format!("not listed: {problem}"));
    }
    Ok(())
}

fn rows(text: &mut String, presets: &[&Preset], width: usize) {
    for preset in presets {
        let title = clean::line(&preset.scene.title);
        let row = format!("{:width$}  {title}", preset.name);
        let _ = writeln!(text, "{}", row.trim_end());
    }
}
