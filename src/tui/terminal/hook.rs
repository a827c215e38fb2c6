//! What happens when something panics while the workbench has the terminal.
//!
//! On the thread that draws: the terminal is restored first, then the panic is told on the main screen and a report with a
//! backtrace is left in the state directory. On any other thread: only the log is told; the terminal stays as it is, since the
//! workbench goes on. Outside the workbench the hook that was there before does its work.

use std::backtrace::Backtrace;
use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::panic::{self, PanicHookInfo};
use std::path::{Path, PathBuf};
use std::thread::{self, ThreadId};

/// Install the hook; the calling thread is the one that draws. Reports go to `directory`.
pub(in crate::tui) fn install(directory: Option<PathBuf>) {
    let drawing = thread::current().id();
    let before = panic::take_hook();
    panic::set_hook(Box::new(move |info| {
        if !super::is_entered() {
            before(info);
        } else if on(drawing) {
            super::restore();
            tell(&report(info), directory.as_deref());
        } else {
            log::error!("{}", report(info));
        }
    }));
}

fn on(thread: ThreadId) -> bool {
    thread::current().id() == thread
}

/// Everything a person who mends this wants to know.
fn report(info: &PanicHookInfo<'_>) -> String {
    let current = thread::current();
    format!(
        "cmra {} panicked on thread {}\n{info}\n{}",
        env!("CARGO_PKG_VERSION"),
        current.name().unwrap_or("without a name"),
        Backtrace::force_capture()
    )
}

/// Leave the report in a file and say so on the main screen; without a file, print all of it.
fn tell(report: &str, directory: Option<&Path>) {
    let written = directory.and_then(|directory| {
        let path = directory.join(format!("panic-{}.txt", std::process::id()));
        fs::create_dir_all(directory).ok()?;
        fs::write(&path, report).ok()?;
        Some(path)
    });
    let mut text = String::from("cmra: internal error; the terminal has been restored\n");
    // Writing to a string does not fail.
    let _ = match written {
        Some(path) => {
            let first: Vec<&str> = report.lines().take(3).collect();
            writeln!(
                text,
                "{}\nthe details are in {}: please report them",
                first.join("\n"),
                path.display()
            )
        }
        None => writeln!(text, "{report}"),
    };
    // Nobody is left to tell when standard error is gone.
    let _ = std::io::stderr().write_all(text.as_bytes());
}
