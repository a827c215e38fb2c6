//! The last result in words, on the main screen after leaving. No drawing.

use crate::model::run::Warning;
use crate::model::run::envelope;
use crate::report::run::page::{self, LABEL};
use crate::tui::pages::prelude::*;

impl App {
    /// The last result in a few lines, for the main screen after leaving.
    pub fn summary(&self) -> String {
        let Some(shown) = &self.shown else {
            return format!("{}: not run", self.base.name);
        };
        let run = &shown.run;
        let name = self.name_of(&run.scene);
        let outcome = format!("{} ({})", page::outcome(run), run.end.words());
        let mut lines = [("scene", name), ("outcome", outcome)]
            .map(|(label, text)| page::labelled(label, &text))
            .to_vec();
        lines.extend(page::results(run));
        // How it ended stands beside the outcome already.
        let ended = Warning::EndedEarly(run.end).to_string();
        let warnings = envelope::warnings(run).into_iter().filter(|text| *text != ended);
        lines.extend(warnings.map(|warning| page::labelled("warning", &warning)));
        let room = usize::from(self.size.0).saturating_sub(LABEL).max(LABEL);
        let hang = |line: String| {
            // A label is columns of ASCII.
            let (label, words) = line.split_at_checked(LABEL).unwrap_or((&line, ""));
            let indent = format!("\n{:LABEL$}", "");
            format!("{label}{}", wrap(words, room).join(&indent))
        };
        lines.into_iter().map(hang).collect::<Vec<_>>().join("\n")
    }
}
