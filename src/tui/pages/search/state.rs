//! State of the Search tab: setups, results, selected design.

use std::sync::Arc;

use crate::files::session::Search;
use crate::tui::app::running::CachedResult;
use crate::tui::keymap::{Pane, Tab};
use crate::tui::widgets::axis::Part;
use crate::worker::studies::{SearchAnswer, SearchRequest};
use cmra_engine::model::scene::SweepAxis;
use cmra_studies::enumeration;
use cmra_studies::study::monte_carlo::{self, DEFAULT_DEVIATION, DEFAULT_SAMPLES};
use cmra_studies::study::quantities;
use cmra_studies::study::search::front::{self, Constraint, DEFAULT, SAMPLES};
use cmra_studies::study::search::seek::{DEFAULT_SCAN, Goal, SCAN};
use cmra_studies::study::sensitivity;
use cmra_studies::study::sweep::{Axis, COUNTS};

pub const SETUP: Pane = Pane::new(Tab::Search, 0);
pub const RESULTS: Pane = Pane::new(Tab::Search, 1);

enumeration! {
    /// Page of the tab.
    #[derive(Default)]
    pub enum Page in PageRow {
        /// Subject, in two or three words.
        title: &'static str,
    }
    /// Values of a variable that reach a goal.
    #[default]
    Seek { title: "Goal seek" }
    /// Best designs.
    Front { title: "Pareto front" }
    /// Effect of each variable.
    Sensitivity { title: "Sensitivity" }
    /// Spread of results.
    MonteCarlo { title: "Monte Carlo" }
}

impl Page {
    /// Number of pages.
    pub const COUNT: usize = Self::ALL.len();

    /// Returns the page of a request.
    pub fn from_request(request: &SearchRequest) -> Self {
        match request {
            SearchRequest::Seek(_) => Self::Seek,
            SearchRequest::Front(_) => Self::Front,
            SearchRequest::Sensitivity(_) => Self::Sensitivity,
            SearchRequest::MonteCarlo(_) => Self::MonteCarlo,
        }
    }
}

#[derive(Clone, Debug, Default)]
pub struct Searching {
    pub page: Page,
    pub row: Row,
    pub setup: Arc<Setup>,
    /// Results by page.
    pub results: [CachedResult<SearchAnswer>; Page::COUNT],
    /// Reason why a page cannot be computed, by page.
    pub problem: [Option<String>; Page::COUNT],
    /// Index of the selected design or solution, or the first visible line, by page.
    pub cursor: [Option<usize>; Page::COUNT],
}

#[derive(Clone, Debug, PartialEq)]
pub struct Setup {
    /// Goal seek: the variable, and the points of its scan.
    pub seek: SweepAxis,
    /// Output of the goal, and its target value.
    pub goal: (&'static str, f64),
    /// Variables of fronts; empty for those of Table 9.2.
    pub bounds: Vec<Bound>,
    /// Whether each of the default objectives is used.
    pub objectives: [bool; 4],
    /// Constraints on designs.
    pub subject_to: Vec<Constraint>,
    /// Whether infeasible designs are excluded.
    pub feasible: bool,
    /// Number of designs evaluated for a front.
    pub designs: usize,
    /// Output of the sensitivity study.
    pub affected: &'static str,
    /// Output of the Monte Carlo study.
    pub output: &'static str,
    /// Relative standard deviation of every input, percent.
    pub percent: f64,
    pub samples: usize,
}

impl Default for Setup {
    fn default() -> Self {
        let front = front::Request::default();
        let scan = usize::try_from(DEFAULT_SCAN).unwrap_or(usize::MAX);
        Self {
            seek: SweepAxis::linear("d", 0.0, 0.5, scan),
            goal: ("percent_of_baseline", 60.0),
            bounds: Vec::new(),
            objectives: [true; 4],
            subject_to: front.subject_to,
            feasible: front.is_feasible,
            designs: front.samples,
            affected: sensitivity::OUTPUT,
            output: "percent_of_baseline",
            percent: 100.0 * DEFAULT_DEVIATION,
            samples: DEFAULT_SAMPLES,
        }
    }
}

impl Setup {
    /// Converts the setup for the session, by meaning instead of by row.
    pub(crate) fn kept(&self) -> Search {
        let (name, target) = self.goal;
        let goal = quantities::find(name).map(|measure| Goal { measure, target });
        let chosen = DEFAULT.iter().zip(self.objectives).filter(|(_, is_chosen)| *is_chosen);
        Search {
            seek: Axis::from_sweep_axis(&self.seek, &SCAN)
                .map_or_else(|_| String::new(), |it| it.to_string()),
            goal: goal.map_or_else(String::new, |goal| goal.to_string()),
            bounds: self.bounds.iter().map(|it| (it.axis.to_string(), it.on)).collect(),
            minimise: Some(chosen.map(|(name, _)| (*name).to_owned()).collect()),
            subject_to: Some(self.subject_to.iter().map(ToString::to_string).collect()),
            feasible: Some(self.feasible),
            designs: Some(self.designs),
            affected: self.affected.to_owned(),
            output: self.output.to_owned(),
            percent: Some(self.percent),
            samples: Some(self.samples),
        }
    }

    /// Restores the setup from the session, as far as it is still valid.
    pub(crate) fn from_session(kept: &Search) -> Self {
        let usual = Self::default();
        let bound = |(text, on): &(String, bool)| {
            let axis = Axis::read_range(text, Some(*COUNTS.start()), &COUNTS).ok()?;
            Some(Bound { axis, on: *on })
        };
        let seek = Axis::read_range(&kept.seek, Some(DEFAULT_SCAN), &SCAN);
        let goal = kept.goal.parse::<Goal>().map(|goal| (goal.measure.name, goal.target));
        let minimise =
            kept.minimise.as_ref().map(|it| DEFAULT.map(|name| it.iter().any(|one| one == name)));
        let bounds = kept.subject_to.as_ref();
        let bounds = bounds.map(|it| it.iter().filter_map(|text| text.parse().ok()).collect());
        Self {
            seek: seek.map_or(usual.seek, |axis| axis.to_sweep_axis()),
            goal: goal.unwrap_or(usual.goal),
            bounds: kept.bounds.iter().filter_map(bound).collect(),
            objectives: minimise.unwrap_or(usual.objectives),
            subject_to: bounds.unwrap_or(usual.subject_to),
            feasible: kept.feasible.unwrap_or(usual.feasible),
            designs: kept.designs.unwrap_or(usual.designs).clamp(*SAMPLES.start(), *SAMPLES.end()),
            affected: quantities::find(&kept.affected).map_or(usual.affected, |it| it.name),
            output: quantities::find(&kept.output).map_or(usual.output, |it| it.name),
            percent: kept.percent.unwrap_or(usual.percent).clamp(1e-3, 100.0),
            samples: kept
                .samples
                .unwrap_or(usual.samples)
                .clamp(*monte_carlo::SAMPLES.start(), *monte_carlo::SAMPLES.end()),
        }
    }
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Row {
    Heading(&'static str),
    /// Goal seek: part of the axis of its variable.
    Axis(Part),
    Result,
    /// Goal value, the preferred row.
    #[default]
    Goal,
    Bound(usize),
    Objective(usize),
    /// Constraints on designs.
    Bounds,
    Feasible,
    /// Number of designs evaluated for a front.
    Designs,
    /// Output of the sensitivity study.
    Affected,
    /// Output of the Monte Carlo study.
    Output,
    /// Relative standard deviation of the inputs.
    Percent,
    Samples,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Bound {
    /// Variable with its bounds as an axis.
    pub axis: Axis,
    /// Whether the variable is varied.
    pub on: bool,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_means_nothing_any_more_is_as_usual() {
        let odd = Search {
            seek: "kk=1..2".to_owned(),
            goal: "depth".to_owned(),
            output: "?".to_owned(),
            bounds: vec![("gamma=1..5".to_owned(), true), ("x".to_owned(), true)],
            percent: Some(0.0),
            ..Search::default()
        };
        let kept = Setup::from_session(&odd);
        let usual = Setup::default();
        assert_eq!((kept.seek, kept.goal, kept.output), (usual.seek, usual.goal, usual.output));
        assert!(kept.bounds.len() == 1 && kept.percent > 0.0);
    }
}
