//! Charts for scientific use in a terminal: linear and logarithmic axes with ticks under their labels, gaps where a value is
//! missing, spikes kept whatever the width, event lines, a crosshair.
//!
//! ```text
//! +- Penetration p [mm] ---------- * now  o A rigid   t [us] +    title; legend; horizontal axis
//! |   |                    a                    b            |    tags of events
//! |  5+                    :         oooooooooooooooooooooo  |    curves over event lines,
//! |   |              ooooo*********************************  |    the selected one on top
//! |   |    o************** :                    :            |
//! |  0+*****               :                    :            |
//! |   ++------+------+-----+------+------+------+------+---  |
//! |    0     20     40    60     80     100    120    140    |    labels centred on their ticks
//! +----------------------------------------------------------+
//! ```
//!
//! Everything shown comes in as plain data: names and units are texts. Knows ratatui and the theme; must not know plates,
//! runs or scenes. A chart of any size with any numbers draws inside its area, never panics, and costs O(points + cells).

mod canvas;
pub mod heatmap;
pub mod layout;
mod paint;

use layout::{frame_of, plan};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::tui::theme::{GlyphSet, Theme, ascii_pass, columns};
use cmra_studies::report::svg::Svg;

pub use canvas::MARKERS;
pub use cmra_studies::report::chart::levels::Levels;
pub use cmra_studies::report::chart::{
    Axis, Below, Chart, Curve, Emphasis, Frame, Legend, Mapping, Mark, Scale, Unit, ViewRange,
};
pub use layout::Layout;

/// Drawing of charts and maps in a terminal.
pub trait Draw: Svg {
    /// Draws into an area; returns the layout.
    fn render(&self, area: Rect, buffer: &mut Buffer, theme: Theme) -> Layout;

    /// Draws as lines of text without trailing blanks, as printed by `--plain`.
    fn to_lines(&self, width: u16, height: u16, theme: Theme) -> Vec<String> {
        let area = Rect::new(0, 0, width, height);
        let mut buffer = Buffer::empty(area);
        self.render(area, &mut buffer, theme);
        if theme.glyphs == GlyphSet::Ascii {
            ascii_pass(&mut buffer);
        }
        buffer_lines(&buffer)
    }
}

impl Draw for Chart<'_> {
    fn render(&self, area: Rect, buffer: &mut Buffer, theme: Theme) -> Layout {
        let area = area.intersection(buffer.area);
        let plan = plan(self, area, theme);
        let frame = frame_of(self, plan.title).right(plan.right);
        frame.render(area, buffer, theme);
        if let Some(row) = plan.layout.legend {
            buffer.set_line(row.x + 1, row.y, &plan.legend, row.width.saturating_sub(1));
        }
        paint::paint(self, &plan.layout, buffer, theme);
        plan.layout
    }
}

/// Returns the emphasis of a curve: of an old scene, selected, or normal.
pub(crate) fn emphasis(is_old: bool, is_selected: bool) -> Emphasis {
    match (is_old, is_selected) {
        (true, _) => Emphasis::Stale,
        (false, true) => Emphasis::Selected,
        (false, false) => Emphasis::Normal,
    }
}

/// Returns the layout of a chart in an area, without drawing.
pub fn layout_of(chart: &Chart<'_>, area: Rect) -> Layout {
    plan(chart, area, Theme::PLAIN).layout
}

/// Aligns the plots of stacked charts by giving all the widest gutter.
pub fn align_gutters(charts: &mut [Chart<'_>], areas: &[Rect]) {
    let gutters = charts.iter().zip(areas).map(|(chart, area)| layout_of(chart, *area).gutter);
    let widest = gutters.max().unwrap_or(0);
    for chart in charts {
        chart.gutter = widest;
    }
}

/// Converts a buffer to lines of text without trailing blanks.
pub fn buffer_lines(buffer: &Buffer) -> Vec<String> {
    let width = usize::from(buffer.area.width.max(1));
    let line = |row: &[ratatui::buffer::Cell]| {
        let mut text = String::with_capacity(width);
        let mut hidden = 0;
        for cell in row {
            // A wide character hides the following cell.
            if hidden > 0 {
                hidden -= 1;
                continue;
            }
            text.push_str(cell.symbol());
            hidden = columns(cell.symbol()).saturating_sub(1);
        }
        text.truncate(text.trim_end().len());
        text
    };
    buffer.content.chunks(width).map(line).collect()
}

#[cfg(test)]
mod tests;
