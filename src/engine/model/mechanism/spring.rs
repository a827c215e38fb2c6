//! Combined force law of all springs: a power law with closed forms, or a general curve.
//!
//! Bounds and inverses of a curve follow from its stations, between which force and energy are monotone.

use std::sync::Arc;

use crate::model::mechanism::curve::{self, Curve, SCALE_M};
use crate::model::mechanism::piece::Piece;
use crate::model::power_law::{PowerLaw, sign};
use crate::model::scene;
use crate::numerics::root::bracketed_root;
use crate::numerics::{larger, smaller};

/// Number of doublings of the distance in the search for an energy or a force beyond the last knot.
const DOUBLINGS: i32 = 80;

/// Combined force law of all springs.
#[derive(Clone, Debug, PartialEq)]
pub enum Spring {
    /// Power law; absent if its coefficient is zero.
    Power(PowerLaw),
    /// Any other law.
    Curve(Arc<Curve>),
}

impl Spring {
    /// Law without force.
    pub const NONE: Self = Self::Power(PowerLaw::NONE);

    /// Creates the law of a valid mechanism, independent of the mount, with the crushed length of an absorber, m.
    pub fn new(mechanism: &scene::Mechanism, crushed_m: f64) -> Self {
        let (first, second) = (&mechanism.spring, mechanism.second_law());
        let curve = || first.law().curve(first, crushed_m);
        match first.power_law() {
            Some(law) if second.is_absent() => Self::Power(law),
            Some(law) if law.is_absent() => Self::Power(second),
            Some(law) if law.exponent.to_bits() == second.exponent.to_bits() => {
                let coefficient = law.coefficient + second.coefficient;
                Self::Power(PowerLaw { coefficient, ..law })
            }
            _ if second.is_absent() => {
                let spring = Self::Curve(Arc::new(curve()));
                let has_force = !spring.is_slack(f64::NEG_INFINITY, f64::INFINITY);
                if has_force { spring } else { Self::NONE }
            }
            _ => Self::Curve(Arc::new(curve().parallel(&Curve::power(second)))),
        }
    }

    /// Adds an elastic stop in parallel: its stiffness, N/m, acts beyond a displacement, m.
    #[must_use]
    pub fn beside_stop(&self, at_m: f64, stiffness_n_m: f64) -> Self {
        let line = |slope_n_m| Piece::line(at_m, 0.0, slope_n_m);
        let laws = vec![(f64::NEG_INFINITY, line(0.0)), (at_m, line(stiffness_n_m))];
        self.beside(&Curve::new(laws, larger(at_m.abs(), SCALE_M)))
    }

    /// Adds a constant force in parallel, N. The minimum of the energy up to the displacement `end_m`, m (infinite without an end), is
    /// zero.
    #[must_use]
    pub fn beside_force(&self, force_n: f64, end_m: f64) -> Self {
        let line = Piece::line(0.0, force_n, 0.0);
        let begins = [f64::NEG_INFINITY, end_m].into_iter().filter(|at_m| *at_m < f64::INFINITY);
        let laws = begins.map(|at_m| (at_m, line.clone())).collect();
        let scale_m = if end_m.is_finite() { end_m.abs() } else { 0.0 };
        self.beside(&Curve::new(laws, larger(scale_m, SCALE_M)))
    }

    fn beside(&self, other: &Curve) -> Self {
        Self::Curve(Arc::new(match self {
            Self::Power(law) => Curve::power(*law).parallel(other),
            Self::Curve(curve) => curve.parallel(other),
        }))
    }

    /// Returns the power law; `None` for a curve.
    pub fn power(&self) -> Option<PowerLaw> {
        if let Self::Power(law) = self { Some(*law) } else { None }
    }

    /// Returns the knots, increasing, m; for a power law zero, unless it is analytic there.
    pub(super) fn knots_m(&self) -> &[f64] {
        match self {
            Self::Power(law) if law.is_smooth_at_zero() => &[],
            Self::Power(_) => &[0.0],
            Self::Curve(curve) => &curve.knots_m,
        }
    }

    /// Returns the stations of the spring and its characteristic length, m.
    fn stations_m(&self) -> (&[f64], f64) {
        match self {
            Self::Power(_) => (&[0.0], SCALE_M),
            Self::Curve(curve) => (&curve.stations_m, curve.scale_m),
        }
    }

    /// Returns the index of the piece at x; a knot belongs to the piece above it.
    pub fn stretch(&self, x: f64) -> usize {
        curve::stretch(self.knots_m(), x)
    }

    /// Returns the ends of a piece, m; infinite at the ends of the law.
    pub fn ends(&self, stretch: usize) -> (f64, f64) {
        curve::ends(self.knots_m(), stretch)
    }

    /// Returns the force at x by the law of a piece, also slightly beyond its ends, N.
    pub fn force_in(&self, stretch: usize, x: f64) -> f64 {
        match self {
            Self::Power(law) => law.force_on(if stretch == 0 { -1.0 } else { 1.0 }, x),
            Self::Curve(curve) => curve.pieces[stretch].force(x),
        }
    }

    /// Returns the sum of the magnitudes of the terms of [`force_in`](Self::force_in), N, whose rounding the force has.
    pub fn terms_in_n(&self, stretch: usize, x: f64) -> f64 {
        match self {
            Self::Power(_) => self.force_in(stretch, x).abs(),
            Self::Curve(curve) => curve.pieces[stretch].terms_n(x),
        }
    }

    /// Returns the stiffness at x by the law of a piece, N/m.
    pub fn tangent_in(&self, stretch: usize, x: f64) -> f64 {
        match self {
            Self::Power(law) => law.tangent(x),
            Self::Curve(curve) => curve.pieces[stretch].tangent(x),
        }
    }

    /// Returns `true` if the stiffness at zero is infinite.
    pub fn is_steep_at_zero(&self) -> bool {
        match self {
            Self::Power(law) => law.is_steep_at_zero(),
            Self::Curve(curve) => curve.pieces[self.stretch(0.0)].is_steep_at_zero(),
        }
    }

    /// Returns `true` if the law is one analytic function.
    pub fn is_analytic(&self) -> bool {
        self.knots_m().is_empty()
    }

    /// Returns `true` for a law without force.
    pub fn is_absent(&self) -> bool {
        self.power().is_some_and(PowerLaw::is_absent)
    }

    /// Returns the force at x, N.
    #[inline]
    pub fn force(&self, x: f64) -> f64 {
        match self {
            Self::Power(law) => law.force(x),
            Self::Curve(curve) => curve.pieces[self.stretch(x)].force(x),
        }
    }

    /// Returns the stiffness at x, N/m; at a knot that of the piece above.
    pub fn tangent(&self, x: f64) -> f64 {
        self.tangent_in(self.stretch(x), x)
    }

    /// Returns the energy stored at x, J; its minimum is 0.
    #[inline]
    pub fn energy(&self, x: f64) -> f64 {
        match self {
            Self::Power(law) => law.integral(x),
            Self::Curve(curve) => curve.energy_in(self.stretch(x), x),
        }
    }

    /// Returns the maximum energy stored between two displacements, J; an infinite one is that of a plate which the spring does not stop.
    pub fn greatest_energy(&self, from_m: f64, to_m: f64) -> f64 {
        let (low, high) = if from_m < to_m { (from_m, to_m) } else { (to_m, from_m) };
        let inside = self.stations_m().0.iter().copied().filter(|x| (low..=high).contains(x));
        inside
            .chain([low, high])
            .filter(|x| x.is_finite())
            .map(|x| self.energy(x))
            .fold(0.0, larger)
    }

    /// Returns the minimum energy stored between two displacements, J; minus infinity if it decreases without bound.
    pub fn least_energy(&self, low_m: f64, high_m: f64) -> f64 {
        let inside = self.stations_m().0.iter().copied().filter(|x| (low_m..=high_m).contains(x));
        let ends = [low_m, high_m].into_iter().filter(|x| x.is_finite());
        let falls = [low_m, high_m]
            .iter()
            .any(|end| end.is_infinite() && sign(*end) * self.force_towards(*end) < 0.0);
        let lowest = if falls { f64::NEG_INFINITY } else { f64::INFINITY };
        inside.chain(ends).map(|x| self.energy(x)).fold(lowest, smaller)
    }

    /// Returns the displacement that a plate reaches from x with a total energy, forward (1) or backward (-1), m; infinite if the spring
    /// does not stop it.
    #[inline]
    pub fn reach(&self, x: f64, energy_j: f64, direction: f64) -> f64 {
        if let Self::Power(law) = self {
            return direction * law.at_integral(energy_j);
        }
        let missing = |x: f64| self.energy(x) - energy_j;
        self.first_place(x, direction, |missing| missing > 0.0, missing)
    }

    /// Returns the first position from x in a direction at which a function, monotone between stations, becomes zero; x if it is already
    /// past zero (`is_past`), infinite if it has no zero.
    fn first_place(
        &self,
        x: f64,
        direction: f64,
        is_past: impl Fn(f64) -> bool,
        function: impl Fn(f64) -> f64,
    ) -> f64 {
        let (stations_m, scale_m) = self.stations_m();
        let is_ahead = |at: &f64| direction * (at - x) > 0.0;
        let mut ahead: Vec<f64> = stations_m.iter().copied().filter(is_ahead).collect();
        ahead.sort_by(|a, b| (direction * a).total_cmp(&(direction * b)));
        let last = ahead.last().copied().unwrap_or(x);
        // Distances 1, 3, 7, ... in characteristic lengths.
        let beyond = (1..=DOUBLINGS).map(|i| last + direction * scale_m * (2f64.powi(i) - 1.0));
        let mut from = x;
        for to in ahead.into_iter().chain(beyond) {
            if is_past(function(to)) {
                return if function(from) >= 0.0 {
                    from
                } else if from == 0.0 && self.is_steep_at_zero() {
                    // Near a singular zero the root is bracketed in the logarithm of the position.
                    let log = |l: f64| function(direction * l.exp());
                    direction
                        * bracketed_root(f64::MIN_POSITIVE.ln(), (direction * to).ln(), log).exp()
                } else {
                    bracketed_root(from, to, function)
                };
            }
            from = to;
        }
        direction * f64::INFINITY
    }

    /// Returns the next equilibrium in forward direction for a plate that is driven forward at x, m; x if it is not, infinite without an
    /// equilibrium.
    pub fn rest_ahead(&self, x: f64) -> f64 {
        let force = |x: f64| self.force(x);
        if force(x) >= 0.0 {
            return x;
        }
        self.first_place(x, 1.0, |force| force >= 0.0, force)
    }

    /// Returns the direction, 1 or -1, in which the spring drives the plate without bound from x: beyond the end of a table with a force
    /// away from zero.
    pub fn drives_away(&self, x: f64) -> Option<f64> {
        let outward = -sign(self.force(x));
        let ahead = self.stations_m().0.iter().any(|station| outward * (station - x) > 0.0);
        let for_ever =
            outward != 0.0 && !ahead && self.reach(x, self.energy(x), outward).is_infinite();
        for_ever.then_some(outward)
    }

    /// Returns the smallest positive displacement with a given force, m; infinite if there is none.
    pub fn at_force(&self, force_n: f64) -> f64 {
        if let Self::Power(law) = self {
            return law.at_force(force_n);
        }
        let missing = |x: f64| self.force(x) - force_n.abs();
        self.first_place(0.0, 1.0, |missing| missing >= 0.0, missing)
    }

    /// Returns minimum and maximum of the force between two displacements, zero included, N; infinite if unbounded.
    pub fn forces_between(&self, low_m: f64, high_m: f64) -> (f64, f64) {
        if let Self::Power(law) = self {
            return (smaller(law.force(low_m), 0.0), larger(law.force(high_m), 0.0));
        }
        let inside = self.stations_m().0.iter().filter(|x| (low_m..=high_m).contains(*x));
        let ends = [low_m, high_m].map(|x| self.force_towards(x)).into_iter();
        ends.chain(inside.map(|x| self.force(*x)))
            .fold((0.0, 0.0), |(least, most), it| (smaller(it, least), larger(it, most)))
    }

    /// Returns `true` if the force is zero between two displacements.
    pub fn is_slack(&self, low_m: f64, high_m: f64) -> bool {
        self.forces_between(low_m, high_m) == (0.0, 0.0)
    }

    /// Returns the displacement up to which the force is zero from x on, m; x if it is none there.
    pub fn slack_until(&self, x: f64) -> f64 {
        let stations = self.stations_m().0.iter().copied().filter(|station| *station > x);
        let places = stations.chain([f64::INFINITY]);
        places.take_while(|place| self.is_slack(x, *place)).last().unwrap_or(x)
    }

    /// Returns the force at x, or its limit for infinite x, N.
    fn force_towards(&self, x: f64) -> f64 {
        if x.is_finite() {
            return self.force(x);
        }
        let (stations_m, scale_m) = self.stations_m();
        let edge = if x > 0.0 { stations_m.last() } else { stations_m.first() };
        let far = edge.copied().unwrap_or(0.0) + sign(x) * scale_m;
        let tangent = self.tangent(far);
        if tangent == 0.0 { self.force(far) } else { tangent * x }
    }
}
