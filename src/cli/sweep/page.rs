//! Pictures of a sweep: charts over one axis, maps over two.

use cmra_engine::model::units::{self, engineering};
use cmra_studies::report::figures::sweeps::picture;
use cmra_studies::report::svg::Picture;
use cmra_studies::report::sweep::Columns;
use cmra_studies::study::sweep::grid::Grid;
use cmra_studies::study::sweep::{Plan, default_outputs};

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
    let usual = default_outputs(grid.plan().base());
    let wanted = |output: &usize| columns == Columns::Chosen || usual.contains(&all[*output].name);
    (0..all.len()).filter(wanted).filter_map(|output| picture(grid, output)).collect()
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
