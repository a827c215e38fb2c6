//! A contact without spring and damper, in closed form: where it ends is a swept volume, when is a quadrature.
//!
//! Sixteen Gauss-Legendre points on each stretch; up to the arrest at Q the travel is Q - L s², in which the integrand is even
//! and smooth, so that eight are enough. The last Legendre coefficients of the integrand, which cost next to nothing, say
//! whether the rule has converged: where they fall like rho^-14, the quadrature's error falls like rho^-32 (Trefethen,
//! *Approximation Theory and Approximation Practice*, theorem 19.3).

use crate::model::closed_form::{Ending, Passage};
use crate::model::contact::{AreaLaw, Piece};
use crate::numerics::larger;
use crate::numerics::quadrature::GAUSS_16;

/// Part of the tolerance that the rule's error may take by that measure.
const SHARE: f64 = 0.03;

/// When a contact ends that starts at zero travel, s; `None` where the rule has not converged to `tolerance`, or a piece has no
/// polynomial area.
pub(super) fn arrest_time_s(passage: &Passage<'_>, ending: Ending, tolerance: f64) -> Option<f64> {
    let Ending::Arrest { travel_m } = ending else { return None };
    let (s, c) = (passage.strength_pa, passage.drag_kg_m3);
    let per_volume = 2.0 * c / passage.mass_kg;
    // Slip from the volume still to be swept.
    let slip = |volume_m3: f64| {
        let squared = if c == 0.0 {
            2.0 * s * volume_m3 / passage.mass_kg
        } else {
            s / c * (per_volume * volume_m3).exp_m1()
        };
        squared.sqrt()
    };
    let pieces = passage.geometry.pieces();
    let last = pieces.iter().position(|piece| travel_m <= piece.to_m)?;
    let ahead = Ahead::of(&pieces[last], travel_m)?;
    let length_m = travel_m - pieces[last].from_m;
    let mut t_s =
        even(tolerance, |s| 2.0 * length_m * s / slip(ahead.volume_m3(length_m * s * s)))?;
    let mut volume_m3 = ahead.volume_m3(length_m);
    for piece in pieces[..last].iter().rev() {
        let ahead = Ahead::of(piece, piece.to_m)?;
        let length_m = piece.to_m - piece.from_m;
        let there = |part: f64| 1.0 / slip(volume_m3 + ahead.volume_m3(length_m * part));
        t_s += length_m * whole(tolerance, there)?;
        volume_m3 += ahead.volume_m3(length_m);
    }
    Some(t_s)
}

/// The volume swept over the last stretch before a travel: a cubic in its length.
struct Ahead([f64; 3]);

impl Ahead {
    fn of(piece: &Piece, travel_m: f64) -> Option<Self> {
        let AreaLaw::Quadratic { origin_m, a } = piece.law else { return None };
        let q = travel_m - origin_m;
        let area = a[0] + q * (a[1] + q * a[2]);
        Some(Self([area, -0.5 * (a[1] + 2.0 * a[2] * q), a[2] / 3.0]))
    }

    fn volume_m3(&self, length_m: f64) -> f64 {
        length_m * (self.0[0] + length_m * (self.0[1] + length_m * self.0[2]))
    }
}

/// Integral from 0 to 1 of an even function.
fn even(tolerance: f64, f: impl Fn(f64) -> f64) -> Option<f64> {
    let mut sums = [0.0; 3];
    for node in &GAUSS_16 {
        let term = node.weight * f(node.at);
        sums[0] += term;
        sums[1] += term * node.last[0];
        sums[2] += term * node.last[2];
    }
    converged(sums, tolerance)
}

/// Integral from 0 to 1.
fn whole(tolerance: f64, f: impl Fn(f64) -> f64) -> Option<f64> {
    let mut sums = [0.0; 3];
    for node in &GAUSS_16 {
        let (left, right) = (f(0.5 - 0.5 * node.at), f(0.5 + 0.5 * node.at));
        sums[0] += 0.5 * node.weight * (left + right);
        sums[1] += 0.5 * node.weight * (left + right) * node.last[2];
        sums[2] += 0.5 * node.weight * (right - left) * node.last[3];
    }
    converged(sums, tolerance)
}

/// The integral, if the integrand's last coefficients are small enough: to the power 32/14, rounded down.
fn converged([sum, before, last]: [f64; 3], tolerance: f64) -> Option<f64> {
    let relative = 29.0 * larger(before.abs(), last.abs()) / sum;
    (relative * relative * relative.sqrt().sqrt() <= SHARE * tolerance).then_some(sum)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::contact::Geometry;
    use crate::model::scene::Scene;

    #[test]
    fn valid_the_rule_against_the_graded_quadrature_up_to_the_limit() {
        let geometry = Geometry::of(&Scene::default());
        for (drag, mass) in [(0.0, 0.0295), (677.5, 0.01475), (4e3, 0.0295)] {
            let mut passage = Passage {
                geometry: &geometry,
                mass_kg: mass,
                strength_pa: 1.52e8,
                drag_kg_m3: drag,
                velocity_m_s: 0.0,
            };
            let limit = passage.limit_velocity_m_s();
            let mut found = 0;
            for i in 0..200 {
                passage.velocity_m_s = limit * (1.0 - 10f64.powf(-f64::from(i) / 40.0 - 0.02));
                let ending = passage.ending();
                let exact = passage.history(ending, 4).last().unwrap().t_s;
                for tolerance in [1e-6, 1e-8, 1e-10] {
                    if let Some(t_s) = arrest_time_s(&passage, ending, tolerance) {
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
