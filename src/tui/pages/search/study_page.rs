//! Presentation of a study's result.

use crate::tui::app::running::CachedResult;
use crate::tui::pages::page::prelude::*;
use crate::tui::pages::search::results::searching;
use crate::tui::pages::search::state::Searching;
use crate::tui::widgets::table::{Grid, NAME_LEAST};
use crate::tui::widgets::text::broken;
use crate::worker::studies::SearchAnswer;
use cmra_engine::model::run::Warning;
use cmra_studies::report::Remark;
use cmra_studies::report::table::Cells;
use cmra_studies::study::envelope::Check;
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

    /// Returns `true` if the result answers the question, even if it is incomplete.
    fn has_answer(&self) -> bool {
        self.choices() > 0
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

    /// Returns the answer in sentences, if possible each on a line of this width.
    fn answer(&self, app: &App, width: usize) -> Vec<TextLine>;

    /// Returns the columns of the table, the most important first; empty if there are no rows.
    fn table(&self, app: &App) -> Vec<Cells>;

    /// Returns briefer names of the rows of the table; empty if there are none.
    fn brief_names(&self) -> Vec<String> {
        Vec::new()
    }

    /// Returns the marked row of the table.
    fn marked(&self, app: &App) -> Option<usize> {
        (self.choices() > 0).then(|| app.pages.search.selected())
    }

    /// Returns the remarks below the table.
    fn remarks(&self, _app: &App) -> Vec<TextLine> {
        Vec::new()
    }

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

/// Text of a result: the answer and the heading of the table, which stay visible, then its rows and the remarks.
#[derive(Debug, Default)]
pub struct Words {
    /// Answer, and heading of the table.
    pub head: Vec<TextLine>,
    /// Rows of the table, then remarks.
    pub body: Vec<TextLine>,
}

impl Words {
    /// Returns the number of lines.
    pub(crate) fn count(&self) -> usize {
        self.head.len() + self.body.len()
    }
}

/// Returns the text of the shown result for this width; empty before the first result.
pub fn search_words(app: &App, width: usize) -> Words {
    let Some(answer) = app.pages.search.answer() else { return Words::default() };
    let is_complete = app.pages.search.shown().is_some_and(CachedResult::is_complete);
    if !is_complete && !answer.has_answer() {
        let text = not_yet(app, searching(app, app.pages.search.page));
        return Words { head: broken(vec![(text, Role::Warning)], width), body: Vec::new() };
    }
    let columns = answer.table(app);
    let rows = columns.first().map_or(0, |column| column.cells.len());
    let room = u16::try_from(width.saturating_sub(2)).unwrap_or(u16::MAX);
    let grid = Grid::with_brief_names(columns, &answer.brief_names(), room, NAME_LEAST);
    let marked = answer.marked(app);
    let line = |row: Option<usize>| {
        let mark = if row.is_some() && row == marked { ">" } else { " " };
        note(format!("{mark} {}", grid.line(row)).trim_end().to_owned())
    };
    let heading = (rows > 0).then(|| (line(None).0, Role::Title));
    let mut head = broken(answer.answer(app, width), width);
    head.extend(heading);
    let mut body: Vec<TextLine> = (0..rows).map(|row| line(Some(row))).collect();
    body.extend(broken(answer.remarks(app), width));
    Words { head, body }
}
