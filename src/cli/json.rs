//! A run as one JSON object, in the order a reader expects, with null where a quantity does not exist.

use serde::ser::{Serialize, SerializeMap, Serializer};
use serde_json::{Map, Value, json};

use crate::cli::run::Computed;
use crate::model::run::StackRun;
use crate::model::run::envelope::warnings;
use crate::model::run::{EnergyLedger, EstimateBasis, Run};
use crate::model::scene::Scene;
use crate::model::variables::{self, VARIABLES, Variable};
use crate::study::quantities::{Quantity, of_runs};

/// The object's entries; a plain map would sort them.
struct Entries(Vec<(&'static str, Value)>);

impl Serialize for Entries {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (key, value) in &self.0 {
            map.serialize_entry(key, value)?;
        }
        map.end()
    }
}

/// The text of the object, with a line end.
pub(super) fn text(computed: &Computed) -> String {
    let run = &computed.run;
    let scene = &run.scene;
    let word = |name: &str| {
        variables::find(name).map_or(Value::Null, |variable| Value::from(variable.show(scene)))
    };
    let mut entries = vec![
        ("scene", Value::from(computed.preset.name.as_str())),
        ("title", Value::from(scene.title.as_str())),
        ("model", word("contact.model")),
        ("interface", word("interface.law")),
        ("outcome", Value::from(run.outcome.word())),
        ("end", Value::from(run.end.words())),
        ("complete", Value::from(run.end.is_complete())),
    ];
    for column in of_runs() {
        entries.push((column.name, result(run, column)));
    }
    let bounds = of_runs().filter(|column| column.lower_bound(run).is_some());
    entries.push(("lower_bounds", bounds.map(|column| Value::from(column.name)).collect()));
    let optional = |value: Option<f64>| value.map_or(Value::Null, finite);
    entries.push(("penetration_at_most_m", optional(run.penetration_at_most_m)));
    entries.push(("nose_protrusion_m", optional(run.protrusion_m())));
    entries.extend([
        (
            "error_estimate_basis",
            run.error_estimate.map_or(Value::Null, |estimate| {
                Value::from(match estimate.basis {
                    EstimateBasis::ClosedForm => "closed form",
                    EstimateBasis::SecondComputation => "second computation",
                    EstimateBasis::HalfStep => "half the step",
                    EstimateBasis::OutcomeDiffers(_) => "unknown: outcome differs",
                })
            }),
        ),
        ("error_estimates", estimates(run)),
        ("method", Value::from(run.cost.method)),
        ("method_reason", Value::from(run.cost.reason)),
        ("run_time_s", finite(computed.took.as_secs_f64())),
        ("omitted", run.omitted.iter().map(|omitted| omitted.words()).collect()),
        ("warnings", Value::from(warnings(run))),
        ("energy_j", energy(&run.ledger)),
        (
            "events",
            run.events
                .iter()
                .map(|event| json!({ "time_s": finite(event.t_s), "event": event.kind.words() }))
                .collect(),
        ),
        ("variables", all_variables(scene)),
        ("version", Value::from(env!("CARGO_PKG_VERSION"))),
    ]);
    if let Some(stack) = &run.stack {
        entries.push(("stack", stack_of(run, stack)));
    }
    // Keys are strings and every number is finite, so nothing can be refused.
    let text = serde_json::to_string_pretty(&Entries(entries)).unwrap_or_default();
    text + "\n"
}

/// The whole stack, and the results of every plate that was struck.
fn stack_of(first: &Run, stack: &StackRun) -> Value {
    let plates = std::iter::once(first).chain(stack.behind.iter().map(|run| &**run));
    let rows: Vec<Value> = plates
        .enumerate()
        .map(|(plate, run)| {
            let mut row = Map::new();
            row.insert("plate".to_owned(), Value::from(stack.name(plate)));
            let impact = run.scene.projectile.velocity_m_s;
            row.insert("impact_velocity_m_s".to_owned(), finite(impact));
            row.insert("outcome".to_owned(), Value::from(run.outcome.word()));
            let own = of_runs().filter(|column| !column.name.starts_with("stack_"));
            row.extend(own.map(|column| (column.name.to_owned(), result(run, column))));
            Value::Object(row)
        })
        .collect();
    json!({
        "elements": stack.elements,
        "outcome": stack.outcome.word(),
        "penetration_m": stack.penetration_m.map_or(Value::Null, finite),
        "residual_velocity_m_s": stack.residual_velocity_m_s.map_or(Value::Null, finite),
        "plates": rows,
    })
}

/// A result, or what it is at least.
fn result(run: &Run, quantity: &Quantity) -> Value {
    let value = quantity.value(run).or_else(|| quantity.lower_bound(run));
    if quantity.is_whole {
        let whole = value.and_then(|count| format!("{count:.0}").parse().ok());
        return whole.map_or(Value::Null, Value::Number);
    }
    value.into()
}

/// A number; null for one that is not finite, which JSON cannot say.
fn finite(value: f64) -> Value {
    serde_json::Number::from_f64(value).map_or(Value::Null, Value::Number)
}

/// The relative error estimate of each result.
fn estimates(run: &Run) -> Value {
    let rows = run.error_estimates.iter();
    Value::Object(rows.map(|error| (error.name.to_owned(), finite(error.relative))).collect())
}

fn energy(ledger: &EnergyLedger) -> Value {
    json!({
        "initial_kinetic": finite(ledger.initial_kinetic_j),
        "initial_spring": finite(ledger.initial_spring_j),
        "projectile": finite(ledger.projectile_j),
        "plate": finite(ledger.plate_j),
        "mechanism_inertia": finite(ledger.inertia_j),
        "spring": finite(ledger.spring_j),
        "crush": finite(ledger.crush_j),
        "damper": finite(ledger.damper_j),
        "penetration": finite(ledger.penetration_j),
        "stop": finite(ledger.stop_j),
    })
}

/// What was put in, by full key.
fn all_variables(scene: &Scene) -> Value {
    let mut map = Map::new();
    let listed = |variable: &&Variable| {
        !variable.key.starts_with("mechanism.") || variables::is_listed(variable, scene)
    };
    for variable in VARIABLES.iter().filter(listed) {
        let value = match variable.value(scene) {
            variables::Value::Number(number) => finite(number),
            variables::Value::Absent => Value::Null,
            variables::Value::Word(word) => Value::from(word),
            variables::Value::Switch(on) => Value::from(on),
        };
        map.insert(variable.key.to_owned(), value);
    }
    Value::Object(map)
}
