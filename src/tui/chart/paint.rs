//! Drawing of a chart's layout into cells: axes, reference and event lines, then curves, then the crosshair.

use ratatui::buffer::Buffer;
use ratatui::style::{Modifier, Style};
use ratatui::text::Span;

use super::canvas::{Canvas, role, trace};
use super::layout::Layout;
use crate::tui::theme::{GlyphSet, Role, Theme};
use cmra_studies::report::chart::ticks::label_start;
use cmra_studies::report::chart::{Chart, Curve, Emphasis, Frame, Mark};

/// Character of vertical dotted lines (events).
const EVENT: char = ':';
/// Character of horizontal dotted lines (levels).
const LEVEL: char = '·';

/// Columns between markers of a curve if curves differ by colour.
const MARKER_EVERY: usize = 18;
/// Shift of the markers of successive curves, in columns, so that they do not overlap.
const MARKER_SHIFT: usize = 5;

/// Draws everything inside the frame.
pub(super) fn paint(chart: &Chart<'_>, layout: &Layout, buffer: &mut Buffer, theme: Theme) {
    if layout.plot.width == 0 || layout.plot.height == 0 {
        return;
    }
    let mut painter = Painter { chart, layout, buffer, theme };
    painter.vertical_axis();
    painter.horizontal_axis();
    painter.levels();
    painter.events();
    painter.curves();
    painter.event_tags();
    painter.level_tags();
}

struct Painter<'a> {
    chart: &'a Chart<'a>,
    layout: &'a Layout,
    buffer: &'a mut Buffer,
    theme: Theme,
}

impl Painter<'_> {
    fn put(&mut self, x: u16, y: u16, character: char, style: Style) {
        if let Some(cell) = self.buffer.cell_mut((x, y)) {
            cell.set_char(character).set_style(style);
        }
    }

    /// Returns `true` if a cell contains at most a dotted line.
    fn is_free(&self, at: (u16, u16), dotted: char) -> bool {
        let symbol = self.buffer.cell(at).map_or("", |cell| cell.symbol());
        symbol == " " || symbol.chars().eq([dotted])
    }

    /// Returns the screen row of a plot cell counted upward.
    fn row(&self, cell: u16) -> u16 {
        self.layout.plot.bottom() - 1 - cell
    }

    fn vertical_axis(&mut self) {
        let Some(x) = self.layout.axis_left else { return };
        let plot = self.layout.plot;
        let style = self.theme.style(Role::Border);
        for y in plot.top()..plot.bottom() {
            self.put(x, y, '│', style);
        }
        for tick in &self.layout.y_ticks.labelled {
            let y = self.row(tick.cell);
            self.put(x, y, '┤', style);
            let width = u16::try_from(tick.label.len()).unwrap_or(u16::MAX);
            let from = x.saturating_sub(width);
            let text = self.theme.style(Role::Text);
            self.buffer.set_string(from, y, &tick.label, text);
        }
    }

    fn horizontal_axis(&mut self) {
        let Some(y) = self.layout.axis_below else { return };
        if self.chart.frame != Frame::Boxed {
            return self.axis_in_line(y);
        }
        let plot = self.layout.plot;
        let style = self.theme.style(Role::Border);
        for x in plot.left()..plot.right() {
            self.put(x, y, '─', style);
        }
        if let Some(x) = self.layout.axis_left {
            self.put(x, y, '└', style);
        }
        for tick in &self.layout.x_ticks.labelled {
            self.put(plot.x + tick.cell, y, '┬', style);
        }
        self.labels_below(self.layout.inner.left(), 0);
    }

    /// Draws the line below a stacked chart, with numbers at the positions of ticks and the unit at the right end.
    fn axis_in_line(&mut self, y: u16) {
        let style = self.theme.style(Role::Border);
        if let Some(x) = self.layout.axis_left {
            self.put(x, y, '┴', style);
        }
        let unit = self.chart.x.unit_text(self.layout.x_ticks.exponent);
        let unit = format!(" {} ", unit.trim_matches(['[', ']']));
        let taken = u16::try_from(Span::raw(&unit).width()).unwrap_or(u16::MAX);
        let inner = self.layout.inner;
        let text = self.theme.style(Role::Text);
        if taken > 2 && taken < inner.width {
            self.buffer.set_string(inner.right() - taken, y, &unit, text);
        }
        self.labels_below(self.layout.axis_left.map_or_else(|| inner.left(), |x| x + 1), taken);
    }

    /// Draws labels starting at a column, each centred under its tick, shifted if necessary to stay inside the frame and left of `taken`
    /// columns. Omits labels without room but keeps their ticks.
    fn labels_below(&mut self, from: u16, taken: u16) {
        let Some(y) = self.layout.labels_below else { return };
        let (inner, style) = (self.layout.inner, self.theme.style(Role::Text));
        let (earliest, mut free_from) = (i32::from(inner.left()), i32::from(from));
        for tick in &self.layout.x_ticks.labelled {
            let length = i32::try_from(tick.label.len()).unwrap_or(i32::MAX / 2);
            let centre = i32::from(self.layout.plot.x + tick.cell);
            let latest = i32::from(inner.right()) - i32::from(taken) - length;
            let start = label_start(centre, length).min(latest).max(earliest);
            let has_room = start >= free_from && start <= centre && start <= latest;
            if let Some(x) = u16::try_from(start).ok().filter(|_| has_room) {
                self.buffer.set_string(x, y, &tick.label, style);
                free_from = start + length + 1;
            }
        }
    }

    fn levels(&mut self) {
        let plot = self.layout.plot;
        let style = self.theme.style(Role::Event);
        for level in &self.chart.levels {
            let Some(cell) = self.layout.y.cell(level.at) else { continue };
            let y = self.row(cell);
            for x in (plot.left()..plot.right()).step_by(2) {
                self.put(x, y, LEVEL, style);
            }
        }
    }

    /// Draws the tags of levels, each as far right as possible without meeting a curve; omits tags without room.
    fn level_tags(&mut self) {
        let plot = self.layout.plot;
        let style = self.theme.style(Role::Event);
        for level in self.chart.levels.iter().filter(|level| !level.tag.is_empty()) {
            let Some(cell) = self.layout.y.cell(level.at) else { continue };
            let y = self.row(cell);
            let is_free = |x: u16| self.is_free((x, y), LEVEL);
            // A blank separates the tag from the dots.
            let tag = format!(" {}", level.tag);
            let length = u16::try_from(Span::raw(&tag).width()).unwrap_or(u16::MAX);
            let starts = plot.left()..plot.right().saturating_sub(length.saturating_sub(1));
            let free = starts.rev().find(|start| (*start..start + length).all(is_free));
            if let Some(x) = free {
                let end = x + length;
                let behind = if end < plot.right() && is_free(end) { " " } else { "" };
                self.buffer.set_string(x, y, tag + behind, style);
            }
        }
    }

    fn events(&mut self) {
        let plot = self.layout.plot;
        let style = self.theme.style(Role::Event);
        for event in &self.chart.marks {
            let Some(cell) = self.layout.x.cell(event.at) else { continue };
            for y in plot.top()..plot.bottom() {
                self.put(plot.x + cell, y, EVENT, style);
            }
        }
    }

    /// Draws the tags of events, each in the highest row that no curve passes.
    fn event_tags(&mut self) {
        let plot = self.layout.plot;
        let style = self.theme.style(Role::Event);
        let cell = |event: &Mark<'_>| Some(plot.x + self.layout.x.cell(event.at)?);
        let events = self.chart.marks.iter().filter(|event| !event.tag.is_empty());
        let mut tags: Vec<(u16, &str)> =
            events.filter_map(|event| Some((cell(event)?, &*event.tag))).collect();
        tags.sort_by_key(|(x, _)| *x);
        tags.dedup_by_key(|(x, _)| *x);
        for (index, (x, tag)) in tags.iter().enumerate() {
            // Keep a blank before the next tag, unless the two are neighbours.
            let next = tags.get(index + 1);
            let end = next.map_or_else(|| plot.right(), |(next, _)| next.saturating_sub(1));
            let width = u16::try_from(Span::raw(*tag).width()).unwrap_or(u16::MAX);
            // A tag at the right end of the plot begins left of its event. A tag without room before the next one is omitted, because its
            // first letters may have another meaning.
            let x = if next.is_none() { *x.min(&end.saturating_sub(width)) } else { *x };
            if width > 1 && (x < plot.x || x + width > end) {
                continue;
            }
            let mut rows = plot.top()..plot.bottom();
            let row = rows.find(|y| (x..x + width).all(|x| self.is_free((x, *y), EVENT)));
            self.buffer.set_string(x, row.unwrap_or_else(|| plot.top()), tag, style);
        }
    }

    fn curves(&mut self) {
        let plot = self.layout.plot;
        let mut canvas = Canvas::new(self.theme.glyphs, plot.width, plot.height);
        let mut markers = Vec::new();
        let is_line = |curve: &&Curve<'_>| curve.emphasis != Emphasis::Faint || !curve.is_dotted();
        let lines = self.chart.curves.iter().filter(is_line).count();
        for owner in drawing_order(&self.chart.curves) {
            let curve = &self.chart.curves[owner];
            if curve.is_dotted() {
                continue;
            }
            trace(curve, owner, (self.layout.x, self.layout.y), &mut canvas);
            if self.theme.glyphs != GlyphSet::Ascii && lines > 1 {
                place_markers(&canvas, owner, plot.width, &mut markers);
            }
        }
        for at in plot.positions() {
            if let Some((owner, dots)) = canvas.cell(at.x - plot.x, at.y - plot.y) {
                let curve = &self.chart.curves[owner];
                let is_ascii = self.theme.glyphs == GlyphSet::Ascii;
                let character = if is_ascii { curve.marker } else { dots };
                self.put(at.x, at.y, character, self.curve_style(curve));
            }
        }
        for (column, row, owner) in markers {
            let curve = &self.chart.curves[owner];
            self.put(plot.x + column, plot.y + row, curve.marker, self.curve_style(curve));
        }
        self.crosshair(&canvas);
        self.letters();
    }

    /// Draws points without lines: the marker of the curve, for every glyph set.
    fn letters(&mut self) {
        let plot = self.layout.plot;
        let crosshair = self.chart.crosshair.and_then(|x| self.layout.x.cell(x));
        for owner in drawing_order(&self.chart.curves) {
            let curve = &self.chart.curves[owner];
            let is_faint = curve.emphasis == Emphasis::Faint;
            for (x, y) in curve.points.iter().filter(|_| curve.is_dotted()) {
                let cell = self.layout.x.cell(*x).zip(self.layout.y.cell(*y));
                let Some((column, up)) = cell else { continue };
                // Faint points are below everything except dotted lines.
                let at = (plot.x + column, self.row(up));
                if is_faint && !(self.is_free(at, EVENT) || self.is_free(at, LEVEL)) {
                    continue;
                }
                let style = self.curve_style(curve);
                let under = crosshair == Some(column);
                let style = if under { style.add_modifier(Modifier::BOLD) } else { style };
                self.put(plot.x + column, self.row(up), curve.marker, style);
            }
        }
    }

    fn curve_style(&self, curve: &Curve<'_>) -> Style {
        let style = self.theme.style(role(curve));
        let is_selected = curve.emphasis == Emphasis::Selected;
        if is_selected { style.add_modifier(Modifier::BOLD) } else { style }
    }

    /// Draws the crosshair over everything, with the curves' markers at intersections.
    fn crosshair(&mut self, canvas: &Canvas) {
        let plot = self.layout.plot;
        let Some(column) = self.chart.crosshair.and_then(|x| self.layout.x.cell(x)) else {
            return;
        };
        for row in 0..plot.height {
            let (character, style) = match canvas.cell(column, row) {
                Some((owner, _)) => {
                    let curve = &self.chart.curves[owner];
                    let style = self.curve_style(curve).add_modifier(Modifier::BOLD);
                    (curve.marker, style)
                }
                None => ('│', self.theme.style(Role::Crosshair)),
            };
            self.put(plot.x + column, plot.y + row, character, style);
        }
    }
}

/// Returns the drawing order: old curves first, the selected curve last, others as given.
fn drawing_order(curves: &[Curve<'_>]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..curves.len()).collect();
    order.sort_by_key(|at| curves[*at].emphasis as u8);
    order
}

/// Chooses the cells (column, row, owner) that show a curve's marker, so that colour is never the only difference.
fn place_markers(canvas: &Canvas, owner: usize, width: u16, markers: &mut Vec<(u16, u16, usize)>) {
    let middle = |column| Some((column, canvas.middle(column, owner)?, owner));
    let first = owner * MARKER_SHIFT + 3;
    let before = markers.len();
    let columns = (0..width).skip(first % MARKER_EVERY).step_by(MARKER_EVERY);
    markers.extend(columns.filter_map(middle));
    if markers.len() == before {
        let drawn: Vec<_> = (0..width).filter_map(middle).collect();
        markers.extend(drawn.get(drawn.len() / 2));
    }
}
