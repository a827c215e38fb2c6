//! A plate that rides on its spring: with an exponent below 1/3 the spring is so stiff near its zero that from first contact on
//! the plate is where spring and contact force balance, and swings about that place too fast to matter.
//!
//! There k x^n = F cos - m x'' - b x' is solved for x term by term, first without inertia; each further pass takes x'' and x' from
//! the one before (Hairer and Wanner, *Solving Ordinary Differential Equations II*, section VI.3: the slow manifold of a
//! singular perturbation). A pass gains as much as the plate swings fast against the motion; where two passes no longer
//! agree, the contact goes on by plain steps from there.

use crate::model::closed_form::Passage;
use crate::model::impact::lean::expansion::{Clock, Constants, Series};
use crate::model::impact::lean::law::{Law as _, Power, product_before, square_before};
use crate::model::impact::lean::way::{Outset, Track, Walk, Way};
use crate::model::impact::lean::{Contact, free};
use crate::model::mechanism::{PowerKind, PowerLaw};
use crate::numerics::{larger, smaller};

/// Passes at the most.
const PASSES_MAX: usize = 8;
/// Newton steps for the place of balance.
const NEWTON_MAX: usize = 30;
/// Its last step at the most, relative.
const NEWTON_LAST: f64 = 1e-8;
/// Part of the tolerance by which the last two passes may differ.
const AGREE: f64 = 0.3;
/// Radians by which a plate could have swung from first contact to its start, at least.
const SWINGS_MIN: f64 = 60.0;
/// See [`eased`].
const EASED_MOST: f64 = 1e3;
/// What a pass must at least gain, after the first few.
const GAIN: f64 = 0.5;
const SETTLED: usize = 3;
/// Tolerances by which a step may miss the next one's start: a plate that swings by more no longer rides.
const SWING: f64 = 1.0;
/// Part of the tolerance of what the plate has moved at the start, against its way in the contact.
const START: f64 = 0.01;

/// The spring that is ridden on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Riding {
    /// k and n.
    pub(super) spring: PowerLaw,
    /// b of a linear damper, N s/m.
    pub(super) damper_n_s_m: f64,
    /// Plate mass, kg.
    pub(super) plate_kg: f64,
    /// How far the plate comes at least, m: what is small against it need not be known as well.
    pub(super) reach_m: f64,
}
/// What a coefficient adds to another of the same order.
#[derive(Clone, Copy, Default)]
struct Per {
    /// Pressure by the slip's.
    slip_pressure: f64,
    /// Contact force by the slip's.
    slip_force: f64,
    /// Area lost by the plate's.
    plate_area: f64,
    /// Contact force lost by the plate's.
    plate_force: f64,
    /// The plate's by a force on it.
    force_plate: f64,
}

/// Exponent below which a plate rides on its spring from the start.
pub(super) const RIDES_BELOW: f64 = 1.0 / 3.0;
/// By how much earlier than need be a riding plate is started at most, so that it rides at first.
const EARLIEST: f64 = 1e-3;
/// Part of the tolerance for each of the many steps of a plate that swings fast.
const SWINGING: f64 = 0.2;

/// By how much less well the place of a plate need be known at `plate_m` that comes to `reach_m` at least. Its swings about the
/// balance fade more slowly than its way grows, and a step must not lose the plate.
pub(super) fn eased(plate_m: f64, reach_m: f64) -> f64 {
    smaller(larger(reach_m / plate_m, 1.0).sqrt(), EASED_MOST)
}

impl Riding {
    /// Up to which part of the contact's length the plate need not be looked at: its way grows with power 1/n of the force.
    pub(super) fn starts_at(&self, tolerance: f64) -> f64 {
        (START * tolerance).powf(self.spring.exponent)
    }

    /// By how much earlier than at this time and place it has to start for its swings to be fast enough: their number up to a
    /// time falls with the power (3 n - 1)/(2 n) of it.
    pub(super) fn earlier(&self, t_s: f64, place_m: f64) -> f64 {
        let n = self.spring.exponent;
        let tangent = n * self.spring.force(place_m) / place_m;
        let swings = (tangent / self.plate_kg).sqrt() * t_s;
        (swings / SWINGS_MIN).powf(2.0 * n / (1.0 - 3.0 * n))
    }

    /// Expand from `state` = (travel, slip, plate, speed); `None` where the plate no longer rides to within the tolerance,
    /// relative to its way.
    pub(super) fn expand<const N: usize>(
        &self,
        constants: &Constants,
        state: [f64; 4],
        unit_s: f64,
        (piece, tolerance): ((f64, [f64; 3]), f64),
    ) -> Option<Series<N>> {
        let (mut lag, mut speed) = ([0.0; N], [0.0; N]);
        speed[0] = state[3];
        let mut plate_m = state[2];
        let mut before = f64::INFINITY;
        for pass in 0..PASSES_MAX {
            let mut series =
                self.pass(constants, state, (unit_s, piece), (plate_m, &lag, &speed))?;
            for (j, (speed, next)) in speed.iter_mut().zip(&series.plate[1..]).enumerate() {
                *speed = (j + 1) as f64 * next / unit_s;
            }
            for (j, (lag, pair)) in lag.iter_mut().zip(speed[..N - 1].windows(2)).enumerate() {
                let inertia = self.plate_kg * (j + 1) as f64 * pair[1] / unit_s;
                *lag = inertia + self.damper_n_s_m * pair[0];
            }
            let moved = (series.plate[0] - plate_m).abs() / series.plate[0];
            let faster = (series.speed[0] - speed[0]).abs() * unit_s / series.plate[0];
            plate_m = series.plate[0];
            // With another speed another slip: the projectile's own velocity is what the force left of it.
            for (slip, (old, new)) in series.slip.iter_mut().zip(series.speed.iter().zip(&speed)) {
                *slip += constants.cos * (old - new);
            }
            series.speed = speed;
            let change = larger(moved, faster);
            // The first has no inertia yet, and agrees with a step before that had none.
            if pass > 0 && change <= AGREE * tolerance {
                return self.keeps_to(&series, state, tolerance).then_some(series);
            }
            if pass >= SETTLED && change > GAIN * before {
                break;
            }
            before = change;
        }
        None
    }

    /// Whether the plate comes in on the slow motion: not at all if it is yet to start.
    fn keeps_to<const N: usize>(&self, s: &Series<N>, state: [f64; 4], tolerance: f64) -> bool {
        let (x, dx, dw) = (s.plate[0], s.plate[0] - state[2], s.speed[0] - state[3]);
        let tangent = self.spring.exponent * self.spring.force(x) / x;
        let swing = dx * dx + dw * dw * self.plate_kg / tangent;
        state[3] == 0.0 || swing.sqrt() <= SWING * tolerance * x
    }

    /// One pass, with m w' + b w and w given.
    fn pass<const N: usize>(
        &self,
        constants: &Constants,
        state: [f64; 4],
        (unit_s, (origin_m, a)): (f64, (f64, [f64; 3])),
        (plate_m, lag, speed): (f64, &[f64; N], &[f64; N]),
    ) -> Option<Series<N>> {
        let Constants { strength_pa, drag_kg_m3, slip_mobility, plate_mobility, cos, .. } =
            *constants;
        let slowing = slip_mobility - cos * cos * plate_mobility;
        let zero = [0.0; N];
        let mut s = Series { travel: zero, slip: zero, plate: zero, speed: *speed };
        let mut offset = zero;
        let (area, pressure) = (&mut [0.0; N], &mut [0.0; N]);
        // The projectile's own travel and velocity, as far as they are known.
        let next = &mut [zero, zero];
        (next[0][0], next[1][0]) = (state[0] + cos * state[2], state[1] + cos * state[3]);
        let mut spring = Power::<N>::of(self.spring);
        let per = &mut Per::default();
        macro_rules! order {
            ($($j:literal)*) => { $( if $j < N {
                const J: usize = $j;
                s.slip[J] = next[1][J] - cos * speed[J];
                let force;
                if J == 0 {
                    pressure[0] = strength_pa + drag_kg_m3 * s.slip[0] * s.slip[0];
                    let area_at = |x: f64| {
                        let q = next[0][0] - cos * x - origin_m;
                        (a[0] + q * (a[1] + a[2] * q), a[1] + 2.0 * a[2] * q)
                    };
                    let pushes = |x: f64| cos * area_at(x).0 * pressure[0] - lag[0];
                    let x = self.balance(plate_m, |x| {
                        (pushes(x), -cos * cos * area_at(x).1 * pressure[0])
                    })?;
                    s.plate[0] = x;
                    offset[0] = next[0][0] - cos * x - origin_m;
                    let (there, slope) = area_at(x);
                    area[0] = there;
                    force = area[0] * pressure[0];
                    let by_plate = spring.term::<0>(&s.plate) * self.spring.exponent / x;
                    let by_slip = 2.0 * drag_kg_m3 * s.slip[0];
                    *per = Per {
                        slip_pressure: by_slip,
                        slip_force: area[0] * by_slip,
                        plate_area: cos * slope,
                        plate_force: cos * slope * pressure[0],
                        force_plate: 1.0 / (by_plate + cos * cos * slope * pressure[0]),
                    };
                } else {
                    // All but the parts of the slip's and the plate's coefficients J: what does not wait for them, ...
                    let moved = next[0][J];
                    let bent = square_before::<N, J, f64>(&offset) + 2.0 * offset[0] * moved;
                    area[J] = a[1] * moved + a[2] * bent;
                    let older = drag_kg_m3 * square_before::<N, J, f64>(&s.slip);
                    let known = product_before::<N, J, f64>(area, pressure)
                        + (area[J] * pressure[0] + area[0] * older);
                    let held = spring.term::<J>(&s.plate);
                    let pushed = (cos * known - lag[J] - held) * per.force_plate;
                    // ... and those parts, linear in them.
                    let x = pushed + cos * per.slip_force * per.force_plate * s.slip[J];
                    force = (known + per.slip_force * s.slip[J]) - per.plate_force * x;
                    s.plate[J] = x;
                    spring.add::<J>(x);
                    offset[J] = moved - cos * x;
                    area[J] -= per.plate_area * x;
                    pressure[J] = older + per.slip_pressure * s.slip[J];
                }
                s.travel[J] = offset[J] + if J == 0 { origin_m } else { 0.0 };
                if J + 1 < N {
                    let h = unit_s / (J + 1) as f64;
                    next[0][J + 1] = h * next[1][J];
                    next[1][J + 1] = -h * slowing * force;
                }
            } )* };
        }
        order!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19);
        Some(s)
    }

    /// Where the spring holds a force and slope that depend on the place: Newton's method on the logarithm of both.
    fn balance(&self, guess_m: f64, force: impl Fn(f64) -> (f64, f64)) -> Option<f64> {
        let mut x = guess_m;
        for _ in 0..NEWTON_MAX {
            let (pushes, slope) = force(x);
            if !(pushes > 0.0 && x > 0.0) {
                return None;
            }
            let gap = (self.spring.force(x) / pushes).ln();
            let step = gap / (self.spring.exponent - x * slope / pushes);
            let next = x * (-step).exp();
            // The method doubles the digits: a step this small leaves rounding alone.
            if step.abs() <= NEWTON_LAST {
                return Some(next);
            }
            x = next;
        }
        Some(x)
    }
}

impl Contact {
    /// A spring so stiff near its zero that the plate rides on it; where it no longer does, plain steps take over.
    pub(super) fn ridden<const N: usize>(&self, riding: Riding, tolerance: f64) -> Option<Outset> {
        let constants = self.constants;
        let expand = |track: &Track, piece| {
            let tolerance = tolerance * eased(track.state[2], riding.reach_m);
            riding.expand::<N>(&constants, track.state, track.clock.rates()[0], (piece, tolerance))
        };
        let sides = (false, true);
        let part = riding.starts_at(tolerance);
        let mut start = self.at_balance(&riding, part, tolerance)?;
        let earlier = riding.earlier(start.t_s, start.state[2]);
        if earlier < 1.0 {
            if earlier < EARLIEST {
                return None;
            }
            start = self.at_balance(&riding, part * earlier, tolerance)?;
        }
        let reach_m = Some(riding.reach_m);
        match self.go_on(expand, start, (sides, tolerance, reach_m)) {
            Way::Ended(end) => Some(Outset::Ended(end)),
            Way::Handed(track) if track.steps > 0 => {
                let tolerance = SWINGING * tolerance;
                Some(Outset::Steps(Walk { track, tolerance, reach_m, terms: N }))
            }
            Way::Handed(_) | Way::Left => None,
        }
    }

    /// Where a riding plate is so early that the projectile has not felt it move.
    fn at_balance(&self, riding: &Riding, part: f64, tolerance: f64) -> Option<Track> {
        let c = &self.constants;
        let passage = Passage {
            geometry: &self.geometry,
            mass_kg: 1.0 / (c.slip_mobility - c.cos * c.cos * c.plate_mobility),
            strength_pa: c.strength_pa,
            drag_kg_m3: c.drag_kg_m3,
            velocity_m_s: c.velocity_m_s,
        };
        let travel_m = c.velocity_m_s * self.scale_s()? * part;
        let travel_m = smaller(travel_m, self.geometry.pieces().first()?.to_m);
        let (t_s, slip) = free::at_travel(&passage, travel_m, tolerance)?;
        let pressure = c.strength_pa + c.drag_kg_m3 * slip * slip;
        let plate_m = riding.spring.at_force(c.cos * self.geometry.area_m2(travel_m) * pressure);
        let clock = Clock::Even { unit_s: 0.5 * t_s };
        Some(self.begin(t_s, [travel_m, slip, plate_m, 0.0], clock))
    }

    /// The spring of a plate that rides on it from first contact, if it is such.
    pub(super) fn as_riding(&self) -> Option<Riding> {
        let (spring, damper) = (self.spring, self.damper);
        let linear = matches!(damper.kind(), PowerKind::Absent | PowerKind::Linear);
        let rides = spring.coefficient > 0.0 && spring.exponent < RIDES_BELOW;
        if !(linear && rides && self.start_m == 0.0 && self.constants.plate_mobility > 0.0) {
            return None;
        }
        Some(Riding {
            spring,
            damper_n_s_m: damper.coefficient,
            plate_kg: 1.0 / self.constants.plate_mobility,
            reach_m: self.reach_m()?,
        })
    }
}
