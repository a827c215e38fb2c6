//! When to draw: at once when little has been drawn lately, and never more often than a slow line can bear.
//!
//! A change waits a few milliseconds for the result of the run it started, so that value and curves come in one frame. Knows
//! no clock: the time is passed in.

use std::time::{Duration, Instant};

/// Least mean time between frames.
const FRAME: Duration = Duration::from_millis(50);

/// The same while a job is running that takes a while.
const FRAME_WHILE_RUNNING: Duration = Duration::from_millis(100);

/// Frames that may be drawn in quick succession after a pause.
const BURST: u32 = 3;

/// How long a frame waits for the result of a run just started.
const GRACE: Duration = Duration::from_millis(12);

pub(super) struct Pace {
    /// Whether anything has changed since the last frame.
    dirty: bool,
    /// When the budget will be full again; each frame moves it on by one interval.
    full_at: Instant,
    /// Until when a frame waits for a result.
    waits_until: Option<Instant>,
    /// A job is running and has said so.
    busy: bool,
}

impl Pace {
    /// Nothing drawn yet, and everything to draw.
    pub(super) fn new(now: Instant) -> Self {
        Self { dirty: true, full_at: now, waits_until: None, busy: false }
    }

    pub(super) fn change(&mut self) {
        self.dirty = true;
    }

    /// A run has been started whose result may come at once.
    pub(super) fn expect_result(&mut self, now: Instant) {
        // The first run of several decides: a held key must not put the frame off for ever.
        self.waits_until.get_or_insert(now + GRACE);
    }

    /// No result is being waited for any more.
    pub(super) fn result_came(&mut self) {
        self.waits_until = None;
    }

    /// Whether a job is running that takes a while.
    pub(super) fn set_busy(&mut self, busy: bool) {
        self.busy = busy;
    }

    /// When the next frame is to be drawn; `None` when there is nothing to draw.
    pub(super) fn due(&self) -> Option<Instant> {
        if !self.dirty {
            return None;
        }
        let spare = self.interval() * (BURST - 1);
        let budget = self.full_at.checked_sub(spare).unwrap_or(self.full_at);
        Some(self.waits_until.map_or(budget, |until| until.max(budget)))
    }

    /// A frame has been drawn; one that changed nothing cost the line nothing.
    pub(super) fn drawn(&mut self, now: Instant, changed: bool) {
        self.dirty = false;
        self.waits_until = None;
        if changed {
            self.full_at = self.full_at.max(now) + self.interval();
        }
    }

    fn interval(&self) -> Duration {
        if self.busy { FRAME_WHILE_RUNNING } else { FRAME }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Frames drawn in `span` when something changes every millisecond.
    fn frames(pace: &mut Pace, start: Instant, span: Duration) -> u32 {
        let mut frames = 0;
        let mut now = start;
        while now < start + span {
            pace.change();
            if pace.due().is_some_and(|due| due <= now) {
                pace.drawn(now, true);
                frames += 1;
            }
            now += Duration::from_millis(1);
        }
        frames
    }

    #[test]
    fn idle_draws_nothing() {
        let now = Instant::now();
        let mut pace = Pace::new(now);
        assert!(pace.due().is_some_and(|due| due <= now));
        pace.drawn(now, true);
        assert_eq!(pace.due(), None);
    }

    #[test]
    fn a_change_after_a_pause_is_drawn_at_once() {
        let start = Instant::now();
        let mut pace = Pace::new(start);
        pace.drawn(start, true);
        let later = start + Duration::from_secs(1);
        pace.change();
        assert!(pace.due().is_some_and(|due| due <= later));
    }

    #[test]
    fn a_flood_gets_twenty_frames_a_second_and_ten_while_running() {
        let start = Instant::now();
        let mut pace = Pace::new(start);
        let ten = Duration::from_secs(10);
        let drawn = frames(&mut pace, start, ten);
        assert!((200..=200 + BURST).contains(&drawn), "{drawn}");
        pace.set_busy(true);
        let drawn = frames(&mut pace, start + ten, ten);
        assert!((98..=100 + BURST).contains(&drawn), "{drawn}");
    }

    #[test]
    fn a_frame_waits_for_a_result_but_not_for_ever() {
        let start = Instant::now();
        let mut pace = Pace::new(start);
        pace.expect_result(start);
        let due = pace.due().expect("something to draw");
        assert_eq!(due, start + GRACE);
        // Another run does not put it off.
        pace.expect_result(start + GRACE / 2);
        assert_eq!(pace.due(), Some(due));
        pace.result_came();
        assert!(pace.due().is_some_and(|due| due <= start));
    }
}
