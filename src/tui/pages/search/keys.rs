//! The Search tab: searching, moving through designs, editing the setup, loading a design.

use std::sync::Arc;

use crate::model::scene::SweepAxis;
use crate::study::quantities::named;
use crate::study::search::seek::SCAN;
use crate::study::sweep::Axis;
use crate::tui::app::App;
use crate::tui::app::find::quantity_called;
use crate::tui::app::history::{Change, Setting};
use crate::tui::app::jobs::{News, Running};
use crate::tui::app::notice::Severity;
use crate::tui::dialogs::wrap;
use crate::tui::keymap::Action;
use crate::tui::message::Effect;
use crate::tui::pages::Tab;
use crate::tui::pages::run::runs;
use crate::tui::pages::run::steps::Press;
use crate::tui::pages::search;
use crate::tui::pages::search::SETUP;
use crate::tui::pages::search::bounds::read_bound;
use crate::tui::pages::search::request::Request;
use crate::tui::pages::search::setup::Setup;
use crate::tui::pages::search::state;
use crate::tui::pages::search::state::{Page, Row};
use crate::tui::update::act::move_by;
use crate::tui::update::{edit, jobs};
use crate::tui::widgets::axis::whole;
use crate::tui::widgets::form::quantity_beside;

/// Far along a front, in designs.
const FAR: isize = 10;
/// Steps in a row of the setup that belong to one edit carry this, the page and the row in place of a variable.
const STEPPING: usize = usize::MAX / 2;
/// Steps of numbers that are not typed.
const POPULATIONS: (usize, usize, usize) = (20, 400, 20);
const GENERATIONS: (usize, usize, usize) = (10, 1000, 10);
const SAMPLES: [usize; 7] = [100, 1000, 3000, 10_000, 30_000, 100_000, 1_000_000];

/// The tab is shown: search, unless there are results or a search is running.
pub(in crate::tui) fn enter(app: &mut App) -> Vec<Effect> {
    let tab = &app.pages.search;
    let there = tab.shown().is_some() || app.jobs.running::<Request>().is_some();
    if there { Vec::new() } else { look(app) }
}

/// What an action does here; `None` where it means nothing of its own.
pub(in crate::tui) fn act(app: &mut App, action: Action) -> Option<Vec<Effect>> {
    match action {
        Action::Run => return Some(look(app)),
        Action::Export | Action::Copy => return None,
        _ if app.pane() == SETUP => return None,
        Action::Enter => return Some(edit::load_design(app, app.search_design())),
        Action::Mark => return Some(runs::keys::pin_design(app, app.search_design())),
        Action::View => return Some(view(app)),
        Action::Sort => app.pages.search.sort_next(),
        Action::LogX if app.pages.search.page != Page::Front => {
            app.say(
                Severity::Note,
                "only the chart of the Pareto front has a scale across to choose",
            );
        }
        Action::LogY if !matches!(app.pages.search.page, Page::Front | Page::Seek) => {
            app.say(
                Severity::Note,
                "no scale to choose here: goal seek and the Pareto front have one",
            );
        }
        Action::LogX => app.pages.search.log.0 = !app.pages.search.log.0,
        Action::LogY => app.pages.search.log.1 = !app.pages.search.log.1,
        _ => {
            let by = match action {
                Action::Left => -1,
                Action::Right => 1,
                Action::FarLeft => -FAR,
                Action::FarRight => FAR,
                _ => return None,
            };
            move_by(app, by);
        }
    }
    Some(Vec::new())
}

/// Another page, which searches at once unless it has something to show.
pub(in crate::tui) fn turn_to(app: &mut App, page: usize) -> Vec<Effect> {
    app.pages.search.page = Page::ALL[page.min(Page::ALL.len() - 1)];
    app.pages.search.problem = None;
    app.field = None;
    app.pages.search.row = app.search_row();
    if app.pages.search.shown().is_some() { Vec::new() } else { look(app) }
}

/// The next pair of objectives on the axes of a front.
fn view(app: &mut App) -> Vec<Effect> {
    if app.pages.search.page != Page::Front {
        app.say(Severity::Note, "one view here: only the Pareto front has axes to choose");
        return Vec::new();
    }
    let count = app.chosen_objectives().len();
    let before = app.pages.search.setup.clone();
    let setup = &mut app.pages.search.setup;
    let (across, up) = setup.axes;
    setup.axes = if up + 1 < count { (across, up + 1) } else { (across + 1, across + 2) };
    if setup.axes.1 >= count {
        setup.axes = (0, 1.min(count.saturating_sub(1)));
    }
    app.pages.search.zoomed = None;
    note(app, Row::Up, before, false);
    Vec::new()
}

/// Lines of the words that have no room; none where the chart stands alone.
pub(in crate::tui) fn hidden_lines(app: &App) -> usize {
    let Some(body) = app.layout().body else { return 0 };
    let (_, area) = search::panes(app, body);
    let lines = app.search_lines(usize::from(area.width.saturating_sub(2))).len();
    match app.pages.search.words_height(area.height, lines) {
        0 => 0,
        below => lines.saturating_sub(usize::from(below.saturating_sub(2))),
    }
}

fn look(app: &mut App) -> Vec<Effect> {
    let page = app.pages.search.page;
    let request = match app.search_request(page) {
        Ok(request) => request,
        Err(problem) => {
            app.say(Severity::Error, problem.clone());
            app.pages.search.problem = Some(problem);
            return Vec::new();
        }
    };
    app.pages.search.problem = None;
    let scene = Arc::clone(&app.scene);
    jobs::study(app, Tab::Search, &scene, request)
}

/// News of the search.
pub(in crate::tui) fn report(app: &mut App, running: &Running, news: &News) {
    if matches!(news, News::Failed) {
        app.pages.search.problem = app.notice.as_ref().map(|notice| notice.text.clone());
    }
    if let (Some(request), Some(answer)) = (running.study.of::<Request>(), news.found()) {
        let (scene, request) = (Arc::clone(&running.scene), request.clone());
        let page = request.page().index();
        app.pages.search.found[page] = Some(state::Found { scene, request, answer });
    }
}

/// The next value of a row of the setup, as one edit with the steps just before.
///
/// # Errors
/// Why there is none.
pub(in crate::tui) fn step(app: &mut App, row: Row, press: Press) -> Result<Vec<Effect>, String> {
    let before = app.pages.search.setup.clone();
    change(app, row, press)?;
    note(app, row, before, true);
    Ok(after_edit(app))
}

/// After an edit of the setup: a search that takes less than a second follows at once.
fn after_edit(app: &mut App) -> Vec<Effect> {
    let quick = app.pages.search.page == Page::Seek && app.auto_run;
    if quick && app.search_is_old() { look(app) } else { Vec::new() }
}

/// Note what was changed in a row of the setup, as one edit; nothing where nothing was.
fn note(app: &mut App, row: Row, before: Setup, stepped: bool) {
    if app.pages.search.setup == before {
        return;
    }
    let at = app.search_rows().iter().position(|one| *one == row).unwrap_or(0);
    let stepping = stepped.then_some(STEPPING + 100 * app.pages.search.page.index() + at);
    // Held arrows: from where they began.
    let first = match app.history.extended(stepping) {
        Some(Change::Setting(Setting::Search(first), _)) => Setup::clone(first),
        _ => before.clone(),
    };
    let after = std::mem::replace(&mut app.pages.search.setup, first);
    let old = app.search_line(row, &app.search_bounds());
    app.pages.search.setup = after.clone();
    let new = app.search_line(row, &app.search_bounds());
    let label = if new.value.is_empty() {
        // A result stands in the place of its label.
        format!("search: {} -> {}", old.label, new.label)
    } else {
        format!("search: {} {} -> {}", new.label, old.value, new.value)
    };
    let setting = (Setting::Search(Box::new(before)), Setting::Search(Box::new(after)));
    edit::note_setting(app, setting, label, stepping);
}

fn change(app: &mut App, row: Row, press: Press) -> Result<(), String> {
    let bounds = app.search_bounds();
    let objectives = app.chosen_objectives().len().max(1);
    let setup = &mut app.pages.search.setup;
    let (up, by) = (press.up, press.by());
    let within = |value: usize, (least, most, each): (usize, usize, usize)| {
        let moved = if up { value + each } else { value.saturating_sub(each) };
        moved.clamp(least, most)
    };
    let objective = |at: usize| wrap(at.min(objectives - 1), by, objectives);
    match row {
        Row::Axis(part) => {
            let mut axis = setup.seek.clone();
            part.step(&mut axis, &app.scene, press)?;
            setup.seek = checked(axis)?;
        }
        Row::Result => setup.goal.0 = quantity_beside(setup.goal.0, by),
        Row::Output => setup.output = quantity_beside(setup.output, by),
        Row::Bound(at) => {
            setup.bounds = bounds;
            if let Some(bound) = setup.bounds.get_mut(at) {
                bound.on = !bound.on;
            }
        }
        Row::Objective(at) => setup.objectives[at] = !setup.objectives[at],
        Row::Stroke => setup.stroke_m = up.then(|| setup.stroke_m.unwrap_or(1.0)),
        Row::Feasible => setup.feasible = !setup.feasible,
        Row::Population => setup.effort.0 = within(setup.effort.0, POPULATIONS),
        Row::Generations => setup.effort.1 = within(setup.effort.1, GENERATIONS),
        Row::Across => setup.axes.0 = objective(setup.axes.0),
        Row::Up => setup.axes.1 = objective(setup.axes.1),
        Row::Percent => {
            setup.percent = (setup.percent + if up { 0.5 } else { -0.5 }).clamp(0.5, 50.0);
        }
        Row::Samples => {
            let at = SAMPLES.iter().position(|count| *count >= setup.samples).unwrap_or(0);
            setup.samples = SAMPLES[at.saturating_add_signed(by).min(SAMPLES.len() - 1)];
        }
        Row::Goal => app.say(Severity::Note, "Enter types a value here"),
        Row::Heading(_) => {}
    }
    Ok(())
}

/// The axis of a scan, where there can be one.
fn checked(axis: SweepAxis) -> Result<SweepAxis, String> {
    Axis::of(&axis, &SCAN).map(|_| axis).map_err(|error| error.to_string())
}

/// Take what was typed into the field of the selected row.
///
/// # Errors
/// Why it is refused.
pub(in crate::tui) fn take(app: &mut App, row: Row, text: &str) -> Result<Vec<Effect>, String> {
    let before = app.pages.search.setup.clone();
    read(app, row, text)?;
    note(app, row, before, false);
    Ok(after_edit(app))
}

fn read(app: &mut App, row: Row, text: &str) -> Result<(), String> {
    let scene = Arc::clone(&app.scene);
    let bounds = app.search_bounds();
    let setup = &mut app.pages.search.setup;
    let name = |text: &str| quantity_called(text).map(|column| column.name);
    match row {
        Row::Axis(part) => {
            let mut axis = setup.seek.clone();
            part.read(&mut axis, &scene, text, &SCAN)?;
            setup.seek = checked(axis)?;
        }
        Row::Result => setup.goal.0 = name(text)?,
        Row::Goal => {
            let column = named(setup.goal.0).map_err(|error| error.to_string())?;
            setup.goal.1 = column.parse(text)?;
        }
        Row::Bound(at) => {
            let old = bounds.get(at).ok_or("this variable is not there any more")?;
            let new = read_bound(old, text)?;
            setup.bounds.clone_from(&bounds);
            setup.bounds[at] = new;
        }
        Row::Stroke if text == "none" => setup.stroke_m = None,
        Row::Stroke => {
            let column = named("stroke_m").map_err(|error| error.to_string())?;
            let value = column.parse(text)?;
            if value <= 0.0 {
                return Err(format!("`{text}` must be greater than 0, or none"));
            }
            setup.stroke_m = Some(value);
        }
        Row::Population => {
            let value = whole(text, &(8..=2000))?;
            if value % 2 == 1 {
                return Err(format!("`{text}` must be even"));
            }
            setup.effort.0 = value;
        }
        Row::Generations => setup.effort.1 = whole(text, &(1..=100_000))?,
        Row::Output => setup.output = name(text)?,
        Row::Percent => {
            let value = text.trim_end_matches('%').trim().parse::<f64>().ok();
            setup.percent = value
                .filter(|value| *value > 0.0 && *value <= 100.0)
                .ok_or_else(|| format!("`{text}` must be above 0 and at most 100 %"))?;
        }
        Row::Samples => setup.samples = whole(text, &(2..=1_000_000))?,
        Row::Heading(_) | Row::Objective(_) | Row::Feasible | Row::Across | Row::Up => {}
    }
    Ok(())
}
