//! The session: what the workbench had open, kept between starts so that nothing is lost by leaving.
//!
//! A scene inside the file is kept as the text of a scene file and read by the same strict reader. A session that cannot be
//! read is put aside, never deleted, and never keeps the program from starting.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::files::atomic::{self, Existing};
use crate::files::error::FileError;
use crate::files::{read, write};
use crate::model::scene::Scene;

/// How many recent files are kept.
const RECENT_MAX: usize = 10;

/// What the workbench had open.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Session {
    /// The scene on the screen.
    pub scene: Scene,
    /// Name or path of the preset it came from.
    pub preset: Option<String>,
    /// Pinned runs: letter or name, and scene. They are computed again.
    pub pins: Vec<(String, Scene)>,
    /// How things were shown (`glyphs`, `theme`, `window`, ...), in words the workbench chooses.
    pub view: BTreeMap<String, String>,
    /// Scene files opened or saved, newest first.
    pub recent: Vec<PathBuf>,
}

/// What was found of the last session.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Loaded {
    /// The session, or what could be read of it; `None`: start with the baseline.
    pub session: Option<Session>,
    /// What went wrong, and where the file was put, for the message row and the log.
    pub notice: Option<String>,
}

impl Session {
    /// Note that a scene file was opened or saved.
    pub fn note_recent(&mut self, path: &Path) {
        self.recent.retain(|known| known != path);
        self.recent.insert(0, path.to_owned());
        self.recent.truncate(RECENT_MAX);
    }
}

/// The file as it is written. Unknown keys are ignored: a newer program may have left them.
#[derive(Serialize, Deserialize)]
struct SessionFile {
    format: i64,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    preset: Option<String>,
    #[serde(default)]
    recent: Vec<String>,
    scene: String,
    #[serde(default)]
    view: BTreeMap<String, String>,
    #[serde(default)]
    pin: Vec<PinRow>,
}

#[derive(Serialize, Deserialize)]
struct PinRow {
    name: String,
    scene: String,
}

/// Save the session, whole or not at all.
///
/// # Errors
/// [`FileError::Write`].
pub fn save(path: &Path, session: &Session) -> Result<(), FileError> {
    let failed = |text: String| FileError::Target { path: path.to_owned(), problem: text };
    let file = SessionFile {
        format: read::FORMAT,
        preset: session.preset.clone(),
        recent: session.recent.iter().filter_map(|path| path.to_str().map(str::to_owned)).collect(),
        scene: write::fresh(&session.scene),
        view: session.view.clone(),
        pin: session
            .pins
            .iter()
            .map(|(name, scene)| PinRow { name: name.clone(), scene: write::fresh(scene) })
            .collect(),
    };
    let body = toml::to_string_pretty(&file).map_err(|error| failed(error.to_string()))?;
    let version = env!("CARGO_PKG_VERSION");
    let text = format!("# the last session of cmra {version}; written by the program\n{body}");
    if let Some(directory) = path.parent() {
        fs::create_dir_all(directory).map_err(|source| FileError::write(directory, source))?;
    }
    atomic::write(path, text.as_bytes(), Existing::Replace)
}

/// Load the last session, if there is one. A file that is damaged is put aside with the ending `.broken`, and what can be read
/// of it is kept.
pub fn load(path: &Path) -> Loaded {
    if fs::symlink_metadata(path).is_err() {
        return Loaded::default();
    }
    let (session, problems) = match read::text_file(path) {
        Ok(text) => parse(&text),
        Err(error) => (None, vec![error.to_string()]),
    };
    let notice = (!problems.is_empty()).then(|| {
        let mut aside = path.as_os_str().to_owned();
        aside.push(".broken");
        let kept = match fs::rename(path, &aside) {
            Ok(()) => format!("it was kept as `{}`", Path::new(&aside).display()),
            Err(error) => format!("and it could not be put aside: {error}"),
        };
        let lost = if session.is_some() {
            "the last session is damaged"
        } else {
            "the last session cannot be read; starting with the baseline"
        };
        format!("{lost}; {kept}: {}", problems.join("; "))
    });
    Loaded { session, notice }
}

/// Copy a session aside before another one takes its place.
///
/// # Errors
/// [`FileError::Write`].
pub fn put_aside(from: &Path, to: &Path) -> Result<(), FileError> {
    let text = fs::read(from).map_err(|source| FileError::write(to, source))?;
    atomic::write(to, &text, Existing::Replace)
}

/// What can be read of a session, and what cannot.
fn parse(text: &str) -> (Option<Session>, Vec<String>) {
    let file: SessionFile = match toml::from_str(text) {
        Ok(file) => file,
        Err(error) => return (None, vec![error.message().to_owned()]),
    };
    if file.format != read::FORMAT {
        let problem = format!(
            "format = {} is not supported: this program reads format {}",
            file.format,
            read::FORMAT
        );
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

    fn example() -> Session {
        let mut session = Session::default();
        session.scene.plate.mass_ratio = 0.1 + 0.2;
        session.scene.notes = "two\nlines and ''' quotes".to_owned();
        session.preset = Some("cocked".to_owned());
        session.pins.push(("A".to_owned(), Scene::default()));
        session.view.insert("glyphs".to_owned(), "ascii".to_owned());
        session.note_recent(Path::new("/somewhere/a.toml"));
        session
    }

    #[test]
    fn a_session_comes_back_as_it_was() {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("state/session.toml");
        assert_eq!(load(&path), Loaded::default());
        save(&path, &example()).unwrap();
        let loaded = load(&path);
        assert_eq!(loaded.notice, None);
        assert_eq!(loaded.session, Some(example()));
    }

    #[test]
    fn a_broken_session_is_put_aside() {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("session.toml");
        fs::write(&path, "format = 1\nscene = 3\n").unwrap();
        let loaded = load(&path);
        assert_eq!(loaded.session, None);
        let notice = loaded.notice.unwrap();
        assert!(notice.contains("session.toml.broken"), "{notice}");
        assert!(!path.exists());
        assert!(place.path().join("session.toml.broken").exists());
    }

    #[test]
    fn a_damaged_pin_does_not_cost_the_scene() {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("session.toml");
        save(&path, &example()).unwrap();
        let text = fs::read_to_string(&path).unwrap();
        // The pin's own scene is the last one in the file.
        let at = text.rfind("mass_kg").unwrap();
        fs::write(&path, format!("{}mass_lb{}", &text[..at], &text[at + 7..])).unwrap();
        let loaded = load(&path);
        let session = loaded.session.unwrap();
        assert_eq!(session.scene, example().scene);
        assert_eq!(session.pins, []);
        assert!(loaded.notice.unwrap().contains("mass_lb"));
    }

    #[test]
    fn recent_files_are_few_and_newest_first() {
        let mut session = Session::default();
        for number in 0..12 {
            session.note_recent(Path::new(&format!("{number}.toml")));
        }
        session.note_recent(Path::new("5.toml"));
        assert_eq!(session.recent.len(), RECENT_MAX);
        assert_eq!(session.recent[0], Path::new("5.toml"));
        assert_eq!(session.recent[1], Path::new("11.toml"));
    }
}
