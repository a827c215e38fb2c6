//! Signals become entries of the loop's inbox, and the process ends in time even when the loop is stuck.
//!
//! The loop can be stuck in a write to a terminal that takes no more bytes. So a signal to end the process is served by
//! the loop when it can, and otherwise by this thread, which saves what the loop last handed it and leaves.

use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread;
use std::time::Duration;

use signal_hook::consts::{
    SIGALRM, SIGCONT, SIGHUP, SIGINT, SIGPROF, SIGQUIT, SIGTERM, SIGTSTP, SIGUSR1, SIGUSR2,
    SIGVTALRM, SIGWINCH, SIGXCPU,
};
use signal_hook::iterator::Signals;

use super::event_loop::LoopEvent;
use super::terminal;

/// The signals that end a process by default and that it can handle: each would leave the terminal as it is.
const ENDING: [i32; 10] =
    [SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGALRM, SIGUSR1, SIGUSR2, SIGXCPU, SIGVTALRM, SIGPROF];

/// How long the loop may take to leave by itself; then, how often and for how long what it waits to write is discarded.
const PATIENCE: Duration = Duration::from_millis(600);
const DISCARD_EVERY: Duration = Duration::from_millis(50);
const DISCARDS: u32 = 12;

/// The exit status where the terminal is gone, whether a signal said so or not.
pub(super) const HUNG_UP: u8 = 128 + 1;

/// Start the thread. `last_resort` is called before it ends the process by itself, which it does not once what is returned has been
/// dropped: the loop has left.
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

/// Wait for the loop to leave. One that is stuck in a write to a terminal that takes no bytes is given room for what it writes.
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
