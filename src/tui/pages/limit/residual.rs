//! Ballistic limit and residual velocity of the Limit tab, as text and as a chart.

use crate::tui::chart::Emphasis;
use crate::tui::pages::limit::state::RESIDUAL;
use crate::tui::pages::page::prelude::*;
use crate::tui::widgets::layout::CHART_ROWS;
use crate::tui::widgets::text::fitting;
use crate::worker::studies::LimitSearch;
use cmra_engine::model::units;
use cmra_studies::report::Remark;
use cmra_studies::report::limit::{FittedLaw, headlines, remarks, residual, taken_to_hold};
use cmra_studies::report::monte_carlo::{perforation, v50};
use cmra_studies::study::limit::Limit;
use cmra_studies::study::monte_carlo;

/// Columns of a remark's label.
const LABEL: u16 = 15;

/// Returns all remarks on the limit, as lines for a pane of this width.
fn limit_lines(app: &App, width: u16) -> Vec<Remark> {
    let tab = &app.pages.limit;
    let Some(report) = &tab.report.result else { return Vec::new() };
    let mut facts = remarks(report);
    if let Some(spread) = spread(app) {
        let words = [v50(spread), perforation(spread).map(|[text, _]| text)].into_iter().flatten();
        facts.extend(words.map(|text| Remark::new("V50", text)));
    } else if report.limit.velocity_m_s().is_some() && tab.report.is_complete() {
        let text = app.keymap.shown("<run>: V50 and its spread, inputs varied by 2 %");
        facts.push(Remark::new("V50", text));
    }
    let room = usize::from(width.saturating_sub(LABEL + 2)).max(10);
    let mut lines: Vec<Remark> = Vec::new();
    // There is no room to explain the laws.
    for mut fact in facts.into_iter().filter(|fact| fact.about != "laws") {
        for text in wrap(&fact.text, room) {
            let about = std::mem::take(&mut fact.about);
            lines.push(Remark { about, text, is_caution: fact.is_caution });
        }
    }
    lines
}

/// Returns the scene whose limit is requested, with the impact velocity of another scene, because the limit does not depend on it.
pub fn limit_scene(app: &App, other: &Scene) -> Scene {
    let mut scene = (*app.scene).clone();
    scene.projectile.velocity_m_s = other.projectile.velocity_m_s;
    scene
}

/// Returns V50 of the current scene, if it was requested.
fn spread(app: &App) -> Option<&monte_carlo::MonteCarloReport> {
    let spread = &app.pages.limit.spread;
    spread.result.as_deref().filter(|_| !spread.is_stale(&app.scene))
}

/// Returns `true` if the requested limit is neither cached nor being computed.
pub(crate) fn lacks_limit(app: &App) -> bool {
    let tab = &app.pages.limit;
    match app.jobs.study::<LimitSearch>() {
        Some((running, _)) => *running.scene != limit_scene(app, &running.scene),
        None => !tab.report.is_settled(&limit_scene(app, &tab.report.scene)),
    }
}

/// Returns `true` if the limit belongs to another scene than the current one.
pub fn limit_is_old(app: &App) -> bool {
    let report = &app.pages.limit.report;
    report.is_stale(&limit_scene(app, &report.scene))
}

/// Returns the impact velocity with which the limit is compared: that of its own scene, m/s.
pub fn limit_shot_m_s(app: &App) -> f64 {
    let own = &app.pages.limit.report.scene;
    let scene = if limit_is_old(app) { own } else { &app.scene };
    scene.projectile.velocity_m_s
}

/// Formats the limit and the margin of its scene in one line of this width.
pub fn limit_headline(app: &App, width: usize) -> Option<String> {
    let report = app.pages.limit.report.result.as_ref()?;
    if report.limit == Limit::Unknown {
        return Some(not_yet(app, app.jobs.running::<LimitSearch>()));
    }
    let of = if limit_is_old(app) { " of another scene" } else { "" };
    let mut scene = Scene::clone(&report.scene);
    scene.projectile.velocity_m_s = limit_shot_m_s(app);
    let holds = if taken_to_hold(report).is_some() { " if the mechanism holds" } else { "" };
    let lines = headlines(&scene, report.limit, holds).into_iter();
    Some(fitting(lines.map(|line| line + of), width))
}

/// Describes the limit.
pub fn limit_readout(app: &App) -> Option<(Severity, String)> {
    let report = app.pages.limit.report.result.as_ref()?;
    let mut parts = Vec::new();
    if let Limit::Found { stopped_at_m_s: Some(again), .. } = report.limit {
        let again = units::velocity(again, 4);
        parts.push(format!("no single limit: {again} is stopped again"));
    }
    parts.extend(report.undecided());
    parts.extend(report.caution());
    let severity = if parts.is_empty() { Severity::Note } else { Severity::Warning };
    parts.extend(spread(app).and_then(v50).map(|text| format!("V50 {text}")));
    if parts.is_empty() {
        return None;
    }
    Some((severity, parts.join("; ")))
}

/// Draws the pane of the residual velocity.
pub(crate) fn render(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    // The line above the pane is empty without a result.
    let room = usize::from(area.width.saturating_sub(2));
    let Some(head) = limit_headline(app, room) else { return chart(app, area, canvas) };
    let role = if limit_is_old(app) { Role::Warning } else { Role::Title };
    canvas.put(area, (1, 0), &head, role);
    let (_, body) = split_top(area, 1);
    let lines = limit_lines(app, area.width);
    let height = u16::try_from(lines.len()).unwrap_or(u16::MAX).saturating_add(2);
    // Without room for both the curve comes first.
    if lines.is_empty() || height.saturating_add(CHART_ROWS) > body.height {
        return chart(app, body, canvas);
    }
    let (above, words) = split_bottom(body, height);
    chart(app, above, canvas);
    write(&lines, words, canvas);
}

fn write(lines: &[Remark], area: Rect, canvas: &mut Canvas<'_>) {
    let inner = PaneFrame::new("Fitted laws and spread").draw(area, canvas);
    for (row, line) in (0..inner.height).zip(lines) {
        let role = if line.is_caution { Role::Warning } else { Role::Text };
        canvas.put(inner, (0, row), &line.about, Role::Title);
        canvas.put(inner, (LABEL, row), &line.text, role);
    }
}

fn chart(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let tab = &app.pages.limit;
    let found = tab.report.result.as_ref();
    // The text beside the chart gives the full names of the laws.
    let name = if area.width < 56 { FittedLaw::initials } else { FittedLaw::name };
    let drawn = found.and_then(|it| residual(it, limit_shot_m_s(app), name));
    let Some(mut chart) = drawn else {
        let frame = PaneFrame::new("Residual velocity").focused(app.has_focus(RESIDUAL));
        let inner = frame.draw(area, canvas);
        let none = "no shot perforates: no curve to draw";
        let why = found.map(|_| if tab.report.is_complete() { none } else { NOT_YET });
        return canvas.put_centred(inner, &nothing::<LimitSearch>(app, "finding the limit", why));
    };
    let old = limit_is_old(app);
    if old {
        chart.curves.iter_mut().for_each(|curve| curve.emphasis = Emphasis::Stale);
    }
    let of = if old { ", of another scene" } else { "" };
    chart.title = format!("Residual velocity{of}").into();
    chart.focused = app.has_focus(RESIDUAL);
    canvas.draw(&chart, area);
}
