//! Numerics tab: accuracy and stability of the methods.

pub mod accuracy;
pub mod stability;
pub mod state;

use crate::tui::pages::numerics::accuracy::accuracy_status;
use crate::tui::pages::numerics::stability::{battery_readout, map_readout, stability_status};
use crate::tui::pages::page::prelude::*;
use crate::tui::pages::run::runs::name_of;
use crate::worker::studies::StabilityMap;
use cmra_engine::model::run::Warning;
use cmra_studies::report::{accuracy as accuracy_table, stability as stability_table};
use cmra_studies::study::accuracy::method::Method;
use cmra_studies::study::library;
use cmra_studies::study::sweep::Axis;

pub use state::{ACCURACY, STABILITY, STIFF_SCENES};

#[rustfmt::skip]
const PANES: &[PaneSpec] = &[
    PaneSpec { pane: ACCURACY, label: "Accuracy", keys: &[
        key(A::Down, "method", "select another method"),
        key(A::Enter, "use", "give the scene the tolerance by which auto reaches 1e-6"),
    ] },
    PaneSpec { pane: STABILITY, label: "Stability", keys: &[
        key(A::Right, "cursor", "move the cursor: time step across, variable upward"),
        key(A::View, "map", "show the map of another variable (k, n, b) or another method"),
        key(A::Locate, "value", "type the place of the cursor: dt 1us k 1e6 (<back> removes it)"),
    ] },
    PaneSpec { pane: STIFF_SCENES, label: "Stiff scenes", keys: &[
        key(A::Down, "scene", "select another scene"),
    ] },
];

const PAGES: &[PageSpec] = &[
    PageSpec { name: "Accuracy", panes: &[ACCURACY] },
    PageSpec { name: "Stability", panes: &[STABILITY, STIFF_SCENES] },
];

#[rustfmt::skip]
const COMMANDS: &[Command] = &[
    Command::new(CommandTarget::Do(A::Tab(Tab::Numerics)), "Numerics tab", "method solver integrator"),
    Command::new(CommandTarget::Show(ACCURACY, None), "Accuracy", "error run time cost method tolerance convergence order"),
    Command::new(CommandTarget::Show(STABILITY, None), "Stability", "stable step fixed step map"),
    Command::new(CommandTarget::Show(STIFF_SCENES, None), "Stiff scenes", "battery extreme cases"),
];

pub(crate) struct NumericsTab;

impl Page for NumericsTab {
    fn about(&self) -> About {
        About { pages: PAGES, panes: PANES, commands: COMMANDS }
    }

    fn enter(&self, app: &mut App) {
        match app.pane() {
            ACCURACY => accuracy::enter(app),
            _ => stability::enter(app),
        }
    }

    fn focused(&self, app: &mut App) {
        self.enter(app);
    }

    fn act(&self, app: &mut App, action: Action) -> bool {
        match app.pane() {
            ACCURACY => accuracy::act(app, action),
            _ => stability::act(app, action),
        }
    }

    fn is_of_use(&self, app: &App, action: Action) -> bool {
        (app.pane(), action) != (ACCURACY, Action::Enter) || accuracy::can_use(app)
    }

    fn readout(&self, app: &App, _room: usize) -> Option<(Severity, String)> {
        match app.pane() {
            ACCURACY => note(accuracy::readout(app)),
            STABILITY => note(map_readout(app)),
            _ => battery_readout(app),
        }
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        match app.pane() {
            ACCURACY => accuracy_status(app),
            _ => stability_status(app),
        }
    }

    fn report(&self, app: &mut App, running: &Running, news: &ReportBody) {
        accuracy::report(app, running, news);
        stability::report(app, running, news);
    }

    fn table(&self, app: &App) -> Option<PageTable> {
        let tab = &app.pages.numerics;
        Some(match app.pane() {
            ACCURACY => {
                let kept = &tab.accuracy.report;
                let (report, name) = (kept.result.clone()?, name_of(app, &kept.scene));
                let csv =
                    move |reach| accuracy_table::table(&name, &report).with_reach(reach).csv();
                let title = "Export the measurements to CSV";
                let table = PageTable::new(title, "accuracy", kept.reach, csv);
                table.for_scene(app, &kept.scene, "accuracy")
            }
            STIFF_SCENES => {
                let kept = &tab.stability.battery;
                let found = kept.result.clone().filter(|found| !found.is_empty())?;
                let csv = move |reach| stability_table::table(&*found).with_reach(reach).csv();
                let title = "Export the stiff scenes to CSV";
                PageTable::new(title, "battery", kept.reach, csv)
            }
            _ => {
                let kept = &tab.stability.map;
                let (map, name) = (kept.result.clone()?, name_of(app, &kept.scene));
                let command = StabilityMap::downcast(kept.request.as_ref()?)?.0.to_string();
                let warnings: Vec<Warning> = library::warnings(&kept.scene).collect();
                let csv = move |reach| {
                    let table = stability_table::map_table(&name, &map);
                    table.with_warnings(&warnings).with_reach(reach).csv()
                };
                let table = PageTable::new("Export the map to CSV", "map", kept.reach, csv);
                table.for_scene(app, &kept.scene, command)
            }
        })
    }

    fn places(&self, app: &App) -> Vec<(String, String)> {
        let map = app.pages.numerics.stability.map.result.as_ref();
        let map = map.filter(|_| app.pane() == STABILITY);
        let axes = map.into_iter().flat_map(|map| [&map.dt, &map.variable]);
        let place = |axis: &Axis| (axis.symbol().to_owned(), axis.variable().unit().to_owned());
        axes.map(place).collect()
    }

    fn go_to_place(&self, app: &mut App, text: &str) -> Result<(), String> {
        app.pages.numerics.stability.cursor = stability::place(app, text)?;
        Ok(())
    }

    fn remove_cursor(&self, app: &mut App) -> bool {
        app.pane() == STABILITY && app.pages.numerics.stability.cursor.take().is_some()
    }

    fn rows(&self, app: &App) -> Option<Rows> {
        match app.pane() {
            ACCURACY => {
                let selected = app.pages.numerics.accuracy.selected_row();
                Some(Rows { count: Method::ALL.len(), selected, shown: 8 })
            }
            STIFF_SCENES => {
                let tab = &app.pages.numerics.stability;
                let (count, selected) = (tab.rows().len(), tab.selected);
                Some(Rows { count, selected, shown: app.list_rows() })
            }
            _ => None,
        }
    }

    fn select(&self, app: &mut App, row: usize) {
        if app.pane() == ACCURACY {
            app.pages.numerics.accuracy.selected = Some(row);
        } else {
            app.pages.numerics.stability.selected = row;
        }
    }

    fn go_to_cell(&self, app: &mut App, cell: (usize, usize)) {
        app.pages.numerics.stability.cursor = Some(cell);
    }

    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>) {
        match app.pane() {
            ACCURACY => accuracy::draw(app, body, canvas),
            STABILITY => stability::draw_map(app, body, canvas),
            _ => stability::draw_battery(app, body, canvas),
        }
    }
}
