//! Charts of a run: time series, and the law of the mechanism.

use crate::report::chart::{Axis, Chart, Curve, Mark, Scale};
use crate::report::law::Law;
use crate::report::series::Channel;
use crate::report::traces::Traces;
use cmra_engine::model::run::{CONTACT_WINDOW, ContactMode, Event, EventKind, Run, RunWarning};
use cmra_engine::model::units::engineering;
use cmra_engine::numerics::{larger, smaller};

/// Quantities drawn over time.
const QUANTITIES: [Channel; 3] =
    [Channel::Penetration, Channel::PlateDisplacement, Channel::ContactForce];
/// Returns the letter of an event in charts and lists: `a` to `z`; empty for later events.
pub fn event_letter(index: usize) -> &'static str {
    const LETTERS: &str = "abcdefghijklmnopqrstuvwxyz";
    LETTERS.get(index..=index).unwrap_or("")
}

/// Describes an event. A fused interface has two limits: the load that exceeds one is named.
pub fn event_words(run: &Run, event: &Event) -> &'static str {
    if event.kind != EventKind::InterfaceExceeded {
        return event.kind.words();
    }
    let is_push = |it: &RunWarning| matches!(it, RunWarning::InterfacePush { t_s, .. } if t_s.to_bits() == event.t_s.to_bits());
    if run.warnings.iter().any(is_push) {
        "interface limit exceeded: push"
    } else {
        "interface limit exceeded: pull"
    }
}

/// Returns marks for the events of a time interval, with their letters.
pub fn event_marks(run: &Run, (from, to): (f64, f64)) -> impl Iterator<Item = Mark<'static>> + '_ {
    let events = run.events.iter().enumerate();
    let seen = events.filter(move |(_, event)| (from..=to).contains(&event.t_s));
    seen.map(|(index, event)| {
        Mark::new(event.t_s, event_words(run, event)).tag(event_letter(index))
    })
}

/// Time of a change of depth over that of the first contact, above which the change is left to the chart of the whole response.
const LATER: f64 = 5.0;

/// Returns the end time of the contact chart, s: shortly after the last change of the depth, or after the first contact if the depth
/// changes much later.
pub fn contact_window_s(run: &Run) -> f64 {
    let first_s = run.contact_end_s();
    let changes = |mode| {
        matches!(mode, ContactMode::Penetrating | ContactMode::Withdrawing | ContactMode::Closing)
    };
    let last = run.series.iter().rev().find(|sample| changes(sample.mode));
    let last_s = last.map_or(first_s, |sample| larger(sample.t_s, first_s));
    CONTACT_WINDOW * if last_s > LATER * first_s { first_s } else { last_s }
}

/// Creates the charts of penetration, displacement and force over time: during the contact, a fraction of a millisecond, then over the
/// whole response if it is longer.
pub fn response(run: &Run, beside: Option<&Traces>) -> Vec<Chart<'static>> {
    let Some(end_s) = run.series.last().map(|row| row.t_s) else {
        return Vec::new();
    };
    let window_s = smaller(contact_window_s(run), end_s);
    let mut charts = over_time(run, beside, ("contact", window_s));
    if end_s > 2.0 * window_s {
        charts.extend(over_time(run, beside, ("whole response", end_s)));
    }
    charts
}

fn over_time(
    run: &Run,
    beside: Option<&Traces>,
    (window, end_s): (&str, f64),
) -> Vec<Chart<'static>> {
    let chart = |quantity: &Channel| {
        let points = quantity.points(run, &run.series);
        let name = format!("{} {}", quantity.title().to_lowercase(), quantity.symbol());
        let measured = beside.map_or_else(Vec::new, |traces| traces.curves(*quantity, end_s));
        let all = points.iter().chain(measured.iter().flat_map(|curve| curve.points.iter()));
        let shown = all.filter(|point| point.0 <= end_s).map(|point| point.1);
        // A chart of a constant would be a line on its own frame.
        let values = Axis::over("", quantity.unit(), Scale::Linear, shown)?;
        let y = Axis { label: name.clone().into(), ..values.with_zero().padded(0.05) };
        let x = Axis::over("t", "s", Scale::Linear, [0.0, end_s])?;
        let difference = beside.and_then(|traces| traces.greatest(*quantity, run));
        let difference = difference.map_or_else(String::new, |most| {
            format!(", greatest difference {}", engineering(most, quantity.unit(), 3))
        });
        let title = format!("{name}, {window}{difference}");
        let label = if measured.is_empty() { "" } else { "computed" };
        let curves = std::iter::once(Curve::new('*', label, points)).chain(measured).collect();
        let marks = event_marks(run, (0.0, end_s)).collect();
        Some(Chart { marks, ..Chart::new(title, x, y, curves) })
    };
    // Measured traces of other quantities.
    let other = |channel: &Channel| {
        !QUANTITIES.contains(channel)
            && beside.is_some_and(|it| it.of_channel(*channel).next().is_some())
    };
    let quantities = QUANTITIES.iter().chain(Channel::ALL.iter().filter(|it| other(it)));
    if end_s > 0.0 { quantities.filter_map(chart).collect() } else { Vec::new() }
}

/// Creates the charts of force, stiffness and stress of the mechanism over the plate displacement, with the range used by the run; empty
/// without a mechanism.
pub fn mechanism(run: &Run) -> Vec<Chart<'static>> {
    let Some(law) = Law::from_run(run) else { return Vec::new() };
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

/// Returns the pictures of a file: contact, whole plate displacement, mechanism.
pub fn selected(run: &Run, beside: Option<&Traces>) -> Vec<Chart<'static>> {
    let mut charts = response(run, beside);
    let count = charts.len() / 2;
    if charts.len() > count.max(QUANTITIES.len()) && count >= QUANTITIES.len() {
        // The displacement is shown over the whole response, other quantities during the contact.
        let displacement = charts.swap_remove(count + 1);
        charts.truncate(count);
        charts[1] = displacement;
    }
    charts.extend(mechanism(run));
    charts
}
