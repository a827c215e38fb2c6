//! The spring as a run sees it: a power law, whose answers are closed forms, or a curve of any shape.
//!
//! Power laws have a compiled path of their own; the choice costs one comparison.

use std::sync::Arc;

use crate::model::mechanism::PowerLaw;
use crate::model::mechanism::curve::{Curve, SCALE_M};
use crate::model::mechanism::piece::Piece;
use crate::model::scene;
use crate::numerics::{larger, smaller};

/// The force law of all springs together.
#[derive(Clone, Debug, PartialEq)]
pub enum Spring {
    /// One power law: absent where its coefficient is zero.
    Power(PowerLaw),
    /// Any other law.
    Curve(Arc<Curve>),
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
            _ if second.is_absent() => Self::from(curve()),
            _ => Self::Curve(Arc::new(curve().parallel(&Curve::power(second)))),
        }
    }

    /// It and a stop of a stiffness that begins at a displacement, together.
    #[must_use]
    pub fn beside_stop(&self, at_m: f64, stiffness_n_m: f64) -> Self {
        let pieces = vec![Piece::line(at_m, 0.0, 0.0), Piece::line(at_m, 0.0, stiffness_n_m)];
        let stop = Curve::new(vec![at_m], pieces, larger(at_m.abs(), SCALE_M));
        Self::Curve(Arc::new(match self {
            Self::Power(law) => Curve::power(*law).parallel(&stop),
            Self::Curve(curve) => curve.parallel(&stop),
        }))
    }

    /// The law of a curve; none where that has no force.
    fn from(curve: Curve) -> Self {
        let is_none = curve.is_slack(f64::NEG_INFINITY, f64::INFINITY);
        if is_none { Self::NONE } else { Self::Curve(Arc::new(curve)) }
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

    /// The analytic stretch in which x lies; its end belongs to the stretch above it. A power law has one on either side of zero, or
    /// one alone where it goes smoothly through it.
    pub fn stretch(&self, x: f64) -> usize {
        match self {
            Self::Power(law) => usize::from(!law.is_smooth_at_zero() && x >= 0.0),
            Self::Curve(curve) => curve.region(x),
        }
    }

    /// The same, but an end belongs to the stretch below it.
    pub fn stretch_below(&self, x: f64) -> usize {
        match self {
            Self::Power(law) => usize::from(!law.is_smooth_at_zero() && x > 0.0),
            Self::Curve(curve) => curve.region_below(x),
        }
    }

    /// The ends of a stretch, m; infinite where it has none.
    pub fn ends(&self, stretch: usize) -> (f64, f64) {
        match self {
            Self::Power(law) if law.is_smooth_at_zero() => (f64::NEG_INFINITY, f64::INFINITY),
            Self::Power(_) if stretch == 0 => (f64::NEG_INFINITY, 0.0),
            Self::Power(_) => (0.0, f64::INFINITY),
            Self::Curve(curve) => curve.ends(stretch),
        }
    }

    /// Force at x by the law of a stretch, which goes on a little beyond its ends, N.
    pub fn force_in(&self, stretch: usize, x: f64) -> f64 {
        match self {
            Self::Power(law) => law.force_on(if stretch == 0 { -1.0 } else { 1.0 }, x),
            Self::Curve(curve) => curve.piece(stretch).force(x),
        }
    }

    /// dF/dx at x by the law of a stretch, N/m.
    pub fn tangent_in(&self, stretch: usize, x: f64) -> f64 {
        match self {
            Self::Power(law) => law.tangent(x),
            Self::Curve(curve) => curve.piece(stretch).tangent(x),
        }
    }

    /// Whether it is infinitely steep at zero.
    pub fn is_steep_at_zero(&self) -> bool {
        match self {
            Self::Power(law) => law.is_steep_at_zero(),
            Self::Curve(curve) => curve.is_steep_at_zero(),
        }
    }

    /// Whether there is no spring at all.
    pub fn is_absent(&self) -> bool {
        matches!(self, Self::Power(law) if law.is_absent())
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
            Self::Curve(curve) => curve.reach(x, energy_j, 1.0),
        }
    }

    /// Which way, 1 or -1, it drives the plate on from x for ever; no power law does.
    pub fn drives_away(&self, x: f64) -> Option<f64> {
        self.curve().and_then(|curve| curve.drives_away(x))
    }

    /// Where, ahead of x, nothing drives a plate forward any more that is driven so at x; x itself otherwise, m.
    pub fn rest_ahead(&self, x: f64) -> f64 {
        match self {
            Self::Power(law) if law.is_absent() => x,
            Self::Power(_) => larger(x, 0.0),
            Self::Curve(curve) => curve.rest_ahead(x),
        }
    }

    /// How far back of neutral it can go, m, positive backwards; infinite where nothing holds it.
    pub fn backward(&self, x: f64, energy_j: f64) -> f64 {
        match self {
            Self::Power(law) => law.at_integral(energy_j),
            Self::Curve(curve) => -curve.reach(x, energy_j, -1.0),
        }
    }

    /// The displacement forward at which the force is this, m; infinite where it never is.
    pub fn at_force(&self, force_n: f64) -> f64 {
        match self {
            Self::Power(law) => law.at_force(force_n),
            Self::Curve(curve) => curve.at_force(force_n.abs()),
        }
    }

    /// Whether there is no force between two displacements.
    pub fn is_slack(&self, low_m: f64, high_m: f64) -> bool {
        match self {
            Self::Power(law) => law.is_absent(),
            Self::Curve(curve) => curve.is_slack(low_m, high_m),
        }
    }

    /// The least and the greatest of zero and the forces between two displacements, N.
    fn forces_between(&self, low_m: f64, high_m: f64) -> (f64, f64) {
        match self {
            Self::Power(law) => (smaller(law.force(low_m), 0.0), larger(law.force(high_m), 0.0)),
            Self::Curve(curve) => curve.forces_between(low_m, high_m),
        }
    }

    /// The greatest force against the plate on the way from x with this energy, N, >= 0.
    pub fn greatest_push(&self, x: f64, energy_j: f64, reach_m: f64) -> f64 {
        self.forces_between(-self.backward(x, energy_j), reach_m).1
    }

    /// The greatest force forward on the way from x with this energy, N, >= 0.
    pub fn greatest_pull(&self, x: f64, energy_j: f64) -> f64 {
        0.0 - self.forces_between(-self.backward(x, energy_j), self.forward(x, energy_j)).0
    }
}
