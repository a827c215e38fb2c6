//! State of the Numerics tab.

use crate::tui::app::running::CachedResult;
use crate::tui::keymap::{Pane, Tab};
use crate::tui::widgets::moved;
use cmra_studies::report::accuracy::TARGETS;
use cmra_studies::study::accuracy::method::{Method, Parameter};
use cmra_studies::study::accuracy::{AccuracyReport, Measured, MethodReport};
use cmra_studies::study::stability::Row;
use cmra_studies::study::stability::map::{FixedStep, Map, MapVariable};

/// Pane of error over run time.
pub const ACCURACY: Pane = Pane::new(Tab::Numerics, 0);
pub const STABILITY: Pane = Pane::new(Tab::Numerics, 1);
pub const STIFF_SCENES: Pane = Pane::new(Tab::Numerics, 2);

#[derive(Clone, Debug, Default)]
pub struct Numerics {
    /// Error over run time.
    pub accuracy: Accuracy,
    /// Stability map and stiff scenes.
    pub stability: Stability,
}

#[derive(Clone, Debug, Default)]
pub struct Accuracy {
    pub report: CachedResult<AccuracyReport>,
    /// Row of the selected method in [`Method::ALL`]; `None` for the fastest method that reaches the first target.
    pub selected: Option<usize>,
}

impl Accuracy {
    pub fn selected_row(&self) -> usize {
        // The method that runs scenes, if it reaches the target.
        let is_reached = self.tolerance().is_some();
        let auto = || Method::ALL.iter().position(|one| is_reached && *one == Method::Auto);
        self.selected.or_else(auto).unwrap_or(0).min(Method::ALL.len() - 1)
    }

    pub fn method(&self) -> Method {
        Method::ALL[self.selected_row()]
    }

    /// Returns the tolerance at which the default method reaches the first target, as in the recommendation.
    pub fn tolerance(&self) -> Option<f64> {
        Some(self.report.result.as_ref()?.usable(TARGETS[0])?.parameter.value())
    }

    /// Returns the tolerance of the selected method for the scene; `None` for a method that is for comparison only.
    pub fn usable(&self) -> Option<f64> {
        self.tolerance().filter(|_| self.method() == Method::Auto)
    }

    pub fn method_report(&self, method: Method) -> Option<&MethodReport> {
        self.report.result.as_ref()?.methods.iter().find(|one| one.method == method)
    }

    /// Returns the usable point of the selected method, else its most accurate point.
    pub fn example(&self) -> Option<(Parameter, &Measured)> {
        let report = self.method_report(self.method())?;
        let usable = self.usable().map(Parameter::Tolerance);
        let used = report.measured().find(|point| Some(point.0) == usable);
        used.or_else(|| report.measured().min_by(|a, b| a.1.error().total_cmp(&b.1.error())))
    }
}

#[derive(Clone, Debug, Default)]
pub struct Stability {
    /// Index of the displayed map: the variables with the first method, then with the second.
    pub view: usize,
    pub map: CachedResult<Map>,
    /// Crosshair as column and row of the map; `None` for the present point.
    pub cursor: Option<(usize, usize)>,
    pub battery: CachedResult<Vec<Row>>,
    /// Selected scene.
    pub selected: usize,
}

impl Stability {
    pub(crate) fn method(&self) -> FixedStep {
        FixedStep::ALL[self.view / MapVariable::ALL.len() % FixedStep::ALL.len()]
    }

    pub(crate) fn variable(&self) -> MapVariable {
        MapVariable::ALL[self.view % MapVariable::ALL.len()]
    }

    /// Returns the cell of the present point, at the scene's value and the thesis's step; `None` outside the map.
    pub fn present(&self) -> Option<(usize, usize)> {
        self.map.result.as_ref()?.present_at()
    }

    /// Returns the cell of the crosshair; the middle of the map by default.
    pub fn cursor(&self) -> Option<(usize, usize)> {
        let (columns, rows) = self.map.result.as_ref()?.counts();
        self.cursor.or_else(|| self.present()).or(Some((columns / 2, rows / 2)))
    }

    pub(crate) fn move_cursor(&mut self, by: (isize, isize)) {
        if let (Some(at), Some(map)) = (self.cursor(), &self.map.result) {
            self.cursor = Some(moved(at, by, map.counts()));
        }
    }

    pub fn rows(&self) -> &[Row] {
        self.battery.result.as_ref().map_or(&[], |battery| battery)
    }
}
