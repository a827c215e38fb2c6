//! The charts of a run: what happened in time, and the law of the mechanism that the plate stands on.

use crate::model::mechanism::{Mechanism, load};
use crate::model::run::{Run, Sample};
use crate::model::scene::Spring;
use crate::numerics::{larger, smaller};
use crate::report::chart::{Axis, Chart, Curve, Mark, Scale};
use crate::report::series::Quantity;

/// The quantity drawn over time.
const QUANTITIES: [Quantity; 3] =
    [Quantity::Penetration, Quantity::PlateDisplacement, Quantity::ContactForce];
/// How far beyond the greatest displacement the law of the mechanism is drawn, and up to which part of it a limit is still shown.
const BEYOND: f64 = 1.15;
const LIMIT_SHOWN: f64 = 2.5;
/// Points of a drawn law.
const POINTS: u32 = 400;

/// The letter an event goes by in charts and lists: `a` to `z`, later ones have none.
pub fn event_letter(index: usize) -> &'static str {
    const LETTERS: &str = "abcdefghijklmnopqrstuvwxyz";
    LETTERS.get(index..=index).unwrap_or("")
}

/// The events of a part of the time, with their letters.
pub fn event_marks(run: &Run, (from, to): (f64, f64)) -> impl Iterator<Item = Mark<'static>> + '_ {
    let events = run.events.iter().enumerate();
    let seen = events.filter(move |(_, event)| (from..=to).contains(&event.t_s));
    seen.map(|(index, event)| Mark::new(event.t_s, event.kind.words()).tag(event_letter(index)))
}

/// Penetration, displacement and force over time: during the contact, which is over in a fraction of a millisecond, then over
/// the whole response, where there is more of it.
pub fn response(run: &Run) -> Vec<Chart<'static>> {
    let Some(end_s) = run.series.last().map(|row| row.t_s) else {
        return Vec::new();
    };
    // A little beyond its end, so that the end itself is seen.
    let window_s = smaller(1.1 * run.contact_end_s(), end_s);
    let mut charts = over_time(run, "contact", window_s);
    if end_s > 2.0 * window_s {
        charts.extend(over_time(run, "whole response", end_s));
    }
    charts
}

fn over_time(run: &Run, window: &str, end_s: f64) -> Vec<Chart<'static>> {
    let chart = |quantity: &Quantity| {
        let points = points(&run.series, *quantity);
        let name = format!("{} {}", quantity.title().to_lowercase(), quantity.symbol());
        let shown = points.iter().filter(|point| point.0 <= end_s).map(|point| point.1);
        // A chart of one value would be a line along its own frame.
        let values = Axis::over("", quantity.unit(), Scale::Linear, shown)?;
        let y = Axis { label: name.clone().into(), ..values.with_zero().padded(0.05) };
        let x = Axis::over("t", "s", Scale::Linear, [0.0, end_s])?;
        let title = format!("{name}, {window}");
        let curve = Curve::new('*', "", points);
        let marks = event_marks(run, (0.0, end_s)).collect();
        Some(Chart { marks, ..Chart::new(title, x, y, vec![curve]) })
    };
    if end_s > 0.0 { QUANTITIES.iter().filter_map(chart).collect() } else { Vec::new() }
}

/// A quantity over time. Where the force jumps, the row of the event has the value before it: the one after it is carried back to
/// the event from the next two rows.
fn points(series: &[Sample], quantity: Quantity) -> Vec<(f64, f64)> {
    let point = |row: &Sample| (row.t_s, quantity.of(row));
    let mut points: Vec<(f64, f64)> = series.first().map(point).into_iter().collect();
    for (at, pair) in series.windows(2).enumerate() {
        let ((event_s, _), (t_s, value)) = (point(&pair[0]), point(&pair[1]));
        let next = series.get(at + 2).filter(|next| next.mode == pair[1].mode && next.t_s > t_s);
        if let Some(next) =
            next.filter(|_| quantity == Quantity::ContactForce && pair[0].mode != pair[1].mode)
        {
            let slope = (quantity.of(next) - value) / (next.t_s - t_s);
            points.push((event_s, value - slope * (t_s - event_s)));
        }
        points.push((t_s, value));
    }
    points
}

/// Force, stiffness and stress of the mechanism over the plate's displacement, with what the run used of it; nothing without a
/// mechanism.
pub fn mechanism(run: &Run) -> Vec<Chart<'static>> {
    let scene = &run.scene;
    let own = Mechanism::of(scene);
    let reached = run.max_plate_displacement_m.or(run.at_least.plate_displacement_m);
    let start_m = run.start_m();
    let Some(reached_m) = reached.filter(|it| *it > start_m) else { return Vec::new() };
    if own.spring.is_absent() && own.elastic_stop().is_none() {
        return Vec::new();
    }
    let yields = scene.mechanism.acting().filter_map(Spring::yields_at_m).reduce(smaller);
    let yields = yields.filter(|at| *at < LIMIT_SHOWN * reached_m);
    let end_m = BEYOND * yields.map_or(reached_m, |at| larger(at, reached_m));
    let low_m = smaller(start_m, 0.0);
    let at = |point: u32| low_m + (end_m - low_m) * f64::from(point) / f64::from(POINTS);
    let stop = own.elastic_stop();
    let in_stop = |x: f64| stop.filter(|stop| stop.position_m.is_some_and(|at| x > at));
    let force = |x: f64| {
        let stopped = in_stop(x).map_or(0.0, |it| it.stiffness_n_m * (x - own.stop_at_m));
        Some(own.spring.force(x) + stopped)
    };
    let stiffness =
        |x: f64| Some(own.spring.tangent(x) + in_stop(x).map_or(0.0, |it| it.stiffness_n_m));
    let stress = |x: f64| load::stress_ratio(scene, x);
    let mut marks = vec![Mark::new(reached_m, "greatest displacement")];
    marks.extend((start_m < 0.0).then(|| Mark::new(start_m, "cocked")));
    marks.extend(own.stop.map(|_| Mark::new(own.stop_at_m, "stop")));
    marks.extend(yields.map(|at| Mark::new(at, "yield")));
    let chart = |title: &'static str, unit: &'static str, get: &dyn Fn(f64) -> Option<f64>| {
        let points = (0..=POINTS).map(at).map(|x| (x, get(x).unwrap_or(f64::NAN)));
        let points: Vec<(f64, f64)> = points.collect();
        let x = Axis::over("plate displacement x", "m", Scale::Linear, [low_m, end_m])?;
        let y = Axis::over(title, unit, Scale::Linear, points.iter().map(|point| point.1))?;
        let curve = Curve::new('*', "", points);
        let chart = Chart::new(title, x, y.with_zero().padded(0.05), vec![curve]);
        Some(Chart { marks: marks.clone(), ..chart })
    };
    let mut charts: Vec<Chart<'static>> = Vec::new();
    charts.extend(chart("force of the mechanism F(x)", "N", &force));
    charts.extend(chart("stiffness of the mechanism dF/dx", "N/m", &stiffness));
    if let Some(mut chart) = chart("greatest stress over yield strength", "", &stress) {
        chart.levels.push(Mark::new(1.0, "yield"));
        charts.push(chart);
    }
    charts
}

/// The pictures of a file: contact, the plate's whole way, the mechanism.
pub fn selected(run: &Run) -> Vec<Chart<'static>> {
    let mut charts = response(run);
    if charts.len() > QUANTITIES.len() {
        // Displacement matters over the whole response, the others during the contact.
        let displacement = charts.swap_remove(QUANTITIES.len() + 1);
        charts.truncate(QUANTITIES.len());
        charts[1] = displacement;
    }
    charts.extend(mechanism(run));
    charts
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;
    use std::sync::Arc;

    use super::*;
    use crate::model::scene::Scene;
    use crate::model::simulate::{Settings, simulate};

    /// After the first arrest projectile and plate move as one on the spring: of equal masses the
    /// projectile needs half of the spring's force k x.
    #[test]
    fn valid_the_contact_force_falls_at_the_first_arrest() {
        let settings = Settings { series: true, estimate: false };
        let mut scene = Scene::default();
        scene.mechanism.spring.coefficient = 1e5;
        let scene = Arc::new(scene);
        let run = simulate(&scene, &settings, &mut |_| ControlFlow::Continue(())).unwrap();
        let arrest = run.first_arrest.unwrap();
        let points = points(&run.series, Quantity::ContactForce);
        let is_event = |point: &&(f64, f64)| point.0.to_bits() == arrest.t_s.to_bits();
        let at_event: Vec<f64> =
            points.iter().filter(|point| is_event(point)).map(|point| point.1).collect();
        let after = 0.5 * scene.mechanism.spring.coefficient * arrest.plate_displacement_m;
        assert_eq!(at_event.len(), 2);
        assert!((at_event[0] - run.peak_contact_force_n.unwrap()).abs() < 1e-6 * at_event[0]);
        assert!((at_event[1] - after).abs() < 1e-3 * after, "{at_event:?} {after}");
        assert_eq!(points.len(), run.series.len() + 1);
    }
}
