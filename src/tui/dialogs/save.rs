//! Saving the scene: as a preset of one's own by its name, or as a file by its path.

use std::path::Path;

use crate::files::preset;
use crate::tui::app::dialog::Dialog;
use crate::tui::dialogs::ask::{Ask, Asking, Purpose};
use crate::tui::message::{EffectReport, ExportOutcome, FileTask};
use crate::tui::prelude::*;
use crate::tui::widgets::input::TextField;

pub(super) fn open(app: &mut App) -> Box<dyn Dialog> {
    app.list_presets();
    Asking::open(Save, TextField::selected(proposed_name(app)))
}

#[derive(Debug)]
struct Save;

impl Purpose for Save {
    const FOOTER: &'static str = "<enter> save  <back> do not save";

    /// A file or one of the person's own presets is replaced only when asked.
    fn accept(
        &self,
        app: &App,
        ask: &mut Ask,
        overwrite: bool,
    ) -> Result<Option<FileTask>, String> {
        let name = ask.value().to_owned();
        if name.is_empty() {
            return Err("a preset needs a name: letters, digits, - and _".to_owned());
        }
        let path = if preset::is_path(&name) { Some(ask.path(app, "scene.toml")?) } else { None };
        let same = app.files.presets.iter().filter(|it| it.part.is_none() && it.name == name);
        let origins: Vec<&str> = same.map(|entry| entry.origin).collect();
        if path.is_none() && origins.contains(&"bundled") {
            return Err(format!(
                "`{name}` is a built-in preset and stays as it is: choose another name"
            ));
        }
        if path.is_none() && origins.contains(&"mine") && !overwrite {
            ask.question = true;
            return Ok(None);
        }
        let scene = Box::new((*app.scene).clone());
        Ok(Some(FileTask::SaveScene { name, path, scene, overwrite }))
    }

    fn ended(&self, ask: &Ask, _: &Path, report: &EffectReport) -> Option<ExportOutcome> {
        match report {
            EffectReport::Saved(name, saved) if ask.value() == name => Some(saved.clone()),
            _ => None,
        }
    }

    fn title(&self) -> (&'static str, &'static str) {
        ("Save the scene", "name  ")
    }

    fn hint(&self, app: &App, ask: &Ask) -> String {
        if preset::is_path(ask.value()) {
            format!("to {}", app.files.directory.join(ask.value()).display())
        } else {
            "kept with your own presets; a path (./my.toml) writes a file".to_owned()
        }
    }

    fn there(&self, app: &App, ask: &Ask) -> String {
        let name = ask.value();
        if preset::is_path(name) {
            app.files.directory.join(name).display().to_string()
        } else {
            format!("your preset `{name}`")
        }
    }
}

/// The present name for one's own preset or file, else that name with the first number that is free.
fn proposed_name(app: &App) -> String {
    let name = &app.base.name;
    // Scenes that the program kept by itself are files, too, but nobody opened them by their path.
    let files = &app.files;
    let is_file = preset::is_path(name) && files.recent.contains(&files.directory.join(name));
    if app.base.is_mine || is_file {
        return name.clone();
    }
    let taken =
        |name: &str| files.presets.iter().any(|entry| entry.part.is_none() && entry.name == name);
    let stem = app.base_stem();
    (2..100)
        .map(|number| format!("{stem}-{number}"))
        .find(|name| !taken(name))
        .unwrap_or_else(|| "my-scene".to_owned())
}
