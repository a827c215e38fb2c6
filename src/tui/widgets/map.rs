//! Map in a pane, with the legend of its bands, contour and letters below.

use ratatui::layout::Rect;

use crate::tui::chart::heatmap::swatch;
use crate::tui::chart::{Layout, Scale, Unit, ViewRange};
use crate::tui::theme::Role;
use crate::tui::widgets::text::columns;
use crate::tui::widgets::{Canvas, split_bottom};
use cmra_engine::model::units::significant;
use cmra_studies::report::map::{Cell, Map, MapMark};

/// Rows of the area for each row of the legend.
const WORDS: u16 = 10;

/// Formats a letter with its meaning in a few words.
fn named(mark: &MapMark) -> String {
    match mark.letter {
        ' ' => format!("blank {}", mark.label),
        letter => format!("{letter} {}", mark.label),
    }
}

impl Canvas<'_> {
    /// Draws a map with its legend; returns the layout.
    pub(crate) fn draw_map(&mut self, map: &Map<'_>, area: Rect) -> Layout {
        let is_drawn = |letter: char| {
            let mut marks = map.cells.iter();
            marks.any(|cell| matches!(cell, Cell::Mark(mark, _) if *mark == letter))
                || map.present.is_some_and(|it| it.1 == letter)
        };
        let marks = map.marks.iter().filter(|mark| is_drawn(mark.letter));
        let mut words: Vec<String> = Vec::new();
        for text in marks.map(named) {
            let room = usize::from(area.width).saturating_sub(3);
            match words.last_mut() {
                Some(line) if line.len() + text.len() < room => {
                    line.push_str("; ");
                    line.push_str(&text);
                }
                _ => words.push(text),
            }
        }
        words.truncate(usize::from(area.height / WORDS));
        let bands = u16::from(map.levels.is_some());
        let below = u16::try_from(words.len()).unwrap_or(0);
        let (above, below) = split_bottom(area, below + bands);
        let layout = self.draw(map, above);
        self.put_bands(map, below);
        for (row, text) in (bands..).zip(words) {
            self.put(below, (1, row), &text, Role::Text);
        }
        layout
    }

    /// Draws the bands in a row, each with its lower bound; if they do not all fit, every second one, every third one, and so on.
    fn put_bands(&mut self, map: &Map<'_>, area: Rect) {
        let Some(levels) = &map.levels else { return };
        let range = ViewRange::from_values(Scale::Linear, map.values()).unwrap_or_default();
        let unit = Unit::with_prefix(range.size(), map.unit);
        let contour = map.contour.as_ref().map(|(_, mark)| named(mark));
        let unit_name =
            Some(&*unit.name).filter(|name| !name.is_empty()).map(|it| format!("{it}:"));
        let lead: Vec<String> = contour.into_iter().chain(unit_name).collect();
        let lead = lead.join("  ");
        let mut column = self.put(area, (1, 0), &lead, Role::Text);
        let from = |band: usize| format!(" {}", significant(levels.band(band).0 * unit.factor, 3));
        let count = levels.bands();
        let room = area.width.saturating_sub(column);
        let width = |every: usize| {
            (0..count).step_by(every).map(|band| columns(&from(band)) + 2).sum::<u16>()
        };
        let every = (1..count).find(|every| width(*every) <= room).unwrap_or(count);
        for band in (0..count).step_by(every) {
            let (symbol, style) = swatch(band, count, self.theme);
            column = self.put_styled(area, (column + 1, 0), &symbol.to_string(), style);
            column = self.put(area, (column, 0), &from(band), Role::Text);
        }
    }
}
