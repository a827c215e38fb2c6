//! A run as a page of text: what happened first, then the numbers, the energy, the cost, and what to be careful about.

use std::fmt::Write as _;

use crate::cli::run::Computed;
use crate::cli::table::at_top;
use crate::files::clean;
use crate::model::mechanism::Mechanism;
use crate::model::run::envelope::warnings;
use crate::model::run::{Outcome, Run};
use crate::model::scene::{Mount, Scene};
use crate::model::units::{self, Engineering};
use crate::report::figures::run::event_letter;
use crate::report::run::{energy_terms, estimate_words};
use crate::study::quantities;

/// Width of the first column.
const LABEL: usize = 24;

pub(super) fn text(computed: &Computed) -> String {
    let run = &computed.run;
    let mut page = String::new();
    let title = clean::line(&run.scene.title);
    let name = &computed.preset.name;
    if title.is_empty() {
        let _ = writeln!(page, "{name}");
    } else {
        let _ = writeln!(page, "{name}: {title}");
    }
    stack(&mut page, run);
    let _ = writeln!(page, "{}\n", sentence(run));
    numbers(&mut page, run);
    mechanism(&mut page, run);
    energy(&mut page, run);
    events(&mut page, run);
    cost(&mut page, computed);
    at_top(&page, &warnings(run))
}

fn show(value: f64, unit: &'static str) -> String {
    Engineering { value, unit, digits: 6 }.to_string()
}

fn short(value: f64, unit: &'static str) -> String {
    Engineering { value, unit, digits: 4 }.to_string()
}

pub(super) fn sentence(run: &Run) -> String {
    let depth = run.final_penetration_m.map(|depth_m| short(depth_m, "m"));
    match run.outcome {
        Outcome::Arrested => {
            let Some(depth) = depth else {
                return "arrested: the projectile stays in the plate; this model knows no depth"
                    .to_owned();
            };
            let share = match (run.percent_of_baseline(), run.baseline_penetration_m) {
                (Some(percent), Some(baseline)) if run.scene.plate.mount == Mount::Sprung => {
                    format!(
                        ", {} % of the {} on a rigid mount",
                        units::fixed_significant(percent, 4),
                        short(baseline, "m")
                    )
                }
                _ => String::new(),
            };
            run.protrusion_m().map_or_else(
                || format!("arrested: the projectile stays in the plate, {depth} deep{share}"),
                |out| {
                    format!(
                        "arrested: the projectile sticks in the plate, its nose {} out of the rear face{share} (partial penetration; \
                         complete by the army criterion)",
                        short(out, "m")
                    )
                },
            )
        }
        Outcome::Perforated => match run.residual_velocity_m_s {
            Some(speed) if speed < 0.0 => format!(
                "perforated: the plate moves back over the projectile, whose residual velocity is backwards, {}",
                short(speed.abs(), "m/s")
            ),
            Some(speed) => format!(
                "perforated: the projectile passes through the plate; its residual velocity is {}",
                short(speed, "m/s")
            ),
            None => "perforated: the projectile passes through the plate".to_owned(),
        },
        Outcome::Separated => {
            let left = run
                .separation
                .map_or_else(String::new, |(_, speed)| format!(" at {}", short(speed, "m/s")));
            let depth =
                depth.map_or_else(String::new, |depth| format!(", leaving a hole {depth} deep"));
            format!("separated: the projectile leaves through the entry face{left}{depth}")
        }
        Outcome::Moving => format!("still moving: {}", run.end.words()),
    }
}

/// One line: label and value.
fn line(page: &mut String, label: &str, value: Option<f64>, unit: &'static str) {
    if let Some(value) = value {
        let _ = writeln!(page, "{label:<LABEL$}{}", show(value, unit));
    }
}

fn numbers(page: &mut String, run: &Run) {
    if let Some(arrest) = run.first_arrest {
        line(page, "first arrest, depth", Some(arrest.penetration_m), "m");
        line(page, "  time", Some(arrest.t_s), "s");
        line(page, "  plate displacement", Some(arrest.plate_displacement_m), "m");
        line(page, "  common velocity", Some(arrest.plate_velocity_m_s), "m/s");
    }
    line(page, "final depth", run.final_penetration_m, "m");
    line(page, "depth so far", run.at_least.penetration_m, "m");
    line(page, "  at most, by energy", run.penetration_at_most_m, "m");
    line(page, "nose out of rear face", run.protrusion_m(), "m");
    line(page, "  on a rigid mount", run.baseline_penetration_m, "m");
    if let Some(percent) = run.percent_of_baseline() {
        let _ = writeln!(
            page,
            "{:<LABEL$}{} %",
            "  of the rigid mount's",
            units::fixed_significant(percent, 4)
        );
    }
    line(page, "exit time", run.exit_time_s, "s");
    line(page, "residual velocity", run.residual_velocity_m_s, "m/s");
    line(page, "separation, time", run.separation.map(|it| it.0), "s");
    line(page, "  projectile velocity", run.separation.map(|it| it.1), "m/s");
    line(page, "peak contact force", run.peak_contact_force_n, "N");
    match (run.max_plate_displacement_m, run.at_least.plate_displacement_m) {
        (Some(_), _) => line(page, "greatest displacement", run.max_plate_displacement_m, "m"),
        (None, Some(so_far)) => {
            line(page, "displacement so far", Some(so_far), "m");
            line(page, "stroke so far", Some(so_far - run.start_m()), "m");
        }
        (None, None) => {
            let _ = writeln!(
                page,
                "{:<LABEL$}{}",
                "greatest displacement",
                no_greatest_displacement(&run.scene)
            );
        }
    }
    line(page, "stroke", run.stroke_m(), "m");
    if let Some(ratio) = run.interface_demand_ratio {
        let _ = writeln!(
            page,
            "{:<LABEL$}{} of its strength A S_y",
            "interface demand",
            units::fixed_significant(ratio, 4)
        );
    }
}

/// The outcome of the shot in a stack, plate by plate; what follows on the page is the first plate's.
fn stack(page: &mut String, run: &Run) {
    let Some(stack) = &run.stack else {
        return;
    };
    for line in crate::study::stack::table(run, stack) {
        let _ = writeln!(page, "{line}");
    }
    page.push_str("\nelement 1 in full:\n");
}

/// The load of a mechanism that is more than one power law.
fn mechanism(page: &mut String, run: &Run) {
    if run.scene.mechanism.is_plain() {
        return;
    }
    let load = &run.mechanism;
    line(page, "energy stored at most", load.stored_j, "J");
    line(page, "  turning with plate", load.rotation_j, "J");
    if let Some(margin) = load.yield_margin {
        let _ = writeln!(
            page,
            "{:<LABEL$}{} (yield strength over the greatest stress)",
            "yield margin",
            units::fixed_significant(margin, 4)
        );
    }
    for (label, mass) in
        [("springs' own mass", load.spring_mass_kg), ("  added to the plate", load.added_kg)]
    {
        if let Some(mass) = mass {
            let _ = writeln!(page, "{label:<LABEL$}{} kg", units::fixed_significant(mass, 4));
        }
    }
}

/// The reason why there is none.
fn no_greatest_displacement(scene: &Scene) -> &'static str {
    let mechanism = &scene.mechanism;
    let nothing_stops_it = Mechanism::of(scene).is_absent() && mechanism.stop.position_m.is_none();
    if nothing_stops_it { "none: nothing stops the plate" } else { "not reached within the run" }
}

fn energy(page: &mut String, run: &Run) {
    let (start, end) = energy_terms(&run.ledger);
    for (heading, terms) in [("\nenergy at the start", start), ("energy at the end", end)] {
        let _ = writeln!(page, "{heading}");
        for term in terms {
            let _ = writeln!(
                page,
                "  {:<22}{:>12} J {:>8} %",
                term.label,
                fixed(term.energy_j),
                units::decimals(term.percent, 2)
            );
        }
    }
    let residual = units::scientific(run.ledger.residual(), 1);
    let _ = writeln!(page, "  {:<22}{residual:>12} of the start", "residual");
}

/// Joule with as many places for every size, so that the points stand in one column.
fn fixed(energy_j: f64) -> String {
    units::fixed_significant(energy_j, 6)
}

fn events(page: &mut String, run: &Run) {
    if run.events.is_empty() {
        return;
    }
    page.push_str("\nevents\n");
    for (index, event) in run.events.iter().enumerate() {
        let _ = writeln!(
            page,
            "  {}  {:>12}  {}",
            event_letter(index),
            show(event.t_s, "s"),
            event.kind.words()
        );
    }
}

/// The quantity of the estimate shown first.
fn estimated_quantity(run: &Run) -> &'static str {
    if run.outcome == Outcome::Perforated { "exit time" } else { "depth" }
}

/// The greatest of the other results' own estimates.
fn estimates(page: &mut String, run: &Run) {
    let greatest = run.error_estimates.iter().max_by(|a, b| a.relative.total_cmp(&b.relative));
    if let Some(error) = greatest
        && let Some(column) = quantities::find(error.name)
    {
        let _ = writeln!(
            page,
            "largest error estimate of all results {:.1e} ({})",
            error.relative,
            column.title()
        );
    }
}

fn cost(page: &mut String, computed: &Computed) {
    let run = &computed.run;
    let cost = &run.cost;
    let _ = writeln!(
        page,
        "\ncomputed by {} in {}: {} steps, {} rejected, {} evaluations",
        cost.method,
        short(computed.took.as_secs_f64(), "s"),
        cost.steps,
        cost.rejected,
        cost.rhs_evaluations
    );
    if let Some(estimate) = estimate_words(run, &format!(" of the {}", estimated_quantity(run))) {
        let _ = writeln!(page, "error estimate {estimate}");
        estimates(page, run);
    }
    if !run.omitted.is_empty() {
        let _ = writeln!(page, "omitted terms (not needed here): {}", run.omitted.join(", "));
    }
}
