//! The Explore tab: curves or a map of a quantity over one variable or two.

pub(in crate::tui) mod curves;
pub(in crate::tui) mod gaps;
pub(in crate::tui) mod keys;
pub(in crate::tui) mod layout;
pub(in crate::tui) mod map;
pub mod plan;
pub(in crate::tui) mod progress;
pub mod setup;
pub mod state;

use std::sync::Arc;

use ratatui::layout::Rect;

use crate::report::figures::axis_of;
use crate::report::sweep;
use crate::study::sweep::Axis;
use crate::tui::app::App;
use crate::tui::app::jobs::{News, Running};
use crate::tui::app::notice::Severity;
use crate::tui::dialogs::ask;
use crate::tui::keymap::Action as A;
use crate::tui::keymap::{Action, Call, Command, Pane, PaneSpec, Part, key};
use crate::tui::message::Effect;
use crate::tui::pages::explore::state::Picture;
use crate::tui::pages::run::steps::Press;
use crate::tui::pages::{About, Page, StatusPart, Tab, Table, note};
use crate::tui::update::zoom::Across;
use crate::tui::widgets::Canvas;
use crate::tui::widgets::form::Form;

/// The curves or the map.
pub const RESULTS: Pane = Pane::of(Tab::Explore, 0);
/// What is swept.
pub const SETUP: Pane = Pane::of(Tab::Explore, 1);

#[rustfmt::skip]
const PANES: &[PaneSpec] = &[
    PaneSpec { pane: RESULTS, label: "Explore", has: &[Part::Chart], keys: &[
        key(A::Right, "cursor", "move the cursor; the scene stays as it is"),
        key(A::Enter, "load", "load the design under the cursor into the scene (u undoes)"),
        key(A::View, "quantity", "show the next quantity"),
        key(A::Mark, "pin", "pin the design under the cursor"),
        key(A::ZoomIn, "zoom", "zoom the variable along about the cursor"),
        key(A::Down, "curve", "move to another curve, or down the map"),
    ] },
    PaneSpec { pane: SETUP, label: "Explore setup", has: &[Part::Form], keys: &[
        key(A::Enter, "type", "type a variable, an end (0.5, 7.5MN/m), a count, a quantity or a held value"),
        key(A::Right, "change", "change the value by a step, or take the next one"),
        key(A::Down, "move", "move to another row"),
        key(A::Find, "find", "find a row of the setup"),
    ] },
];

#[rustfmt::skip]
const COMMANDS: &[Command] = &[
    Command::new(Call::Do(A::Tab(Tab::Explore)), "Explore tab", "sweep surface map family curves parameter study heat map"),
    Command::new(Call::In(RESULTS, A::Contour), "Contour through the cursor", "level line"),
    Command::new(Call::In(RESULTS, A::FitResiduals), "Toggle residuals of the quadratic fit", "response surface r2"),
];

/// What the workbench asks of this tab.
pub(in crate::tui) struct ExploreTab;

impl Page for ExploreTab {
    fn about(&self) -> &'static About {
        &About { name: "Explore", pages: &[], panes: PANES, commands: COMMANDS }
    }

    fn enter(&self, app: &mut App) -> Vec<Effect> {
        keys::enter(app)
    }

    fn act(&self, app: &mut App, action: Action) -> Option<Vec<Effect>> {
        keys::act(app, action)
    }

    fn readout(&self, app: &App, room: usize) -> Option<(Severity, String)> {
        note(app.sweep_readout(room))
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        app.sweep_status(app.picture())
    }

    fn report(&self, app: &mut App, running: &Running, news: &News) {
        keys::report(app, running, news);
    }

    fn table(&self, app: &App) -> Option<Table> {
        let found = app.pages.explore.found(app.picture())?;
        let plan = found.grid.plan();
        let names: Vec<&str> = plan.axes().iter().map(Axis::symbol).collect();
        let file = format!("{}-{}.csv", ask::base_stem(app), names.join("-"));
        let (name, scene, grid) =
            (app.name_of(plan.base()), Arc::new(plan.base().clone()), Arc::clone(&found.grid));
        let is_complete = grid.is_complete();
        let csv = move || sweep::grid_csv(&name, &grid);
        Some(Table::new("Export the sweep to CSV", file, Some(&scene), csv).complete(is_complete))
    }

    fn is_idle(&self, app: &App, action: Action) -> bool {
        let alone = app.picture() == Picture::Line && !state::has_family(&app.scene);
        app.pane() == RESULTS && action == Action::Down && alone
    }

    fn form(&self, app: &App) -> Option<Form> {
        (app.pane() == SETUP).then(|| app.setup_form())
    }

    fn select(&self, app: &mut App, row: usize) {
        app.pages.explore.row = app.setup_choices()[row];
    }

    fn step(&self, app: &mut App, row: usize, press: Press) -> Result<Vec<Effect>, String> {
        setup::keys::step(app, app.setup_choices()[row], press)
    }

    fn take(&self, app: &mut App, row: usize, text: &str) -> Result<Vec<Effect>, String> {
        setup::keys::take(app, app.setup_choices()[row], text)
    }

    fn go_to_cell(&self, app: &mut App, cell: (usize, usize)) {
        app.pages.explore.cursor[app.picture() as usize] = Some(cell);
    }

    fn across<'a>(&self, app: &'a mut App) -> Option<Across<'a>> {
        let grid = &app.pages.explore.found(Picture::Line)?.grid;
        if app.pane() != RESULTS || app.picture() != Picture::Line {
            return None;
        }
        let x = axis_of(&grid.plan().axes()[0]);
        let about = grid.coordinate(app.cursor_point(grid), 0);
        Some(Across::of(&mut app.pages.explore.zoomed, x.view, x.scale, Some(about)))
    }

    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>) {
        let panes = layout::panes(app, body);
        if let Some(area) = panes.setup {
            app.setup_form().render(app, SETUP, area, canvas);
        }
        match app.picture() {
            Picture::Line => curves::render(app, &panes, canvas),
            Picture::Surface => map::render(app, &panes, canvas),
        }
    }
}
