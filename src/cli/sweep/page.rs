//! Page of a sweep: charts over one axis, maps over two, number of points by outcome.

use std::fmt::Write as _;

use crate::cli::draw;
use crate::cli::text::{chart_size, width};
use cmra_engine::model::units::{self, engineering};
use cmra_studies::report::figures::sweeps::picture;
use cmra_studies::report::svg::Picture;
use cmra_studies::report::sweep::Columns;
use cmra_studies::report::table::Table;
use cmra_studies::study::outcome::OutcomeCounts;
use cmra_studies::study::sweep::grid::Grid;
use cmra_studies::study::sweep::{Axis, DEFAULT_OUTPUTS, Plan, PointOutcome, Spacing};

/// Maximum number of rows of the table of a sweep with one axis.
const TABLE_ROWS: u64 = 13;
/// Maximum number of points kept in memory for charts; a larger sweep has only a summary.
pub(in crate::cli) const KEPT_MAX: u64 = 250_000;

/// Returns `true` if a sweep can be drawn: a complete grid of one or two axes.
pub(super) fn is_drawable(plan: &Plan) -> bool {
    plan.axes().len() <= 2 && plan.points() <= KEPT_MAX
}

/// Returns the charts of a complete sweep: of the given outputs, or of the default ones if all were computed.
pub(super) fn pictures(kept: Option<&Grid>, columns: Columns) -> Vec<Picture> {
    let Some(grid) = kept.filter(|grid| grid.is_complete()) else { return Vec::new() };
    let all = grid.plan().outputs();
    let wanted =
        |output: &usize| columns == Columns::Chosen || DEFAULT_OUTPUTS.contains(&all[*output].name);
    (0..all.len()).filter(wanted).filter_map(|output| picture(grid, output)).collect()
}

/// Returns the page of a sweep; `how` has the run time and the number of threads.
pub(super) fn text(
    name: &str,
    plan: &Plan,
    (ended, how): (OutcomeCounts, &str),
    kept: Option<&Grid>,
) -> String {
    let axes: Vec<String> = plan.axes().iter().map(axis_words).collect();
    let mut page = format!("{name}: {}\n{} points {how}\n\n", axes.join("; "), ended.total());
    if let Some(grid) = kept.filter(|grid| grid.is_complete()) {
        for output in 0..plan.outputs().len() {
            drawn(&mut page, grid, output);
        }
        if let [axis] = plan.axes() {
            table(&mut page, grid, axis);
        }
    }
    let _ = writeln!(page, "{ended}");
    page
}

fn axis_words(axis: &Axis) -> String {
    if axis.spacing() == Spacing::Listed {
        let unit = axis.variable().unit();
        let values = format!("{} = {} {unit}", axis.symbol(), axis.range().replace(',', ", "));
        return format!("{}, {} points", values.trim_end(), axis.count());
    }
    let (from, to) = axis.ends();
    let unit = axis.variable().unit();
    let log = if axis.spacing() == Spacing::Log { " at equal ratios" } else { "" };
    let ends = format!("{} to {} {unit}", units::shortest(from), units::shortest(to));
    format!("{} {}{log}, {} points", axis.symbol(), ends.trim_end(), axis.count())
}

/// Appends the chart of an output.
fn drawn(page: &mut String, grid: &Grid, output: usize) {
    let column = grid.plan().outputs()[output];
    let is_axis = grid.plan().axes().len() == 1;
    let Some(picture) = picture(grid, output) else {
        let where_to = if is_axis { "axis" } else { "grid" };
        let _ = writeln!(page, "{}: no value anywhere on this {where_to}\n", column.title());
        return;
    };
    page.push_str(&draw::within(&picture, chart_size(draw::MAP).0));
    let points = grid.counts().0;
    let gone = (0..points).filter(|at| grid.cell(*at, 0, output).value().is_none()).count();
    if gone > 0 && is_axis {
        let _ = writeln!(page, "{gone} of {points} points have no value and are left blank");
    }
    page.push('\n');
}

fn table(page: &mut String, grid: &Grid, axis: &Axis) {
    let last = axis.count() - 1;
    // Evenly spaced rows if the number of points allows them.
    let even = (5..TABLE_ROWS).rev().find(|steps| last.is_multiple_of(*steps));
    let count = even.map_or_else(|| TABLE_ROWS.min(axis.count()), |steps| steps + 1);
    let places = (0..count).map(|row| row * last / (count - 1));
    let shown = places.filter_map(|at| usize::try_from(at).ok());
    let unit = axis.variable().unit();
    let table = Table::new(shown)
        .with("axis", axis.symbol(), unit, |at| axis.value(*at as u64))
        .with("outcome", "outcome", "", |at| grid.outcome(*at, 0).map(PointOutcome::key));
    let outputs = grid.plan().outputs().iter().enumerate();
    let table = outputs.fold(table, |table, (output, column)| {
        table.with(column.name, column.title(), column.unit(), move |at| {
            grid.cell(*at, 0, output).value()
        })
    });
    let _ = writeln!(page, "{}", table.page(&table.keys(), width()));
}

/// Formats a time: `0.31 s`, `12 min`, `5.2 h`.
pub(in crate::cli) fn duration(seconds: f64) -> String {
    let (value, unit) = match seconds {
        s if s < 60.0 => return engineering(s, "s", 2),
        s if s < 5400.0 => (s / 60.0, "min"),
        s if s < 172_800.0 => (s / 3600.0, "h"),
        s => (s / 86_400.0, "days"),
    };
    format!("{} {unit}", units::significant(value, 2))
}
