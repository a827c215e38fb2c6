//! One action: the page that is shown comes first, then what the action means anywhere.

use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::dialogs::{List, ask, export, options};
use crate::tui::keymap::{Action, Pane, Part};
use crate::tui::message::Effect;
use crate::tui::pages::run::keys::step_of;
use crate::tui::pages::run::runs;
use crate::tui::pages::run::steps::Press;
use crate::tui::pages::{self, Tab};
use crate::tui::update::{edit, field, find, zoom};

/// Do it, in the pane that has the keys.
pub(in crate::tui) fn act(app: &mut App, action: Action) -> Vec<Effect> {
    if !matches!(action, Action::Quit | Action::QuitWithSummary | Action::Cancel) {
        app.jobs.asked_to_quit = false;
    }
    if !steps(app, action) {
        app.history.commit();
        app.editor.stepped = None;
    }
    let page = pages::of(app.tab);
    if let Some(effects) = page.act(app, action).or_else(|| in_form(app, action)) {
        return effects;
    }
    if let Some(rows) = page.rows(app)
        && let Some(by) = rows_moved(action, rows.shown)
    {
        move_by(app, by);
        return Vec::new();
    }
    if page.across(app).is_some_and(|across| across.change(action)) {
        return Vec::new();
    }
    if zoom::is_zoom(action) && pages::spec(app.pane()).has.contains(&Part::Chart) {
        app.say(Severity::Note, "nothing is drawn yet that could be zoomed");
        return Vec::new();
    }
    anywhere(app, action)
}

/// What an action does to the selected row of a form: it takes the next value, or opens its field.
fn in_form(app: &mut App, action: Action) -> Option<Vec<Effect>> {
    let page = pages::of(app.tab);
    let form = page.form(app)?;
    let press = match action {
        Action::Enter => Press::NEXT,
        _ => step_of(action)?,
    };
    let row = form.rows(0).selected;
    page.select(app, row);
    if action == Action::Enter && form.line()?.text.is_some() {
        return Some(field::open(app, row));
    }
    Some(page.step(app, row, press).unwrap_or_else(|why| app.refuse(why)))
}

/// Move the selection of the pane by rows, stopping at the ends.
pub(in crate::tui) fn move_by(app: &mut App, by: isize) {
    let page = pages::of(app.tab);
    if let Some(rows) = page.rows(app)
        && let Some(last) = rows.count.checked_sub(1)
    {
        page.select(app, rows.selected.min(last).saturating_add_signed(by).min(last));
    }
}

/// Whether an action steps the value of a row: such steps join into one edit.
fn steps(app: &App, action: Action) -> bool {
    step_of(action).is_some() && pages::spec(app.pane()).has.contains(&Part::Form)
}

/// By how many rows an action moves in a list that shows so many at once; `None` for other actions.
pub(in crate::tui) fn rows_moved(action: Action, page: usize) -> Option<isize> {
    let page = isize::try_from(page.max(2) - 1).unwrap_or(1);
    match action {
        Action::Up => Some(-1),
        Action::Down => Some(1),
        Action::PageUp => Some(-page),
        Action::PageDown => Some(page),
        Action::First => Some(isize::MIN / 2),
        Action::Last => Some(isize::MAX / 2),
        _ => None,
    }
}

/// How far along and upward an action moves a cursor; far is this many.
pub(in crate::tui) fn cursor_moved(action: Action, far: isize) -> Option<(isize, isize)> {
    match action {
        Action::Left => Some((-1, 0)),
        Action::Right => Some((1, 0)),
        Action::FarLeft => Some((-far, 0)),
        Action::FarRight => Some((far, 0)),
        Action::Up => Some((0, 1)),
        Action::Down => Some((0, -1)),
        Action::PageUp => Some((0, far)),
        Action::PageDown => Some((0, -far)),
        Action::First => Some((isize::MIN / 2, 0)),
        Action::Last => Some((isize::MAX / 2, 0)),
        _ => None,
    }
}

/// What an action does where the page has no meaning of its own for it.
fn anywhere(app: &mut App, action: Action) -> Vec<Effect> {
    use Action as A;
    match action {
        A::Tab(tab) => return go_to(app, tab),
        A::FocusNext => return focus(app, true),
        A::FocusPrevious => return focus(app, false),
        A::TabNext | A::TabPrevious => return beside(app, action == A::TabNext),
        A::Find => find::open(app),
        A::Undo => return edit::undo(app),
        A::Redo => return edit::redo(app),
        A::ResetAll => return edit::reset_all(app),
        A::History => app.dialog = Some(List::History.at(app.history.done)),
        A::Palette => app.dialog = Some(List::Palette.typing()),
        A::Help => app.dialog = Some(List::Help.at(0)),
        A::Options => app.dialog = Some(List::Options.at(0)),
        A::Presets => {
            app.dialog = Some(List::Presets.at(0));
            return vec![app.list_presets()];
        }
        A::Save => return ask::save(app),
        A::Export if of_runs(app.tab) => export::open(app),
        A::Export => ask::export(app),
        A::Copy if of_runs(app.tab) => return runs::keys::copy(app),
        A::Copy => return ask::copy(app),
        A::Models => return runs::keys::models(app),
        A::Switch(option) => return options::switch(app, option),
        A::Cancel | A::Back | A::Quit | A::QuitWithSummary => return leave(app, action),
        A::FullPane => {
            let at = app.tab.index();
            app.full_pane[at] = !app.full_pane[at];
        }
        A::Redraw => return vec![Effect::Redraw],
        A::Suspend => return vec![Effect::Suspend],
        _ => {
            let key = app.keymap.label(action);
            app.say(Severity::Note, format!("`{key}` does nothing here: ? lists the keys"));
        }
    }
    Vec::new()
}

/// Show a tab; one that is shown already shows its next page.
pub(in crate::tui) fn go_to(app: &mut App, tab: Tab) -> Vec<Effect> {
    if app.tab != tab {
        app.tab = tab;
        app.field = None;
        app.log_scroll = 0;
        return pages::of(tab).enter(app);
    }
    next_page(app, true)
}

/// The next or previous page of the tab, in a circle; nothing where it has one.
fn next_page(app: &mut App, forward: bool) -> Vec<Effect> {
    let page = pages::of(app.tab);
    let count = page.about().pages.len();
    if count < 2 {
        return Vec::new();
    }
    let step = if forward { 1 } else { count - 1 };
    let next = (page.shown(app) + step) % count;
    page.turn_to(app, next)
}

/// The tab at the right or the left of the one shown.
fn beside(app: &mut App, forward: bool) -> Vec<Effect> {
    let count = Tab::ALL.len();
    let step = if forward { 1 } else { count - 1 };
    go_to(app, Tab::ALL[(app.tab.index() + step) % count])
}

/// Show a pane, with a page of its tab where one is named.
pub(in crate::tui) fn show(app: &mut App, pane: Pane, page: Option<usize>) -> Vec<Effect> {
    app.focus_on(pane);
    let of_tab = pages::of(app.tab);
    match page {
        Some(page) => of_tab.turn_to(app, page),
        None => of_tab.enter(app),
    }
}

/// The next pane of the page; the next page where the page has one pane.
fn focus(app: &mut App, forward: bool) -> Vec<Effect> {
    let page = pages::of(app.tab);
    let panes = page.shown_panes(app);
    if panes.len() < 2 {
        if page.about().pages.len() < 2 {
            app.say(Severity::Note, "this tab has one pane; } and { change tabs");
        }
        return next_page(app, forward);
    }
    let at = panes.iter().position(|pane| *pane == app.pane()).unwrap_or(0);
    let step = if forward { 1 } else { panes.len() - 1 };
    app.focus_on(panes[(at + step) % panes.len()]);
    page.focused(app)
}

/// Whether anything under way has been so for so long that leaving it asks twice.
fn is_long(app: &App) -> bool {
    pages::all_jobs(app).any(|(_, job)| app.jobs.long.contains(&job))
}

fn leave(app: &mut App, action: Action) -> Vec<Effect> {
    let is_quit = matches!(action, Action::Quit | Action::QuitWithSummary);
    let own: Vec<u64> =
        pages::all_jobs(app).filter(|(tab, _)| *tab == app.tab).map(|(_, job)| job).collect();
    let jobs: Vec<u64> = match action {
        Action::Cancel if own.is_empty() => {
            pages::all_jobs(app).take(1).map(|(_, job)| job).collect()
        }
        Action::Back | Action::Cancel => own,
        _ => Vec::new(),
    };
    if !jobs.is_empty() {
        return jobs.into_iter().map(Effect::Cancel).collect();
    }
    if action == Action::Back {
        back(app);
        return Vec::new();
    }
    let question = if is_quit && is_long(app) {
        Some(
            "a job has been running for more than 5 s: q again quits without it, Esc in its tab cancels it",
        )
    } else if is_quit && app.session_lost && app.is_modified() {
        Some(
            "the session cannot be kept (see 7:Log): q again quits without it, s or e save the scene or the table",
        )
    } else if action == Action::Cancel {
        Some("no job is running: Ctrl-c again quits")
    } else {
        None
    };
    if let Some(question) = question.filter(|_| !app.jobs.asked_to_quit) {
        app.jobs.asked_to_quit = true;
        app.say(Severity::Warning, question);
        return Vec::new();
    }
    vec![Effect::SaveSession, Effect::Quit { summary: action == Action::QuitWithSummary }]
}

/// Esc with nothing to stop: it closes what is open here, and never takes anything away.
fn back(app: &mut App) {
    let at = app.tab.index();
    if app.full_pane[at] {
        app.full_pane[at] = false;
    } else if !find::clear(app) {
        let elsewhere = pages::all_jobs(app).map(|(tab, _)| tab).next();
        let kept = if app.session_lost { "is not kept" } else { "is kept" };
        let text = elsewhere.map_or_else(
            || format!("nothing to close: q quits (the session {kept})"),
            |tab| format!("nothing to stop here: Esc in {} stops its job", tab.title()),
        );
        app.say(Severity::Note, text);
    }
}

/// Whether what a tab exports and copies are runs, not a table of its own.
fn of_runs(tab: Tab) -> bool {
    matches!(tab, Tab::Run | Tab::Log)
}
