//! Where the parts of a chart lie: legend row, labels, axes, plot. Pure arithmetic on rectangles.

use ratatui::layout::Rect;
use ratatui::text::{Line, Span};

use super::canvas::left_out_of;
use super::{
    Axis, Chart, Curve, Emphasis, Labels, Legend, Mapping, Side, cell_marker, frame_of, role,
};
use crate::report::chart::spaced;
use crate::report::chart::ticks::{Along, Ticks};
use crate::tui::theme::Theme;

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
    pub(super) axis_left: Option<u16>,
    pub(super) axis_right: Option<u16>,
    pub(super) axis_below: Option<u16>,
    pub(super) labels_below: Option<u16>,
    pub(super) x_ticks: Ticks,
    pub(super) y_ticks: Ticks,
    pub(super) right_ticks: Ticks,
}

impl Layout {
    /// Column and row, within the plot, of a point by the left axis; `None` outside the view.
    pub(crate) fn place(&self, x: f64, y: f64) -> Option<(u16, u16)> {
        let (column, up) = self.x.cell(x).zip(self.y.cell(y))?;
        Some((column, self.plot.height.saturating_sub(up + 1)))
    }
}

/// Lays a chart out inside its frame; `legend_row` requests a row of its own for the legend.
pub(super) fn layout(chart: &Chart<'_>, inner: Rect, legend_row: bool) -> Layout {
    let with_legend = legend_row && inner.height >= LEGEND_ROW_FROM;
    let top = u16::from(with_legend);
    let axis = u16::from(inner.height >= AXIS_FROM);
    let labels = u16::from(inner.height >= LABELS_FROM && chart.x.labels == Labels::Shown);
    let height = inner.height.saturating_sub(top + axis + labels);

    let y = map(&chart.y, height);
    let right = chart.right.as_ref().map(|axis| map(axis, height));
    let along = Along::Rows(half_rows_apart(height));
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

/// The parts of the title line.
pub(super) struct Plan<'a> {
    pub(super) layout: Layout,
    pub(super) title: String,
    pub(super) right: Line<'a>,
    pub(super) legend: Line<'a>,
}

/// Decides what goes where. All in the title line if it fits; else the legend gets a row of its own; else, in a low
/// chart, only the curves' markers stay.
pub(super) fn plan<'a>(chart: &'a Chart<'_>, area: Rect, theme: Theme) -> Plan<'a> {
    let left_out = left_out(chart);
    let inner = frame_of(chart).inner(area);
    let room = usize::from(area.width.saturating_sub(8));
    let entries = legend(chart, theme);
    let legend = line(entries.clone());
    let axis = |layout: &Layout| chart.x.text(layout.x_ticks.exponent);

    let full = layout(chart, inner, false);
    let title = title_text(chart, &full) + &hidden(left_out);
    let both = join(legend.clone(), axis(&full));
    if Span::raw(&title).width() + both.width() <= room {
        return Plan { layout: full, title, right: both, legend: Line::default() };
    }
    let layout = layout(chart, inner, legend.width() > 0);
    let title = title_text(chart, &layout);
    let axis = Line::from(axis(&layout));
    let notes = [hidden(left_out), format!(" ({left_out} hidden)")];
    let needed = Span::raw(&title).width() + axis.width();
    let note = notes.into_iter().find(|note| left_out > 0 && needed + note.len() <= room);
    let title = title + &note.unwrap_or_default();
    let room = room.saturating_sub(Span::raw(&title).width());
    let (right, legend) = if layout.legend.is_some() {
        // The row begins a blank from the frame.
        (axis, whole(entries, usize::from(inner.width.saturating_sub(1))))
    } else if legend.width() > 0 {
        (shortened(entries, room), Line::default())
    } else {
        (axis, legend)
    };
    Plan { layout, title, right, legend }
}

/// Points that a logarithmic axis cannot show.
fn left_out(chart: &Chart<'_>) -> usize {
    let count = |curve: &Curve<'_>| {
        let vertical = match (curve.side, &chart.right) {
            (Side::Right, Some(axis)) => axis.scale,
            (Side::Right, None) | (Side::Left, _) => chart.y.scale,
        };
        left_out_of(curve, chart.x.scale, vertical)
    };
    chart.curves.iter().map(count).sum()
}

/// The points that a logarithmic axis does not show, for the title.
fn hidden(count: usize) -> String {
    match count {
        0 => String::new(),
        1 => " (1 point <= 0 not drawn)".to_owned(),
        count => format!(" ({count} points <= 0 not drawn)"),
    }
}

fn title_text(chart: &Chart<'_>, layout: &Layout) -> String {
    let unit = chart.y.unit_text(layout.y_ticks.exponent);
    let mut text = spaced(&chart.title, &unit);
    if let Some(axis) = &chart.right {
        text += ", right: ";
        text += &axis.text(layout.right_ticks.exponent);
    }
    text
}

/// The marker and the words of each curve that has a label.
fn legend<'a>(chart: &'a Chart<'_>, theme: Theme) -> Vec<[Span<'a>; 2]> {
    let entry = |curve: &Curve<'_>| {
        let old = if curve.emphasis == Emphasis::Stale { " (old)" } else { "" };
        let side = if curve.side == Side::Right { " (right)" } else { "" };
        let marker = Span::styled(cell_marker(curve).to_string(), theme.style(role(curve)));
        [marker, Span::raw(format!(" {}{old}{side}", curve.label))]
    };
    let is_shown = |curve: &&Curve<'_>| chart.legend != Legend::Hidden && !curve.label.is_empty();
    chart.curves.iter().filter(is_shown).map(entry).collect()
}

/// Entries of a legend, two blanks between them.
fn line<'a>(entries: impl IntoIterator<Item = [Span<'a>; 2]>) -> Line<'a> {
    let mut line = Line::default();
    for entry in entries {
        if !line.spans.is_empty() {
            line.push_span("  ");
        }
        line.spans.extend(entry);
    }
    line
}

fn join(mut legend: Line<'_>, axis: String) -> Line<'_> {
    if !axis.is_empty() {
        if legend.width() > 0 {
            legend.spans.push(Span::raw("   "));
        }
        legend.spans.push(Span::raw(axis));
    }
    legend
}

/// As many whole entries of a legend as fit, and `..` where there are more: a number must not be cut.
fn whole(entries: Vec<[Span<'_>; 2]>, room: usize) -> Line<'_> {
    let all = line(entries.clone());
    if all.width() <= room {
        return all;
    }
    let mut used = 0;
    let kept = entries.into_iter().take_while(|entry| {
        used += entry.iter().map(Span::width).sum::<usize>() + 2;
        used + 2 <= room
    });
    let mut short = line(kept);
    if !short.spans.is_empty() {
        short.push_span("  ");
    }
    short.push_span("..");
    short
}

/// The whole legend where it fits, else its markers, as many as there is room for.
fn shortened(entries: Vec<[Span<'_>; 2]>, room: usize) -> Line<'_> {
    let all = line(entries.clone());
    if all.width() <= room {
        return all;
    }
    let markers = entries.into_iter().map(|[marker, _]| marker);
    markers.take(room.saturating_sub(1)).collect()
}
