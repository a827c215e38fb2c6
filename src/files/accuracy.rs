//! A comparison of methods as rows for machines: CSV with one row a point, JSON with the same keys.

use serde_json::{Map, Value};

use crate::files::error::FileError;
use crate::model::units;
use crate::study::accuracy::method::{Knob, Method};
use crate::study::accuracy::reference::Reference;
use crate::study::accuracy::{MethodReport, Point, Report};

/// A scene's name and its comparison.
pub type Named = (String, Report);

/// Columns of the CSV and keys of a point.
const COLUMNS: [&str; 20] = [
    "scene",
    "method",
    "letter",
    "time_step_s",
    "tolerance",
    "error",
    "penetration_error",
    "time_error",
    "at_floor",
    "penetration_m",
    "end_time_s",
    "steps",
    "rejected",
    "rhs_evaluations",
    "run_time_s_min",
    "run_time_s_median",
    "run_time_s_mad",
    "repeats",
    "observed_order",
    "refused",
];

/// Columns of the CSV that tell what a method was judged by.
const JUDGE: [&str; 2] = ["reference", "reference_uncertainty"];

/// Where `auto` gave no answer, in words: the knob, and why.
pub fn auto_failures((scene, report): &Named) -> Vec<String> {
    let auto = report.methods.iter().filter(|it| it.method == Method::Auto);
    auto.flat_map(|method| &method.points)
        .filter_map(|point| {
            let why = point.result.as_ref().err()?.words();
            Some(format!("{scene}: auto gave no answer at {}: {why}", point.knob))
        })
        .collect()
}

/// A point's values in the order of [`COLUMNS`].
fn values(scene: &str, method: &MethodReport, point: &Point) -> [Value; COLUMNS.len()] {
    let (mut step, mut tolerance) = (Value::Null, Value::Null);
    match point.knob {
        Knob::None => {}
        Knob::Step(dt_s) => step = number(dt_s),
        Knob::Tolerance(value) => tolerance = number(value),
    }
    let of = |get: &dyn Fn(&crate::study::accuracy::Measured) -> Value| {
        point.result.as_ref().map_or(Value::Null, get)
    };
    [
        Value::from(scene),
        Value::from(method.method.name()),
        Value::from(method.method.letter().to_string()),
        step,
        tolerance,
        of(&|m| number(m.error())),
        of(&|m| number(m.depth_error)),
        of(&|m| number(m.time_error)),
        of(&|m| Value::from(m.is_at_floor())),
        of(&|m| number(m.answer.depth_m)),
        of(&|m| number(m.answer.t_s)),
        of(&|m| Value::from(m.answer.steps)),
        of(&|m| Value::from(m.answer.rejected)),
        of(&|m| Value::from(m.answer.evaluations)),
        of(&|m| number(m.timing.min_s)),
        of(&|m| number(m.timing.median_s)),
        of(&|m| m.timing.mad_s.map_or(Value::Null, number)),
        of(&|m| Value::from(m.timing.repeats)),
        method.observed_order().map_or(Value::Null, number),
        point.result.err().map_or(Value::Null, |refusal| Value::from(refusal.words())),
    ]
}

/// CSV text, one row a point.
///
/// # Errors
/// [`FileError::Csv`] should a row be malformed.
pub fn csv(reports: &[Named]) -> Result<String, FileError> {
    let mut writer = ::csv::Writer::from_writer(Vec::new());
    let table = FileError::Csv;
    writer.write_record(COLUMNS.iter().chain(&JUDGE)).map_err(table)?;
    for (name, report) in reports {
        for method in &report.methods {
            let judge = judge(method.reference.as_ref());
            for point in &method.points {
                let row = values(name, method, point).into_iter().chain(judge.clone());
                writer.write_record(row.map(|value| field(&value))).map_err(table)?;
            }
        }
    }
    let bytes = writer.into_inner().map_err(|error| table(error.into_error().into()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

fn judge(reference: Option<&Reference>) -> [Value; JUDGE.len()] {
    let basis = reference.map_or(Value::Null, |found| Value::from(found.basis.words()));
    let uncertainty = reference.and_then(|found| found.uncertainty).map_or(Value::Null, number);
    [basis, uncertainty]
}

/// A list with one object a scene.
pub fn json(reports: &[Named]) -> String {
    let list: Vec<Value> = reports.iter().map(|(name, report)| scene(name, report)).collect();
    // Keys are strings and every number is finite, so nothing can be refused.
    serde_json::to_string_pretty(&list).unwrap_or_default() + "\n"
}

fn scene(name: &str, report: &Report) -> Value {
    let mut object = Map::new();
    object.insert("scene".into(), name.into());
    let references = report.references.iter().map(|reference| {
        let mut object = Map::new();
        object.insert("basis".into(), reference.basis.words().into());
        object.insert("ending".into(), reference.ending.word().into());
        object.insert("penetration_m".into(), number(reference.depth_m));
        object.insert("end_time_s".into(), number(reference.t_s));
        let uncertainty = reference.uncertainty.map_or(Value::Null, number);
        object.insert("uncertainty".into(), uncertainty);
        Value::Object(object)
    });
    object.insert("references".into(), references.collect());
    let answers = [1e-4, 1e-6, 1e-9, 1e-12].map(|target| {
        let mut answer = Map::new();
        answer.insert("error".into(), number(target));
        let found = report.cheapest(target);
        answer.insert("method".into(), found.map_or(Value::Null, |it| it.method.name().into()));
        let knob = found.and_then(|it| it.knob.value()).map_or(Value::Null, number);
        answer.insert("knob".into(), knob);
        answer.insert("run_time_s".into(), found.map_or(Value::Null, |it| number(it.min_s)));
        let full = report.cheapest_in_full(target);
        answer.insert("nothing_left_out_s".into(), full.map_or(Value::Null, |it| number(it.min_s)));
        Value::Object(answer)
    });
    object.insert("answers".into(), answers.into_iter().collect());
    let points = report.methods.iter().flat_map(|method| {
        let judge = judge(method.reference.as_ref());
        method.points.iter().map(move |point| {
            let pairs = COLUMNS.iter().zip(values(name, method, point));
            let pairs = pairs.chain(JUDGE.iter().zip(judge.clone()));
            Value::Object(pairs.map(|(key, value)| ((*key).to_owned(), value)).collect())
        })
    });
    object.insert("points".into(), points.collect());
    Value::Object(object)
}

/// A number; null for one that is not finite, which JSON cannot say.
fn number(value: f64) -> Value {
    serde_json::Number::from_f64(value).map_or(Value::Null, Value::Number)
}

/// A value as a CSV field; what does not exist is empty.
fn field(value: &Value) -> String {
    match value {
        Value::Null => String::new(),
        Value::String(text) => text.clone(),
        Value::Number(number) if number.is_f64() => {
            number.as_f64().map_or_else(String::new, units::shortest)
        }
        Value::Number(_) | Value::Bool(_) | Value::Array(_) | Value::Object(_) => value.to_string(),
    }
}
