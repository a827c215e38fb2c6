//! The terminal: entering and leaving it, and one write per frame.
//!
//! Leaving must work from anywhere (return, panic, signal, suspension), so the little state it needs is global and
//! [`restore`] may be called at any time, any number of times. A frame goes out as begin-synchronised-update, the changed
//! cells, end, in one write; a frame without a change writes nothing. The terminal is never asked anything: no round trips.
//! Knows nothing of what is drawn; how cells become bytes is in `encode`.

mod encode;
pub(super) mod hook;

use std::io;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use crossterm::cursor::{Hide, MoveTo, Show};
use crossterm::event::{DisableBracketedPaste, EnableBracketedPaste};
use crossterm::queue;
use crossterm::style::{Attribute, SetAttribute};
use crossterm::terminal::{
    BeginSynchronizedUpdate, EndSynchronizedUpdate, EnterAlternateScreen, LeaveAlternateScreen,
    disable_raw_mode, enable_raw_mode,
};
use ratatui::Terminal;
use ratatui::backend::{Backend, ClearType, WindowSize};
use ratatui::buffer::Cell;
use ratatui::layout::{Position, Size};
use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::io::Errno;
use rustix::process::{Signal, getpid, kill_current_process_group, kill_process};
use rustix::stdio::stdout;
use rustix::termios::{QueueSelector, tcflush};

/// Whether the terminal is ours at present (raw, alternate screen).
static ENTERED: AtomicBool = AtomicBool::new(false);

static MOUSE: AtomicBool = AtomicBool::new(false);

/// Reports of buttons and wheel, in the coordinates of SGR. crossterm's own sequence also requests every movement, which a slow
/// line would have to carry for nothing.
const MOUSE_ON: &[u8] = b"\x1b[?1000h\x1b[?1006h";
const MOUSE_OFF: &[u8] = b"\x1b[?1006l\x1b[?1000l";

/// The end of a string (ST): a sequence whose end was discarded would swallow what follows.
const STRING_END: &[u8] = b"\x1b\\";

/// How long a terminal that takes no bytes is waited for on leaving.
const SHORT: Duration = Duration::from_millis(200);

/// Size assumed where the terminal does not know its own.
const UNKNOWN_SIZE: Size = Size { width: 80, height: 24 };

/// The largest part of a window that is drawn on. Where someone has set an absurd size, every cell of it would take memory.
const LARGEST: Size = Size { width: 1000, height: 500 };

/// Columns and rows of a window of this size that are drawn on.
pub(super) fn usable(columns: u16, rows: u16) -> (u16, u16) {
    (columns.min(LARGEST.width), rows.min(LARGEST.height))
}

/// A terminal that restores itself when dropped.
pub(super) struct Guard {
    terminal: Terminal<Screen>,
}

impl Guard {
    /// Take over the terminal: raw mode, alternate screen, bracketed paste, hidden cursor.
    pub(super) fn enter() -> io::Result<Self> {
        let mut screen = Screen::new();
        enable_raw_mode()?;
        ENTERED.store(true, Ordering::SeqCst);
        screen.queue_entry()?;
        match Terminal::new(screen) {
            Ok(terminal) => Ok(Self { terminal }),
            Err(error) => {
                restore();
                Err(error)
            }
        }
    }

    pub(super) fn size(&self) -> io::Result<(u16, u16)> {
        let size = self.terminal.size()?;
        Ok((size.width, size.height))
    }

    /// Draw one frame in one write; returns whether anything had changed.
    pub(super) fn draw(
        &mut self,
        render: impl FnOnce(&mut ratatui::Frame<'_>),
    ) -> io::Result<bool> {
        let before = self.terminal.backend().writes;
        self.terminal.draw(render)?;
        Ok(self.terminal.backend().writes != before)
    }

    /// The next frame clears the screen and draws every cell.
    pub(super) fn redraw_all(&mut self) -> io::Result<()> {
        self.terminal.clear()
    }

    /// Take the terminal over again, after a suspension or after someone else may have changed its modes.
    pub(super) fn enter_again(&mut self) -> io::Result<()> {
        // Another program may have changed the modes meanwhile: forget the saved ones, so that the present ones are restored.
        disable_raw_mode()?;
        enable_raw_mode()?;
        ENTERED.store(true, Ordering::SeqCst);
        self.terminal.backend_mut().queue_entry()?;
        self.terminal.clear()
    }

    /// Capture the mouse, or leave it to the terminal's own selection.
    pub(super) fn set_mouse(&mut self, on: bool) -> io::Result<()> {
        MOUSE.store(on, Ordering::SeqCst);
        let sequence = if on { MOUSE_ON } else { MOUSE_OFF };
        self.terminal.backend_mut().pending.extend_from_slice(sequence);
        self.terminal.backend_mut().commit()
    }

    /// Send a sequence that draws nothing (the clipboard's).
    pub(super) fn send(&mut self, sequence: &impl crossterm::Command) -> io::Result<()> {
        queue!(self.terminal.backend_mut().pending, sequence)?;
        self.terminal.backend_mut().commit()
    }
}

impl Drop for Guard {
    fn drop(&mut self) {
        restore();
    }
}

/// Give the terminal back: idempotent, from any thread, as far as it goes (the terminal may be gone). A terminal that takes no
/// bytes loses the frames on their way to it, so that there is room for the farewell.
pub(super) fn restore() {
    if ENTERED.swap(false, Ordering::SeqCst) {
        let takes =
            || poll_stdout(PollFlags::OUT, Some(SHORT)).is_ok_and(|found| !found.is_empty());
        if !takes() {
            discard_output();
        }
        if takes() {
            // If the terminal is gone, the error cannot be shown.
            let _ = write_all(&farewell());
        }
        let _ = disable_raw_mode();
    }
}

/// Discard what the terminal has not taken yet.
fn discard_output() {
    let _ = tcflush(stdout(), QueueSelector::OFlush);
}

/// Let a thread go on that is stuck in a write to a terminal that takes no bytes. The system makes room, but does not wake the
/// writer: a signal does, and this one means no more than another look at the size.
pub(super) fn make_room() {
    discard_output();
    let _ = kill_process(getpid(), Signal::WINCH);
}

/// What undoes [`Screen::queue_entry`], and whatever a frame cut short has left.
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

/// Whether a shell could continue this process: one of the processes above it in its group has a parent outside of the group, but
/// in the same session. Where none has, the system ignores a request to stop by a terminal, and so does this program.
pub(super) fn could_be_continued() -> bool {
    let Some(own) = Relations::of("self") else {
        // A system without `/proc` does not tell: a shell is the usual case.
        return true;
    };
    let mut parent = own.parent;
    while let Some(above) = Relations::of(&parent.to_string()) {
        if above.session != own.session {
            return false;
        }
        if above.group != own.group {
            return true;
        }
        parent = above.parent;
    }
    false
}

/// The numbers that relate a process to others. Zero stands for a process outside of the container that this program runs in;
/// `getsid` and `getpgid` of rustix refuse that zero, so the numbers come from `/proc`.
struct Relations {
    parent: u32,
    group: u32,
    session: u32,
}

impl Relations {
    /// Reads the numbers of a process (its number, or `self`). None where the system does not tell.
    fn of(process: &str) -> Option<Self> {
        let stat = std::fs::read_to_string(format!("/proc/{process}/stat")).ok()?;
        // The name in parentheses may hold anything; state, parent, group and session follow it.
        let (_, rest) = stat.rsplit_once(')')?;
        let mut numbers = rest.split_whitespace().skip(1).map(str::parse);
        let mut next = || numbers.next()?.ok();
        Some(Self { parent: next()?, group: next()?, session: next()? })
    }
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

/// The backend: collects a frame and writes it at once.
struct Screen {
    /// Bytes of the frame in the making.
    pending: Vec<u8>,
    /// Whether the cursor is shown, as last sent to the terminal.
    cursor_shown: bool,
    /// Where the cursor was last put, for the frames that show it.
    cursor_at: Option<Position>,
    writes: u64,
}

impl Screen {
    fn new() -> Self {
        Self {
            pending: Vec::with_capacity(16 * 1024),
            cursor_shown: true,
            cursor_at: None,
            writes: 0,
        }
    }

    /// The beginning of the first frame.
    fn queue_entry(&mut self) -> io::Result<()> {
        queue!(self.pending, EnterAlternateScreen, EnableBracketedPaste, Hide)?;
        if MOUSE.load(Ordering::SeqCst) {
            self.pending.extend_from_slice(MOUSE_ON);
        }
        self.cursor_shown = false;
        self.cursor_at = None;
        Ok(())
    }

    /// Write what has been collected; nothing when there is nothing.
    fn commit(&mut self) -> io::Result<()> {
        if self.pending.is_empty() {
            return Ok(());
        }
        let mut frame = Vec::with_capacity(self.pending.len() + 16);
        queue!(frame, BeginSynchronizedUpdate)?;
        frame.append(&mut self.pending);
        queue!(frame, EndSynchronizedUpdate)?;
        self.writes = self.writes.wrapping_add(1);
        write_all(&frame)
    }
}

impl Backend for Screen {
    type Error = io::Error;

    fn draw<'a, I>(&mut self, content: I) -> io::Result<()>
    where
        I: Iterator<Item = (u16, u16, &'a Cell)>,
    {
        if encode::cells(&mut self.pending, content) {
            self.cursor_at = None;
        }
        Ok(())
    }

    fn hide_cursor(&mut self) -> io::Result<()> {
        if self.cursor_shown {
            queue!(self.pending, Hide)?;
            self.cursor_shown = false;
        }
        Ok(())
    }

    fn show_cursor(&mut self) -> io::Result<()> {
        if !self.cursor_shown {
            queue!(self.pending, Show)?;
            self.cursor_shown = true;
        }
        Ok(())
    }

    fn get_cursor_position(&mut self) -> io::Result<Position> {
        // Asking the terminal would be a round trip; ratatui only wants to put it back.
        Ok(self.cursor_at.unwrap_or_default())
    }

    fn set_cursor_position<P: Into<Position>>(&mut self, position: P) -> io::Result<()> {
        let position = position.into();
        if self.cursor_shown && self.cursor_at != Some(position) {
            queue!(self.pending, MoveTo(position.x, position.y))?;
            self.cursor_at = Some(position);
        }
        Ok(())
    }

    fn clear(&mut self) -> io::Result<()> {
        self.clear_region(ClearType::All)
    }

    fn clear_region(&mut self, region: ClearType) -> io::Result<()> {
        use crossterm::terminal::{Clear, ClearType as Part};
        let part = match region {
            ClearType::All => Part::All,
            ClearType::AfterCursor => Part::FromCursorDown,
            ClearType::BeforeCursor => Part::FromCursorUp,
            ClearType::CurrentLine => Part::CurrentLine,
            ClearType::UntilNewLine => Part::UntilNewLine,
        };
        queue!(self.pending, Clear(part))
    }

    fn size(&self) -> io::Result<Size> {
        let size = rustix::termios::tcgetwinsize(stdout())?;
        if size.ws_col == 0 || size.ws_row == 0 {
            return Ok(UNKNOWN_SIZE);
        }
        Ok(usable(size.ws_col, size.ws_row).into())
    }

    fn window_size(&mut self) -> io::Result<WindowSize> {
        Ok(WindowSize { columns_rows: self.size()?, pixels: Size::default() })
    }

    fn flush(&mut self) -> io::Result<()> {
        self.commit()
    }
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
    let mut watched = [PollFd::new(&out, wanted)];
    let patience = patience.and_then(|wait| Timespec::try_from(wait).ok());
    match poll(&mut watched, patience.as_ref()) {
        Ok(_) | Err(Errno::INTR) => Ok(watched[0].revents()),
        Err(error) => Err(error),
    }
}
