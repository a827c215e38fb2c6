//! The dialogs that ask for a text: a preset's name, the path of a table or of runs, the file of a measured curve.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crossterm::event::{KeyCode, KeyEvent};

use crate::files::atomic::Existing;
use crate::files::export::Destination;
use crate::files::preset;
use crate::files::report::is_report;
use crate::model::scene::SpringKind;
use crate::model::{units, variables};
use crate::report::svg;
use crate::tui::dialogs::export::{self as runs, Choices};
use crate::tui::dialogs::{Ask, Dialog, Purpose, answered, frame};
use crate::tui::message::{Content, FileTask};
use crate::tui::pages;
use crate::tui::pages::run::report;
use crate::tui::prelude::*;
use crate::tui::update::edit;
use crate::tui::view;
use crate::tui::widgets::input::TextField;
use crate::tui::widgets::text::wrapped;

pub(crate) fn open(app: &mut App, purpose: Purpose, text: TextField, choices: Choices) {
    let (question, completions) = (false, Vec::new());
    app.dialog = Some(Dialog::Ask(Box::new(Ask { purpose, text, question, completions, choices })));
}

impl Ask {
    /// The field that takes characters, where the selected line has one.
    pub(crate) fn field_mut(&mut self) -> Option<&mut TextField> {
        if self.choices.selected == 0 { Some(&mut self.text) } else { self.choices.field_mut() }
    }

    fn exports(&self) -> bool {
        matches!(self.purpose, Purpose::Runs | Purpose::Table(_))
    }

    fn is_of(&self, directory: &Path, path: &Path) -> bool {
        directory.join(self.text.value().trim()) == path
    }

    /// Whether it asks for an export to this path.
    pub(crate) fn exports_to(&self, directory: &Path, path: &Path) -> bool {
        self.exports() && self.is_of(directory, path)
    }

    /// Whether it asks to save the scene under this name.
    pub(crate) fn saves(&self, name: &str) -> bool {
        self.purpose == Purpose::Preset && self.text.value().trim() == name
    }

    /// Another text or choice: what was said about the old one is removed.
    pub(super) fn forget(&mut self) {
        self.question = false;
        self.text.error = None;
        self.completions.clear();
    }

    /// Change what the selected line chooses.
    fn change(&mut self, by: isize) {
        self.choices.change(by);
        self.text.error = None;
    }
}

/// Ask for the name to save the scene under.
pub(crate) fn save(app: &mut App) {
    let name = proposed_name(app);
    open(app, Purpose::Preset, TextField::selected(name), Choices::default());
    app.list_presets();
}

/// Ask for the file to write the table shown to, if there is anything in it.
pub(crate) fn export_table(app: &mut App) {
    match pages::of(app.tab).table(app) {
        Some(table) => {
            let file = TextField::new(table.file);
            open(app, Purpose::Table(table.title), file, Choices::default());
        }
        None => app.refuse(nothing_yet(app, "export")),
    }
}

/// Why a page has no table.
fn nothing_yet(app: &App, what: &str) -> String {
    if pages::all_jobs(app).any(|(tab, _)| tab == app.tab) {
        return "nothing is finished yet: <back> stops the job and keeps what is finished"
            .to_owned();
    }
    format!("nothing to {what} yet: press <run> to compute it")
}

pub(crate) fn copy(app: &mut App) {
    let Some(table) = pages::of(app.tab).table(app) else {
        return app.refuse(nothing_yet(app, "copy"));
    };
    match Content::Page(table).text() {
        Ok(text) => app.request(Effect::Copy(text)),
        Err(why) => app.refuse(why.to_string()),
    }
}

/// The present name for one's own preset or file, else that name with the first number that is free.
fn proposed_name(app: &App) -> String {
    let name = &app.base.name;
    // Scenes that the program kept by itself are files, too, but nobody opened them by their path.
    let is_file =
        preset::is_path(name) && app.files.recent.contains(&app.files.directory.join(name));
    if app.base.is_mine || is_file {
        return name.clone();
    }
    let taken = |name: &str| {
        app.files.presets.iter().any(|entry| entry.part.is_none() && entry.name == name)
    };
    let stem = base_stem(app);
    (2..100)
        .map(|number| format!("{stem}-{number}"))
        .find(|name| !taken(name))
        .unwrap_or_else(|| "my-scene".to_owned())
}

pub(crate) fn press(app: &mut App, mut state: Ask, key: KeyEvent) {
    let is_path = state.purpose != Purpose::Preset || preset::is_path(state.text.value());
    let typing = state.field_mut().is_some();
    match key.code {
        KeyCode::Esc if !state.question => return,
        KeyCode::Esc | KeyCode::Char('n') if state.question => state.question = false,
        KeyCode::Char('q') if !typing => return,
        KeyCode::Char('y' | 'o') if state.question => accept(app, &mut state, true),
        KeyCode::Char('r') if state.question => {
            state.text = TextField::new(next_name(state.text.value()));
            (state.choices.selected, state.question) = (0, false);
        }
        KeyCode::Enter if state.question => {}
        KeyCode::Enter => accept(app, &mut state, false),
        KeyCode::Tab if is_path && state.choices.selected == 0 => {
            app.request(Effect::Files(FileTask::Complete(state.text.value().to_owned())));
        }
        KeyCode::Down | KeyCode::Tab => state.choices.move_by(1),
        KeyCode::Up | KeyCode::BackTab => state.choices.move_by(-1),
        KeyCode::Char('j') if !typing => state.choices.move_by(1),
        KeyCode::Char('k') if !typing => state.choices.move_by(-1),
        KeyCode::Left | KeyCode::Char('h') if !typing => state.change(-1),
        KeyCode::Right | KeyCode::Char('l' | ' ') if !typing => state.change(1),
        KeyCode::Char('a') if !typing => state.choices.all_or_none(),
        _ => {
            if state.field_mut().is_some_and(|field| field.press(key)) {
                state.forget();
            }
        }
    }
    app.dialog = Some(Dialog::Ask(Box::new(state)));
}

/// Does what the text was typed for; `overwrite`: a file or preset of this name may be replaced.
fn accept(app: &mut App, state: &mut Ask, overwrite: bool) {
    state.text.all_selected = false;
    let asked = match report_file(app, state, overwrite) {
        // It is asked before the report is computed, and not only when it is written.
        Some(to) if !overwrite && to.path.exists() => {
            state.question = true;
            Ok(None)
        }
        Some(to) => report::write(app, to).map(|()| None),
        None => task(app, state, overwrite),
    };
    match asked {
        Ok(task) => app.effects.extend(task.map(Effect::Files)),
        Err(error) => state.text.error = Some(error),
    }
}

/// The report to write, where an export goes to a path that ends as one.
fn report_file(app: &App, state: &Ask, overwrite: bool) -> Option<Destination> {
    let path = path_of(app, state.text.value(), "").ok().filter(|_| state.exports())?;
    let existing = Existing::replaced(overwrite);
    is_report(&path).then_some(Destination { path, existing, has_scene: false })
}

/// The file tasks; none if a question comes first.
fn task(app: &App, state: &mut Ask, overwrite: bool) -> Result<Option<FileTask>, String> {
    let task = match state.purpose {
        Purpose::Preset => return save_as(app, state, overwrite),
        Purpose::Table(_) => {
            let path = path_of(app, state.text.value(), "table.csv")?;
            let table = || pages::of(app.tab).table(app).map(Content::Page);
            let gone = || "the result to write no longer exists".to_owned();
            export(app, path, overwrite, || table().ok_or_else(gone))?
        }
        Purpose::Runs => {
            let path = path_of(app, state.text.value(), "run.csv")?;
            let table = || runs::table(app, &state.choices).map(Content::Runs);
            export(app, path, overwrite, table)?
        }
        Purpose::Curve => FileTask::ReadCurve(path_of(app, state.text.value(), "curve.csv")?),
    };
    (state.question, state.text.error) = (false, None);
    Ok(Some(task))
}

/// Write the charts on the screen to a path that ends in `.svg`, the table to any other.
fn export(
    app: &App,
    path: PathBuf,
    overwrite: bool,
    table: impl FnOnce() -> Result<Content, String>,
) -> Result<FileTask, String> {
    let content = if is_svg(&path) {
        let drawn = view::pictures(app);
        if drawn.is_empty() {
            return Err(
                "no chart on the screen can be drawn as SVG: write the table to a .csv file"
                    .to_owned(),
            );
        }
        Content::Text(svg::file(&drawn))
    } else {
        table()?
    };
    let existing = Existing::replaced(overwrite);
    Ok(FileTask::Export(Destination { path, existing, has_scene: true }, content))
}

/// What is written to a path instead of the table, by its ending.
pub(super) fn instead_of_table(path: &Path) -> Option<&'static str> {
    if is_svg(path) {
        return Some("the charts on the screen, as SVG");
    }
    is_report(path).then_some("the report: inputs, results, charts, limit, sweep")
}

fn is_svg(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("svg"))
}

/// The path that was typed.
fn path_of(app: &App, text: &str, example: &str) -> Result<PathBuf, String> {
    let text = text.trim();
    if text.is_empty() || text.ends_with('/') {
        return Err(format!("the path needs a file name, for example `{example}`"));
    }
    Ok(app.files.directory.join(text))
}

/// Save the scene under the name or path; a file or one of the person's own presets is replaced only when asked.
fn save_as(app: &App, state: &mut Ask, overwrite: bool) -> Result<Option<FileTask>, String> {
    let name = state.text.value().trim().to_owned();
    if name.is_empty() {
        return Err("a preset needs a name: letters, digits, - and _".to_owned());
    }
    let scene = Box::new((*app.scene).clone());
    if preset::is_path(&name) {
        let path = path_of(app, &name, "scene.toml")?;
        if !overwrite && path.exists() {
            state.question = true;
            return Ok(None);
        }
        return Ok(Some(FileTask::SaveScene { name, path: Some(path), scene, overwrite }));
    }
    let same = app.files.presets.iter().filter(|entry| entry.part.is_none() && entry.name == name);
    let origins: Vec<&str> = same.map(|entry| entry.origin).collect();
    if origins.contains(&"bundled") {
        return Err(format!(
            "`{name}` is a built-in preset and stays as it is: choose another name"
        ));
    }
    if origins.contains(&"mine") && !overwrite {
        state.question = true;
        return Ok(None);
    }
    Ok(Some(FileTask::SaveScene { name, path: None, scene, overwrite }))
}

/// The next name of a series: `run.csv`, `run-2.csv`, `run-3.csv`.
fn next_name(text: &str) -> String {
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

/// The first part of every name proposed for a file about a scene: the preset's name without folders and ending.
pub(crate) fn base_stem(app: &App) -> &str {
    app.base.name.rsplit('/').next().unwrap_or("scene").trim_end_matches(".toml")
}

pub(crate) fn render(app: &App, state: &Ask, screen: Rect, canvas: &mut Canvas<'_>) {
    let (title, right) = match state.purpose {
        Purpose::Runs => return runs::render(app, state, screen, canvas),
        Purpose::Preset => ("Save the scene", ""),
        Purpose::Table(title) => (title, "Enter writes"),
        Purpose::Curve => {
            ("Measured curve of the spring (CSV)", "Tab completes  Enter reads  Esc keeps")
        }
    };
    let (width, label) =
        if state.purpose == Purpose::Preset { (64, "name  ") } else { (76, "file  ") };
    let inner = frame(screen, (width, 9), PaneFrame::new(title).right(right), canvas);
    let start = canvas.put(inner, (0, 1), label, Role::Title);
    let field = TextField { error: None, ..state.text.clone() };
    let width = inner.width.saturating_sub(start + 1);
    field.draw(canvas, Rect { x: inner.x + start, y: inner.y + 1, width, height: 1 });
    let (text, role) = match (&state.text.error, state.question) {
        (_, true) => (question(app, state), Role::Warning),
        (Some(error), false) => (app.keymap.shown(&format!("x {error}")), Role::Error),
        (None, false) => (hint(app, state), Role::Dim),
    };
    canvas.put_lines(inner, 3, wrapped(&text, inner.width, role));
}

/// What is asked where something of this name is there already.
pub(super) fn question(app: &App, state: &Ask) -> String {
    let text = state.text.value().trim();
    let (there, note) = match state.purpose {
        Purpose::Preset if !preset::is_path(text) => {
            (format!("your preset `{text}`"), " (its comments stay)")
        }
        Purpose::Preset => {
            (app.files.directory.join(text).display().to_string(), " (its comments stay)")
        }
        _ => (app.files.directory.join(text).display().to_string(), ""),
    };
    format!("! {there} exists: o overwrite{note}, r rename, Esc back")
}

fn hint(app: &App, state: &Ask) -> String {
    match state.purpose {
        Purpose::Preset if preset::is_path(state.text.value()) => {
            format!("to {}", app.files.directory.join(state.text.value().trim()).display())
        }
        Purpose::Preset => {
            "kept with your own presets; a path (./my.toml) writes a file".to_owned()
        }
        Purpose::Runs | Purpose::Table(_) => {
            let path = app.files.directory.join(state.text.value().trim());
            let other = instead_of_table(&path).unwrap_or(
                "a name that ends in .svg writes the charts on the screen, .html the report of the scene",
            );
            format!("to {}\n{other}", path.display())
        }
        // The required format of the file, and the present points.
        Purpose::Curve => format!(
            "displacement in m, force in N, one point per line, as in 0.01,1000. Now: {} (Esc keeps them)",
            extent(&app.scene.mechanism.spring.table.points)
        ),
    }
}

/// After a word was taken: a spring that is a table now requests its file.
pub(crate) fn ask(app: &mut App, word: &str) {
    let is_kind = app.pages.run.editor.variable().key == "mechanism.spring.kind";
    if is_kind && word == SpringKind::Table.word() {
        open(app, Purpose::Curve, TextField::default(), Choices::default());
    }
}

/// `3 points, x = 0 to 0.05 m`.
pub(crate) fn extent(points: &[[f64; 2]]) -> String {
    match (points.first(), points.last()) {
        (Some(first), Some(last)) => format!(
            "{} points, x = {} to {} m",
            points.len(),
            units::shortest(first[0]),
            units::shortest(last[0])
        ),
        _ => "no points".to_owned(),
    }
}

/// The file was read, or could not be: its points become the spring's as one edit, or the dialog says why not.
pub(crate) fn read(app: &mut App, path: &Path, points: Result<Arc<[[f64; 2]]>, String>) {
    let name = path
        .file_name()
        .map_or_else(|| path.display().to_string(), |name| name.to_string_lossy().into_owned());
    let taken = points.and_then(|points| {
        let count = points.len();
        let mut scene = (*app.scene).clone();
        let spring = &mut scene.mechanism.spring;
        spring.kind = SpringKind::Table;
        spring.table.points = points;
        variables::validate(&scene).map_err(|error| error.to_string())?;
        Ok((scene, count))
    });
    let is_it =
        |ask: &Ask, directory: &Path| ask.purpose == Purpose::Curve && ask.is_of(directory, path);
    if let Some((scene, count)) = answered(app, taken, is_it) {
        app.tell(format!("spring: {count} points from {name} (<undo> undoes)"));
        edit::commit_scene(app, scene, format!("spring curve from {name}"), None);
    }
}
