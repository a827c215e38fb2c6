//! The residual velocity over the impact velocity, with the limit and the fitted laws.

use crate::report::chart::{Axis, Chart, Curve, Mark, Scale, Unit, ViewRange};
use crate::study::limit::{Report, Shot};

const LAW_POINTS: usize = 400;
/// The scene's velocity is in view up to a given number of limits.
const OWN_IN_VIEW: f64 = 4.0;

/// The axes of impact and residual velocity; `None` where nothing goes through.
pub fn axes(report: &Report) -> Option<(Axis<'static>, Axis<'static>)> {
    let own = report.scene.projectile.velocity_m_s;
    let limit = report.limit.velocity_m_s();
    let impacts = report.shots.iter().map(|shot| shot.impact_m_s);
    let own = limit.filter(|limit| own < OWN_IN_VIEW * limit).map(|_| own);
    // Without a limit the shots cover decades.
    let scale = if limit.is_some() { Scale::Linear } else { Scale::Log10 };
    let x = Axis::over("impact velocity", "m/s", scale, impacts.chain(own))?;
    let residuals = report.shots.iter().filter_map(|shot| shot.residual_m_s);
    let y = Axis::over("residual velocity", "m/s", Scale::Linear, residuals)?;
    let unit = || Unit::new("m/s");
    Some((x.unit(unit()), y.with_zero().padded(0.04).unit(unit())))
}

/// Shots as points with gaps between.
fn dots(shots: &[Shot], wanted: impl Fn(&Shot) -> Option<f64>) -> Vec<(f64, f64)> {
    let dot = |shot: &Shot| Some([(shot.impact_m_s, wanted(shot)?), (f64::NAN, f64::NAN)]);
    shots.iter().filter_map(dot).flatten().collect()
}

/// A law over the view; before its limit it is nothing.
fn law(view: ViewRange, limit_m_s: f64, residual: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    let step = view.span() / LAW_POINTS as f64;
    let at = |i: usize| view.lo() + step * i as f64;
    let beyond = (0..=LAW_POINTS).map(at).filter(|v| *v > limit_m_s);
    std::iter::once(limit_m_s).chain(beyond).map(|v| (v, residual(v))).collect()
}

/// The chart of the impact velocities in view, or of all; `None` where nothing goes through.
pub fn residual(report: &Report, view: Option<ViewRange>) -> Option<Chart<'static>> {
    let (x, y) = axes(report)?;
    let x = Axis { view: view.unwrap_or(x.view), ..x };
    let recht_ipson =
        report.recht_ipson.map(|it| law(x.view, it.limit_m_s, |v| it.residual_m_s(v)));
    let lambert_jonas =
        report.lambert_jonas.map(|it| law(x.view, it.limit_m_s, |v| it.residual_m_s(v)));
    let stopped = |shot: &Shot| shot.residual_m_s.is_none().then_some(0.0);
    let curves = [
        Curve::new('+', "Recht-Ipson", recht_ipson.unwrap_or_default()).colour(1),
        Curve::new('x', "Lambert-Jonas", lambert_jonas.unwrap_or_default()).colour(2),
        Curve::new('o', "through", dots(&report.shots, |shot| shot.residual_m_s)).colour(3),
        Curve::new('s', "stopped", dots(&report.shots, stopped)).colour(4),
    ];
    let curves = curves.into_iter().filter(|curve| !curve.points.is_empty());
    let limit = report.limit.velocity_m_s();
    let limit = limit.map(|at| Mark::new(at, "ballistic limit").tag("v_bl"));
    let own = report.scene.projectile.velocity_m_s;
    let own = x.view.contains(own).then(|| Mark::new(own, "scene"));
    Some(Chart {
        marks: limit.into_iter().chain(own).collect(),
        ..Chart::new("residual velocity", x, y, curves.collect())
    })
}
