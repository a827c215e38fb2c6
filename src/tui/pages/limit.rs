//! Limit tab: whether the shot is stopped, whether and where moving armour pays, and the residual velocity.

pub mod comparison;
pub mod map;
pub mod residual;
pub mod state;

use crate::tui::pages::limit::comparison::{candidate_lines, own_comparison};
use crate::tui::pages::limit::map::{design, efficiency_map};
use crate::tui::pages::limit::residual::{lacks_limit, limit_readout, limit_scene};
use crate::tui::pages::run::runs::name_of;
use std::time::Duration;

use crate::tui::app::notice::outside;
use crate::tui::app::running::CachedResult;
use crate::tui::pages::page::prelude::*;
use crate::tui::pages::run::runs;
use crate::tui::widgets::cursor_moved;
use crate::tui::widgets::text::fitting;
use crate::worker::studies::{
    EfficiencyMapStudy, LimitSearch, MassComparison, StudyRequest, V50Study,
};
use cmra_studies::report::compare::{short_verdict, where_it_pays};
use cmra_studies::report::limit::headlines;
use cmra_studies::report::{self, limit};
use cmra_studies::study::compare::{self, Candidate};
use cmra_studies::study::context::Progress;
use cmra_studies::study::envelope;
use cmra_studies::study::limit::COMMAND;
use cmra_studies::study::monte_carlo;
use cmra_studies::study::validity;

pub use state::{CANDIDATES, EFFICIENCY_MAP, RESIDUAL};

#[rustfmt::skip]
const PANES: &[PaneSpec] = &[
    PaneSpec { pane: EFFICIENCY_MAP, label: "Mass efficiency", keys: &[
        key(A::Run, "whole map", "compute the whole map, and the comparison below it"),
        key(A::Right, "cursor", "move the cursor; the scene stays as it is"),
        key(A::Down, "up/down", "move the cursor down or up the map"),
        key(A::Enter, "load", "load the design under the cursor into the scene (<undo> undoes)"),
        key(A::View, "residual", "show the residual velocity and V50"),
        key(A::Locate, "value", "type the place of the cursor: v_i 50 gamma 2 (<back> removes it)"),
        key(A::Mark, "pin", "pin the design under the cursor"),
    ] },
    PaneSpec { pane: CANDIDATES, label: "Candidates", keys: &[
        key(A::Down, "more", "scroll"),
        key(A::View, "residual", "show the residual velocity and V50"),
        key(A::Enter, "load", "load the design under the cursor into the scene (<undo> undoes)"),
        key(A::Mark, "pin", "pin the design under the cursor"),
    ] },
    PaneSpec { pane: RESIDUAL, label: "Residual velocity", keys: &[
        key(A::View, "map", "show the map of mass efficiency"),
        key(A::Run, "V50", "compute V50 and its spread, as `cmra montecarlo` does"),
    ] },
];

#[rustfmt::skip]
const COMMANDS: &[Command] = &[
    Command::new(CommandTarget::Do(A::Tab(Tab::Limit)), "Limit tab", "stopped perforated"),
    Command::new(CommandTarget::Show(EFFICIENCY_MAP, None), "Map of mass efficiency", "does it pay pays compare"),
    Command::new(CommandTarget::Show(CANDIDATES, None), "Comparison at equal areal mass", "does it pay pays mass efficiency compare worth candidates"),
    Command::new(CommandTarget::Show(RESIDUAL, None), "Residual velocity", "ballistic limit v50 perforation recht-ipson lambert-jonas"),
];

/// Rows of the verdict: on the shot, and on moving armour.
const VERDICT_ROWS: u16 = 2;
/// Minimum rows below the verdict for map and candidates together.
const BOTH: u16 = 14;
/// Time limit of a comparison when the page is shown; the map has the remaining time.
const COMPARISON_LOOK: Duration = Duration::from_millis(100);

pub(crate) struct LimitTab;

/// Returns the scene whose comparison is neither cached nor being computed: the current scene first, then the design under the cursor.
fn missing_comparison(app: &App) -> Option<Arc<Scene>> {
    let tab = &app.pages.limit;
    let is_known = |kept: &CachedResult<compare::ComparisonReport>, scene: &Scene| {
        let is_there = kept.result.is_some() && *kept.scene == *scene;
        is_there && kept.has_been_looked_at()
    };
    let is_coming = |scene: &Scene| {
        app.jobs.running::<MassComparison>().is_some_and(|running| *running.scene == *scene)
    };
    let missing = if is_known(&tab.own, &app.scene) {
        let design = tab.cursor.and_then(|_| design(app).ok())?.scene;
        (!is_known(&tab.design, &design)).then(|| Arc::new(design))
    } else {
        Some(Arc::clone(&app.scene))
    };
    missing.filter(|scene| !is_coming(scene))
}

fn is_map_missing(app: &App) -> bool {
    let kept = &app.pages.limit.map;
    let is_there = efficiency_map(app).is_some() && kept.has_been_looked_at();
    let running = app.jobs.running::<EfficiencyMapStudy>();
    let is_coming = running.is_some_and(|running| *running.scene == *app.scene);
    map::has_map(&app.scene) && !is_there && !is_coming
}

/// Computes the missing results of the shown pane within the time limit.
fn look(app: &mut App) {
    if app.pane() == RESIDUAL {
        if lacks_limit(app) {
            jobs::look(app, jobs::LOOK, LimitSearch);
        }
        return;
    }
    if app.scene.is_stack() {
        return;
    }
    if let Some(scene) = missing_comparison(app) {
        jobs::look_at(app, COMPARISON_LOOK, &scene, MassComparison);
    } else if app.jobs.running::<MassComparison>().is_none() && is_map_missing(app) {
        let taken = app.pages.limit.own.elapsed.unwrap_or_default().min(COMPARISON_LOOK);
        jobs::look(app, jobs::LOOK.saturating_sub(taken), EfficiencyMapStudy);
    }
}

/// Computes all results of the shown pane.
fn compute(app: &mut App, action: Action) {
    let own = Arc::clone(&app.scene);
    let asked: Vec<(Arc<Scene>, StudyRequest)> = if app.pane() == RESIDUAL {
        let v50 = V50Study(monte_carlo::Request::v50());
        vec![(Arc::clone(&own), LimitSearch.into()), (own, v50.into())]
    } else {
        let is_there = app.pages.limit.own.is_complete() && own_comparison(app).is_some();
        let design = design(app).ok().filter(|_| is_there && app.pages.limit.cursor.is_some());
        let compared = design.map_or_else(|| Arc::clone(&own), |design| Arc::new(design.scene));
        let map = map::has_map(&own).then(|| (own, EfficiencyMapStudy.into()));
        std::iter::once((compared, MassComparison.into())).chain(map).collect()
    };
    jobs::studies(app, action, asked);
}

impl Page for LimitTab {
    fn about(&self) -> About {
        About { pages: &[], panes: PANES, commands: COMMANDS }
    }

    fn shown_panes(&self, app: &App) -> Vec<Pane> {
        if app.pane() == RESIDUAL { vec![RESIDUAL] } else { vec![EFFICIENCY_MAP, CANDIDATES] }
    }

    fn enter(&self, app: &mut App) {
        if efficiency_map(app).is_none() {
            app.pages.limit.cursor = None;
        }
        look(app);
    }

    fn edited(&self, app: &mut App) {
        app.pages.limit.cursor = None;
    }

    fn await_rest(&self, app: &mut App) {
        if app.pane() != RESIDUAL
            && !app.scene.is_stack()
            && (missing_comparison(app).is_some() || is_map_missing(app))
        {
            jobs::begin_rest(app);
        }
    }

    fn rested(&self, app: &mut App) {
        look(app);
    }

    fn act(&self, app: &mut App, action: Action) -> bool {
        match (app.pane(), action) {
            (_, A::Run) => compute(app, action),
            (RESIDUAL, A::View) => app.focus_on(EFFICIENCY_MAP),
            (RESIDUAL, _) => return false,
            (_, A::View) => {
                app.focus_on(RESIDUAL);
                look(app);
            }
            (_, A::Enter) => edit::load_design(app, design(app)),
            (_, A::Mark) => runs::pin_design(app, design(app)),
            (EFFICIENCY_MAP, _) => match cursor_moved(action) {
                Some(by) => map::move_cursor(app, by),
                None => return false,
            },
            _ => return false,
        }
        true
    }

    fn is_of_use(&self, app: &App, action: Action) -> bool {
        let tab = &app.pages.limit;
        match (app.pane(), action) {
            (EFFICIENCY_MAP, A::Run) => !tab.map.is_complete() || efficiency_map(app).is_none(),
            (EFFICIENCY_MAP, _) => action == A::View || efficiency_map(app).is_some(),
            _ => true,
        }
    }

    fn readout(&self, app: &App, _room: usize) -> Option<(Severity, String)> {
        if app.pane() == RESIDUAL { limit_readout(app) } else { note(map::readout(app)) }
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        let tab = &app.pages.limit;
        let done = || part(Severity::Note, "done");
        if app.pane() != RESIDUAL {
            let comparing = app.jobs.running::<MassComparison>();
            let comparing =
                comparing.map(|it| under_way(&format!("comparing{}", it.counted("of", ""))));
            let mapping = match app.jobs.running::<EfficiencyMapStudy>() {
                Some(it) => Some(under_way(&format!("mapping{}", it.counted("of", " points")))),
                None if efficiency_map(app).is_some() && !tab.map.is_complete() => {
                    Some(cut(&tab.map, "points"))
                }
                None => None,
            };
            let shown = if tab.cursor.is_some() { &tab.design } else { &tab.own };
            let stopped = || {
                let is_part = shown.result.is_some() && !shown.is_complete();
                is_part.then(|| cut(shown, "candidates"))
            };
            let first = mapping.or(comparing).or_else(stopped).unwrap_or_else(done);
            return std::iter::once(first).chain(app.validity_part()).collect();
        }
        let scene = limit_scene(app, &tab.report.scene);
        let shots = |it: &Running| format!("finding the limit{}", it.counted("of about", " shots"));
        let finding = progress::<LimitSearch, _>(app, &tab.report, &scene, shots, "shots");
        let mut parts = vec![finding.unwrap_or_else(done)];
        let sampling = |it: &Running| format!("V50{}", it.counted("of", " samples"));
        parts.extend(app.jobs.running::<V50Study>().map(|it| under_way(&sampling(it))));
        let spread = Some(&tab.spread).filter(|it| it.result.is_some() && !it.is_complete());
        let is_shown = app.jobs.running::<V50Study>().is_none();
        parts.extend(spread.filter(|_| is_shown).map(|it| cut(it, "samples of V50")));
        if let Some(report) = &tab.report.result {
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
        let is_own = *running.scene == *app.scene;
        let tab = &mut app.pages.limit;
        tab.report.keep(running, news);
        tab.spread.keep(running, news);
        tab.map.keep(running, news);
        if is_own { &mut tab.own } else { &mut tab.design }.keep(running, news);
        if efficiency_map(app).is_none() {
            app.pages.limit.cursor = None;
        }
        let tab = &mut app.pages.limit;
        if let (Some(map), false) = (&tab.map.result, tab.map.is_complete()) {
            let done = map.cells.iter().flatten().count();
            tab.map.reach = Reach::Partial(Progress { done, total: map.cells.len() });
        }
        // Compute in order: the comparison of the scene, the map, the design under the cursor.
        let is_whole =
            matches!(news, ReportBody::Ended(Some(answer)) if answer.reach.is_complete());
        if is_whole && app.tab == Tab::Limit && app.pane() != RESIDUAL {
            look(app);
        }
    }

    fn table(&self, app: &App) -> Option<PageTable> {
        let tab = &app.pages.limit;
        if app.pane() == RESIDUAL {
            let kept = &tab.report;
            let report = kept.result.clone().filter(|report| !report.shots.is_empty())?;
            let name = name_of(app, &kept.scene);
            let csv = move |reach| {
                let warnings = limit::warnings(&report);
                limit::shots(&name, &report).with_warnings(&warnings).with_reach(reach).csv()
            };
            let title = "Export the shots to CSV";
            let table = PageTable::new(title, "limit", kept.reach, csv);
            return Some(table.for_scene(app, &kept.scene, COMMAND));
        }
        let mut request = compare::Request::default();
        if app.pane() == CANDIDATES {
            let kept = if tab.cursor.is_some() { &tab.design } else { &tab.own };
            let (found, name) = (kept.result.clone()?, name_of(app, &kept.scene));
            let csv = move |reach| {
                let warnings = validity::of_scene(&found.scene);
                let table = report::compare::table(&name, &found);
                table.with_warnings(&warnings).with_reach(reach).csv()
            };
            let table = PageTable::new("Export the comparison to CSV", "compare", kept.reach, csv);
            return Some(table.for_scene(app, &kept.scene, request.to_string()));
        }
        let kept = &tab.map;
        let (map, name) = (kept.result.clone()?, name_of(app, &kept.scene));
        request.map = Some([map.x().clone(), map.y().clone()]);
        let csv = move |reach| report::compare::map_table(&name, &map).with_reach(reach).csv();
        let table = PageTable::new("Export the map to CSV", "mass-efficiency", kept.reach, csv);
        Some(table.for_scene(app, &kept.scene, request.to_string()))
    }

    fn rows(&self, app: &App) -> Option<Rows> {
        if app.pane() != CANDIDATES {
            return None;
        }
        let area = area(app, app.layout().body?, CANDIDATES)?;
        let lines = candidate_lines(app, usize::from(area.width.saturating_sub(2)));
        let shown = usize::from(area.height.saturating_sub(2));
        let count = lines.len().saturating_sub(shown) + 1;
        Some(Rows { count, selected: app.pages.limit.scrolled.min(count - 1), shown })
    }

    fn select(&self, app: &mut App, row: usize) {
        app.pages.limit.scrolled = row;
    }

    fn go_to_cell(&self, app: &mut App, cell: (usize, usize)) {
        app.pages.limit.cursor = Some(cell);
    }

    fn places(&self, app: &App) -> Vec<(String, String)> {
        if app.pane() == EFFICIENCY_MAP { map::places(app) } else { Vec::new() }
    }

    fn go_to_place(&self, app: &mut App, text: &str) -> Result<(), String> {
        map::go_to_place(app, text)
    }

    fn remove_cursor(&self, app: &mut App) -> bool {
        app.pane() != RESIDUAL && app.pages.limit.cursor.take().is_some()
    }

    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>) {
        if app.pane() != RESIDUAL {
            verdict(app, body, canvas);
        }
        for spec in PANES {
            let Some(area) = area(app, body, spec.pane) else { continue };
            canvas.pane(area, spec.pane);
            match spec.pane {
                RESIDUAL => residual::render(app, area, canvas),
                CANDIDATES => comparison::render(app, area, canvas),
                _ => map::render(app, area, canvas),
            }
        }
    }
}

/// Draws the verdicts: whether and by how much the armour stops the shot, and whether and where moving pays.
fn verdict(app: &App, body: Rect, canvas: &mut Canvas<'_>) {
    let room = usize::from(body.width.saturating_sub(2));
    let Some((report, own)) =
        own_comparison(app).and_then(|it| Some((it, it.entry(Candidate::Scene)?)))
    else {
        let words = match app.jobs.running::<MassComparison>() {
            Some(_) => "finding the limit of this scene",
            None if app.scene.is_stack() => {
                "no limit at equal mass: a stack is compared with nothing"
            }
            None => NO_RESULTS,
        };
        canvas.put(body, (1, 0), &app.keymap.shown(words), Role::Dim);
        return;
    };
    let first = fitting(headlines(&report.scene, own.perforation, ""), room);
    let (answer, why) = short_verdict(report);
    let place = efficiency_map(app).and_then(|map| where_it_pays(map, &app.scene));
    let place = place.map_or_else(String::new, |place| format!("; {place}"));
    let cause = why.split(", ").next().unwrap_or_default().to_owned();
    let ends = [format!("{why}{place}"), place, why.clone(), cause, String::new()];
    let second = ends.map(|end| format!("{answer}{end}"));
    let second = fitting(second, room);
    canvas.put(body, (1, 0), &first, Role::Title);
    canvas.put(body, (1, 1), &second, Role::Title);
}

/// Returns the area of a pane: the residual velocity alone; the candidates below the map, or the focused pane alone if there is no room for
/// both.
fn area(app: &App, body: Rect, pane: Pane) -> Option<Rect> {
    let focus = app.pane();
    if pane == RESIDUAL || focus == RESIDUAL {
        return (pane == focus).then_some(body);
    }
    let (_, rest) = split_top(body, VERDICT_ROWS);
    let candidates = match rest.height {
        0..BOTH => return (pane == focus).then_some(rest),
        BOTH..24 => 5,
        24..36 => 11,
        36.. => 17,
    };
    let (above, below) = split_bottom(rest, candidates);
    Some(if pane == CANDIDATES { below } else { above })
}
