//! Map of mass efficiency with its cursor, the slices through the cursor, and the design there.

use crate::tui::chart::{self, Chart, Curve, Frame, Mark, align_gutters};
use crate::tui::pages::explore::cursor::{place_on, places_of};
use crate::tui::pages::explore::state::{copy_value, nearest, placed};
use crate::tui::pages::limit::state::EFFICIENCY_MAP;
use crate::tui::pages::page::prelude::*;
use crate::tui::widgets::layout::NARROW;
use crate::tui::widgets::moved;
use crate::worker::studies::{EfficiencyMapStudy, MassComparison};
use cmra_engine::model::units::fixed_significant;
use cmra_studies::report::chart::Below;
use cmra_studies::report::compare::page::no_efficiency;
use cmra_studies::report::compare::picture;
use cmra_studies::report::figures::{axis_of, column_of};
use cmra_studies::report::map::Map;
use cmra_studies::study::compare::known_absence;
use cmra_studies::study::compare::map::{Map as EfficiencyMap, default_axes};
use cmra_studies::study::sweep::Axis;

/// Letter of the scene on the map.
const SCENE: char = 'S';
/// Minimum rows of two slices, one above the other: a title, three rows and an axis each.
const TWO_SLICES: u16 = 10;

/// Returns the map, possibly partial, if it belongs to this scene: the scene lies on the axes and differs in their variables only.
pub(crate) fn efficiency_map(app: &App) -> Option<&EfficiencyMap> {
    let kept = &app.pages.limit.map;
    let found = kept.result.as_deref()?;
    let axes = [found.x(), found.y()];
    let mut own = (*kept.scene).clone();
    own.sweep.clone_from(&app.scene.sweep);
    for axis in axes {
        copy_value(axis, &app.scene, &mut own);
    }
    let is_on = |axis: &Axis| {
        let (low, high) = axis.ends();
        axis.get(&app.scene).is_some_and(|own| (low..=high).contains(&own))
    };
    (own == *app.scene && axes.into_iter().all(is_on)).then_some(found)
}

/// Returns the point under the cursor; before it is moved, the point nearest to the scene.
fn map_point(app: &App, map: &EfficiencyMap) -> (usize, usize) {
    let own = |axis: &Axis| axis.get(&app.scene).and_then(|own| nearest(axis, own));
    let scene = || (own(map.x()).unwrap_or(0), own(map.y()).unwrap_or(0));
    app.pages.limit.cursor.unwrap_or_else(scene)
}

/// Returns the design under the cursor; before it is moved, the scene.
pub(crate) fn design(app: &App) -> Result<LabelledScene, String> {
    let Some(at) = app.pages.limit.cursor else {
        return Ok(LabelledScene { scene: (*app.scene).clone(), label: "scene".to_owned() });
    };
    let map = efficiency_map(app).ok_or_else(|| old("scene"))?;
    Ok(placed((*app.scene).clone(), values_at(map, at)))
}

/// Describes the point under the cursor: `v_i 150 m/s, gamma 2`; `None` before it is moved.
pub(super) fn point_words(app: &App) -> Option<String> {
    let values = values_at(efficiency_map(app)?, app.pages.limit.cursor?);
    let words = values.map(|(axis, value)| format!("{} {}", axis.symbol(), axis.show(value, 5)));
    Some(words.join(", "))
}

/// Returns the axes of the map with their values at a point.
fn values_at(map: &EfficiencyMap, (x, y): (usize, usize)) -> [(&Axis, f64); 2] {
    [(map.x(), x), (map.y(), y)].map(|(axis, at)| (axis, axis.value(at as u64)))
}

/// Returns `true` if a scene has a map.
pub(super) fn has_map(scene: &Scene) -> bool {
    scene.is_sprung() && known_absence(scene).is_none() && default_axes(scene).is_some()
}

/// Moves the cursor by points; the scene is unchanged.
pub(super) fn move_cursor(app: &mut App, by: (isize, isize)) {
    let Some(map) = efficiency_map(app) else {
        return app.report_progress(nothing::<EfficiencyMapStudy>(app, BEING_COMPUTED, None));
    };
    let next = moved(map_point(app, map), by, counts(map));
    app.pages.limit.cursor = Some(next);
}

fn counts(map: &EfficiencyMap) -> (usize, usize) {
    let count = |axis: &Axis| usize::try_from(axis.count()).unwrap_or(usize::MAX);
    (count(map.x()), count(map.y()))
}

pub(super) fn places(app: &App) -> Vec<(String, String)> {
    places_of(app, efficiency_map(app).into_iter().flat_map(|map| [map.x(), map.y()]))
}

pub(super) fn go_to_place(app: &mut App, text: &str) -> Result<(), String> {
    let Some(map) = efficiency_map(app) else { return Err(old("scene")) };
    let axes = [map.x().clone(), map.y().clone()];
    app.pages.limit.cursor = Some(place_on(app, &axes, map_point(app, map), text)?);
    Ok(())
}

/// Describes the point under the cursor.
pub(super) fn readout(app: &App) -> Option<String> {
    let map = efficiency_map(app)?;
    let Some(at) = app.pages.limit.cursor else {
        let own = [map.x(), map.y()].map(|axis| {
            let value = axis.get(&app.scene).unwrap_or_default();
            format!("{} {}", axis.symbol(), axis.show(value, 4))
        });
        let moves = app.keymap.shown("<left> <down> <up> <right> move, the numbers follow");
        return Some(format!("{SCENE}: this scene, {}; {moves}", own.join(", ")));
    };
    let place =
        values_at(map, at).map(|(axis, it)| format!("{} {}", axis.symbol(), axis.show(it, 4)));
    let words = match map.cell(at.0 as u64, at.1 as u64) {
        Some(Ok(value)) => format!("mass efficiency {}", fixed_significant(value, 4)),
        Some(Err(absence)) => absence.words(),
        None => not_yet(app, app.jobs.running::<EfficiencyMapStudy>()),
    };
    Some(format!("{}: {words}", place.join(", ")))
}

/// Draws the map, and right of it the slices through its cursor.
pub(super) fn render(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let focused = app.has_focus(EFFICIENCY_MAP);
    let found = efficiency_map(app);
    let absence = found.map_or_else(|| known_absence(&app.scene), EfficiencyMap::absence);
    let absence = no_efficiency(absence);
    let Some((found, map)) = found.and_then(|found| Some((found, picture(found)?))) else {
        let inner = PaneFrame::new("Mass efficiency").focused(focused).draw(area, canvas);
        let why = match found {
            Some(map) if map.is_complete() => Some(&*absence),
            Some(_) => Some(NOT_YET),
            _ if app.scene.is_stack() => Some("a stack is compared with nothing"),
            _ if !app.scene.is_sprung() => Some("the mount is rigid: there is no moving to pay"),
            _ if known_absence(&app.scene).is_some() => Some(&*absence),
            _ if !has_map(&app.scene) => Some("no map over v_i and the plate's size"),
            _ if app.jobs.running::<MassComparison>().is_some() => {
                Some("computed after the comparison")
            }
            _ => None,
        };
        return canvas
            .put_centred(inner, &nothing::<EfficiencyMapStudy>(app, "computing the map", why));
    };
    let has_slices = area.width >= NARROW;
    let (left, right) =
        split_left(area, if has_slices { area.width * 11 / 20 } else { area.width });
    let at = map_point(app, found);
    let column =
        |point: (usize, usize)| column_of(found.x(), point.0).zip(column_of(found.y(), point.1));
    let own = |axis: &Axis| axis.get(&app.scene).and_then(|own| nearest(axis, own));
    let present = own(found.x()).zip(own(found.y())).and_then(column);
    let title = format!("Mass efficiency, up: {}", found.y().symbol()).into();
    let mut map = Map { title, focused, present: present.map(|at| (at, SCENE)), ..map };
    map.cursor = app.pages.limit.cursor.and_then(column);
    let layout = canvas.draw_map(&map, left);
    canvas.plot(&layout, |x, y| {
        Some(Target::Cell(EFFICIENCY_MAP, (nearest(found.x(), x)?, nearest(found.y(), y)?)))
    });
    if has_slices {
        slices(found, at, right, canvas);
    }
}

/// Draws the mass efficiency along the row and the column of a point.
fn slices(map: &EfficiencyMap, (x, y): (usize, usize), area: Rect, canvas: &mut Canvas<'_>) {
    let (row, across) = map.row(y as u64);
    let (column, up) = map.column(x as u64);
    let is_both = area.height >= TWO_SLICES;
    let (above, below) = split_bottom(area, if is_both { area.height / 2 } else { 0 });
    let parts = [
        (map.x(), (map.y(), row, y), across, x, above, Below::Across),
        (map.y(), (map.x(), column, x), up, y, below, Below::End),
    ];
    let mut charts: Vec<(Chart<'_>, Rect)> = Vec::new();
    for (axis, (held, held_at, wanted), points, own, area, below) in parts {
        let points: Vec<(f64, f64)> =
            points.into_iter().map(|(at, value)| (axis.value(at), value)).collect();
        let begins = charts.is_empty();
        let frame = Frame::Stacked { begins, below: if is_both { below } else { Below::End } };
        let held = format!("{} {}", held.symbol(), held.show(held.value(held_at), 3));
        // A partial map may lack the line of the cursor.
        let at = if held_at == wanted as u64 { "at" } else { "nearest" };
        let title = format!("over {}, {at} {held}", axis.symbol());
        let values = points.iter().map(|point| point.1).filter(|value| value.is_finite());
        let Some(y) = chart::Axis::fitted("", "", values) else { continue };
        let curve = Curve::new('*', "", points);
        let levels = vec![Mark::new(1.0, "")];
        let crosshair = Some(axis.value(own as u64));
        let chart =
            Chart { crosshair, frame, levels, ..Chart::new(title, axis_of(axis), y, vec![curve]) };
        charts.push((chart, area));
        if !is_both {
            break;
        }
    }
    if charts.is_empty() {
        let inner = PaneFrame::new("Slices through the cursor").draw(area, canvas);
        return canvas.put_centred(inner, "too few points yet");
    }
    let areas: Vec<Rect> = charts.iter().map(|it| it.1).collect();
    let mut charts: Vec<Chart<'_>> = charts.into_iter().map(|it| it.0).collect();
    align_gutters(&mut charts, &areas);
    for (chart, area) in charts.iter().zip(areas) {
        canvas.draw(chart, area);
    }
}
