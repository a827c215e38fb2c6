//! The comparison as a page of text: chart, table, answers, and what was refused and why.

use std::fmt::Write as _;

use crate::files::accuracy::Named;
use crate::model::contact_phase::Ending;
use crate::model::units::Engineering;
use crate::study::accuracy::method::Method;
use crate::study::accuracy::{Cheapest, MethodReport, Report};
use crate::tui::chart::{Axis, Chart, Curve, Legend, Level, Scale, Unit, ViewRange};
use crate::tui::theme::Theme;

const WIDTH: u16 = 80;
const HEIGHT: u16 = 20;
/// The accuracies asked for in the table.
const TARGETS: [f64; 2] = [1e-6, 1e-9];
/// The accuracies answered below it.
const ANSWERS: [f64; 4] = [1e-4, 1e-6, 1e-9, 1e-12];

/// The pages of all scenes, one under the other.
pub(super) fn text(reports: &[Named]) -> String {
    let pages: Vec<String> = reports.iter().map(|(name, report)| page(name, report)).collect();
    pages.join("\n")
}

fn page(name: &str, report: &Report) -> String {
    let mut page = format!("{name}: error against run time of the first contact\n\n");
    page.push_str(&chart(report));
    page.push_str(&table(report));
    answers(&mut page, report);
    references(&mut page, report);
    refusals(&mut page, report);
    page
}

fn seconds(value: f64) -> String {
    Engineering { value, unit: "s", digits: 3 }.to_string()
}

/// Error over time, both logarithmic, a letter for each method.
fn chart(report: &Report) -> String {
    let curves: Vec<(Method, Vec<(f64, f64)>)> = report
        .methods
        .iter()
        .map(|method| {
            let point = |(_, measured): (_, &crate::study::accuracy::Measured)| {
                (measured.timing.min_s, measured.error())
            };
            (method.method, method.measured().map(point).collect())
        })
        .collect();
    let points = || curves.iter().flat_map(|(_, points)| points);
    let times = ViewRange::of(Scale::Log10, points().map(|point| point.0));
    let errors = ViewRange::of(Scale::Log10, points().map(|point| point.1));
    let (Some(times), Some(errors)) = (times, errors) else {
        return "no method gave a result that could be judged\n".to_owned();
    };
    // The unit of the fast end: microseconds, of which a person thinks here.
    let unit = Unit::with_prefix(ViewRange::new(0.0, 30.0 * times.lo()), "s");
    let x = Axis::new("run time", times.rounded(Scale::Log10)).scale(Scale::Log10).unit(unit);
    let y = Axis::new("", errors.rounded(Scale::Log10)).scale(Scale::Log10);
    let curves = curves
        .iter()
        .map(|(method, points)| Curve::new(method.letter(), method.name(), points))
        .collect();
    let title = "relative error, the greater of depth and time";
    let floor = report.references.first().and_then(|reference| reference.uncertainty);
    let level = floor.map(|y| Level { y, tag: "reference's floor".into() });
    let chart = Chart {
        legend: Legend::Hidden,
        levels: level.into_iter().collect(),
        ..Chart::new(title, x, y, curves)
    };
    let mut text = String::new();
    for line in chart.to_lines(WIDTH, HEIGHT, Theme::PLAIN) {
        text.push_str(&line);
        text.push('\n');
    }
    text
}

/// A line for each method.
fn table(report: &Report) -> String {
    let mut text = format!(
        "\n  {:<20}{:>6}{:>10}{:>14}{:>14}\n",
        "method", "order", "best", "time to 1e-6", "time to 1e-9"
    );
    let pick = report.cheapest(TARGETS[1]);
    for method in &report.methods {
        let order = method.observed_order().map_or_else(|| "-".to_owned(), |it| format!("{it:.1}"));
        let best = method.least_error().map_or_else(|| "-".to_owned(), |it| format!("{it:.0e}"));
        let _ = write!(
            text,
            "{} {:<20}{order:>6}{best:>10}",
            method.method.letter(),
            method.method.name()
        );
        for target in TARGETS {
            let time = method.cheapest(target).map(|found| seconds(found.min_s));
            let _ = write!(text, "{:>14}", time.unwrap_or_else(|| "-".to_owned()));
        }
        if pick.is_some_and(|pick| pick.method == method.method) {
            text.push_str("  <- cheapest to 1e-9");
        }
        text.push('\n');
    }
    text
}

fn answers(page: &mut String, report: &Report) {
    page.push('\n');
    for target in ANSWERS {
        let _ = match report.cheapest(target) {
            Some(found) => {
                writeln!(page, "{target:.0e} costs {}{}", by(&found), full(report, &found, target))
            }
            None => writeln!(page, "{target:.0e}: no method gets there"),
        };
    }
    if let Some(found) = thesis_step(report) {
        let _ = writeln!(page, "the thesis's own dt 1e-6 s: error {found:.1e}");
    }
    let repeats = report.methods.iter().flat_map(MethodReport::measured);
    let unsteady = repeats.filter(|(_, measured)| {
        let timing = measured.timing;
        timing.mad_s.is_some_and(|mad_s| mad_s > 0.2 * timing.median_s)
    });
    let _ = match unsteady.count() {
        0 => writeln!(page, "times: least of repeated runs, spread (MAD) below 20 % everywhere"),
        count => writeln!(
            page,
            "times: least of repeated runs; at {count} points the spread (MAD) exceeds 20 %: busy machine"
        ),
    };
}

fn by(found: &Cheapest) -> String {
    let knob = found.knob.to_string();
    let with = if knob.is_empty() { String::new() } else { format!(" at {knob}") };
    format!("{} by {}{with}", seconds(found.min_s), found.method.name())
}

/// What the same costs with nothing left out, unless that is what is done.
fn full(report: &Report, found: &Cheapest, target: f64) -> String {
    let full = report.cheapest_in_full(target).filter(|full| full.method != found.method);
    full.map_or_else(String::new, |full| format!("; {} with nothing left out", seconds(full.min_s)))
}

fn thesis_step(report: &Report) -> Option<f64> {
    let printed = report.methods.iter().find(|it| it.method == Method::ThesisPrinted)?;
    let own = |knob: f64| (knob / 1e-6 - 1.0).abs() < 1e-9;
    let mut points = printed.measured();
    points.find(|(knob, _)| knob.value().is_some_and(own)).map(|(_, measured)| measured.error())
}

fn references(page: &mut String, report: &Report) {
    page.push_str("\njudged by\n");
    for reference in &report.references {
        let letters: String = report
            .methods
            .iter()
            .filter(|method| method.reference.is_some_and(|own| own.basis == reference.basis))
            .map(|method| method.method.letter())
            .collect();
        let result = match reference.ending {
            Ending::Arrest => format!("{} deep", length(reference.depth_m)),
            Ending::Perforation => "perforated".to_owned(),
        };
        let sure = reference
            .uncertainty
            .map_or_else(|| "unknown".to_owned(), |uncertainty| format!("{uncertainty:.0e}"));
        let _ = writeln!(
            page,
            "  {:<24}{result}, {}, uncertainty {sure}; judges {}",
            reference.basis.words(),
            Engineering { value: reference.t_s, unit: "s", digits: 10 },
            if letters.is_empty() { "none" } else { &letters }
        );
    }
}

fn length(value: f64) -> String {
    Engineering { value, unit: "m", digits: 10 }.to_string()
}

/// Refused points by method and reason.
fn refusals(page: &mut String, report: &Report) {
    let mut is_first = true;
    for method in &report.methods {
        let mut reasons: Vec<(&str, Vec<String>)> = Vec::new();
        for point in &method.points {
            let Err(refusal) = point.result else { continue };
            let knob = point.knob.to_string();
            match reasons.iter_mut().find(|(words, _)| *words == refusal.words()) {
                Some((_, knobs)) => knobs.push(knob),
                None => reasons.push((refusal.words(), vec![knob])),
            }
        }
        for (words, knobs) in reasons {
            if std::mem::take(&mut is_first) {
                page.push_str("\nwithout result\n");
            }
            let which = match knobs.as_slice() {
                [] => String::new(),
                [only] => only.clone(),
                [first, .., last] => format!("{} points, {first} to {last}", knobs.len()),
            };
            let blank = if which.is_empty() { "" } else { ": " };
            let _ = writeln!(page, "  {} {which}{blank}{words}", method.method.letter());
        }
    }
}
