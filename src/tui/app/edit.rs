//! Edits of the scene. Each can be undone, is validated before it takes effect, and requests a new run.

use std::sync::Arc;

use crate::tui::app::history::{Edit, Snapshot};
use crate::tui::app::jobs;
use crate::tui::app::pins::Pin;
use crate::tui::pages::explore::state::ChartKind;
use crate::tui::pages::run::editor::shown_in;
use crate::tui::prelude::*;
use crate::tui::preset::{LabelledScene, ReferencePreset};
use crate::tui::widgets::cycled;
use crate::tui::widgets::value_steps::{self, StepKey};
use cmra_engine::model::run::Warning;
use cmra_engine::model::scene::{Scene, SpringKind, Table};
use cmra_engine::model::units::Bare;
use cmra_engine::model::variables::{self, Kind, VARIABLES, Value, Variable};
use cmra_studies::study::envelope;
use cmra_studies::study::error::refusal;

/// Sets a variable. `stepping` merges the edit with the preceding steps of the same variable.
pub(crate) fn set(
    app: &mut App,
    index: usize,
    value: Value,
    stepping: Option<usize>,
) -> Result<(), String> {
    let variable = &VARIABLES[index];
    let scene = with(&app.scene, variable, value)?;
    if scene == *app.scene {
        return Ok(());
    }
    let old = app.history.extended(stepping).map_or(&app.scene, |first| &first.scene);
    let unit = app.pages.run.editor.unit(index);
    let shown = |scene: &Scene| shown_in(variable, scene, unit, 6);
    let label = format!("{} {} -> {}", variable.symbol, shown(old), shown(&scene));
    // Existing breaches are marked in the list; new breaches are reported.
    let before = envelope::of_scene(&app.scene);
    let breach = envelope::of_scene(&scene)
        .into_iter()
        .filter(|breach| before.iter().all(|old| old.check != breach.check))
        .find(|breach| breach.check.symbol() == variable.symbol)
        .map(|breach| Warning { meaning: String::new(), ..Warning::from(&breach) });
    let warning = breach.or_else(|| variable.range_warning(&scene));
    commit_scene(app, scene, label, stepping);
    if let Some(warning) = warning {
        app.say(Severity::Warning, warning.to_string());
    }
    Ok(())
}

/// Returns a scene with another value of a variable, or the reason why it makes no sense.
pub(crate) fn with(present: &Scene, variable: &Variable, value: Value) -> Result<Scene, String> {
    let mut scene = present.clone();
    let set = variable.set(&mut scene, value).and_then(|()| variables::validate(&scene));
    set.map_err(|error| refusal(&error))?;
    let spring = &scene.mechanism.spring;
    let begins = spring.kind == SpringKind::Table && spring.kind != present.mechanism.spring.kind;
    if begins && spring.table == Table::default() {
        let why = "the points of a table come from a file: see `cmra help mechanisms`";
        return Err(why.to_owned());
    }
    Ok(scene)
}

/// Sets a variable from typed text: a value with its unit, a fraction, or a change of the old value.
pub(crate) fn read(app: &mut App, index: usize, text: &str) -> Result<(), String> {
    let unit = app.pages.run.editor.unit(index);
    let value = VARIABLES[index].parse(&app.scene, text, Bare::In(unit));
    set(app, index, value.map_err(|error| refusal(&error))?, None)
}

/// Displays a variable in the typed unit, as a part of the edit made since `before`.
pub(crate) fn show_in_unit_of(app: &mut App, index: usize, text: &str, before: Snapshot) {
    app.pages.run.editor.show_in_unit_of(index, text);
    let after = app.snapshot();
    if after.units == before.units {
        return;
    }
    let is_edited = (&after.scene, &after.search) != (&before.scene, &before.search);
    if let Some(edit) = app.history.edits.last_mut().filter(|_| is_edited) {
        edit.states.1 = after;
    } else {
        let (symbol, unit) = (VARIABLES[index].symbol, app.pages.run.editor.unit(index));
        note(app, before, format!("{symbol} in {unit}"), None);
    }
}

/// Replaces the scene, as one edit.
pub(crate) fn commit_scene(app: &mut App, scene: Scene, label: String, stepping: Option<usize>) {
    let before = app.snapshot();
    // Steps of held arrow keys are relative to the first state.
    if app.history.extended(stepping).is_none() {
        app.keep_before(&before.scene);
    }
    app.scene = Arc::new(scene);
    commit(app, before, label, stepping);
}

/// Replaces the scene by the design under a cursor, or reports the reason why there is none.
pub(crate) fn load_design(app: &mut App, design: Result<LabelledScene, String>) {
    match design {
        Ok(design) if design.scene == *app.scene => {
            app.report_progress("the scene is this design already: <tab-run> shows its run");
        }
        Ok(LabelledScene { scene, label }) => {
            commit_scene(app, scene, format!("load {label}"), None);
            app.report_progress(format!("loaded {label}: <tab-run> shows its run, <undo> undoes"));
        }
        Err(why) => app.refuse(why),
    }
}

/// Replaces the scene and its base preset and shows the sweep as curves or a map, as one edit.
pub(crate) fn load(app: &mut App, base: ReferencePreset, picture: ChartKind) {
    let before = app.snapshot();
    let label = format!("load {}", base.name);
    app.pages.run.charts.cursor_s = None;
    app.before = None;
    app.pages.explore.picture = picture;
    (app.scene, app.base) = (Arc::clone(&base.scene), base);
    commit(app, before, label, None);
}

/// Records the opening of a session as one edit, and computes its pins.
pub(crate) fn opened(app: &mut App, before: Snapshot, label: String) {
    commit(app, before, label, None);
    follow_pins(app);
}

fn commit(app: &mut App, before: Snapshot, label: String, stepping: Option<usize>) {
    let old = Arc::clone(&before.scene);
    note(app, before, label, stepping);
    app.first_run = false;
    follow(app, &old);
}

/// Updates after a change of the scene.
fn follow(app: &mut App, before: &Scene) {
    app.is_edited |= *app.scene != *before;
    if app.pages.run.editor.filter.is_empty() && !app.pages.run.editor.shows(&app.scene) {
        // If the scene no longer uses the variable, select the nearest one in the list.
        let away = |index: &usize| index.abs_diff(app.pages.run.editor.selected);
        let nearest = app.pages.run.editor.listed(&app.scene).into_iter().min_by_key(away);
        app.pages.run.editor.selected = nearest.unwrap_or_default();
    }
    app.request(Effect::SaveSession);
}

/// Records the changes since `before` as one edit; `stepping` merges it with the preceding steps.
pub(crate) fn note(app: &mut App, before: Snapshot, label: String, stepping: Option<usize>) {
    let states = Box::new((before, app.snapshot()));
    app.history.push(Edit { label, states, stepping });
}

/// Applies the change of an edit. Unchanged parts and the results of pins keep their present state.
fn make(app: &mut App, from: &Snapshot, to: Snapshot) {
    if from.pins != to.pins {
        let now = std::mem::take(&mut app.pins);
        let own = |pin: Pin| now.iter().find(|it| it.scene == pin.scene).cloned().unwrap_or(pin);
        app.pins = to.pins.into_iter().map(own).collect();
        follow_pins(app);
    }
    if (&from.scene, &from.base) != (&to.scene, &to.base) {
        app.keep_before(&from.scene);
        (app.scene, app.base) = (to.scene, to.base);
        follow(app, &from.scene);
    }
    if from.search != to.search {
        app.pages.search.setup = to.search;
        app.pages.search.problem = Default::default();
    }
    if from.units != to.units {
        app.pages.run.editor.units = to.units;
    }
    if from.picture != to.picture {
        app.pages.explore.picture = to.picture;
    }
}

/// Undoes the last edit.
pub(crate) fn undo(app: &mut App) {
    let Some(at) = app.history.done.checked_sub(1) else {
        return app.report_progress("nothing to undo");
    };
    app.history.done = at;
    let Edit { label, states, .. } = app.history.edits[at].clone();
    app.report_progress(format!("undone: {label} (<redo> redoes)"));
    make(app, &states.1, states.0);
}

/// Redoes the last undone edit.
pub(crate) fn redo(app: &mut App) {
    let at = app.history.done;
    let Some(Edit { label, states, .. }) = app.history.edits.get(at).cloned() else {
        return app.report_progress("nothing to redo");
    };
    app.history.done = at + 1;
    app.report_progress(format!("redone: {label}"));
    make(app, &states.0, states.1);
}

/// Pins a scene, in the order of the letters, as one edit.
pub(crate) fn pin(app: &mut App, pin: Pin) {
    let (before, label) = (app.snapshot(), format!("pin {}", pin.label()));
    let at = app.pins.partition_point(|other| other.letter < pin.letter);
    app.pins.insert(at, pin);
    note(app, before, label, None);
    follow_pins(app);
}

/// Removes a pin, as one edit.
pub(crate) fn unpin(app: &mut App, gone: &Pin) {
    let (before, label) = (app.snapshot(), format!("unpin {}", gone.label()));
    app.pins.retain(|pin| pin.letter != gone.letter);
    note(app, before, label, None);
    follow_pins(app);
}

/// Updates after a change of the pins.
fn follow_pins(app: &mut App) {
    app.pages.run.selected = app.pages.run.selected.min(app.pins.len());
    jobs::submit_pins(app);
    app.request(Effect::SaveSession);
}

/// Resets the selected variable to the preset's value.
pub(crate) fn reset(app: &mut App) {
    let index = app.pages.run.editor.selected;
    let value = VARIABLES[index].value(&app.base.scene);
    if value == VARIABLES[index].value(&app.scene) {
        return app.report_progress(format!(
            "{} has the preset's value already",
            VARIABLES[index].symbol
        ));
    }
    finish(app, index, value, None);
}

/// Resets every variable to the preset's value.
pub(crate) fn reset_all(app: &mut App) {
    if !app.is_modified() {
        return app.report_progress("nothing differs from the preset");
    }
    let scene = (*app.base.scene).clone();
    let label = format!("reset all to {}", app.base.name);
    app.report_progress(format!("{label}: <undo> undoes"));
    commit_scene(app, scene, label, None);
}

/// Steps the selected variable: a number by its rule, a choice or switch to its neighbour.
pub(crate) fn step(app: &mut App, press: StepKey) {
    let index = app.pages.run.editor.selected;
    let variable = &VARIABLES[index];
    let (symbol, scene) = (variable.symbol, &app.scene);
    let number = match &variable.kind {
        Kind::Switch { get, .. } => return finish(app, index, Value::Switch(!get(scene)), None),
        Kind::Choice { words, get, .. } => {
            let next = cycled(get(scene), press.by(), words.len());
            return finish(app, index, Value::Word(words[next]), None);
        }
        Kind::Number(number) => number,
    };
    let value = match (number.get)(scene) {
        Some(value) => {
            // The step size is constant during repeated arrow keys.
            let plain = match app.pages.run.editor.stepped {
                Some((same, decade)) if same == index => decade,
                _ => value_steps::decade(variable, value),
            };
            app.pages.run.editor.stepped = Some((index, plain));
            value_steps::stepped(variable, value, press, plain)
        }
        None => press.up.then(|| value_steps::first_value(variable, number, scene)),
    };
    if let Some(value) = value {
        return finish(app, index, Value::Number(value), Some(index));
    }
    let direction = if press.up { "more" } else { "less" };
    let allowed = variable.allowed();
    app.report_progress(format!("{symbol} cannot be stepped to {direction}: it must be {allowed}"));
}

fn finish(app: &mut App, index: usize, value: Value, stepping: Option<usize>) {
    if let Err(error) = set(app, index, value, stepping) {
        app.refuse(error);
    }
}
