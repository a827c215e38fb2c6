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
            app.sweeping.problem = Some("these axes cannot be swept: r says why".to_owned());
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
    let both =
        matches!(action, Action::Run | Action::Export | Action::FocusNext | Action::FocusPrevious);
    if both || app.sweeping.on_setup {
        return both || setup::is_own(action);
    }
    let surface = app.picture() == Some(Picture::Surface);
    moved(action).is_some()
        || matches!(action, Action::Quantity | Action::LogY | Action::Contour | Action::OpenDesign)
        || (action == Action::Difference && surface)
}

/// Whether an action moves the cursor: such steps join into one edit.
pub(super) fn is_step(app: &App, action: Action) -> bool {
    app.picture().is_some() && !app.sweeping.on_setup && moved(action).is_some()
}

/// How many points along and up an action moves the cursor.
fn moved(action: Action) -> Option<(isize, isize)> {
    match action {
        Action::CursorLeft => Some((-1, 0)),
        Action::CursorRight => Some((1, 0)),
        Action::CursorLeftFar => Some((-FAR, 0)),
        Action::CursorRightFar => Some((FAR, 0)),
        Action::Up => Some((0, 1)),
        Action::Down => Some((0, -1)),
        Action::CursorUpFar => Some((0, FAR)),
        Action::CursorDownFar => Some((0, -FAR)),
        _ => None,
    }
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
    let (Some((x, y)), Some(picture)) = (moved(action), app.picture()) else {
        return Vec::new();
    };
    let Some(found) = app.sweeping.found(picture) else {
        app.say(Severity::Note, "nothing to move in yet: r sweeps");
        return Vec::new();
    };
    let grid = Arc::clone(&found.grid);
    if !grid.is_full() {
        let upward = x == 0 && picture == Picture::Surface;
        return to_neighbour(app, &grid, usize::from(upward), x + y);
    }
    let at = app.cursor_point(&grid);
    let axes = grid.plan().axes();
    // On curves only the axis that is walked along snaps to its points; on a surface the cross is the design.
    let steps = axes.iter().zip([(at.0, x), (at.1, y)]);
    let steps = steps.filter(|(_, (_, by))| *by != 0 || picture == Picture::Surface);
    let values: Vec<(&Axis, f64)> =
        steps.map(|(axis, (at, by))| (axis, stepped(axis, at, by))).collect();
    cursor_to(app, &values)
}

/// Move to another point of a design, in the order of one of its axes.
fn to_neighbour(app: &mut App, grid: &Grid, axis: usize, by: isize) -> Vec<Effect> {
    let mut order: Vec<usize> = (0..grid.counts().0).collect();
    let axis = axis.min(grid.plan().axes().len() - 1);
    let along = |x: &usize| grid.coordinate((*x, 0), axis);
    order.sort_by(|a, b| along(a).total_cmp(&along(b)));
    let here = app.cursor_point(grid).0;
    let at = order.iter().position(|x| *x == here).unwrap_or(0);
    cursor_to_point(app, grid, (order[at.saturating_add_signed(by).min(order.len() - 1)], 0))
}

/// The design of a point of the picture shown becomes the scene.
pub(super) fn jump(app: &mut App, point: (usize, usize)) -> Vec<Effect> {
    let found = app.picture().and_then(|picture| app.sweeping.found(picture));
    let Some(grid) = found.map(|found| Arc::clone(&found.grid)) else {
        return Vec::new();
    };
    let along = app.picture() == Some(Picture::Line) && grid.is_full();
    if !along {
        return cursor_to_point(app, &grid, point);
    }
    let axes: Vec<(&Axis, f64)> =
        grid.plan().axes().iter().take(1).map(|axis| (axis, grid.coordinate(point, 0))).collect();
    cursor_to(app, &axes)
}

fn cursor_to_point(app: &mut App, grid: &Grid, point: (usize, usize)) -> Vec<Effect> {
    let axes = grid.plan().axes().iter().enumerate();
    let values: Vec<(&Axis, f64)> =
        axes.map(|(place, axis)| (axis, grid.coordinate(point, place))).collect();
    cursor_to(app, &values)
}

/// The variables on axes get these values.
fn cursor_to(app: &mut App, values: &[(&Axis, f64)]) -> Vec<Effect> {
    let mut scene = (*app.scene).clone();
    let mut words = Vec::new();
    for (axis, value) in values {
        (axis.number().set)(&mut scene, Some(*value));
        words.push(format!("{}={}", axis.symbol(), crate::model::units::significant(*value, 5)));
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
            app.sweeping.problem = Some("this cannot be swept: r says why".to_owned());
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
    let name = format!("{}-{}.csv", path::base_stem(app), names.join("-"));
    app.dialog = Some(Dialog::ExportSweep(Save {
        input: Input::new(name),
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
