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

use std::borrow::Cow;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::text::Span;

use crate::tui::theme::{GlyphSet, PaneFrame, Theme, ascii_pass};

mod canvas;
pub mod curve;
pub mod heatmap;
pub mod layout;
pub mod levels;
mod paint;
pub mod scale;
mod ticks;
mod titles;
mod trace;

pub use crate::report::unit::Unit;
pub use curve::{Curve, Emphasis, MARKERS, Side};
pub use heatmap::{HeatCell, Heatmap};
pub use layout::Layout;
pub use levels::Levels;
pub use scale::{Mapping, Scale, ViewRange};

/// An axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis<'a> {
    /// What it measures: `t`. Of the left axis the chart's title says it.
    pub label: Cow<'a, str>,
    /// The unit numbers are shown in; points, views, events and crosshair stay in the unit of the data.
    pub unit: Unit<'a>,
    /// How values are spread.
    pub scale: Scale,
    /// Which values are shown, in the unit of the data.
    pub view: ViewRange,
    /// Whether numbers stand at the ticks.
    pub labels: Labels,
}

impl<'a> Axis<'a> {
    /// A linear axis that shows numbers as they are, without a unit.
    pub fn new(label: impl Into<Cow<'a, str>>, view: ViewRange) -> Self {
        Self {
            label: label.into(),
            unit: Unit::new(""),
            scale: Scale::Linear,
            view,
            labels: Labels::Shown,
        }
    }

    /// With numbers in this unit.
    #[must_use]
    pub fn unit(mut self, unit: Unit<'a>) -> Self {
        self.unit = unit;
        self
    }

    /// With this scale.
    #[must_use]
    pub fn scale(mut self, scale: Scale) -> Self {
        self.scale = scale;
        self
    }
}

/// Whether the numbers of the horizontal axis are written: of charts stacked on one time axis only the lowest needs them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Labels {
    /// Written.
    #[default]
    Shown,
    /// Ticks only.
    Hidden,
}

/// A vertical dotted line.
#[derive(Clone, Debug, PartialEq)]
pub struct EventLine<'a> {
    /// Where, in the unit of the data.
    pub x: f64,
    /// A letter or a few at its top; may be empty.
    pub tag: Cow<'a, str>,
}

/// A horizontal dotted line, by the left axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Level<'a> {
    /// Where, in the unit of the data.
    pub y: f64,
    /// A word at its right end; may be empty.
    pub tag: Cow<'a, str>,
}

/// What is around a chart.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Frame {
    /// A box with the title in its top line.
    #[default]
    Boxed,
    /// A box without its lower line, for charts stacked on each other.
    OpenBelow,
}

/// Whether the curves are named.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Legend {
    /// In the title line, or in a row above the plot where that is too short. Never over data.
    #[default]
    Shown,
    /// Not: another chart names them.
    Hidden,
}

/// A chart. Build it with [`Chart::new`] and set the rest: `Chart { crosshair: Some(t), ..Chart::new(title, x, y, curves) }`.
pub struct Chart<'a> {
    /// What it shows; the unit of the left axis is appended.
    pub title: Cow<'a, str>,
    /// The horizontal axis.
    pub x: Axis<'a>,
    /// The left axis.
    pub y: Axis<'a>,
    /// A second vertical axis, for the curves of [`Side::Right`].
    pub right: Option<Axis<'a>>,
    /// The curves, later ones over earlier ones.
    pub curves: Vec<Curve<'a>>,
    /// Vertical lines under the curves.
    pub events: Vec<EventLine<'a>>,
    /// Horizontal lines under the curves.
    pub levels: Vec<Level<'a>>,
    /// Where the crosshair stands, in the unit of the data.
    pub crosshair: Option<f64>,
    /// What is around it.
    pub frame: Frame,
    /// Whether the curves are named.
    pub legend: Legend,
    /// Least columns for the labels of the left axis; see [`align_gutters`].
    pub gutter: u16,
    /// Whether it has the keys.
    pub focused: bool,
}

impl<'a> Chart<'a> {
    /// A chart with curves and axes and nothing else.
    pub fn new(
        title: impl Into<Cow<'a, str>>,
        x: Axis<'a>,
        y: Axis<'a>,
        curves: Vec<Curve<'a>>,
    ) -> Self {
        Self {
            title: title.into(),
            x,
            y,
            right: None,
            curves,
            events: Vec::new(),
            levels: Vec::new(),
            crosshair: None,
            frame: Frame::Boxed,
            legend: Legend::Shown,
            gutter: 0,
            focused: false,
        }
    }

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
        let area = Rect::new(0, 0, width, height);
        let mut buffer = Buffer::empty(area);
        self.render(area, &mut buffer, theme);
        if theme.glyphs == GlyphSet::Ascii {
            ascii_pass(&mut buffer);
        }
        buffer_lines(&buffer)
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
