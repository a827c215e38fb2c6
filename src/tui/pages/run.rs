//! The Run tab: one impact, with its variables, its charts and the runs to compare with.

pub mod charts;
pub mod editor;
pub(crate) mod report;
pub mod runs;
pub mod steps;

use crate::model::variables::Kind;
use crate::tui::app::layout::{NARROW, ROOMY, WIDE};
use crate::tui::dialogs::List;
use crate::tui::pages;
use crate::tui::pages::prelude::*;
use crate::tui::pages::run::steps::{Input, Press, Size};
use crate::tui::update;

pub const VARIABLES: Pane = Pane::of(Tab::Run, 0);
pub const CHARTS: Pane = Pane::of(Tab::Run, 1);
pub const RUNS: Pane = Pane::of(Tab::Run, 2);

#[rustfmt::skip]
pub(super) const PANES: &[PaneSpec] = &[
    PaneSpec { pane: VARIABLES, label: "Variables", has: &[Part::Form], keys: &[
        key(A::Right, "step", "change the value by a step (<far-left> <far-right> ten steps, <fine-less> <fine-more> a tenth)"),
        key(A::Enter, "type", "type the value (25.4mm, 1/3, *2, +5%), or choose from a list"),
        key(A::Mark, "pin", "pin this run to compare with (A to H)"),
        key(A::Presets, "presets", "load a preset, a threat, a material or an absorber"),
        key(A::Export, "export", "export this run and the pinned ones"),
        key(A::Window, "chart", "contact or whole in the selected chart; <full-pane> enlarges it"),
        key(A::Down, "", "move to another variable; below the last one More unfolds"),
        key(A::Find, "find", "find a variable by symbol or word"),
        key(A::Reset, "reset", "reset this row to the preset's value"),
    ] },
    PaneSpec { pane: CHARTS, label: "Charts", has: &[Part::Chart], keys: &[
        key(A::Enter, "enlarge", "show the selected chart alone, or all of them again"),
        key(A::Window, "contact/whole", "show the contact, or the whole response"),
        key(A::Down, "chart", "select the chart below or above"),
        key(A::Right, "cursor", "move the cursor in time (<far-left> <far-right> ten columns)"),
        key(A::View, "view", "show another quantity: F(x), stiffness and stress come last"),
        key(A::EventNext, "event", "move the cursor to the next event"),
        key(A::ZoomIn, "zoom", "zoom about the cursor"),
        key(A::Mark, "pin", "pin this run to compare with (A to H)"),
        key(A::Difference, "", "show curves as differences to the first pinned run"),
    ] },
    PaneSpec { pane: RUNS, label: "Runs", has: &[Part::Table], keys: &[
        key(A::Enter, "load", "load this pinned run's scene"),
        key(A::Mark, "pin/unpin", "pin the current run, or unpin the selected one"),
        key(A::ShowHide, "show/hide", "show or hide this run"),
        key(A::Difference, "difference", "show curves as differences to the first pinned run"),
        key(A::Down, "move", "select another run"),
        key(A::Sort, "sort", "sort the table by the next column"),
        key(A::Find, "filter", "show only the runs that match a text"),
    ] },
];

pub(super) const PAGES: &[PageSpec] = &[];

#[rustfmt::skip]
pub(super) const COMMANDS: &[Command] = &[
    Command::new(Call::Do(A::Tab(Tab::Run)), "Run tab", "variables charts curves impact simulation"),
    Command::new(Call::In(VARIABLES, A::Find), "Find a variable", "filter search"),
    Command::new(Call::In(VARIABLES, A::Reset), "Reset this variable to the preset", "default"),
    Command::new(Call::In(CHARTS, A::View), "Next quantity of the chart", "velocity force displacement stress yield stiffness"),
    Command::new(Call::In(CHARTS, A::Window), "Contact or whole response", "window time"),
    Command::new(Call::In(CHARTS, A::Difference), "Differences to the first pinned run", "compare subtract"),
    Command::new(Call::In(CHARTS, A::EventNext), "Next event", "arrest cursor"),
    Command::new(Call::In(CHARTS, A::FitVertical), "Fit the vertical axis to the view or to everything", "scale"),
    Command::new(Call::In(CHARTS, A::LogX), "Logarithmic or linear time axis", "log x"),
    Command::new(Call::In(CHARTS, A::LogY), "Logarithmic or linear value axis", "log y"),
    Command::new(Call::In(CHARTS, A::ZoomFit), "Show everything", "fit zoom"),
];

pub(crate) struct RunTab;

impl Page for RunTab {
    fn act(&self, app: &mut App, action: Action) -> bool {
        match (action, app.pane()) {
            (Action::Run, _) => jobs::run_now(app),
            (Action::Enter, CHARTS) => return self.act(app, Action::FullPane),
            (Action::FullPane, pane) => {
                // A list of variables is no better alone: the chart is meant.
                app.focus_on(if pane == VARIABLES { CHARTS } else { pane });
                let full = &mut app.full_pane[Tab::Run.index()];
                *full = !*full;
            }
            (_, CHARTS) | (Action::Difference, RUNS) | (Action::Window, VARIABLES) => {
                return charts::act(app, action);
            }
            (Action::Mark, RUNS) if app.selected_run > 0 => runs::unpin(app),
            (Action::Mark, _) => runs::pin_scene(app),
            (Action::Enter, RUNS) => runs::load(app),
            (Action::ShowHide, RUNS) => runs::show_or_hide(app),
            (Action::Sort, RUNS) => {
                let sorting = app.runs.sorting.next(&app.compared_runs().keys());
                app.runs.sorting = sorting;
            }
            (_, VARIABLES) if edits(action) && !app.editor.shows(&app.scene) => {
                app.tell("no variable is selected: <back> shows all of them");
            }
            (Action::Enter, VARIABLES) => open(app),
            (Action::Reset, VARIABLES) => edit::reset(app),
            (_, VARIABLES) => match step_of(action) {
                Some(press) => edit::step(app, press),
                None => return false,
            },
            _ => return false,
        }
        true
    }

    fn readout(&self, app: &App, room: usize) -> Option<(Severity, String)> {
        match app.pane() {
            CHARTS if app.charts.cursor_s.is_some() => note(Some(app.readout())),
            CHARTS => note(Some(charts::draw::event_words(app, app.charts.selected))),
            RUNS => note(runs::difference(app)),
            VARIABLES if app.editor.shows(&app.scene) => note(Some(app.variable_words(room))),
            _ => None,
        }
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        report::status(app).into_iter().chain(app.run_status()).collect()
    }

    fn report(&self, app: &mut App, running: &Running, news: &ReportBody) {
        report::made(app, running, news);
    }

    fn rows(&self, app: &App) -> Option<Rows> {
        match app.pane() {
            VARIABLES => {
                let listed = app.editor.listed(&app.scene);
                let selected = listed.iter().position(|index| *index == app.editor.selected);
                let area = app.layout().body.and_then(|body| panes(app, body).variables);
                let shown = area.map_or(10, |area| usize::from(area.height.saturating_sub(2)));
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
            RUNS => {
                app.selected_run = app.run_order().get(row).copied().unwrap_or(app.selected_run);
            }
            _ => app.charts.selected = row,
        }
    }

    fn filter<'a>(&self, app: &'a mut App) -> Option<&'a mut String> {
        match app.pane() {
            VARIABLES => Some(&mut app.editor.filter),
            RUNS => Some(&mut app.runs.filter),
            _ => None,
        }
    }

    fn takes_unit(&self, _app: &App) -> bool {
        true
    }

    fn text(&self, app: &App, _row: usize) -> String {
        app.variable_text()
    }

    fn change(&self, app: &mut App, _row: usize, input: Input<'_>) -> Result<(), String> {
        edit::change(app, app.editor.selected, input)
    }

    fn across<'a>(&self, app: &'a mut App) -> Option<Across<'a>> {
        (app.pane() == CHARTS).then(|| app.time_across())
    }

    fn go_to_value(&self, app: &mut App, chart: usize, value: f64) {
        app.charts.selected = chart;
        app.bring_into_view(value);
    }

    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>) {
        let panes = panes(app, body);
        if let Some(area) = panes.variables {
            editor::render(app, area, app.has_focus(VARIABLES), canvas);
        }
        if let Some(area) = panes.charts {
            charts::draw::render(app, area, app.has_focus(CHARTS), canvas);
        }
        if let Some(area) = panes.runs {
            runs::render(app, area, app.has_focus(RUNS), canvas);
        }
    }
}

/// Whether an action changes the selected variable.
fn edits(action: Action) -> bool {
    matches!(action, Action::Enter | Action::Reset) || step_of(action).is_some()
}

/// Words from which on a list is clearer than going to the next one.
const WORDS_LISTED: usize = 3;

/// Up or down, and by how much, an action steps a value.
pub(crate) fn step_of(action: Action) -> Option<Press> {
    let press = |up, size| Some(Press { up, size });
    match action {
        Action::Left => press(false, Size::Plain),
        Action::Right => press(true, Size::Plain),
        Action::FarLeft => press(false, Size::Coarse),
        Action::FarRight => press(true, Size::Coarse),
        Action::FineLess => press(false, Size::Fine),
        Action::FineMore => press(true, Size::Fine),
        _ => None,
    }
}

/// Open the selected variable's field, or the list of its words; of two words, the other one is taken.
pub(crate) fn open(app: &mut App) {
    match &app.editor.variable().kind {
        Kind::Choice(choice) if choice.words.len() >= WORDS_LISTED => {
            app.dialog = Some(List::Words.at((choice.get)(&app.scene)));
        }
        Kind::Choice(_) | Kind::Switch { .. } => edit::step(app, Press::NEXT),
        Kind::Number(_) => {
            let row = pages::of(Tab::Run).rows(app).map_or(0, |rows| rows.selected);
            update::open_field(app, row);
        }
    }
}

#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Panes {
    pub variables: Option<Rect>,
    pub charts: Option<Rect>,
    pub runs: Option<Rect>,
}

/// The variables beside the charts, and below them the runs; or the pane that has the keys alone.
pub(crate) fn panes(app: &App, body: Rect) -> Panes {
    let none = Panes::default();
    if app.is_full() {
        return match app.pane() {
            CHARTS => Panes { charts: Some(body), ..none },
            RUNS => Panes { runs: Some(body), ..none },
            _ => Panes { variables: Some(body), ..none },
        };
    }
    let (upper, runs) = split_bottom(body, 1 + runs::rows_shown(app, body));
    let width = match body.width {
        0..NARROW => 24,
        NARROW..WIDE => 31,
        WIDE..ROOMY => 38,
        ROOMY.. => 42,
    };
    let (variables, charts) = split_left(upper, width);
    Panes { variables: Some(variables), charts: Some(charts), runs: Some(runs) }
}
