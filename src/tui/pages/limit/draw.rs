//! The Limit tab: limit and margin in one line, the residual-velocity curve with its laws, and these laws and the scatter in words.

use ratatui::layout::Rect;

use crate::model::run::Outcome;
use crate::report::figures::limit::residual;
use crate::study::limit::Report;
use crate::tui::app::App;
use crate::tui::chart::{Draw, Emphasis, Layout, Scale};
use crate::tui::message::Target;
use crate::tui::pages::limit::RESIDUAL;
use crate::tui::pages::limit::state::LimitSearch;
use crate::tui::pages::limit::state::{BESIDE, FACTS, Fact, LABEL};
use crate::tui::theme::{PaneFrame, Role};
use crate::tui::widgets::Canvas;
use crate::tui::widgets::text::{put, put_centred, text_role};

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
    let text = match (app.jobs.running::<LimitSearch>(), &app.pages.limit.report) {
        (Some(_), _) => "finding the limit",
        (None, Some(report)) if !report.is_complete => "cancelled before there was a curve",
        (None, Some(_)) => "no shot goes through: there is no curve",
        (None, None) => "no results yet: press r",
    };
    put_centred(canvas, inner, text, app.theme.style(Role::Dim));
}

fn chart(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let tab = &app.pages.limit;
    let drawn = tab.report.as_ref().and_then(|it| Some((it, residual(it, tab.zoomed)?)));
    let Some((report, mut chart)) = drawn else {
        nothing(app, area, canvas);
        return;
    };
    let old = app.limit_is_old();
    for (is_log, axis) in [(tab.log.0, &mut chart.x), (tab.log.1, &mut chart.y)] {
        if is_log {
            axis.scale = Scale::Log10;
        }
    }
    for curve in &mut chart.curves {
        if old {
            curve.emphasis = Emphasis::Stale;
        }
        // The words beside the chart name the laws in full.
        match (area.width < 56, &*curve.label) {
            (true, "Recht-Ipson") => curve.label = "R-I".into(),
            (true, "Lambert-Jonas") => curve.label = "L-J".into(),
            (_, _) => {}
        }
    }
    chart.title =
        if old { "Residual velocity, of another scene" } else { "Residual velocity" }.into();
    chart.crosshair = tab.shot().map(|shot| shot.impact_m_s);
    chart.focused = app.has_focus(RESIDUAL);
    let layout = chart.render(area, canvas, app.theme);
    marks(app, report, &layout, canvas);
    let shots = report.shots.iter();
    let places = shots.map(|shot| Some((shot.impact_m_s, shot.residual_m_s.unwrap_or(0.0))));
    canvas.points(&layout, places, |shot| Target::Row(RESIDUAL, shot));
}

/// A letter for each shot, whatever the characters of curves: what became of it.
fn marks(app: &App, report: &Report, layout: &Layout, canvas: &mut Canvas<'_>) {
    for (index, shot) in report.shots.iter().enumerate() {
        let (letter, colour) = match shot.outcome {
            Outcome::Perforated => ("o", 3),
            Outcome::Arrested | Outcome::Separated => ("s", 4),
            Outcome::Moving => ("m", 4),
        };
        let height = shot.residual_m_s.unwrap_or(0.0);
        let Some(place) = layout.place(shot.impact_m_s, height) else { continue };
        let role = match (app.pages.limit.cursor == Some(index), app.limit_is_old()) {
            (true, _) => Role::Crosshair,
            (false, true) => Role::Dim,
            (false, false) => Role::Curve(colour),
        };
        put(canvas, layout.plot, place, letter, app.theme.style(role));
    }
}
