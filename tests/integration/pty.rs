//! A terminal without a person: the program runs in a pseudo-terminal, an emulator reads what it draws.
//!
//! A wait is for something to come, however long that takes: nothing sleeps, and no test goes on because time has passed.

use std::io::{Read, Write};
use std::num::NonZeroU16;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver};
use std::thread;
use std::time::{Duration, Instant};

use portable_pty::{CommandBuilder, ExitStatus, MasterPty, PtySize, native_pty_system};
use rustix::process::{Pid, Signal, kill_process};

/// A test that waits so long for anything hangs.
pub(crate) const HANG: Duration = Duration::from_secs(120);

/// The beginning and the end of a frame (synchronised update), and what clears the screen within one.
const FRAME: &[u8] = b"\x1b[?2026h";
const FRAME_END: &[u8] = b"\x1b[?2026l";
const CLEAR: &[u8] = b"\x1b[2J";

/// The question whether all has arrived, and what a terminal answers.
const ASK: &[u8] = b"\x1b[5n";
const ANSWER: &[u8] = b"\x1b[0n";

/// The usual size of the screens under test.
const SIZE: (u16, u16) = (80, 24);

/// How the program is to be started.
pub(crate) struct Start<'a> {
    /// The command; `None`: the workbench itself.
    pub(crate) shell: Option<&'a str>,
    /// Arguments of the workbench.
    pub(crate) arguments: &'a [&'a str],
    /// Further variables of the environment.
    pub(crate) environment: &'a [(&'a str, &'a str)],
    /// Whether the terminal is the controlling one: without it, a hang-up sends no signal.
    pub(crate) controlling: bool,
    /// The home directory of an earlier start.
    pub(crate) home: Option<tempfile::TempDir>,
    /// Whether the terminal has an alternate screen.
    pub(crate) alternate: bool,
    /// Text on the screen before the start.
    pub(crate) before: &'a str,
}

impl Default for Start<'_> {
    fn default() -> Self {
        Self {
            shell: None,
            arguments: &[],
            environment: &[],
            controlling: true,
            home: None,
            alternate: true,
            before: "",
        }
    }
}

/// The program in its terminal.
pub(crate) struct Terminal {
    master: Option<Box<dyn MasterPty + Send>>,
    writer: Option<Box<dyn Write + Send>>,
    bytes: Receiver<Vec<u8>>,
    stop_reading: Arc<AtomicBool>,
    hold: Arc<AtomicBool>,
    /// Lets a reader on hold go on; dropped with the rest, which ends it.
    release: mpsc::Sender<()>,
    exit: Receiver<ExitStatus>,
    parser: vt100::Parser,
    process: Pid,
    /// All bytes drawn so far.
    drawn: Vec<u8>,
    /// Whether no frame is under way: what is half drawn is not looked at.
    is_whole: bool,
    /// Whether the terminal answers the question whether all has arrived.
    pub(crate) answers: bool,
    alternate: bool,
    /// The job of the shell that runs in the terminal.
    pub(crate) job: Option<Pid>,
    /// The modes of the terminal before the program.
    modes_before: String,
    /// Home, and where the program was started.
    pub(crate) home: Option<tempfile::TempDir>,
}

impl Terminal {
    /// Start the workbench afresh.
    pub(crate) fn start() -> Self {
        Self::start_with(Start::default())
    }

    /// Starts with these settings.
    pub(crate) fn start_with(mut start: Start<'_>) -> Self {
        let size = PtySize { cols: SIZE.0, rows: SIZE.1, pixel_width: 0, pixel_height: 0 };
        let pair = native_pty_system().openpty(size).expect("a pseudo-terminal");
        let home = start.home.take().unwrap_or_else(|| tempfile::tempdir().expect("a directory"));
        let command = command(&start, home.path());
        let modes_before = modes(pair.master.as_ref());
        let mut child = pair.slave.spawn_command(command).expect("it starts");
        drop(pair.slave);
        let process = child
            .process_id()
            .and_then(|id| Pid::from_raw(id.try_into().ok()?))
            .expect("a process");
        let (send, exit) = mpsc::channel();
        thread::spawn(move || child.wait().map(|status| send.send(status)));
        let reader = pair.master.try_clone_reader().expect("a reader");
        let stop_reading = Arc::new(AtomicBool::new(false));
        let hold = Arc::new(AtomicBool::new(false));
        let (release, released) = mpsc::channel();
        let mut parser = vt100::Parser::new(rows(SIZE.1), rows(SIZE.0), 0);
        parser.process(start.before.as_bytes());
        let bytes =
            read_in_background(reader, Arc::clone(&stop_reading), Arc::clone(&hold), released);
        Self {
            writer: Some(pair.master.take_writer().expect("a writer")),
            bytes,
            hold,
            release,
            stop_reading,
            master: Some(pair.master),
            exit,
            parser,
            alternate: start.alternate,
            job: None,
            process,
            drawn: Vec::new(),
            is_whole: true,
            answers: true,
            modes_before,
            home: Some(home),
        }
    }

    /// Type.
    pub(crate) fn send(&mut self, keys: &str) {
        self.send_bytes(keys.as_bytes());
    }

    /// Send what need not be text.
    pub(crate) fn send_bytes(&mut self, bytes: &[u8]) {
        let writer = self.writer.as_mut().expect("the terminal is there");
        writer.write_all(bytes).expect("it takes keys");
        writer.flush().expect("it takes keys");
    }

    /// Wait until the screen is as wanted, and give its text.
    pub(crate) fn wait_until(
        &mut self,
        what: &str,
        wanted: impl Fn(&vt100::Screen) -> bool,
    ) -> String {
        let deadline = Instant::now() + HANG;
        loop {
            if self.is_whole && wanted(self.parser.screen()) {
                return self.parser.screen().contents();
            }
            let left = deadline.saturating_duration_since(Instant::now());
            match self.bytes.recv_timeout(left) {
                Ok(bytes) => self.take(&bytes),
                Err(error) => {
                    panic!("{what}: {error}; the screen is\n{}", self.parser.screen().contents())
                }
            }
        }
    }

    /// Wait until a text is on the screen, and give all of it.
    pub(crate) fn wait_for(&mut self, text: &str) -> String {
        self.wait_until(text, |screen| screen.contents().contains(text))
    }

    /// Wait until the program has dealt with all keys sent so far: it has answered a request to redraw the screen.
    pub(crate) fn sync(&mut self) {
        self.send("\x0c");
        self.wait_redrawn();
    }

    /// Wait for a whole frame, from now on, that clears the screen first.
    pub(crate) fn wait_redrawn(&mut self) {
        let before = self.drawn.len();
        let deadline = Instant::now() + HANG;
        let is_redrawn = |drawn: &[u8]| {
            let cleared = find(drawn, CLEAR);
            cleared.is_some_and(|at| find(&drawn[at..], FRAME_END).is_some())
        };
        while !is_redrawn(&self.drawn[before..]) {
            let left = deadline.saturating_duration_since(Instant::now());
            match self.bytes.recv_timeout(left) {
                Ok(bytes) => self.take(&bytes),
                Err(error) => {
                    panic!(
                        "it redraws: {error}; the screen is\n{}",
                        self.parser.screen().contents()
                    )
                }
            }
        }
    }

    /// All that was drawn so far, as text.
    pub(crate) fn text(&self) -> String {
        String::from_utf8_lossy(&self.drawn).into_owned()
    }

    /// The number of bytes of each frame so far.
    pub(crate) fn frames(&self) -> Vec<usize> {
        let mut frames = Vec::new();
        let mut rest = &self.drawn[..];
        while let Some(begin) = find(rest, FRAME) {
            let Some(size) = find(&rest[begin..], FRAME_END) else { break };
            frames.push(size + FRAME_END.len());
            rest = &rest[begin + size..];
        }
        frames
    }

    /// Forget what was drawn, but for the screen.
    pub(crate) fn forget(&mut self) {
        self.drawn.clear();
    }

    /// Draw over the screen, as another program does.
    pub(crate) fn scribble(&mut self, bytes: &[u8]) {
        self.parser.process(bytes);
    }

    fn take(&mut self, bytes: &[u8]) {
        let before = self.drawn.len();
        self.drawn.extend_from_slice(bytes);
        // A mark may have come in two pieces.
        let news = &self.drawn[before.saturating_sub(FRAME.len() - 1)..];
        let last = |mark: &[u8]| news.windows(mark.len()).rposition(|found| found == mark);
        let (begins, ends) = (last(FRAME), last(FRAME_END));
        self.is_whole = if begins == ends { self.is_whole } else { ends > begins };
        if self.alternate {
            self.parser.process(bytes);
        } else {
            // As a terminal without an alternate screen, which knows nothing of these.
            let text = String::from_utf8_lossy(bytes);
            let text = text.replace("\x1b[?1049h", "").replace("\x1b[?1049l", "");
            self.parser.process(text.as_bytes());
        }
        if self.answers {
            // A question may have come in two pieces.
            let from = before.saturating_sub(ASK.len() - 1);
            let asked = self.drawn[from..].windows(ASK.len()).filter(|found| *found == ASK).count();
            for _ in 0..asked {
                // The program may have ended.
                let _ = self.writer.as_mut().map(|writer| writer.write_all(ANSWER));
            }
        }
    }

    /// The screen as it is.
    pub(crate) fn screen(&self) -> &vt100::Screen {
        self.parser.screen()
    }

    /// Give the terminal another size.
    pub(crate) fn resize(&mut self, columns: u16, lines: u16) {
        self.parser.screen_mut().set_size(rows(lines), rows(columns));
        self.claim_size(columns, lines);
    }

    /// Tell the program of a size that the emulator does not have.
    pub(crate) fn claim_size(&self, columns: u16, lines: u16) {
        let size = PtySize { cols: columns, rows: lines, pixel_width: 0, pixel_height: 0 };
        let master = self.master.as_ref().expect("the terminal is there");
        master.resize(size).expect("it can be resized");
    }

    /// Send the program a signal.
    pub(crate) fn signal(&self, signal: Signal) {
        kill_process(self.process, signal).expect("it is there");
    }

    /// Let the stopped job of the shell go on.
    pub(crate) fn go_on(&self) {
        kill_process(self.job.expect("a job"), Signal::CONT).expect("it is there");
    }

    /// The program's process.
    pub(crate) fn process(&self) -> String {
        self.process.as_raw_nonzero().to_string()
    }

    /// Take no more bytes than those under way, as a terminal whose connection is stuck.
    pub(crate) fn stop_taking(&self) {
        self.hold.store(true, Ordering::SeqCst);
    }

    /// Take bytes again, and all that is there, once the program has ended.
    pub(crate) fn take_again(&mut self) {
        self.hold.store(false, Ordering::SeqCst);
        self.release.send(()).expect("the reader is on hold");
        self.take_rest();
    }

    /// Close the terminal, as a dropped connection does.
    pub(crate) fn hang_up(&mut self) {
        // The reading thread holds a handle of its own: a redraw wakes it up, and it lets go.
        self.stop_reading.store(true, Ordering::SeqCst);
        self.send("\x0c");
        let deadline = Instant::now() + HANG;
        loop {
            let left = deadline.saturating_duration_since(Instant::now());
            match self.bytes.recv_timeout(left) {
                Ok(bytes) => self.take(&bytes),
                Err(error) => {
                    assert_eq!(error, mpsc::RecvTimeoutError::Disconnected);
                    break;
                }
            }
        }
        self.writer = None;
        self.master = None;
    }

    /// Wait for the end of the program and take all it has drawn.
    pub(crate) fn wait_exit(&mut self) -> ExitStatus {
        let status = self.exit.recv_timeout(HANG).expect("it ends");
        if !self.hold.load(Ordering::SeqCst) {
            self.take_rest();
        }
        status
    }

    /// The last bytes of a program that has ended: reading ends when the other end is closed.
    fn take_rest(&mut self) {
        while let Ok(bytes) = self.bytes.recv_timeout(HANG) {
            self.take(&bytes);
        }
    }

    /// Whether the modes of the terminal are those from before the program.
    pub(crate) fn has_old_modes(&self) -> bool {
        self.master.as_ref().is_none_or(|master| modes(master.as_ref()) == self.modes_before)
    }

    /// The terminal is as it was: main screen, cursor, no paste or mouse reports, the old modes.
    pub(crate) fn assert_restored(&self) {
        let screen = self.screen();
        assert!(!screen.alternate_screen(), "still on the alternate screen");
        assert!(!screen.hide_cursor(), "the cursor is hidden");
        assert!(!screen.bracketed_paste(), "bracketed paste is on");
        assert_eq!(screen.mouse_protocol_mode(), vt100::MouseProtocolMode::None);
        assert!(self.has_old_modes(), "the modes are others");
    }

    /// A file below the home directory.
    pub(crate) fn file(&self, name: &str) -> PathBuf {
        self.home.as_ref().expect("kept").path().join(name)
    }

    /// Where the session is kept.
    pub(crate) fn session_file(&self) -> PathBuf {
        self.file("state/cmra/session.toml")
    }
}

impl Drop for Terminal {
    fn drop(&mut self) {
        // A test that failed leaves no process behind.
        if matches!(self.exit.try_recv(), Err(mpsc::TryRecvError::Empty)) {
            let _ = kill_process(self.process, Signal::KILL);
        }
    }
}

/// Wait until the system gives a process this state: T is stopped.
pub(crate) fn wait_for_state(process: &str, wanted: char) {
    wait_while(&format!("{process} is not {wanted}"), || {
        let stat = std::fs::read_to_string(format!("/proc/{process}/stat")).expect("it is there");
        let state = stat.rsplit(')').next().and_then(|rest| rest.trim().chars().next());
        state != Some(wanted)
    });
}

/// Wait while something holds.
pub(crate) fn wait_while(what: &str, mut holds: impl FnMut() -> bool) {
    let deadline = Instant::now() + HANG;
    while holds() {
        assert!(Instant::now() < deadline, "{what}");
        thread::yield_now();
    }
}

/// The command, in an environment of its own.
fn command(start: &Start<'_>, home: &Path) -> CommandBuilder {
    let program = env!("CARGO_BIN_EXE_cmra");
    let mut command = match start.shell {
        None => CommandBuilder::new(program),
        Some(shell) => CommandBuilder::new(shell),
    };
    command.args(start.arguments);
    command.env_clear();
    command.cwd(home);
    command.set_controlling_tty(start.controlling);
    let path = std::env::var("PATH").unwrap_or_default();
    let below = |name: &str| home.join(name).display().to_string();
    for (name, value) in [
        ("HOME", below("")),
        ("XDG_DATA_HOME", below("data")),
        ("XDG_STATE_HOME", below("state")),
        ("XDG_CONFIG_HOME", below("config")),
        ("PATH", path),
        ("TERM", "xterm-256color".to_owned()),
        ("LANG", "C.UTF-8".to_owned()),
        ("CMRA", program.to_owned()),
    ] {
        command.env(name, value);
    }
    for (name, value) in start.environment {
        command.env(name, value);
    }
    command
}

/// The modes of a terminal, in whatever words.
fn modes(master: &dyn MasterPty) -> String {
    format!("{:?}", master.get_termios())
}

/// Where bytes are among others.
fn find(all: &[u8], wanted: &[u8]) -> Option<usize> {
    all.windows(wanted.len()).position(|found| found == wanted)
}

fn rows(count: u16) -> NonZeroU16 {
    NonZeroU16::new(count).expect("a terminal has a size")
}

/// Bytes as they come, until either end is closed; on hold, none are taken until the release.
fn read_in_background(
    mut reader: Box<dyn Read + Send>,
    stop: Arc<AtomicBool>,
    hold: Arc<AtomicBool>,
    released: Receiver<()>,
) -> Receiver<Vec<u8>> {
    let (send, receive) = mpsc::channel();
    thread::spawn(move || {
        let mut buffer = [0; 16 * 1024];
        while let Ok(count) = reader.read(&mut buffer) {
            if count == 0 || stop.load(Ordering::SeqCst) {
                return;
            }
            if send.send(buffer[..count].to_vec()).is_err() {
                return;
            }
            if hold.load(Ordering::SeqCst) && released.recv().is_err() {
                return;
            }
        }
    });
    receive
}
