//! Report of a Pareto front: a table with one row for each design, and an object. SI, percent for percentages.

use serde_json::{Value, json};

use crate::report::compare::{UNHELD, marked};
use crate::report::page::Page;
use crate::report::table::{Cells, Table};
use crate::study::compare::is_held;
use crate::study::context::Reach;
use crate::study::library;
use crate::study::search::front::{FrontReport, MissingObjective, Objective, STEPS_MAX};
use crate::study::sweep::{Axis, PointOutcome, Spacing};
use crate::study::validity;
use crate::study::verdict::Verdict;
use cmra_engine::model::run::{Outcome, Warning};
use cmra_engine::model::units::{significant, velocity};

/// Describes the constraint of a search unless it is switched off, with the warnings that it lets pass.
fn feasible(front: &FrontReport) -> String {
    let passes = front.known.iter().filter(|it| validity::lets_pass(**it, &front.known));
    let passes: Vec<&str> = passes.map(|check| check.label()).collect();
    let but = match &*passes {
        [] => String::new(),
        labels => format!(", but for those of the scene itself ({})", labels.join(", ")),
    };
    format!(
        "feasible: the shot is stopped, and no warning that the answer errs on the unsafe side{but}"
    )
}

/// Returns warnings about the rows: those of a single best design; for a front, the number of designs outside validity.
pub fn warnings(front: &FrontReport) -> Vec<Warning> {
    let (scene, request) = (&front.base, &front.request);
    let known: Vec<Warning> = library::warnings(scene).collect();
    let mut warnings = known.clone();
    warnings.extend(validity::of_pair(scene, &request.over, &request.measures()));
    if let [design] = &*front.designs {
        let scene = front.scene(design);
        warnings.extend(validity::of_design("best design", &scene, &request.over, &known));
    } else if !front.outside.is_empty() {
        let (count, outside) = (front.designs.len(), validity::counted(&front.outside));
        warnings.push(Warning::remark(
            format!("outside validity, of {count} designs: {outside}"),
            " (`cmra run` of a design says why)",
        ));
    }
    warnings
}

/// Explains why a front is empty: objectives that do not exist, and checks that designs fail.
pub fn lacks(front: &FrontReport) -> Vec<String> {
    if !front.designs.is_empty() {
        return Vec::new();
    }
    let v = front.base.projectile.velocity_m_s;
    let say = |lack: &MissingObjective| {
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
    let infeasible = (!front.infeasible.is_empty()).then(|| {
        let (counts, all) = (validity::counted(&front.infeasible), front.runs);
        format!("infeasible, of {all} runs: {counts}")
    });
    let unstopped = (front.unstopped > 0).then(|| {
        let v = velocity(v, 4);
        format!(
            "{} of {} runs are not known to stop {v}: a thicker plate, or a slower v_i",
            front.unstopped, front.runs
        )
    });
    front.lacks.iter().map(say).chain(infeasible).chain(unstopped).collect()
}

/// Returns the table of the designs of a front.
pub fn table<'c>(name: &'c str, front: &'c FrontReport) -> Table<'c, usize> {
    let of = move |at: &usize| &front.designs[*at];
    let mut table = Table::new(0..front.designs.len())
        .field("scene", move |_| name)
        .field("interface", move |_| front.base.interface.law.word());
    for (at, axis) in front.request.over.iter().enumerate() {
        let (symbol, unit) = (axis.symbol(), axis.variable().unit());
        table = table.with(symbol, symbol, unit, move |row| of(row).values.get(at).copied());
    }
    for (at, measure) in front.request.measures().into_iter().enumerate() {
        let value = move |row: &usize| *of(row).measures.get(at)?;
        table = table.with(measure.name, measure.heading(), "", value);
        table = table.shown(|_, value| Some(measure.show(value.as_f64()?, 4)));
    }
    // The column is needed only if an interface exceeds its limit load.
    let first = front.request.objectives[0].measure;
    let plastic = move |row: &usize| Some(of(row).plastic?.message(first));
    let verdict = move |row: &usize| Verdict::from_scene(&front.scene(of(row))).decision.word();
    let table = table
        .with("outcome", "outcome", "", move |row| of(row).outcome.key())
        .field("held", move |row| is_design_held(front, *row))
        .with("verdict", "verdict", "", verdict);
    table.with("plastic", "on a plastic interface", "", plastic)
}

/// Returns the name of a design in a list, marked if nothing holds the design.
pub fn name(front: &FrontReport, at: usize, is_knee: bool) -> String {
    let name = if is_knee { "knee".to_owned() } else { (at + 1).to_string() };
    marked(&name, is_design_held(front, at))
}

fn is_design_held(front: &FrontReport, at: usize) -> bool {
    is_held(&front.scene(&front.designs[at]))
}

/// Explains the mark of designs that nothing holds; `None` if these designs have none.
pub fn unheld(
    front: &FrontReport,
    mut designs: impl Iterator<Item = usize>,
) -> Option<&'static str> {
    designs.any(|at| !is_design_held(front, at)).then_some(UNHELD)
}

/// Returns the columns of a page: numbers, outcome and verdict, and the plastic interface if a fused one exceeds its limit load.
pub fn page_keys(front: &FrontReport) -> Vec<&'static str> {
    let axes = front.request.over.iter().map(Axis::symbol);
    let measures = front.request.measures().into_iter().map(|it| it.name);
    let has_plastic = front.designs.iter().any(|design| design.plastic.is_some());
    let ends = ["outcome", "verdict"].into_iter().chain(has_plastic.then_some("plastic"));
    axes.chain(measures).chain(ends).collect()
}

/// Maximum number of designs that a page lists.
const LISTED: usize = 16;

/// Returns the report: the request, and designs evenly spaced along the front.
pub fn page(title: &str, front: &FrontReport, reach: Reach) -> Page {
    let request = &front.request;
    let objective = |it: &Objective| {
        let most = if it.maximise { "greatest " } else { "least " };
        most.to_owned() + &it.measure.title()
    };
    let objectives: Vec<String> = request.objectives.iter().map(objective).collect();
    let mut page = Page::new(format!("{title}: {}", objectives.join(", ")));
    for constraint in &request.subject_to {
        page.line(format!("  subject to {}", constraint.label()));
    }
    if request.is_feasible {
        page.line(format!("  {} (--no-feasibility switches this off)", feasible(front)));
    }
    for axis in &request.over {
        let (low, high) = axis.ends();
        let log = if axis.spacing() == Spacing::Log { " (log)" } else { "" };
        let (low, high) = (significant(low, 4), axis.show(high, 4));
        page.line(format!("  {:8}{low} .. {high}{log}", axis.symbol()));
    }
    designs(&mut page, front, reach);
    page
}

fn designs(page: &mut Page, front: &FrontReport, reach: Reach) {
    let count = front.designs.len();
    let kind = match (front.request.objectives.len(), count) {
        (_, 0) if front.lacks.iter().any(|it| it.count == front.runs) => "no design".to_owned(),
        (_, 0) => "no design satisfies every constraint".to_owned(),
        (1, _) => "the best design".to_owned(),
        (_, _) => format!("a front of {count} designs"),
    };
    let early = if reach.is_complete() { "" } else { ", stopped early" };
    let (law, runs) = (front.base.interface.law.word(), front.runs);
    page.heading(format!("interface {law}: {kind} ({runs} runs{early})"));
    if front.given_up > 0 {
        let count = front.given_up;
        page.line(format!(
            "  {count} runs stopped after {STEPS_MAX} steps: such designs count as failed"
        ));
    }
    for lack in lacks(front) {
        page.fact("  ", 2, lack);
    }
    // Evenly spaced along the front, including both ends.
    let listed = count.min(LISTED);
    if count > 0 {
        let place = |at: usize| if listed > 1 { at * (count - 1) / (listed - 1) } else { 0 };
        let mut table = table("", front);
        table.rows = (0..listed).map(place).collect();
        let numbers = (0..listed).map(|at| name(front, place(at), false)).collect();
        let mut cells = vec![Cells { head: String::new(), is_text: false, cells: numbers }];
        cells.extend(table.cells(&page_keys(front)));
        page.table(cells);
        if let Some(text) = unheld(front, (0..listed).map(place)) {
            page.paragraph(text, 2);
        }
    }
    if listed < count {
        page.line(format!("      ({listed} of {count}; --csv FILE has them all)"));
    }
}

/// Returns the whole report as an object; null for values that do not exist.
pub fn json(name: &str, front: &FrontReport, reach: Reach) -> Value {
    let request = &front.request;
    let variables = request.over.iter().map(|axis| {
        let (low, high) = axis.ends();
        json!({
            "variable": axis.symbol(), "key": axis.variable().key, "low": low, "high": high,
            "log": axis.spacing() == Spacing::Log,
        })
    });
    let objectives = request.objectives.iter().map(
        |objective| json!({ "output": objective.measure.name, "maximise": objective.maximise }),
    );
    let constraints = request.subject_to.iter().map(|constraint| {
        json!({ "output": constraint.measure.name, "is": constraint.sign(), "bound": constraint.bound })
    });
    json!({
        "scene": name,
        "interface": front.base.interface.law.word(),
        "variables": variables.collect::<Vec<_>>(),
        "objectives": objectives.collect::<Vec<_>>(),
        "constraints": constraints.collect::<Vec<_>>(),
        "feasible": request.is_feasible,
        "samples": request.samples,
        "runs": front.runs,
        "given_up": front.given_up,
        "no_design": lacks(front),
        "complete": reach.is_complete(),
        "designs": table(name, front).objects(|key| !["scene", "interface"].contains(&key)),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::context::{Context, never_cancel};
    use crate::study::search::front::{Request, run};
    use crate::study::testing::scene;

    /// Wire is not counted by default: the scene itself fails the check of the springs' mass.
    #[test]
    fn the_sentence_names_the_warnings_that_are_let_pass() {
        let request = Request { samples: 16, ..Request::default() };
        let text = |pairs: &str| {
            let front = run(&scene(pairs), &request, &mut Context::new(2, &mut never_cancel));
            feasible(&front.unwrap())
        };
        let own = text("face=60mm interface=plastic");
        assert!(
            own.contains("but for those of the scene itself (") && own.contains("spring mass"),
            "{own}"
        );
        // Loads never pass.
        let overloaded = text("v_i=300");
        assert!(!overloaded.contains("interface"), "{overloaded}");
        assert!(text("k=0 b=0 h=12mm").ends_with("unsafe side"));
    }
}
