//! A study's table: one list of columns, from which its CSV, its JSON and its page are made.
//!
//! CSV and JSON have SI units and the shortest digits that read back to the same number; a value that does not exist is an empty
//! field or null. A page has a few digits and a prefix for each unit.

use std::borrow::Cow;

use serde::Serialize;
use serde_json::{Map, Value};

use crate::study::context::Reach;
use cmra_engine::model::run::Warning;
use cmra_engine::model::units::{
    NO_NUMBER, Prefix, fixed_significant, shortest, significant, without_rounding,
};

const DIGITS: usize = 4;
/// Blanks between two columns of a page, and those of a table that would not fit otherwise.
const GAPS: [usize; 2] = [2, 1];

/// A column of a table with rows `R`.
pub struct Column<'c, R> {
    /// Name in CSV and JSON; the name of a number ends in its unit.
    pub key: &'static str,
    /// Heading on a page.
    pub label: Cow<'static, str>,
    /// The unit of its numbers; empty for pure numbers, counts and words.
    pub unit: &'static str,
    /// Function from a row to the value of the column.
    pub get: Get<'c, R>,
    /// The text that a page shows instead of the value.
    shown: Option<Shown<'c, R>>,
}

/// Makes the value of a column from a row.
type Get<'c, R> = Box<dyn Fn(&R) -> Value + 'c>;
/// Makes the text of a page from a row and its value.
type Shown<'c, R> = Box<dyn Fn(&R, &Value) -> Option<String> + 'c>;

/// Rows, and the columns that are made of them.
#[must_use]
pub struct Table<'c, R> {
    /// The columns, in the order of files.
    pub columns: Vec<Column<'c, R>>,
    /// The rows.
    pub rows: Vec<R>,
}

impl<'c, R> Table<'c, R> {
    /// A table of these rows, which has no column yet.
    pub fn new(rows: impl IntoIterator<Item = R>) -> Self {
        Self { columns: Vec::new(), rows: rows.into_iter().collect() }
    }

    /// With a further column.
    pub fn with<T: Into<Value>>(
        mut self,
        key: &'static str,
        label: impl Into<Cow<'static, str>>,
        unit: &'static str,
        get: impl Fn(&R) -> T + 'c,
    ) -> Self {
        let get = Box::new(move |row: &R| unsigned_zero(get(row).into()));
        self.columns.push(Column { key, label: label.into(), unit, get, shown: None });
        self
    }

    /// With a further column that files alone have: no page shows it.
    pub fn field<T: Into<Value>>(self, key: &'static str, get: impl Fn(&R) -> T + 'c) -> Self {
        self.with(key, "", "", get)
    }

    /// With a text that a page shows in the last column instead of the value.
    pub fn shown(mut self, text: impl Fn(&R, &Value) -> Option<String> + 'c) -> Self {
        if let Some(column) = self.columns.last_mut() {
            column.shown = Some(Box::new(text));
        }
        self
    }

    /// The keys of its columns.
    pub fn keys(&self) -> Vec<&'static str> {
        self.columns.iter().map(|column| column.key).collect()
    }

    /// As CSV, RFC 4180: a line of the keys, and a line a row.
    pub fn csv(&self) -> String {
        let mut head = csv::Writer::from_writer(Vec::new());
        // Into memory: nothing can fail.
        drop(head.write_record(self.keys()));
        text_of(head) + &self.csv_rows()
    }

    /// Formats the rows as CSV without the header: a chunk of a long table.
    pub fn csv_rows(&self) -> String {
        let mut writer = csv::Writer::from_writer(Vec::new());
        for row in &self.rows {
            for column in &self.columns {
                drop(writer.write_field(&*cell(&(column.get)(row))));
            }
            drop(writer.write_record(None::<&[u8]>));
        }
        text_of(writer)
    }

    /// As a JSON list of objects, whose keys keep the order of the columns.
    pub fn json(&self) -> String {
        pretty(&self.objects(|_| true))
    }

    /// Formats the rows as JSON objects, one a line, separated by commas: a chunk of a long list.
    pub fn json_rows(&self) -> String {
        let entry = |column: &Column<'_, R>, row: &R| {
            let value = (column.get)(row);
            // Shortest digits are JSON as they are.
            let text = if value.is_f64() { field(&value).into_owned() } else { value.to_string() };
            format!("\"{}\": {text}", column.key)
        };
        let object = |row: &R| {
            let entries: Vec<String> = self.columns.iter().map(|it| entry(it, row)).collect();
            format!("    {{ {} }}", entries.join(", "))
        };
        self.rows.iter().map(object).collect::<Vec<_>>().join(",\n")
    }

    /// The values of a row by their keys, of some columns.
    pub fn object(&self, row: &R, wanted: impl Fn(&str) -> bool) -> Map<String, Value> {
        let mut object = Map::new();
        for column in self.columns.iter().filter(|column| wanted(column.key)) {
            object.insert(column.key.to_owned(), (column.get)(row));
        }
        object
    }

    /// The rows as objects, of some columns.
    pub fn objects(&self, wanted: impl Fn(&str) -> bool) -> Value {
        self.rows.iter().map(|row| Value::Object(self.object(row, &wanted))).collect()
    }

    /// With the warnings of the whole table in every row.
    pub fn with_warnings(self, warnings: &[Warning]) -> Self {
        let text = listed(warnings);
        self.field("warnings", move |_| text.clone())
    }

    /// With the column `complete` in every row of an incomplete table.
    pub fn with_reach(self, reach: Reach) -> Self {
        if reach.is_complete() { self } else { self.field("complete", |_| false) }
    }

    /// Returns the columns of the transposed table: headings at the left, a column for each row.
    pub fn turned(&self, keys: &[&str]) -> Vec<Cells> {
        let lines: Vec<Cells> = keys.iter().flat_map(|key| self.cells(&[key])).collect();
        let heads = lines.iter().map(|line| line.head.clone()).collect();
        let column = |row: usize| Cells {
            head: String::new(),
            is_text: false,
            cells: lines.iter().map(|line| line.cells[row].clone()).collect(),
        };
        let first = Cells { head: String::new(), is_text: true, cells: heads };
        let rows = (0..self.rows.len()).map(column);
        std::iter::once(first).chain(rows).collect()
    }

    /// The columns with these keys on a page, those of one unit with the same prefix.
    pub fn cells(&self, keys: &[&str]) -> Vec<Cells> {
        let named = |key: &&str| self.columns.iter().find(|column| column.key == *key);
        let values =
            |column: &Column<'_, R>| self.rows.iter().map(|row| (column.get)(row)).collect();
        let valued = |column| (column, values(column));
        let columns: Vec<(&Column<'_, R>, Vec<Value>)> =
            keys.iter().filter_map(named).map(valued).collect();
        let size = |unit: &str| {
            let alike = columns.iter().filter(|(column, _)| column.unit == unit);
            let sizes = alike.flat_map(|(_, values)| values).filter_map(Value::as_f64);
            sizes.fold(0.0, |a: f64, b| a.max(b.abs()))
        };
        let of = |(column, values): &(&Column<'_, R>, Vec<Value>)| {
            let prefix = if column.takes_prefix() {
                Prefix::for_value(size(column.unit))
            } else {
                Prefix::NONE
            };
            let rows = self.rows.iter().zip(values);
            let gap = if column.unit.is_empty() { "" } else { ", " };
            Cells {
                head: format!("{}{gap}{}{}", column.label, prefix.letter, column.unit),
                is_text: values.iter().any(Value::is_string),
                cells: rows.map(|(row, value)| column.text(row, value, prefix)).collect(),
            }
        };
        columns.iter().map(of).collect()
    }
}

impl<R> Column<'_, R> {
    fn takes_prefix(&self) -> bool {
        matches!(self.unit, "m" | "s" | "N" | "J" | "Pa")
    }

    /// Formats a value for a page.
    fn text(&self, row: &R, value: &Value, prefix: Prefix) -> String {
        let own = self.shown.as_ref().and_then(|shown| shown(row, value));
        own.unwrap_or_else(|| match value {
            Value::Null => NO_NUMBER.to_owned(),
            // In a few digits, those before the point among them.
            Value::Number(number) if number.is_f64() => {
                let value = number.as_f64().unwrap_or(f64::NAN);
                let value = if self.takes_prefix() { without_rounding(value) } else { value };
                let value = value / prefix.size;
                let is_long = value.abs() >= 1e4;
                if is_long { significant(value, DIGITS) } else { fixed_significant(value, DIGITS) }
            }
            Value::Bool(is_so) => if *is_so { "yes" } else { "no" }.to_owned(),
            value => field(value).into_owned(),
        })
    }
}

fn text_of(written: csv::Writer<Vec<u8>>) -> String {
    String::from_utf8(written.into_inner().unwrap_or_default()).unwrap_or_default()
}

/// A column of a page.
#[derive(Clone, Debug, PartialEq)]
pub struct Cells {
    /// Heading of the column.
    pub head: String,
    /// Words stand at the left, numbers at the right.
    pub is_text: bool,
    /// Cells of the column, top to bottom.
    pub cells: Vec<String>,
}

impl Cells {
    /// Returns the width in characters.
    pub fn width(&self) -> usize {
        let all = self.cells.iter().chain([&self.head]);
        all.map(|cell| cell.chars().count()).max().unwrap_or(0)
    }

    /// The heading, or the cell of a row, as wide as the column.
    pub fn padded(&self, row: Option<usize>) -> String {
        let text = row.map_or(&self.head, |row| &self.cells[row]);
        let width = self.width();
        if self.is_text { format!("{text:<width$}") } else { format!("{text:>width$}") }
    }
}

/// Columns beside each other, each as wide as its widest cell, two blanks apart, or one if the table fits only then. Those that do not fit
/// into the width follow below, the first one beside them again.
pub fn grid(columns: &[Cells], width: usize) -> String {
    let Some((first, rest)) = columns.split_first() else { return String::new() };
    let cells: usize = columns.iter().map(Cells::width).sum();
    let fits = |gap: &usize| cells + gap * rest.len() <= width;
    let gap = GAPS.into_iter().find(fits).unwrap_or(GAPS[0]);
    let (mut block, mut used, mut text) = (vec![first], first.width(), String::new());
    for column in rest {
        let needed = gap + column.width();
        if used + needed > width && block.len() > 1 {
            text += &(beside(&block, gap) + "\n");
            (block, used) = (vec![first], first.width());
        }
        block.push(column);
        used += needed;
    }
    text + &beside(&block, gap)
}

/// The columns of a transposed table have no heading, and no line for it.
fn beside(columns: &[&Cells], gap: usize) -> String {
    let line = |row: Option<usize>| {
        let cells: Vec<String> = columns.iter().map(|column| column.padded(row)).collect();
        cells.join(&" ".repeat(gap)).trim_end().to_owned() + "\n"
    };
    let rows = columns.first().map_or(0, |it| it.cells.len());
    let has_head = columns.iter().any(|it| !it.head.is_empty());
    has_head.then_some(None).into_iter().chain((0..rows).map(Some)).map(line).collect()
}

/// A text of JSON, with a line end.
pub fn pretty(value: &impl Serialize) -> String {
    // Keys are strings and every number is finite, so nothing can be refused.
    serde_json::to_string_pretty(value).unwrap_or_default() + "\n"
}

/// A field of CSV. A text that a spreadsheet would take for a formula begins with an apostrophe there: it stays text.
fn cell(value: &Value) -> Cow<'_, str> {
    match value {
        Value::String(text) if is_formula(text) => Cow::Owned(format!("'{text}")),
        value => field(value),
    }
}

/// Whether a spreadsheet computes a text: names of files and scenes may be anything. A lone sign is text.
fn is_formula(text: &str) -> bool {
    text.starts_with(['=', '+', '-', '@', '\t', '\r']) && text.len() > 1
}

/// A zero without the sign that arithmetic leaves on it.
pub(super) fn unsigned_zero(value: Value) -> Value {
    if value.as_f64() == Some(0.0) && value.is_f64() { 0.0.into() } else { value }
}

fn field(value: &Value) -> Cow<'_, str> {
    match value {
        Value::Null => Cow::Borrowed(""),
        Value::String(text) => Cow::Borrowed(text),
        Value::Number(number) => Cow::Owned(match number.as_f64() {
            Some(float) if number.is_f64() => shortest(float),
            _ => number.to_string(),
        }),
        Value::Bool(_) | Value::Array(_) | Value::Object(_) => Cow::Owned(value.to_string()),
    }
}

/// Warnings in a cell of a table.
pub fn listed(warnings: &[Warning]) -> String {
    warnings.iter().map(ToString::to_string).collect::<Vec<String>>().join("; ")
}

/// Warnings in JSON.
pub fn texts(warnings: &[Warning]) -> Value {
    warnings.iter().map(ToString::to_string).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    type Row = (&'static str, Option<f64>, u64);

    fn table() -> Table<'static, Row> {
        Table::new([("a, b", Some(0.1 + 0.2), 3), ("c", Some(f64::NAN), 1200), ("d", None, 0)])
            .with("name", "name", "", |row: &Row| row.0)
            .with("depth_m", "depth", "m", |row: &Row| row.1)
            .with("steps", "steps", "", |row: &Row| row.2)
    }

    #[test]
    fn a_zero_has_no_sign_and_no_column_is_in_a_unit_of_rounding() {
        let of = |value: f64| {
            let rows = [("a", Some(value), 0)];
            Table::new(rows).with("stroke_m", "stroke", "m", |row: &Row| row.1)
        };
        assert_eq!(of(-0.0).csv(), "stroke_m\n0\n");
        assert!(!of(-0.0).json().contains("-0"));
        assert_eq!(grid(&of(9.122e-26).cells(&["stroke_m"]), 80), "stroke, m\n        0\n");
        assert_eq!(of(9.122e-26).csv(), "stroke_m\n9.122e-26\n");
    }

    /// A spreadsheet computes what begins with such a sign; numbers stay numbers.
    #[test]
    fn a_text_is_no_formula_in_a_file() {
        let rows = ["=1+1.toml", "+1", "-2", "@x", "\tx", "-", "a=b"];
        let rows = rows.map(|name| (name, Some(-1.5), 0));
        let table = Table::new(rows).with("name", "name", "", |row: &Row| row.0).with(
            "depth_m",
            "depth",
            "m",
            |row: &Row| row.1,
        );
        let csv = "name,depth_m\n'=1+1.toml,-1.5\n'+1,-1.5\n'-2,-1.5\n'@x,-1.5\n'\tx,-1.5\n-,-1.5\na=b,-1.5\n";
        assert_eq!(table.csv(), csv);
        assert!(table.json().contains("\"=1+1.toml\""));
    }

    #[test]
    fn files_keep_order_digits_and_missing_values() {
        let table = table();
        assert_eq!(
            table.csv(),
            "name,depth_m,steps\n\"a, b\",0.30000000000000004,3\nc,,1200\nd,,0\n"
        );
        let text = table.json();
        let back: Vec<Map<String, Value>> = serde_json::from_str(&text).unwrap();
        assert_eq!(back[0]["depth_m"], Value::from(0.1 + 0.2));
        assert_eq!((&back[1]["depth_m"], &back[2]["depth_m"]), (&Value::Null, &Value::Null));
        assert!(text.find("name") < text.find("depth_m"));
        let objects = table.objects(|key| key != "name");
        assert_eq!(objects[1], serde_json::json!({ "depth_m": null, "steps": 1200 }));
    }

    #[test]
    fn a_page_has_four_digits_and_one_prefix_a_column() {
        assert_eq!(
            grid(&table().cells(&["name", "depth_m", "steps"]), 80),
            "name  depth, mm  steps\na, b      300.0      3\nc             -   1200\nd             -      0\n"
        );
        assert_eq!(
            grid(&table().turned(&["name", "depth_m"]), 80),
            "name        a, b  c  d\ndepth, mm  300.0  -  -\n"
        );
        assert_eq!(
            grid(&table().cells(&["name", "depth_m", "steps"]), 15),
            "name  depth, mm\na, b      300.0\nc             -\nd             -\n\n\
             name  steps\na, b      3\nc      1200\nd         0\n"
        );
        let warned = table().with_warnings(&["x", "y"].map(|text| Warning::remark(text, "")));
        assert!(warned.csv().starts_with("name,depth_m,steps,warnings\n\"a, b\","));
        assert!(warned.csv().contains(",3,x; y\n"));
    }
}
