//! Sensitivity: its setup, its request, and what was found.

use crate::model::run::envelope::Check;
use crate::report::sensitivity::{condition, indices, table, tornado};
use crate::study::quantities::{named, usual_of};
use crate::study::sensitivity::{Report, Request};
use crate::study::validity;
use crate::tui::pages::page::prelude::*;
use crate::tui::pages::search::Study;
use crate::tui::pages::search::answer::{Answer, note, table_lines};
use crate::tui::pages::search::state::Row;
use crate::tui::widgets::text::broken;
use crate::worker::studies::SearchRequest;

/// The columns shown.
const TORNADO: [&str; 4] = ["variable", "output_at_low", "output_at_high", "bar"];
const INDICES: [&str; 3] = ["variable", "sobol_first", "sobol_total"];

pub(super) const STUDY: Study = Study {
    title: "Sensitivity",
    synonyms: "sobol tornado importance ranking",
    file: "sensitivity.csv",
    rows,
    request,
};

fn rows(app: &App) -> Vec<Row> {
    let mut rows = vec![Row::Heading("Of"), Row::Output, Row::Heading("Vary")];
    rows.extend(app.bound_rows());
    rows
}

fn request(app: &App) -> Result<SearchRequest, String> {
    let over = app.varied()?;
    let output = named(app.pages.search.setup.output).map_err(|error| error.to_string())?;
    let output = Some(output).filter(|it| it.name != usual_of(&app.scene));
    Ok(SearchRequest::Sensitivity(Request { over, output, ..Request::default() }))
}

impl Answer for Report {
    fn readout(&self, _app: &App) -> Option<String> {
        Some("+- is the 95 % confidence interval".to_owned())
    }

    fn outside_at_ends(&self) -> &[(Check, String)] {
        &self.outside_at_ends
    }

    fn lines(&self, app: &App, width: usize) -> Vec<TextLine> {
        let output = self.output;
        let own = output.show_any(self.own, 3);
        let mut lines = vec![note(format!("{}; the scene: {own}", output.title()))];
        let condition = condition(self);
        lines.extend(condition.map(|text| (text, Role::Warning)));
        lines.push(note(String::new()));
        lines.push(note("one variable at a time, from low to high end".to_owned()));
        if self.is_empty() {
            let text = "nothing to compare: no run has this result; <next-pane>, then Of: choose another one";
            return broken(vec![lines.remove(0), (app.keymap.shown(text), Role::Warning)], width);
        }
        let bar = width.saturating_sub(36).clamp(4, 40);
        lines.extend(table_lines(&tornado(self, bar), &TORNADO, width));
        lines.push(note(String::new()));
        lines.extend(table_lines(&indices(self), &INDICES, width));
        lines
    }

    fn csv(&self, scene: &Scene, name: &str, reach: Reach) -> String {
        table(name, self)
            .with_warnings(&validity::of_axes(scene, &self.axes))
            .with_reach(reach)
            .csv()
    }
}
