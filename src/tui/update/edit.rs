//! Edits of the scene: every one can be undone, is checked before it counts, and asks for a new run.

use std::sync::Arc;

use crate::model::run::envelope;
use crate::model::scene::Scene;
use crate::model::units::Bare;
use crate::model::variables::{self, Kind, Number, VARIABLES, Value, Variable};
use crate::tui::app::history::{Edit, Setting, Snapshot};
use crate::tui::app::notice::Severity;
use crate::tui::app::{App, Base};
use crate::tui::dialogs::wrap;
use crate::tui::message::Effect;
use crate::tui::pages::explore;
use crate::tui::pages::run::editor::shown_value;
use crate::tui::pages::run::runs::Pin;
use crate::tui::pages::run::steps::Size;
use crate::tui::pages::run::{runs, steps};
use crate::tui::update::jobs;

/// Columns that hold six digits of any value.
const WIDE: usize = 24;

/// Set a variable. `stepping` joins it with the steps just before.
///
/// # Errors
/// Why the value, or the scene with it, makes no sense; nothing is changed then.
pub(in crate::tui) fn set(
    app: &mut App,
    index: usize,
    value: Value,
    stepping: Option<usize>,
) -> Result<Vec<Effect>, String> {
    let variable = &VARIABLES[index];
    let mut scene = (*app.scene).clone();
    variable
        .set(&mut scene, value)
        .and_then(|()| variables::validate(&scene))
        .map_err(|error| error.to_string())?;
    if scene == *app.scene {
        return Ok(Vec::new());
    }
    let old = match app.history.edits.last() {
        // Held arrows: from where they began.
        Some(last) if stepping.is_some() && last.stepping == stepping => {
            shown_value(variable, &last.before.scene, WIDE)
        }
        _ => shown_value(variable, &app.scene, WIDE),
    };
    let label = format!("{} {old} -> {}", variable.symbol, shown_value(variable, &scene, WIDE));
    // What was outside before is marked in the list; what comes to be outside is said.
    let before = envelope::of_scene(&app.scene);
    let breach = envelope::of_scene(&scene)
        .into_iter()
        .filter(|breach| before.iter().all(|old| old.check != breach.check))
        .find(|breach| breach.check.symbol() == variable.symbol)
        .map(|breach| breach.to_string());
    let warning = breach.or_else(|| variable.range_warning(&scene));
    let effects = commit_scene(app, scene, label, stepping);
    if let Some(warning) = warning {
        app.say(Severity::Warning, warning);
    }
    Ok(effects)
}

/// Set a variable to what was typed: a value with its unit, a fraction, or a change of the old value.
///
/// # Errors
/// As [`set`], and where the text is no value.
pub(in crate::tui) fn type_value(
    app: &mut App,
    index: usize,
    text: &str,
) -> Result<Vec<Effect>, String> {
    let value = VARIABLES[index].parse(&app.scene, text, Bare::Stored);
    set(app, index, value.map_err(|error| error.to_string())?, None)
}

/// Make another scene the current one, as one edit.
pub(in crate::tui) fn commit_scene(
    app: &mut App,
    scene: Scene,
    label: String,
    stepping: Option<usize>,
) -> Vec<Effect> {
    let after = Snapshot { scene: Arc::new(scene), base: app.base.clone() };
    commit(app, after, label, stepping)
}

/// Make the design under a cursor the current scene, or say why there is none.
pub(in crate::tui) fn load_design(
    app: &mut App,
    design: Result<(Scene, String), String>,
) -> Vec<Effect> {
    match design {
        Ok((scene, _)) if scene == *app.scene => {
            app.say(Severity::Note, "the scene is this design already: 1 shows its run");
            Vec::new()
        }
        Ok((scene, label)) => load_scene(app, scene, &label),
        Err(why) => app.refuse(why),
    }
}

/// Make a scene the current one, as one edit, and say so.
pub(in crate::tui) fn load_scene(app: &mut App, scene: Scene, label: &str) -> Vec<Effect> {
    let effects = commit_scene(app, scene, format!("load {label}"), None);
    app.say(Severity::Note, format!("loaded {label}: 1 shows its run, u undoes"));
    effects
}

/// Make another scene current and compare it with another preset, as one edit.
pub(in crate::tui) fn load(app: &mut App, base: Base) -> Vec<Effect> {
    let label = format!("load {}", base.name);
    let after = Snapshot { scene: Arc::clone(&base.scene), base };
    app.charts.zoom_s = None;
    app.charts.cursor_s = None;
    commit(app, after, label, None)
}

fn commit(app: &mut App, after: Snapshot, label: String, stepping: Option<usize>) -> Vec<Effect> {
    let before = Snapshot { scene: Arc::clone(&app.scene), base: app.base.clone() };
    let edit =
        Edit { label, before, after: after.clone(), unpinned: None, setting: None, stepping };
    app.history.push(edit);
    app.first_run = false;
    install(app, after)
}

fn install(app: &mut App, snapshot: Snapshot) -> Vec<Effect> {
    app.scene = snapshot.scene;
    app.base = snapshot.base;
    let mut effects = jobs::after_edit(app);
    effects.extend(explore::keys::after_edit(app));
    effects.push(Effect::SaveSession);
    effects
}

/// Note that a pin was taken away, as one edit.
pub(in crate::tui) fn note_unpinned(app: &mut App, pin: Pin) {
    let label = format!("unpin {}: {}", pin.letter, pin.name);
    let edit = Edit { unpinned: Some(pin), ..beside_the_scene(app, label) };
    app.history.push(edit);
}

/// Note that the setup of a tab was changed, as one edit; `stepping` joins it with the steps just before.
pub(in crate::tui) fn note_setting(
    app: &mut App,
    setting: (Setting, Setting),
    label: String,
    stepping: Option<usize>,
) {
    let edit = Edit { setting: Some(setting), stepping, ..beside_the_scene(app, label) };
    app.history.push(edit);
}

/// An edit that leaves the scene alone.
fn beside_the_scene(app: &App, label: String) -> Edit {
    let before = Snapshot { scene: Arc::clone(&app.scene), base: app.base.clone() };
    let after = before.clone();
    Edit { label, before, after, unpinned: None, setting: None, stepping: None }
}

/// Set a tab up as it was, or will be again.
fn set_up(app: &mut App, setting: Setting) -> Vec<Effect> {
    match setting {
        Setting::Search(setup) => {
            app.pages.search.setup = *setup;
            app.pages.search.problem = None;
        }
        Setting::Visits(visits) => {
            app.pages.explore.visits = visits;
            return explore::keys::after_edit(app);
        }
        Setting::Weights(weights) => app.pages.thesis.weights = weights,
    }
    Vec::new()
}

/// Take the last edit back.
pub(in crate::tui) fn undo(app: &mut App) -> Vec<Effect> {
    let Some(edit) = app.history.undo().cloned() else {
        app.say(Severity::Note, "nothing to undo");
        return Vec::new();
    };
    app.say(Severity::Note, format!("undone: {} (Ctrl-r redoes)", edit.label));
    match (edit.unpinned, edit.setting) {
        (Some(pin), _) => runs::keys::put_back(app, pin),
        (None, Some((before, _))) => set_up(app, before),
        (None, None) => install(app, edit.before),
    }
}

/// Do the last undone edit again.
pub(in crate::tui) fn redo(app: &mut App) -> Vec<Effect> {
    let Some(edit) = app.history.redo().cloned() else {
        app.say(Severity::Note, "nothing to redo");
        return Vec::new();
    };
    app.say(Severity::Note, format!("redone: {}", edit.label));
    match (edit.unpinned, edit.setting) {
        (Some(pin), _) => runs::keys::take_away(app, &pin),
        (None, Some((_, after))) => set_up(app, after),
        (None, None) => install(app, edit.after),
    }
}

/// Go to the state after the first `done` edits.
pub(in crate::tui) fn travel(app: &mut App, done: usize) -> Vec<Effect> {
    let done = done.min(app.history.edits.len());
    if done == app.history.done {
        return Vec::new();
    }
    let snapshot = match done.checked_sub(1).and_then(|at| app.history.edits.get(at)) {
        Some(edit) => edit.after.clone(),
        None => app.history.edits[0].before.clone(),
    };
    let mut effects = Vec::new();
    let here = app.history.done;
    let back = app.history.unpinned(done.min(here)..here);
    effects.extend(back.into_iter().flat_map(|pin| runs::keys::put_back(app, pin)));
    let gone = app.history.unpinned(here.min(done)..done);
    effects.extend(gone.into_iter().flat_map(|pin| runs::keys::take_away(app, &pin)));
    for setting in app.history.settings_to(done) {
        effects.extend(set_up(app, setting));
    }
    app.history.done = done;
    app.say(Severity::Note, format!("back to the state after edit {done}"));
    effects.extend(install(app, snapshot));
    effects
}

/// Reset the selected variable to the preset's value.
pub(in crate::tui) fn reset(app: &mut App) -> Vec<Effect> {
    let index = app.editor.selected;
    let value = VARIABLES[index].value(&app.base.scene);
    match set(app, index, value, None) {
        Ok(effects) => {
            if effects.is_empty() {
                app.say(
                    Severity::Note,
                    format!("{} has the preset's value already", VARIABLES[index].symbol),
                );
            }
            effects
        }
        Err(error) => app.refuse(error),
    }
}

/// Reset every variable to the preset's value.
pub(in crate::tui) fn reset_all(app: &mut App) -> Vec<Effect> {
    if !app.is_modified() {
        app.say(Severity::Note, "nothing differs from the preset");
        return Vec::new();
    }
    let scene = (*app.base.scene).clone();
    let label = format!("reset all to {}", app.base.name);
    app.say(Severity::Note, format!("{label}: u undoes"));
    commit_scene(app, scene, label, None)
}

/// Step the selected variable: a number by its rule, a choice or switch to its neighbour.
pub(in crate::tui) fn step(app: &mut App, up: bool, size: Size) -> Vec<Effect> {
    let index = app.editor.selected;
    let variable = &VARIABLES[index];
    let Kind::Number(number) = &variable.kind else {
        if let Some(value) = cycled(app, index, up) {
            return finish(app, index, value, None);
        }

        let only = format!("{} has only one value: {}", variable.symbol, variable.show(&app.scene));
        app.say(Severity::Note, only);
        return Vec::new();
    };
    let value = match (number.get)(&app.scene) {
        Some(value) => step_number(app, index, number, value, (up, size)),
        None => up.then(|| steps::first_value(number)),
    };
    if let Some(value) = value {
        return finish(app, index, Value::Number(value), Some(index));
    }
    app.say(Severity::Note, edge(variable, up));
    Vec::new()
}

fn step_number(
    app: &mut App,
    index: usize,
    number: &Number,
    value: f64,
    (up, size): (bool, Size),
) -> Option<f64> {
    let stride = match app.editor.stride {
        Some((same, decade)) if same == index => decade,
        _ => steps::decade(number, value),
    };
    app.editor.stride = Some((index, stride));
    steps::stepped(number, value, up, size, stride)
}

fn edge(variable: &Variable, up: bool) -> String {
    let way = if up { "more" } else { "less" };
    format!(
        "{} cannot be stepped to {way}: it must be {} (, and . step finer)",
        variable.symbol,
        variable.allowed()
    )
}

fn finish(app: &mut App, index: usize, value: Value, stepping: Option<usize>) -> Vec<Effect> {
    match set(app, index, value, stepping) {
        Ok(effects) => effects,
        Err(error) => app.refuse(error),
    }
}

/// The neighbour of a choice or switch; `None` where there is only one value, or the variable is a number.
fn cycled(app: &App, index: usize, up: bool) -> Option<Value> {
    match &VARIABLES[index].kind {
        Kind::Switch { get, .. } => Some(Value::Switch(!get(&app.scene))),
        Kind::Choice(choice) if choice.words.len() > 1 => {
            let next = wrap((choice.get)(&app.scene), if up { 1 } else { -1 }, choice.words.len());
            Some(Value::Word(choice.words[next]))
        }
        Kind::Choice(_) | Kind::Number(_) => None,
    }
}
