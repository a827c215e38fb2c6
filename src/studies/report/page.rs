//! A report as a list of blocks. Each report makes one list; the command line, the workbench and HTML render it, each in its own width.

use std::borrow::Cow;

use crate::report::Remark;
use crate::report::svg::Picture;
use crate::report::table::Cells;
use cmra_engine::model::run::Warning;

/// Number of columns and rows of a picture in text.
pub type Size = (u16, u16);

/// Size of a chart in text of 80 columns.
pub const CHART: Size = (78, 16);
/// Size of a map in text of 80 columns.
pub const MAP: Size = (78, 26);

/// Part of a report.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// Title of the report.
    Title(String),
    /// Heading of a section.
    Heading(String),
    /// Line; further lines are indented by two more blanks.
    Line(String),
    /// Text beside its label; without a label, a paragraph.
    Fact {
        /// The words; a caution stands out.
        remark: Remark,
        /// Column of the text, of a paragraph that of its further lines.
        column: usize,
    },
    /// Two texts at the ends of a line.
    Ends(String, String),
    /// Table, column by column.
    Table(Vec<Cells>),
    /// Chart or map.
    Picture(Box<Picture>, Size),
    /// Warnings of the scene, in a section of their own.
    Warnings(Vec<Warning>),
    /// Text of a file or of commands, kept as it is.
    Code(String),
    /// Blank line.
    Space,
}

impl Block {
    /// Creates a paragraph whose further lines are indented by two blanks.
    pub fn paragraph(text: impl Into<String>) -> Self {
        Self::Fact { remark: Remark::new("", text), column: 2 }
    }

    /// Indents lines, labels and tables by some blanks.
    fn indented(self, by: usize) -> Self {
        let moved = |text: &str| format!("{:by$}{text}", "");
        match self {
            Self::Line(text) => Self::Line(moved(&text)),
            Self::Fact { mut remark, column } => {
                remark.about = moved(&remark.about).into();
                Self::Fact { remark, column: column + by }
            }
            Self::Table(mut columns) => {
                if let Some(first) = columns.first_mut() {
                    let is_headed = !first.head.is_empty();
                    first.head = if is_headed { moved(&first.head) } else { String::new() };
                    first.cells.iter_mut().for_each(|cell| *cell = moved(cell));
                }
                Self::Table(columns)
            }
            other => other,
        }
    }
}

/// Report as a list of blocks.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Page {
    /// The blocks, top to bottom.
    pub blocks: Vec<Block>,
}

impl Page {
    /// Begins a report with its title.
    pub fn new(title: impl Into<String>) -> Self {
        Self { blocks: vec![Block::Title(title.into())] }
    }

    /// Appends a block.
    pub fn push(&mut self, block: Block) {
        self.blocks.push(block);
    }

    /// Appends a line; further lines are indented by two more blanks.
    pub fn line(&mut self, text: impl Into<String>) {
        self.push(Block::Line(text.into()));
    }

    /// Appends lines.
    pub fn lines(&mut self, all: impl IntoIterator<Item = String>) {
        self.blocks.extend(all.into_iter().map(Block::Line));
    }

    /// Appends a paragraph whose further lines have this indent.
    pub fn paragraph(&mut self, text: impl Into<String>, indent: usize) {
        self.fact("", indent, text);
    }

    /// Appends a text beside its label; the text begins in this column.
    pub fn fact(
        &mut self,
        label: impl Into<Cow<'static, str>>,
        column: usize,
        text: impl Into<String>,
    ) {
        self.push(Block::Fact { remark: Remark::new(label, text), column });
    }

    /// Appends the texts of an entry below its heading; skips empty ones.
    pub fn entries<'t>(&mut self, all: impl IntoIterator<Item = (&'static str, &'t str)>) {
        for (label, text) in all.into_iter().filter(|(_, text)| !text.is_empty()) {
            self.fact(format!("    {label}"), 16, text);
        }
    }

    /// Appends remarks beside their subjects.
    pub fn remarks(&mut self, remarks: impl IntoIterator<Item = Remark>, column: usize) {
        self.blocks.extend(remarks.into_iter().map(|remark| Block::Fact { remark, column }));
    }

    /// Appends the heading of a section.
    pub fn heading(&mut self, text: impl Into<String>) {
        self.push(Block::Heading(text.into()));
    }

    /// Appends the heading of a section and its blocks, indented by some blanks.
    pub fn section(&mut self, heading: impl Into<String>, indent: usize, blocks: Vec<Block>) {
        self.heading(heading);
        self.blocks.extend(blocks.into_iter().map(|block| block.indented(indent)));
    }

    /// Appends a table.
    pub fn table(&mut self, columns: Vec<Cells>) {
        self.push(Block::Table(columns));
    }

    /// Appends a chart or a map.
    pub fn picture(&mut self, picture: Picture, size: Size) {
        self.push(Block::Picture(Box::new(picture), size));
    }

    /// Appends a blank line.
    pub fn space(&mut self) {
        self.push(Block::Space);
    }
}
