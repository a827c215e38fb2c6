//! Line above the chart: the constant variables, and their differences from the caption of the figure.

use crate::tui::pages::page::prelude::*;
use crate::tui::pages::run::editor::{index_of, shown_in, spring_rows};
use cmra_engine::model::scene::SpringKind;
use cmra_engine::model::units;
use cmra_engine::model::variables::{VARIABLES, Value, Variable, is_offered};
use cmra_studies::study::sweep::Axis;
use cmra_studies::study::sweep::grid::Grid;
use cmra_studies::study::thesis::caption;

/// Variables of the line, by symbol: those of the figures of chapter 9, then the next most useful. Further variables of the spring stand
/// between the two parts.
const NAMED: ([&str; 5], [&str; 4]) =
    (["gamma", "d", "spring", "k", "n"], ["b", "theta", "h", "v_i"]);
/// Columns between two variables.
const GAP: usize = 2;

/// Returns the variables of the line, by index into the table, without those of another kind of spring.
fn named(scene: &Scene) -> impl Iterator<Item = usize> {
    let (first, last) = (NAMED.0.map(index_of), NAMED.1.map(index_of));
    let all = first.into_iter().chain(spring_rows(scene)).chain(last);
    all.filter(|index| is_offered(&VARIABLES[*index], scene))
}

/// Returns `true` for a value that needs no mention: normal impact, a power law, a single spring.
fn is_usual(variable: &Variable, scene: &Scene) -> bool {
    match variable.symbol {
        "theta" => scene.projectile.obliquity_deg == 0.0,
        "spring" => scene.mechanism.spring.kind == SpringKind::PowerLaw,
        "N_spring" => scene.mechanism.spring.is_single(),
        _ => false,
    }
}

/// Returns as many constant variables as fit; a variable that differs from the caption is followed by the caption's value.
pub(super) fn held(app: &App, grid: &Grid, room: usize) -> Vec<TextLine> {
    let axes = grid.plan().axes();
    let captions = caption(&app.base.name);
    let mut parts: Vec<TextLine> = Vec::new();
    for index in named(&app.scene) {
        let variable = &VARIABLES[index];
        let symbol = variable.symbol;
        let is_axis = axes.iter().any(|axis| axis.variable().key == variable.key);
        let is_none = variable.value(&app.scene) == Value::Absent;
        let is_zero = |scene: &Scene| {
            variable.number().and_then(|it| (it.get)(scene)).is_some_and(|value| value == 0.0)
        };
        if is_axis || is_none || is_usual(variable, &app.scene) {
            continue;
        }
        let unit = app.unit_of(symbol);
        let show = |scene: &Scene| {
            // Zero needs no unit.
            let unit = if is_zero(scene) { "" } else { unit };
            shown_in(variable, scene, unit, 4)
        };
        let own = format!("{symbol} {}", show(&app.scene));
        let printed = captions.iter().find(|it| it.0 == symbol).and_then(|(_, value)| {
            let mut scene = Scene::clone(&app.scene);
            (variable.number()?.set)(&mut scene, Some(*value));
            (scene != *app.scene).then(|| show(&scene))
        });
        parts.push(match printed {
            Some(printed) => (format!("{own} (caption: {printed}, see ?)"), Role::Warning),
            None => (own, Role::Dim),
        });
    }
    // Differences come first.
    parts.sort_by_key(|part| part.1 != Role::Warning);
    let mut left = room;
    parts.retain(|(text, _)| {
        let fits = usize::from(columns(text)) <= left;
        if fits {
            left = left.saturating_sub(usize::from(columns(text)) + GAP);
        }
        fits
    });
    parts
}

/// Draws the line.
pub(super) fn draw(app: &App, grid: &Grid, area: Rect, canvas: &mut Canvas<'_>) {
    let mut column = 1;
    for (text, role) in held(app, grid, usize::from(area.width.saturating_sub(2))) {
        column = canvas.put(area, (column, 0), &text, role) + 2;
    }
}

/// Returns the name of an axis value in a legend, in the display unit.
pub(super) fn legend(app: &App, axis: &Axis, at: u64) -> String {
    let unit = app.unit_of(axis.symbol());
    let number = axis.variable().number();
    let shown = |value: f64| {
        let value = number.and_then(|it| units::in_unit(value, unit, it.quantity)).unwrap_or(value);
        significant(value, 3)
    };
    // The first curve of the family shows the symbol, the last one the unit.
    let name = if at == 0 { format!("{}=", axis.symbol()) } else { String::new() };
    let is_last = at + 1 == axis.count() && !unit.is_empty();
    let unit = if is_last { format!(" {unit}") } else { String::new() };
    format!("{name}{}{unit}", shown(axis.value(at)))
}
