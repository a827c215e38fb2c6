//! Shots at a scene with other impact velocities, and the search for the limit between stopped and perforating shots.

use std::sync::Arc;

use crate::study::context::Context;
use crate::study::envelope::is_overloaded;
use crate::study::first_contact::{self, ContactOutput};
use crate::study::limit::closures::jump;
use crate::study::limit::shot_outcome::{BracketEnd, ShotOutcome, decide, edge};
use crate::study::limit::{
    ABOVE, BELOW, BESIDE_LIMIT, CURVE, Closures, Limit, LimitMethod, RANGE_M_S, ResidualAtLimit,
    SCAN, Shot, closed_form,
};
use cmra_engine::model::run::{EndReason, Observer, Outcome, Run, RunWarning};
use cmra_engine::model::scene::Scene;
use cmra_engine::model::simulate::{Settings, simulate};
use cmra_engine::numerics::{larger, smaller};

/// Relative width of the final bracket around the limit.
const WIDTH: f64 = 1e-10;
/// Relative distances from a limit at which the outcomes are checked, beside those of the curve. The limit is unique if all shots below it
/// are stopped and all shots above it perforate.
pub(super) const BESIDE: [f64; 6] = [1e-7, 1e-5, 1e-3, 1e-2, 0.05, 0.3];
/// Maximum number of times that the check of a limit may find a lower one.
const LOWER_MAX: usize = 4;
/// Difference of the residual velocities at two distances above a limit that is negligible, relative to it: the last digit on pages.
const SETTLED: f64 = 1e-4;
/// Relative width of the final bracket around the velocity at which the interface reaches its limit load.
const HOLDS_WIDTH: f64 = 1e-5;
/// Relative width of the final bracket around the slowest undecided shot: the last digit on pages.
const UNDECIDED_WIDTH: f64 = 1e-4;
/// Points of the scan for that velocity, and distance of the slowest one above the velocity of the plate, relative to it.
const HOLDS_SCAN: usize = 12;
const HOLDS_ABOVE: f64 = 1e-2;
/// Upper bound of the run tolerance: that of a default run, so that the same shot has the same outcome there.
const TOLERANCE: f64 = 1e-9;

/// Evaluation budget of all shots of a limit, in units of [`Cost::work`](cmra_engine::model::run::Cost::work): about 1.3 s, at 0.05 us each.
pub(super) const WORK_MAX: usize = 26_000_000;
/// Ratio of the remaining budget to that of the next shot. A limit takes one to three hundred shots, and the first ones determine the
/// others.
const SHOTS_LEFT: usize = 32;
/// Minimum evaluation budget of every shot; an ordinary shot takes less.
const WORK_OF_SHOT: usize = 20_000;

/// Evaluation budget of the shots of a limit. Shots that exceed the remaining budget end undecided.
#[derive(Debug, Default)]
pub(super) struct ShotWork {
    /// Work of all previous shots.
    pub(super) spent: usize,
}

impl ShotWork {
    /// Returns the settings of the next shot, with or without a series.
    fn of_shot(&self, settings: Settings) -> Settings {
        let left = WORK_MAX.saturating_sub(self.spent);
        let most = usize::max(left / SHOTS_LEFT, WORK_OF_SHOT);
        Settings { work_max: Some(most), ..settings }
    }

    /// Adds the work of finished shots.
    fn spend(&mut self, work: usize) {
        self.spent += work;
    }
}

/// Runs shots at a scene. Progress counts shots.
pub(super) struct ShotRunner<'s, 'c, 'w> {
    pub(super) scene: &'s Arc<Scene>,
    pub(super) context: &'c mut Context<'w>,
    pub(super) work: &'c mut ShotWork,
    /// Velocities of the shots that were stopped, m/s.
    pub(super) stopped_m_s: Vec<f64>,
}

impl ShotRunner<'_, '_, '_> {
    /// Returns `true` if the next shot may start; `false` once cancelled.
    pub(super) fn should_continue(&mut self) -> bool {
        let goes_on = self.context.should_continue();
        self.context.count(1);
        goes_on
    }

    /// Runs a shot at this velocity until it is decided; `None` if cancelled.
    fn shoot(&mut self, impact_m_s: f64) -> Option<(Shot, ShotOutcome)> {
        if !self.should_continue() {
            return None;
        }
        let settings = self.work.of_shot(Settings::BARE);
        let found = shot(self.scene, impact_m_s, &settings, &mut self.context.observer());
        self.work.spend(found.work);
        (!self.context.is_stopped()).then_some((found.shot, found.outcome))
    }

    /// Returns the outcome of a shot; `None` if cancelled.
    fn verdict(&mut self, impact_m_s: f64) -> Option<ShotOutcome> {
        let aimed = aimed(self.scene, impact_m_s);
        let at_contact =
            first_contact::contact(&aimed, ContactOutput::Passage, aimed.run.tolerance);
        let outcome = match at_contact {
            Some(end) => self.should_continue().then_some(ShotOutcome::of_contact(&aimed, &end))?,
            None => self.shoot(impact_m_s)?.1,
        };
        if outcome == ShotOutcome::Stopped {
            self.stopped_m_s.push(impact_m_s);
        }
        Some(outcome)
    }

    /// Runs a shot just below a limit; `None` if cancelled.
    pub(super) fn at_limit(&mut self, limit_m_s: f64) -> Option<Run> {
        if !self.should_continue() {
            return None;
        }
        let own = aimed(self.scene, limit_m_s * (1.0 - BESIDE_LIMIT));
        // The loads are those of a run: this one shot may take the work of one.
        let mut run = simulate(&own, &Settings::SERIES, &mut self.context.observer()).ok()?;
        self.work.spend(work_of(&run));
        // The limit has no depth to compare with the baseline.
        run.warnings.retain(|warning| *warning != RunWarning::NoBaseline);
        (run.end != EndReason::Cancelled).then_some(run)
    }

    /// Computes the residual velocity just above a limit; `None` if the shot does not perforate, or if cancelled.
    pub(super) fn residual_at_limit(&mut self, limit_m_s: f64) -> Option<ResidualAtLimit> {
        let mut beside = |part: f64| self.shoot(limit_m_s * (1.0 + part))?.0.residual_m_s;
        let [velocity_m_s, farther_m_s] = [beside(BESIDE_LIMIT)?, beside(10.0 * BESIDE_LIMIT)?];
        let is_settled = (velocity_m_s - farther_m_s).abs() <= SETTLED * limit_m_s;
        Some(ResidualAtLimit { velocity_m_s, is_settled })
    }

    /// Finds the velocity up to which a fused interface stays within its limit load, m/s, if it exceeds it just below the ballistic limit; 0
    /// if it exceeds it in all shots of a scan; `None` if it does not exceed it, if it does so in slow shots and not in some faster ones, or
    /// if cancelled.
    pub(super) fn interface_holds(&mut self, at_limit: &Run, limit_m_s: f64) -> Option<f64> {
        // The slowest shots do not reach a plate that moves away.
        let plate_m_s = self.scene.plate_velocity_m_s() * self.scene.cos_obliquity();
        let low = larger(RANGE_M_S.0, plate_m_s * (1.0 + HOLDS_ABOVE));
        if !is_overloaded(at_limit) || low >= limit_m_s {
            return None;
        }
        let ratio = (limit_m_s / low).powf(1.0 / HOLDS_SCAN as f64);
        let mut scan = Vec::new();
        for velocity_m_s in (0..HOLDS_SCAN).map(|point| low * ratio.powf(point as f64)) {
            scan.push((velocity_m_s, is_overloaded(&self.at_limit(velocity_m_s)?)));
        }
        scan.push((limit_m_s, true));
        let first = scan.iter().position(|(_, fails)| *fails)?;
        if first == 0 {
            return scan.iter().all(|(_, fails)| *fails).then_some(0.0);
        }
        let (mut holds, mut fails) = (scan[first - 1].0, scan[first].0);
        while fails - holds > HOLDS_WIDTH * fails {
            let between = 0.5 * (holds + fails);
            let side =
                if is_overloaded(&self.at_limit(between)?) { &mut fails } else { &mut holds };
            *side = between;
        }
        Some(holds)
    }

    /// Computes the limits by the three closures; `None` if there is only one closure, or if cancelled.
    pub(super) fn closures(&mut self) -> Option<Closures> {
        let Self { scene, .. } = *self;
        if !self.should_continue() {
            return None;
        }
        let work = &mut *self.work;
        self.context.uncounted(|context| Closures::from_scene(scene, context, work))
    }

    /// Computes the limits on either side of the jump at h = D; `None` without a jump, or if cancelled.
    pub(super) fn jump(&mut self) -> Option<(f64, f64)> {
        let Self { scene, .. } = *self;
        if !self.should_continue() {
            return None;
        }
        let work = &mut *self.work;
        self.context.uncounted(|context| jump(scene, context, work))
    }

    /// Computes the limit over the whole velocity range, by closed form or by outcome.
    fn limit(&mut self) -> Limit {
        if !self.scene.contact.model.knows_perforation() {
            return Limit::NotModelled;
        }
        if let Some(velocity_m_s) = closed_form(self.scene) {
            return if velocity_m_s < RANGE_M_S.0 {
                Limit::Always
            } else if velocity_m_s <= RANGE_M_S.1 {
                Limit::found(velocity_m_s, LimitMethod::ClosedForm)
            } else {
                Limit::Never
            };
        }
        self.search().unwrap_or(Limit::Unknown)
    }

    /// Searches for the limit and checks the outcomes on either side.
    pub(super) fn whole_limit(&mut self) -> Limit {
        let mut limit = self.limit();
        for _ in 0..LOWER_MAX {
            let Limit::Found { basis: LimitMethod::Outcome, .. } = limit else { break };
            let Some(beside) = self.check_neighbourhood(limit) else { return Limit::Unknown };
            if beside == limit {
                break;
            }
            limit = beside;
        }
        self.close_undecided(limit).unwrap_or(Limit::Unknown)
    }

    /// Closes in on the slowest undecided shot from the fastest one that is known to be stopped. A perforation between them lowers the limit.
    fn close_undecided(&mut self, limit: Limit) -> Option<Limit> {
        let Some(mut undecided_m_s) = limit.undecided_at_m_s() else { return Some(limit) };
        let slower = self.stopped_m_s.iter().filter(|it| **it < undecided_m_s);
        let mut stopped_m_s = slower.copied().fold(RANGE_M_S.0, larger);
        while undecided_m_s - stopped_m_s > UNDECIDED_WIDTH * undecided_m_s {
            let between_m_s = 0.5 * (stopped_m_s + undecided_m_s);
            match self.verdict(between_m_s)? {
                ShotOutcome::Stopped => stopped_m_s = between_m_s,
                ShotOutcome::Undecided => undecided_m_s = between_m_s,
                ShotOutcome::Perforated => {
                    let below = (stopped_m_s, ShotOutcome::Stopped);
                    let lower = self.closed_in(below, between_m_s)?;
                    let again = self.stopped_m_s.iter().copied().filter(|it| *it > between_m_s);
                    return self.close_undecided(lower.stopped_again(again.reduce(smaller)));
                }
            }
        }
        Some(limit.above_undecided(undecided_m_s))
    }

    /// Checks a limit by shots on either side. A perforation below it lowers the limit. A stopped shot above it marks the limit as not
    /// unique. Undecided shots below it do not change it.
    fn check_neighbourhood(&mut self, mut limit: Limit) -> Option<Limit> {
        let Limit::Found { velocity_m_s: limit_m_s, stopped_at_m_s, .. } = limit else {
            return Some(limit);
        };
        let mut stopped_m_s = None;
        let mut below: Vec<f64> =
            BESIDE.iter().map(|part| 1.0 - part).chain(curve_below()).collect();
        below.sort_by(f64::total_cmp);
        for times in below {
            let velocity_m_s = times * limit_m_s;
            match self.verdict(velocity_m_s)? {
                ShotOutcome::Stopped => stopped_m_s = Some(velocity_m_s),
                ShotOutcome::Undecided => limit = limit.above_undecided(velocity_m_s),
                ShotOutcome::Perforated => {
                    let lower_m_s = stopped_m_s.unwrap_or(RANGE_M_S.0);
                    let below = (lower_m_s, ShotOutcome::Stopped);
                    let lower = self.closed_in(below, velocity_m_s)?;
                    return Some(lower.stopped_again(Some(limit_m_s)));
                }
            }
        }
        let mut again_m_s = stopped_at_m_s;
        for part in BESIDE {
            let velocity_m_s = limit_m_s * (1.0 + part);
            if again_m_s.is_none_or(|again_m_s| velocity_m_s < again_m_s)
                && self.verdict(velocity_m_s)? == ShotOutcome::Stopped
            {
                again_m_s = Some(velocity_m_s);
            }
        }
        Some(limit.stopped_again(again_m_s))
    }

    /// Bisects between a shot that does not perforate and one that does.
    fn closed_in(&mut self, below: BracketEnd, through_m_s: f64) -> Option<Limit> {
        let mut slowest_m_s = None;
        let mut look = |velocity_m_s: f64| {
            let outcome = self.verdict(velocity_m_s)?;
            if outcome == ShotOutcome::Undecided {
                slowest_m_s =
                    Some(slowest_m_s.map_or(velocity_m_s, |it| smaller(it, velocity_m_s)));
            }
            Some(outcome)
        };
        let found = edge(through_m_s, below, WIDTH, &mut look)?;
        let limit = match found {
            (through_m_s, (undecided_m_s, ShotOutcome::Undecided)) => {
                Limit::Between { undecided_m_s, through_m_s: Some(through_m_s) }
            }
            (a, (b, _)) => Limit::found(0.5 * (a + b), LimitMethod::Outcome),
        };
        Some(slowest_m_s.map_or(limit, |undecided_m_s| limit.above_undecided(undecided_m_s)))
    }

    /// Finds the limit by the outcome of runs: a geometrically spaced scan, then bisection.
    pub(super) fn search(&mut self) -> Option<Limit> {
        let (low, high): (f64, f64) = RANGE_M_S;
        let ratio = (high / low).powf(1.0 / (SCAN - 1) as f64);
        let velocities: Vec<f64> = (0..SCAN).map(|point| low * ratio.powf(point as f64)).collect();
        let (mut below, mut undecided_m_s) = (None, None);
        for (point, &velocity) in velocities.iter().enumerate() {
            let verdict = self.verdict(velocity)?;
            if verdict != ShotOutcome::Perforated {
                below = Some((velocity, verdict));
                let is_undecided = verdict == ShotOutcome::Undecided;
                undecided_m_s = undecided_m_s.or_else(|| is_undecided.then_some(velocity));
                continue;
            }
            // If all slow shots perforate, a stopped faster shot does not define a limit velocity.
            let Some(below) = below else { return Some(Limit::Always) };
            let mut again_m_s = None;
            for &faster_m_s in &velocities[point + 1..] {
                if self.verdict(faster_m_s)? == ShotOutcome::Stopped {
                    again_m_s = Some(faster_m_s);
                    break;
                }
            }
            let limit = self.closed_in(below, velocity)?.stopped_again(again_m_s);
            return Some(match undecided_m_s {
                Some(undecided_m_s) => limit.above_undecided(undecided_m_s),
                None => limit,
            });
        }
        // An undecided shot is not known to be stopped.
        Some(match undecided_m_s {
            Some(undecided_m_s) => Limit::Between { undecided_m_s, through_m_s: None },
            None => Limit::Never,
        })
    }

    /// Computes the shots of the residual-velocity curve, denser above the limit; over the whole range without a limit.
    pub(super) fn curve(&mut self, limit: Limit) -> Vec<Shot> {
        let velocities: Vec<f64> = match limit {
            Limit::Found { velocity_m_s, .. } => {
                // The curve is steepest at the limit.
                let fraction = |i: usize| i as f64 / ABOVE as f64;
                let above = (1..=ABOVE).map(|i| 1.0 + (CURVE.1 - 1.0) * fraction(i).powi(2));
                curve_below().chain(above).map(|times| times * velocity_m_s).collect()
            }
            Limit::Between { .. } | Limit::Never | Limit::Always => {
                let (low, high): (f64, f64) = RANGE_M_S;
                let step = (high / low).powf(1.0 / ABOVE as f64);
                (0..=ABOVE).map(|i| low * step.powf(i as f64)).collect()
            }
            Limit::NotModelled | Limit::Unknown => Vec::new(),
        };
        let (scene, stop) = (self.scene, self.context.stop());
        // Shared settings make the result independent of the order in which the shots end.
        let settings = self.work.of_shot(Settings::BARE);
        let shoot = |velocity_m_s: &f64| {
            let found = shot(scene, *velocity_m_s, &settings, &mut |_| stop.flow());
            (!stop.is_set()).then_some(found)
        };
        let all =
            self.context.map_items(&velocities, shoot, |context, _| context.should_continue());
        self.work.spend(all.iter().map(|found| found.work).sum());
        all.into_iter().map(|found| found.shot).collect()
    }
}

/// Returns the velocities of the curve below the limit, relative to it.
fn curve_below() -> impl Iterator<Item = f64> {
    (0..BELOW).map(|i| CURVE.0 + (1.0 - CURVE.0) * i as f64 / BELOW as f64)
}

/// Shot with its outcome and its work.
#[derive(Clone, Copy, Debug)]
struct DecidedShot {
    shot: Shot,
    outcome: ShotOutcome,
    work: usize,
}

/// Returns the work of a run, for all plates.
fn work_of(run: &Run) -> usize {
    let behind = run.stack.iter().flat_map(|stack| &stack.behind);
    behind.map(|run| run.cost.work()).sum::<usize>() + run.cost.work()
}

/// Runs a shot at a scene with another impact velocity until it is decided or cancelled.
fn shot(
    scene: &Scene,
    impact_m_s: f64,
    settings: &Settings,
    observer: Observer<'_>,
) -> DecidedShot {
    let without_run = |own: Outcome, outcome: ShotOutcome| DecidedShot {
        shot: Shot { impact_m_s, outcome: own, residual_m_s: None },
        outcome,
        work: 0,
    };
    let aimed = aimed(scene, impact_m_s);
    if aimed.closing_velocity_m_s() <= 0.0 {
        return without_run(Outcome::Separated, ShotOutcome::Stopped);
    }
    // The scene is already validated, and any velocity that reaches the plate is valid.
    match decide(&aimed, settings, observer) {
        Some((run, outcome)) => DecidedShot {
            shot: Shot {
                impact_m_s,
                outcome: run.shot_outcome(),
                residual_m_s: run.shot_residual_m_s(),
            },
            outcome,
            work: work_of(&run),
        },
        None => without_run(Outcome::Moving, ShotOutcome::Undecided),
    }
}

pub(super) fn aimed(scene: &Scene, impact_m_s: f64) -> Arc<Scene> {
    let mut own = scene.clone();
    own.projectile.velocity_m_s = impact_m_s;
    own.run.tolerance = smaller(own.run.tolerance, TOLERANCE);
    Arc::new(own)
}
