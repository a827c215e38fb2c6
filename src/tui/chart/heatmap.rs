//! A heat map: two axes, a colour or character for each band of values, marks where there is no value, one contour, a cursor.
//!
//! ```text
//! +- percent of baseline: k [MN/m] --------- gamma +
//! |  7.5+##############@@@@@@@@@@@@@@@@@@@@@@@@@   |    bands of round bounds, darkest least
//! |     |***OOOO######|####@@@@@@@@@@@@@@@@@@@@@   |    O the contour
//! |  5.0+*****OOOO####|########@@@@@@@@@@@@@@@@@   |
//! |     |-+-+-+-+OOOO-X-#-#-#-#-#-#-#-@-@-@-@-@-   |    X the cursor
//! |  2.5++++*****OOOO#|############@@@@@@@@@@@@@   |
//! |     |+++++*****OOO|O#################@@@@@@@   |
//! |    0+PPPPPP+*****O|OOOO###################@@   |    P a mark: no number
//! |     ++------+------+------+------+------+----  |
//! |      1      2      3      4      5      6      |
//! +------------------------------------------------+
//! ```
//!
//! Colour is never the only channel: bands differ in their characters wherever there are fewer than 256 colours, and the scale is
//! written below the map. Frame, axes and ticks are the chart's own.

use ratatui::buffer::Buffer;
use ratatui::layout::{Offset, Position, Rect};
use ratatui::style::{Color, Modifier, Style};

use super::{Chart, Draw, Layout, Mapping};
use crate::tui::theme::colours::ink_on;
use crate::tui::theme::{GlyphSet, Role, Theme, columns};
use cmra_studies::report::chart::levels::BANDS_MAX;
use cmra_studies::report::map::{Cell, Map, Tone};

/// Relative difference from the contour level below which values are treated as equal.
const NOISE: f64 = 1e-9;

/// Characters of the bands, in ascending order.
const RAMP: [char; BANDS_MAX] = [' ', '.', ':', '-', '=', '+', '*', '#', '%', '@'];

impl Draw for Map<'_> {
    fn render(&self, area: Rect, buffer: &mut Buffer, theme: Theme) -> Layout {
        let chart = Chart {
            focused: self.focused,
            ..Chart::new(&*self.title, self.x.clone(), self.y.clone(), Vec::new())
        };
        let layout = chart.render(area, buffer, theme);
        let plot = layout.plot;
        if plot.is_empty() {
            return layout;
        }
        draw_bands(self, &layout, buffer, theme);
        draw_contour(self, &layout, buffer);
        draw_labels(self, &layout, buffer);
        if let Some((point, letter)) = self.present {
            put(buffer, place(self, &layout, point), letter, theme.style(Role::Title));
        }
        draw_cursor(self, &layout, buffer);
        layout
    }
}

/// Returns the cell of the map that a cell of the screen shows.
fn shown(map: &Map<'_>, layout: &Layout, at: Position) -> Cell {
    let plot = layout.plot;
    let x = spread(at.x - plot.x, plot.width, map.counts.0);
    let value = layout.y.value(plot.bottom() - 1 - at.y);
    upward(map).cell(value).map_or(Cell::Empty, |y| map.cell(x, y.into()))
}

/// Returns the vertical mapping of a map's points.
fn upward(map: &Map<'_>) -> Mapping {
    let count = u16::try_from(map.counts.1).unwrap_or(u16::MAX);
    Mapping::new(map.y.scale, map.y.view, count)
}

fn draw_bands(map: &Map<'_>, layout: &Layout, buffer: &mut Buffer, theme: Theme) {
    for at in layout.plot.positions() {
        let (symbol, style) = match (shown(map, layout, at), &map.levels) {
            (Cell::Value(value), Some(levels)) => {
                swatch(levels.index(value), levels.bands(), theme)
            }
            (Cell::Mark(letter, tone), _) => (letter, theme.style(role(tone))),
            (Cell::Value(_) | Cell::Empty, _) => (' ', Style::new()),
        };
        put(buffer, at, symbol, style);
    }
}

/// Draws the contour: cells on the other side of the level than a neighbour, on the side nearer to the level.
fn draw_contour(map: &Map<'_>, layout: &Layout, buffer: &mut Buffer) {
    let plot = layout.plot;
    let Some(level) = map.contour.as_ref().map(|contour| contour.0) else { return };
    let value = |at: Position| match shown(map, layout, at) {
        Cell::Value(value) => Some(value - level),
        Cell::Mark(..) | Cell::Empty => None,
    };
    for at in plot.positions() {
        let Some(here) = value(at) else { continue };
        let is_crossed = |other: f64| {
            let changes = (here < 0.0) != (other < 0.0);
            // Values that differ by rounding error only have no contour between them.
            changes && here.abs() <= other.abs() && (here - other).abs() > NOISE * level.abs()
        };
        let beside = [(-1, 0), (1, 0), (0, -1), (0, 1)].map(|(x, y)| at + Offset::new(x, y));
        let beside = beside.into_iter().filter(|at| plot.contains(*at));
        if beside.filter_map(value).any(is_crossed) {
            over(buffer, at, 'O');
        }
    }
}

/// Draws each label where its value is crossed, in a separate row, at the free position nearest to the middle.
fn draw_labels(map: &Map<'_>, layout: &Layout, buffer: &mut Buffer) {
    let plot = layout.plot;
    let cross = map.cursor.map(|point| place(map, layout, point));
    let present = map.present.map(|(point, _)| place(map, layout, point));
    let mut rows: Vec<u16> = Vec::new();
    for (bound, text) in &map.labels {
        let width = u16::try_from(columns(text)).unwrap_or(u16::MAX);
        let is_below = |at: Position| match shown(map, layout, at) {
            Cell::Value(value) => Some(value < *bound),
            Cell::Mark(..) | Cell::Empty => None,
        };
        let is_crossed = |at: &Position| {
            at.x + 1 < plot.right()
                && match (is_below(*at), is_below(*at + Offset::new(1, 0))) {
                    (Some(left), Some(right)) => left != right,
                    _ => false,
                }
        };
        let has_room = |at: &Position| {
            let around = (at.x.saturating_sub(1)..=at.x + width, at.y);
            let covers = |point: Position| point.y == around.1 && around.0.contains(&point.x);
            at.x + width < plot.right()
                && rows.iter().all(|row| row.abs_diff(at.y) > 1)
                && cross.is_none_or(|cross| cross.y != at.y && !around.0.contains(&cross.x))
                && !present.is_some_and(covers)
        };
        let far = |at: &Position| {
            let middle = (plot.left() + plot.width / 2, plot.top() + plot.height / 2);
            at.x.abs_diff(middle.0) / 2 + at.y.abs_diff(middle.1)
        };
        let places = plot.positions().filter(is_crossed).filter(has_room);
        let Some(at) = places.min_by_key(far) else { continue };
        rows.push(at.y);
        for (column, letter) in (at.x..).zip(text.chars()) {
            over(buffer, Position { x: column, ..at }, letter);
        }
    }
}

/// Draws the cursor: a cross, and alternate cells of its row and column.
fn draw_cursor(map: &Map<'_>, layout: &Layout, buffer: &mut Buffer) {
    let (Some(point), plot) = (map.cursor, layout.plot) else { return };
    let cross = place(map, layout, point);
    let row = (plot.left()..plot.right()).map(|x| Position { x, ..cross });
    for at in row.filter(|at| at.x % 2 == cross.x % 2 && *at != cross) {
        over(buffer, at, '─');
    }
    let column = (plot.top()..plot.bottom()).map(|y| Position { y, ..cross });
    for at in column.filter(|at| *at != cross) {
        over(buffer, at, '│');
    }
    put(buffer, cross, 'X', Style::new().add_modifier(Modifier::REVERSED | Modifier::BOLD));
}

/// Returns the point displayed in a cell of an axis.
fn spread(cell: u16, cells: u16, count: usize) -> usize {
    let last = usize::from(cells.max(1)) - 1;
    rounded(usize::from(cell) * (count - 1), last).min(count - 1)
}

/// Returns the cell of a point.
fn place(map: &Map<'_>, layout: &Layout, (x, y): (usize, usize)) -> Position {
    let plot = layout.plot;
    let last = usize::from(plot.width.max(1)) - 1;
    let column = u16::try_from(rounded(x * last, map.counts.0 - 1)).unwrap_or(u16::MAX);
    let value = upward(map).value(u16::try_from(y).unwrap_or(u16::MAX));
    let up = layout.y.cell(value).unwrap_or(0);
    Position::new(plot.x + column, (plot.bottom() - 1).saturating_sub(up))
}

fn rounded(numerator: usize, denominator: usize) -> usize {
    if denominator == 0 { 0 } else { (2 * numerator + denominator) / (2 * denominator) }
}

pub fn role(tone: Tone) -> Role {
    match tone {
        Tone::Faint => Role::Dim,
        Tone::Plain => Role::Text,
        Tone::Warning => Role::Warning,
        Tone::Error => Role::Error,
    }
}

/// Returns the character and style of a band, also for the scale beside the map.
pub fn swatch(band: usize, bands: usize, theme: Theme) -> (char, Style) {
    let shade = shade(band, bands);
    let Some((colour, ink)) = theme.heat(shade) else {
        return (RAMP[shade], Style::new());
    };
    let symbol = if theme.glyphs == GlyphSet::Ascii { RAMP[shade] } else { ' ' };
    (symbol, Style::new().bg(colour).fg(ink))
}

/// Returns the index of a band in the ramp; few bands are spread over the whole ramp.
fn shade(band: usize, bands: usize) -> usize {
    let last = RAMP.len() - 1;
    if bands < 2 { last / 2 } else { rounded(band.min(bands - 1) * last, bands - 1) }
}

fn put(buffer: &mut Buffer, at: Position, symbol: char, style: Style) {
    if let Some(cell) = buffer.cell_mut(at) {
        cell.reset();
        cell.set_char(symbol).set_style(style);
    }
}

/// Draws a character over the map: keeps the background and chooses a readable foreground.
fn over(buffer: &mut Buffer, at: Position, symbol: char) {
    let Some(cell) = buffer.cell_mut(at) else { return };
    let below = cell.bg;
    let mut style = Style::new().add_modifier(Modifier::BOLD);
    if below != Color::Reset {
        style = style.bg(below).fg(ink_on(below));
    }
    cell.reset();
    cell.set_char(symbol).set_style(style);
}

#[cfg(test)]
mod tests {
    use super::super::{Axis, Levels, ViewRange};
    use super::*;
    use cmra_studies::report::map::MapMark;

    #[test]
    fn no_contour_runs_between_values_equal_within_rounding() {
        let flat = |x: usize, y: usize| Cell::Value(100.0 + ((x * 7 + y * 3) % 5) as f64 * 2e-14);
        let axis = Axis::new("x", ViewRange::new(0.0, 10.0));
        let levels = Levels::from_values([0.0, 110.0]);
        let map = Map {
            contour: Some((100.0 + 3e-14, MapMark::new('O', ""))),
            ..Map::new("flat", (axis.clone(), axis), (11, 6), levels, flat)
        };
        let text = map.to_lines(29, 10, Theme::PLAIN).join("\n");
        assert!(!text.contains('O'), "{text}");
    }

    #[test]
    fn points_and_cells_correspond() {
        for (width, height, count) in
            [(11, 6, 2), (16, 7, 3), (101, 49, 41), (60, 60, 60), (9, 9, 5)]
        {
            let axis = Axis::new("x", ViewRange::new(0.8, 7.0));
            let cell = |x: usize, y: usize| Cell::Value((x * 100 + y) as f64);
            let levels = Levels::from_values([0.0, 1.0]);
            let map = Map::new("map", (axis.clone(), axis), (count, count), levels, cell);
            let area = Rect::new(0, 0, width + 12, height + 4);
            let layout = map.render(area, &mut Buffer::empty(area), Theme::PLAIN);
            for index in (0..count).filter(|_| usize::from(layout.plot.width) >= count) {
                let at = place(&map, &layout, (index, index));
                let Cell::Value(found) = shown(&map, &layout, at) else { panic!("{index}") };
                assert_eq!((found / 100.0).floor().to_bits(), (index as f64).to_bits());
                // A point higher or lower only where rows are fewer than points, or not half a row apart.
                let row = layout.y.value(1) - layout.y.value(0);
                let apart = 6.2 / (count - 1) as f64;
                assert!((found % 100.0 - index as f64).abs() * apart <= 0.5 * row + 0.5 * apart);
            }
        }
    }
}
