//! Report of one scene by several contact models: Table 8.1 of the thesis with numbers.

use crate::report::page::Page;
use crate::report::run::{NamedRun, comparison};
use cmra_engine::model::run::{Run, RunWarning};

/// Compared results.
const KEYS: [&str; 5] =
    ["name", "outcome", "final_penetration_m", "max_plate_displacement_m", "peak_contact_force_n"];

/// Returns the page of the runs, the reference first, with a remark on each model.
pub fn page(heading: &str, runs: &[NamedRun]) -> Page {
    let mut page = Page::new(format!("{heading}: the interaction models of Table 8.1"));
    page.space();
    let rows = runs.iter().map(|(name, run)| (name.clone(), Ok(&**run)));
    page.table(comparison(rows).cells(&KEYS));
    page.space();
    for (name, run) in runs {
        page.fact(name.clone(), 18, remark(run));
    }
    let text = "not included: the fifth model of Table 8.1 needs a finite element solver";
    page.fact("finite elements    ", 19, text);
    page
}

/// Describes the model of a run, its parameters, and what of the scene it ignores.
fn remark(run: &Run) -> String {
    let model = run.scene.contact.model;
    let ignored = run.warnings.iter().filter(|it| matches!(it, RunWarning::NotModelled(_)));
    let clauses = [model.about().to_owned(), model.parameters(&run.scene)].into_iter();
    let clauses = clauses.chain(ignored.map(|it| it.sentence().0));
    clauses.filter(|it| !it.is_empty()).collect::<Vec<_>>().join("; ")
}
