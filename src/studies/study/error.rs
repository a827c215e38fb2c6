//! Why a study over variables is refused before anything runs.

use thiserror::Error;

use cmra_engine::model::variables::VariableError;

/// Why a sweep, or another study over variables, is refused before anything runs: axis, value, rule, cure.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{0}")]
pub struct SweepError(pub(in crate::study) String);

impl SweepError {
    /// No variable has this name.
    pub fn unknown(name: &str, source: &VariableError) -> Self {
        Self(format!("axis {name}: {source}"))
    }

    /// More axes than a study can have.
    pub(in crate::study) fn too_many_axes(count: usize, most: usize) -> Self {
        Self(format!(
            "{count} axes are too many: a sweep has at most {most}; hold some of the variables"
        ))
    }

    /// A scene that is to be swept has no axis.
    pub(in crate::study) fn no_axis() -> Self {
        Self("a sweep needs at least one axis, for example gamma=0.8..7:101".to_owned())
    }
}
