//! The workbench as a person has it: a real terminal, from the first chart to the restored prompt.

use std::fs;
use std::time::{Duration, Instant};

use rustix::process::Signal;

use crate::pty::{PATIENCE, Start, Terminal, wait_for_state};

/// Longest quiet time within one answer of the program.
const QUIET: Duration = Duration::from_millis(300);

/// The status row of a finished run of the baseline.
const DONE: &str = "arrested";

fn started() -> Terminal {
    let mut terminal = Terminal::start();
    terminal.wait_for(DONE);
    terminal.settle(QUIET);
    terminal
}

#[test]
fn a_session_from_the_first_chart_to_the_prompt() {
    let mut terminal = Terminal::start();
    let first = terminal.wait_for(DONE);
    assert!(first.contains("Penetration"), "{first}");
    assert!(terminal.screen().alternate_screen());
    assert!(terminal.screen().bracketed_paste());
    terminal.settle(QUIET);

    // Three rows down is the impact velocity; the curve follows the new value.
    let before = chart(&terminal);
    terminal.send("jj\r");
    terminal.send("150\r");
    terminal.wait_for("150");
    terminal.settle(QUIET);
    assert_ne!(chart(&terminal), before);

    terminal.send(" ");
    terminal.wait_until("a pinned run in the legend", |screen| screen.contents().contains("A "));

    terminal.send("e");
    terminal.wait_for(".csv");
    terminal.send("\x15here.csv\r");
    let csv = terminal.file("here.csv");
    terminal.wait_for("here.csv");
    terminal.settle(QUIET);
    let text = fs::read_to_string(csv).expect("it has been written");
    assert!(text.lines().count() > 10, "{text}");
    assert!(text.contains("time_s,mode,penetration_m"), "{text}");
    assert!(terminal.file("here.toml").exists());

    terminal.send("q");
    let status = terminal.wait_exit(PATIENCE);
    assert_eq!(status.exit_code(), 0);
    terminal.assert_restored();

    // What was done is there the next time.
    let mut again = Terminal::start_with(Start { home: terminal.home.take(), ..Start::default() });
    again.wait_for("150");
    again.wait_for("restored");
    again.send("q");
    assert_eq!(again.wait_exit(PATIENCE).exit_code(), 0);
}

/// What is drawn right of the variables, at 80 columns.
fn chart(terminal: &Terminal) -> Vec<String> {
    terminal.screen().rows(32, 48).skip(2).take(16).collect()
}

#[test]
fn a_summary_can_stay_on_the_main_screen() {
    let mut terminal = started();
    terminal.send("Q");
    assert_eq!(terminal.wait_exit(PATIENCE).exit_code(), 0);
    terminal.assert_restored();
    let left = terminal.screen().contents();
    assert!(left.contains("arrested"), "{left}");
}

#[test]
fn resizing_redraws_in_the_new_size() {
    let mut terminal = started();
    terminal.resize(120, 40);
    terminal.wait_until("the frame fills 120 columns", |screen| {
        screen.contents().lines().any(|line| line.chars().count() > 100)
    });
    terminal.settle(QUIET);
    terminal.resize(30, 8);
    terminal.wait_for("60");
    terminal.settle(QUIET);
    terminal.resize(80, 24);
    terminal.wait_for(DONE);
    terminal.send("q");
    assert_eq!(terminal.wait_exit(PATIENCE).exit_code(), 0);
    terminal.assert_restored();
}

#[test]
fn a_hangup_ends_the_process_and_keeps_the_session() {
    for controlling in [true, false] {
        // Without a controlling terminal no signal comes: the loop must notice by itself.
        let mut terminal = Terminal::start_with(Start { controlling, ..Start::default() });
        terminal.wait_for(DONE);
        terminal.send("jj\r150\r");
        terminal.wait_for("150");
        terminal.hang_up();
        let status = terminal.wait_exit(Duration::from_secs(2));
        assert_eq!(status.exit_code(), 129, "controlling: {controlling}");
        let kept = fs::read_to_string(terminal.session_file()).expect("the session was saved");
        assert!(kept.contains("150"), "{kept}");
    }
}

#[test]
fn signals_end_the_process_with_the_terminal_restored() {
    for (signal, code) in
        [(Signal::TERM, 143), (Signal::HUP, 129), (Signal::INT, 130), (Signal::QUIT, 131)]
    {
        let mut terminal = started();
        terminal.send("jj\r150\r");
        terminal.wait_for("150");
        terminal.signal(signal);
        let status = terminal.wait_exit(Duration::from_secs(2));
        assert_eq!(status.exit_code(), code, "{signal:?}");
        terminal.assert_restored();
        assert!(fs::read_to_string(terminal.session_file()).is_ok_and(|kept| kept.contains("150")));
    }
}

#[test]
fn a_terminal_that_takes_no_bytes_does_not_hold_up_the_end() {
    let mut terminal = started();
    terminal.send("jj\r150\r");
    terminal.wait_for("150");
    terminal.settle(QUIET);
    terminal.stop_taking();
    // Some 60 frames are more than a pseudo-terminal keeps for a reader that does not read.
    let process = terminal.process();
    for _ in 0..60 {
        terminal.send("\x0c");
        terminal.settle(Duration::from_millis(50));
    }
    let asked = Instant::now();
    terminal.signal(Signal::TERM);
    let status = terminal.wait_exit(Duration::from_secs(4));
    assert_eq!(status.exit_code(), 143, "{process}");
    // It really was stuck: left alone, it leaves in a few milliseconds.
    assert!(asked.elapsed() > Duration::from_secs(1), "{:?}", asked.elapsed());
    let kept = fs::read_to_string(terminal.session_file()).expect("the session was saved");
    assert!(kept.contains("150"), "{kept}");
}

#[test]
fn ctrl_z_stops_and_fg_comes_back() {
    let mut terminal = Terminal::start_with(Start {
        shell: Some("/bin/sh"),
        arguments: &["-i", "-m"],
        environment: &[("PS1", "prompt> "), ("LC_ALL", "C.UTF-8"), ("ENV", "")],
        ..Start::default()
    });
    terminal.wait_for("prompt>");
    terminal.send("sh -c 'echo $$ > pid; exec $CMRA'\r");
    terminal.wait_for(DONE);
    terminal.settle(QUIET);
    let process = fs::read_to_string(terminal.file("pid")).expect("its number");
    let process = process.trim();
    terminal.send("\x1a");
    wait_for_state(process, 'T');
    terminal.wait_until("the shell again", |screen| {
        !screen.alternate_screen() && screen.contents().contains("Stopped")
    });
    assert!(!terminal.screen().hide_cursor());
    assert!(!terminal.screen().bracketed_paste());
    terminal.send("echo alive\r");
    terminal.wait_for("\nalive");
    terminal.send("fg\r");
    terminal.wait_until("the workbench again", |screen| {
        screen.alternate_screen() && screen.contents().contains(DONE)
    });
    terminal.settle(QUIET);
    // It listens again.
    terminal.send("q");
    terminal.wait_until("the shell's fourth prompt", |screen| {
        !screen.alternate_screen() && screen.contents().matches("prompt>").count() == 4
    });
    terminal.send("exit\r");
    assert_eq!(terminal.wait_exit(PATIENCE).exit_code(), 0);
}

#[test]
fn without_a_shell_ctrl_z_is_refused() {
    let mut terminal = started();
    terminal.send("\x1a");
    terminal.wait_for("cannot suspend");
    assert!(terminal.screen().alternate_screen());
    terminal.send("q");
    assert_eq!(terminal.wait_exit(PATIENCE).exit_code(), 0);
}

#[test]
fn stopped_and_continued_from_outside_it_redraws() {
    let mut terminal = started();
    terminal.signal(Signal::STOP);
    let process = terminal.process();
    wait_for_state(&process, 'T');
    assert_eq!(terminal.settle(QUIET), 0);
    // Someone clears the screen meanwhile.
    terminal.signal(Signal::CONT);
    let before = terminal.drawn;
    terminal.settle(QUIET);
    assert!(terminal.drawn - before > 1000, "it draws every cell");
    assert!(terminal.screen().contents().contains(DONE));
    terminal.send("q");
    assert_eq!(terminal.wait_exit(PATIENCE).exit_code(), 0);
    terminal.assert_restored();
}

#[test]
fn bytes_stay_few() {
    let mut terminal = Terminal::start_with(Start { arguments: &["--fresh"], ..Start::default() });
    terminal.wait_for(DONE);
    terminal.settle(QUIET);
    let first = terminal.drawn;
    assert!(first <= 4096, "first frame: {first} bytes");
    // Idle: not a byte.
    assert_eq!(terminal.settle(Duration::from_secs(2)), 0);
    terminal.send("jj");
    terminal.settle(QUIET);
    terminal.send("l");
    let nudge = terminal.settle(QUIET);
    assert!((1..=4096).contains(&nudge), "a nudge: {nudge} bytes");
    // A key held for two seconds, thirty times a second, in one go: frames are left out.
    for _ in 0..60 {
        terminal.send("l");
    }
    let held = terminal.settle(QUIET);
    assert!(held <= 12 * 4096, "a held key: {held} bytes");
    terminal.send("q");
    assert_eq!(terminal.wait_exit(PATIENCE).exit_code(), 0);
}
