//! Input and output files of a command: an output never replaces an input, even with `--force`.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::os::unix::fs::MetadataExt as _;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use crate::files::error::FileError;
use crate::files::read;

/// Paths that this process has read, and those that its command line writes to. Files are compared as they are now: one that was replaced
/// is another file.
#[derive(Default)]
struct Files {
    read: BTreeSet<PathBuf>,
    reserved: BTreeSet<PathBuf>,
}

static FILES: Mutex<Files> = Mutex::new(Files { read: BTreeSet::new(), reserved: BTreeSet::new() });

/// Path of standard input, which may be a file.
const STDIN: &str = "/dev/stdin";

/// Returns the text of an input (scene, library, measured values); an error if it is an output of the command line.
pub(super) fn text_file(path: &Path, bytes_max: u64) -> Result<String, FileError> {
    note(path)?;
    read::text_file(path, bytes_max)
}

/// Registers standard input.
pub fn note_stdin() -> Result<(), FileError> {
    note(Path::new(STDIN))
}

/// Registers an input; an error if it is an output of the command line.
fn note(path: &Path) -> Result<(), FileError> {
    let mut files = FILES.lock().unwrap_or_else(PoisonError::into_inner);
    if has(&files.reserved, path) {
        return Err(refusal(path));
    }
    files.read.extend(std::path::absolute(path));
    Ok(())
}

/// Returns an error if an output is a file that was read.
pub(super) fn refuse(path: &Path) -> Result<(), FileError> {
    let files = FILES.lock().unwrap_or_else(PoisonError::into_inner);
    if has(&files.read, path) { Err(refusal(path)) } else { Ok(()) }
}

/// Registers an output of the command line; an error if it was read. Later inputs that are the same file are errors.
pub(super) fn reserve(path: &Path) -> Result<(), FileError> {
    refuse(path)?;
    let mut files = FILES.lock().unwrap_or_else(PoisonError::into_inner);
    files.reserved.extend(std::path::absolute(path));
    Ok(())
}

fn refusal(path: &Path) -> FileError {
    let problem = "it is an input of this computation and would be lost: choose another name";
    FileError::target(path, problem)
}

/// Returns `true` if a path leads to one of these files, by whatever name or link.
fn has(paths: &BTreeSet<PathBuf>, path: &Path) -> bool {
    identity(path).is_some_and(|own| paths.iter().any(|other| identity(other) == Some(own)))
}

/// Device and number of an ordinary file; `None` for what is not there, or is a device or a pipe.
fn identity(path: &Path) -> Option<(u64, u64)> {
    let found = if path == Path::new(STDIN) {
        // By its name only where there is `/proc`.
        File::from(rustix::stdio::stdin().try_clone_to_owned().ok()?).metadata()
    } else {
        fs::metadata(path)
    };
    found.ok().filter(fs::Metadata::is_file).map(|found| (found.dev(), found.ino()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_input_is_no_output_whichever_is_named_first() {
        let place = tempfile::tempdir().unwrap();
        let at = |name: &str| {
            let path = place.path().join(name);
            fs::write(&path, "1").unwrap();
            path
        };
        let (read, written) = (at("read"), at("written"));
        let link = place.path().join("link");
        std::os::unix::fs::symlink(&read, &link).unwrap();
        let hard_link = place.path().join("hard");
        fs::hard_link(&read, &hard_link).unwrap();
        note(&read).unwrap();
        for output in [&read, &link, &hard_link, &place.path().join("../").join(&read)] {
            let error = reserve(output).unwrap_err().to_string();
            assert!(error.contains("is an input"), "{error}");
            assert!(refuse(output).is_err());
        }
        reserve(&written).unwrap();
        assert!(note(&written).unwrap_err().to_string().contains("written` cannot be the target"));
        // A terminal is both.
        note(Path::new("/dev/null")).unwrap();
        reserve(Path::new("/dev/null")).unwrap();
        reserve(&place.path().join("absent")).unwrap();
    }
}
