//! The first moment of a contact whose spring or damper is singular at zero, where the plate is at rest.
//!
//! Up to there the contact is expanded without these laws. What they take from the plate follows from its impulse,
//! m w = integral of (F - D - K): over a moment that begins at rest a force grows with a power of time that hardly changes, so that its
//! integral is its last value times t/(power + 1). The powers of displacement and velocity, a = t w/x and p = t w'/w, follow from the
//! balance of forces there. Between inertia alone (a = 3, p = 2 against a force that grows with time) and a law that holds the plate
//! alone (p by the law's exponent) they relax: both ends are exact.

use crate::model::contact_kernel::expansion::{Series, State, slope};
use crate::model::mechanism::PowerLaw;
use crate::numerics::larger;

/// What the velocity is wrong by per square of the laws' share of the driving force, relative, at most: for all exponents of both
/// laws from 0.1 to 3, the plate's equation integrated in steps of a thousandth of the logarithm of time is closer.
const MISSED: f64 = 0.15;
/// The same per square of what the contact itself changes the power of the displacement by.
const BENT: f64 = 0.1;
/// Part of the tolerance that the start may use up.
const TOLERANCE_PART: f64 = 0.2;
/// Share of the driving force up to which a law may be put in that grows faster than that.
const SHARE_MAX: f64 = 0.3;
/// Rounds for the length of the moment, and for the balance at its end: both gain two digits or more each.
const ROUNDS: usize = 8;
const BALANCE_ROUNDS: usize = 3;
/// The least power of time by which a plate is taken to start.
const POWER_MIN: f64 = 0.1;

/// A singular start.
pub(super) struct Start {
    /// Coefficient zero where it is not singular.
    pub(super) spring: PowerLaw,
    pub(super) damper: PowerLaw,
    pub(super) plate_kg: f64,
    pub(super) cos: f64,
    /// Where the plate starts, m.
    pub(super) start_m: f64,
    /// The power of time with which the plate's velocity starts without these laws.
    pub(super) power: f64,
    pub(super) tolerance: f64,
    /// The contact's velocity or, where the plate's own displacement matters, its, m/s.
    pub(super) scale_m_s: f64,
    /// The contact's duration, s.
    pub(super) scale_s: f64,
}

/// A moment after first contact without the singular laws.
struct Moment {
    t_s: f64,
    state: State,
    /// What drives the plate, N.
    driving_n: f64,
    /// Powers of time of the plate's displacement and velocity.
    a: f64,
    p: f64,
}

impl Start {
    /// The time, s, and the state a moment after first contact, from its expansion without these laws in units of `unit_s` that is
    /// trusted up to `span`; `None` where there is none.
    pub(super) fn place(
        &self,
        series: &Series,
        unit_s: f64,
        mut span: f64,
    ) -> Option<(f64, State)> {
        for _ in 0..ROUNDS {
            let moment = self.moment(series, unit_s, span)?;
            let (excess, power) = self.excess(&moment);
            if excess <= 1.0 {
                return Some((moment.t_s, self.with_laws(&moment)));
            }
            span *= 0.9 * excess.powf(-1.0 / power);
        }
        None
    }

    fn moment(&self, series: &Series, unit_s: f64, span: f64) -> Option<Moment> {
        let (t_s, state) = (unit_s * span, series.state(span));
        let [_, slip, plate_m, w] = state;
        let x = plate_m - self.start_m;
        let driving_n = self.plate_kg * slope(&series.speed, span) / unit_s;
        let moves_on = slip > 0.0 && x > 0.0 && w > 0.0 && driving_n > 0.0;
        let p = t_s * driving_n / (self.plate_kg * w);
        moves_on.then_some(Moment { t_s, state, driving_n, a: w * t_s / x, p })
    }

    /// By how many times the error that is left would exceed its part of the tolerance, and with which power of time that falls.
    fn excess(&self, moment: &Moment) -> (f64, f64) {
        let [_, _, plate_m, w] = moment.state;
        let spring = self.spring.force(plate_m - self.start_m) / moment.driving_n;
        let damper = self.damper.force(w) / moment.driving_n;
        let (spring_power, damper_power) = self.powers(moment);
        let (share, power) =
            if spring > damper { (spring, spring_power) } else { (damper, damper_power) };
        let (powers, squares) = (power * power, share * share);
        // A law that begins stronger than the driving force has been so before.
        let of_one = if power > 0.0 { squares / (1.0 + squares) } else { 1.0 };
        let bent = moment.a - (self.power + 1.0);
        let part = share / (1.0 + share);
        let missed = MISSED * powers / (1.0 + powers) * of_one + BENT * part * bent * bent;
        let allowed = TOLERANCE_PART * self.tolerance;
        let by_plate = self.cos * missed * w / (allowed * self.scale_m_s);
        // What the contact force does to the projectile is known as if these laws were not there.
        let elapsed = (moment.t_s / self.scale_s).powi(4);
        let by_projectile = part * elapsed / allowed;
        let by_share = if power > 0.0 { share / SHARE_MAX } else { 0.0 };
        (larger(larger(by_plate, by_projectile), by_share), larger(power, 0.0) + 2.0)
    }

    /// With which powers of time the laws' shares of the driving force grow.
    fn powers(&self, moment: &Moment) -> (f64, f64) {
        let driving = moment.p - 1.0;
        (self.spring.exponent * moment.a - driving, self.damper.exponent * moment.p - driving)
    }

    /// The state with what the laws have taken from the plate.
    fn with_laws(&self, moment: &Moment) -> State {
        let t_s = moment.t_s;
        let [travel, slip, plate_m, free_m_s] = moment.state;
        let (m, n) = (self.damper.exponent, self.spring.exponent);
        let (spring_power, damper_power) = self.powers(moment);
        // A force that is bent on its way: its integral feels less of that than its end.
        let straightened =
            |start: f64, end: f64| start + (end - start) * (start + 1.0) / (start + 2.0);
        let spring_free = straightened(n * (self.power + 1.0), n * moment.a);
        let damper_free = straightened(m * self.power, m * moment.p);
        let (mut w, mut a, mut p) = (free_m_s, moment.a, moment.p);
        for _ in 0..BALANCE_ROUNDS {
            let (held, damped) = (self.spring.force(w * t_s / a), self.damper.force(w));
            // The powers by the logarithmic derivative of the balance, then relaxed.
            let inertia = self.plate_kg * w * p / t_s;
            let whole = inertia + held + damped;
            let balanced =
                (inertia + (moment.p - 1.0) * whole - n * held) / (inertia + m * damped + n * held);
            let fastest = if held > damped { spring_power } else { damper_power };
            let relaxing = larger(fastest * inertia / whole, 0.0);
            p = larger(
                moment.p + (balanced - moment.p) * moment.p / (moment.p + relaxing),
                POWER_MIN,
            );
            a = moment.a + (p - moment.p) * moment.a / (moment.a + relaxing);
            // The impulse: a step of Newton's method on the logarithm, where powers are lines.
            let by_spring = held * t_s / (1.0 + spring_free + n * (a - moment.a));
            let by_damper = damped * t_s / (1.0 + damper_free + m * (p - moment.p));
            let sum = self.plate_kg * w + by_spring + by_damper;
            let slope = (self.plate_kg * w + n * by_spring + m * by_damper) / sum;
            w *= (self.plate_kg * free_m_s / sum).powf(1.0 / slope);
        }
        let x = self.start_m + w * t_s / a;
        let travel = travel - self.cos * (x - plate_m);
        [travel, slip - self.cos * (w - free_m_s), x, w]
    }
}
