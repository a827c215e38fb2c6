//! A small drawing of projectile, plate, spring, damper and stop at the cursor's time: it moves with the crosshair.

use crate::model::run::Run;
use crate::model::scene::Mount;
use crate::numerics::{larger, smaller};
use crate::report::run::page;
use crate::report::series::Channel;
use crate::tui::pages::prelude::*;
use crate::tui::pages::run::CHARTS;
use crate::tui::pages::run::runs::engineering;

/// The projectile, its nose at the right; the plate.
const PROJECTILE: &str = "===)";
const PLATE: &str = "|###|";
/// Columns left of the plate where it stands farthest to the left, and those that a spring keeps.
const LEFT: u16 = 8;
const SPRING: u16 = 10;

/// Draw it in a frame that says when, how deep and how far.
pub(crate) fn render(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let Some(shown) = &app.shown else {
        PaneFrame::new("Mechanism").draw(area, canvas);
        return;
    };
    let run = &shown.run;
    let t_s = app.charts.cursor_s.unwrap_or_else(|| run.contact_end_s());
    let title = format!("Mechanism at {}", engineering(t_s, "s"));
    let at = |quantity: Channel| quantity.at(run, t_s).unwrap_or(0.0);
    let (depth_m, plate_m) = (at(Channel::Penetration), at(Channel::PlateDisplacement));
    let right = format!("p {}  x {}", engineering(depth_m, "m"), engineering(plate_m, "m"));
    let inner = PaneFrame::new(title).right(right).draw(area, canvas);
    let mount = inner.width.saturating_sub(2);
    let room = mount.saturating_sub(LEFT + columns(PLATE) + SPRING);
    if room < 2 || inner.height < 2 {
        return;
    }
    let plate = LEFT + cells(share(app, run, plate_m), room.min(inner.width / 3));
    let face = plate + columns(PLATE);
    let rows = inner.height.min(3);
    for row in 0..rows {
        canvas.put(inner, (mount, row), "|", Role::Text);
        canvas.put(inner, (plate, row), PLATE, Role::Curve(1));
    }
    let scene = &run.scene;
    let held = scene.plate.mount == Mount::Sprung;
    let gap = usize::from(mount.saturating_sub(face));
    let spring = if held { "/\\".repeat(gap.div_ceil(2)) } else { "=".repeat(gap) };
    let spring: String = spring.chars().take(gap).collect();
    canvas.put(inner, (face, 0), &spring, Role::Text);
    if held && !scene.mechanism.damper.is_absent() && rows > 1 {
        let piston = format!("{:-^gap$}", "[=]");
        canvas.put(inner, (face, 1), &piston, Role::Text);
    }
    if let (true, Some(stop_m)) = (held, scene.mechanism.stop.position_m) {
        let at = LEFT + columns(PLATE) + cells(share(app, run, stop_m), room.min(inner.width / 3));
        canvas.put(inner, (at.min(mount - 1), rows - 1), "]", Role::Warning);
    }
    // The nose by its depth in the plate: at the front face when it is not in, beyond the rear face after perforation.
    let thickness = scene.target.thickness_m;
    let depth = if thickness > 0.0 { (depth_m / thickness).clamp(0.0, 1.5) } else { 0.0 };
    let nose = plate + cells(depth, columns(PLATE));
    let start = nose.saturating_sub(columns(PROJECTILE));
    canvas.put(inner, (start, rows / 2), PROJECTILE, Role::Title);
}

/// Where a displacement stands between the least and the greatest of those in view.
fn share(app: &App, run: &Run, plate_m: f64) -> f64 {
    let (_, to_s) = app.time_range_s();
    let end_m = Channel::PlateDisplacement.at(run, to_s);
    let end_m = end_m.or_else(|| run.series.last().map(|last| last.plate_displacement_m));
    let cocked_m = -run.scene.plate.cocking_m;
    let known = [Some(cocked_m), end_m, Some(plate_m)];
    let known = || known.iter().flatten().copied();
    let (least, most) = (known().fold(0.0, smaller), known().fold(0.0, larger));
    if most > least { (plate_m - least) / (most - least) } else { 0.0 }
}

/// A fraction of a given number of cells, to the nearest one.
fn cells(fraction: f64, of: u16) -> u16 {
    let wanted = fraction * f64::from(of);
    (0..=2 * of).find(|cell| f64::from(*cell) + 0.5 > wanted).unwrap_or(2 * of)
}

pub(crate) fn events(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let keys = app.keymap.shown("<next-event> <previous-event>");
    let inner = PaneFrame::new("Events").right(keys).draw(area, canvas);
    let Some(shown) = &app.shown else { return };
    let lines = page::events(&shown.run);
    if lines.is_empty() {
        canvas.put(inner, (1, 0), "none", Role::Dim);
    }
    for (row, (line, event)) in (0..inner.height).zip(lines.iter().zip(&shown.run.events)) {
        canvas.put(inner, (1, row), line, Role::Text);
        if app.charts.cursor_s.is_some_and(|t_s| t_s.to_bits() == event.t_s.to_bits()) {
            canvas.paint_row(inner, row);
        }
    }
    let chart = app.charts.selected;
    canvas.rows(inner, (0, lines.len()), |event| {
        let value = shown.run.events.get(event)?.t_s;
        Some(Target::Value { pane: CHARTS, chart, value })
    });
}

pub(crate) fn ledger(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let inner = PaneFrame::new("Energy").draw(area, canvas);
    let Some(shown) = &app.shown else {
        return;
    };
    for (row, line) in (0..inner.height).zip(page::energy(&shown.run.ledger)) {
        canvas.put(inner, (1, row), &line, Role::Text);
    }
}
