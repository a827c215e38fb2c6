//! Frame scheduling: draws immediately after a pause, and limits the rate on a slow connection.
//!
//! Each frame requests an acknowledgement from the terminal, and the next frame is drawn after it. On a slow connection the picture is
//! therefore at most one frame time old. Terminals that do not answer are not asked again.
//!
//! Animations leave the connection idle for longer than a frame takes, so that keys have priority.
//!
//! A change waits a few milliseconds for the result of its run, so that value and curves appear in one frame. Does not read a clock: the
//! time is an argument.

use std::time::{Duration, Instant};

/// Minimum mean time between frames.
const FRAME: Duration = Duration::from_millis(50);

/// Maximum number of frames in quick succession after a pause.
const BURST: u32 = 3;

/// Maximum time that a frame waits for the result of a new run.
const GRACE: Duration = Duration::from_millis(12);

/// Maximum time that a frame waits for the previous acknowledgement, for a terminal that has answered before, and for one that has not.
const ARRIVAL: Duration = Duration::from_secs(3);
const FIRST_ARRIVAL: Duration = Duration::from_secs(1);

/// Maximum time for the last acknowledgement when quitting: a frame of 10 kB at 2 kB/s. The shell would receive a later one as typed text.
const LAST_ARRIVAL: Duration = Duration::from_secs(5);

/// Number of consecutive frames without acknowledgement after which the terminal is not asked again, if it has answered before, and if not.
const UNANSWERED: u32 = 5;
const NEVER_ANSWERED: u32 = 2;

/// Idle time of the connection after an animation frame, relative to the time of that frame.
const REST: f64 = 2.0;
/// Minimum idle time after an animation frame for a terminal that does not acknowledge frames, and bytes per second of such frames.
const REST_UNKNOWN: Duration = Duration::from_millis(250);
const RATE_UNKNOWN: f64 = 2000.0;

pub(super) struct FrameScheduler {
    /// Whether the screen has changed since the last frame.
    dirty: bool,
    /// Whether an animation has changed since the last frame.
    moving: bool,
    /// Earliest time of the next animation frame.
    rests_until: Instant,
    /// Time at which the budget is full; each frame delays it by one interval.
    full_at: Instant,
    /// Time until which a frame waits for a result.
    waits_until: Option<Instant>,
    /// Time of the last frame, if it is not acknowledged.
    under_way: Option<Instant>,
    /// Number of pending acknowledgements, and the time of the last request.
    owed: (u32, Option<Instant>),
    /// Number of consecutive frames without acknowledgement.
    unanswered: u32,
    /// Whether the terminal has ever acknowledged a frame.
    answers: bool,
}

impl FrameScheduler {
    /// Creates the initial state: nothing is drawn, and a frame is due.
    pub(super) fn new(now: Instant) -> Self {
        Self {
            dirty: true,
            moving: false,
            rests_until: now,
            full_at: now,
            waits_until: None,
            under_way: None,
            owed: (0, None),
            unanswered: 0,
            answers: false,
        }
    }

    pub(super) fn change(&mut self) {
        self.dirty = true;
    }

    /// Marks an animated part of the screen as changed.
    pub(super) fn animate(&mut self) {
        self.moving = true;
    }

    /// Records that a run was started whose result may come soon.
    pub(super) fn expect_result(&mut self, now: Instant) {
        // The first of several runs determines the time, so that a held key does not delay the frame indefinitely.
        self.waits_until.get_or_insert(now + GRACE);
    }

    /// Records that no result is expected any more.
    pub(super) fn result_came(&mut self) {
        self.waits_until = None;
    }

    /// Returns the time of the next frame; `None` if there is nothing to draw.
    pub(super) fn due(&self) -> Option<Instant> {
        if !self.dirty && !self.moving {
            return None;
        }
        let rest = (!self.dirty).then_some(self.rests_until);
        let spare = FRAME * (BURST - 1);
        let budget = self.full_at.checked_sub(spare).unwrap_or(self.full_at);
        let patience = if self.answers { ARRIVAL } else { FIRST_ARRIVAL };
        let arrived = self.under_way.map(|drawn| drawn + patience);
        [self.waits_until, arrived, rest].into_iter().flatten().chain([budget]).max()
    }

    /// Returns `true` if the frame should request an acknowledgement.
    pub(super) fn requests_ack(&self) -> bool {
        self.unanswered < if self.answers { UNANSWERED } else { NEVER_ANSWERED }
    }

    /// Returns the time until which an acknowledgement may come; `None` if none is pending.
    pub(super) fn answers_until(&self) -> Option<Instant> {
        let (count, last) = self.owed;
        last.filter(|_| count > 0).map(|asked| asked + LAST_ARRIVAL)
    }

    /// Records the acknowledgement of the last frame.
    pub(super) fn arrived(&mut self, now: Instant) {
        if let Some(drawn) = self.under_way {
            self.rests_until = now + now.saturating_duration_since(drawn).mul_f64(REST);
        }
        (self.under_way, self.unanswered, self.answers) = (None, 0, true);
        self.owed.0 = self.owed.0.saturating_sub(1);
    }

    /// Discards pending acknowledgements after the terminal was handed over.
    pub(super) fn lost(&mut self) {
        (self.under_way, self.owed) = (None, (0, None));
    }

    /// Records that a frame of so many bytes was drawn; an unchanged frame has none.
    pub(super) fn drawn(&mut self, now: Instant, bytes: usize) {
        (self.dirty, self.moving) = (false, false);
        self.waits_until = None;
        if bytes > 0 {
            if !self.answers {
                let takes = Duration::from_secs_f64(bytes as f64 / RATE_UNKNOWN);
                self.rests_until = now + takes.max(REST_UNKNOWN);
            }
            self.full_at = self.full_at.max(now) + FRAME;
            let asked = self.requests_ack();
            self.unanswered += u32::from(self.under_way.is_some());
            self.under_way = asked.then_some(now);
            if asked {
                self.owed = (self.owed.0 + 1, Some(now));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Frames drawn in `span` when something changes every millisecond.
    fn frames(pace: &mut FrameScheduler, start: Instant, span: Duration) -> u32 {
        let mut frames = 0;
        let mut now = start;
        while now < start + span {
            pace.change();
            if pace.due().is_some_and(|due| due <= now) {
                pace.drawn(now, 1);
                frames += 1;
            }
            now += Duration::from_millis(1);
        }
        frames
    }

    /// On a slow connection two requests may be pending; both answers belong to this program.
    #[test]
    fn every_answer_is_awaited_for_some_seconds() {
        let start = Instant::now();
        let mut pace = FrameScheduler::new(start);
        assert_eq!(pace.answers_until(), None);
        let second = start + Duration::from_secs(4);
        for now in [start, second] {
            pace.change();
            pace.drawn(now, 1);
        }
        let until = Some(second + LAST_ARRIVAL);
        assert_eq!(pace.answers_until(), until);
        pace.arrived(second);
        assert_eq!(pace.answers_until(), until);
        pace.arrived(second);
        assert_eq!(pace.answers_until(), None);
        // Another program receives the answers of a terminal that was handed over.
        pace.change();
        pace.drawn(second, 1);
        pace.lost();
        assert_eq!(pace.answers_until(), None);
    }

    #[test]
    fn idle_draws_nothing() {
        let now = Instant::now();
        let mut pace = FrameScheduler::new(now);
        assert!(pace.due().is_some_and(|due| due <= now));
        pace.drawn(now, 1);
        assert_eq!(pace.due(), None);
    }

    #[test]
    fn a_flood_gets_twenty_frames_a_second() {
        let start = Instant::now();
        let mut pace = FrameScheduler { unanswered: UNANSWERED, ..FrameScheduler::new(start) };
        let ten = Duration::from_secs(10);
        let drawn = frames(&mut pace, start, ten);
        assert!((200..=200 + BURST).contains(&drawn), "{drawn}");
    }

    /// A frame of 1900 bytes takes 0.38 s at 5 kB/s.
    #[test]
    fn on_a_slow_line_a_frame_is_drawn_when_the_last_one_has_arrived() {
        let start = Instant::now();
        let mut pace = FrameScheduler::new(start);
        pace.drawn(start, 1);
        pace.arrived(start);
        let (mut now, mut frames) = (start, 0);
        let mut arrives = None;
        while now < start + Duration::from_secs(10) {
            now += Duration::from_millis(1);
            pace.change();
            if arrives.is_some_and(|at| at <= now) {
                pace.arrived(now);
                arrives = None;
            }
            if pace.due().is_some_and(|due| due <= now) {
                assert_eq!(arrives, None, "one is under way");
                pace.drawn(now, 1);
                arrives = Some(now + Duration::from_millis(380));
                frames += 1;
            }
        }
        assert!((25..=27).contains(&frames), "{frames}");
    }

    /// A frame of 600 bytes takes 0.12 s at 5 kB/s; with an idle time twice as long that is 1.7 kB/s. Keys do not wait.
    #[test]
    fn what_moves_by_itself_leaves_a_slow_line_free() {
        let start = Instant::now();
        let mut pace = FrameScheduler::new(start);
        pace.drawn(start, 1);
        pace.arrived(start);
        let (mut now, mut frames, mut arrives) = (start, 0, None);
        while now < start + Duration::from_secs(10) {
            now += Duration::from_millis(1);
            pace.animate();
            if arrives.is_some_and(|at| at <= now) {
                pace.arrived(now);
                arrives = None;
            }
            if pace.due().is_some_and(|due| due <= now) {
                pace.drawn(now, 1);
                arrives = Some(now + Duration::from_millis(120));
                frames += 1;
            }
        }
        assert!((26..=29).contains(&frames), "{frames}");
        pace.arrived(now);
        let rest = pace.due();
        pace.change();
        assert!(pace.due() <= rest && pace.due().is_some_and(|due| due <= now + FRAME));
    }

    /// Where the speed of the line is unknown, an animation takes 2 kB/s.
    #[test]
    fn without_answers_large_frames_of_an_animation_are_rare() {
        let start = Instant::now();
        for (bytes, rest) in [(100, REST_UNKNOWN), (3000, Duration::from_millis(1500))] {
            let mut pace = FrameScheduler { unanswered: UNANSWERED, ..FrameScheduler::new(start) };
            pace.drawn(start, bytes);
            pace.animate();
            assert_eq!(pace.due(), Some(start + rest));
        }
    }

    #[test]
    fn a_terminal_that_does_not_answer_is_asked_no_more() {
        let start = Instant::now();
        let mut pace = FrameScheduler::new(start);
        let ten = Duration::from_secs(10);
        frames(&mut pace, start, ten);
        assert!(!pace.requests_ack());
        // Quitting waits a few seconds for the last acknowledgement.
        assert!(pace.answers_until().is_some_and(|until| until < start + ten));
        let drawn = frames(&mut pace, start + ten, ten);
        assert!(drawn >= 200, "{drawn}");
        // A terminal that has answered before is given more time.
        let mut pace = FrameScheduler::new(start);
        pace.drawn(start, 1);
        pace.arrived(start);
        pace.drawn(start + ten, 1);
        pace.change();
        assert_eq!(pace.due(), Some(start + ten + ARRIVAL));
    }

    #[test]
    fn a_frame_waits_for_a_result_but_not_for_ever() {
        let start = Instant::now();
        let mut pace = FrameScheduler::new(start);
        pace.expect_result(start);
        let due = pace.due().expect("something to draw");
        assert_eq!(due, start + GRACE);
        // Another run does not delay the frame.
        pace.expect_result(start + GRACE / 2);
        assert_eq!(pace.due(), Some(due));
        pace.result_came();
        assert!(pace.due().is_some_and(|due| due <= start));
    }
}
