//! The workbench under a person who never rests: random keys, resizes, clicks and pastes over all tabs.

use std::fs;
use std::io::Write as _;
use std::time::{Duration, Instant};

use rustix::process::Signal;

use crate::pty::Terminal;
use crate::random::Random;

/// How long, s, unless the environment says otherwise.
const LASTS_S: u64 = 120;

/// Keys that do something somewhere; those that leave or suspend, and `:`, which reaches them, are not among them.
const KEYS: [&str; 56] = [
    "1", "2", "3", "4", "5", "6", "7", "8", "9", "{", "}", "j", "k", "h", "l", "J", "K", "H", "L",
    ",", ".", "g", "G", "u", "\x12", "\r", "\r", "\x1b", "\x1b", "\t", " ", "/", "e", "y", "s",
    "p", "o", "c", "d", "m", "r", "v", "w", "x", "z", "?", "t", "M", "R", "[", "]", "X", "Y",
    "\x1b[A", "\x1b[B", "0.5",
];

/// Parts of the time, at the end of each of which the memory is noted.
const PARTS: u32 = 12;

/// Two lines, as a person pastes them.
const PASTE: &str = "\x1b[200~gamma=2\nx\x1b[201~";

/// The memory that a process has now, MB; none once it has ended.
fn memory(process: &str) -> Option<u64> {
    let status = fs::read_to_string(format!("/proc/{process}/status")).ok()?;
    let now = status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
    Some(now.trim().trim_end_matches(" kB").parse::<u64>().expect("a number") / 1024)
}

#[cfg(target_os = "linux")]
#[test]
#[ignore = "takes two minutes"]
fn random_keys_resizes_clicks_and_pastes_do_no_harm() {
    let lasts = std::env::var("CMRA_SOAK_S").ok().and_then(|seconds| seconds.parse().ok());
    let lasts = Duration::from_secs(lasts.unwrap_or(LASTS_S));
    let mut terminal = Terminal::start();
    terminal.wait_for("arrested");
    let process = terminal.process();
    let (mut random, start) = (Random(16), Instant::now());
    let first = memory(&process).expect("it runs");
    let (mut most, mut events) = (first, 0_u64);
    let mut rows = 24;
    let mut sent: Vec<String> = Vec::new();
    let mut noted = Vec::new();
    while start.elapsed() < lasts {
        let choice = random.below(40);
        if choice < 2 {
            // Keys wait in the terminal, a change of its size does not: a click that is read after it would hit another row.
            terminal.sync();
        }
        match choice {
            0 => {
                rows = 1 + random.below(60);
                let columns = 1 + random.below(200);
                sent.push(format!("{columns}x{rows}"));
                terminal.resize(columns.try_into().unwrap(), rows.try_into().unwrap());
            }
            1 => {
                // Not on the last row, where a click on a key's name presses it: one of them leaves.
                let (column, row) = (random.below(90), random.below(rows));
                sent.push(format!("\x1b[<0;{column};{row}M"));
                terminal.send(&sent[sent.len() - 1]);
            }
            _ => {
                let keys = if choice == 2 { PASTE } else { random.of(&KEYS) };
                sent.push(keys.to_owned());
                terminal.send(keys);
            }
        }
        events += 1;
        if events.is_multiple_of(8) {
            terminal.sync();
            terminal.forget();
        }
        sent.drain(..sent.len().saturating_sub(60));
        let Some(now) = memory(&process) else {
            let status = terminal.wait_exit();
            let screen = terminal.screen().contents();
            panic!("it ended after {events} events, {status:?}; the last: {sent:?}\n{screen}");
        };
        most = most.max(now);
        if start.elapsed() > lasts * (u32::try_from(noted.len()).unwrap() + 1) / PARTS {
            noted.push(now);
        }
    }
    let last = memory(&process).expect("it runs");
    let _ = writeln!(
        std::io::stderr(),
        "{events} events: {first} MB at the start, {last} MB at the end, {most} MB at most; each twelfth: {noted:?}"
    );
    terminal.signal(Signal::TERM);
    assert_eq!(terminal.wait_exit().exit_code(), 143);
    terminal.assert_restored();
}
