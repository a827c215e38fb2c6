//! The Thesis tab: its claims, its principles, its screening matrix.

pub(in crate::tui) mod draw;
pub(in crate::tui) mod keys;
pub mod state;

use ratatui::layout::Rect;

use crate::report::thesis;
use crate::study::principles;
use crate::study::screening::CRITERIA;
use crate::study::thesis::Row;
use crate::tui::app::App;
use crate::tui::app::jobs::{News, Running};
use crate::tui::app::notice::Severity;
use crate::tui::keymap::Action as A;
use crate::tui::keymap::{Action, Call, Command, Pane, PaneSpec, Part, key};
use crate::tui::message::Effect;
use crate::tui::pages::{About, Page, Rows, StatusPart, Tab, Table, note};
use crate::tui::widgets::Canvas;

/// The claims of the thesis.
pub const CLAIMS: Pane = Pane::of(Tab::Thesis, 0);
/// Its design principles.
pub const PRINCIPLES: Pane = Pane::of(Tab::Thesis, 1);
/// Its screening matrix.
pub const SCREENING: Pane = Pane::of(Tab::Thesis, 2);

#[rustfmt::skip]
const PANES: &[PaneSpec] = &[
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
        key(A::Enter, "open", "load the preset nearest to the first concept"),
    ] },
];

#[rustfmt::skip]
const COMMANDS: &[Command] = &[
    Command::new(Call::Do(A::Tab(Tab::Thesis)), "Thesis tab", "reproduce"),
    Command::new(Call::Show(CLAIMS, None), "Claims", "reproduce thesis check verdict"),
    Command::new(Call::Show(PRINCIPLES, None), "Principles", "families functions"),
    Command::new(Call::Show(SCREENING, None), "Screening", "matrix weights criteria concepts"),
];

/// What the workbench asks of this tab.
pub(in crate::tui) struct ThesisTab;

impl Page for ThesisTab {
    fn about(&self) -> &'static About {
        &About {
            name: "Thesis",
            pages: &["Claims", "Principles", "Screening"],
            panes: PANES,
            commands: COMMANDS,
        }
    }

    fn shown_panes(&self, app: &App) -> Vec<Pane> {
        vec![app.pane()]
    }

    fn shown(&self, app: &App) -> usize {
        PANES.iter().position(|spec| spec.pane == app.pane()).unwrap_or(0)
    }

    fn turn_to(&self, app: &mut App, page: usize) -> Vec<Effect> {
        app.focus_on(PANES[page.min(PANES.len() - 1)].pane);
        self.enter(app)
    }

    fn enter(&self, app: &mut App) -> Vec<Effect> {
        keys::enter(app)
    }

    fn act(&self, app: &mut App, action: Action) -> Option<Vec<Effect>> {
        keys::act(app, action)
    }

    fn readout(&self, app: &App, _room: usize) -> Option<(Severity, String)> {
        note(app.thesis_readout())
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        app.thesis_status()
    }

    fn report(&self, app: &mut App, _running: &Running, news: &News) {
        if let Some(found) = news.found() {
            app.pages.thesis.report = Some(found);
        }
    }

    fn table(&self, app: &App) -> Option<Table> {
        let (file, text) = match app.pane() {
            PRINCIPLES => ("principles.csv", thesis::principles().csv()),
            SCREENING => ("screening.csv", thesis::screening(&app.pages.thesis.weights).csv()),
            _ => {
                // Of the claims those that are shown, as far as they are checked.
                let shown: Vec<Row> = app.claims().into_iter().cloned().collect();
                ("claims.csv", (!shown.is_empty()).then(|| thesis::claims(&shown).csv())?)
            }
        };
        Some(Table::new("Export this page to CSV", file, None, move || text.clone()))
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
        (app.pane() == CLAIMS).then_some(&mut app.find.claims)
    }

    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>) {
        draw::render(app, body, canvas);
    }
}
