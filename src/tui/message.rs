//! Inputs of the workbench ([`Message`]) and its requests to the event loop ([`Effect`]).

use std::fmt;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use crossterm::event::KeyEvent;

use crate::files::export::{self, Destination, Sidecar};
use crate::tui::prelude::*;
use crate::tui::preset::PresetEntry;
use crate::worker::{Task, TaskReport};
use cmra_engine::model::scene::Scene;
use cmra_studies::report::run::{self, NamedRun};
use cmra_studies::report::traces::Traces;
use cmra_studies::study::context::Reach;

#[derive(Clone, Debug)]
pub enum Message {
    Key(KeyEvent),
    /// Pasted text (bracketed paste).
    Paste(String),
    /// New size of the terminal.
    Resize(u16, u16),
    Click(Target),
    /// Turn of the wheel (`true` for upward) at a target.
    Wheel(bool, Option<Target>),
    Report(TaskReport),
    /// End of the quiet time after an edit; outdated unless the serial number is the newest.
    RunDue(u64),
    /// End of the idle time; outdated unless the serial number is the newest.
    Rest(u64),
    /// Number of a job that now needs confirmation to be cancelled, because it takes long.
    LongJob(u64),
    /// Next frame of the animation with this number.
    Tick(u64),
    /// End of an effect, successful or not.
    Done(EffectReport),
}

/// Result of an effect, with texts for the message row.
#[derive(Clone, Debug)]
pub enum EffectReport {
    /// A scene was saved under this name or path.
    Saved(String, ExportOutcome),
    /// Result of an export to this path: written, target exists, or failed.
    Exported(PathBuf, ExportOutcome),
    /// Available presets.
    Presets(Vec<PresetEntry>),
    /// Scene read from a file.
    Loaded(Result<(String, Box<Scene>), String>),
    /// Traces read from a file.
    Traces(PathBuf, Result<Arc<Traces>, String>),
    /// Message for the user.
    Said(Severity, String),
    /// Saving the session starts to fail, or works again.
    Session(Result<(), String>),
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ExportOutcome {
    Written(Vec<PathBuf>),
    /// The file exists and was not replaced.
    Exists(PathBuf),
    Failed(String),
}

impl ExportOutcome {
    /// Describes an export that wrote nothing.
    pub(crate) fn message(&self) -> String {
        match self {
            Self::Written(_) => String::new(),
            Self::Exists(path) => {
                format!("{} already exists and was not replaced", path.display())
            }
            Self::Failed(text) => text.clone(),
        }
    }
}

/// Request of the workbench to the event loop.
#[derive(Clone, Debug)]
pub enum Effect {
    /// Queue a task; replaces an older task of the same slot.
    Submit(Task),
    /// Cancel a task, by number.
    Cancel(u64),
    After(Duration, Message),
    Files(FileTask),
    /// Save the session soon (edits in quick succession are saved once).
    SaveSession,
    /// Copy to the clipboard of the terminal (OSC 52).
    Copy(String),
    /// Capture or release the mouse.
    Mouse(bool),
    Redraw,
    /// Restore the terminal and stop until `fg`.
    Suspend,
    /// Quit.
    Quit,
}

/// File task for the I/O thread.
#[derive(Clone, Debug)]
pub enum FileTask {
    /// Save the scene, keeping the comments of an existing file.
    SaveScene {
        /// Typed name or path.
        name: String,
        /// Path of the file; `None` for a user preset of this name.
        path: Option<PathBuf>,
        scene: Box<Scene>,
        /// Replace an existing file or preset.
        overwrite: bool,
    },
    Export(Destination, Content),
    /// List the available presets, including these files.
    ListPresets(Vec<PathBuf>),
    Load(PathBuf),
    /// Read traces for the charts.
    Traces(PathBuf),
}

/// Content of a file to write.
#[derive(Clone, Debug)]
pub enum Content {
    /// Runs with their names (`now`, `A`, ...).
    Runs(Vec<NamedRun>),
    Page(PageTable),
    /// Displayed charts as SVG.
    Text(String),
}

/// Table of a page. The text is built when written or copied, because a long table takes a moment.
#[derive(Clone)]
pub struct PageTable {
    /// Content of the export, for the dialog's frame.
    pub title: &'static str,
    /// Proposed file name.
    pub file: String,
    reach: Reach,
    csv: Arc<dyn Fn(Reach) -> String + Send + Sync>,
    /// Scene of the content, if it has one.
    scene: Option<Arc<Scene>>,
    /// Comment lines above the scene in the file next to the table.
    notes: String,
    /// Command that recreates the table from the scene: `sweep --over k=1..2`.
    command: String,
}

impl PageTable {
    /// Creates a table without a scene.
    pub(crate) fn new(
        title: &'static str,
        stem: impl fmt::Display,
        reach: Reach,
        csv: impl Fn(Reach) -> String + Send + Sync + 'static,
    ) -> Self {
        let part = if reach.is_complete() { "" } else { "-incomplete" };
        let file = format!("{stem}{part}.csv");
        let (csv, notes, command) = (Arc::new(csv), String::new(), String::new());
        Self { title, file, reach, csv, scene: None, notes, command }
    }

    /// Creates a table of a scene, which a command recreates; the file name contains the preset.
    pub(crate) fn for_scene(
        self,
        app: &App,
        scene: &Arc<Scene>,
        command: impl Into<String>,
    ) -> Self {
        // The results of another preset are not named after the present one.
        let stem = if scene.title == app.scene.title {
            app.base_stem().to_owned()
        } else {
            scene.title.to_lowercase().replace(|c: char| !c.is_alphanumeric(), "-")
        };
        let file = format!("{stem}-{}", self.file);
        let missing = self.reach.counted("").map(|after| format!("# not complete: {after}\n"));
        let notes = missing.unwrap_or_default();
        Self { file, scene: Some(Arc::clone(scene)), notes, command: command.into(), ..self }
    }

    /// Replaces the comment lines above the scene.
    pub(crate) fn noted(self, notes: String) -> Self {
        Self { notes, ..self }
    }

    fn beside(&self) -> Option<Sidecar<'_>> {
        let (notes, command) = (self.notes.clone(), self.command.clone());
        Some(Sidecar { run: None, scene: self.scene.as_ref()?, notes, command })
    }
}

impl fmt::Debug for PageTable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("PageTable")
            .field("is_complete", &self.reach.is_complete())
            .finish_non_exhaustive()
    }
}

impl Content {
    pub(crate) fn is_complete(&self) -> bool {
        match self {
            Self::Runs(_) | Self::Text(_) => true,
            Self::Page(table) => table.reach.is_complete(),
        }
    }

    /// Returns the text of the file.
    pub fn text(&self) -> String {
        match self {
            Self::Runs(runs) => run::csv(runs),
            Self::Page(table) => (table.csv)(table.reach),
            Self::Text(text) => text.clone(),
        }
    }

    pub fn scenes(&self) -> Vec<Sidecar<'_>> {
        match self {
            Self::Runs(runs) => export::scenes(runs),
            Self::Page(table) => table.beside().into_iter().collect(),
            Self::Text(_) => Vec::new(),
        }
    }
}
