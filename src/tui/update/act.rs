//! Handles an action: first by the page shown, then by its meaning on every page.

use crate::tui::app::{ActiveInput, Settings, edit};
use crate::tui::dialogs;
use crate::tui::keymap::CommandTarget;
use crate::tui::message::Content;
use crate::tui::pages::run::{self, VARIABLES, runs};
use crate::tui::pages::{self, move_by};
use crate::tui::prelude::*;
use crate::tui::update;
use crate::tui::widgets::input::TextField;
use crate::tui::widgets::table::NO_MATCH;
use crate::tui::widgets::value_steps::{Input, StepKey};
use crate::tui::widgets::{around, cycled, rows_moved, step_of};

/// Performs an action in the focused pane.
pub(crate) fn act(app: &mut App, action: Action) {
    if app.jobs.awaiting_confirmation != Some(action) {
        app.jobs.awaiting_confirmation = None;
    }
    // Steps of a variable are merged into one edit.
    if step_of(action).is_none() || app.pane() != VARIABLES {
        app.history.commit();
        app.pages.run.editor.stepped = None;
    }
    let page = pages::page(app.tab);
    let acts_on_rows = step_of(action).is_some()
        || matches!(action, Action::Enter | Action::Mark | Action::Reset | Action::Copy);
    if acts_on_rows && update::matches_nothing(app) {
        return app.report_progress(NO_MATCH);
    }
    if action == Action::Enter && run::lists_words(app) {
        return dialogs::list_words(app);
    }
    if page.act(app, action) || in_form(app, action) {
        return;
    }
    if let Some(rows) = page.rows(app)
        && let Some(by) = rows_moved(action, rows.shown)
    {
        return move_by(app, by);
    }
    anywhere(app, action);
}

/// Applies an action to the selected row of a form: takes the next value, or opens its field.
fn in_form(app: &mut App, action: Action) -> bool {
    let page = pages::page(app.tab);
    let enters = action == Action::Enter;
    let press = if enters { Some(StepKey::NEXT) } else { step_of(action) };
    let Some((form, press)) = page.form(app).zip(press) else { return false };
    let row = form.rows(0).selected;
    page.select(app, row);
    if enters && form.line().is_some_and(|line| line.text.is_some()) {
        pages::open_field(app);
    } else if let Err(why) = page.change(app, Input::Step(press)) {
        app.refuse(why);
    }
    true
}

/// Applies an action for which the page has no meaning of its own.
fn anywhere(app: &mut App, action: Action) {
    use Action as A;
    if dialogs::open(app, action) {
        return;
    }
    match action {
        A::Tab(tab) => go_to(app, tab),
        A::Locate => locate(app),
        A::FocusNext => focus(app, 1),
        A::FocusPrevious => focus(app, -1),
        A::Find => update::open_find(app),
        A::Undo => edit::undo(app),
        A::Redo => edit::redo(app),
        A::ResetAll => edit::reset_all(app),
        A::Copy if app.shows_runs() => runs::copy(app),
        A::Copy => copy(app),
        A::Cancel | A::Back | A::Quit => leave(app, action),
        A::Redraw => app.request(Effect::Redraw),
        A::Suspend => app.request(Effect::Suspend),
        A::Characters | A::Colours | A::Mouse => change_setting(app, action),
        _ => {
            let label = app.keymap.label(action);
            does_nothing(app, &label);
        }
    }
}

/// Opens the field of the crosshair position.
fn locate(app: &mut App) {
    if pages::page(app.tab).places(app).is_empty() {
        return app.report_progress(pages::nothing_yet(app, "point at"));
    }
    app.typing = Some(ActiveInput::Place(TextField::default()));
}

/// Reports that a key has no effect here.
pub(crate) fn does_nothing(app: &mut App, label: &str) {
    app.report_progress(format!("`{label}` does nothing here: <help> lists the keys"));
}

/// Changes a setting to its next value.
fn change_setting(app: &mut App, action: Action) {
    let Settings { theme, mouse } = &mut app.settings;
    let text = match action {
        Action::Characters => {
            theme.glyphs = theme.glyphs.next();
            format!("characters: {}", theme.glyphs)
        }
        Action::Colours => {
            theme.depth = theme.depth.next();
            format!("colours: {}", theme.depth.word())
        }
        _ => {
            *mouse = !*mouse;
            app.effects.push(Effect::Mouse(*mouse));
            let words = ["off: the terminal selects text", "on: a click selects, the wheel moves"];
            format!("mouse {}", words[usize::from(*mouse)])
        }
    };
    app.report_progress(text);
    app.request(Effect::SaveSession);
}

/// Shows a tab; if the tab is already shown, its next page.
pub(crate) fn go_to(app: &mut App, tab: Tab) {
    if app.tab == tab {
        next_page(app, 1);
    } else {
        app.tab = tab;
        app.typing = None;
        pages::page(tab).enter(app);
    }
}

/// Shows the next or previous page of the tab, cyclically; no effect for a single page.
fn next_page(app: &mut App, by: isize) {
    let page = pages::page(app.tab);
    let count = page.about().pages.len();
    if count > 1 {
        page.turn_to(app, cycled(page.shown(app), by, count));
    }
}

/// Shows a pane, with a page of its tab if given.
fn show(app: &mut App, pane: Pane, page: Option<usize>) {
    app.focus_on(pane);
    let of_tab = pages::page(app.tab);
    match page {
        Some(page) => of_tab.turn_to(app, page),
        None => of_tab.enter(app),
    }
}

/// Focuses the next pane of the page; shows the next page if the page has a single pane.
fn focus(app: &mut App, by: isize) {
    let page = pages::page(app.tab);
    let panes = page.shown_panes(app);
    if panes.len() < 2 {
        if page.about().pages.is_empty() {
            app.report_progress(
                "this tab has one pane; <tab-run>, <tab-explore> and so on change tabs",
            );
        }
        return next_page(app, by);
    }
    app.focus_on(around(&panes, app.pane(), by));
    page.focused(app);
}

/// Stops jobs, closes the open element, or quits; requires a confirmation if something would be lost.
fn leave(app: &mut App, action: Action) {
    // Close the open element before stopping a job.
    if action == Action::Back && update::clear(app) {
        return;
    }
    let all: Vec<(Tab, u64)> = pages::all_jobs(app).collect();
    let is_meant = |tab: Tab| match action {
        Action::Back => tab == app.tab,
        _ => action == Action::Cancel,
    };
    let jobs: Vec<u64> =
        all.iter().filter(|(tab, _)| is_meant(*tab)).map(|(_, job)| *job).collect();
    let is_long = |job: &u64| app.jobs.long.contains(job);
    let question = match action {
        Action::Back if jobs.iter().any(is_long) => Some(
            "a job has been running for more than 5 s: <back> again cancels it and keeps what is finished",
        ),
        Action::Quit if all.iter().any(|(tab, job)| *tab == Tab::Search || is_long(job)) => Some(
            "a job is running: <quit> again quits without it, <back> in its tab cancels it and keeps what is finished",
        ),
        Action::Cancel if jobs.iter().any(is_long) => Some(
            "a job has been running for more than 5 s: <cancel> again quits without it, <back> in its tab keeps what is finished",
        ),
        Action::Quit if app.files.session_lost && app.is_modified() => Some(
            "the session cannot be kept (see <tab-log>:Log): <quit> again quits without it, <save> or <export> save the scene or the table",
        ),
        Action::Cancel if jobs.is_empty() => Some("no job is running: <cancel> again quits"),
        _ => None,
    };
    if let Some(question) = question.filter(|_| app.jobs.awaiting_confirmation != Some(action)) {
        app.jobs.awaiting_confirmation = Some(action);
        return app.say(Severity::Warning, question);
    }
    // Pressed twice the key quits, also while the cancelled job is ending.
    let insists = action == Action::Cancel && app.jobs.awaiting_confirmation == Some(action);
    app.jobs.awaiting_confirmation = (action == Action::Cancel).then_some(action);
    if !jobs.is_empty() && !insists {
        // A study stopped by the user restarts on request only, also if it started because its page was shown.
        let stopped = app.jobs.studies.iter_mut().filter(|running| jobs.contains(&running.id));
        stopped.for_each(|running| running.is_look = false);
        app.effects.extend(jobs.into_iter().map(Effect::Cancel));
    } else if action == Action::Back {
        back(app);
    } else {
        app.request(Effect::SaveSession);
        app.request(Effect::Quit);
    }
}

/// Handles Esc without a job to stop: closes the open element, and never discards data.
fn back(app: &mut App) {
    if pages::page(app.tab).remove_cursor(app) {
        return;
    }
    if app.is_full() {
        app.pages.run.is_full = false;
        return;
    }
    let text = if let Some((tab, _)) = pages::all_jobs(app).next() {
        format!("nothing to stop here: <back> in {} stops its job", tab.title(&app.keymap))
    } else {
        let kept = if app.files.session_lost { "is not kept" } else { "is kept" };
        format!("nothing to close: <quit> quits (the session {kept})")
    };
    app.report_progress(text);
}

/// Copies the table of the page.
fn copy(app: &mut App) {
    let Some(table) = pages::page(app.tab).table(app) else {
        return app.refuse(pages::nothing_yet(app, "copy"));
    };
    app.request(Effect::Copy(Content::Page(table).text()));
}

/// Runs a command in the pane to which it belongs.
pub(crate) fn call(app: &mut App, call: CommandTarget) {
    match call {
        CommandTarget::Do(action) => act(app, action),
        CommandTarget::Show(pane, page) => show(app, pane, page),
        CommandTarget::In(pane, action) => {
            let before = app.tab;
            app.focus_on(pane);
            if app.tab != before {
                pages::page(app.tab).enter(app);
            }
            act(app, action);
        }
    }
}
