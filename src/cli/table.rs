//! Where a table of rows goes: to a file beside the page, to standard output instead of it, or as JSON. The one declaration of
//! `--json`, `--csv` and `--force`.

use std::path::{Path, PathBuf};

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use serde_json::Value;

use crate::cli::progress::Extent;
use crate::cli::scene::SceneOverrides;
use crate::cli::{CliError, output, text};
use crate::files::atomic::OverwritePolicy;
use crate::files::error::FileError;
use crate::files::export::{Destination, Sidecar};
use crate::tui::widgets::text::wrap;
use cmra_engine::model::run::envelope::OUTSIDE;
use cmra_engine::model::scene::Scene;
use cmra_studies::report::table::{Table, pretty};

/// `--json`, `--csv FILE`, `--force`.
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

/// Reads one of these choices by its word; `--help` says what each is.
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
    /// Whether a table is wanted.
    pub(super) fn is_wanted(&self) -> bool {
        self.csv.is_some()
    }

    /// Whether it replaces the page on standard output.
    pub(super) fn is_stdout(&self) -> bool {
        self.csv.as_deref() == Some(Path::new("-"))
    }

    /// The file that it goes to.
    pub(super) fn file(&self) -> Option<Destination> {
        let path = self.csv.clone().filter(|_| !self.is_stdout())?;
        Some(Destination { path, existing: self.existing() })
    }

    /// Warnings below a result, a line each.
    pub(super) fn warnings(&self, warnings: &[String]) -> String {
        if warnings.is_empty() {
            return String::new();
        }
        let room = text::width() - 4;
        // What reads a pipe cannot ask for more.
        let is_full = self.verbose || !text::is_screen();
        let line = |warning: &String| {
            if is_full { wrap(warning, room).join("\n    ") } else { brief(warning) }
        };
        let lines = warnings.iter().map(|warning| format!("  ! {}\n", line(warning)));
        let how = if is_full {
            ""
        } else {
            " (`cmra explain NAME` explains one; --verbose prints them in full)"
        };
        format!("\nwarnings{how}\n{}", lines.collect::<String>())
    }

    /// The handling of an existing file.
    pub(super) fn existing(&self) -> OverwritePolicy {
        OverwritePolicy::replaced(self.force)
    }

    /// Whether the table, and its scene where one goes beside it, can be written where they are to go: checked before a long
    /// computation, not after it.
    pub(super) fn check(&self, has_scene: bool) -> Result<(), CliError> {
        self.check_stdout()?;
        Ok(self.file().map_or(Ok(()), |to| to.check(has_scene))?)
    }

    /// Checks that only one kind of result goes to standard output.
    pub(super) fn check_stdout(&self) -> Result<(), CliError> {
        if self.json && self.is_stdout() {
            return Err(CliError::Option(
                "--json and --csv - both write to standard output: omit one of them, or name a file for --csv".to_owned(),
            ));
        }
        Ok(())
    }

    /// Print the page or the rows, or the JSON object where that has more than its rows, and write the file. Of a table that is made
    /// from a scene the changes head the page, and the scene goes beside the file.
    pub(super) fn deliver<R>(
        &self,
        extent: Extent,
        source: Option<Source<'_>>,
        page: &str,
        object: Option<Value>,
        rows: Table<'_, R>,
    ) -> Result<(), CliError> {
        let rows = rows.with_reach(extent.reach);
        if self.is_stdout() {
            return output::print(&rows.csv());
        }
        let changed = source.as_ref().map(|source| source.0.changed());
        let written = self.file().map_or(Ok(()), |to| write(&to, &rows.csv(), source, extent));
        // A file that cannot be written must not cost what was computed.
        output::print(&match object {
            _ if !self.json => {
                let missing = extent.missing().map(|missing| missing + "\n\n");
                text::fitted(&(missing.unwrap_or_default() + &changed.unwrap_or_default() + page))
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

/// The changes that made a scene, the scene, and the command that makes the table of it: its name and options.
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

/// A warning in brief: of a breach of validity the first clause, which has its name and number, or the first two where the first has
/// no number, and on which side the answer errs; of any other the clauses that fit in a line, or all of it. A clause is never cut: the
/// page wraps it.
fn brief(warning: &str) -> String {
    let room = text::width() - 4;
    let Some((lead, text)) = warning.split_once(OUTSIDE) else {
        let fits = |clause: &&str| clause.chars().count() <= room;
        return clauses(warning).filter(fits).last().unwrap_or(warning).to_owned();
    };
    let (text, direction) = text.rsplit_once(" (").unwrap_or((text, ""));
    let has_number = |clause: &&str| clause.contains(|c: char| c.is_ascii_digit());
    let clause = clauses(text).find(has_number).or_else(|| clauses(text).next()).unwrap_or(text);
    format!("{lead}{clause} ({direction}")
}

/// A text up to each end of a clause, and the whole.
fn clauses(text: &str) -> impl Iterator<Item = &str> {
    let ends = text.match_indices([':', ';']).map(|(at, _)| at);
    ends.chain([text.len()]).map(|end| &text[..end])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_warning_is_a_line_with_its_number_and_direction() {
        for (warning, line) in [
            (
                "outside validity: h/D = 2: with dishing the law is validated up to about 1; set dishing=off (conservative)",
                "h/D = 2 (conservative)",
            ),
            (
                "at k = 7.5e6: outside validity: spring end moves at 36.8 m/s: a coil surges (unconservative)",
                "at k = 7.5e6: spring end moves at 36.8 m/s (unconservative)",
            ),
            (
                "outside validity: nose = blunt: about 60 % too high (unconservative)",
                "nose = blunt: about 60 % too high (unconservative)",
            ),
            (
                "the horizon of 1 ms was not reached: the run stopped",
                "the horizon of 1 ms was not reached: the run stopped",
            ),
            (
                "equal velocities at 92 us, before t_d = 185 us: the half-sine history is that of a fixed plate",
                "equal velocities at 92 us, before t_d = 185 us",
            ),
            (
                "outside validity: rigid stop asks the fused interface for an unbounded force: set it (unconservative)",
                "rigid stop asks the fused interface for an unbounded force (unconservative)",
            ),
        ] {
            assert_eq!(brief(warning), line);
        }
        // A clause longer than a line stays whole.
        let long = "word ".repeat(40);
        assert_eq!(brief(long.trim_end()), long.trim_end());
        let breach = format!("outside validity: {long}is 8.457: explained (unconservative)");
        assert_eq!(brief(&breach), format!("{long}is 8.457 (unconservative)"));
    }
}
