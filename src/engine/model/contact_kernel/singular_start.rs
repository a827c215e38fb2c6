//! First moment of a contact with a plate at rest at a singular zero of its spring or damper.
//!
//! The contact is expanded without these laws. Their effect follows from the momentum balance, m w = integral of (F - D - K). From rest a
//! force grows with a nearly constant power of time: its integral is its final value times t/(power + 1). The powers of displacement and
//! velocity, a = t w/x and p = t w'/w, follow from the balance of forces at the end. They change from those of inertia alone (3 and 2 for a
//! force proportional to time) to those of the law alone; both limits are exact.

use crate::model::contact_kernel::Contact;
use crate::model::contact_kernel::expansion::{Series, State, TimeGrading};
use crate::model::power_law::PowerLaw;
use crate::numerics::{larger, smaller};

/// Unit of the first step without grading, relative to the duration of the contact.
const EVEN_UNIT: f64 = 0.5;
/// Unit of the first step with grading, relative to its start.
const GRADED_UNIT: f64 = 0.6;
/// Maximum duration of the first moment, relative to the duration of the contact.
const MOMENT_MAX: f64 = 0.1;
/// Relative error of displacement and velocity, relative to the change of the laws' fraction of the force and of the power of the
/// displacement since first contact. Maximum over random scenes, compared with the simulation.
const MISSED: f64 = 0.04;
/// Maximum error of the relative velocity for a plate that is treated as fixed, in units of (t/duration)⁴: a sixth of the product of the
/// mobility fractions of both bodies, which is at most 1/4.
const HELD: f64 = 1.0 / 24.0;
/// Fraction of the tolerance for the error of the start.
const TOLERANCE_PART: f64 = 0.2;
/// Maximum number of iterations for the duration of the first moment.
const ROUNDS: usize = 12;
/// Maximum number of iterations for the balance of forces.
const BALANCE_ROUNDS: usize = 8;
/// Relative change of the velocity at which the iteration stops; the convergence is quadratic.
const SETTLED: f64 = 0.05;
/// Minimum power of time of the initial motion.
const POWER_MIN: f64 = 0.1;
/// Minimum velocity scale of the plate, relative to the velocity of the projectile; smaller velocities are within rounding.
const PLATE_PART_MIN: f64 = 1e-4;

impl Contact {
    /// Returns time, s, state and grading of the first step: at first contact, or after the first moment of a singular law.
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

    /// Returns the state at `span` with the effect of the singular laws, its error, and the power of time of the error; `None` if the plate
    /// does not move forward.
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
        let (mut fraction, mut growth, mut by_spring) = (0.0, 0.0, false);
        // Forces are expressed as changes of velocity within this time.
        let per_force = t_s * self.plate_mobility;
        for _ in 0..BALANCE_ROUNDS {
            let held = per_force * spring.force(w * t_s / a);
            let damped = per_force * self.damper.force(w);
            let inertia = w * p;
            let whole = inertia + held + damped;
            fraction = (held + damped) / whole;
            by_spring = held > damped;
            growth = if by_spring { n * free_a } else { m * free_p } + 1.0 - free_p;
            // Powers from the logarithmic derivative of the balance, with relaxation.
            let balanced =
                (inertia + (free_p - 1.0) * whole - n * held) / (inertia + m * damped + n * held);
            let relaxing = larger(growth, 0.0);
            p = free_p + (larger(balanced, POWER_MIN) - free_p) * free_p / (free_p + relaxing);
            a = free_a + (p - free_p) * free_a / (free_a + relaxing);
            // Momentum balance: a Newton step in logarithms, in which powers are linear.
            let (to_spring, to_damper) = (held / (1.0 + n * a), damped / (1.0 + m * p));
            let sum = w + to_spring + to_damper;
            let slope = (w + n * to_spring + m * to_damper) / sum;
            let moved = (free_m_s / sum).powf(1.0 / slope);
            w *= moved;
            if (moved - 1.0).abs() < SETTLED {
                break;
            }
        }
        // A difference of displacements would cancel for a cocked plate.
        let (dx, dw) = (t_s * (w / a - free_m_s / free_a), w - free_m_s);
        let state = [travel - self.cos * dx, slip - self.cos * dw, plate_m + dx, w];
        // Initially a preload is constant and the contact force proportional to time, and either inertia or a law dominates.
        let first_p = if self.start_m < 0.0 { 1.0 } else { 2.0 };
        let (first_fraction, first_a) = if growth > 0.0 {
            (0.0, first_p + 1.0)
        } else if by_spring {
            (1.0, (first_p - 1.0) / n)
        } else {
            (1.0, (first_p - 1.0) / m + 1.0)
        };
        let missed = MISSED * (fraction - first_fraction).abs() * (a - first_a).abs();
        // Velocity of the projectile, or of the plate if its displacement is relevant.
        let counts_m_s = larger(self.reach_m / self.scale_s, PLATE_PART_MIN * self.velocity_m_s);
        let by_plate = missed * self.cos * w / counts_m_s;
        let by_projectile = HELD * fraction * (t_s / self.scale_s).powi(4);
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
