//! Explore tab: curves or a map of a quantity over one or two variables.

pub mod cursor;
pub(crate) mod curves;
mod held;
pub mod plan;
pub mod setup;
pub mod state;

use crate::files::export;
use crate::tui::app::notice::with_ends;
use crate::tui::app::show_duration;
use crate::tui::pages::explore::cursor::no_sweep;
use crate::tui::pages::explore::cursor::{
    chart_kind, cursor_point, shown_output, sweep_design, sweep_is_old, sweep_readout,
};
use crate::tui::pages::explore::plan::at_rest;
use crate::tui::pages::explore::plan::{printed_plan, sweep_plan};
use crate::tui::pages::explore::setup::{setup_choices, setup_form, setup_row};
use crate::tui::pages::explore::state::sweep_of;
use crate::tui::pages::page::prelude::*;
use crate::tui::pages::run::runs;
use crate::tui::pages::run::runs::name_of;
use crate::tui::widgets::cycled;
use crate::tui::widgets::form::Form;
use crate::tui::widgets::value_steps::Input;
use crate::tui::widgets::{cursor_moved, moved};
use crate::worker::studies::{PictureSweep, PrintedSweep};
use cmra_engine::model::run::Outcome;
use cmra_studies::report::sweep::{self, Columns};
use cmra_studies::study::sweep::Axis;
use cmra_studies::study::sweep::grid::Grid;

pub use state::{RESULTS, SETUP};

#[rustfmt::skip]
const PANES: &[PaneSpec] = &[
    PaneSpec { pane: RESULTS, label: "Explore", keys: &[
        key(A::Right, "cursor", "move the cursor; the scene stays as it is"),
        key(A::Enter, "load", "load the design under the cursor into the scene (<undo> undoes)"),
        key(A::View, "quantity", "show the next quantity"),
        key(A::Mark, "pin", "pin the design under the cursor"),
        key(A::Down, "curve", "move to another curve, or down the map"),
        key(A::Locate, "value", "type the place of the cursor: n 0.5 k 1MN/m (<back> removes it)"),
    ] },
    PaneSpec { pane: SETUP, label: "Explore setup", keys: &[
        key(A::Enter, "type", "type a variable, an end (0.5, 7.5MN/m), a count or a quantity"),
        key(A::Right, "change", "change the value by a step, or take the next one"),
        key(A::Down, "move", "move to another row"),
    ] },
];

#[rustfmt::skip]
const COMMANDS: &[Command] = &[
    Command::new(CommandTarget::Do(A::Tab(Tab::Explore)), "Explore tab", "sweep surface map family curves parameter study heat map"),
];

pub(crate) struct ExploreTab;

impl Page for ExploreTab {
    fn about(&self) -> About {
        About { pages: &[], panes: PANES, commands: COMMANDS }
    }

    fn enter(&self, app: &mut App) {
        let plan = sweep_plan(app);
        let wanted = plan.as_ref().ok();
        let coming = app.jobs.study::<PictureSweep>().map(|(_, sweep)| sweep);
        if coming.is_some_and(|it| it.picture == chart_kind(app) && Some(&*it.plan) == wanted) {
            return;
        }
        // A study stopped by the user restarts on request only.
        let found = app.pages.explore.found().filter(|_| app.pages.explore.result.is_over());
        if !found.is_some_and(|grid| Some(&**grid.plan()) == wanted) {
            return compute(app, None);
        }
        app.pages.explore.problem = None;
        // The displayed result matches the setup again: cancel the active study, which would replace it.
        stop(app);
    }

    fn edited(&self, app: &mut App) {
        self.enter(app);
    }

    fn act(&self, app: &mut App, action: Action) -> bool {
        match action {
            Action::Run => compute(app, Some(action)),
            Action::Mark => runs::pin_design(app, sweep_design(app)),
            _ if app.pane() == SETUP => return false,
            Action::View => {
                let count = sweep_of(&app.scene).outputs.len();
                app.pages.explore.output = cycled(app.pages.explore.output, 1, count);
            }
            Action::Enter => edit::load_design(app, sweep_design(app)),
            _ => match cursor_moved(action) {
                Some(by) => move_cursor(app, by),
                None => return false,
            },
        }
        true
    }

    fn readout(&self, app: &App, room: usize) -> Option<(Severity, String)> {
        note(sweep_readout(app, room))
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        let found = app.pages.explore.found();
        let computing = app.jobs.running::<PictureSweep>();
        let progress = match (computing, found) {
            (Some(computing), _) => {
                under_way(&format!("sweeping{}", computing.counted("of", " points")))
            }
            _ if sweep_is_old(app) => part(Severity::Warning, old("scene")),
            (None, None) => part(Severity::Note, NO_RESULTS),
            (None, Some(grid)) => {
                let total = grid.progress().1;
                let kept = &app.pages.explore.result;
                match kept.elapsed.filter(|_| kept.is_complete()) {
                    Some(took) => {
                        let took = show_duration(took);
                        part(Severity::Note, format!("{total} points in {took}"))
                    }
                    None => cut(kept, "points"),
                }
            }
        };
        let problem = app.pages.explore.problem.clone().filter(|_| computing.is_none());
        let problem = problem.map(|text| part(Severity::Error, text));
        let mut parts = vec![problem.unwrap_or(progress)];
        if let Some(grid) = found {
            let others = grid.outcomes().each();
            for (word, count) in
                others.filter(|(word, count)| *count > 0 && *word != Outcome::Arrested.word())
            {
                let is_separated = word == Outcome::Separated.word();
                let severity = if is_separated { Severity::Note } else { Severity::Warning };
                parts.push(part(severity, format!("{count} {word}")));
            }
            let output = shown_output(app, grid).0;
            parts.extend(at_rest(grid, output).map(|text| part(Severity::Note, text)));
        }
        let ends = found.map(|grid| grid.outside_at_ends.iter().map(|it| it.0));
        parts.extend(with_ends(app.validity_part(), ends.into_iter().flatten()));
        parts
    }

    fn report(&self, app: &mut App, running: &Running, news: &ReportBody) {
        if PrintedSweep::downcast(&running.request).is_some() {
            let printed = news.found::<Grid>().filter(|answer| answer.reach.is_complete());
            app.pages.explore.printed = printed.map(|answer| answer.report);
            // Show the note until the cursor is moved; then the legend names the curves.
            let found = app.pages.explore.found().filter(|_| app.pages.explore.cursor.is_none());
            let differs = |grid: &Arc<Grid>| {
                !curves::printed(app, grid, shown_output(app, grid).0).is_empty()
            };
            if found.is_some_and(differs) {
                app.report_progress(
                    "faint: the thesis's own scheme, as printed; the others: corrected",
                );
            }
        }
        if PictureSweep::downcast(&running.request).is_none() {
            return;
        }
        let tab = &mut app.pages.explore;
        let before = tab.found().map(|grid| Arc::clone(grid.plan()));
        if tab.result.keep(running, news)
            && let Some(grid) = &tab.result.result
            && before.is_none_or(|plan| plan.axes() != grid.plan().axes())
        {
            // New axes reset the cursor.
            tab.cursor = None;
        }
        match news {
            ReportBody::Failed(_) => {
                app.pages.explore.problem =
                    Some("this cannot be swept: press <run> to see why".to_owned());
            }
            ReportBody::Ended(Some(answer)) if !answer.reach.is_complete() && !running.is_look => {
                app.report_progress(jobs::CANCELLED);
            }
            ReportBody::Progress { .. } | ReportBody::Ended(_) | ReportBody::Part(_) => {}
        }
    }

    fn table(&self, app: &App) -> Option<PageTable> {
        let (grid, kept) = (app.pages.explore.found()?, &app.pages.explore.result);
        let plan = grid.plan();
        let names: Vec<&str> = plan.axes().iter().map(Axis::symbol).collect();
        let sweep = Some(Columns::Chosen.sweep(plan));
        let scene = Arc::new(Scene { sweep, ..Scene::clone(&kept.scene) });
        let (reach, (done, total)) = (kept.reach, grid.progress());
        let is_part = !reach.is_complete();
        let missing = is_part.then(|| format!("not complete: {done} of {total} points"));
        let notes = export::sweep_notes(plan, missing.as_deref());
        let (name, grid) = (name_of(app, &scene), Arc::clone(grid));
        let csv = move |reach| sweep::grid_csv(&name, &grid, reach);
        let table = PageTable::new("Export the sweep to CSV", names.join("-"), reach, csv);
        Some(table.for_scene(app, &scene, "sweep").noted(notes))
    }

    fn form(&self, app: &App) -> Option<Form> {
        (app.pane() == SETUP).then(|| setup_form(app))
    }

    fn select(&self, app: &mut App, row: usize) {
        match app.pane() {
            SETUP => app.pages.explore.row = setup_choices(app)[row],
            _ => app.pages.explore.output = row,
        }
    }

    fn change(&self, app: &mut App, input: Input<'_>) -> Result<(), String> {
        setup::change(app, setup_row(app), input)
    }

    fn go_to_cell(&self, app: &mut App, cell: (usize, usize)) {
        app.pages.explore.cursor = Some(cell);
    }

    fn places(&self, app: &App) -> Vec<(String, String)> {
        let grid = app.pages.explore.found().filter(|_| app.pane() == RESULTS);
        cursor::places_of(app, grid.into_iter().flat_map(|grid| grid.plan().axes()))
    }

    fn go_to_place(&self, app: &mut App, text: &str) -> Result<(), String> {
        app.pages.explore.cursor = Some(cursor::place(app, text)?);
        Ok(())
    }

    fn remove_cursor(&self, app: &mut App) -> bool {
        app.pane() == RESULTS && app.pages.explore.cursor.take().is_some()
    }

    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>) {
        curves::render(app, body, canvas);
    }
}

/// Cancels the active sweep; a long one continues until a key cancels it.
fn stop(app: &mut App) {
    let id = app.jobs.running::<PictureSweep>().map(|job| job.id);
    if let Some(id) = id.filter(|id| !app.jobs.is_long(*id)) {
        app.jobs.forget(id);
        app.request(Effect::Cancel(id));
    }
}

/// Computes the sweep, on request or within the time limit of a page that is shown.
fn compute(app: &mut App, by: Option<Action>) {
    match sweep_plan(app) {
        Err(error) => {
            stop(app);
            app.pages.explore.problem =
                Some("these axes cannot be swept: press <run> to see why".to_owned());
            app.refuse(error.to_string());
        }
        Ok(plan) => {
            app.pages.explore.problem = None;
            let sweep = PictureSweep { picture: chart_kind(app), plan: Arc::new(plan) };
            app.pages.explore.printed = None;
            let printed = printed_plan(app).map(|plan| PrintedSweep(Arc::new(plan)));
            if let Some(action) = by {
                jobs::study(app, action, sweep);
                // If a confirmation keeps a long sweep, keep its other curves, too.
                if let Some(printed) = printed.filter(|_| app.jobs.awaiting_confirmation.is_none())
                {
                    jobs::study(app, action, printed);
                }
            } else {
                jobs::look(app, jobs::LOOK / (1 + u32::from(printed.is_some())), sweep);
                if let Some(printed) = printed {
                    jobs::look(app, jobs::LOOK / 2, printed);
                }
            }
        }
    }
}

/// Moves the cursor by points; the scene is unchanged.
fn move_cursor(app: &mut App, (x, y): (isize, isize)) {
    let Some(grid) = app.pages.explore.found().cloned() else {
        return app.report_progress(no_sweep(app));
    };
    let at = cursor_point(app, &grid);
    // Right and up lead to larger values, also on a descending axis.
    let upward = |by: isize, axis: Option<&Axis>| {
        if axis.is_some_and(|axis| axis.ends().0 > axis.ends().1) { -by } else { by }
    };
    let axes = grid.plan().axes();
    let next = moved(at, (upward(x, axes.first()), upward(y, axes.get(1))), grid.counts());
    app.pages.explore.cursor = Some(next);
}
