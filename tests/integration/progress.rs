//! Progress of long commands on a terminal: a person sees how far one is, and an interrupt keeps what is finished.

use std::process::ExitCode;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::Duration;

use rustix::process::Signal;
use signal_hook::consts::SIGINT;

use crate::pty::{Start, Terminal};

/// The command line of [`a_command_that_is_interrupted`].
const WORDS: &str = "CMRA_TEST_WORDS";

/// Looks at the clock before the progress is shown for the first time.
const LOOKS: u32 = 4;

#[test]
#[ignore = "run by the tests below, in a terminal of its own"]
fn a_command_that_is_interrupted() {
    let Ok(words) = std::env::var(WORDS) else { return };
    let looks = AtomicU32::new(0);
    // Each look lasts a second, and the interrupt comes when the progress is first shown: no matter how fast the machine is.
    let clock = move || {
        let looks = looks.fetch_add(1, Ordering::Relaxed);
        if looks == LOOKS {
            // Twice, as `timeout` sends it: to the process and to its group.
            for _ in 0..2 {
                signal_hook::low_level::raise(SIGINT).expect("a signal");
            }
        }
        Duration::from_secs(1) * looks
    };
    let arguments = words.split(' ').map(Into::into);
    let code = cmra::cli::run_by(Arc::new(clock), arguments).expect("a valid command");
    assert_eq!(format!("{code:?}"), format!("{:?}", ExitCode::FAILURE));
}

/// A command whose progress comes by a clock of its own, and that is interrupted when it is first shown.
fn in_own_time(words: &str, environment: &[(&str, &str)]) -> Terminal {
    let program = std::env::current_exe().unwrap();
    let words = format!("cmra {words}");
    let environment = [environment, &[(WORDS, &words)]].concat();
    let name = "progress::a_command_that_is_interrupted";
    Terminal::start_with(Start {
        shell: program.to_str(),
        arguments: &["--ignored", "--exact", name, "--nocapture"],
        environment: &environment,
        ..Start::default()
    })
}

/// Interrupts a command at its first progress message with these words, and returns its output.
#[track_caller]
fn interrupted(words: &str, progress: &str) -> (String, Terminal) {
    let mut terminal = in_own_time(words, &[]);
    let status = terminal.wait_exit();
    let page = terminal.screen().contents();
    assert_eq!(status.exit_code(), 0, "{words}: {page}");
    let shown = terminal.text();
    let line = shown.split("\r\x1b[K").find(|piece| piece.contains(progress));
    let line = line.unwrap_or_else(|| panic!("{words}: no `{progress}`: {shown}"));
    assert!(!line.contains('\n'), "one line, in its own place: {line}");
    let is_gone = !page.contains(" %: ") && !page.contains(" s after ");
    assert!(is_gone, "the line is taken away: {page}");
    (page, terminal)
}

#[test]
fn a_long_run_reports_the_time_it_has_reached() {
    let words = "run --set k=1e9 --set n=1.5 --set run.horizon_s=1000 --csv long.csv";
    let (page, terminal) = interrupted(words, " after 4.0 s, 64 steps");
    assert!(page.contains("the run is incomplete: cancelled: what was finished is kept"), "{page}");
    let rows = std::fs::read_to_string(terminal.file("long.csv.partial")).unwrap();
    assert!(rows.lines().count() > 10 && rows.ends_with('\n'));
}

/// A table goes where the screen does not cut it.
#[test]
fn what_is_cut_short_says_so_and_draws_no_conclusion() {
    for (words, said, marked, conclusion) in [
        ("reproduce --csv a.csv", " rows", "not complete: interrupted after ", " rows: "),
        ("stability", " scenes", "not complete: interrupted after ", " scenes pass"),
        (
            "accuracy --set interface=plastic",
            " of 69 points",
            "no answer is drawn from these points",
            "<- cheapest",
        ),
    ] {
        let (page, terminal) = interrupted(words, said);
        assert!(page.contains(marked), "{words}: {page}");
        assert!(!page.contains(conclusion), "{words}: {page}");
        if words.ends_with("a.csv") {
            let rows = std::fs::read_to_string(terminal.file("a.csv.partial")).unwrap();
            let mut ends = rows.lines().map(|line| line.rsplit(',').next().unwrap());
            assert_eq!(ends.next(), Some("complete"), "{words}");
            assert!(ends.all(|end| end == "false"), "{words}: {rows}");
        }
    }
}

/// Every study that was stopped says so on its page, in each row of its table, in the name of its file and beside it.
#[test]
fn each_study_that_is_cut_short_says_so_on_its_page_and_in_its_file() {
    let slow = "--set k=1e9 --set n=1.5 --set interface=plastic --set run.horizon_s=1000";
    for (command, said) in [
        (format!("limit {slow}"), " shots or so"),
        (format!("compare {slow}"), " candidates"),
        ("compare --map v_i,gamma".to_owned(), " points"),
        (format!("seek --over gamma=1..3:9 --goal stroke_m=1mm {slow}"), " runs"),
        ("optimise".to_owned(), " runs"),
        ("montecarlo --samples 1000000".to_owned(), " runs"),
        (format!("sensitivity {slow}"), " runs"),
        ("stability".to_owned(), " scenes"),
        ("stability --map k".to_owned(), " rows"),
        ("accuracy --set interface=plastic".to_owned(), " points"),
        ("reproduce".to_owned(), " rows"),
        ("validate".to_owned(), " measurements"),
    ] {
        let (page, terminal) = interrupted(&format!("{command} --csv a.csv"), said);
        // A long page has left the screen by its top.
        let all = terminal.text();
        assert!(all.contains("not complete: interrupted after "), "{command}: {page}");
        let rows = std::fs::read_to_string(terminal.file("a.csv.partial"));
        let rows = rows.unwrap_or_else(|_| panic!("{command}: {page}"));
        let mut lines = rows.lines();
        assert!(lines.next().is_some_and(|head| head.ends_with(",complete")), "{command}: {rows}");
        assert!(lines.all(|line| line.ends_with(",false")), "{command}: {rows}");
        if let Ok(beside) = std::fs::read_to_string(terminal.file("a.csv.toml")) {
            assert!(beside.contains("# not complete: interrupted after "), "{command}: {beside}");
        }
    }
}

/// The progress of a sweep counts its finished points.
#[test]
fn a_sweep_counts_its_points() {
    let arguments = ["sweep", "--over", "gamma=1..3:1000000000", "--csv", "endless.csv"];
    let mut terminal = Terminal::start_with(Start { arguments: &arguments, ..Start::default() });
    terminal.wait_until("some points are done", |screen| {
        let text = screen.contents();
        text.contains(" of 1000000000 points, ") && !text.contains(" %: 0 of")
    });
    terminal.signal(Signal::INT);
    assert_eq!(terminal.wait_exit().exit_code(), 1);
}

/// A run of millions of steps is cancelled before its end.
#[test]
fn a_search_is_stopped_within_a_run() {
    let scene = "--set k=1e9 --set n=1.5 --set interface=plastic --set run.horizon_s=1000";
    for (command, said) in [
        ("seek --over gamma=1..3:9 --goal stroke_m=1mm", "0 of 49 runs"),
        ("montecarlo", "0 of 10000 runs"),
        ("optimise", " of 16384 runs"),
        ("sweep --over gamma=1..3:9", "0 of 9 points"),
        ("compare", "0 of 4 candidates"),
    ] {
        let (page, _) = interrupted(&format!("{command} {scene}"), said);
        assert!(page.contains("interrupted: "), "{command}: {page}");
    }
}

#[test]
fn a_dumb_terminal_gets_no_line_that_would_have_to_be_taken_away() {
    let mut terminal = in_own_time("compare", &[("TERM", "dumb")]);
    // Nothing was shown: it was not interrupted, which the test within it reports.
    assert_eq!(terminal.wait_exit().exit_code(), 101);
    assert!(!terminal.text().contains("\x1b[K"), "{:?}", terminal.text());
}
