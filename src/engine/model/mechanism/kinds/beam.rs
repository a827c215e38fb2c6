//! Pseudo-rigid-body model of a beam: two rigid links, a pin joint and a torsional spring.
//!
//! `P = K Theta/(gamma l cos Theta)`, `x = gamma l sin Theta`, `K = gamma K_Theta E I/l`; the direction of the load is constant, the
//! bending moment at the root is `P (l - gamma l (1 - cos Theta))`. L. L. Howell, *Compliant Mechanisms* (2001), chapter 5; thesis section
//! 9.5.2. A beam with a guided end consists of two cantilevers of half the length, with `2 K` at each of its two pivots.

use super::{Curve, Law, Piece, Spring, SpringKind, parts};
use crate::numerics::root::bracketed_root;
use crate::numerics::smaller;

/// Stiffness coefficient `K_Theta` of the torsional spring, for a transverse load.
const STIFFNESS_COEFFICIENT: f64 = 2.65;
/// Characteristic radius factor gamma of Table 9.3.
const RADIUS_FACTOR: f64 = 0.85;
/// Maximum angle of the pseudo-rigid-body model for a transverse load (Howell). Beyond it the force continues along its tangent, and the
/// run has a warning.
const ANGLE_MAX_DEG: f64 = 64.3;
/// Number of pivots of a guided beam, each with twice the stiffness of that of a cantilever.
const PIVOTS: f64 = 2.0;
/// Moving fraction of the mass of a cantilever.
const MOVING_CANTILEVER: f64 = 33.0 / 140.0;
/// Moving fraction of the mass of a guided beam.
const MOVING_GUIDED: f64 = 13.0 / 35.0;

const TABLE_9_3: &str = "thesis Table 9.3";
const TITANIUM: &str = "thesis Table 9.3: titanium 6-4";

parts! {
    /// Rectangular beam; the default is that of Table 9.3 of the thesis, titanium 6-4, whose density the thesis does not give.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Beam at (mechanism.spring: Spring.beam) {
        pub length_m: f64 = 0.3 => "l_beam", "beam length", "length of a beam", number(Length, Positive).source(TABLE_9_3);
        pub width_m: f64 = 0.03 => "w_beam", "beam width", "width of a beam, across the bending",
            number(Length, Positive).source(TABLE_9_3);
        pub height_m: f64 = 0.015 => "h_beam", "beam height", "height of a beam, in the direction of bending",
            number(Length, Positive).source(TABLE_9_3);
        pub modulus_pa: f64 = 113.8e9 => "E_beam", "beam modulus", "modulus of elasticity of a beam",
            number(Pressure, Positive).source(TITANIUM);
        pub yield_pa: f64 = 880e6 => "Y_beam", "beam strength", "yield strength of a beam",
            number(Pressure, Positive).source(TITANIUM);
        pub density_kg_m3: f64 = 4430.0 => "rho_beam", "beam density", "density of a beam",
            number(Density, Positive).source("titanium 6-4; Table 9.3 does not give it");
    }
}

impl Beam {
    /// Returns the torsional stiffness K, N m/rad.
    pub fn torsional_n_m(&self) -> f64 {
        let inertia = self.width_m * self.height_m.powi(3) / 12.0;
        RADIUS_FACTOR * STIFFNESS_COEFFICIENT * self.modulus_pa * inertia / self.length_m
    }

    fn reach_m(&self) -> f64 {
        RADIUS_FACTOR * self.length_m
    }

    /// Returns the law of a number of cantilevers in parallel.
    pub fn link(&self, count: f64) -> Piece {
        let reach_m = self.reach_m();
        Piece::Link { force_n: count * self.torsional_n_m() / reach_m, reach_m }
    }

    /// Returns the maximum displacement of the pseudo-rigid-body model, m.
    fn limit_m(&self) -> f64 {
        self.reach_m() * ANGLE_MAX_DEG.to_radians().sin()
    }

    fn stress_pa(&self, kind: SpringKind, x_m: f64) -> f64 {
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
}

/// Law of beams in parallel.
impl Law for Beam {
    /// Returns the law of the links, linear beyond the range of the pseudo-rigid-body model.
    fn curve(&self, spring: &Spring, _crushed_m: f64) -> Curve {
        let pivots = if spring.kind == SpringKind::FixedGuided { PIVOTS } else { 1.0 };
        let link = self.link(spring.count * pivots * pivots);
        let limit = self.limit_m();
        let beyond = Piece::line(limit, link.force(limit), link.tangent(limit));
        Curve::odd(&[(0.0, link), (limit, beyond)], limit)
    }

    fn limits(&self, spring: &Spring, side: f64) -> Vec<(f64, &'static str)> {
        let yields = self.yields_at_m(spring);
        let yields = yields.map(|at| (side * at, "the beam yields, and the law is elastic"));
        let what = "the pseudo-rigid body follows no beam farther; the force goes on straight";
        yields.into_iter().chain([(side * self.limit_m(), what)]).collect()
    }

    fn mass_kg(&self, spring: &Spring, _: Option<f64>) -> Option<f64> {
        let Self { density_kg_m3, width_m, height_m, length_m, .. } = self;
        Some(spring.count * (density_kg_m3 * width_m * height_m * length_m))
    }

    fn moving_part(&self, spring: &Spring) -> f64 {
        if spring.kind == SpringKind::FixedGuided { MOVING_GUIDED } else { MOVING_CANTILEVER }
    }

    fn stress_ratio(&self, spring: &Spring, x_m: f64) -> Option<f64> {
        Some(self.stress_pa(spring.kind, x_m) / self.yield_pa)
    }

    fn yields_at_m(&self, spring: &Spring) -> Option<f64> {
        let limit = self.limit_m();
        let excess = |x: f64| self.stress_pa(spring.kind, x) - self.yield_pa;
        (excess(limit) > 0.0).then(|| bracketed_root(0.0, limit, excess))
    }
}
