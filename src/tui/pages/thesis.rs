//! The Thesis tab: its claims, its principles, its screening matrix.

pub(crate) mod draw;

use crate::report::thesis;
use crate::study::principles;
use crate::study::screening::{CONCEPTS, CRITERIA, WEIGHTS_PERCENT, ranking};
use crate::study::sweep::Sampling;
use crate::study::thesis::{ClaimVerdict, Opens, Row, claims, reproduce, tally};
use crate::tui::app::Base;
use crate::tui::app::find::{rank, ranked};
use crate::tui::app::history::Stepping;
use crate::tui::app::status::fitting;
use crate::tui::dialogs::around;
use crate::tui::dialogs::presets::base_of;
use crate::tui::pages::explore::state::Picture;
use crate::tui::pages::prelude::*;
use crate::tui::pages::run::{self, step_of};
use crate::tui::pages::{self, explore};

pub const CLAIMS: Pane = Pane::of(Tab::Thesis, 0);
pub const PRINCIPLES: Pane = Pane::of(Tab::Thesis, 1);
pub const SCREENING: Pane = Pane::of(Tab::Thesis, 2);

#[rustfmt::skip]
pub(super) const PANES: &[PaneSpec] = &[
    PaneSpec { pane: CLAIMS, label: "Claims", has: &[Part::Table], keys: &[
        key(A::Down, "claim", "select another claim"),
        key(A::Enter, "open", "load the claim's scene and show it"),
        key(A::View, "verdict", "show only the rows with the next verdict, or all"),
        key(A::Find, "find", "find a claim"),
        key(A::Sort, "sort", "sort the table by the next column"),
    ] },
    PaneSpec { pane: PRINCIPLES, label: "Principles", has: &[], keys: &[
        key(A::Down, "principle", "select another principle"),
        key(A::Enter, "open", "load the preset that shows the principle"),
        key(A::Find, "find", "find a principle"),
    ] },
    PaneSpec { pane: SCREENING, label: "Screening", has: &[Part::Form], keys: &[
        key(A::Right, "weight", "change the weight by a percent"),
        key(A::Down, "criterion", "select another criterion"),
        key(A::Reset, "printed", "reset the weight to the printed one"),
        key(A::Enter, "open", "load the preset of the concept that ranks first"),
    ] },
];

pub(super) const PAGES: &[PageSpec] = &[
    PageSpec { name: "Claims", panes: &[CLAIMS] },
    PageSpec { name: "Principles", panes: &[PRINCIPLES] },
    PageSpec { name: "Screening", panes: &[SCREENING] },
];

#[rustfmt::skip]
pub(super) const COMMANDS: &[Command] = &[
    Command::new(Call::Do(A::Tab(Tab::Thesis)), "Thesis tab", "reproduce"),
    Command::new(Call::Show(CLAIMS, None), "Claims", "reproduce thesis check verdict"),
    Command::new(Call::Show(PRINCIPLES, None), "Principles", "families functions"),
    Command::new(Call::Show(SCREENING, None), "Screening", "matrix weights criteria concepts"),
];

pub(crate) struct ThesisTab;

impl Page for ThesisTab {
    fn enter(&self, app: &mut App) {
        let lacks = app.jobs.lacks::<Claims, _>(&app.pages.thesis.report, &Scene::default());
        if lacks && app.pane() == CLAIMS {
            check(app);
        }
    }

    fn act(&self, app: &mut App, action: Action) -> bool {
        let pane = app.pane();
        if let (SCREENING, Some(press)) = (pane, step_of(action)) {
            let step = STEP * press.size.factor();
            let (mut weights, at) = (app.pages.thesis.weights, app.pages.thesis.criterion);
            weights[at] =
                (weights[at] + if press.up { step } else { -step }).clamp(0.0, WEIGHT_MAX);
            weigh(app, weights, Some(at));
            return true;
        }
        match action {
            Action::Run => check(app),
            Action::Enter => open(app),
            Action::View if pane == CLAIMS => app.pages.thesis.next_filter(),
            Action::Sort => app.pages.thesis.by_verdict = !app.pages.thesis.by_verdict,
            Action::Reset => {
                let (mut weights, at) = (app.pages.thesis.weights, app.pages.thesis.criterion);
                weights[at] = WEIGHTS_PERCENT[at];
                weigh(app, weights, None);
                app.tell("weight reset to that of Table 7.1 (<undo> undoes)");
            }
            _ => return false,
        }
        true
    }

    fn readout(&self, app: &App, _room: usize) -> Option<(Severity, String)> {
        let tab = &app.pages.thesis;
        let text = match app.pane() {
            CLAIMS => {
                let row = app.claim()?;
                let opens = match row.claim.opens() {
                    Opens::Nothing => "no scene shows this".to_owned(),
                    Opens::Scene(_) => "<enter> opens its scene".to_owned(),
                    Opens::Preset(name) => format!("<enter> opens {name}"),
                };
                // The cause is in the detail: a line that changes its height here would move the list.
                let verdict = row.found.verdict;
                format!("{} {}: {opens}", verdict.letter(), verdict.words())
            }
            // Its name is selected in the list and heads the detail.
            PRINCIPLES => match principles::PRINCIPLES[tab.principle].preset {
                Some(name) => format!("<enter> opens {name}"),
                None => "no preset shows it".to_owned(),
            },
            // In one row of the narrowest screen: a second one would hide the ranks.
            _ => format!(
                "{}: {} %, printed {} %",
                CRITERIA[tab.criterion],
                significant(tab.weights[tab.criterion], 4),
                significant(WEIGHTS_PERCENT[tab.criterion], 4),
            ),
        };
        note(Some(text))
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        let tab = &app.pages.thesis;
        let mut parts = Vec::new();
        let words = |it: &Running| format!("checking the claims{}", it.counted("of", ""));
        let checking = progress::<Claims, _>(app, &tab.report, &Scene::default(), words);
        parts.extend(checking.map(Progress::part));
        if tab.report.found.is_some() {
            let (rows, counts) = (tab.rows(), tally(tab.rows()));
            let listed = |show: fn(ClaimVerdict, usize) -> String| {
                let parts = ClaimVerdict::ALL.iter().zip(counts);
                let parts = parts.map(|(verdict, count)| show(*verdict, count));
                parts.collect::<Vec<_>>().join(", ")
            };
            let full = listed(|verdict, count| format!("{count} {}", verdict.words()));
            let full = format!("{} rows: {full}", rows.len());
            // The letters are those of the list.
            let brief =
                listed(|verdict, count| format!("{}{count} {}", verdict.letter(), verdict.brief()));
            let letters = listed(|verdict, count| format!("{count} {}", verdict.letter()));
            let room = usize::from(app.size.0.saturating_sub(2));
            parts.push((Severity::Note, full, fitting([brief, letters], room)));
        }
        parts
    }

    fn report(&self, app: &mut App, running: &Running, news: &ReportBody) {
        app.pages.thesis.report.keep(running, news, |report| report.is_complete);
    }

    fn table(&self, app: &App) -> Option<PageTable> {
        let tab = &app.pages.thesis;
        let (file, is_complete, text) = match app.pane() {
            PRINCIPLES => ("principles.csv", true, thesis::principles().csv()),
            SCREENING => ("screening.csv", true, thesis::screening(&tab.weights).csv()),
            _ => {
                // Of the claims those that are shown, as far as they are checked.
                let shown: Vec<Row> = app.claims().into_iter().cloned().collect();
                let text = (!shown.is_empty()).then(|| thesis::claims(&shown).csv())?;
                ("claims.csv", tab.report.is_complete, text)
            }
        };
        Some(PageTable::new("Export this page to CSV", file, is_complete, move |_| text.clone()))
    }

    fn rows(&self, app: &App) -> Option<Rows> {
        let tab = &app.pages.thesis;
        let (count, selected) = match app.pane() {
            CLAIMS => (app.claims().len(), tab.selected),
            PRINCIPLES => (principles::PRINCIPLES.len(), tab.principle),
            _ => (CRITERIA.len(), tab.criterion),
        };
        Some(Rows { count, selected, shown: app.list_rows() })
    }

    fn select(&self, app: &mut App, row: usize) {
        match app.pane() {
            CLAIMS => app.pages.thesis.selected = row,
            PRINCIPLES => app.pages.thesis.principle = row,
            _ => app.pages.thesis.criterion = row,
        }
    }

    fn row_name(&self, app: &App, row: usize) -> Option<String> {
        match app.pane() {
            CLAIMS => None,
            PRINCIPLES => {
                principles::PRINCIPLES.get(row).map(|it| format!("{} {}", it.name, it.family))
            }
            _ => CRITERIA.get(row).map(|name| (*name).to_owned()),
        }
    }

    fn filter<'a>(&self, app: &'a mut App) -> Option<&'a mut String> {
        (app.pane() == CLAIMS).then_some(&mut app.pages.thesis.find)
    }

    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>) {
        draw::render(app, body, canvas);
    }
}

const STEP: f64 = 1.0;
const WEIGHT_MAX: f64 = 100.0;

/// Check the claims; the scene plays no part.
fn check(app: &mut App) {
    jobs::study_of(app, Tab::Thesis, &Arc::default(), Claims);
}

/// Other weights, as one edit; steps of one criterion join.
fn weigh(app: &mut App, weights: [f64; 7], stepped: Option<usize>) {
    let before = app.snapshot();
    app.pages.thesis.weights = weights;
    if weights.map(f64::to_bits) == before.weights.map(f64::to_bits) {
        return;
    }
    let stepping = stepped.map(Stepping::Weight);
    let label = match stepped {
        None => "printed weights".to_owned(),
        Some(at) => {
            let first = app.history.extended(stepping).unwrap_or(&before).weights[at];
            let percent = |weight| significant(weight, 4);
            format!("{} {} -> {} %", CRITERIA[at], percent(first), percent(weights[at]))
        }
    };
    edit::note(app, before, label, stepping);
}

/// Open what the selected row shows, as one edit: a sweep in its tab, another scene in the Run tab.
fn open(app: &mut App) {
    let tab = &app.pages.thesis;
    let row = app.claim();
    let opens = match app.pane() {
        PRINCIPLES => {
            principles::PRINCIPLES[tab.principle].preset.map_or(Opens::Nothing, Opens::Preset)
        }
        SCREENING => Opens::Preset(CONCEPTS[ranking(&tab.weights)[0].concept].preset),
        _ => row.map_or(Opens::Nothing, |row| row.claim.opens()),
    };
    let id = row.map_or("claim", |row| row.claim.id);
    let base = match opens {
        Opens::Nothing => None,
        Opens::Scene(scene) => Some(Base {
            name: format!("claim {id}"),
            is_mine: false,
            scene: Arc::new(scene.clone()),
        }),
        Opens::Preset(name) => {
            app.presets.iter().find(|entry| entry.name == name).cloned().map(base_of)
        }
    };
    let Some(base) = base else {
        return app.tell("no scene shows this");
    };
    show(app, base);
}

/// Load a scene and show what it is about: a sweep in Explore, else its run.
pub(crate) fn show(app: &mut App, base: Base) {
    let name = base.name.clone();
    let axes = base.scene.sweep.as_ref().map_or(0, |sweep| sweep.axes.len());
    // The sweep as the preset has it, whatever was looked at before.
    let mut plan = app.pages.explore.plan;
    if axes > 0 {
        plan.picture = if axes == 1 { Picture::Line } else { Picture::Surface };
        plan.samplings = [Sampling::Factorial; 2];
    }
    edit::load(app, base, plan);
    if axes == 0 {
        app.focus_on(run::VARIABLES);
        return;
    }
    app.focus_on(explore::RESULTS);
    app.pages.explore.output = 0;
    app.pages.explore.cursor = [None; 2];
    app.pages.explore.zoomed = None;
    pages::of(Tab::Explore).enter(app);
    app.tell(format!("{name} loaded, here is its sweep (<undo> undoes)"));
}

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

#[derive(Clone, Debug)]
pub struct Thesis {
    pub report: Kept<RowsSoFar<Row>>,
    pub filter: Option<ClaimVerdict>,
    /// The claims shown match this.
    pub find: String,
    pub by_verdict: bool,
    pub selected: usize,
    pub principle: usize,
    pub criterion: usize,
    /// Weights of the criteria, percent.
    pub weights: [f64; 7],
}

impl Default for Thesis {
    fn default() -> Self {
        Self {
            report: Kept::default(),
            filter: None,
            find: String::new(),
            by_verdict: false,
            selected: 0,
            principle: 0,
            criterion: 0,
            weights: WEIGHTS_PERCENT,
        }
    }
}

impl Thesis {
    pub fn rows(&self) -> &[Row] {
        self.report.found.as_ref().map_or(&[], |report| &report.rows)
    }

    /// The next verdict to filter by; after the last one, all rows.
    pub fn next_filter(&mut self) {
        let all: Vec<Option<ClaimVerdict>> =
            std::iter::once(None).chain(ClaimVerdict::ALL.into_iter().map(Some)).collect();
        (self.filter, self.selected) = (around(&all, self.filter, 1), 0);
    }
}

impl App {
    /// The claims shown: of the wanted verdict, and those that match what is looked for, best first.
    pub fn claims(&self) -> Vec<&Row> {
        let tab = &self.pages.thesis;
        let passes = |row: &&Row| tab.filter.is_none_or(|wanted| row.found.verdict == wanted);
        let mut rows = ranked(tab.rows().iter().filter(passes), |row| {
            let claim = &row.claim;
            rank(&tab.find, &[claim.id, claim.place], claim.says)
        });
        if tab.by_verdict {
            let order =
                |row: &&Row| ClaimVerdict::ALL.iter().position(|it| *it == row.found.verdict);
            rows.sort_by_key(order);
        }
        rows
    }

    pub fn claim(&self) -> Option<&Row> {
        self.claims().get(self.pages.thesis.selected).copied()
    }
}
