//! Tables on the screen: the first column always, beside it as many of the others as have room, the next ones at a key.

use std::ops::Range;

use crate::report::table::Cells;
use crate::tui::widgets::text::fitted;

/// Least columns of the names of a table's rows.
const NAME_LEAST: usize = 12;

/// From this width on two blanks stand between columns, one below it.
const WIDE: u16 = 60;

pub(crate) struct Grid {
    cells: Vec<Cells>,
    shown: Range<usize>,
    /// The separator of two columns.
    gap: &'static str,
    /// The page of the columns, and how many pages there are.
    page: (usize, usize),
}

impl Grid {
    /// The page after a given number of turns of a table that has a given number of columns of the screen.
    pub(crate) fn of(cells: Vec<Cells>, width: u16, turns: usize) -> Self {
        Self::spaced(cells, width, turns, gap(width))
    }

    fn spaced(cells: Vec<Cells>, width: u16, turns: usize, gap: &'static str) -> Self {
        let lead = cells.first().map_or(0, Cells::width);
        let room = usize::from(width).saturating_sub(lead);
        let end_of = |from: usize| {
            let mut used = 0;
            let fits = cells[from..].iter().take_while(|column| {
                used += gap.len() + column.width();
                used <= room
            });
            // One at least: a page must go on.
            from + fits.count().max(1)
        };
        let mut ends = Vec::new();
        while cells.len() > 1 && ends.last().is_none_or(|end| *end < cells.len()) {
            ends.push(end_of(ends.last().copied().unwrap_or(1)));
        }
        let number = turns % ends.len().max(1);
        let end = ends.get(number).copied().unwrap_or(1);
        // As much as there is room for, so that the last page is not a column alone.
        let from = (1..end).find(|from| end_of(*from) >= end).unwrap_or(1);
        Self { cells, shown: from..end, gap, page: (number, ends.len()) }
    }

    /// As many columns as fit beside names of [`NAME_LEAST`] columns; longer names are shortened to the room that is left.
    pub(crate) fn shortened(mut cells: Vec<Cells>, width: u16) -> Self {
        let room = usize::from(width);
        let name = cells.first().map_or(0, Cells::width).min(NAME_LEAST);
        let all = |gap: &&str| {
            let others = cells.iter().skip(1).map(|column| gap.len() + column.width());
            name + others.sum::<usize>() <= room
        };
        let between = [gap(width), " "].into_iter().find(all).unwrap_or(" ");
        let gap = between.len();
        let mut used = name;
        let fitting = cells.iter().skip(1).take_while(|column| {
            used += gap + column.width();
            used <= room
        });
        let count = fitting.count();
        cells.truncate(1 + count);
        let others: usize = cells.iter().skip(1).map(|column| gap + column.width()).sum();
        if let Some(names) = cells.first_mut() {
            for name in &mut names.cells {
                *name = fitted(name, room.saturating_sub(others));
            }
        }
        Self::spaced(cells, width, 0, between)
    }

    /// Which page of how many, and the key that turns it; nothing where all columns are shown.
    pub(crate) fn hint(&self) -> Option<String> {
        let (number, count) = self.page;
        (count > 1).then(|| format!("<view> columns {}/{count}", number + 1))
    }

    /// The headings, or the cells of a row.
    pub(crate) fn line(&self, row: Option<usize>) -> String {
        let shown = self.cells.first().into_iter().chain(&self.cells[self.shown.clone()]);
        shown.map(|column| column.padded(row)).collect::<Vec<_>>().join(self.gap)
    }
}

/// The separator of two columns.
fn gap(width: u16) -> &'static str {
    if width < WIDE { " " } else { "  " }
}

/// The words of a table without a row that matches.
pub(crate) const NO_MATCH: &str = "no row matches: <back> shows all of them";

/// A title with the text that the rows below it match.
pub(crate) fn filtered(title: &str, filter: &str) -> String {
    if filter.is_empty() { title.to_owned() } else { format!("{title} /{filter}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(width: u16, turns: usize) -> (String, Option<String>) {
        let column = |head: &str| Cells {
            head: head.to_owned(),
            is_text: false,
            cells: vec![head.repeat(2)],
        };
        let grid = Grid::of(["a", "b", "c", "d", "e"].map(column).into(), width, turns);
        (grid.line(None).replace(' ', ""), grid.hint())
    }

    #[test]
    fn every_column_is_on_some_page_beside_the_first_and_none_is_left_alone() {
        assert_eq!(shown(14, 0), ("abcde".to_owned(), None));
        let hint = |number: usize| Some(format!("<view> columns {number}/2"));
        assert_eq!(shown(13, 0), ("abcd".to_owned(), hint(1)));
        assert_eq!(shown(13, 1), ("acde".to_owned(), hint(2)));
        assert_eq!(shown(13, 2), ("abcd".to_owned(), hint(1)));
        let pages: Vec<String> = (0..4).map(|turns| shown(2, turns).0).collect();
        assert_eq!(pages, ["ab", "ac", "ad", "ae"]);
    }
}
