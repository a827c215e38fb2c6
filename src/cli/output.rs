//! The only place that writes to standard output and standard error.

use std::io::{self, Write};
use std::process::ExitCode;

use crate::cli::CliError;

/// Write a result to standard output.
pub(super) fn print(text: &str) -> Result<(), CliError> {
    let mut out = io::stdout().lock();
    out.write_all(text.as_bytes()).and_then(|()| out.flush()).map_err(CliError::Stdout)
}

/// Say something beside the result, on standard error. If nobody can hear it, it is lost: there is nowhere else to say it.
pub(super) fn note(text: &str) {
    let _ = writeln!(io::stderr().lock(), "{text}");
}

/// Print why a command failed, and give its exit code.
pub fn report(error: &CliError) -> ExitCode {
    if !error.is_quiet() {
        note(&format!("error: {error}"));
    }
    error.code()
}
