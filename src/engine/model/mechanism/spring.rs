//! The spring as a run sees it: a power law, whose answers are closed forms, or a curve of any shape.
//!
//! Power laws have a compiled path of their own; the choice costs one comparison.

use std::sync::Arc;

use crate::model::mechanism::curve::Curve;
use crate::model::mechanism::piece::Piece;
use crate::model::mechanism::{PowerLaw, combine};
use crate::model::scene;
use crate::numerics::larger;

/// The force law of all springs together.
#[derive(Clone, Debug, PartialEq)]
pub enum Spring {
    /// One power law: absent where its coefficient is zero.
    Power(PowerLaw),
    /// Any other law.
    Curve(Arc<Curve>),
}

/// The force law within one stretch, as the equations of motion take it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Elastic<'a> {
    /// A power law.
    Power(PowerLaw),
    /// An analytic stretch of a curve.
    Piece(&'a Piece),
}

impl Spring {
    /// The law of a valid scene's mechanism, whatever the mount.
    pub fn of(mechanism: &scene::Mechanism) -> Self {
        Self::after(mechanism, 0.0)
    }

    /// The same where an absorber was crushed up to this displacement, m.
    pub fn after(mechanism: &scene::Mechanism, crushed_m: f64) -> Self {
        let (first, second) = (&mechanism.spring, mechanism.second_law());
        let curve = || first.law().curve(first, crushed_m);
        match first.power_law() {
            Some(law) if second.is_absent() => Self::Power(law),
            Some(law) if law.is_absent() => Self::Power(second),
            Some(law) if law.exponent.to_bits() == second.exponent.to_bits() => {
                let coefficient = law.coefficient + second.coefficient;
                Self::Power(PowerLaw { coefficient, ..law })
            }
            _ if second.is_absent() => Self::Curve(Arc::new(curve())),
            _ => Self::Curve(Arc::new(combine::parallel(&curve(), &Curve::power(second)))),
        }
    }

    /// No spring.
    pub const NONE: Self = Self::Power(PowerLaw::NONE);

    /// The power law, where it is one.
    pub fn power(&self) -> Option<PowerLaw> {
        match self {
            Self::Power(law) => Some(*law),
            Self::Curve(_) => None,
        }
    }

    /// The curve, where it is one.
    pub fn curve(&self) -> Option<&Curve> {
        match self {
            Self::Power(_) => None,
            Self::Curve(curve) => Some(curve),
        }
    }

    /// The ends of a stretch of the curve, m; infinite for a power law.
    pub fn ends(&self, region: usize) -> (f64, f64) {
        self.curve().map_or((f64::NEG_INFINITY, f64::INFINITY), |curve| curve.ends(region))
    }

    /// Whether there is no spring at all.
    pub fn is_absent(&self) -> bool {
        matches!(self, Self::Power(law) if law.is_absent())
    }

    /// Whether it is a power law that cannot be expanded at zero.
    pub fn is_singular(&self) -> bool {
        matches!(self, Self::Power(law) if law.is_singular())
    }

    /// Force at x, N.
    pub fn force(&self, x: f64) -> f64 {
        match self {
            Self::Power(law) => law.force(x),
            Self::Curve(curve) => curve.force(x),
        }
    }

    /// dF/dx at x, N/m.
    pub fn tangent(&self, x: f64) -> f64 {
        match self {
            Self::Power(law) => law.tangent(x),
            Self::Curve(curve) => curve.tangent(x),
        }
    }

    /// Energy stored at x, J: zero at the lowest point.
    pub fn energy(&self, x: f64) -> f64 {
        match self {
            Self::Power(law) => law.integral(x),
            Self::Curve(curve) => curve.energy(x),
        }
    }

    /// The greatest energy stored between two displacements, J.
    pub fn greatest_energy(&self, from_m: f64, to_m: f64) -> f64 {
        match self {
            Self::Power(law) => larger(law.integral(from_m), law.integral(to_m)),
            Self::Curve(curve) => curve.greatest_energy(from_m, to_m),
        }
    }

    /// How far forward a plate that is at x can go with this energy, m; infinite where nothing holds it.
    pub fn forward(&self, x: f64, energy_j: f64) -> f64 {
        match self {
            Self::Power(law) => law.at_integral(energy_j),
            Self::Curve(curve) => curve.forward(x, energy_j),
        }
    }

    /// Which way, 1 or -1, it drives the plate on from x for ever; no power law does.
    pub fn drives_away(&self, x: f64) -> Option<f64> {
        self.curve().and_then(|curve| curve.drives_away(x))
    }

    /// How far back of neutral it can go, m, positive backwards; infinite where nothing holds it.
    pub fn backward(&self, x: f64, energy_j: f64) -> f64 {
        match self {
            Self::Power(law) => law.at_integral(energy_j),
            Self::Curve(curve) => -curve.backward(x, energy_j),
        }
    }

    /// The displacement forward at which the force is this, m; infinite where it never is.
    pub fn at_force(&self, force_n: f64) -> f64 {
        match self {
            Self::Power(law) => law.at_force(force_n),
            Self::Curve(curve) => curve.at_force(force_n.abs()),
        }
    }

    /// The greatest force against the plate on the way from x with this energy, N, >= 0.
    pub fn greatest_push(&self, x: f64, energy_j: f64, reach_m: f64) -> f64 {
        match self {
            Self::Power(law) if reach_m.is_finite() => law.force(reach_m),
            Self::Power(_) => 0.0,
            Self::Curve(curve) => curve.forces_between(curve.backward(x, energy_j), reach_m).1,
        }
    }

    /// The greatest force forward on the way from x with this energy, N, >= 0.
    pub fn greatest_pull(&self, x: f64, energy_j: f64) -> f64 {
        match self {
            Self::Power(law) => {
                let back = law.at_integral(energy_j);
                if back.is_finite() { law.force(back) } else { 0.0 }
            }
            Self::Curve(curve) => {
                let (back, far) = (curve.backward(x, energy_j), curve.forward(x, energy_j));
                -curve.forces_between(back, far).0
            }
        }
    }
}

impl Elastic<'_> {
    /// Force at x, N.
    pub fn force(self, x: f64) -> f64 {
        match self {
            Self::Power(law) => law.force(x),
            Self::Piece(piece) => piece.force(x),
        }
    }

    /// dF/dx at x, N/m.
    pub fn tangent(self, x: f64) -> f64 {
        match self {
            Self::Power(law) => law.tangent(x),
            Self::Piece(piece) => piece.tangent(x),
        }
    }
}
