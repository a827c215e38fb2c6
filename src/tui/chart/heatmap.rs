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

/// Values nearer to each other, relative to the contour's, are the same.
const NOISE: f64 = 1e-9;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Color, Modifier, Style};

use super::{Chart, Draw, Layout};
use crate::report::chart::levels::BANDS_MAX;
use crate::report::map::{Cell, Map, Tone};
use crate::tui::theme::colours::ink_on;
use crate::tui::theme::{GlyphSet, Role, Theme};

/// The bands in characters, least first.
const RAMP: [char; BANDS_MAX] = [' ', '.', ':', '-', '=', '+', '*', '#', '%', '@'];

impl Draw for Map<'_> {
    fn render(&self, area: Rect, buffer: &mut Buffer, theme: Theme) -> Layout {
        let chart = Chart {
            focused: self.focused,
            ..Chart::new(&*self.title, self.x.clone(), self.y.clone(), Vec::new())
        };
        let layout = chart.render(area, buffer, theme);
        if layout.plot.is_empty() {
            return layout;
        }
        draw_bands(self, layout.plot, buffer, theme);
        draw_contour(self, layout.plot, buffer);
        draw_present(self, layout.plot, buffer, theme);
        draw_cursor(self, layout.plot, buffer);
        layout
    }
}

fn draw_bands(map: &Map<'_>, plot: Rect, buffer: &mut Buffer, theme: Theme) {
    for row in 0..plot.height {
        for column in 0..plot.width {
            let x = spread(column, plot.width, map.counts.0);
            let cell = map.cell(x, spread_up(row, plot, map.counts.1));
            let (symbol, style) = match (cell, &map.levels) {
                (Cell::Value(value), Some(levels)) => {
                    swatch(levels.index(value), levels.bands(), theme)
                }
                (Cell::Mark(letter, tone), _) => (letter, theme.style(role(tone))),
                (Cell::Value(_) | Cell::Empty, _) => (' ', Style::new()),
            };
            put(buffer, (plot.x + column, plot.y + row), symbol, style);
        }
    }
}

/// Cells whose value and a neighbour's lie on different sides of the contour, on the nearer side.
fn draw_contour(map: &Map<'_>, plot: Rect, buffer: &mut Buffer) {
    let Some(level) = map.contour.as_ref().map(|contour| contour.0) else { return };
    // Where all values are the same but for rounding there is no line between them.
    let noise = NOISE * level.abs();
    let value = |column: u16, row: u16| {
        let x = spread(column, plot.width, map.counts.0);
        match map.cell(x, spread_up(row, plot, map.counts.1)) {
            Cell::Value(value) => Some(value - level),
            Cell::Mark(..) | Cell::Empty => None,
        }
    };
    for row in 0..plot.height {
        for column in 0..plot.width {
            let Some(here) = value(column, row) else { continue };
            let crossed = |other: Option<f64>| {
                other.is_some_and(|other| {
                    (here < 0.0) != (other < 0.0)
                        && here.abs() <= other.abs()
                        && (here - other).abs() > noise
                })
            };
            let beside = [
                column.checked_sub(1).map(|column| (column, row)),
                (column + 1 < plot.width).then_some((column + 1, row)),
                row.checked_sub(1).map(|row| (column, row)),
                (row + 1 < plot.height).then_some((column, row + 1)),
            ];
            if beside.into_iter().flatten().any(|(column, row)| crossed(value(column, row))) {
                over(buffer, (plot.x + column, plot.y + row), 'O');
            }
        }
    }
}

/// The point to be seen.
fn draw_present(map: &Map<'_>, plot: Rect, buffer: &mut Buffer, theme: Theme) {
    if let Some((point, letter)) = map.present {
        let (column, row) = place(plot, point, map.counts);
        put(buffer, (plot.x + column, plot.y + row), letter, theme.style(Role::Title));
    }
}

/// Its row and column, every other cell, and a cross.
fn draw_cursor(map: &Map<'_>, plot: Rect, buffer: &mut Buffer) {
    let Some((x, y)) = map.cursor else { return };
    let (column, row) = place(plot, (x, y), map.counts);
    for other in (0..plot.width).filter(|other| (other % 2 == column % 2) && *other != column) {
        over(buffer, (plot.x + other, plot.y + row), '─');
    }
    for other in (0..plot.height).filter(|other| *other != row) {
        over(buffer, (plot.x + column, plot.y + other), '│');
    }
    let cross = (plot.x + column, plot.y + row);
    put(buffer, cross, 'X', Style::new().add_modifier(Modifier::REVERSED | Modifier::BOLD));
}

/// The point a row of a plot shows, of `count` spread upward over its rows.
fn spread_up(row: u16, plot: Rect, count: usize) -> usize {
    spread(plot.height.saturating_sub(1).saturating_sub(row), plot.height, count)
}

/// The point a column shows.
fn spread(column: u16, columns: u16, count: usize) -> usize {
    let last = usize::from(columns.max(1)) - 1;
    rounded(usize::from(column) * (count - 1), last).min(count - 1)
}

/// A point's column and row, from the top.
fn place(plot: Rect, (x, y): (usize, usize), counts: (usize, usize)) -> (u16, u16) {
    let along = |at: usize, count: usize, cells: u16| {
        let last = usize::from(cells.max(1)) - 1;
        u16::try_from(rounded(at * last, count - 1)).unwrap_or(u16::MAX)
    };
    let up = along(y, counts.1, plot.height);
    (along(x, counts.0, plot.width), plot.height.saturating_sub(1).saturating_sub(up))
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

/// A band's character and style; also for the scale beside the map.
pub fn swatch(band: usize, bands: usize, theme: Theme) -> (char, Style) {
    let shade = shade(band, bands);
    let Some((colour, ink)) = theme.heat(shade) else {
        return (RAMP[shade], Style::new());
    };
    let symbol = if theme.glyphs == GlyphSet::Ascii { RAMP[shade] } else { ' ' };
    (symbol, Style::new().bg(colour).fg(ink))
}

/// The band's place in the ramp: few bands are spread over all of it.
fn shade(band: usize, bands: usize) -> usize {
    let last = RAMP.len() - 1;
    if bands < 2 { last / 2 } else { rounded(band.min(bands - 1) * last, bands - 1) }
}

fn put(buffer: &mut Buffer, at: (u16, u16), symbol: char, style: Style) {
    if let Some(cell) = buffer.cell_mut(at) {
        cell.reset();
        cell.set_char(symbol).set_style(style);
    }
}

/// A character over the map: the colour below stays, the ink is what can be read on it.
fn over(buffer: &mut Buffer, at: (u16, u16), symbol: char) {
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

    #[test]
    fn no_contour_runs_between_values_equal_within_rounding() {
        let flat = |x: usize, y: usize| Cell::Value(100.0 + ((x * 7 + y * 3) % 5) as f64 * 2e-14);
        let axis = Axis::new("x", ViewRange::new(0.0, 10.0));
        let levels = Levels::of([0.0, 110.0]);
        let map = Map {
            contour: Some((100.0 + 3e-14, "".into())),
            ..Map::new("flat", (axis.clone(), axis), (11, 6), levels, flat)
        };
        let text = map.to_lines(29, 10, Theme::PLAIN).join("\n");
        assert!(!text.contains('O'), "{text}");
    }

    #[test]
    fn points_and_cells_correspond() {
        for (cells, count) in [(2, 2), (7, 3), (41, 101), (101, 41), (60, 60), (1, 5)] {
            let plot = Rect::new(0, 0, cells, cells);
            for index in 0..count {
                let (column, row) = place(plot, (index, index), (count, count));
                if usize::from(cells) >= count {
                    assert_eq!(spread(column, cells, count), index);
                    assert_eq!(spread_up(row, plot, count), index);
                }
            }
            assert_eq!(spread(0, cells, count), 0);
            if cells > 1 {
                assert_eq!(spread(cells - 1, cells, count), count - 1);
            }
        }
    }
}
