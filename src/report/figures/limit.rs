//! The residual velocity over the impact velocity, with the limit and the fitted law.

use crate::report::chart::{Axis, Chart, Curve, Line, Scale};
use crate::study::limit::Report;

/// Points of a drawn law.
const LAW_POINTS: u32 = 200;

/// The chart; `None` without a limit.
pub fn residual(report: &Report) -> Option<Chart> {
    let limit_m_s = report.limit.velocity_m_s()?;
    let shots: Vec<(f64, f64)> = report
        .shots
        .iter()
        .map(|shot| (shot.impact_m_s, shot.residual_m_s.unwrap_or(f64::NAN)))
        .collect();
    let impacts = shots.iter().map(|shot| shot.0);
    let x = Axis::over("impact velocity", "m/s", Scale::Linear, impacts)?;
    let residuals = shots.iter().map(|shot| shot.1).chain([0.0]);
    let y = Axis::over("residual velocity", "m/s", Scale::Linear, residuals)?.padded(0.03);
    let step = (x.high - x.low) / f64::from(LAW_POINTS);
    let law = report.lambert_jonas.map(|law| {
        let at = |point: u32| x.low + step * f64::from(point);
        let points = (0..=LAW_POINTS).map(|point| (at(point), law.residual_m_s(at(point))));
        Curve { points: points.collect(), ..Curve::new("Lambert-Jonas", '-') }
    });
    let runs = Curve { points: shots, is_dotted: true, ..Curve::new("runs", 'o') };
    Some(Chart {
        title: "residual velocity".to_owned(),
        x,
        y,
        curves: law.into_iter().chain([runs]).collect(),
        marks: vec![Line { tag: "limit".to_owned(), ..Line::new(limit_m_s, "ballistic limit") }],
        levels: Vec::new(),
    })
}
