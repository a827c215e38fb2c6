//! The comparison at equal areal mass in the Limit tab: the verdict, the figures of the candidates beside each other, the map of
//! mass efficiency and the design under its cursor, in words and drawn.

use crate::report;
use crate::report::compare::{picture, reasons, verdict};
use crate::report::figures::column_of;
use crate::study::compare::map::Map;
use crate::study::compare::{self, is_equal};
use crate::study::sweep::Axis;
use crate::tui::pages::explore::state::{copy_value, nearest, placed};
use crate::tui::pages::limit::state::{COMPARISON, EFFICIENCY_MAP};
use crate::tui::pages::page::prelude::*;
use crate::worker::studies::{Comparison, EqualMass};

/// What the rows of the comparison mean, for `?`.
pub(crate) const COMPARISON_WORDS: &str = "Ballistic limit: the plate is perforated above it. Limit if the spring must survive: the plate is perforated, or the spring fails, by its known mass and the range of its law. Mass efficiency: areal mass of the solid plate that just stops the shot, over that of this armour. *: nothing stops plate and projectile";

impl App {
    /// Whether the comparison belongs to another scene than the one on the screen.
    pub fn comparison_is_old(&self) -> bool {
        self.pages.limit.comparison.is_old(&self.scene)
    }

    pub fn comparison(&self) -> Option<&Comparison> {
        self.pages.limit.comparison.found.as_deref()
    }

    pub fn comparison_lines(&self, width: usize) -> Vec<TextLine> {
        self.comparison().map_or_else(Vec::new, |found| lines(&found.report, width))
    }

    /// The map, and its cell under the cursor: the one it was moved to, else the one nearest to the scene.
    pub(crate) fn efficiency_cell(&self) -> Option<(&Map, (usize, usize))> {
        let map = self.comparison()?.map.as_ref()?;
        let own = |axis: &Axis| nearest(axis, axis.get(&self.scene)?);
        let own = || own(map.x()).zip(own(map.y()));
        Some((map, self.pages.limit.map_cursor.or_else(own).unwrap_or((0, 0))))
    }

    /// The design under the cursor of the map, with the values of its axes in words.
    pub fn efficiency_design(&self) -> Result<LabelledScene, String> {
        let Some((map, at)) = self.efficiency_cell() else {
            return Err(nothing::<EqualMass>(self, BEING_COMPUTED, None));
        };
        if self.pages.limit.comparison.is_old(&self.efficiency_scene()) {
            return Err(old("scene"));
        }
        Ok(placed((*self.scene).clone(), values(map, at)))
    }

    /// The scene whose map is wanted: with the values that the axes of the one there have in its scene.
    pub fn efficiency_scene(&self) -> Scene {
        let mut scene = (*self.scene).clone();
        if let Some(map) = self.comparison().and_then(|found| found.map.as_ref()) {
            for axis in [map.x(), map.y()] {
                copy_value(axis, &self.pages.limit.comparison.scene, &mut scene);
            }
        }
        scene
    }

    /// The description of the cell under the map's cursor.
    pub fn efficiency_readout(&self) -> Option<String> {
        let (map, at) = self.efficiency_cell()?;
        let value = match map.cell(at.0 as u64, at.1 as u64) {
            Some(Ok(value)) if is_equal(value) => "mass efficiency 1: no difference".to_owned(),
            Some(Ok(value)) => {
                let pays = if value > 1.0 { "moving armour pays" } else { "it does not pay" };
                format!("mass efficiency {}: {pays}", significant(value, 4))
            }
            Some(Err(absence)) => absence.words.to_owned(),
            None => "not computed yet".to_owned(),
        };
        let place = |(axis, at): (&Axis, f64)| format!("{} {}", axis.symbol(), axis.show(at, 5));
        let [x, y] = values(map, at).map(place);
        Some(format!("{x}, {y}: {value}"))
    }
}

/// The axes of a map with their values at a cell.
fn values(map: &Map, (x, y): (usize, usize)) -> [(&Axis, f64); 2] {
    [(map.x(), x), (map.y(), y)].map(|(axis, at)| (axis, axis.value(at as u64)))
}

/// The verdict, what to beware of, the candidates beside each other as on the printed page, then what the verdict rests on.
fn lines(report: &compare::Report, width: usize) -> Vec<TextLine> {
    let sentence = |role: Role, text: &str| -> Vec<TextLine> {
        let parts = wrap(text, width.saturating_sub(GOES_ON.len())).into_iter().enumerate();
        let lead = |at: usize| if at == 0 { "" } else { GOES_ON };
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
const GOES_ON: &str = "  ";

/// The verdict first, then the figures beside each other; scrolled by j and k.
pub(crate) fn render(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let focused = app.has_focus(COMPARISON);
    let old = if app.comparison_is_old() { " (of another scene)" } else { "" };
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
        canvas.put_centred(inner, &nothing::<EqualMass>(app, running, None));
    }
    let first = app.pages.limit.scrolled.min(lines.len().saturating_sub(height));
    let shown = whole(&lines[first..], height);
    canvas.put_lines(inner, 0, shown.iter().cloned());
}

/// A given number of lines at most, without the beginning of a sentence whose end has no room.
fn whole(lines: &[TextLine], height: usize) -> &[TextLine] {
    let ends = |at: &usize| lines.get(*at).is_none_or(|next| !next.0.starts_with(GOES_ON));
    let room = height.min(lines.len());
    &lines[..(1..=room).rev().find(ends).unwrap_or(room)]
}

/// The map of mass efficiency with the line of 1, and below it what its colours mean.
pub(crate) fn map(app: &App, area: Rect, canvas: &mut Canvas<'_>) {
    let focused = app.has_focus(EFFICIENCY_MAP);
    let cell = app.efficiency_cell();
    let Some(((found, (x, y)), map)) = cell.and_then(|it| Some((it, picture(it.0)?))) else {
        let frame = PaneFrame::new("Mass efficiency").focused(focused);
        let inner = frame.draw(area, canvas);
        let why = cell.map(|_| "no point has a mass efficiency");
        return canvas.put_centred(inner, &nothing::<EqualMass>(app, "computing the map", why));
    };
    let cursor = column_of(found.x(), x).zip(column_of(found.y(), y));
    let title = format!("mass efficiency, up: {}", found.y().symbol()).into();
    let layout = canvas.draw_map(&report::map::Map { title, cursor, focused, ..map }, area);
    canvas.plot(&layout, |x, y| {
        Some(Target::Cell(EFFICIENCY_MAP, (nearest(found.x(), x)?, nearest(found.y(), y)?)))
    });
}
