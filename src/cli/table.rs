//! Output of tables (`--json`, `--csv`, `--force`): to a file in addition to the page, or to standard output instead of it.

use std::path::PathBuf;

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use serde_json::Value;

use crate::cli::progress::Extent;
use crate::cli::scene::SceneOverrides;
use crate::cli::{CliError, output, text};
use crate::files::atomic::OverwritePolicy;
use crate::files::error::FileError;
use crate::files::export::{Destination, Sidecar};
use crate::tui::plain::TextStyle;
use crate::tui::theme::Theme;
use cmra_engine::model::scene::Scene;
use cmra_studies::report::page::Page;
use cmra_studies::report::table::{Table, pretty};

/// Arguments of the output of a table: `--json`, `--csv FILE`, `--force`.
#[derive(Debug, Default, Args)]
#[command(group = clap::ArgGroup::new("files").multiple(true))]
pub(super) struct TableArguments {
    /// Print JSON instead of the page: SI units, null for a quantity that does not exist
    #[arg(long)]
    pub(super) json: bool,
    /// Write the table to this file; `-` writes it to standard output instead of the page
    #[arg(long, value_name = "FILE", group = "files")]
    csv: Option<PathBuf>,
    /// Replace an existing file
    #[arg(long, requires = "files")]
    force: bool,
    /// Print warnings in full instead of a line each on a terminal
    #[arg(long)]
    verbose: bool,
}

/// Returns a parser of choices by their words; `--help` describes each choice.
pub(super) fn choice<T: Copy + Send + Sync + 'static>(
    all: &'static [T],
    word: fn(T) -> &'static str,
    about: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    let values = all.iter().map(move |it| PossibleValue::new(word(*it)).help(about(*it)));
    let named = move |text: String| all.iter().copied().find(|it| word(*it) == text);
    PossibleValuesParser::new(values)
        .try_map(move |text| named(text).ok_or("not one of the choices"))
}

impl TableArguments {
    /// Returns `true` if a table is requested.
    pub(super) fn is_wanted(&self) -> bool {
        self.csv.is_some()
    }

    /// Returns `true` if the table goes to standard output, instead of the page.
    pub(super) fn is_stdout(&self) -> bool {
        self.csv.as_deref().is_some_and(output::is_stdout)
    }

    /// Returns the destination of the table.
    pub(super) fn file(&self) -> Option<Destination> {
        let path = self.csv.clone().filter(|_| !self.is_stdout())?;
        Some(Destination { path, existing: self.existing() })
    }

    /// Returns the layout of the page; warnings are short on a terminal unless `--verbose` is given.
    pub(super) fn style(&self) -> TextStyle {
        // The reader of a pipe cannot repeat the command: the full text.
        let is_brief = !self.verbose && text::is_screen();
        TextStyle { width: text::width(), theme: Theme::PLAIN, is_brief }
    }

    /// Returns the policy for an existing file.
    pub(super) fn existing(&self) -> OverwritePolicy {
        OverwritePolicy::replaced(self.force)
    }

    /// Checks, before a long computation, that the table and the scene file beside it can be written.
    pub(super) fn check(&self, has_scene: bool) -> Result<(), CliError> {
        self.check_stdout()?;
        Ok(self.file().map_or(Ok(()), |to| to.check(has_scene))?)
    }

    /// Checks that at most one kind of result goes to standard output.
    pub(super) fn check_stdout(&self) -> Result<(), CliError> {
        if self.json && self.is_stdout() {
            return Err(CliError::Option(
                "--json and --csv - both write to standard output: omit one of them, or name a file for --csv".to_owned(),
            ));
        }
        Ok(())
    }

    /// Prints the page, the table or the JSON object, and writes the file. For a table computed from a scene the changes head the page, and
    /// a scene file is written beside the table.
    pub(super) fn deliver<R>(
        &self,
        extent: Extent,
        source: Option<Source<'_>>,
        page: &Page,
        object: Option<Value>,
        rows: Table<'_, R>,
    ) -> Result<(), CliError> {
        let rows = rows.with_reach(extent.reach);
        if self.is_stdout() {
            return output::print(&rows.csv());
        }
        let changed = source.as_ref().map(|source| source.0.changed());
        let written = self.file().map_or(Ok(()), |to| write(&to, &rows.csv(), source, extent));
        // The result is printed before the file, which may fail to be written.
        output::print(&match object {
            _ if !self.json => {
                let missing = extent.missing().map(|missing| missing + "\n\n");
                let head = missing.unwrap_or_default() + &changed.unwrap_or_default();
                head + &text::plain(page, self.style())
            }
            Some(mut object) => {
                object["complete"] = extent.reach.is_complete().into();
                pretty(&object)
            }
            None => rows.json(),
        })?;
        Ok(written?)
    }
}

/// Changes of the scene, the scene, and the command that computes the table: its name and options.
pub(super) type Source<'a> = (&'a SceneOverrides, &'a Scene, String);

fn write(
    to: &Destination,
    text: &str,
    source: Option<Source<'_>>,
    extent: Extent,
) -> Result<(), FileError> {
    let notes = extent.missing().map_or_else(String::new, |missing| format!("# {missing}\n"));
    let is_complete = extent.reach.is_complete();
    let beside = source.map(|(_, scene, command)| Sidecar { run: None, scene, notes, command });
    output::note_written(&to.write(text.as_bytes(), beside.as_slice(), is_complete)?);
    Ok(())
}
