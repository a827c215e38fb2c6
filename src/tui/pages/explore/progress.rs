//! How far a sweep is and what it found, for the status row. No drawing.

use crate::model::units;
use crate::tui::app::notice::Severity;
use crate::tui::app::{App, show_duration};
use crate::tui::pages::explore::gaps;
use crate::tui::pages::explore::plan::PictureSweep;
use crate::tui::pages::explore::state::{Picture, quadratic};
use crate::tui::pages::{Progress, StatusPart, part};

impl App {
    /// The parts of the status row in this tab.
    pub fn sweep_status(&self, picture: Picture) -> Vec<StatusPart> {
        let mut parts = Vec::new();
        let found = self.pages.explore.found(picture);
        let computing = self.jobs.study::<PictureSweep>();
        let computing = computing.filter(|(_, sweep)| sweep.picture == picture);
        parts.push(match (computing, &self.pages.explore.problem, found) {
            (Some((computing, _)), ..) => {
                let points = computing.points.map_or_else(String::new, |(done, total)| {
                    format!(": {done} of {total} points")
                });
                let left = computing.left().filter(|left| left.as_secs() > 0);
                let left =
                    left.map_or_else(String::new, |left| format!(", {} left", show_duration(left)));
                Progress::Running(format!("sweeping{points}{left}")).part()
            }
            (None, Some(problem), _) => part(Severity::Error, problem.clone()),
            _ if self.sweep_is_old(picture) => Progress::Old("scene").part(),
            (None, None, None) => Progress::Nothing.part(),
            (None, None, Some(found)) => {
                let (done, total) = found.grid.progress();
                match found.took.filter(|_| found.grid.is_complete()) {
                    Some(took) => {
                        Progress::Done(format!("{total} points in {}", show_duration(took))).part()
                    }
                    None => Progress::Cut(format!(" after {done} of {total} points")).part(),
                }
            }
        });
        if let Some(found) = found {
            for (word, count) in found.grid.outcomes().each() {
                if count > 0 && word != "arrested" {
                    let severity =
                        if word == "separated" { Severity::Note } else { Severity::Warning };
                    parts.push(part(severity, format!("{count} {word}")));
                }
            }
            let output = self.shown_output(&found.grid).0;
            parts.extend(gaps::at_rest(&found.grid, output).map(|text| part(Severity::Note, text)));
        }
        if let Some(found) =
            found.filter(|_| picture == Picture::Surface && self.pages.explore.residuals)
        {
            let (output, _) = self.shown_output(&found.grid);
            let text = quadratic(&found.grid, output).map_or_else(
                || "no quadratic fits".to_owned(),
                |fit| format!("quadratic fit: R2 {}", units::fixed_significant(fit.r_squared, 4)),
            );
            parts.push(part(Severity::Note, text));
        }
        parts.extend(self.validity_part());
        parts
    }
}
