//! Pareto fronts for machines: a row a design, or one JSON object. SI, percent for percentages.

use serde_json::{Map, Value, json};

use crate::files::rows::{Rows, number};
use crate::model::scene::InterfaceLaw;
use crate::study::search::front::{Candidate, Front, Standing, Task};
use crate::study::sweep::{Axis, Spacing};

/// The law's word.
pub fn law(law: InterfaceLaw) -> &'static str {
    match law {
        InterfaceLaw::Fused => "fused",
        InterfaceLaw::Plastic => "plastic",
    }
}

/// A candidate's standing in a word.
pub fn standing(standing: &Standing) -> &'static str {
    match standing {
        Standing::OnFront => "on the front",
        Standing::Beaten { .. } => "beaten",
        Standing::Breaks(_) => "breaks a constraint",
        Standing::NoValue(_) => "no value",
        Standing::Impossible => "impossible",
    }
}

/// Every front as rows: scene, law, kind (`front`, or the name of a candidate), the variables, the measures, the outcome.
pub fn rows(name: &str, task: &Task, fronts: &[Front]) -> Rows {
    let symbols = task.axes.iter().map(Axis::symbol);
    let measures = task.measures();
    let columns = ["scene", "interface", "design"].into_iter().chain(symbols);
    let columns = columns.chain(measures.iter().map(|it| it.name)).chain(["outcome"]).collect();
    let mut rows = Vec::new();
    for front in fronts {
        let lead =
            |kind: &str| -> Vec<Value> { [name, law(front.law), kind].map(Value::from).into() };
        for design in &front.designs {
            let mut row = lead("front");
            row.extend(design.values.iter().map(|value| number(Some(*value))));
            row.extend(design.measures.iter().map(|value| number(*value)));
            row.push(Value::from(design.fate.word()));
            rows.push(row);
        }
        for candidate in &front.candidates {
            let mut row = lead(candidate.name);
            row.extend(values(task, candidate).into_iter().map(number));
            row.extend(candidate.measures.iter().map(|value| number(*value)));
            row.push(Value::from(standing(&candidate.standing)));
            rows.push(row);
        }
    }
    Rows { columns, rows }
}

/// A candidate's values of the variables.
fn values(task: &Task, candidate: &Candidate) -> Vec<Option<f64>> {
    let value = |axis: &Axis| (axis.number().get)(candidate.scene.as_ref()?);
    task.axes.iter().map(value).collect()
}

/// Everything, as one object; null for what does not exist.
pub fn json(name: &str, task: &Task, fronts: &[Front]) -> String {
    let variables = task.axes.iter().map(|axis| {
        let (low, high) = axis.ends();
        json!({
            "variable": axis.symbol(), "key": axis.variable().key, "low": number(Some(low)),
            "high": number(Some(high)), "log": axis.spacing() == Spacing::Log,
        })
    });
    let objectives = task.objectives.iter().map(
        |objective| json!({ "output": objective.measure.name, "maximise": objective.maximise }),
    );
    let constraints = task.constraints.iter().map(|constraint| {
        let sign = if constraint.at_most { "<=" } else { ">=" };
        json!({ "output": constraint.measure.name, "is": sign, "bound": number(Some(constraint.bound)) })
    });
    let object = json!({
        "scene": name,
        "variables": variables.collect::<Vec<_>>(),
        "objectives": objectives.collect::<Vec<_>>(),
        "constraints": constraints.collect::<Vec<_>>(),
        "seed": task.effort.seed,
        "population": task.effort.population,
        "generations": task.effort.generations,
        "fronts": fronts.iter().map(|front| of_front(task, front)).collect::<Vec<_>>(),
    });
    // Keys are strings and every number is finite, so nothing can be refused.
    serde_json::to_string_pretty(&object).unwrap_or_default() + "\n"
}

fn of_front(task: &Task, front: &Front) -> Value {
    let measures = task.measures();
    let named = |values: &[Option<f64>], found: &[Option<f64>]| {
        let symbols = task.axes.iter().map(Axis::symbol).zip(values);
        let results = measures.iter().map(|column| column.name).zip(found);
        let entries = symbols.chain(results);
        entries.map(|(key, value)| (key.to_owned(), number(*value))).collect::<Map<String, Value>>()
    };
    let designs = front.designs.iter().map(|design| {
        let own: Vec<Option<f64>> = design.values.iter().map(|value| Some(*value)).collect();
        let mut object = named(&own, &design.measures);
        object.insert("outcome".to_owned(), Value::from(design.fate.word()));
        Value::Object(object)
    });
    let candidates = front.candidates.iter().map(|candidate| {
        let mut object = named(&values(task, candidate), &candidate.measures);
        object.insert("name".to_owned(), Value::from(candidate.name));
        object.insert("source".to_owned(), Value::from(candidate.source));
        object.insert("standing".to_owned(), Value::from(standing(&candidate.standing)));
        let by = match candidate.standing {
            Standing::Beaten { by } => Some(by),
            Standing::OnFront
            | Standing::Breaks(_)
            | Standing::NoValue(_)
            | Standing::Impossible => None,
        };
        object.insert("beaten_by".to_owned(), by.map_or(Value::Null, Value::from));
        Value::Object(object)
    });
    json!({
        "interface": law(front.law),
        "runs": front.runs,
        "given_up": front.given_up,
        "generations": front.generations,
        "complete": front.is_complete,
        "designs": designs.collect::<Vec<_>>(),
        "candidates": candidates.collect::<Vec<_>>(),
    })
}
