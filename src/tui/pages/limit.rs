//! The Limit tab: the ballistic limit, the residual velocity, and the comparison at equal areal mass.

pub mod comparison;
pub mod state;

use crate::report::{compare, limit};
use crate::study::limit::Limit;
use crate::tui::app::layout::NARROW;
use crate::tui::app::status::outside;
use crate::tui::dialogs::{around, ask, wrap};
use crate::tui::pages::limit::comparison::EqualMass;
use crate::tui::pages::limit::state::LimitSearch;
use crate::tui::pages::prelude::*;
use crate::tui::pages::run::runs;
use crate::tui::update::act::{along, cursor_moved, moved};

/// The residual velocity over the impact velocity.
pub const RESIDUAL: Pane = Pane::of(Tab::Limit, 0);
/// The comparison at equal areal mass.
pub const COMPARISON: Pane = Pane::of(Tab::Limit, 1);
pub const EFFICIENCY_MAP: Pane = Pane::of(Tab::Limit, 2);

#[rustfmt::skip]
const PANES: &[PaneSpec] = &[
    PaneSpec { pane: RESIDUAL, label: "Residual velocity", has: &[Part::Chart], keys: &[
        key(A::Right, "shot", "move the cursor to the next faster shot"),
        key(A::View, "V50", "V50 and its spread (inputs but v_i +-2 %; model error: cmra limit)"),
        key(A::Enter, "load", "load the impact velocity under the cursor (<undo> undoes)"),
        key(A::ZoomIn, "zoom", "zoom the impact velocity about the cursor"),
    ] },
    PaneSpec { pane: COMPARISON, label: "Comparison", has: &[], keys: &[
        key(A::View, "absorber", "compare with the next absorber, or with the scene's own"),
        key(A::Enter, "load", "load the scene with this absorber (<undo> undoes)"),
    ] },
    PaneSpec { pane: EFFICIENCY_MAP, label: "Mass efficiency", has: &[], keys: &[
        key(A::Right, "cursor", "move the cursor; the scene stays as it is"),
        key(A::Enter, "load", "load the design under the cursor into the scene (<undo> undoes)"),
        key(A::Mark, "pin", "pin the design under the cursor"),
    ] },
];

#[rustfmt::skip]
const COMMANDS: &[Command] = &[
    Command::new(Call::Do(A::Tab(Tab::Limit)), "Limit tab", "stopped perforated"),
    Command::new(Call::Show(RESIDUAL, None), "Ballistic limit", "v50 residual velocity perforation recht-ipson lambert-jonas"),
    Command::new(Call::Show(COMPARISON, None), "Comparison at equal areal mass", "does it pay pays mass efficiency compare worth absorber"),
    Command::new(Call::Show(EFFICIENCY_MAP, None), "Efficiency map", "mass efficiency compare worth"),
];

pub(crate) struct LimitTab;

impl Page for LimitTab {
    fn about(&self) -> &'static About {
        &About { name: "Limit", pages: &[], panes: PANES, commands: COMMANDS }
    }

    fn enter(&self, app: &mut App) {
        let found = app.pages.limit.report.is_there(&app.limit_scene());
        if !found && !app.jobs.is_coming::<LimitSearch>(&app.scene) {
            find(app);
        }
        let kept = &app.pages.limit.comparison;
        let wanted = app.compared_scene();
        if wanted.is_ok_and(|scene| !app.jobs.lacks::<EqualMass, _>(kept, &scene)) {
            return;
        }
        compare(app);
    }

    fn act(&self, app: &mut App, action: Action) -> bool {
        match (action, app.pane()) {
            (Action::Run, RESIDUAL) => find(app),
            (Action::Run, _) => compare(app),
            (_, COMPARISON) => return in_comparison(app, action),
            (_, EFFICIENCY_MAP) => return in_map(app, action),
            _ => return in_curve(app, action),
        }
        true
    }

    fn is_idle(&self, app: &App, action: Action) -> bool {
        app.pane() == EFFICIENCY_MAP && action == Action::View
    }

    fn readout(&self, app: &App, _room: usize) -> Option<(Severity, String)> {
        match app.pane() {
            RESIDUAL => app.limit_readout(),
            COMPARISON => note(app.comparison_readout()),
            _ => note(app.efficiency_readout()),
        }
    }

    fn status(&self, app: &App) -> Vec<StatusPart> {
        let tab = &app.pages.limit;
        let done = || Progress::Done("done".to_owned());
        let words = |it: &Running| format!("comparing{}", it.counted("of", ""));
        if app.pane() != RESIDUAL {
            let of_map = app.pane() == EFFICIENCY_MAP;
            let scene = if of_map { app.efficiency_scene() } else { app.compared_scene() };
            let scene = scene.unwrap_or_default();
            let comparing = progress::<EqualMass, _>(app, &tab.comparison, &scene, words);
            let first = comparing.unwrap_or_else(done).part();
            return std::iter::once(first).chain(app.validity_part()).collect();
        }
        let finding = progress::<LimitSearch, _>(app, &tab.report, &app.limit_scene(), |it| {
            format!("finding the limit{}", it.counted("of about", " shots"))
        });
        let mut parts = vec![finding.unwrap_or_else(done).part()];
        if let Some(report) = &tab.report.found {
            let comparing = app.jobs.running::<EqualMass>();
            parts.extend(comparing.map(|it| Progress::Running(words(it)).part()));
            let at_limit = report.at_limit.as_ref();
            parts.extend(at_limit.map_or_else(
                || app.validity_part(),
                |it| outside(it.breaches.iter().map(|breach| breach.check), " at the limit", ""),
            ));
            if let Limit::Found { basis, .. } = report.limit {
                parts.push(part(Severity::Note, format!("by {}", basis.words())));
            }
            parts.push(part(Severity::Note, format!("curve of {} shots", report.shots.len())));
        }
        parts
    }

    fn report(&self, app: &mut App, running: &Running, news: &ReportBody) {
        app.pages.limit.keep(running, news);
    }

    fn table(&self, app: &App) -> Option<PageTable> {
        let stem = ask::base_stem(app);
        if app.pane() == RESIDUAL {
            let kept = &app.pages.limit.report;
            let report = kept.found.as_ref().filter(|report| !report.shots.is_empty())?;
            let (report, is_complete) = (Arc::clone(report), kept.is_complete);
            let file = format!("{stem}-limit.csv");
            let csv = move |name: &str| limit::shots(name, &report).csv();
            let table = PageTable::new("Export the shots to CSV", file, is_complete, csv);
            return Some(table.of(app, &kept.scene));
        }
        let kept = &app.pages.limit.comparison;
        let found = Arc::clone(kept.found.as_ref()?);
        if app.pane() == COMPARISON {
            let (file, is_complete) = (format!("{stem}-compare.csv"), found.report.is_complete);
            let csv = move |name: &str| compare::table(name, &found.report).csv();
            let table = PageTable::new("Export the comparison to CSV", file, is_complete, csv);
            return Some(table.of(app, &kept.scene));
        }
        let (map, file) = (found.map.clone()?, format!("{stem}-mass-efficiency.csv"));
        let is_complete = map.is_complete();
        let csv = move |name: &str| compare::map_table(name, &map).csv();
        Some(PageTable::new("Export the map to CSV", file, is_complete, csv).of(app, &kept.scene))
    }

    fn rows(&self, app: &App) -> Option<Rows> {
        match app.pane() {
            RESIDUAL => {
                let (count, selected) = (app.pages.limit.shots().len(), app.pages.limit.shot_at());
                Some(Rows { count, selected, shown: 1 })
            }
            COMPARISON => {
                let area = panes(app, app.layout().body?).comparison?;
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
        let own_m_s = app.limit_shot_m_s();
        let tab = &mut app.pages.limit;
        let (x, _) = limit::axes(tab.report.found.as_ref()?, own_m_s)?;
        let scale = if tab.log.0 { Scale::Log10 } else { x.scale };
        let about = tab.shot().map(|shot| shot.impact_m_s);
        Some(Across::of(&mut tab.zoomed, x.view, scale, about))
    }

    fn draw(&self, app: &App, body: Rect, canvas: &mut Canvas<'_>) {
        let panes = panes(app, body);
        if let Some(area) = panes.comparison {
            comparison::render(app, area, canvas);
        }
        if let Some(area) = panes.residual {
            state::render(app, area, canvas);
        }
        if let Some(area) = panes.map {
            comparison::map(app, area, canvas);
        }
    }
}

/// Far along the curve, in shots, and over the map, in cells.
const FAR: i16 = 5;
const FAR_CELLS: i16 = 10;

fn in_curve(app: &mut App, action: Action) -> bool {
    match action {
        Action::View => {
            app.pages.limit.sampled = !app.pages.limit.sampled;
            find(app);
        }
        Action::Down | Action::PageDown => turn(app, 1),
        Action::Up | Action::PageUp => turn(app, -1),
        Action::LogX => app.pages.limit.log.0 = !app.pages.limit.log.0,
        Action::LogY => app.pages.limit.log.1 = !app.pages.limit.log.1,
        Action::Enter => load_shot(app),
        _ => match along(action, FAR) {
            Some(by) => app.pages.limit.move_cursor(by.into()),
            None => return false,
        },
    }
    true
}

fn load_shot(app: &mut App) {
    if app.limit_is_old() {
        return app.refuse(old("scene"));
    }
    let Some(velocity_m_s) = app.pages.limit.shot().map(|shot| shot.impact_m_s) else {
        return app.tell("no shot under the cursor: <left> and <right> move it");
    };
    let mut scene = (*app.scene).clone();
    scene.projectile.velocity_m_s = velocity_m_s;
    let label = format!("v_i = {} m/s", significant(velocity_m_s, 4));
    edit::load_design(app, Ok(LabelledScene { scene, label }));
}

fn in_comparison(app: &mut App, action: Action) -> bool {
    match action {
        Action::View => {
            let names = app.absorbers().into_iter().map(|entry| entry.name.as_str());
            let all: Vec<Option<&str>> = std::iter::once(None).chain(names.map(Some)).collect();
            let now = app.absorber().map(|entry| entry.name.as_str());
            app.pages.limit.absorber = around(&all, now, 1).map(str::to_owned);
            compare(app);
        }
        Action::Enter => match (app.compared_scene(), app.absorber()) {
            (_, None) => app.tell("the scene's own spring: <view> takes one of the library"),
            (scene, Some(absorber)) => {
                // The absorber stays chosen: the comparison is one of this scene, and of the one before when it is undone.
                let label = format!("absorber {}", absorber.name);
                edit::load_design(app, scene.map(|scene| LabelledScene { scene, label }));
            }
        },
        _ => return false,
    }
    true
}

fn in_map(app: &mut App, action: Action) -> bool {
    match (action, cursor_moved(action, FAR_CELLS)) {
        (Action::Enter, _) => {
            let before = Arc::clone(&app.scene);
            edit::load_design(app, app.efficiency_design());
            if app.scene != before {
                let own = significant(1e3 * app.scene.target.thickness_m, 4);
                app.tell(format!(
                    "loaded with h = {own} mm as it was: the map is of plates that just stop the shot (<undo> undoes)"
                ));
            }
        }
        (Action::Mark, _) => runs::pin_design(app, app.efficiency_design()),
        (_, Some(by)) => move_on_map(app, by),
        (_, None) => return false,
    }
    true
}

fn move_on_map(app: &mut App, by: (isize, isize)) {
    let map = app.comparison().and_then(|found| found.map.as_ref());
    if let Some((map, at)) = map.zip(app.efficiency_cursor()) {
        let count = |points: u64| usize::try_from(points).unwrap_or(usize::MAX);
        let counts = (count(map.x().count()), count(map.y().count()));
        app.pages.limit.map_cursor = Some(moved(at, by, counts));
    }
}

fn compare(app: &mut App) {
    match app.compared_scene() {
        Ok(scene) => jobs::study_of(
            app,
            Tab::Limit,
            &Arc::new(scene),
            EqualMass { absorber: app.pages.limit.absorber.clone() },
        ),
        Err(why) => app.refuse(why),
    }
}

/// Turn from the curve through the pages of words, in a circle.
fn turn(app: &mut App, by: isize) {
    let pages = app.limit_pages().map_or(0, |(_, pages)| pages);
    app.pages.limit.page = wrap(app.pages.limit.page.min(pages), by, pages + 1);
}

fn find(app: &mut App) {
    let (effort, scene) = (app.pages.limit.effort(), Arc::clone(&app.scene));
    jobs::study_of(app, Tab::Limit, &scene, LimitSearch(effort));
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct LimitPanes {
    /// The comparison at equal areal mass.
    pub comparison: Option<Rect>,
    pub residual: Option<Rect>,
    pub map: Option<Rect>,
}

/// The comparison above the residual velocity and the map; the pane that has the keys alone where there is no room for three.
pub(crate) fn panes(app: &App, body: Rect) -> LimitPanes {
    let focus = app.pane();
    let rows = if body.height < ROOM_FOR_FIGURES { VERDICT_ROWS } else { COMPARISON_ROWS };
    if app.is_full() || body.height < rows + 8 {
        let of = |pane| (focus == pane).then_some(body);
        return LimitPanes {
            comparison: of(COMPARISON),
            residual: of(RESIDUAL),
            map: of(EFFICIENCY_MAP),
        };
    }
    let (comparison, below) = split_bottom(body, body.height - rows);
    if body.width < NARROW {
        let map = focus == EFFICIENCY_MAP;
        return LimitPanes {
            comparison: Some(comparison),
            residual: (!map).then_some(below),
            map: map.then_some(below),
        };
    }
    let (left, right) = split_left(below, below.width / 2);
    LimitPanes { comparison: Some(comparison), residual: Some(left), map: Some(right) }
}

/// Rows of the comparison, frame included; of the verdict alone where the body is lower than this, so that charts can be read.
const COMPARISON_ROWS: u16 = 10;
const VERDICT_ROWS: u16 = 6;
const ROOM_FOR_FIGURES: u16 = 26;
