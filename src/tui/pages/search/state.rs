//! What the Search tab keeps: what is looked for, what was found, which design is selected.

use std::sync::Arc;

use crate::model::scene::SweepAxis;
use crate::study::search::front::{self, Constraint};
use crate::study::search::seek::SCAN_USUAL;
use crate::study::sweep::Axis;
use crate::tui::app::running::Kept;
use crate::tui::keymap::{Pane, Tab};
use crate::tui::widgets::axis::Part;
use crate::worker::studies::{SearchAnswer, SearchRequest};

pub const SETUP: Pane = Pane::of(Tab::Search, 0);
pub const RESULTS: Pane = Pane::of(Tab::Search, 1);

/// A page of the tab: a study.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Page {
    #[default]
    Seek,
    Front,
    Sensitivity,
    MonteCarlo,
}

impl Page {
    /// All of them, in their order.
    pub const ALL: [Self; 4] = [Self::Seek, Self::Front, Self::Sensitivity, Self::MonteCarlo];
    /// How many there are.
    pub const COUNT: usize = Self::ALL.len();

    /// The page that asks for it.
    pub fn of(request: &SearchRequest) -> Self {
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
    /// The results, page by page.
    pub found: [Kept<SearchAnswer>; Page::COUNT],
    /// Why a page cannot be computed, page by page.
    pub problem: [Option<String>; Page::COUNT],
    /// The selected design or solution by its place among all, or the first line shown, page by page.
    pub cursor: [Option<usize>; Page::COUNT],
}

#[derive(Clone, Debug, PartialEq)]
pub struct Setup {
    /// Goal seek: the variable, and the points of its scan.
    pub seek: SweepAxis,
    /// The result and its wanted value.
    pub goal: (&'static str, f64),
    /// Variables of fronts and sensitivity; empty: those of Table 9.2.
    pub bounds: Vec<Bound>,
    /// Which of the usual objectives count.
    pub objectives: [bool; 4],
    /// Bounds that designs have to keep.
    pub subject_to: Vec<Constraint>,
    /// Designs that are not feasible do not count.
    pub feasible: bool,
    /// Designs that a front tries.
    pub designs: usize,
    /// The result of sensitivity and scatter.
    pub output: &'static str,
    /// Relative deviation of every input, percent.
    pub percent: f64,
    pub samples: usize,
}

impl Default for Setup {
    fn default() -> Self {
        let front = front::Request::default();
        let scan = usize::try_from(SCAN_USUAL).unwrap_or(usize::MAX);
        Self {
            seek: SweepAxis::linear("d", 0.0, 0.5, scan),
            goal: ("percent_of_baseline", 60.0),
            bounds: Vec::new(),
            objectives: [true; 4],
            subject_to: front.subject_to,
            feasible: front.is_feasible,
            designs: front.samples,
            output: "percent_of_baseline",
            percent: 2.0,
            samples: 10_000,
        }
    }
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Row {
    Heading(&'static str),
    /// Goal seek: a part of its variable's axis.
    Axis(Part),
    Result,
    /// The goal: what a person changes first.
    #[default]
    Goal,
    Bound(usize),
    Objective(usize),
    /// Bounds that designs have to keep.
    Bounds,
    Feasible,
    /// Designs that a front tries.
    Designs,
    /// The result of sensitivity and scatter.
    Output,
    /// Relative deviation of the inputs.
    Percent,
    Samples,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Bound {
    /// The variable, and its bounds as the ends of an axis.
    pub axis: Axis,
    /// It is varied; otherwise held.
    pub on: bool,
}
