//! The CSV dialect of a table: as RFC 4180 has it, or for programs that read nothing else.
//!
//! The tables themselves are made elsewhere, with a comma between values, a point in numbers and LF at the end of lines; here
//! their text is rewritten, piece by piece where they are long.

use std::borrow::Cow;

use cmra_studies::enumeration;
use csv::{ReaderBuilder, Terminator, WriterBuilder};

use crate::files::error::FileError;

enumeration! {
    /// The CSV dialect of a table.
    #[derive(Default)]
    pub enum Style in StyleRow {
        /// The word of the command line and of files.
        word: &'static str,
        /// Its description.
        words: &'static str,
        /// The prefix of a file, before its first line.
        head: &'static str,
    }
    /// A comma between values, a point in numbers, LF at the end of lines.
    #[default]
    Plain { word: "plain", words: "commas, as every program reads it", head: "" }
    /// The same with CRLF line ends.
    Crlf { word: "crlf", words: "commas, lines end with CR LF", head: "" }
    /// A semicolon between values, a comma in numbers, CRLF, and the mark of UTF-8 at the head: what Excel opens by itself where
    /// the comma is the decimal sign, and few other programs do.
    ExcelEu { word: "excel-eu", words: "for Excel with decimal commas: 1,5;2", head: "\u{feff}" }
}

impl Style {
    /// A whole file: its head, comment lines, and the table.
    ///
    /// # Errors
    /// [`FileError::Csv`] should the table be malformed.
    pub fn file(self, comments: &str, table: &str) -> Result<String, FileError> {
        let comments = match self {
            Self::Plain => Cow::Borrowed(comments),
            Self::Crlf | Self::ExcelEu => Cow::Owned(comments.replace('\n', "\r\n")),
        };
        let table = self.rows(table.as_bytes())?;
        Ok(format!("{}{comments}{}", self.head(), String::from_utf8_lossy(&table)))
    }

    /// Whole rows of a table.
    ///
    /// # Errors
    /// As [`Style::file`].
    pub fn rows(self, rows: &[u8]) -> Result<Cow<'_, [u8]>, FileError> {
        let mut respelt = WriterBuilder::new();
        respelt.flexible(true).terminator(Terminator::CRLF);
        match self {
            Self::Plain => return Ok(Cow::Borrowed(rows)),
            Self::Crlf => {}
            Self::ExcelEu => {
                respelt.delimiter(b';');
            }
        }
        let mut respelt = respelt.from_writer(Vec::with_capacity(rows.len() + rows.len() / 8));
        let mut reader = ReaderBuilder::new().has_headers(false).flexible(true).from_reader(rows);
        for row in reader.records() {
            let row = row?;
            respelt.write_record(row.iter().map(|field| self.field(field).into_owned()))?;
        }
        let bytes = respelt.into_inner().map_err(|error| csv::Error::from(error.into_error()))?;
        Ok(Cow::Owned(bytes))
    }

    fn field(self, field: &str) -> Cow<'_, str> {
        let is_decimal = || field.contains('.') && field.parse::<f64>().is_ok();
        match self {
            Self::ExcelEu if is_decimal() => Cow::Owned(field.replace('.', ",")),
            Self::Plain | Self::Crlf | Self::ExcelEu => Cow::Borrowed(field),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str = "run,time_s,event\n\"a, b\",1.5e-7,\nfigure-9.7,-0.25,\"x;y\"\n";

    #[test]
    fn every_style_has_its_signs_and_the_same_values() {
        let file = |style: Style| style.file("# v: 1.5 (m)\n", TABLE).unwrap();
        assert_eq!(file(Style::Plain), format!("# v: 1.5 (m)\n{TABLE}"));
        assert_eq!(
            file(Style::Crlf),
            "# v: 1.5 (m)\r\nrun,time_s,event\r\n\"a, b\",1.5e-7,\r\nfigure-9.7,-0.25,x;y\r\n"
        );
        // A name with a point is not a number; what has the separator in it is quoted.
        assert_eq!(
            file(Style::ExcelEu),
            "\u{feff}# v: 1.5 (m)\r\nrun;time_s;event\r\na, b;1,5e-7;\r\nfigure-9.7;-0,25;\"x;y\"\r\n"
        );
    }

    #[test]
    fn pieces_make_the_whole() {
        let (first, second) = TABLE.split_at(TABLE.find("figure").unwrap());
        for style in Style::ALL {
            let piece = |text: &str| style.rows(text.as_bytes()).unwrap().into_owned();
            assert_eq!([piece(first), piece(second)].concat(), piece(TABLE));
        }
    }
}
