//! Setup of Explore as a list: axes and output. No drawing.

use crate::tui::pages::explore::cursor::chart_kind;
use crate::tui::pages::explore::plan::is_corrected_figure;
use crate::tui::pages::explore::plan::{sweep_plan, sweep_plan_of};
use crate::tui::pages::explore::state::{ChartKind, SetupRow, completed, has_family, sweep_of};
use crate::tui::pages::page::prelude::*;
use crate::tui::widgets::axis::{Part, numeric, over};
use crate::tui::widgets::form::{Form, FormRow, quantity_after};
use crate::tui::widgets::value_steps::Input;
use crate::tui::widgets::{around, cycled};
use cmra_engine::model::scene::Sweep;
use cmra_engine::model::units;
use cmra_engine::model::variables::{self, Variable};
use cmra_studies::study::quantities::{Quantity, named};
use cmra_studies::study::sweep::Axis;
use cmra_studies::study::sweep::grid::GRID_COUNTS;

/// Returns the rows of the setup, headings included.
fn setup_rows(app: &App) -> Vec<SetupRow> {
    use SetupRow as R;
    let is_map = chart_kind(app) == ChartKind::Surface;
    let has_two = is_map || has_family(&app.scene);
    let mut rows = vec![R::Heading("Show"), R::Output, R::Picture, R::Heading("Along")];
    let along = [Part::Name, Part::From, Part::To, Part::Points, Part::Spacing];
    rows.extend(along.map(|part| R::Axis(0, part)));
    rows.extend([R::Heading("Across"), R::Axis(1, Part::Name)]);
    if has_two {
        rows.extend([R::Axis(1, Part::From), R::Axis(1, Part::To)]);
        rows.extend(is_map.then_some(R::Axis(1, Part::Points)));
        rows.push(R::Axis(1, Part::Spacing));
    }
    rows
}

/// Returns the selectable rows.
pub fn setup_choices(app: &App) -> Vec<SetupRow> {
    let mut rows = setup_rows(app);
    rows.retain(|row| !matches!(row, SetupRow::Heading(_)));
    rows
}

/// Returns the selected row; the first axis if the selection no longer exists.
pub(crate) fn setup_row(app: &App) -> SetupRow {
    let row = app.pages.explore.row;
    if setup_rows(app).contains(&row) { row } else { SetupRow::default() }
}

pub(crate) fn setup_form(app: &App) -> Form {
    let sweep = sweep_of(&app.scene);
    Form::new(&setup_rows(app), setup_row(app), |row| setup_line(app, row, &sweep))
}

/// Returns a row of the setup, with the sweep of the scene.
pub(crate) fn setup_line(app: &App, row: SetupRow, sweep: &Sweep) -> FormRow {
    let picture = chart_kind(app);
    // A default second axis is not displayed as chosen.
    let has_one = picture == ChartKind::Line && !has_family(&app.scene);
    match row {
        SetupRow::Heading(text) => FormRow::heading(text),
        SetupRow::Axis(1, Part::Name) if has_one => FormRow::typed("variable", "none").means(
            "curves can be repeated for values of a second variable: <right>, or <enter> and its name",
        ),
        SetupRow::Axis(at, part) => part.line(&sweep.axes[at], app.unit_of(&sweep.axes[at].name)),
        SetupRow::Picture => {
            let word = if picture == ChartKind::Line { "curves" } else { "map" };
            FormRow::choice("shown as", word).means(
                "curves: one for each value of the variable across, if any; map: colours over both",
            )
        }
        SetupRow::Output => {
            FormRow::quantity(&sweep.outputs[app.pages.explore.output_of(sweep)])
        }
    }
}

/// Changes the value of a row.
pub(crate) fn change(app: &mut App, row: SetupRow, input: Input<'_>) -> Result<(), String> {
    let mut sweep = sweep_of(&app.scene);
    let picture = chart_kind(app);
    match (row, input) {
        (SetupRow::Axis(1, Part::Name), Input::Text("none")) if picture == ChartKind::Line => {
            without_family(app, sweep);
        }
        (SetupRow::Axis(at, Part::Name), Input::Step(press)) => {
            next_variable(app, at, press.by())?;
        }
        (SetupRow::Axis(at, part), _) => {
            let unit = app.unit_of(&sweep.axes[at].name);
            part.change(&mut sweep.axes[at], (&app.scene, unit), input, &GRID_COUNTS)?;
            checked(app, sweep, at)?;
        }
        (SetupRow::Picture, Input::Step(press)) => {
            let next = around(&[ChartKind::Line, ChartKind::Surface], picture, press.by());
            show_as(app, next)?;
            if next == ChartKind::Surface && is_corrected_figure(&app.base) {
                app.report_progress("a map shows the corrected physics alone; as curves it has the printed scheme beside it");
            }
        }
        (SetupRow::Output, _) => {
            let name = &sweep.outputs[app.pages.explore.output_of(&sweep)];
            choose_output(app, quantity_after(name, input)?);
        }
        (SetupRow::Heading(_) | SetupRow::Picture, _) => {}
    }
    Ok(())
}

/// Replaces the displayed output; selects it alone if it is already among the outputs.
pub(crate) fn choose_output(app: &mut App, name: &str) {
    let mut sweep = sweep_of(&app.scene);
    if let Some(there) = sweep.outputs.iter().position(|one| one == name) {
        app.pages.explore.output = there;
        return;
    }
    sweep = settled(app, sweep, 0);
    let at = app.pages.explore.output_of(&sweep);
    name.clone_into(&mut sweep.outputs[at]);
    let title = named(name).map_or_else(|_| name.to_owned(), Quantity::title);
    store(app, sweep, format!("show {title}"));
}

/// Changes the variable of an axis; the second axis of curves may be none.
fn next_variable(app: &mut App, at: usize, by: isize) -> Result<(), String> {
    let mut sweep = sweep_of(&app.scene);
    let has_family = has_family(&app.scene);
    // Keep a second axis that the user chose.
    let other = variables::find(&sweep.axes[1 - at].name).ok().filter(|_| at == 1 || has_family);
    let is_there = |variable: &&'static Variable| {
        other.is_none_or(|other| !variables::exclude_each_other(other, variable))
    };
    let has_none = at == 1 && chart_kind(app) == ChartKind::Line;
    let choices = numeric(&app.scene).filter(is_there).map(Some);
    let choices: Vec<Option<&'static Variable>> = choices.chain(has_none.then_some(None)).collect();
    let now = variables::find(&sweep.axes[at].name).ok().filter(|_| has_family || !has_none);
    let own = choices.iter().position(|it| it.map(|it| it.key) == now.map(|it| it.key));
    match choices[cycled(own.unwrap_or(0), by, choices.len())] {
        Some(variable) => {
            sweep.axes[at] = over(&app.scene, variable, sweep.axes[at].count)?;
            checked(app, sweep, at)?;
        }
        None => without_family(app, sweep),
    }
    Ok(())
}

/// Removes the family of curves.
fn without_family(app: &mut App, mut sweep: Sweep) {
    sweep.axes.truncate(1);
    store(app, sweep, "one curve".to_owned());
}

/// Updates the sweep after a change of one of its axes. A default second axis is removed from curves, and kept for a map.
fn settled(app: &App, mut sweep: Sweep, changed: usize) -> Sweep {
    if changed == 0 && !has_family(&app.scene) {
        sweep.axes.truncate(1);
        if chart_kind(app) == ChartKind::Surface {
            sweep = completed(&app.scene, sweep);
        }
    }
    sweep
}

/// Shows curves or a map, if possible.
fn show_as(app: &mut App, picture: ChartKind) -> Result<(), String> {
    let state = app.snapshot();
    app.pages.explore.picture = picture;
    if let Err(error) = sweep_plan(app) {
        app.pages.explore.picture = state.picture;
        return Err(error.to_string());
    }
    let word = if picture == ChartKind::Line { "curves" } else { "a map" };
    edit::note(app, state, format!("show {word}"), None);
    Ok(())
}

/// Stores a valid sweep with one changed axis; the error names axis, value, rule and remedy.
fn checked(app: &mut App, sweep: Sweep, changed: usize) -> Result<(), String> {
    let sweep = settled(app, sweep, changed);
    for axis in &sweep.axes {
        Axis::from_sweep_axis(axis, &GRID_COUNTS).map_err(|error| error.to_string())?;
    }
    let edited = Scene { sweep: Some(sweep.clone()), ..Scene::clone(&app.scene) };
    sweep_plan_of(app, &edited).map_err(|error| error.to_string())?;
    let show = units::shortest;
    let words =
        sweep.axes.iter().map(|it| format!("{} {}..{}", it.name, show(it.from), show(it.to)));
    let words: Vec<String> = words.collect();
    store(app, sweep, format!("sweep {}", words.join(", ")));
    Ok(())
}

fn store(app: &mut App, sweep: Sweep, label: String) {
    let scene = Scene { sweep: Some(sweep), ..Scene::clone(&app.scene) };
    if scene != *app.scene {
        edit::commit_scene(app, scene, label, None);
    }
}
