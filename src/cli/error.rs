//! Errors of the command line, and their exit codes.

use std::io;
use std::process::ExitCode;

use thiserror::Error;

use crate::files::error::FileError;
use cmra_engine::model::variables::VariableError;
use cmra_studies::study::error::{QuantityError, StudyError};

/// Error of a command.
#[derive(Debug, Error)]
pub enum CliError {
    /// A file cannot be read, written or found.
    #[error(transparent)]
    File(FileError),
    /// The file exists already.
    #[error("`{0}` already exists: add --force to replace it, or choose another name")]
    Exists(String),
    /// The command line, or the scene as a whole, is invalid.
    #[error("{0}")]
    Option(String),
    /// The study, or the scene, is refused.
    #[error(transparent)]
    Study(#[from] StudyError),
    /// Standard output cannot be written.
    #[error("cannot write to standard output: {0}")]
    Stdout(io::Error),
    /// The workbench could not start or had to stop.
    #[error("the terminal cannot be used: {0}; `cmra run --plain` needs none")]
    Workbench(io::Error),
}

impl From<FileError> for CliError {
    /// Adds the remedy of the command line for an existing file: `--force`.
    fn from(error: FileError) -> Self {
        match error {
            FileError::Exists(path) => Self::Exists(path.display().to_string()),
            other => Self::File(other),
        }
    }
}

impl From<VariableError> for CliError {
    fn from(error: VariableError) -> Self {
        Self::Study(error.into())
    }
}

impl From<QuantityError> for CliError {
    fn from(error: QuantityError) -> Self {
        Self::Study(error.into())
    }
}

impl CliError {
    /// Returns the exit code: 1 if the computation or the system failed, 2 if the command line or an input file is invalid.
    pub fn code(&self) -> ExitCode {
        match self {
            // A pipe closed by its reader is not a failure.
            _ if self.is_quiet() => ExitCode::SUCCESS,
            Self::Stdout(_)
            | Self::Workbench(_)
            | Self::File(FileError::Write { .. } | FileError::Kept { .. } | FileError::NoHome) => {
                ExitCode::FAILURE
            }
            Self::File(_) | Self::Exists(_) | Self::Option(_) | Self::Study(_) => ExitCode::from(2),
        }
    }

    /// Returns `true` if the message has several lines: one for each problem of a scene file.
    pub(super) fn has_lines(&self) -> bool {
        matches!(self, Self::File(FileError::Scene(_) | FileError::Unmendable { .. }))
    }

    /// Returns `true` if the reader has closed standard output.
    pub(super) fn is_quiet(&self) -> bool {
        matches!(self, Self::Stdout(source) if source.kind() == io::ErrorKind::BrokenPipe)
    }
}
