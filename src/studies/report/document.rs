//! A report as plain data, and as one HTML file with its pictures in it.

use std::fmt::Write as _;

use crate::report::svg::{self, Picture, Svg, escaped};

/// A part of a report.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// The title of what follows.
    Heading(String),
    /// Sentences.
    Paragraph(String),
    /// One line each.
    List(Vec<String>),
    /// A table: names of the columns, and rows of as many texts.
    Table {
        /// The names.
        head: Vec<String>,
        /// The rows.
        rows: Vec<Vec<String>>,
    },
    /// Text to be copied as it is.
    Code(String),
    /// A chart or a map.
    Picture(Box<Picture>),
}

/// A report.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Document {
    /// Its title.
    pub title: String,
    /// Its parts.
    pub blocks: Vec<Block>,
}

/// The look of a page: black on white, as wide as a picture and a half, nothing from elsewhere.
const STYLE: &str = "body { max-width: 60em; margin: 2em auto; padding: 0 1em; font-family: sans-serif; color: #111; \
                     background: #fff; line-height: 1.4 } table { border-collapse: collapse } \
                     th, td { border: 1px solid #ccc; padding: 0.2em 0.6em; text-align: left; vertical-align: top } \
                     pre { background: #f4f4f4; padding: 0.6em; overflow-x: auto } svg { max-width: 100%; height: auto }";

impl Document {
    /// One HTML file that is XML, too.
    pub fn html(&self) -> String {
        let title = escaped(&self.title);
        let mut out = format!(
            "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n\
             <title>{title}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n<h1>{title}</h1>\n"
        );
        for block in &self.blocks {
            let _ = match block {
                Block::Heading(text) => writeln!(out, "<h2>{}</h2>", escaped(text)),
                Block::Paragraph(text) => writeln!(out, "<p>{}</p>", escaped(text)),
                Block::List(items) => {
                    let items = items.iter().map(|item| element("li", item)).collect::<String>();
                    writeln!(out, "<ul>\n{items}</ul>")
                }
                Block::Table { head, rows } => {
                    let row = |cell: &str, texts: &[String]| {
                        let cells = texts.iter().map(|text| element(cell, text));
                        format!("<tr>\n{}</tr>\n", cells.collect::<String>())
                    };
                    let rows = rows.iter().map(|texts| row("td", texts)).collect::<String>();
                    writeln!(
                        out,
                        "<table>\n<thead>\n{}</thead>\n<tbody>\n{rows}</tbody>\n</table>",
                        row("th", head)
                    )
                }
                Block::Code(text) => writeln!(out, "<pre><code>{}</code></pre>", escaped(text)),
                Block::Picture(picture) => {
                    let picture = svg::element(&[picture.svg()]);
                    writeln!(out, "<figure>\n{picture}</figure>")
                }
            };
        }
        out + "</body>\n</html>\n"
    }
}

fn element(name: &str, text: &str) -> String {
    format!("<{name}>{}</{name}>\n", escaped(text))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn document() -> Document {
        let text = |text: &str| text.to_owned();
        Document {
            title: text("a <b> & \"c\" | *d*"),
            blocks: vec![
                Block::Heading(text("Results")),
                Block::List(vec![text("x < 1"), text("y_z")]),
                Block::Table { head: vec![text("a|b")], rows: vec![vec![text("<td>")]] },
                Block::Code(text("k = 1 & <n>\n```\n")),
            ],
        }
    }

    #[test]
    fn html_is_xml_with_the_texts_as_they_are() {
        let html = document().html();
        let options = roxmltree::ParsingOptions { allow_dtd: true, ..Default::default() };
        let read = roxmltree::Document::parse_with_options(&html, options).unwrap();
        let text_of = |name: &str| {
            read.descendants()
                .find(|node| node.has_tag_name(("http://www.w3.org/1999/xhtml", name)))
                .unwrap()
                .text()
        };
        assert_eq!(text_of("h1"), Some("a <b> & \"c\" | *d*"));
        assert_eq!(text_of("li"), Some("x < 1"));
        assert_eq!(text_of("td"), Some("<td>"));
        assert_eq!(text_of("code"), Some("k = 1 & <n>\n```\n"));
    }
}
