//! Presentation of a study's result.

use crate::tui::pages::page::prelude::*;
use crate::tui::pages::search::state::Searching;
use crate::tui::widgets::table::{Grid, NAME_LEAST};
use crate::worker::studies::SearchAnswer;
use cmra_engine::model::run::Warning;
use cmra_engine::model::run::envelope::Check;
use cmra_studies::report::Remark;
use cmra_studies::report::table::Table;
use cmra_studies::study::sweep;

/// Presentation of a study's result on its page.
pub(crate) trait Answer {
    /// Returns the axes that define a design of the result.
    fn over(&self) -> &[sweep::Axis] {
        &[]
    }

    /// Describes the computational effort.
    fn effort(&self) -> Option<String> {
        None
    }

    /// Returns the number of designs or solutions.
    fn choices(&self) -> usize {
        0
    }

    /// Returns the design under the cursor as a scene with a label.
    fn design(&self, _app: &App) -> Result<LabelledScene, String> {
        Err("no design to load here: goal seek and the Pareto front have some".to_owned())
    }

    /// Describes the point under the cursor.
    fn readout(&self, _app: &App) -> Option<String> {
        None
    }

    /// Returns the validity of the designs; that of the scene if there are none.
    fn validity(&self, app: &App) -> Option<StatusPart> {
        app.validity_part()
    }

    /// Returns the validity checks that fail at an end of an axis but not for the scene itself, each with its warning.
    fn outside_at_ends(&self) -> &[(Check, Warning)] {
        &[]
    }

    /// Returns the lines of text beside the chart.
    fn lines(&self, app: &App, width: usize) -> Vec<TextLine>;

    /// Formats the results of a named scene as CSV.
    fn csv(&self, scene: &Scene, name: &str, reach: Reach) -> String;

    /// Returns `true` if there is a chart.
    fn draws(&self, _tab: &Searching) -> bool {
        false
    }

    fn draw(&self, _app: &App, _area: Rect, _canvas: &mut Canvas<'_>) {}
}

impl SearchAnswer {
    pub(crate) fn answer(&self) -> &dyn Answer {
        match self {
            Self::Seek(report) => &**report,
            Self::Front(report) => &**report,
            Self::Sensitivity(report) => &**report,
            Self::MonteCarlo(report) => &**report,
        }
    }

    /// Formats the results of a named scene as CSV.
    pub fn csv(&self, scene: &Scene, name: &str, reach: Reach) -> String {
        self.answer().csv(scene, name, reach)
    }
}

pub(super) fn note(text: String) -> TextLine {
    (text, Role::Text)
}

/// Formats a remark as a line.
pub(super) fn line(remark: Remark) -> TextLine {
    (remark.text, if remark.is_caution { Role::Warning } else { Role::Text })
}

/// Formats the rows of a table for a number of columns, below their headings.
pub(super) fn table_lines<R>(
    table: &Table<'_, R>,
    keys: &[&str],
    width: usize,
) -> impl Iterator<Item = TextLine> {
    let rows = table.rows.len();
    let room = u16::try_from(width.saturating_sub(2)).unwrap_or(u16::MAX);
    let grid = Grid::new(table.cells(keys), room, NAME_LEAST);
    std::iter::once(None)
        .chain((0..rows).map(Some))
        .map(move |row| note(format!("  {}", grid.line(row)).trim_end().to_owned()))
}
