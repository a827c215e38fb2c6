//! Titles of the charts, each with the number of the current run and its change by the latest edit.

use crate::tui::pages::page::prelude::*;
use crate::tui::pages::run::charts::is_free;
use crate::tui::pages::run::editor::shown_value;
use crate::tui::pages::run::state::Window;
use crate::tui::widgets::text::fitting;
use crate::tui::widgets::value_steps::engineering;
use cmra_engine::model::run::{Outcome, Run, RunWarning};
use cmra_engine::model::variables::VARIABLES;
use cmra_studies::report::figures::run::contact_window_s;
use cmra_studies::report::run::page::{self, of_first};
use cmra_studies::report::series::Channel;
use cmra_studies::study::envelope;

/// Returns the name of a chart with the number of the current run, for this width.
pub(super) fn title(app: &App, chart: usize, room: usize) -> String {
    let quantity = app.pages.run.charts.quantities[chart];
    let name = quantity.name();
    let window = match app.pages.run.charts.windows[chart] {
        Window::Whole if quantity.is_over_time() => ", whole",
        Window::Whole | Window::Contact => "",
    };
    let Some(shown) = &app.shown else { return name.to_owned() };
    if app.shows_old() {
        return format!("{name} (old)");
    }
    let run = &*shown.run;
    let name = format!("{name}{}{window}", of_first(run));
    let titles = match quantity {
        Channel::Penetration => depth_titles(&name, run),
        Channel::ContactForce => {
            let peak = peak(run);
            vec![format!("{name}, {peak}"), format!("Force, {peak}")]
        }
        Channel::PlateDisplacement => {
            let (kind, value) = travel(run);
            let travel = format!("{kind}{value}");
            vec![format!("{name}: {travel}"), format!("Plate: {travel}"), format!("Plate {value}")]
        }
        _ => {
            let most = engineering(greatest(quantity, run), quantity.unit());
            let title = format!("{name}, greatest {most}");
            vec![if quantity.is_over_time() { title } else { name }]
        }
    };
    let beside = app.pages.run.differences.get(quantity);
    let added = match beside.map(|most| engineering(most, quantity.unit())) {
        Some(most) => vec![format!("greatest difference {most}"), format!("difference {most}")],
        None => changed(app, quantity, run).into_iter().collect(),
    };
    let with =
        titles.iter().flat_map(|title| added.iter().map(move |text| format!("{title}, {text}")));
    fitting(with.chain(titles.iter().cloned()).collect::<Vec<_>>(), room)
}

/// Returns the maximum magnitude of a quantity over a run.
fn greatest(quantity: Channel, run: &Run) -> f64 {
    let values = run.series.iter().map(|sample| quantity.value(&run.scene, sample).abs());
    values.filter(|value| value.is_finite()).fold(0.0, f64::max)
}

/// Returns the number of a title, SI; `None` if it has none.
fn headline(quantity: Channel, run: &Run) -> Option<f64> {
    match quantity {
        Channel::Penetration if run.outcome == Outcome::Perforated => None,
        Channel::Penetration => run.penetration.final_m,
        Channel::ContactForce => run.peak_contact_force_n,
        Channel::PlateDisplacement => run.max_plate_displacement_m,
        _ => quantity.is_over_time().then(|| greatest(quantity, run)),
    }
}

/// Describes the latest edit's effect on a title's number: `+0.442 since gamma 1`, or `was through at h 6.35 mm`.
fn changed(app: &App, quantity: Channel, run: &Run) -> Option<String> {
    let before = app.run_before()?;
    let edit = match App::differing(&before.scene, &run.scene)[..] {
        [index] => {
            let variable = &VARIABLES[index];
            format!("{} {}", variable.symbol, shown_value(variable, &before.scene))
        }
        _ => "the edit".to_owned(),
    };
    let unit = quantity.unit();
    match (headline(quantity, before), headline(quantity, run)) {
        (Some(then), Some(now)) => Some(match difference(now, now - then, unit) {
            Some(difference) => format!("{difference} since {edit}"),
            None => format!("as at {edit}"),
        }),
        (Some(then), None) => Some(format!("{} at {edit}", engineering(then, unit))),
        (None, Some(_)) if before.outcome == Outcome::Perforated => {
            Some(format!("through at {edit}"))
        }
        _ => None,
    }
}

/// Formats a difference with its sign, in the prefix and decimals of the preceding value; `None` if it rounds to zero.
fn difference(value: f64, difference: f64, unit: &'static str) -> Option<String> {
    let text = engineering(value, unit);
    let number = text.split(' ').next().unwrap_or_default();
    let decimals = number.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let size = number.parse::<f64>().ok().filter(|number| *number != 0.0);
    let shown = size.map_or(difference, |number| difference * number / value);
    let text = format!("{shown:+.decimals$}");
    (text.trim_start_matches(['+', '-']).parse() != Ok(0.0)).then_some(text)
}

/// Returns versions of the depth's title, from the longest to the shortest. A depth with an overloaded fused interface is never shown
/// alone.
fn depth_titles(name: &str, run: &Run) -> Vec<String> {
    let Some(depth) = depth(run) else {
        return vec![format!("{name}: {}", page::outcome(run)), name.to_owned()];
    };
    let percent = run.percent_of_baseline().filter(|_| run.scene.is_sprung());
    let share = |of: &str| percent.map_or_else(String::new, |it| format!(" ({it:.0} %{of})"));
    let plastic = plastic(run).map_or_else(String::new, |it| format!("; plastic: {it}"));
    let colon = if run.outcome == Outcome::Perforated { ":" } else { "" };
    vec![
        format!("{name}{colon} {depth}{}{plastic}", share(" of rigid mount")),
        format!("{name}{colon} {depth}{}{plastic}", share("")),
        format!("Depth {depth}{plastic}"),
        format!("{depth}{plastic}"),
    ]
}

/// Describes the depth of a shot and the motion after the first contact; `None` if unknown.
fn depth(run: &Run) -> Option<String> {
    let depth_m = run.penetration.final_m?;
    if run.outcome == Outcome::Perforated {
        return Some(through(run));
    }
    let depth = engineering(depth_m, "m");
    let first_m = run.first_arrest.map(|arrest| arrest.penetration_m);
    let is_later = first_m.is_some_and(|first_m| depth_m > first_m * 1.001);
    let leaves = run
        .departure
        .separation
        .map_or_else(String::new, |it| format!(", leaves at {}", speed(it.velocity_m_s.abs())));
    let shows_first = contact_window_s(run) < 1.2 * run.contact_end_s();
    Some(match first_m.filter(|_| is_later && shows_first) {
        Some(first_m) => format!("{}, later {depth}{leaves}", engineering(first_m, "m")),
        None => format!("{depth}{leaves}"),
    })
}

/// Describes a perforation, with its residual velocity.
fn through(run: &Run) -> String {
    match run.departure.residual_velocity_m_s {
        Some(left) if left < 0.0 => format!("through, back at {}", speed(-left)),
        Some(left) => format!("through, leaves at {}", speed(left)),
        None => "through".to_owned(),
    }
}

/// Formats a velocity with one decimal; a low one with significant digits.
fn speed(velocity_m_s: f64) -> String {
    if velocity_m_s < 1.0 {
        engineering(velocity_m_s, "m/s")
    } else {
        format!("{velocity_m_s:.1} m/s")
    }
}

/// Describes the result with a plastic interface, if the fused one would exceed its strength.
fn plastic(run: &Run) -> Option<String> {
    let is_exceeded = |it: &RunWarning| {
        matches!(it, RunWarning::InterfacePush { .. } | RunWarning::InterfacePull { .. })
    };
    let fails = run.warnings.iter().any(is_exceeded);
    let is_hit = envelope::hits_fused_stop(run) == Some(true);
    let plastic = run.plastic.as_ref().filter(|_| fails || is_hit)?;
    if plastic.outcome == Outcome::Perforated {
        return Some(through(plastic));
    }
    plastic.penetration.final_m.map(|depth_m| engineering(depth_m, "m"))
}

fn peak(run: &Run) -> String {
    if envelope::hits_fused_stop(run) == Some(true) {
        return "fused: unbounded at the stop".to_owned();
    }
    run.peak_contact_force_n.map_or_else(
        || "no peak: the collision takes no time".to_owned(),
        |peak| format!("peak {}", engineering(peak, "N")),
    )
}

/// Describes the greatest displacement of the plate: the word `greatest`, if it is known or looked for, and the rest.
fn travel(run: &Run) -> (&'static str, String) {
    let stroke = run.stroke_m().filter(|_| run.scene.start_m() != 0.0);
    let stroke =
        stroke.map_or_else(String::new, |stroke| format!(", stroke {}", engineering(stroke, "m")));
    match (run.max_plate_displacement_m, run.at_least.plate_displacement_m) {
        (Some(most), _) => ("greatest ", engineering(most, "m") + &stroke),
        (None, Some(least)) => ("", format!("at least {}", engineering(least, "m"))),
        (None, None) if is_free(run) => {
            let last = run.series.last().map_or(0.0, |last| last.plate_velocity_m_s);
            ("", format!("leaves at {}, no greatest", speed(last)))
        }
        (None, None) => ("greatest ", "not known".to_owned()),
    }
}
