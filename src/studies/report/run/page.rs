//! Report of a run: the outcome as a sentence, and results, warnings, energy, events and computation as blocks, which text, Log tab and
//! HTML share.

use std::borrow::Cow;

use crate::report::Remark;
use crate::report::clean;
use crate::report::figures::run::{event_letter, event_words, mechanism, response};
use crate::report::page::{Block, Page, Size};
use crate::report::run::{AT_START, ENERGY, LedgerPart, stack};
use crate::report::svg::Picture;
use crate::report::table::Cells;
use crate::report::traces::Traces;
use crate::report::verdict;
use crate::study::envelope;
use crate::study::quantities;
use cmra_engine::model::mechanism::Mechanism;
use cmra_engine::model::run::{EstimateBasis, Event, Outcome, Run, RunResult};
use cmra_engine::model::scene::Scene;
use cmra_engine::model::units::{self, engineering, fixed_significant};
use cmra_engine::numerics::larger;

/// Size of a chart below the results.
const SIZE: Size = (78, 15);
/// Column of a value after its label.
pub const LABEL: usize = 24;

fn short(value: f64, unit: &str) -> String {
    engineering(value, unit, 4)
}

/// Label and text of a line.
type Labelled = (Cow<'static, str>, String);

/// Returns texts beside their labels.
pub fn labelled(all: Vec<Labelled>) -> Vec<Block> {
    let fact = |(label, text)| Block::Fact { remark: Remark::new(label, text), column: LABEL };
    all.into_iter().map(fact).collect()
}

/// Returns the end of a heading for results of a stack's first element, ` of element 1`; empty for a single plate.
pub fn of_first(run: &Run) -> &'static str {
    if run.stack.is_some() { " of element 1" } else { "" }
}

/// Describes the outcome of the shot briefly: `arrested at 4.572 mm (64.3 % of a rigid mount)`. Returns the sentence for a stack. Mentions
/// a likely ricochet.
pub fn outcome(run: &Run) -> String {
    let doubt = if envelope::ricochet(&run.scene).is_some() { "; ricochet is likely" } else { "" };
    known_outcome(run) + doubt
}

fn known_outcome(run: &Run) -> String {
    if let Some(stack) = &run.stack {
        return stack.sentence();
    }
    if let Some(out) = by_protrusion(run) {
        return format!("perforated by protrusion: nose {} out", short(out, "m"));
    }
    let word = run.outcome.word();
    let percent = run.percent_of_baseline();
    let percent = percent.map_or_else(String::new, |it| format!(" ({it:.1} % of a rigid mount)"));
    match (run.outcome, run.penetration.final_m, run.departure.residual_velocity_m_s) {
        (Outcome::Perforated, _, Some(speed)) => {
            format!("{word}, residual velocity {}", short(speed.abs(), "m/s"))
        }
        (Outcome::Arrested, Some(depth), _) => {
            format!("{word} at {}{percent}", short(depth, "m"))
        }
        (Outcome::Separated, Some(depth), _) => {
            format!("{word} after {} of penetration{percent}", short(depth, "m"))
        }
        _ => word.to_owned(),
    }
}

/// Describes the outcome of the shot in a sentence with its meaning; for a stack, of the first element. Mentions a likely ricochet.
pub fn sentence(run: &Run) -> String {
    let doubt = envelope::ricochet(&run.scene).map(|text| format!("; theta is {text}"));
    known_sentence(run) + &doubt.unwrap_or_default()
}

/// Returns the protrusion of the nose from the rear face, m, if the scene's criterion counts it as a perforation.
fn by_protrusion(run: &Run) -> Option<f64> {
    let is_through = run.stack.is_none() && run.shot_outcome() == Outcome::Perforated;
    run.protrusion_m().filter(|_| is_through)
}

fn known_sentence(run: &Run) -> String {
    if let Some(out) = by_protrusion(run) {
        return format!(
            "perforated by the army criterion (protrusion): the nose stands {} out of the rear face",
            short(out, "m")
        );
    }
    let depth = run.penetration.final_m.map(|depth_m| short(depth_m, "m"));
    match run.outcome {
        Outcome::Arrested => depth.map_or_else(
            || "arrested: the projectile stays in the plate; this model knows no depth".to_owned(),
            |depth| arrested(run, &depth),
        ),
        Outcome::Perforated => match run.departure.residual_velocity_m_s {
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
                .departure.separation
                .map_or_else(String::new, |it| format!(" at {}", short(it.velocity_m_s, "m/s")));
            let depth =
                depth.map_or_else(String::new, |depth| format!(", leaving a hole {depth} deep"));
            format!("separated: the projectile leaves through the entry face{left}{depth}")
        }
        Outcome::Moving => format!("still moving: {}", run.end.words()),
        Outcome::Unmeasured => {
            "not-measured: the law of the plug, low for a rigid cylinder on a plate thinner than 0.6 D, does not stop it; what becomes of it \
             is not known"
                .to_owned()
        }
    }
}

fn arrested(run: &Run, depth: &str) -> String {
    let share = match (run.percent_of_baseline(), run.penetration.baseline_m) {
        (Some(percent), Some(baseline)) if run.scene.is_sprung() => {
            let percent = fixed_significant(percent, 4);
            format!(", {percent} % of the {} on a rigid mount", short(baseline, "m"))
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

/// Returns the line of a quantity with its title, and the text of a value.
fn titled_as(name: &str, text: Option<String>) -> Option<Labelled> {
    Some((quantities::find(name)?.title().into(), text?))
}

/// Returns the line of a result: title, value and unit are those of its quantity. Of a stack it is the value of the first element.
fn line_of(result: RunResult, run: &Run) -> Option<Labelled> {
    let quantity = quantities::find(result.key())?;
    titled_as(quantity.name, Some(engineering(result.value(run)?, quantity.unit(), 6)))
}

/// Returns the line of a label; `None` without a text.
fn own(label: &'static str, text: Option<String>) -> Option<Labelled> {
    Some((label.into(), text?))
}

/// Returns `true` if nothing stops the plate: it has no mechanism, or a spring that drives it away.
fn is_endless(run: &Run) -> bool {
    let scene = &run.scene;
    let is_driven = run.mechanism.peak_mount_n.is_none() && run.end.is_complete();
    let has_nothing =
        Mechanism::from_scene(scene).is_absent() && scene.mechanism.stop.position_m.is_none();
    scene.is_sprung() && (has_nothing || is_driven)
}

/// Lists the results, one per line; omits those that do not exist.
pub fn results(run: &Run) -> Vec<Labelled> {
    let known = |result: Option<f64>, unit| result.map(|result| engineering(result, unit, 6));
    let rounded = |result: Option<f64>, words: &str| {
        result.map(|result| format!("{}{words}", fixed_significant(result, 4)))
    };
    let (arrest, separation) = (run.first_arrest, run.departure.separation);
    let (so_far, load) = (run.at_least, &run.mechanism);
    let start_m = run.scene.start_m();
    let stroke_so_far = so_far.plate_displacement_m.map(|so_far_m| so_far_m - start_m);
    let displacement = known(run.max_plate_displacement_m, "m");
    // Omit the line for a shot that no law follows to its end.
    let is_known = displacement.is_some()
        || so_far.plate_displacement_m.is_some()
        || run.outcome == Outcome::Unmeasured;
    // Reason for a missing displacement.
    let nothing_stops_it = is_endless(run);
    let none = if nothing_stops_it {
        "none: nothing stops the plate"
    } else {
        "not reached within the run"
    };
    // A plate that nothing stops has no greatest displacement but that at a horizon.
    let words = if nothing_stops_it { " at the horizon, moving on" } else { "" };
    let displacement = displacement.map(|it| it + words);
    let displacement = displacement.or_else(|| (!is_known).then(|| none.to_owned()));
    let push = if envelope::hits_fused_stop(run) == Some(true) {
        Some("unbounded at the rigid stop".to_owned())
    } else {
        rounded(run.interface.demand_ratio, " of its strength A S_y")
    };
    // Below the limit load of the interface its type makes no difference.
    let loads = [run.interface.demand_ratio, run.interface.tension_ratio];
    let is_overloaded = loads.into_iter().flatten().any(|ratio| ratio > 1.0);
    let plastic = run.plastic.as_ref().filter(|_| is_overloaded);
    let closure = run.scene.closure_by_thickness().map(|it| format!("{}, by thickness", it.word()));
    let mount_force = quantities::find("peak_mount_force_n").and_then(|it| it.value(run));
    let of = |result| line_of(result, run);
    // A line has the title of its quantity unless it reads on: in its text, or in the indented lines below it.
    let of_run = [
        own("strength rule", closure),
        own("first stop, depth", known(arrest.map(|it| it.penetration_m), "m")),
        own("  time", known(arrest.map(|it| it.t_s), "s")),
        own("  plate displacement", known(arrest.map(|it| it.plate_displacement_m), "m")),
        own("  common velocity", known(arrest.map(|it| it.plate_velocity_m_s), "m/s")),
        of(RunResult::FinalPenetration),
        own("depth so far", known(so_far.penetration_m, "m")),
        own("  at most, by energy", known(run.penetration.at_most_m, "m")),
        own("nose out of rear face", known(run.protrusion_m(), "m")),
        own("  on a rigid mount", known(run.penetration.baseline_m, "m")),
        own("  of the rigid mount's", rounded(run.percent_of_baseline(), " %")),
        of(RunResult::ExitTime),
        of(RunResult::ResidualVelocity),
        own("separation, time", known(separation.map(|it| it.t_s), "s")),
        own("  projectile velocity", known(separation.map(|it| it.velocity_m_s), "m/s")),
        of(RunResult::PeakContactForce),
        titled_as("peak_mount_force_n", known(mount_force, "N")),
        titled_as("max_plate_displacement_m", displacement),
        own("displacement so far", known(so_far.plate_displacement_m, "m")),
        own("stroke so far", known(stroke_so_far, "m")),
        of(RunResult::Stroke),
        own("interface push", push),
        own("  if it can yield", plastic.map(|plastic| if_it_yields(plastic))),
    ];
    let margin_words = " (yield strength over the greatest stress)";
    // The energy of a single power-law spring is in the ledger.
    let of_mechanism = [
        own("energy stored at most", known(load.stored_j, "J")),
        own("  turning with plate", known(load.rotation_j, "J")),
        titled_as("yield_margin", rounded(load.yield_margin, margin_words)),
        own("springs' own mass", rounded(load.spring_mass_kg, " kg")),
        own("  added to the plate", rounded(load.added_kg, " kg")),
    ];
    let of_mechanism = of_mechanism.into_iter().filter(|_| !run.scene.mechanism.is_plain());
    of_run.into_iter().chain(of_mechanism).flatten().collect()
}

/// Describes the same shot with a plastic interface.
fn if_it_yields(plastic: &Run) -> String {
    let word = plastic.shot_outcome().word();
    let left =
        plastic.departure.residual_velocity_m_s.map(|v| format!(", {} left", short(v, "m/s")));
    let deep = || {
        let percent = plastic.percent_of_baseline();
        let percent = percent.map(|it| format!(", {} %", fixed_significant(it, 4)));
        let depth = short(plastic.penetration.final_m?, "m");
        Some(format!(", {depth} deep{}", percent.unwrap_or_default()))
    };
    let result = if plastic.shot_outcome() == Outcome::Perforated { left } else { deep() };
    format!("{word}{} (interface = plastic)", result.unwrap_or_default())
}

/// Column of an event after its letter and time.
const EVENT: usize = 14;

/// Lists the events beside their times, with their letters in the charts.
pub fn events(run: &Run) -> Vec<Block> {
    let fact = |(index, event): (usize, &Event)| {
        let (letter, time) = (event_letter(index), engineering(event.t_s, "s", 6));
        let remark = Remark::new(format!("{letter:<2}{time:>10}  "), event_words(run, event));
        Block::Fact { remark, column: EVENT }
    };
    run.events.iter().enumerate().map(fact).collect()
}

/// Number of events shown at each end of a list.
const EVENTS_SHOWN: usize = 10;

/// Lists the events for a page; only the first and last of a plate that chatters on its stop.
fn events_in_brief(run: &Run) -> Vec<Block> {
    let mut blocks = events(run);
    if blocks.len() > 2 * EVENTS_SHOWN {
        let omitted = EVENTS_SHOWN..blocks.len() - EVENTS_SHOWN;
        let note = format!("... {} more: --json lists them all", omitted.len());
        blocks.splice(omitted, [Block::Line(note)]);
    }
    blocks
}

/// Lists the energy ledger, one term per row, with fractions of the initial energy. Without a measured outcome the energies at the end are
/// unknown.
pub fn energy(run: &Run) -> Vec<Block> {
    let ledger = &run.ledger;
    let whole_j = larger(ledger.initial_j().abs(), ledger.final_j().abs());
    let terms = |parts: &[LedgerPart]| -> Vec<(&'static str, f64)> {
        let terms = parts.iter().map(|(_, label, get)| (*label, get(ledger)));
        // Rounding leaves such a part of the whole.
        terms.filter(|term| term.1.abs() > f64::EPSILON * whole_j).collect()
    };
    let (start, end) = ENERGY.split_at(AT_START);
    let start = terms(start);
    let mut rows = vec![("at the start", ledger.initial_j())];
    // A single term equals the total.
    rows.extend(if start.len() > 1 { start } else { Vec::new() });
    if run.outcome == Outcome::Unmeasured {
        let remark = Remark::new("at the end", "not measured");
        return vec![Block::Table(of_energies(&rows)), Block::Fact { remark, column: 13 }];
    }
    let (weight, end) = end.split_at(1);
    rows.extend(terms(weight));
    rows.push(("at the end", ledger.final_j()));
    rows.extend(terms(end));
    let residual = match ledger.residual() {
        0.0 => "0".to_owned(),
        other => units::scientific(other, 1),
    };
    let label = format!("{:<13}{residual:>10}  ", "residual");
    let residual = Block::Fact { column: label.len(), remark: Remark::new(label, "of the start") };
    vec![Block::Table(of_energies(&rows)), residual]
}

/// Returns the columns of energies and of their percentages of the first.
fn of_energies(rows: &[(&'static str, f64)]) -> Vec<Cells> {
    let column = |is_text: bool, text: &dyn Fn(&str, f64) -> String| Cells {
        head: String::new(),
        is_text,
        cells: rows.iter().map(|(label, energy_j)| text(label, *energy_j)).collect(),
    };
    let start_j = rows.first().map_or(0.0, |row| row.1);
    let percent = |energy_j: f64| if start_j == 0.0 { 0.0 } else { 100.0 * energy_j / start_j };
    vec![
        column(true, &|label, _| label.to_owned()),
        // No prefix, so that terms in a column can be compared.
        column(false, &|_, energy_j| format!("{} J", fixed_significant(energy_j, 6))),
        column(false, &|_, energy_j| format!("{} %", units::decimals(percent(energy_j), 2))),
    ]
}

/// Describes how the run was computed, its run time if known, and its error.
pub fn computation(run: &Run, took_s: Option<f64>) -> Vec<Labelled> {
    let cost = &run.cost;
    let steps = format!(
        "{} accepted, {} rejected, {} evaluations",
        cost.steps, cost.rejected, cost.rhs_evaluations
    );
    let omitted =
        if run.omitted.is_empty() { "nothing".to_owned() } else { run.omitted.join(", ") };
    let facts = [
        own("method", Some(format!("{}: {}", cost.method, cost.reason))),
        own("run time", took_s.map(|took_s| short(took_s, "s"))),
        own("steps", Some(steps)),
        own("end", Some(run.end.words().to_owned())),
        own("error", Some(error(run).unwrap_or_else(|| "not estimated".to_owned()))),
        own("largest error", largest_error(run)),
        own("omitted terms", Some(omitted)),
    ];
    facts.into_iter().flatten().collect()
}

/// Describes the error estimate and its basis; `None` without an estimate.
fn error(run: &Run) -> Option<String> {
    let estimate = run.estimate.main?;
    let basis = match run.estimate.basis? {
        EstimateBasis::SecondComputation => "from a second, more accurate computation",
        EstimateBasis::ClosedForm => "from the closed form",
        EstimateBasis::HalfStep => "from half the step: against the scheme's own limit",
        EstimateBasis::OutcomeDiffers(other) => {
            return Some(format!(
                "unknown: outcome differs (the other computation ends {})",
                other.word()
            ));
        }
    };
    let of = if run.outcome == Outcome::Perforated { "exit time" } else { "depth" };
    Some(format!("{} of the {of} ({basis})", units::below(estimate)))
}

/// Describes the largest error estimate of all results.
fn largest_error(run: &Run) -> Option<String> {
    run.estimate.main?;
    // A result that does not exist, or is zero but for rounding, has no relative error.
    let is_shown = |name: &str| {
        let value = quantities::find(name).and_then(|it| it.value(run));
        value.is_some_and(|value| units::without_rounding(value) != 0.0)
    };
    let estimates = run.estimate.by_result.iter().filter(|it| is_shown(it.0));
    let (name, error) = estimates.max_by(|a, b| a.1.total_cmp(&b.1))?;
    Some(format!("{} of all results ({})", units::below(*error), quantities::find(name)?.title()))
}

/// Returns the report: outcome, verdict, results, warnings, energy, events and computation; the differences from traces; and, if
/// requested, the charts of the run and of its mechanism. The contact comes first: it ends within a fraction of a millisecond. The event
/// lines of charts have the letters of the list of events.
pub fn page(name: &str, run: &Run, with: Option<&Traces>, has_charts: bool) -> Page {
    let mut page = Page::new(titled(name, &run.scene));
    if run.stack.is_some() {
        page.blocks.extend(stack::blocks(run));
        page.line(verdict::of_run(run));
        page.heading("element 1 in full:");
    }
    page.line(sentence(run));
    if run.stack.is_none() {
        page.line(verdict::of_run(run));
    }
    page.space();
    page.blocks.extend(labelled(results(run)));
    page.push(Block::Warnings(envelope::warnings(run)));
    page.section("energy", 2, energy(run));
    if !run.events.is_empty() {
        page.section("events", 2, events_in_brief(run));
    }
    page.section("computation", 2, labelled(computation(run, run.cost.took_s)));
    if let Some(traces) = with {
        traces.compare(&mut page, run);
    }
    let charts = response(run, with).into_iter().chain(mechanism(run));
    for chart in charts.filter(|_| has_charts) {
        page.space();
        page.picture(Picture::Chart(chart), SIZE);
    }
    page
}

/// Returns everything about a run by sections, warnings and events first; a scene edited since is named another scene.
pub fn log(run: &Run, took_s: Option<f64>, is_stale: bool) -> Page {
    let mut page = Page::default();
    let which = if is_stale { " (of another scene)" } else { "" };
    let warnings = envelope::warnings(run).into_iter();
    let warnings = warnings.map(|it| Remark::caution("! ", it.to_string()));
    let warnings = warnings.map(|remark| Block::Fact { remark, column: 2 }).collect();
    let none = || vec![Block::Line("none".to_owned())];
    let or_none = |blocks: Vec<Block>| if blocks.is_empty() { none() } else { blocks };
    page.section(format!("Warnings of the run{which}"), 0, or_none(warnings));
    if run.stack.is_some() {
        page.section("Stack: plate by plate", 0, stack::blocks(run));
    }
    let first = of_first(run);
    page.section(format!("Events{first}"), 0, or_none(events(run)));
    let heading = format!("Energy{first}: where it was at the start, and where it went");
    page.section(heading, 0, energy(run));
    page.heading(format!("Results{first}"));
    page.line(sentence(run));
    page.blocks.extend(labelled(results(run)));
    page.section(format!("Computation{first}"), 0, labelled(computation(run, took_s)));
    page
}

/// Returns the name of a run with the title of its scene.
pub fn titled(name: &str, scene: &Scene) -> String {
    let title = clean::line(&scene.title);
    if title.is_empty() || title == name { name.to_owned() } else { format!("{name}: {title}") }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::table::grid;
    use crate::study::testing::run_of;

    /// Without a spring two bodies of equal mass share the momentum: half the velocity, half the energy.
    #[test]
    fn valid_a_free_plate_of_equal_mass_takes_half_of_everything() {
        let run = run_of("k=0");
        let results = results(&run);
        for (label, value) in [
            ("  common velocity", "50.0000 m/s"),
            ("max plate displacement", "none: nothing stops the plate"),
        ] {
            assert!(results.contains(&(label.into(), value.to_owned())), "{results:?}");
        }
        let Block::Table(energies) = &energy(&run)[0] else { panic!("a table comes first") };
        let energy = grid(energies, 80);
        for row in [
            "at the start  147.500 J  100.00 %",
            "penetration   73.7500 J   50.00 %",
            "plate         36.8750 J   25.00 %",
        ] {
            assert!(energy.contains(row), "{energy}");
        }
    }

    #[test]
    fn a_plate_that_nothing_stops_has_no_greatest_displacement_but_at_a_horizon() {
        let line = |pairs: &str| {
            let lines = results(&run_of(pairs));
            lines.into_iter().find(|line| line.0.contains("max plate displacement")).unwrap().1
        };
        assert!(line("k=0").starts_with("none"));
        assert!(line("k=0 horizon=2ms").ends_with("mm at the horizon, moving on"));
        assert!(line("k=1e5 horizon=2ms").ends_with("mm"));
        assert_eq!(line("mount=rigid"), "0 m");
    }

    #[test]
    fn a_likely_ricochet_is_in_the_outcome() {
        let at = |theta: &str| {
            let run = run_of(theta);
            [outcome(&run), sentence(&run)].map(|text| text.contains("ricochet is likely"))
        };
        assert_eq!((at("theta=20deg"), at("theta=85deg")), ([false; 2], [true; 2]));
    }
}
