//! Tables with more columns than may have room: they come in pages, the next one at a key.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use crate::tui::widgets::text::{columns, put};

/// A column: heading, width, value.
pub(in crate::tui) type Column<T> = (&'static str, u16, fn(&T) -> String);

/// The columns that are shown.
pub(in crate::tui) struct Page<'a, T> {
    columns: &'a [Column<T>],
    number: usize,
    count: usize,
}

impl<'a, T> Page<'a, T> {
    /// The page after so many turns of a table that has `room` columns of the screen.
    pub(in crate::tui) fn of(table: &'a [Column<T>], room: u16, table_page: usize) -> Self {
        let end_of = |from: usize| {
            let mut used = 0;
            let fits = table[from..].iter().take_while(|column| {
                used += column.1;
                used <= room
            });
            // One at the least: a page must go on.
            from + fits.count().max(1)
        };
        let mut ends = Vec::new();
        while ends.last().is_none_or(|end| *end < table.len()) && !table.is_empty() {
            ends.push(end_of(ends.last().copied().unwrap_or(0)));
        }
        let number = table_page % ends.len().max(1);
        let end = ends.get(number).copied().unwrap_or(0);
        // As much as there is room for, so that the last page is not a column alone.
        let from = (0..end).find(|from| end_of(*from) >= end).unwrap_or(0);
        Self { columns: &table[from..end], number, count: ends.len() }
    }

    /// Which page of how many, and the key that turns it; nothing where all columns are shown.
    pub(in crate::tui) fn hint(&self) -> Option<String> {
        (self.count > 1).then(|| format!("v columns {}/{}", self.number + 1, self.count))
    }

    /// The columns of the screen that its columns take.
    pub(in crate::tui) fn width(&self) -> u16 {
        self.columns.iter().map(|column| column.1).sum()
    }

    /// Write the headings into the first row of an area, from a column on.
    pub(in crate::tui) fn headings(
        &self,
        buffer: &mut Buffer,
        area: Rect,
        from: u16,
        style: Style,
    ) {
        self.write(buffer, area, (from, 0), style, |(heading, _, _)| (*heading).to_owned());
    }

    /// Write the values of an item into a row of an area, from a column on.
    pub(in crate::tui) fn values(
        &self,
        buffer: &mut Buffer,
        area: Rect,
        at: (u16, u16),
        (item, style): (&T, Style),
    ) {
        self.write(buffer, area, at, style, |(_, _, value)| value(item));
    }

    fn write(
        &self,
        buffer: &mut Buffer,
        area: Rect,
        (from, row): (u16, u16),
        style: Style,
        text: impl Fn(&Column<T>) -> String,
    ) {
        let mut end = from;
        for column in self.columns {
            end += column.1;
            let text = text(column);
            put(buffer, area, (end.saturating_sub(columns(&text)), row), &text, style);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: [Column<u8>; 5] = [
        ("a", 4, |value| value.to_string()),
        ("b", 4, |_| String::new()),
        ("c", 4, |_| String::new()),
        ("d", 4, |_| String::new()),
        ("e", 4, |_| String::new()),
    ];

    fn shown(room: u16, table_page: usize) -> (String, Option<String>) {
        let page = Page::of(&TABLE, room, table_page);
        (page.columns.iter().map(|column| column.0).collect(), page.hint())
    }

    #[test]
    fn every_column_is_on_some_page_and_none_is_left_alone() {
        assert_eq!(shown(20, 0), ("abcde".to_owned(), None));
        let hint = |number: usize| Some(format!("v columns {number}/2"));
        assert_eq!(shown(17, 0), ("abcd".to_owned(), hint(1)));
        assert_eq!(shown(17, 1), ("bcde".to_owned(), hint(2)));
        assert_eq!(shown(17, 2), ("abcd".to_owned(), hint(1)));
        let pages: String = (0..5).map(|table_page| shown(2, table_page).0).collect();
        assert_eq!(pages, "abcde");
    }
}
