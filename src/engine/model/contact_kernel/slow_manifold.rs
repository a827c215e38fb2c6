//! Contacts whose plates follow the slow manifold of their springs: pass by pass, as many in parallel as the vectors hold.
//!
//! Each lane is at a pass of its own. After a pass it takes another about the new balance, or has settled and takes a step, or
//! fails and tries a shorter one; and where even that fails it hands over to plain steps. A single contact is one lane.

use std::ops::ControlFlow;

use pulp::{Arch, Scalar, Simd, WithSimd};

use crate::model::contact_kernel::Contact;
use crate::model::contact_kernel::expansion::{Area, Constants, Series, trusted};
use crate::model::contact_kernel::integration::{
    InitialPhase, IntegrationState, STEPS_MAX, Sides, StepEnd, plate_scale_m,
};
use crate::model::contact_kernel::lane_buffer::{CONSTANTS, LANES_MAX, LaneBuffer, has_lanes};
use crate::model::contact_kernel::slow_manifold_series::{
    About, Balance, Guess, Lag, Spring, SpringManifold, tolerance_factor,
};
use crate::numerics::larger;
use crate::numerics::wide::Wide;

/// Maximum number of passes.
const PASSES_MAX: usize = 8;
/// Part of the tolerance by which the last two passes may differ.
const PASS_TOLERANCE: f64 = 0.3;
/// What a pass must at least gain, after the first few.
const PASS_GAIN: f64 = 0.5;
const FIRST_PASSES: usize = 3;
/// Part of a step below which a plate that has left the manifold is not tried again.
const RETRY_STEP_MIN: f64 = 0.1;

const STATE: usize = 0;
const UNIT: usize = 4;
const PIECE: usize = 5;
const SPRING: usize = 9;
const BALANCE: usize = 13;
const PLATE_SCALE: usize = 15;
const FIXED: usize = 16;
/// The result of a pass.
const SPEEDS: usize = FIXED + CONSTANTS;
const TRUSTED: usize = SPEEDS + 2;
const SIZE: usize = TRUSTED + 1;
const SLOPE: usize = SIZE + 1;
const END: usize = SLOPE + 1;
const ROWS: usize = END + 4;

/// A contact on the slow manifold.
#[derive(Clone, Copy, Debug)]
pub(super) struct ManifoldRun {
    manifold: SpringManifold,
    tolerance: f64,
    progress: IntegrationState,
    /// From where another method goes on: a step earlier than where this one was seen to fail.
    before: IntegrationState,
    /// The area law of the piece that the last step ended with.
    joint: Option<Area>,
    /// How far steps are trusted after failures.
    reach_factor: f64,
    terms: usize,
}

/// An expansion about the present state.
#[derive(Clone, Copy, Debug)]
struct Attempt {
    area: Area,
    /// Made with the area law of the piece before, to see whether the next one sets the plate oscillating.
    by_piece_before: bool,
    passes: usize,
    balance: Balance,
    /// How far that is from the one before, relative.
    moved: f64,
    /// By how much the pass before changed the plate's displacement, relative.
    change: f64,
}

/// The next attempt, or what follows the manifold.
type Continued = ControlFlow<InitialPhase, Attempt>;

#[derive(Clone, Copy, PartialEq, Eq)]
enum PassResult {
    Again,
    Settled,
    Failed,
}

impl ManifoldRun {
    pub(super) fn from(
        manifold: SpringManifold,
        start: IntegrationState,
        tolerance: f64,
        terms: usize,
    ) -> Self {
        Self {
            manifold,
            tolerance,
            progress: start,
            before: start,
            joint: None,
            reach_factor: 1.0,
            terms,
        }
    }

    fn step(&mut self, contact: &Contact) -> Continued {
        if self.progress.steps >= STEPS_MAX {
            return ControlFlow::Break(self.left(contact));
        }
        let Some(area) = contact.area_law(self.progress.piece) else {
            return ControlFlow::Break(self.left(contact));
        };
        self.progress.steps += 1;
        self.attempt(contact, area, false)
    }

    fn attempt(&mut self, contact: &Contact, area: Area, by_piece_before: bool) -> Continued {
        let IntegrationState { state, .. } = self.progress;
        let guess = Guess { balance: self.manifold.at(state[2]), lag_n: 0.0, speed_m_s: state[3] };
        let found = self.manifold.balance(&contact.constants, state, area, &guess);
        let Some(balance) = found else { return self.failed(contact, by_piece_before) };
        let (moved, change) = ((balance.plate_m - state[2]).abs() / balance.plate_m, f64::INFINITY);
        let attempt = Attempt { area, by_piece_before, passes: 0, balance, moved, change };
        ControlFlow::Continue(attempt)
    }

    /// The next attempt after a failure.
    fn failed(&mut self, contact: &Contact, by_piece_before: bool) -> Continued {
        if let (Some(area), false) = (self.joint, by_piece_before) {
            return self.attempt(contact, area, true);
        }
        if self.progress.piece != self.before.piece || self.reach_factor < RETRY_STEP_MIN {
            return ControlFlow::Break(self.handed(contact, self.before));
        }
        // The step there may have been too long, and so may be those to come.
        self.reach_factor *= 0.5;
        self.progress = IntegrationState { steps: self.progress.steps, ..self.before };
        self.step(contact)
    }

    /// What a pass means that gave these plate velocities, the one it was made with first; finds the next balance.
    fn assess(
        &self,
        contact: &Contact,
        attempt: &mut Attempt,
        [old_m_s, new_m_s]: [f64; 2],
        lag_n: f64,
    ) -> PassResult {
        let IntegrationState { state, clock, .. } = self.progress;
        let tolerance = self.tolerance * tolerance_factor(state[2], self.manifold.reach_m);
        let x = attempt.balance.plate_m;
        let change = larger(attempt.moved, (old_m_s - new_m_s).abs() * clock.rates()[0] / x);
        // The first has no inertia yet, and agrees with a step before that had none.
        if attempt.passes > 0 && change <= PASS_TOLERANCE * tolerance {
            let keeps = self.manifold.keeps_to(attempt.balance, new_m_s, state, tolerance);
            return if keeps { PassResult::Settled } else { PassResult::Failed };
        }
        if attempt.passes >= FIRST_PASSES && change > PASS_GAIN * attempt.change {
            return PassResult::Failed;
        }
        let guess = Guess { balance: attempt.balance, lag_n, speed_m_s: new_m_s };
        let next = self.manifold.balance(&contact.constants, state, attempt.area, &guess);
        let Some(balance) = next.filter(|_| attempt.passes + 1 < PASSES_MAX) else {
            return PassResult::Failed;
        };
        let moved = (balance.plate_m - x).abs() / balance.plate_m;
        let passes = attempt.passes + 1;
        *attempt = Attempt { passes, balance, moved, change, ..*attempt };
        PassResult::Again
    }

    /// Take the step that an attempt has settled on.
    fn take<const N: usize>(
        &mut self,
        contact: &Contact,
        attempt: &Attempt,
        end_of_step: &StepEnd,
        series: impl Fn() -> Series<N>,
    ) -> Continued {
        if attempt.by_piece_before {
            // Fine up to the joint; on the next piece the plate oscillates.
            return ControlFlow::Break(self.handed(contact, self.progress));
        }
        self.joint = None;
        let here = self.progress;
        let sides = Sides { spring: false, damper: true };
        if let ControlFlow::Break(end) =
            contact.advance(&mut self.progress, sides, end_of_step, series)
        {
            return ControlFlow::Break(end.map_or_else(|| self.left(contact), InitialPhase::Ended));
        }
        if self.progress.t_s > here.t_s {
            self.before = here;
        }
        if self.progress.piece > here.piece {
            self.joint = Some(attempt.area);
        }
        self.step(contact)
    }

    /// Plain steps go on from where the manifold was followed to.
    fn handed(&self, contact: &Contact, progress: IntegrationState) -> InitialPhase {
        if progress.steps == 0 {
            return self.left(contact);
        }
        InitialPhase::Steps(self.manifold.plan(progress, self.tolerance, self.terms))
    }

    /// The contact starts anew, without the manifold.
    fn left(&self, contact: &Contact) -> InitialPhase {
        contact.start(self.tolerance, self.terms)
    }
}

/// A run along the manifold, its contact, and the place of its result.
#[derive(Clone, Copy)]
pub(super) struct ManifoldJob<'c> {
    pub(super) contact: &'c Contact,
    pub(super) manifold_run: ManifoldRun,
    pub(super) place: usize,
}

/// The continuation of these runs, which all have the same number of terms; not in their order.
pub(super) fn run_manifold_batch(
    jobs: &[ManifoldJob<'_>],
    report: &mut dyn FnMut(usize, InitialPhase),
) {
    dispatch(jobs, report, false);
}

impl Contact {
    /// The continuation of a single run.
    pub(super) fn end_of_manifold(&self, manifold_run: &ManifoldRun) -> InitialPhase {
        let mut initial_phase = InitialPhase::Left;
        let jobs = &[ManifoldJob { contact: self, manifold_run: *manifold_run, place: 0 }];
        dispatch(jobs, &mut |_: usize, report| initial_phase = report, true);
        initial_phase
    }
}

fn dispatch(
    jobs: &[ManifoldJob<'_>],
    report: &mut dyn FnMut(usize, InitialPhase),
    single_lane: bool,
) {
    let arch = Arch::new();
    if let Some(terms) = jobs.first().map(|job| job.manifold_run.terms) {
        by_terms!(terms, N => arch.dispatch(Batch::<N> { jobs, report, single_lane }));
    }
}

/// Runs along the slow manifold, compiled for the instructions of the machine.
struct Batch<'r, 'c, const N: usize> {
    jobs: &'r [ManifoldJob<'c>],
    report: &'r mut dyn FnMut(usize, InitialPhase),
    /// One after the other in a single lane.
    single_lane: bool,
}

impl<const N: usize> WithSimd for Batch<'_, '_, N> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        if self.single_lane || const { !has_lanes::<S>() } {
            run::<Scalar, N>(Scalar::new(), self.jobs, self.report);
        } else {
            run::<S, N>(simd, self.jobs, self.report);
        }
    }
}

struct Lane<'c> {
    job: ManifoldJob<'c>,
    attempt: Attempt,
}

/// The lanes: what they compute with, and what the pass to come takes from the last.
struct Lanes<'r, 'c, const N: usize> {
    buffer: LaneBuffer<ROWS>,
    force: LaneBuffer<N>,
    speed: LaneBuffer<N>,
    waiting: std::slice::Iter<'r, ManifoldJob<'c>>,
    report: &'r mut dyn FnMut(usize, InitialPhase),
}

impl<'c, const N: usize> Lanes<'_, 'c, N> {
    fn next(&mut self, lane: usize) -> Option<Lane<'c>> {
        loop {
            let mut job = *self.waiting.next()?;
            match job.manifold_run.step(job.contact) {
                ControlFlow::Continue(attempt) => {
                    self.buffer.put_constants(lane, FIXED, &job.contact.constants);
                    let SpringManifold { spring, damper_n_s_m, plate_kg, .. } =
                        job.manifold_run.manifold;
                    let spring = [spring.coefficient, spring.exponent, damper_n_s_m, plate_kg];
                    self.buffer.put(lane, SPRING, spring);
                    let lane_job = Lane { job, attempt };
                    self.begin(lane, &lane_job);
                    return Some(lane_job);
                }
                ControlFlow::Break(phase) => (self.report)(job.place, phase),
            }
        }
    }

    /// The first pass of an attempt: no inertia yet, and the plate's velocity as it is.
    fn begin(&mut self, lane: usize, lane_job: &Lane<'_>) {
        let IntegrationState { state, clock, .. } = lane_job.job.manifold_run.progress;
        self.buffer.put(lane, STATE, state);
        self.buffer.put(lane, UNIT, [clock.rates()[0]]);
        self.buffer.put(lane, PIECE, lane_job.attempt.area.numbers());
        self.force.put(lane, 0, [0.0; N]);
        self.speed.put(lane, 0, [0.0; N]);
        self.speed.put(lane, 0, [state[3]]);
        self.balance(lane, lane_job);
    }

    /// A pass about the balance of the attempt.
    fn balance(&mut self, lane: usize, lane_job: &Lane<'_>) {
        let Balance { plate_m, force_n } = lane_job.attempt.balance;
        let plate_scale_m =
            plate_scale_m(plate_m, Some(lane_job.job.manifold_run.manifold.reach_m));
        self.buffer.put(lane, BALANCE, [plate_m, force_n, plate_scale_m]);
    }

    /// Go on with the next attempt, or with the next job.
    fn go_on(&mut self, lane: usize, mut lane_job: Lane<'c>, next: Continued) -> Option<Lane<'c>> {
        match next {
            ControlFlow::Continue(attempt) => {
                lane_job.attempt = attempt;
                self.begin(lane, &lane_job);
                Some(lane_job)
            }
            ControlFlow::Break(phase) => {
                (self.report)(lane_job.job.place, phase);
                self.next(lane)
            }
        }
    }

    /// How far each series is trusted, and where it leads.
    #[inline(always)]
    fn look<S: Simd>(
        &mut self,
        simd: S,
        constants: &Constants<Wide<S>>,
        series: &Series<N, Wide<S>>,
        lanes: &[Option<Lane<'_>>],
    ) {
        let buffer = &mut self.buffer;
        buffer.store(SIZE, [constants.last_terms(series, buffer.wide(simd, PLATE_SCALE))]);
        for (lane, lane_job) in lanes.iter().enumerate() {
            let Some(Lane { job: ManifoldJob { manifold_run, .. }, .. }) = lane_job else {
                continue;
            };
            let trusted = trusted::<N>(buffer.0[SIZE][lane], manifold_run.tolerance);
            buffer.0[TRUSTED][lane] = manifold_run.reach_factor * trusted;
        }
        let span = buffer.wide(simd, TRUSTED);
        buffer.store(SLOPE, [series.slip_slope(span)]);
        buffer.store(END, series.state(span));
    }
}

/// All lanes, pass by pass, until no job is left.
#[inline(always)]
fn run<S: Simd, const N: usize>(
    simd: S,
    jobs: &[ManifoldJob<'_>],
    report: &mut dyn FnMut(usize, InitialPhase),
) {
    let mut all = Lanes::<N> {
        buffer: LaneBuffer::idle(),
        force: LaneBuffer::idle(),
        speed: LaneBuffer::idle(),
        waiting: jobs.iter(),
        report,
    };
    let mut lanes: [Option<Lane<'_>>; LANES_MAX] = [const { None }; LANES_MAX];
    let lanes = &mut lanes[..S::F64_LANES];
    for (lane, lane_job) in lanes.iter_mut().enumerate() {
        *lane_job = all.next(lane);
    }
    while lanes.iter().any(Option::is_some) {
        let buffer = &all.buffer;
        let [coefficient, exponent, damper_n_s_m, plate_kg] = buffer.wides(simd, SPRING);
        let spring = Spring { coefficient, exponent, damper_n_s_m, plate_kg };
        let constants = buffer.constants(simd, FIXED);
        let unit_s = buffer.wide(simd, UNIT);
        let area = Area::of(buffer.wides(simd, PIECE));
        let lag = Lag { force: all.force.wides(simd, 0), speed: all.speed.wides(simd, 0) };
        let [plate_m, held_n] = buffer.wides(simd, BALANCE);
        let about = About { plate_m, held_n, lag: &lag };
        let state = buffer.wides(simd, STATE);
        let mut series = spring.pass::<N>(&constants, state, unit_s, area, &about);
        let next = spring.lag(&series, unit_s);
        all.buffer.store(SPEEDS, [lag.speed[0], next.speed[0]]);
        all.force.store(0, next.force);
        all.speed.store(0, next.speed);
        let mut results = [PassResult::Again; LANES_MAX];
        for (lane, (lane_job, result)) in lanes.iter_mut().zip(&mut results).enumerate() {
            let Some(lane_job) = lane_job else { continue };
            let (speeds, lag_n) = (all.buffer.of(lane, SPEEDS), all.force.0[0][lane]);
            let ManifoldJob { contact, manifold_run, .. } = &lane_job.job;
            *result = manifold_run.assess(contact, &mut lane_job.attempt, speeds, lag_n);
            if *result == PassResult::Again {
                all.balance(lane, lane_job);
            }
        }
        if results.contains(&PassResult::Settled) {
            // With another speed another slip: the projectile's own velocity is what the force left of it.
            for j in 0..N {
                series.slip[j] = series.slip[j] + constants.cos * (lag.speed[j] - next.speed[j]);
            }
            series.speed = next.speed;
            all.look(simd, &constants, &series, lanes);
        }
        for (lane, place) in lanes.iter_mut().enumerate() {
            let result = results[lane];
            let Some(mut lane_job) = place.take_if(|_| result != PassResult::Again) else {
                continue;
            };
            let ManifoldJob { contact, manifold_run, .. } = &mut lane_job.job;
            let next = if result == PassResult::Failed {
                manifold_run.failed(contact, lane_job.attempt.by_piece_before)
            } else {
                let end_of_step = StepEnd {
                    trusted: all.buffer.0[TRUSTED][lane],
                    state: all.buffer.of(lane, END),
                    rises: all.buffer.0[SLOPE][lane] > 0.0,
                    speed_m_s: all.buffer.0[SPEEDS + 1][lane],
                };
                manifold_run.take(contact, &lane_job.attempt, &end_of_step, || series.lane(lane))
            };
            *place = all.go_on(lane, lane_job, next);
        }
    }
}
