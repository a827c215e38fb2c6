//! Signals become entries of the loop's inbox, and the process ends in time even when the loop is stuck.
//!
//! The loop can be stuck in a write to a terminal that takes no more bytes. So whoever asks the process to end is served by
//! the loop when it can, and otherwise by this thread, which saves what the loop last handed it and leaves.

use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread;
use std::time::Duration;

use signal_hook::consts::{SIGCONT, SIGHUP, SIGINT, SIGQUIT, SIGTERM};
use signal_hook::iterator::Signals;

use super::Incoming;

/// How long the loop may take to leave by itself.
const PATIENCE: Duration = Duration::from_millis(1200);

/// Which signal ends the process with which status: 128 + its number, as shells do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Signal {
    /// Leave with this exit status.
    End(u8),
    /// The process was stopped and goes on: take the terminal over again.
    Continued,
}

/// Tells the signal thread that the loop has left; it then no longer ends the process.
pub(super) struct Watch {
    _left: Sender<()>,
}

/// Start the thread. `last_resort` is called before it ends the process by itself.
///
/// # Errors
/// When the system has no thread to give, or refuses a handler.
pub(super) fn spawn(
    inbox: Sender<Incoming>,
    last_resort: impl Fn() + Send + 'static,
) -> std::io::Result<Watch> {
    let mut signals = Signals::new([SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGCONT])?;
    let (left, loop_left) = mpsc::channel::<()>();
    thread::Builder::new().name("signals".to_owned()).spawn(move || {
        for number in signals.forever() {
            let signal = meaning(number);
            if inbox.send(Incoming::Signal(signal)).is_err() {
                return;
            }
            let Signal::End(status) = signal else {
                continue;
            };
            match loop_left.recv_timeout(PATIENCE) {
                Ok(()) | Err(RecvTimeoutError::Disconnected) => return,
                Err(RecvTimeoutError::Timeout) => {
                    last_resort();
                    end_process(status);
                }
            }
        }
    })?;
    Ok(Watch { _left: left })
}

fn meaning(number: i32) -> Signal {
    match number {
        SIGCONT => Signal::Continued,
        other => Signal::End(u8::try_from(128 + other).unwrap_or(u8::MAX)),
    }
}

#[expect(
    clippy::exit,
    reason = "the loop is stuck and cannot return; what could be saved has been"
)]
fn end_process(status: u8) -> ! {
    std::process::exit(i32::from(status))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_signal_ends_with_128_and_its_number() {
        // Numbers as in POSIX: HUP 1, INT 2, QUIT 3, TERM 15.
        for (number, status) in [(SIGHUP, 129), (SIGINT, 130), (SIGQUIT, 131), (SIGTERM, 143)] {
            assert_eq!(meaning(number), Signal::End(status));
        }
        assert_eq!(meaning(SIGCONT), Signal::Continued);
    }
}
