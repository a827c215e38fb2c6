//! Plan of a chart or map of the Explore tab.

use crate::tui::pages::explore::cursor::chart_kind;
use crate::tui::pages::explore::state::{CURVES, ChartKind, has_family, sweep_of};
use crate::tui::pages::page::prelude::*;
use crate::tui::preset::ReferencePreset;
use cmra_engine::model::scene::{ContactModel, SweepAxis};
use cmra_studies::study::sweep::grid::{self, GRID_COUNTS, Grid};
use cmra_studies::study::sweep::{Axis, Plan, Spacing, StudyError};

/// Returns `true` if a preset is a figure of the thesis, drawn with the corrected physics.
pub(crate) fn is_corrected_figure(base: &ReferencePreset) -> bool {
    base.name.starts_with("figure-9.") && base.scene.contact.model == ContactModel::Hydrodynamic
}

/// Spring exponents of the curves, chosen where they differ: at the thesis's stiffness the depth falls most steeply near 0.22.
const EXPONENTS: [f64; 5] = [0.2, 0.25, 0.3, 0.5, 1.0];

/// Returns the values of a second axis for which curves are drawn: the listed values, else a few over the range.
fn family(second: &Axis) -> Result<Axis, StudyError> {
    let (name, (from, to)) = (second.symbol(), second.ends());
    let (low, high) = (from.min(to), from.max(to));
    let within = EXPONENTS.into_iter().filter(|value| (low..high).contains(value) && *value > low);
    let mut values: Vec<f64> = std::iter::once(low).chain(within).chain([high]).collect();
    if second.spacing() == Spacing::Listed {
        return Ok(second.clone());
    }
    if name != "n" || values.len() < usize::try_from(CURVES).unwrap_or(usize::MAX) {
        return Axis::new(name, (from, to), CURVES, second.spacing());
    }
    if from > to {
        values.reverse();
    }
    let listed = SweepAxis { values, ..second.to_sweep_axis() };
    Axis::from_sweep_axis(&listed, &GRID_COUNTS)
}

/// Returns the plan of a figure's curves by the printed scheme of the thesis; `None` if the scene is not a figure, or already uses that
/// scheme.
pub(crate) fn printed_plan(app: &App) -> Option<Plan> {
    if !is_corrected_figure(&app.base)
        || app.scene.contact.model != ContactModel::Hydrodynamic
        || chart_kind(app) != ChartKind::Line
    {
        return None;
    }
    let mut scene = Scene::clone(&app.scene);
    scene.contact.model = ContactModel::Appendix;
    sweep_plan_of(app, &scene).ok()
}

/// Returns the plan of the displayed chart or map for the present scene.
pub fn sweep_plan(app: &App) -> Result<Plan, StudyError> {
    sweep_plan_of(app, &app.scene)
}

/// Builds the sweep plan for another scene.
pub fn sweep_plan_of(app: &App, scene: &Scene) -> Result<Plan, StudyError> {
    let sweep = sweep_of(scene);
    let axis = |at: usize| Axis::from_sweep_axis(&sweep.axes[at], &GRID_COUNTS);
    let mut axes = vec![axis(0)?];
    match chart_kind(app) {
        ChartKind::Line if has_family(scene) => {
            axes.push(family(&axis(1)?)?);
        }
        ChartKind::Line => {}
        ChartKind::Surface => axes.push(axis(1)?),
    }
    let plan = Plan::new(scene, axes, &sweep.outputs)?;
    grid::fits(&plan).map(|()| plan)
}

/// Explains why an output exists at no point of a picture, with the remedy.
pub fn no_value(grid: &Grid, output: usize) -> [String; 2] {
    let column = grid.plan().outputs()[output];
    let name = column.title();
    if grid.progress().0 == 0 {
        return ["sweeping the first points".to_owned(), String::new()];
    }
    let mut outcomes: Vec<_> = cells(grid).filter_map(|(x, y)| grid.outcome(x, y)).collect();
    outcomes.dedup();
    let why = match outcomes[..] {
        [outcome] => format!("no {name} at any point: {}", outcome.without_value(column)),
        _ => format!("no {name} at any point: {}", grid.outcomes()),
    };
    let cure = "<view>, or Show in the setup (<next-pane>): another output; or hold other values";
    [why, cure.to_owned()]
}

fn cells(grid: &Grid) -> impl Iterator<Item = (usize, usize)> {
    let (along, up) = grid.counts();
    (0..along).flat_map(move |x| (0..up).map(move |y| (x, y)))
}

/// Describes how many points came to rest without a value of an output, with the letter of these gaps and its meaning.
pub(crate) fn at_rest(grid: &Grid, output: usize) -> Option<String> {
    let is_empty = |(x, y): &(usize, usize)| grid.value(*x, *y, output).is_none();
    let outcomes = cells(grid).filter(is_empty).filter_map(|(x, y)| grid.outcome(x, y));
    let mut without = outcomes.filter(|outcome| outcome.is_stopped());
    let outcome = without.next()?;
    let why = outcome.without_value(grid.plan().outputs()[output]);
    let points = match without.count() {
        0 => "1 point".to_owned(),
        more => format!("{} points", more + 1),
    };
    Some(format!("{points} ({}): {why}", outcome.letter()))
}
