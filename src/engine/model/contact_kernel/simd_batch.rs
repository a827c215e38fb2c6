//! Many contacts at once, their plain steps in parallel in the lanes of a vector.
//!
//! A lane is a contact; all lanes take a step together, each with its own length, and a lane whose contact has ended takes the
//! next. The arithmetic is that of the single contact in the same order, so that its results are the same to the last digit
//! whatever runs beside it. What is rare (an arrest, the end of a piece, a turn of the plate) is done for its lane alone, and so
//! is a contact whose spring or damper is of a kind that has no lanes here.

use std::collections::BTreeMap;

use pulp::{Arch, Simd, WithSimd};

use crate::model::contact_kernel::expansion::{Area, StepTime, trusted};
use crate::model::contact_kernel::integration::{
    InitialPhase, Plan, STEPS_MAX, Sides, StepEnd, plate_scale_m,
};
use crate::model::contact_kernel::lane_buffer::{CONSTANTS, LANES_MAX, LaneBuffer, has_lanes};
use crate::model::contact_kernel::law::{Law, Linear, Power};
use crate::model::contact_kernel::slow_manifold::{ManifoldJob, run_manifold_batch};
use crate::model::contact_kernel::{Contact, ContactEnd, is_linear};
use crate::numerics::wide::Wide;

const ROWS: usize = SIZE + 1;
const STATE: usize = 0;
const RATES: usize = 4;
const PIECE: usize = 7;
const FIXED: usize = 11;
const SPRING: usize = FIXED + CONSTANTS;
const DAMPER: usize = SPRING + 2;
const PLATE_SCALE: usize = DAMPER + 1;
/// The result of a step.
const TRUSTED: usize = PLATE_SCALE + 1;
const SLOPE: usize = TRUSTED + 1;
const SIZE: usize = SLOPE + 1;

/// Run contacts to the relative accuracy `tolerance` each, as [`Contact::run`] does; or tighter, for the plate's sake.
pub fn run_batch(
    contacts: &[Contact],
    tolerance: f64,
    minding_plate: bool,
) -> Vec<Option<ContactEnd>> {
    let mut ends = vec![None; contacts.len()];
    let mut queues: BTreeMap<Class, Vec<Job<'_>>> = BTreeMap::new();
    let mut jobs = Vec::new();
    let mut go_on = |place: usize, initial_phase| {
        let contact = &contacts[place];
        match initial_phase {
            InitialPhase::Ended(end) => ends[place] = Some(end),
            // Nothing returns to the manifold.
            InitialPhase::OnManifold(_) | InitialPhase::Left => {}
            InitialPhase::Steps(plan) => match contact.class(&plan) {
                Some(class) => queues.entry(class).or_default().push(Job { contact, plan, place }),
                None => ends[place] = contact.plan(&plan),
            },
        }
    };
    for (place, contact) in contacts.iter().enumerate() {
        let tolerance = if minding_plate { contact.minding_plate(tolerance) } else { tolerance };
        match contact.initial_phase(tolerance) {
            InitialPhase::OnManifold(manifold_run) => {
                jobs.push(ManifoldJob { contact, manifold_run, place });
            }
            initial_phase => go_on(place, initial_phase),
        }
    }
    run_manifold_batch(&jobs, &mut go_on);
    for (class, jobs) in &queues {
        by_terms!(class.terms, N => run_class::<N>(*class, jobs, &mut ends));
    }
    ends
}

/// A kind of steps that has lanes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Class {
    terms: usize,
    /// The spring is not linear.
    power: bool,
    /// The clock is graded: such a spring from a singular start on.
    graded: bool,
}

fn run_class<const N: usize>(class: Class, jobs: &[Job<'_>], ends: &mut [Option<ContactEnd>]) {
    let arch = Arch::new();
    match (class.power, class.graded) {
        (false, _) => arch.dispatch(Batch::<N, false, false> { jobs, ends }),
        (true, false) => arch.dispatch(Batch::<N, true, false> { jobs, ends }),
        (true, true) => arch.dispatch(Batch::<N, true, true> { jobs, ends }),
    }
}

/// A contact with its plan.
#[derive(Clone, Copy)]
struct Job<'c> {
    contact: &'c Contact,
    plan: Plan,
    place: usize,
}

impl Contact {
    /// Among which its plain steps are; `None` where they have no lanes.
    fn class(&self, plan: &Plan) -> Option<Class> {
        let power = !is_linear(self.spring);
        let graded = power && matches!(plan.progress.clock, StepTime::Graded { .. });
        is_linear(self.damper).then_some(Class { terms: plan.terms, power, graded })
    }
}

/// Contacts of a class, to be run by the vectors of the machine.
struct Batch<'r, 'c, const N: usize, const POWER: bool, const GRADED: bool> {
    jobs: &'r [Job<'c>],
    ends: &'r mut [Option<ContactEnd>],
}

impl<const N: usize, const POWER: bool, const GRADED: bool> WithSimd
    for Batch<'_, '_, N, POWER, GRADED>
{
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        if const { !has_lanes::<S>() } {
            for job in self.jobs {
                self.ends[job.place] = job.contact.plan(&job.plan);
            }
        } else if const { POWER } {
            let power = |rows: &LaneBuffer<ROWS>| {
                Power::new(rows.wide(simd, SPRING), rows.wide(simd, SPRING + 1))
            };
            run::<S, N, GRADED, Power<N, Wide<S>>>(simd, power, self.jobs, self.ends);
        } else {
            let linear = |rows: &LaneBuffer<ROWS>| Linear(rows.wide(simd, SPRING));
            run::<S, N, GRADED, Linear<Wide<S>>>(simd, linear, self.jobs, self.ends);
        }
    }
}

impl LaneBuffer<ROWS> {
    /// The constants of the contact.
    fn lane_job(&mut self, lane: usize, contact: &Contact) {
        self.put_constants(lane, FIXED, &contact.constants);
        self.put(lane, SPRING, [contact.spring.coefficient, contact.spring.exponent]);
        self.put(lane, DAMPER, [contact.damper.coefficient]);
    }

    /// The part that changes from step to step; `None` where the area is not a polynomial.
    fn place(&mut self, lane: usize, job: &Job<'_>) -> Option<()> {
        let Plan { progress, reach_m, .. } = &job.plan;
        let area = job.contact.area_law(progress.piece)?;
        self.put(lane, STATE, progress.state);
        self.put(lane, RATES, progress.clock.rates());
        self.put(lane, PIECE, area.numbers());
        self.put(lane, PLATE_SCALE, [plate_scale_m(progress.state[2], *reach_m)]);
        Some(())
    }
}

/// All lanes, step by step, until the jobs are done.
#[inline(always)]
fn run<S: Simd, const N: usize, const GRADED: bool, K: Law<N, Wide<S>>>(
    simd: S,
    spring: impl Fn(&LaneBuffer<ROWS>) -> K,
    jobs: &[Job<'_>],
    ends: &mut [Option<ContactEnd>],
) {
    let mut buffer = LaneBuffer::idle();
    let mut waiting = jobs.iter();
    let mut lanes: [Option<Job<'_>>; LANES_MAX] = [None; LANES_MAX];
    let lanes = &mut lanes[..S::F64_LANES];
    for (lane, lane_job) in lanes.iter_mut().enumerate() {
        *lane_job = next(&mut waiting, &mut buffer, lane);
    }
    while lanes.iter().any(Option::is_some) {
        let (spring, damper) = (spring(&buffer), Linear(buffer.wide(simd, DAMPER)));
        let state: [Wide<S>; 4] = buffer.wides(simd, STATE);
        let constants = buffer.constants(simd, FIXED);
        let rates = buffer.wides(simd, RATES);
        let area = Area::of(buffer.wides(simd, PIECE));
        let series = constants.expand::<N, GRADED>(spring, damper, state, rates, area);
        buffer.store(SIZE, [constants.last_terms(&series, buffer.wide(simd, PLATE_SCALE))]);
        for (lane, job) in lanes.iter().enumerate() {
            let tolerance = job.as_ref().map_or(1.0, |job| job.plan.tolerance);
            buffer.0[TRUSTED][lane] = trusted::<N>(buffer.0[SIZE][lane], tolerance);
        }
        let span = buffer.wide(simd, TRUSTED);
        buffer.store(SLOPE, [series.slip_slope(span)]);
        let speeds = buffer.0[STATE + 3];
        buffer.store(STATE, series.state(span));
        for (lane, lane_job) in lanes.iter_mut().enumerate() {
            let Some(job) = lane_job else { continue };
            let end_of_step = StepEnd {
                trusted: buffer.0[TRUSTED][lane],
                state: buffer.of(lane, STATE),
                rises: buffer.0[SLOPE][lane] > 0.0,
                speed_m_s: speeds[lane],
            };
            job.plan.progress.steps += 1;
            let sides = Sides { spring: K::TWO_SIDED, damper: true };
            let progress = &mut job.plan.progress;
            let stepped = job.contact.advance(progress, sides, &end_of_step, || series.lane(lane));
            let goes_on = stepped.is_continue()
                && progress.steps < STEPS_MAX
                && buffer.place(lane, job).is_some();
            if !goes_on {
                ends[job.place] = stepped.break_value().flatten();
                *lane_job = next(&mut waiting, &mut buffer, lane);
            }
        }
    }
}

/// Puts the next job on a lane.
fn next<'c>(
    waiting: &mut std::slice::Iter<'_, Job<'c>>,
    buffer: &mut LaneBuffer<ROWS>,
    lane: usize,
) -> Option<Job<'c>> {
    waiting.by_ref().find_map(|job| {
        buffer.lane_job(lane, job.contact);
        buffer.place(lane, job).map(|()| *job)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::variables::scene_with;

    /// Contacts of every class and of none, long and short ones mixed.
    fn contacts() -> Vec<Contact> {
        let springs = ["k=1e5", "k=0", "k=1e6 n=0.5", "k=1e5 n=0.2", "k=1e5 n=1.4", "k=5e6 n=0.36"];
        let others = ["", "d=0.01", "b=500", "b=100 m=2", "b=1e8", "h=0.003 v_i=400", "n=2"];
        let mut contacts = Vec::new();
        for gamma in ["0.8", "1", "5"] {
            for spring in springs {
                for other in others {
                    let scene = scene_with(&format!("{spring} {other} gamma={gamma}"));
                    contacts.push(Contact::of(&scene));
                }
            }
        }
        contacts
    }

    #[test]
    fn a_lane_is_the_single_contact_to_the_last_digit() {
        let contacts = contacts();
        for tolerance in [1e-5, 1e-8, 1e-11] {
            for minding_plate in [false, true] {
                let batch = run_batch(&contacts, tolerance, minding_plate);
                for (contact, end) in contacts.iter().zip(&batch) {
                    let single = if minding_plate {
                        contact.run(contact.minding_plate(tolerance))
                    } else {
                        contact.run(tolerance)
                    };
                    assert_eq!(*end, single, "{tolerance}: {contact:?}");
                }
                let answered = batch.iter().filter(|end| end.is_some()).count();
                assert!(answered > contacts.len() / 2, "{answered} of {}", contacts.len());
            }
        }
    }

    #[test]
    fn neither_neighbours_nor_order_change_a_digit() {
        let contacts = contacts();
        let all = run_batch(&contacts, 1e-7, true);
        let mut reversed = contacts.clone();
        reversed.reverse();
        let mut back = run_batch(&reversed, 1e-7, true);
        back.reverse();
        assert_eq!(all, back);
        for (place, some) in contacts.chunks(5).zip(all.chunks(5)) {
            assert_eq!(run_batch(place, 1e-7, true), some);
        }
    }
}
