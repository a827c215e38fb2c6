//! The file beside a study's CSV: the scene it was made from, and the command that makes the same rows again.

use std::fs;
use std::path::{Path, PathBuf};

use crate::cli::pace::was_interrupted;
use crate::cli::{again, help};
use crate::files::atomic::Existing;
use crate::files::clean;
use crate::files::error::FileError;
use crate::files::export;
use crate::model::scene::Scene;

/// Whether a scene may be written beside this file; asked before the computation, not after it.
pub(super) fn check(csv: &Path, existing: Existing) -> Result<(), FileError> {
    if !is_ordinary(csv) {
        return Ok(());
    }
    let beside = export::sidecar_path(csv, None);
    export::check_sidecar(csv, &beside)?;
    if existing == Existing::Keep && fs::symlink_metadata(&beside).is_ok() {
        return Err(FileError::Exists(beside));
    }
    Ok(())
}

/// Its name and text; `None` where there is no place beside the file.
pub(super) fn file(csv: &Path, scene: &Scene) -> Option<(PathBuf, String)> {
    if !is_ordinary(csv) {
        return None;
    }
    let beside = export::sidecar_path(csv, None);
    let name = format!("./{}", beside.file_name().unwrap_or_default().to_string_lossy());
    let again = again::line(&help::command(), &typed(), Some(&name));
    let missing = was_interrupted().then(|| "not complete: interrupted".to_owned());
    let text = export::study_sidecar(csv, scene, &again, missing.as_slice());
    Some((beside, text))
}

/// The command as a comment line, as it was typed.
pub(super) fn inline_again() -> String {
    format!("# again: {}\n", clean::line(&again::line(&help::command(), &typed(), None)))
}

/// A device or a pipe has no place beside it.
pub(super) fn is_ordinary(csv: &Path) -> bool {
    fs::metadata(csv).map_or(true, |found| found.is_file())
}

/// The words of the command line after the program's name.
fn typed() -> Vec<String> {
    std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned()).collect()
}
