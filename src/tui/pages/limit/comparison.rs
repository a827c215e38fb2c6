//! Comparison of candidates with equal areal mass for the design under the cursor, with its basis.

use crate::tui::app::running::CachedResult;
use crate::tui::pages::limit::map::{design, point_words};
use crate::tui::pages::limit::state::CANDIDATES;
use crate::tui::pages::page::prelude::*;
use crate::tui::plain::{self, TextStyle};
use crate::worker::studies::MassComparison;
use cmra_studies::report::compare::page::parts;
use cmra_studies::report::page::{Block, Page};
use cmra_studies::study::compare::{self, Candidate};

/// Explanation of the comparison's rows, for `?`.
pub(crate) const COMPARISON_WORDS: &str = "Ballistic limit: the plate is perforated above it. Limit if the spring survives: the plate is perforated, or the spring fails, by its known mass and the range of its law. Mass efficiency: areal mass of the solid plate that just stops the shot, over that of this armour. *: nothing stops plate and projectile";

/// Returns the comparison of the scene, if available.
pub(crate) fn own_comparison(app: &App) -> Option<&compare::ComparisonReport> {
    of_scene(&app.pages.limit.own, &app.scene)
}

/// Returns the comparison of the design under the cursor, if available.
fn candidates(app: &App) -> Option<&compare::ComparisonReport> {
    if app.pages.limit.cursor.is_none() {
        return own_comparison(app);
    }
    of_scene(&app.pages.limit.design, &design(app).ok()?.scene)
}

pub fn candidate_lines(app: &App, width: usize) -> Vec<TextLine> {
    candidates(app).map_or_else(Vec::new, |report| lines(app, report, width))
}

/// Returns a comparison of this scene that contains the scene itself.
fn of_scene<'a>(
    kept: &'a CachedResult<compare::ComparisonReport>,
    scene: &Scene,
) -> Option<&'a compare::ComparisonReport> {
    let found = kept.result.as_deref().filter(|_| *kept.scene == *scene)?;
    found.entry(Candidate::Scene).map(|_| found)
}

/// Returns the lines of the comparison: cautions, the candidates side by side as in the printed report, and the basis of the verdict.
fn lines(app: &App, report: &compare::ComparisonReport, width: usize) -> Vec<TextLine> {
    let [mut blocks, table, reasons] = parts(report);
    blocks.extend(table);
    blocks.push(Block::Space);
    blocks.extend(reasons);
    let style = TextStyle { width, theme: app.settings.theme, is_brief: true };
    plain::lines(&Page { blocks }, style)
}

/// Indentation of the continuation lines of a sentence.
const CONTINUATION_INDENT: &str = "  ";

/// Draws the candidates side by side; scrolled by j and k.
pub(super) fn render(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let focused = app.has_focus(CANDIDATES);
    let of = point_words(app).unwrap_or_else(|| "this scene".to_owned());
    let lines = candidate_lines(app, usize::from(area.width.saturating_sub(2)));
    let height = usize::from(area.height.saturating_sub(2));
    let right = match (lines.len() > height, focused) {
        (true, true) => "<down>/<up>: more",
        (true, false) => "<next-pane>, <down>/<up>: more",
        (false, _) => "",
    };
    let frame = PaneFrame::new(format!("Candidates: {of}"));
    let frame = frame.right(app.keymap.shown(right)).focused(focused);
    let inner = frame.draw(area, canvas);
    if lines.is_empty() {
        let running = "comparing with a rigid mount and a solid plate of the same areal mass";
        let rests = app.pages.limit.cursor.map(|_| "computed when the cursor rests");
        let why =
            if app.scene.is_stack() { Some("a stack is compared with nothing") } else { rests };
        canvas.put_centred(inner, &nothing::<MassComparison>(app, running, why));
    }
    let first = app.pages.limit.scrolled.min(lines.len().saturating_sub(height));
    let shown = whole(&lines[first..], height);
    canvas.put_lines(inner, 0, shown.iter().cloned());
}

/// Returns at most this many lines, without a truncated sentence at the end.
fn whole(lines: &[TextLine], height: usize) -> &[TextLine] {
    let ends =
        |at: &usize| lines.get(*at).is_none_or(|next| !next.0.starts_with(CONTINUATION_INDENT));
    let room = height.min(lines.len());
    &lines[..(1..=room).rev().find(ends).unwrap_or(room)]
}
