//! The terminal: entering and leaving it, and one write per frame.
//!
//! Leaving must work from anywhere (return, panic, signal, suspension), so the little state it needs is global and
//! [`restore`] may be called at any time, any number of times. A frame goes out as begin-synchronised-update, the changed
//! cells, end, in one write; a frame without a change writes nothing. A frame may end in the one question that the terminal is
//! ever asked: to report its status, which it does when all before has arrived.
//! Knows nothing of what is drawn; how cells become bytes is in `encode`.

pub(super) mod decode;
mod encode;
pub(super) mod hook;

use std::io;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use crossterm::cursor::{Hide, MoveTo, Show};
use crossterm::event::{DisableBracketedPaste, EnableBracketedPaste};
use crossterm::queue;
use crossterm::style::{Attribute, SetAttribute};
use crossterm::terminal::{
    BeginSynchronizedUpdate, Clear, ClearType, EndSynchronizedUpdate, EnterAlternateScreen,
    LeaveAlternateScreen, disable_raw_mode, enable_raw_mode,
};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::io::Errno;
use rustix::process::{Signal, getpgrp, getpid, kill_current_process_group, kill_process};
use rustix::stdio::{stdin, stdout};
use rustix::termios::{QueueSelector, tcflush};

/// Whether the terminal is ours at present (raw, alternate screen).
static ENTERED: AtomicBool = AtomicBool::new(false);

/// Held while the terminal is given back: another thread that ends the process waits for that, so many times as long as the terminal is
/// waited for.
static RESTORING: Mutex<()> = Mutex::new(());
const PATIENCE: usize = 5;

static MOUSE: AtomicBool = AtomicBool::new(false);

/// Reports of buttons and wheel, in the coordinates of SGR. crossterm's own sequence also requests every movement, which a slow
/// line would have to carry for nothing.
const MOUSE_ON: &[u8] = b"\x1b[?1000h\x1b[?1006h";
const MOUSE_OFF: &[u8] = b"\x1b[?1006l\x1b[?1000l";

/// Asks for a status report (DSR); the answer is `ESC [ 0 n`.
const ASK: &[u8] = b"\x1b[5n";

/// The end of a string (ST): a sequence whose end was discarded would swallow what follows.
const STRING_END: &[u8] = b"\x1b\\";

/// How long a terminal that takes no bytes is waited for on leaving.
const SHORT: Duration = Duration::from_millis(200);

/// Size assumed where the terminal does not know its own.
const UNKNOWN_SIZE: (u16, u16) = (80, 24);

/// The largest part of a window that is drawn on. Where someone has set an absurd size, every cell of it would take memory.
const LARGEST: (u16, u16) = (1000, 500);

/// A place of the cursor, and whether it is shown there.
pub(crate) type Cursor = ((u16, u16), bool);

/// A terminal that restores itself when dropped.
pub(super) struct Guard {
    /// Cells that the terminal shows.
    shown: Buffer,
    /// Where its cursor stands, and whether it is shown, as last sent.
    cursor: Option<Cursor>,
    /// Bytes that go out with the next frame.
    pending: Vec<u8>,
}

impl Guard {
    /// Take over the terminal: raw mode, alternate screen, bracketed paste, hidden cursor.
    pub(super) fn enter() -> io::Result<Self> {
        enable_raw_mode()?;
        ENTERED.store(true, Ordering::SeqCst);
        // Dropped when anything below fails, which restores the terminal.
        let mut guard = Self { shown: Buffer::default(), cursor: None, pending: Vec::new() };
        guard.shown.resize(area(size()?));
        discard_input();
        guard.queue_entry()?;
        Ok(guard)
    }

    /// The beginning of the first frame. Where there is no alternate screen, that of the shell is cleared.
    fn queue_entry(&mut self) -> io::Result<()> {
        queue!(self.pending, EnterAlternateScreen, SetAttribute(Attribute::Reset))?;
        queue!(self.pending, Clear(ClearType::All), EnableBracketedPaste, Hide)?;
        if MOUSE.load(Ordering::SeqCst) {
            self.pending.extend_from_slice(MOUSE_ON);
        }
        self.cursor = None;
        Ok(())
    }

    /// Draw one frame of a size in one write, with the question whether it has arrived if `asks`; `render` gives where the cursor is
    /// to stand. Returns whether anything had changed.
    pub(super) fn draw(
        &mut self,
        size: (u16, u16),
        asks: bool,
        render: impl FnOnce(&mut Buffer) -> Option<Cursor>,
    ) -> io::Result<bool> {
        let area = area(size);
        if self.shown.area != area {
            self.shown = Buffer::empty(area);
            self.redraw_all()?;
        }
        let mut next = Buffer::empty(area);
        let cursor = render(&mut next);
        let before = self.pending.len();
        encode::cells(&mut self.pending, self.shown.diff_iter(&next));
        let any = self.pending.len() > before;
        let is_shown = |cursor: Option<Cursor>| cursor.is_some_and(|(_, is_shown)| is_shown);
        if let Some(((x, y), _)) = cursor
            && (any || cursor != self.cursor)
        {
            queue!(self.pending, MoveTo(x, y))?;
        }
        match (is_shown(self.cursor), is_shown(cursor)) {
            (false, true) => queue!(self.pending, Show)?,
            (true, false) => queue!(self.pending, Hide)?,
            _ => {}
        }
        (self.shown, self.cursor) = (next, cursor);
        self.commit(asks)
    }

    /// The next frame clears the screen and draws every cell.
    pub(super) fn redraw_all(&mut self) -> io::Result<()> {
        self.shown.reset();
        queue!(self.pending, Clear(ClearType::All))
    }

    /// Take the terminal over again, after a suspension or after someone else may have changed its modes.
    pub(super) fn enter_again(&mut self) -> io::Result<()> {
        // Another program may have changed the modes meanwhile: forget the saved ones, so that the present ones are restored.
        disable_raw_mode()?;
        enable_raw_mode()?;
        ENTERED.store(true, Ordering::SeqCst);
        discard_input();
        self.queue_entry()?;
        self.redraw_all()
    }

    /// Capture the mouse, or leave it to the terminal's own selection.
    pub(super) fn set_mouse(&mut self, on: bool) -> io::Result<()> {
        MOUSE.store(on, Ordering::SeqCst);
        self.pending.extend_from_slice(if on { MOUSE_ON } else { MOUSE_OFF });
        self.commit(false).map(drop)
    }

    /// Send a sequence that draws nothing (the clipboard's).
    pub(super) fn send(&mut self, sequence: &impl crossterm::Command) -> io::Result<()> {
        queue!(self.pending, sequence)?;
        self.commit(false).map(drop)
    }

    /// Write what has been collected, and the question; returns whether there was anything.
    fn commit(&mut self, asks: bool) -> io::Result<bool> {
        if self.pending.is_empty() {
            return Ok(false);
        }
        let mut frame = Vec::with_capacity(self.pending.len() + 16);
        queue!(frame, BeginSynchronizedUpdate)?;
        frame.append(&mut self.pending);
        queue!(frame, EndSynchronizedUpdate)?;
        if asks {
            frame.extend_from_slice(ASK);
        }
        write_all(&frame).map(|()| true)
    }
}

fn area((width, height): (u16, u16)) -> Rect {
    Rect::new(0, 0, width, height)
}

/// Columns and rows of the terminal that are drawn on.
pub(super) fn size() -> io::Result<(u16, u16)> {
    let size = rustix::termios::tcgetwinsize(stdout())?;
    if size.ws_col == 0 || size.ws_row == 0 {
        return Ok(UNKNOWN_SIZE);
    }
    Ok((size.ws_col.min(LARGEST.0), size.ws_row.min(LARGEST.1)))
}

impl Drop for Guard {
    fn drop(&mut self) {
        restore();
    }
}

/// Give the terminal back: idempotent, from any thread, as far as it goes (the terminal may be gone). A terminal that takes no
/// bytes loses the frames on their way to it, so that there is room for the farewell.
pub(super) fn restore() {
    let _one = (0..PATIENCE).find_map(|_| {
        let free = RESTORING.try_lock().ok();
        if free.is_none() {
            // Waits, unless the terminal is gone.
            let _ = poll_stdout(PollFlags::empty(), Some(SHORT));
        }
        free
    });
    if ENTERED.swap(false, Ordering::SeqCst) {
        let takes =
            || poll_stdout(PollFlags::OUT, Some(SHORT)).is_ok_and(|found| !found.is_empty());
        // A thread that was stuck in a write, and goes on, fills the room again.
        let has_room = (0..PATIENCE).any(|_| {
            let takes = takes();
            if !takes {
                discard_output();
            }
            takes
        });
        if has_room {
            // If the terminal is gone, the error cannot be shown.
            let _ = write_all(&farewell());
        }
        // What has come by now was for this program.
        discard_input();
        let _ = disable_raw_mode();
    }
}

/// Discard what the terminal has not taken yet.
fn discard_output() {
    let _ = tcflush(stdout(), QueueSelector::OFlush);
}

/// Discard what has come and was not meant for this program: late answers to questions of another one, which would be taken for keys.
fn discard_input() {
    let _ = tcflush(stdin(), QueueSelector::IFlush);
}

/// Wait for bytes of the terminal, at most this long, and take them; `None` when the time has passed. The end of the terminal is an
/// error.
pub(super) fn read(buffer: &mut [u8], patience: Option<Duration>) -> io::Result<Option<usize>> {
    let input = stdin();
    let patience = patience.and_then(|wait| Timespec::try_from(wait).ok());
    loop {
        match poll(&mut [PollFd::new(&input, PollFlags::IN)], patience.as_ref()) {
            Ok(0) => return Ok(None),
            Ok(_) => {}
            Err(Errno::INTR) => continue,
            Err(error) => return Err(error.into()),
        }
        match rustix::io::read(input, &mut *buffer) {
            Ok(0) => return Err(io::ErrorKind::UnexpectedEof.into()),
            Ok(count) => return Ok(Some(count)),
            Err(Errno::INTR | Errno::AGAIN) => {}
            Err(error) => return Err(error.into()),
        }
    }
}

/// Let a thread go on that is stuck in a write to a terminal that takes no bytes. The system makes room, but does not wake the
/// writer: a signal does, and this one means no more than another look at the size.
pub(super) fn make_room() {
    discard_output();
    let _ = kill_process(getpid(), Signal::WINCH);
}

/// Returns the bytes that undo [`Guard::queue_entry`] and end an incomplete frame.
fn farewell() -> Vec<u8> {
    let mut bytes = Vec::with_capacity(64);
    // Writing to a vector does not fail.
    bytes.extend_from_slice(STRING_END);
    let _ = queue!(bytes, EndSynchronizedUpdate);
    if MOUSE.load(Ordering::SeqCst) {
        bytes.extend_from_slice(MOUSE_OFF);
    }
    let _ = queue!(
        bytes,
        DisableBracketedPaste,
        SetAttribute(Attribute::Reset),
        // Where there is no alternate screen, the prompt comes on an empty one.
        MoveTo(0, 0),
        Clear(ClearType::All),
        LeaveAlternateScreen,
        Show
    );
    bytes
}

/// Stop this process and those started with it (`cargo run`, for one) until continued, as the shell's own Ctrl-Z does. The signal
/// cannot be caught, unlike that of Ctrl-Z, which this program handles itself.
pub(super) fn stop() -> io::Result<()> {
    Ok(kill_current_process_group(Signal::STOP)?)
}

/// Whether a shell could continue this process: the leader of its group has a parent in the same session. Where it has none, the
/// system ignores a request to stop by a terminal, and so does this program.
pub(super) fn could_be_continued() -> bool {
    let group = getpgrp().as_raw_nonzero().get();
    // A system without `/proc` does not tell, nor does a leader that has ended: a shell is the usual case.
    relations(group).is_none_or(|(parent, session)| {
        relations(parent).is_some_and(|(_, other)| other == session)
    })
}

/// The parent and the session of a process; `None` where the system does not tell. Zero stands for a process outside of the container
/// that this program runs in; `getsid` of rustix refuses that zero, so the numbers come from `/proc`.
fn relations(process: i32) -> Option<(i32, i32)> {
    let stat = std::fs::read_to_string(format!("/proc/{process}/stat")).ok()?;
    // The name in parentheses may hold anything; state, parent, group and session follow it.
    let (_, rest) = stat.rsplit_once(')')?;
    let mut numbers = rest.split_whitespace().skip(1).map(str::parse);
    Some((numbers.next()?.ok()?, numbers.nth(1)?.ok()?))
}

/// Whether the terminal is ours at present.
pub(super) fn is_entered() -> bool {
    ENTERED.load(Ordering::SeqCst)
}

/// Whether the other end of the terminal is gone.
pub(super) fn is_hung_up() -> bool {
    // No event requested: only hang-ups and errors are reported.
    poll_stdout(PollFlags::empty(), Some(Duration::ZERO)).is_ok_and(|found| !found.is_empty())
}

/// Write everything to the terminal, whatever mode others have put the descriptor in.
fn write_all(mut bytes: &[u8]) -> io::Result<()> {
    while !bytes.is_empty() {
        match rustix::io::write(stdout(), bytes) {
            Ok(0) => return Err(io::ErrorKind::WriteZero.into()),
            Ok(written) => bytes = &bytes[written..],
            Err(Errno::INTR) => {}
            // Someone who shares the terminal has made it non-blocking.
            Err(Errno::AGAIN) => {
                poll_stdout(PollFlags::OUT, None)?;
            }
            Err(error) => return Err(error.into()),
        }
    }
    Ok(())
}

/// Wait for events of the terminal, at most this long; gives those that have come, hang-ups and errors among them.
fn poll_stdout(wanted: PollFlags, patience: Option<Duration>) -> Result<PollFlags, Errno> {
    let out = stdout();
    let start = Instant::now();
    loop {
        let left = patience.map(|patience| patience.saturating_sub(start.elapsed()));
        let left = left.and_then(|left| Timespec::try_from(left).ok());
        let mut watched = [PollFd::new(&out, wanted)];
        match poll(&mut watched, left.as_ref()) {
            Ok(_) => return Ok(watched[0].revents()),
            // A signal says nothing of the terminal.
            Err(Errno::INTR) => {}
            Err(error) => return Err(error),
        }
    }
}
