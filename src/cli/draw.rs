//! Pictures as plain text: what the workbench draws, for pipes, logs and screen readers.

use std::fmt::Write as _;

use crate::model::units::significant;
use crate::report::chart::{self, Chart, Line};
use crate::report::map::{Cell, Map};
use crate::report::svg::Picture;
use crate::tui::chart::{
    self as drawn, Axis, Curve, EventLine, HeatCell, Heatmap, Legend, Level, Levels, Scale, Unit,
    ViewRange,
};
use crate::tui::theme::{Role, Theme};

/// Columns and rows.
pub(super) type Size = (u16, u16);

/// Rows of a chart and of a map on a page of 80 columns.
const CHART: Size = (78, 16);
const MAP: Size = (78, 26);

/// A picture on a page.
pub(super) fn picture(picture: &Picture) -> String {
    match picture {
        Picture::Chart(it) => chart(it, CHART, Theme::PLAIN),
        Picture::Map(it) => map(it, MAP, Theme::PLAIN),
    }
}

/// A chart; its vertical axis is named by its title.
pub(super) fn chart(chart: &Chart, (width, height): Size, theme: Theme) -> String {
    let curves = chart.curves.iter().enumerate().map(|(number, curve)| {
        Curve::new(curve.letter, curve.name.as_str(), &curve.points).colour(number)
    });
    let is_named = chart.curves.iter().any(|curve| !curve.name.is_empty());
    let mark = |line: &Line| EventLine { x: line.at, tag: line.tag.clone().into() };
    let level = |line: &Line| Level { y: line.at, tag: line.tag.clone().into() };
    let drawn = drawn::Chart {
        legend: if is_named { Legend::Shown } else { Legend::Hidden },
        events: chart.marks.iter().map(mark).collect(),
        levels: chart.levels.iter().map(level).collect(),
        ..drawn::Chart::new(
            chart.title.as_str(),
            axis(&chart.x, &chart.x.label),
            axis(&chart.y, ""),
            curves.collect(),
        )
    };
    drawn.to_lines(width, height, theme).join("\n") + "\n"
}

/// A map, the key of its bands, and what its letters mean.
pub(super) fn map(map: &Map, (width, height): Size, theme: Theme) -> String {
    let Some(levels) = Levels::of(Scale::Linear, map.values()) else {
        return format!("{}: no value\n", map.title);
    };
    let cell = |column: usize, row: usize| match map.cell(column, row) {
        Cell::Value(value) => HeatCell::Value(value),
        Cell::Mark(letter) => HeatCell::Mark(letter, Role::Dim),
        Cell::Empty => HeatCell::Empty,
    };
    let heatmap = Heatmap {
        title: format!("{}, up: {}", map.title, map.y.label).into(),
        x: axis(&map.x, &map.x.label),
        y: axis(&map.y, &map.y.label),
        counts: map.counts,
        cell: &cell,
        levels: &levels,
        contour: map.contour.as_ref().map(|(value, _)| *value),
        cursor: None,
        focused: false,
    };
    let mut text = heatmap.to_lines(width, height, theme).join("\n") + "\n";
    let range = ViewRange::of(Scale::Linear, map.values()).unwrap_or_default();
    let unit = Unit::with_prefix(range.size(), &map.unit);
    text += &key(&levels, &unit, usize::from(width));
    if let Some((_, name)) = &map.contour {
        let _ = writeln!(text, "  O {name}");
    }
    for (letter, words) in &map.marks {
        let _ = writeln!(text, "  {letter} {words}");
    }
    text
}

fn axis<'a>(axis: &'a chart::Axis, label: &'a str) -> Axis<'a> {
    let unit = Unit::with_prefix(axis.size, &axis.unit);
    Axis::new(label, ViewRange::new(axis.low, axis.high)).scale(axis.scale).unit(unit)
}

/// The bands of a map with their bounds.
fn key(levels: &Levels, unit: &Unit<'_>, width: usize) -> String {
    let mut parts = vec!["  scale".to_owned()];
    for band in 0..levels.bands() {
        let (from, _) = levels.band(band);
        let (symbol, _) = drawn::heatmap::swatch(band, levels.bands(), Theme::PLAIN);
        parts.push(format!("  {} [{symbol}]", significant(from * unit.factor, 4)));
    }
    let (_, top) = levels.band(levels.bands() - 1);
    let top = format!("  {} {}", significant(top * unit.factor, 4), unit.name);
    parts.push(top.trim_end().to_owned());
    let mut lines = vec![String::new()];
    for part in parts {
        let fits = lines.last().is_some_and(|line| line.len() + part.len() <= width);
        match lines.last_mut() {
            Some(line) if fits => line.push_str(&part),
            _ => lines.push(format!("       {part}")),
        }
    }
    lines.join("\n") + "\n"
}
