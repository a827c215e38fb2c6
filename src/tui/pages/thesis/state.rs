//! The Thesis tab: the reproduction report, the families of principles, the screening matrix, and what is selected in them.

use std::error::Error;
use std::sync::Arc;

use crate::model::scene::Scene;
use crate::model::units::significant;
use crate::study::context::Context;
use crate::study::principles::PRINCIPLES;
use crate::study::screening::{CRITERIA, WEIGHTS_PERCENT};
use crate::study::thesis::{Opens, Row, Verdict, claims, reproduce, tally};
use crate::tui::app::App;
use crate::tui::app::find::{rank, ranked};
use crate::tui::app::notice::Severity;
use crate::tui::pages::thesis::{self, CLAIMS};
use crate::tui::pages::{Progress, StatusPart};
use crate::worker::Finding;
use crate::worker::reporter::Reporter;
use crate::worker::study::{Lane, RowsSoFar, Study};

/// Checks every claim of the thesis; the scene plays no part.
#[derive(Debug)]
pub struct Claims;

impl Study for Claims {
    fn lane(&self) -> Lane {
        Lane::Studies
    }

    fn make(&self, _: &Arc<Scene>, reporter: &Reporter<'_>) -> Result<Finding, Box<dyn Error>> {
        let watch = &mut reporter.watch(RowsSoFar::part);
        let rows = reproduce(&mut Context::new(reporter.threads(), watch));
        Ok(Finding::new(RowsSoFar::ended(rows, claims().len())))
    }
}

/// The state of the tab.
#[derive(Clone, Debug)]
pub struct Thesis {
    /// The claims checked so far.
    pub report: Option<Arc<RowsSoFar<Row>>>,
    /// Only rows with this verdict are shown.
    pub filter: Option<Verdict>,
    /// The rows are sorted by verdict.
    pub by_verdict: bool,
    /// The selected one of the rows shown.
    pub selected: usize,
    /// The selected principle.
    pub principle: usize,
    /// The selected criterion.
    pub criterion: usize,
    /// Weights of the criteria, percent.
    pub weights: [f64; 7],
}

impl Default for Thesis {
    fn default() -> Self {
        Self {
            report: None,
            filter: None,
            by_verdict: false,
            selected: 0,
            principle: 0,
            criterion: 0,
            weights: WEIGHTS_PERCENT,
        }
    }
}

impl Thesis {
    /// All rows there are.
    pub fn rows(&self) -> &[Row] {
        self.report.as_ref().map_or(&[], |report| &report.rows)
    }

    /// The next verdict to filter by; after the last one, all rows.
    pub fn next_filter(&mut self) {
        let at = self.filter.and_then(|it| Verdict::ALL.iter().position(|other| *other == it));
        self.filter = match at {
            None => Verdict::ALL.first().copied(),
            Some(at) => Verdict::ALL.get(at + 1).copied(),
        };
        self.selected = 0;
    }
}

impl App {
    /// The claims shown: of the wanted verdict, and those that match what is looked for, best first.
    pub fn claims(&self) -> Vec<&Row> {
        let tab = &self.pages.thesis;
        let passes = |row: &&Row| tab.filter.is_none_or(|wanted| row.found.verdict == wanted);
        let mut rows = ranked(tab.rows().iter().filter(passes), |row| {
            let claim = &row.claim;
            rank(&self.find.claims, &[claim.id, claim.place], claim.says)
        });
        if tab.by_verdict {
            let order = |row: &&Row| Verdict::ALL.iter().position(|it| *it == row.found.verdict);
            rows.sort_by_key(order);
        }
        rows
    }

    /// The selected claim.
    pub fn claim(&self) -> Option<&Row> {
        self.claims().get(self.pages.thesis.selected).copied()
    }

    /// What is selected, in words, for the message row.
    pub fn thesis_readout(&self) -> Option<String> {
        let tab = &self.pages.thesis;
        match self.pane() {
            CLAIMS => {
                let row = self.claim()?;
                let opens = match row.claim.opens {
                    Opens::Nothing => "no scene shows this".to_owned(),
                    Opens::Scene(_) => "Enter opens its scene".to_owned(),
                    Opens::Preset(name) => format!("Enter opens {name}"),
                };
                // The cause is in the detail: a line that changes its height here would move the list.
                Some(format!("{}: {opens}", row.found.verdict.words()))
            }
            thesis::PRINCIPLES => {
                let principle = &PRINCIPLES[tab.principle];
                let opens = principle.preset.map_or_else(
                    || "no preset shows it".to_owned(),
                    |name| format!("Enter opens {name}"),
                );
                // Its name is selected in the list and heads the detail.
                Some(opens)
            }
            _ => {
                let weight = tab.weights[tab.criterion];
                // In one row of the narrowest screen: a second one would hide the ranks.
                Some(format!(
                    "{}: {} %, printed {} %",
                    CRITERIA[tab.criterion],
                    significant(weight, 4),
                    significant(WEIGHTS_PERCENT[tab.criterion], 4),
                ))
            }
        }
    }

    /// The parts of the status row in this tab; see [`App::status`].
    pub fn thesis_status(&self) -> Vec<StatusPart> {
        let tab = &self.pages.thesis;
        let mut parts = Vec::new();
        let progress = match (self.jobs.running::<Claims>(), &tab.report) {
            (Some(running), _) => {
                Some(Progress::Running(format!("checking the claims{}", running.counted("of", ""))))
            }
            (None, None) => Some(Progress::Nothing),
            (None, Some(report)) if !report.is_complete => Some(Progress::Cut(String::new())),
            (None, Some(_)) => None,
        };
        parts.extend(progress.map(Progress::part));
        if tab.report.is_some() {
            let (rows, counts) = (tab.rows(), tally(tab.rows()));
            let listed = |show: fn(Verdict) -> &'static str| {
                let parts = Verdict::ALL.iter().zip(counts);
                let parts = parts.map(|(verdict, count)| format!("{count} {}", show(*verdict)));
                parts.collect::<Vec<_>>().join(", ")
            };
            let full = format!("{} rows: {}", rows.len(), listed(Verdict::words));
            parts.push((Severity::Note, full, listed(Verdict::brief)));
        }
        parts
    }
}
