//! Pareto fronts: one row for each design, and the whole as an object. SI, percent for percentages.

use serde_json::{Value, json};

use crate::model::library;
use crate::model::run::Outcome;
use crate::model::scene::{InterfaceLaw, Scene};
use crate::model::units::significant;
use crate::report::Remark;
use crate::report::table::Table;
use crate::study::search::front::{Candidate, Front, Lack, Standing, Task};
use crate::study::sweep::{PointOutcome, Spacing};
use crate::study::validity;

/// Warnings about the rows: those of a single best design; of a front how many designs are outside validity.
pub fn warnings(scene: &Scene, task: &Task, fronts: &[Front]) -> Vec<String> {
    let known: Vec<String> = library::warnings(scene).map(str::to_owned).collect();
    let mut warnings = known.clone();
    warnings.extend(validity::of_pair(scene, &task.axes, &task.measures()));
    for front in fronts {
        let law = front.law.word();
        if let [design] = &*front.designs {
            let (name, scene) = (format!("best design, {law}"), front.scene(task, design));
            warnings.extend(validity::of_design(&name, &scene, &task.axes, &known));
        } else if !front.outside.is_empty() {
            let (count, outside) = (front.designs.len(), validity::counted(&front.outside));
            warnings.push(format!(
                "{law}: outside validity, of {count} designs: {outside} (`cmra run` of a design says why)"
            ));
        }
    }
    warnings
}

/// A candidate's standing in a sentence.
pub fn standing(candidate: &Candidate, task: &Task) -> Remark {
    match &candidate.standing {
        Standing::OnFront => Remark::new("", "on the Pareto front: not dominated"),
        Standing::Dominated { by } => Remark::new("", format!("dominated by design {}", by + 1)),
        Standing::Breaks(broken) => {
            let words: Vec<String> =
                broken.iter().map(|at| task.constraints[*at].words()).collect();
            Remark::caution("", format!("violates {}", words.join(", ")))
        }
        Standing::NoValue(outcome) => {
            let measures = task.objectives.iter().map(|it| it.measure);
            let missing = measures.zip(&candidate.measures).find(|(_, value)| value.is_none());
            let why = match missing.map(|it| it.0) {
                Some(it) if it.name == "peak_mount_force_n" && outcome.is_stopped() => {
                    "a rigid stop is hit, the force is unbounded"
                }
                Some(it) => outcome.without_value(it),
                None => outcome.word(),
            };
            Remark::caution("", format!("not on the front: {why}"))
        }
        Standing::Impossible => Remark::caution("", "not possible with this scene"),
    }
}

/// Why a front without designs has none, beside its constraints: objectives that do not exist.
pub fn lacks(front: &Front) -> Vec<String> {
    let v = front.base.projectile.velocity_m_s;
    let say = |lack: &Lack| {
        let why = match lack.outcome {
            PointOutcome::Ended(Outcome::Perforated) => format!(
                "the shot of v_i = {} m/s perforates them; set a slower v_i, or take a quantity that does not depend on the shot, such \
                 as plate_mass_kg",
                significant(v, 4)
            ),
            other => other.without_value(lack.measure).to_owned(),
        };
        let (name, count) = (lack.measure.name, lack.count);
        format!("{name} does not exist in {count} of {} runs: {why}", front.runs)
    };
    front.lacks.iter().filter(|_| front.designs.is_empty()).map(say).collect()
}

/// A candidate's standing in a word.
fn word_of(standing: &Standing) -> &'static str {
    match standing {
        Standing::OnFront => "on the front",
        Standing::Dominated { .. } => "dominated",
        Standing::Breaks(_) => "violates a constraint",
        Standing::NoValue(_) => "no value",
        Standing::Impossible => "impossible",
    }
}

/// A design of a front, or a candidate beside it.
pub struct Row<'f> {
    law: InterfaceLaw,
    /// `front`, or the name of a candidate.
    kind: &'static str,
    values: Vec<Option<f64>>,
    measures: &'f [Option<f64>],
    /// What becomes of the design; of a candidate its standing.
    outcome: &'static str,
}

fn design(front: &Front, at: usize) -> Row<'_> {
    let design = &front.designs[at];
    Row {
        law: front.law,
        kind: "front",
        values: design.values.iter().copied().map(Some).collect(),
        measures: &design.measures,
        outcome: design.outcome.word(),
    }
}

fn candidates<'f>(task: &Task, front: &'f Front) -> impl Iterator<Item = Row<'f>> {
    front.candidates.iter().map(|candidate| Row {
        law: front.law,
        kind: candidate.name,
        values: task.axes.iter().map(|axis| axis.get(candidate.scene.as_ref()?)).collect(),
        measures: &candidate.measures,
        outcome: word_of(&candidate.standing),
    })
}

/// Every front: its designs, then its candidates.
pub fn table<'c>(name: &'c str, task: &Task, fronts: &'c [Front]) -> Table<'c, Row<'c>> {
    let rows = fronts.iter().flat_map(|front| {
        let designs = (0..front.designs.len()).map(|at| design(front, at));
        designs.chain(candidates(task, front))
    });
    with_columns(Table::of(rows), name, task)
}

/// Some designs of a front, by their places.
pub fn designs<'c>(
    task: &Task,
    front: &'c Front,
    places: impl Iterator<Item = usize>,
) -> Table<'c, Row<'c>> {
    with_columns(Table::of(places.map(|at| design(front, at))), "", task)
}

fn with_columns<'c>(rows: Table<'c, Row<'c>>, name: &'c str, task: &Task) -> Table<'c, Row<'c>> {
    let mut table = rows
        .with("scene", "scene", "", move |_| name)
        .with("interface", "interface", "", |row| row.law.word())
        .with("design", "design", "", |row| row.kind);
    for (at, axis) in task.axes.iter().enumerate() {
        table = table.with(axis.symbol(), axis.symbol(), axis.variable().unit(), move |row| {
            row.values.get(at).copied().flatten()
        });
    }
    for (at, measure) in task.measures().into_iter().enumerate() {
        table = table
            .with(measure.name, measure.heading(), "", move |row| {
                row.measures.get(at).copied().flatten()
            })
            .shown(|_, value| Some(measure.show(value.as_f64()?, 4)));
    }
    table.with("outcome", "outcome", "", |row| row.outcome)
}

/// Everything, as one object; null for what does not exist.
pub fn json(name: &str, task: &Task, fronts: &[Front]) -> Value {
    let variables = task.axes.iter().map(|axis| {
        let (low, high) = axis.ends();
        json!({
            "variable": axis.symbol(), "key": axis.variable().key, "low": low, "high": high,
            "log": axis.spacing() == Spacing::Log,
        })
    });
    let objectives = task.objectives.iter().map(
        |objective| json!({ "output": objective.measure.name, "maximise": objective.maximise }),
    );
    let constraints = task.constraints.iter().map(|constraint| {
        let sign = if constraint.at_most { "<=" } else { ">=" };
        json!({ "output": constraint.measure.name, "is": sign, "bound": constraint.bound })
    });
    json!({
        "scene": name,
        "variables": variables.collect::<Vec<_>>(),
        "objectives": objectives.collect::<Vec<_>>(),
        "constraints": constraints.collect::<Vec<_>>(),
        "seed": task.effort.seed,
        "population": task.effort.population,
        "generations": task.effort.generations,
        "fronts": fronts.iter().map(|front| of_front(task, front)).collect::<Vec<_>>(),
    })
}

fn of_front(task: &Task, front: &Front) -> Value {
    let is_own = |key: &str| !["scene", "interface", "design"].contains(&key);
    let challengers = with_columns(Table::of(candidates(task, front)), "", task);
    let mut list = Vec::new();
    for (row, candidate) in challengers.rows.iter().zip(&front.candidates) {
        let mut object = challengers.object(row, is_own);
        object.remove("outcome");
        let by = if let Standing::Dominated { by } = candidate.standing { Some(by) } else { None };
        object.extend([
            ("name".to_owned(), candidate.name.into()),
            ("source".to_owned(), candidate.source.into()),
            ("standing".to_owned(), row.outcome.into()),
            ("dominated_by".to_owned(), by.into()),
        ]);
        list.push(object);
    }
    json!({
        "interface": front.law.word(),
        "runs": front.runs,
        "given_up": front.given_up,
        "no_design": lacks(front),
        "generations": front.generations,
        "complete": front.is_complete,
        "designs": designs(task, front, 0..front.designs.len()).objects(is_own),
        "candidates": list,
    })
}
