//! Maps: bands of colour, letters where there is no value, contours, and the key beside them.

use std::fmt::Write as _;

use super::{Plot, RIGHT, TOP, at, draw_frame, frame, text};
use crate::report::chart::levels::Levels;
use crate::report::chart::{Axis, Unit};
use crate::report::map::{Cell, Map};
use cmra_engine::model::units;

/// Room of the legend of a map, at its right.
const SCALE_WIDTH: f64 = 92.0;
/// Letters for which that has room.
const NOTE_COLUMNS: usize = 18;
/// Colours of a map from its least to its greatest value (viridis).
const BANDS: [(u8, u8, u8); 6] =
    [(68, 1, 84), (65, 68, 135), (42, 120, 142), (34, 168, 132), (122, 209, 81), (253, 231, 37)];

fn band_colour(number: usize, count: usize) -> String {
    let place = (number as f64 + 0.5) / count as f64 * (BANDS.len() - 1) as f64;
    let lower = (0..BANDS.len() - 2).rev().find(|at| *at as f64 <= place).unwrap_or(0);
    let fraction = place - lower as f64;
    let (from, to) = (BANDS[lower], BANDS[lower + 1]);
    let mix = |from: u8, to: u8| f64::from(from) + fraction * (f64::from(to) - f64::from(from));
    let (red, green, blue) = (mix(from.0, to.0), mix(from.1, to.1), mix(from.2, to.2));
    format!("rgb({red:.0},{green:.0},{blue:.0})")
}

/// An axis with half a cell beyond both ends: the first value lies in the middle of the first cell, the last one in that of the last.
fn widened<'a>(axis: &Axis<'a>, count: usize) -> Axis<'a> {
    axis.clone().padded(0.5 / (count.max(2) - 1) as f64)
}

/// Width and height of a point of a map.
fn size_of_point(plot: Plot<'_>, map: &Map<'_>) -> (f64, f64) {
    let [columns, rows] = [map.counts.0, map.counts.1].map(|count| count.max(1) as f64);
    ((plot.right - plot.left) / columns, (plot.bottom - plot.top) / rows)
}

pub(super) fn draw_map(map: &Map<'_>) -> String {
    let mut out = String::new();
    let (columns, rows) = map.counts;
    let (x, y) = (widened(&map.x, columns), widened(&map.y, rows));
    let plot = Plot::new(&x, &y, TOP, RIGHT + SCALE_WIDTH);
    draw_frame(&mut out, plot, &map.title);
    let levels = map.levels.as_ref();
    let count = levels.map_or(0, Levels::bands);
    let (width, height) = size_of_point(plot, map);
    out.push_str("<g shape-rendering=\"crispEdges\">\n");
    for row in 0..rows {
        let bottom = plot.bottom - height * row as f64;
        let ink = |column: usize| match map.cell(column, row) {
            Cell::Value(value) if value.is_finite() => levels.map(|levels| levels.index(value)),
            _ => None,
        };
        let inks: Vec<(usize, Option<usize>)> =
            (0..columns).map(|column| (column, ink(column))).collect();
        // Neighbours of one colour are one rectangle, a hair larger so that no gap is seen between them.
        for run in inks.chunk_by(|a, b| a.1 == b.1) {
            let (Some((first, Some(band))), length) = (run.first(), run.len()) else { continue };
            let _ = writeln!(
                out,
                "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>",
                at(plot.left + width * *first as f64),
                at(bottom - height),
                at(width * length as f64 + 0.3),
                at(height + 0.3),
                band_colour(*band, count)
            );
        }
    }
    out.push_str("</g>\n");
    draw_letters(&mut out, plot, map);
    if let Some((value, _)) = &map.contour {
        let path = contour(plot, map, *value);
        // White below black: seen on every colour.
        for ink in
            ["stroke=\"#ffffff\" stroke-width=\"4\"", "stroke=\"#000000\" stroke-width=\"2\""]
        {
            let _ = writeln!(out, "<path d=\"{path}\" fill=\"none\" {ink}/>");
        }
    }
    frame(&mut out, plot);
    draw_key(&mut out, plot, map, levels);
    out
}

/// Letters of points without a value, so many that they can be read.
fn draw_letters(out: &mut String, plot: Plot<'_>, map: &Map<'_>) {
    let ((columns, rows), (width, height)) = (map.counts, size_of_point(plot, map));
    let every =
        |size: f64| (1..100_usize).find(|number| size * *number as f64 >= 16.0).unwrap_or(100);
    let grey = " font-size=\"10\" fill=\"#777777\"";
    for row in (0..rows).step_by(every(height)) {
        for column in (0..columns).step_by(every(width)) {
            let Cell::Mark(letter, _) = map.cell(column, row) else { continue };
            let x = plot.left + width * (column as f64 + 0.5);
            let y = plot.bottom - height * (row as f64 + 0.5) + 3.5;
            text(out, (x, y), "middle", grey, &letter.to_string());
        }
    }
}

/// The bands with their bounds, what the letters mean, and the contour.
fn draw_key(out: &mut String, plot: Plot<'_>, map: &Map<'_>, levels: Option<&Levels>) {
    let count = levels.map_or(0, Levels::bands);
    let (left, room) = (plot.right + 14.0, 16.0);
    let bands = levels.into_iter().flat_map(|it| (0..count).map(|band| it.band(band)));
    let bands: Vec<(f64, f64)> = bands.collect();
    let size = bands.iter().fold(0.0_f64, |size, band| size.max(band.0.abs()).max(band.1.abs()));
    let Unit { factor, name: unit } = Unit::with_prefix(size, map.unit);
    let mut y = plot.top + 8.0;
    if !unit.is_empty() {
        text(out, (left, y), "start", "", &format!("[{unit}]"));
        y += 8.0;
    }
    let number = |out: &mut String, y: f64, bound: f64| {
        let (place, shown) = ((left + 21.0, y + 4.0), units::significant(bound * factor, 4));
        text(out, place, "start", " font-size=\"11\"", &shown);
    };
    for (band, (_, bound)) in bands.iter().enumerate().rev() {
        let (x, top, ink) = (at(left), at(y), band_colour(band, count));
        let size = format!("width=\"16\" height=\"{room}\"");
        let _ = writeln!(out, "<rect x=\"{x}\" y=\"{top}\" {size} fill=\"{ink}\"/>");
        number(out, y, *bound);
        y += room;
    }
    if let Some((bound, _)) = bands.first() {
        number(out, y, *bound);
    }
    y += 14.0;
    let mut notes: Vec<String> = Vec::new();
    notes.extend(map.contour.iter().map(|(_, mark)| format!("— {}", mark.meaning())));
    notes.extend(map.marks.iter().map(ToString::to_string));
    for note in notes {
        for line in textwrap::wrap(&note, NOTE_COLUMNS) {
            y += 13.0;
            text(out, (left, y), "start", " font-size=\"10\"", &line);
        }
    }
}

/// The line on which a map has a value: in each square of four points straight from side to side.
fn contour(plot: Plot<'_>, map: &Map<'_>, value: f64) -> String {
    let ((columns, rows), (width, height)) = (map.counts, size_of_point(plot, map));
    let mut path = String::new();
    for row in 0..rows.saturating_sub(1) {
        for column in 0..columns.saturating_sub(1) {
            let corners = [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(right, up)| {
                let over = match map.cell(column + right, row + up) {
                    Cell::Value(found) => found - value,
                    Cell::Mark(..) | Cell::Empty => f64::NAN,
                };
                (column as f64 + right as f64 + 0.5, row as f64 + up as f64 + 0.5, over)
            });
            if corners.iter().any(|(_, _, over)| !over.is_finite()) {
                continue;
            }
            let crossing = |side: usize| {
                let ((x, y, over), (to_x, to_y, to)) = (corners[side], corners[(side + 1) % 4]);
                let fraction = over / (over - to);
                ((over > 0.0) != (to > 0.0)).then(|| {
                    let (x, y) = (x + fraction * (to_x - x), y + fraction * (to_y - y));
                    (plot.left + width * x, plot.bottom - height * y)
                })
            };
            let crossings: Vec<(f64, f64)> = (0..4).filter_map(crossing).collect();
            for pair in crossings.chunks_exact(2) {
                let ((x1, y1), (x2, y2)) = (pair[0], pair[1]);
                let _ = write!(path, "M{} {}L{} {}", at(x1), at(y1), at(x2), at(y2));
            }
        }
    }
    path
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::chart::Scale;
    use crate::report::map::{MapMark, Tone};
    use crate::report::svg::{LEFT, Svg, WIDTH, file};

    #[test]
    fn a_map_has_its_bands_its_letters_and_its_contour() {
        // The value is the column: the contour at 1.5 is upright, between the second and the third column.
        let cell = |column: usize, row: usize| match (column, row) {
            (3, 2) => Cell::Mark('P', Tone::Error),
            _ => Cell::Value(column as f64),
        };
        let axis = |high| Axis::over("x", "m", Scale::Linear, [0.0, high]).unwrap();
        let axes = (axis(3.0), axis(2.0));
        let map = Map {
            contour: Some((1.5, MapMark::new('O', "line"))),
            marks: vec![MapMark::new('P', "perforated")],
            ..Map::new("map", axes, (4, 3), Levels::from_values([0.0, 3.0]), cell)
        };
        let text = file(&[map.svg()]);
        let read = roxmltree::Document::parse(&text).unwrap();
        let path = read.descendants().find(|node| node.has_tag_name("path")).unwrap();
        let width = WIDTH - LEFT - RIGHT - SCALE_WIDTH;
        let x = at(LEFT + width / 4.0 * 2.0);
        let places = path.attribute("d").unwrap().split(['M', 'L']).filter(|it| !it.is_empty());
        assert!(places.clone().count() == 4);
        for place in places {
            assert_eq!(place.split(' ').next(), Some(x.as_str()), "{text}");
        }
        assert!(text.contains(">P</text>") && text.contains(">P perforated</text>"));
    }
}
