//! The Limit tab: the ballistic limit, the residual velocity, and the comparison at equal areal mass.

pub mod comparison;
pub(in crate::tui) mod draw;
pub(in crate::tui) mod keys;
pub(in crate::tui) mod layout;
pub mod state;

use std::sync::Arc;

use ratatui::layout::Rect;

use crate::report::figures::limit::axes;
use crate::report::{compare, limit};
use crate::study::limit::Report;
use crate::tui::app::App;
use crate::tui::app::jobs::{News, Running};
use crate::tui::app::notice::Severity;
use crate::tui::chart::Scale;
use crate::tui::dialogs::ask;
use crate::tui::keymap::Action as A;
use crate::tui::keymap::{Action, Call, Command, Pane, PaneSpec, Part, key};
use crate::tui::message::Effect;
use crate::tui::pages::limit::comparison::Comparison;
use crate::tui::pages::{About, Page, Rows, StatusPart, Tab, Table, note};
use crate::tui::update::zoom::Across;
use crate::tui::widgets::Canvas;

/// The residual velocity over the impact velocity.
pub const RESIDUAL: Pane = Pane::of(Tab::Limit, 0);
/// The comparison at equal areal mass.
pub const COMPARISON: Pane = Pane::of(Tab::Limit, 1);
/// The map of mass efficiency.
pub const EFFICIENCY_MAP: Pane = Pane::of(Tab::Limit, 2);

#[rustfmt::skip]
const PANES: &[PaneSpec] = &[
    PaneSpec { pane: RESIDUAL, label: "Residual velocity", has: &[Part::Chart], keys: &[
        key(A::Right, "shot", "move the cursor to the next faster shot"),
        key(A::View, "V50", "compute V50 and its spread with every input scattered by 2 %, or leave it out"),
        key(A::Enter, "load", "load the impact velocity under the cursor into the scene (u undoes)"),
        key(A::ZoomIn, "zoom", "zoom the impact velocity about the cursor"),
    ] },
    PaneSpec { pane: COMPARISON, label: "Comparison", has: &[], keys: &[
        key(A::View, "absorber", "compare with the next absorber of the library, or the scene's own"),
        key(A::Enter, "load", "load the scene with this absorber (u undoes)"),
    ] },
    PaneSpec { pane: EFFICIENCY_MAP, label: "Mass efficiency", has: &[], keys: &[
        key(A::Right, "cursor", "move the cursor; the scene stays as it is"),
        key(A::Enter, "load", "load the design under the cursor into the scene (u undoes)"),
        key(A::Mark, "pin", "pin the design under the cursor"),
    ] },
];

#[rustfmt::skip]
const COMMANDS: &[Command] = &[
    Command::new(Call::Do(A::Tab(Tab::Limit)), "Limit tab", "stopped perforated"),
    Command::new(Call::Show(RESIDUAL, None), "Ballistic limit", "v50 residual velocity perforation recht-ipson lambert-jonas"),
    Command::new(Call::Show(COMPARISON, None), "Comparison at equal areal mass", "does it pay mass efficiency compare worth absorber"),
];

/// What the workbench asks of this tab.
pub(in crate::tui) struct LimitTab;

impl Page for LimitTab {
    fn about(&self) -> &'static About {
        &About { name: "Limit", pages: &[], panes: PANES, commands: COMMANDS }
    }

    fn enter(&self, app: &mut App) -> Vec<Effect> {
        keys::enter(app)
    }

    fn act(&self, app: &mut App, action: Action) -> Option<Vec<Effect>> {
        keys::act(app, action)
    }

    fn readout(&self, app: &App, _room: usize) -> Option<(Severity, String)> {
        match app.pane() {
            RESIDUAL => app.limit_readout(),
            COMPARISON => note(app.comparison_readout()),
            _ => note(app.efficiency_readout()),
        }
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        app.limit_status()
    }

    fn report(&self, app: &mut App, running: &Running, news: &News) {
        if let Some(comparison) = news.found::<Comparison>() {
            app.pages.limit.comparison = Some((Arc::clone(&running.scene), comparison));
        } else if let Some(report) = news.found::<Report>() {
            app.pages.limit.show(report);
        }
    }

    fn table(&self, app: &App) -> Option<Table> {
        let stem = ask::base_stem(app);
        if app.pane() == RESIDUAL {
            let report = app.pages.limit.report.as_ref();
            let report = Arc::clone(report.filter(|report| !report.shots.is_empty())?);
            let (name, scene) = (app.name_of(&report.scene), Arc::clone(&report.scene));
            let file = format!("{}-limit.csv", ask::stem(app, &scene));
            let is_complete = report.is_complete;
            let csv = move || limit::shots(&name, &report).csv();
            let title = "Export the shots to CSV";
            return Some(Table::new(title, file, Some(&scene), csv).complete(is_complete));
        }
        let (scene, found) = app.pages.limit.comparison.as_ref()?;
        let (name, found) = (app.name_of(scene), Arc::clone(found));
        if app.pane() == COMPARISON {
            let is_complete = found.report.is_complete;
            let csv = move || compare::table(&name, &found.report).csv();
            let (title, file) = ("Export the comparison to CSV", format!("{stem}-compare.csv"));
            return Some(Table::new(title, file, Some(scene), csv).complete(is_complete));
        }
        let (map, file) = (found.map.clone()?, format!("{stem}-mass-efficiency.csv"));
        let csv = move || compare::map_table(&name, &map).csv();
        Some(Table::new("Export the map to CSV", file, Some(scene), csv))
    }

    fn rows(&self, app: &App) -> Option<Rows> {
        match app.pane() {
            RESIDUAL => {
                let (count, selected) = (app.pages.limit.shots().len(), app.pages.limit.shot_at());
                Some(Rows { count, selected, shown: 1 })
            }
            COMPARISON => {
                let area = layout::panes(app, app.layout().body?).comparison?;
                let shown = usize::from(area.height.saturating_sub(2));
                let lines = app.comparison_lines(usize::from(area.width.saturating_sub(2))).len();
                let count = lines.saturating_sub(shown) + 1;
                Some(Rows { count, selected: app.pages.limit.scrolled.min(count - 1), shown })
            }
            _ => None,
        }
    }

    fn select(&self, app: &mut App, row: usize) {
        if app.pane() == RESIDUAL {
            app.pages.limit.cursor = Some(row);
        } else {
            app.pages.limit.scrolled = row;
        }
    }

    fn go_to_cell(&self, app: &mut App, cell: (usize, usize)) {
        app.pages.limit.map_cursor = Some(cell);
    }

    fn across<'a>(&self, app: &'a mut App) -> Option<Across<'a>> {
        if app.pane() != RESIDUAL {
            return None;
        }
        let tab = &mut app.pages.limit;
        let (x, _) = axes(tab.report.as_ref()?)?;
        let scale = if tab.log.0 { Scale::Log10 } else { x.scale };
        let about = tab.shot().map(|shot| shot.impact_m_s);
        Some(Across::of(&mut tab.zoomed, x.view, scale, about))
    }

    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>) {
        let panes = layout::panes(app, body);
        if let Some(area) = panes.comparison {
            comparison::draw::render(app, area, canvas);
        }
        if let Some(area) = panes.residual {
            draw::render(app, area, canvas);
        }
        if let Some(area) = panes.map {
            comparison::draw::map(app, area, canvas);
        }
    }
}
