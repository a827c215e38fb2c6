//! The workbench where the world is against it: pipes in the place of its files, another workbench beside it, absurd windows,
//! devices as targets, and a person who leaves in the middle of everything.

use std::fs;
use std::path::Path;

use crate::hostile::pipe;
use crate::pty::{Start, Terminal, wait_while};

/// The status row of a finished run of the baseline.
const DONE: &str = "arrested";

fn started(start: Start<'_>) -> Terminal {
    let mut terminal = Terminal::start_with(start);
    terminal.wait_for(DONE);
    terminal
}

/// Close a dialog, and wait until this is no longer on the screen: a key that follows at once would make another one of Esc.
fn close(terminal: &mut Terminal, text: &str) {
    terminal.send("\x1b");
    terminal.wait_until("the dialog is closed", |screen| !screen.contents().contains(text));
}

/// Give the impact velocity, the first of the analysis variables, another value.
fn shoot_at(terminal: &mut Terminal, speed: &str) {
    terminal.send(&format!("gjjjjjjj\r{speed}\r"));
    let there = format!(" {speed} m/s");
    terminal.wait_until("the new velocity", |screen| {
        screen.hide_cursor() && screen.contents().contains(&there)
    });
}

/// Wait until a file holds this text.
fn wait_for_text(path: &Path, text: &str) {
    wait_while(&format!("no `{text}` in {}", path.display()), || {
        !fs::read_to_string(path).is_ok_and(|found| found.contains(text))
    });
}

#[test]
fn pipes_in_the_place_of_its_own_files_do_not_hold_it_up() {
    let home = tempfile::tempdir().unwrap();
    for name in ["state/cmra/session.toml", "data/cmra/presets/stuck.toml"] {
        pipe(&home.path().join(name));
    }
    let start = Start { home: Some(home), ..Start::default() };
    let mut terminal = Terminal::start_with(start);
    terminal.wait_for("session cannot be read");
    shoot_at(&mut terminal, "150");
    // The list of presets comes all the same.
    terminal.send("p");
    terminal.wait_for("Baseline of chapter 9");
    close(&mut terminal, "Baseline of chapter 9");
    terminal.send("q");
    assert_eq!(terminal.wait_exit().exit_code(), 0);
    terminal.assert_restored();
    // It would say so where it has waited in vain for the disk.
    assert!(!terminal.screen().contents().contains("not kept"));
    let kept = fs::read_to_string(terminal.session_file()).expect("an ordinary file by now");
    assert!(kept.contains("150"), "{kept}");
}

#[test]
fn two_workbenches_at_once_lose_nothing_of_each_other() {
    let shared = tempfile::tempdir().unwrap();
    let state = shared.path().to_str().unwrap();
    let session = shared.path().join("cmra/session.toml");
    let recent = |number: u32| shared.path().join(format!("cmra/recent/unsaved-{number}.toml"));
    let environment = &[("XDG_STATE_HOME", state)];
    let mut first = started(Start { environment, ..Start::default() });
    let mut second = started(Start { environment, ..Start::default() });
    shoot_at(&mut first, "150");
    wait_for_text(&session, "150.0");
    shoot_at(&mut second, "125");
    second.send("q");
    assert_eq!(second.wait_exit().exit_code(), 0);
    wait_for_text(&session, "125.0");
    wait_for_text(&recent(1), "150.0");
    // The first one goes on, and says what it has found.
    shoot_at(&mut first, "175");
    first.wait_for("another workbench");
    wait_for_text(&session, "175.0");
    wait_for_text(&recent(2), "125.0");
    first.send("q");
    assert_eq!(first.wait_exit().exit_code(), 0);
}

#[test]
fn a_window_of_absurd_size_is_drawn_on_in_part() {
    let mut terminal = started(Start::default());
    terminal.claim_size(u16::MAX, u16::MAX);
    terminal.sync();
    let status = fs::read_to_string(format!("/proc/{}/status", terminal.process())).unwrap();
    let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).unwrap();
    let kilobytes: u64 = peak.trim().trim_end_matches(" kB").parse().unwrap();
    assert!(kilobytes < 400_000, "{peak}");
    terminal.resize(80, 24);
    terminal.wait_for(DONE);
    terminal.send("q");
    assert_eq!(terminal.wait_exit().exit_code(), 0);
    terminal.assert_restored();
}

#[test]
fn an_export_to_the_terminal_device_is_refused() {
    let mut terminal = started(Start::default());
    terminal.send("e\x15/dev/tty\r");
    terminal.wait_for("is a device or a pipe");
    // Nor a scene to be read, which would take the keys.
    close(&mut terminal, "is a device or a pipe");
    terminal.send("p");
    terminal.sync();
    terminal.send("/dev/tty\r");
    // Enter has closed the list by now; an escape sent right before the next key would be read as Alt and that key.
    terminal.wait_for("`/dev/tty` is a device or a pipe");
    assert!(!terminal.screen().contents().contains("Baseline of chapter 9"));
    terminal.send("q");
    assert_eq!(terminal.wait_exit().exit_code(), 0);
    terminal.assert_restored();
}

#[test]
fn a_table_whose_name_is_taken_goes_by_another_one() {
    let mut terminal = started(Start::default());
    fs::write(terminal.file("taken.csv"), "mine").unwrap();
    // The Limit tab has a map, which takes a name when it is whole.
    terminal.send("3");
    terminal.wait_until("a look", |screen| {
        ["first look", "done | "].iter().any(|it| screen.contents().contains(it))
    });
    terminal.send("r");
    terminal.sync();
    terminal.wait_for("done | ");
    terminal.send("e\x15taken.csv\r");
    terminal.wait_for("o overwrite");
    terminal.send("\x1b");
    terminal.wait_for("Enter write");
    terminal.send("\x15free.csv\r");
    terminal.wait_for("written: ");
    assert_eq!(fs::read_to_string(terminal.file("taken.csv")).unwrap(), "mine");
    assert!(fs::read_to_string(terminal.file("free.csv")).unwrap().lines().count() > 2);
    terminal.send("q");
    assert_eq!(terminal.wait_exit().exit_code(), 0);
}

#[test]
fn leaving_waits_for_nothing_that_is_being_computed() {
    // A scene whose run takes all the work that a run may take.
    let home = tempfile::tempdir().unwrap();
    let scene = home.path().join("endless.toml");
    let text = "format = 1\nrun.horizon_s = 1e9\nmechanism.spring.exponent = 0.3\n";
    fs::write(&scene, text).unwrap();
    // The run itself and tabs that compute as they are looked at, which is short, and every study with the words that tell that it is under
    // way.
    let starts = [
        ("", "[1:Run]", ""),
        ("2", "[2:Explore]", ""),
        ("2r", "[2:Explore]", "sweeping: "),
        ("3", "[3:Limit]", ""),
        ("3r", "[3:Limit]", ""),
        ("4", "[Goal seek]", ""),
        ("4r", "[Goal seek]", "searching: "),
        ("44r", "[Pareto front]", "searching: "),
        ("444r", "[Sensitivity]", "searching: "),
        ("4444r", "[Monte Carlo]", "searching: "),
        ("5r", "[Accuracy]", "measuring"),
        ("55", "[Stability]", ""),
        ("55r", "[Stability]", "computing the map"),
        ("6", "[Claims]", ""),
        ("6r", "[Claims]", "checking the claims: "),
        ("7", "[7:Log]", ""),
    ];
    for (keys, shown, under_way) in starts {
        let arguments = [scene.to_str().unwrap()];
        let mut terminal =
            Terminal::start_with(Start { arguments: &arguments, ..Start::default() });
        terminal.wait_for("1:Run");
        for key in keys.chars() {
            terminal.send(&key.to_string());
            terminal.sync();
        }
        let screen = terminal.wait_for(under_way);
        assert!(screen.contains(shown), "{keys}: {screen}");
        // Keys may be pressed repeatedly on quitting.
        for _ in 0..200 {
            terminal.send("j");
        }
        // One of the two asks whether to leave a running job.
        terminal.send("qq");
        assert_eq!(terminal.wait_exit().exit_code(), 0, "{keys}");
        terminal.assert_restored();
    }
}

#[test]
fn very_long_input_fills_a_field_only() {
    let mut terminal = started(Start::default());
    terminal.send("\r");
    for _ in 0..20 {
        terminal.send(&"1".repeat(1000));
    }
    terminal.send("\r");
    terminal.wait_for("not a finite number");
    close(&mut terminal, "not a finite number");
    terminal.send("q");
    assert_eq!(terminal.wait_exit().exit_code(), 0);
}
