//! The Thesis tab: what is computed of the thesis, its design principles, its screening of concepts.

pub(crate) mod draw;
pub mod state;

use crate::report::thesis;
use crate::study::thesis::{ClaimVerdict, Row, tally};
use crate::tui::pages::explore;
use crate::tui::pages::explore::plan::is_corrected_figure;
use crate::tui::pages::explore::state::Picture;
use crate::tui::pages::page::prelude::*;
use crate::tui::pages::run;
use crate::tui::preset::Base;
use crate::tui::widgets::find::{rank, ranked};
use crate::worker::studies::Claims;

pub use state::{CLAIMS, CONCEPTS, PRINCIPLES};

#[rustfmt::skip]
const PANES: &[PaneSpec] = &[
    PaneSpec { pane: CLAIMS, label: "Claims", keys: &[
        key(A::Down, "claim", "select another claim"),
        key(A::Enter, "open", "load the preset that shows the claim"),
        key(A::Find, "find", "find a claim"),
    ] },
    PaneSpec { pane: PRINCIPLES, label: "Principles", keys: &[] },
    PaneSpec { pane: CONCEPTS, label: "Concepts", keys: &[] },
];

const PAGES: &[PageSpec] = &[
    PageSpec { name: "Claims", panes: &[CLAIMS] },
    PageSpec { name: "Principles", panes: &[PRINCIPLES] },
    PageSpec { name: "Concepts", panes: &[CONCEPTS] },
];

#[rustfmt::skip]
const COMMANDS: &[Command] = &[
    Command::new(Call::Do(A::Tab(Tab::Thesis)), "Thesis tab", "reproduce"),
    Command::new(Call::Show(CLAIMS, None), "Claims", "reproduce thesis check verdict"),
    Command::new(Call::Show(PRINCIPLES, None), "Principles", "families functions"),
    Command::new(Call::Show(CONCEPTS, None), "Concepts", "screening matrix weights criteria ratings"),
];

pub(crate) struct ThesisTab;

impl Page for ThesisTab {
    fn about(&self) -> About {
        About { pages: PAGES, panes: PANES, commands: COMMANDS }
    }

    fn enter(&self, app: &mut App) {
        let lacks = app.jobs.lacks::<Claims, _>(&app.pages.thesis.report, &Scene::default());
        if lacks && app.pane() == CLAIMS {
            check(app);
        }
    }

    fn act(&self, app: &mut App, action: Action) -> bool {
        if app.pane() != CLAIMS {
            return false;
        }
        match action {
            Action::Run => check(app),
            Action::Enter => open(app),
            _ => return false,
        }
        true
    }

    fn readout(&self, app: &App, _room: usize) -> Option<(Severity, String)> {
        let claim = app.claim().filter(|_| app.pane() == CLAIMS)?.claim;
        let opens = match claim.preset {
            Some(name) => format!("<enter> opens {name}"),
            None => "no preset shows this".to_owned(),
        };
        // The cause is in the detail: a line that changes its height here would move the list.
        note(Some(format!("{} {}: {opens}", claim.verdict.letter(), claim.verdict.words())))
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        let tab = &app.pages.thesis;
        let mut parts = Vec::new();
        let words = |it: &Running| format!("checking the claims{}", it.counted("of", ""));
        let checking = progress::<Claims, _>(app, &tab.report, &Scene::default(), words);
        parts.extend(checking.map(Progress::part));
        if tab.report.found.is_some() {
            let counts = ClaimVerdict::ALL.iter().zip(tally(tab.rows()));
            let counts: Vec<String> =
                counts.map(|(verdict, count)| format!("{count} {}", verdict.words())).collect();
            parts.push(part(Severity::Note, counts.join(", ")));
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
            CONCEPTS => ("concepts.csv", true, thesis::concepts().csv()),
            _ => {
                // Of the claims those that are shown, as far as they are checked.
                let shown: Vec<Row> = app.claims().into_iter().cloned().collect();
                let text = (!shown.is_empty()).then(|| thesis::claims(&shown).csv())?;
                ("claims.csv", tab.report.is_complete, text)
            }
        };
        Some(PageTable::new("Export this page to CSV", file, is_complete, move || text.clone()))
    }

    fn rows(&self, app: &App) -> Option<Rows> {
        let (count, selected) = (app.claims().len(), app.pages.thesis.selected);
        (app.pane() == CLAIMS).then(|| Rows { count, selected, shown: app.list_rows() })
    }

    fn select(&self, app: &mut App, row: usize) {
        app.pages.thesis.selected = row;
    }

    fn filter<'a>(&self, app: &'a mut App) -> Option<&'a mut String> {
        (app.pane() == CLAIMS).then_some(&mut app.pages.thesis.find)
    }

    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>) {
        draw::render(app, body, canvas);
    }
}

/// Check the claims; the scene plays no part.
fn check(app: &mut App) {
    jobs::study_of(app, &Arc::default(), Claims);
}

/// Open the preset that shows the selected claim: a sweep in its tab, another scene in the Run tab.
fn open(app: &mut App) {
    let preset = app.claim().and_then(|row| row.claim.preset);
    let entry = app.files.presets.iter().find(|entry| Some(entry.name.as_str()) == preset);
    match entry.cloned() {
        Some(entry) => show(app, entry.base()),
        None => app.tell("no preset shows this"),
    }
}

/// Load a scene and show what it is about: a sweep in Explore, else its run.
pub(crate) fn show(app: &mut App, base: Base) {
    let (name, axes) = (base.name.clone(), axes(&base.scene));
    let picture = picture_of(app, &base);
    edit::load(app, base, picture);
    look(app);
    if axes > 0 {
        app.tell(format!("{name} loaded, here is its sweep (<undo> undoes)"));
    }
}

/// Axes of the sweep that a scene keeps.
fn axes(scene: &Scene) -> usize {
    scene.sweep.as_ref().map_or(0, |sweep| sweep.axes.len())
}

/// How the sweep of a preset is shown, whatever was looked at before: over two axes as a map, but figures of the thesis as curves, which
/// have the printed scheme's beside them.
fn picture_of(app: &App, base: &Base) -> Picture {
    match axes(&base.scene) {
        0 => app.picture(),
        2.. if !is_corrected_figure(base) => Picture::Surface,
        _ => Picture::Line,
    }
}

/// Begin with what the scene is about, as if its preset had been loaded.
pub(crate) fn begin(app: &mut App) {
    app.pages.explore.picture = picture_of(app, &app.base);
    look(app);
}

/// Show what the scene is about: a sweep in Explore, else its run.
fn look(app: &mut App) {
    if axes(&app.scene) == 0 {
        app.focus_on(run::VARIABLES);
        return;
    }
    app.focus_on(explore::RESULTS);
    app.pages.explore.output = 0;
    app.pages.explore.cursor = None;
    explore::ExploreTab.enter(app);
}

impl App {
    /// The claims shown: those that match what is looked for, best first.
    pub fn claims(&self) -> Vec<&Row> {
        let tab = &self.pages.thesis;
        ranked(tab.rows().iter(), |row| {
            let claim = &row.claim;
            rank(&tab.find, &[claim.id, claim.place], claim.says)
        })
    }

    pub fn claim(&self) -> Option<&Row> {
        self.claims().get(self.pages.thesis.selected).copied()
    }
}
