//! The cantilever without the pseudo-rigid body: an inextensible elastic line under an end load that keeps its direction.
//!
//! `E I theta'' = -P cos theta` with `theta(0) = 0` and no moment at the tip has the first integral
//! `theta'^2 = 2 alpha (sin theta_e - sin theta)`, `alpha = P l^2/(E I)`; with `sin theta = sin theta_e (1 - t^2)` what is left are
//! two smooth integrals over t from 0 to 1. K. E. Bisshopp and D. C. Drucker, *Quarterly of Applied Mathematics* 3 (1945) 272.

use crate::numerics::quadrature::gauss;
use crate::numerics::root::in_bracket;

/// Tip displacement over length, and `P l^2/(E I)`, for a sine of the tip's angle in (0, 1).
fn state(sine: f64) -> (f64, f64) {
    let weight = |t: f64| {
        let sin = sine * (1.0 - t * t);
        2.0 * sine.sqrt() / (1.0 - sin * sin).sqrt()
    };
    let length = gauss(0.0, 1.0, 8, weight);
    let rise = gauss(0.0, 1.0, 8, |t| weight(t) * sine * (1.0 - t * t));
    (rise / length, 0.5 * length * length)
}

/// `P l^2/(E I)` at a tip displacement over length in (0, 0.9).
pub(super) fn load(displacement: f64) -> f64 {
    state(in_bracket(1e-12, 1.0 - 1e-9, |sine| state(sine).0 - displacement)).1
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Small loads bend by `P l^3/(3 E I)`; Bisshopp and Drucker's tip displacements for loads of 1, 2 and 5.
    #[test]
    fn valid_small_loads_and_the_published_table() {
        assert!((load(1e-4) / 3e-4 - 1.0).abs() < 1e-7);
        for (alpha, tip) in [(1.0, 0.30172), (2.0, 0.49346), (5.0, 0.71379)] {
            assert!((load(tip) / alpha - 1.0).abs() < 1e-3, "{tip}: {}", load(tip));
        }
    }
}
