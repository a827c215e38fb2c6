//! The Run tab: one impact, with its variables, its charts and the runs to compare with.

pub mod charts;
pub mod editor;
pub(crate) mod mechanism;
pub(crate) mod report;
pub mod runs;
pub mod steps;

use crate::model::variables::Kind;
use crate::tui::app::layout::{ROOMY, WIDE};
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
        key(A::Enter, "type", "type the value (25.4mm, 1/3, *2, +5%), or choose from a list"),
        key(A::Right, "change", "change the value by a step (<far-left> <far-right> ten steps, <fine-less> <fine-more> a tenth)"),
        key(A::Down, "move", "move to another variable"),
        key(A::Find, "find", "find a variable by symbol or word"),
        key(A::Mark, "pin", "pin this run to compare with (A to H)"),
        key(A::Reset, "reset", "reset this row to the preset's value"),
    ] },
    PaneSpec { pane: CHARTS, label: "Charts", has: &[Part::Chart], keys: &[
        key(A::Right, "cursor", "move the cursor in time (<far-left> <far-right> ten columns)"),
        key(A::View, "view", "show another quantity: F(x), stiffness and stress come last"),
        key(A::EventNext, "event", "move the cursor to the next event"),
        key(A::ZoomIn, "zoom", "zoom about the cursor"),
        key(A::Window, "window", "show the contact only, or the whole response"),
        key(A::Down, "chart", "select the chart below or above"),
        key(A::Mark, "pin", "pin this run to compare with (A to H)"),
        key(A::SecondAxis, "2nd axis", "second axis at the right: next quantity, after the last none"),
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
    Command::new(Call::In(CHARTS, A::SecondAxis), "Second axis of the chart", "right"),
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
            (_, CHARTS) | (Action::Difference, RUNS) => return charts::act(app, action),
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
                let shown = area.map_or(10, |area| usize::from(area.height.saturating_sub(3)));
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
        app.editor.variable().show(&app.scene)
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
        charts::draw::render(app, &panes.charts, app.has_focus(CHARTS), canvas);
        if let Some(area) = panes.runs {
            runs::render(app, area, app.has_focus(RUNS), canvas);
        }
        if let Some(area) = panes.events {
            mechanism::events(app, area, canvas);
        }
        if let Some(area) = panes.mechanism {
            mechanism::render(app, area, canvas);
        }
        if let Some(area) = panes.ledger {
            mechanism::ledger(app, area, canvas);
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

/// From this width on: events and energy beside the charts.
const WIDEST: u16 = 160;
/// From this height on: the table of runs is always there.
const TALL: u16 = 34;

#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Panes {
    pub variables: Option<Rect>,
    /// One chart (the selected one) or all three, from top to bottom.
    pub charts: Vec<Rect>,
    pub runs: Option<Rect>,
    pub events: Option<Rect>,
    pub ledger: Option<Rect>,
    pub mechanism: Option<Rect>,
}

pub(crate) fn panes(app: &App, body: Rect) -> Panes {
    let (focus, pins) = (app.pane(), app.pins.len());
    if app.is_full() {
        full(body, focus)
    } else if body.width < WIDE {
        narrow(body, app.size.1, focus, pins)
    } else {
        wide(body, app.size.1, focus, pins)
    }
}

fn full(body: Rect, focus: Pane) -> Panes {
    match focus {
        CHARTS => Panes { charts: stacked(body), ..Panes::default() },
        RUNS => Panes { runs: Some(body), ..Panes::default() },
        _ => Panes { variables: Some(body), ..Panes::default() },
    }
}

fn narrow(body: Rect, height: u16, focus: Pane, pins: usize) -> Panes {
    let (left, right) = split_left(body, 31);
    let mut panes = Panes { variables: Some(left), ..Panes::default() };
    if height >= TALL {
        let (top, bottom) = split_bottom(right, runs_height(pins));
        panes.runs = Some(bottom);
        panes.charts = if top.height >= 36 { stacked(top) } else { vec![top] };
    } else if focus == RUNS {
        panes.runs = Some(right);
    } else {
        panes.charts = vec![right];
    }
    panes
}

fn wide(body: Rect, height: u16, focus: Pane, pins: usize) -> Panes {
    let (left, mut right) = split_left(body, if body.width >= ROOMY { 52 } else { 48 });
    let mut panes = Panes { variables: Some(left), ..Panes::default() };
    if height >= TALL || focus == RUNS {
        let (top, bottom) = split_bottom(left, runs_height(pins).min(body.height / 2));
        (panes.variables, panes.runs) = (Some(top), Some(bottom));
    }
    if body.width >= WIDEST {
        let (middle, column) = split_left(right, right.width - 42);
        right = middle;
        let (events, ledger) = split_bottom(column, 14.min(column.height / 2));
        panes.events = Some(events);
        panes.ledger = Some(ledger);
    }
    if right.height >= DRAWN {
        let (charts, drawing) = split_bottom(right, DRAWING_ROWS);
        right = charts;
        panes.mechanism = Some(drawing);
    }
    panes.charts = stacked(right);
    panes
}

/// Rows of the drawing of the mechanism, frame included, and from what height on it stands below the charts.
const DRAWING_ROWS: u16 = 5;
const DRAWN: u16 = 19;

/// Header, the current run, the pins, and what differs from the first pin.
fn runs_height(pins: usize) -> u16 {
    let rows = u16::try_from(pins.min(8)).unwrap_or(8);
    if rows == 0 { 6 } else { 7 + rows }
}

/// As many of the three charts as can be read: six rows each, and two more for the common axis.
fn stacked(area: Rect) -> Vec<Rect> {
    let count = match area.height {
        0..=13 => 1,
        14..=19 => 2,
        _ => 3,
    };
    // Short charts share the time axis of the lowest, which needs two rows more for it.
    let extra = if count > 1 && area.height / count < 11 { 2 } else { 0 };
    let each = (area.height - extra) / count;
    let one = |index: u16| {
        let y = area.y + index * each;
        let height = if index + 1 == count { area.bottom() - y } else { each };
        Rect { y, height, ..area }
    };
    (0..count).map(one).collect()
}
