//! The first moment of a contact whose spring or damper is singular at zero, where the plate is at rest.
//!
//! Up to there the contact is expanded without these laws. What they take from the plate follows from its impulse,
//! m w = integral of (F - D - K): from rest on a force grows with a power of time that hardly changes, so that its integral is its
//! last value times t/(power + 1). The powers of displacement and velocity, a = t w/x and p = t w'/w, follow from the balance of
//! forces at the end. They relax from those of inertia alone (3 and 2 against a force that grows with time) to those of a law
//! that holds the plate alone; both limits are exact.

use crate::model::contact_kernel::expansion::{Series, State, slope};
use crate::model::mechanism::PowerLaw;
use crate::numerics::larger;

/// What displacement and velocity are wrong by, relative, in units of e² s²/((1 + e²)(1 + s²)), at most: s is the laws' share of the
/// driving force, and e the power of time with which that grows.
const MISSED: f64 = 0.3;
/// The same per square of the change that the contact itself makes to the power of the displacement.
const BENT: f64 = 0.1;
/// What the slip is wrong by in units of (t/duration)⁴, at most, if the plate stays where it would have moved freely: the sixth part
/// of the product of the bodies' parts of the mobility, which is a quarter at most.
const HELD: f64 = 1.0 / 24.0;
/// Part of the tolerance that the start may use up.
const TOLERANCE_PART: f64 = 0.2;
/// Rounds for the length of the moment.
const ROUNDS: usize = 8;
/// Rounds for the balance at its end, each of which gains two digits or more.
const BALANCE_ROUNDS: usize = 3;
/// The least power of time with which a plate is taken to start.
const POWER_MIN: f64 = 0.1;

/// A singular start.
pub(super) struct Start {
    /// Coefficient zero of a spring that is cocked: it acts from the beginning.
    pub(super) spring: PowerLaw,
    pub(super) damper: PowerLaw,
    pub(super) plate_kg: f64,
    pub(super) cos: f64,
    /// Where the plate starts, m.
    pub(super) from_m: f64,
    pub(super) tolerance: f64,
    /// The projectile's velocity or, where the plate's own displacement matters, that of the plate, m/s.
    pub(super) scale_m_s: f64,
    /// The contact's duration, s.
    pub(super) duration_s: f64,
}

/// A moment after first contact without these laws.
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
    /// The time, s, and the state a moment after first contact, from the contact's expansion without these laws in units of `unit_s`,
    /// which is trusted up to `span`; `None` where there is none.
    pub(super) fn place(
        &self,
        series: &Series,
        unit_s: f64,
        mut span: f64,
    ) -> Option<(f64, State)> {
        for _ in 0..ROUNDS {
            let Some(moment) = self.moment(series, unit_s, span) else {
                span *= 0.5;
                continue;
            };
            let (excess, power) = self.excess(&moment);
            if excess <= 1.0 {
                return Some((moment.t_s, self.with_laws(&moment)));
            }
            span *= 0.9 * excess.powf(-1.0 / power);
        }
        None
    }

    /// The moment at `span`; `None` where the plate does not go forward.
    fn moment(&self, series: &Series, unit_s: f64, span: f64) -> Option<Moment> {
        let (t_s, state) = (unit_s * span, series.state(span));
        let (x, w) = (state[2] - self.from_m, state[3]);
        let driving_n = self.plate_kg * slope(&series.speed, span) / unit_s;
        let p = t_s * driving_n / (self.plate_kg * w);
        let goes_on = state[1] > 0.0 && x > 0.0 && w > 0.0 && driving_n > 0.0;
        goes_on.then_some(Moment { t_s, state, driving_n, a: w * t_s / x, p })
    }

    /// The power of time with which the plate's velocity begins.
    fn first_power(&self) -> f64 {
        // A preload pushes at once, the contact in proportion to time.
        if self.from_m < 0.0 { 1.0 } else { 2.0 }
    }

    /// With which powers of time the laws' shares of the driving force grow, the spring's first.
    fn growths(&self, moment: &Moment) -> (f64, f64) {
        let driving = moment.p - 1.0;
        (self.spring.exponent * moment.a - driving, self.damper.exponent * moment.p - driving)
    }

    /// How many times the error that is left is larger than its part of the tolerance, and with which power of time it grows.
    fn excess(&self, moment: &Moment) -> (f64, f64) {
        let [_, _, plate_m, w] = moment.state;
        let n = self.spring.exponent;
        let held = self.spring.force(plate_m - self.from_m) / moment.driving_n;
        let damped = self.damper.force(w) / moment.driving_n;
        let (by_spring, by_damper) = self.growths(moment);
        let (share, growth) = if held > damped { (held, by_spring) } else { (damped, by_damper) };
        let part = |x: f64| x / (1.0 + x);
        // A law whose share falls has been stronger before.
        let of_share = if growth > 0.0 { part(share * share) } else { 1.0 };
        let bent = moment.a - (self.first_power() + 1.0);
        let missed = MISSED * part(growth * growth) * of_share + BENT * part(share) * bent * bent;
        let elapsed = moment.t_s / self.duration_s;
        let slip = self.cos * missed * w / self.scale_m_s;
        let plate = if growth < 0.0 && held > damped {
            // The plate oscillates about a balance that is much closer. It keeps its action: that fades against its displacement.
            let fades = (3.0 + n) / (4.0 * n);
            let closer = 1.0 + share.powf(1.0 / n);
            (larger(slip / closer, missed * elapsed.powf(fades)), fades)
        } else {
            (slip, 2.0 + 2.0 * larger(growth, 0.0) / (1.0 + share * share))
        };
        let projectile = (HELD * part(share) * elapsed.powi(4), 4.0);
        let (error, power) = if projectile.0 > plate.0 { projectile } else { plate };
        (error / (TOLERANCE_PART * self.tolerance), power)
    }

    /// The state with what the laws have taken from the plate.
    fn with_laws(&self, moment: &Moment) -> State {
        let t_s = moment.t_s;
        let [travel, slip, plate_m, free_m_s] = moment.state;
        let (m, n) = (self.damper.exponent, self.spring.exponent);
        let (by_spring, by_damper) = self.growths(moment);
        // The integral of a force whose power changes on its way feels less of that than its end.
        let mean = |first: f64, last: f64| first + (last - first) * (first + 1.0) / (first + 2.0);
        let spring_power = mean(n * (self.first_power() + 1.0), n * moment.a);
        let damper_power = mean(m * self.first_power(), m * moment.p);
        let (mut w, mut a, mut p) = (free_m_s, moment.a, moment.p);
        for _ in 0..BALANCE_ROUNDS {
            let (held, damped) = (self.spring.force(w * t_s / a), self.damper.force(w));
            // The powers by the logarithmic derivative of the balance, then relaxed.
            let inertia = self.plate_kg * w * p / t_s;
            let whole = inertia + held + damped;
            let balanced =
                (inertia + (moment.p - 1.0) * whole - n * held) / (inertia + m * damped + n * held);
            let growth = if held > damped { by_spring } else { by_damper };
            let relaxing = larger(growth * inertia / whole, 0.0);
            p = moment.p + (balanced - moment.p) * moment.p / (moment.p + relaxing);
            p = larger(p, POWER_MIN);
            a = moment.a + (p - moment.p) * moment.a / (moment.a + relaxing);
            // The impulse: a step of Newton's method on the logarithm, where powers are lines.
            let to_spring = held * t_s / (1.0 + spring_power + n * (a - moment.a));
            let to_damper = damped * t_s / (1.0 + damper_power + m * (p - moment.p));
            let sum = self.plate_kg * w + to_spring + to_damper;
            let slope = (self.plate_kg * w + n * to_spring + m * to_damper) / sum;
            w *= (self.plate_kg * free_m_s / sum).powf(1.0 / slope);
        }
        // Not as a difference of places: beside a cocked plate's own the contact may be tiny.
        let (dx, dw) = (t_s * (w / a - free_m_s / moment.a), w - free_m_s);
        [travel - self.cos * dx, slip - self.cos * dw, plate_m + dx, w]
    }
}
