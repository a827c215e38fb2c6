//! Sensitivity: setup, request, and presentation of the result.

use crate::tui::pages::page::prelude::*;
use crate::tui::pages::search::Study;
use crate::tui::pages::search::state::Row;
use crate::tui::pages::search::study_page::{Answer, note, table_lines};
use crate::tui::theme::GlyphSet;
use crate::tui::widgets::text::broken;
use crate::worker::studies::SearchRequest;
use cmra_engine::model::run::Warning;
use cmra_engine::model::run::envelope::Check;
use cmra_studies::report::sensitivity::{ASCII, BLOCKS, COLUMNS, page, table};
use cmra_studies::study::quantities::named;
use cmra_studies::study::sensitivity::{OUTPUT, Request, SensitivityReport};
use cmra_studies::study::sweep::Axis;
use cmra_studies::study::validity;

pub(super) const STUDY: Study = Study {
    title: "Sensitivity",
    synonyms: "tornado importance ranking one at a time",
    file: "sensitivity.csv",
    rows,
    request,
};

fn rows(_app: &App) -> Vec<Row> {
    vec![Row::Heading("Of"), Row::Affected]
}

fn request(app: &App) -> Result<SearchRequest, String> {
    let output = named(app.pages.search.setup.affected).map_err(|error| error.to_string())?;
    let output = Some(output).filter(|it| it.name != OUTPUT);
    Ok(SearchRequest::Sensitivity(Request { over: Vec::new(), output }))
}

/// Returns the characters for the levels of bars. The PC character set has no eighths of a block.
pub(crate) fn levels(glyphs: GlyphSet) -> [char; 8] {
    match glyphs {
        GlyphSet::Braille => BLOCKS,
        GlyphSet::Ascii | GlyphSet::Block => ASCII,
    }
}

impl Answer for SensitivityReport {
    fn readout(&self, _app: &App) -> Option<String> {
        let top = self.output.show(self.scale()?, 3);
        Some(format!("bars: 0 to {top}, the 95th percentile of all runs; here: slope at the scene"))
    }

    fn outside_at_ends(&self) -> &[(Check, Warning)] {
        &self.outside_at_ends
    }

    fn lines(&self, app: &App, width: usize) -> Vec<TextLine> {
        let own = self.output.show_any(self.own.and_then(|own| own.result), 3);
        let mut lines = vec![note(format!("{}; the scene: {own}", self.output.title()))];
        if self.is_empty() {
            let text = "nothing to compare: no run has this result; <next-pane>, then Of: choose another one";
            lines.push((app.keymap.shown(text), Role::Warning));
            return broken(lines, width);
        }
        lines.push(note("one variable at a time over its range".to_owned()));
        lines.push(note(String::new()));
        let levels = levels(app.settings.theme.glyphs);
        lines.extend(table_lines(&page(self, levels), &COLUMNS, width));
        lines
    }

    fn csv(&self, scene: &Scene, name: &str, reach: Reach) -> String {
        let axes: Vec<Axis> = self.effects.iter().map(|effect| effect.axis.clone()).collect();
        let warnings = validity::of_axes(scene, &axes);
        table(name, self).with_warnings(&warnings).with_reach(reach).csv()
    }
}
