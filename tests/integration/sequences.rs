//! Bytes that no terminal should send, and some do: none of them ends the workbench.

use rustix::process::Signal;

use crate::pty::Terminal;
use crate::random::Random;

/// The status row of a finished run of the baseline.
const DONE: &str = "arrested";

/// Numbers in control sequences: the least, those just inside and outside of a byte, of a column of the old mouse report, and of
/// sixteen bits. None is the code of a key that leaves, and none begins a paste.
const NUMBERS: [&str; 12] =
    ["", "0", "1", "2", "5", "9", "31", "32", "223", "255", "65535", "99999999999"];

/// The control sequence with these numbers, by its first and its last bytes.
fn control(first: &str, numbers: &[&str], last: char) -> Vec<u8> {
    format!("\x1b[{first}{}{last}", numbers.join(";")).into_bytes()
}

/// Sequences that overflow in crossterm 0.29: coordinates of zero.
fn known() -> Vec<Vec<u8>> {
    ["\x1b[<0;0;5M", "\x1b[<0;5;0m", "\x1b[0;1R", "\x1b[1;0R", "\x1b[32;0;0M", "\x1b[M   "]
        .map(|sequence| sequence.as_bytes().to_vec())
        .to_vec()
}

/// Every kind of sequence, by its last byte, with no, one and three numbers; and the old mouse report with every sixth byte.
fn every_kind() -> Vec<Vec<u8>> {
    let mut all = Vec::new();
    for last in (0x40..0x7f_u8).map(char::from) {
        for first in ["", "<", "?", ">"] {
            for number in NUMBERS {
                all.push(control(first, &[number], last));
            }
            all.push(control(first, &["0", "0", "0"], last));
            all.push(control(first, &["1", "1:0", "0"], last));
        }
        all.push(vec![0x1b, b'O', last as u8]);
    }
    for button in (0x20..=0xff).step_by(6) {
        for place in [0x20, 0x21, 0x7f, 0xff] {
            all.push(vec![0x1b, b'[', b'M', button, place, 0x20]);
            all.push(vec![0x1b, b'[', b'M', button, 0x20, place]);
        }
    }
    all
}

/// Random ones, of which about half are well-formed.
fn random(count: usize) -> Vec<Vec<u8>> {
    let mut random = Random(16);
    let mut draw = |below: usize| random.below(below);
    let mut all = Vec::new();
    for _ in 0..count {
        let first = ["", "", "<", "?"][draw(4)];
        let numbers: Vec<&str> = (0..draw(5)).map(|_| NUMBERS[draw(NUMBERS.len())]).collect();
        // Broken off earlier, a sequence leaves its last byte as a key: not the one that leaves.
        let last = char::from(0x40 + u8::try_from(draw(0x3f)).unwrap());
        let last = if last.eq_ignore_ascii_case(&'q') { 'x' } else { last };
        let mut sequence = control(first, &numbers, last);
        if draw(4) == 0 {
            // A byte that belongs there as little as any, but is not a key by itself.
            let at = 2 + draw(sequence.len() - 2);
            sequence.insert(at, [b';', b'<', 0x80, 0xff, b'0', b':'][draw(6)]);
        }
        all.push(sequence);
    }
    all
}

#[test]
fn no_control_sequence_ends_the_workbench() {
    let mut terminal = Terminal::start();
    terminal.wait_for(DONE);
    for sequence in known().into_iter().chain(every_kind()).chain(random(10_000)) {
        terminal.send_bytes(&sequence);
    }
    // It still listens: input that was lost would have ended it with 129.
    terminal.signal(Signal::TERM);
    assert_eq!(terminal.wait_exit().exit_code(), 143);
    terminal.assert_restored();
    let state = std::fs::read_dir(terminal.file("state/cmra")).unwrap();
    let mut names = state.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    assert!(!names.any(|name| name.starts_with("panic-")));
}
