//! One action of the key table.

use crate::model::units;
use crate::study::accuracy::method::Method;
use crate::tui::app::accuracy::Measuring;
use crate::tui::app::dialog::{Dialog, Picker};
use crate::tui::app::notice::Severity;
use crate::tui::app::steps::Size;
use crate::tui::app::{App, Tab, runs as run_words};
use crate::tui::message::{Action, Effect, Place};

use super::{
    accuracy, charts, dialogs, edit, export, field, jobs, limit, runs, search, stability, sweep,
    thesis,
};

/// Do it, in the pane that has the keys.
pub(super) fn act(app: &mut App, action: Action) -> Vec<Effect> {
    use Action as A;
    if !matches!(action, A::Quit | A::QuitWithSummary) {
        app.jobs.asked_to_quit = false;
    }
    if !is_step(action) && !sweep::is_step(app, action) {
        app.history.seal();
        app.editor.stride = None;
    }
    if app.picture().is_some() && sweep::is_own(app, action) {
        return sweep::act(app, action);
    }
    if app.tab == Tab::Accuracy && accuracy::is_own(action) {
        return accuracy::act(app, action);
    }
    if app.tab == Tab::Stability && stability::is_own(action) {
        return stability::act(app, action);
    }
    if app.tab == Tab::Thesis && thesis::is_own(action) {
        return thesis::act(app, action);
    }
    if app.tab == Tab::Limit && limit::is_own(app, action) {
        return limit::act(app, action);
    }
    if app.tab == Tab::Search && search::is_own(app, action) {
        return search::act(app, action);
    }
    anywhere(app, action)
}

/// The list of presets, filled as soon as it has been read.
fn presets(app: &mut App) -> Vec<Effect> {
    app.dialog = Some(Dialog::Presets(Picker::default()));
    vec![Effect::ListPresets]
}

/// What an action does where no tab has its own meaning for it; the first ones only some tabs have.
fn anywhere(app: &mut App, action: Action) -> Vec<Effect> {
    use Action as A;
    match action {
        A::MapVariable
        | A::MapMethod
        | A::SlopeGuides
        | A::SpreadBars
        | A::CursorUpFar
        | A::CursorDownFar
        | A::Contour
        | A::NextVerdict
        | A::Scatter
        | A::SearchNext
        | A::OpenDesign => {}
        A::TabRun
        | A::TabSweep
        | A::TabSurface
        | A::TabAccuracy
        | A::TabStability
        | A::TabLog
        | A::TabThesis
        | A::TabLimit
        | A::TabSearch
        | A::TabNext
        | A::TabPrevious => return tabs(app, action),
        A::FocusNext | A::FocusPrevious => focus(app, action),
        A::Up | A::Down | A::First | A::Last | A::PageUp | A::PageDown => movement(app, action),
        A::Edit => return field::open(app),
        A::StepDown => return edit::step(app, false, Size::Plain),
        A::StepUp => return edit::step(app, true, Size::Plain),
        A::StepDownCoarse => return edit::step(app, false, Size::Coarse),
        A::StepUpCoarse => return edit::step(app, true, Size::Coarse),
        A::StepDownFine => return edit::step(app, false, Size::Fine),
        A::StepUpFine => return edit::step(app, true, Size::Fine),
        A::Reset | A::ResetAll => return reset(app, action),
        A::Filter => field::open_filter(app),
        A::Undo | A::Redo => return history(app, action),
        A::Interface => return edit::switch_interface(app),
        A::History | A::Help | A::Palette => overlay(app, action),
        A::Presets => return presets(app),
        A::Save | A::SaveAs => return dialogs::save(app, action == A::SaveAs),
        A::Export => export::open(app),
        A::Models | A::Pin | A::Unpin | A::Adopt | A::ShowHide => return runs::act(app, action),
        A::Copy => return copy(app),
        A::Run => return jobs::run_now(app),
        A::AutoRun => return auto_run(app),
        A::Cancel | A::Back | A::Quit | A::QuitWithSummary => return leave(app, action),
        A::Difference
        | A::CursorLeft
        | A::CursorRight
        | A::CursorLeftFar
        | A::CursorRightFar
        | A::EventNext
        | A::EventPrevious
        | A::ZoomIn
        | A::ZoomOut
        | A::ZoomFit
        | A::PanLeft
        | A::PanRight
        | A::FitVertical
        | A::Window
        | A::Quantity
        | A::SecondAxis
        | A::NoSecondAxis
        | A::LogX
        | A::LogY => return charts::act(app, action),
        A::FullPane | A::Glyphs | A::Theme | A::Mouse | A::Redraw | A::Suspend => {
            return screen(app, action);
        }
    }
    Vec::new()
}

fn history(app: &mut App, action: Action) -> Vec<Effect> {
    if action == Action::Undo { edit::undo(app) } else { edit::redo(app) }
}

fn reset(app: &mut App, action: Action) -> Vec<Effect> {
    if action == Action::Reset { edit::reset(app) } else { edit::reset_all(app) }
}

fn is_step(action: Action) -> bool {
    matches!(
        action,
        Action::StepDown
            | Action::StepUp
            | Action::StepDownCoarse
            | Action::StepUpCoarse
            | Action::StepDownFine
            | Action::StepUpFine
    )
}

fn tabs(app: &mut App, action: Action) -> Vec<Effect> {
    let at = Tab::ALL.iter().position(|tab| *tab == app.tab).unwrap_or(0);
    let count = Tab::ALL.len();
    app.tab = match action {
        Action::TabRun => Tab::Run,
        Action::TabSweep => Tab::Sweep,
        Action::TabSurface => Tab::Surface,
        Action::TabAccuracy => Tab::Accuracy,
        Action::TabStability => Tab::Stability,
        Action::TabLog => Tab::Log,
        Action::TabThesis => Tab::Thesis,
        Action::TabLimit => Tab::Limit,
        Action::TabSearch => Tab::Search,
        Action::TabPrevious => Tab::ALL[(at + count - 1) % count],
        _ => Tab::ALL[(at + 1) % count],
    };
    app.log_scroll = 0;
    entered(app)
}

/// The tab is shown: it computes what it has not, for the scene there is.
pub(super) fn entered(app: &mut App) -> Vec<Effect> {
    match app.tab {
        Tab::Sweep | Tab::Surface => sweep::enter(app),
        Tab::Accuracy => accuracy::enter(app),
        Tab::Stability => stability::enter(app),
        Tab::Thesis => thesis::enter(app),
        Tab::Limit => limit::enter(app),
        Tab::Search => search::enter(app),
        Tab::Run | Tab::Log => Vec::new(),
    }
}

/// The next pane of the Run tab; the other tabs that come here have one.
fn focus(app: &mut App, action: Action) {
    if app.tab != Tab::Run {
        app.say(Severity::Note, "this tab has one pane; } and { change tabs");
        return;
    }
    let forward = action == Action::FocusNext;
    let places = [Place::Variables, Place::Charts, Place::Runs];
    let at = places.iter().position(|place| *place == app.focus);
    let step = if forward { 1 } else { places.len() - 1 };
    app.focus = places[(at.unwrap_or(0) + step) % places.len()];
}

fn overlay(app: &mut App, action: Action) {
    app.dialog = Some(match action {
        Action::History => Dialog::History(Picker::at(app.history.done)),
        Action::Palette => Dialog::Palette(Picker::typing()),
        _ => Dialog::Help(Picker::default()),
    });
}

fn movement(app: &mut App, action: Action) {
    let by = |page: usize| {
        let page = isize::try_from(page.max(2) - 1).unwrap_or(1);
        match action {
            Action::Up => -1,
            Action::Down => 1,
            Action::PageUp => -page,
            Action::PageDown => page,
            Action::First => isize::MIN / 2,
            _ => isize::MAX / 2,
        }
    };
    match app.place() {
        Place::Variables | Place::Anywhere => {
            let rows = app.layout().variable_rows();
            app.editor.move_by(&app.scene, by(rows));
        }
        Place::Charts => {
            app.charts.selected = app.charts.selected.saturating_add_signed(by(3)).min(2);
        }
        Place::Runs => {
            let last = app.pins.len();
            app.selected_run = app.selected_run.saturating_add_signed(by(8)).min(last);
        }
        Place::Setup => {
            let rows = app.layout().log_rows();
            if let Some(picture) = app.picture() {
                app.move_in_setup(picture, by(rows));
            }
        }
        // The cursor's own steps.
        Place::Lines | Place::Surface | Place::Limit | Place::Search => {}
        Place::SearchSetup => app.move_in_search(by(app.layout().log_rows())),
        Place::Accuracy => {
            let last = Method::ALL.len() - 1;
            let selected = app.accuracy.selected;
            app.accuracy.selected = selected.saturating_add_signed(by(8)).min(last);
        }
        Place::Map => app.stability.move_cursor(-by(8).clamp(-100, 100), 0),
        Place::Battery => {
            let last = app.stability.rows().len().saturating_sub(1);
            let selected = app.stability.selected;
            let page = app.layout().log_rows();
            app.stability.selected = selected.saturating_add_signed(by(page)).min(last);
        }
        Place::Claims | Place::Principles | Place::Screening => app.thesis.move_by(by(8)),
        Place::Log => {
            let rows = app.layout().log_rows();
            let most = app.log_lines(usize::from(app.size.0)).len().saturating_sub(rows);
            app.log_scroll = app.log_scroll.saturating_add_signed(by(rows)).min(most);
        }
    }
}

fn auto_run(app: &mut App) -> Vec<Effect> {
    app.auto_run = !app.auto_run;
    if !app.auto_run {
        app.say(Severity::Note, "auto-run is off: r runs, a switches it on again");
        return Vec::new();
    }
    app.say(Severity::Note, "auto-run is on: every edit runs at once");
    if app.is_stale() { jobs::run_now(app) } else { Vec::new() }
}

/// What a tab may be waiting for on the studies' thread.
fn studies_of(app: &App, tab: Tab) -> [Option<&Measuring>; 2] {
    match tab {
        Tab::Accuracy => [app.accuracy.measuring.as_ref(), None],
        Tab::Stability => [app.stability.mapping.as_ref(), app.stability.running.as_ref()],
        Tab::Thesis => [app.thesis.running.as_ref(), None],
        Tab::Limit => [app.limit.finding.as_ref(), None],
        Tab::Search => [app.searching.running.as_ref(), None],
        Tab::Run | Tab::Sweep | Tab::Surface | Tab::Log => [None, None],
    }
}

/// Whether anything under way has been so for so long that leaving it asks twice.
fn is_long(app: &App) -> bool {
    app.jobs.current.as_ref().is_some_and(|job| job.long)
        || Tab::ALL.into_iter().flat_map(|tab| studies_of(app, tab)).flatten().any(|it| it.long)
        || app.sweeping.computing.as_ref().is_some_and(|it| it.long)
}

/// What Esc stops: what the tab says it stops, before anything that goes on elsewhere.
fn to_stop(app: &App) -> Option<Effect> {
    let is_studying = |tab: Tab| studies_of(app, tab).iter().any(Option::is_some);
    let sweeps = app.sweeping.computing.is_some();
    if sweeps && matches!(app.tab, Tab::Sweep | Tab::Surface) {
        Some(Effect::CancelSweep)
    } else if is_studying(app.tab) {
        Some(Effect::CancelStudy)
    } else if app.jobs.current.is_some() {
        Some(Effect::CancelJob)
    } else if sweeps {
        Some(Effect::CancelSweep)
    } else {
        Tab::ALL.into_iter().any(is_studying).then_some(Effect::CancelStudy)
    }
}

fn leave(app: &mut App, action: Action) -> Vec<Effect> {
    let quit = |summary| vec![Effect::SaveSession, Effect::Quit { summary }];
    let long = is_long(app);
    let stopped = to_stop(app);
    match action {
        Action::Quit | Action::QuitWithSummary if long && !app.jobs.asked_to_quit => {
            app.jobs.asked_to_quit = true;
            app.say(
                Severity::Warning,
                "a job has been going on for more than 5 s: q again leaves without it, Esc stops it",
            );
            Vec::new()
        }
        Action::Quit | Action::QuitWithSummary
            if app.session_lost && app.is_modified() && !app.jobs.asked_to_quit =>
        {
            app.jobs.asked_to_quit = true;
            app.say(
                Severity::Warning,
                "the session cannot be kept (see 6:Log): q again leaves without it, s or e save what matters",
            );
            Vec::new()
        }
        Action::Cancel | Action::Back if stopped.is_some() => stopped.into_iter().collect(),
        Action::Back => {
            if app.full_pane {
                app.full_pane = false;
            } else if !app.editor.filter.is_empty() {
                app.editor.set_filter(&app.scene, "");
            } else {
                let kept = if app.session_lost { "is not kept" } else { "is kept" };
                let text = format!("nothing to stop: q quits (the session {kept})");
                app.say(Severity::Note, text);
            }
            Vec::new()
        }
        Action::QuitWithSummary => quit(true),
        _ => quit(false),
    }
}

fn screen(app: &mut App, action: Action) -> Vec<Effect> {
    match action {
        Action::FullPane => app.full_pane = !app.full_pane,
        Action::Glyphs => {
            app.theme.glyphs = app.theme.glyphs.next();
            app.say(
                Severity::Note,
                format!("characters: {} (m for the next set)", app.theme.glyphs),
            );
            return vec![Effect::SaveSession];
        }
        Action::Theme => {
            app.theme.depth = app.theme.depth.next(app.best_depth);
            app.say(
                Severity::Note,
                format!("colours: {} (t for the next)", app.theme.depth.word()),
            );
            return vec![Effect::SaveSession];
        }
        Action::Mouse => {
            app.mouse = !app.mouse;
            app.say(
                Severity::Note,
                if app.mouse {
                    "the program has the mouse: M gives it back"
                } else {
                    "the terminal has the mouse: select text as usual"
                },
            );
            return vec![Effect::Mouse(app.mouse)];
        }
        Action::Redraw => return vec![Effect::Redraw],
        _ => return vec![Effect::Suspend],
    }
    Vec::new()
}

fn copy(app: &mut App) -> Vec<Effect> {
    let Some(shown) = &app.shown else {
        app.say(Severity::Error, "nothing to copy yet: r runs the scene");
        return Vec::new();
    };
    let run = &shown.run;
    let number = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), units::shortest);
    let name = run_words::name_of(&run.scene, &app.base.name, &app.base.scene);
    let lines = [
        format!("scene\t{name}"),
        format!("outcome\t{}", run.outcome),
        format!(
            "first_arrest_penetration_m\t{}",
            number(run.first_arrest.map(|arrest| arrest.penetration_m))
        ),
        format!("first_arrest_time_s\t{}", number(run.first_arrest.map(|arrest| arrest.t_s))),
        format!("final_penetration_m\t{}", number(run.final_penetration_m)),
        format!("percent_of_baseline\t{}", number(run.percent_of_baseline())),
        format!("peak_contact_force_n\t{}", number(run.peak_contact_force_n)),
        format!("max_plate_displacement_m\t{}", number(run.max_plate_displacement_m)),
        format!("residual_velocity_m_s\t{}", number(run.residual_velocity_m_s)),
        format!("interface_demand_ratio\t{}", number(run.interface_demand_ratio)),
    ];
    vec![Effect::Copy(lines.join("\n") + "\n")]
}
