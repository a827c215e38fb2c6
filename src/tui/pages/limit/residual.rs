//! The ballistic limit and the residual velocity of the Limit tab, in words and drawn.

use std::fmt::Write as _;

use crate::model::run::Outcome;
use crate::model::units::{self, fixed_significant};
use crate::report::Remark;
use crate::report::limit::{remarks, residual, taken_to_hold};
use crate::report::monte_carlo::{perforation, v50};
use crate::study::limit::{Limit, Shot};
use crate::study::monte_carlo;
use crate::tui::chart::Emphasis;
use crate::tui::pages::limit::state::{COMPARISON, EFFICIENCY_MAP, RESIDUAL};
use crate::tui::pages::page::prelude::*;
use crate::tui::widgets::layout::{CHART_ROWS, NARROW};
use crate::tui::widgets::text::fitting;
use crate::worker::studies::LimitSearch;

/// From this width on the facts stand beside the chart.
pub const BESIDE: u16 = 100;
/// Columns of the facts beside the chart, frame included.
pub const FACTS: u16 = 40;
/// Columns of a fact's label where it stands before the words.
pub const LABEL: u16 = 15;

/// Pages of words in the place of the curve.
pub(crate) struct WordPages {
    /// The rows of a page.
    rows: usize,
    pub count: usize,
    /// The page that is shown; 0 for the curve.
    pub shown: usize,
}

impl WordPages {
    /// Where j leads, or k back from the last one.
    fn hint(&self) -> &'static str {
        match self.shown {
            0 => "<down>: laws",
            page if page == self.count => "<up>: curve",
            _ => "<down>: more",
        }
    }
}

/// `250.0 m/s: stopped`.
pub(crate) fn shot_words(shot: &Shot) -> String {
    let ends = match (shot.outcome, shot.residual_m_s) {
        (Outcome::Perforated, Some(left)) => {
            format!("residual velocity {}", fixed_significant(left, 4))
        }
        (Outcome::Perforated, None) => "through".to_owned(),
        (Outcome::Arrested | Outcome::Separated, _) => "stopped".to_owned(),
        (Outcome::Moving, _) => "still moving at the end of the run".to_owned(),
    };
    format!("{}: {ends}", units::velocity(shot.impact_m_s, 4))
}

impl App {
    /// Everything but the limit itself, as lines for a pane of a given number of columns. Beside the chart labels stand above their
    /// words, and there is room to say what the laws are.
    fn limit_lines(&self, width: u16) -> Vec<Remark> {
        let tab = &self.pages.limit;
        let Some(report) = &tab.report.found else { return Vec::new() };
        let mut facts = remarks(report);
        if let Some(spread) = self.v50() {
            let words = [v50(spread), perforation(spread)].into_iter().flatten();
            facts.extend(words.map(|text| Remark::new("V50", text)));
        } else if report.limit.velocity_m_s().is_some() && report.is_complete {
            let text = self.keymap.shown("<view>: V50 and its spread, inputs varied by 2 %");
            facts.push(Remark::new("V50", text));
        }
        let is_beside = width >= BESIDE;
        let room = if is_beside { FACTS } else { width.saturating_sub(LABEL) }.saturating_sub(2);
        let mut lines: Vec<Remark> = Vec::new();
        for mut fact in facts.into_iter().filter(|fact| is_beside || fact.about != "laws") {
            if is_beside {
                lines.extend((!lines.is_empty()).then(|| Remark::new("", "")));
                lines.push(Remark::new(std::mem::take(&mut fact.about), ""));
            }
            for text in wrap(&fact.text, usize::from(room).max(10)) {
                let about = std::mem::take(&mut fact.about);
                lines.push(Remark { about, text, is_caution: fact.is_caution });
            }
        }
        lines
    }

    /// The pages of words, where the curve and all that is to report have no room together: j and k turn from the curve through them.
    pub(crate) fn limit_pages(&self) -> Option<WordPages> {
        let area = area(self, self.layout().body?, RESIDUAL)?;
        let lines = self.limit_lines(area.width).len();
        // The first row of the body is the limit itself; a frame takes two.
        let rows = usize::from(area.height).saturating_sub(3);
        let chart = if area.width >= BESIDE { 0 } else { usize::from(CHART_ROWS) };
        let is_crowded = lines > 0 && rows > 0 && lines + chart > rows;
        let count = lines.div_ceil(rows.max(1));
        let shown = self.pages.limit.page.min(count);
        is_crowded.then_some(WordPages { rows, count, shown })
    }

    /// The scene whose limit is wanted, at the impact velocity of another one: it does not depend on that.
    pub fn limit_scene(&self, other: &Scene) -> Scene {
        let mut scene = (*self.scene).clone();
        scene.projectile.velocity_m_s = other.projectile.velocity_m_s;
        scene
    }

    /// V50 of the scene on the screen, once it was asked for.
    fn v50(&self) -> Option<&monte_carlo::Report> {
        let spread = &self.pages.limit.spread;
        spread.found.as_deref().filter(|_| !spread.is_old(&self.scene))
    }

    /// Whether what is wanted of the limit is neither there nor under way.
    pub(crate) fn lacks_limit(&self) -> bool {
        let tab = &self.pages.limit;
        match self.jobs.study::<LimitSearch>() {
            Some((running, _)) => *running.scene != self.limit_scene(&running.scene),
            None => !tab.report.is_there(&self.limit_scene(&tab.report.scene)),
        }
    }

    /// Whether the limit belongs to another scene than the one on the screen.
    pub fn limit_is_old(&self) -> bool {
        let report = &self.pages.limit.report;
        report.is_old(&self.limit_scene(&report.scene))
    }

    /// The velocity of the shot that the limit is compared with: of its own scene, m/s.
    pub fn limit_shot_m_s(&self) -> f64 {
        let own = &self.pages.limit.report.scene;
        let scene = if self.limit_is_old() { own } else { &self.scene };
        scene.projectile.velocity_m_s
    }

    /// The limit and the margin of the scene it belongs to, in one line of a given number of columns.
    pub fn limit_headline(&self, width: usize) -> Option<String> {
        let report = self.pages.limit.report.found.as_ref()?;
        let is_old = self.limit_is_old();
        let of = if is_old { " of another scene" } else { "" };
        let Limit::Found { velocity_m_s, stopped_at_m_s, .. } = report.limit else {
            return Some(fitting([report.limit.absence()? + of], width));
        };
        let own_m_s = self.limit_shot_m_s();
        let (margin, own) = (velocity_m_s / own_m_s - 1.0, significant(own_m_s, 4));
        // Where a faster shot is stopped again, being beyond the limit tells nothing.
        let ends = match (margin < 0.0, stopped_at_m_s) {
            (false, _) => format!(": {own} m/s is stopped"),
            (true, None) => format!(": {own} m/s perforates"),
            (true, Some(_)) => format!(" at {own} m/s"),
        };
        let limit = format!("v_bl {} m/s{of}", fixed_significant(velocity_m_s, 6));
        let bare = format!("{limit}, margin {:+.1} %", 100.0 * margin);
        let is_conditional = margin >= 0.0 && taken_to_hold(report).is_some();
        let condition = if is_conditional { " if the mechanism holds" } else { "" };
        let short = format!("{bare}{condition}");
        let full = format!("{short}{ends}");
        Some(fitting([format!("limit {full}"), full, short, bare, limit], width))
    }

    /// The shot at the crosshair in words, with what the laws say there; without one, what to know of the limit.
    pub fn limit_readout(&self) -> Option<(Severity, String)> {
        let report = self.pages.limit.report.found.as_ref()?;
        if let Some(shot) = self.pages.limit.shot() {
            let mut text = shot_words(shot);
            let laws =
                [("Recht-Ipson", report.recht_ipson), ("Lambert-Jonas", report.lambert_jonas)];
            for (name, law) in laws {
                if let Some(law) = law.filter(|_| shot.residual_m_s.is_some()) {
                    let left = fixed_significant(law.residual_m_s(shot.impact_m_s), 4);
                    let _ = write!(text, "; {name} {left}");
                }
            }
            return Some((Severity::Note, text));
        }
        let mut parts = Vec::new();
        if let Limit::Found { stopped_at_m_s: Some(again), .. } = report.limit {
            let again = units::velocity(again, 4);
            parts.push(format!("no single limit: {again} is stopped again"));
        }
        parts.extend(report.undecided());
        parts.extend(report.caution());
        let severity = if parts.is_empty() { Severity::Note } else { Severity::Warning };
        parts.extend(self.limit_pages().map(|pages| pages.hint().to_owned()));
        parts.extend(self.v50().and_then(v50).map(|text| format!("V50 {text}")));
        // Where there is one row, the pane itself has the limit in full.
        if self.layout().message.height > 1 {
            let at = usize::from(severity == Severity::Warning);
            parts.insert(at.min(parts.len()), self.limit_headline(usize::MAX)?);
        }
        Some((severity, parts.join("; ")))
    }
}

/// Draw the pane of the residual velocity.
pub(crate) fn render(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    // Until something is found nothing stands above the pane.
    let room = usize::from(area.width.saturating_sub(2));
    let Some(head) = app.limit_headline(room) else { return chart(app, area, canvas) };
    let role = if app.limit_is_old() { Role::Warning } else { Role::Title };
    canvas.put(area, (1, 0), &head, role);
    let (_, body) = split_top(area, 1);
    let lines = app.limit_lines(area.width);
    let pages = app.limit_pages();
    if let Some(pages) = pages.as_ref().filter(|pages| pages.shown > 0) {
        let lines = lines.get((pages.shown - 1) * pages.rows..).unwrap_or_default();
        return write(lines, &app.keymap.shown(pages.hint()), body, canvas);
    }
    if lines.is_empty() || pages.is_some() {
        return chart(app, body, canvas);
    }
    let (above, words) = if area.width >= BESIDE {
        split_left(body, body.width - FACTS)
    } else {
        let height = u16::try_from(lines.len()).unwrap_or(u16::MAX).saturating_add(2);
        split_bottom(body, height)
    };
    chart(app, above, canvas);
    write(&lines, "", words, canvas);
}

fn write(lines: &[Remark], hint: &str, area: Rect, canvas: &mut Canvas<'_>) {
    let title = "Fitted laws and spread";
    let inner = PaneFrame::new(title).right(hint).draw(area, canvas);
    let is_labelled = |line: &Remark| !line.about.is_empty() && !line.text.is_empty();
    let column = if lines.iter().any(is_labelled) { LABEL } else { 0 };
    for (row, line) in (0..inner.height).zip(lines) {
        let role = if line.is_caution { Role::Warning } else { Role::Text };
        canvas.put(inner, (0, row), line.about, Role::Title);
        canvas.put(inner, (column, row), &line.text, role);
    }
}

fn chart(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let tab = &app.pages.limit;
    let found = tab.report.found.as_ref();
    let drawn = found.and_then(|it| Some((it, residual(it, app.limit_shot_m_s())?)));
    let Some((report, mut chart)) = drawn else {
        let frame = PaneFrame::new("Residual velocity").focused(app.has_focus(RESIDUAL));
        let inner = frame.draw(area, canvas);
        let cut = "cancelled before there was a curve";
        let none = "no shot perforates: no curve to draw";
        let why = found.map(|report| if report.is_complete { none } else { cut });
        return canvas.put_centred(inner, &nothing::<LimitSearch>(app, "finding the limit", why));
    };
    let old = app.limit_is_old();
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
    let of = if old { ", of another scene" } else { "" };
    chart.title = format!("Residual velocity{of}").into();
    chart.crosshair = tab.shot().map(|shot| shot.impact_m_s);
    chart.focused = app.has_focus(RESIDUAL);
    let layout = canvas.draw(&chart, area);
    let shots = report.shots.iter();
    let places = shots.map(|shot| Some((shot.impact_m_s, shot.residual_m_s.unwrap_or(0.0))));
    canvas.points(&layout, places, |shot| Target::Row(RESIDUAL, shot));
}

/// Where a pane stands: the residual velocity and the map above the comparison; the pane that has the keys alone where
/// there is no room for three.
pub(crate) fn area(app: &App, body: Rect, pane: Pane) -> Option<Rect> {
    let focus = app.pane();
    let rows = if body.height < ROOM_FOR_FIGURES { VERDICT_ROWS } else { COMPARISON_ROWS };
    if body.height < rows + 8 {
        return (pane == focus).then_some(body);
    }
    let (above, comparison) = split_bottom(body, rows);
    let (left, right) = split_left(above, above.width / 2);
    let is_narrow = body.width < NARROW;
    let at_right = match focus {
        EFFICIENCY_MAP => focus,
        _ if is_narrow => RESIDUAL,
        _ => EFFICIENCY_MAP,
    };
    match pane {
        COMPARISON => Some(comparison),
        _ if is_narrow => (pane == at_right).then_some(above),
        RESIDUAL => Some(left),
        _ => (pane == at_right).then_some(right),
    }
}

/// Rows of the comparison, frame included; of the verdict alone where the body is lower than this, so that charts can be read.
const COMPARISON_ROWS: u16 = 10;
const VERDICT_ROWS: u16 = 6;
const ROOM_FOR_FIGURES: u16 = 26;
