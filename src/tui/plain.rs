//! Reports and their pictures as lines of text, as the workbench draws them, for pipes, logs and screen readers.

use crate::tui::chart::{Draw, heatmap::swatch};
use crate::tui::theme::{Role, Theme};
use crate::tui::widgets::text::TextLine;
use cmra_engine::model::run::Warning;
use cmra_engine::model::units::significant;
use cmra_studies::report::chart::levels::Levels;
use cmra_studies::report::chart::{Chart, Scale, Unit, ViewRange};
use cmra_studies::report::map::Map;
use cmra_studies::report::page::{Block, Page, Size};
use cmra_studies::report::svg::Picture;
use cmra_studies::report::table::grid;
use cmra_studies::report::wrap::wrap;

/// How a report is written as text.
#[derive(Clone, Copy)]
pub(crate) struct TextStyle {
    /// Number of columns.
    pub width: usize,
    /// Theme of the pictures.
    pub theme: Theme,
    /// Whether each warning has one short line.
    pub is_brief: bool,
}

/// Writes a report as lines of text. Texts are wrapped, wide tables continue below, and pictures are narrowed.
pub(crate) fn lines(page: &Page, style: TextStyle) -> Vec<TextLine> {
    page.blocks.iter().flat_map(|block| block_lines(block, style)).collect()
}

/// Writes a block as lines of text.
pub(crate) fn block_lines(block: &Block, style: TextStyle) -> Vec<TextLine> {
    let width = style.width;
    let all = |role: Role, texts: Vec<String>| texts.into_iter().map(|it| (it, role)).collect();
    let split = |text: &str| text.lines().map(str::to_owned).collect();
    match block {
        Block::Title(text) => all(Role::Title, line(text, width)),
        Block::Heading(text) => all(Role::Title, [vec![String::new()], line(text, width)].concat()),
        Block::Line(text) => all(Role::Text, line(text, width)),
        Block::Fact { remark, column } => {
            let role = if remark.is_caution { Role::Warning } else { Role::Text };
            let column_of_first = if remark.about.is_empty() { 0 } else { *column };
            let lead = format!("{:column_of_first$}", remark.about);
            all(role, hanging(&lead, &remark.text, *column, width))
        }
        Block::Ends(left, right) => {
            let gap = width.saturating_sub(left.chars().count() + right.chars().count()).max(2);
            all(Role::Title, line(&format!("{left}{:gap$}{right}", ""), width))
        }
        Block::Table(columns) => all(Role::Text, split(&grid(columns, width))),
        Block::Picture(picture, size) => {
            let columns = size.0.min(u16::try_from(width).unwrap_or(u16::MAX));
            all(Role::Text, split(&draw(picture, (columns, size.1), style.theme)))
        }
        Block::Warnings(list) => all(Role::Warning, warnings(list, style)),
        Block::Code(text) => all(Role::Text, split(text)),
        Block::Space => vec![(String::new(), Role::Text)],
    }
}

/// Wraps a line; further lines are indented by two more blanks.
fn line(text: &str, width: usize) -> Vec<String> {
    if text.chars().count() <= width {
        return vec![text.to_owned()];
    }
    let (blanks, words) = text.split_at(text.len() - text.trim_start().len());
    let mut parts = wrap(words, width.saturating_sub(blanks.len()));
    let first = parts.swap_remove(0);
    let rest = words[first.len()..].trim_start();
    let further = format!("{blanks}  ");
    let rest = wrap(rest, width.saturating_sub(further.len())).into_iter();
    std::iter::once(format!("{blanks}{first}"))
        .chain(rest.map(|it| further.clone() + &it))
        .collect()
}

/// Wraps a text after its lead; further lines have this indent.
pub(crate) fn hanging(lead: &str, text: &str, indent: usize, width: usize) -> Vec<String> {
    let room = width.saturating_sub(indent.max(lead.chars().count()));
    let mut lines = wrap(&text.replace('\n', " "), room);
    for (at, line) in lines.iter_mut().enumerate() {
        *line = if at == 0 { format!("{lead}{line}") } else { format!("{:indent$}{line}", "") };
    }
    lines
}

/// Formats warnings below a heading, and how to read more about brief ones.
pub(crate) fn warnings(list: &[Warning], style: TextStyle) -> Vec<String> {
    if list.is_empty() {
        return Vec::new();
    }
    let each = |warning: &Warning| {
        let whole = warning.to_string();
        let fits = whole.chars().count() <= style.width.saturating_sub(4);
        let is_whole = !style.is_brief || warning.breach.is_none() && fits;
        let text = if is_whole { whole } else { warning.short() };
        hanging("  ! ", &text, 4, style.width)
    };
    let how = if style.is_brief {
        " (`cmra explain NAME` explains one; --verbose prints them in full)"
    } else {
        ""
    };
    let head = line(&format!("warnings{how}"), style.width);
    std::iter::once(String::new()).chain(head).chain(list.iter().flat_map(each)).collect()
}

/// Draws a picture of this size.
fn draw(picture: &Picture, size: Size, theme: Theme) -> String {
    match picture {
        Picture::Chart(it) => chart(it, size, theme),
        Picture::Map(it) => map(it, size),
    }
}

/// Draws a chart; its title names the vertical axis.
fn chart(chart: &Chart<'_>, (width, height): Size, theme: Theme) -> String {
    chart.to_lines(width, height, theme).join("\n") + "\n"
}

/// Draws a map with the scale of its bands and the meanings of its letters.
fn map(map: &Map<'_>, (width, height): Size) -> String {
    let title = format!("{}, up: {}", map.title, map.y.label).into();
    let drawn = Map { title, ..map.clone() };
    let mut text = drawn.to_lines(width, height, Theme::PLAIN).join("\n") + "\n";
    if let Some(levels) = &map.levels {
        let range = ViewRange::from_values(Scale::Linear, map.values()).unwrap_or_default();
        let unit = Unit::with_prefix(range.size(), map.unit);
        text += &key(levels, &unit, usize::from(width));
    }
    for mark in map.contour.iter().map(|it| &it.1).chain(&map.marks) {
        text += &(line(&format!("  {mark}"), usize::from(width)).join("\n") + "\n");
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

#[cfg(test)]
mod tests {
    use super::*;

    fn text(blocks: Vec<Block>) -> Vec<String> {
        let style = TextStyle { width: 40, theme: Theme::PLAIN, is_brief: false };
        lines(&Page { blocks }, style).into_iter().map(|line| line.0).collect()
    }

    #[test]
    fn long_texts_continue_below_themselves() {
        let words = ["word"; 30].join(" ");
        let mut page = Page::default();
        page.line(words.clone());
        page.line(format!("    {words}"));
        page.fact("  label", 10, words.clone());
        page.paragraph(words.clone(), 3);
        page.push(Block::Ends(words.clone(), "end".to_owned()));
        for (block, indent) in page.blocks.into_iter().zip([2, 6, 10, 3, 2]) {
            let lines = text(vec![block.clone()]);
            assert!(lines.iter().all(|line| line.len() <= 40), "{lines:#?}");
            assert!(lines.len() > 3, "{lines:#?}");
            for line in &lines[1..] {
                assert_eq!(line.len() - line.trim_start().len(), indent, "{block:?}");
            }
            let found = lines.join(" ");
            assert_eq!(found.split_whitespace().filter(|it| *it == "word").count(), 30);
        }
    }

    #[test]
    fn the_ends_of_a_line_are_at_the_edges_of_the_page() {
        let lines = text(vec![Block::Ends("left".to_owned(), "right".to_owned())]);
        assert_eq!(lines, [format!("left{:31}right", "")]);
    }
}
