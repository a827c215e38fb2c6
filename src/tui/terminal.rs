//! Terminal: entering and leaving it, and one write per frame.
//!
//! Leaving must work from any context (return, panic, signal, suspension). Its small state is therefore global, and [`restore`] may be
//! called at any time and repeatedly. A frame is a single write: begin synchronised update, changed cells, end. An unchanged frame writes
//! nothing. A frame may end with a request for a status report, which the terminal answers after it has received the frame. The module does
//! not depend on the content of frames; `encode` converts cells to bytes.

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

/// Whether the program controls the terminal (raw mode, alternate screen).
static ENTERED: AtomicBool = AtomicBool::new(false);

/// Lock during the restoration of the terminal. Another thread that ends the process waits for it, at most this many times the short
/// timeout.
static RESTORING: Mutex<()> = Mutex::new(());
const PATIENCE: usize = 5;

static MOUSE: AtomicBool = AtomicBool::new(false);

/// Enables reports of buttons and wheel in SGR coordinates. crossterm's own sequence also requests all movements, which would load a slow
/// connection.
const MOUSE_ON: &[u8] = b"\x1b[?1000h\x1b[?1006h";
const MOUSE_OFF: &[u8] = b"\x1b[?1006l\x1b[?1000l";

/// Requests a status report (DSR); the answer is `ESC [ 0 n`.
const ASK: &[u8] = b"\x1b[5n";

/// String terminator (ST). A sequence without its end would swallow the following output.
const STRING_END: &[u8] = b"\x1b\\";

/// Timeout for a terminal that accepts no bytes when leaving.
const SHORT: Duration = Duration::from_millis(200);

/// Assumed size if the terminal does not report its size.
const UNKNOWN_SIZE: (u16, u16) = (80, 24);

/// Maximum drawn size of a window; bounds the memory for cells.
const LARGEST: (u16, u16) = (1000, 500);

/// Cursor position, and whether the cursor is visible.
pub(crate) type Cursor = ((u16, u16), bool);

/// Terminal that restores itself when dropped.
pub(super) struct Guard {
    /// Cells displayed by the terminal.
    shown: Buffer,
    /// Position and visibility of the cursor, as last sent.
    cursor: Option<Cursor>,
    /// Bytes to be sent with the next frame.
    pending: Vec<u8>,
}

impl Guard {
    /// Takes over the terminal: raw mode, alternate screen, bracketed paste, hidden cursor.
    pub(super) fn enter() -> io::Result<Self> {
        enable_raw_mode()?;
        ENTERED.store(true, Ordering::SeqCst);
        // Dropped if a later step fails, which restores the terminal.
        let mut guard = Self { shown: Buffer::default(), cursor: None, pending: Vec::new() };
        guard.shown.resize(area(size()?));
        discard_input();
        guard.queue_entry()?;
        Ok(guard)
    }

    /// Queues the start of the first frame. Clears the shell's screen if there is no alternate screen.
    fn queue_entry(&mut self) -> io::Result<()> {
        queue!(self.pending, EnterAlternateScreen, SetAttribute(Attribute::Reset))?;
        queue!(self.pending, Clear(ClearType::All), EnableBracketedPaste, Hide)?;
        if MOUSE.load(Ordering::SeqCst) {
            self.pending.extend_from_slice(MOUSE_ON);
        }
        self.cursor = None;
        Ok(())
    }

    /// Draws a frame of this size in one write, with a request for acknowledgement if `asks`; `render` returns the cursor. Returns the number
    /// of bytes; none if nothing changed.
    pub(super) fn draw(
        &mut self,
        size: (u16, u16),
        asks: bool,
        render: impl FnOnce(&mut Buffer) -> Option<Cursor>,
    ) -> io::Result<usize> {
        let area = area(size);
        if self.shown.area != area {
            self.shown = Buffer::empty(area);
            self.redraw_all()?;
        }
        let mut next = Buffer::empty(area);
        let cursor = render(&mut next);
        let before = self.pending.len();
        encode::cells(&mut self.pending, &self.shown, &next);
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

    /// Makes the next frame clear the screen and draw every cell.
    pub(super) fn redraw_all(&mut self) -> io::Result<()> {
        self.shown.reset();
        queue!(self.pending, Clear(ClearType::All))
    }

    /// Takes the terminal over again, after a suspension or after another program may have changed its modes.
    pub(super) fn enter_again(&mut self) -> io::Result<()> {
        // Another program may have changed the modes: discard the saved modes, so that the present ones are restored later.
        disable_raw_mode()?;
        enable_raw_mode()?;
        ENTERED.store(true, Ordering::SeqCst);
        discard_input();
        self.queue_entry()?;
        self.redraw_all()
    }

    /// Captures the mouse, or releases it for the terminal's own selection.
    pub(super) fn set_mouse(&mut self, on: bool) -> io::Result<()> {
        MOUSE.store(on, Ordering::SeqCst);
        self.pending.extend_from_slice(if on { MOUSE_ON } else { MOUSE_OFF });
        self.commit(false).map(drop)
    }

    /// Sends a sequence that draws nothing (clipboard).
    pub(super) fn send(&mut self, sequence: &impl crossterm::Command) -> io::Result<()> {
        queue!(self.pending, sequence)?;
        self.commit(false).map(drop)
    }

    /// Writes the collected bytes and the request; returns their number.
    fn commit(&mut self, asks: bool) -> io::Result<usize> {
        if self.pending.is_empty() {
            return Ok(0);
        }
        let mut frame = Vec::with_capacity(self.pending.len() + 16);
        queue!(frame, BeginSynchronizedUpdate)?;
        frame.append(&mut self.pending);
        queue!(frame, EndSynchronizedUpdate)?;
        if asks {
            frame.extend_from_slice(ASK);
        }
        write_all(&frame).map(|()| frame.len())
    }
}

fn area((width, height): (u16, u16)) -> Rect {
    Rect::new(0, 0, width, height)
}

/// Returns the drawn columns and rows of the terminal.
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

/// Restores the terminal as far as possible (it may be lost); idempotent, from any thread. If the terminal accepts no bytes, pending frames
/// are discarded to make room for the final sequence.
pub(super) fn restore() {
    let _one = (0..PATIENCE).find_map(|_| {
        let free = RESTORING.try_lock().ok();
        if free.is_none() {
            // Waits, unless the terminal is lost.
            let _ = poll_stdout(PollFlags::empty(), Some(SHORT));
        }
        free
    });
    if ENTERED.swap(false, Ordering::SeqCst) {
        let takes =
            || poll_stdout(PollFlags::OUT, Some(SHORT)).is_ok_and(|found| !found.is_empty());
        // A blocked writer that continues fills the buffer again.
        let has_room = (0..PATIENCE).any(|_| {
            let takes = takes();
            if !takes {
                discard_output();
            }
            takes
        });
        if has_room {
            // If the terminal is lost, the error cannot be shown.
            let _ = write_all(&farewell());
        }
        // Pending input was meant for this program.
        discard_input();
        let _ = disable_raw_mode();
    }
}

/// Discards pending output.
fn discard_output() {
    let _ = tcflush(stdout(), QueueSelector::OFlush);
}

/// Discards pending input: late answers to another program, which would be taken for keys.
fn discard_input() {
    let _ = tcflush(stdin(), QueueSelector::IFlush);
}

/// Reads bytes from the terminal, waiting at most this long; `None` on timeout. The end of the terminal is an error.
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

/// Unblocks a thread in a write to a terminal that accepts no bytes. Discarding output makes room but does not wake the writer; a signal
/// does. The signal otherwise causes only a query of the size.
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
        // Without an alternate screen, the prompt appears on an empty screen.
        MoveTo(0, 0),
        Clear(ClearType::All),
        LeaveAlternateScreen,
        Show
    );
    bytes
}

/// Stops this process and its process group (such as `cargo run`) until continued, as the shell's Ctrl-Z does. The signal cannot be caught,
/// unlike that of Ctrl-Z, which this program handles itself.
pub(super) fn stop() -> io::Result<()> {
    Ok(kill_current_process_group(Signal::STOP)?)
}

/// Returns `true` if a shell can continue this process: the leader of its group has a parent in the same session. Otherwise the system
/// ignores a stop request by a terminal, and so does this program.
pub(super) fn could_be_continued() -> bool {
    let group = getpgrp().as_raw_nonzero().get();
    // Assume a shell on a system without `/proc`, and for a leader that has ended.
    relations(group).is_none_or(|(parent, session)| {
        relations(parent).is_some_and(|(_, other)| other == session)
    })
}

/// Returns the parent and the session of a process; `None` if the system does not provide them. Zero is a process outside the container of
/// this program. `getsid` of rustix rejects this zero, so the numbers come from `/proc`.
fn relations(process: i32) -> Option<(i32, i32)> {
    let stat = std::fs::read_to_string(format!("/proc/{process}/stat")).ok()?;
    // The name in parentheses may contain any characters; state, parent, group and session follow it.
    let (_, rest) = stat.rsplit_once(')')?;
    let mut numbers = rest.split_whitespace().skip(1).map(str::parse);
    Some((numbers.next()?.ok()?, numbers.nth(1)?.ok()?))
}

/// Returns `true` if the program controls the terminal.
pub(super) fn is_entered() -> bool {
    ENTERED.load(Ordering::SeqCst)
}

/// Returns `true` if the other end of the terminal is closed.
pub(super) fn is_hung_up() -> bool {
    // No event is requested: only hang-ups and errors are reported.
    poll_stdout(PollFlags::empty(), Some(Duration::ZERO)).is_ok_and(|found| !found.is_empty())
}

/// Writes all bytes to the terminal, also if the descriptor is non-blocking.
fn write_all(mut bytes: &[u8]) -> io::Result<()> {
    while !bytes.is_empty() {
        match rustix::io::write(stdout(), bytes) {
            Ok(0) => return Err(io::ErrorKind::WriteZero.into()),
            Ok(written) => bytes = &bytes[written..],
            Err(Errno::INTR) => {}
            // Another user of the terminal has made it non-blocking.
            Err(Errno::AGAIN) => {
                poll_stdout(PollFlags::OUT, None)?;
            }
            Err(error) => return Err(error.into()),
        }
    }
    Ok(())
}

/// Waits for events of the terminal, at most this long; returns the events, including hang-ups and errors.
fn poll_stdout(wanted: PollFlags, patience: Option<Duration>) -> Result<PollFlags, Errno> {
    let out = stdout();
    let start = Instant::now();
    loop {
        let left = patience.map(|patience| patience.saturating_sub(start.elapsed()));
        let left = left.and_then(|left| Timespec::try_from(left).ok());
        let mut watched = [PollFd::new(&out, wanted)];
        match poll(&mut watched, left.as_ref()) {
            Ok(_) => return Ok(watched[0].revents()),
            // A signal is unrelated to the terminal.
            Err(Errno::INTR) => {}
            Err(error) => return Err(error),
        }
    }
}
