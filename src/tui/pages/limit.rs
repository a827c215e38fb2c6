//! The Limit tab: the ballistic limit, the residual velocity, and the comparison at equal areal mass.

pub mod comparison;
pub mod residual;
pub mod state;

use crate::tui::app::notice::outside;
use crate::tui::pages::limit::residual::area;
use crate::tui::pages::page::prelude::*;
use crate::worker::studies::{LimitSearch, MassComparison, V50Study};
use cmra_engine::model::run::envelope;
use cmra_studies::report::{self, limit};
use cmra_studies::study::compare;
use cmra_studies::study::limit::COMMAND;
use cmra_studies::study::monte_carlo;
use cmra_studies::study::validity;

pub use state::{COMPARISON, EFFICIENCY_MAP, RESIDUAL};

#[rustfmt::skip]
const PANES: &[PaneSpec] = &[
    PaneSpec { pane: RESIDUAL, label: "Residual velocity", keys: &[
        key(A::View, "V50", "compute V50 and its spread, as `cmra montecarlo` does"),
    ] },
    PaneSpec { pane: COMPARISON, label: "Comparison", keys: &[] },
    PaneSpec { pane: EFFICIENCY_MAP, label: "Mass efficiency", keys: &[] },
];

#[rustfmt::skip]
const COMMANDS: &[Command] = &[
    Command::new(CommandTarget::Do(A::Tab(Tab::Limit)), "Limit tab", "stopped perforated"),
    Command::new(CommandTarget::Show(RESIDUAL, None), "Ballistic limit", "v50 residual velocity perforation recht-ipson lambert-jonas"),
    Command::new(CommandTarget::Show(COMPARISON, None), "Comparison at equal areal mass", "does it pay pays mass efficiency compare worth"),
    Command::new(CommandTarget::Show(EFFICIENCY_MAP, None), "Efficiency map", "mass efficiency compare worth"),
];

pub(crate) struct LimitTab;

impl Page for LimitTab {
    fn about(&self) -> About {
        About { pages: &[], panes: PANES, commands: COMMANDS }
    }

    fn enter(&self, app: &mut App) {
        if app.lacks_limit() {
            jobs::look(app, jobs::LOOK / 2, LimitSearch);
        }
        if app.jobs.lacks::<MassComparison, _>(&app.pages.limit.comparison, &app.scene) {
            jobs::look(app, jobs::LOOK / 2, MassComparison);
        }
    }

    fn act(&self, app: &mut App, action: Action) -> bool {
        match (app.pane(), action) {
            (RESIDUAL, A::Run) => jobs::study(app, action, LimitSearch),
            (_, A::Run) => jobs::study(app, action, MassComparison),
            (RESIDUAL, A::View) => jobs::study(app, action, V50Study(monte_carlo::Request::v50())),
            _ => return false,
        }
        true
    }

    fn readout(&self, app: &App, _room: usize) -> Option<(Severity, String)> {
        if app.pane() == RESIDUAL { app.limit_readout() } else { None }
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        let tab = &app.pages.limit;
        let done = || part(Severity::Note, "done");
        let words = |it: &Running| format!("comparing{}", it.counted("of", ""));
        if app.pane() != RESIDUAL {
            let comparing =
                progress::<MassComparison, _>(app, &tab.comparison, &app.scene, words, "");
            let first = comparing.unwrap_or_else(done);
            return std::iter::once(first).chain(app.validity_part()).collect();
        }
        let scene = app.limit_scene(&tab.report.scene);
        let shots = |it: &Running| format!("finding the limit{}", it.counted("of about", " shots"));
        let finding = progress::<LimitSearch, _>(app, &tab.report, &scene, shots, "shots");
        let mut parts = vec![finding.unwrap_or_else(done)];
        let sampling = |it: &Running| format!("V50{}", it.counted("of", " samples"));
        parts.extend(app.jobs.running::<V50Study>().map(|it| under_way(&sampling(it))));
        let spread = Some(&tab.spread).filter(|it| it.result.is_some() && !it.is_complete());
        let is_shown = app.jobs.running::<V50Study>().is_none();
        parts.extend(spread.filter(|_| is_shown).map(|it| cut(it, "samples of V50")));
        if let Some(report) = &tab.report.result {
            let comparing = app.jobs.running::<MassComparison>();
            parts.extend(comparing.map(|it| under_way(&words(it))));
            let at_limit = report.at_limit.as_ref();
            parts.extend(at_limit.map_or_else(
                || app.validity_part(),
                |run| {
                    let breaches = envelope::of_run(run).into_iter();
                    outside(breaches.map(|breach| breach.check), " at the limit")
                },
            ));
        }
        parts
    }

    fn report(&self, app: &mut App, running: &Running, news: &ReportBody) {
        let tab = &mut app.pages.limit;
        tab.report.keep(running, news);
        tab.spread.keep(running, news);
        tab.comparison.keep(running, news);
    }

    fn table(&self, app: &App) -> Option<PageTable> {
        let (limit, comparison) = (&app.pages.limit.report, &app.pages.limit.comparison);
        if app.pane() == RESIDUAL {
            let report = limit.result.clone().filter(|report| !report.shots.is_empty())?;
            let name = app.name_of(&limit.scene);
            let csv = move |reach| {
                let warnings = limit::warnings(&report);
                limit::shots(&name, &report).with_warnings(&warnings).with_reach(reach).csv()
            };
            let title = "Export the shots to CSV";
            let table = PageTable::new(title, "limit.csv", limit.reach, csv);
            return Some(table.for_scene(app, &limit.scene, COMMAND));
        }
        let (found, name) = (comparison.result.clone()?, app.name_of(&comparison.scene));
        let mut request = compare::Request::default();
        let table = if app.pane() == COMPARISON {
            // The map comes after the comparison.
            let is_there = found.map.is_some();
            let reach = if is_there { Reach::Complete } else { comparison.reach };
            let csv = move |reach| {
                let warnings = validity::of_scene(&found.report.scene);
                let table = report::compare::table(&name, &found.report);
                table.with_warnings(&warnings).with_reach(reach).csv()
            };
            PageTable::new("Export the comparison to CSV", "compare.csv", reach, csv)
        } else {
            let map = found.map.clone()?;
            request.map = Some([map.x().clone(), map.y().clone()]);
            let csv = move |reach| report::compare::map_table(&name, &map).with_reach(reach).csv();
            PageTable::new("Export the map to CSV", "mass-efficiency.csv", comparison.reach, csv)
        };
        Some(table.for_scene(app, &comparison.scene, request.to_string()))
    }

    fn rows(&self, app: &App) -> Option<Rows> {
        match app.pane() {
            RESIDUAL => {
                let (count, shown) = app.limit_words()?;
                Some(Rows { count: count + 1, selected: app.pages.limit.word, shown })
            }
            COMPARISON => {
                let area = area(app, app.layout().body?, COMPARISON)?;
                let lines = app.comparison_lines(usize::from(area.width.saturating_sub(2)));
                let shown = usize::from(area.height.saturating_sub(2));
                let count = lines.len().saturating_sub(shown) + 1;
                Some(Rows { count, selected: app.pages.limit.scrolled.min(count - 1), shown })
            }
            _ => None,
        }
    }

    fn select(&self, app: &mut App, row: usize) {
        let (pane, tab) = (app.pane(), &mut app.pages.limit);
        match pane {
            RESIDUAL => tab.word = row,
            _ => tab.scrolled = row,
        }
    }

    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>) {
        for spec in PANES {
            let Some(area) = area(app, body, spec.pane) else { continue };
            canvas.pane(area, spec.pane);
            match spec.pane {
                RESIDUAL => residual::render(app, area, canvas),
                COMPARISON => comparison::render(app, area, canvas),
                _ => comparison::map(app, area, canvas),
            }
        }
    }
}
