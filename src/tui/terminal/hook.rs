//! Panic hook while the workbench controls the terminal.
//!
//! The hook writes a report with a backtrace to the state directory. On the drawing thread it restores the terminal first and prints the
//! panic on the main screen. On other threads the terminal is unchanged, because the workbench continues. Outside the workbench the
//! previous hook is used.

use std::backtrace::Backtrace;
use std::fs;
use std::io::Write as _;
use std::panic::{self, PanicHookInfo};
use std::path::{Path, PathBuf};
use std::thread;

/// Installs the hook; the calling thread is the drawing thread. Reports are written to `directory`.
pub(crate) fn install(directory: Option<PathBuf>) {
    let drawing = thread::current().id();
    let before = panic::take_hook();
    panic::set_hook(Box::new(move |info| {
        if !super::is_entered() {
            before(info);
        } else if thread::current().id() == drawing {
            super::restore();
            report_progress(&report(info), directory.as_deref());
        } else {
            written(&report(info), directory.as_deref());
        }
    }));
}

/// Returns the report for debugging.
fn report(info: &PanicHookInfo<'_>) -> String {
    let current = thread::current();
    format!(
        "cmra {} panicked on thread {}\n{info}\n{}",
        env!("CARGO_PKG_VERSION"),
        current.name().unwrap_or("without a name"),
        Backtrace::force_capture()
    )
}

/// Writes the report to a new file.
fn written(report: &str, directory: Option<&Path>) -> Option<PathBuf> {
    let directory = directory?;
    fs::create_dir_all(directory).ok()?;
    let named = tempfile::Builder::new().prefix("panic-").suffix(".txt").tempfile_in(directory);
    let (mut file, path) = named.ok()?.keep().ok()?;
    file.write_all(report.as_bytes()).ok()?;
    Some(path)
}

/// Writes the report to a file and prints its path on the main screen; without a file, prints the whole report.
fn report_progress(report: &str, directory: Option<&Path>) {
    let text = match written(report, directory) {
        Some(path) => {
            let first: Vec<&str> = report.lines().take(3).collect();
            let (first, path) = (first.join("\n"), path.display());
            format!("{first}\nthe details are in {path}: please report them")
        }
        None => report.to_owned(),
    };
    let head = "cmra: internal error; the terminal has been restored";
    // If standard error is closed, the message cannot be shown.
    let _ = writeln!(std::io::stderr(), "{head}\n{text}");
}

#[cfg(test)]
mod tests {
    use std::io::Read;

    use portable_pty::{CommandBuilder, PtySize, native_pty_system};
    use ratatui::style::Style;

    use super::*;
    use crate::tui::terminal::Guard;

    const PLACE: &str = "CMRA_TEST_PLACE";

    /// Runs one of the ignored tests below in a separate terminal. Returns the final screen, the last content of the alternate screen, and
    /// whether the modes are restored.
    fn in_a_terminal(test: &str, place: &Path) -> (vt100::Parser, String, bool) {
        let pair = native_pty_system().openpty(PtySize::default()).unwrap();
        let mut command = CommandBuilder::new(std::env::current_exe().unwrap());
        let name = format!("{}::{test}", module_path!().split_once("::").unwrap().1);
        command.args(["--ignored", "--exact", &name, "--nocapture"]);
        // The directory and the home of the tester have no effect.
        command.cwd(place);
        command.env_clear();
        command.env(PLACE, place);
        command.env("TERM", "xterm-256color");
        let before = format!("{:?}", pair.master.get_termios());
        let mut child = pair.slave.spawn_command(command).unwrap();
        drop(pair.slave);
        let mut reader = pair.master.try_clone_reader().unwrap();
        let mut parser = vt100::Parser::default();
        let mut on_alternate = String::new();
        let mut buffer = [0; 4096];
        // Reading ends when the program, the last user of the terminal, has ended.
        while let Ok(count) = reader.read(&mut buffer) {
            if count == 0 {
                break;
            }
            // Use small pieces, to see text that is overwritten immediately.
            for piece in buffer[..count].chunks(8) {
                parser.process(piece);
                let shown = parser.screen().contents();
                // The alternate screen is cleared when leaving.
                if parser.screen().alternate_screen() && !shown.trim().is_empty() {
                    on_alternate = shown;
                }
            }
        }
        child.wait().unwrap();
        let same_modes = format!("{:?}", pair.master.get_termios()) == before;
        (parser, on_alternate, same_modes)
    }

    #[test]
    fn a_panic_of_the_drawing_thread_restores_first_and_leaves_a_report() {
        let place = tempfile::tempdir().unwrap();
        let (parser, _, same_modes) = in_a_terminal("the_drawing_thread_panics", place.path());
        let screen = parser.screen();
        assert!(!screen.alternate_screen() && !screen.hide_cursor() && same_modes);
        let text = screen.contents();
        assert!(text.contains("internal error"), "{text}");
        assert!(text.contains("deliberate"), "{text}");
        let report = fs::read_dir(place.path()).unwrap().next().unwrap().unwrap().path();
        let name = report.file_name().unwrap().to_str().unwrap();
        assert!(text.replace('\n', "").contains(name), "{text}");
        let report = fs::read_to_string(report).unwrap();
        assert!(report.contains("deliberate") && report.contains("the_drawing_thread_panics"));
    }

    #[test]
    fn a_panic_of_another_thread_leaves_the_terminal_alone() {
        let place = tempfile::tempdir().unwrap();
        let (parser, on_alternate, same_modes) =
            in_a_terminal("another_thread_panics", place.path());
        assert_eq!(on_alternate.trim(), "still here");
        assert!(!parser.screen().alternate_screen() && same_modes);
        let text = parser.screen().contents();
        assert!(!text.contains("deliberate"), "{text}");
        let report = fs::read_dir(place.path()).unwrap().next().unwrap().unwrap().path();
        assert!(fs::read_to_string(report).unwrap().contains("deliberate"));
    }

    #[test]
    fn no_report_replaces_another() {
        let place = tempfile::tempdir().unwrap();
        let paths = ["first", "second"].map(|text| written(text, Some(place.path())).unwrap());
        assert_eq!(paths.map(|path| fs::read_to_string(path).unwrap()), ["first", "second"]);
    }

    fn take_over() -> Guard {
        install(std::env::var_os(PLACE).map(PathBuf::from));
        Guard::enter().expect("a terminal")
    }

    #[test]
    #[ignore = "run by a test above, in a terminal of its own"]
    fn the_drawing_thread_panics() {
        let _guard = take_over();
        panic!("deliberate");
    }

    #[test]
    #[ignore = "run by a test above, in a terminal of its own"]
    fn another_thread_panics() {
        let mut guard = take_over();
        assert!(thread::spawn(|| panic!("deliberate")).join().is_err());
        let drawn = guard.draw((80, 24), false, |buffer| {
            buffer.set_string(0, 0, "still here", Style::new());
            None
        });
        assert!(drawn.is_ok_and(|bytes| bytes > 0));
    }
}
