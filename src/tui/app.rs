//! State of the workbench: plain data, without terminal types, I/O or a clock.
//!
//! [`crate::tui::update`] changes it, [`crate::tui::view`] draws it. The session file stores a part of it.

pub(crate) mod dialog;
pub(crate) mod edit;
pub mod history;
pub mod jobs;
pub mod notice;
pub mod pins;
pub mod running;

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use dialog::Dialog;
use history::{History, Snapshot};
use notice::{Notice, Severity};
use pins::{DisplayedRun, Pin, RunView};
use running::Jobs;

use crate::files::clean;
use crate::files::session;
use crate::tui::keymap::Keymap;
use crate::tui::message::FileTask;
use crate::tui::pages::states::States;
use crate::tui::prelude::*;
use crate::tui::preset::{PresetEntry, ReferencePreset};
use crate::tui::theme::Theme;
use crate::tui::widgets::input::TextField;
use cmra_engine::model::run::Run;
use cmra_engine::model::scene::Scene;

/// Maximum number of stored messages.
const LOG_MAX: usize = 2000;

/// Settings of the workbench, stored in the session.
#[derive(Clone, Debug, Default)]
pub struct Settings {
    pub theme: Theme,
    pub mouse: bool,
}

/// State of the files on disk.
#[derive(Clone, Debug, Default)]
pub struct Files {
    /// Directory for relative paths.
    pub directory: PathBuf,
    /// Available presets.
    pub presets: Vec<PresetEntry>,
    /// Recently opened or saved files, newest first.
    pub recent: Vec<PathBuf>,
    /// Whether the last attempt to save the session failed.
    pub session_lost: bool,
}

/// Input field with the keyboard focus, if no dialog is open.
#[derive(Clone, Debug)]
pub enum ActiveInput {
    /// Field of a row of the focused pane.
    Field(TextField),
    /// Search field (`/`).
    Find(TextField),
    /// Field for the crosshair position.
    Place(TextField),
}

/// Complete state.
#[derive(Debug, Default)]
pub struct App {
    /// Columns and rows of the terminal.
    pub size: (u16, u16),
    pub tab: Tab,
    pub focus: [Pane; Tab::ALL.len()],
    pub typing: Option<ActiveInput>,
    pub keymap: Keymap,
    pub settings: Settings,
    /// Whether this is the first start. A line explains how to begin, until the first edit.
    pub first_run: bool,
    pub scene: Arc<Scene>,
    /// Whether an edit has changed the scene since the last message.
    pub(crate) is_edited: bool,
    /// Preset from which the scene was loaded.
    pub base: ReferencePreset,
    /// Undo history.
    pub history: History,
    /// Displayed result; `None` before the first one.
    pub shown: Option<DisplayedRun>,
    /// Run before the latest edit.
    pub before: Option<Arc<Run>>,
    /// Tasks of the worker.
    pub jobs: Jobs,
    /// Pinned runs, in the order of their letters.
    pub pins: Vec<Pin>,
    pub pages: States,
    pub(crate) dialog: Option<Box<dyn Dialog>>,
    /// Newest message, until the next key.
    pub notice: Option<Notice>,
    pub files: Files,
    /// Pending effects.
    pub(crate) effects: Vec<Effect>,
}

impl App {
    /// Creates a workbench on a preset, with which edits are compared.
    pub fn new(base: ReferencePreset, theme: Theme, directory: PathBuf) -> Self {
        Self {
            size: (80, 24),
            settings: Settings { theme, ..Settings::default() },
            focus: Tab::ALL.map(|tab| Pane::new(tab, 0)),
            scene: Arc::clone(&base.scene),
            base,
            files: Files { directory, ..Files::default() },
            ..Self::default()
        }
    }

    /// Returns the open field of a row.
    pub fn field(&self) -> Option<&TextField> {
        if let Some(ActiveInput::Field(field)) = &self.typing { Some(field) } else { None }
    }

    /// Returns the open search field.
    pub fn find(&self) -> Option<&TextField> {
        if let Some(ActiveInput::Find(text)) = &self.typing { Some(text) } else { None }
    }

    /// Returns the open field for the crosshair position.
    pub fn place(&self) -> Option<&TextField> {
        if let Some(ActiveInput::Place(text)) = &self.typing { Some(text) } else { None }
    }

    /// Returns `true` if a dialog is open.
    pub fn has_dialog(&self) -> bool {
        self.dialog.is_some()
    }

    /// Returns `true` if the tab exports and copies runs; `false` if it has a table of its own.
    pub(crate) fn shows_runs(&self) -> bool {
        matches!(self.tab, Tab::Run | Tab::Log)
    }

    /// Returns the first part of proposed file names: the preset's name without folders and extension.
    pub(crate) fn base_stem(&self) -> &str {
        self.base.name.rsplit('/').next().unwrap_or("scene").trim_end_matches(".toml")
    }

    /// Returns the undoable part of the state.
    pub(crate) fn snapshot(&self) -> Snapshot {
        Snapshot {
            scene: Arc::clone(&self.scene),
            base: self.base.clone(),
            units: self.pages.run.editor.units.clone(),
            search: Arc::clone(&self.pages.search.setup),
            picture: self.pages.explore.picture,
            pins: self.pins.iter().map(|pin| Pin { run: None, job: None, ..pin.clone() }).collect(),
        }
    }

    /// Returns `true` if the focused pane fills the body.
    pub fn is_full(&self) -> bool {
        self.tab == Tab::Run && self.pages.run.is_full
    }

    pub fn pane(&self) -> Pane {
        self.focus[self.tab.index()]
    }

    /// Focuses a pane and shows its tab.
    pub fn focus_on(&mut self, pane: Pane) {
        self.tab = pane.tab;
        self.focus[self.tab.index()] = pane;
    }

    /// Returns `true` if a pane has the focus: its tab is shown and no dialog is open.
    pub fn has_focus(&self, pane: Pane) -> bool {
        self.pane() == pane && self.dialog.is_none()
    }

    /// Returns `true` if the scene differs from the preset from which it was loaded.
    pub fn is_modified(&self) -> bool {
        *self.scene != *self.base.scene
    }

    /// Returns `true` if the displayed result belongs to an older scene.
    pub fn is_stale(&self) -> bool {
        self.shown.as_ref().is_some_and(|shown| *shown.run.scene != *self.scene)
    }

    /// Returns `true` if the result is marked as old: not immediately after an edit, because most runs end in that time.
    pub fn shows_old(&self) -> bool {
        self.is_stale() && (self.jobs.overdue || self.jobs.current.is_none())
    }

    /// Shows a message and stores it for the Log tab.
    pub fn say(&mut self, severity: Severity, text: impl Into<String>) {
        // The error of a file may have several lines.
        let text = self.keymap.shown(&text.into()).replace('\n', "; ");
        let text = clean::line(&text).into_owned();
        let notice = Notice { severity, text };
        self.keep(notice.clone());
        self.notice = Some(notice);
    }

    /// Records an opened or saved file; relative paths start in the directory.
    pub(crate) fn note_recent(&mut self, path: &Path) {
        session::note_recent(&mut self.files.recent, self.files.directory.join(path));
    }

    pub(crate) fn request(&mut self, effect: Effect) {
        self.effects.push(effect);
    }

    /// Requests the list of presets, including recent files.
    pub(crate) fn list_presets(&mut self) {
        self.request(Effect::Files(FileTask::ListPresets(self.files.recent.clone())));
    }

    /// Shows a message of severity `Note`.
    pub(crate) fn report_progress(&mut self, text: impl Into<String>) {
        self.say(Severity::Note, text);
    }

    pub(crate) fn refuse(&mut self, why: impl Into<String>) {
        self.say(Severity::Error, why);
    }

    /// Stores a message for the Log tab; drops the oldest beyond the maximum.
    pub(crate) fn keep(&mut self, notice: Notice) {
        let messages = &mut self.pages.log.messages;
        if messages.len() >= LOG_MAX {
            messages.drain(..LOG_MAX / 4);
        }
        messages.push(notice);
    }

    /// Returns the run before the latest edit, while the result of the edit is displayed and differs from it.
    pub fn run_before(&self) -> Option<&Run> {
        let before = self.before.as_deref()?;
        let is_new = |shown: &DisplayedRun| *shown.run.scene != *before.scene && !self.is_stale();
        self.shown.as_ref().is_some_and(is_new).then_some(before)
    }

    /// Stores the run of a scene before an edit, if it is complete.
    pub(crate) fn keep_before(&mut self, scene: &Scene) {
        let of_scene =
            |shown: &&DisplayedRun| shown.elapsed.is_some() && *shown.run.scene == *scene;
        self.before = self.shown.as_ref().filter(of_scene).map(|shown| Arc::clone(&shown.run));
    }

    /// Returns the runs to draw, the current one last so that it is on top.
    pub fn visible_runs(&self) -> Vec<RunView<'_>> {
        let pins = (1..).zip(&self.pins).filter_map(|(index, pin)| {
            let run = pin.run.as_deref()?;
            Some(RunView { letter: Some(pin.letter), index, name: &pin.name, run, old: false })
        });
        let old = self.shows_old();
        let now = self.shown.iter().map(|shown| &*shown.run);
        let now = now.map(|run| RunView { letter: None, index: 0, name: "now", run, old });
        pins.chain(now).collect()
    }

    /// Returns the variables that differ between two scenes, by index into the table.
    pub fn differing(a: &Scene, b: &Scene) -> Vec<usize> {
        cmra_engine::model::variables::VARIABLES
            .iter()
            .enumerate()
            .filter(|(_, variable)| variable.value(a) != variable.value(b))
            .map(|(index, _)| index)
            .collect()
    }
}

/// Formats a computation time in a few characters: `0.21 ms`.
pub fn show_duration(took: Duration) -> String {
    cmra_engine::model::units::engineering(took.as_secs_f64(), "s", 2)
}
