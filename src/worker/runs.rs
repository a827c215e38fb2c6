//! Runs of scenes: the run of the screen shows its curve while it grows.

use std::error::Error;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Duration;

use super::reporter::{BETWEEN, Reporter};
use super::studies::StudyResult;
use super::{JobProgress, ReportBody, Slot};
use cmra_engine::model::run::Run;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::simulate::{self, RunSnapshot, Settings};
use cmra_studies::study::context::{Answer, Progress, Reach};

/// A run that ends before this reports only that it has ended: no frame is spent on its beginning.
const QUIET: Duration = Duration::from_millis(20);

/// A person waits for the curve of a run that takes so long.
const SLOW: Duration = Duration::from_millis(200);

/// A curve waits at least this many times as long as the one before took.
const PART_SHARE: u32 = 20;

/// Steps between two looks at the clock (a look costs about as much as a tenth of a step).
const STEPS_PER_LOOK: u32 = 8;

/// Steps after which the plastic interface beside a fused one is given up: nobody waits for it.
const PLASTIC_STEPS: u32 = 200_000;

/// Runs a scene, for the screen or for a pin.
pub(super) fn of_scene(
    slot: Slot,
    scene: &Arc<Scene>,
    reporter: &Reporter<'_>,
) -> Result<StudyResult, Box<dyn Error>> {
    run(slot, scene, reporter, |settings, observer| {
        simulate::simulate(scene, settings, observer).map_err(|error| error.to_string())
    })
}

/// Run a scene. The computation calls the observer before every step, which may end it, and look at the results so far.
pub(super) fn run(
    slot: Slot,
    scene: &Arc<Scene>,
    reporter: &Reporter<'_>,
    compute: impl FnOnce(&Settings, simulate::Observer<'_>) -> Result<Run, String>,
) -> Result<StudyResult, Box<dyn Error>> {
    let mut pulse = ReportSchedule { pause: SLOW, ..ReportSchedule::default() };
    let mut observer = |look: &RunSnapshot<'_>| {
        reporter.check_cancelled()?;
        if let Some(t_s) = pulse.beat(look.t_s, || reporter.elapsed()) {
            let (progress, elapsed) = (JobProgress::Time(t_s), reporter.elapsed());
            (reporter.send)(ReportBody::Progress { progress, elapsed });
        }
        if slot == Slot::Current
            && pulse.part_is_due()
            && let Some(run) = (look.so_far)()
        {
            // It is not to spend more than a small part of its time on them.
            pulse.pause =
                BETWEEN.max(PART_SHARE * reporter.elapsed().saturating_sub(pulse.last_poll));
            let (reach, elapsed) = (Reach::Partial(Progress::default()), reporter.elapsed());
            (reporter.send)(ReportBody::Part(Answer { report: run.into(), reach, elapsed }));
        }
        ControlFlow::Continue(())
    };
    let mut run = compute(&Settings::default(), &mut observer)?;
    // The time is that of the run by itself.
    let took = reporter.elapsed();
    reporter.elapsed.set(Some(took));
    run.cost.took_s = Some(took.as_secs_f64());
    if run.end.is_complete() {
        let mut left = PLASTIC_STEPS;
        let mut observer = |_: &RunSnapshot<'_>| {
            left = left.saturating_sub(1);
            if left == 0 { ControlFlow::Break(()) } else { reporter.check_cancelled() }
        };
        run.plastic = simulate::plastic_beside(scene, &mut observer).map(Arc::new);
    }
    Ok(run.into())
}

/// When a run reports; times count from its start.
#[derive(Default)]
struct ReportSchedule {
    steps: u32,
    /// The last look at the clock.
    seen: Duration,
    last_progress: Option<Duration>,
    /// When the curve so far was requested last, and how long the next one has to wait from then on.
    last_poll: Duration,
    pause: Duration,
}

impl ReportSchedule {
    /// Whether it is time, by the last look at the clock, for a person to see the curve so far; it then counts as requested.
    fn part_is_due(&mut self) -> bool {
        let is_due = self.seen >= self.last_poll + self.pause;
        if is_due {
            (self.last_poll, self.pause) = (self.seen, BETWEEN);
        }
        is_due
    }

    /// After a step that reached `t_s`: the time to report, if any; 0 says that the run takes a moment.
    fn beat(&mut self, t_s: f64, elapsed: impl Fn() -> Duration) -> Option<f64> {
        self.steps = self.steps.wrapping_add(1);
        if !self.steps.is_multiple_of(STEPS_PER_LOOK) {
            return None;
        }
        self.seen = elapsed();
        match self.last_progress {
            None if self.seen >= QUIET => {
                self.last_progress = Some(Duration::ZERO);
                Some(0.0)
            }
            Some(last_progress) if self.seen >= last_progress + BETWEEN => {
                self.last_progress = Some(self.seen);
                Some(t_s)
            }
            _ => None,
        }
    }
}
