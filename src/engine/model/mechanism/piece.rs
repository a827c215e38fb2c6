//! Analytic piece of a force law: force, stiffness and energy.
//!
//! A law is one analytic function between two knots. It is also evaluated slightly beyond them: a step can pass an event before the event
//! is located.

use crate::model::power_law::PowerLaw;

/// Analytic force as a function of displacement.
#[derive(Clone, Debug, PartialEq)]
pub enum Piece {
    /// `c0 + c1 z + c2 z² + c3 z³` with z = x - `from_m`.
    Cubic {
        /// Position of z = 0, m.
        from_m: f64,
        /// Coefficients, N, N/m, N/m², N/m³.
        c: [f64; 4],
    },
    /// Pseudo-rigid link: `force_n asin(s)/sqrt(1 - s²)`, s = x/`reach_m`.
    Link {
        /// Force scale K/(gamma l), N.
        force_n: f64,
        /// Length gamma l, m.
        reach_m: f64,
    },
    /// Power law on one side of zero; the side has no effect for a law that is analytic at zero.
    Power {
        /// Law.
        law: PowerLaw,
        /// Side, 1 or -1.
        side: f64,
    },
    /// Two laws in parallel (equal displacement).
    Parallel(Box<[Self; 2]>),
}

impl Piece {
    /// Returns a linear law through (x, force) with a stiffness.
    pub fn line(x_m: f64, force_n: f64, slope_n_m: f64) -> Self {
        Self::Cubic { from_m: x_m, c: [force_n, slope_n_m, 0.0, 0.0] }
    }

    /// Returns the force at x, N.
    pub fn force(&self, x: f64) -> f64 {
        match self {
            Self::Cubic { from_m, c } => {
                let z = x - from_m;
                c[0] + z * (c[1] + z * (c[2] + z * c[3]))
            }
            Self::Link { force_n, reach_m } => {
                let s = x / reach_m;
                force_n * s.asin() / (1.0 - s * s).sqrt()
            }
            Self::Power { law, side } => law.force_on(*side, x),
            Self::Parallel(laws) => laws[0].force(x) + laws[1].force(x),
        }
    }

    /// Returns the sum of the magnitudes of the force's terms at x, N: they cancel where a piece is far from its own zero.
    pub fn terms_n(&self, x: f64) -> f64 {
        match self {
            Self::Cubic { from_m, c } => {
                let (z, c) = ((x - from_m).abs(), c.map(f64::abs));
                c[0] + z * (c[1] + z * (c[2] + z * c[3]))
            }
            Self::Link { .. } | Self::Power { .. } => self.force(x).abs(),
            Self::Parallel(laws) => laws[0].terms_n(x) + laws[1].terms_n(x),
        }
    }

    /// Returns the stiffness dF/dx at x, N/m.
    pub fn tangent(&self, x: f64) -> f64 {
        match self {
            Self::Cubic { from_m, c } => {
                let z = x - from_m;
                c[1] + z * (2.0 * c[2] + z * 3.0 * c[3])
            }
            Self::Link { force_n, reach_m } => {
                // With G = asin(s)/sqrt(1 - s²): (1 - s²) G' = 1 + s G.
                let s = x / reach_m;
                (force_n + s * self.force(x)) / ((1.0 - s * s) * reach_m)
            }
            Self::Power { law, .. } => law.tangent(x),
            Self::Parallel(laws) => laws[0].tangent(x) + laws[1].tangent(x),
        }
    }

    /// Returns an antiderivative of the force, J; the curve adds the integration constant.
    pub fn energy(&self, x: f64) -> f64 {
        match self {
            Self::Cubic { from_m, c } => {
                let z = x - from_m;
                z * (c[0] + z * (c[1] / 2.0 + z * (c[2] / 3.0 + z * c[3] / 4.0)))
            }
            Self::Link { force_n, reach_m } => {
                let angle = (x / reach_m).asin();
                0.5 * force_n * reach_m * angle * angle
            }
            Self::Power { law, .. } => law.integral(x),
            Self::Parallel(laws) => laws[0].energy(x) + laws[1].energy(x),
        }
    }

    /// Returns the law -F(-x); only a cubic is not odd.
    pub(super) fn mirrored(&self) -> Self {
        let Self::Cubic { from_m, c } = self else { return self.clone() };
        Self::Cubic { from_m: -from_m, c: [-c[0], c[1], -c[2], c[3]] }
    }

    /// Returns `true` if the stiffness at zero is infinite.
    pub fn is_steep_at_zero(&self) -> bool {
        match self {
            Self::Power { law, .. } => law.is_steep_at_zero(),
            Self::Parallel(laws) => laws.iter().any(Self::is_steep_at_zero),
            Self::Cubic { .. } | Self::Link { .. } => false,
        }
    }
}
