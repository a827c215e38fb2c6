//! The only place that writes to standard output and standard error.

use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use crate::cli::CliError;
use crate::files::clean;

pub(super) fn print(text: &str) -> Result<(), CliError> {
    let mut out = io::stdout().lock();
    let text = clean::page(text);
    out.write_all(text.as_bytes()).and_then(|()| out.flush()).map_err(CliError::Stdout)
}

/// Write a piece of a result that goes on.
pub(super) fn print_bytes(bytes: &[u8]) -> Result<(), CliError> {
    io::stdout().lock().write_all(bytes).map_err(CliError::Stdout)
}

/// Show how far a long computation is, in the place of what was shown before; an empty text takes it away.
pub(super) fn progress(text: &str) {
    let mut error = io::stderr().lock();
    // As with notes: where it is lost, there is nowhere else to show it.
    let _ = write!(error, "\r\x1b[K{text}").and_then(|()| error.flush());
}

/// Writes a note beside the result, on standard error. A closed standard error loses it.
pub(super) fn note(text: &str) {
    let _ = writeln!(io::stderr().lock(), "{}", clean::page(text));
}

/// Name the files that were written.
pub(super) fn note_written(files: &[PathBuf]) {
    for path in files {
        note(&format!("wrote {}", path.display()));
    }
}

/// Print why a command failed, and give its exit code.
pub fn fail(error: &CliError) -> ExitCode {
    if !error.is_quiet() {
        let text = format!("error: {error}");
        // Most errors are of one line, whatever a name or an argument in them holds.
        note(&if error.has_lines() { text } else { clean::line(&text).into_owned() });
    }
    error.code()
}
