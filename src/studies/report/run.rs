//! Report of runs: time series, results and events as tables, and a run as a JSON object. SI; null for quantities that do not exist.

use std::sync::Arc;

use serde_json::{Value, json};

use crate::report::table::{self, Table, pretty, texts, unsigned_zero};
use crate::report::traces::Traces;
use crate::report::verdict;
use crate::study::envelope::warnings;
use crate::study::quantities::{Quantity, QuantityFlag, find, of_runs};
use crate::study::verdict::Verdict;
use cmra_engine::model::run::{
    EnergyLedger, EstimateBasis, Event, EventKind, Outcome, Run, Sample, StackRun,
};
use cmra_engine::model::scene::{Scene, Stack};
use cmra_engine::model::units::fixed_significant;
use cmra_engine::model::variables::{self, VARIABLES, Variable};

pub mod models;
pub mod page;
pub mod stack;

/// Run with its name (`now`, `A`, ...).
pub type NamedRun = (String, Arc<Run>);

/// Column of the time series: its key and value.
type Column = (&'static str, fn(&Sample) -> f64);

const NUMBERS: [Column; 10] = [
    ("time_s", |row| row.t_s),
    ("penetration_m", |row| row.penetration_m),
    ("projectile_displacement_m", |row| row.projectile_displacement_m),
    ("projectile_velocity_m_s", |row| row.projectile_velocity_m_s),
    ("plate_displacement_m", |row| row.plate_displacement_m),
    ("plate_velocity_m_s", |row| row.plate_velocity_m_s),
    ("contact_force_n", |row| row.contact_force_n),
    ("spring_force_n", |row| row.spring_force_n),
    ("damper_force_n", |row| row.damper_force_n),
    ("stop_force_n", |row| row.stop_force_n),
];

/// Writes the time series of runs as CSV, with the name of the run in the first column if there are several.
pub fn csv(runs: &[NamedRun]) -> String {
    let events = |(_, run): &NamedRun| placed(&run.series, &run.events);
    let events: Vec<Vec<(usize, String)>> = runs.iter().map(events).collect();
    // Pairs of a run and one of its rows.
    let rows = runs.iter().enumerate();
    let rows = rows.flat_map(|(at, (_, run))| (0..run.series.len()).map(move |row| (at, row)));
    let sample = |at: &(usize, usize)| &runs[at.0].1.series[at.1];
    let event = |at: &(usize, usize)| {
        let own = &events[at.0];
        own.binary_search_by_key(&at.1, |event| event.0).map_or("", |found| &own[found].1)
    };
    let mut table = Table::new(rows);
    if runs.len() > 1 {
        table = table.field("run", |at| runs[at.0].0.as_str());
    }
    for (place, (key, get)) in NUMBERS.into_iter().enumerate() {
        table = table.field(key, move |at| get(sample(at)));
        if place == 0 {
            table = table.field("mode", move |at| sample(at).mode.word());
        }
    }
    table.field("event", event).csv()
}

/// Maximum number of events that a row lists in order. More are counted by kind, because spreadsheets cut fields of more than 32,767
/// characters; the JSON object has every event.
const LISTED_MAX: usize = 16;

/// Assigns each event to the first row at or after its time, else to the last row.
fn placed(samples: &[Sample], events: &[Event]) -> Vec<(usize, String)> {
    let mut rows: Vec<(usize, Vec<EventKind>)> = Vec::new();
    for event in events.iter().filter(|_| !samples.is_empty()) {
        let at = samples.partition_point(|sample| sample.t_s < event.t_s).min(samples.len() - 1);
        match rows.last_mut() {
            Some((row, kinds)) if *row >= at => kinds.push(event.kind),
            _ => rows.push((at, vec![event.kind])),
        }
    }
    rows.into_iter().map(|(row, kinds)| (row, listed(&kinds))).collect()
}

/// Formats the events of a row: in order, or with the number of each kind if there are many.
fn listed(kinds: &[EventKind]) -> String {
    if kinds.len() <= LISTED_MAX {
        let words: Vec<&str> = kinds.iter().map(|kind| kind.words()).collect();
        return words.join("; ");
    }
    let mut counts: Vec<(EventKind, usize)> = Vec::new();
    for kind in kinds {
        match counts.iter_mut().find(|(known, _)| known == kind) {
            Some((_, count)) => *count += 1,
            None => counts.push((*kind, 1)),
        }
    }
    let words = counts.into_iter().map(|(kind, count)| match count {
        1 => kind.words().to_owned(),
        _ => format!("{} ({count} times)", kind.words()),
    });
    words.collect::<Vec<_>>().join("; ")
}

/// Returns the table of the results of runs of a named scene, one row each.
pub fn results<'r>(scene: &'r str, runs: &'r [NamedRun]) -> Table<'r, &'r NamedRun> {
    let table = Table::new(runs)
        .field("run", |it| it.0.as_str())
        .field("scene", move |_| scene)
        .field("outcome", |it| it.1.shot_outcome().word())
        .field("end", |it| it.1.end.words())
        .field("method", |it| it.1.cost.method)
        .field("run_time_s", |it| it.1.cost.took_s);
    let quantities = of_runs();
    let table = quantities
        .fold(table, |table, quantity| table.field(quantity.name, |it| quantity.value(&it.1)));
    table.field("warnings", |it| table::listed(&warnings(&it.1)))
}

/// Name of a compared run, with the run or a word for the reason why there is none.
pub type Compared<'c> = (String, Result<&'c Run, &'static str>);

/// Returns the table that compares runs, each number in the unit of its heading.
pub fn comparison<'c>(runs: impl IntoIterator<Item = Compared<'c>>) -> Table<'c, Compared<'c>> {
    let outcome =
        |it: &Compared<'_>| it.1.map_or_else(|word| word, |run| run.shot_outcome().word());
    let table = Table::new(runs).with("name", "run", "", |it| it.0.clone());
    let table = table.with("outcome", "outcome", "", outcome);
    let table = column(table, "final_penetration_m", "depth mm, %", 1e3, |run| Some(depth(run)));
    let table = table.with("plastic", "plastic mm", "", |it: &Compared<'_>| {
        it.1.ok()?.plastic.as_ref()?.penetration.final_m
    });
    let table = table.shown(|it, _| Some(depth(it.1.ok()?.plastic.as_ref()?)));
    let table = column(table, "max_plate_displacement_m", "travel mm", 1e3, |_| None);
    let table = column(table, "peak_contact_force_n", "peak kN", 1e-3, |_| None);
    column(table, "peak_mount_force_n", "mount kN", 1e-3, |run| {
        stack::peak_mount_n(run).map(|(force_n, _)| fixed_significant(1e-3 * force_n, 4))
    })
}

/// Adds a column of a quantity times a factor; uses its text on pages if there is one.
fn column<'c>(
    table: Table<'c, Compared<'c>>,
    name: &'static str,
    label: &'static str,
    factor: f64,
    text: impl Fn(&Run) -> Option<String> + 'c,
) -> Table<'c, Compared<'c>> {
    let value = move |it: &Compared<'_>| find(name)?.value(it.1.ok()?);
    table.with(name, label, "", value).shown(move |it, _| {
        let run = it.1.ok()?;
        text(run).or_else(|| known(find(name)?, factor, run))
    })
}

/// Formats a quantity times a factor, or `>=` and its lower bound if no more is known.
fn known(quantity: &Quantity, factor: f64, run: &Run) -> Option<String> {
    let number = |value: f64| fixed_significant(factor * value, 4);
    let bound = || Some(format!(">= {}", number(quantity.lower_bound(run)?)));
    quantity.value(run).map(number).or_else(bound)
}

/// Formats the depth, mm, with its percentage of the depth on a rigid mount in brackets.
fn depth(run: &Run) -> String {
    // A nose that perforates by its protrusion stays in the plate.
    if run.shot_outcome() == Outcome::Perforated && run.protrusion_m().is_none() {
        return "through".to_owned();
    }
    let depth = find("final_penetration_m").and_then(|it| known(it, 1e3, run));
    let Some(depth) = depth else { return "-".to_owned() };
    let percent =
        find("percent_of_baseline").and_then(|it| it.value(run).or_else(|| it.lower_bound(run)));
    let percent = percent.map_or_else(String::new, |it| format!(" ({it:.0})"));
    format!("{depth}{percent}")
}

/// Adds the results of a run to an object.
fn with_results(mut object: Value, run: &Run) -> Value {
    for quantity in of_runs() {
        object[quantity.name] = result(run, quantity);
    }
    object
}

/// Iterates over the results that are lower bounds, since the run ended before they were final.
pub fn lower_bounds(run: &Run) -> impl Iterator<Item = &'static str> {
    of_runs().filter(|it| it.lower_bound(run).is_some()).map(|it| it.name)
}

/// Writes a run of a named scene as a JSON object in reading order; `beside` adds the differences from traces.
pub fn json(name: &str, run: &Run, beside: Option<&Traces>) -> String {
    let scene = &run.scene;
    let object = json!({
        "scene": name,
        "title": scene.title,
        "model": scene.contact.model.word(),
        "interface": scene.interface.law.word(),
        "outcome": run.shot_outcome().word(),
        "criterion": scene.target.criterion.word(),
        "closure": scene.closure().word(),
        "end": run.end.words(),
        "complete": run.is_decided(),
    });
    let mut object = with_results(object, run);
    let verdict = Verdict::from_scene(scene);
    for (key, value) in verdict::object(&verdict) {
        object[key] = value;
    }
    let is_searched = verdict.limit_m_s.is_none();
    object["no_limit"] =
        is_searched.then_some("no closed form: `cmra limit` searches it by many shots").into();
    object["lower_bounds"] = lower_bounds(run).collect();
    object["penetration_at_most_m"] = run.penetration.at_most_m.into();
    object["nose_protrusion_m"] = run.protrusion_m().into();
    let basis = run.estimate.basis.map(|basis| match basis {
        EstimateBasis::SecondComputation => "second computation",
        EstimateBasis::ClosedForm => "closed form",
        EstimateBasis::HalfStep => "half the step",
        EstimateBasis::OutcomeDiffers(_) => "unknown: outcome differs",
    });
    object["error_estimate_basis"] = basis.into();
    let exists = |name: &&str| !object[*name].is_null();
    let names = run.estimate.by_result.iter().map(|error| error.0).filter(exists);
    let errors = names.map(|name| (name.to_owned(), run.error_of(name).into())).collect();
    object["error_estimates"] = Value::Object(errors);
    object["method"] = run.cost.method.into();
    object["method_reason"] = run.cost.reason.into();
    object["run_time_s"] = run.cost.took_s.into();
    object["omitted"] = run.omitted.clone().into();
    object["warnings"] = texts(&warnings(run));
    let plastic = |run: &Arc<Run>| {
        let mut object = with_results(json!({ "outcome": run.shot_outcome().word() }), run);
        object["warnings"] = run.warnings.iter().map(ToString::to_string).collect();
        object
    };
    object["plastic"] = run.plastic.as_ref().map(plastic).into();
    let known = if run.outcome == Outcome::Unmeasured { AT_START } else { ENERGY.len() };
    let energy = ENERGY.iter().enumerate().map(|(index, (key, _, get))| {
        let value: Value = (index < known).then(|| get(&run.ledger)).into();
        ((*key).to_owned(), value)
    });
    object["energy_j"] = Value::Object(energy.collect());
    let event = |it: &Event| json!({ "time_s": it.t_s, "event": it.kind.words() });
    object["events"] = run.events.iter().map(event).collect();
    object["variables"] = all_variables(scene);
    object["version"] = env!("CARGO_PKG_VERSION").into();
    if let Some(stack) = &run.stack {
        object["stack"] = stack_of(run, stack);
    }
    if let Some(traces) = beside {
        object["with"] = traces.json(run);
    }
    pretty(&object)
}

/// Returns the object of a stack, with the results of every struck plate.
fn stack_of(whole: &Run, stack: &StackRun) -> Value {
    // The first plate alone.
    let scene = Scene { stack: Stack::default(), sweep: None, ..(*whole.scene).clone() };
    let first = Run { stack: None, scene: Arc::new(scene), ..whole.clone() };
    let plates = std::iter::once(&first).chain(stack.behind.iter().map(|run| &**run));
    let rows: Vec<Value> = plates
        .enumerate()
        .map(|(plate, run)| {
            let row = json!({
                "plate": stack.name(plate),
                "impact_velocity_m_s": run.scene.projectile.velocity_m_s,
                "outcome": stack.outcome_of(plate, run).word(),
            });
            with_results(row, run)
        })
        .collect();
    json!({
        "elements": stack.elements,
        "outcome": stack.outcome.word(),
        "penetration_m": stack.penetration_m,
        "residual_velocity_m_s": stack.residual_velocity_m_s,
        "plates": rows,
    })
}

/// Returns a result, else its lower bound.
fn result(run: &Run, quantity: &Quantity) -> Value {
    let value = quantity.value(run).or_else(|| quantity.lower_bound(run));
    if quantity.has(QuantityFlag::Whole) {
        let whole = value.and_then(|count| format!("{count:.0}").parse().ok());
        return whole.map_or(Value::Null, Value::Number);
    }
    unsigned_zero(value.into())
}

/// Term of the energy ledger: its name in JSON, its label on pages, and its value.
type LedgerPart = (&'static str, &'static str, fn(&EnergyLedger) -> f64);

const ENERGY: [LedgerPart; 14] = [
    ("initial_kinetic", "projectile", |it| it.initial_kinetic_j),
    ("initial_plate", "plate", |it| it.initial_plate_j),
    ("initial_spring", "cocked spring", |it| it.initial_spring_j),
    ("weight", "weight since", |it| it.weight_j),
    ("projectile", "projectile", |it| it.projectile_j),
    ("plate", "plate", |it| it.plate_j),
    ("mechanism_inertia", "mechanism", |it| it.inertia_j),
    ("spring", "spring", |it| it.spring_j),
    ("crush", "crushed", |it| it.crush_j),
    ("damper", "damper", |it| it.damper_j),
    ("penetration", "penetration", |it| it.penetration_j),
    ("plug_pick_up", "plug pick-up", |it| it.pick_up_j),
    ("shear", "plug sheared", |it| it.shear_j),
    ("stop", "stop", |it| it.stop_j),
];
/// Number of terms present at the start.
const AT_START: usize = 3;

/// Returns the values of all variables, by full key.
fn all_variables(scene: &Scene) -> Value {
    let listed = |variable: &&Variable| {
        !variable.key.starts_with("mechanism.") || variables::is_listed(variable, scene)
    };
    let entry = |variable: &Variable| {
        let value = match variable.value(scene) {
            variables::Value::Number(number) => number.into(),
            variables::Value::Absent => Value::Null,
            variables::Value::Word(word) => word.into(),
            variables::Value::Switch(on) => on.into(),
        };
        (variable.key.to_owned(), value)
    };
    Value::Object(VARIABLES.iter().filter(listed).map(entry).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::testing::run_of;
    use cmra_engine::model::run::{AtLeast, ContactMode, Penetration, RunWarning};

    fn sample(t_s: f64, penetration_m: f64, mode: ContactMode) -> Sample {
        Sample { t_s, mode, penetration_m, ..Sample::default() }
    }

    /// Results of one plate do not exist for a stack, and the mount that is loaded most is known.
    #[test]
    fn a_stack_has_the_mount_force_of_its_plate_with_the_greatest() {
        let run = run_of("elements=2 h=5mm h_base=5mm v_i=200 interface=plastic");
        let forces = run.plates().filter_map(|plate| plate.mechanism.peak_mount_n);
        let greatest_kn = 1e-3 * forces.fold(0.0, f64::max);
        let table = comparison([("now".to_owned(), Ok(&run))]);
        let shown = table.cells(&["peak_mount_force_n"])[0].cells[0].clone();
        assert_eq!(shown, fixed_significant(greatest_kn, 4));
    }

    /// The push of a fused interface is unbounded at a rigid stop; the force of the contact is not.
    #[test]
    fn the_peak_of_a_comparison_is_that_of_the_page() {
        let run = run_of("x_stop=5mm");
        let table = comparison([("now".to_owned(), Ok(&run))]);
        let peak = &table.cells(&["peak_contact_force_n"])[0].cells[0];
        assert_eq!(*peak, fixed_significant(1e-3 * run.peak_contact_force_n.unwrap(), 4));
    }

    /// The table marks a lower bound by `>=`, with its percentage of the depth on a rigid mount.
    #[test]
    fn a_lower_bound_is_one_in_a_comparison() {
        let moving = Run {
            at_least: AtLeast { penetration_m: Some(6e-3), plate_displacement_m: Some(0.02) },
            penetration: Penetration { baseline_m: Some(8e-3), ..Penetration::default() },
            ..Run::default()
        };
        let run = Run { plastic: Some(Arc::new(moving.clone())), ..moving };
        let table = comparison([("now".to_owned(), Ok(&run))]);
        let keys = ["final_penetration_m", "plastic", "max_plate_displacement_m"];
        let cells = table.cells(&keys).into_iter().map(|column| column.cells[0].clone());
        assert_eq!(cells.collect::<Vec<_>>(), [">= 6.000 (75)", ">= 6.000 (75)", ">= 20.00"]);
    }

    /// By its protrusion a nose perforates that stays in the plate.
    #[test]
    fn a_nose_that_only_protrudes_has_a_depth_in_a_comparison() {
        for (pairs, stays) in
            [("v_i=215 h=8mm criterion=protrusion", true), ("v_i=400 h=3mm", false)]
        {
            let run = run_of(pairs);
            assert_eq!(run.shot_outcome(), Outcome::Perforated, "{pairs}");
            let table = comparison([("now".to_owned(), Ok(&run))]);
            let depth = fixed_significant(1e3 * run.penetration.final_m.unwrap(), 4);
            let cell = if stays { &depth } else { "through" };
            assert_eq!(table.cells(&["final_penetration_m"])[0].cells[0], cell, "{pairs}");
        }
    }

    /// Headline, table and objects of a stack name one outcome, by the criterion of the scene.
    #[test]
    fn a_stack_perforated_by_protrusion_is_perforated_everywhere() {
        let run = run_of("elements=1 h_base=3mm h=0.5mm v_i=110 criterion=protrusion");
        let object: Value = serde_json::from_str(&json("a stack", &run, None)).unwrap();
        assert_eq!(object["outcome"], "perforated");
        assert_eq!(object["stack"]["outcome"], "perforated");
        assert_eq!(object["stack"]["plates"][1]["outcome"], "perforated");
        assert!(object["stack"]["plates"][1]["final_penetration_m"].is_number());
        let page = format!("{:?}", stack::blocks(&run));
        assert!(!page.contains("arrested") && !page.contains("stopped"), "{page}");
        assert!(page::outcome(&run).contains("perforated by the army criterion"));
    }

    fn jump() -> Vec<Sample> {
        vec![
            sample(0.0, 0.0, ContactMode::Penetrating),
            sample(1.0, 2.0, ContactMode::Penetrating),
            sample(1.0, 5.0, ContactMode::Fused),
            sample(2.0, 5.0, ContactMode::Fused),
        ]
    }

    #[test]
    fn each_event_stands_once_and_none_is_lost() {
        let events = [
            (1.0, EventKind::FirstArrest),
            (1.0, EventKind::NoseBuried),
            (3.0, EventKind::GreatestDisplacement),
        ]
        .map(|(t_s, kind)| Event { t_s, kind });
        let (first, last) = ("projectile first stops; nose buried", "greatest displacement");
        assert_eq!(placed(&jump(), &events), [(1, first.to_owned()), (3, last.to_owned())]);
    }

    /// A spreadsheet cuts a field of more than 32,767 characters, and some readers refuse one of more than 131,072.
    #[test]
    fn many_events_of_a_row_are_counted() {
        let event = |kind, at: usize| Event { t_s: 1.0 + at as f64 * 1e-6, kind };
        let swings = |count: usize| -> Vec<Event> {
            let pair = [EventKind::Separation, EventKind::Recontact];
            let pairs = pair.into_iter().cycle().enumerate().map(|(at, kind)| event(kind, at + 1));
            [event(EventKind::FirstArrest, 0)].into_iter().chain(pairs.take(count)).collect()
        };
        let text = |count: usize| placed(&jump(), &swings(count)).pop().unwrap();
        let few = "separation; contact again; separation; contact again";
        assert_eq!(text(4), (3, few.to_owned()));
        let many = "separation (10000 times); contact again (10000 times)";
        assert_eq!(text(20_000), (3, many.to_owned()));
        let odd = [swings(20_000), vec![event(EventKind::StopHit, 30_000)]].concat();
        assert_eq!(placed(&jump(), &odd)[1].1, format!("{many}; stop hit"));
        assert_eq!(placed(&jump(), &odd)[0], (1, "projectile first stops".to_owned()));
    }
    /// An energy balance that does not close is said beside the numbers it belongs to.
    #[test]
    fn the_plastic_results_have_the_warnings_of_their_own_run() {
        let drift = RunWarning::EnergyDrift { residual: 1e-5 };
        let plastic = Run { warnings: vec![drift], ..Run::default() };
        let run = Run { plastic: Some(Arc::new(plastic)), ..Run::default() };
        let object: Value = serde_json::from_str(&json("a", &run, None)).unwrap();
        assert!(!object["warnings"].to_string().contains("energy balance"));
        assert!(object["plastic"]["warnings"][0].as_str().unwrap().contains("energy balance"));
    }
}
