//! Saving the scene: as a preset of one's own by its name, or as a file by its path.

use std::path::Path;

use crossterm::event::KeyEvent;

use crate::files::preset;
use crate::tui::app::dialog::{Dialog, FootKey, Footer, Outcome};
use crate::tui::dialogs::ask::{Ask, REPLACE, Step};
use crate::tui::message::{EffectReport, FileTask};
use crate::tui::prelude::*;
use crate::tui::widgets::input::TextField;

pub(super) fn open(app: &mut App) -> Option<Box<dyn Dialog>> {
    app.list_presets();
    Some(Box::new(Save(Ask::new(TextField::selected(proposed_name(app))))))
}

#[derive(Clone, Debug)]
struct Save(Ask);

impl Dialog for Save {
    fn footer(&self) -> Footer {
        if self.0.question {
            return REPLACE;
        }
        &[(FootKey::Of(Action::Enter), "save"), (FootKey::Of(Action::Back), "do not save")]
    }

    fn press(&mut self, app: &mut App, key: KeyEvent) -> Outcome {
        let is_path = preset::is_path(self.0.text.value());
        match self.0.press(app, key, is_path) {
            Step::Accept { overwrite } => {
                let task = self.task(app, overwrite);
                self.0.begun(app, task);
            }
            Step::Closes => return Outcome::Closes,
            Step::Stays => {}
        }
        Outcome::Stays
    }

    fn click(&mut self, _: &mut App, _: usize) -> Outcome {
        Outcome::Stays
    }

    fn field_mut(&mut self) -> Option<&mut TextField> {
        Some(&mut self.0.text)
    }

    fn pasted(&mut self) {
        self.0.forget();
    }

    fn answered(&mut self, _: &Path, report: &EffectReport) -> Option<Outcome> {
        match report {
            EffectReport::Saved(name, saved) if self.0.value() == name => Some(self.0.ended(saved)),
            EffectReport::Completions(names) => Some(self.0.complete(names)),
            _ => None,
        }
    }

    fn draw(&self, app: &App, screen: Rect, canvas: &mut Canvas<'_>) {
        let name = self.0.value();
        let hint = if preset::is_path(name) {
            format!("to {}", app.files.directory.join(name).display())
        } else {
            "kept with your own presets; a path (./my.toml) writes a file".to_owned()
        };
        let pane =
            PaneFrame::new("Save the scene; comments of a file or preset that is replaced stay");
        self.0.draw(app, (pane, "name  ", hint), screen, canvas);
    }
}

impl Save {
    /// The task; none if a question comes first: a file or one of the person's own presets is replaced only when asked.
    fn task(&mut self, app: &App, overwrite: bool) -> Result<Option<FileTask>, String> {
        let name = self.0.value().to_owned();
        if name.is_empty() {
            return Err("a preset needs a name: letters, digits, - and _".to_owned());
        }
        let path =
            if preset::is_path(&name) { Some(self.0.path(app, "scene.toml")?) } else { None };
        let same = app.files.presets.iter().filter(|it| it.part.is_none() && it.name == name);
        let origins: Vec<&str> = same.map(|entry| entry.origin).collect();
        if path.is_none() && origins.contains(&"bundled") {
            return Err(format!(
                "`{name}` is a built-in preset and stays as it is: choose another name"
            ));
        }
        // The thread that writes finds out whether a file exists.
        if path.is_none() && origins.contains(&"mine") && !overwrite {
            self.0.question = true;
            return Ok(None);
        }
        let scene = Box::new((*app.scene).clone());
        Ok(Some(FileTask::SaveScene { name, path, scene, overwrite }))
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
