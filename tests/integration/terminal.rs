//! The workbench as a person has it: a real terminal, from the first chart to the restored prompt.

use std::fs;
use std::time::Duration;

use rustix::process::Signal;

use crate::pty::{PATIENCE, Start, Terminal, wait_for_state};

/// Longest quiet time within one answer of the program.
const QUIET: Duration = Duration::from_millis(300);

/// The status row of a finished run of the baseline.
const DONE: &str = "arrested";

fn started() -> Terminal {
    let mut terminal = Terminal::start();
    terminal.wait_for(DONE);
    terminal
}

/// Give the impact velocity another value and wait until it is in force: the field is closed again.
fn shoot_at_150(terminal: &mut Terminal) {
    terminal.send("jj\r150\r");
    terminal.wait_until("the new velocity", |screen| {
        screen.hide_cursor() && screen.contents().contains(" 150 m/s")
    });
}

#[test]
fn a_session_from_the_first_chart_to_the_prompt() {
    let mut terminal = Terminal::start();
    let first = terminal.wait_for(DONE);
    assert!(first.contains("Penetration"), "{first}");
    assert!(terminal.screen().alternate_screen());
    assert!(terminal.screen().bracketed_paste());
    terminal.settle(QUIET);

    // A faster shot goes deeper, and the curve follows.
    let (chart_before, depth_before) = (chart(&terminal), depth_mm(&first));
    shoot_at_150(&mut terminal);
    terminal.settle(QUIET);
    let depth = depth_mm(&terminal.screen().contents());
    assert!(depth > depth_before, "{depth} after {depth_before}");
    assert_ne!(chart(&terminal), chart_before);

    terminal.send(" ");
    terminal.wait_for("A v_i=150  * now");

    terminal.send("e");
    terminal.wait_for("Export to CSV");
    // Ctrl-U empties the field.
    terminal.send("\x15here.csv\r");
    terminal.wait_for("written");
    let text = fs::read_to_string(terminal.file("here.csv")).expect("it has been written");
    let mut rows = csv::Reader::from_reader(text.as_bytes());
    let column = rows.headers().expect("a header").iter().position(|name| name == "penetration_m");
    let depths: Vec<f64> = rows
        .records()
        .map(|row| row.expect("a row")[column.expect("depths")].parse().expect("a number"))
        .collect();
    // What the file has is what the screen shows, to the digits shown.
    let deepest_mm = depths.iter().fold(0.0, |a: f64, b| a.max(*b)) * 1e3;
    assert!((deepest_mm - depth).abs() <= 0.0005 + 1e-9, "{deepest_mm} and {depth}");
    assert!(terminal.file("here.toml").exists());

    terminal.send("q");
    let status = terminal.wait_exit(PATIENCE);
    assert_eq!(status.exit_code(), 0);
    terminal.assert_restored();

    // What was done is there the next time.
    let mut again = Terminal::start_with(Start { home: terminal.home.take(), ..Start::default() });
    let restored = again.wait_until("the restored session", |screen| {
        screen.contents().contains("session restored") && screen.contents().contains(DONE)
    });
    assert!(restored.contains(" 150 m/s"), "{restored}");
    again.wait_for("A v_i=150");
    again.send("q");
    assert_eq!(again.wait_exit(PATIENCE).exit_code(), 0);
}

/// The depth at first arrest on the screen, mm.
fn depth_mm(screen: &str) -> f64 {
    let line = screen.lines().find(|line| line.contains(" mm  first arrest"));
    let (_, rest) = line.and_then(|it| it.split_once("now ")).expect("the line of results");
    let number = rest.split_whitespace().next().expect("a number");
    number.parse().expect("a number")
}

/// What is drawn right of the variables, at 80 columns.
fn chart(terminal: &Terminal) -> Vec<String> {
    terminal.screen().rows(32, 48).skip(2).take(16).collect()
}

#[test]
fn a_summary_can_stay_on_the_main_screen() {
    let mut terminal = started();
    let depth = depth_mm(&terminal.screen().contents());
    // All of it is to be seen.
    terminal.resize(120, 60);
    terminal.send("Q");
    assert_eq!(terminal.wait_exit(PATIENCE).exit_code(), 0);
    terminal.assert_restored();
    let left = terminal.screen().contents();
    assert!(left.contains("arrested") && left.contains(&depth.to_string()), "{left}");
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
        shoot_at_150(&mut terminal);
        terminal.hang_up();
        let status = terminal.wait_exit(PATIENCE);
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
        shoot_at_150(&mut terminal);
        terminal.signal(signal);
        let status = terminal.wait_exit(PATIENCE);
        assert_eq!(status.exit_code(), code, "{signal:?}");
        terminal.assert_restored();
        assert!(fs::read_to_string(terminal.session_file()).is_ok_and(|kept| kept.contains("150")));
    }
}

/// Each ends a process by default, without a word to the terminal. Numbers as on Linux: USR1 10, USR2 12, ALRM 14, XCPU 24.
#[cfg(target_os = "linux")]
#[test]
fn unexpected_signals_restore_the_terminal_too() {
    for (signal, code) in
        [(Signal::USR1, 138), (Signal::USR2, 140), (Signal::ALARM, 142), (Signal::XCPU, 152)]
    {
        let mut terminal = Terminal::start();
        terminal.wait_for(DONE);
        terminal.signal(signal);
        assert_eq!(terminal.wait_exit(PATIENCE).exit_code(), code, "{signal:?}");
        terminal.assert_restored();
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_limit_on_the_size_of_files_does_not_end_the_workbench() {
    let mut terminal = Terminal::start_with(Start {
        shell: Some("/bin/sh"),
        arguments: &["-c", "ulimit -f 0; exec $CMRA"],
        ..Start::default()
    });
    terminal.wait_for(DONE);
    shoot_at_150(&mut terminal);
    terminal.wait_for("the session cannot be kept");
    terminal.send("q");
    terminal.wait_for("q again quits without it");
    terminal.send("q");
    assert_eq!(terminal.wait_exit(PATIENCE).exit_code(), 0);
    terminal.assert_restored();
}

#[test]
fn a_terminal_that_takes_no_bytes_does_not_hold_up_the_end() {
    let mut terminal = started();
    terminal.send(":mouse\r");
    terminal.wait_until("mouse reports", |screen| {
        screen.mouse_protocol_mode() == vt100::MouseProtocolMode::PressRelease
    });
    shoot_at_150(&mut terminal);
    terminal.stop_taking();
    // Some 60 frames are more than a pseudo-terminal keeps for a reader that does not read.
    for _ in 0..60 {
        terminal.send("\x0c");
        terminal.settle(Duration::from_millis(50));
    }
    // It is stuck in a write: it would draw, and nothing comes.
    terminal.signal(Signal::TERM);
    assert_eq!(terminal.wait_exit(PATIENCE).exit_code(), 143);
    // A reader that continues finds the terminal unchanged.
    terminal.take_again();
    terminal.assert_restored();
    let kept = fs::read_to_string(terminal.session_file()).expect("the session was saved");
    assert!(kept.contains("150"), "{kept}");
}

/// Wait until the shell has the terminal again and has asked this often.
fn at_prompt(terminal: &mut Terminal, prompts: usize) {
    terminal.wait_until("the shell's prompt", |screen| {
        !screen.alternate_screen() && screen.contents().matches("prompt>").count() == prompts
    });
}

#[test]
fn ctrl_z_stops_and_fg_comes_back() {
    stops_and_comes_back(|terminal, _process| terminal.send("\x1a"));
}

#[test]
fn a_stop_from_outside_restores_the_terminal_and_fg_comes_back() {
    stops_and_comes_back(|_terminal, process| {
        let told = std::process::Command::new("kill").args(["-TSTP", process]).status();
        assert!(told.expect("it runs").success());
    });
}

/// The workbench as a job of a shell, stopped in some way.
fn stops_and_comes_back(stop: impl Fn(&mut Terminal, &str)) {
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
    stop(&mut terminal, process);
    wait_for_state(process, 'T');
    at_prompt(&mut terminal, 2);
    assert!(terminal.screen().contents().contains("Stopped"));
    assert!(!terminal.screen().hide_cursor());
    assert!(!terminal.screen().bracketed_paste());
    terminal.send("echo alive\r");
    at_prompt(&mut terminal, 3);
    assert_eq!(terminal.screen().contents().matches("alive").count(), 2);
    terminal.send("fg\r");
    terminal.wait_until("the workbench again", |screen| {
        screen.alternate_screen() && screen.contents().contains(DONE)
    });
    terminal.settle(QUIET);
    // It listens again.
    terminal.send("q");
    at_prompt(&mut terminal, 4);
    terminal.send("exit\r");
    assert_eq!(terminal.wait_exit(PATIENCE).exit_code(), 0);
}

#[test]
fn the_mouse_belongs_to_the_terminal_until_it_is_switched_on() {
    let mut terminal = started();
    assert_eq!(terminal.screen().mouse_protocol_mode(), vt100::MouseProtocolMode::None);
    terminal.send(":mouse\r");
    terminal.wait_until("mouse reports", |screen| {
        screen.mouse_protocol_mode() == vt100::MouseProtocolMode::PressRelease
    });
    // The wheel, one notch down, over the list of variables (SGR report, button 65).
    terminal.send("\x1b[<65;5;8M");
    terminal.wait_for("> R ");
    terminal.send("q");
    assert_eq!(terminal.wait_exit(PATIENCE).exit_code(), 0);
    terminal.assert_restored();
}

/// Esc and an arrow that arrive together: the arrow steps the value, and nothing is taken for a letter.
#[test]
fn an_arrow_right_after_an_escape_is_an_arrow() {
    let mut terminal = started();
    shoot_at_150(&mut terminal);
    // Esc and Left in one write.
    terminal.send("\x1b\x1b[D");
    terminal.wait_for(" 149 m/s");
    terminal.send("q");
    assert_eq!(terminal.wait_exit(PATIENCE).exit_code(), 0);
}

#[test]
fn without_a_shell_ctrl_z_is_refused() {
    let mut terminal = started();
    terminal.send("\x1a");
    terminal.wait_for("cannot suspend");
    // Nor from outside: there it is ignored, as the system ignores it.
    terminal.signal(Signal::TSTP);
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
    terminal.send("L");
    let coarse = terminal.settle(QUIET);
    assert!((1..=4096).contains(&coarse), "a coarse nudge: {coarse} bytes");
    // A key held for two seconds, thirty times a second, in one go: frames are omitted.
    for _ in 0..60 {
        terminal.send("l");
    }
    let held = terminal.settle(QUIET);
    assert!(held <= 12 * 4096, "a held key: {held} bytes");
    terminal.send("q");
    assert_eq!(terminal.wait_exit(PATIENCE).exit_code(), 0);
}
