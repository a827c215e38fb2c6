//! Tables on the screen: the first column always, and as many others as fit.

use crate::tui::theme;
use crate::tui::widgets::text::clip_words;
use cmra_studies::report::table::Cells;

/// Minimum columns for the names of a table's rows if they may be shortened.
pub(crate) const NAME_LEAST: u16 = 12;

/// Minimum width for two blanks between columns, else one.
const WIDE: u16 = 60;

pub(crate) struct Grid {
    cells: Vec<Cells>,
    /// Separator of two columns.
    gap: &'static str,
}

impl Grid {
    /// Creates a table with as many columns as fit beside a first column of at least `least` columns; longer names are shortened to the
    /// remaining width.
    pub(crate) fn new(cells: Vec<Cells>, width: u16, least: u16) -> Self {
        Self::with_brief_names(cells, &[], width, least)
    }

    /// Creates a table with briefer names for rows whose names are too long.
    pub(crate) fn with_brief_names(
        mut cells: Vec<Cells>,
        brief: &[String],
        width: u16,
        least: u16,
    ) -> Self {
        let room = usize::from(width);
        let name = cells.first().map_or(0, Cells::width).min(usize::from(least));
        let needed = |count: usize, gap: &str| {
            let others = cells.iter().skip(1).take(count);
            name + others.map(|column| gap.len() + column.width()).sum::<usize>()
        };
        let all = cells.len().saturating_sub(1);
        let gap = if width < WIDE || needed(all, "  ") > room { " " } else { "  " };
        let count = (1..=all).rev().find(|count| needed(*count, gap) <= room).unwrap_or(0);
        let left = room.saturating_sub(needed(count, gap) - name);
        cells.truncate(1 + count);
        if let Some(names) = cells.first_mut() {
            for (row, name) in names.cells.iter_mut().enumerate() {
                let brief = brief.get(row).filter(|_| theme::columns(name) > left);
                *name = clip_words(brief.unwrap_or(name), left);
            }
        }
        Self { cells, gap }
    }

    /// Returns the headings, or the cells of a row.
    pub(crate) fn line(&self, row: Option<usize>) -> String {
        self.cells.iter().map(|column| column.padded(row)).collect::<Vec<_>>().join(self.gap)
    }
}

/// Text of a table without matching rows.
pub(crate) const NO_MATCH: &str = "no row matches: <back> shows all of them";

/// Returns a title with the filter text of its rows.
pub(crate) fn filtered(title: &str, filter: &str) -> String {
    if filter.is_empty() { title.to_owned() } else { format!("{title} /{filter}") }
}
