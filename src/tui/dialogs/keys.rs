//! Keys in the dialogs: help, palette, presets, list of edits, saving. (Exporting has its own file.)

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use tui_input::Input;

use crate::model::library::Entry;
use crate::model::variables::{self, Value};
use crate::tui::app::notice::Severity;
use crate::tui::app::status::clip;
use crate::tui::app::{App, Base, Origin};
use crate::tui::dialogs;
use crate::tui::dialogs::{Dialog, Picker, Save, curve, export, options, palette, path, table};
use crate::tui::message::{Effect, PresetEntry, Target};
use crate::tui::pages::run::runs;
use crate::tui::pages::thesis;
use crate::tui::update::edit;
use crate::tui::widgets::input;

/// A key while a dialog is open.
pub(in crate::tui) fn press(app: &mut App, key: KeyEvent) -> Vec<Effect> {
    match app.dialog.take() {
        Some(Dialog::Save(state)) => save_key(app, state, key),
        Some(Dialog::Export(state)) => export::press(app, *state, key),
        Some(Dialog::Options(picker)) => options::keys::press(app, picker, key),
        Some(Dialog::ExportTable(which, state)) => table::press(app, which, state, key),
        Some(Dialog::Curve(second, state)) => curve::press(app, second, state, key),
        Some(Dialog::Help(picker)) => in_list(app, picker, key, Kind::Help),
        Some(Dialog::Palette(picker)) => in_list(app, picker, key, Kind::Palette),
        Some(Dialog::Presets(picker)) => in_list(app, picker, key, Kind::Presets),
        Some(Dialog::History(picker)) => in_list(app, picker, key, Kind::History),
        Some(Dialog::Words(picker)) => in_list(app, picker, key, Kind::Words),
        None => Vec::new(),
    }
}

/// A click while a dialog is open: it selects a row, does what the row is for where it was selected, or closes a list.
pub(in crate::tui) fn click(app: &mut App, target: Target) -> Vec<Effect> {
    let key = |code| KeyEvent::new(code, KeyModifiers::NONE);
    let selected = match &mut app.dialog {
        Some(
            Dialog::Help(picker)
            | Dialog::Palette(picker)
            | Dialog::Presets(picker)
            | Dialog::History(picker)
            | Dialog::Options(picker)
            | Dialog::Words(picker),
        ) => &mut picker.selected,
        Some(Dialog::Export(_)) => {
            if let Target::DialogRow(row) = target {
                return export::click(app, row);
            }
            return Vec::new();
        }
        // What has been typed is not thrown away by a click.
        Some(_) | None => return Vec::new(),
    };
    match target {
        Target::DialogRow(row) if *selected == row => press(app, key(KeyCode::Enter)),
        Target::DialogRow(row) => {
            *selected = row;
            Vec::new()
        }
        Target::Beside => {
            app.dialog = None;
            Vec::new()
        }
        _ => Vec::new(),
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Help,
    Palette,
    Presets,
    History,
    Words,
}

impl Kind {
    fn dialog(self, picker: Picker) -> Dialog {
        match self {
            Self::Help => Dialog::Help(picker),
            Self::Palette => Dialog::Palette(picker),
            Self::Presets => Dialog::Presets(picker),
            Self::History => Dialog::History(picker),
            Self::Words => Dialog::Words(picker),
        }
    }

    fn count(self, app: &App, typed: &str) -> usize {
        match self {
            Self::Help => dialogs::help_rows(app, typed).len(),
            Self::Palette => app.palette(typed).len(),
            Self::Presets => dialogs::preset_rows(&app.presets, typed).len(),
            Self::History => app.history.edits.len() + 1,
            Self::Words => app.editor.variable().words().len(),
        }
    }
}

/// Keys all lists share; Enter and Space mean what the list is for.
fn in_list(app: &mut App, mut picker: Picker, key: KeyEvent, kind: Kind) -> Vec<Effect> {
    let last = kind.count(app, picker.filter.value()).saturating_sub(1);
    let control = key.modifiers.contains(KeyModifiers::CONTROL);
    let letter = !picker.typing && !control;
    if let Some(by) = moves(key, letter) {
        picker.selected = picker.selected.saturating_add_signed(by).min(last);
        app.dialog = Some(kind.dialog(picker));
        return Vec::new();
    }
    match key.code {
        KeyCode::Esc if picker.typing && kind != Kind::Palette => {
            picker.typing = false;
            picker.filter = Input::default();
            picker.selected = 0;
        }
        KeyCode::Esc => return Vec::new(),
        KeyCode::Enter => return chosen(app, &picker, kind),
        KeyCode::Char('q') if letter => return Vec::new(),
        KeyCode::Char('?') if letter && kind == Kind::Help => return Vec::new(),
        KeyCode::Char('/') if letter && !matches!(kind, Kind::History | Kind::Words) => {
            picker.typing = true;
        }
        KeyCode::Char(' ') if letter && kind == Kind::Presets => {
            let effects = pin_preset(app, &picker);
            app.dialog = Some(Dialog::Presets(picker));
            return effects;
        }
        _ if picker.typing && input::press(&mut picker.filter, &mut false, key) => {
            picker.selected = 0;
        }
        _ => {}
    }
    app.dialog = Some(kind.dialog(picker));
    Vec::new()
}

/// How far a key moves the selection: arrows always, letters while none go into the filter.
fn moves(key: KeyEvent, letter: bool) -> Option<isize> {
    let control = key.modifiers.contains(KeyModifiers::CONTROL);
    match key.code {
        KeyCode::Up => Some(-1),
        KeyCode::Down => Some(1),
        KeyCode::PageUp => Some(-10),
        KeyCode::PageDown => Some(10),
        KeyCode::Char('p' | 'k') if control => Some(-1),
        KeyCode::Char('n' | 'j') if control => Some(1),
        KeyCode::Char('k') if letter => Some(-1),
        KeyCode::Char('j') if letter => Some(1),
        KeyCode::Home | KeyCode::Char('g') if letter => Some(isize::MIN / 2),
        KeyCode::End | KeyCode::Char('G') if letter => Some(isize::MAX / 2),
        _ => None,
    }
}

/// After text came into a dialog: what is selected may not be there any more.
pub(in crate::tui) fn after_typing(app: &mut App) {
    match &mut app.dialog {
        Some(Dialog::Help(picker) | Dialog::Palette(picker) | Dialog::Presets(picker)) => {
            picker.selected = 0;
        }
        Some(Dialog::Save(save) | Dialog::ExportTable(_, save) | Dialog::Curve(_, save)) => {
            save.question = false;
            save.error = None;
        }
        Some(Dialog::Export(export)) => {
            export.question = false;
            export.error = None;
            export.completions.clear();
        }
        Some(Dialog::History(_) | Dialog::Words(_) | Dialog::Options(_)) | None => {}
    }
}

fn chosen(app: &mut App, picker: &Picker, kind: Kind) -> Vec<Effect> {
    let typed = picker.filter.value();
    match kind {
        Kind::Help => {
            let rows = dialogs::help_rows(app, typed);
            let action = rows.get(picker.selected).map(|row| row.action);
            action.map_or_else(Vec::new, |action| palette::keys::press(app, action))
        }
        Kind::Palette => palette::keys::chosen(app, picker),
        Kind::Presets => match selected_preset(app, picker) {
            Some(entry) => {
                let refused = entry.problem.is_some();
                let effects = take_preset(app, entry);
                if refused || (effects.is_empty() && app.dialog.is_none() && app.is_refused()) {
                    app.dialog = Some(Dialog::Presets(picker.clone()));
                }
                effects
            }
            None if looks_like_path(typed) => vec![Effect::Load(typed.trim().into())],
            None => {
                let typed = clip(typed.trim(), 24);
                let text =
                    format!("no preset matches; a file is opened by its path: ./{typed}.toml");
                app.say(Severity::Note, text);
                app.dialog = Some(Dialog::Presets(picker.clone()));
                Vec::new()
            }
        },
        Kind::History => edit::travel(app, picker.selected),
        Kind::Words => take_word(app, picker),
    }
}

/// Set the selected variable to a word; one that is refused leaves the list open, with the reason.
fn take_word(app: &mut App, picker: &Picker) -> Vec<Effect> {
    let Some(word) = app.editor.variable().words().get(picker.selected) else {
        return Vec::new();
    };
    match edit::set(app, app.editor.selected, Value::Word(word), None) {
        Ok(effects) => {
            curve::ask(app, word);
            effects
        }
        Err(error) => {
            app.say(Severity::Error, error);
            app.dialog = Some(Dialog::Words(picker.clone()));
            Vec::new()
        }
    }
}

/// Load a preset and show what it is about; put a part of a library into the scene.
pub(in crate::tui) fn take_preset(app: &mut App, entry: PresetEntry) -> Vec<Effect> {
    if let Some(problem) = entry.problem {
        app.say(Severity::Error, format!("{} cannot be loaded: {problem}", entry.name));
        return Vec::new();
    }
    match &entry.part {
        Some(part) => take_part(app, part),
        None => thesis::keys::show(app, base_of(entry)),
    }
}

fn looks_like_path(text: &str) -> bool {
    let text = text.trim();
    text.contains('/') || std::path::Path::new(text).extension().is_some_and(|end| end == "toml")
}

fn selected_preset(app: &App, picker: &Picker) -> Option<PresetEntry> {
    let rows = dialogs::preset_rows(&app.presets, picker.filter.value());
    rows.get(picker.selected).map(|entry| (*entry).clone())
}

fn base_of(entry: PresetEntry) -> Base {
    let origin = match entry.origin {
        "bundled" => Origin::Bundled,
        "mine" => Origin::Mine,
        _ => Origin::Other,
    };
    Base { name: entry.name, origin, scene: entry.scene.into() }
}

fn pin_preset(app: &mut App, picker: &Picker) -> Vec<Effect> {
    let Some(entry) = selected_preset(app, picker) else { return Vec::new() };
    if let Some(problem) = entry.problem {
        app.say(Severity::Error, format!("{} cannot be pinned: {problem}", entry.name));
        return Vec::new();
    }
    match entry.scene_on(&app.scene) {
        Ok(scene) => runs::keys::pin(app, entry.name, scene.into()),
        Err(error) => {
            app.say(Severity::Error, error.to_string());
            Vec::new()
        }
    }
}

/// Takes an entry of a library into the scene, as one edit; one that makes no sense is refused.
fn take_part(app: &mut App, part: &Entry) -> Vec<Effect> {
    let mut scene = (*app.scene).clone();
    let made = part.apply(&mut scene).and_then(|()| variables::validate(&scene));
    if let Err(error) = made {
        app.say(Severity::Error, error.to_string());
        return Vec::new();
    }
    let label = format!("{} {}", part.library.word(), part.name);
    let effects = edit::commit_scene(app, scene, label.clone(), None);
    if part.warning.is_empty() {
        app.say(Severity::Note, format!("{label} (u undoes)"));
    } else {
        app.say(Severity::Warning, format!("{}: {}", part.name, part.warning));
    }
    effects
}

/// Save the scene as a preset: ask for the name, and before an existing one is replaced.
pub(in crate::tui) fn save(app: &mut App) -> Vec<Effect> {
    app.dialog = Some(Dialog::Save(Save {
        input: Input::new(proposed_name(app)),
        all_selected: true,
        question: false,
        error: None,
    }));
    vec![Effect::ListPresets]
}

/// The present name for one's own preset, else that name with the first number that is free.
fn proposed_name(app: &App) -> String {
    if app.base.origin == Origin::Mine {
        return app.base.name.clone();
    }
    let taken =
        |name: &str| app.presets.iter().any(|entry| entry.part.is_none() && entry.name == name);
    let stem = path::base_stem(app);
    (2..100)
        .map(|number| format!("{stem}-{number}"))
        .find(|name| !taken(name))
        .unwrap_or_else(|| "my-scene".to_owned())
}

fn save_key(app: &mut App, mut state: Save, key: KeyEvent) -> Vec<Effect> {
    let mut effects = Vec::new();
    match key.code {
        KeyCode::Esc => return Vec::new(),
        KeyCode::Char('y') if state.question => effects = save_as(app, &state, true),
        KeyCode::Char('n') if state.question => state.question = false,
        KeyCode::Enter if state.question => {}
        KeyCode::Enter => {
            state.all_selected = false;
            match name_problem(app, state.input.value().trim()) {
                Some(NameProblem::Exists) => state.question = true,
                Some(NameProblem::Refused(text)) => state.error = Some(text),
                None => effects = save_as(app, &state, false),
            }
        }
        _ => {
            if input::press(&mut state.input, &mut state.all_selected, key) {
                state.question = false;
                state.error = None;
            }
        }
    }
    app.dialog = Some(Dialog::Save(state));
    effects
}

enum NameProblem {
    Exists,
    Refused(String),
}

fn name_problem(app: &App, name: &str) -> Option<NameProblem> {
    if name.is_empty() {
        return Some(NameProblem::Refused(
            "a preset needs a name: letters, digits, - and _".to_owned(),
        ));
    }
    let same = app.presets.iter().filter(|entry| entry.part.is_none() && entry.name == name);
    let origins: Vec<&str> = same.map(|entry| entry.origin).collect();
    if origins.contains(&"bundled") {
        return Some(NameProblem::Refused(format!(
            "`{name}` is a built-in preset and stays as it is: choose another name"
        )));
    }
    origins.contains(&"mine").then_some(NameProblem::Exists)
}

fn save_as(app: &App, state: &Save, overwrite: bool) -> Vec<Effect> {
    vec![Effect::SavePreset {
        name: state.input.value().trim().to_owned(),
        scene: Box::new((*app.scene).clone()),
        overwrite,
    }]
}
