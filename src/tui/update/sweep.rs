//! The Sweep and Surface tabs: asking for pictures, moving the cursor (which is the scene), exporting what was found.

use std::sync::Arc;

use crossterm::event::KeyEvent;
use tui_input::Input;

use super::{edit, jobs, path, setup};
use crate::study::sweep::Axis;
use crate::study::sweep::grid::Grid;
use crate::tui::app::dialog::{Dialog, Save};
use crate::tui::app::notice::Severity;
use crate::tui::app::runs::name_of;
use crate::tui::app::sweep::{Computing, Contour, Found, Picture};
use crate::tui::app::{App, Tab};
use crate::tui::message::{Action, Effect, Message, SweepExport};
use crate::worker::sweeps::{SweepBody, SweepJob, SweepReport};

/// Steps of the cursor that belong to one edit carry this in place of a variable.
const CURSOR: usize = usize::MAX;
/// Far along a picture, in points.
const FAR: isize = 10;
/// A sweep that will take longer says so.
const LONG_S: u64 = 60;

/// The picture is computed, unless it is there.
pub(super) fn enter(app: &mut App) -> Vec<Effect> {
    app.sweeping.field = None;
    refresh(app)
}

/// After an edit of the scene: a picture on the screen follows at once.
pub(super) fn after_edit(app: &mut App) -> Vec<Effect> {
    if app.auto_run { refresh(app) } else { Vec::new() }
}

fn refresh(app: &mut App) -> Vec<Effect> {
    let Some(picture) = app.picture() else {
        return Vec::new();
    };
    let plan = app.sweep_plan(picture);
    let wanted = plan.as_ref().ok();
    let coming = app.sweeping.computing.as_ref().map(|it| (it.picture, &*it.plan));
    if coming.is_some_and(|(of, plan)| of == picture && Some(plan) == wanted) {
        return Vec::new();
    }
    let there = app
        .sweeping
        .found(picture)
        .is_some_and(|found| Some(&**found.grid.plan()) == wanted && found.grid.is_complete());
    if there && app.sweeping.computing.is_none() {
        app.sweeping.problem = None;
        return Vec::new();
    }
    if there { Vec::new() } else { compute(app) }
}

/// Compute the picture of the present tab.
pub(super) fn compute(app: &mut App) -> Vec<Effect> {
    let Some(picture) = app.picture() else {
        return Vec::new();
    };
    match app.sweep_plan(picture) {
        Err(error) => {
            app.sweeping.computing = None;
            app.sweeping.problem = Some("these axes cannot be swept".to_owned());
            app.say(Severity::Error, error.to_string());
            vec![Effect::CancelSweep]
        }
        Ok(plan) => {
            app.sweeping.problem = None;
            let id = app.jobs.next_id();
            let plan = Arc::new(plan);
            app.sweeping.computing = Some(Computing {
                id,
                picture,
                plan: Arc::clone(&plan),
                points: None,
                elapsed: std::time::Duration::ZERO,
                long: false,
                warned: false,
            });
            vec![
                Effect::Sweep(SweepJob { id, plan }),
                Effect::After(jobs::LONG, Message::LongJob(id)),
            ]
        }
    }
}

/// Whether the tab has its own meaning for an action.
pub(super) fn is_own(app: &App, action: Action) -> bool {
    let plot = matches!(
        action,
        Action::CursorLeft
            | Action::CursorRight
            | Action::CursorLeftFar
            | Action::CursorRightFar
            | Action::CursorUpFar
            | Action::CursorDownFar
            | Action::Up
            | Action::Down
            | Action::Quantity
            | Action::LogY
            | Action::Contour
            | Action::OpenDesign
    ) || (action == Action::Difference && app.picture() == Some(Picture::Surface));
    let both =
        matches!(action, Action::Run | Action::Export | Action::FocusNext | Action::FocusPrevious);
    both || (plot && !app.sweeping.on_setup) || (app.sweeping.on_setup && setup::is_own(action))
}

/// Whether an action moves the cursor: such steps join into one edit.
pub(super) fn is_step(app: &App, action: Action) -> bool {
    let moves = matches!(
        action,
        Action::CursorLeft
            | Action::CursorRight
            | Action::CursorLeftFar
            | Action::CursorRightFar
            | Action::CursorUpFar
            | Action::CursorDownFar
            | Action::Up
            | Action::Down
    );
    app.picture().is_some() && !app.sweeping.on_setup && moves
}

/// An action the tab has its own meaning for.
pub(super) fn act(app: &mut App, action: Action) -> Vec<Effect> {
    match action {
        Action::Run => return compute(app),
        Action::Export => export(app),
        Action::FocusNext | Action::FocusPrevious => {
            app.sweeping.on_setup = !app.sweeping.on_setup;
        }
        _ if app.sweeping.on_setup => return setup::act(app, action),
        Action::Quantity => app.sweeping.output = next_output(app),
        Action::LogY => app.sweeping.log_values = !app.sweeping.log_values,
        Action::Contour => {
            app.sweeping.contour = match app.sweeping.contour {
                Contour::Cursor => Contour::Off,
                Contour::Off => Contour::Cursor,
            };
        }
        Action::Difference => app.sweeping.residuals = !app.sweeping.residuals,
        Action::OpenDesign => {
            app.tab = Tab::Run;
            app.say(Severity::Note, "this design is the current scene: u undoes, Space pins it");
        }
        _ => return walk(app, action),
    }
    Vec::new()
}

fn next_output(app: &App) -> usize {
    let count = crate::tui::app::sweep::sweep_of(&app.scene).outputs.len().max(1);
    (app.sweeping.output + 1) % count
}

/// Move the cursor: the variables on the axes get the values of the point.
fn walk(app: &mut App, action: Action) -> Vec<Effect> {
    let (x, y) = match action {
        Action::CursorLeft => (-1, 0),
        Action::CursorRight => (1, 0),
        Action::CursorLeftFar => (-FAR, 0),
        Action::CursorRightFar => (FAR, 0),
        Action::Up => (0, 1),
        Action::Down => (0, -1),
        Action::CursorUpFar => (0, FAR),
        _ => (0, -FAR),
    };
    let Some(picture) = app.picture() else {
        return Vec::new();
    };
    let Some(found) = app.sweeping.found(picture) else {
        app.say(Severity::Note, "nothing to move in yet: r sweeps");
        return Vec::new();
    };
    let grid = Arc::clone(&found.grid);
    if !grid.is_full() {
        return walk_along(app, &grid, if x == 0 { y } else { x });
    }
    let at = app.cursor_point(&grid);
    let axes = grid.plan().axes();
    let mut scene = (*app.scene).clone();
    let mut words = Vec::new();
    // On curves only the axis that is walked along snaps to its points; on a surface the cross is the design.
    let steps = [(axes.first(), at.0, x), (axes.get(1), at.1, y)];
    for (axis, at, by) in steps {
        let Some(axis) = axis.filter(|_| by != 0 || picture == Picture::Surface) else { continue };
        let value = stepped(axis, at, by);
        (axis.number().set)(&mut scene, Some(value));
        words.push(format!("{}={}", axis.symbol(), crate::model::units::significant(value, 5)));
    }
    if words.is_empty() || scene == *app.scene {
        return Vec::new();
    }
    edit::commit_scene(app, scene, format!("cursor to {}", words.join(" ")), Some(CURSOR))
}

/// Move through the points of a design in the order of the first axis.
fn walk_along(app: &mut App, grid: &Grid, by: isize) -> Vec<Effect> {
    let mut order: Vec<usize> = (0..grid.counts().0).collect();
    let along = |x: &usize| grid.coordinate((*x, 0), 0);
    order.sort_by(|a, b| along(a).total_cmp(&along(b)));
    let here = app.cursor_point(grid).0;
    let at = order.iter().position(|x| *x == here).unwrap_or(0);
    let next = order[at.saturating_add_signed(by).min(order.len() - 1)];
    let mut scene = (*app.scene).clone();
    let mut words = Vec::new();
    for (place, axis) in grid.plan().axes().iter().enumerate() {
        let value = grid.coordinate((next, 0), place);
        (axis.number().set)(&mut scene, Some(value));
        words.push(format!("{}={}", axis.symbol(), crate::model::units::significant(value, 5)));
    }
    if scene == *app.scene {
        return Vec::new();
    }
    edit::commit_scene(app, scene, format!("cursor to {}", words.join(" ")), Some(CURSOR))
}

/// The value so many points further, stopping at the ends; up and right lead to greater values.
fn stepped(axis: &Axis, at: usize, by: isize) -> f64 {
    let by = if axis.ends().0 < axis.ends().1 { by } else { -by };
    let last = usize::try_from(axis.count() - 1).unwrap_or(usize::MAX);
    let index = at.saturating_add_signed(by).min(last);
    axis.value(u64::try_from(index).unwrap_or(u64::MAX))
}

/// What is said of the sweep under way; reports of replaced ones are dropped.
pub(super) fn report(app: &mut App, report: SweepReport) {
    let Some(computing) = app.sweeping.computing.as_mut().filter(|it| it.id == report.id) else {
        return;
    };
    let picture = computing.picture;
    match report.body {
        SweepBody::Progress { done, total, elapsed } => {
            computing.points = Some((done, total));
            computing.elapsed = elapsed;
        }
        SweepBody::Part { grid, elapsed } => {
            computing.points = Some(grid.progress());
            computing.elapsed = elapsed;
            app.sweeping.show(picture, Found { grid, took: None });
        }
        SweepBody::Ended { grid, took } => {
            app.sweeping.computing = None;
            let stopped = !grid.is_complete();
            app.sweeping.show(picture, Found { grid, took: Some(took) });
            if stopped {
                app.say(Severity::Note, "stopped: what was finished is shown, r sweeps again");
            }
            return;
        }
        SweepBody::Failed(text) => {
            app.sweeping.computing = None;
            app.sweeping.problem = Some("this cannot be swept".to_owned());
            app.say(Severity::Error, text);
            return;
        }
    }
    warn_if_long(app);
}

fn warn_if_long(app: &mut App) {
    let Some(computing) = &mut app.sweeping.computing else { return };
    let Some(left) = computing.left().filter(|left| left.as_secs() >= LONG_S) else { return };
    if computing.warned {
        return;
    }
    computing.warned = true;
    let minutes = left.as_secs().div_ceil(60);
    app.say(
        Severity::Warning,
        format!(
            "this sweep will take about {minutes} min more: Esc stops it and keeps what is finished"
        ),
    );
}

fn export(app: &mut App) {
    let Some(found) = app.picture().and_then(|picture| app.sweeping.found(picture)) else {
        app.say(Severity::Error, "nothing to export yet: r sweeps");
        return;
    };
    let names: Vec<&str> = found.grid.plan().axes().iter().map(Axis::symbol).collect();
    let stem = app.base.name.rsplit('/').next().unwrap_or("scene").trim_end_matches(".toml");
    app.dialog = Some(Dialog::ExportSweep(Save {
        input: Input::new(format!("{stem}-{}.csv", names.join("-"))),
        fresh: false,
        question: false,
        error: None,
    }));
}

/// A key while the dialog for the path is open.
pub(super) fn press(app: &mut App, state: Save, key: KeyEvent) -> Vec<Effect> {
    path::press(app, state, key, write, Dialog::ExportSweep)
}

fn write(app: &App, state: &mut Save, overwrite: bool) -> Vec<Effect> {
    let Some(found) = app.picture().and_then(|picture| app.sweeping.found(picture)) else {
        return Vec::new();
    };
    let Some(path) = path::typed(app, state, "sweep.csv") else { return Vec::new() };
    let name = name_of(found.grid.plan().base(), &app.base.name, &app.base.scene);
    let grid = Arc::clone(&found.grid);
    vec![Effect::ExportSweep(Box::new(SweepExport { path, overwrite, name, grid }))]
}
