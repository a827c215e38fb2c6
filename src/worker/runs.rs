//! Runs of scenes. The run of the edited scene reports its time series while it is computed.

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

/// Duration below which a run sends only its final report: a frame for the start would be replaced at once.
const QUIET: Duration = Duration::from_millis(20);

/// Duration after which a run sends partial results: the delay is noticeable.
const SLOW: Duration = Duration::from_millis(200);

/// Minimum interval between two partial results, relative to the time that the last one took: at most 5 % of the run.
const PART_SHARE: u32 = 20;

/// Steps between two readings of the clock. A reading takes about a tenth of a step.
const STEPS_PER_LOOK: u32 = 8;

/// Runs a scene and reports the result.
pub(super) fn of_scene(
    slot: Slot,
    scene: &Arc<Scene>,
    reporter: &Reporter<'_>,
) -> Result<StudyResult, Box<dyn Error>> {
    run(slot, reporter, |settings, took_s, observer| {
        simulate::simulate_beside_plastic(scene, settings, took_s, observer)
            .map_err(|error| error.to_string())
    })
}

/// Runs a scene. An observer, called before each step, sends partial results and stops a cancelled run.
pub(super) fn run(
    slot: Slot,
    reporter: &Reporter<'_>,
    compute: impl FnOnce(
        &Settings,
        &mut dyn FnMut() -> f64,
        simulate::Observer<'_>,
    ) -> Result<Run, String>,
) -> Result<StudyResult, Box<dyn Error>> {
    let mut pulse = ReportSchedule { pause: SLOW, ..ReportSchedule::default() };
    let mut observer = |look: &RunSnapshot<'_>| {
        reporter.check_cancelled()?;
        if reporter.elapsed.get().is_some() {
            // The run is complete; what remains is the one with a plastic interface beside it.
            return ControlFlow::Continue(());
        }
        if let Some(t_s) = pulse.beat(look.t_s, || reporter.elapsed()) {
            let (progress, elapsed) = (JobProgress::Time(t_s), reporter.elapsed());
            (reporter.send)(ReportBody::Progress { progress, elapsed });
        }
        if slot == Slot::Current
            && pulse.part_is_due()
            && let Some(run) = (look.so_far)()
        {
            // Partial results take at most a small fraction of the time.
            pulse.pause =
                BETWEEN.max(PART_SHARE * reporter.elapsed().saturating_sub(pulse.last_poll));
            let (reach, elapsed) = (Reach::Partial(Progress::default()), reporter.elapsed());
            (reporter.send)(ReportBody::Part(Answer { report: run.into(), reach, elapsed }));
        }
        ControlFlow::Continue(())
    };
    // The run time excludes the additional run with a plastic interface.
    let took_s = &mut || {
        let took = reporter.elapsed();
        reporter.elapsed.set(Some(took));
        took.as_secs_f64()
    };
    Ok(compute(&Settings::default(), took_s, &mut observer)?.into())
}

/// Schedule of the reports of a run; times since its start.
#[derive(Default)]
struct ReportSchedule {
    steps: u32,
    /// Last reading of the clock.
    seen: Duration,
    last_progress: Option<Duration>,
    /// Time of the last partial result.
    last_poll: Duration,
    /// Minimum interval until the next partial result.
    pause: Duration,
}

impl ReportSchedule {
    /// Returns `true` if a partial result is due at the last reading of the clock, and marks it as sent.
    fn part_is_due(&mut self) -> bool {
        let is_due = self.seen >= self.last_poll + self.pause;
        if is_due {
            (self.last_poll, self.pause) = (self.seen, BETWEEN);
        }
        is_due
    }

    /// Returns the simulated time to report after a step that reached `t_s`, if a report is due; 0 for the first report.
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
