//! The Stability tab: asking for the map and the battery, and moving about in them.

use std::sync::Arc;

use crate::model::units::significant;
use crate::model::variables::{VARIABLES, Value};
use crate::study::stability::map::{Axis, Method};
use crate::tui::app::App;
use crate::tui::app::notice::Severity;
use crate::tui::keymap::Action;
use crate::tui::message::Effect;
use crate::tui::pages::Tab;
use crate::tui::pages::numerics::STIFF_SCENES;
use crate::tui::pages::numerics::stability::{StabilityMap, StiffScenes};
use crate::tui::update::act::cursor_moved;
use crate::tui::update::{edit, jobs};

/// Far along the map.
const FAR: isize = 10;

/// What is shown is computed, unless it has been or is being.
pub(in crate::tui) fn enter(app: &mut App) -> Vec<Effect> {
    let tab = &app.pages.numerics.stability;
    if app.pane() == STIFF_SCENES {
        let there = tab.battery.as_ref().is_some_and(|battery| battery.is_complete)
            || app.jobs.running::<StiffScenes>().is_some();
        return if there { Vec::new() } else { battery(app) };
    }
    let there = tab.map.as_ref().is_some_and(|(scene, map)| {
        let is_wanted = map.method == tab.method && map.axis == tab.axis;
        *scene == app.scene && is_wanted && map.is_complete()
    });
    if there || app.jobs.is_coming::<StabilityMap>(&app.scene) { Vec::new() } else { map(app) }
}

/// What an action does here; `None` where it means nothing of its own.
pub(in crate::tui) fn act(app: &mut App, action: Action) -> Option<Vec<Effect>> {
    if app.pane() == STIFF_SCENES { in_battery(app, action) } else { in_map(app, action) }
}

fn in_battery(app: &mut App, action: Action) -> Option<Vec<Effect>> {
    match action {
        Action::Run => return Some(battery(app)),
        Action::View => app.pages.numerics.stability.table_page += 1,
        Action::Sort => app.pages.numerics.stability.sort_next(),
        _ => return None,
    }
    Some(Vec::new())
}

fn in_map(app: &mut App, action: Action) -> Option<Vec<Effect>> {
    let tab = &mut app.pages.numerics.stability;
    match action {
        Action::Run => return Some(map(app)),
        Action::View => {
            // Three variables, then the same with the other method.
            (tab.axis, tab.method) = match (tab.axis, tab.method) {
                (Axis::K, method) => (Axis::N, method),
                (Axis::N, method) => (Axis::B, method),
                (Axis::B, Method::Thesis) => (Axis::K, Method::Rk4),
                (Axis::B, Method::Rk4) => (Axis::K, Method::Thesis),
            };
            return Some(map(app));
        }
        Action::Enter => return Some(load(app)),
        _ => {
            let (columns, rows) = cursor_moved(action, FAR)?;
            tab.move_cursor(rows.clamp(-100, 100), columns.clamp(-1000, 1000));
        }
    }
    Some(Vec::new())
}

/// Load the value of the row under the cursor into the scene.
fn load(app: &mut App) -> Vec<Effect> {
    if app.map_is_old() || app.pages.numerics.stability.map.is_none() {
        return app.refuse("no map of this scene: press r to compute it");
    }
    let found =
        app.pages.numerics.stability.map.as_ref().zip(app.pages.numerics.stability.cursor());
    let Some(((_, map), (row, _))) = found else { return Vec::new() };
    let (symbol, value) = (map.axis.symbol(), map.values[row]);
    let Some(index) = VARIABLES.iter().position(|one| one.symbol == symbol) else {
        return Vec::new();
    };
    match edit::set(app, index, Value::Number(value), None) {
        Ok(effects) => {
            let text = format!("loaded {symbol} = {} (u undoes)", significant(value, 4));
            app.say(Severity::Note, text);
            effects
        }
        Err(error) => app.refuse(error),
    }
}

fn map(app: &mut App) -> Vec<Effect> {
    let map = StabilityMap {
        method: app.pages.numerics.stability.method,
        axis: app.pages.numerics.stability.axis,
    };
    let scene = Arc::clone(&app.scene);
    jobs::study(app, Tab::Numerics, &scene, map)
}

fn battery(app: &mut App) -> Vec<Effect> {
    let scene = Arc::clone(&app.scene);
    jobs::study(app, Tab::Numerics, &scene, StiffScenes)
}
