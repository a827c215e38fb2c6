//! What can go wrong on the command line, and the exit code it has.

use std::io;
use std::process::ExitCode;

use thiserror::Error;

use crate::files::error::FileError;
use crate::model::variables::VariableError;
use crate::study::monte_carlo::MonteCarloError;
use crate::study::sweep::SweepError;
use crate::tui::TuiError;

/// Why a command could not be carried out.
#[derive(Debug, Error)]
pub enum CliError {
    /// A file cannot be read, written or found.
    #[error(transparent)]
    File(#[from] FileError),
    /// A file is there already.
    #[error(
        "`{path}` exists and was left alone: add --force to replace it, or choose another name"
    )]
    Exists {
        /// The file.
        path: String,
    },
    /// `--set` without a `=`.
    #[error("--set {argument}: write NAME=VALUE, for example --set gamma=2")]
    NotAnAssignment {
        /// What was written.
        argument: String,
    },
    /// `--set` with a name or a value that is refused.
    #[error("--set {argument}: {source}")]
    Set {
        /// What was written.
        argument: String,
        /// Why it is refused.
        source: Box<VariableError>,
    },
    /// `--over` that cannot be read.
    #[error("--over {argument}: {problem}")]
    Over {
        /// What was written.
        argument: String,
        /// What is wrong, and what to write.
        problem: String,
    },
    /// The sweep is refused before it begins.
    #[error(transparent)]
    Sweep(#[from] SweepError),
    /// The scatter is refused before it begins.
    #[error(transparent)]
    MonteCarlo(#[from] MonteCarloError),
    /// A sweep of a scene that has none, without `--over`.
    #[error("{scene} has no [sweep] of its own: name an axis, for example --over gamma=0.8..7:101")]
    NothingToSweep {
        /// The scene.
        scene: String,
    },
    /// An option that needs another.
    #[error("{0}")]
    Option(String),
    /// A weight of the screening matrix that is none.
    #[error(
        "--weight {argument}: write CRITERION=PERCENT with 0 to 100, for example --weight analysis=0; the criteria are {criteria}"
    )]
    Weight {
        /// What was written.
        argument: String,
        /// The names that exist.
        criteria: String,
    },
    /// The scene as a whole makes no sense.
    #[error(transparent)]
    Scene(Box<VariableError>),
    /// Standard output cannot be written.
    #[error("cannot write to standard output: {0}")]
    Stdout(io::Error),
    /// The workbench could not start or had to stop.
    #[error(transparent)]
    Workbench(#[from] TuiError),
}

impl From<VariableError> for CliError {
    fn from(error: VariableError) -> Self {
        Self::Scene(Box::new(error))
    }
}

impl CliError {
    /// 1 where the computation or the system failed, 2 where the command line or an input file is wrong.
    pub fn code(&self) -> ExitCode {
        match self {
            // Whoever reads our output has had enough: not a failure.
            Self::Stdout(source) if source.kind() == io::ErrorKind::BrokenPipe => ExitCode::SUCCESS,
            Self::Stdout(_)
            | Self::Workbench(_)
            | Self::File(FileError::Write { .. } | FileError::Csv(_) | FileError::NoHome) => {
                ExitCode::FAILURE
            }
            Self::File(_)
            | Self::Exists { .. }
            | Self::NotAnAssignment { .. }
            | Self::Weight { .. }
            | Self::Set { .. }
            | Self::Over { .. }
            | Self::Sweep(_)
            | Self::MonteCarlo(_)
            | Self::NothingToSweep { .. }
            | Self::Option(_)
            | Self::Scene(_) => ExitCode::from(2),
        }
    }

    /// Whether its text has several lines: those of a scene file, one for each problem.
    pub(super) fn has_lines(&self) -> bool {
        matches!(self, Self::File(FileError::Scene(_) | FileError::Unmendable { .. }))
    }

    /// Whether standard output is closed: there is no reader left.
    pub(super) fn is_quiet(&self) -> bool {
        matches!(self, Self::Stdout(source) if source.kind() == io::ErrorKind::BrokenPipe)
    }
}
