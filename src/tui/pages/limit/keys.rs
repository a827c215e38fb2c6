//! The Limit tab: asking for the limit and for the comparison at equal areal mass, moving along the curve and over the map.

use std::sync::Arc;

use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::dialogs::wrap;
use crate::tui::keymap::Action;
use crate::tui::message::Effect;
use crate::tui::pages::Tab;
use crate::tui::pages::limit::comparison::EqualMass;
use crate::tui::pages::limit::state::LimitSearch;
use crate::tui::pages::limit::{COMPARISON, EFFICIENCY_MAP, RESIDUAL};
use crate::tui::pages::run::runs;
use crate::tui::update::act::cursor_moved;
use crate::tui::update::{edit, jobs};

/// Far along the curve, in shots, and over the map, in cells.
const FAR: isize = 5;
const FAR_CELLS: isize = 10;

/// The tab is shown: find the limit, and compare, unless this scene's results are there or are being computed.
pub(in crate::tui) fn enter(app: &mut App) -> Vec<Effect> {
    let tab = &app.pages.limit;
    let found = tab.report.as_ref().is_some_and(|report| *report.scene == *app.scene);
    let coming = app.jobs.is_coming::<LimitSearch>(&app.scene);
    let mut effects = if found || coming { Vec::new() } else { find(app) };
    let comparing =
        app.compared_scene().is_ok_and(|wanted| app.jobs.is_coming::<EqualMass>(&wanted));
    let compared = app.pages.limit.comparison.is_some() && !app.comparison_is_old();
    if !comparing && !compared {
        effects.extend(compare(app));
    }
    effects
}

/// What an action does here; `None` where it means nothing of its own.
pub(in crate::tui) fn act(app: &mut App, action: Action) -> Option<Vec<Effect>> {
    match action {
        Action::Run if app.pane() == RESIDUAL => return Some(find(app)),
        Action::Run => return Some(compare(app)),
        _ => {}
    }
    match app.pane() {
        COMPARISON => in_comparison(app, action),
        EFFICIENCY_MAP => in_map(app, action),
        _ => in_curve(app, action),
    }
}

fn in_curve(app: &mut App, action: Action) -> Option<Vec<Effect>> {
    match action {
        Action::View => {
            app.pages.limit.sampled = !app.pages.limit.sampled;
            return Some(find(app));
        }
        Action::Down | Action::PageDown => turn(app, 1),
        Action::Up | Action::PageUp => turn(app, -1),
        Action::Left => app.pages.limit.move_cursor(-1),
        Action::Right => app.pages.limit.move_cursor(1),
        Action::FarLeft => app.pages.limit.move_cursor(-FAR),
        Action::FarRight => app.pages.limit.move_cursor(FAR),
        Action::First => {
            app.pages.limit.cursor = (!app.pages.limit.shots().is_empty()).then_some(0);
        }
        Action::Last => app.pages.limit.cursor = app.pages.limit.shots().len().checked_sub(1),
        Action::LogX => app.pages.limit.log.0 = !app.pages.limit.log.0,
        Action::LogY => app.pages.limit.log.1 = !app.pages.limit.log.1,
        Action::Enter => return Some(load_shot(app)),
        _ => return None,
    }
    Some(Vec::new())
}

fn load_shot(app: &mut App) -> Vec<Effect> {
    if app.limit_is_old() {
        return app.refuse("these results belong to another scene: press r to find its limit");
    }
    let Some(velocity_m_s) = app.pages.limit.shot().map(|shot| shot.impact_m_s) else {
        app.say(Severity::Note, "no shot under the cursor: h and l move it");
        return Vec::new();
    };
    let mut scene = (*app.scene).clone();
    scene.projectile.velocity_m_s = velocity_m_s;
    let text = format!("v_i = {} m/s", crate::model::units::significant(velocity_m_s, 4));
    edit::load_design(app, Ok((scene, text)))
}

fn in_comparison(app: &mut App, action: Action) -> Option<Vec<Effect>> {
    match action {
        Action::View => {
            app.pages.limit.absorber = wrap(app.pages.limit.absorber, 1, app.absorbers().len() + 1);
            Some(compare(app))
        }
        Action::Enter => Some(match (app.compared_scene(), app.absorber()) {
            (_, None) => {
                app.say(Severity::Note, "the scene's own spring: v takes one of the library");
                Vec::new()
            }
            (Ok(scene), Some(absorber)) => {
                let name = format!("absorber {}", absorber.name);
                app.pages.limit.absorber = 0;
                edit::load_scene(app, scene, &name)
            }
            (Err(why), _) => app.refuse(why),
        }),
        _ => None,
    }
}

fn in_map(app: &mut App, action: Action) -> Option<Vec<Effect>> {
    match action {
        Action::Enter => return Some(edit::load_design(app, app.efficiency_design())),
        Action::Mark => return Some(runs::keys::pin_design(app, app.efficiency_design())),
        _ => {}
    }
    let (x, y) = cursor_moved(action, FAR_CELLS)?;
    let map = app.comparison().and_then(|found| found.map.as_ref());
    let counts = map.map(|map| (map.x().count(), map.y().count()));
    if let (Some((across, up)), Some(at)) = (counts, app.efficiency_cursor()) {
        let moved = |at: usize, by: isize, count: u64| {
            let last = usize::try_from(count.saturating_sub(1)).unwrap_or(usize::MAX);
            at.saturating_add_signed(by).min(last)
        };
        app.pages.limit.map_cursor = Some((moved(at.0, x, across), moved(at.1, y, up)));
    }
    Some(Vec::new())
}

fn compare(app: &mut App) -> Vec<Effect> {
    let scene = match app.compared_scene() {
        Ok(scene) => Arc::new(scene),
        Err(why) => {
            return app.refuse(why);
        }
    };
    jobs::study(app, Tab::Limit, &scene, EqualMass)
}

/// Turn from the curve through the pages of words, in a circle.
fn turn(app: &mut App, by: isize) {
    let pages = app.limit_pages().map_or(0, |(_, pages)| pages);
    app.pages.limit.page = wrap(app.pages.limit.page.min(pages), by, pages + 1);
}

fn find(app: &mut App) -> Vec<Effect> {
    let (effort, scene) = (app.pages.limit.effort(), Arc::clone(&app.scene));
    jobs::study(app, Tab::Limit, &scene, LimitSearch(effort))
}
