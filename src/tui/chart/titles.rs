//! What is written above a plot: title with unit, legend, horizontal axis; and what gives way when the line is too short.

use ratatui::layout::Rect;
use ratatui::text::{Line, Span};

use super::curve::{cell_marker, role};
use super::layout::{self, Layout};
use super::{Chart, Curve, Emphasis, Legend, Side, frame_of, trace};
use crate::report::chart::spaced;
use crate::tui::theme::Theme;

/// What goes where in the title line.
pub(super) struct Plan<'a> {
    /// Where the parts of the chart lie.
    pub(super) layout: Layout,
    /// At the left of the title line.
    pub(super) title: String,
    /// At its right.
    pub(super) right: Line<'a>,
    /// In a row of its own.
    pub(super) legend: Line<'a>,
}

/// Decides what goes where. All in the title line if it fits; else the legend gets a row of its own; else, in a low
/// chart, only the curves' markers stay.
pub(super) fn plan<'a>(chart: &'a Chart<'_>, area: Rect, theme: Theme) -> Plan<'a> {
    let left_out = left_out(chart);
    let inner = frame_of(chart).inner(area);
    let room = usize::from(area.width.saturating_sub(8));
    let legend = legend_line(chart, theme);
    let axis = |layout: &Layout| chart.x.text(layout.x_ticks.exponent);

    let layout = layout::layout(chart, inner, false);
    let title = title_text(chart, &layout, left_out);
    let both = join(legend.clone(), axis(&layout));
    if Span::raw(&title).width() + both.width() <= room {
        return Plan { layout, title, right: both, legend: Line::default() };
    }
    let layout = layout::layout(chart, inner, legend.width() > 0);
    let title = title_text(chart, &layout, left_out);
    let axis = Line::from(axis(&layout));
    let room = room.saturating_sub(Span::raw(&title).width());
    let (right, legend) = if layout.legend.is_some() {
        // The row begins a blank from the frame.
        (axis, whole(legend, usize::from(inner.width.saturating_sub(1))))
    } else if legend.width() > 0 {
        (shortened(legend, room), Line::default())
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
        trace::left_out(curve, chart.x.scale, vertical)
    };
    chart.curves.iter().map(count).sum()
}

fn title_text(chart: &Chart<'_>, layout: &Layout, left_out: usize) -> String {
    let unit = chart.y.unit_text(layout.y_ticks.exponent);
    let mut text = spaced(&chart.title, &unit);
    if let Some(axis) = &chart.right {
        text += ", right: ";
        text += &axis.text(layout.right_ticks.exponent);
    }
    match left_out {
        0 => text,
        1 => text + " (1 point <= 0 not drawn)",
        count => text + &format!(" ({count} points <= 0 not drawn)"),
    }
}

fn legend_line<'a>(chart: &'a Chart<'_>, theme: Theme) -> Line<'a> {
    let mut spans = Vec::new();
    if chart.legend == Legend::Hidden {
        return Line::default();
    }
    for curve in chart.curves.iter().filter(|curve| !curve.label.is_empty()) {
        if !spans.is_empty() {
            spans.push(Span::raw("  "));
        }
        let style = theme.style(role(curve));
        spans.push(Span::styled(cell_marker(curve).to_string(), style));
        let old = match curve.emphasis {
            Emphasis::Stale => " (old)",
            Emphasis::Normal | Emphasis::Selected => "",
        };
        let side = match curve.side {
            Side::Left => "",
            Side::Right => " (right)",
        };
        spans.push(Span::raw(format!(" {}{old}{side}", curve.label)));
    }
    Line::from(spans)
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
fn whole(legend: Line<'_>, room: usize) -> Line<'_> {
    if legend.width() <= room {
        return legend;
    }
    let mut entries: Vec<Vec<Span<'_>>> = vec![Vec::new()];
    for span in legend.spans {
        // Blanks stand between two entries.
        if span.content.trim().is_empty() {
            entries.push(Vec::new());
        } else if let Some(entry) = entries.last_mut() {
            entry.push(span);
        }
    }
    let mut short: Vec<Span<'_>> = Vec::new();
    let mut used = 0;
    for entry in entries {
        let width = entry.iter().map(Span::width).sum::<usize>() + 2;
        if used + width + 2 > room {
            break;
        }
        used += width;
        short.extend(entry);
        short.push(Span::raw("  "));
    }
    short.push(Span::raw(".."));
    Line::from(short)
}

/// The whole legend where it fits, else its markers, as many as there is room for.
fn shortened(legend: Line<'_>, room: usize) -> Line<'_> {
    if legend.width() <= room {
        return legend;
    }
    let markers = legend.spans.iter().filter(|span| span.width() == 1);
    let mut short: Vec<Span<'_>> = Vec::new();
    for marker in markers {
        if short.len() + 2 > room {
            break;
        }
        short.push(marker.clone());
    }
    Line::from(short)
}
