//! Charts for scientific use in a terminal: linear and logarithmic axes with ticks under their labels, gaps where a value is
//! missing, spikes kept whatever the width, event lines, a crosshair, a second vertical axis.
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

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::text::Span;

use crate::tui::theme::{GlyphSet, PaneFrame, Theme, ascii_pass};

mod canvas;
pub mod curve;
pub mod heatmap;
pub mod layout;
mod paint;
mod titles;
mod trace;

pub use crate::report::chart::levels::Levels;
pub use crate::report::chart::{
    Axis, Chart, Curve, Emphasis, Frame, Labels, Legend, Mapping, Mark, Scale, Side, Unit,
    ViewRange,
};
pub use curve::MARKERS;
pub use layout::Layout;

impl Chart<'_> {
    /// Where everything would lie in an area, without drawing.
    pub fn layout(&self, area: Rect) -> Layout {
        self.plan(area, Theme::PLAIN).layout
    }

    /// Draws the chart into an area, and tells where everything lies.
    pub fn render(&self, area: Rect, buffer: &mut Buffer, theme: Theme) -> Layout {
        let area = area.intersection(buffer.area);
        let plan = self.plan(area, theme);
        self.pane().right(plan.right).titled(plan.title).render(area, buffer, theme);
        if let Some(row) = plan.layout.legend {
            buffer.set_line(row.x + 1, row.y, &plan.legend, row.width.saturating_sub(1));
        }
        paint::paint(self, &plan.layout, buffer, theme);
        plan.layout
    }

    /// The chart as lines of text, blanks at their ends removed: what `--plain` prints.
    pub fn to_lines(&self, width: u16, height: u16, theme: Theme) -> Vec<String> {
        lines_of(width, height, theme, |area, buffer| drop(self.render(area, buffer, theme)))
    }

    /// Its frame.
    fn pane(&self) -> PaneFrame<'_> {
        let pane = PaneFrame::default().focused(self.focused);
        if self.frame == Frame::OpenBelow { pane.open_below() } else { pane }
    }
}

/// Makes the plots of charts stacked on each other begin in one column: gives all the widest gutter.
pub fn align_gutters(charts: &mut [Chart<'_>], areas: &[Rect]) {
    let gutters = charts.iter().zip(areas).map(|(chart, area)| chart.layout(*area).gutter);
    let widest = gutters.max().unwrap_or(0);
    for chart in charts {
        chart.gutter = widest;
    }
}

/// What is drawn in an area of its own, as lines of text.
fn lines_of(
    width: u16,
    height: u16,
    theme: Theme,
    draw: impl FnOnce(Rect, &mut Buffer),
) -> Vec<String> {
    let area = Rect::new(0, 0, width, height);
    let mut buffer = Buffer::empty(area);
    draw(area, &mut buffer);
    if theme.glyphs == GlyphSet::Ascii {
        ascii_pass(&mut buffer);
    }
    buffer_lines(&buffer)
}

/// A buffer as lines of text, blanks at their ends removed.
pub fn buffer_lines(buffer: &Buffer) -> Vec<String> {
    let width = usize::from(buffer.area.width.max(1));
    let line = |row: &[ratatui::buffer::Cell]| {
        let mut text = String::with_capacity(width);
        let mut hidden = 0;
        for cell in row {
            // A wide character hides the cell after it.
            if hidden > 0 {
                hidden -= 1;
                continue;
            }
            text.push_str(cell.symbol());
            hidden = Span::raw(cell.symbol()).width().saturating_sub(1);
        }
        text.truncate(text.trim_end().len());
        text
    };
    buffer.content.chunks(width).map(line).collect()
}

#[cfg(test)]
mod tests;
