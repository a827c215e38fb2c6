//! `--svg FILE`: charts of a study as a file.

use std::path::PathBuf;

use clap::Args;

use crate::cli::table::TableArguments;
use crate::cli::{CliError, output};
use crate::files::{atomic, export};
use cmra_studies::report::svg::{self, Picture, Svg};
use cmra_studies::study::context::Reach;

/// Arguments of the charts: `--svg FILE`.
#[derive(Debug, Args)]
pub(super) struct ChartArguments {
    /// Write the charts to this file as SVG; `-` writes them to standard output instead of the page
    #[arg(long, value_name = "FILE", group = "files")]
    svg: Option<PathBuf>,
}

impl ChartArguments {
    pub(super) fn is_wanted(&self) -> bool {
        self.svg.is_some()
    }

    /// Returns `true` if the charts go to standard output, instead of the page.
    pub(super) fn is_stdout(&self) -> bool {
        self.svg.as_deref().is_some_and(output::is_stdout)
    }

    /// Checks, before a long computation, that the charts can be written.
    pub(super) fn check(&self, table: &TableArguments) -> Result<(), CliError> {
        if self.is_stdout() && (table.json || table.is_stdout()) {
            return Err(CliError::Option(
                "--svg - writes to standard output, as --json and --csv - do: name a file for one of them".to_owned(),
            ));
        }
        if let (Some(path), Some(to)) = (&self.svg, table.file())
            && to.has(path)
        {
            let path = path.display();
            return Err(CliError::Option(format!(
                "--svg {path}: --csv writes to the same file, or its scene; choose another name"
            )));
        }
        if let Some(path) = self.svg.as_ref().filter(|_| !self.is_stdout()) {
            export::check(path, "svg", table.existing())?;
        }
        Ok(())
    }

    /// Writes the charts; an interrupted study has none.
    pub(super) fn write(
        &self,
        table: &TableArguments,
        reach: Reach,
        pictures: impl FnOnce() -> Vec<Picture>,
    ) -> Result<(), CliError> {
        let Some(path) = &self.svg else { return Ok(()) };
        if !reach.is_complete() {
            output::note("interrupted: no picture was written");
            return Ok(());
        }
        let pictures = pictures();
        if pictures.is_empty() {
            output::note("there is nothing to draw: no picture was written");
            return Ok(());
        }
        let drawn: Vec<String> = pictures.iter().map(Svg::svg).collect();
        let text = svg::file(&drawn);
        if self.is_stdout() {
            return output::print(&text);
        }
        atomic::write(path, text.as_bytes(), table.existing())?;
        output::note_written(std::slice::from_ref(path));
        Ok(())
    }
}
