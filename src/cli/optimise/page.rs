//! Fronts as a page of text: a few designs spread over each, and where the scene and the thesis's designs stand.

use std::fmt::Write as _;

use crate::cli::text::width;
use crate::model::units::significant;
use crate::report::front::{designs, standing};
use crate::report::table::{Cells, grid};
use crate::study::search::front::{Candidate, Constraint, Front, STEPS_MAX, Task};
use crate::study::sweep::{Axis, Spacing};

/// Designs of a front that are listed.
const LISTED: usize = 16;

pub(super) fn text(name: &str, task: &Task, fronts: &[Front]) -> String {
    let objective = |it: &crate::study::search::front::Objective| {
        let most = if it.maximise { "greatest " } else { "least " };
        most.to_owned() + &it.measure.title()
    };
    let objectives: Vec<String> = task.objectives.iter().map(objective).collect();
    let mut page = format!("{name}: {}\n", objectives.join(", "));
    let (feasible, named): (Vec<&Constraint>, Vec<&Constraint>) =
        task.constraints.iter().partition(|constraint| constraint.is_feasibility);
    for constraint in named {
        let _ = writeln!(page, "  subject to {}", constraint.words());
    }
    if !feasible.is_empty() {
        let words: Vec<String> = feasible.iter().map(|constraint| constraint.words()).collect();
        let _ = writeln!(page, "  feasible: {}", words.join(", "));
        page.push_str("            (--no-feasibility switches this off)\n");
    }
    for axis in &task.axes {
        let (low, high) = axis.ends();
        let log = if axis.spacing() == Spacing::Log { " (log)" } else { "" };
        let (low, high) = (significant(low, 4), axis.show(high, 4));
        let _ = writeln!(page, "  {:8}{low} .. {high}{log}", axis.symbol());
    }
    for front in fronts {
        one(&mut page, task, front);
    }
    page
}

fn one(page: &mut String, task: &Task, front: &Front) {
    let count = front.designs.len();
    let kind = match (task.objectives.len(), count) {
        (_, 0) => "no design satisfies every constraint".to_owned(),
        (1, _) => "the best design".to_owned(),
        (_, _) => format!("a front of {count} designs"),
    };
    let early = if front.is_complete { "" } else { ", stopped early" };
    let _ = writeln!(
        page,
        "\ninterface {}: {kind} ({} runs, {} generations, seed {}{early})",
        front.law.word(),
        front.runs,
        front.generations,
        task.effort.seed
    );
    if front.given_up > 0 {
        let count = front.given_up;
        let _ = writeln!(
            page,
            "  {count} runs stopped after {STEPS_MAX} steps: such designs count as failed"
        );
    }
    // Spread over the front, the first and the last among them.
    let listed = count.min(LISTED);
    if count > 0 {
        let place = |at: usize| if listed > 1 { at * (count - 1) / (listed - 1) } else { 0 };
        let table = designs(task, front, (0..listed).map(place));
        let numbers = (0..listed).map(|at| (place(at) + 1).to_string()).collect();
        let measures = task.measures();
        let shown = task.shown().into_iter().map(|at| measures[at].name);
        let keys: Vec<&str> = task.axes.iter().map(Axis::symbol).chain(shown).collect();
        let mut cells = vec![Cells { head: String::new(), is_text: false, cells: numbers }];
        cells.extend(table.cells(&keys));
        *page += &grid(&cells, width());
    }
    if listed < count {
        let _ = writeln!(page, "      ({listed} of {count}; --csv FILE has them all)");
    }
    page.push('\n');
    for candidate in &front.candidates {
        stands(page, task, candidate);
    }
}

fn stands(page: &mut String, task: &Task, candidate: &Candidate) {
    let measures = task.measures();
    let found = task.shown().into_iter();
    let found = found.map(|at| measures[at].show_any(candidate.measures[at], 4));
    let found: Vec<String> = found.collect();
    let words = standing(candidate, task).text;
    let _ = writeln!(page, "  {:20}{words}\n  {:20}{}", candidate.name, "", found.join("  "));
    if candidate.source != "as it is" {
        let _ = writeln!(page, "  {:20}{}", "", candidate.source);
    }
}
