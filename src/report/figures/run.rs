//! The charts of a run: what happened in time, and the law of the mechanism that the plate stands on.

use crate::model::run::{Run, Sample};
use crate::numerics::smaller;
use crate::report::chart::{Axis, Chart, Curve, Mark, Scale};
use crate::report::law::Law;
use crate::report::series::Quantity;

/// The quantity drawn over time.
const QUANTITIES: [Quantity; 3] =
    [Quantity::Penetration, Quantity::PlateDisplacement, Quantity::ContactForce];
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
    let Some(law) = Law::of(run) else { return Vec::new() };
    let (low_m, end_m) = law.range_m();
    let chart = |title: &'static str, unit: &'static str, get: fn(&Law, f64) -> f64| {
        let points = law.points(get);
        let x = Axis::over("plate displacement x", "m", Scale::Linear, [low_m, end_m])?;
        let y = Axis::over(title, unit, Scale::Linear, points.iter().map(|point| point.1))?;
        let curve = Curve::new('*', "", points);
        let chart = Chart::new(title, x, y.with_zero().padded(0.05), vec![curve]);
        Some(Chart { marks: law.marks(), ..chart })
    };
    let mut charts: Vec<Chart<'static>> = Vec::new();
    charts.extend(chart("force of the mechanism F(x)", "N", Law::force));
    charts.extend(chart("stiffness of the mechanism dF/dx", "N/m", Law::stiffness));
    if let Some(mut chart) = chart("greatest stress over yield strength", "", Law::stress) {
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
