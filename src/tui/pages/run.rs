//! Run tab: a single impact, with its variables, charts, and runs for comparison.

pub mod charts;
pub mod editor;
pub mod impact;
pub(crate) mod matters;
pub mod runs;
pub mod state;
mod status;

use crate::tui::chart::Unit;
use crate::tui::pages::page::open_field;
use crate::tui::pages::page::prelude::*;
use crate::tui::pages::run::charts::end_s;
use crate::tui::pages::run::matters::matters_words;
use crate::tui::widgets::axis::FIELD_DIGITS;
use crate::tui::widgets::form::FieldQuantity;
use crate::tui::widgets::layout::{NARROW, ROOMY, WIDE};
use crate::tui::widgets::step_of;
use crate::tui::widgets::value_steps::{Input, StepKey};
use cmra_engine::model::variables::Kind;
use cmra_studies::report::series::Channel;
use cmra_studies::report::traces::{MARK, Traces};

pub use state::{CHARTS, RUNS, VARIABLES};

#[rustfmt::skip]
const PANES: &[PaneSpec] = &[
    PaneSpec { pane: VARIABLES, label: "Variables", keys: &[
        key(A::Right, "step", "change the value by a step (<far-left> <far-right> ten steps)"),
        key(A::Enter, "type", "type the value (25.4mm, 1/3, *2, +5%), or choose from a list"),
        key(A::Mark, "pin", "pin this run to compare with (A to H)"),
        key(A::View, "bars", "bars of what matters: depth, travel, force; then words again"),
        key(A::Presets, "presets", "load a preset, a threat, a material or an absorber"),
        key(A::Window, "chart", "contact or whole in the selected chart; <full-pane> enlarges it"),
        key(A::Export, "export", "export this run and the pinned ones"),
        key(A::FullPane, "", "show the selected chart alone, or all of them again"),
        key(A::Down, "", "move to another variable; below the last one More unfolds"),
        key(A::Find, "find", "find a variable by symbol or word"),
        key(A::Reset, "reset", "reset this row to the preset's value"),
    ] },
    PaneSpec { pane: CHARTS, label: "Charts", keys: &[
        key(A::Enter, "enlarge", "show the selected chart alone, or all of them again"),
        key(A::FullPane, "", "the same"),
        key(A::Window, "contact/whole", "show the contact, or the whole response"),
        key(A::Down, "chart", "select the chart below or above"),
        key(A::Right, "cursor", "move the cursor in time (<far-left> <far-right> ten columns)"),
        key(A::Play, "play", "play the impact below the enlarged chart; any key ends it"),
        key(A::View, "view", "show another quantity: F(x), stiffness and stress come last"),
        key(A::Locate, "time", "type the time of the cursor: 64us (<back> removes it)"),
        key(A::Mark, "pin", "pin this run to compare with (A to H)"),
    ] },
    PaneSpec { pane: RUNS, label: "Runs", keys: &[
        key(A::Enter, "load", "load this pinned run's scene"),
        key(A::Mark, "pin/unpin", "pin the current run, or unpin the selected one"),
        key(A::Down, "move", "select another run"),
        key(A::FullPane, "", "show the table alone, or all panes again"),
    ] },
];

#[rustfmt::skip]
const COMMANDS: &[Command] = &[
    Command::new(CommandTarget::Do(A::Tab(Tab::Run)), "Run tab", "variables charts curves impact simulation"),
    Command::new(CommandTarget::In(VARIABLES, A::Find), "Find a variable", "filter search"),
    Command::new(CommandTarget::In(VARIABLES, A::Reset), "Reset this variable to the preset", "default"),
    Command::new(CommandTarget::In(VARIABLES, A::View), "What matters", "sensitivity bars importance effect of each variable"),
    Command::new(CommandTarget::In(CHARTS, A::View), "Next quantity of the chart", "velocity force displacement stress yield stiffness"),
    Command::new(CommandTarget::In(CHARTS, A::Window), "Contact or whole response", "window time"),
    Command::new(CommandTarget::In(CHARTS, A::Play), "Play the impact", "drawing animation animate movie scene picture time"),
    Command::new(CommandTarget::In(CHARTS, A::FullPane), "Show this chart alone", "full enlarge maximise"),
];

pub(crate) struct RunTab;

impl Page for RunTab {
    fn about(&self) -> About {
        About { pages: &[], panes: PANES, commands: COMMANDS }
    }

    fn await_rest(&self, app: &mut App) {
        matters::wait(app);
    }

    fn rested(&self, app: &mut App) {
        matters::rested(app);
    }

    fn act(&self, app: &mut App, action: Action) -> bool {
        match (action, app.pane()) {
            (Action::Run, VARIABLES) if matters::fill(app, action) => {}
            (Action::Run, _) => jobs::rerun(app, action),
            (Action::Enter, CHARTS) => return self.act(app, Action::FullPane),
            (Action::FullPane, pane) => {
                // A full-screen list of variables has no advantage, so enlarge the chart.
                app.focus_on(if pane == VARIABLES { CHARTS } else { pane });
                app.pages.run.is_full = !app.pages.run.is_full;
            }
            (Action::Play, CHARTS) => impact::play(app),
            (_, CHARTS) | (Action::Window, VARIABLES) => {
                return charts::act(app, action);
            }
            (Action::Mark, RUNS) if app.pages.run.selected > 0 => runs::unpin(app),
            (Action::Mark, _) => runs::pin_scene(app),
            (Action::Enter, RUNS) => runs::load(app),
            (Action::View, VARIABLES) => matters::next(app),
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
            // The drawing already shows the values at the crosshair.
            CHARTS if app.is_full() => {
                note(Some(charts::draw::event_words(app, app.pages.run.charts.selected)))
            }
            CHARTS if app.pages.run.charts.cursor_s.is_some() => note(Some(app.readout())),
            CHARTS => note(Some(charts::draw::event_words(app, app.pages.run.charts.selected))),
            RUNS => note(runs::difference(app)),
            VARIABLES if app.pages.run.editor.shows(&app.scene) => {
                note(Some(matters_words(app).unwrap_or_else(|| app.variable_words(room))))
            }
            _ => None,
        }
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        app.run_status()
    }

    fn report(&self, app: &mut App, running: &Running, news: &ReportBody) {
        matters::report(app, running, news);
    }

    fn rows(&self, app: &App) -> Option<Rows> {
        match app.pane() {
            VARIABLES => {
                let listed = app.pages.run.editor.listed(&app.scene);
                let selected =
                    listed.iter().position(|index| *index == app.pages.run.editor.selected);
                let area = app.layout().body.and_then(|body| area(app, body, VARIABLES));
                let shown = area.map_or(10, |area| usize::from(area.height.saturating_sub(2)));
                Some(Rows { count: listed.len(), selected: selected.unwrap_or(0), shown })
            }
            RUNS => {
                let (count, selected) = (app.pins.len() + 1, app.pages.run.selected);
                Some(Rows { count, selected, shown: 8 })
            }
            _ => Some(Rows {
                count: app.pages.run.charts.quantities.len(),
                selected: app.pages.run.charts.selected,
                shown: 3,
            }),
        }
    }

    fn select(&self, app: &mut App, row: usize) {
        match app.pane() {
            VARIABLES => {
                if let Some(index) = app.pages.run.editor.listed(&app.scene).get(row) {
                    app.pages.run.editor.selected = *index;
                }
            }
            RUNS => app.pages.run.selected = row,
            _ => app.pages.run.charts.selected = row,
        }
    }

    fn filter<'a>(&self, app: &'a mut App) -> Option<&'a mut String> {
        (app.pane() == VARIABLES).then_some(&mut app.pages.run.editor.filter)
    }

    fn field_quantity(&self, app: &App) -> Option<FieldQuantity> {
        let editor = &app.pages.run.editor;
        let unit = editor.unit(editor.selected).to_owned();
        Some(FieldQuantity { unit, variable: Some(editor.variable()) })
    }

    /// Returns the number in the displayed unit.
    fn text(&self, app: &App) -> String {
        let editor = &app.pages.run.editor;
        let unit = editor.unit(editor.selected);
        editor::number_in(editor.variable(), &app.scene, unit, FIELD_DIGITS)
    }

    fn change(&self, app: &mut App, input: Input<'_>) -> Result<(), String> {
        let index = app.pages.run.editor.selected;
        match input {
            Input::Text(text) => edit::read(app, index, text),
            Input::Step(_) => Ok(()),
        }
    }

    fn go_to_value(&self, app: &mut App, chart: usize, value: f64) {
        app.pages.run.charts.selected = chart;
        app.pages.run.charts.cursor_s = Some(value);
    }

    fn places(&self, app: &App) -> Vec<(String, String)> {
        if app.pane() != CHARTS {
            return Vec::new();
        }
        let unit = Unit::with_prefix(end_s(app, app.pages.run.charts.selected), "s");
        vec![("t".to_owned(), unit.name.into_owned())]
    }

    fn go_to_place(&self, app: &mut App, text: &str) -> Result<(), String> {
        app.pages.run.charts.cursor_s = charts::place(app, text)?;
        Ok(())
    }

    fn remove_cursor(&self, app: &mut App) -> bool {
        app.pane() == CHARTS && app.pages.run.charts.cursor_s.take().is_some()
    }

    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>) {
        for PaneSpec { pane, .. } in PANES {
            let Some(area) = area(app, body, *pane) else { continue };
            let render = match *pane {
                VARIABLES => editor::draw::render,
                CHARTS => charts::draw::render,
                _ => runs::render,
            };
            render(app, area, app.has_focus(*pane), canvas);
        }
    }
}

/// Shows traces with the runs; quantities without a chart replace those of the last charts.
pub(crate) fn lay_beside(app: &mut App, traces: Arc<Traces>) {
    let charts = &mut app.pages.run.charts;
    let mut place = charts.quantities.len();
    for channel in Channel::ALL {
        if traces.of_channel(channel).next().is_none() || charts.quantities.contains(&channel) {
            continue;
        }
        let is_free = |at: &usize| traces.of_channel(charts.quantities[*at]).next().is_none();
        let Some(at) = (0..place).rev().find(is_free) else { break };
        charts.quantities[at] = channel;
        place = at;
    }
    let (count, name) = (traces.traces.len(), traces.name.clone());
    app.pages.run.beside = Some(traces);
    app.tab = Tab::Run;
    let what = if count == 1 { "trace" } else { "traces" };
    app.report_progress(format!("{count} {what} of {name}, marked {MARK}: titles have the greatest difference; <beside> changes or removes"));
}

/// Updates the displayed traces after a change of the run or the charts.
pub(crate) fn follow_traces(app: &mut App) {
    let channels = app.pages.run.charts.quantities;
    let ends = [0, 1, 2].map(|chart| (channels[chart], end_s(app, chart)));
    let page = &mut app.pages.run;
    page.drawn.follow(page.beside.as_ref(), ends);
    let run = app.shown.as_ref().map(|shown| &shown.run);
    page.differences.follow(run, page.beside.as_ref(), channels);
}

/// Returns `true` if the focused row is a variable with a list of choices.
pub(crate) fn lists_words(app: &App) -> bool {
    app.pane() == VARIABLES && app.pages.run.editor.shows(&app.scene) && is_list(app)
}

/// Minimum number of choices for a list instead of stepping.
const WORDS_LISTED: usize = 3;

/// Returns `true` if the selected variable has enough choices for a list.
pub(crate) fn is_list(app: &App) -> bool {
    app.pages.run.editor.variable().keys().len() >= WORDS_LISTED
}

/// Selects a variable in the list.
pub(crate) fn focus_on(app: &mut App, index: usize) {
    app.focus_on(VARIABLES);
    app.pages.run.editor.filter.clear();
    app.pages.run.editor.selected = index;
}

/// Opens the selected variable's field; toggles a variable with two choices.
pub(crate) fn open(app: &mut App) {
    match &app.pages.run.editor.variable().kind {
        Kind::Choice { .. } | Kind::Switch { .. } => edit::step(app, StepKey::NEXT),
        Kind::Number(_) => {
            open_field(app);
        }
    }
}

/// Returns the area of a pane: the variables beside the charts, and the runs below; or the focused pane alone.
fn area(app: &App, body: Rect, pane: Pane) -> Option<Rect> {
    if app.is_full() {
        return (pane == app.pane()).then_some(body);
    }
    let (upper, runs) = split_bottom(body, 1 + runs::rows_shown(app, body));
    let width = match body.width {
        0..NARROW if app.pages.run.matters.output.is_none() => 24,
        0..WIDE => 31,
        WIDE..ROOMY => 38,
        ROOMY.. => 42,
    };
    let (variables, charts) = split_left(upper, width);
    Some(match pane {
        VARIABLES => variables,
        CHARTS => charts,
        _ => runs,
    })
}
