//! The Search tab: what is looked for, what was found, which design is selected, and all of it in words. No drawing.

use std::sync::Arc;

use super::App;
use super::accuracy::Measuring;
use super::layout::{Body, CHART_ROWS};
use super::notice::Severity;
use crate::files::error::FileError;
use crate::files::{compare as compare_file, sensitivity as sensitivity_file};
use crate::files::{front as front_file, scatter as scatter_file, seek as seek_file};
use crate::model::scene::Scene;
use crate::model::units::significant;
use crate::study::search::front::{Design, Front, Task};
use crate::study::search::scatter::Summary;
use crate::worker::searches::{Answer, Request};
pub use bounds::Bound;
pub use setup::{Row, SearchField, Setup};

pub mod bounds;
pub mod lines;
pub mod setup;

/// A page of the tab.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Page {
    /// Which values of a variable give a wanted result.
    #[default]
    Seek,
    /// The designs that nothing beats.
    Front,
    /// Which variables matter.
    Sensitivity,
    /// How results scatter.
    Scatter,
    /// The comparison at equal areal mass.
    Compare,
}

/// Rows of words that a chart must leave, frame included.
const LEAST_WORDS: u16 = 6;

impl Page {
    /// All pages, in order.
    pub const ALL: [Self; 5] =
        [Self::Seek, Self::Front, Self::Sensitivity, Self::Scatter, Self::Compare];

    /// What it answers, in two or three words.
    pub fn title(self) -> &'static str {
        match self {
            Self::Seek => "goal seek",
            Self::Front => "best designs",
            Self::Sensitivity => "what matters",
            Self::Scatter => "scatter",
            Self::Compare => "mass efficiency",
        }
    }

    /// The file proposed for an export.
    pub fn file(self) -> &'static str {
        match self {
            Self::Seek => "seek.csv",
            Self::Front => "front.csv",
            Self::Sensitivity => "sensitivity.csv",
            Self::Scatter => "scatter.csv",
            Self::Compare => "compare.csv",
        }
    }

    pub(in crate::tui) fn place(self) -> usize {
        Self::ALL.iter().position(|page| *page == self).unwrap_or(0)
    }

    /// The page so many further, in a circle.
    #[must_use]
    pub fn turned(self, by: isize) -> Self {
        Self::ALL[super::dialog::wrap(self.place(), by, Self::ALL.len())]
    }
}

/// What was found.
#[derive(Clone, Debug)]
pub struct Found {
    /// Of which scene.
    pub scene: Arc<Scene>,
    /// What was asked.
    pub request: Arc<Request>,
    /// The answer, as far as it is.
    pub answer: Answer,
}

/// The state of the tab.
#[derive(Clone, Debug, Default)]
pub struct Searching {
    /// The page shown.
    pub page: Page,
    /// The setup has the keys.
    pub on_setup: bool,
    /// The selected row of the setup.
    pub row: Row,
    /// The open field.
    pub field: Option<SearchField>,
    /// What is looked for.
    pub setup: Setup,
    /// What was found, page by page.
    pub found: [Option<Found>; 5],
    /// What is being looked for, its page, and the request.
    pub running: Option<Measuring>,
    /// See `running`.
    pub asked: Option<(Page, Arc<Request>)>,
    /// Why the present page cannot be computed.
    pub problem: Option<String>,
    /// The selected design or solution, page by page.
    pub cursor: [usize; 5],
    /// Where chart and words have no room together, the words are shown.
    pub in_words: bool,
    /// Logarithmic axes across and up.
    pub log: (bool, bool),
}

impl Searching {
    /// What was found on the page shown.
    pub fn shown(&self) -> Option<&Found> {
        self.found[self.page.place()].as_ref()
    }

    /// The front shown, with what was asked.
    pub fn front(&self) -> Option<(&Front, &Task)> {
        match self.found[Page::Front.place()].as_ref().map(|found| (&found.answer, &*found.request))
        {
            Some((Answer::Front(front), Request::Front(task))) => Some((front, task)),
            Some(_) | None => None,
        }
    }

    /// The designs of the front, by the measure across.
    pub fn designs(&self) -> Vec<&Design> {
        let Some((front, task)) = self.front() else { return Vec::new() };
        let across = self.across(task).0;
        let mut designs: Vec<&Design> = front.designs.iter().collect();
        let value = |design: &Design| design.measures[across].unwrap_or(f64::NAN);
        designs.sort_by(|a, b| value(a).total_cmp(&value(b)));
        designs
    }

    /// The places of the measures drawn across and up.
    pub fn across(&self, task: &Task) -> (usize, usize) {
        let last = task.measures().len().saturating_sub(1);
        let (across, up) = self.setup.axes;
        (across.min(last), up.min(last))
    }

    /// How many things the cursor can stand on.
    pub fn choices(&self) -> usize {
        match self.shown().map(|found| &found.answer) {
            Some(Answer::Seek(report)) => report.solutions.len(),
            Some(Answer::Front(front)) => front.designs.len(),
            Some(Answer::Sensitivity(_) | Answer::Scatter(_) | Answer::Compare(_)) | None => 0,
        }
    }

    /// Whether there is something to draw on the page shown.
    fn draws(&self) -> bool {
        match self.shown().map(|found| &found.answer) {
            Some(Answer::Seek(report)) => report.scan.iter().any(|point| point.1.is_some()),
            Some(Answer::Front(front)) => !front.designs.is_empty(),
            Some(Answer::Scatter(report)) => {
                let drawn = |it: &&Summary| it.measure.name == self.setup.output;
                report.summaries.iter().find(drawn).is_some_and(|it| !it.sorted.is_empty())
            }
            Some(Answer::Compare(found)) => found.map.is_some(),
            Some(Answer::Sensitivity(_)) | None => false,
        }
    }

    /// Whether a right pane so high has no room for a chart and so many lines of words: then Tab turns from one to the other.
    pub fn is_crowded(&self, height: u16, lines: usize) -> bool {
        // A chart is drawn where four lines are left below it, or all there are.
        self.draws() && height < CHART_ROWS + words_rows(lines).min(LEAST_WORDS)
    }

    /// Of a right pane so high, the rows below the chart, frame included; all of them where there is no chart, none where it
    /// stands alone.
    pub fn words_height(&self, height: u16, lines: usize) -> u16 {
        match (self.draws(), self.is_crowded(height, lines)) {
            (true, false) => words_rows(lines).min(height - CHART_ROWS).max(3),
            (true, true) if !self.in_words => 0,
            (true, true) | (false, _) => height,
        }
    }

    /// The first line shown of a page without designs to choose from.
    pub fn scrolled(&self) -> usize {
        self.cursor[self.page.place()]
    }

    /// Select one of them.
    pub fn select(&mut self, at: usize) {
        self.cursor[self.page.place()] = at;
    }

    /// The selected one of them.
    pub fn selected(&self) -> usize {
        self.cursor[self.page.place()].min(self.choices().saturating_sub(1))
    }
}

/// Rows of a pane with so many lines, frame included.
fn words_rows(lines: usize) -> u16 {
    u16::try_from(lines).unwrap_or(u16::MAX).saturating_add(2)
}

impl App {
    /// Whether chart and words have no room together here; see [`Searching::is_crowded`].
    pub fn search_is_crowded(&self) -> bool {
        let Body::Search(_, area) = self.layout().body else { return false };
        let lines = self.search_lines(usize::from(area.width.saturating_sub(2))).len();
        self.searching.is_crowded(area.height, lines)
    }

    /// Whether what is shown belongs to another scene or another setup.
    pub fn search_is_old(&self) -> bool {
        let Some(found) = self.searching.shown() else { return false };
        let request = self.search_request(self.searching.page).ok();
        *found.scene != *self.scene || request.as_ref() != Some(&*found.request)
    }

    /// The design under the cursor as a scene, and its name for the list of edits.
    pub fn search_design(&self) -> Option<(Scene, String)> {
        let tab = &self.searching;
        let found = tab.shown()?;
        match (&found.answer, &*found.request) {
            (Answer::Seek(report), _) => {
                let at = report.solutions.get(tab.selected())?.place.at;
                let mut scene = (*found.scene).clone();
                (report.axis.number().set)(&mut scene, Some(at));
                Some((scene, format!("goal seek: {} {}", report.axis.symbol(), significant(at, 5))))
            }
            (Answer::Front(front), Request::Front(task)) => {
                let design = *tab.designs().get(tab.selected())?;
                let mut scene = (*found.scene).clone();
                scene.interface.law = front.law;
                for (axis, value) in task.axes.iter().zip(&design.values) {
                    (axis.number().set)(&mut scene, Some(*value));
                }
                Some((scene, format!("design {} of the front", tab.selected() + 1)))
            }
            (
                Answer::Front(_) | Answer::Sensitivity(_) | Answer::Scatter(_) | Answer::Compare(_),
                _,
            ) => None,
        }
    }

    /// What is selected, in words.
    pub fn search_readout(&self) -> Option<String> {
        let tab = &self.searching;
        if tab.on_setup {
            return Some(self.search_row_words());
        }
        if let Some(problem) = &tab.problem {
            return Some(problem.clone());
        }
        let found = tab.shown()?;
        match (&found.answer, &*found.request) {
            (Answer::Seek(report), _) => {
                let solution = report.solutions.get(tab.selected())?;
                let at = super::sweep::axis_value(&report.axis, solution.place.at);
                let value = report.measure.show(solution.place.value, 4);
                Some(format!("{} {at}: {value}; Enter opens it", report.axis.symbol()))
            }
            (Answer::Front(_), Request::Front(task)) => {
                let design = *tab.designs().get(tab.selected())?;
                let values = task.axes.iter().zip(&design.values);
                let values: Vec<String> = values
                    .map(|(axis, value)| format!("{} {}", axis.symbol(), significant(*value, 3)))
                    .collect();
                let results: Vec<String> = design
                    .measures
                    .iter()
                    .zip(task.measures())
                    .filter_map(|(value, column)| {
                        Some(format!("{} {}", setup::brief(column), column.show((*value)?, 3)))
                    })
                    .collect();
                Some(format!(
                    "#{}/{} {}: {}",
                    tab.selected() + 1,
                    tab.choices(),
                    values.join(" "),
                    results.join(", ")
                ))
            }
            (Answer::Sensitivity(_), _) => {
                Some("+-: 95 % confidence; v: the next search; r: again".to_owned())
            }
            (Answer::Front(_) | Answer::Scatter(_) | Answer::Compare(_), _) => {
                Some("v: the next search; z: this pane alone; r computes again".to_owned())
            }
        }
    }

    /// The parts of the status row in this tab; see [`App::status`].
    pub fn search_status(&self) -> Vec<(Severity, String, String)> {
        let same = |severity, text: String| (severity, text.clone(), text);
        let tab = &self.searching;
        let mine = tab.asked.as_ref().filter(|(page, _)| *page == tab.page);
        let mut parts = Vec::new();
        match (&tab.running, mine, tab.shown()) {
            (Some(running), Some(_), _) => {
                let of = running.points.map_or_else(String::new, |(done, total)| {
                    format!(": {done} of about {total} runs")
                });
                parts.push(same(Severity::Note, format!("searching{of} (Esc stops)")));
            }
            (Some(_), None, _) => {
                parts.push(same(
                    Severity::Note,
                    "another search is under way (Esc stops)".to_owned(),
                ));
            }
            (None, _, None) => match &tab.problem {
                Some(_) => {
                    parts.push(same(Severity::Error, "this cannot be looked for".to_owned()));
                }
                None => {
                    parts.push(same(Severity::Note, "not looked for yet: r searches".to_owned()));
                }
            },
            (None, _, Some(_)) if self.search_is_old() => {
                parts.push(same(Severity::Warning, "old: r searches again".to_owned()));
            }
            (None, _, Some(found)) => {
                let (done, runs) = told(&found.answer);
                let word = if done { "done" } else { "stopped: what there is is shown" };
                let severity = if done { Severity::Note } else { Severity::Warning };
                parts.push(same(severity, word.to_owned()));
                if let Some(runs) = runs {
                    parts.push(same(Severity::Note, runs));
                }
            }
        }
        parts.extend(self.validity_part());
        let law = crate::model::variables::find("interface.law");
        let law = law.map_or_else(|_| String::new(), |found| found.show(&self.scene));
        let law = format!("interface {law}");
        parts.push((Severity::Note, format!("{law} (i switches)"), law));
        parts
    }

    /// What is shown as a table; `None` where there is nothing.
    pub fn search_csv(&self) -> Option<Result<String, FileError>> {
        let found = self.searching.shown()?;
        let name = super::runs::name_of(&found.scene, &self.base.name, &self.base.scene);
        Some(match (&found.answer, &*found.request) {
            (Answer::Seek(report), _) => seek_file::rows(&name, report).csv(),
            (Answer::Front(front), Request::Front(task)) => {
                front_file::rows(&name, task, std::slice::from_ref(&**front)).csv()
            }
            (Answer::Front(_), _) => return None,
            (Answer::Sensitivity(report), _) => sensitivity_file::rows(&name, report).csv(),
            (Answer::Scatter(report), _) => scatter_file::rows(&name, report).csv(),
            (Answer::Compare(found), _) => compare_file::rows(&name, &found.report).csv(),
        })
    }
}

/// Whether an answer is whole, and how much went into it.
fn told(answer: &Answer) -> (bool, Option<String>) {
    match answer {
        Answer::Seek(report) => (report.is_complete, Some(format!("{} runs", report.runs))),
        Answer::Front(front) => {
            let text = format!("{} designs, {} runs", front.designs.len(), front.runs);
            (front.is_complete, Some(text))
        }
        Answer::Sensitivity(report) => (report.sobol.is_some(), None),
        Answer::Scatter(report) => {
            (report.is_complete, Some(format!("{} samples", report.samples)))
        }
        Answer::Compare(found) => (found.report.is_complete, None),
    }
}
