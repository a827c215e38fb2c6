//! Pinning, unpinning, loading, showing and hiding runs.

use std::sync::Arc;

use crate::model::scene::Scene;
use crate::model::units;
use crate::model::variables;
use crate::study::models::by_every_model;
use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::message::Effect;
use crate::tui::pages::run::runs::{LETTERS, Pin};
use crate::tui::update::{edit, jobs};

/// Pin the scene, or unpin it where it is pinned already.
pub(in crate::tui) fn pin_scene(app: &mut App) -> Vec<Effect> {
    if let Some(pin) = app.pins.iter().find(|pin| *pin.scene == *app.scene).cloned() {
        return unpinned(app, pin);
    }
    let name = app.name_of(&app.scene);
    let scene = Arc::clone(&app.scene);
    pin(app, name, scene)
}

/// Pin the design under a cursor, or say why there is none.
pub(in crate::tui) fn pin_design(
    app: &mut App,
    design: Result<(Scene, String), String>,
) -> Vec<Effect> {
    match design {
        Ok((scene, label)) => pin(app, label, Arc::new(scene)),
        Err(why) => app.refuse(why),
    }
}

/// Freeze a scene under the next free letter; its result is the one on the screen, or is computed.
pub(in crate::tui) fn pin(app: &mut App, name: String, scene: Arc<Scene>) -> Vec<Effect> {
    if let Some(pin) = app.pins.iter().find(|pin| *pin.scene == *scene) {
        let text = format!("this scene is pinned already, as {}", pin.letter);
        app.say(Severity::Note, text);
        return Vec::new();
    }
    let free = |letter: &char| app.pins.iter().all(|pin| pin.letter != *letter);
    let Some(letter) = LETTERS.into_iter().find(free) else {
        return app
            .refuse("all eight pins A to H are taken: Space on one in the pane Runs unpins it");
    };
    let run = app
        .shown
        .as_ref()
        .filter(|shown| *shown.run.scene == *scene)
        .map(|shown| Arc::clone(&shown.run));
    app.say(Severity::Note, format!("pinned as {letter}: {name}"));
    insert(app, Pin { letter, name, scene, run, visible: true, job: None })
}

/// Pin the scene by every interaction model but its own; take them away when all are there.
pub(in crate::tui) fn models(app: &mut App) -> Vec<Effect> {
    let own = app.scene.contact.model;
    let mut refused = None;
    let mut wanted: Vec<(&str, Arc<Scene>)> = Vec::new();
    for (name, scene) in by_every_model(&app.scene) {
        match variables::validate(&scene) {
            Ok(()) if scene.contact.model != own => wanted.push((name, Arc::new(scene))),
            Ok(()) => {}
            Err(reason) => refused = Some(reason.to_string()),
        }
    }
    if let (true, Some(reason)) = (wanted.is_empty(), &refused) {
        return app.refuse(reason.clone());
    }
    let is_pinned = |app: &App, scene: &Scene| app.pins.iter().any(|pin| *pin.scene == *scene);
    let missing: Vec<_> =
        wanted.iter().filter(|(_, scene)| !is_pinned(app, scene)).cloned().collect();
    if missing.is_empty() {
        app.pins.retain(|pin| wanted.iter().all(|(_, scene)| *pin.scene != **scene));
        app.selected_run = app.selected_run.min(app.pins.len());
        app.charts.difference &= !app.pins.is_empty();
        app.say(Severity::Note, "the other interaction models are unpinned");
        return vec![Effect::SaveSession];
    }
    let room = LETTERS.len() - app.pins.len();
    if missing.len() > room {
        let text = format!(
            "{} models need a pin each, and {room} of the eight pins are free: Space on one in the pane Runs unpins it",
            missing.len()
        );
        return app.refuse(text);
    }
    let mut effects = Vec::new();
    for (name, scene) in missing {
        effects.extend(pin(app, name.to_owned(), scene));
    }
    let rest =
        if refused.is_some() { "; models that cannot run this scene are not drawn" } else { "" };
    app.say(
        Severity::Note,
        format!(
            "{} and the other models side by side (the same again takes them away){rest}",
            own.word()
        ),
    );
    effects
}

/// The pin that is selected in the table of runs.
fn selected(app: &mut App) -> Option<usize> {
    let found = app.selected_run.checked_sub(1).filter(|at| *at < app.pins.len());
    if found.is_none() {
        app.say(
            Severity::Note,
            if app.pins.is_empty() {
                "no run is pinned yet: Space pins the current one"
            } else {
                "select a pinned run first (j, k): the first row is the current run"
            },
        );
    }
    found
}

pub(in crate::tui) fn unpin(app: &mut App) -> Vec<Effect> {
    let Some(at) = selected(app) else {
        return Vec::new();
    };
    let pin = app.pins[at].clone();
    unpinned(app, pin)
}

fn unpinned(app: &mut App, pin: Pin) -> Vec<Effect> {
    let effects = take_away(app, &pin);
    app.say(Severity::Note, format!("unpinned {}: {} (u undoes)", pin.letter, pin.name));
    edit::note_unpinned(app, pin);
    effects
}

/// Remove the pin of this scene.
pub(in crate::tui) fn take_away(app: &mut App, gone: &Pin) -> Vec<Effect> {
    // By its scene, not by its letter: that may have become another one's since.
    app.pins.retain(|pin| *pin.scene != *gone.scene);
    app.selected_run = app.selected_run.min(app.pins.len());
    if app.pins.is_empty() {
        app.charts.difference = false;
    }
    vec![Effect::SaveSession]
}

/// Put a pin back that had been taken away, under its letter or, if that is taken, the first free one.
pub(in crate::tui) fn put_back(app: &mut App, pin: Pin) -> Vec<Effect> {
    if app.pins.iter().any(|other| *other.scene == *pin.scene) {
        return Vec::new();
    }
    let free = |letter: &char| app.pins.iter().all(|other| other.letter != *letter);
    let Some(letter) = std::iter::once(pin.letter).chain(LETTERS).find(free) else {
        return app.refuse("all eight pins A to H are taken: nothing was put back");
    };
    // A job under way when it was taken away has reported to nobody.
    insert(app, Pin { letter, job: None, ..pin })
}

/// Among the pins, in the order of their letters.
fn insert(app: &mut App, pin: Pin) -> Vec<Effect> {
    let at = app.pins.partition_point(|other| other.letter < pin.letter);
    app.pins.insert(at, pin);
    let mut effects = jobs::submit_pins(app);
    effects.push(Effect::SaveSession);
    effects
}

pub(in crate::tui) fn load(app: &mut App) -> Vec<Effect> {
    let Some(at) = selected(app) else {
        return Vec::new();
    };
    let pin = &app.pins[at];
    if *pin.scene == *app.scene {
        app.say(Severity::Note, "the current scene is this one already");
        return Vec::new();
    }
    let label = format!("load {}: {}", pin.letter, pin.name);
    let scene = (*pin.scene).clone();
    app.say(Severity::Note, format!("{label} (u undoes)"));
    edit::commit_scene(app, scene, label, None)
}

pub(in crate::tui) fn show_or_hide(app: &mut App) -> Vec<Effect> {
    match app.selected_run.checked_sub(1) {
        None => app.current_visible = !app.current_visible,
        Some(at) => {
            if let Some(pin) = app.pins.get_mut(at) {
                pin.visible = !pin.visible;
            }
        }
    }
    Vec::new()
}

/// Copy the results of the run shown.
pub(in crate::tui) fn copy(app: &mut App) -> Vec<Effect> {
    let Some(shown) = &app.shown else {
        return app.refuse("nothing to copy yet: r runs the scene");
    };
    let run = &shown.run;
    let number = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), units::shortest);
    let name = app.name_of(&run.scene);
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
