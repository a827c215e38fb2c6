//! The dialogs for one text: a preset's name, the path of a table, the file of a measured curve.

use std::path::PathBuf;

use crossterm::event::{KeyCode, KeyEvent};
use ratatui::layout::Rect;

use crate::files::atomic::Existing;
use crate::files::export::{Destination, Meta};
use crate::model::scene::Scene;
use crate::tui::app::notice::Severity;
use crate::tui::app::{App, Origin};
use crate::tui::dialogs::popup::frame;
use crate::tui::dialogs::{Ask, Dialog, Purpose, curve};
use crate::tui::message::{Effect, FileTask};
use crate::tui::pages;
use crate::tui::theme::Role;
use crate::tui::widgets::Canvas;
use crate::tui::widgets::input::TextField;
use crate::tui::widgets::text::{put, put_lines, wrapped};

/// Ask for a text.
pub(in crate::tui) fn open(app: &mut App, purpose: Purpose, text: TextField) {
    app.dialog = Some(Dialog::Ask(Ask { purpose, text, question: false }));
}

/// Ask for the name to save the scene under.
pub(in crate::tui) fn save(app: &mut App) -> Vec<Effect> {
    let name = proposed_name(app);
    open(app, Purpose::Preset, TextField::selected(name));
    vec![app.list_presets()]
}

/// Ask for the file to write the table shown to, if there is anything in it.
pub(in crate::tui) fn export(app: &mut App) {
    match pages::of(app.tab).table(app) {
        Some(table) => open(app, Purpose::Table(table.title), TextField::new(table.file)),
        None => app.say(Severity::Error, "nothing to export yet: press r to compute it"),
    }
}

/// Copy the table shown to the clipboard.
pub(in crate::tui) fn copy(app: &mut App) -> Vec<Effect> {
    let Some(table) = pages::of(app.tab).table(app) else {
        return app.refuse("nothing to copy yet: press r to compute it".to_owned());
    };
    match table.content.table(Meta::Beside) {
        Ok(text) => vec![Effect::Copy(text)],
        Err(why) => app.refuse(why.to_string()),
    }
}

/// The present name for one's own preset, else that name with the first number that is free.
fn proposed_name(app: &App) -> String {
    if app.base.origin == Origin::Mine {
        return app.base.name.clone();
    }
    let taken =
        |name: &str| app.presets.iter().any(|entry| entry.part.is_none() && entry.name == name);
    let stem = base_stem(app);
    (2..100)
        .map(|number| format!("{stem}-{number}"))
        .find(|name| !taken(name))
        .unwrap_or_else(|| "my-scene".to_owned())
}

/// A key while the dialog is open.
pub(in crate::tui) fn press(app: &mut App, mut state: Ask, key: KeyEvent) -> Vec<Effect> {
    let is_path = state.purpose != Purpose::Preset;
    let mut effects = Vec::new();
    match key.code {
        KeyCode::Esc if !(is_path && state.question) => return effects,
        KeyCode::Esc | KeyCode::Char('n') if state.question => state.question = false,
        KeyCode::Char('y' | 'o') if state.question => effects = accept(app, &mut state, true),
        KeyCode::Char('r') if state.question && is_path => {
            state.text = TextField::new(next_name(state.text.value()));
            state.question = false;
        }
        KeyCode::Enter if state.question => {}
        KeyCode::Enter => effects = accept(app, &mut state, false),
        KeyCode::Tab if is_path => {
            effects = vec![Effect::Files(FileTask::Complete(state.text.value().to_owned()))];
        }
        _ => {
            if state.text.press(key) {
                state.question = false;
            }
        }
    }
    app.dialog = Some(Dialog::Ask(state));
    effects
}

/// Do what the text is asked for; `overwrite`: a file or preset of this name may be replaced.
fn accept(app: &App, state: &mut Ask, overwrite: bool) -> Vec<Effect> {
    state.text.all_selected = false;
    let accepted = match state.purpose {
        Purpose::Preset => save_as(app, state, overwrite),
        Purpose::Table(_) => typed_path(app, state, "table.csv").and_then(|path| {
            let table = pages::of(app.tab).table(app);
            let table = table.ok_or_else(|| "there is nothing to write any more".to_owned())?;
            let existing = Existing::replaced(overwrite);
            let to = Destination { path, existing, meta: Meta::Beside };
            Ok(vec![Effect::Files(FileTask::Export(to, table.content))])
        }),
        Purpose::Curve(second) => typed_path(app, state, "curve.csv")
            .map(|path| vec![Effect::Files(FileTask::ReadCurve(second, path))]),
    };
    accepted.unwrap_or_else(|error| {
        state.text.error = Some(error);
        Vec::new()
    })
}

fn typed_path(app: &App, state: &mut Ask, example: &str) -> Result<PathBuf, String> {
    let path = path_of(app, &state.text, example)?;
    state.question = false;
    Ok(path)
}

/// The path that was typed.
///
/// # Errors
/// In words, where it names no file.
pub(in crate::tui) fn path_of(
    app: &App,
    field: &TextField,
    example: &str,
) -> Result<PathBuf, String> {
    let text = field.value().trim();
    if text.is_empty() || text.ends_with('/') {
        return Err(format!("the path needs a file name, for example `{example}`"));
    }
    Ok(app.directory.join(text))
}

/// Save the scene under the name; one of the person's own presets is replaced only when asked.
fn save_as(app: &App, state: &mut Ask, overwrite: bool) -> Result<Vec<Effect>, String> {
    let name = state.text.value().trim().to_owned();
    if name.is_empty() {
        return Err("a preset needs a name: letters, digits, - and _".to_owned());
    }
    let same = app.presets.iter().filter(|entry| entry.part.is_none() && entry.name == name);
    let origins: Vec<&str> = same.map(|entry| entry.origin).collect();
    if origins.contains(&"bundled") {
        return Err(format!(
            "`{name}` is a built-in preset and stays as it is: choose another name"
        ));
    }
    if origins.contains(&"mine") && !overwrite {
        state.question = true;
        return Ok(Vec::new());
    }
    let scene = Box::new((*app.scene).clone());
    Ok(vec![Effect::Files(FileTask::SavePreset { name, scene, overwrite })])
}

/// The next name of a series: `run.csv`, `run-2.csv`, `run-3.csv`.
pub(in crate::tui) fn next_name(text: &str) -> String {
    let (stem, ending) = match text.rsplit_once('.') {
        Some((stem, ending)) if !ending.contains('/') => (stem, format!(".{ending}")),
        _ => (text, String::new()),
    };
    match stem.rsplit_once('-') {
        Some((front, number)) => match number.parse::<u32>() {
            Ok(number) => format!("{front}-{}{ending}", number.saturating_add(1)),
            Err(_) => format!("{stem}-2{ending}"),
        },
        None => format!("{stem}-2{ending}"),
    }
}

/// The first part of the name proposed for a file about a scene: the preset's, where the scene is still that.
pub(in crate::tui) fn stem<'a>(app: &'a App, scene: &Scene) -> &'a str {
    if *scene == *app.base.scene { base_stem(app) } else { "scene" }
}

/// The preset's name without folders and ending.
pub(in crate::tui) fn base_stem(app: &App) -> &str {
    app.base.name.rsplit('/').next().unwrap_or("scene").trim_end_matches(".toml")
}

/// Draw it.
pub(in crate::tui) fn render(app: &App, state: &Ask, screen: Rect, canvas: &mut Canvas<'_>) {
    let (width, titles, label) = match state.purpose {
        Purpose::Preset => (64, ("Save the scene as a preset", ""), "name  "),
        Purpose::Table(title) => (76, (title, "Enter writes"), "file  "),
        Purpose::Curve(_) => (76, curve::TITLES, "file  "),
    };
    let inner = frame(app, screen, (width, 9), titles, canvas);
    let start = put(canvas, inner, (0, 1), label, app.theme.style(Role::Title));
    let field = TextField { error: None, ..state.text.clone() };
    let width = inner.width.saturating_sub(start + 1);
    field.draw(canvas, Rect { x: inner.x + start, y: inner.y + 1, width, height: 1 }, app.theme);
    let (text, role) = match (&state.text.error, state.question) {
        (_, true) => (question(app, state), Role::Warning),
        (Some(error), false) => (format!("x {error}"), Role::Error),
        (None, false) => (hint(app, state), Role::Dim),
    };
    put_lines(canvas, inner, 3, app.theme, wrapped(&text, inner.width, role));
}

fn question(app: &App, state: &Ask) -> String {
    let text = state.text.value().trim();
    match state.purpose {
        Purpose::Preset => {
            format!("you have a preset `{text}` already: overwrite it? y / n (its comments stay)")
        }
        Purpose::Table(_) | Purpose::Curve(_) => {
            let path = app.directory.join(text);
            format!("{} exists: [o]verwrite, [r]ename, Esc back", path.display())
        }
    }
}

fn hint(app: &App, state: &Ask) -> String {
    match state.purpose {
        Purpose::Preset => "kept with your own presets; `cmra NAME` opens it".to_owned(),
        Purpose::Table(_) => {
            format!("to {}", app.directory.join(state.text.value().trim()).display())
        }
        Purpose::Curve(second) => curve::hint(app, second),
    }
}
