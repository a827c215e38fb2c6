//! Inputs of the workbench ([`Message`]) and its requests to the outside ([`Effect`]).

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
    /// Text was pasted (bracketed paste).
    Paste(String),
    /// The terminal has a new size.
    Resize(u16, u16),
    Click(Target),
    /// The wheel was turned, upward or not, over something.
    Wheel(bool, Option<Target>),
    Report(TaskReport),
    /// The quiet time after an edit is over; stale when the serial number is not the newest.
    RunDue(u64),
    /// No key was pressed for a while; stale when the serial number is not the newest.
    Rest(u64),
    /// A job has been running for so long that leaving must not drop it without confirmation: its number.
    LongJob(u64),
    /// The next picture of the playing with this number is due.
    Tick(u64),
    /// An effect has been carried out, or has failed.
    Done(EffectReport),
}

/// How an effect ended. The texts are for the message row.
#[derive(Clone, Debug)]
pub enum EffectReport {
    /// A scene was saved under this name or path: its file.
    Saved(String, ExportOutcome),
    /// An export to this path was written; or the target exists already; or it failed.
    Exported(PathBuf, ExportOutcome),
    /// The presets that can be loaded now.
    Presets(Vec<PresetEntry>),
    /// A scene file was read.
    Loaded(Result<(String, Box<Scene>), String>),
    /// The traces of a file were read, or why not.
    Traces(PathBuf, Result<Arc<Traces>, String>),
    /// Something a person should know of.
    Said(Severity, String),
    /// The session cannot be kept any more, and why; or it can again.
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

/// A request of the workbench to the outside.
#[derive(Clone, Debug)]
pub enum Effect {
    /// Queue a task; a newer one of the same slot replaces an older one.
    Submit(Task),
    /// Cancel a task, by its number.
    Cancel(u64),
    After(Duration, Message),
    Files(FileTask),
    /// Save the session soon (edits in quick succession are saved once).
    SaveSession,
    /// Copy to the clipboard of the terminal (OSC 52).
    Copy(String),
    /// Capture the mouse or let it go.
    Mouse(bool),
    Redraw,
    /// Restore the terminal and stop until `fg`.
    Suspend,
    /// Leave.
    Quit,
}

/// Something to do with files, on a thread of its own.
#[derive(Clone, Debug)]
pub enum FileTask {
    /// Save the scene, keeping the comments of an existing file.
    SaveScene {
        /// The name or path that was typed.
        name: String,
        /// The file; `None`: a preset of the user's of this name.
        path: Option<PathBuf>,
        scene: Box<Scene>,
        /// Replace an existing file or preset.
        overwrite: bool,
    },
    Export(Destination, Content),
    /// List the presets there are, these files among them.
    ListPresets(Vec<PathBuf>),
    Load(PathBuf),
    /// Read traces to draw beside the runs.
    Traces(PathBuf),
}

/// The content of a file to write.
#[derive(Clone, Debug)]
pub enum Content {
    /// Runs, each with its name (`now`, `A`, ...).
    Runs(Vec<NamedRun>),
    Page(PageTable),
    /// The charts on the screen as SVG.
    Text(String),
}

/// The table of a page, made where it is written or copied: a long one takes a moment.
#[derive(Clone)]
pub struct PageTable {
    /// Content of the export, for the dialog's frame.
    pub title: &'static str,
    /// The file that is proposed.
    pub file: String,
    reach: Reach,
    csv: Arc<dyn Fn(Reach) -> String + Send + Sync>,
    /// Scene of the content, if it has one.
    scene: Option<Arc<Scene>>,
    /// The comment lines above the scene in the file beside the table.
    notes: String,
    /// The command that makes the table again of the scene: `sweep --over k=1..2`.
    command: String,
}

impl PageTable {
    /// A table of no scene in particular.
    pub(crate) fn new(
        title: &'static str,
        file: impl Into<String>,
        reach: Reach,
        csv: impl Fn(Reach) -> String + Send + Sync + 'static,
    ) -> Self {
        let mut file = file.into();
        if !reach.is_complete() {
            file = file.replace(".csv", "-incomplete.csv");
        }
        let (csv, notes, command) = (Arc::new(csv), String::new(), String::new());
        Self { title, file, reach, csv, scene: None, notes, command }
    }

    /// Builds a table of a scene, which a command makes again; the preset is part of the file's name.
    pub(crate) fn for_scene(
        self,
        app: &App,
        scene: &Arc<Scene>,
        command: impl Into<String>,
    ) -> Self {
        let file = format!("{}-{}", app.base_stem(), self.file);
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

    /// The text of the file.
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
