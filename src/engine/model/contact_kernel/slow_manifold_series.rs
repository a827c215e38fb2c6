//! The slow manifold of a spring: with an exponent below 1/3 the spring is so stiff near its zero that from first contact on
//! the plate is where spring and contact force balance, and oscillates about that place too fast to matter.
//!
//! There k x^n = F cos - m x'' - b x' is solved for x term by term, first without inertia; each further pass takes x'' and x'
//! from the one before (Hairer and Wanner, *Solving Ordinary Differential Equations II*, section VI.3: the slow manifold of a
//! singular perturbation). A pass gains as much as the plate oscillates fast against the motion; where two passes no longer
//! agree, the contact goes on by plain steps from there.

use crate::model::contact_kernel::expansion::{Area, Constants, Series, StepTime};
use crate::model::contact_kernel::integration::{IntegrationState, Plan};
use crate::model::contact_kernel::law::{Law as _, Power, product_before, square_before};
use crate::model::contact_kernel::slow_manifold::ManifoldRun;
use crate::model::contact_kernel::{Contact, free, is_linear};
use crate::model::mechanism::PowerLaw;
use crate::numerics::{larger, smaller};

/// Newton steps for the place of balance.
const NEWTON_MAX: usize = 30;
/// Its last step at most, relative.
const NEWTON_LAST: f64 = 1e-8;
/// Radians by which a plate could have swung from first contact to its start, at least.
const OSCILLATION_MIN_RAD: f64 = 60.0;
/// See [`tolerance_factor`].
const TOLERANCE_FACTOR_MAX: f64 = 1e3;
/// Tolerances by which a step may miss the next one's start: a plate that oscillates by more has left the manifold.
const OFF_MANIFOLD: f64 = 1.0;
/// Part of the tolerance of what the plate has moved at the start, against its displacement in the contact.
const START_PART: f64 = 0.1;

/// The spring of the manifold.
#[derive(Clone, Copy, Debug)]
pub(super) struct SpringManifold {
    /// k and n.
    pub(super) spring: PowerLaw,
    /// b of a linear damper, N s/m.
    pub(super) damper_n_s_m: f64,
    pub(super) plate_kg: f64,
    /// How far the plate comes at least, m: what is small against it need not be known as well.
    pub(super) reach_m: f64,
}

/// Where the spring holds what pushes the plate.
#[derive(Clone, Copy, Debug)]
pub(super) struct Balance {
    pub(super) plate_m: f64,
    pub(super) force_n: f64,
}

/// The start of the search for a balance.
pub(super) struct Guess {
    pub(super) balance: Balance,
    /// The force of plate inertia and damper, N.
    pub(super) lag_n: f64,
    pub(super) speed_m_s: f64,
}

/// The terms that the next pass takes from the one before.
#[derive(Clone, Copy)]
pub(super) struct Lag<const N: usize> {
    /// Inertia and damper, m w' + b w, N.
    pub(super) force: [f64; N],
    /// Plate velocity w, m/s.
    pub(super) speed: [f64; N],
}

/// What a pass is made about: a balance, and what the pass before leaves.
pub(super) struct About<'a, const N: usize> {
    pub(super) plate_m: f64,
    pub(super) held_n: f64,
    pub(super) lag: &'a Lag<N>,
}

/// Exponent below which a plate follows the manifold from the start.
pub(super) const MANIFOLD_BELOW: f64 = 1.0 / 3.0;
/// By how much earlier than necessary a plate is started at most, so that it follows the manifold at first.
const START_FACTOR_MIN: f64 = 1e-3;
/// Part of the tolerance for each of the many steps of a plate that oscillates fast.
const STEP_TOLERANCE: f64 = 0.2;

/// By how much less well the place of a plate need be known at `plate_m` that comes to `reach_m` at least. Its oscillations about
/// the balance fade more slowly than its displacement grows, and a step must not lose the plate.
pub(super) fn tolerance_factor(plate_m: f64, reach_m: f64) -> f64 {
    smaller(larger(reach_m / plate_m, 1.0).sqrt(), TOLERANCE_FACTOR_MAX)
}

impl SpringManifold {
    /// Up to which part of the contact's length the plate need not be looked at: it moves with power 1/n of the force.
    fn starts_at(&self, tolerance: f64) -> f64 {
        (START_PART * tolerance).powf(self.spring.exponent)
    }

    /// By how much earlier than at this time and place it has to start for its oscillations to be fast enough: their number up to
    /// a time falls with the power (3 n - 1)/(2 n) of it.
    pub(super) fn earlier(&self, t_s: f64, place_m: f64) -> f64 {
        let n = self.spring.exponent;
        let tangent = n * self.spring.force(place_m) / place_m;
        let radians = (tangent / self.plate_kg).sqrt() * t_s;
        (radians / OSCILLATION_MIN_RAD).powf(2.0 * n / (1.0 - 3.0 * n))
    }

    /// Whether the plate comes in on the slow motion: not at all if it is yet to start.
    pub(super) fn keeps_to(&self, at: Balance, w: f64, state: [f64; 4], tolerance: f64) -> bool {
        let x = at.plate_m;
        let (dx, dw) = (x - state[2], w - state[3]);
        let tangent = self.spring.exponent * at.force_n / x;
        let amplitude_squared = dx * dx + dw * dw * self.plate_kg / tangent;
        state[3] == 0.0 || amplitude_squared.sqrt() <= OFF_MANIFOLD * tolerance * x
    }

    /// Plain steps from there, small enough to follow its oscillations.
    pub(super) fn plan(&self, progress: IntegrationState, tolerance: f64, terms: usize) -> Plan {
        Plan { progress, tolerance: STEP_TOLERANCE * tolerance, reach_m: Some(self.reach_m), terms }
    }

    /// Where a contact is from which the first pass looks for the balance.
    pub(super) fn at(&self, plate_m: f64) -> Balance {
        Balance { plate_m, force_n: self.spring.force(plate_m) }
    }

    /// The balance from a guess where the projectile is at `state`: Newton's method on the
    /// logarithm of both sides, where powers are lines. `None` where nothing pushes.
    pub(super) fn balance(
        &self,
        constants: &Constants,
        state: [f64; 4],
        Area { origin_m, a }: Area,
        guess: &Guess,
    ) -> Option<Balance> {
        let Constants { strength_pa, drag_kg_m3, cos, .. } = *constants;
        let (own_m, own_m_s) = (state[0] + cos * state[2], state[1] + cos * state[3]);
        let slip = own_m_s - cos * guess.speed_m_s;
        let pressure = strength_pa + drag_kg_m3 * slip * slip;
        let n = self.spring.exponent;
        let Balance { plate_m: mut x, force_n: mut force } = guess.balance;
        for _ in 0..NEWTON_MAX {
            let q = own_m - cos * x - origin_m;
            let pushes = cos * (a[0] + q * (a[1] + a[2] * q)) * pressure - guess.lag_n;
            let slope = -cos * cos * (a[1] + 2.0 * a[2] * q) * pressure;
            if !(pushes > 0.0 && x > 0.0) {
                return None;
            }
            let step = ln(force / pushes) / (n - x * slope / pushes);
            x *= exp(-step);
            force *= exp(-n * step);
            // The method doubles the digits: a step this small leaves rounding alone.
            if step.abs() <= NEWTON_LAST {
                break;
            }
        }
        Some(Balance { plate_m: x, force_n: force })
    }

    /// One pass about that place of balance: the series with the plate's velocity as it was before.
    #[inline(always)]
    pub(super) fn pass<const N: usize>(
        &self,
        constants: &Constants,
        state: [f64; 4],
        unit_s: f64,
        Area { origin_m, a }: Area,
        &About { plate_m, held_n, lag }: &About<'_, N>,
    ) -> Series<N> {
        let Constants { strength_pa, drag_kg_m3, slip_mobility, plate_mobility, cos, .. } =
            *constants;
        let slowing = slip_mobility - cos * cos * plate_mobility;
        let zero = [0.0; N];
        let mut s = Series { travel: zero, slip: zero, plate: zero, speed: lag.speed };
        let mut offset = zero;
        let (area, pressure) = (&mut [0.0; N], &mut [0.0; N]);
        // The projectile's own travel and velocity, as far as they are known.
        let next = &mut [zero, zero];
        (next[0][0], next[1][0]) = (state[0] + cos * state[2], state[1] + cos * state[3]);
        let mut spring = Power::<N>::of(self.spring);
        spring.start(plate_m, held_n);
        s.plate[0] = plate_m;
        s.slip[0] = next[1][0] - cos * lag.speed[0];
        offset[0] = next[0][0] - cos * plate_m - origin_m;
        area[0] = a[0] + offset[0] * (a[1] + a[2] * offset[0]);
        pressure[0] = strength_pa + drag_kg_m3 * s.slip[0] * s.slip[0];
        let slope = a[1] + a[2] * offset[0] * 2.0;
        // What a coefficient of the slip or of the plate adds to another of the same order, or takes from it.
        let slip_pressure = drag_kg_m3 * s.slip[0] * 2.0;
        let slip_force = area[0] * slip_pressure;
        let plate_area = cos * slope;
        let plate_force = cos * slope * pressure[0];
        let tangent = held_n * self.spring.exponent / plate_m;
        let force_plate = 1.0 / (tangent + cos * cos * slope * pressure[0]);
        macro_rules! order {
            ($($j:literal)*) => { $( if const { $j < N } {
                const J: usize = $j;
                let force;
                if J == 0 {
                    force = area[0] * pressure[0];
                } else {
                    s.slip[J] = next[1][J] - cos * lag.speed[J];
                    // All but the parts of the slip's and the plate's coefficients J: what does not wait for them, ...
                    let moved = next[0][J];
                    let curvature = square_before::<N, J>(&offset) + offset[0] * moved * 2.0;
                    area[J] = a[1] * moved + a[2] * curvature;
                    let older = drag_kg_m3 * square_before::<N, J>(&s.slip);
                    let known = product_before::<N, J>(area, pressure)
                        + (area[J] * pressure[0] + area[0] * older);
                    let held = spring.term::<J>(&s.plate);
                    let pushed = (cos * known - lag.force[J] - held) * force_plate;
                    // ... and those parts, linear in them.
                    let x = pushed + cos * slip_force * force_plate * s.slip[J];
                    force = (known + slip_force * s.slip[J]) - plate_force * x;
                    s.plate[J] = x;
                    spring.add::<J>(x);
                    offset[J] = moved - cos * x;
                    area[J] -= plate_area * x;
                    pressure[J] = older + slip_pressure * s.slip[J];
                }
                s.travel[J] = if J == 0 { offset[J] + origin_m } else { offset[J] };
                if const { J + 1 < N } {
                    let h = unit_s * (1.0 / (J + 1) as f64);
                    next[0][J + 1] = h * next[1][J];
                    next[1][J + 1] = -(h * slowing * force);
                }
            } )* };
        }
        order!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19);
        s
    }

    /// What follows from a pass for the plate's velocity and for the next pass; of the last terms nothing is known.
    #[inline(always)]
    pub(super) fn lag<const N: usize>(&self, series: &Series<N>, unit_s: f64) -> Lag<N> {
        let rate = 1.0 / unit_s;
        let zero = [0.0; N];
        let mut lag = Lag { force: zero, speed: zero };
        for j in 0..N - 1 {
            lag.speed[j] = series.plate[j + 1] * (j + 1) as f64 * rate;
        }
        for j in 0..N - 1 {
            let inertia = self.plate_kg * lag.speed[j + 1] * (j + 1) as f64 * rate;
            lag.force[j] = inertia + self.damper_n_s_m * lag.speed[j];
        }
        lag
    }
}

/// By how little an argument differs from the one of zero logarithm, or from zero, where a few terms give every digit.
const NEAR: f64 = 1e-3;

/// The natural logarithm, quick near one.
fn ln(ratio: f64) -> f64 {
    if (ratio - 1.0).abs() > NEAR {
        return ratio.ln();
    }
    let z = (ratio - 1.0) / (ratio + 1.0);
    2.0 * z * (1.0 + z * z * (1.0 / 3.0 + z * z * (1.0 / 5.0)))
}

/// The exponential, quick near zero.
fn exp(x: f64) -> f64 {
    if x.abs() > NEAR {
        return x.exp();
    }
    1.0 + x * (1.0 + x * (1.0 / 2.0 + x * (1.0 / 6.0 + x * (1.0 / 24.0 + x * (1.0 / 120.0)))))
}

impl Contact {
    /// A contact that starts on a spring so stiff near its zero that the plate follows its manifold; `None` where it does not.
    pub(super) fn mounted(
        &self,
        manifold: SpringManifold,
        tolerance: f64,
        terms: usize,
    ) -> Option<ManifoldRun> {
        let part = manifold.starts_at(tolerance);
        let mut start = self.at_balance(&manifold, part, tolerance)?;
        let earlier = manifold.earlier(start.t_s, start.state[2]);
        if earlier < 1.0 {
            if earlier < START_FACTOR_MIN {
                return None;
            }
            start = self.at_balance(&manifold, part * earlier, tolerance)?;
        }
        Some(ManifoldRun::from(manifold, start, tolerance, terms))
    }

    /// Where a plate on the manifold is so early that the projectile has not felt it move.
    fn at_balance(
        &self,
        manifold: &SpringManifold,
        part: f64,
        tolerance: f64,
    ) -> Option<IntegrationState> {
        let c = &self.constants;
        let passage = c.passage(&self.geometry, c.slip_mobility - c.cos * c.cos * c.plate_mobility);
        let travel_m = c.velocity_m_s * self.scale_s? * part;
        let travel_m = smaller(travel_m, self.geometry.pieces().first()?.to_m);
        let (t_s, slip) = free::at_travel(&passage, travel_m, tolerance)?;
        let pressure = c.strength_pa + c.drag_kg_m3 * slip * slip;
        let plate_m = manifold.spring.at_force(c.cos * self.geometry.area_m2(travel_m) * pressure);
        let clock = StepTime::Even { unit_s: 0.5 * t_s };
        Some(self.begin(t_s, [travel_m, slip, plate_m, 0.0], clock))
    }

    /// The manifold of a plate that follows it from first contact, if there is one.
    pub(super) fn spring_manifold(&self) -> Option<SpringManifold> {
        let (spring, damper) = (self.spring, self.damper);
        let is_slow = !spring.is_absent() && spring.exponent < MANIFOLD_BELOW;
        if !(is_linear(damper)
            && is_slow
            && self.start_m == 0.0
            && self.constants.plate_mobility > 0.0)
        {
            return None;
        }
        Some(SpringManifold {
            spring,
            damper_n_s_m: damper.coefficient,
            plate_kg: 1.0 / self.constants.plate_mobility,
            reach_m: self.reach_m()?,
        })
    }
}
