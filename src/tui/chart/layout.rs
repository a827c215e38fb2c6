//! Layout of a chart: legend row, labels, axes, plot. Arithmetic on rectangles only.

use ratatui::layout::Rect;
use ratatui::text::{Line, Span};

use super::canvas::role;
use crate::tui::theme::{PaneFrame, Theme};
use cmra_studies::report::chart::ticks::{Along, Tick, Ticks};
use cmra_studies::report::chart::{
    Axis, Below, Chart, Curve, Emphasis, Frame, Legend, Mapping, Scale, ViewRange,
};
use cmra_studies::report::steps::{Step, decade};

/// Minimum columns for labels at the left, so that the plot does not move when "9" becomes "10".
const MIN_GUTTER: u16 = 3;
/// Minimum width of a plot with labels beside it.
const MIN_PLOT_WIDTH: u16 = 8;
/// Minimum heights inside the frame for an axis, its labels and a legend row.
const AXIS_FROM: u16 = 3;
const LABELS_FROM: u16 = 4;
const LEGEND_ROW_FROM: u16 = 9;
/// Minimum blank columns right of a plot: for the second half of the last label, and a blank.
const MARGIN: u16 = 2;

/// Layout of a chart, and the mapping of its values to cells.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    /// Cells of the curves.
    pub plot: Rect,
    /// Columns of the plot, also used by the crosshair.
    pub x: Mapping,
    /// Rows of the plot, counted upward.
    pub y: Mapping,
    /// Columns for labels left of the left axis.
    pub gutter: u16,
    /// Area inside the frame.
    pub(super) inner: Rect,
    /// Row of the legend, if the title line has no room for it.
    pub(super) legend: Option<Rect>,
    pub(super) axis_left: Option<u16>,
    pub(super) axis_below: Option<u16>,
    pub(super) labels_below: Option<u16>,
    pub(super) x_ticks: Ticks,
    pub(super) y_ticks: Ticks,
}

pub(super) fn frame_of(chart: &Chart<'_>, title: String) -> PaneFrame<'static> {
    PaneFrame::new(title).focused(chart.focused).frame(chart.frame)
}

/// Computes the layout of a chart inside its frame; `legend_row` requests a separate row for the legend.
pub(super) fn layout(chart: &Chart<'_>, inner: Rect, legend_row: bool) -> Layout {
    let with_legend = legend_row && inner.height >= LEGEND_ROW_FROM;
    let top = u16::from(with_legend);
    let is_stacked = chart.frame != Frame::Boxed;
    let axis = u16::from(inner.height >= AXIS_FROM && !is_stacked);
    let labels = u16::from(inner.height >= LABELS_FROM && !is_stacked);
    let height = inner.height.saturating_sub(top + axis + labels);

    let is_low = is_stacked && (2..LOW).contains(&height) && chart.y.scale == Scale::Linear;
    let lines: Vec<f64> = chart.levels.iter().map(|level| level.at).collect();
    let rows = if is_low { Some(low(&chart.y, height)) } else { chart.y.on_rows(height, &lines) };
    let (y, y_ticks) = rows.unwrap_or_else(|| {
        let along = Along::Rows(half_rows_apart(height));
        (map(&chart.y, height), chart.y.ticks(height, along))
    });

    let gutter = (y_ticks.width() + 1).max(MIN_GUTTER).max(chart.gutter);
    let has_left = inner.width >= gutter.saturating_add(1 + MIN_PLOT_WIDTH);
    let left = if has_left { gutter + 1 } else { 0 };
    let margin = match (is_stacked, has_left) {
        // The last label moves to the left.
        (true, _) => 1,
        (false, true) => {
            let width = inner.width.saturating_sub(left + MARGIN);
            let label = chart.x.ticks(width, Along::Row).width();
            // Labels take at most a quarter of the plot.
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
    // The border lines of stacked charts contain the axis and its labels.
    let line = match chart.frame {
        Frame::Boxed | Frame::Stacked { below: Below::Nothing, .. } => None,
        Frame::Stacked { .. } => Some(inner.bottom()),
    };
    let below = plot.bottom();
    Layout {
        plot,
        x: map(&chart.x, plot.width),
        y,
        gutter,
        inner,
        legend: with_legend.then_some(Rect { height: 1, ..inner }),
        axis_left: has_left.then(|| plot.x - 1),
        axis_below: (axis == 1).then_some(below).or(line),
        labels_below: (labels == 1).then_some(below + 1).or(line),
        x_ticks: chart.x.ticks(plot.width, Along::Row),
        y_ticks,
    }
}

/// Number of rows below which stacked charts show the maximum in the top row.
const LOW: u16 = 5;
/// Maximum distance of a value beyond the centre of the lowest row, in rows, and maximum length of an axis relative to its values.
const IN_LOWEST: f64 = 0.45;
const LONGEST: f64 = 1.2;
/// Resolution of the value of the lowest row, as a fraction of the range.
const PARTS: f64 = 20.0;
/// Maximum number of digits of a label after its first.
const MAX_DIGITS: i32 = 12;

/// Maps the rows of a low chart: the maximum on top, and zero at the centre of a row, else a round number in the lowest row.
fn low(axis: &Axis<'_>, rows: u16) -> (Mapping, Ticks) {
    let (lo, hi) = (axis.view.lo(), axis.view.hi());
    let top = rows.saturating_sub(1);
    let with_zero = |below: u16| {
        let row = hi / f64::from(top - below);
        let is_held = (f64::from(below) + IN_LOWEST) * row >= -lo;
        let is_short = row * f64::from(top) <= LONGEST * (hi - lo);
        (is_held && is_short).then(|| (-f64::from(below) * row, below))
    };
    let zero = if lo <= 0.0 && hi > 0.0 { (0..top).find_map(with_zero) } else { None };
    let factor = axis.unit.factor;
    let step = Step::at_least(axis.view.span() * factor / PARTS);
    let floor = (lo * factor / step.size() + 1e-9).floor() * step.size();
    let from = zero.map_or(floor / factor, |(from, _)| from);
    let map = Mapping::new(axis.scale, ViewRange::new(from, hi), rows);
    let tick = |cell: u16, value: f64, digits: i32| {
        let digits = usize::try_from(digits.clamp(0, MAX_DIGITS)).unwrap_or(0);
        let short: f64 = format!("{value:.digits$e}").parse().unwrap_or(value);
        // Convert -0 to 0.
        Tick { cell, value, label: (short + 0.0).to_string() }
    };
    let (size, span) = (decade(hi.abs() * factor), decade(axis.view.span() * factor));
    let whole = decade(floor.abs()) - step.exponent;
    let lower = zero.map_or_else(|| tick(0, floor, whole), |(_, cell)| tick(cell, 0.0, 0));
    let labelled = vec![lower, tick(top, hi * factor, 2.max(2 + size - span))];
    (map, Ticks { labelled, exponent: 0 })
}

/// Returns the distance between labels in half rows.
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

/// Parts of the title line.
pub(super) struct Plan<'a> {
    pub(super) layout: Layout,
    pub(super) title: String,
    pub(super) right: Line<'a>,
    pub(super) legend: Line<'a>,
}

/// Plans the title line. It contains everything if that fits; else the legend gets its own row if the chart is high enough.
pub(super) fn plan<'a>(chart: &'a Chart<'_>, area: Rect, theme: Theme) -> Plan<'a> {
    let inner = frame_of(chart, String::new()).inner(area);
    let room = usize::from(area.width.saturating_sub(8));
    let entries = legend(chart, theme);
    let full = layout(chart, inner, false);
    if chart.frame != Frame::Boxed {
        return stacked(chart, full, entries, room);
    }
    let axis = |layout: &Layout| chart.x.text(layout.x_ticks.exponent);
    let title = title_text(chart, &full) + &hidden(chart);
    let both = join(line(entries.clone()), axis(&full));
    if Span::raw(&title).width() + both.width() <= room {
        return Plan { layout: full, title, right: both, legend: Line::default() };
    }
    let layout = layout(chart, inner, !entries.is_empty());
    let (title, right) = (title_text(chart, &layout) + &hidden(chart), axis(&layout).into());
    // The row begins one blank after the frame.
    let legend = whole(entries, usize::from(inner.width.saturating_sub(1)));
    Plan { layout, title, right, legend }
}

/// Plans the title line of a chart that shares a box: title with number and unit, then legend and note if they fit.
fn stacked<'a>(
    chart: &'a Chart<'_>,
    layout: Layout,
    entries: Vec<[Span<'a>; 2]>,
    room: usize,
) -> Plan<'a> {
    let unit = &*chart.y.unit.name;
    let has_unit = unit.is_empty() || chart.title.split([' ', ',']).any(|word| word == unit);
    let full = title_text(chart, &layout);
    let is_whole = Span::raw(&full).width() <= room + 3;
    let title = if (has_unit && layout.y_ticks.exponent == 0) || !is_whole {
        chart.title.clone().into_owned()
    } else {
        full
    };
    let title = title + &hidden(chart);
    let room = room.saturating_sub(Span::raw(&title).width());
    let legend = line(entries);
    let both = join(legend.clone(), chart.note.to_string());
    let note = Line::from(chart.note.to_string());
    let right = [both, legend, note].into_iter().find(|line| line.width() <= room);
    Plan { layout, title, right: right.unwrap_or_default(), legend: Line::default() }
}

/// Describes how many points a logarithmic axis cannot represent, for the title.
fn hidden(chart: &Chart<'_>) -> String {
    let points = chart.curves.iter().flat_map(|curve| curve.points.iter());
    let finite = points.filter(|(x, y)| x.is_finite() && y.is_finite());
    match finite.filter(|(x, y)| !(chart.x.scale.shows(*x) && chart.y.scale.shows(*y))).count() {
        0 => String::new(),
        count => format!(" ({count} <= 0 not drawn)"),
    }
}

fn title_text(chart: &Chart<'_>, layout: &Layout) -> String {
    chart.y.after(&chart.title, layout.y_ticks.exponent)
}

/// Returns marker and label of each curve with a label.
fn legend<'a>(chart: &'a Chart<'_>, theme: Theme) -> Vec<[Span<'a>; 2]> {
    let entry = |curve: &Curve<'_>| {
        let old = if curve.emphasis == Emphasis::Stale { " (old)" } else { "" };
        let marker = Span::styled(curve.marker.to_string(), theme.style(role(curve)));
        [marker, Span::raw(format!(" {}{old}", curve.label))]
    };
    let is_shown = |curve: &&Curve<'_>| chart.legend != Legend::Hidden && !curve.label.is_empty();
    chart.curves.iter().filter(is_shown).map(entry).collect()
}

/// Joins entries of a legend with two blanks.
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
    if legend.width() > 0 && !axis.is_empty() {
        legend.push_span("   ");
    }
    legend.push_span(axis);
    legend
}

/// Returns as many complete entries of a legend as fit, and `..` if some are omitted. Numbers must not be cut.
fn whole(mut entries: Vec<[Span<'_>; 2]>, room: usize) -> Line<'_> {
    let all = line(entries.clone());
    if all.width() <= room {
        return all;
    }
    // Two blanks and two points.
    while !entries.is_empty() && line(entries.clone()).width() + 4 > room {
        entries.pop();
    }
    entries.push(["..".into(), Span::default()]);
    line(entries)
}
