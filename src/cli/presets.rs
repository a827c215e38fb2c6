//! `cmra presets [show NAME]`: bundled and own presets, as a page, CSV or JSON.

use std::fmt::Write as _;

use clap::{Args, Subcommand};

use crate::cli::table::{TableArguments, TableDestination};
use crate::cli::{CliError, output, scene};
use crate::files::paths::Paths;
use crate::files::preset::{self, Origin, Preset};
use crate::files::{clean, write};
use crate::report::table::Table;

#[derive(Debug, Args)]
pub(super) struct PresetsArguments {
    #[command(subcommand)]
    action: Option<Action>,
    #[command(flatten)]
    table: TableArguments,
}

#[derive(Debug, Subcommand)]
enum Action {
    /// List the presets
    List {
        #[command(flatten)]
        table: TableArguments,
    },
    /// Print a preset's file: where its numbers come from, what to expect, and every value
    Show {
        /// The preset's name
        name: String,
    },
}

pub(super) fn run(arguments: &PresetsArguments) -> Result<(), CliError> {
    match &arguments.action {
        Some(Action::List { table }) if table.is_given() => list(table),
        None | Some(Action::List { .. }) => list(&arguments.table),
        Some(Action::Show { .. })
            if arguments.table.json
                || !matches!(arguments.table.target(), TableDestination::None) =>
        {
            let text = "presets show prints the preset's file: --json and --csv are for the list";
            Err(CliError::Option(text.to_owned()))
        }
        Some(Action::Show { name }) => output::print(&whole(&scene::named(name.as_ref())?)),
    }
}

/// A preset's file with every value; one's own file may have only those that differ from the baseline.
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

fn list(table: &TableArguments) -> Result<(), CliError> {
    table.check()?;
    let paths = Paths::of_user().ok();
    let preset::List { presets, unreadable } = preset::list(paths.as_ref());
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
    table.alone().deliver(&text, table_of(&presets))?;
    for one in unreadable {
        output::note(&format!("not listed: {}", one.error));
    }
    Ok(())
}

/// One row a preset.
fn table_of(presets: &[Preset]) -> Table<'_, &Preset> {
    Table::of(presets)
        .with("name", "name", "", |it| it.name.as_str())
        .with("title", "title", "", |it| it.scene.title.as_str())
        .with("notes", "notes", "", |it| it.scene.notes.as_str())
        .with("bundled", "bundled", "", |it| it.origin == Origin::Bundled)
        .with("file", "file", "", |it| match &it.origin {
            Origin::Mine(path) | Origin::File(path) => Some(path.display().to_string()),
            Origin::Bundled | Origin::Text => None,
        })
}
