//! The setup of a sweep: choosing axes, ranges and output in place, and stepping the held variables.
//!
//! Every change is an edit of the scene's own `[sweep]` (or of a held variable), checked as a whole before it counts; a text
//! that is refused stays in its field.

use std::ops::RangeInclusive;

use crate::model::scene::{Scene, Sweep};
use crate::model::units::{self, Bare};
use crate::model::variables::{self, Kind, Number, VARIABLES, Variable};
use crate::study::quantities::QUANTITIES;
use crate::study::sweep::Axis;
use crate::study::sweep::grid::GRID_COUNTS;
use crate::tui::app::App;
use crate::tui::app::find::quantity_called;
use crate::tui::app::history::Setting;
use crate::tui::app::notice::Severity;
use crate::tui::dialogs::wrap;
use crate::tui::keymap::Action;
use crate::tui::message::Effect;
use crate::tui::pages::explore::state::{
    Picture, SetupRow, Spread, Sweeping, has_family, numeric, sweep_of,
};
use crate::tui::pages::run;
use crate::tui::pages::run::keys::step_of;
use crate::tui::pages::run::steps;
use crate::tui::pages::run::steps::Size;
use crate::tui::update::{edit, field};

/// The numbers of points the arrows go through.
const COUNTS: [usize; 9] = [5, 11, 21, 41, 101, 201, 401, 701, 1001];
/// How many curves a family may have.
const CURVES: RangeInclusive<u64> = 2..=7;

/// What an action does in the setup; `None` where it means nothing of its own.
pub(in crate::tui) fn act(app: &mut App, action: Action) -> Option<Vec<Effect>> {
    let picture = app.picture();
    let row = app.setup_row(picture);
    app.pages.explore.row = row;
    if let SetupRow::Held(index) = row {
        app.editor.selected = index;
    }
    if let Some((up, size)) = step_of(action) {
        return Some(match row {
            SetupRow::Held(_) => edit::step(app, up, size),
            row => step(app, picture, row, (up, size)),
        });
    }
    match (action, row) {
        (Action::Reset, SetupRow::Held(_)) => Some(edit::reset(app)),
        (Action::Reset, _) => {
            app.say(Severity::Note, "only held variables are reset here: u undoes an edit");
            Some(Vec::new())
        }
        (Action::Enter, row) => Some(open(app, picture, row)),
        _ => None,
    }
}

/// Open the field of a row, or take its next value where it has words.
fn open(app: &mut App, picture: Picture, row: SetupRow) -> Vec<Effect> {
    match row {
        SetupRow::Spacing(_) | SetupRow::Design | SetupRow::Picture => {
            step(app, picture, row, (true, Size::Plain))
        }
        // A list of the words, or the other of two.
        SetupRow::Held(index) if !matches!(VARIABLES[index].kind, Kind::Number(_)) => {
            run::keys::open(app)
        }
        row => {
            let choices = app.setup_choices(picture);
            field::open(app, choices.iter().position(|one| *one == row).unwrap_or(0))
        }
    }
}

/// The variable along on the other scale.
pub(in crate::tui) fn toggle_spacing(app: &mut App) -> Vec<Effect> {
    step(app, app.picture(), SetupRow::Spacing(0), (true, Size::Plain))
}

/// Take what was typed into the field of the selected row.
///
/// # Errors
/// Why it is refused.
pub(in crate::tui) fn take(app: &mut App, text: &str) -> Result<Vec<Effect>, String> {
    let picture = app.picture();
    let row = app.setup_row(picture);
    let mut sweep = sweep_of(&app.scene);
    let whole = |text: &str, counts: RangeInclusive<u64>| {
        text.parse::<usize>().map_err(|_not_a_number| {
            format!("`{text}` must be a whole number, {} to {}", counts.start(), counts.end())
        })
    };
    match row {
        SetupRow::Name(1) if picture == Picture::Line && text == "none" => {
            sweep.axes.truncate(1);
            return Ok(store(app, sweep, "one curve".to_owned()));
        }
        SetupRow::Name(at) => {
            let variable = variables::find(text).map_err(|error| error.to_string())?;
            sweep.axes[at] = fresh_axis(&app.scene, variable)?;
        }
        SetupRow::From(at) | SetupRow::To(at) => {
            let variable =
                variables::find(&sweep.axes[at].name).map_err(|error| error.to_string())?;
            let number = number_of(variable)?;
            let axis = &mut sweep.axes[at];
            let end = if row == SetupRow::From(at) { &mut axis.from } else { &mut axis.to };
            *end = units::parse_relative(text, *end, number.quantity, Bare::Stored)
                .map_err(|problem| format!("{}: {problem}", variable.symbol))?;
        }
        SetupRow::Points(at) => sweep.axes[at].count = whole(text, GRID_COUNTS)?,
        SetupRow::Curves => {
            let curves = whole(text, CURVES)? as u64;
            if !CURVES.contains(&curves) {
                let (least, most) = (CURVES.start(), CURVES.end());
                return Err(format!("curves = {curves} must be {least} to {most}"));
            }
            return tried(app, picture, |sweeping| sweeping.visits.curves = curves);
        }
        SetupRow::Output => {
            let output = quantity_called(text)?;
            let at = app.pages.explore.output.min(sweep.outputs.len() - 1);
            return Ok(choose_output(app, sweep, at, output.name));
        }
        SetupRow::Held(index) => return edit::type_value(app, index, text),
        SetupRow::Heading(_) | SetupRow::Spacing(_) | SetupRow::Design | SetupRow::Picture => {
            return Ok(Vec::new());
        }
    }
    checked(app, picture, sweep, row)
}

/// Show another output in the place of one; where it is among them already, just that one.
fn choose_output(app: &mut App, mut sweep: Sweep, at: usize, name: &str) -> Vec<Effect> {
    if let Some(there) = sweep.outputs.iter().position(|one| one == name) {
        app.pages.explore.output = there;
        return Vec::new();
    }
    name.clone_into(&mut sweep.outputs[at]);
    store(app, sweep, format!("show {name}"))
}

/// One press of an arrow on a row of the sweep itself.
fn step(app: &mut App, picture: Picture, row: SetupRow, (up, size): (bool, Size)) -> Vec<Effect> {
    let mut sweep = sweep_of(&app.scene);
    let by = if up { 1 } else { -1 };
    let result = match row {
        SetupRow::Name(at) => return next_variable(app, picture, at, by),
        SetupRow::From(at) | SetupRow::To(at) => step_end(&mut sweep, row, at, (up, size))
            .and_then(|()| checked(app, picture, sweep, row)),
        SetupRow::Points(at) => {
            let count = &mut sweep.axes[at].count;
            let next = if up {
                COUNTS.into_iter().find(|other| *other > *count)
            } else {
                COUNTS.into_iter().rev().find(|other| *other < *count)
            };
            *count = next.unwrap_or(*count);
            checked(app, picture, sweep, row)
        }
        SetupRow::Spacing(at) => {
            sweep.axes[at].log = !sweep.axes[at].log;
            checked(app, picture, sweep, row)
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
            let at = app.pages.explore.output.min(sweep.outputs.len() - 1);
            let here = QUANTITIES.iter().position(|column| column.name == sweep.outputs[at]);
            let next = wrap(here.unwrap_or(0), by, QUANTITIES.len());
            Ok(choose_output(app, sweep, at, QUANTITIES[next].name))
        }
        SetupRow::Heading(_) | SetupRow::Held(_) => Ok(Vec::new()),
    };
    result.unwrap_or_else(|error| {
        app.say(Severity::Error, error);
        Vec::new()
    })
}

fn step_end(
    sweep: &mut Sweep,
    row: SetupRow,
    at: usize,
    (up, size): (bool, Size),
) -> Result<(), String> {
    let variable = variables::find(&sweep.axes[at].name).map_err(|error| error.to_string())?;
    let number = number_of(variable)?;
    let axis = &mut sweep.axes[at];
    // A range's end is stepped by the size of the range: from 0 there is no size of its own.
    let greatest = if axis.from.abs() > axis.to.abs() { axis.from } else { axis.to };
    let stride = steps::decade(number, greatest);
    let end = if row == SetupRow::From(at) { &mut axis.from } else { &mut axis.to };
    let next = steps::stepped(number, *end, up, size, stride);
    *end = next.ok_or_else(|| {
        format!("{} cannot go further: it must be {}", variable.symbol, variable.allowed())
    })?;
    Ok(())
}

/// Another variable on an axis; across curves also none.
fn next_variable(app: &mut App, picture: Picture, at: usize, by: isize) -> Vec<Effect> {
    let mut sweep = sweep_of(&app.scene);
    let other = variables::find(&sweep.axes[1 - at].name).map(|found| found.key);
    let family = at == 1 && picture == Picture::Line;
    let alone = family && !has_family(&app.scene);
    let taken = |variable: &&'static Variable| {
        // The stand-in second axis gives way; one that a person chose does not.
        let stands_in = at == 0 && !has_family(&app.scene);
        stands_in || other != Ok(variable.key)
    };
    let choices: Vec<&'static Variable> = numeric().filter(taken).collect();
    let places = choices.len() + usize::from(family);
    let here = variables::find(&sweep.axes[at].name)
        .ok()
        .and_then(|now| choices.iter().position(|variable| variable.key == now.key));
    let here = if alone { places - 1 } else { here.unwrap_or(0) };
    let next = if alone && by > 0 {
        // From none to the usual one first.
        variables::find(&sweep.axes[at].name)
            .ok()
            .and_then(|now| choices.iter().position(|variable| variable.key == now.key))
            .unwrap_or(0)
    } else {
        wrap(here, by, places)
    };
    let Some(variable) = choices.get(next) else {
        sweep.axes.truncate(1);
        return store(app, sweep, "one curve".to_owned());
    };
    let result = fresh_axis(&app.scene, variable).and_then(|axis| {
        sweep.axes[at] = axis;
        checked(app, picture, sweep, SetupRow::Name(at))
    });
    result.unwrap_or_else(|error| {
        app.say(Severity::Error, error);
        Vec::new()
    })
}

/// An axis over a variable: the thesis's range, or from half to twice the present value.
fn fresh_axis(
    scene: &Scene,
    variable: &'static Variable,
) -> Result<crate::model::scene::SweepAxis, String> {
    let number = number_of(variable)?;
    let (from, to) = number.thesis_range.unwrap_or_else(|| {
        let value = (number.get)(scene).unwrap_or_else(|| steps::first_value(number));
        let (from, to) = if value == 0.0 { (0.0, 1.0) } else { (0.5 * value, 2.0 * value) };
        let most = match number.allowed {
            variables::Allowed::Between(_, high) => high,
            variables::Allowed::Below(_, high) => 0.75 * high,
            variables::Allowed::Positive
            | variables::Allowed::NonNegative
            | variables::Allowed::Any => f64::INFINITY,
        };
        (from, if to < most { to } else { most })
    });
    let name = variable.symbol.to_owned();
    Ok(crate::model::scene::SweepAxis { name, from, to, count: 41, log: false, values: Vec::new() })
}

fn number_of(variable: &'static Variable) -> Result<&'static Number, String> {
    match &variable.kind {
        Kind::Number(number) => Ok(number),
        Kind::Choice(_) | Kind::Switch { .. } => Err(format!(
            "{} has no numbers to sweep over, only {}: choose a numeric variable",
            variable.symbol,
            variable.allowed()
        )),
    }
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

/// Store a sweep that can be made; the refusal names axis, value, rule and cure.
fn checked(
    app: &mut App,
    picture: Picture,
    mut sweep: Sweep,
    row: SetupRow,
) -> Result<Vec<Effect>, String> {
    let second = matches!(
        row,
        SetupRow::Name(1)
            | SetupRow::From(1)
            | SetupRow::To(1)
            | SetupRow::Points(1)
            | SetupRow::Spacing(1)
    );
    // The stand-in second axis becomes the scene's own only when it is shown or touched.
    if picture == Picture::Line && !second && !has_family(&app.scene) {
        sweep.axes.truncate(1);
    }
    for axis in &sweep.axes {
        Axis::of(axis, &GRID_COUNTS).map_err(|error| error.to_string())?;
    }
    let edited = Scene { sweep: Some(sweep.clone()), ..Scene::clone(&app.scene) };
    app.sweep_plan_of(&edited, picture).map_err(|error| error.to_string())?;
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
