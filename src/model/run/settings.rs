//! What is requested of a run, and who watches it.

use std::ops::ControlFlow;

/// What a run should deliver besides its results.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Settings {
    /// Keep the series to draw from.
    pub series: bool,
    /// Compute the error estimate (a second, tighter computation).
    pub estimate: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self { series: true, estimate: true }
    }
}

/// Called before every step with the time reached, s; `Break` ends the run as cancelled.
pub type Observer<'a> = &'a mut dyn FnMut(f64) -> ControlFlow<()>;
