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

/// The result of a study of the tab, as its page shows it.
pub(crate) trait Answer {
    /// The axes that a design of it is a point of.
    fn over(&self) -> &[sweep::Axis] {
        &[]
    }

    /// How much went into it.
    fn effort(&self) -> Option<String> {
        None
    }

    /// How many designs or solutions it has.
    fn choices(&self) -> usize {
        0
    }

    /// The design under the cursor, as a change of a scene.
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

    /// Checks of the model's validity that fail at an end of an axis and not for the scene itself, each with its warning.
    fn outside_at_ends(&self) -> &[(Check, Warning)] {
        &[]
    }

    /// Returns the lines of text beside the chart.
    fn lines(&self, app: &App, width: usize) -> Vec<TextLine>;

    /// The results of a scene of this name as a table.
    fn csv(&self, scene: &Scene, name: &str, reach: Reach) -> String;

    /// Whether there is something to draw.
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

    /// The results of a scene of this name as a table.
    pub fn csv(&self, scene: &Scene, name: &str, reach: Reach) -> String {
        self.answer().csv(scene, name, reach)
    }
}

pub(super) fn note(text: String) -> TextLine {
    (text, Role::Text)
}

/// Words about a result as a line.
pub(super) fn line(remark: Remark) -> TextLine {
    (remark.text, if remark.is_caution { Role::Warning } else { Role::Text })
}

/// The rows of a table in a given number of columns, below their headings.
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
