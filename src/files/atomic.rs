//! Files written whole or not at all, and never over another file unless that is asked for.
//!
//! New content goes to a temporary file in the target's own directory, is flushed to the disk, and takes the target's name in one
//! step. Several files that belong together all get their names, or none does.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

use tempfile::NamedTempFile;

use crate::files::error::FileError;

/// How the names of temporary files begin and end.
const PREFIX: &str = ".cmra-";
const SUFFIX: &str = ".tmp";

/// What to do about a file that is there already.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Existing {
    /// Leave it alone and report it.
    Keep,
    /// Replace it.
    Replace,
}

/// Write one file.
///
/// # Errors
/// [`FileError::Exists`] or [`FileError::Write`]; nothing is left behind then.
pub fn write(path: &Path, content: &[u8], existing: Existing) -> Result<(), FileError> {
    write_all(&[(path.to_owned(), content)], existing)
}

/// Whether a file could be written here now: its name is free or may be replaced, and its directory takes files. Nothing is left
/// behind.
///
/// # Errors
/// As [`write()`].
pub fn check(path: &Path, existing: Existing) -> Result<(), FileError> {
    prepare(path, b"", existing).map(drop)
}

/// Whether nothing but an ordinary file is or would be here: a device or a pipe may be waited for without end, or be the very
/// terminal that is drawn on.
///
/// # Errors
/// [`FileError::Special`].
pub fn ordinary(path: &Path) -> Result<(), FileError> {
    match fs::metadata(path) {
        Ok(found) if !found.is_file() && !found.is_dir() => {
            Err(FileError::Special { path: path.to_owned() })
        }
        Ok(_) | Err(_) => Ok(()),
    }
}

/// Write files that belong together: all, or none.
///
/// # Errors
/// [`FileError::Exists`] or [`FileError::Write`]; nothing is left behind then.
pub fn write_all(files: &[(PathBuf, &[u8])], existing: Existing) -> Result<(), FileError> {
    let mut ready = Vec::new();
    for (path, content) in files {
        ready.push(prepare(path, content, existing)?);
    }
    let mut named: Vec<PathBuf> = Vec::new();
    for file in ready {
        let path = file.target.clone();
        if let Err(error) = file.finish(existing) {
            // Only files that were not there before are taken back: a replaced one cannot be.
            if existing == Existing::Keep {
                for path in &named {
                    let _ = fs::remove_file(path);
                }
            }
            return Err(error);
        }
        named.push(path);
    }
    Ok(())
}

/// Take away the temporary files that a program killed in the middle of writing has left in a directory of this program's own.
/// Younger ones are left alone: another program may be about to name them.
pub fn clear_leftovers(directory: &Path, younger: Duration) {
    let Ok(entries) = fs::read_dir(directory) else { return };
    for entry in entries.flatten() {
        let name = entry.file_name();
        let name = name.to_string_lossy();
        if !(name.starts_with(PREFIX) && name.ends_with(SUFFIX)) {
            continue;
        }
        let modified = entry.metadata().ok().filter(fs::Metadata::is_file);
        let age = modified.and_then(|found| found.modified().ok()?.elapsed().ok());
        if age.is_some_and(|age| age >= younger) {
            // Where it cannot be taken away it does no harm.
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// A file that grows piece by piece and takes its name when it is finished; until then it is a temporary one beside it.
pub struct Growing {
    path: PathBuf,
    ready: Ready<'static>,
    device: Option<File>,
}

impl Growing {
    /// Begin.
    ///
    /// # Errors
    /// [`FileError::Exists`] or [`FileError::Write`].
    pub fn begin(path: &Path, existing: Existing) -> Result<Self, FileError> {
        let ready = prepare(path, b"", existing)?;
        let device = match &ready.place {
            Place::Beside(_) => None,
            Place::Direct(_) => {
                let opened = OpenOptions::new().write(true).open(&ready.target);
                Some(opened.map_err(|source| FileError::write(path, source))?)
            }
        };
        Ok(Self { path: path.to_owned(), ready, device })
    }

    /// Add a piece.
    ///
    /// # Errors
    /// [`FileError::Write`].
    pub fn add(&mut self, content: &[u8]) -> Result<(), FileError> {
        let written = match (&mut self.device, &mut self.ready.place) {
            (Some(device), _) => device.write_all(content),
            (None, Place::Beside(file)) => file.write_all(content),
            (None, Place::Direct(_)) => Ok(()),
        };
        written.map_err(|source| FileError::write(&self.path, source))
    }

    /// Give it its name.
    ///
    /// # Errors
    /// [`FileError::Exists`] when another file has taken the name meanwhile, or [`FileError::Write`].
    pub fn finish(self, existing: Existing) -> Result<(), FileError> {
        if let Place::Beside(file) = &self.ready.place {
            file.as_file().sync_all().map_err(|source| FileError::write(&self.path, source))?;
        }
        self.ready.finish(existing)
    }
}

/// Content that waits for its name.
struct Ready<'c> {
    target: PathBuf,
    place: Place<'c>,
}

enum Place<'c> {
    /// An ordinary file: a temporary one beside it.
    Beside(NamedTempFile),
    /// A device or pipe such as `/dev/stdout`: it cannot be replaced, only written to.
    Direct(&'c [u8]),
}

fn prepare<'c>(path: &Path, content: &'c [u8], existing: Existing) -> Result<Ready<'c>, FileError> {
    // A link stays a link: what it points to is replaced.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let failed = |source| FileError::write(path, source);
    let found = fs::metadata(&target).ok();
    if found.as_ref().is_some_and(fs::Metadata::is_dir) {
        return Err(failed(io::Error::from(io::ErrorKind::IsADirectory)));
    }
    if found.as_ref().is_some_and(|found| !found.is_file()) {
        return Ok(Ready { target, place: Place::Direct(content) });
    }
    if existing == Existing::Keep && fs::symlink_metadata(&target).is_ok() {
        return Err(FileError::Exists(path.to_owned()));
    }
    let directory = directory_of(&target);
    let mut builder = tempfile::Builder::new();
    builder.prefix(PREFIX).suffix(SUFFIX);
    match found {
        Some(found) => {
            builder.permissions(found.permissions());
        }
        None => usual_permissions(&mut builder),
    }
    let mut file = builder.tempfile_in(directory).map_err(failed)?;
    file.write_all(content).map_err(failed)?;
    file.as_file().sync_all().map_err(failed)?;
    Ok(Ready { target, place: Place::Beside(file) })
}

impl Ready<'_> {
    fn finish(self, existing: Existing) -> Result<(), FileError> {
        let target = self.target;
        let outcome = match self.place {
            Place::Direct(content) => OpenOptions::new()
                .write(true)
                .open(&target)
                .and_then(|mut file| file.write_all(content)),
            Place::Beside(file) => match existing {
                Existing::Keep => file.persist_noclobber(&target),
                Existing::Replace => file.persist(&target),
            }
            .map_err(|error| error.error)
            .map(|_file| sync_directory(&target)),
        };
        outcome.map_err(|source| match source.kind() {
            io::ErrorKind::AlreadyExists => FileError::Exists(target.clone()),
            _ => FileError::write(&target, source),
        })
    }
}

/// The new name itself reaches the disk only with its directory. Not every file system can do this, and the content is safe
/// either way, so a refusal is not an error.
fn sync_directory(target: &Path) {
    if let Ok(directory) = File::open(directory_of(target)) {
        let _ = directory.sync_all();
    }
}

fn directory_of(target: &Path) -> &Path {
    match target.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

/// The permissions of any new file: of these the system takes away what the user's mask says.
#[cfg(unix)]
fn usual_permissions(builder: &mut tempfile::Builder<'_, '_>) {
    use std::os::unix::fs::PermissionsExt as _;
    builder.permissions(fs::Permissions::from_mode(0o666));
}

#[cfg(not(unix))]
fn usual_permissions(_builder: &mut tempfile::Builder<'_, '_>) {}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(directory: &Path) -> Vec<String> {
        let mut names: Vec<String> = fs::read_dir(directory)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    }

    #[test]
    fn an_existing_file_is_kept_unless_it_may_be_replaced() {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("a.csv");
        write(&path, b"one", Existing::Keep).unwrap();
        let refused = write(&path, b"two", Existing::Keep).unwrap_err();
        assert!(matches!(refused, FileError::Exists(_)), "{refused}");
        assert_eq!(fs::read(&path).unwrap(), b"one");
        write(&path, b"two", Existing::Replace).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"two");
        assert_eq!(names(place.path()), ["a.csv"]);
    }

    #[test]
    fn all_files_are_written_or_none() {
        let place = tempfile::tempdir().unwrap();
        let (first, second) = (place.path().join("a.csv"), place.path().join("a.toml"));
        fs::write(&second, "mine").unwrap();
        let files: [(PathBuf, &[u8]); 2] = [(first.clone(), b"1"), (second.clone(), b"2")];
        assert!(write_all(&files, Existing::Keep).is_err());
        assert_eq!(names(place.path()), ["a.toml"]);
        assert_eq!(fs::read(&second).unwrap(), b"mine");
    }

    #[test]
    fn a_growing_file_has_its_name_only_when_it_is_finished() {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("a.csv");
        let mut file = Growing::begin(&path, Existing::Keep).unwrap();
        file.add(b"one ").unwrap();
        assert!(!path.exists());
        file.add(b"two").unwrap();
        file.finish(Existing::Keep).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"one two");
        assert!(matches!(Growing::begin(&path, Existing::Keep), Err(FileError::Exists(_))));
        drop(Growing::begin(&path, Existing::Replace).unwrap());
        assert_eq!(fs::read(&path).unwrap(), b"one two");
        assert_eq!(names(place.path()), ["a.csv"]);
    }

    #[test]
    fn what_a_killed_program_left_is_taken_away_and_nothing_else() {
        let place = tempfile::tempdir().unwrap();
        let (left, mine) = (place.path().join(".cmra-Ab12.tmp"), place.path().join("mine.tmp"));
        fs::write(&left, "half a sess").unwrap();
        fs::write(&mine, "1").unwrap();
        fs::create_dir(place.path().join(".cmra-folder.tmp")).unwrap();
        // Another program may be about to name it.
        clear_leftovers(place.path(), Duration::from_secs(3600));
        assert_eq!(names(place.path()), [".cmra-Ab12.tmp", ".cmra-folder.tmp", "mine.tmp"]);
        clear_leftovers(place.path(), Duration::ZERO);
        assert_eq!(names(place.path()), [".cmra-folder.tmp", "mine.tmp"]);
        clear_leftovers(&place.path().join("absent"), Duration::ZERO);
    }

    #[test]
    fn a_directory_is_not_a_target() {
        let place = tempfile::tempdir().unwrap();
        let error = write(place.path(), b"1", Existing::Replace).unwrap_err();
        assert!(error.to_string().contains("directory"), "{error}");
    }

    #[cfg(unix)]
    #[test]
    fn a_link_stays_a_link_and_permissions_stay() {
        use std::os::unix::fs::{PermissionsExt as _, symlink};
        let place = tempfile::tempdir().unwrap();
        let (real, link) = (place.path().join("real"), place.path().join("link"));
        fs::write(&real, "old").unwrap();
        fs::set_permissions(&real, fs::Permissions::from_mode(0o640)).unwrap();
        symlink(&real, &link).unwrap();
        write(&link, b"new", Existing::Replace).unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::read(&real).unwrap(), b"new");
        assert_eq!(fs::metadata(&real).unwrap().permissions().mode() & 0o777, 0o640);
    }
}
