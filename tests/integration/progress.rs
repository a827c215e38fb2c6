//! A person at a terminal sees how far a long command is, and an interrupt keeps what is finished.

use std::time::Duration;

use rustix::process::Signal;

use crate::pty::{PATIENCE, Start, Terminal};

/// What a command says that is interrupted as soon as it tells how far it is, in these words.
#[track_caller]
fn interrupted(arguments: &[&str], words: &str) -> (String, Terminal) {
    let mut terminal = Terminal::start_with(Start { arguments, ..Start::default() });
    let line = terminal.wait_for(words);
    assert_eq!(line.trim().lines().count(), 1, "one line, in its own place: {line}");
    terminal.signal(Signal::INT);
    let status = terminal.wait_exit(PATIENCE);
    assert_eq!(status.exit_code(), 1);
    let page = terminal.screen().contents();
    let is_gone = !page.contains(" %: ") && !page.contains(" s after ");
    assert!(is_gone, "the line is taken away: {page}");
    (page, terminal)
}

#[test]
fn a_long_run_reports_the_time_it_has_reached() {
    let words = "run --set k=1e9 --set n=1.5 --set run.horizon_s=1000 --csv long.csv";
    let arguments: Vec<&str> = words.split(' ').collect();
    let (page, terminal) = interrupted(&arguments, " s after ");
    assert!(page.contains("the run is incomplete: cancelled: what was finished is kept"), "{page}");
    let rows = std::fs::read_to_string(terminal.file("long.partial.csv")).unwrap();
    assert!(rows.lines().count() > 1_000 && rows.ends_with('\n'));
}

#[test]
fn every_long_computation_reports_its_progress() {
    for (words, said) in [
        ("limit --samples 1000000", " shots or so"),
        // On a busy machine the page itself tells of points.
        ("accuracy --set interface=plastic", " of 89 points"),
        ("scatter --samples 1000000 --set n=0.7", " runs"),
    ] {
        let arguments: Vec<&str> = words.split(' ').collect();
        let (page, _) = interrupted(&arguments, said);
        assert!(page.contains("interrupted: "), "{words}: {page}");
    }
}

/// A table goes where the screen does not cut it.
#[test]
fn what_is_cut_short_says_so_and_draws_no_conclusion() {
    for (words, said, marked, conclusion) in [
        ("reproduce --csv a.csv", " rows", "not complete: interrupted after ", " rows: "),
        ("stability", " scenes", "not complete: interrupted after ", " scenes pass"),
        (
            "accuracy --set interface=plastic",
            " of 89 points",
            "no answer is drawn from these points",
            "<- cheapest",
        ),
        ("compare --map v_i,gamma --csv a.csv", " points", "the rest not computed", "   -\n"),
    ] {
        let arguments: Vec<&str> = words.split(' ').collect();
        let (page, terminal) = interrupted(&arguments, said);
        assert!(page.contains(marked), "{words}: {page}");
        assert!(!page.contains(conclusion), "{words}: {page}");
        if words.ends_with("a.csv") {
            let rows = std::fs::read_to_string(terminal.file("a.partial.csv")).unwrap();
            let mut ends = rows.lines().map(|line| line.rsplit(',').next().unwrap());
            assert_eq!(ends.next(), Some("complete"), "{words}");
            assert!(ends.all(|end| end == "false"), "{words}: {rows}");
        }
    }
}

/// Of a sweep the points that are done are counted.
#[test]
fn a_sweep_counts_its_points() {
    let words = "sweep --over gamma=1..3:100000 --set n=0.7 --set interface=plastic";
    let arguments: Vec<&str> = words.split(' ').collect();
    let mut terminal = Terminal::start_with(Start { arguments: &arguments, ..Start::default() });
    terminal.wait_until("some points are done", |screen| {
        let text = screen.contents();
        text.contains(" of 100000 points, ") && !text.contains(" %: 0 of")
    });
    terminal.signal(Signal::INT);
    assert_eq!(terminal.wait_exit(PATIENCE).exit_code(), 1);
}

/// One run of these takes minutes: the word to stop does not wait for its end.
#[test]
fn a_search_is_stopped_within_a_run() {
    let scene = "--set k=1e9 --set n=1.5 --set interface=plastic --set run.horizon_s=1000";
    for (command, said) in [
        ("seek --over gamma=1..3:9 --goal stroke_m=1mm", "0 of 49 runs"),
        ("scatter", "0 of 10000 runs"),
        ("optimise", " of 16384 runs"),
        ("sweep --over gamma=1..3:9", "0 of 9 points"),
        ("compare", "0 of 4 candidates"),
    ] {
        let words = format!("{command} {scene}");
        let arguments: Vec<&str> = words.split(' ').collect();
        let mut terminal =
            Terminal::start_with(Start { arguments: &arguments, ..Start::default() });
        terminal.wait_for(said);
        terminal.signal(Signal::INT);
        assert_eq!(terminal.wait_exit(PATIENCE).exit_code(), 1, "{command}");
        assert!(terminal.screen().contents().contains("interrupted: "), "{command}");
    }
}

#[test]
fn a_dumb_terminal_gets_no_line_that_would_have_to_be_taken_away() {
    // Minutes on any machine.
    let arguments = ["limit", "--samples", "1000000"];
    let environment = [("TERM", "dumb")];
    let start = Start { arguments: &arguments, environment: &environment, ..Start::default() };
    let mut terminal = Terminal::start_with(start);
    // Well beyond the time after which others get one.
    assert_eq!(terminal.settle(Duration::from_secs(1)), 0);
    terminal.signal(Signal::INT);
    assert_eq!(terminal.wait_exit(PATIENCE).exit_code(), 1);
}
