//! The Explore tab: asking for sweeps, moving the cursor, loading the design under it.

use std::sync::Arc;

use crate::numerics::statistics::ascending;
use crate::study::sweep::Axis;
use crate::study::sweep::grid::Grid;
use crate::tui::app::App;
use crate::tui::app::jobs::{News, Running};
use crate::tui::app::notice::Severity;
use crate::tui::keymap::Action;
use crate::tui::message::Effect;
use crate::tui::pages::Tab;
use crate::tui::pages::explore::SETUP;
use crate::tui::pages::explore::plan::PictureSweep;
use crate::tui::pages::explore::setup;
use crate::tui::pages::explore::state::{Contour, Found, Picture};
use crate::tui::pages::run::runs;
use crate::tui::pages::run::runs::engineering;
use crate::tui::update::act::cursor_moved;
use crate::tui::update::{edit, jobs};

/// Far along a picture, in points.
const FAR: isize = 10;
/// A sweep that will take longer says so.
const LONG_S: u64 = 60;

/// After an edit of the scene: a picture on the screen follows at once.
pub(in crate::tui) fn after_edit(app: &mut App) -> Vec<Effect> {
    let shown = app.tab == Tab::Explore;
    if app.auto_run && shown { enter(app) } else { Vec::new() }
}

/// The picture is computed, unless it is there.
pub(in crate::tui) fn enter(app: &mut App) -> Vec<Effect> {
    let picture = app.picture();
    let plan = app.sweep_plan(picture);
    let wanted = plan.as_ref().ok();
    let coming = app.jobs.study::<PictureSweep>().map(|(_, sweep)| sweep);
    if coming.is_some_and(|it| it.picture == picture && Some(&*it.plan) == wanted) {
        return Vec::new();
    }
    let there = app
        .pages
        .explore
        .found(picture)
        .is_some_and(|found| Some(&**found.grid.plan()) == wanted && found.grid.is_complete());
    if !there {
        return compute(app);
    }
    app.pages.explore.problem = None;
    if coming.is_none_or(|it| it.picture != picture) {
        return Vec::new();
    }
    // The setup is again what is shown: what was asked for meanwhile would replace it.
    let before = app.jobs.take::<PictureSweep>();
    before.map(|job| Effect::Cancel(job.id)).into_iter().collect()
}

/// Compute what Explore shows.
pub(in crate::tui) fn compute(app: &mut App) -> Vec<Effect> {
    let picture = app.picture();
    if let Some(horizon_s) = app.scene.run.horizon_s {
        let horizon = engineering(horizon_s, "s");
        app.say(
            Severity::Warning,
            format!("horizon is set by hand: every point is simulated to {horizon}, which takes long; `auto` stops at the result"),
        );
    }
    match app.sweep_plan(picture) {
        Err(error) => {
            let before = app.jobs.take::<PictureSweep>();
            app.pages.explore.problem =
                Some("these axes cannot be swept: press r to see why".to_owned());
            app.say(Severity::Error, error.to_string());
            before.map(|job| Effect::Cancel(job.id)).into_iter().collect()
        }
        Ok(plan) => {
            app.pages.explore.problem = None;
            let scene = Arc::clone(&app.scene);
            let sweep = PictureSweep { picture, plan: Arc::new(plan) };
            jobs::study(app, Tab::Explore, &scene, sweep)
        }
    }
}

/// What an action does here; `None` where it means nothing of its own.
pub(in crate::tui) fn act(app: &mut App, action: Action) -> Option<Vec<Effect>> {
    match action {
        Action::Run => return Some(compute(app)),
        Action::Export | Action::Copy => return None,
        Action::Mark => return Some(runs::keys::pin_design(app, app.sweep_design())),
        Action::Contour => {
            app.pages.explore.contour = match app.pages.explore.contour {
                Contour::Cursor => Contour::Off,
                Contour::Off => Contour::Cursor,
            };
            return Some(Vec::new());
        }
        Action::FitResiduals => {
            app.pages.explore.residuals = !app.pages.explore.residuals;
            return Some(Vec::new());
        }
        _ if app.pane() == SETUP => return setup::keys::act(app, action),
        Action::View => app.pages.explore.output = next_output(app),
        Action::LogY => app.pages.explore.log_values = !app.pages.explore.log_values,
        Action::LogX => return Some(setup::keys::toggle_spacing(app)),
        Action::ZoomIn | Action::ZoomOut | Action::PanLeft | Action::PanRight
            if app.picture() == Picture::Surface =>
        {
            app.say(Severity::Note, "a map shows all of its axes: change their ends in the setup");
        }
        Action::Enter => return Some(edit::load_design(app, app.sweep_design())),
        _ => move_cursor(app, cursor_moved(action, FAR)?),
    }
    Some(Vec::new())
}

fn next_output(app: &App) -> usize {
    let count = crate::tui::pages::explore::state::sweep_of(&app.scene).outputs.len().max(1);
    (app.pages.explore.output + 1) % count
}

/// Move the cursor by points; the scene stays as it is.
fn move_cursor(app: &mut App, (x, y): (isize, isize)) {
    let picture = app.picture();
    let Some(found) = app.pages.explore.found(picture) else {
        app.say(Severity::Note, "no results yet: press r to sweep");
        return;
    };
    let grid = Arc::clone(&found.grid);
    let at = app.cursor_point(&grid);
    let next = if grid.is_full() {
        let (across, up) = grid.counts();
        let axes = grid.plan().axes();
        let moved = |at: usize, by: isize, count: usize, axis: Option<&Axis>| {
            // Right and up lead to greater values, also on an axis that runs downward.
            let down = axis.is_some_and(|axis| axis.ends().0 > axis.ends().1);
            at.saturating_add_signed(if down { -by } else { by }).min(count - 1)
        };
        (moved(at.0, x, across, axes.first()), moved(at.1, y, up, axes.get(1)))
    } else {
        let upward = x == 0 && picture == Picture::Surface;
        (neighbour(&grid, at.0, usize::from(upward), x + y), 0)
    };
    app.pages.explore.cursor[picture as usize] = Some(next);
}

/// Another point of a design, in the order of one of its axes.
fn neighbour(grid: &Grid, here: usize, axis: usize, by: isize) -> usize {
    let axis = axis.min(grid.plan().axes().len() - 1);
    let along = (0..grid.counts().0).map(|x| grid.coordinate((x, 0), axis));
    let order = ascending(&along.collect::<Vec<f64>>());
    let at = order.iter().position(|x| *x == here).unwrap_or(0);
    order[at.saturating_add_signed(by).min(order.len() - 1)]
}

/// News of the sweep.
pub(in crate::tui) fn report(app: &mut App, running: &Running, news: &News) {
    let Some(sweep) = running.study.of::<PictureSweep>() else { return };
    match (news, news.found::<Grid>()) {
        (News::Failed, _) => {
            app.pages.explore.problem = Some("this cannot be swept: press r to see why".to_owned());
        }
        (News::Ended(_, took), Some(grid)) => {
            if !grid.is_complete() {
                let text = "Cancelled. Partial results are shown; press r to sweep again.";
                app.say(Severity::Note, text);
            }
            app.pages.explore.show(sweep.picture, Found { grid, took: Some(*took) });
        }
        (_, Some(grid)) => app.pages.explore.show(sweep.picture, Found { grid, took: None }),
        (_, None) => warn_if_long(app, running),
    }
}

fn warn_if_long(app: &mut App, running: &Running) {
    let left = running.left().map_or(0, |left| left.as_secs());
    if left < LONG_S || app.pages.explore.warned == Some(running.id) {
        return;
    }
    app.pages.explore.warned = Some(running.id);
    let minutes = left.div_ceil(60);
    app.say(
        Severity::Warning,
        format!(
            "this sweep will take about {minutes} min more: Esc stops it and keeps what is finished"
        ),
    );
}
