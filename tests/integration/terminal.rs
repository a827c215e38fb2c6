//! The workbench as a person has it: a real terminal, from the first chart to the restored prompt.

use std::fs;
use std::io::Write as _;
use std::os::unix::process::CommandExt as _;
use std::process::Command;

use rustix::process::{Pid, Signal, WaitOptions, kill_process, waitpid};
use rustix::stdio::stdin;
use rustix::termios::tcsetpgrp;

use crate::pty::{Start, Terminal, wait_for_state};

/// The outcome in the table of runs, once there is one.
const DONE: &str = "arrested";

fn started() -> Terminal {
    let mut terminal = Terminal::start();
    terminal.wait_for(DONE);
    terminal
}

/// Give the impact velocity another value and wait until it is in force: the field is closed again.
fn shoot_at_150(terminal: &mut Terminal) {
    terminal.send("gjjjjjjj\r150\r");
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

    // A faster shot goes deeper, and the curve follows.
    let depth_before = depth_mm(&first);
    let chart_before = chart(terminal.screen());
    shoot_at_150(&mut terminal);
    let second = terminal.wait_until("a deeper shot", |screen| {
        depth_mm(&screen.contents()) > depth_before && chart(screen) != chart_before
    });
    let depth = depth_mm(&second).expect("a depth");

    terminal.send(" ");
    terminal.wait_for("oA   v_i=150");

    terminal.send("e");
    terminal.wait_for("Export the runs to CSV");
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
    let status = terminal.wait_exit();
    assert_eq!(status.exit_code(), 0);
    terminal.assert_restored();

    // What was done is there the next time.
    let mut again = Terminal::start_with(Start { home: terminal.home.take(), ..Start::default() });
    let restored = again.wait_until("the restored session", |screen| {
        screen.contents().contains("session restored") && screen.contents().contains(DONE)
    });
    assert!(restored.contains(" 150 m/s"), "{restored}");
    again.wait_for("oA   v_i=150");
    again.send("q");
    assert_eq!(again.wait_exit().exit_code(), 0);
}

/// Returns the depth in the title of its chart, mm; `None` on a screen that is drawn in part. A shorter title says what an edit changed.
fn depth_mm(screen: &str) -> Option<f64> {
    let titles = ["Penetration ", "Depth "];
    let (_, rest) = titles.iter().find_map(|title| screen.split_once(title))?;
    rest.split_whitespace().next()?.parse().ok()
}

/// Returns the part of the screen right of the variables, at 80 columns.
fn chart(screen: &vt100::Screen) -> Vec<String> {
    screen.rows(32, 48).skip(2).take(16).collect()
}

#[test]
fn resizing_redraws_in_the_new_size() {
    let mut terminal = started();
    terminal.resize(120, 40);
    terminal.wait_until("the frame fills 120 columns", |screen| {
        screen.contents().lines().any(|line| line.chars().count() > 100)
    });
    terminal.resize(30, 8);
    terminal.wait_for("60");
    terminal.resize(80, 24);
    terminal.wait_for(DONE);
    terminal.send("q");
    assert_eq!(terminal.wait_exit().exit_code(), 0);
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
        let status = terminal.wait_exit();
        assert_eq!(status.exit_code(), 129, "controlling: {controlling}");
        let kept = fs::read_to_string(terminal.session_file()).expect("the session was saved");
        assert!(kept.contains("150"), "{kept}");
    }
}

/// A workbench that was stopped while it saved holds the lock for ever.
#[test]
fn edits_reach_the_disk_beside_a_lock_that_another_holds() {
    for hangs_up in [true, false] {
        let home = tempfile::tempdir().unwrap();
        let folder = home.path().join("state/cmra");
        fs::create_dir_all(&folder).unwrap();
        let lock = fs::File::create(folder.join("session.lock")).unwrap();
        lock.lock().unwrap();
        let mut terminal = Terminal::start_with(Start { home: Some(home), ..Start::default() });
        terminal.wait_for(DONE);
        shoot_at_150(&mut terminal);
        if hangs_up {
            terminal.hang_up();
        } else {
            terminal.signal(Signal::TERM);
        }
        assert_eq!(terminal.wait_exit().exit_code(), if hangs_up { 129 } else { 143 });
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
        let status = terminal.wait_exit();
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
        assert_eq!(terminal.wait_exit().exit_code(), code, "{signal:?}");
        terminal.assert_restored();
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_limit_on_the_size_of_files_does_not_end_the_workbench() {
    let mut terminal = Terminal::start_with(Start {
        shell: Some("/bin/sh"),
        arguments: &["-c", "ulimit -f 0; exec \"$CMRA\""],
        ..Start::default()
    });
    terminal.wait_for(DONE);
    shoot_at_150(&mut terminal);
    terminal.wait_for("the session cannot be kept");
    terminal.send("q");
    terminal.wait_for("q again quits without it");
    terminal.send("q");
    assert_eq!(terminal.wait_exit().exit_code(), 0);
    terminal.assert_restored();
}

#[test]
fn a_terminal_that_takes_no_bytes_does_not_hold_up_the_end() {
    let mut terminal = Terminal::start();
    // Of one that never answers nothing is asked any more, and frames do not wait for each other.
    terminal.answers = false;
    terminal.wait_for(DONE);
    for _ in 0..4 {
        terminal.sync();
    }
    switch_mouse_on(&mut terminal);
    shoot_at_150(&mut terminal);
    terminal.stop_taking();
    draw_until_stuck(&mut terminal);
    terminal.signal(Signal::TERM);
    assert_eq!(terminal.wait_exit().exit_code(), 143);
    // A reader that continues finds the terminal unchanged.
    terminal.take_again();
    terminal.assert_restored();
    let kept = fs::read_to_string(terminal.session_file()).expect("the session was saved");
    assert!(kept.contains("150"), "{kept}");
}

fn switch_mouse_on(terminal: &mut Terminal) {
    terminal.send("M");
    terminal.wait_until("mouse reports", |screen| {
        screen.mouse_protocol_mode() == vt100::MouseProtocolMode::PressRelease
    });
}

/// Have frames drawn until a thread waits for room in the terminal, which takes no bytes.
fn draw_until_stuck(terminal: &mut Terminal) {
    let process = terminal.process();
    let is_stuck = || {
        let threads = fs::read_dir(format!("/proc/{process}/task")).expect("it is there");
        threads.flatten().any(|thread| {
            // The first number is that of the system call: to write is 1 on x86, 64 on others. Not every kernel tells.
            let call = fs::read_to_string(thread.path().join("syscall"));
            call.map_or(true, |call| call.starts_with("1 ") || call.starts_with("64 "))
        })
    };
    crate::pty::wait_while("no write is stuck", || {
        terminal.send("\x0c");
        !is_stuck()
    });
}

#[test]
fn ctrl_z_stops_and_a_continuation_comes_back() {
    stops_and_comes_back(|terminal, _process| terminal.send("\x1a"));
}

#[test]
fn a_stop_from_outside_restores_the_terminal_and_a_continuation_comes_back() {
    stops_and_comes_back(|_terminal, process| {
        kill_process(process, Signal::TSTP).expect("it is there");
    });
}

/// Runs a job as a shell does: it hands over the terminal, and reports each stop and the end.
#[test]
#[ignore = "run by the tests above, in a terminal of its own"]
#[expect(
    clippy::zombie_processes,
    reason = "it is waited for by its number, which reports stops too"
)]
fn a_shell() {
    let Some(program) = std::env::var_os("CMRA") else { return };
    let job = Command::new(program).process_group(0).spawn().expect("it starts");
    let job = Pid::from_raw(job.id().try_into().expect("a number")).expect("not zero");
    tcsetpgrp(stdin(), job).expect("the terminal is ours");
    // A job that was faster has been stopped: it asked something of a terminal that was not yet its own.
    kill_process(job, Signal::CONT).expect("it is there");
    let tell = |text: &str| drop(write!(std::io::stderr(), "\r\n{text}> "));
    tell(&format!("job {}", job.as_raw_nonzero()));
    while let Ok(Some((_, status))) = waitpid(Some(job), WaitOptions::UNTRACED) {
        if status.stopped() {
            tell("stopped");
        } else {
            tell("ended");
            return;
        }
    }
}

/// The workbench as a job of a shell, stopped in some way.
fn stopped(stop: impl Fn(&mut Terminal, Pid)) -> Terminal {
    let program = std::env::current_exe().unwrap();
    let mut terminal = Terminal::start_with(Start {
        shell: program.to_str(),
        arguments: &["--ignored", "--exact", "terminal::a_shell", "--nocapture"],
        ..Start::default()
    });
    terminal.wait_for(DONE);
    let text = terminal.text();
    let (_, job) = text.split_once("job ").expect("its number");
    let number = job.split_once('>').expect("its end").0.to_owned();
    let job = Pid::from_raw(number.parse().expect("a number")).expect("not zero");
    terminal.job = Some(job);
    stop(&mut terminal, job);
    wait_for_state(&number, 'T');
    terminal.wait_until("stopped", |screen| {
        !screen.alternate_screen() && screen.contents().contains("stopped>")
    });
    terminal.assert_restored();
    terminal
}

fn stops_and_comes_back(stop: impl Fn(&mut Terminal, Pid)) {
    let mut terminal = stopped(stop);
    terminal.go_on();
    terminal.wait_until("the workbench again", |screen| {
        screen.alternate_screen() && screen.contents().contains(DONE)
    });
    // It listens again.
    terminal.send("q");
    terminal.wait_until("ended", |screen| {
        !screen.alternate_screen() && screen.contents().contains("ended>")
    });
    assert_eq!(terminal.wait_exit().exit_code(), 0);
}

#[test]
fn the_mouse_belongs_to_the_terminal_until_it_is_switched_on() {
    let mut terminal = started();
    assert_eq!(terminal.screen().mouse_protocol_mode(), vt100::MouseProtocolMode::None);
    switch_mouse_on(&mut terminal);
    // The wheel, one notch down, over the list of variables (SGR report, button 65).
    terminal.send("\x1b[<65;5;8M");
    terminal.wait_for("> d ");
    terminal.send("q");
    assert_eq!(terminal.wait_exit().exit_code(), 0);
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
    assert_eq!(terminal.wait_exit().exit_code(), 0);
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
    assert_eq!(terminal.wait_exit().exit_code(), 0);
}

#[test]
fn stopped_and_continued_from_outside_it_redraws() {
    let mut terminal = started();
    terminal.signal(Signal::STOP);
    let process = terminal.process();
    wait_for_state(&process, 'T');
    // Someone clears the screen meanwhile.
    terminal.scribble(b"\x1b[2J");
    terminal.signal(Signal::CONT);
    terminal.wait_for(DONE);
    terminal.send("q");
    assert_eq!(terminal.wait_exit().exit_code(), 0);
    terminal.assert_restored();
}

/// The rate of frames has tests of its own, by a clock that is handed in (`tui::pace`).
#[test]
fn bytes_stay_few() {
    let mut terminal = Terminal::start_with(Start { arguments: &["--fresh"], ..Start::default() });
    terminal.wait_for(DONE);
    terminal.send("jjjjjjj");
    for key in ["l", "L"] {
        terminal.send(key);
    }
    terminal.sync();
    // A key held for two seconds, thirty times a second, in one go.
    terminal.send(&"l".repeat(60));
    terminal.wait_for(" 170 m/s");
    let frames = terminal.frames();
    assert!(frames.len() > 2 && frames.iter().all(|bytes| *bytes <= 4096), "{frames:?}");
    terminal.send("q");
    assert_eq!(terminal.wait_exit().exit_code(), 0);
}

/// Whether a screen shows what a key does.
type Seen = Box<dyn Fn(&vt100::Screen) -> bool>;

/// A frame of 1 kB takes 0.2 s on a line of 5 kB/s. Another time range or a step leaves what it does not concern in its place.
#[test]
fn a_key_on_run_sends_at_most_1_kb() {
    let mut terminal = started();
    terminal.sync();
    let title =
        |title: &'static str| move |screen: &vt100::Screen| screen.contents().contains(title);
    let keys: [(&str, Seen); 7] = [
        ("c", Box::new(title(", whole 4.572"))),
        ("c", Box::new(title("4.572 mm (64 % of rigid mount)"))),
        ("l", Box::new(title("4.700 mm"))),
        ("h", Box::new(title("4.572 mm (64 % of rigid mount)"))),
        ("j", Box::new(title("> d "))),
        ("k", Box::new(title("> gamma"))),
        (" ", Box::new(title("pinned as A"))),
    ];
    for (key, seen) in keys {
        terminal.forget();
        terminal.send(key);
        terminal.wait_until(key, seen);
        let frames = terminal.frames();
        let sent: usize = frames.iter().sum();
        assert!((1..=1000).contains(&sent), "{key}: {frames:?}");
    }
    terminal.send("q");
    assert_eq!(terminal.wait_exit().exit_code(), 0);
}

/// Text of the shell stays where there is no alternate screen: it is cleared on entering, and the screen is on leaving.
#[test]
fn without_an_alternate_screen_nothing_of_the_shell_stays_between_the_digits() {
    let mut terminal = Terminal::start_with(Start {
        alternate: false,
        before: &"old shell text ".repeat(200),
        ..Start::default()
    });
    let page = terminal.wait_for(DONE);
    assert!(!page.contains("old shell"), "{page}");
    terminal.send("q");
    assert_eq!(terminal.wait_exit().exit_code(), 0);
    assert_eq!(terminal.screen().contents().trim(), "");
    assert_eq!(terminal.screen().cursor_position(), (0, 0));
}

#[test]
fn the_size_is_asked_after_a_stop_and_on_a_redraw() {
    let mut terminal = stopped(|terminal, _| terminal.send("\x1a"));
    // The shell's window changes: the program is not told, since the signal goes to the shell.
    terminal.resize(120, 40);
    terminal.go_on();
    terminal.wait_until("the frame fills 120 columns", |screen| {
        screen.contents().lines().any(|line| line.chars().count() > 100)
    });
    terminal.send("q");
    terminal.wait_for("ended>");
}

/// Keys that are split between packets have tests of their own, by a clock that is handed in (`tui::input`).
#[test]
fn a_paste_is_text_and_what_is_no_key_is_swallowed() {
    let mut terminal = started();
    terminal.send("gjjjjjjj\r");
    terminal.send("\x1b[200~150\x1b[201~\r");
    terminal.wait_until("the pasted velocity", |screen| {
        screen.hide_cursor() && screen.contents().contains(" 150 m/s")
    });
    // F5, and answers to questions of another program: none of their bytes is a key.
    terminal.send("\x1b[15~\x1b]11;rgb:ffff/ffff/ffff\x1b\\\x1b[>41;380;0c\x1bP>|xterm(380)\x1b\\");
    terminal.sync();
    let page = terminal.screen().contents();
    assert!(page.contains("[1:Run]") && page.contains(" 150 m/s"), "{page}");
    terminal.send("q");
    assert_eq!(terminal.wait_exit().exit_code(), 0);
}

#[test]
fn escape_and_a_key_in_one_packet_both_count() {
    let mut terminal = started();
    terminal.send("p");
    terminal.wait_for("Baseline of chapter 9");
    terminal.send("\x1b2");
    terminal.wait_until("the list is closed, and the second tab is open", |screen| {
        let text = screen.contents();
        text.contains("[2:") && !text.contains("Baseline of chapter 9")
    });
    terminal.send("q");
    assert_eq!(terminal.wait_exit().exit_code(), 0);
}

/// When frames are drawn has tests of its own, by a clock that is handed in (`tui::pace`).
#[test]
fn frames_ask_whether_they_have_arrived_unless_the_terminal_never_answers() {
    let asked = |terminal: &Terminal| terminal.text().matches("\x1b[5n").count();
    let mut terminal = started();
    terminal.sync();
    assert!(asked(&terminal) >= 2);
    terminal.send("q");
    assert_eq!(terminal.wait_exit().exit_code(), 0);
    let mut mute = Terminal::start();
    mute.answers = false;
    mute.wait_for(DONE);
    for _ in 0..6 {
        mute.sync();
    }
    // The third is asked while the second may still be answered.
    assert_eq!(asked(&mute), 3);
    mute.send("q");
    assert_eq!(mute.wait_exit().exit_code(), 0);
}

/// A screen reader follows the cursor, which nobody sees.
#[test]
fn the_hidden_cursor_stands_on_the_selected_row() {
    let mut terminal = started();
    let row = |screen: &vt100::Screen| {
        let (row, _) = screen.cursor_position();
        screen.contents().lines().nth(row.into()).unwrap_or_default().to_owned()
    };
    for _ in 0..3 {
        terminal.wait_until("the cursor on the selected row", |screen| {
            screen.hide_cursor() && row(screen).contains('>')
        });
        terminal.send("j");
    }
    terminal.send("q");
    assert_eq!(terminal.wait_exit().exit_code(), 0);
}

#[test]
fn a_copy_under_tmux_says_what_tmux_needs() {
    let environment = &[("TMUX", "/tmp/tmux-0/default,1,0")];
    let mut terminal = Terminal::start_with(Start { environment, ..Start::default() });
    terminal.wait_for(DONE);
    terminal.send("y");
    terminal.wait_for("set-clipboard on");
    terminal.send("q");
    assert_eq!(terminal.wait_exit().exit_code(), 0);
}

#[test]
fn a_copy_in_gnu_screen_says_that_it_does_not_arrive() {
    let environment = &[("STY", "4711.pts-0.host")];
    let mut terminal = Terminal::start_with(Start { environment, ..Start::default() });
    terminal.wait_for(DONE);
    terminal.send("y");
    terminal.wait_for("GNU screen does not pass");
    // A program before this one has left the keyboard protocol of kitty on.
    terminal.send("\x1b[113u");
    assert_eq!(terminal.wait_exit().exit_code(), 0);
}

/// A key that the configuration gives an action works in dialogs, too.
#[test]
fn keys_of_the_configuration_reach_dialogs() {
    let home = tempfile::tempdir().unwrap();
    let folder = home.path().join("config/cmra");
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("config.toml"), "[keys]\ndown = [\"n\"]\n").unwrap();
    let mut terminal = Terminal::start_with(Start { home: Some(home), ..Start::default() });
    terminal.wait_for(DONE);
    terminal.send("?");
    let row = |terminal: &Terminal| terminal.screen().cursor_position().0;
    terminal.sync();
    let first = row(&terminal);
    terminal.send("n");
    terminal.sync();
    assert_eq!(row(&terminal), first + 1, "{}", terminal.screen().contents());
    terminal.send("q");
    terminal.sync();
    terminal.send("q");
    assert_eq!(terminal.wait_exit().exit_code(), 0);
}

/// A person's first steps at the usual sizes: edit gamma, pin two runs, export them, open a figure, save, return.
#[test]
fn the_first_steps_at_every_size() {
    const FIRST: [&str; 8] = [
        "[1:Run]",
        "Design variables",
        "Analysis variables",
        "Penetration 4.572 mm (64 % of rigid mount)",
        "Contact force, peak 17.74 kN",
        "Plate displacement",
        "greatest 38.38 mm",
        "error ",
    ];
    const MAIN: [&str; 14] =
        ["gamma", "d", "k", "n", "b", "m", "x_stop", "v_i", "m_p", "R", "h", "rho", "S_y", "C_d"];
    for (columns, lines) in [(80, 24), (100, 30), (120, 36), (160, 48)] {
        let mut terminal = Terminal::start();
        terminal.resize(columns, lines);
        let first = terminal.wait_until("the first screen", |screen| {
            let text = screen.contents();
            FIRST.iter().all(|word| text.contains(word)) && text.contains(DONE)
        });
        let rows: Vec<&str> =
            first.lines().map(|line| line.trim_start_matches(['│', '>', ' '])).collect();
        for symbol in MAIN {
            let is_row = |row: &&str| row.split_whitespace().next() == Some(symbol);
            assert!(rows.iter().any(is_row), "{columns}x{lines}: {symbol}\n{first}");
        }
        // The meaning and range of the selected row.
        assert!(first.contains("thesis 0.8 to 7"), "{columns}x{lines}\n{first}");

        let mut before = depth_mm(&first);
        for gamma in ["2", "4"] {
            terminal.send(&format!("g\r{gamma}\r"));
            let kg = format!("{gamma} (");
            let heavier = terminal.wait_until("a heavier plate", |screen| {
                screen.contents().contains(&kg) && depth_mm(&screen.contents()) > before
            });
            before = depth_mm(&heavier);
            terminal.send(" ");
            terminal.wait_for(&format!("gamma={gamma}"));
        }
        terminal.send("g\r1\r");
        terminal.wait_until("the two pins and the scene", |screen| {
            let text = screen.contents();
            let now = text.lines().find(|line| line.starts_with("*now"));
            now.is_some_and(|line| line.contains(" 4.572 "))
                && ["gamma=2", "gamma=4"].iter().all(|pin| text.contains(pin))
        });

        terminal.send("e");
        terminal.wait_for("Export the runs to CSV");
        terminal.send("\x15both.csv\r");
        terminal.wait_for("written");
        let text = fs::read_to_string(terminal.file("both.csv")).expect("it has been written");
        for run in ["now", "A", "B"] {
            let has = text.lines().any(|row| row.split(',').any(|cell| cell == run));
            assert!(has, "{columns}x{lines}: {run} is missing");
        }

        terminal.send("p9.8\r");
        terminal.wait_for("[2:Explore]");
        // What is only looked at has little time: all of it is asked for.
        terminal.send("r");
        let figure = terminal.wait_for("faint: the ");
        assert!(figure.contains("[2:Explore]") && figure.contains("gamma"), "{figure}");

        terminal.send("1s");
        terminal.wait_for("Save");
        terminal.send("\x15mine\r");
        terminal.wait_for("saved");
        terminal.send("q");
        assert!(terminal.wait_exit().success());
        let home = terminal.home.take();
        let mut again = Terminal::start_with(Start { home, ..Start::default() });
        again.wait_until("what was left", |screen| screen.contents().contains("mine"));
        again.send("q");
        assert!(again.wait_exit().success());
    }
}
