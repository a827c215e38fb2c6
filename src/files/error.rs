//! Errors of files, with their remedies, independent of the format.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

use thiserror::Error;

use crate::files::clean;
use cmra_engine::model::variables;

/// Error of reading, writing or finding a file.
#[derive(Debug, Error)]
pub enum FileError {
    /// The file cannot be read.
    #[error("cannot read `{}`: {}", shown(.path), reason(.source))]
    Read {
        /// The file.
        path: PathBuf,
        /// The error of the system.
        source: io::Error,
    },
    /// The file cannot be written.
    #[error("cannot write `{}`: {}", shown(.path), reason(.source))]
    Write {
        /// The file.
        path: PathBuf,
        /// The error of the system.
        source: io::Error,
    },
    /// The file, its name or its folder cannot be used; the text has the reason and the remedy.
    #[error("{0}")]
    Refused(String),
    /// The file is not a scene.
    #[error("{0}")]
    Scene(SceneErrors),
    /// Neither a preset nor a file.
    #[error("`{}` is neither a preset nor a file: {hint}", clean::line(.name))]
    UnknownScene {
        /// Name as given.
        name: String,
        /// Closest names, or the expected form.
        hint: String,
    },
    /// The file exists and was not replaced.
    #[error("`{}` already exists: choose another name, or allow it to be replaced", shown(.0))]
    Exists(PathBuf),
    /// The file could not be completed; the finished part is in another file.
    #[error("{problem}; what was computed is kept in `{}`", shown(.path))]
    Kept {
        /// File with the finished part.
        path: PathBuf,
        /// Error that prevented the completion.
        problem: Box<Self>,
    },
    /// The preset to replace is not a readable scene; its content would be lost.
    #[error("`{}` is not a readable scene and was not replaced: correct it, remove it, or save under another name\n{problem}", shown(.path))]
    Unmendable {
        /// The file.
        path: PathBuf,
        /// The error.
        problem: SceneErrors,
    },
    /// No home directory is known.
    #[error("no home directory is known: set HOME, or XDG_DATA_HOME and XDG_STATE_HOME")]
    NoHome,
}

impl FileError {
    /// Creates the error of reading a file.
    pub fn read(path: &Path, source: io::Error) -> Self {
        Self::Read { path: path.to_owned(), source }
    }

    /// Creates the error of writing a file.
    pub fn write(path: &Path, source: io::Error) -> Self {
        Self::Write { path: path.to_owned(), source }
    }

    /// Creates the error of a device or a pipe in place of a regular file.
    pub(super) fn special(path: &Path) -> Self {
        Self::Refused(format!(
            "`{}` is a device or a pipe, for which there would be no end of waiting: name an ordinary file",
            shown(path)
        ))
    }

    /// Creates the error of an invalid name of a preset or an entry.
    pub(super) fn name(name: &str, problem: &str) -> Self {
        Self::Refused(format!("`{}` cannot be the name: {problem}", clean::line(name)))
    }

    /// Creates the error of an invalid target.
    pub(super) fn target(path: &Path, problem: &str) -> Self {
        Self::Refused(format!("`{}` cannot be the target: {problem}", shown(path)))
    }
}

/// Formats a path for one line; control characters are replaced.
pub(super) fn shown(path: &Path) -> String {
    clean::line(&path.to_string_lossy()).into_owned()
}

/// Returns the error text of the system, in lower case and without its number.
fn reason(error: &io::Error) -> String {
    let text = error.to_string();
    let text = text.split(" (os error").next().unwrap_or(&text);
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_lowercase().collect::<String>() + letters.as_str()
    })
}

/// Problems of a scene file in the order of its lines; never empty.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SceneErrors {
    /// Name of the file as given by the user.
    pub file: String,
    /// The error.
    pub problems: Vec<Problem>,
    /// Whether there are more problems than listed.
    pub more: bool,
}

/// Problem in a scene file.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Problem {
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// Key, value, allowed values and remedy.
    pub text: String,
}

impl fmt::Display for SceneErrors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let file = clean::line(&self.file);
        for (index, problem) in self.problems.iter().enumerate() {
            if index > 0 {
                f.write_str("\n")?;
            }
            let Problem { line, column, text } = problem;
            write!(f, "{file}:{line}:{column}: {text}")?;
        }
        if self.more {
            write!(f, "\n{file}: and more: correct these first")?;
        }
        Ok(())
    }
}

/// Returns `did you mean ...?` with the candidates closest to `name`; `None` if no candidate is close.
pub fn did_you_mean(name: &str, candidates: &[&str]) -> Option<String> {
    did_you_mean_the("", name, candidates)
}

/// As [`did_you_mean`], with what the candidates are before them.
pub fn did_you_mean_the(what: &str, name: &str, candidates: &[&str]) -> Option<String> {
    let lower = name.to_lowercase();
    let distance = |candidate: &str| {
        let other = candidate.to_lowercase();
        // A prefix counts as a match.
        let is_begun = lower.len() >= 3 && other.starts_with(&lower);
        if is_begun { 0 } else { strsim::osa_distance(&lower, &other) }
    };
    variables::close(what, name, candidates.iter().map(|it| (distance(it), *it)).collect())
}

/// Returns the hint of [`did_you_mean`]; if no candidate is close, lists all after a text: `the keys here are a, b`.
pub fn nearest(name: &str, candidates: &[&str], all: &str) -> String {
    did_you_mean(name, candidates).unwrap_or_else(|| format!("{all} {}", candidates.join(", ")))
}
