//! Where a table of rows goes: to a file beside the page, to standard output instead of it, or as JSON.

use std::path::{Path, PathBuf};

use clap::Args;

use crate::cli::{CliError, output};
use crate::files::atomic::{self, Existing};
use crate::files::error::FileError;
use crate::files::rows::Rows;

/// `--json`, `--csv FILE`, `--force`.
#[derive(Debug, Args)]
pub(super) struct TableArguments {
    /// Print JSON: a list with one object a row
    #[arg(long)]
    json: bool,
    /// Write the rows to this file; `-` writes them to standard output instead of the page
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// Replace an existing file
    #[arg(long, requires = "csv")]
    force: bool,
}

impl TableArguments {
    /// Print the page or the rows, and write the file.
    pub(super) fn deliver(&self, page: &str, rows: &Rows) -> Result<(), CliError> {
        deliver(page, rows, (self.json, self.csv.as_deref(), self.force))
    }
}

/// As [`TableArguments::deliver`], with the three options by themselves.
pub(super) fn deliver(
    page: &str,
    rows: &Rows,
    (json, csv, force): (bool, Option<&Path>, bool),
) -> Result<(), CliError> {
    if csv == Some(Path::new("-")) {
        return output::print(&rows.csv()?);
    }
    if let Some(path) = csv {
        write(path, rows, force)?;
    }
    if json { output::print(&rows.json()) } else { output::print(page) }
}

/// The same for a report whose JSON object tells more than its rows: a file still holds the rows.
pub(super) fn deliver_report(
    page: impl FnOnce() -> String,
    object: impl FnOnce() -> String,
    rows: &Rows,
    (json, csv, force): (bool, Option<&Path>, bool),
) -> Result<(), CliError> {
    if !json {
        return deliver(&page(), rows, (false, csv, force));
    }
    if let Some(path) = csv.filter(|path| *path != Path::new("-")) {
        write(path, rows, force)?;
    }
    output::print(&object())
}

/// Write the rows to a file.
fn write(path: &Path, rows: &Rows, force: bool) -> Result<(), CliError> {
    write_text(path, &rows.csv()?, force)
}

/// Write a table that is a text already.
pub(super) fn write_text(path: &Path, text: &str, force: bool) -> Result<(), CliError> {
    let existing = if force { Existing::Replace } else { Existing::Keep };
    atomic::write(path, text.as_bytes(), existing).map_err(|error| match error {
        FileError::Exists(path) => CliError::Exists { path: path.display().to_string() },
        other => CliError::File(other),
    })?;
    output::note(&format!("wrote {}", path.display()));
    Ok(())
}
