//! The last five unsaved sessions, each in its own file; the list of presets shows them as recent.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use crate::files::atomic::{self, OverwritePolicy};
use crate::files::error::FileError;
use crate::files::read;
use crate::files::session::BYTES_MAX;

/// Number of sessions kept.
const KEPT: u32 = 5;

/// Saves the text of a session and returns its path. It replaces, in this order: the same text, the session saved `before`, a free place,
/// the oldest session.
pub fn keep(
    folder: &Path,
    session: &str,
    before: Option<(&Path, &str)>,
) -> Result<PathBuf, FileError> {
    let text_of = |session: &str| format!("# left unsaved\n{session}");
    let text = text_of(session);
    let files = (1..=KEPT).map(|number| folder.join(format!("unsaved-{number}.toml")));
    let files: Vec<PathBuf> = files.collect();
    let has =
        |path: &Path, text: &str| read::text_file(path, BYTES_MAX).is_ok_and(|there| there == text);
    let is_same = |path: &&PathBuf| has(path, &text);
    // Another process can have replaced it.
    let older = || before.filter(|(path, session)| has(path, &text_of(session)));
    let older = || older().and_then(|(path, _)| files.iter().find(|it| *it == path));
    let free = || files.iter().find(|path| fs::symlink_metadata(path).is_err());
    let oldest = || files.iter().min_by_key(|path| modified(path));
    let chosen = files.iter().find(is_same).or_else(older).or_else(free).or_else(oldest);
    let path = chosen.cloned().unwrap_or_else(|| folder.join("unsaved-1.toml"));
    atomic::make_folder_of(&path)?;
    let is_free = fs::symlink_metadata(&path).is_err();
    match atomic::write(&path, text.as_bytes(), OverwritePolicy::replaced(!is_free)) {
        // Another workbench has used the free place meanwhile.
        Err(FileError::Exists(_)) => keep(folder, session, before),
        written => written.map(|()| path),
    }
}

/// Returns the paths of the saved sessions, newest first.
pub fn list(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut files: Vec<PathBuf> = entries
        .map(|entry| entry.path())
        .filter(|path| path.extension().is_some_and(|end| end == "toml"))
        .collect();
    files.sort_by_key(|path| std::cmp::Reverse((modified(path), path.clone())));
    files
}

fn modified(path: &Path) -> Option<SystemTime> {
    fs::symlink_metadata(path).and_then(|found| found.modified()).ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files::preset;
    use crate::files::session::{self, Session};
    use cmra_engine::model::scene::{PlateSize, Scene};

    #[test]
    fn five_sessions_are_kept_and_their_scenes_open_by_their_paths() {
        let place = tempfile::tempdir().unwrap();
        let folder = place.path().join("recent");
        let of = |ratio: f64| {
            let mut scene = Scene::default();
            scene.plate.size = PlateSize::Ratio(ratio);
            scene
        };
        let scene_in = |path: &Path| preset::from_file(path).unwrap().scene;
        for ratio in [1.0, 2.0, 3.0, 4.0, 5.0, 5.0, 6.0] {
            let session = Session { scene: of(ratio), ..Session::default() };
            let path = session::keep(&folder, &session).unwrap();
            assert_eq!(scene_in(&path), of(ratio));
        }
        assert_eq!(list(&folder).len(), 5);
        let kept: Vec<Scene> = list(&folder).iter().map(|path| scene_in(path)).collect();
        assert!((2..=6).all(|ratio| kept.contains(&of(f64::from(ratio)))), "{kept:?}");
    }
}
