//! Current and pinned runs: table, names, pinning and copying.

use crate::tui::app::pins::{LETTERS, Pin};
use crate::tui::chart::MARKERS;
use crate::tui::pages::page::prelude::*;
use crate::tui::pages::run::editor::shown_value;
use crate::tui::pages::run::state::RUNS;
use crate::tui::widgets::table::{Grid, NAME_LEAST};
use crate::tui::widgets::value_steps::shown_number;
use cmra_engine::model::run::{Outcome, Run};
use cmra_engine::model::variables::{VARIABLES, Value};
use cmra_studies::report::run::{Compared, comparison};
use cmra_studies::report::table::Table;

/// Returns the table that compares the current run with the pinned runs.
pub(crate) fn compared_runs(app: &App) -> Table<'_, Compared<'_>> {
    let absent = |runs: bool| if runs { "running" } else { "no result" };
    let now = app.shown.as_ref().map(|shown| &*shown.run);
    let now = now.ok_or_else(|| absent(app.jobs.current.is_some()));
    let pins = app.pins.iter().map(move |pin| {
        (pin.name.clone(), pin.run.as_deref().ok_or_else(|| absent(pin.job.is_some())))
    });
    comparison(std::iter::once((name_of(app, &app.scene), now)).chain(pins))
}

/// Returns the pin selected in the table of runs; `None` for the current run.
fn selected_pin(app: &App) -> Option<&Pin> {
    app.pins.get(app.pages.run.selected.checked_sub(1)?)
}

/// Returns a name for a scene: the preset's if nothing differs, else the differences (`gamma=1 d=0.5`).
pub fn name_of(app: &App, scene: &Scene) -> String {
    let differing = App::differing(scene, &app.base.scene);
    if differing.is_empty() {
        // Use the file name of a path.
        return app.base.name.rsplit('/').next().unwrap_or_default().to_owned();
    }
    let shown = |index: usize| {
        let variable = &VARIABLES[index];
        let value = match variable.value(scene) {
            Value::Number(number) => shown_number(number, 24),
            _ => variable.show(scene),
        };
        format!("{}={value}", variable.symbol)
    };
    differing.into_iter().map(shown).collect::<Vec<_>>().join(" ")
}

/// Columns of marker, letter and a blank before the name.
const LEAD: u16 = 5;
/// Minimum width for all columns of the table.
const ALL_COLUMNS: u16 = 72;

/// Returns the rows of the table that fit a screen with this body, without its heading: all of a few runs, some of many.
pub(crate) fn rows_shown(app: &App, body: Rect) -> u16 {
    let all = u16::try_from(app.pins.len() + 1).unwrap_or(u16::MAX);
    all.min((body.height / 6).max(1))
}

pub(crate) fn render(app: &App, area: Rect, focused: bool, canvas: &mut Canvas<'_>) {
    canvas.pane(area, RUNS);
    let table = compared_runs(app);
    let mut keys = table.keys();
    if area.width < ALL_COLUMNS {
        keys.retain(|key| !matches!(*key, "plastic" | "peak_mount_force_n"));
    }
    let grid = Grid::new(table.cells(&keys), area.width.saturating_sub(LEAD + 1), NAME_LEAST);
    let role = if focused { Role::Focus } else { Role::Title };
    canvas.put(area, (LEAD, 0), &grid.line(None), role);
    let list = Rect { y: area.y + 1, height: area.height.saturating_sub(1), ..area };
    let (count, selected) = (app.pins.len() + 1, app.pages.run.selected);
    let rows = RowList { count, selected, painted: focused };
    let hidden = count.saturating_sub(usize::from(list.height));
    if hidden > 0 {
        canvas.put(area, (0, 0), &format!("+{hidden}"), Role::Warning);
    }
    rows.render(
        canvas,
        list,
        |row| Some(Target::Row(RUNS, row)),
        |canvas, row, index| {
            let pin = index.checked_sub(1).map(|at| app.pins[at].letter.to_string());
            let name = pin.as_deref().unwrap_or("now");
            let label = format!("{}{name}", MARKERS[index % MARKERS.len()]);
            canvas.put(row, (0, 0), &label, Role::Curve(index));
            let line = grid.line(Some(index));
            canvas.put(row, (LEAD, 0), &line, Role::Text);
            let through = line.find("perforated").map(|at| LEAD + columns(&line[..at]));
            if let Some(at) = through {
                canvas.put(row, (at, 0), "perforated", Role::Warning);
            }
        },
    );
}

/// Describes the difference of the current run to the selected pin, else to the first one, and the changed variables.
pub(crate) fn difference(app: &App) -> Option<String> {
    let pin = selected_pin(app).or_else(|| app.pins.first())?;
    let depth = |run: &Run| run.penetration.final_m.filter(|_| run.outcome == Outcome::Arrested);
    let pair = app.shown.as_ref().zip(pin.run.as_ref());
    let pair = pair.and_then(|(now, pin)| Some((depth(&now.run)?, depth(pin)?)));
    let gained = pair.map_or_else(
        || "no depths to compare".to_owned(),
        |(now, then)| {
            let percent = 100.0 * (now - then) / then;
            format!("depth {:+.4} mm ({percent:+.1} %)", (now - then) * 1e3)
        },
    );
    let differing = App::differing(&pin.scene, &app.scene).into_iter();
    let words: Vec<String> = differing
        .map(|index| {
            let variable = &VARIABLES[index];
            let shown = |scene: &Scene| shown_value(variable, scene);
            format!("{} {} -> {}", variable.symbol, shown(&pin.scene), shown(&app.scene))
        })
        .collect();
    let changed = if words.is_empty() { "same scene".to_owned() } else { words.join(", ") };
    Some(format!("now - {}: {gained}; {changed}", pin.letter))
}

/// Pins the scene; unpins it if it is already pinned.
pub(crate) fn pin_scene(app: &mut App) {
    if let Some(pin) = app.pins.iter().find(|pin| *pin.scene == *app.scene).cloned() {
        return unpinned(app, &pin);
    }
    let name = name_of(app, &app.scene);
    let scene = Arc::clone(&app.scene);
    pin(app, name, scene);
}

/// Pins the design under a cursor, or reports the reason why there is none.
pub(crate) fn pin_design(app: &mut App, design: Result<LabelledScene, String>) {
    match design {
        Ok(design) => pin(app, design.label, Arc::new(design.scene)),
        Err(why) => app.refuse(why),
    }
}

/// Pins a scene under the next free letter, with the displayed result or a new run.
pub(crate) fn pin(app: &mut App, name: String, scene: Arc<Scene>) {
    if let Some(pin) = app.pins.iter().find(|pin| *pin.scene == *scene) {
        let text = format!("this scene is pinned already, as {}", pin.letter);
        return app.report_progress(text);
    }
    let is_free = |letter: &char| app.pins.iter().all(|pin| pin.letter != *letter);
    let Some(letter) = LETTERS.into_iter().find(is_free) else {
        return app
            .refuse("all eight pins A to H are taken: <mark> on one in the pane Runs unpins it");
    };
    let shown = app.shown.as_ref().filter(|it| *it.run.scene == *scene && it.elapsed.is_some());
    let run = shown.map(|shown| Arc::clone(&shown.run));
    let pin = Pin { run, ..Pin::new(letter, name, scene) };
    app.report_progress(format!("pinned as {}", pin.label()));
    edit::pin(app, pin);
}

/// Returns the pin selected in the table of runs; reports the reason if there is none.
fn selected(app: &mut App) -> Option<Pin> {
    let found = selected_pin(app).cloned();
    if found.is_none() {
        app.report_progress(if app.pins.is_empty() {
            "no run is pinned yet: <mark> pins the current one"
        } else {
            "select a pinned run first (<down>, <up>): the first row is the current run"
        });
    }
    found
}

pub(crate) fn unpin(app: &mut App) {
    if let Some(pin) = selected(app) {
        unpinned(app, &pin);
    }
}

fn unpinned(app: &mut App, pin: &Pin) {
    edit::unpin(app, pin);
    app.report_progress(format!("unpinned {} (<undo> undoes)", pin.label()));
}

pub(crate) fn load(app: &mut App) {
    let Some(pin) = selected(app) else { return };
    if *pin.scene == *app.scene {
        return app.report_progress("the current scene is this one already");
    }
    let label = format!("load {}", pin.label());
    let scene = (*pin.scene).clone();
    app.report_progress(format!("{label} (<undo> undoes)"));
    edit::commit_scene(app, scene, label, None);
}

pub(crate) fn copy(app: &mut App) {
    if app.shown.is_none() {
        return app.refuse("nothing to copy yet: <run> runs the scene");
    }
    let text = compared_runs(app).csv();
    app.request(Effect::Copy(text));
}
