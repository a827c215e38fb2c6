//! Rides: the ways of contacts whose plates ride on their springs, pass by pass and as many side by side as the vectors hold.
//!
//! Each lane is at a pass of its own. After a pass it takes another about the new balance, or has settled and takes a step, or fails
//! and tries a shorter one; and where even that fails it hands over to plain steps. A single contact is one lane.

use pulp::{Arch, Scalar, Simd, WithSimd};

use crate::model::contact_kernel::expansion::{Constants, Series, trusted};
use crate::model::contact_kernel::integration::{Outset, STEPS_MAX, Seen, Track, Way, minded_m};
use crate::model::contact_kernel::lane_buffer::{Bench, CONSTANTS, LANES_MAX, has_lanes};
use crate::model::contact_kernel::slow_manifold_series::{Balance, Lag, Riding, Spring, eased};
use crate::model::contact_kernel::{Contact, TERMS, TERMS_LOOSE, TERMS_TIGHT};
use crate::numerics::larger;
use crate::numerics::wide::Wide;

/// Passes at the most.
const PASSES_MAX: usize = 8;
/// Part of the tolerance by which the last two passes may differ.
const AGREE: f64 = 0.3;
/// What a pass must at least gain, after the first few.
const GAIN: f64 = 0.5;
const SETTLED: usize = 3;
/// Part of a step below which a plate that no longer rides is not asked again.
const SHORTEST: f64 = 0.1;

const STATE: usize = 0;
const UNIT: usize = 4;
const PIECE: usize = 5;
const SPRING: usize = 9;
const BALANCE: usize = 13;
const MINDED: usize = 15;
const FIXED: usize = 16;
/// What a pass shows.
const SPEEDS: usize = FIXED + CONSTANTS;
const TRUSTED: usize = SPEEDS + 2;
const SIZE: usize = TRUSTED + 1;
const SLOPE: usize = SIZE + 1;
const END: usize = SLOPE + 1;
const ROWS: usize = END + 4;

/// A contact on a riding plate.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ride {
    riding: Riding,
    tolerance: f64,
    track: Track,
    /// From where to go on another way: a step earlier than where this one was seen to fail.
    before: Track,
    /// The area law of the piece that the last step ended with.
    joint: Option<(f64, [f64; 3])>,
    /// How far steps are trusted after failures.
    leash: f64,
    /// Of the expansion.
    terms: usize,
}

/// An expansion about where the track is.
#[derive(Clone, Copy, Debug)]
struct Attempt {
    law: (f64, [f64; 3]),
    /// Only asked with the law of the piece before: is it the next one that sets the plate swinging?
    asked_back: bool,
    /// Passes done.
    passes: usize,
    balance: Balance,
    /// How far that is from the one before, relative.
    moved: f64,
    /// By how much the pass before changed the plate's way, relative.
    change: f64,
}

/// What a pass led to.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Verdict {
    Again,
    Settled,
    Failed,
}

impl Ride {
    pub(super) fn from(riding: Riding, start: Track, (tolerance, terms): (f64, usize)) -> Self {
        Self { riding, tolerance, track: start, before: start, joint: None, leash: 1.0, terms }
    }

    /// A new step.
    fn step(&mut self, contact: &Contact) -> Result<Attempt, Way> {
        if self.track.steps >= STEPS_MAX {
            return Err(Way::Left);
        }
        let law = contact.area_law(self.track.piece).ok_or(Way::Left)?;
        self.track.steps += 1;
        self.attempt(contact, law, false)
    }

    fn attempt(
        &mut self,
        contact: &Contact,
        law: (f64, [f64; 3]),
        asked_back: bool,
    ) -> Result<Attempt, Way> {
        let Track { state, .. } = self.track;
        let from = self.riding.at(state[2]);
        let found = self.riding.balance(&contact.constants, state, law, (from, 0.0, state[3]));
        let change = f64::INFINITY;
        match found {
            Some(balance) => {
                let moved = (balance.plate_m - state[2]).abs() / balance.plate_m;
                Ok(Attempt { law, asked_back, passes: 0, balance, moved, change })
            }
            None => self.failed(contact, asked_back),
        }
    }

    /// What to try where an attempt has failed.
    fn failed(&mut self, contact: &Contact, asked_back: bool) -> Result<Attempt, Way> {
        if let (Some(law), false) = (self.joint, asked_back) {
            return self.attempt(contact, law, true);
        }
        if self.track.piece != self.before.piece || self.leash < SHORTEST {
            return Err(Way::Handed(self.before));
        }
        // The step there may have been too long, and so may be those to come.
        self.leash *= 0.5;
        self.track = Track { steps: self.track.steps, ..self.before };
        self.step(contact)
    }

    /// What a pass means that gave these plate velocities, the one it was made with first; finds the next balance.
    fn judge(
        &self,
        contact: &Contact,
        attempt: &mut Attempt,
        ([old_m_s, new_m_s], lag_n): ([f64; 2], f64),
    ) -> Verdict {
        let Track { state, clock, .. } = self.track;
        let tolerance = self.tolerance * eased(state[2], self.riding.reach_m);
        let x = attempt.balance.plate_m;
        let change = larger(attempt.moved, (old_m_s - new_m_s).abs() * clock.rates()[0] / x);
        // The first has no inertia yet, and agrees with a step before that had none.
        if attempt.passes > 0 && change <= AGREE * tolerance {
            let keeps = self.riding.keeps_to((attempt.balance, new_m_s), state, tolerance);
            return if keeps { Verdict::Settled } else { Verdict::Failed };
        }
        if attempt.passes >= SETTLED && change > GAIN * attempt.change {
            return Verdict::Failed;
        }
        let from = (attempt.balance, lag_n, new_m_s);
        let next = self.riding.balance(&contact.constants, state, attempt.law, from);
        let Some(balance) = next.filter(|_| attempt.passes + 1 < PASSES_MAX) else {
            return Verdict::Failed;
        };
        let moved = (balance.plate_m - x).abs() / balance.plate_m;
        let passes = attempt.passes + 1;
        *attempt = Attempt { passes, balance, moved, change, ..*attempt };
        Verdict::Again
    }

    /// Take the step that an attempt has settled on.
    fn take<const N: usize>(
        &mut self,
        contact: &Contact,
        attempt: &Attempt,
        (seen, series): (Seen, impl Fn() -> Series<N>),
    ) -> Result<Attempt, Way> {
        if attempt.asked_back {
            // Fine up to the joint; the next piece sets the plate swinging.
            return Err(Way::Handed(self.track));
        }
        self.joint = None;
        let here = self.track;
        if let Some(way) = contact.stride(&mut self.track, (false, true), &seen, series) {
            return Err(way);
        }
        if self.track.t_s > here.t_s {
            self.before = here;
        }
        if self.track.piece > here.piece {
            self.joint = Some(attempt.law);
        }
        self.step(contact)
    }

    /// What comes after the ride.
    fn end(&self, contact: &Contact, way: Way) -> Outset {
        match way {
            Way::Ended(end) => Outset::Ended(end),
            Way::Handed(track) if track.steps > 0 => {
                Outset::Steps(self.riding.walk(track, (self.tolerance, self.terms)))
            }
            Way::Handed(_) | Way::Left => contact.start(self.tolerance, self.terms),
        }
    }
}

/// A ride, whose it is, and where its end belongs.
#[derive(Clone, Copy)]
pub(super) struct Rider<'c> {
    pub(super) contact: &'c Contact,
    pub(super) ride: Ride,
    pub(super) place: usize,
}

/// What comes after these rides, which all have the same number of terms; not in their order.
pub(super) fn ride_abreast(riders: &[Rider<'_>], led: &mut dyn FnMut(usize, Outset)) {
    let arch = Arch::new();
    match riders.first().map(|rider| rider.ride.terms) {
        Some(TERMS_LOOSE) => arch.dispatch(Abreast::<TERMS_LOOSE> { riders, led }),
        Some(TERMS) => arch.dispatch(Abreast::<TERMS> { riders, led }),
        Some(_) => arch.dispatch(Abreast::<TERMS_TIGHT> { riders, led }),
        None => {}
    }
}

impl Contact {
    /// What comes after a single ride.
    pub(super) fn ridden(&self, ride: &Ride) -> Outset {
        let mut outset = Outset::Left;
        let riders = &[Rider { contact: self, ride: *ride, place: 0 }];
        let led = &mut |_: usize, led| outset = led;
        let arch = Arch::new();
        match ride.terms {
            TERMS_LOOSE => arch.dispatch(Alone::<TERMS_LOOSE> { riders, led }),
            TERMS => arch.dispatch(Alone::<TERMS> { riders, led }),
            _ => arch.dispatch(Alone::<TERMS_TIGHT> { riders, led }),
        }
        outset
    }
}

/// Rides side by side.
struct Abreast<'r, 'c, const N: usize> {
    riders: &'r [Rider<'c>],
    led: &'r mut dyn FnMut(usize, Outset),
}

impl<const N: usize> WithSimd for Abreast<'_, '_, N> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        if const { !has_lanes::<S>() } {
            for Rider { contact, ride, place } in self.riders {
                (self.led)(*place, contact.ridden(ride));
            }
        } else {
            run::<S, N>(simd, self.riders, self.led);
        }
    }
}

/// A ride in a single lane, compiled for the instructions of the machine.
struct Alone<'r, 'c, const N: usize> {
    riders: &'r [Rider<'c>],
    led: &'r mut dyn FnMut(usize, Outset),
}

impl<const N: usize> WithSimd for Alone<'_, '_, N> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _simd: S) {
        run::<Scalar, N>(Scalar::new(), self.riders, self.led);
    }
}

/// A contact in its lane.
struct Seat<'c> {
    rider: Rider<'c>,
    attempt: Attempt,
}

/// The lanes: what they compute with, and what the pass to come takes from the last.
struct Lanes<'r, 'c, const N: usize> {
    bench: Bench<ROWS>,
    force: Bench<N>,
    speed: Bench<N>,
    waiting: std::slice::Iter<'r, Rider<'c>>,
    led: &'r mut dyn FnMut(usize, Outset),
}

impl<'c, const N: usize> Lanes<'_, 'c, N> {
    /// Seat the next rider there is.
    fn next(&mut self, lane: usize) -> Option<Seat<'c>> {
        loop {
            let mut rider = *self.waiting.next()?;
            match rider.ride.step(rider.contact) {
                Ok(attempt) => {
                    self.bench.put_constants(lane, FIXED, &rider.contact.constants);
                    let Riding { spring, damper_n_s_m, plate_kg, .. } = rider.ride.riding;
                    let spring = [spring.coefficient, spring.exponent, damper_n_s_m, plate_kg];
                    self.bench.put(lane, SPRING, spring);
                    let seat = Seat { rider, attempt };
                    self.begin(lane, &seat);
                    return Some(seat);
                }
                Err(way) => (self.led)(rider.place, rider.ride.end(rider.contact, way)),
            }
        }
    }

    /// The first pass of an attempt: no inertia yet, and the plate's velocity as it is.
    fn begin(&mut self, lane: usize, seat: &Seat<'_>) {
        let Track { state, clock, .. } = seat.rider.ride.track;
        let (origin_m, [a0, a1, a2]) = seat.attempt.law;
        self.bench.put(lane, STATE, state);
        self.bench.put(lane, UNIT, [clock.rates()[0]]);
        self.bench.put(lane, PIECE, [origin_m, a0, a1, a2]);
        self.force.put(lane, 0, [0.0; N]);
        self.speed.put(lane, 0, [0.0; N]);
        self.speed.put(lane, 0, [state[3]]);
        self.balance(lane, seat);
    }

    /// A pass about the balance of the attempt.
    fn balance(&mut self, lane: usize, seat: &Seat<'_>) {
        let Balance { plate_m, force_n } = seat.attempt.balance;
        let minded_m = minded_m(plate_m, Some(seat.rider.ride.riding.reach_m));
        self.bench.put(lane, BALANCE, [plate_m, force_n, minded_m]);
    }

    /// Go on with the next attempt, or with the next rider.
    fn go_on(
        &mut self,
        lane: usize,
        mut seat: Seat<'c>,
        next: Result<Attempt, Way>,
    ) -> Option<Seat<'c>> {
        match next {
            Ok(attempt) => {
                seat.attempt = attempt;
                self.begin(lane, &seat);
                Some(seat)
            }
            Err(way) => {
                let Rider { contact, ride, place } = seat.rider;
                (self.led)(place, ride.end(contact, way));
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
        seats: &[Option<Seat<'_>>],
    ) {
        let bench = &mut self.bench;
        bench.store(SIZE, [constants.last_terms(series, bench.wide(simd, MINDED))]);
        for (lane, seat) in seats.iter().enumerate() {
            let Some(Seat { rider: Rider { ride, .. }, .. }) = seat else { continue };
            let trusted = trusted::<N>(bench.0[SIZE][lane], ride.tolerance);
            bench.0[TRUSTED][lane] = ride.leash * trusted;
        }
        let span = bench.wide(simd, TRUSTED);
        bench.store(SLOPE, [series.slip_slope(span)]);
        bench.store(END, series.state(span));
    }
}

/// All lanes, pass by pass, until the rides are over.
#[inline(always)]
fn run<S: Simd, const N: usize>(simd: S, riders: &[Rider<'_>], led: &mut dyn FnMut(usize, Outset)) {
    let mut all = Lanes::<N> {
        bench: Bench::idle(),
        force: Bench::idle(),
        speed: Bench::idle(),
        waiting: riders.iter(),
        led,
    };
    let mut seats: [Option<Seat<'_>>; LANES_MAX] = [const { None }; LANES_MAX];
    let seats = &mut seats[..S::F64_LANES];
    for (lane, seat) in seats.iter_mut().enumerate() {
        *seat = all.next(lane);
    }
    while seats.iter().any(Option::is_some) {
        let bench = &all.bench;
        let [coefficient, exponent, damper_n_s_m, plate_kg] = bench.wides(simd, SPRING);
        let spring = Spring { coefficient, exponent, damper_n_s_m, plate_kg };
        let constants = bench.constants(simd, FIXED);
        let unit_s = bench.wide(simd, UNIT);
        let [origin_m, a0, a1, a2] = bench.wides(simd, PIECE);
        let scale = (unit_s, (origin_m, [a0, a1, a2]));
        let lag = Lag { force: all.force.wides(simd, 0), speed: all.speed.wides(simd, 0) };
        let from = (bench.wides(simd, BALANCE), &lag);
        let mut series = spring.pass::<N>(&constants, bench.wides(simd, STATE), scale, from);
        let next = spring.lag(&series, unit_s);
        all.bench.store(SPEEDS, [lag.speed[0], next.speed[0]]);
        all.force.store(0, next.force);
        all.speed.store(0, next.speed);
        let mut verdicts = [Verdict::Again; LANES_MAX];
        for (lane, (seat, verdict)) in seats.iter_mut().zip(&mut verdicts).enumerate() {
            let Some(seat) = seat else { continue };
            let speeds = (all.bench.of(lane, SPEEDS), all.force.0[0][lane]);
            let Rider { contact, ride, .. } = &seat.rider;
            *verdict = ride.judge(contact, &mut seat.attempt, speeds);
            if *verdict == Verdict::Again {
                all.balance(lane, seat);
            }
        }
        if verdicts.contains(&Verdict::Settled) {
            // With another speed another slip: the projectile's own velocity is what the force left of it.
            for j in 0..N {
                series.slip[j] = series.slip[j] + constants.cos * (lag.speed[j] - next.speed[j]);
            }
            series.speed = next.speed;
            all.look(simd, &constants, &series, seats);
        }
        for (lane, place) in seats.iter_mut().enumerate() {
            let verdict = verdicts[lane];
            let Some(mut seat) = place.take_if(|_| verdict != Verdict::Again) else { continue };
            let Rider { contact, ride, .. } = &mut seat.rider;
            let next = if verdict == Verdict::Failed {
                ride.failed(contact, seat.attempt.asked_back)
            } else {
                let seen = Seen {
                    trusted: all.bench.0[TRUSTED][lane],
                    state: all.bench.of(lane, END),
                    rises: all.bench.0[SLOPE][lane] > 0.0,
                    speed_m_s: all.bench.0[SPEEDS + 1][lane],
                };
                ride.take(contact, &seat.attempt, (seen, || series.lane(lane)))
            };
            *place = all.go_on(lane, seat, next);
        }
    }
}
