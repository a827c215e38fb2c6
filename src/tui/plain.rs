//! Pictures as plain text, as drawn by the workbench, for pipes, logs and screen readers.

use std::fmt::Write as _;

use crate::tui::chart::{Draw, heatmap::swatch};
use crate::tui::theme::Theme;
use cmra_engine::model::units::significant;
use cmra_studies::report::chart::levels::Levels;
use cmra_studies::report::chart::{Chart, Scale, Unit, ViewRange};
use cmra_studies::report::map::Map;
use cmra_studies::report::svg::Picture;

/// Number of columns and rows.
pub(crate) type Size = (u16, u16);

/// Size of a chart and of a map on a page of 80 columns.
const CHART: Size = (78, 16);
pub(crate) const MAP: Size = (78, 26);

/// Draws a picture within this width.
pub(crate) fn within(picture: &Picture, width: u16) -> String {
    match picture {
        Picture::Chart(it) => chart(it, (CHART.0.min(width), CHART.1), Theme::PLAIN),
        Picture::Map(it) => map(it, (MAP.0.min(width), MAP.1)),
    }
}

/// Draws a chart; its title names the vertical axis.
pub(crate) fn chart(chart: &Chart<'_>, (width, height): Size, theme: Theme) -> String {
    chart.to_lines(width, height, theme).join("\n") + "\n"
}

/// Draws a map with the scale of its bands and the meanings of its letters.
pub(crate) fn map(map: &Map<'_>, (width, height): Size) -> String {
    let title = format!("{}, up: {}", map.title, map.y.label).into();
    let drawn = Map { title, ..map.clone() };
    let mut text = drawn.to_lines(width, height, Theme::PLAIN).join("\n") + "\n";
    if let Some(levels) = &map.levels {
        let range = ViewRange::from_values(Scale::Linear, map.values()).unwrap_or_default();
        let unit = Unit::with_prefix(range.size(), map.unit);
        text += &key(levels, &unit, usize::from(width));
    }
    if let Some((_, mark)) = &map.contour {
        let _ = writeln!(text, "  {mark}");
    }
    for mark in &map.marks {
        let _ = writeln!(text, "  {mark}");
    }
    text
}

fn key(levels: &Levels, unit: &Unit<'_>, width: usize) -> String {
    let mut parts = vec!["  scale".to_owned()];
    for band in 0..levels.bands() {
        let (from, _) = levels.band(band);
        let (symbol, _) = swatch(band, levels.bands(), Theme::PLAIN);
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
