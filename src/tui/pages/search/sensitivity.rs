//! Sensitivity: setup, request, and presentation of the result.

use crate::tui::pages::page::prelude::*;
use crate::tui::pages::search::Study;
use crate::tui::pages::search::state::Row;
use crate::tui::pages::search::study_page::{Answer, note};
use crate::tui::theme::GlyphSet;
use crate::worker::studies::SearchRequest;
use cmra_engine::model::run::Warning;
use cmra_studies::report::sensitivity::{ASCII, BLOCKS, COLUMNS, bars, table};
use cmra_studies::report::table::Cells;
use cmra_studies::study::envelope::Check;
use cmra_studies::study::quantities::named;
use cmra_studies::study::sensitivity::{OUTPUT, Request, SensitivityReport};
use cmra_studies::study::sweep::Axis;
use cmra_studies::study::validity;

pub(super) const STUDY: Study = Study {
    synonyms: "tornado importance ranking one at a time",
    file: "sensitivity",
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

/// Number of variables that the answer names.
const NAMED: usize = 3;

impl Answer for SensitivityReport {
    fn readout(&self, _app: &App) -> Option<String> {
        let top = self.output.show(self.scale()?, 3);
        Some(format!(
            "one variable at a time over its range; bars: 0 to {top}; here: the slope at the scene"
        ))
    }

    fn has_answer(&self) -> bool {
        !self.is_empty()
    }

    fn outside_at_ends(&self) -> &[(Check, Warning)] {
        &self.outside_at_ends
    }

    fn answer(&self, app: &App, _width: usize) -> Vec<TextLine> {
        let title = self.output.title();
        if self.is_empty() {
            let text = "nothing to compare: no run has this result; <next-pane>, then Of: choose another one";
            return vec![(app.keymap.shown(text), Role::Warning)];
        }
        let own = self.output.show_any(self.own.and_then(|own| own.result), 3);
        let effects = self.order().into_iter().map(|at| &self.effects[at]);
        let names: Vec<&str> = effects.take(NAMED).map(|effect| effect.axis.symbol()).collect();
        vec![note(format!("{title}, here {own}: {} matter most", names.join(", ")))]
    }

    fn table(&self, app: &App) -> Vec<Cells> {
        if self.is_empty() {
            return Vec::new();
        }
        bars(self, levels(app.settings.theme.glyphs)).cells(&COLUMNS)
    }

    fn csv(&self, scene: &Scene, name: &str, reach: Reach) -> String {
        let axes: Vec<Axis> = self.effects.iter().map(|effect| effect.axis.clone()).collect();
        let warnings = validity::of_axes(scene, &axes);
        table(name, self).with_warnings(&warnings).with_reach(reach).csv()
    }
}
