//! The loop itself, and the effects that are not files: jobs, timers, the clipboard, suspending, leaving.

use std::collections::VecDeque;
use std::io;
use std::sync::mpsc::{self, Receiver, Sender};
use std::time::{Duration, Instant};

use crossterm::clipboard::CopyToClipboard;
use crossterm::event::{MouseEvent, MouseEventKind};

use super::backlog;
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

/// Idle, the loop looks this often whether the terminal is still there.
const LOOK: Duration = Duration::from_millis(250);

/// Messages taken before the loop looks at anything else.
const MESSAGES_PER_TURN: usize = 256;

/// Most bytes of text sent to the terminal's clipboard: what terminals take at least.
const CLIPBOARD_MAX: usize = 64 * 1024 / 4 * 3;

/// Most messages taken out of the inbox at once.
const INBOX_MAX: usize = 1 << 16;

/// How long the system may take to stop the process.
const STOPPING: Duration = Duration::from_millis(150);

/// How long leaving may take when the person left, and when the terminal or the system ends the process.
const FINISH_QUIT: Duration = Duration::from_secs(10);
const FINISH_FORCED: Duration = Duration::from_millis(900);

pub(super) enum ExitReason {
    Quit,
    /// A signal, or the terminal is gone: with the exit status that stands for.
    Signal(u8),
    /// The terminal cannot be used any more.
    Broken(io::Error),
}

impl From<io::Error> for ExitReason {
    fn from(error: io::Error) -> Self {
        Self::Broken(error)
    }
}

/// Goes on, unless there is a reason to leave.
type LoopResult = Result<(), ExitReason>;

/// Message to the event loop.
pub(super) enum LoopEvent {
    Message(Message),
    Mouse(MouseEvent),
    /// The last frame has arrived at the terminal.
    Arrived,
    /// A signal, or the terminal is gone: leave with this exit status.
    End(u8),
    /// Stop the process (`kill -TSTP`).
    Stop,
    /// The terminal has another size.
    Resized,
    /// The process was stopped and goes on: take the terminal over again.
    Continued,
}

/// Everything the loop has at hand.
pub(super) struct EventLoop {
    app: App,
    guard: Guard,
    inbox: Receiver<LoopEvent>,
    worker: Worker,
    io_thread: IoThread,
    pace: FrameScheduler,
    timers: Vec<(Instant, Message)>,
    /// Events that arrived while the process was being stopped.
    put_off: VecDeque<LoopEvent>,
    /// Dropped when the loop has left.
    _left: Sender<()>,
}

impl EventLoop {
    /// Take the terminal over and start every thread. The first run is under way before the terminal is touched.
    pub(super) fn start(options: Options, paths: Option<Paths>) -> io::Result<Self> {
        let (sender, inbox) = mpsc::channel();
        let for_reports = sender.clone();
        let worker = Worker::spawn(move |report| {
            // The loop may be over already.
            let _ = for_reports.send(LoopEvent::Message(Message::Report(report)));
        });
        let (mut app, known) = start::app(options, paths.as_ref());
        let effects = update::start(&mut app);
        let io_thread = IoThread::spawn(paths, known, effects::SESSION_DELAY, sender.clone())?;
        let unsaved = io_thread.unsaved();
        let left = signals::spawn(sender.clone(), move || {
            // The reader is gone.
            let _ = unsaved.save_at_once(effects::SAVING);
            terminal::restore();
        })?;
        // Dropped when anything below fails, which restores the terminal.
        let guard = Guard::enter()?;
        let mut shell = Self {
            app,
            guard,
            inbox,
            worker,
            io_thread,
            pace: FrameScheduler::new(Instant::now()),
            timers: Vec::new(),
            put_off: VecDeque::from([LoopEvent::Message(size()?)]),
            _left: left,
        };
        input::spawn(sender, input::hold(environment))?;
        for effect in effects {
            // Starting requests runs and lists only.
            let _ = shell.carry_out(effect, &mut VecDeque::new());
        }
        Ok(shell)
    }

    /// Go on until there is a reason to leave.
    pub(super) fn run(&mut self) -> ExitReason {
        loop {
            match self.turn() {
                Ok(()) => {}
                // A terminal that is gone answers with several different errors.
                Err(ExitReason::Broken(_)) if terminal::is_hung_up() => {
                    return ExitReason::Signal(HUNG_UP);
                }
                Err(ending) => return ending,
            }
        }
    }

    /// Leave: save the session, restore the terminal, and give what a person should know of the session, if anything.
    pub(super) fn leave(mut self, ending: &ExitReason) -> Option<String> {
        let is_forced = !matches!(ending, ExitReason::Quit);
        let patience = if is_forced { FINISH_FORCED } else { FINISH_QUIT };
        self.io_thread.session_changed(start::session(&self.app));
        if !is_forced {
            self.await_arrival();
        }
        // The person sees the prompt while the disk is still busy.
        drop(self.guard);
        match self.io_thread.finish(patience, is_forced) {
            Ok(aside) => aside.map(|aside| effects::of_another(&aside)),
            Err(why) => Some(format!("the session was not kept: {why}")),
        }
    }

    /// Wait for something, deal with all that has come, and draw if it is time.
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
            let changed = self.guard.draw(app.size, asks, |buffer| view::view(app, buffer))?;
            self.pace.drawn(Instant::now(), changed);
        }
        Ok(())
    }

    /// How long nothing can happen by itself.
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
                // Where no shell could continue it, the system would ignore the signal.
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

    /// The message of a click or a turn of the wheel on the present screen.
    fn pointed(&self, mouse: MouseEvent) -> Option<Message> {
        let target = view::target(&self.app, (mouse.column, mouse.row));
        match mouse.kind {
            MouseEventKind::ScrollUp => Some(Message::Wheel(true, target)),
            MouseEventKind::ScrollDown => Some(Message::Wheel(false, target)),
            _ => target.map(Message::Click),
        }
    }

    /// Let the state take a message, and all that follows from it at once.
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

    /// Send a text to the clipboard of the terminal; gives what to say of it.
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

    /// Give the terminal back, stop, and take it over again when continued. Returns whether the process was stopped.
    fn suspend(&mut self) -> io::Result<bool> {
        if !terminal::could_be_continued() {
            return Ok(false);
        }
        self.await_arrival();
        terminal::restore();
        terminal::stop()?;
        // The system stops the process a moment after the call; it goes on with a signal. The time runs out while stopped, too:
        // only the second wait in a row without a signal means that nothing happened.
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
        // The window may have changed meanwhile.
        self.put_off.push_front(LoopEvent::Message(size()?));
        Ok(stopped)
    }

    /// Wait for the answers that are under way, as long as they may take: a later one would reach the shell.
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

/// The message of the present size of the terminal.
fn size() -> io::Result<Message> {
    terminal::size().map(|(columns, rows)| Message::Resize(columns, rows))
}
