//! Signal thread: converts signals to messages of the event loop, and ends the process in time if the loop is blocked.
//!
//! A write to a terminal that accepts no bytes can block the loop. The loop handles a signal to end the process if it can. Otherwise this
//! thread saves the last session state and ends the process.

use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread;
use std::time::Duration;

use signal_hook::consts::{
    SIGALRM, SIGCONT, SIGHUP, SIGINT, SIGPROF, SIGQUIT, SIGTERM, SIGTSTP, SIGUSR1, SIGUSR2,
    SIGVTALRM, SIGWINCH, SIGXCPU,
};
use signal_hook::iterator::Signals;

use super::backlog::LoopEvent;
use super::terminal;

/// Signals that end a process by default and can be handled. Each would leave the terminal in its present mode.
const ENDING: [i32; 10] =
    [SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGALRM, SIGUSR1, SIGUSR2, SIGXCPU, SIGVTALRM, SIGPROF];

/// Maximum time for the loop to end; interval and number of attempts to discard its pending output afterwards.
const PATIENCE: Duration = Duration::from_millis(600);
const DISCARD_EVERY: Duration = Duration::from_millis(50);
const DISCARDS: u32 = 12;

/// Exit status for a lost terminal, with or without a signal.
pub(super) const HUNG_UP: u8 = 128 + 1;

/// Starts the thread. Calls `last_resort` before the thread ends the process. Dropping the returned value, when the loop has ended,
/// prevents this.
pub(super) fn spawn(
    inbox: Sender<LoopEvent>,
    last_resort: impl Fn() + Send + 'static,
) -> std::io::Result<Sender<()>> {
    let mut signals = Signals::new(ENDING.into_iter().chain([SIGTSTP, SIGCONT, SIGWINCH]))?;
    let (left, loop_left) = mpsc::channel::<()>();
    thread::Builder::new().name("signals".to_owned()).spawn(move || {
        for number in signals.forever() {
            let incoming = meaning(number);
            let status = if let LoopEvent::End(status) = incoming { Some(status) } else { None };
            if inbox.send(incoming).is_err() {
                return;
            }
            let Some(status) = status else { continue };
            if !has_left(&loop_left) {
                last_resort();
                end_process(status);
            }
            return;
        }
    })?;
    Ok(left)
}

/// Waits for the loop to end. Discards pending output if the loop is blocked in a write to a terminal that accepts no bytes.
fn has_left(loop_left: &mpsc::Receiver<()>) -> bool {
    let left_within =
        |patience| !matches!(loop_left.recv_timeout(patience), Err(RecvTimeoutError::Timeout));
    left_within(PATIENCE)
        || (0..DISCARDS).any(|_| {
            terminal::make_room();
            left_within(DISCARD_EVERY)
        })
}

/// Converts a signal to a message; the exit status is 128 + its number, as in shells.
fn meaning(number: i32) -> LoopEvent {
    match number {
        SIGCONT => LoopEvent::Continued,
        SIGTSTP => LoopEvent::Stop,
        SIGWINCH => LoopEvent::Resized,
        other => LoopEvent::End(u8::try_from(128 + other).unwrap_or(u8::MAX)),
    }
}

#[expect(
    clippy::exit,
    reason = "the loop is stuck and cannot return; what could be saved has been"
)]
fn end_process(status: u8) -> ! {
    std::process::exit(i32::from(status))
}
