//! A contact without spring and damper, in closed form: the place of its end follows from a swept volume, the time from a
//! quadrature.
//!
//! Sixteen Gauss-Legendre points on each stretch; up to the arrest at Q the travel is Q - L s², in which the integrand is even
//! and smooth, so that eight are enough. The last Legendre coefficients of the integrand, which cost next to nothing, say
//! whether the rule has converged: where they fall like rho^-14, the quadrature's error falls like rho^-32 (Trefethen,
//! *Approximation Theory and Approximation Practice*, theorem 19.3).

use std::f64::consts::E;

use crate::model::closed_form::{Ending, Passage, Rule};
use crate::model::contact::Geometry;
use crate::model::contact_kernel::expansion::Constants;
use crate::model::contact_kernel::{Contact, ContactEnd};
use crate::model::scene::{ContactModel, Scene};
use crate::numerics::exponential::{NEAR, bernoulli, bernoulli_near};
use crate::numerics::larger;
use crate::numerics::quadrature::GAUSS_16;

/// Part of the tolerance that the rule's error may take by that measure.
const TOLERANCE_PART: f64 = 0.03;

/// Shots on a rigid or free plate that leave with a part of their velocity between these are done in closed form: above, an
/// integration is as good and cheaper; below, the residual velocity has few digits.
const FAST_EXIT: f64 = 0.5;
const SLOW_EXIT: f64 = 0.05;
/// c v²/S up to which the exponents of the drag are within [`NEAR`].
const NEAR_EXCESS: f64 = E - 1.0;
const _: () = assert!(NEAR == 1.0);

/// When a contact ends that starts at zero travel, s; `None` where the rule has not converged to `tolerance`, or a piece has no
/// polynomial area.
fn arrest_time_s(passage: &Passage<'_>, travel_m: f64, tolerance: f64) -> Option<f64> {
    // The exponent grows from zero at rest to ln(1 + c v²/S) at first contact.
    let v = passage.velocity_m_s;
    if passage.drag_kg_m3 * v * v <= NEAR_EXCESS * passage.strength_pa {
        time_to_rest_s(passage, travel_m, tolerance, bernoulli_near)
    } else {
        time_to_rest_s(passage, travel_m, tolerance, bernoulli)
    }
}

/// The same with the function by which the drag changes the slip.
fn time_to_rest_s(
    passage: &Passage<'_>,
    travel_m: f64,
    tolerance: f64,
    drag: impl Fn(f64) -> (f64, f64),
) -> Option<f64> {
    let exponent = |volume_m3: f64| passage.exponent(volume_m3);
    let pieces = passage.geometry.pieces();
    let last = pieces.iter().position(|piece| travel_m <= piece.to_m)?;
    let [c1, c2, c3] = pieces[last].law.behind(travel_m)?;
    let length_m = travel_m - pieces[last].from_m;
    // Volume over length on the last stretch before the rest.
    let mean = |ahead_m: f64| c1 + ahead_m * (c2 + ahead_m * c3);
    let mut sum = (2.0 * length_m).sqrt()
        * even(tolerance, |s| {
            let ahead_m = length_m * s * s;
            let mean_m2 = mean(ahead_m);
            let (above, below) = drag(exponent(ahead_m * mean_m2));
            (above / (below * mean_m2)).sqrt()
        })?;
    let mut volume_m3 = length_m * mean(length_m);
    for piece in pieces[..last].iter().rev() {
        let [c1, c2, c3] = piece.law.behind(piece.to_m)?;
        let length_m = piece.to_m - piece.from_m;
        let swept = |part: f64| {
            let back_m = length_m * part;
            volume_m3 + back_m * (c1 + back_m * (c2 + back_m * c3))
        };
        let there = |part: f64| {
            let volume_m3 = swept(part);
            let (above, below) = drag(exponent(volume_m3));
            (above / (2.0 * below * volume_m3)).sqrt()
        };
        sum += length_m * whole(tolerance, there)?;
        volume_m3 = swept(1.0);
    }
    Some(sum / (passage.mobility_per_kg * passage.strength_pa).sqrt())
}

/// When and how fast a shot that is not stopped before is at a travel in the first piece: (s, m/s).
pub(super) fn at_travel(
    passage: &Passage<'_>,
    travel_m: f64,
    tolerance: f64,
) -> Option<(f64, f64)> {
    let slip = |q_m: f64| passage.slip_squared(q_m).sqrt();
    let t_s = travel_m * whole(tolerance, |part| 1.0 / slip(travel_m * part))?;
    Some((t_s, slip(travel_m)))
}

/// The contact of a scene whose plate is rigid or free; `None` where it is not, or the rule for the time does not converge.
pub(super) fn contact_end(scene: &Scene, tolerance: f64) -> Option<ContactEnd> {
    let moves = !scene.is_rigid();
    if (moves && !scene.mechanism.is_nothing()) || scene.contact.model != ContactModel::Hydrodynamic
    {
        return None;
    }
    let geometry = Geometry::of(scene);
    let constants = Constants::of(scene, geometry.nose.cos, moves);
    closed(&geometry, &constants, scene.start_m(), tolerance)
}

impl Contact {
    /// The end, if the plate is rigid or free and the rule for the time converges.
    pub(super) fn closed(&self, tolerance: f64) -> Option<ContactEnd> {
        if !(self.spring.is_absent() && self.damper.is_absent()) {
            return None;
        }
        closed(&self.geometry, &self.constants, self.start_m, tolerance)
    }
}

/// A plate that is rigid or free: no integration where the rule for the time converges.
fn closed(
    geometry: &Geometry,
    constants: &Constants,
    start_m: f64,
    tolerance: f64,
) -> Option<ContactEnd> {
    let c = constants;
    let passage = c.passage(geometry, c.slip_mobility);
    let ending = passage.ending();
    let (t_s, travel_m, slip) = match ending {
        Ending::Exit { velocity_m_s } => {
            let left = velocity_m_s / c.velocity_m_s;
            if !(SLOW_EXIT..FAST_EXIT).contains(&left) {
                return None;
            }
            (None, geometry.exit_m, velocity_m_s)
        }
        Ending::Arrest { travel_m } => {
            (arrest_time_s(&passage, travel_m, tolerance), travel_m, 0.0)
        }
    };
    // Near the ballistic limit the time wants a finer rule.
    let t_s = t_s.or_else(|| Some(passage.history(ending, Rule::FINE).last()?.t_s))?;
    let fraction = c.cos * c.plate_mobility / c.slip_mobility;
    let plate_displacement_m = start_m + fraction * (c.velocity_m_s * t_s - travel_m);
    Some(ContactEnd {
        arrested: matches!(ending, Ending::Arrest { .. }),
        t_s,
        penetration_m: geometry.depth_m(travel_m),
        plate_displacement_m,
        plate_velocity_m_s: fraction * (c.velocity_m_s - slip),
        max_displacement_m: plate_displacement_m,
        steps: 0,
    })
}

/// Integral from 0 to 1 of an even function.
fn even(tolerance: f64, f: impl Fn(f64) -> f64) -> Option<f64> {
    // All values before any sum: they come in vectors.
    let values = GAUSS_16.map(|node| f(node.at));
    let mut sums = [0.0; 3];
    for (node, value) in GAUSS_16.iter().zip(values) {
        let term = node.weight * value;
        sums[0] += term;
        sums[1] += term * node.last[0];
        sums[2] += term * node.last[2];
    }
    converged(sums, tolerance)
}

/// Integral from 0 to 1.
fn whole(tolerance: f64, f: impl Fn(f64) -> f64) -> Option<f64> {
    let left = GAUSS_16.map(|node| f(0.5 - 0.5 * node.at));
    let right = GAUSS_16.map(|node| f(0.5 + 0.5 * node.at));
    let mut sums = [0.0; 3];
    for (node, (left, right)) in GAUSS_16.iter().zip(left.into_iter().zip(right)) {
        let weight = 0.5 * node.weight;
        sums[0] += weight * (left + right);
        sums[1] += weight * (left + right) * node.last[2];
        sums[2] += weight * (right - left) * node.last[3];
    }
    converged(sums, tolerance)
}

/// The integral, if the integrand's last coefficients are small enough: to the power 32/14, rounded down.
fn converged([sum, before, last]: [f64; 3], tolerance: f64) -> Option<f64> {
    let relative = 29.0 * larger(before.abs(), last.abs()) / sum;
    let fourth = |x: f64| (x * x) * (x * x);
    // relative^(9/4) within its part, without roots.
    (relative * fourth(relative * relative) <= fourth(TOLERANCE_PART * tolerance)).then_some(sum)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn valid_the_rule_against_the_graded_quadrature_up_to_the_limit() {
        let geometry = Geometry::of(&Scene::default());
        for (drag, mass) in [(0.0, 0.0295), (677.5, 0.01475), (4e3, 0.0295)] {
            let mut passage = Passage {
                geometry: &geometry,
                mobility_per_kg: 1.0 / mass,
                strength_pa: 1.52e8,
                drag_kg_m3: drag,
                velocity_m_s: 0.0,
            };
            let limit = passage.limit_velocity_m_s();
            let mut found = 0;
            for i in 0..200 {
                passage.velocity_m_s = limit * (1.0 - 10f64.powf(-f64::from(i) / 40.0 - 0.02));
                let ending = passage.ending();
                let Ending::Arrest { travel_m } = ending else { panic!("perforated") };
                let exact = passage.history(ending, Rule::FINEST).last().unwrap().t_s;
                for tolerance in [1e-6, 1e-8, 1e-10] {
                    if let Some(t_s) = arrest_time_s(&passage, travel_m, tolerance) {
                        found += 1;
                        assert!(
                            (t_s / exact - 1.0).abs() < tolerance,
                            "{i} {tolerance}: {t_s} {exact}"
                        );
                    }
                }
            }
            assert!(found > 100, "{found}");
        }
    }

    #[test]
    fn a_parabola_is_integrated_and_a_step_is_refused() {
        let close = |found: Option<f64>, exact: f64| (found.unwrap() - exact).abs() < 1e-15;
        assert!(close(even(1e-15, |s| 1.0 + 3.0 * s * s), 2.0));
        assert!(close(whole(1e-15, |s| 1.0 + 2.0 * s), 2.0));
        assert_eq!(even(1e-6, |s| f64::from(s > 0.5)), None);
        assert_eq!(whole(1e-6, |s| f64::from(s > 0.5)), None);
        assert_eq!(whole(1e-6, |_| f64::NAN), None);
    }
}
