//! The Search tab: asking, stepping through designs, editing what is looked for, opening a design.

use std::fmt::Display;
use std::ops::RangeInclusive;
use std::str::FromStr;
use std::sync::Arc;

use crossterm::event::{KeyCode, KeyEvent};
use tui_input::Input;

use super::{edit, input, jobs, table};
use crate::model::results::RESULTS;
use crate::study::quantities::{parse_value, quantity};
use crate::study::search::seek::SCAN;
use crate::tui::app::accuracy::Measuring;
use crate::tui::app::dialog::{Table, wrap};
use crate::tui::app::history::{Edit, Setting};
use crate::tui::app::layout::Body;
use crate::tui::app::notice::Severity;
use crate::tui::app::search::bounds::{bound, read_bound, read_end};
use crate::tui::app::search::setup::Setup;
use crate::tui::app::search::{Found, Page, Row, SearchField};
use crate::tui::app::sweep::numeric;
use crate::tui::app::{App, Tab};
use crate::tui::message::{Action, Effect, Message};
use crate::worker::studies::{Finding, Study, StudyBody, StudyKind};

/// Far along a front, in designs.
const FAR: isize = 10;
/// Steps in a row of the setup that belong to one edit carry this, the page and the row in place of a variable.
const STEPPING: usize = usize::MAX / 2;
/// Steps of numbers that are not typed.
const POPULATIONS: (usize, usize, usize) = (20, 400, 20);
const GENERATIONS: (usize, usize, usize) = (10, 1000, 10);
const SAMPLES: [usize; 7] = [100, 1000, 3000, 10_000, 30_000, 100_000, 1_000_000];

/// The tab is shown: look, unless it has been or is being.
pub(super) fn enter(app: &mut App) -> Vec<Effect> {
    app.searching.field = None;
    let tab = &app.searching;
    let there = tab.shown().is_some() || tab.running.is_some();
    if there { Vec::new() } else { look(app) }
}

/// Whether the tab has its own meaning for an action.
pub(super) fn is_own(app: &App, action: Action) -> bool {
    use Action as A;
    let both =
        matches!(action, A::Run | A::Export | A::FocusNext | A::FocusPrevious | A::SearchNext);
    let setup = matches!(action, A::Edit | A::StepUp | A::StepDown | A::Reset);
    let found = matches!(
        action,
        A::CursorLeft
            | A::CursorRight
            | A::CursorLeftFar
            | A::CursorRightFar
            | A::First
            | A::Last
            | A::OpenDesign
            | A::LogX
            | A::LogY
    );
    both || if app.searching.on_setup { setup } else { found }
}

/// An action the tab has its own meaning for.
pub(super) fn act(app: &mut App, action: Action) -> Vec<Effect> {
    match action {
        Action::Run => return look(app),
        Action::Export => table::open(app, Table::Search),
        Action::FocusNext => focus(app, true),
        Action::FocusPrevious => focus(app, false),
        Action::SearchNext => return turn(app, 1),
        Action::StepUp => return step(app, 1),
        Action::StepDown => return step(app, -1),
        Action::Edit => return open_field(app),
        Action::OpenDesign => return open(app),
        Action::LogX if app.searching.page != Page::Front => {
            app.say(
                Severity::Note,
                "only the chart of the best designs has a scale across to choose",
            );
        }
        Action::LogY if !matches!(app.searching.page, Page::Front | Page::Seek) => {
            app.say(
                Severity::Note,
                "nothing with a scale to choose here: goal seek and best designs have one",
            );
        }
        Action::LogX => app.searching.log.0 = !app.searching.log.0,
        Action::LogY => app.searching.log.1 = !app.searching.log.1,
        Action::First => walk(app, isize::MIN / 2),
        Action::Last => walk(app, isize::MAX / 2),
        Action::CursorLeft => walk(app, -1),
        Action::CursorRight => walk(app, 1),
        Action::CursorLeftFar => walk(app, -FAR),
        Action::CursorRightFar => walk(app, FAR),
        _ => app.say(Severity::Note, "r searches again with what is set up here"),
    }
    Vec::new()
}

/// Another page, which looks at once unless it has something to show.
fn turn(app: &mut App, by: isize) -> Vec<Effect> {
    app.searching.page = app.searching.page.turned(by);
    app.searching.problem = None;
    if app.searching.shown().is_some() { Vec::new() } else { look(app) }
}

/// From what was found to the setup and back: in a circle, by way of the words where these have no room below the chart.
fn focus(app: &mut App, forward: bool) {
    let crowded = app.search_is_crowded();
    let tab = &mut app.searching;
    if tab.on_setup {
        (tab.on_setup, tab.in_words) = (false, !forward);
    } else if crowded && tab.in_words != forward {
        tab.in_words = forward;
    } else {
        tab.on_setup = true;
    }
}

fn walk(app: &mut App, by: isize) {
    let (at, last) = match (app.searching.choices(), app.layout().body) {
        (0, Body::Search(_, area)) => {
            let lines = app.search_lines(usize::from(area.width.saturating_sub(2))).len();
            let below = app.searching.words_height(area.height, lines);
            let hidden = lines.saturating_sub(usize::from(below.saturating_sub(2)));
            (app.searching.scrolled(), if below == 0 { 0 } else { hidden })
        }
        (choices, _) => (app.searching.selected(), choices.saturating_sub(1)),
    };
    let at = at.min(last).saturating_add_signed(by).min(last);
    app.searching.cursor[app.searching.page.place()] = at;
}

fn look(app: &mut App) -> Vec<Effect> {
    let page = app.searching.page;
    let request = match app.search_request(page) {
        Ok(request) => Arc::new(request),
        Err(problem) => {
            app.say(Severity::Error, problem.clone());
            app.searching.problem = Some(problem);
            return Vec::new();
        }
    };
    app.searching.problem = None;
    let id = app.jobs.next_id();
    let scene = Arc::clone(&app.scene);
    app.searching.running =
        Some(Measuring { id, scene: Arc::clone(&scene), points: None, long: false });
    app.searching.asked = Some((page, Arc::clone(&request)));
    let kind = StudyKind::Search(request);
    vec![Effect::Study(Study { id, scene, kind }), Effect::After(jobs::LONG, Message::LongJob(id))]
}

/// Load the design under the cursor and show it in the Run tab.
fn open(app: &mut App) -> Vec<Effect> {
    let Some((scene, label)) = app.search_design() else {
        app.say(Severity::Note, "no design to open here: goal seek and best designs have some");
        return Vec::new();
    };
    app.tab = Tab::Run;
    let effects = edit::commit_scene(app, scene, label, None);
    app.say(
        Severity::Note,
        "this design is the current scene: u undoes, 9 goes back, Space pins it",
    );
    effects
}

/// A report of the search under way.
pub(super) fn report(app: &mut App, body: StudyBody) {
    let (Some(running), Some((page, request))) = (&mut app.searching.running, &app.searching.asked)
    else {
        return;
    };
    let (page, request) = (*page, Arc::clone(request));
    let scene = Arc::clone(&running.scene);
    let keep = |answer| {
        app.searching.found[page.place()] = Some(Found { scene, request, answer });
    };
    match body {
        StudyBody::Part { done, total, part: Finding::Search(part) } => {
            running.points = Some((done, total));
            if let Some(answer) = part {
                keep(answer);
            }
        }
        StudyBody::Ended(Finding::Search(answer)) => {
            if let Some(answer) = answer {
                keep(answer);
            }
            (app.searching.running, app.searching.asked) = (None, None);
        }
        StudyBody::Failed(text) => {
            (app.searching.running, app.searching.asked) = (None, None);
            app.searching.problem = Some(text.clone());
            app.say(Severity::Error, text);
        }
        // Findings of other kinds carry other numbers.
        StudyBody::Part { .. } | StudyBody::Ended(_) => {}
    }
}

/// The next value of the selected row, as one edit with the steps just before.
fn step(app: &mut App, by: isize) -> Vec<Effect> {
    let row = app.search_row();
    app.searching.row = row;
    if row == Row::Page {
        return turn(app, by);
    }
    let before = app.searching.setup.clone();
    change(app, row, by);
    note(app, row, before, true);
    Vec::new()
}

/// Note what was changed in a row of the setup, as one edit; nothing where nothing was.
fn note(app: &mut App, row: Row, before: Setup, stepped: bool) {
    if app.searching.setup == before {
        return;
    }
    let at = app.search_rows().iter().position(|one| *one == row).unwrap_or(0);
    let stepping = stepped.then_some(STEPPING + 100 * app.searching.page.place() + at);
    // Held arrows: from where they began.
    let first = match app.history.edits.last() {
        Some(Edit { stepping: last, setting: Some((Setting::Search(first), _)), .. })
            if stepped && *last == stepping =>
        {
            Setup::clone(first)
        }
        Some(_) | None => before.clone(),
    };
    let after = std::mem::replace(&mut app.searching.setup, first);
    let old = app.search_shown(row);
    app.searching.setup = after.clone();
    let new = app.search_shown(row);
    let label = match (old.1.is_empty(), new.1.is_empty()) {
        // A result stands in the place of its label.
        (true, true) => format!("search: {} -> {}", old.0, new.0),
        (_, _) => format!("search: {} {} -> {}", new.0, old.1, new.1),
    };
    let setting = (Setting::Search(Box::new(before)), Setting::Search(Box::new(after)));
    edit::note_setting(app, setting, label, stepping);
}

fn change(app: &mut App, row: Row, by: isize) {
    let bounds = app.search_bounds();
    let objectives = app.chosen_objectives().len().max(1);
    let setup = &mut app.searching.setup;
    let within = |value: usize, (least, most, each): (usize, usize, usize)| {
        let moved = if by > 0 { value + each } else { value.saturating_sub(each) };
        moved.clamp(least, most)
    };
    let measures = || RESULTS.iter().map(|column| column.name);
    let next = |name: &str| {
        let all: Vec<&'static str> = measures().collect();
        let at = all.iter().position(|other| *other == name).unwrap_or(0);
        all[wrap(at, by, all.len())]
    };
    match row {
        Row::Page => {}
        Row::Name => {
            let names: Vec<&'static str> = numeric().map(|variable| variable.symbol).collect();
            let at = names.iter().position(|name| *name == setup.seek.name).unwrap_or(0);
            if let Ok(chosen) = bound(&app.scene, names[wrap(at, by, names.len())]) {
                setup.seek = chosen;
            }
        }
        Row::Spacing => setup.seek.log = !setup.seek.log,
        Row::Result => {
            setup.goal.0 = next(setup.goal.0);
        }
        Row::Output => setup.output = next(setup.output),
        Row::Bound(at) => {
            setup.bounds = bounds;
            if let Some(bound) = setup.bounds.get_mut(at) {
                bound.on = by > 0;
            }
        }
        Row::Objective(at) => setup.objectives[at] = by > 0,
        Row::Stroke => {
            setup.stroke_m = if by > 0 { Some(setup.stroke_m.unwrap_or(1.0)) } else { None }
        }
        Row::Feasible => setup.feasible = by > 0,
        Row::Population => setup.effort.0 = within(setup.effort.0, POPULATIONS),
        Row::Generations => setup.effort.1 = within(setup.effort.1, GENERATIONS),
        Row::Across => setup.axes.0 = wrap(setup.axes.0.min(objectives - 1), by, objectives),
        Row::Up => setup.axes.1 = wrap(setup.axes.1.min(objectives - 1), by, objectives),
        Row::Percent => {
            setup.percent = (setup.percent + if by > 0 { 0.5 } else { -0.5 }).clamp(0.5, 50.0);
        }
        Row::Samples => {
            let at = SAMPLES.iter().position(|count| *count >= setup.samples).unwrap_or(0);
            setup.samples = SAMPLES[at.saturating_add_signed(by).min(SAMPLES.len() - 1)];
        }
        Row::From | Row::To | Row::Goal | Row::Points | Row::Heading(_) => {
            app.say(Severity::Note, "Enter types a value here");
        }
    }
}

fn open_field(app: &mut App) -> Vec<Effect> {
    let row = app.search_row();
    app.searching.row = row;
    match row {
        Row::Page | Row::Spacing | Row::Across | Row::Up => return step(app, 1),
        Row::Objective(at) => {
            let before = app.searching.setup.clone();
            app.searching.setup.objectives[at] = !before.objectives[at];
            note(app, row, before, false);
        }
        Row::Feasible => {
            let before = app.searching.setup.clone();
            app.searching.setup.feasible = !before.feasible;
            note(app, row, before, false);
        }
        Row::Heading(_) => {}
        _ => {
            let input = Input::new(app.search_text(row));
            app.searching.field = Some(SearchField { row, input, fresh: true, error: None });
        }
    }
    Vec::new()
}

/// A key while a field of the setup is open.
pub(super) fn press(app: &mut App, key: KeyEvent) -> Vec<Effect> {
    match key.code {
        KeyCode::Esc => app.searching.field = None,
        KeyCode::Enter | KeyCode::Down => commit(app, 1),
        KeyCode::Up => commit(app, -1),
        KeyCode::Tab | KeyCode::BackTab => commit(app, 0),
        _ => {
            if let Some(field) = &mut app.searching.field
                && input::press(&mut field.input, &mut field.fresh, key)
            {
                field.error = None;
            }
        }
    }
    Vec::new()
}

/// Take the text and go on; a text that is refused stays, with the reason, and nothing else changes.
fn commit(app: &mut App, then: isize) {
    let Some(field) = app.searching.field.take() else { return };
    let text = field.input.value().trim().to_owned();
    // The bounds of a held variable are a proposal: typed again they are taken.
    let same = text == app.search_text(field.row) && !matches!(field.row, Row::Bound(_));
    let untouched = field.fresh || same;
    let before = app.searching.setup.clone();
    let taken = if untouched { Ok(()) } else { take(app, field.row, &text) };
    match taken {
        Ok(()) => {
            note(app, field.row, before, false);
            app.move_in_search(then);
        }
        Err(error) => app.searching.field = Some(SearchField { error: Some(error), ..field }),
    }
}

/// A whole number in a range.
fn count<T: FromStr + PartialOrd + Display>(
    text: &str,
    allowed: &RangeInclusive<T>,
) -> Result<T, String> {
    let value = text.parse().ok().filter(|value| allowed.contains(value));
    let (least, most) = (allowed.start(), allowed.end());
    value.ok_or_else(|| format!("`{text}` must be a whole number, {least} to {most}"))
}

fn take(app: &mut App, row: Row, text: &str) -> Result<(), String> {
    let scene = Arc::clone(&app.scene);
    let bounds = app.search_bounds();
    let setup = &mut app.searching.setup;
    let name =
        |text: &str| quantity(text).map(|column| column.name).map_err(|error| error.to_string());
    match row {
        Row::Name => setup.seek = bound(&scene, text)?,
        Row::From | Row::To => setup.seek = read_end(&setup.seek, row == Row::From, text)?,
        Row::Points => setup.points = count(text, &SCAN)?,
        Row::Result => setup.goal.0 = name(text)?,
        Row::Goal => {
            let column = quantity(setup.goal.0).map_err(|error| error.to_string())?;
            setup.goal.1 = parse_value(column, text)?;
        }
        Row::Bound(at) => {
            let old = bounds.get(at).ok_or("this variable is not there any more")?;
            let new = read_bound(old, text)?;
            setup.bounds.clone_from(&bounds);
            setup.bounds[at] = new;
        }
        Row::Stroke if text == "none" => setup.stroke_m = None,
        Row::Stroke => {
            let column = quantity("stroke_m").map_err(|error| error.to_string())?;
            let value = parse_value(column, text)?;
            if value <= 0.0 {
                return Err(format!("`{text}` must be greater than 0, or none"));
            }
            setup.stroke_m = Some(value);
        }
        Row::Population => {
            let value = count(text, &(8..=2000))?;
            if value % 2 == 1 {
                return Err(format!("`{text}` must be even"));
            }
            setup.effort.0 = value;
        }
        Row::Generations => setup.effort.1 = count(text, &(1..=100_000))?,
        Row::Output => setup.output = name(text)?,
        Row::Percent => {
            let value = text.trim_end_matches('%').trim().parse::<f64>().ok();
            setup.percent = value
                .filter(|value| *value > 0.0 && *value <= 100.0)
                .ok_or_else(|| format!("`{text}` must be above 0 and at most 100 %"))?;
        }
        Row::Samples => setup.samples = count(text, &(2..=1_000_000))?,
        Row::Page
        | Row::Heading(_)
        | Row::Spacing
        | Row::Objective(_)
        | Row::Feasible
        | Row::Across
        | Row::Up => {}
    }
    Ok(())
}
