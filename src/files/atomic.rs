//! Atomic writing of files; an existing file is replaced only on request.
//!
//! The content is written to a temporary file in the directory of the target, synchronised to the disk, and renamed. For several files that
//! belong together all are on the disk before the first one is renamed. Old ones are moved aside first: a file is never found beside one of
//! another version.

use std::collections::BTreeSet;
use std::ffi::{OsStr, OsString};
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Write};
use std::os::unix::ffi::OsStrExt as _;
use std::os::unix::fs::{FileTypeExt as _, MetadataExt as _, PermissionsExt as _};
use std::path::{Path, PathBuf};

use rustix::event::{Timespec, poll};
use rustix::fs::{Gid, Uid, fchown};
use tempfile::NamedTempFile;

use crate::files::error::FileError;

/// Policy for an existing file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OverwritePolicy {
    /// Keep the file and return an error.
    Keep,
    /// Replace the file.
    Replace,
}

impl OverwritePolicy {
    /// Returns `Replace` if requested, else `Keep`.
    pub fn replaced(is_asked_for: bool) -> Self {
        if is_asked_for { Self::Replace } else { Self::Keep }
    }
}

/// Writes a file.
///
/// # Errors
/// [`FileError::Exists`] or [`FileError::Write`]; no temporary file remains.
pub fn write(path: &Path, content: &[u8], existing: OverwritePolicy) -> Result<(), FileError> {
    let mut file = PartialFile::prepare(path, existing, hidden)?;
    file.add(content)?;
    name_all(vec![file], existing)
}

/// Creates the folder of a file if it is missing.
pub fn make_folder_of(path: &Path) -> Result<(), FileError> {
    let folder = directory_of(path);
    fs::create_dir_all(folder).map_err(|source| FileError::write(folder, source))
}

/// Checks that a file can be written: its name is free or may be replaced, and files can be created in its directory.
pub fn check(path: &Path, existing: OverwritePolicy) -> Result<(), FileError> {
    PartialFile::prepare(path, existing, hidden).map(drop)
}

/// Checks that a path is a regular file or does not exist. Writing to a device or a pipe could block forever, or draw on the terminal.
pub fn check_regular_file(path: &Path) -> Result<(), FileError> {
    match fs::metadata(path) {
        Ok(found) if !found.is_file() && !found.is_dir() => Err(FileError::special(path)),
        Ok(_) | Err(_) => Ok(()),
    }
}

/// Returns `true` for a named pipe, which blocks until another program opens it. Pipes passed by a shell (`<(...)`, `/dev/stdout`) are
/// already open at their other end.
fn is_named_pipe(path: &Path, found: &fs::Metadata) -> bool {
    found.file_type().is_fifo() && !path.starts_with("/dev") && !path.starts_with("/proc")
}

/// Suffix of a file that is moved aside while it is replaced.
const PREVIOUS: &str = ".previous";

/// Renames all temporary files to their targets. The files after the first one belong to it: their old versions are moved aside first. If
/// the process is killed in between, a file can be alone or under the backup name, but never beside one of another version.
fn name_all(ready: Vec<PartialFile>, existing: OverwritePolicy) -> Result<(), FileError> {
    for PartialFile { target, place, .. } in &ready {
        if let WriteTarget::Beside(file) = place {
            let synced = file.as_file().sync_all();
            synced.map_err(|source| FileError::write(target, source))?;
        }
    }
    let mut previous = Vec::new();
    for old in ready.iter().skip(1).filter(|_| existing == OverwritePolicy::Replace) {
        let aside = with_end(&old.target, PREVIOUS);
        // If the old file does not exist or cannot be moved, renaming the new one reports the error.
        if matches!(old.place, WriteTarget::Beside(_)) && fs::rename(&old.target, &aside).is_ok() {
            previous.push((old.target.clone(), aside));
        }
    }
    let mut named: Vec<PathBuf> = Vec::new();
    for file in ready {
        let path = file.target.clone();
        if let Err(error) = file.name(existing) {
            // The old files return to their names if the first rename failed.
            for (path, aside) in previous.iter().filter(|_| named.is_empty()) {
                let _ = fs::rename(aside, path);
            }
            // New files are removed again; a replaced file cannot be restored.
            for path in named.iter().filter(|_| existing == OverwritePolicy::Keep) {
                let _ = fs::remove_file(path);
            }
            return Err(error);
        }
        named.push(path);
    }
    for (_, aside) in previous {
        // A backup that cannot be removed is harmless.
        let _ = fs::remove_file(aside);
    }
    // The directories are synchronised after all renames: a process killed during the synchronisation leaves complete sets. Some file
    // systems do not support it; the content is on the disk in any case.
    for directory in named.iter().map(|path| directory_of(path)).collect::<BTreeSet<_>>() {
        let _ = File::open(directory).and_then(|directory| directory.sync_all());
    }
    Ok(())
}

/// Interval between two attempts to take a lock; a wait with a time limit needs polling, since the system's own wait has none.
const LOCK_EVERY: Timespec = Timespec { tv_sec: 0, tv_nsec: 5_000_000 };
/// Maximum number of attempts to take a lock: 5 s in all.
const LOCK_TRIES: u32 = 1000;

/// Waits for the exclusive lock of a file; it is released when the result is dropped or the process ends.
///
/// Returns `None` if the lock is not available: no support by the file system, a holder that does not release it, or `may_wait` returns
/// `false`. The caller continues without it, since saving is more important than the order of two writers.
pub fn wait_for_lock(path: &Path, may_wait: &dyn Fn() -> bool) -> Option<File> {
    let file = OpenOptions::new().create(true).truncate(false).write(true).open(path).ok()?;
    for _ in 0..LOCK_TRIES {
        if file.try_lock().is_ok() {
            return Some(file);
        }
        if !may_wait() {
            break;
        }
        // A sleep: `poll` without events returns after the time limit.
        let _ = poll(&mut [], Some(&LOCK_EVERY));
    }
    None
}

/// Suffix of an unfinished table.
const PARTIAL: &str = ".partial";

/// Table that is written in parts to `NAME.partial` and renamed when it is complete. After the first part the file remains, even if the
/// process is killed.
pub struct PartialFile {
    /// Path as given.
    path: PathBuf,
    /// Target of the path if it is a symbolic link, else the path.
    target: PathBuf,
    place: WriteTarget,
    /// Length of the complete parts, bytes.
    length: u64,
}

enum WriteTarget {
    Beside(NamedTempFile),
    /// Device or pipe such as `/dev/stdout`, opened at the first write; it cannot be replaced.
    Direct(Option<File>),
}

impl PartialFile {
    /// Starts a table.
    pub fn begin(path: &Path, existing: OverwritePolicy) -> Result<Self, FileError> {
        let mut file = Self::prepare(path, existing, visible)?;
        file.add(b"")?;
        Ok(file)
    }

    fn prepare(
        path: &Path,
        existing: OverwritePolicy,
        temporary: fn(&Path) -> io::Result<NamedTempFile>,
    ) -> Result<Self, FileError> {
        // A symbolic link remains; its target is replaced.
        let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        let failed = |source| FileError::write(path, source);
        let placed = |target, place| Self { path: path.to_owned(), target, place, length: 0 };
        let found = fs::metadata(&target).ok();
        if let Some(found) = &found {
            if found.is_dir() {
                return Err(failed(io::Error::from(io::ErrorKind::IsADirectory)));
            }
            // Nothing reads from the master side of a terminal.
            if is_named_pipe(path, found) || !found.is_file() && target.ends_with("ptmx") {
                return Err(FileError::special(path));
            }
            if !found.is_file() {
                return Ok(placed(target, WriteTarget::Direct(None)));
            }
        }
        let is_there = fs::symlink_metadata(&target).is_ok();
        if found.is_none() && is_there {
            let problem =
                "it is a link to a file that is not there: remove the link, or choose another name";
            return Err(FileError::target(path, problem));
        }
        if existing == OverwritePolicy::Keep && is_there {
            return Err(FileError::Exists(path.to_owned()));
        }
        if found.as_ref().is_some_and(|found| found.permissions().readonly()) {
            let problem = "it is read-only: make it writable, or choose another name";
            return Err(FileError::target(path, problem));
        }
        let file = temporary(&target).map_err(failed)?;
        if let Some(found) = found {
            keep_owner(file.as_file(), &found);
            // Set after creation: the builder would apply the umask again.
            file.as_file().set_permissions(found.permissions()).map_err(failed)?;
        }
        Ok(placed(target, WriteTarget::Beside(file)))
    }

    /// Appends a part.
    pub fn add(&mut self, content: &[u8]) -> Result<(), FileError> {
        let written = match &mut self.place {
            WriteTarget::Beside(file) => file.as_file_mut().write_all(content),
            WriteTarget::Direct(Some(device)) => device.write_all(content),
            WriteTarget::Direct(device) => {
                let opened = OpenOptions::new().write(true).open(&self.target);
                opened.and_then(|file| device.insert(file).write_all(content))
            }
        };
        written.map_err(|source| FileError::write(&self.path, source))?;
        self.length += content.len() as u64;
        if let WriteTarget::Beside(file) = &mut self.place {
            let is_table = file.path().extension().is_none_or(|end| end != "tmp");
            file.disable_cleanup(is_table && self.length > 0);
        }
        Ok(())
    }

    /// Keeps the complete parts of an unfinished table and returns their path; `None` for a device, or without a part.
    pub fn partial(&self) -> Option<PathBuf> {
        match &self.place {
            WriteTarget::Beside(file) if self.length > 0 => {
                // An incomplete last part that cannot be cut off is visible in the file.
                let _ = file.as_file().set_len(self.length);
                let is_link = fs::read_link(&self.path).is_ok();
                let given = if is_link { &self.target } else { &self.path };
                Some(given.with_file_name(file.path().file_name().unwrap_or_default()))
            }
            WriteTarget::Beside(_) | WriteTarget::Direct(_) => None,
        }
    }

    /// Renames the table to its target and writes the files that belong to it.
    ///
    /// # Errors
    /// [`FileError::Exists`] if a target was created meanwhile, or [`FileError::Write`].
    pub fn finish(
        self,
        beside: &[(PathBuf, String)],
        existing: OverwritePolicy,
    ) -> Result<(), FileError> {
        let mut ready = vec![self];
        for (path, content) in beside {
            let mut file = Self::prepare(path, existing, hidden)?;
            file.add(content.as_bytes())?;
            ready.push(file);
        }
        name_all(ready, existing)
    }

    /// Renames the file to its target; does nothing for a device.
    fn name(self, existing: OverwritePolicy) -> Result<(), FileError> {
        let (target, WriteTarget::Beside(file)) = (self.target, self.place) else { return Ok(()) };
        let named = match existing {
            OverwritePolicy::Keep => file.persist_noclobber(&target),
            OverwritePolicy::Replace => file.persist(&target),
        };
        let named = named.map(drop).or_else(|failed| match (existing, failed.error.kind()) {
            (OverwritePolicy::Keep, io::ErrorKind::AlreadyExists) => Err(failed.error),
            (OverwritePolicy::Keep, _) => persist_reserved(failed.file, &target),
            (_, io::ErrorKind::ResourceBusy) => copy_over(failed.file, &target),
            _ => Err(failed.error),
        });
        named.map_err(|error| match error.kind() {
            io::ErrorKind::AlreadyExists => FileError::Exists(target.clone()),
            _ => FileError::write(&target, error),
        })
    }
}

/// Sets the owner of a file to that of the replaced one, as far as permitted.
fn keep_owner(file: &File, replaced: &fs::Metadata) {
    let (uid, gid) = (Uid::from_raw(replaced.uid()), Gid::from_raw(replaced.gid()));
    let own = file.metadata().ok().map(|own| (own.uid(), own.gid()));
    if own != Some((replaced.uid(), replaced.gid())) && fchown(file, Some(uid), Some(gid)).is_err()
    {
        // Only root can change the owner; the group can be one of the user's own.
        let _ = fchown(file, None, Some(gid));
    }
}

/// Prefix and suffix of the name of a temporary file.
const HIDDEN: (&str, &str) = (".cmra-", ".tmp");
/// Maximum number of attempts to create a temporary file that is not removed before it is locked. A file system without link counts uses
/// all of them.
const HIDDEN_TRIES: u32 = 20;

/// Creates a temporary file beside a target. It is locked while the process lives; [`remove_stale`] removes files without a lock.
fn hidden(target: &Path) -> io::Result<NamedTempFile> {
    let directory = directory_of(target);
    remove_stale(directory);
    let made = || builder().prefix(HIDDEN.0).suffix(HIDDEN.1).tempfile_in(directory);
    for _ in 0..HIDDEN_TRIES {
        let file = made()?;
        // Another process can take the file for a stale one before it is locked: then it holds the lock, or has removed the file. On a
        // file system without locks nothing is removed.
        let is_taken = matches!(file.as_file().try_lock(), Err(TryLockError::WouldBlock));
        if !is_taken && file.as_file().metadata()?.nlink() > 0 {
            return Ok(file);
        }
    }
    made()
}

/// Removes temporary files of killed processes.
pub fn remove_stale(directory: &Path) {
    for entry in fs::read_dir(directory).into_iter().flatten().flatten() {
        let (name, path) = (entry.file_name(), entry.path());
        let name = name.to_string_lossy();
        let is_hidden = name.starts_with(HIDDEN.0) && name.ends_with(HIDDEN.1);
        if is_hidden
            && entry.file_type().is_ok_and(|kind| kind.is_file())
            && let Ok(file) = File::open(&path)
            && file.try_lock().is_ok()
        {
            let _ = fs::remove_file(path);
        }
    }
}

/// Creates the file of an unfinished table beside a target: `NAME.partial`, with a number if that exists.
fn visible(target: &Path) -> io::Result<NamedTempFile> {
    for number in 1..10_000 {
        let end = if number > 1 { format!("{PARTIAL}-{number}") } else { PARTIAL.to_owned() };
        let name = fitted(target.file_name().unwrap_or_default(), &end);
        let made = builder().prefix(&name).rand_bytes(0).tempfile_in(directory_of(target));
        if !made.as_ref().is_err_and(|error| error.kind() == io::ErrorKind::AlreadyExists) {
            return made;
        }
    }
    Err(io::ErrorKind::AlreadyExists.into())
}

/// Returns a builder of files with the default permissions, to which the system applies the umask.
fn builder<'n>() -> tempfile::Builder<'n, 'n> {
    let mut builder = tempfile::Builder::new();
    builder.permissions(fs::Permissions::from_mode(0o666));
    builder
}

/// Renames a file to a free name on a file system without atomic no-replace rename and without links, such as FUSE and SMB. An empty file
/// reserves the name first; that fails if the name exists.
fn persist_reserved(file: NamedTempFile, target: &Path) -> io::Result<()> {
    File::create_new(target)?;
    file.persist(target).map(drop).map_err(|failed| {
        let _ = fs::remove_file(target);
        failed.error
    })
}

/// Copies the content into a file that cannot be replaced, such as a bind mount.
fn copy_over(mut file: NamedTempFile, target: &Path) -> io::Result<()> {
    let mut into = OpenOptions::new().write(true).truncate(true).open(target)?;
    io::copy(&mut file.reopen()?, &mut into)?;
    into.sync_all()?;
    file.disable_cleanup(false);
    Ok(())
}

/// Returns a path with a suffix added to its name.
pub(super) fn with_end(path: &Path, end: &str) -> PathBuf {
    path.with_file_name(fitted(path.file_name().unwrap_or_default(), end))
}

/// Maximum length of a file name on usual file systems, bytes.
const NAME_MAX: usize = 255;

/// Adds a suffix to a name, which is shortened to fit into [`NAME_MAX`].
pub(super) fn fitted(name: &OsStr, end: &str) -> OsString {
    let room = NAME_MAX.saturating_sub(end.len());
    let mut fitted = if name.len() <= room {
        name.to_owned()
    } else {
        // Cut between characters if the name is UTF-8.
        let text = String::from_utf8_lossy(name.as_bytes());
        let cut = (0..=room).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0);
        OsString::from(&text[..cut])
    };
    fitted.push(end);
    fitted
}

fn directory_of(target: &Path) -> &Path {
    match target.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

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
    fn all_files_are_written_or_none() {
        let place = tempfile::tempdir().unwrap();
        let (first, second) = (place.path().join("a.csv"), place.path().join("a.toml"));
        fs::write(&second, "mine").unwrap();
        let file = PartialFile::begin(&first, OverwritePolicy::Keep).unwrap();
        assert!(file.finish(&[(second.clone(), "2".to_owned())], OverwritePolicy::Keep).is_err());
        assert_eq!(names(place.path()), ["a.toml"]);
        assert_eq!(fs::read(&second).unwrap(), b"mine");
    }

    #[test]
    fn a_growing_table_can_be_seen_and_is_left_alone() {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("a.csv");
        let begin = || PartialFile::begin(&path, OverwritePolicy::Keep).unwrap();
        let mut first = begin();
        first.add(b"1\n").unwrap();
        let mut second = begin();
        second.add(b"2\n").unwrap();
        // One without a row is nothing to keep.
        drop(begin());
        assert_eq!(names(place.path()), ["a.csv.partial", "a.csv.partial-2"]);
        assert_eq!(first.partial(), Some(place.path().join("a.csv.partial")));
        // As if it had been killed.
        drop(first);
        assert_eq!(fs::read(place.path().join("a.csv.partial")).unwrap(), b"1\n");
        second.finish(&[], OverwritePolicy::Keep).unwrap();
        assert_eq!(names(place.path()), ["a.csv", "a.csv.partial"]);
        assert_eq!(fs::read(&path).unwrap(), b"2\n");
        assert!(matches!(
            PartialFile::begin(&path, OverwritePolicy::Keep),
            Err(FileError::Exists(_))
        ));
    }

    #[test]
    fn a_file_system_that_lacks_something_costs_no_row() {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("a.csv");
        let made = |content: &[u8]| {
            let mut file = visible(&path).unwrap();
            file.write_all(content).unwrap();
            file.disable_cleanup(true);
            file
        };
        // Neither a rename that replaces nothing nor a link.
        persist_reserved(made(b"1"), &path).unwrap();
        let mut file = made(b"2");
        file.disable_cleanup(false);
        let taken = persist_reserved(file, &path).unwrap_err();
        assert_eq!(taken.kind(), io::ErrorKind::AlreadyExists);
        assert_eq!(fs::read(&path).unwrap(), b"1");
        // No rename at all over this one.
        copy_over(made(b"3"), &path).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"3");
        assert_eq!(names(place.path()), ["a.csv"]);
    }

    /// Every name that the file system takes can be written, as a table and as a scene.
    #[test]
    fn the_longest_names_are_written() {
        let place = tempfile::tempdir().unwrap();
        for (stem, end) in
            [("a".repeat(251), ".csv"), ("ö".repeat(125), ".csv"), ("b".repeat(255), "")]
        {
            let path = place.path().join(format!("{stem}{end}"));
            let mut file = PartialFile::begin(&path, OverwritePolicy::Keep).unwrap();
            file.add(b"1").unwrap();
            let beside = crate::files::export::sidecar_path(&path, Some("A"));
            file.finish(&[(beside.clone(), "2".to_owned())], OverwritePolicy::Keep).unwrap();
            assert_eq!(
                (fs::read(&path).unwrap(), fs::read(&beside).unwrap()),
                (b"1".to_vec(), b"2".to_vec())
            );
            let file = PartialFile::begin(&path, OverwritePolicy::Replace).unwrap();
            file.finish(&[(beside, "3".to_owned())], OverwritePolicy::Replace).unwrap();
        }
        assert_eq!(names(place.path()).len(), 6);
    }

    #[test]
    fn temporary_files_of_killed_programs_go_and_others_stay() {
        let place = tempfile::tempdir().unwrap();
        let (path, stale) = (place.path().join("a"), place.path().join(".cmra-killed.tmp"));
        fs::write(&stale, "1").unwrap();
        let mut living = PartialFile::prepare(&path, OverwritePolicy::Keep, hidden).unwrap();
        living.add(b"2").unwrap();
        assert!(!stale.exists());
        write(&place.path().join("b"), b"3", OverwritePolicy::Keep).unwrap();
        name_all(vec![living], OverwritePolicy::Keep).unwrap();
        assert_eq!(names(place.path()), ["a", "b"]);
        assert_eq!(fs::read(&path).unwrap(), b"2");
    }

    /// Only root can give a file away.
    #[test]
    fn a_replaced_file_keeps_its_owner() {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("a");
        fs::write(&path, "old").unwrap();
        let chosen = (Some(12_345), Some(23_456));
        let is_root = std::os::unix::fs::chown(&path, chosen.0, chosen.1).is_ok();
        let before = fs::metadata(&path).unwrap();
        assert!(!is_root || before.uid() == 12_345);
        write(&path, b"new", OverwritePolicy::Replace).unwrap();
        let after = fs::metadata(&path).unwrap();
        assert_eq!((after.uid(), after.gid()), (before.uid(), before.gid()));
    }

    #[test]
    fn an_old_scene_is_there_until_the_new_table_is() {
        let place = tempfile::tempdir().unwrap();
        let (table, scene) = (place.path().join("a.csv"), place.path().join("a.toml"));
        fs::write(&scene, "old").unwrap();
        // A folder takes the table's name meanwhile: it cannot be named.
        let file = PartialFile::begin(&table, OverwritePolicy::Replace).unwrap();
        fs::create_dir(&table).unwrap();
        assert!(
            file.finish(&[(scene.clone(), "new".to_owned())], OverwritePolicy::Replace).is_err()
        );
        assert_eq!(names(place.path()), ["a.csv", "a.toml"]);
        assert_eq!(fs::read(&scene).unwrap(), b"old");
    }

    #[test]
    fn one_has_a_lock_at_a_time() {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("session.lock");
        let first = wait_for_lock(&path, &|| true);
        let second = File::open(&path).unwrap();
        let lock = || second.try_lock();
        assert!(first.is_some() && lock().is_err());
        assert!(wait_for_lock(&path, &|| false).is_none());
        drop(first);
        assert!(lock().is_ok());
        // Where there can be none, the work goes on.
        assert!(wait_for_lock(&place.path().join("absent/session.lock"), &|| true).is_none());
    }

    #[test]
    fn neither_a_link_to_nothing_nor_a_directory_is_replaced() {
        let place = tempfile::tempdir().unwrap();
        let link = place.path().join("a.csv");
        std::os::unix::fs::symlink(place.path().join("absent"), &link).unwrap();
        for (path, words) in
            [(&*link, "a link to a file that is not there"), (place.path(), "directory")]
        {
            for existing in [OverwritePolicy::Keep, OverwritePolicy::Replace] {
                let error = write(path, b"1", existing).unwrap_err().to_string();
                assert!(error.contains(words), "{error}");
            }
        }
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    }

    #[test]
    fn a_link_stays_a_link_and_permissions_stay() {
        use std::os::unix::fs::symlink;
        let place = tempfile::tempdir().unwrap();
        let (real, link) = (place.path().join("real"), place.path().join("link"));
        fs::write(&real, "old").unwrap();
        symlink(&real, &link).unwrap();
        // One that the user's mask would not allow.
        fs::set_permissions(&real, fs::Permissions::from_mode(0o666)).unwrap();
        write(&link, b"new", OverwritePolicy::Replace).unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        let mode = || fs::metadata(&real).unwrap().permissions().mode() & 0o777;
        assert_eq!((fs::read(&real).unwrap().as_slice(), mode()), (&b"new"[..], 0o666));
        // A read-only file is not replaced, though its folder would allow it.
        fs::set_permissions(&real, fs::Permissions::from_mode(0o444)).unwrap();
        let refused = write(&link, b"newest", OverwritePolicy::Replace).unwrap_err().to_string();
        assert!(refused.contains("read-only"), "{refused}");
        assert_eq!((fs::read(&real).unwrap().as_slice(), mode()), (&b"new"[..], 0o444));
    }
}
