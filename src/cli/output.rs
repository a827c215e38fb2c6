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

/// Writes a piece of a result.
pub(super) fn print_bytes(bytes: &[u8]) -> Result<(), CliError> {
    io::stdout().lock().write_all(bytes).map_err(CliError::Stdout)
}

/// Shows the progress of a long computation in place of the previous text; an empty text removes it.
pub(super) fn progress(text: &str) {
    let mut error = io::stderr().lock();
    // As with notes: where it is lost, there is nowhere else to show it.
    let _ = write!(error, "\r\x1b[K{text}").and_then(|()| error.flush());
}

/// Writes a note beside the result, on standard error. A closed standard error loses it.
pub(super) fn note(text: &str) {
    let _ = writeln!(io::stderr().lock(), "{}", clean::page(text));
}

/// Prints the names of the files that were written.
pub(super) fn note_written(files: &[PathBuf]) {
    for path in files {
        note(&format!("wrote {}", path.display()));
    }
}

/// Prints the error of a command and returns its exit code.
pub fn fail(error: &CliError) -> ExitCode {
    if !error.is_quiet() {
        let text = format!("error: {error}");
        // Most errors are of one line, whatever a name or an argument in them holds.
        note(&if error.has_lines() { text } else { clean::line(&text).into_owned() });
    }
    error.code()
}
