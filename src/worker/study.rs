//! Studies: work of seconds on threads of its own, so that the run of an edited scene never waits. A study that is cancelled keeps
//! its results so far.

use std::any::Any;
use std::error::Error;
use std::fmt::Debug;
use std::sync::Arc;
use std::time::Duration;

use super::reporter::{BETWEEN, Reporter};
use crate::model::scene::Scene;

/// A study that a page asks for. A newer one of the same type replaces an older one.
pub trait Study: Any + Debug + Send + Sync {
    /// The thread it is done on.
    fn lane(&self) -> Lane;

    /// Whether it measures run times, for which it has the machine to itself.
    fn measures(&self) -> bool {
        false
    }

    /// When it shows what it has so far.
    fn tempo(&self) -> Tempo {
        Tempo { first: BETWEEN, between: BETWEEN }
    }

    /// Computes the result; a study that is stopped gives its results so far.
    ///
    /// # Errors
    /// Why it cannot be made, in words.
    fn make(&self, scene: &Arc<Scene>, reporter: &Reporter<'_>) -> Result<Finding, Box<dyn Error>>;
}

impl dyn Study {
    /// The study, where it is of this type.
    pub fn of<S: Study>(&self) -> Option<&S> {
        (self as &dyn Any).downcast_ref()
    }
}

/// A thread that does one task at a time. Half a minute of measurements or of stiff scenes must not keep a limit waiting.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lane {
    /// Runs of scenes.
    Runs,
    /// The points of a picture.
    Sweeps,
    /// Studies of half a minute.
    Studies,
    /// Studies of seconds.
    Searches,
}

impl Lane {
    /// All of them, with the names of their threads.
    pub(super) const ALL: [(Self, &str); 4] = [
        (Self::Runs, "runs"),
        (Self::Sweeps, "sweeps"),
        (Self::Studies, "studies"),
        (Self::Searches, "searches"),
    ];
}

/// When a task shows what it has so far.
#[derive(Clone, Copy, Debug)]
pub struct Tempo {
    /// Not before this time.
    pub first: Duration,
    /// Least time between two parts.
    pub between: Duration,
}

/// A result, whole or as far as it is. The page that asked for it knows its type.
#[derive(Clone, Debug)]
pub struct Finding(Arc<dyn Any + Send + Sync>);

impl Finding {
    /// This result.
    pub fn new<T: Any + Send + Sync>(found: T) -> Self {
        Self(Arc::new(found))
    }

    /// The result, where it is of this type.
    pub fn get<T: Any + Send + Sync>(&self) -> Option<Arc<T>> {
        Arc::clone(&self.0).downcast().ok()
    }
}

impl<T: Any + Send + Sync> From<Arc<T>> for Finding {
    fn from(found: Arc<T>) -> Self {
        Self(found)
    }
}

/// Rows of a study, all or those computed so far.
#[derive(Clone, Debug)]
pub struct RowsSoFar<R> {
    /// The rows computed so far.
    pub rows: Vec<R>,
    /// Whether these are all.
    pub is_complete: bool,
}

impl<R: Clone> RowsSoFar<R> {
    /// Rows of a study that goes on.
    pub fn part(rows: &[R]) -> Self {
        Self { rows: rows.to_vec(), is_complete: false }
    }

    /// Rows of a study that has ended, of so many in all.
    pub fn ended(rows: Vec<R>, count: usize) -> Self {
        Self { is_complete: rows.len() == count, rows }
    }
}
