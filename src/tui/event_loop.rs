//! Event loop, and the effects without files: jobs, timers, clipboard, suspending, quitting.

use std::collections::VecDeque;
use std::io;
use std::sync::mpsc::{self, Receiver, Sender};
use std::time::{Duration, Instant};

use crossterm::clipboard::CopyToClipboard;
use crossterm::event::{MouseEvent, MouseEventKind};

use super::backlog::{self, LoopEvent};
use super::effects::{self, IoThread};
use super::frame_scheduler::FrameScheduler;
use super::signals::{self, HUNG_UP};
use super::start::environment;
use super::terminal::{self, Guard};
use super::{Options, input, start};
use crate::files::paths::Paths;
use crate::tui::message::{EffectReport, Message};
use crate::tui::prelude::*;
use crate::tui::{update, view};
use crate::worker::{Slot, Worker};

/// Interval of checks for a lost terminal while idle.
const LOOK: Duration = Duration::from_millis(250);

/// Maximum number of messages handled per turn of the loop.
const MESSAGES_PER_TURN: usize = 256;

/// Maximum size of a clipboard text, bytes; the smallest limit of common terminals.
const CLIPBOARD_MAX: usize = 64 * 1024 / 4 * 3;

/// Maximum number of messages taken from the inbox at once.
const INBOX_MAX: usize = 1 << 16;

/// Maximum time for the system to stop the process.
const STOPPING: Duration = Duration::from_millis(150);

/// Maximum time for quitting: on request, and when the terminal or the system ends the process.
const FINISH_QUIT: Duration = Duration::from_secs(10);
const FINISH_FORCED: Duration = Duration::from_millis(900);

pub(super) enum ExitReason {
    Quit,
    /// Signal or lost terminal, with its exit status.
    Signal(u8),
    /// Terminal error.
    Broken(io::Error),
}

impl From<io::Error> for ExitReason {
    fn from(error: io::Error) -> Self {
        Self::Broken(error)
    }
}

/// Result of a loop turn; the error is the reason to quit.
type LoopResult = Result<(), ExitReason>;

/// State of the event loop.
pub(super) struct EventLoop {
    app: App,
    guard: Guard,
    inbox: Receiver<LoopEvent>,
    worker: Worker,
    io_thread: IoThread,
    pace: FrameScheduler,
    /// Mouse targets of the last frame, which is what a person clicks on.
    targets: view::Targets,
    timers: Vec<(Instant, Message)>,
    /// Events that arrived while the process was stopped.
    put_off: VecDeque<LoopEvent>,
    /// Dropped when the loop has ended.
    _left: Sender<()>,
}

impl EventLoop {
    /// Takes over the terminal and starts all threads. The first run starts before the terminal is changed.
    pub(super) fn start(options: Options, paths: Option<Paths>) -> io::Result<Self> {
        let (sender, inbox) = mpsc::channel();
        let for_reports = sender.clone();
        let worker = Worker::spawn(move |report| {
            // The loop may have ended.
            let _ = for_reports.send(LoopEvent::Message(Message::Report(report)));
        });
        let (mut app, known) = start::app(options, paths.as_ref());
        let effects = update::start(&mut app);
        let io_thread = IoThread::spawn(paths, known, effects::SESSION_DELAY, sender.clone())?;
        let unsaved = io_thread.unsaved();
        let left = signals::spawn(sender.clone(), move || {
            // The input thread has ended.
            let _ = unsaved.save_at_once(effects::SAVING);
            terminal::restore();
        })?;
        // Dropped if a later step fails, which restores the terminal.
        let guard = Guard::enter()?;
        let mut shell = Self {
            app,
            guard,
            inbox,
            worker,
            io_thread,
            pace: FrameScheduler::new(Instant::now()),
            targets: view::Targets::default(),
            timers: Vec::new(),
            put_off: VecDeque::from([LoopEvent::Message(size()?)]),
            _left: left,
        };
        input::spawn(sender, input::hold(environment))?;
        for effect in effects {
            // The effects at start are runs and lists only.
            let _ = shell.carry_out(effect, &mut VecDeque::new());
        }
        Ok(shell)
    }

    /// Runs the loop until there is a reason to quit.
    pub(super) fn run(&mut self) -> ExitReason {
        loop {
            match self.turn() {
                Ok(()) => {}
                // A lost terminal returns several different errors.
                Err(ExitReason::Broken(_)) if terminal::is_hung_up() => {
                    return ExitReason::Signal(HUNG_UP);
                }
                Err(ending) => return ending,
            }
        }
    }

    /// Quits: saves the session and restores the terminal. Returns a message about the session for the user, if any.
    pub(super) fn leave(mut self, ending: &ExitReason) -> Option<String> {
        let is_forced = !matches!(ending, ExitReason::Quit);
        let patience = if is_forced { FINISH_FORCED } else { FINISH_QUIT };
        self.io_thread.session_changed(start::session(&self.app));
        if !is_forced {
            self.await_arrival();
        }
        // Restore the terminal first, so that the prompt does not wait for the disk.
        drop(self.guard);
        match self.io_thread.finish(patience, is_forced) {
            Ok(aside) => aside.map(|aside| effects::of_another(&aside)),
            Err(why) => Some(format!("the session was not kept: {why}")),
        }
    }

    /// Waits for messages, handles all of them, and draws if a frame is due.
    fn turn(&mut self) -> LoopResult {
        if self.put_off.is_empty() {
            self.put_off.extend(self.inbox.recv_timeout(self.wait(Instant::now())));
        }
        self.put_off.extend(self.inbox.try_iter().take(INBOX_MAX));
        let keymap = &self.app.keymap;
        backlog::shorten(&mut self.put_off, |key| keymap.action(key) == Some(Action::Cancel));
        for _ in 0..MESSAGES_PER_TURN {
            let Some(incoming) = self.put_off.pop_front() else { break };
            self.receive(incoming)?;
        }
        self.fire_timers()?;
        let now = Instant::now();
        if terminal::is_hung_up() {
            return Err(ExitReason::Signal(HUNG_UP));
        }
        if self.pace.due().is_some_and(|due| due <= now) {
            let (app, asks) = (&self.app, self.pace.requests_ack());
            // Targets are as many as cells: without a mouse nothing asks for them.
            let targets = app.settings.mouse.then_some(&mut self.targets);
            let bytes =
                self.guard.draw(app.size, asks, |buffer| view::view(app, buffer, targets))?;
            self.pace.drawn(Instant::now(), bytes);
        }
        Ok(())
    }

    /// Returns the time until the next timer.
    fn wait(&self, now: Instant) -> Duration {
        let timers = self.timers.iter().map(|(due, _)| *due);
        timers
            .chain(self.pace.due())
            .map(|due| due.saturating_duration_since(now))
            .min()
            .map_or(LOOK, |wait| wait.min(LOOK))
    }

    fn fire_timers(&mut self) -> LoopResult {
        while let Some(at) = self.timers.iter().position(|(due, _)| *due <= Instant::now()) {
            let (_, message) = self.timers.remove(at);
            self.take(message)?;
        }
        Ok(())
    }

    fn receive(&mut self, incoming: LoopEvent) -> LoopResult {
        match incoming {
            LoopEvent::Message(message) => self.take(message)?,
            LoopEvent::Mouse(mouse) => {
                if let Some(message) = self.pointed(mouse) {
                    self.take(message)?;
                }
            }
            LoopEvent::Arrived => self.pace.arrived(Instant::now()),
            LoopEvent::End(status) => return Err(ExitReason::Signal(status)),
            LoopEvent::Stop => {
                // The system ignores the signal if no shell could continue the process.
                let _stopped = self.suspend()?;
            }
            LoopEvent::Resized => self.take(size()?)?,
            LoopEvent::Continued => {
                self.guard.enter_again()?;
                self.pace.lost();
                self.take(size()?)?;
            }
        }
        Ok(())
    }

    /// Returns the message of a click or a turn of the wheel at a position of the screen.
    fn pointed(&self, mouse: MouseEvent) -> Option<Message> {
        let target = self.targets.at((mouse.column, mouse.row));
        match mouse.kind {
            MouseEventKind::ScrollUp => Some(Message::Wheel(true, target)),
            MouseEventKind::ScrollDown => Some(Message::Wheel(false, target)),
            _ => target.map(Message::Click),
        }
    }

    /// Updates the state with a message and performs the resulting effects.
    fn take(&mut self, message: Message) -> LoopResult {
        let mut queue = VecDeque::from([message]);
        while let Some(message) = queue.pop_front() {
            let is_tick = matches!(message, Message::Tick(_));
            let effects = update::update(&mut self.app, message);
            if is_tick {
                self.pace.animate();
            } else {
                self.pace.change();
            }
            if self.app.jobs.current.is_none() {
                self.pace.result_came();
            }
            for effect in effects {
                self.carry_out(effect, &mut queue)?;
            }
        }
        Ok(())
    }

    fn carry_out(&mut self, effect: Effect, queue: &mut VecDeque<Message>) -> LoopResult {
        match effect {
            Effect::Submit(task) => {
                if task.slot() == Slot::Current {
                    self.pace.expect_result(Instant::now());
                }
                self.worker.submit(task);
            }
            Effect::Cancel(id) => self.worker.cancel(id),
            Effect::After(delay, message) => self.timers.push((Instant::now() + delay, message)),
            Effect::Files(task) => self.io_thread.ask(task),
            Effect::SaveSession => self.io_thread.session_changed(start::session(&self.app)),
            Effect::Copy(text) => {
                let said = EffectReport::Said(Severity::Note, self.copy(&text)?);
                queue.push_back(Message::Done(said));
            }
            Effect::Mouse(on) => self.guard.set_mouse(on)?,
            Effect::Redraw => {
                self.guard.redraw_all()?;
                queue.push_back(size()?);
            }
            Effect::Suspend => {
                if !self.suspend()? {
                    queue.push_back(Message::Done(EffectReport::Said(
                        Severity::Error,
                        "cannot suspend: no shell is there to come back from".to_owned(),
                    )));
                }
            }
            Effect::Quit => return Err(ExitReason::Quit),
        }
        Ok(())
    }

    /// Copies a text to the clipboard of the terminal; returns the message for the user.
    fn copy(&mut self, text: &str) -> io::Result<String> {
        if text.len() > CLIPBOARD_MAX {
            let (length, most) = (text.len() / 1024, CLIPBOARD_MAX / 1024);
            return Ok(format!(
                "{length} kB are too long for the terminal's clipboard (at most {most} kB): <export> writes a file"
            ));
        }
        self.guard.send(&CopyToClipboard::to_clipboard_from(text))?;
        Ok(match (environment("TMUX"), environment("STY")) {
            (Some(_), _) => "sent to the terminal's clipboard (OSC 52); tmux passes it on only with `set -s set-clipboard on`",
            (None, Some(_)) => "GNU screen does not pass the terminal's clipboard on (OSC 52): <export> writes a file",
            (None, None) => "sent to the terminal's clipboard (OSC 52)",
        }
        .to_owned())
    }

    /// Restores the terminal, stops the process, and takes the terminal over when continued. Returns whether the process was stopped.
    fn suspend(&mut self) -> io::Result<bool> {
        if !terminal::could_be_continued() {
            return Ok(false);
        }
        self.await_arrival();
        terminal::restore();
        terminal::stop()?;
        // The system stops the process shortly after the call, and a signal continues it. The wait may also expire while the process is
        // stopped. Therefore only two expired waits in a row mean that it was not stopped.
        let mut stopped = false;
        let mut waits = 0;
        while !stopped && waits < 2 {
            match self.inbox.recv_timeout(STOPPING) {
                Ok(LoopEvent::Continued) => stopped = true,
                Ok(other) => self.put_off.push_back(other),
                Err(_) => waits += 1,
            }
        }
        self.guard.enter_again()?;
        self.pace.lost();
        // The window size may have changed.
        self.put_off.push_front(LoopEvent::Message(size()?));
        Ok(stopped)
    }

    /// Waits for pending answers of the terminal; the shell would receive later ones.
    fn await_arrival(&mut self) {
        self.put_off.retain(|incoming| {
            let has_arrived = matches!(incoming, LoopEvent::Arrived);
            if has_arrived {
                self.pace.arrived(Instant::now());
            }
            !has_arrived
        });
        while let Some(deadline) = self.pace.answers_until() {
            let left = deadline.saturating_duration_since(Instant::now());
            match self.inbox.recv_timeout(left) {
                Ok(LoopEvent::Arrived) => self.pace.arrived(Instant::now()),
                Ok(LoopEvent::End(_)) | Err(_) => return,
                Ok(other) => self.put_off.push_back(other),
            }
        }
    }
}

/// Returns the message with the present size of the terminal.
fn size() -> io::Result<Message> {
    terminal::size().map(|(columns, rows)| Message::Resize(columns, rows))
}
