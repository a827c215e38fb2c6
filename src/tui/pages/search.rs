//! Search tab: goal seek, Pareto front, sensitivity, Monte Carlo.

pub(crate) mod draw;
mod front;
mod monte_carlo;
pub mod results;
mod seek;
mod sensitivity;
pub mod setup;
pub mod state;
pub mod study_page;

use crate::tui::app::history::Snapshot;
use crate::tui::app::notice::with_ends;
use crate::tui::pages::page::move_by;
use crate::tui::pages::page::prelude::*;
use crate::tui::pages::run::runs;
use crate::tui::pages::run::runs::name_of;
use crate::tui::pages::search::results::{search_design, search_is_old, searching};
use crate::tui::pages::search::setup::read_bound;
use crate::tui::pages::search::state::{Bound, Row, Setup};
use crate::tui::pages::search::study_page::Answer;
use crate::tui::pages::search::study_page::search_words;
use crate::tui::widgets::along;
use crate::tui::widgets::axis::whole;
use crate::tui::widgets::form::{Form, quantity_after};
use crate::tui::widgets::layout::{NARROW, setup_width};
use crate::tui::widgets::value_steps::Input;
use crate::worker::studies::SearchRequest;
use cmra_studies::study::error::TargetError;
use cmra_studies::study::monte_carlo::SAMPLES;
use cmra_studies::study::quantities::{Needs, named};
use cmra_studies::study::search::front::{Constraint, SAMPLES as DESIGNS};
use cmra_studies::study::search::seek::SCAN;
use cmra_studies::study::sweep::Axis;

/// Columns of a search's setup: the longest row, `stroke at most 1.000 m`, and a frame.
const SEARCH_SETUP: u16 = 30;

/// Returns the areas of setup and results; if both do not fit, the focused one gets more of the room, or all.
pub(crate) fn panes(app: &App, body: Rect) -> (Rect, Rect) {
    let width = match app.pane() {
        SETUP if body.width < NARROW => SEARCH_SETUP,
        _ if body.width < NARROW => 0,
        _ => setup_width(body.width),
    };
    split_left(body, width)
}
pub(crate) use sensitivity::levels;
pub use state::{RESULTS, SETUP};

#[rustfmt::skip]
const PANES: &[PaneSpec] = &[
    PaneSpec { pane: SETUP, label: "Search setup", keys: &[
        key(A::Enter, "type", "type a variable, bounds (0.8..7, 1e3..1e6:log) or a goal"),
        key(A::Right, "change", "take the next value, or switch on and off"),
        key(A::Run, "search", "search with this setup"),
        key(A::Down, "move", "move to another row"),
    ] },
    PaneSpec { pane: RESULTS, label: "Search results", keys: &[
        key(A::Down, "move", "move to the next design or solution"),
        key(A::Enter, "load", "load this design into the scene (<undo> undoes)"),
        key(A::Mark, "pin", "pin this design"),
    ] },
];

/// Creates a page and the command that shows it.
const fn page(at: usize) -> PageSpec {
    PageSpec { name: state::Page::ALL[at].title(), panes: &[SETUP, RESULTS] }
}

const fn command(at: usize) -> Command {
    let page = state::Page::ALL[at];
    Command::new(CommandTarget::Show(RESULTS, Some(at)), page.title(), page.study().synonyms)
}

const PAGES: &[PageSpec; state::Page::COUNT] = &[page(0), page(1), page(2), page(3)];

const COMMANDS: &[Command; 1 + state::Page::COUNT] = &[
    Command::new(CommandTarget::Do(A::Tab(Tab::Search)), "Search tab", "find a design"),
    command(0),
    command(1),
    command(2),
    command(3),
];

/// Study of a page: its synonyms, file, setup rows and request.
struct Study {
    /// Synonyms for the search.
    synonyms: &'static str,
    /// Proposed file name of an export, without its ending.
    file: &'static str,
    /// Returns the rows of the setup, headings included.
    rows: fn(&App) -> Vec<Row>,
    /// Builds the request of the setup.
    request: fn(&App) -> Result<SearchRequest, String>,
}

impl state::Page {
    const fn study(self) -> &'static Study {
        match self {
            Self::Seek => &seek::STUDY,
            Self::Front => &front::STUDY,
            Self::Sensitivity => &sensitivity::STUDY,
            Self::MonteCarlo => &monte_carlo::STUDY,
        }
    }
}

pub(crate) struct SearchTab;

impl Page for SearchTab {
    fn about(&self) -> About {
        About { pages: PAGES, panes: PANES, commands: COMMANDS }
    }

    fn shown(&self, app: &App) -> usize {
        app.pages.search.page as usize
    }

    fn turn_to(&self, app: &mut App, page: usize) {
        app.pages.search.page = state::Page::ALL[page.min(state::Page::ALL.len() - 1)];
        app.typing = None;
        app.pages.search.row = app.search_row();
        self.enter(app);
    }

    fn enter(&self, app: &mut App) {
        let tab = &app.pages.search;
        let kept = &tab.results[tab.page as usize];
        let is_there =
            searching(app, tab.page).is_some() || kept.result.is_some() && kept.is_over();
        if is_there {
            follow(app);
        } else if tab.page != state::Page::Front {
            // A front takes seconds and has no coarse version, so it starts on request only.
            search(app, None);
        }
    }

    fn is_of_use(&self, app: &App, action: Action) -> bool {
        match action {
            Action::Enter | Action::Mark if app.pane() == RESULTS => app.pages.search.choices() > 0,
            Action::Down => self.rows(app).is_some_and(|rows| rows.count > 1),
            _ => true,
        }
    }

    fn act(&self, app: &mut App, action: Action) -> bool {
        match action {
            Action::Run => search(app, Some(action)),
            _ if app.pane() == SETUP => return false,
            Action::Enter => edit::load_design(app, search_design(app)),
            Action::Mark => runs::pin_design(app, search_design(app)),
            _ => match along(action) {
                Some(by) => move_by(app, by),
                None => return false,
            },
        }
        true
    }

    fn readout(&self, app: &App, _room: usize) -> Option<(Severity, String)> {
        let tab = &app.pages.search;
        if let Some(problem) = tab.problem() {
            return note(Some(problem.clone()));
        }
        note(tab.answer()?.readout(app))
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        let tab = &app.pages.search;
        if let Some(running) = searching(app, tab.page) {
            let counted = running.counted("of", " runs").replacen(": ", ": about ", 1);
            return vec![under_way(&format!("searching{counted}"))];
        }
        let answer = tab.answer();
        let own = answer.filter(|_| !search_is_old(app));
        let kept = &tab.results[tab.page as usize];
        let first = match (answer, own) {
            (Some(_), None) => part(Severity::Warning, old("setup")),
            (_, Some(_)) if kept.is_complete() => part(Severity::Note, "done"),
            (_, Some(_)) => cut(kept, "runs"),
            _ if tab.problem().is_some() => part(Severity::Error, "this cannot be searched for"),
            _ => part(Severity::Note, NO_RESULTS),
        };
        let ends = own.into_iter().flat_map(Answer::outside_at_ends);
        let validity = answer.map_or_else(|| app.validity_part(), |answer| answer.validity(app));
        let validity = with_ends(validity, ends.map(|it| it.0));
        let effort = own.and_then(Answer::effort).map(|runs| part(Severity::Note, runs));
        std::iter::once(first).chain(validity).chain(effort).collect()
    }

    fn report(&self, app: &mut App, running: &Running, news: &ReportBody) {
        let Some(request) = SearchRequest::downcast(&running.request) else { return };
        let (tab, page) = (&mut app.pages.search, state::Page::from_request(request) as usize);
        if let ReportBody::Failed(text) = news {
            tab.problem[page] = Some(text.clone());
        } else {
            tab.results[page].keep(running, news);
        }
    }

    fn table(&self, app: &App) -> Option<PageTable> {
        let kept = app.pages.search.shown()?;
        let (answer, scene) = (kept.result.clone()?, Arc::clone(&kept.scene));
        let command = SearchRequest::downcast(kept.request.as_ref()?)?.command();
        let name = name_of(app, &scene);
        let csv = move |reach| answer.csv(&scene, &name, reach);
        let (title, file) = ("Export the results to CSV", app.pages.search.page.study().file);
        let table = PageTable::new(title, file, kept.reach, csv);
        Some(table.for_scene(app, &kept.scene, command))
    }

    fn form(&self, app: &App) -> Option<Form> {
        (app.pane() == SETUP).then(|| app.search_form())
    }

    fn change(&self, app: &mut App, input: Input<'_>) -> Result<(), String> {
        let (row, before) = (app.search_row(), app.snapshot());
        change(app, row, input)?;
        note_change(app, row, before);
        follow(app);
        Ok(())
    }

    fn rows(&self, app: &App) -> Option<Rows> {
        let (tab, shown) = (&app.pages.search, app.list_rows());
        if let Some(form) = self.form(app) {
            return Some(form.rows(shown));
        }
        let (count, selected) = match tab.choices() {
            0 => (hidden_lines(app) + 1, tab.scrolled()),
            choices => (choices, tab.selected()),
        };
        Some(Rows { count, selected, shown })
    }

    fn select(&self, app: &mut App, row: usize) {
        if app.pane() == SETUP {
            app.pages.search.row = app.search_choices(app.pages.search.page)[row];
        } else {
            let tab = &mut app.pages.search;
            tab.cursor[tab.page as usize] = Some(row);
        }
    }

    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>) {
        let (setup, results) = panes(app, body);
        draw::render(app, setup, results, canvas);
    }
}

/// Returns the number of text lines that do not fit.
pub(crate) fn hidden_lines(app: &App) -> usize {
    let Some(body) = app.layout().body else { return 0 };
    let (_, area) = panes(app, body);
    let words = search_words(app, usize::from(area.width.saturating_sub(2)));
    let below = app.pages.search.words_height(area.height, &words);
    words.count().saturating_sub(usize::from(below.saturating_sub(2)))
}

/// Repeats a goal seek after an edit of the setup or the scene.
fn follow(app: &mut App) {
    if app.pages.search.page == state::Page::Seek && search_is_old(app) {
        search(app, None);
    }
}

/// Starts the search of the page's setup, on request or within the time limit of a page that is shown.
fn search(app: &mut App, by: Option<Action>) {
    let page = app.pages.search.page;
    let request = match app.search_request(page) {
        Ok(request) => request,
        Err(problem) => {
            app.refuse(problem.clone());
            app.pages.search.problem[page as usize] = Some(problem);
            return;
        }
    };
    app.pages.search.problem[page as usize] = None;
    match by {
        Some(action) => jobs::study(app, action, request),
        None => jobs::look(app, jobs::LOOK, request),
    }
}

/// Records a change of a row of the setup as one edit, if there is one.
fn note_change(app: &mut App, row: Row, before: Snapshot) {
    if app.pages.search.setup == before.search {
        return;
    }
    let after = std::mem::replace(&mut app.pages.search.setup, Arc::clone(&before.search));
    let old = app.search_line(row, &app.search_bounds());
    app.pages.search.setup = after;
    let new = app.search_line(row, &app.search_bounds());
    let label = if new.value.is_empty() {
        // The row of a result has no label.
        format!("search: {} -> {}", old.label, new.label)
    } else {
        format!("search: {} {} -> {}", new.label, old.value, new.value)
    };
    edit::note(app, before, label, None);
}

pub(crate) fn change(app: &mut App, row: Row, input: Input<'_>) -> Result<(), String> {
    let bounds = app.search_bounds();
    let unit = app.search_line(row, &bounds).quantity.unwrap_or_default().unit;
    let setup = Arc::make_mut(&mut app.pages.search.setup);
    match (row, input) {
        (Row::Axis(part), _) => {
            let mut axis = setup.seek.clone();
            part.change(&mut axis, (&app.scene, &unit), input, &SCAN)?;
            // Check that the axis can be scanned.
            Axis::from_sweep_axis(&axis, &SCAN).map_err(|error| error.to_string())?;
            setup.seek = axis;
        }
        (Row::Result, _) => {
            let next = quantity_after(setup.goal.0, input)?;
            if next != setup.goal.0 {
                let value = first_goal(app, next);
                Arc::make_mut(&mut app.pages.search.setup).goal = (next, value);
            }
        }
        (Row::Affected, _) => setup.affected = quantity_after(setup.affected, input)?,
        (Row::Output, _) => setup.output = quantity_after(setup.output, input)?,
        (Row::Goal, Input::Text(text)) => {
            let column = named(setup.goal.0).map_err(|error| error.to_string())?;
            setup.goal.1 = column.parse_in(text, &unit)?;
        }
        (Row::Bound(at), _) => {
            let old = bounds.get(at).ok_or("this variable no longer exists")?;
            let new = match input {
                Input::Text(text) => read_bound(old, text, &unit)?,
                Input::Step(_) => Bound { on: !old.on, ..old.clone() },
            };
            setup.bounds.clone_from(&bounds);
            setup.bounds[at] = new;
        }
        (Row::Objective(at), Input::Step(_)) => setup.objectives[at] = !setup.objectives[at],
        (Row::Feasible, Input::Step(_)) => setup.feasible = !setup.feasible,
        (_, Input::Step(_)) => app.report_progress("<enter> types a value here"),
        (_, Input::Text(text)) => read_number(setup, row, text)?,
    }
    Ok(())
}

/// Returns an initial goal: the value of the current run in two digits, if available immediately.
fn first_goal(app: &App, name: &str) -> f64 {
    let run = app.shown.as_ref().filter(|_| !app.shows_old()).map(|shown| &shown.run);
    let quantity = named(name).ok();
    let by_run = quantity.filter(|quantity| quantity.needs() != Needs::Limit);
    let value = by_run.zip(run).and_then(|(quantity, run)| quantity.value(run));
    let is_velocity = quantity.is_some_and(|quantity| quantity.unit() == "m/s");
    let usual = if is_velocity { app.scene.projectile.velocity_m_s } else { 1.0 };
    let value = value.unwrap_or(usual);
    significant(value, 2).parse().unwrap_or(value)
}

fn read_number(setup: &mut Setup, row: Row, text: &str) -> Result<(), String> {
    match row {
        Row::Bounds => {
            let bounds = text.split(',').filter(|_| text != "none");
            let bounds: Result<_, TargetError> =
                bounds.map(Constraint::parse_in_shown_unit).collect();
            setup.subject_to = bounds.map_err(|error| error.to_string())?;
        }
        Row::Designs => setup.designs = whole(text, &DESIGNS)?,
        Row::Percent => {
            let percent = text.trim_end_matches('%').trim().parse().ok();
            let percent = percent.filter(|percent| (1e-3..=100.0).contains(percent));
            let why = || format!("`{text}` must be from 0.001 to 100 %");
            setup.percent = percent.ok_or_else(why)?;
        }
        Row::Samples => setup.samples = whole(text, &SAMPLES)?,
        _ => {}
    }
    Ok(())
}
