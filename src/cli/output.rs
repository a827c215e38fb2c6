//! Writes to standard output and standard error; no other module does.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use crate::cli::CliError;
use crate::files::clean;

/// Returns `true` if a path of the command line is standard output. What is written is added to a file behind it, which is not
/// replaced, and no scene goes beside it.
pub(super) fn is_stdout(path: &Path) -> bool {
    ["-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"].iter().any(|name| path == Path::new(name))
}

pub(super) fn print(text: &str) -> Result<(), CliError> {
    let mut out = io::stdout().lock();
    let text = clean::page(text);
    out.write_all(text.as_bytes()).and_then(|()| out.flush()).map_err(CliError::Stdout)
}

/// Writes a part of a result.
pub(super) fn print_bytes(bytes: &[u8]) -> Result<(), CliError> {
    io::stdout().lock().write_all(bytes).map_err(CliError::Stdout)
}

/// Shows the progress of a long computation in place of the previous text; an empty text removes it.
pub(super) fn progress(text: &str) {
    let mut error = io::stderr().lock();
    // An error is ignored: there is no other place to report it.
    let _ = write!(error, "\r\x1b[K{text}").and_then(|()| error.flush());
}

/// Writes a note to standard error; ignored if that is closed.
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
        // Most errors have one line; a name or an argument in them can contain line ends.
        note(&if error.has_lines() { text } else { clean::line(&text).into_owned() });
    }
    error.code()
}
