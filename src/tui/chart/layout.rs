//! Where the parts of a chart lie: legend row, labels, axes, plot. Pure arithmetic on rectangles.

use ratatui::layout::Rect;

use super::{Axis, Chart, Labels, Mapping};
use crate::report::chart::ticks::{Along, Ticks};

/// Room kept at the left for labels, so that the plot does not jump when "9" becomes "10".
const LEAST_GUTTER: u16 = 3;
/// Least width of a plot that leaves room for labels beside it.
const LEAST_PLOT_WIDTH: u16 = 8;
/// Least heights inside the frame for: an axis, its labels, a legend row.
const AXIS_FROM: u16 = 3;
const LABELS_FROM: u16 = 4;
const LEGEND_ROW_FROM: u16 = 9;
/// Least blank columns right of a plot without a right axis: for the second half of the last label, and a blank.
const MARGIN: u16 = 2;

/// Where the parts of a chart lie, and how its values map to cells.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    /// The cells of the curves.
    pub plot: Rect,
    /// Columns of the plot: the crosshair walks with this.
    pub x: Mapping,
    /// Rows of the plot, counted upward.
    pub y: Mapping,
    /// Rows of the plot by the right axis, counted upward.
    pub right: Option<Mapping>,
    /// Columns for labels left of the left axis.
    pub gutter: u16,
    /// Everything inside the frame.
    pub(super) inner: Rect,
    /// The row of the legend, when the title line cannot take it.
    pub(super) legend: Option<Rect>,
    /// Column of the left axis.
    pub(super) axis_left: Option<u16>,
    /// Column of the right axis.
    pub(super) axis_right: Option<u16>,
    /// Row of the horizontal axis.
    pub(super) axis_below: Option<u16>,
    /// Row of its labels.
    pub(super) labels_below: Option<u16>,
    pub(super) x_ticks: Ticks,
    pub(super) y_ticks: Ticks,
    pub(super) right_ticks: Ticks,
}

impl Layout {
    /// Column and row, within the plot, of a point by the left axis; `None` outside the view.
    pub(in crate::tui) fn place(&self, x: f64, y: f64) -> Option<(u16, u16)> {
        let (column, up) = self.x.cell(x).zip(self.y.cell(y))?;
        Some((column, self.plot.height.saturating_sub(up + 1)))
    }
}

/// Lays a chart out inside its frame; `legend_row` asks for a row of its own for the legend.
pub(super) fn layout(chart: &Chart<'_>, inner: Rect, legend_row: bool) -> Layout {
    let with_legend = legend_row && inner.height >= LEGEND_ROW_FROM;
    let top = u16::from(with_legend);
    let axis = u16::from(inner.height >= AXIS_FROM);
    let labels = u16::from(inner.height >= LABELS_FROM && chart.x.labels == Labels::Shown);
    let height = inner.height.saturating_sub(top + axis + labels);

    let y = map(&chart.y, height);
    let right = chart.right.as_ref().map(|axis| map(axis, height));
    let along = Along::Column(half_rows_apart(height));
    let y_ticks = chart.y.ticks(height, along);
    let right_ticks =
        chart.right.as_ref().map(|axis| axis.ticks(height, along)).unwrap_or_default();

    let gutter = (y_ticks.width() + 1).max(LEAST_GUTTER).max(chart.gutter);
    let has_left = inner.width >= gutter.saturating_add(1 + LEAST_PLOT_WIDTH);
    let left = if has_left { gutter + 1 } else { 0 };
    let right_width = right_ticks.width().max(1) + 2;
    let has_right = right.is_some() && inner.width >= left + right_width + LEAST_PLOT_WIDTH;
    let margin = match (has_right, has_left) {
        (true, _) => right_width,
        (false, true) => {
            let width = inner.width.saturating_sub(left + MARGIN);
            let label = chart.x.ticks(width, Along::Row).width();
            // Labels must not eat the plot: a quarter of it at most.
            (label.saturating_sub(1) / 2 + 1).clamp(MARGIN, MARGIN.max(width / 4))
        }
        (false, false) => 0,
    };
    let plot = Rect {
        x: inner.x + left,
        y: inner.y + top,
        width: inner.width.saturating_sub(left + margin),
        height,
    };
    let below = plot.bottom();
    Layout {
        plot,
        x: map(&chart.x, plot.width),
        y,
        right,
        gutter,
        inner,
        legend: with_legend.then_some(Rect { height: 1, ..inner }),
        axis_left: has_left.then(|| plot.x - 1),
        axis_right: has_right.then(|| plot.right()),
        axis_below: (axis == 1).then_some(below),
        labels_below: (labels == 1).then_some(below + 1),
        x_ticks: chart.x.ticks(plot.width, Along::Row),
        y_ticks,
        right_ticks,
    }
}

/// Half rows from one label to the next.
fn half_rows_apart(height: u16) -> u16 {
    match height {
        0..4 => 2,
        4..8 => 3,
        8..12 => 4,
        12..24 => 6,
        24.. => 8,
    }
}

fn map(axis: &Axis<'_>, cells: u16) -> Mapping {
    Mapping::new(axis.scale, axis.view, cells)
}
