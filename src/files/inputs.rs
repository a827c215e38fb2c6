//! Input and output files of a command: an output never replaces an input, even with `--force`.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use crate::files::error::FileError;
use crate::files::read;

/// Files of this process, by canonical paths.
#[derive(Default)]
struct Files {
    read: BTreeSet<PathBuf>,
    reserved: BTreeSet<PathBuf>,
}

static FILES: Mutex<Files> = Mutex::new(Files { read: BTreeSet::new(), reserved: BTreeSet::new() });

/// Returns the text of an input (scene, library, measured values); an error if it is an output of the command line.
pub(super) fn text_file(path: &Path, bytes_max: u64) -> Result<String, FileError> {
    note(path)?;
    read::text_file(path, bytes_max)
}

/// Registers standard input, which may be a file.
pub fn note_stdin() -> Result<(), FileError> {
    note(Path::new("/dev/stdin"))
}

/// Registers an input; an error if it is an output of the command line.
fn note(path: &Path) -> Result<(), FileError> {
    let Some(real) = real(path) else { return Ok(()) };
    let mut files = FILES.lock().unwrap_or_else(PoisonError::into_inner);
    if files.reserved.contains(&real) {
        return Err(refusal(path));
    }
    files.read.insert(real);
    Ok(())
}

/// Rejects an output that is an input.
pub(super) fn refuse(path: &Path) -> Result<(), FileError> {
    let files = FILES.lock().unwrap_or_else(PoisonError::into_inner);
    let is_input = real(path).is_some_and(|real| files.read.contains(&real));
    if is_input { Err(refusal(path)) } else { Ok(()) }
}

/// Registers an output; an error if it is an input. Later inputs with the same path are rejected.
pub(super) fn reserve(path: &Path) -> Result<(), FileError> {
    refuse(path)?;
    let mut files = FILES.lock().unwrap_or_else(PoisonError::into_inner);
    files.reserved.extend(real(path));
    Ok(())
}

fn refusal(path: &Path) -> FileError {
    let problem = "it is an input of this computation and would be lost: choose another name";
    FileError::target(path, problem)
}

/// Returns the canonical path of a regular file; `None` for others.
fn real(path: &Path) -> Option<PathBuf> {
    path.canonicalize().ok().filter(|real| real.is_file())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_input_is_no_output_whichever_is_named_first() {
        let place = tempfile::tempdir().unwrap();
        let at = |name: &str| {
            let path = place.path().join(name);
            std::fs::write(&path, "1").unwrap();
            path
        };
        let (read, written) = (at("read"), at("written"));
        let link = place.path().join("link");
        std::os::unix::fs::symlink(&read, &link).unwrap();
        note(&read).unwrap();
        for output in [&read, &link, &place.path().join("../").join(&read)] {
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
