//! Errors of studies, by kind.

use thiserror::Error;

use cmra_engine::model::variables::VariableError;

/// Why a study over variables is refused before anything runs, or has no answer.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum StudyError {
    /// The scene is refused.
    #[error(transparent)]
    Variable(#[from] VariableError),
    /// A quantity is refused.
    #[error(transparent)]
    Quantity(#[from] QuantityError),
    /// An axis is refused.
    #[error("axis {axis}: {problem}")]
    Axis {
        /// Axis as it was written.
        axis: String,
        /// Value, rule and cure.
        problem: String,
    },
    /// The axes or points of a study are refused together.
    #[error("{0}")]
    Points(String),
    /// The samples of a Monte Carlo study are refused.
    #[error("{0}")]
    Samples(String),
}

/// Why a quantity is refused.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum QuantityError {
    /// No quantity has this name.
    #[error("output {name}: not a result of a run: {cure}")]
    Unknown {
        /// Name as it was written.
        name: String,
        /// The nearest names.
        cure: String,
    },
    /// A stack does not have the quantity.
    #[error("{title}: a stack has none; take {instead}, for example")]
    NotOfStacks {
        /// Title of the quantity.
        title: String,
        /// Quantity that a stack has.
        instead: &'static str,
    },
}

impl StudyError {
    /// Creates the error of an axis.
    pub(in crate::study) fn axis(axis: impl Into<String>, problem: impl Into<String>) -> Self {
        Self::Axis { axis: axis.into(), problem: problem.into() }
    }

    /// More axes than a study can have.
    pub(in crate::study) fn too_many_axes(count: usize, most: usize) -> Self {
        Self::Points(format!(
            "{count} axes are too many: a sweep has at most {most}; hold some of the variables"
        ))
    }

    /// A scene that is to be swept has no axis.
    pub(in crate::study) fn no_axis() -> Self {
        Self::Points("a sweep needs at least one axis, for example gamma=0.8..7:101".to_owned())
    }
}
