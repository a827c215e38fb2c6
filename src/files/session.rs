//! Session of the workbench, saved between starts.
//!
//! A scene in the file is the text of a scene file, and is read by the same strict reader. An unreadable session is backed up, not deleted;
//! the workbench starts in any case.

use std::collections::HashMap;
use std::collections::hash_map::RandomState;
use std::fs;
use std::hash::{BuildHasher as _, Hasher as _};
use std::path::{Path, PathBuf};

use serde::de::DeserializeOwned;
use serde::{Deserialize, Deserializer, Serialize};

use crate::files::atomic::{self, OverwritePolicy};
use crate::files::error::FileError;
use crate::files::read;
use crate::files::{recent, write};
use cmra_engine::model::scene::Scene;

/// Number of recent files kept.
const RECENT_MAX: usize = 10;

/// Maximum size of a session file, bytes: nine scenes of maximum size, with quotes.
pub(super) const BYTES_MAX: u64 = 32 * read::BYTES_MAX;

/// State of the workbench.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Session {
    /// Scene on the screen.
    pub scene: Scene,
    /// Name or path of the preset that the scene was loaded from.
    pub preset: Option<String>,
    /// Pinned runs: letter or name, and scene. They are computed again at the next start.
    pub pins: Vec<(String, Scene)>,
    /// Settings of the workbench.
    pub view: View,
    /// Setups of the tabs.
    pub setup: Setup,
    /// Scene files opened or saved, newest first.
    pub recent: Vec<PathBuf>,
}

/// Settings of the workbench that the user has changed.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct View {
    /// Word of the character set.
    #[serde(deserialize_with = "value_or_none")]
    pub glyphs: Option<String>,
    /// Word of the number of colours.
    #[serde(deserialize_with = "value_or_none")]
    pub colours: Option<String>,
}

/// Setups of the tabs, as far as a scene does not contain them.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Setup {
    /// Setup of Explore.
    #[serde(deserialize_with = "value_or_none")]
    pub explore: Option<Explore>,
    /// Setup of Search.
    #[serde(deserialize_with = "value_or_none")]
    pub search: Option<Search>,
}

/// View of the sweep in Explore.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Explore {
    /// Map if `true`, else curves.
    pub is_map: bool,
    /// Quantity shown.
    pub output: String,
}

/// Setup of the Search tab, independent of the labels of its rows; missing values have their defaults.
#[derive(Clone, Debug, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct Search {
    /// Variable of goal seek, with its range.
    pub seek: String,
    /// Goal of goal seek.
    pub goal: String,
    /// Variables of a front, and whether each is varied; empty for the default selection.
    pub bounds: Vec<(String, bool)>,
    /// Objectives of a front.
    pub minimise: Option<Vec<String>>,
    /// Constraints of a front.
    pub subject_to: Option<Vec<String>>,
    /// Whether only feasible designs count.
    pub feasible: Option<bool>,
    /// Number of designs of a front.
    pub designs: Option<usize>,
    /// Quantity of the sensitivity study.
    pub affected: String,
    /// Quantity of the Monte Carlo study.
    pub output: String,
    /// Standard deviation of every input, percent.
    pub percent: Option<f64>,
    /// Number of samples.
    pub samples: Option<usize>,
}

/// Result of loading the last session.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Loaded {
    /// Session, or its readable part; `None` to start with the baseline.
    pub session: Option<Session>,
    /// Error and path of the file, for the message row and the log.
    pub notice: Option<String>,
    /// Fingerprint of the file.
    pub known: SessionFingerprint,
}

/// Adds a scene file to the recent files.
pub fn note_recent(recent: &mut Vec<PathBuf>, path: PathBuf) {
    recent.retain(|known| *known != path);
    recent.insert(0, path);
    recent.truncate(RECENT_MAX);
}

/// Contents of the session file. Unknown keys, as of a newer version, are ignored.
#[derive(Serialize, Deserialize)]
struct SessionFile {
    format: i64,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    preset: Option<String>,
    #[serde(default)]
    recent: Vec<String>,
    scene: String,
    #[serde(default)]
    view: View,
    #[serde(default)]
    setup: Setup,
    #[serde(default)]
    pin: Vec<PinRow>,
}

/// Deserialises a value; `None` if it is invalid, so that the rest of the session is kept.
fn value_or_none<'de, D: Deserializer<'de>, T: DeserializeOwned>(
    file: D,
) -> Result<Option<T>, D::Error> {
    Ok(toml::Value::deserialize(file)?.try_into().ok())
}

#[derive(Serialize, Deserialize)]
struct PinRow {
    name: String,
    scene: String,
}

/// Fingerprint of the session file, which detects other writers.
#[derive(Clone, Debug, PartialEq)]
pub struct SessionFingerprint {
    /// Last content read or written, without the first line.
    body: Option<String>,
    /// Random name of this workbench, for the first line of the file. Process numbers repeat, over time and between containers.
    writer: String,
    /// Path and last text of the saved session of each other workbench.
    kept: HashMap<String, (PathBuf, String)>,
}

impl Default for SessionFingerprint {
    fn default() -> Self {
        let writer = format!("{:016x}", RandomState::new().build_hasher().finish());
        Self { body: None, writer, kept: HashMap::new() }
    }
}

/// Text before the name of the workbench in the first line.
const WRITER: &str = ", workbench ";

/// Returns the name of the workbench in the first line, and the rest of the session.
fn parts(text: &str) -> (&str, &str) {
    let (first, body) = text.split_once('\n').unwrap_or(("", text));
    (first.split_once(WRITER).map_or("", |(_, writer)| writer), body)
}

/// Saves the session atomically.
///
/// If another workbench has written the file since `known`, its session is first saved among the recent ones, replacing an earlier one of
/// the same workbench; its path is returned. `may_wait` returns `false` to stop waiting for another workbench that is saving.
pub fn save(
    path: &Path,
    session: &Session,
    known: &mut SessionFingerprint,
    may_wait: &dyn Fn() -> bool,
) -> Result<Option<PathBuf>, FileError> {
    atomic::make_folder_of(path)?;
    // Without the lock, another workbench could write between the reading and the writing below, and its session would be lost.
    let _lock = atomic::wait_for_lock(&path.with_extension("lock"), may_wait);
    let body = body(path, session)?;
    let there = read::text_file(path, BYTES_MAX).ok();
    if known.body.as_ref() == Some(&body) && there.is_some() {
        return Ok(None);
    }
    let other = there.filter(|there| known.body.as_deref() != Some(parts(there).1));
    let mut aside = None;
    if let Some(there) = other
        && parse(&there).0.is_some()
    {
        let ((writer, body), folder) = (parts(&there), path.with_file_name("recent"));
        let before = known.kept.get(writer).map(|(path, body)| (path.as_path(), body.as_str()));
        // Workbenches without a name cannot be distinguished.
        let before = before.filter(|_| !writer.is_empty());
        let place = recent::keep(&folder, body, before)?;
        known.kept.insert(writer.to_owned(), (place.clone(), body.to_owned()));
        aside = Some(place);
    }
    let (version, writer) = (env!("CARGO_PKG_VERSION"), &known.writer);
    let text = format!("# the last session of cmra {version}{WRITER}{writer}\n{body}");
    atomic::write(path, text.as_bytes(), OverwritePolicy::Replace)?;
    known.body = Some(body);
    Ok(aside)
}

/// Saves a session among the recent ones and returns its path.
pub fn keep(folder: &Path, session: &Session) -> Result<PathBuf, FileError> {
    recent::keep(folder, &body(folder, session)?, None)
}

/// Loads a session from the recent ones; `None` if the file is not a session.
pub fn kept(path: &Path) -> Option<Session> {
    let text = read::text_file(path, BYTES_MAX).ok()?;
    parse(&text).0
}

/// Returns the text of the scene in a session; `None` if the text is not a session.
pub(super) fn scene_in(text: &str) -> Option<String> {
    toml::from_str(text).ok().map(|file: SessionFile| file.scene)
}

fn body(path: &Path, session: &Session) -> Result<String, FileError> {
    let file = SessionFile {
        format: read::FORMAT,
        preset: session.preset.clone(),
        recent: session.recent.iter().filter_map(|path| path.to_str().map(str::to_owned)).collect(),
        scene: write::fresh(&session.scene),
        view: session.view.clone(),
        setup: session.setup.clone(),
        pin: session
            .pins
            .iter()
            .map(|(name, scene)| PinRow { name: name.clone(), scene: write::fresh(scene) })
            .collect(),
    };
    toml::to_string_pretty(&file).map_err(|error| FileError::target(path, &error.to_string()))
}

/// Loads the last session, if there is one. A damaged file is backed up with the suffix `.broken`; its readable part is loaded.
pub fn load(path: &Path) -> Loaded {
    if fs::symlink_metadata(path).is_err() {
        return Loaded::default();
    }
    let (text, (session, problems)) = match read::text_file(path, BYTES_MAX) {
        Ok(text) => {
            let parsed = parse(&text);
            (Some(text), parsed)
        }
        Err(error) => (None, (None, vec![error.to_string()])),
    };
    let notice = (!problems.is_empty()).then(|| {
        let aside = atomic::with_end(path, ".broken");
        let kept = match fs::rename(path, &aside) {
            Ok(()) => format!("it was kept as `{}`", aside.display()),
            Err(error) => format!("and it could not be backed up: {error}"),
        };
        let lost = if session.is_some() {
            "the last session is damaged"
        } else {
            "the last session cannot be read; starting with the baseline"
        };
        format!("{lost}; {kept}: {}", problems.join("; "))
    });
    // A session that was backed up no longer exists under its name.
    let body = text.filter(|_| notice.is_none()).map(|text| parts(&text).1.to_owned());
    let known = SessionFingerprint { body, ..SessionFingerprint::default() };
    Loaded { session, notice, known }
}

/// Returns the readable part of a session, and the errors.
fn parse(text: &str) -> (Option<Session>, Vec<String>) {
    let file: SessionFile = match toml::from_str(text) {
        Ok(file) => file,
        Err(error) => return (None, vec![error.message().to_owned()]),
    };
    if file.format != read::FORMAT {
        let (own, known) = (file.format, read::FORMAT);
        let problem = format!("format = {own} is not supported: this program reads format {known}");
        return (None, vec![problem]);
    }
    let mut problems = Vec::new();
    let mut pins = Vec::new();
    for pin in file.pin {
        match read::scene(&pin.scene, &format!("pin {}", pin.name)) {
            Ok(scene) => pins.push((pin.name, scene)),
            Err(error) => problems.push(error.to_string()),
        }
    }
    match read::scene(&file.scene, "scene") {
        Ok(scene) => {
            let session = Session {
                scene,
                preset: file.preset,
                pins,
                view: file.view,
                setup: file.setup,
                recent: file.recent.into_iter().map(PathBuf::from).collect(),
            };
            (Some(session), problems)
        }
        Err(error) => {
            problems.insert(0, error.to_string());
            (None, problems)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cmra_engine::model::scene::PlateSize;

    /// A session with this mass ratio.
    fn session(ratio: f64) -> Session {
        let mut session = Session::default();
        session.scene.plate.size = PlateSize::Ratio(ratio);
        session.scene.notes = "two\nlines and ''' quotes".to_owned();
        session.preset = Some("cocked".to_owned());
        session.pins.push(("A".to_owned(), Scene::default()));
        session.view.glyphs = Some("ascii".to_owned());
        session.setup.search =
            Some(Search { goal: "stroke_m=0.6".to_owned(), ..Search::default() });
        note_recent(&mut session.recent, PathBuf::from("/somewhere/a.toml"));
        session
    }

    fn example() -> Session {
        session(0.1 + 0.2)
    }

    /// A folder, and the path of a session in it.
    fn place() -> (tempfile::TempDir, PathBuf) {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("session.toml");
        (place, path)
    }

    /// The session of the example in a folder, and its text.
    fn saved() -> (tempfile::TempDir, PathBuf, String) {
        let (place, path) = place();
        save(&path, &example(), &mut SessionFingerprint::default(), &|| true).unwrap();
        let text = fs::read_to_string(&path).unwrap();
        (place, path, text)
    }

    /// The mass ratio of a kept scene.
    fn ratio_in(path: impl AsRef<Path>) -> f64 {
        kept(path.as_ref()).unwrap().scene.mass_ratio()
    }

    #[test]
    fn the_scene_of_another_workbench_is_kept() {
        let (place, path) = place();
        let count = || recent::list(&place.path().join("recent")).len();
        save(&path, &session(1.0), &mut SessionFingerprint::default(), &|| true).unwrap();
        let (mut first, mut second) = (load(&path).known, load(&path).known);
        // The second one saves; the first one has done nothing since and leaves.
        assert_eq!(save(&path, &session(2.0), &mut second, &|| true).unwrap(), None);
        assert_eq!(save(&path, &session(1.0), &mut first, &|| true).unwrap(), None);
        assert_eq!((load(&path).session, count()), (Some(session(2.0)), 0));
        // It goes on working.
        let aside = save(&path, &session(3.0), &mut first, &|| true).unwrap().unwrap();
        assert_eq!(kept(&aside), Some(session(2.0)));
        assert_eq!((load(&path).session, count()), (Some(session(3.0)), 1));
        // Someone took the file away: it is written again.
        fs::remove_file(&path).unwrap();
        assert_eq!(save(&path, &session(3.0), &mut first, &|| true).unwrap(), None);
        assert_eq!(load(&path).session, Some(session(3.0)));
    }

    /// A workbench that runs beside another keeps its last scene and removes no older ones.
    #[test]
    fn two_that_work_in_turn_leave_older_scenes_where_they_are() {
        let (place, path) = place();
        let folder = place.path().join("recent");
        keep(&folder, &session(0.5)).unwrap();
        let known =
            |writer: &str| SessionFingerprint { writer: writer.to_owned(), ..load(&path).known };
        let mut first = known("1");
        save(&path, &session(1.0), &mut first, &|| true).unwrap();
        let mut second = known("2");
        for turn in 1..10 {
            save(&path, &session(10.0 + f64::from(turn)), &mut second, &|| true).unwrap();
            save(&path, &session(20.0 + f64::from(turn)), &mut first, &|| true).unwrap();
        }
        let mut kept: Vec<f64> = recent::list(&folder).into_iter().map(ratio_in).collect();
        kept.sort_by(f64::total_cmp);
        assert_eq!(kept, [0.5, 19.0, 28.0]);
    }

    /// Two containers that share a home directory may both have a process 1.
    #[test]
    fn workbenches_with_one_process_number_are_told_apart() {
        let (place, path) = place();
        let [mut first, mut second, mut third] = [(); 3].map(|()| SessionFingerprint::default());
        save(&path, &session(1.0), &mut first, &|| true).unwrap();
        save(&path, &session(2.0), &mut second, &|| true).unwrap();
        save(&path, &session(3.0), &mut first, &|| true).unwrap();
        save(&path, &session(4.0), &mut third, &|| true).unwrap();
        save(&path, &session(5.0), &mut first, &|| true).unwrap();
        let folder = place.path().join("recent");
        let mut kept: Vec<f64> = recent::list(&folder).into_iter().map(ratio_in).collect();
        kept.sort_by(f64::total_cmp);
        assert_eq!(kept, [1.0, 2.0, 3.0, 4.0]);
    }

    /// Each round, two that began on the same session save at the same moment: one of them is kept aside.
    #[test]
    fn two_that_save_at_once_are_both_kept() {
        for round in 0..40 {
            let (place, path, _) = saved();
            let known = load(&path).known;
            let barrier = std::sync::Barrier::new(2);
            std::thread::scope(|scope| {
                for ratio in [2.0, 3.0] {
                    let (mut known, barrier, path) = (known.clone(), &barrier, &path);
                    scope.spawn(move || {
                        barrier.wait();
                        save(path, &session(ratio), &mut known, &|| true).unwrap();
                    });
                }
            });
            let here = load(&path).session.unwrap().scene.mass_ratio();
            let both = here + ratio_in(place.path().join("recent/unsaved-1.toml"));
            assert!((both - 5.0).abs() < 1e-12, "round {round}: one of them is lost");
        }
    }

    #[test]
    fn a_session_of_nine_great_scenes_comes_back() {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("state/session.toml");
        let none = load(&path);
        assert_eq!((none.session, none.notice, none.known.body), (None, None, None));
        let mut session = example();
        session.scene.notes = session.scene.notes.repeat(40_000);
        session.pins = ["A", "B", "C", "D", "E", "F", "G", "H"]
            .map(|letter| (letter.to_owned(), session.scene.clone()))
            .to_vec();
        save(&path, &session, &mut SessionFingerprint::default(), &|| true).unwrap();
        assert!(fs::metadata(&path).unwrap().len() > 7 * read::BYTES_MAX);
        let loaded = load(&path);
        assert_eq!(loaded.notice, None);
        assert_eq!(loaded.session, Some(session));
    }

    #[test]
    fn a_broken_session_is_put_aside() {
        let (place, path) = place();
        fs::write(&path, "format = 1\nscene = 3\n").unwrap();
        let loaded = load(&path);
        assert_eq!(loaded.session, None);
        let notice = loaded.notice.unwrap();
        assert!(notice.contains("session.toml.broken"), "{notice}");
        assert!(!path.exists());
        let broken = place.path().join("session.toml.broken");
        assert!(fs::read_to_string(broken).unwrap().contains("scene = 3"));
    }

    #[test]
    fn a_damaged_pin_does_not_cost_the_scene() {
        let (_place, path, text) = saved();
        // The pin's own scene is the last one.
        let at = text.rfind("mass_kg").unwrap();
        fs::write(&path, format!("{}mass_lb{}", &text[..at], &text[at + 7..])).unwrap();
        let loaded = load(&path);
        let session = loaded.session.unwrap();
        assert_eq!(session.scene, example().scene);
        assert_eq!(session.pins, []);
        assert!(loaded.notice.unwrap().contains("mass_lb"));
    }

    #[test]
    fn a_setup_that_means_nothing_costs_nothing_else() {
        let (_place, path, text) = saved();
        for wrong in ["[view]\nlater = 3\nthreads = \"x\"\n", "[setup]\nlater = 3\nexplore = 7\n"] {
            let table = &wrong[..=wrong.find('\n').unwrap()];
            let text = if text.contains(table) { text.clone() } else { format!("{text}\n{table}") };
            fs::write(&path, text.replacen(table, wrong, 1)).unwrap();
            let loaded = load(&path);
            assert_eq!((loaded.session, loaded.notice), (Some(example()), None), "{wrong}");
        }
    }
}
