//! The Run tab: one impact, with its variables, its charts and the runs to compare with.

pub mod charts;
pub mod editor;
pub(in crate::tui) mod keys;
pub(in crate::tui) mod layout;
pub(in crate::tui) mod mechanism;
pub mod runs;
pub(in crate::tui) mod side;
pub mod steps;
pub mod summary;

use ratatui::layout::Rect;

use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::keymap::Action as A;
use crate::tui::keymap::{Action, Call, Command, Pane, PaneSpec, Part, key};
use crate::tui::message::Effect;
use crate::tui::pages::{About, Page, Rows, StatusPart, Tab, note};
use crate::tui::update::edit;
use crate::tui::update::zoom::Across;
use crate::tui::widgets::Canvas;

/// The list of variables.
pub const VARIABLES: Pane = Pane::of(Tab::Run, 0);
/// The charts.
pub const CHARTS: Pane = Pane::of(Tab::Run, 1);
/// The table of runs.
pub const RUNS: Pane = Pane::of(Tab::Run, 2);

#[rustfmt::skip]
const PANES: &[PaneSpec] = &[
    PaneSpec { pane: VARIABLES, label: "Variables", has: &[Part::Form], keys: &[
        key(A::Enter, "type", "type the value: 25.4mm, 7.5MN/m, 1/3, *2, +5%; of a choice, list its words"),
        key(A::Right, "change", "change the value by a step (H L ten steps, , . a tenth)"),
        key(A::Down, "move", "move to another variable"),
        key(A::Find, "find", "find a variable by symbol or word"),
        key(A::Mark, "pin", "pin this run to compare with (A to H)"),
        key(A::Reset, "reset", "reset this row to the preset's value"),
    ] },
    PaneSpec { pane: CHARTS, label: "Charts", has: &[Part::Chart], keys: &[
        key(A::Right, "cursor", "move the cursor in time (H L ten columns)"),
        key(A::View, "view", "show another quantity in this chart, or force over displacement"),
        key(A::EventNext, "event", "move the cursor to the next event"),
        key(A::ZoomIn, "zoom", "zoom about the cursor"),
        key(A::Window, "window", "show the contact only, or the whole response"),
        key(A::Down, "chart", "select the chart below or above"),
        key(A::Mark, "pin", "pin this run to compare with (A to H)"),
        key(A::SecondAxis, "2nd axis", "show another quantity of the same run on an axis at the right, at last none"),
        key(A::Difference, "", "show curves as differences to the first pinned run"),
    ] },
    PaneSpec { pane: RUNS, label: "Runs", has: &[Part::Table], keys: &[
        key(A::Enter, "load", "load this pinned run's scene"),
        key(A::Mark, "pin/unpin", "pin the current run, or unpin the selected one"),
        key(A::ShowHide, "show/hide", "draw this run or leave it out"),
        key(A::Difference, "difference", "show curves as differences to the first pinned run"),
        key(A::Down, "move", "select another run"),
        key(A::Sort, "sort", "sort the table by the next column"),
    ] },
];

#[rustfmt::skip]
const COMMANDS: &[Command] = &[
    Command::new(Call::Do(A::Tab(Tab::Run)), "Run tab", "variables charts curves impact simulation"),
    Command::new(Call::In(VARIABLES, A::Find), "Find a variable", "filter search"),
    Command::new(Call::In(CHARTS, A::View), "Next quantity of the chart", "velocity force displacement stress yield"),
    Command::new(Call::In(CHARTS, A::Window), "Contact or whole response", "window time"),
    Command::new(Call::In(CHARTS, A::SecondAxis), "Second axis of the chart", "right"),
    Command::new(Call::In(CHARTS, A::Difference), "Differences to the first pinned run", "compare subtract"),
    Command::new(Call::In(CHARTS, A::EventNext), "Next event", "arrest cursor"),
    Command::new(Call::In(CHARTS, A::FitVertical), "Fit the vertical axis to the view or to everything", "scale"),
    Command::new(Call::In(CHARTS, A::LogX), "Logarithmic or linear time axis", "log x"),
    Command::new(Call::In(CHARTS, A::LogY), "Logarithmic or linear value axis", "log y"),
    Command::new(Call::In(CHARTS, A::ZoomFit), "Show everything", "fit zoom"),
];

/// What the workbench asks of this tab.
pub(in crate::tui) struct RunTab;

impl Page for RunTab {
    fn about(&self) -> &'static About {
        &About { name: "Run", pages: &[], panes: PANES, commands: COMMANDS }
    }

    fn act(&self, app: &mut App, action: Action) -> Option<Vec<Effect>> {
        keys::act(app, action)
    }

    fn readout(&self, app: &App, room: usize) -> Option<(Severity, String)> {
        match app.pane() {
            CHARTS if app.charts.cursor_s.is_some() => note(Some(app.readout())),
            VARIABLES => note(Some(app.variable_words(room))),
            _ => None,
        }
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        app.run_status()
    }

    fn rows(&self, app: &App) -> Option<Rows> {
        match app.pane() {
            VARIABLES => {
                let listed = app.editor.listed(&app.scene);
                let selected = listed.iter().position(|index| *index == app.editor.selected);
                let shown = layout::variable_rows(app);
                Some(Rows { count: listed.len(), selected: selected.unwrap_or(0), shown })
            }
            RUNS => {
                let order = app.run_order();
                let selected = order.iter().position(|run| *run == app.selected_run).unwrap_or(0);
                Some(Rows { count: order.len(), selected, shown: 8 })
            }
            _ => Some(Rows {
                count: app.charts.quantities.len(),
                selected: app.charts.selected,
                shown: 3,
            }),
        }
    }

    fn select(&self, app: &mut App, row: usize) {
        match app.pane() {
            VARIABLES => {
                if let Some(index) = app.editor.listed(&app.scene).get(row) {
                    app.editor.selected = *index;
                }
            }
            RUNS => app.selected_run = app.run_order().get(row).copied().unwrap_or(0),
            _ => app.charts.selected = row,
        }
    }

    fn row_name(&self, app: &App, row: usize) -> Option<String> {
        let pins = || app.pins.get(app.run_order().get(row)?.checked_sub(1)?);
        let name = || {
            pins().map_or_else(|| "now".to_owned(), |pin| format!("{} {}", pin.letter, pin.name))
        };
        (app.pane() == RUNS).then(name)
    }

    fn filter<'a>(&self, app: &'a mut App) -> Option<&'a mut String> {
        (app.pane() == VARIABLES).then_some(&mut app.editor.filter)
    }

    fn takes_unit(&self, _app: &App) -> bool {
        true
    }

    fn text(&self, app: &App, _row: usize) -> String {
        app.editor.variable().show(&app.scene)
    }

    fn take(&self, app: &mut App, _row: usize, text: &str) -> Result<Vec<Effect>, String> {
        edit::type_value(app, app.editor.selected, text)
    }

    fn across<'a>(&self, app: &'a mut App) -> Option<Across<'a>> {
        (app.pane() == CHARTS).then(|| app.time_across())
    }

    fn go_to_value(&self, app: &mut App, chart: usize, value: f64) {
        app.charts.selected = chart;
        app.bring_into_view(value);
    }

    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>) {
        let panes = layout::panes(app, body);
        if let Some(area) = panes.variables {
            editor::draw::render(app, area, app.has_focus(VARIABLES), canvas);
        }
        charts::draw::render(app, &panes.charts, app.has_focus(CHARTS), canvas);
        if let Some(area) = panes.runs {
            runs::draw::render(app, area, app.has_focus(RUNS), canvas);
        }
        if let Some(area) = panes.events {
            side::events(app, area, canvas);
        }
        if let Some(area) = panes.mechanism {
            mechanism::render(app, area, canvas);
        }
        if let Some(area) = panes.ledger {
            side::ledger(app, area, canvas);
        }
    }
}
