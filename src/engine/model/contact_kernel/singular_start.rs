//! The first moment of a contact whose spring or damper is singular at zero, where the plate is at rest.
//!
//! Up to there the contact is expanded without these laws. What they take from the plate follows from its impulse,
//! m w = integral of (F - D - K): from rest on a force grows with a power of time that hardly changes, so that its integral is its
//! last value times t/(power + 1). The powers of displacement and velocity, a = t w/x and p = t w'/w, follow from the balance of
//! forces at the end. They relax from those of inertia alone (3 and 2 against a force that grows with time) to those of a law
//! that holds the plate alone; both limits are exact.

use crate::model::contact_kernel::Contact;
use crate::model::contact_kernel::expansion::{Series, State, TimeGrading};
use crate::model::mechanism::PowerLaw;
use crate::numerics::{larger, smaller};

/// First unit of a step, relative to the contact's duration and, on a graded clock, to where it starts.
const EVEN_UNIT: f64 = 0.5;
const GRADED_UNIT: f64 = 0.6;
/// Time up to which a plate is expanded without its singular laws, as part of the contact's duration.
const MOMENT_MAX: f64 = 0.1;
/// Relative error of displacement and velocity, per change of the laws' fraction of the force and of the displacement's power since first
/// contact. Greatest ratio measured against the simulation on random scenes.
const MISSED: f64 = 0.04;
/// Greatest error of the relative velocity, in units of (t/duration)⁴, of a plate that is treated as fixed but would move freely. It is a
/// sixth of the product of the bodies' fractions of the mobility, which is 1/4 at most.
const HELD: f64 = 1.0 / 24.0;
/// Part of the tolerance that the start may use up.
const TOLERANCE_PART: f64 = 0.2;
/// Rounds for the length of the moment.
const ROUNDS: usize = 12;
/// Rounds for the balance at its end, at most, and the relative change of the velocity after which it is known.
const BALANCE_ROUNDS: usize = 8;
const SETTLED: f64 = 0.05;
/// The least power of time with which a plate is taken to start.
const POWER_MIN: f64 = 0.1;
/// The least velocity of the plate that counts, as part of that of the projectile: less is within rounding.
const PLATE_PART_MIN: f64 = 1e-4;

impl Contact {
    /// First contact, or a little later where a law is singular there: the time, s, the state, and the clock of the first step.
    pub(super) fn begin(&self, tolerance: f64) -> Option<(f64, State, TimeGrading)> {
        let from_zero = self.start_m == 0.0;
        let clock = TimeGrading { unit_s: EVEN_UNIT * self.scale_s, grade: 0.0 };
        let state = [0.0, self.velocity_m_s, self.start_m, 0.0];
        if self.damper.is_linear() && (self.spring.is_linear() || !from_zero) {
            return Some((0.0, state, clock));
        }
        let piece = self.geometry.pieces().first()?;
        let laws = [self.spring.only_if(!from_zero), PowerLaw::NONE];
        let series = self.expand(laws, state, clock, piece.law)?;
        let trusted = series.trusted(tolerance, self.velocity_m_s, f64::INFINITY);
        let mut span = smaller(trusted, MOMENT_MAX / EVEN_UNIT);
        for _ in 0..ROUNDS {
            let t_s = clock.unit_s * span;
            let Some((state, error, power)) = self.moment(&series, t_s, span) else {
                span *= 0.5;
                continue;
            };
            let excess = error / (TOLERANCE_PART * tolerance);
            if excess <= 1.0 {
                let clock = TimeGrading { unit_s: 3.0 * GRADED_UNIT * t_s, grade: GRADED_UNIT };
                return (state[0] < piece.to_m && state[1] > 0.0).then_some((t_s, state, clock));
            }
            span *= 0.9 * excess.powf(-1.0 / power);
        }
        None
    }

    /// The state at `span` with what the laws have taken from the plate, its error, and the power of time with which that grows;
    /// `None` where the plate does not go forward.
    fn moment(&self, series: &Series, t_s: f64, span: f64) -> Option<(State, f64, f64)> {
        let [travel, slip, plate_m, free_m_s] = series.state(span);
        let (free_m, gained_m_s) = (plate_m - self.start_m, span * series.acceleration(span));
        if !(slip > 0.0 && free_m > 0.0 && free_m_s > 0.0 && gained_m_s > 0.0) {
            return None;
        }
        let (free_a, free_p) = (free_m_s * t_s / free_m, gained_m_s / free_m_s);
        let spring = self.spring.only_if(self.start_m == 0.0);
        let (n, m) = (spring.exponent, self.damper.exponent);
        let (mut w, mut a, mut p) = (free_m_s, free_a, free_p);
        let (mut share, mut growth, mut by_spring) = (0.0, 0.0, false);
        // All forces as the velocities that they would give in this time.
        let per_force = t_s * self.plate_mobility;
        for _ in 0..BALANCE_ROUNDS {
            let held = per_force * spring.force(w * t_s / a);
            let damped = per_force * self.damper.force(w);
            let inertia = w * p;
            let whole = inertia + held + damped;
            share = (held + damped) / whole;
            by_spring = held > damped;
            growth = if by_spring { n * free_a } else { m * free_p } + 1.0 - free_p;
            // The powers by the logarithmic derivative of the balance, then relaxed.
            let balanced =
                (inertia + (free_p - 1.0) * whole - n * held) / (inertia + m * damped + n * held);
            let relaxing = larger(growth, 0.0);
            p = free_p + (larger(balanced, POWER_MIN) - free_p) * free_p / (free_p + relaxing);
            a = free_a + (p - free_p) * free_a / (free_a + relaxing);
            // The impulse: a step of Newton's method on the logarithm, where powers are lines.
            let (to_spring, to_damper) = (held / (1.0 + n * a), damped / (1.0 + m * p));
            let sum = w + to_spring + to_damper;
            let slope = (w + n * to_spring + m * to_damper) / sum;
            let moved = (free_m_s / sum).powf(1.0 / slope);
            w *= moved;
            if (moved - 1.0).abs() < SETTLED {
                break;
            }
        }
        // Not as a difference of places: beside a cocked plate's own the contact may be tiny.
        let (dx, dw) = (t_s * (w / a - free_m_s / free_a), w - free_m_s);
        let state = [travel - self.cos * dx, slip - self.cos * dw, plate_m + dx, w];
        // At first a preload pushes at once, the contact in proportion to time, and either inertia alone or a law alone holds the plate.
        let first_p = if self.start_m < 0.0 { 1.0 } else { 2.0 };
        let (first_share, first_a) = if growth > 0.0 {
            (0.0, first_p + 1.0)
        } else if by_spring {
            (1.0, (first_p - 1.0) / n)
        } else {
            (1.0, (first_p - 1.0) / m + 1.0)
        };
        let missed = MISSED * (share - first_share).abs() * (a - first_a).abs();
        // The projectile's velocity or, where the plate's own displacement matters, that of the plate.
        let counts_m_s = larger(self.reach_m / self.scale_s, PLATE_PART_MIN * self.velocity_m_s);
        let by_plate = missed * self.cos * w / counts_m_s;
        let by_projectile = HELD * share * (t_s / self.scale_s).powi(4);
        Some(if by_projectile > by_plate {
            (state, by_projectile, 4.0)
        } else {
            (
                state,
                by_plate,
                free_p + 2.0 * larger(growth, -growth / if by_spring { n } else { m }),
            )
        })
    }
}
