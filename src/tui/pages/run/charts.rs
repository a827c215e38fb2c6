//! Content of the charts: quantities, time ranges, crosshair, and points of every curve. No drawing.

pub(crate) mod draw;
mod titles;

use crate::tui::app::pins::RunView;
use crate::tui::chart::Unit;
use crate::tui::pages::page::prelude::*;
use crate::tui::pages::run::runs;
use crate::tui::pages::run::state::Window;
use crate::tui::widgets::along;
use crate::tui::widgets::place::{self, on_axis};
use cmra_engine::model::run::{Run, Sample};
use cmra_engine::model::units::{self, Bare, Dimension, engineering};
use cmra_engine::numerics::{larger, smaller};
use cmra_studies::report::figures::run::contact_window_s;
use cmra_studies::report::series::{Channel, thinned};

/// Points of a run, SI.
#[derive(Clone, Debug)]
pub struct Curve<'a> {
    pub view: RunView<'a>,
    /// Time, s, and value; NaN for a gap.
    pub points: Vec<(f64, f64)>,
}

/// Crosshair step, as a fraction of the displayed range.
const STEP: f64 = 0.01;

/// Plate displacement relative to the depth below which a plate counts as fixed.
const HELD: f64 = 1e-3;

/// Fraction of its path at which a plate counts as settled.
const SETTLED: f64 = 1e-2;

/// Returns `true` if the plate does not move visibly compared with the depth.
pub(crate) fn is_held(run: &Run) -> bool {
    let farthest = run.max_plate_displacement_m.map(f64::abs);
    let starts_at_zero = run.scene.start_m() == 0.0;
    let fraction = farthest.zip(run.penetration.final_m).map(|(farthest, depth)| farthest / depth);
    starts_at_zero && fraction.is_some_and(|fraction| fraction < HELD)
}

/// Returns the end time of the whole response, s. For a slowly returning plate, 1.5 times the time to settle to a hundredth of its path; if
/// nothing stops the plate, two contact times.
fn whole_s(run: &Run) -> f64 {
    let Some(last) = run.series.last() else { return 0.0 };
    let ahead_m = |row: &Sample| (row.plate_displacement_m - last.plate_displacement_m).abs();
    let way_m = run.series.iter().map(ahead_m).fold(0.0, larger);
    let settling = run.series.iter().rfind(|row| ahead_m(row) > SETTLED * way_m);
    let settled_s = larger(1.5 * settling.map_or(0.0, |row| row.t_s), contact_window_s(run));
    let end_s = smaller(last.t_s, settled_s);
    if is_free(run) { larger(end_s, 2.0 * run.contact_end_s()) } else { end_s }
}

/// Returns `true` if nothing stops the plate.
pub(crate) fn is_free(run: &Run) -> bool {
    let is_known = run.end.is_complete() && run.at_least.plate_displacement_m.is_none();
    is_known && run.max_plate_displacement_m.is_none()
}

/// Returns the end time of a chart, s; the start is the first contact.
pub fn end_s(app: &App, chart: usize) -> f64 {
    let of = |run: &Run| match app.pages.run.charts.windows[chart] {
        Window::Contact => contact_window_s(run),
        Window::Whole => whole_s(run),
    };
    let ends = app.visible_runs().into_iter().map(|view| of(view.run));
    let end_s = ends.filter(|end_s| end_s.is_finite()).fold(0.0, larger);
    if end_s > 0.0 { end_s } else { 1e-3 }
}

/// Returns the curves of a chart: for each run the points in view and the next one.
pub fn curves(app: &App, chart: usize) -> Vec<Curve<'_>> {
    let (quantity, end_s) = (app.pages.run.charts.quantities[chart], end_s(app, chart));
    let points = |run: &Run| {
        let seen = run.series.partition_point(|sample| sample.t_s <= end_s) + 1;
        // Over the displacement the whole path is drawn.
        let samples = run.series.get(..seen).filter(|_| quantity.is_over_time());
        let mut points = quantity.points(run, samples.unwrap_or(&run.series));
        if quantity == Channel::ContactForce && is_held(run) {
            // After the arrest the curve would show an invisible vibration.
            points.retain(|point| point.0 <= run.contact_end_s());
        }
        if quantity == Channel::PlateDisplacement && is_free(run) {
            points.extend(run.series.last().map(|last| {
                let t_s = whole_s(run);
                (t_s, last.plate_displacement_m + last.plate_velocity_m_s * (t_s - last.t_s))
            }));
        }
        if quantity.is_over_time() { thinned(points) } else { points }
    };
    let runs = app.visible_runs().into_iter();
    runs.map(|view| Curve { view, points: points(view.run) }).collect()
}

/// Moves the crosshair by hundredths of the displayed range, starting in the middle.
pub fn move_cursor(app: &mut App, by: isize) {
    let end_s = end_s(app, app.pages.run.charts.selected);
    let moved = |here: f64| (here + by as f64 * STEP * end_s).clamp(0.0, end_s);
    let cursor_s = &mut app.pages.run.charts.cursor_s;
    *cursor_s = Some(cursor_s.map_or(0.5 * end_s, moved));
}

/// Performs an action on the charts.
pub(crate) fn act(app: &mut App, action: Action) -> bool {
    use Action as A;
    let selected = app.pages.run.charts.selected;
    match action {
        A::Mark => runs::pin_scene(app),
        A::Window => window(app),
        A::View => {
            let mut next = app.pages.run.charts.quantities[selected].next();
            while app.pages.run.charts.quantities.contains(&next) {
                next = next.next();
            }
            app.pages.run.charts.quantities[selected] = next;
        }
        _ => match along(action) {
            Some(by) => move_cursor(app, by),
            None => return false,
        },
    }
    true
}

/// Parses a time, s, on the axis of the selected chart.
pub(crate) fn place(app: &App, text: &str) -> Result<Option<f64>, String> {
    let end_s = end_s(app, app.pages.run.charts.selected);
    let unit = Unit::with_prefix(end_s, "s").name;
    let read = |_: usize, text: &str| {
        let t_s = units::parse(text, Dimension::Time, Bare::In(&unit))?;
        on_axis("t", t_s, (0.0, end_s), |t_s| engineering(t_s, "s", 4))
    };
    Ok(place::values(text, &["t"], read)?[0])
}

/// Switches the time range of the selected chart.
fn window(app: &mut App) {
    let charts = &mut app.pages.run.charts;
    let (window, name) =
        (&mut charts.windows[charts.selected], charts.quantities[charts.selected].title());
    let (next, words) = match window {
        Window::Contact => (Window::Whole, "the whole response"),
        Window::Whole => (Window::Contact, "the contact, up to the last change of the depth"),
    };
    *window = next;
    app.report_progress(format!("{name}: {words}"));
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;
    use std::sync::Arc;

    use super::*;
    use cmra_engine::model::scene::Scene;
    use cmra_engine::model::simulate::{RunSnapshot, Settings, simulate};
    use cmra_engine::model::variables::changed;

    /// Without inertia, x' = -k x^n/b takes `b (100^(n-1) - 1)/(k (n-1) d^(n-1))` = 602 s from d to a hundredth of d, and continues
    /// forever.
    #[test]
    fn valid_the_whole_response_of_a_plate_that_creeps_on_is_that_until_it_has_settled() {
        let scene = changed(Scene::default(), "d=0.05 b=400 k=1e4 n=2.3").unwrap();
        let go_on = &mut |_: &RunSnapshot<'_>| ControlFlow::Continue(());
        let run = simulate(&Arc::new(scene), &Settings::SERIES, go_on).unwrap();
        let settled_s = 400.0 / (1e4 * 1.3) * (100f64.powf(1.3) - 1.0) / 0.05f64.powf(1.3);
        assert!(run.series.last().unwrap().t_s > 10.0 * settled_s);
        assert!((whole_s(&run) / settled_s - 1.5).abs() < 0.3, "{}", whole_s(&run));
    }
}
