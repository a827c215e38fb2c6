//! The error of every method over its run time, both logarithmic, a letter for each method.

use crate::report::chart::{Axis, Chart, Curve, Legend, Mark, Scale, Unit, ViewRange};
use crate::study::accuracy::{MethodReport, Report};

/// The error of a method over its run time, s.
pub fn curve(of: &MethodReport) -> Curve<'static> {
    let points: Vec<(f64, f64)> =
        of.measured().map(|(_, it)| (it.timing.min_s, it.error())).collect();
    Curve::new(of.method.letter(), of.method.name(), points).colour(of.method as usize)
}

/// The axes over run times, s, and errors.
pub fn axes(times: ViewRange, errors: ViewRange) -> (Axis<'static>, Axis<'static>) {
    // The unit of the fast end: microseconds, of which a person thinks here.
    let unit = Unit::with_prefix(30.0 * times.lo(), "s");
    let x = Axis::new("run time", times).scale(Scale::Log10).unit(unit);
    (x, Axis::new("relative error", errors).scale(Scale::Log10))
}

/// The chart; `None` where no result could be judged.
pub fn error_over_time(report: &Report) -> Option<Chart<'static>> {
    let curves: Vec<Curve<'static>> = report.methods.iter().map(curve).collect();
    let points = || curves.iter().flat_map(|curve| curve.points.iter());
    let times = ViewRange::of(Scale::Log10, points().map(|point| point.0))?;
    let errors = ViewRange::of(Scale::Log10, points().map(|point| point.1))?;
    let (x, y) = axes(times.rounded(Scale::Log10), errors.rounded(Scale::Log10));
    let floor = report.references.first().and_then(|reference| reference.uncertainty);
    let title = "relative error, the greater of depth and time";
    Some(Chart {
        // The table of methods has their letters.
        legend: Legend::Hidden,
        levels: floor.map(|at| Mark::new(at, "reference's floor")).into_iter().collect(),
        ..Chart::new(title, x, y, curves)
    })
}
