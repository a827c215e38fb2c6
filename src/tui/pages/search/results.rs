//! Results of the Search tab, the selected design, and whether they are stale. No drawing.

use crate::tui::app::running::CachedResult;
use crate::tui::pages::explore::state::copy_value;
use crate::tui::pages::page::prelude::*;
use crate::tui::pages::search::state::{Page, Searching};
use crate::tui::pages::search::study_page::{Answer, Words};
use crate::tui::widgets::layout::CHART_ROWS;
use crate::worker::studies::{SearchAnswer, SearchRequest};
use cmra_studies::study::search::front::{Design, FrontReport};

/// Minimum number of visible rows of a table below a chart.
const ROWS: usize = 2;

impl Searching {
    /// Returns the result of the shown page; `None` before the first one.
    pub fn shown(&self) -> Option<&CachedResult<SearchAnswer>> {
        Some(&self.results[self.page as usize]).filter(|kept| kept.result.is_some())
    }

    /// Returns the reason why the shown page cannot be computed.
    pub fn problem(&self) -> Option<&String> {
        self.problem[self.page as usize].as_ref()
    }

    pub fn front(&self) -> Option<&FrontReport> {
        match &**self.results[Page::Front as usize].result.as_ref()? {
            SearchAnswer::Front(front) => Some(front),
            _ => None,
        }
    }

    /// Returns the result as its page presents it.
    pub(crate) fn answer(&self) -> Option<&dyn Answer> {
        Some(self.shown()?.result.as_ref()?.answer())
    }

    /// Returns the number of items that can be selected.
    pub fn choices(&self) -> usize {
        self.answer().map_or(0, Answer::choices)
    }

    /// Returns the rows for text below the chart in a pane of this height, frame included. Text gets all rows if there is no chart, or no
    /// room for one with the answer and some rows of the table. A table with a single row may be hidden.
    pub fn words_height(&self, height: u16, words: &Words) -> u16 {
        let lines = |count: usize| u16::try_from(count).unwrap_or(u16::MAX).saturating_add(2);
        let all = lines(words.count());
        let least =
            if words.body.len() == 1 { lines(1) } else { all.min(lines(words.head.len() + ROWS)) };
        let draws = self.answer().is_some_and(|answer| answer.draws(self));
        if draws && height >= CHART_ROWS + least { all.min(height - CHART_ROWS) } else { height }
    }

    /// Returns the first visible line of a page without selectable designs.
    pub fn scrolled(&self) -> usize {
        self.cursor[self.page as usize].unwrap_or(0)
    }

    /// Returns the row of the selected item: on a front the knee until another design is selected, else the first one.
    pub fn selected(&self) -> usize {
        let knee = || self.knee().filter(|_| self.page == Page::Front);
        let chosen = self.cursor[self.page as usize].or_else(knee);
        chosen.filter(|at| *at < self.choices()).unwrap_or(0)
    }

    /// Returns the index of the front's knee: the design farthest from the line between the ends of the two drawn axes, each scaled by its
    /// range on the front; `None` if there is no such line.
    pub fn knee(&self) -> Option<usize> {
        let front = self.front()?;
        let places: Vec<Option<(f64, f64)>> =
            front.designs.iter().map(|design| place(front, design)).collect();
        let shown = || places.iter().flatten();
        let range = |of: fn(&(f64, f64)) -> f64| {
            let least = shown().map(of).min_by(f64::total_cmp)?;
            let most = shown().map(of).max_by(f64::total_cmp)?;
            (most > least).then_some((least, most - least))
        };
        let ((x0, width), (y0, height)) = (range(|it| it.0)?, range(|it| it.1)?);
        // Both objectives are minimised: the knee is nearest to the corner of both minima, along the diagonal.
        let depth = |(x, y): (f64, f64)| (x - x0) / width + (y - y0) / height;
        let known = places.iter().enumerate().filter_map(|(at, place)| Some((at, (*place)?)));
        known.min_by(|a, b| depth(a.1).total_cmp(&depth(b.1))).map(|(at, _)| at)
    }
}

/// Returns the indices of the measures on the horizontal and vertical axis: the first two objectives.
pub(super) fn axes(front: &FrontReport) -> (usize, usize) {
    (0, 1.min(front.request.measures().len().saturating_sub(1)))
}

/// Returns the position of a design on these axes.
pub(super) fn place(front: &FrontReport, design: &Design) -> Option<(f64, f64)> {
    let value = |at: usize| design.measures.get(at).copied().flatten();
    let (across, up) = axes(front);
    value(across).zip(value(up))
}

/// Returns the active search of a page.
pub fn searching(app: &App, page: Page) -> Option<&Running> {
    let is_own = |request: &Arc<SearchRequest>| Page::from_request(request) == page;
    let mut studies = app.jobs.studies.iter();
    studies.find(|running| SearchRequest::downcast(&running.request).is_some_and(is_own))
}

/// Returns `true` if the shown result belongs to another scene or setup. Values of the searched variables are ignored, so that loading
/// a design of the results does not make the others stale.
pub fn search_is_old(app: &App) -> bool {
    let tab = &app.pages.search;
    let Some((kept, answer)) = tab.shown().zip(tab.answer()) else { return false };
    let mut scene = (*app.scene).clone();
    scene.sweep.clone_from(&kept.scene.sweep);
    for axis in answer.over() {
        copy_value(axis, &kept.scene, &mut scene);
    }
    let request = kept.request.as_ref().and_then(SearchRequest::downcast);
    let wanted = app.search_request(tab.page).ok();
    *kept.scene != scene || request.map(|it| &**it) != wanted.as_ref()
}

/// Returns the design under the cursor as a scene with a label.
pub fn search_design(app: &App) -> Result<LabelledScene, String> {
    let Some(answer) = app.pages.search.answer() else {
        let is_running = searching(app, app.pages.search.page).is_some();
        return Err(app.keymap.shown(if is_running { BEING_COMPUTED } else { NO_RESULTS }));
    };
    if search_is_old(app) {
        return Err(old("setup"));
    }
    answer.design(app)
}
