//! The state of the workbench: plain data, no terminal type, no I/O, no clock.
//!
//! [`crate::tui::update`] changes it, [`crate::tui::view`] draws it. What the session file keeps is taken from here.

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

/// Messages kept of a session.
const LOG_MAX: usize = 2000;

/// How the workbench is set, which the session keeps.
#[derive(Clone, Debug, Default)]
pub struct Settings {
    pub theme: Theme,
    pub mouse: bool,
}

/// State of the files on disk.
#[derive(Clone, Debug, Default)]
pub struct Files {
    /// Where relative paths start.
    pub directory: PathBuf,
    /// The presets that can be loaded.
    pub presets: Vec<PresetEntry>,
    /// Files opened or saved lately, newest first.
    pub recent: Vec<PathBuf>,
    /// The session could not be saved the last time.
    pub session_lost: bool,
}

/// Input field that has the keyboard, if no dialog is open.
#[derive(Clone, Debug)]
pub enum ActiveInput {
    /// The field of a row of the pane that has the keys.
    Field(TextField),
    /// The field of `/`.
    Find(TextField),
    /// The place of the crosshair.
    Place(TextField),
}

/// The whole state.
#[derive(Debug, Default)]
pub struct App {
    /// Columns and rows of the terminal.
    pub size: (u16, u16),
    pub tab: Tab,
    pub focus: [Pane; Tab::ALL.len()],
    pub typing: Option<ActiveInput>,
    pub keymap: Keymap,
    pub settings: Settings,
    /// This is the first start: a line says how to begin, until the first edit.
    pub first_run: bool,
    pub scene: Arc<Scene>,
    /// An edit has changed the scene since the last message.
    pub(crate) is_edited: bool,
    /// The preset it came from.
    pub base: ReferencePreset,
    /// Edits that can be undone.
    pub history: History,
    /// The result on the screen, if any yet.
    pub shown: Option<DisplayedRun>,
    /// The run before the latest edit.
    pub before: Option<Arc<Run>>,
    /// The tasks of the worker.
    pub jobs: Jobs,
    /// Pinned runs, in the order of their letters.
    pub pins: Vec<Pin>,
    pub pages: States,
    pub(crate) dialog: Option<Box<dyn Dialog>>,
    /// The newest message, until the next key.
    pub notice: Option<Notice>,
    pub files: Files,
    /// The pending requests to the outside.
    pub(crate) effects: Vec<Effect>,
}

impl App {
    /// A workbench on a scene, which is also what edits are compared with.
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

    /// The open field of a row.
    pub fn field(&self) -> Option<&TextField> {
        if let Some(ActiveInput::Field(field)) = &self.typing { Some(field) } else { None }
    }

    /// The open field of `/`.
    pub fn find(&self) -> Option<&TextField> {
        if let Some(ActiveInput::Find(text)) = &self.typing { Some(text) } else { None }
    }

    /// The open field of a place.
    pub fn place(&self) -> Option<&TextField> {
        if let Some(ActiveInput::Place(text)) = &self.typing { Some(text) } else { None }
    }

    /// Whether a dialog lies on top.
    pub fn has_dialog(&self) -> bool {
        self.dialog.is_some()
    }

    /// Whether what the tab exports and copies are runs, not a table of its own.
    pub(crate) fn shows_runs(&self) -> bool {
        matches!(self.tab, Tab::Run | Tab::Log)
    }

    /// The first part of every name proposed for a file about a scene: the preset's name without folders and ending.
    pub(crate) fn base_stem(&self) -> &str {
        self.base.name.rsplit('/').next().unwrap_or("scene").trim_end_matches(".toml")
    }

    /// All that edits change, as it is now.
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

    /// Whether the pane that has the keys fills the body.
    pub fn is_full(&self) -> bool {
        self.tab == Tab::Run && self.pages.run.is_full
    }

    pub fn pane(&self) -> Pane {
        self.focus[self.tab.index()]
    }

    /// Give a pane the keys; its tab is shown.
    pub fn focus_on(&mut self, pane: Pane) {
        self.tab = pane.tab;
        self.focus[self.tab.index()] = pane;
    }

    /// Whether a pane has the keys: its tab is shown and no dialog lies on top.
    pub fn has_focus(&self, pane: Pane) -> bool {
        self.pane() == pane && self.dialog.is_none()
    }

    /// Whether the scene differs from the preset it came from.
    pub fn is_modified(&self) -> bool {
        *self.scene != *self.base.scene
    }

    /// Whether the result on the screen belongs to an older scene.
    pub fn is_stale(&self) -> bool {
        self.shown.as_ref().is_some_and(|shown| *shown.run.scene != *self.scene)
    }

    /// Whether to say so: not in the first moments after an edit, in which most runs land.
    pub fn shows_old(&self) -> bool {
        self.is_stale() && (self.jobs.overdue || self.jobs.current.is_none())
    }

    /// Show a message and keep it for the Log tab.
    pub fn say(&mut self, severity: Severity, text: impl Into<String>) {
        // A file may have several errors, a line each.
        let text = self.keymap.shown(&text.into()).replace('\n', "; ");
        let text = clean::line(&text).into_owned();
        let notice = Notice { severity, text };
        self.keep(notice.clone());
        self.notice = Some(notice);
    }

    /// Note a file that was opened or saved; a relative path is one of the directory.
    pub(crate) fn note_recent(&mut self, path: &Path) {
        session::note_recent(&mut self.files.recent, self.files.directory.join(path));
    }

    pub(crate) fn request(&mut self, effect: Effect) {
        self.effects.push(effect);
    }

    /// Ask for the presets there are, the files opened lately among them.
    pub(crate) fn list_presets(&mut self) {
        self.request(Effect::Files(FileTask::ListPresets(self.files.recent.clone())));
    }

    /// Say something good to know.
    pub(crate) fn report_progress(&mut self, text: impl Into<String>) {
        self.say(Severity::Note, text);
    }

    pub(crate) fn refuse(&mut self, why: impl Into<String>) {
        self.say(Severity::Error, why);
    }

    /// Keep a message for the Log tab; of very many the oldest go.
    pub(crate) fn keep(&mut self, notice: Notice) {
        let messages = &mut self.pages.log.messages;
        if messages.len() >= LOG_MAX {
            messages.drain(..LOG_MAX / 4);
        }
        messages.push(notice);
    }

    /// The run before the latest edit, while the result of the edit is on the screen and differs from it.
    pub fn run_before(&self) -> Option<&Run> {
        let before = self.before.as_deref()?;
        let is_new = |shown: &DisplayedRun| *shown.run.scene != *before.scene && !self.is_stale();
        self.shown.as_ref().is_some_and(is_new).then_some(before)
    }

    /// Keep the run of a scene that is about to be edited, if it is complete.
    pub(crate) fn keep_before(&mut self, scene: &Scene) {
        let of_scene =
            |shown: &&DisplayedRun| shown.elapsed.is_some() && *shown.run.scene == *scene;
        self.before = self.shown.as_ref().filter(of_scene).map(|shown| Arc::clone(&shown.run));
    }

    /// The runs to draw, the current one last so that it lies on top.
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

    /// The variables that differ between two scenes, by index into the table.
    pub fn differing(a: &Scene, b: &Scene) -> Vec<usize> {
        cmra_engine::model::variables::VARIABLES
            .iter()
            .enumerate()
            .filter(|(_, variable)| variable.value(a) != variable.value(b))
            .map(|(index, _)| index)
            .collect()
    }
}

/// How long the computation took, in a few characters: `0.21 ms`.
pub fn show_duration(took: Duration) -> String {
    cmra_engine::model::units::engineering(took.as_secs_f64(), "s", 2)
}
