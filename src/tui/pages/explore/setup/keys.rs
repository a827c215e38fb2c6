//! The setup of a sweep: choosing axes, ranges and output in place, and stepping the held variables.
//!
//! Every change is an edit of the scene's own `[sweep]` (or of a held variable), checked as a whole before it counts; a text
//! that is refused stays in its field.

use std::ops::RangeInclusive;

use crate::model::scene::{Scene, Sweep};
use crate::model::units;
use crate::model::variables::{self, Kind, VARIABLES, Variable};
use crate::study::sweep::Axis;
use crate::study::sweep::grid::GRID_COUNTS;
use crate::tui::app::App;
use crate::tui::app::find::quantity_called;
use crate::tui::app::history::Setting;
use crate::tui::app::notice::Severity;
use crate::tui::dialogs::wrap;
use crate::tui::keymap::Action;
use crate::tui::message::Effect;
use crate::tui::pages::explore::setup::{Part, SetupRow};
use crate::tui::pages::explore::state::{Picture, Spread, Sweeping, has_family, sweep_of};
use crate::tui::pages::run;
use crate::tui::pages::run::steps::Press;
use crate::tui::update::edit;
use crate::tui::widgets::axis::{numeric, over, place, whole};
use crate::tui::widgets::form::quantity_beside;

/// How many curves a family may have.
const CURVES: RangeInclusive<u64> = 2..=7;

/// What an action does to a held variable beside typing a number; `None` where it means nothing of its own.
pub(in crate::tui) fn act(app: &mut App, action: Action) -> Option<Vec<Effect>> {
    let SetupRow::Held(index) = app.setup_row() else {
        let text = "only held variables are reset here: u undoes an edit";
        return (action == Action::Reset).then(|| {
            app.say(Severity::Note, text);
            Vec::new()
        });
    };
    app.editor.selected = index;
    match action {
        Action::Reset => Some(edit::reset(app)),
        // A list of the words, or the other of two.
        Action::Enter if !matches!(VARIABLES[index].kind, Kind::Number(_)) => {
            Some(run::keys::open(app))
        }
        _ => None,
    }
}

/// The variable along on the other scale.
pub(in crate::tui) fn toggle_spacing(app: &mut App) -> Vec<Effect> {
    let stepped = step(app, SetupRow::Axis(0, Part::Spacing), Press::NEXT);
    stepped.unwrap_or_else(|error| app.refuse(error))
}

/// Take what was typed into the field of a row.
///
/// # Errors
/// Why it is refused.
pub(in crate::tui) fn take(
    app: &mut App,
    row: SetupRow,
    text: &str,
) -> Result<Vec<Effect>, String> {
    let mut sweep = sweep_of(&app.scene);
    match row {
        SetupRow::Axis(1, Part::Name) if app.picture() == Picture::Line && text == "none" => {
            sweep.axes.truncate(1);
            Ok(store(app, sweep, "one curve".to_owned()))
        }
        SetupRow::Axis(at, part) => {
            part.read(&mut sweep.axes[at], &app.scene, text, &GRID_COUNTS)?;
            checked(app, sweep, at)
        }
        SetupRow::Curves => {
            let curves = whole(text, &CURVES)?;
            tried(app, app.picture(), |sweeping| sweeping.visits.curves = curves)
        }
        SetupRow::Output => {
            let output = quantity_called(text)?;
            Ok(choose_output(app, sweep, output.name))
        }
        SetupRow::Held(index) => edit::type_value(app, index, text),
        SetupRow::Heading(_) | SetupRow::Design | SetupRow::Picture => Ok(Vec::new()),
    }
}

/// Show another output in the place of the one shown; where it is among them already, just that one.
fn choose_output(app: &mut App, mut sweep: Sweep, name: &str) -> Vec<Effect> {
    if let Some(there) = sweep.outputs.iter().position(|one| one == name) {
        app.pages.explore.output = there;
        return Vec::new();
    }
    let at = app.pages.explore.output_of(&sweep);
    name.clone_into(&mut sweep.outputs[at]);
    store(app, sweep, format!("show {name}"))
}

/// One press of an arrow on a row.
///
/// # Errors
/// Why there is no such value.
pub(in crate::tui) fn step(
    app: &mut App,
    row: SetupRow,
    press: Press,
) -> Result<Vec<Effect>, String> {
    let mut sweep = sweep_of(&app.scene);
    let picture = app.picture();
    let by = press.by();
    match row {
        SetupRow::Axis(at, Part::Name) => next_variable(app, at, by),
        SetupRow::Axis(at, part) => {
            part.step(&mut sweep.axes[at], &app.scene, press)?;
            checked(app, sweep, at)
        }
        SetupRow::Picture => {
            let next = match picture {
                Picture::Line => Picture::Surface,
                Picture::Surface => Picture::Line,
            };
            tried(app, next, |sweeping| sweeping.visits.picture = next)
        }
        SetupRow::Design => {
            let all = Spread::ALL;
            let here = app.pages.explore.spread(picture);
            let at = all.iter().position(|one| *one == here).unwrap_or(0);
            let next = all[wrap(at, by, all.len())];
            tried(app, picture, |sweeping| sweeping.set_spread(picture, next))
        }
        SetupRow::Curves => {
            let curves = app.pages.explore.visits.curves.saturating_add_signed(by as i64);
            let next = curves.clamp(*CURVES.start(), *CURVES.end());
            tried(app, picture, |sweeping| sweeping.visits.curves = next)
        }
        SetupRow::Output => {
            let next = quantity_beside(&sweep.outputs[app.pages.explore.output_of(&sweep)], by);
            Ok(choose_output(app, sweep, next))
        }
        SetupRow::Held(_) => Ok(edit::step(app, press)),
        SetupRow::Heading(_) => Ok(Vec::new()),
    }
}

/// Another variable on an axis; across curves also none.
fn next_variable(app: &mut App, at: usize, by: isize) -> Result<Vec<Effect>, String> {
    let mut sweep = sweep_of(&app.scene);
    let other = variables::find(&sweep.axes[1 - at].name).map(|found| found.key);
    let family = at == 1 && app.picture() == Picture::Line;
    let alone = family && !has_family(&app.scene);
    let taken = |variable: &&'static Variable| {
        // The stand-in second axis gives way; one that a person chose does not.
        let stands_in = at == 0 && !has_family(&app.scene);
        stands_in || other != Ok(variable.key)
    };
    let choices: Vec<&'static Variable> = numeric().filter(taken).collect();
    let places = choices.len() + usize::from(family);
    let own = place(&sweep.axes[at], &choices).unwrap_or(0);
    let next = match (alone, by > 0) {
        // From none to the usual one first.
        (true, true) => own,
        (true, false) => wrap(places - 1, by, places),
        (false, _) => wrap(own, by, places),
    };
    let Some(variable) = choices.get(next) else {
        sweep.axes.truncate(1);
        return Ok(store(app, sweep, "one curve".to_owned()));
    };
    sweep.axes[at] = over(&app.scene, variable, sweep.axes[at].count)?;
    checked(app, sweep, at)
}

/// Change what a picture visits, unless the picture cannot be made then.
fn tried(
    app: &mut App,
    picture: Picture,
    change: impl FnOnce(&mut Sweeping),
) -> Result<Vec<Effect>, String> {
    let (before, old) = (app.pages.explore.visits, app.pages.explore.spread(picture));
    change(&mut app.pages.explore);
    if let Err(error) = app.sweep_plan(picture) {
        app.pages.explore.visits = before;
        return Err(error.to_string());
    }
    let (after, new) = (app.pages.explore.visits, app.pages.explore.spread(picture));
    if after == before {
        return Ok(Vec::new());
    }
    let label = if before.picture != after.picture {
        let word = if after.picture == Picture::Line { "curves" } else { "a map" };
        format!("show {word}")
    } else if old == new {
        format!("curves {} -> {}", before.curves, after.curves)
    } else {
        format!("design {} -> {}", old.word(), new.word())
    };
    let setting = (Setting::Visits(before), Setting::Visits(after));
    edit::note_setting(app, setting, label, None);
    Ok(crate::tui::pages::explore::keys::after_edit(app))
}

/// Store a sweep that can be made, changed in one of its axes; the refusal names axis, value, rule and cure.
fn checked(app: &mut App, mut sweep: Sweep, changed: usize) -> Result<Vec<Effect>, String> {
    // The stand-in second axis becomes the scene's own only when it is shown or touched.
    if app.picture() == Picture::Line && changed == 0 && !has_family(&app.scene) {
        sweep.axes.truncate(1);
    }
    for axis in &sweep.axes {
        Axis::of(axis, &GRID_COUNTS).map_err(|error| error.to_string())?;
    }
    let edited = Scene { sweep: Some(sweep.clone()), ..Scene::clone(&app.scene) };
    app.sweep_plan_of(&edited, app.picture()).map_err(|error| error.to_string())?;
    let words: Vec<String> = sweep
        .axes
        .iter()
        .map(|axis| {
            let show = units::shortest;
            format!("{} {}..{}", axis.name, show(axis.from), show(axis.to))
        })
        .collect();
    Ok(store(app, sweep, format!("sweep {}", words.join(", "))))
}

fn store(app: &mut App, sweep: Sweep, label: String) -> Vec<Effect> {
    let mut scene = (*app.scene).clone();
    scene.sweep = Some(sweep);
    if scene == *app.scene {
        return Vec::new();
    }
    edit::commit_scene(app, scene, label, None)
}
