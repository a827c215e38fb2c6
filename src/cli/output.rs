//! The only place that writes to standard output and standard error.

use std::borrow::Cow;
use std::io::{self, Write};
use std::process::ExitCode;

use crate::cli::CliError;

/// Write a result to standard output.
pub(super) fn print(text: &str) -> Result<(), CliError> {
    let mut out = io::stdout().lock();
    let text = harmless(text);
    out.write_all(text.as_bytes()).and_then(|()| out.flush()).map_err(CliError::Stdout)
}

/// A text of a scene file for a person's terminal, which would obey control characters: they are replaced.
pub(super) fn printable(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { char::REPLACEMENT_CHARACTER } else { c }).collect()
}

/// The same for a text of several lines: names of files and arguments may hold sequences that a terminal would obey, and no
/// result of this program needs one.
fn harmless(text: &str) -> Cow<'_, str> {
    let commands = |c: char| c.is_control() && !matches!(c, '\n' | '\r' | '\t');
    if text.contains(commands) {
        Cow::Owned(text.replace(commands, "\u{fffd}"))
    } else {
        Cow::Borrowed(text)
    }
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

/// Say something beside the result, on standard error. If nobody can hear it, it is lost: there is nowhere else to say it.
pub(super) fn note(text: &str) {
    let _ = writeln!(io::stderr().lock(), "{}", harmless(text));
}

/// Print why a command failed, and give its exit code.
pub fn report(error: &CliError) -> ExitCode {
    if !error.is_quiet() {
        note(&format!("error: {error}"));
    }
    error.code()
}
