//! A sweep as a page of text: charts over one axis, maps over two, where every output is least and greatest, how points ended.

use std::fmt::Write as _;
use std::ops::Range;

use crate::model::results::ResultColumn;
use crate::model::units::{self, Engineering};
use crate::study::sweep::grid::tells;
use crate::study::sweep::{Axis, Design, Fate, Plan, Rows, Spacing, Summary};
use crate::tui::chart::{
    self, Chart, Curve, Heatmap, Legend, Levels, Scale, Spot, Unit, ViewRange,
};
use crate::tui::theme::{Role, Theme};

const WIDTH: u16 = 78;
const CHART_HEIGHT: u16 = 16;
const MAP_HEIGHT: u16 = 26;
/// Most rows of the table of one axis.
const TABLE_ROWS: u64 = 13;
/// Points kept to be drawn; larger sweeps are only summed up.
const KEPT_MAX: u64 = 250_000;

/// What stands above the page.
pub(super) struct Head<'a> {
    pub(super) name: &'a str,
    pub(super) threads: usize,
    pub(super) took_s: f64,
}

/// The rows to draw, where there are few enough and the whole grid is there.
pub(super) struct Kept(Option<Vec<Row>>);

/// What became of a point, and its outputs.
type Row = (Fate, Vec<Option<f64>>);

impl Kept {
    pub(super) fn of(plan: &Plan, points: Range<u64>) -> Self {
        let whole = points == (0..plan.points());
        let drawable = plan.design() == Design::Factorial && plan.axes().len() <= 2;
        Self((whole && drawable && plan.points() <= KEPT_MAX).then(Vec::new))
    }

    pub(super) fn keep(&mut self, rows: &Rows) {
        let Some(kept) = &mut self.0 else { return };
        for row in 0..rows.len() {
            let outputs = (0..rows.outputs()).map(|output| rows.value(row, output)).collect();
            kept.push((rows.fate(row), outputs));
        }
    }

    /// All rows of a sweep that has been made to its end.
    fn whole(&self, plan: &Plan) -> Option<&[Row]> {
        self.0.as_deref().filter(|rows| rows.len() as u64 == plan.points())
    }
}

/// The page.
pub(super) fn text(plan: &Plan, head: &Head<'_>, summary: &Summary, kept: &Kept) -> String {
    let axes: Vec<String> = plan.axes().iter().map(axis_words).collect();
    let design = match plan.design() {
        Design::Factorial => "every combination".to_owned(),
        Design::LatinHypercube { seed, .. } => format!("Latin hypercube, seed {seed}"),
        Design::Sobol { seed, .. } => format!("Sobol's sequence, seed {seed}"),
    };
    let mut page = format!("{}: {}\n", head.name, axes.join("; "));
    let _ = writeln!(
        page,
        "{} points ({design}) in {} on {} thread{}\n",
        summary.points(),
        duration(head.took_s),
        head.threads,
        if head.threads == 1 { "" } else { "s" }
    );
    match (plan.axes(), kept.whole(plan)) {
        ([x], Some(rows)) => {
            for output in 0..plan.outputs().len() {
                curve(&mut page, plan, x, output, rows);
            }
            table(&mut page, plan, x, rows);
        }
        ([x, y], Some(rows)) => {
            for output in 0..plan.outputs().len() {
                map(&mut page, plan, (x, y), output, rows);
            }
        }
        (_, _) => {}
    }
    extremes(&mut page, plan, summary);
    let _ = writeln!(page, "\n{}", summary.words());
    page
}

fn axis_words(axis: &Axis) -> String {
    if axis.spacing() == Spacing::Listed {
        let unit = axis.variable().unit().trim_start_matches('-');
        let values = format!("{} = {} {unit}", axis.symbol(), axis.range().replace(',', ", "));
        return format!("{}, {} points", values.trim_end(), axis.count());
    }
    let (from, to) = axis.ends();
    let unit = axis.variable().unit().trim_start_matches('-');
    let log = if axis.spacing() == Spacing::Log { " at equal ratios" } else { "" };
    let ends = format!("{} to {} {unit}", units::shortest(from), units::shortest(to));
    format!("{} {}{log}, {} points", axis.symbol(), ends.trim_end(), axis.count())
}

fn scale(axis: &Axis) -> Scale {
    match axis.spacing() {
        Spacing::Linear | Spacing::Listed => Scale::Linear,
        Spacing::Log => Scale::Log10,
    }
}

/// An axis of the plan as one of a chart.
fn chart_axis(axis: &Axis) -> chart::Axis<'static> {
    let (from, to) = axis.ends();
    let view = ViewRange::new(from, to);
    let unit = axis.variable().unit().trim_start_matches('-');
    chart::Axis::new(axis.symbol(), view).scale(scale(axis)).unit(Unit::with_prefix(view, unit))
}

/// The number to draw of a row, if one tells anything.
fn shown(row: &Row, output: usize, column: &ResultColumn) -> Option<f64> {
    row.1[output].filter(|_| tells(column, row.0))
}

fn curve(page: &mut String, plan: &Plan, axis: &Axis, output: usize, rows: &[Row]) {
    let column = plan.outputs()[output];
    let values = || rows.iter().map(|row| shown(row, output, column).unwrap_or(f64::NAN));
    let Some(range) = ViewRange::of(Scale::Linear, values()) else {
        let _ = writeln!(page, "{}: exists nowhere on this axis\n", column.title());
        return;
    };
    let mut points: Vec<(f64, f64)> = (0..).map(|index| axis.value(index)).zip(values()).collect();
    if axis.spacing() == Spacing::Listed {
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
    }
    let view = range.padded(Scale::Linear, 0.05);
    let y = chart::Axis::new("", view).unit(Unit::with_prefix(range, column.unit()));
    let curve = Curve::new('*', "", &points);
    let chart = Chart {
        legend: Legend::Hidden,
        ..Chart::new(column.title(), chart_axis(axis), y, vec![curve])
    };
    lines(page, &chart.to_lines(WIDTH, CHART_HEIGHT, Theme::PLAIN));
    let gone = rows.iter().filter(|row| shown(row, output, column).is_none()).count();
    if gone > 0 {
        let _ = writeln!(page, "{gone} of {} points have no such value: gaps", rows.len());
    }
    page.push('\n');
}

fn lines(page: &mut String, lines: &[String]) {
    for line in lines {
        page.push_str(line);
        page.push('\n');
    }
}

fn table(page: &mut String, plan: &Plan, axis: &Axis, rows: &[Row]) {
    let mut head = format!("{:>12}  {:<10}", axis.symbol(), "outcome");
    for column in plan.outputs() {
        let _ = write!(head, "  {:>24}", column.name);
    }
    let _ = writeln!(page, "{}", head.trim_end());
    let last = axis.count() - 1;
    // Evenly spread, where the number of points allows it.
    let even = (5..TABLE_ROWS).rev().find(|steps| last.is_multiple_of(*steps));
    let count = even.map_or_else(|| TABLE_ROWS.min(axis.count()), |steps| steps + 1);
    for index in (0..count).map(|row| row * last / (count - 1)) {
        let Some(row) = usize::try_from(index).ok().and_then(|index| rows.get(index)) else {
            continue;
        };
        let _ =
            write!(page, "{:>12}  {:<10}", units::significant(axis.value(index), 6), row.0.word());
        for value in &row.1 {
            let text = value.map_or_else(|| "-".to_owned(), |value| units::significant(value, 7));
            let _ = write!(page, "  {text:>24}");
        }
        page.push('\n');
    }
    page.push('\n');
}

fn map(page: &mut String, plan: &Plan, (x, y): (&Axis, &Axis), output: usize, rows: &[Row]) {
    let column = plan.outputs()[output];
    let values = || rows.iter().filter_map(|row| shown(row, output, column));
    let places = (places(x), places(y));
    let counts = (places.0.len(), places.1.len());
    let Some(levels) = Levels::of(Scale::Linear, values()) else {
        let _ = writeln!(page, "{}: exists nowhere on this grid\n", column.title());
        return;
    };
    let up = as_index(y.count());
    let spot = |at_x: usize, at_y: usize| {
        let row = &rows[places.0[at_x] * up + places.1[at_y]];
        let mark = || Spot::Mark(row.0.letter(), Role::Dim);
        shown(row, output, column).map_or_else(mark, Spot::Value)
    };
    let map = Heatmap {
        title: format!("{}, up: {}", column.title(), y.symbol()).into(),
        x: chart_axis(x),
        y: chart_axis(y),
        counts,
        spot: &spot,
        levels: &levels,
        contour: None,
        cursor: None,
        focused: false,
    };
    lines(page, &map.to_lines(WIDTH, MAP_HEIGHT, Theme::PLAIN));
    let range = ViewRange::of(Scale::Linear, values()).unwrap_or_default();
    let unit = Unit::with_prefix(range, column.unit());
    page.push_str(&key(&levels, unit.factor, &unit.name));
    let mut marks: Vec<(char, &str)> = rows
        .iter()
        .filter(|row| shown(row, output, column).is_none())
        .map(|row| (row.0.letter(), row.0.without_value(column)))
        .collect();
    marks.sort_unstable();
    marks.dedup();
    for (letter, words) in marks {
        let _ = writeln!(page, "  {letter} {words}");
    }
    page.push('\n');
}

/// The bands of a map with their bounds, times a factor, in a unit.
pub(in crate::cli) fn key(levels: &Levels, factor: f64, unit: &str) -> String {
    let mut line = "  scale".to_owned();
    for band in 0..levels.bands() {
        let (from, _) = levels.band(band);
        let (symbol, _) = chart::heatmap::swatch(band, levels.bands(), Theme::PLAIN);
        let _ = write!(line, "  {} [{symbol}]", units::significant(from * factor, 4));
    }
    let (_, top) = levels.band(levels.bands() - 1);
    let _ = writeln!(line, "  {} {unit}", units::significant(top * factor, 4));
    line
}

/// Cells of a map along an axis whose values are a list.
const LIST_CELLS: u64 = 60;

/// The point that each cell of a map shows, from the least value of an axis to the greatest: the point itself, or the nearest one
/// of a list.
fn places(axis: &Axis) -> Vec<usize> {
    let (from, to) = axis.ends();
    if axis.spacing() == Spacing::Listed {
        let last = (LIST_CELLS - 1) as f64;
        let value = |cell: u64| from + (to - from) * cell as f64 / last;
        return (0..LIST_CELLS).map(|cell| as_index(axis.nearest(value(cell)))).collect();
    }
    let rising = 0..as_index(axis.count());
    if from > to { rising.rev().collect() } else { rising.collect() }
}

fn as_index(count: u64) -> usize {
    usize::try_from(count).unwrap_or(usize::MAX)
}

fn extremes(page: &mut String, plan: &Plan, summary: &Summary) {
    for (column, extremes) in plan.outputs().iter().zip(&summary.extremes) {
        let Some(extremes) = extremes else {
            let _ = writeln!(page, "{}: no value", column.title());
            continue;
        };
        for (word, (value, point)) in [("least", extremes.least), ("greatest", extremes.greatest)] {
            let place: Vec<String> = (0..plan.axes().len())
                .map(|axis| {
                    let value = units::significant(plan.coordinate(point, axis), 5);
                    format!("{}={value}", plan.axes()[axis].symbol())
                })
                .collect();
            let value = match column.unit() {
                "" => units::significant(value, 6),
                "%" => format!("{} %", units::fixed_significant(value, 5)),
                unit => Engineering { value, unit, digits: 5 }.to_string(),
            };
            let _ = writeln!(page, "{word:<8} {}  {value} at {}", column.title(), place.join(" "));
        }
    }
}

/// A time as a person says it: `0.31 s`, `12 min`, `5.2 h`.
pub(in crate::cli) fn duration(seconds: f64) -> String {
    let (value, unit) = match seconds {
        s if s < 60.0 => return Engineering { value: s, unit: "s", digits: 2 }.to_string(),
        s if s < 5400.0 => (s / 60.0, "min"),
        s if s < 172_800.0 => (s / 3600.0, "h"),
        s => (s / 86_400.0, "days"),
    };
    format!("{} {unit}", units::significant(value, 2))
}
