//! The comparison at equal areal mass in the Limit tab: the verdict, the figures of the candidates beside each other, and the map of
//! mass efficiency, in words and drawn.

use crate::tui::pages::limit::state::{COMPARISON, EFFICIENCY_MAP};
use crate::tui::pages::page::prelude::*;
use crate::worker::studies::{Comparison, MassComparison};
use cmra_studies::report;
use cmra_studies::report::compare::{picture, reasons, verdict};
use cmra_studies::study::compare;

/// Meaning of the comparison's rows, for `?`.
pub(crate) const COMPARISON_WORDS: &str = "Ballistic limit: the plate is perforated above it. Limit if the spring must survive: the plate is perforated, or the spring fails, by its known mass and the range of its law. Mass efficiency: areal mass of the solid plate that just stops the shot, over that of this armour. *: nothing stops plate and projectile";

impl App {
    pub fn comparison(&self) -> Option<&Comparison> {
        self.pages.limit.comparison.result.as_deref()
    }

    pub fn comparison_lines(&self, width: usize) -> Vec<TextLine> {
        self.comparison().map_or_else(Vec::new, |found| lines(&found.report, width))
    }
}

/// The verdict, what to beware of, the candidates beside each other as on the printed page, then what the verdict rests on.
fn lines(report: &compare::ComparisonReport, width: usize) -> Vec<TextLine> {
    let sentence = |role: Role, text: &str| -> Vec<TextLine> {
        let parts =
            wrap(text, width.saturating_sub(CONTINUATION_INDENT.len())).into_iter().enumerate();
        let lead = |at: usize| if at == 0 { "" } else { CONTINUATION_INDENT };
        parts.map(|(at, part)| (lead(at).to_owned() + &part, role)).collect()
    };
    let mut lines = sentence(Role::Text, &verdict(report));
    if let Some(caution) = report.caution() {
        lines.extend(sentence(Role::Warning, &format!("caution: {caution}")));
    }
    let table = report::compare::beside(report, width);
    for line in table.lines() {
        if line.starts_with('*') {
            lines.extend(sentence(Role::Text, line));
        } else {
            lines.push((line.to_owned(), Role::Text));
        }
    }
    lines.push((String::new(), Role::Text));
    lines.extend(reasons(report).iter().flat_map(|text| sentence(Role::Text, text)));
    lines
}

/// The indentation of the further lines of a sentence.
const CONTINUATION_INDENT: &str = "  ";

/// The verdict first, then the figures beside each other; scrolled by j and k.
pub(crate) fn render(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let focused = app.has_focus(COMPARISON);
    let old =
        if app.pages.limit.comparison.is_stale(&app.scene) { " (of another scene)" } else { "" };
    let title = format!("Does moving armour pay?{old}");
    let lines = app.comparison_lines(usize::from(area.width.saturating_sub(2)));
    let height = usize::from(area.height.saturating_sub(2));
    let more = lines.len() > height;
    let right = match (more, focused) {
        (true, true) => "<down>/<up>: more",
        (true, false) => "<next-pane>, <down>/<up>: more",
        (false, _) => "",
    };
    let frame = PaneFrame::new(title).right(app.keymap.shown(right)).focused(focused);
    let inner = frame.draw(area, canvas);
    if lines.is_empty() {
        let running = "comparing with a rigid mount and a solid plate of the same areal mass";
        canvas.put_centred(inner, &nothing::<MassComparison>(app, running, None));
    }
    let first = app.pages.limit.scrolled.min(lines.len().saturating_sub(height));
    let shown = whole(&lines[first..], height);
    canvas.put_lines(inner, 0, shown.iter().cloned());
}

/// A given number of lines at most, without the beginning of a sentence whose end has no room.
fn whole(lines: &[TextLine], height: usize) -> &[TextLine] {
    let ends =
        |at: &usize| lines.get(*at).is_none_or(|next| !next.0.starts_with(CONTINUATION_INDENT));
    let room = height.min(lines.len());
    &lines[..(1..=room).rev().find(ends).unwrap_or(room)]
}

/// The map of mass efficiency with the line of 1, and below it what its colours mean.
pub(crate) fn map(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let focused = app.has_focus(EFFICIENCY_MAP);
    let found = app.comparison().and_then(|found| found.map.as_ref());
    let Some((found, map)) = found.and_then(|found| Some((found, picture(found)?))) else {
        let inner = PaneFrame::new("Mass efficiency").focused(focused).draw(area, canvas);
        let why = found.map(|_| "no point has a mass efficiency");
        return canvas
            .put_centred(inner, &nothing::<MassComparison>(app, "computing the map", why));
    };
    let title = format!("mass efficiency, up: {}", found.y().symbol()).into();
    canvas.draw_map(&report::map::Map { title, focused, ..map }, area);
}
