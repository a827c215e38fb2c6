//! Preset picker: names at the left; description and changes at the right.

use crate::tui::pages::run::runs::name_of;
use std::path::Path;

use crate::files::session::Session;
use crate::tui::app::dialog::Outcome;
use crate::tui::app::edit;
use crate::tui::dialogs::list::{List, Picker, frame};
use crate::tui::message::FileTask;
use crate::tui::pages::run;
use crate::tui::pages::run::editor::{index_of, shown_value};
use crate::tui::pages::thesis;
use crate::tui::prelude::*;
use crate::tui::preset::PresetEntry;
use crate::tui::widgets::find::{rank, ranked};
use crate::tui::widgets::text::{TextLine, clip, wrapped};
use crate::tui::widgets::{split_left, split_top};
use cmra_engine::model::scene::{PlateSize, Scene, Target};
use cmra_engine::model::variables::VARIABLES;

#[derive(Debug)]
pub(super) struct Presets;

const NAMES: u16 = 32;

impl List for Presets {
    const OPENED_BY: Action = Action::Presets;
    const IS_FILTERED: bool = true;
    const FOOTER: &'static str = "type a name or a path  <enter> load  Up/Down move  <back> close";

    fn count(&self, app: &App, typed: &str) -> usize {
        rows(&app.files.presets, typed).len()
    }

    /// Loads the selected preset, or the file of a path. A rejected one leaves the list open.
    fn chosen(&mut self, app: &mut App, picker: &Picker) -> Outcome {
        let typed = picker.filter.value().trim();
        let is_path =
            typed.contains('/') || Path::new(typed).extension().is_some_and(|it| it == "toml");
        if typed.is_empty() && !picker.moved {
            app.report_progress(
                "type a name, or move to one: nothing is loaded that was not chosen",
            );
            return Outcome::Stays;
        }
        let rows = rows(&app.files.presets, picker.filter.value());
        if let Some(entry) = rows.get(picker.selected).map(|entry| (*entry).clone()) {
            let Err(why) = take(app, entry) else { return Outcome::Closes };
            app.refuse(why);
        } else if is_path {
            app.request(Effect::Files(FileTask::Load(typed.into())));
            return Outcome::Closes;
        } else {
            let path = format!("./{}.toml", clip(typed, 24));
            app.report_progress(figure(typed).map_or_else(
                || format!("no preset matches; a file is opened by its path: {path}"),
                |number| {
                    format!("figure {number} has no data to compute: a drawing or a photograph")
                },
            ));
        }
        Outcome::Stays
    }

    fn draw(&self, app: &App, picker: &Picker, screen: Rect, canvas: &mut Canvas<'_>) {
        let pane = PaneFrame::new("Presets, threats, materials, absorbers");
        let inner = frame(screen, (110, 40), pane, canvas);
        picker.draw_filter(inner, canvas);
        let (_, body) = split_top(inner, 2);
        let rows = rows(&app.files.presets, picker.filter.value());
        let (left, right) = split_left(body, NAMES);
        let (_, right) = split_left(right, 2);
        if rows.is_empty() {
            canvas.put(body, (0, 0), &no_match(picker.filter.value()), Role::Dim);
        }
        picker.draw_rows(rows.len(), left, canvas, |canvas, row, index| {
            let entry = rows[index];
            let room = usize::from(row.width.saturating_sub(11));
            let (mark, role) = match entry.problem {
                Some(_) => ("!", Role::Warning),
                None => (" ", Role::Text),
            };
            canvas.put(row, (0, 0), mark, role);
            canvas.put(row, (1, 0), &clip(&entry.name, room), role);
            let at = row.width.saturating_sub(8);
            canvas.put(row, (at, 0), entry.origin, Role::Dim);
        });
        if let Some(entry) = rows.get(picker.selected) {
            about(app, entry, right, canvas);
        }
    }
}

/// Returns the matching presets, best first; all presets in order for an empty text. For a figure number in no name, returns the presets
/// whose comment contains it.
fn rows<'a>(presets: &'a [PresetEntry], typed: &str) -> Vec<&'a PresetEntry> {
    let found = ranked(presets.iter(), |it| rank(typed, &[&it.name, it.origin], &it.scene.title));
    match figure(typed).filter(|_| found.is_empty()) {
        Some(number) => presets.iter().filter(|entry| mentions(&entry.comment, number)).collect(),
        None => found,
    }
}

/// Returns the number of a figure from `9.14` or `figure 9.14`.
fn figure(typed: &str) -> Option<&str> {
    let number = typed.trim().rsplit([' ', '-']).next()?;
    let (chapter, figure) = number.split_once('.')?;
    let is_number = |text: &str| !text.is_empty() && text.bytes().all(|it| it.is_ascii_digit());
    (is_number(chapter) && is_number(figure)).then_some(number)
}

/// Returns `true` if a comment refers to the figure of this number.
fn mentions(comment: &str, number: &str) -> bool {
    let words = comment.split(|letter: char| !(letter.is_ascii_digit() || letter == '.'));
    comment.contains("Figure") && words.map(|word| word.trim_matches('.')).any(|it| it == number)
}

/// Returns the message for a search without matches.
fn no_match(typed: &str) -> String {
    match figure(typed) {
        Some(number) => format!("figure {number} has no data to compute"),
        None => "none; Enter opens a file by its path".to_owned(),
    }
}

/// Draws the title and the changes, then as much of comment and notes as fits.
fn about(app: &App, entry: &PresetEntry, area: Rect, canvas: &mut Canvas<'_>) {
    let width = area.width;
    let mut lines: Vec<TextLine> = Vec::new();
    if let Some(problem) = &entry.problem {
        lines.push((format!("{} cannot be loaded:", entry.name), Role::Warning));
        lines.extend(wrapped(problem, width, Role::Text));
        lines.push(("correct its file, or delete it".to_owned(), Role::Dim));
        return canvas.put_lines(area, 0, lines);
    }
    let title = if entry.scene.title.is_empty() { &entry.name } else { &entry.scene.title };
    lines.extend(wrapped(title, width, Role::Title));
    if let Some(session) = &entry.session {
        lines.push(("a session that was left unsaved: it opens whole".to_owned(), Role::Dim));
        let (_, Session { pins, .. }) = &**session;
        let names = pins.iter().map(|(letter, scene)| format!("{letter}: {}", name_of(app, scene)));
        lines.extend(names.map(|name| (clip(&name, usize::from(width)), Role::Text)));
    } else if entry.part.is_none() {
        let tab = if thesis::axes(&entry.scene) > 0 { Tab::Explore } else { Tab::Run };
        let text = format!("shows on {}", tab.title(&app.keymap));
        lines.push((text, Role::Dim));
    }
    lines.push((String::new(), Role::Text));
    lines.extend(changes(app, entry, width));
    for text in [&entry.comment, &entry.scene.notes] {
        if !text.is_empty() {
            lines.push((String::new(), Role::Text));
        }
        // Line breaks of a file are not kept on the screen.
        let paragraphs = text.split("\n\n").map(|it| it.replace('\n', " "));
        for (at, paragraph) in paragraphs.enumerate() {
            lines.extend((at > 0).then(|| (String::new(), Role::Dim)));
            lines.extend(wrapped(&paragraph, width, Role::Dim));
        }
    }
    canvas.put_lines(area, 0, lines);
}

/// Lists the variables that the preset would change, old and new values; a long list in several columns.
fn changes(app: &App, entry: &PresetEntry, width: u16) -> Vec<TextLine> {
    let scene = match entry.scene_on(&app.scene) {
        Ok(scene) => scene,
        Err(error) => return wrapped(&error.to_string(), width, Role::Text).collect(),
    };
    let differing = App::differing(&app.scene, &scene);
    if differing.is_empty() {
        let same = if entry.scene.sweep == app.scene.sweep {
            "no change: the same scene"
        } else {
            "the same variables; its own sweep"
        };
        return vec![(same.to_owned(), Role::Text)];
    }
    let mut lines = vec![("would change:".to_owned(), Role::Text)];
    for index in differing {
        let variable = &VARIABLES[index];
        let brief = |scene| shown_value(variable, scene);
        let (old, new) = (brief(&app.scene), brief(&scene));
        let text = format!("  {:<9} {old} -> {new}", variable.symbol);
        lines.push((clip(&text, usize::from(width)), Role::Text));
    }
    lines
}

/// Loads a preset and shows its subject, or applies a library entry to the scene; returns the reason if neither is possible.
pub(crate) fn take(app: &mut App, entry: PresetEntry) -> Result<(), String> {
    if let Some(problem) = entry.problem {
        return Err(format!("{} cannot be loaded: {problem}", entry.name));
    }
    if let Some(session) = entry.session {
        app.open_session(*session);
        return Ok(());
    }
    let Some(part) = &entry.part else {
        thesis::show(app, entry.base());
        return Ok(());
    };
    let scene = entry.scene_on(&app.scene).map_err(|error| error.to_string())?;
    let label = format!("{} {}", part.library.key(), part.name);
    edit::commit_scene(app, scene, label.clone(), None);
    if part.warning.is_empty() {
        app.report_progress(format!("{label} (<undo> undoes)"));
    } else {
        app.say(Severity::Warning, format!("{}: {}", part.name, part.warning));
    }
    ask_for_face(app);
    Ok(())
}

/// Opens the field of the plate's side after both the shot and the plate were chosen. The mass ratio of another shot would give the plate
/// an unintended size.
fn ask_for_face(app: &mut App) {
    let usual = Scene::default();
    let (scene, base) = (&app.scene, &app.base.scene);
    // A library projectile changes the law of its nose but keeps the plate.
    let plate = |of: &Scene| {
        let Target { closure, drag, drag_coefficient, dishing, .. } = usual.target;
        Target { closure, drag, drag_coefficient, dishing, ..of.target }
    };
    let is_chosen = |it: &Scene| scene.projectile != it.projectile && plate(scene) != plate(it);
    let by_ratio = matches!(scene.plate.size, PlateSize::Ratio(_)) && scene.is_sprung();
    if by_ratio && is_chosen(&usual) && is_chosen(base) {
        run::focus_on(app, index_of("face"));
        run::open(app);
        app.report_progress(
            "how large is the plate? type the side of its face (150mm), or <back> keeps gamma",
        );
    }
}
