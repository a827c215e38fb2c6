//! Report as a single HTML file with embedded pictures.

use std::fmt::Write as _;

use crate::report::page::Block;
use crate::report::svg::{self, Picture, Svg, escaped};
use crate::report::table::Cells;

/// Style sheet of a report: black on white, 1.5 pictures wide, without external resources.
const STYLE: &str = "body { max-width: 60em; margin: 2em auto; padding: 0 1em; font-family: sans-serif; color: #111; \
                     background: #fff; line-height: 1.4 } table { border-collapse: collapse } \
                     th, td { border: 1px solid #ccc; padding: 0.2em 0.6em; text-align: left; vertical-align: top } \
                     pre { background: #f4f4f4; padding: 0.6em; overflow-x: auto } svg { max-width: 100%; height: auto }";

/// HTML document under construction; the file is also well-formed XML.
pub struct Document(String);

impl Document {
    /// Creates a report with this title.
    pub fn new(title: &str) -> Self {
        let title = escaped(title);
        Self(format!(
            "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n\
             <title>{title}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n<h1>{title}</h1>\n"
        ))
    }

    /// Appends a heading.
    pub fn heading(&mut self, text: &str) {
        self.0 += &element("h2", text);
    }

    /// Appends a paragraph.
    pub fn paragraph(&mut self, text: &str) {
        self.0 += &element("p", text);
    }

    /// Appends a list, one item per line.
    pub fn list(&mut self, items: &[impl ToString]) {
        let items: String = items.iter().map(|item| element("li", &item.to_string())).collect();
        let _ = writeln!(self.0, "<ul>\n{items}</ul>");
    }

    /// Appends the blocks of a report; texts beside labels become a list.
    pub fn blocks(&mut self, blocks: &[Block]) {
        for part in blocks.chunk_by(|a, b| item(a).is_some() && item(b).is_some()) {
            let items: Vec<String> = part.iter().filter_map(item).collect();
            if items.is_empty() {
                for block in part {
                    self.block(block);
                }
            } else {
                self.list(&items);
            }
        }
    }

    fn block(&mut self, block: &Block) {
        match block {
            Block::Title(text) | Block::Heading(text) => self.heading(text),
            Block::Line(text) => self.paragraph(text.trim()),
            Block::Fact { remark, .. } => self.paragraph(&remark.text),
            Block::Ends(left, right) => self.paragraph(&format!("{left} {right}")),
            Block::Table(columns) => self.columns(columns),
            Block::Picture(picture, _) => self.picture(picture),
            Block::Warnings(list) => self.list(list),
            Block::Space => {}
        }
    }

    fn columns(&mut self, columns: &[Cells]) {
        let head: Vec<String> = columns.iter().map(|column| column.head.clone()).collect();
        let count = columns.first().map_or(0, |column| column.cells.len());
        let texts = |at: usize| columns.iter().map(|column| column.cells[at].clone()).collect();
        self.rows(&head, (0..count).map(texts));
    }

    /// Appends a table: column names, and rows of as many texts.
    pub fn table<const N: usize>(
        &mut self,
        head: [&str; N],
        rows: impl Iterator<Item = [String; N]>,
    ) {
        self.rows(&head.map(str::to_owned), rows.map(Vec::from));
    }

    fn rows(&mut self, head: &[String], rows: impl Iterator<Item = Vec<String>>) {
        let head = row("th", head);
        let rows: String = rows.map(|texts| row("td", &texts)).collect();
        let _ =
            writeln!(self.0, "<table>\n<thead>\n{head}</thead>\n<tbody>\n{rows}</tbody>\n</table>");
    }

    /// Appends preformatted text.
    pub fn code(&mut self, text: &str) {
        let _ = writeln!(self.0, "<pre><code>{}</code></pre>", escaped(text));
    }

    /// Appends a chart or a map.
    pub fn picture(&mut self, picture: &Picture) {
        let _ = writeln!(self.0, "<figure>\n{}</figure>", svg::element(&[picture.svg()]));
    }

    /// Returns the complete file.
    pub fn html(self) -> String {
        self.0 + "</body>\n</html>\n"
    }
}

/// Returns the label and the text of a block that has both.
fn item(block: &Block) -> Option<String> {
    let Block::Fact { remark, .. } = block else { return None };
    let label = remark.about.trim();
    (!label.is_empty()).then(|| format!("{label}: {}", remark.text))
}

fn row(cell: &str, texts: &[String]) -> String {
    let cells: String = texts.iter().map(|text| element(cell, text)).collect();
    format!("<tr>\n{cells}</tr>\n")
}

fn element(name: &str, text: &str) -> String {
    format!("<{name}>{}</{name}>\n", escaped(text))
}
