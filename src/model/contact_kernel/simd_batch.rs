//! Many contacts at once, their plain steps side by side in the lanes of a vector.
//!
//! A lane is a contact; all lanes take a step together, each with its own length, and a lane whose contact has ended takes the
//! next. The arithmetic is that of the single contact in the same order, so that its results are the same to the last digit
//! whatever runs beside it. What is rare (an arrest, the end of a piece, a turn of the plate) is done for its lane alone, and so is
//! a contact whose spring or damper is of a kind that has no lanes here.

use pulp::{Arch, Simd, WithSimd};

use crate::model::contact_kernel::expansion::{Clock, trusted};
use crate::model::contact_kernel::integration::{Outset, STEPS_MAX, Seen, Walk, Way, minded_m};
use crate::model::contact_kernel::lane_buffer::{Bench, CONSTANTS, LANES_MAX, has_lanes};
use crate::model::contact_kernel::law::{Law, Linear, Power};
use crate::model::contact_kernel::slow_manifold::{Rider, ride_abreast};
use crate::model::contact_kernel::{
    Contact, ContactEnd, SPRING_POWERS, TERMS, TERMS_LOOSE, TERMS_TIGHT, is_linear, is_singular,
};
use crate::model::mechanism::PowerKind;
use crate::numerics::wide::Wide;

const ROWS: usize = 24;
const STATE: usize = 0;
const RATES: usize = 4;
const PIECE: usize = 7;
const FIXED: usize = 11;
const SPRING: usize = FIXED + CONSTANTS;
const DAMPER: usize = 19;
const MINDED: usize = 20;
/// What a step shows.
const TRUSTED: usize = 21;
const SLOPE: usize = 22;
const SIZE: usize = 23;

/// Run contacts to the relative accuracy `tolerance` each, as [`Contact::run`] or [`Contact::run_minding_plate`] does.
pub fn run_abreast(
    contacts: &[Contact],
    tolerance: f64,
    minding_plate: bool,
) -> Vec<Option<ContactEnd>> {
    let mut ends = vec![None; contacts.len()];
    let mut queues: [Vec<Job<'_>>; CLASSES] = Default::default();
    let mut riders = Vec::new();
    let mut go_on = |place: usize, outset| {
        let contact = &contacts[place];
        match outset {
            Outset::Ended(end) => ends[place] = Some(end),
            // Nothing rides again.
            Outset::Rides(_) | Outset::Left => {}
            Outset::Steps(walk) => match contact.class(&walk) {
                Some(class) => queues[class].push(Job { contact, walk, place }),
                None => ends[place] = contact.walk(&walk),
            },
        }
    };
    for (place, contact) in contacts.iter().enumerate() {
        let tolerance = if minding_plate { contact.minding_plate(tolerance) } else { tolerance };
        match contact.outset(tolerance) {
            Outset::Rides(ride) => riders.push(Rider { contact, ride, place }),
            outset => go_on(place, outset),
        }
    }
    ride_abreast(&riders, &mut go_on);
    let arch = Arch::new();
    for (class, jobs) in queues.iter().enumerate().filter(|(_, jobs)| !jobs.is_empty()) {
        let ends = &mut ends[..];
        match class {
            0 => arch.dispatch(Abreast::<TERMS_LOOSE, false, false> { jobs, ends }),
            1 => arch.dispatch(Abreast::<TERMS_LOOSE, true, false> { jobs, ends }),
            2 => arch.dispatch(Abreast::<TERMS_LOOSE, true, true> { jobs, ends }),
            3 => arch.dispatch(Abreast::<TERMS, false, false> { jobs, ends }),
            4 => arch.dispatch(Abreast::<TERMS, true, false> { jobs, ends }),
            5 => arch.dispatch(Abreast::<TERMS, true, true> { jobs, ends }),
            6 => arch.dispatch(Abreast::<TERMS_TIGHT, false, false> { jobs, ends }),
            7 => arch.dispatch(Abreast::<TERMS_TIGHT, true, false> { jobs, ends }),
            _ => arch.dispatch(Abreast::<TERMS_TIGHT, true, true> { jobs, ends }),
        }
    }
    ends
}

/// Kinds of steps that have lanes: terms of the expansion, then spring and clock.
const CLASSES: usize = 9;

/// A contact on its way.
#[derive(Clone, Copy)]
struct Job<'c> {
    contact: &'c Contact,
    walk: Walk,
    place: usize,
}

impl Contact {
    /// Among which its plain steps are; `None` where they have no lanes.
    fn class(&self, walk: &Walk) -> Option<usize> {
        if !is_linear(self.damper) {
            return None;
        }
        let spring = if is_singular(self.spring, SPRING_POWERS) {
            1 + usize::from(matches!(walk.track.clock, Clock::Graded { .. }))
        } else if matches!(self.spring.kind(), PowerKind::Whole(_)) {
            return None;
        } else {
            0
        };
        let terms = match walk.terms {
            TERMS_LOOSE => 0,
            TERMS => 1,
            _ => 2,
        };
        Some(3 * terms + spring)
    }
}

/// Contacts of a class, to be run by the vectors of the machine.
struct Abreast<'r, 'c, const N: usize, const POWER: bool, const GRADED: bool> {
    jobs: &'r [Job<'c>],
    ends: &'r mut [Option<ContactEnd>],
}

impl<const N: usize, const POWER: bool, const GRADED: bool> WithSimd
    for Abreast<'_, '_, N, POWER, GRADED>
{
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        if const { !has_lanes::<S>() } {
            for job in self.jobs {
                self.ends[job.place] = job.contact.walk(&job.walk);
            }
        } else if const { POWER } {
            let power = |rows: &Bench<ROWS>| {
                Power::new(rows.wide(simd, SPRING), rows.wide(simd, SPRING + 1))
            };
            run::<S, N, GRADED, Power<N, Wide<S>>>(simd, power, self.jobs, self.ends);
        } else {
            let linear = |rows: &Bench<ROWS>| Linear(rows.wide(simd, SPRING));
            run::<S, N, GRADED, Linear<Wide<S>>>(simd, linear, self.jobs, self.ends);
        }
    }
}

impl Bench<ROWS> {
    /// What does not change along the way.
    fn seat(&mut self, lane: usize, contact: &Contact) {
        self.put_constants(lane, FIXED, &contact.constants);
        self.put(lane, SPRING, [contact.spring.coefficient, contact.spring.exponent]);
        self.put(lane, DAMPER, [contact.damper.coefficient]);
    }

    /// What changes from step to step; `None` where the area is no polynomial.
    fn place(&mut self, lane: usize, job: &Job<'_>) -> Option<()> {
        let Walk { track, reach_m, .. } = &job.walk;
        let (origin_m, [a0, a1, a2]) = job.contact.area_law(track.piece)?;
        self.put(lane, STATE, track.state);
        self.put(lane, RATES, track.clock.rates());
        self.put(lane, PIECE, [origin_m, a0, a1, a2]);
        self.put(lane, MINDED, [minded_m(track.state[2], *reach_m)]);
        Some(())
    }
}

/// All lanes, step by step, until the jobs are done.
#[inline(always)]
fn run<S: Simd, const N: usize, const GRADED: bool, K: Law<N, Wide<S>>>(
    simd: S,
    spring: impl Fn(&Bench<ROWS>) -> K,
    jobs: &[Job<'_>],
    ends: &mut [Option<ContactEnd>],
) {
    let mut bench = Bench::idle();
    let mut waiting = jobs.iter();
    let mut lanes: [Option<Job<'_>>; LANES_MAX] = [None; LANES_MAX];
    let lanes = &mut lanes[..S::F64_LANES];
    for (lane, seat) in lanes.iter_mut().enumerate() {
        *seat = next(&mut waiting, &mut bench, lane);
    }
    while lanes.iter().any(Option::is_some) {
        let [origin_m, a0, a1, a2] = bench.wides(simd, PIECE);
        let laws = (spring(&bench), Linear(bench.wide(simd, DAMPER)));
        let state: [Wide<S>; 4] = bench.wides(simd, STATE);
        let constants = bench.constants(simd, FIXED);
        let area = (origin_m, [a0, a1, a2]);
        let series = constants.expand::<N, GRADED>(laws, state, bench.wides(simd, RATES), area);
        bench.store(SIZE, [constants.last_terms(&series, bench.wide(simd, MINDED))]);
        for (lane, job) in lanes.iter().enumerate() {
            let tolerance = job.as_ref().map_or(1.0, |job| job.walk.tolerance);
            bench.0[TRUSTED][lane] = trusted::<N>(bench.0[SIZE][lane], tolerance);
        }
        let span = bench.wide(simd, TRUSTED);
        bench.store(SLOPE, [series.slip_slope(span)]);
        let speeds = bench.0[STATE + 3];
        bench.store(STATE, series.state(span));
        for (lane, seat) in lanes.iter_mut().enumerate() {
            let Some(job) = seat else { continue };
            let seen = Seen {
                trusted: bench.0[TRUSTED][lane],
                state: bench.of(lane, STATE),
                rises: bench.0[SLOPE][lane] > 0.0,
                speed_m_s: speeds[lane],
            };
            job.walk.track.steps += 1;
            let sides = (K::TWO_SIDED, true);
            let track = &mut job.walk.track;
            let way = job.contact.stride(track, sides, &seen, || series.lane(lane));
            let goes_on =
                way.is_none() && track.steps < STEPS_MAX && bench.place(lane, job).is_some();
            if !goes_on {
                ends[job.place] = way.and_then(Way::ended);
                *seat = next(&mut waiting, &mut bench, lane);
            }
        }
    }
}

/// Seat the next job on a lane.
fn next<'c>(
    waiting: &mut std::slice::Iter<'_, Job<'c>>,
    bench: &mut Bench<ROWS>,
    lane: usize,
) -> Option<Job<'c>> {
    waiting.by_ref().find_map(|job| {
        bench.seat(lane, job.contact);
        bench.place(lane, job).map(|()| *job)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::scene::Scene;
    use crate::model::units::Bare;
    use crate::model::variables::set_by_name;

    /// Contacts of every class and of none, long and short ones mixed.
    fn contacts() -> Vec<Contact> {
        let springs = ["k=1e5", "k=0", "k=1e6 n=0.5", "k=1e5 n=0.2", "k=1e5 n=1.4", "k=5e6 n=0.36"];
        let others =
            ["", "d=0.01", "b=500", "b=100 m=2", "b=1e8", "h=0.003 v_i=400", "n=2", "m_p=0"];
        let mut contacts = Vec::new();
        for gamma in ["0.8", "1", "5"] {
            for spring in springs {
                for other in others {
                    let mut scene = Scene::default();
                    for pair in spring.split(' ').chain(other.split_whitespace()) {
                        let (name, value) = pair.split_once('=').unwrap();
                        // A projectile without mass is refused and leaves the one there is.
                        let _refused = set_by_name(&mut scene, name, value, Bare::Si);
                    }
                    set_by_name(&mut scene, "gamma", gamma, Bare::Si).unwrap();
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
                let abreast = run_abreast(&contacts, tolerance, minding_plate);
                for (contact, end) in contacts.iter().zip(&abreast) {
                    let single = if minding_plate {
                        contact.run_minding_plate(tolerance)
                    } else {
                        contact.run(tolerance)
                    };
                    assert_eq!(*end, single, "{tolerance}: {contact:?}");
                }
                let answered = abreast.iter().filter(|end| end.is_some()).count();
                assert!(answered > contacts.len() / 2, "{answered} of {}", contacts.len());
            }
        }
    }

    #[test]
    fn neither_neighbours_nor_order_change_a_digit() {
        let contacts = contacts();
        let all = run_abreast(&contacts, 1e-7, true);
        let mut reversed = contacts.clone();
        reversed.reverse();
        let mut back = run_abreast(&reversed, 1e-7, true);
        back.reverse();
        assert_eq!(all, back);
        for (place, some) in contacts.chunks(5).zip(all.chunks(5)) {
            assert_eq!(run_abreast(place, 1e-7, true), some);
        }
    }
}
