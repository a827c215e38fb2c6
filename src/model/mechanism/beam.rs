//! A beam as the pseudo-rigid-body model sees it: two rigid links, a pin and a torsional spring.
//!
//! `P = K Theta/(gamma l cos Theta)`, `x = gamma l sin Theta`, `K = gamma K_Theta E I/l`; the load keeps its direction, the bending
//! moment at the root is `P (l - gamma l (1 - cos Theta))`. L. L. Howell, *Compliant Mechanisms* (2001), chapter 5; thesis
//! section 9.5.2. A beam that is guided at its end is two half-length cantilevers, `2 K` at each of its two pivots.

use crate::model::mechanism::curve::{Curve, Segments};
use crate::model::mechanism::piece::Piece;
use crate::model::scene::{Beam, SpringKind};
use crate::numerics::smaller;

/// `K_Theta`, the stiffness coefficient of the torsional spring for a load across the beam.
const STIFFNESS_COEFFICIENT: f64 = 2.65;
/// gamma, the characteristic radius factor of Table 9.3.
const RADIUS_FACTOR: f64 = 0.85;
/// The angle up to which the pseudo-rigid body follows the beam (Howell, for a load across the beam); beyond it the force
/// goes on along its tangent, so that a run that gets there ends with a warning instead of failing.
const ANGLE_MAX_DEG: f64 = 64.3;
/// Pivots of a guided beam, each of twice the stiffness of the cantilever's one.
const PIVOTS: f64 = 2.0;

impl Beam {
    /// K, N m/rad.
    pub fn torsional_n_m(&self) -> f64 {
        let inertia = self.width_m * self.height_m.powi(3) / 12.0;
        RADIUS_FACTOR * STIFFNESS_COEFFICIENT * self.modulus_pa * inertia / self.length_m
    }

    fn reach_m(&self) -> f64 {
        RADIUS_FACTOR * self.length_m
    }

    /// The law of a given number of cantilevers in parallel.
    pub fn link(&self, count: f64) -> Piece {
        let reach_m = self.reach_m();
        Piece::Link { force_n: count * self.torsional_n_m() / reach_m, reach_m }
    }

    /// Displacement up to which the pseudo-rigid body follows the beam, m.
    pub(super) fn limit_m(&self) -> f64 {
        self.reach_m() * ANGLE_MAX_DEG.to_radians().sin()
    }

    pub(super) fn stress_pa(&self, kind: SpringKind, x_m: f64) -> f64 {
        let x = smaller(x_m.abs(), self.limit_m());
        if kind == SpringKind::FixedGuided {
            // Each half is a cantilever of half the length with half the displacement.
            let half = Self { length_m: 0.5 * self.length_m, ..*self };
            return half.stress_pa(SpringKind::Cantilever, 0.5 * x);
        }
        let cos = (x / self.reach_m()).asin().cos();
        let arm = self.length_m - self.reach_m() * (1.0 - cos);
        let section = self.width_m * self.height_m * self.height_m / 6.0;
        self.link(1.0).force(x) * arm / section
    }

    /// Its mass, kg.
    pub fn mass_kg(&self) -> f64 {
        self.density_kg_m3 * self.width_m * self.height_m * self.length_m
    }

    /// The law of a given number of beams in parallel, straight beyond where the pseudo-rigid body follows them.
    pub(super) fn curve(&self, kind: SpringKind, count: f64) -> Curve {
        let pivots = if kind == SpringKind::FixedGuided { PIVOTS } else { 1.0 };
        let link = self.link(count * pivots * pivots);
        let limit = self.limit_m();
        let beyond = |x: f64| Piece::line(x, link.force(x), link.tangent(x));
        let pieces = vec![beyond(-limit), link.clone(), beyond(limit)];
        Curve::new(Segments { knots_m: vec![-limit, limit], pieces }, limit)
    }
}
