//! I/O thread: performs file effects on a separate thread, so that a slow disk does not delay keys.
//!
//! Tasks run in order. The session is saved shortly after a change (changes in quick succession are saved once), and immediately when the
//! loop ends. Does not depend on the terminal.

use std::cell::Cell;
use std::panic::{self, AssertUnwindSafe};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, TryLockError};
use std::thread;
use std::time::{Duration, Instant};

use super::backlog::LoopEvent;
use super::start;
use crate::files::atomic::{self, OverwritePolicy};
use crate::files::error::FileError;
use crate::files::export::Destination;
use crate::files::library;
use crate::files::paths::Paths;
use crate::files::preset::{self, Preset};
use crate::files::read_traces;
use crate::files::recent;
use crate::files::session::{self, Session, SessionFingerprint};
use crate::tui::app::notice::Severity;
use crate::tui::message::{Content, EffectReport, ExportOutcome, FileTask as Task, Message};
use crate::tui::preset::PresetEntry;
use cmra_engine::model::scene::Scene;

/// Maximum delay before a changed session is saved.
pub(super) const SESSION_DELAY: Duration = Duration::from_secs(1);

/// Maximum time for another thread to save the session when the program has to end, and the polling interval.
pub(super) const SAVING: Duration = Duration::from_millis(500);
const SAVING_CHECK: Duration = Duration::from_millis(5);

/// Result of saving the session: the backup of another workbench's session if there was one, or the reason for a failure.
type SaveResult = Result<Option<PathBuf>, String>;

pub(super) enum Request {
    Task(Task),
    /// The session in [`Unsaved`] has changed.
    SessionChanged,
    /// Save the session now and confirm.
    Finish(Sender<SaveResult>),
}

/// Session that is not yet saved.
#[derive(Clone, Default)]
pub(super) struct Unsaved {
    session: Arc<Mutex<Option<Box<Session>>>>,
    known: Arc<Mutex<SessionFingerprint>>,
    /// Whether the program has to end soon, without waiting for another workbench.
    is_urgent: Arc<AtomicBool>,
    paths: Option<Paths>,
}

impl Unsaved {
    fn lock(&self) -> MutexGuard<'_, Option<Box<Session>>> {
        self.session.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Saves an unsaved session; `None` if there is none, or no place for it.
    pub(super) fn save(&self) -> Option<SaveResult> {
        self.save_as(&mut self.known.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// Saves an unsaved session when the program has to end. Does not wait for the lock of another workbench, and waits at most this long
    /// for a thread that is saving.
    pub(super) fn save_at_once(&self, patience: Duration) -> Option<SaveResult> {
        self.is_urgent.store(true, Ordering::SeqCst);
        let deadline = Instant::now() + patience;
        loop {
            match self.known.try_lock() {
                Ok(mut known) => return self.save_as(&mut known),
                Err(TryLockError::Poisoned(known)) => return self.save_as(&mut known.into_inner()),
                Err(TryLockError::WouldBlock) if Instant::now() < deadline => {
                    thread::park_timeout(SAVING_CHECK);
                }
                Err(TryLockError::WouldBlock) => {
                    return Some(Err("the disk takes too long".to_owned()));
                }
            }
        }
    }

    /// Saves the session while holding the fingerprint; `None` if another thread has already saved it.
    fn save_as(&self, known: &mut SessionFingerprint) -> Option<SaveResult> {
        let session = self.lock().take()?;
        let path = self.paths.as_ref()?.session_file();
        let may_wait = || !self.is_urgent.load(Ordering::SeqCst);
        let saved = session::save(&path, &session, known, &may_wait);
        Some(saved.map_err(|error| error.to_string()))
    }
}

pub(super) struct IoThread {
    requests: Sender<Request>,
    unsaved: Unsaved,
}

impl IoThread {
    /// Starts the thread, which saves a changed session after this delay. Without paths it stores no files of the program.
    pub(super) fn spawn(
        paths: Option<Paths>,
        known: SessionFingerprint,
        delay: Duration,
        inbox: Sender<LoopEvent>,
    ) -> std::io::Result<Self> {
        let (requests, receive) = mpsc::channel();
        let known = Arc::new(Mutex::new(known));
        let unsaved = Unsaved { known, paths, ..Unsaved::default() };
        let queue = FileQueue {
            unsaved: unsaved.clone(),
            inbox,
            delay,
            is_kept: Cell::new(true),
            shares: Cell::new(false),
        };
        thread::Builder::new().name("io_thread".to_owned()).spawn(move || queue.serve(&receive))?;
        Ok(Self { requests, unsaved })
    }

    pub(super) fn ask(&self, task: Task) {
        self.request(Request::Task(task));
    }

    fn request(&self, request: Request) {
        // The thread ends only with the loop.
        let _ = self.requests.send(request);
    }

    /// Schedules saving the session.
    pub(super) fn session_changed(&self, session: Session) {
        *self.unsaved.lock() = Some(Box::new(session));
        self.request(Request::SessionChanged);
    }

    /// Returns the unsaved session, for the thread that saves it if the loop cannot.
    pub(super) fn unsaved(&self) -> Unsaved {
        self.unsaved.clone()
    }

    /// Finishes all tasks and saves the session within this time; does not wait for another workbench if urgent.
    pub(super) fn finish(&self, patience: Duration, is_urgent: bool) -> SaveResult {
        self.unsaved.is_urgent.store(is_urgent, Ordering::SeqCst);
        let (done, wait) = mpsc::channel();
        let asked = self.requests.send(Request::Finish(done)).is_ok();
        match wait.recv_timeout(patience) {
            Ok(saved) if asked => saved,
            // A slow task blocks the thread: save the session first.
            _ => self.unsaved.save_at_once(SAVING).unwrap_or(Ok(None)),
        }
    }
}

struct FileQueue {
    unsaved: Unsaved,
    inbox: Sender<LoopEvent>,
    /// Maximum delay before a changed session is saved.
    delay: Duration,
    /// Whether the last attempt to save the session succeeded.
    is_kept: Cell<bool>,
    /// Whether another workbench saves its session in the same place.
    shares: Cell<bool>,
}

impl FileQueue {
    fn serve(&self, requests: &Receiver<Request>) {
        let mut session_due: Option<Instant> = None;
        if let Some(paths) = &self.unsaved.paths {
            for folder in [&paths.state, &paths.recent_folder(), &paths.presets] {
                atomic::remove_stale(folder);
            }
        }
        loop {
            if session_due.is_some_and(|due| due <= Instant::now()) {
                session_due = None;
                self.save();
            }
            let request = match session_due {
                Some(due) => requests.recv_timeout(due.saturating_duration_since(Instant::now())),
                None => requests.recv().map_err(Into::into),
            };
            match request {
                Ok(Request::SessionChanged) => {
                    session_due.get_or_insert_with(|| Instant::now() + self.delay);
                }
                Ok(Request::Finish(done)) => {
                    session_due = None;
                    // The loop may have stopped waiting.
                    let _ = done.send(self.unsaved.save().unwrap_or(Ok(None)));
                }
                Ok(Request::Task(task)) => self.contained(task),
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => {
                    self.save();
                    return;
                }
            }
        }
    }

    /// Saves the session; notifies the user when saving starts to fail, and when it works again.
    fn save(&self) {
        let Some(saved) = self.unsaved.save() else { return };
        // The loop may have ended.
        let tell = |report| drop(self.inbox.send(LoopEvent::Message(Message::Done(report))));
        if let Ok(Some(aside)) = &saved
            && !self.shares.replace(true)
        {
            tell(EffectReport::Said(Severity::Warning, of_another(aside)));
        }
        if self.is_kept.replace(saved.is_ok()) != saved.is_ok() {
            tell(EffectReport::Session(saved.map(drop)));
        }
    }

    /// Runs a task and reports; a panic ends the task, not the thread.
    fn contained(&self, task: Task) {
        let done = panic::catch_unwind(AssertUnwindSafe(|| self.do_task(task)));
        if let Ok(report) = done {
            // The loop may have ended.
            let _ = self.inbox.send(LoopEvent::Message(Message::Done(report)));
        }
    }

    fn do_task(&self, task: Task) -> EffectReport {
        let paths = self.unsaved.paths.as_ref();
        match task {
            Task::SaveScene { name, path, scene, overwrite } => {
                let saved = save_scene(paths, &name, path, &scene, overwrite);
                EffectReport::Saved(name, saved)
            }
            Task::Export(to, content) => {
                EffectReport::Exported(to.path.clone(), export(&to, &content))
            }
            Task::ListPresets(recent) => EffectReport::Presets(list_presets(paths, &recent)),
            Task::Traces(path) => {
                let read = read_traces::traces(&path).map(Arc::new);
                EffectReport::Traces(path, read.map_err(|error| error.to_string()))
            }
            Task::Load(path) => EffectReport::Loaded(
                preset::from_file(&path)
                    .map(|found| (found.name, Box::new(found.scene)))
                    .map_err(|error| error.to_string()),
            ),
        }
    }
}

/// Returns the message about another session found in place of this one.
pub(super) fn of_another(aside: &Path) -> String {
    format!(
        "another workbench has kept its session meanwhile: it is kept as {}, and the list of presets has it",
        aside.display()
    )
}

/// Saves a scene in this file, or without a file as a user preset of this name.
fn save_scene(
    paths: Option<&Paths>,
    name: &str,
    path: Option<PathBuf>,
    scene: &Scene,
    overwrite: bool,
) -> ExportOutcome {
    let existing = OverwritePolicy::replaced(overwrite);
    let saved = match (path, paths) {
        (Some(path), _) => preset::save_file(&path, scene, existing).map(|()| path),
        (None, Some(paths)) => preset::save(paths, name, scene, existing),
        (None, None) => Err(FileError::NoHome),
    };
    written(saved.map(|path| vec![path]))
}

fn written(written: Result<Vec<PathBuf>, FileError>) -> ExportOutcome {
    match written {
        Ok(files) => ExportOutcome::Written(files),
        Err(FileError::Exists(path)) => ExportOutcome::Exists(path),
        Err(error) => ExportOutcome::Failed(error.to_string()),
    }
}

fn export(to: &Destination, content: &Content) -> ExportOutcome {
    let ready =
        atomic::check_regular_file(&to.path).and_then(|()| atomic::make_folder_of(&to.path));
    let written = ready.and_then(|()| {
        to.write(content.text().as_bytes(), &content.scenes(), content.is_complete())
    });
    self::written(written)
}

fn list_presets(paths: Option<&Paths>, opened: &[PathBuf]) -> Vec<PresetEntry> {
    let (presets, unreadable) = preset::list(paths);
    let (parts, wrong_parts) = library::list(paths);
    let wrong_parts = wrong_parts
        .iter()
        .map(|error| PresetEntry::broken("library".to_owned(), error.to_string()));
    // Omit a missing or invalid recent file; loading it reports the error.
    let unsaved = paths.map(|paths| recent::list(&paths.recent_folder())).unwrap_or_default();
    let entry = |found: Preset| PresetEntry {
        origin: found.origin.label(),
        name: found.name,
        scene: found.scene,
        comment: found.comment,
        ..PresetEntry::default()
    };
    let recent = |path: &PathBuf| match session::kept(path) {
        Some(session) => Some(start::entry_of_session(session, paths)),
        None => {
            preset::from_file(path).ok().map(|it| PresetEntry { origin: "recent", ..entry(it) })
        }
    };
    presets
        .into_iter()
        .map(entry)
        .chain(unsaved.iter().chain(opened).filter_map(recent))
        .chain(parts.into_iter().map(PresetEntry::of_part))
        .chain(unreadable.into_iter().map(|it| PresetEntry::broken(it.0, it.1.to_string())))
        .chain(wrong_parts)
        .collect()
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;
    use cmra_engine::model::scene::PlateSize;

    /// Limit after which a test is considered to hang.
    const HANG: Duration = Duration::from_secs(120);

    fn started(delay: Duration) -> (tempfile::TempDir, Paths, IoThread, Receiver<LoopEvent>) {
        let place = tempfile::tempdir().unwrap();
        let paths = Paths::below(place.path());
        let (send, receive) = mpsc::channel();
        let io_thread =
            IoThread::spawn(Some(paths.clone()), SessionFingerprint::default(), delay, send)
                .unwrap();
        (place, paths, io_thread, receive)
    }

    fn report(inbox: &Receiver<LoopEvent>) -> EffectReport {
        loop {
            let incoming = inbox.recv_timeout(HANG).expect("a report in time");
            if let LoopEvent::Message(Message::Done(report)) = incoming {
                return report;
            }
        }
    }

    fn session_of(mass_ratio: f64) -> Session {
        let mut session = Session::default();
        session.scene.plate.size = PlateSize::Ratio(mass_ratio);
        session
    }

    #[test]
    fn an_export_makes_its_folder() {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("new/deep/a.csv");
        let to = Destination { path: path.clone(), existing: OverwritePolicy::Keep };
        let exported = export(&to, &Content::Text("1\n".to_owned()));
        assert!(matches!(exported, ExportOutcome::Written(files) if files == [path.clone()]));
        assert_eq!(fs::read_to_string(path).unwrap(), "1\n");
    }

    /// Killed programs leave their temporary files in each folder of the workbench.
    #[test]
    fn temporary_files_of_killed_programs_go_at_the_start() {
        let place = tempfile::tempdir().unwrap();
        let paths = Paths::below(place.path());
        let folders = [paths.state.clone(), paths.recent_folder(), paths.presets.clone()];
        for folder in &folders {
            fs::create_dir_all(folder).unwrap();
            fs::write(folder.join(".cmra-killed.tmp"), "1").unwrap();
        }
        let (send, inbox) = mpsc::channel();
        let known = SessionFingerprint::default();
        let io_thread = IoThread::spawn(Some(paths), known, Duration::ZERO, send).unwrap();
        // The answer comes after the start.
        io_thread.ask(Task::ListPresets(Vec::new()));
        report(&inbox);
        for folder in folders {
            assert!(!folder.join(".cmra-killed.tmp").exists(), "{folder:?}");
        }
    }

    #[test]
    fn a_session_that_cannot_be_kept_is_reported_once() {
        let (place, paths, io_thread, inbox) = started(Duration::ZERO);
        // A file is at the place of the folder.
        let state = paths.state.clone();
        fs::create_dir_all(state.parent().unwrap()).unwrap();
        fs::write(&state, "").unwrap();
        let outcome = || match report(&inbox) {
            EffectReport::Session(saved) => saved,
            other => panic!("{other:?}"),
        };
        io_thread.session_changed(session_of(2.0));
        let why = outcome().unwrap_err();
        assert!(why.contains("cannot write"), "{why}");
        io_thread.session_changed(session_of(3.0));
        // Saving is repeated before the next request, without a message.
        io_thread.ask(Task::ListPresets(Vec::new()));
        assert!(matches!(report(&inbox), EffectReport::Presets(_)));
        fs::remove_file(&state).unwrap();
        io_thread.session_changed(session_of(4.0));
        assert_eq!(outcome(), Ok(()));
        drop(place);
    }

    #[test]
    fn a_session_that_changes_often_is_saved_once() {
        let (_place, paths, io_thread, inbox) = started(Duration::from_secs(1_000_000));
        io_thread.session_changed(session_of(2.0));
        // The answer comes after the change was handled.
        io_thread.ask(Task::ListPresets(Vec::new()));
        report(&inbox);
        assert!(!paths.session_file().exists());
        io_thread.session_changed(session_of(3.0));
        io_thread.finish(HANG, false).unwrap();
        assert_eq!(session::load(&paths.session_file()).session, Some(session_of(3.0)));
    }

    /// Another workbench that was stopped while saving holds the lock forever.
    #[test]
    fn a_forced_end_saves_beside_a_lock_that_another_holds() {
        for saves_already in [false, true] {
            let delay = if saves_already { Duration::ZERO } else { HANG };
            let (_place, paths, io_thread, _inbox) = started(delay);
            fs::create_dir_all(&paths.state).unwrap();
            let lock = fs::File::create(paths.session_file().with_extension("lock")).unwrap();
            lock.lock().unwrap();
            io_thread.session_changed(session_of(2.0));
            // The saving thread holds the fingerprint while it waits for the lock.
            while saves_already && io_thread.unsaved.known.try_lock().is_ok() {
                thread::yield_now();
            }
            assert_eq!(io_thread.finish(HANG, true), Ok(None));
            assert_eq!(session::load(&paths.session_file()).session, Some(session_of(2.0)));
            // So does the thread that ends the process.
            io_thread.session_changed(session_of(3.0));
            let saved = io_thread.unsaved().save_at_once(HANG);
            assert!(!matches!(saved, Some(Err(_))), "{saved:?}");
            assert_eq!(session::load(&paths.session_file()).session, Some(session_of(3.0)));
        }
    }

    #[test]
    fn a_preset_is_not_replaced_without_consent() {
        let (_place, paths, io_thread, inbox) = started(Duration::ZERO);
        let ask = |overwrite| {
            io_thread.ask(Task::SaveScene {
                name: "mine".to_owned(),
                path: None,
                scene: Box::default(),
                overwrite,
            });
        };
        ask(false);
        let file = paths.preset_file("mine");
        let saved = || match report(&inbox) {
            EffectReport::Saved(name, outcome) if name == "mine" => outcome,
            other => panic!("{other:?}"),
        };
        assert_eq!(saved(), ExportOutcome::Written(vec![file.clone()]));
        ask(false);
        assert_eq!(saved(), ExportOutcome::Exists(file.clone()));
        ask(true);
        assert_eq!(saved(), ExportOutcome::Written(vec![file]));
        io_thread.ask(Task::ListPresets(Vec::new()));
        let EffectReport::Presets(presets) = report(&inbox) else {
            panic!("not a list");
        };
        let mine = presets.iter().find(|entry| entry.name == "mine").unwrap();
        assert_eq!(mine.origin, "mine");
    }
}
