//! The program: its command line, and one line for what went wrong.

use std::process::ExitCode;

use cmra::cli;

fn main() -> ExitCode {
    match cli::run(std::env::args_os()) {
        Ok(code) => code,
        Err(error) => cli::fail(&error),
    }
}
