//! HTML file of a report, with embedded pictures and without external resources. The file is also well-formed XML.

use cmra_engine::model::run::Warning;

use crate::report::Remark;
use crate::report::page::{Block, Page};
use crate::report::svg::{self, Svg as _, escaped};
use crate::report::table::Cells;

/// Style sheet of a report: black on white, 1.5 pictures wide.
const STYLE: &str = "body { max-width: 60em; margin: 2em auto; padding: 0 1em; font-family: sans-serif; color: #111; \
                     background: #fff; line-height: 1.4 } table { border-collapse: collapse } \
                     th, td { border: 1px solid #ccc; padding: 0.2em 0.6em; text-align: left; vertical-align: top } \
                     .facts th, .facts td { border: none } .facts th { font-weight: normal; color: #555; white-space: nowrap } \
                     .number { text-align: right } .caution { font-weight: bold } \
                     pre { background: #f4f4f4; padding: 0.6em; overflow-x: auto } svg { max-width: 100%; height: auto }";

/// Returns a report as an HTML file. The first title heads the document.
pub fn html(page: &Page) -> String {
    let is_title = |block: &&Block| matches!(block, Block::Title(_));
    let title = match page.blocks.iter().find(is_title) {
        Some(Block::Title(text)) => escaped(text),
        _ => String::new(),
    };
    let rest = match &page.blocks[..] {
        [Block::Title(_), rest @ ..] => rest,
        all => all,
    };
    // Labels below each other make a table.
    let parts = rest.chunk_by(|a, b| label(a).is_some() && label(b).is_some());
    let body: String = parts.map(part).collect();
    format!(
        "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n\
         <title>{title}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n<h1>{title}</h1>\n{body}</body>\n</html>\n"
    )
}

/// Writes a block, or several labels with their texts.
fn part(blocks: &[Block]) -> String {
    let facts: String = blocks.iter().filter_map(label).map(fact).collect();
    if facts.is_empty() {
        blocks.iter().map(one).collect()
    } else {
        format!("<table class=\"facts\">\n{facts}</table>\n")
    }
}

fn one(block: &Block) -> String {
    match block {
        Block::Title(text) | Block::Heading(text) => element("h2", "", text),
        Block::Line(text) => element("p", "", text.trim()),
        Block::Fact { remark, .. } => element("p", caution(remark), &remark.text),
        Block::Ends(left, right) => element("p", "", &format!("{left} {right}")),
        Block::Table(columns) => table(columns),
        Block::Picture(picture, _) => {
            format!("<figure>\n{}</figure>\n", svg::element(&[picture.svg()]))
        }
        Block::Warnings(list) => warnings(list),
        Block::Code(text) => format!("<pre><code>{}</code></pre>\n", escaped(text)),
        Block::Space => String::new(),
    }
}

/// Returns the words of a block that has a label.
fn label(block: &Block) -> Option<&Remark> {
    let Block::Fact { remark, .. } = block else { return None };
    (!remark.about.trim().is_empty()).then_some(remark)
}

/// Writes a label and its text; the blanks before a label say what it belongs to.
fn fact(remark: &Remark) -> String {
    let text = element("td", caution(remark), &remark.text);
    format!("<tr>\n{}{text}</tr>\n", cell("th", "", &remark.about))
}

fn caution(remark: &Remark) -> &'static str {
    if remark.is_caution { " class=\"caution\"" } else { "" }
}

fn warnings(list: &[Warning]) -> String {
    if list.is_empty() {
        return String::new();
    }
    let items: String = list.iter().map(|it| element("li", "", &it.to_string())).collect();
    format!("{}<ul>\n{items}</ul>\n", element("h2", "", "Warnings"))
}

fn table(columns: &[Cells]) -> String {
    let row = |name: &str, at: Option<usize>| {
        let text = |it: &Cells| at.map_or_else(|| it.head.clone(), |at| it.cells[at].clone());
        let class = |it: &Cells| if it.is_text { "" } else { " class=\"number\"" };
        let cells = columns.iter().map(|it| cell(name, class(it), &text(it)));
        format!("<tr>\n{}</tr>\n", cells.collect::<String>())
    };
    let has_head = columns.iter().any(|column| !column.head.is_empty());
    let head = if has_head { row("th", None) } else { String::new() };
    let head = if has_head { format!("<thead>\n{head}</thead>\n") } else { head };
    let count = columns.first().map_or(0, |column| column.cells.len());
    let rows: String = (0..count).map(|at| row("td", Some(at))).collect();
    format!("<table>\n{head}<tbody>\n{rows}</tbody>\n</table>\n")
}

/// Writes a cell; blanks before its text become an indent.
fn cell(name: &str, class: &str, text: &str) -> String {
    let inner = text.trim();
    let blanks = text.len() - text.trim_start().len();
    if class.is_empty() && blanks > 0 && !inner.is_empty() {
        let indent = format!(" style=\"padding-left: {}em\"", (blanks + 1) as f64 / 2.0);
        return element(name, &indent, inner);
    }
    element(name, class, inner)
}

fn element(name: &str, attributes: &str, text: &str) -> String {
    format!("<{name}{attributes}>{}</{name}>\n", escaped(text))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::table::Table;

    /// A number stands at the right, a label below another in one table with it, and a text cannot end its element.
    #[test]
    fn blocks_become_elements() {
        let mut page = Page::new("a < b");
        page.fact("depth", 10, "4 mm");
        page.fact("  time", 10, "2 us");
        page.push(Block::Fact { remark: Remark::caution("caution", "near"), column: 10 });
        page.paragraph("alone", 0);
        page.heading("rows");
        page.table(Table::new([1.5]).with("x_m", "x", "m", |x: &f64| *x).cells(&["x_m"]));
        page.push(Block::Code("k = 1\n".to_owned()));
        let html = html(&page);
        for expected in [
            "<title>a &lt; b</title>",
            "<h1>a &lt; b</h1>",
            "<th>depth</th>\n<td>4 mm</td>",
            "<th style=\"padding-left: 1.5em\">time</th>",
            "<td class=\"caution\">near</td>",
            "<p>alone</p>",
            "<h2>rows</h2>",
            "<th class=\"number\">x, m</th>",
            "<td class=\"number\">1.500</td>",
            "<pre><code>k = 1\n</code></pre>",
        ] {
            assert!(html.contains(expected), "{expected}\n{html}");
        }
        assert_eq!(html.matches("<table class=\"facts\">").count(), 1);
        assert_eq!(html.matches("a &lt; b").count(), 2);
    }
}
