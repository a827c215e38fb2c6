//! The Limit tab: limit and margin in one line, the residual-velocity curve with its laws, and these laws and the scatter in words.

use ratatui::layout::Rect;

use crate::model::run::Outcome;
use crate::study::limit::{Limit, Report, Shot};
use crate::tui::app::App;
use crate::tui::chart::{
    Axis, Chart, Curve, Emphasis, EventLine, Legend, Mapping, Scale, Unit, ViewRange,
};
use crate::tui::message::Target;
use crate::tui::pages::limit::RESIDUAL;
use crate::tui::pages::limit::state::{BESIDE, FACTS, Fact, LABEL};
use crate::tui::theme::{PaneFrame, Role};
use crate::tui::widgets::Canvas;
use crate::tui::widgets::text::{columns, put, text_role};

/// Points of a drawn law.
const LAW_POINTS: usize = 400;
/// The scene's velocity is in view up to so many limits.
const OWN_IN_VIEW: f64 = 4.0;

/// Draw the pane of the residual velocity.
pub(in crate::tui) fn render(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    canvas.pane(area, RESIDUAL);
    // Until something is found nothing stands above the pane.
    let room = usize::from(area.width.saturating_sub(2));
    let Some(head) = app.limit_headline(room) else { return chart(app, area, canvas) };
    let role = if app.limit_is_old() { Role::Warning } else { Role::Title };
    put(canvas, area, (1, 0), &head, app.theme.style(role));
    let body = Rect { y: area.y + 1, height: area.height.saturating_sub(1), ..area };
    let lines = app.limit_lines(area.width);
    if lines.is_empty() {
        return chart(app, body, canvas);
    }
    if let Some((rows, _)) = app.limit_pages() {
        let Some((page, is_last)) = app.limit_page() else { return chart(app, body, canvas) };
        let lines = lines.get((page - 1) * rows..).unwrap_or_default();
        write(app, lines, if is_last { "Tab: curve" } else { "Tab: more" }, body, canvas);
        return;
    }
    if area.width >= BESIDE {
        let width = body.width - FACTS;
        chart(app, Rect { width, ..body }, canvas);
        let side = Rect { x: body.x + width, width: FACTS, ..body };
        write(app, &lines, "", side, canvas);
        return;
    }
    let height = u16::try_from(lines.len()).unwrap_or(u16::MAX).saturating_add(2);
    let height = height.min(body.height);
    chart(app, Rect { height: body.height - height, ..body }, canvas);
    let below = Rect { y: body.y + body.height - height, height, ..body };
    write(app, &lines, "", below, canvas);
}

fn write(app: &App, lines: &[Fact], hint: &'static str, area: Rect, canvas: &mut Canvas<'_>) {
    let title = "Fitted laws and scatter";
    let inner = PaneFrame::new(title).right(hint).render(area, canvas, app.theme);
    let column =
        if lines.iter().any(|line| !line.0.is_empty() && !line.2.is_empty()) { LABEL } else { 0 };
    for (row, (label, severity, text)) in (0..inner.height).zip(lines) {
        let role = text_role(*severity);
        put(canvas, inner, (0, row), label, app.theme.style(Role::Title));
        put(canvas, inner, (column, row), text, app.theme.style(role));
    }
}

/// What stands in the chart's place where there is no curve.
fn nothing(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let frame = PaneFrame::new("Residual velocity").focused(app.has_focus(RESIDUAL));
    let inner = frame.render(area, canvas, app.theme);
    let text = match (&app.limit.finding, &app.limit.report) {
        (Some(_), _) => "finding the limit",
        (None, Some(report)) if !report.is_complete => "cancelled before there was a curve",
        (None, Some(_)) => "no shot goes through: there is no curve",
        (None, None) => "no results yet: press r",
    };
    let column = inner.width.saturating_sub(columns(text)) / 2;
    put(canvas, inner, (column, inner.height / 2), text, app.theme.style(Role::Dim));
}

/// The axes of impact and residual velocity; `None` where nothing goes through.
pub(super) fn axes(report: &Report) -> Option<(Axis<'static>, Axis<'static>)> {
    let own = report.scene.projectile.velocity_m_s;
    let limit = report.limit.velocity_m_s();
    let impacts = report.shots.iter().map(|shot| shot.impact_m_s);
    let own = limit.filter(|limit| own < OWN_IN_VIEW * limit).map(|_| own);
    // Without a limit the shots cover decades.
    let scale = if limit.is_some() { Scale::Linear } else { Scale::Log10 };
    let x = ViewRange::of(scale, impacts.chain(own))?;
    let residuals: Vec<f64> = report.shots.iter().filter_map(|shot| shot.residual_m_s).collect();
    if residuals.is_empty() {
        return None;
    }
    let y = ViewRange::of(Scale::Linear, residuals.into_iter().chain([0.0]))?;
    let unit = || Unit::new("m/s");
    let x = Axis::new("impact velocity", x).scale(scale).unit(unit());
    Some((x, Axis::new("", y.padded(Scale::Linear, 0.04)).unit(unit())))
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

fn chart(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let tab = &app.limit;
    let Some((report, (x, y))) = tab.report.as_ref().and_then(|it| Some((it, axes(it)?))) else {
        nothing(app, area, canvas);
        return;
    };
    let x = Axis { view: app.limit.zoomed.unwrap_or(x.view), ..x.clone() };
    let log = |on: bool, scale| if on { Scale::Log10 } else { scale };
    let x = x.clone().scale(log(app.limit.log.0, x.scale));
    let y = y.clone().scale(log(app.limit.log.1, y.scale));
    let old = app.limit_is_old();
    let emphasis = if old { Emphasis::Stale } else { Emphasis::Normal };
    let recht_ipson = report
        .recht_ipson
        .map(|it| law(x.view, it.limit_m_s, |v| it.residual_m_s(v)))
        .unwrap_or_default();
    let lambert_jonas = report
        .lambert_jonas
        .map(|it| law(x.view, it.limit_m_s, |v| it.residual_m_s(v)))
        .unwrap_or_default();
    let through = dots(&report.shots, |shot| shot.residual_m_s);
    let stopped = dots(&report.shots, |shot| shot.residual_m_s.is_none().then_some(0.0));
    // The words beside the chart name the laws in full.
    let narrow = area.width < 56;
    let mut curves = Vec::new();
    for (index, (marker, name, points)) in [
        ('+', if narrow { "R-I" } else { "Recht-Ipson" }, &recht_ipson),
        ('x', if narrow { "L-J" } else { "Lambert-Jonas" }, &lambert_jonas),
        ('o', "through", &through),
        ('s', "stopped", &stopped),
    ]
    .into_iter()
    .enumerate()
    {
        if !points.is_empty() {
            curves.push(Curve::new(marker, name, points).colour(index + 1).emphasis(emphasis));
        }
    }
    let limit = match report.limit {
        Limit::Found { velocity_m_s, .. } => Some((velocity_m_s, "v_bl")),
        Limit::Between { .. } | Limit::Never | Limit::Always | Limit::Unknown => None,
    };
    let own = report.scene.projectile.velocity_m_s;
    let lines = limit.into_iter().chain(x.view.contains(own).then_some((own, "scene")));
    let title = if old { "Residual velocity, of another scene" } else { "Residual velocity" };
    let chart = Chart {
        legend: Legend::Shown,
        events: lines.map(|(x, tag)| EventLine { x, tag: tag.into() }).collect(),
        crosshair: tab.shot().map(|shot| shot.impact_m_s),
        focused: app.has_focus(RESIDUAL),
        ..Chart::new(title, x, y, curves)
    };
    let layout = chart.render(area, canvas, app.theme);
    marks(app, report, (layout.plot, layout.x, layout.y), canvas);
    let shots = report.shots.iter();
    let places = shots.map(|shot| Some((shot.impact_m_s, shot.residual_m_s.unwrap_or(0.0))));
    canvas.points(&layout, places, |shot| Target::Row(RESIDUAL, shot));
}

/// A letter for each shot, whatever the characters of curves: what became of it.
fn marks(
    app: &App,
    report: &Report,
    (plot, x, y): (Rect, Mapping, Mapping),
    canvas: &mut Canvas<'_>,
) {
    for (index, shot) in report.shots.iter().enumerate() {
        let (letter, colour) = match shot.outcome {
            Outcome::Perforated => ("o", 3),
            Outcome::Arrested | Outcome::Separated => ("s", 4),
            Outcome::Moving => ("m", 4),
        };
        let height = shot.residual_m_s.unwrap_or(0.0);
        let Some((column, row)) = x.cell(shot.impact_m_s).zip(y.cell(height)) else { continue };
        let role = match (app.limit.cursor == Some(index), app.limit_is_old()) {
            (true, _) => Role::Crosshair,
            (false, true) => Role::Dim,
            (false, false) => Role::Curve(colour),
        };
        let row = plot.height.saturating_sub(row + 1);
        put(canvas, plot, (column, row), letter, app.theme.style(role));
    }
}
