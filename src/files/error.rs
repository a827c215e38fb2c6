//! Errors of files, with their cures. No particular format.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

use thiserror::Error;

use crate::files::clean;
use cmra_engine::model::variables;

/// Why a file could not be read, written or found.
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
    /// The file, its name or its place cannot be used: which, why, and the cure.
    #[error("{0}")]
    Refused(String),
    /// The file is not a scene.
    #[error("{0}")]
    Scene(SceneErrors),
    /// Neither a preset nor a file.
    #[error("`{}` is neither a preset nor a file: {hint}", clean::line(.name))]
    UnknownScene {
        /// The text as written.
        name: String,
        /// The nearest names, or what to write.
        hint: String,
    },
    /// The file exists already and was not replaced.
    #[error("`{}` already exists: choose another name, or allow it to be replaced", shown(.0))]
    Exists(PathBuf),
    /// The file could not be finished, and what was made before is in another one.
    #[error("{problem}; what was computed is kept in `{}`", shown(.path))]
    Kept {
        /// The other file.
        path: PathBuf,
        /// Why it could not be finished.
        problem: Box<Self>,
    },
    /// A preset is to be replaced whose file is not a readable scene; what is in it would be lost.
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
    /// A reading error of this file.
    pub fn read(path: &Path, source: io::Error) -> Self {
        Self::Read { path: path.to_owned(), source }
    }

    /// A writing error of this file.
    pub fn write(path: &Path, source: io::Error) -> Self {
        Self::Write { path: path.to_owned(), source }
    }

    /// A device or a pipe where only an ordinary file will do: it may never end, or never begin.
    pub(super) fn special(path: &Path) -> Self {
        Self::Refused(format!(
            "`{}` is a device or a pipe, for which there would be no end of waiting: name an ordinary file",
            shown(path)
        ))
    }

    /// A name that a preset or an entry cannot have.
    pub(super) fn name(name: &str, problem: &str) -> Self {
        Self::Refused(format!("`{}` cannot be the name: {problem}", clean::line(name)))
    }

    /// A file that cannot be written to.
    pub(super) fn target(path: &Path, problem: &str) -> Self {
        Self::Refused(format!("`{}` cannot be the target: {problem}", shown(path)))
    }
}

/// A path for a line of text: what would break or command that line is replaced.
pub(super) fn shown(path: &Path) -> String {
    clean::line(&path.to_string_lossy()).into_owned()
}

/// The error text of the system, lower case and without its number.
fn reason(error: &io::Error) -> String {
    let text = error.to_string();
    let text = text.split(" (os error").next().unwrap_or(&text);
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_lowercase().collect::<String>() + letters.as_str()
    })
}

/// Everything that is wrong with one scene file, in the order of its lines. Never empty.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SceneErrors {
    /// The file's name as the user wrote it.
    pub file: String,
    /// The error.
    pub problems: Vec<Problem>,
    /// More problems exist than are listed.
    pub more: bool,
}

/// Problem in a scene file.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Problem {
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// Key and value, what is allowed, and the cure.
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

/// `did you mean ...?` with the candidates spelled most like `name`; `None` when none is close.
pub fn did_you_mean(name: &str, candidates: &[&str]) -> Option<String> {
    let lower = name.to_lowercase();
    let distance = |candidate: &str| {
        let other = candidate.to_lowercase();
        // The beginning of a long name means that name.
        let is_begun = lower.len() >= 3 && other.starts_with(&lower);
        if is_begun { 0 } else { strsim::osa_distance(&lower, &other) }
    };
    variables::close(name, candidates.iter().map(|it| (distance(it), *it)).collect())
}

/// The candidates spelled most like `name`, else all of them after some words: `the keys here are a, b`.
pub fn nearest(name: &str, candidates: &[&str], all: &str) -> String {
    did_you_mean(name, candidates).unwrap_or_else(|| format!("{all} {}", candidates.join(", ")))
}
