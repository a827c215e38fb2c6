//! Sensitivity as a page of text: the tornado with its bars, Morris's effects, Sobol's indices.

use std::fmt::Write as _;

use crate::cli::text::width;
use crate::report::sensitivity::{table, tornado};
use crate::report::table::{Cells, grid};
use crate::study::sensitivity::Report;

/// Cells of the longest bar.
const BAR: usize = 20;

pub(super) fn text(name: &str, report: &Report) -> String {
    let own = report.output.show_any(report.own, 4);
    let mut page =
        format!("{name}: what {} depends on\nthe scene itself: {own}\n\n", report.output.title());
    let keys = ["variable", "low", "high", "output_at_low", "output_at_high"];
    let bars = grid(&tornado(report, &keys, BAR), width());
    let _ = writeln!(page, "one at a time, the others as in the scene\n{bars}");
    morris(&mut page, report);
    sobol(&mut page, report);
    page
}

fn morris(page: &mut String, report: &Report) {
    if report.effects.is_empty() {
        return;
    }
    let table = table("", report);
    let mut cells = table.cells(&["variable", "morris_mu_star", "morris_mu", "morris_sigma"]);
    let used = table.rows.iter().map(|at| report.effects[*at].used.to_string());
    cells.push(Cells { head: "steps".to_owned(), is_text: false, cells: used.collect() });
    let _ = writeln!(
        page,
        "Morris's effects over the whole range ({} trajectories)\n{}",
        report.effort.trajectories,
        grid(&cells, width())
    );
}

fn sobol(page: &mut String, report: &Report) {
    let Some(found) = &report.sobol else { return };
    let _ = writeln!(
        page,
        "Sobol's indices: fractions of the variance, 95 % intervals ({} samples, seed {})",
        found.rows, report.effort.seed
    );
    *page += &table("", report).page(
        &[
            "variable",
            "sobol_first",
            "sobol_first_low_95",
            "sobol_first_high_95",
            "sobol_total",
            "sobol_total_low_95",
            "sobol_total_high_95",
        ],
        width(),
    );
    let deviation = found.variance.is_finite().then(|| found.variance.sqrt());
    let mean = found.mean.is_finite().then_some(found.mean);
    let _ = writeln!(
        page,
        "  mean {}, standard deviation {}",
        report.output.show_any(mean, 4),
        report.output.show_any(deviation, 4)
    );
    if found.inputs.iter().all(|input| input.first.is_none()) {
        page.push_str(
            "  no indices: the result does not vary, or has no value, over these bounds\n",
        );
    }
    if found.used < found.rows {
        let _ = writeln!(
            page,
            "  {} of {} samples have a point without a value (perforated, moving or failed) and are not counted: the indices are \
             those of the rest",
            found.rows - found.used,
            found.rows
        );
    }
}
