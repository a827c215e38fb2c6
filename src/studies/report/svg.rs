//! Charts and maps as SVG: light ground, axis titles with units, a legend; one picture or several under each other.

use std::fmt::Write as _;

use crate::report::chart::ticks::Along;
use crate::report::chart::{Axis, Chart, Curve, Mark};
use crate::report::map::Map;
use crate::report::series::thinned;
use crate::study::statistics::sorted_by;

mod bands;

/// Size of one picture.
const WIDTH: f64 = 640.0;
const HEIGHT: f64 = 400.0;
/// Room around the plot.
const LEFT: f64 = 72.0;
const RIGHT: f64 = 24.0;
const BOTTOM: f64 = 52.0;
const TOP: f64 = 34.0;
/// Room beyond a plot for the width of a line along its edge.
const EDGE: f64 = 2.0;
/// Height of a line of the legend, and about how wide a letter is.
const LEGEND_LINE: f64 = 18.0;
const LETTER: f64 = 7.0;
/// Marks that are nearer to each other share a name.
const MARKS_NEAR: f64 = 13.0;
/// Size of a cell, where ticks are chosen by the cells that their labels take; half rows between two labels above each other.
const CELL: (f64, f64) = (LETTER, 16.0);
const HALF_ROWS: u16 = 4;
/// Colours of curves, to be distinguished by the colour-blind too (Okabe and Ito).
const COLOURS: [&str; 7] =
    ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"];
/// A chart or a map.
#[derive(Clone, Debug, PartialEq)]
pub enum Picture {
    /// A chart.
    Chart(Chart<'static>),
    /// A map.
    Map(Map<'static>),
}

/// Drawing as SVG.
pub trait Svg {
    /// Returns the SVG elements of the drawing, without the enclosing `svg` element.
    fn svg(&self) -> String;
}

impl Svg for Picture {
    fn svg(&self) -> String {
        match self {
            Self::Chart(chart) => chart.svg(),
            Self::Map(map) => map.svg(),
        }
    }
}

impl Svg for Chart<'_> {
    fn svg(&self) -> String {
        draw_chart(self)
    }
}

impl Svg for Map<'_> {
    fn svg(&self) -> String {
        bands::draw_map(self)
    }
}

/// A whole SVG file of some drawn pictures, each under the other.
pub fn file(drawn: &[String]) -> String {
    format!("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{}", element(drawn))
}

/// Encloses drawings in an `svg` element for an HTML page.
pub fn element(drawn: &[String]) -> String {
    let height = HEIGHT * drawn.len().max(1) as f64;
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{height}\" viewBox=\"0 0 {WIDTH} {height}\" \
         font-family=\"sans-serif\" font-size=\"13\">\n<rect width=\"{WIDTH}\" height=\"{height}\" fill=\"#ffffff\"/>\n"
    );
    for (number, picture) in drawn.iter().enumerate() {
        let top = HEIGHT * number as f64;
        let _ = writeln!(out, "<g transform=\"translate(0 {top})\">\n{picture}</g>");
    }
    out + "</svg>\n"
}

/// Text as it stands in XML; characters that XML does not allow are removed.
pub fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            '\n' | '\t' => out.push(c),
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => {}
            c => out.push(c),
        }
    }
    out
}

/// The place of the plot within its picture, and its axes.
#[derive(Clone, Copy)]
struct Plot<'a> {
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
    x: &'a Axis<'a>,
    y: &'a Axis<'a>,
}

impl<'a> Plot<'a> {
    /// The plot over these axes, from a height on, with this room at the right.
    fn new(x: &'a Axis<'a>, y: &'a Axis<'a>, top: f64, room: f64) -> Self {
        Self { left: LEFT, right: WIDTH - room, top, bottom: HEIGHT - BOTTOM, x, y }
    }

    fn across(&self, value: f64) -> f64 {
        self.left + part(self.x, value) * (self.right - self.left)
    }

    fn up(&self, value: f64) -> f64 {
        self.bottom - part(self.y, value) * (self.bottom - self.top)
    }

    /// An upright line.
    fn upright(&self, x: f64) -> [Point; 2] {
        [(x, self.top), (x, self.bottom)]
    }

    /// A level line.
    fn level(&self, y: f64) -> [Point; 2] {
        [(self.left, y), (self.right, y)]
    }
}

/// A place in a picture: to the right, and down.
type Point = (f64, f64);

/// How far along an axis a value lies; a little beyond its ends at most.
fn part(axis: &Axis<'_>, value: f64) -> f64 {
    let (low, high) = (axis.scale.place(axis.view.lo()), axis.scale.place(axis.view.hi()));
    ((axis.scale.place(value) - low) / (high - low)).clamp(-10.0, 11.0)
}

/// A number of a picture: no more digits than can be seen.
fn at(value: f64) -> String {
    let text = format!("{value:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// A text at a place that is its `anchor`; `rest` are further attributes.
fn text(out: &mut String, (x, y): Point, anchor: &str, rest: &str, text: &str) {
    let (x, y, text) = (at(x), at(y), escaped(text));
    let _ = writeln!(out, "<text x=\"{x}\" y=\"{y}\" text-anchor=\"{anchor}\"{rest}>{text}</text>");
}

fn stroke(out: &mut String, [from, to]: [Point; 2], style: &str) {
    let (x1, y1, x2, y2) = (at(from.0), at(from.1), at(to.0), at(to.1));
    let _ = writeln!(out, "<line x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\" {style}/>");
}

/// Title, frame, ticks and the titles of the axes.
fn draw_frame(out: &mut String, plot: Plot<'_>, title: &str) {
    let (x, y) = (plot.x, plot.y);
    let middle = f64::midpoint(plot.left, plot.right);
    text(out, (LEFT, 20.0), "start", " font-weight=\"bold\"", title);
    let cells = |length: f64, cell: f64| format!("{:.0}", length / cell).parse().unwrap_or(0);
    let across = x.ticks(cells(plot.right - plot.left, CELL.0), Along::Row);
    let up = y.ticks(cells(plot.bottom - plot.top, CELL.1), Along::Column(HALF_ROWS));
    let grid = "stroke=\"#dddddd\"";
    for tick in &across.labelled {
        let place = plot.across(tick.value / x.unit.factor);
        stroke(out, plot.upright(place), grid);
        text(out, (place, plot.bottom + 17.0), "middle", "", &tick.label);
    }
    for tick in &up.labelled {
        let place = plot.up(tick.value / y.unit.factor);
        stroke(out, plot.level(place), grid);
        text(out, (plot.left - 6.0, place + 4.5), "end", "", &tick.label);
    }
    text(out, (middle, plot.bottom + 38.0), "middle", "", &x.text(across.exponent));
    // The title of the vertical axis is turned.
    let place = (16.0, f64::midpoint(plot.top, plot.bottom));
    text(out, place, "middle", &turned(place), &y.text(up.exponent));
}

/// The attribute of a text that stands upright at a place.
fn turned((x, y): Point) -> String {
    format!(" transform=\"rotate(-90 {} {})\"", at(x), at(y))
}

fn frame(out: &mut String, plot: Plot<'_>) {
    let _ = writeln!(
        out,
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#333333\"/>",
        at(plot.left),
        at(plot.top),
        at(plot.right - plot.left),
        at(plot.bottom - plot.top)
    );
}

/// The rows of a legend: which curves stand in each.
fn legend_rows(curves: &[Curve<'_>]) -> Vec<Vec<usize>> {
    let mut rows: Vec<Vec<usize>> = Vec::new();
    let mut used = f64::INFINITY;
    for (number, curve) in curves.iter().enumerate().filter(|(_, curve)| !curve.label.is_empty()) {
        let width = 40.0 + LETTER * curve.label.chars().count() as f64;
        if used + width > WIDTH - LEFT - RIGHT {
            rows.push(Vec::new());
            used = 0.0;
        }
        used += width;
        if let Some(row) = rows.last_mut() {
            row.push(number);
        }
    }
    rows
}

fn colour(number: usize) -> &'static str {
    COLOURS[number % COLOURS.len()]
}

fn draw_chart(chart: &Chart<'_>) -> String {
    let mut out = String::new();
    let rows = legend_rows(&chart.curves);
    let top = TOP + LEGEND_LINE * rows.len() as f64;
    let plot = Plot::new(&chart.x, &chart.y, top, RIGHT);
    draw_frame(&mut out, plot, &chart.title);
    for (row, numbers) in rows.iter().enumerate() {
        let y = TOP + LEGEND_LINE * row as f64 + 4.0;
        let mut x = LEFT;
        for number in numbers {
            let curve = &chart.curves[*number];
            let ink = colour(curve.colour);
            if curve.is_dotted() {
                dot(&mut out, (x + 11.0, y - 4.0), ink);
            } else {
                let style = format!("stroke=\"{ink}\" stroke-width=\"2\"");
                stroke(&mut out, [(x, y - 4.0), (x + 22.0, y - 4.0)], &style);
            }
            text(&mut out, (x + 28.0, y), "start", "", &curve.label);
            x += 40.0 + LETTER * curve.label.chars().count() as f64;
        }
    }
    draw_lines(&mut out, plot, chart);
    // What lies outside the plot is cut off.
    let (x, y) = (at(plot.left - EDGE), at(plot.top - EDGE));
    let width = at(plot.right - plot.left + 2.0 * EDGE);
    let height = at(plot.bottom - plot.top + 2.0 * EDGE);
    let _ = writeln!(
        out,
        "<svg x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" viewBox=\"{x} {y} {width} {height}\">"
    );
    for curve in &chart.curves {
        draw_curve(&mut out, plot, curve, colour(curve.colour));
    }
    out.push_str("</svg>\n");
    frame(&mut out, plot);
    out
}

fn dot(out: &mut String, (x, y): Point, ink: &str) {
    let _ = writeln!(out, "<circle cx=\"{}\" cy=\"{}\" r=\"3\" fill=\"{ink}\"/>", at(x), at(y));
}

fn draw_curve(out: &mut String, plot: Plot<'_>, curve: &Curve<'_>, ink: &str) {
    let (x, y) = (plot.x, plot.y);
    let place = |(at_x, at_y)| {
        let is_shown = x.scale.shows(at_x) && y.scale.shows(at_y);
        is_shown.then(|| (plot.across(at_x), plot.up(at_y)))
    };
    let places: Vec<Option<Point>> =
        thinned(curve.points.to_vec()).into_iter().map(place).collect();
    for piece in places.split(Option::is_none) {
        match piece {
            [] => {}
            [place] => place.iter().for_each(|place| dot(out, *place, ink)),
            _ => {
                let points = piece.iter().flatten().map(|(x, y)| format!("{},{}", at(*x), at(*y)));
                let points = points.collect::<Vec<_>>().join(" ");
                let style = format!("stroke=\"{ink}\" stroke-width=\"2\"");
                let _ = writeln!(out, "<polyline points=\"{points}\" fill=\"none\" {style}/>");
            }
        }
    }
}

/// Lines to read the curves by, with their names.
fn draw_lines(out: &mut String, plot: Plot<'_>, chart: &Chart<'_>) {
    let dashed = "stroke=\"#777777\" stroke-dasharray=\"4 3\"";
    let small = " font-size=\"11\" fill=\"#555555\"";
    let marks = chart.marks.iter().filter(|it| chart.x.scale.shows(it.at));
    let marks = marks.filter(|mark| (0.0..=1.0).contains(&part(&chart.x, mark.at)));
    let marks = sorted_by(marks.collect(), |mark| mark.at);
    let near = |a: &&Mark<'_>, b: &&Mark<'_>| plot.across(b.at) - plot.across(a.at) < MARKS_NEAR;
    for group in marks.chunk_by(near) {
        for mark in group {
            stroke(out, plot.upright(plot.across(mark.at)), dashed);
        }
        let names: Vec<&str> = group.iter().map(|mark| &*mark.name).collect();
        let x = plot.across(group.first().map_or(0.0, |mark| mark.at));
        // At the right edge the name stands before its line.
        let x = if x > plot.right - MARKS_NEAR { x - 5.0 } else { x + 11.0 };
        let place = (x, plot.top + 6.0);
        text(out, place, "end", &format!("{small}{}", turned(place)), &names.join(", "));
    }
    for level in &chart.levels {
        if !chart.y.scale.shows(level.at) || !(0.0..=1.0).contains(&part(&chart.y, level.at)) {
            continue;
        }
        let y = plot.up(level.at);
        stroke(out, plot.level(y), dashed);
        text(out, (plot.right - 4.0, y - 4.0), "end", small, &level.name);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::chart::Scale;

    #[test]
    fn a_file_is_xml_whatever_the_texts_are() {
        let points =
            vec![(0.0, 0.0), (0.4, f64::NAN), (0.5, 0.5), (0.6, 0.7), (1.0, f64::INFINITY)];
        let axis = || Axis::over("x", "m", Scale::Linear, [0.0, 1.0]).unwrap();
        let chart = Chart {
            marks: vec![Mark::new(0.5, "a < b & \"c\"\u{1b}[2J")],
            levels: vec![Mark::new(0.5, "'yield'")],
            ..Chart::new("<b>title</b> & more", axis(), axis(), vec![Curve::new('*', "", points)])
        };
        let text = file(&[chart.svg()]);
        let read = roxmltree::Document::parse(&text).unwrap();
        let texts: Vec<&str> = read.descendants().filter_map(|node| node.text()).collect();
        assert!(texts.contains(&"<b>title</b> & more") && texts.contains(&"a < b & \"c\"[2J"));
        // The gap leaves a single point and a line of two.
        let count = |name: &str| read.descendants().filter(|node| node.has_tag_name(name)).count();
        assert_eq!((count("circle"), count("polyline")), (1, 1));
        assert!(!text.contains("NaN") && !text.contains("inf"));
    }
}
