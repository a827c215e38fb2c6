//! The spring as a run sees it: a power law, or a curve of any shape.
//!
//! A power law has closed forms, and a compiled path of its own: the choice costs one comparison. All else is found from the knots and
//! the stations of either: between two stations the energy only rises or only falls.

use std::sync::Arc;

use crate::model::mechanism::curve::{self, Curve, SCALE_M};
use crate::model::mechanism::piece::Piece;
use crate::model::mechanism::{PowerLaw, sign};
use crate::model::scene;
use crate::numerics::root::bracketed_root;
use crate::numerics::{larger, smaller};

/// Doublings on the way to where an energy ends, or a force is reached, beyond the last knot.
const DOUBLINGS: i32 = 80;

/// The force law of all springs together.
#[derive(Clone, Debug, PartialEq)]
pub enum Spring {
    /// Power law; absent if its coefficient is zero.
    Power(PowerLaw),
    /// Any other law.
    Curve(Arc<Curve>),
}

impl Spring {
    /// No spring.
    pub const NONE: Self = Self::Power(PowerLaw::NONE);

    /// The law of a valid scene's mechanism, whatever the mount, after an absorber was crushed up to a displacement, m.
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

    /// Adds a constant force in parallel, N, of a plate that goes to an end at most, m; infinite without one. The energy is zero at the lowest
    /// point up to there.
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

    /// The power law, where it is one.
    pub fn power(&self) -> Option<PowerLaw> {
        if let Self::Power(law) = self { Some(*law) } else { None }
    }

    /// The ends of its analytic stretches, rising, m: of a power law zero, or none where it goes smoothly through that.
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

    /// The stretch in which x lies; its end belongs to the stretch above it.
    pub fn stretch(&self, x: f64) -> usize {
        curve::stretch(self.knots_m(), x)
    }

    /// The ends of a stretch, m; infinite where it has none.
    pub fn ends(&self, stretch: usize) -> (f64, f64) {
        curve::ends(self.knots_m(), stretch)
    }

    /// Force at x by the law of a stretch, which goes on a little beyond its ends, N.
    pub fn force_in(&self, stretch: usize, x: f64) -> f64 {
        match self {
            Self::Power(law) => law.force_on(if stretch == 0 { -1.0 } else { 1.0 }, x),
            Self::Curve(curve) => curve.pieces[stretch].force(x),
        }
    }

    /// dF/dx at x by the law of a stretch, N/m.
    pub fn tangent_in(&self, stretch: usize, x: f64) -> f64 {
        match self {
            Self::Power(law) => law.tangent(x),
            Self::Curve(curve) => curve.pieces[stretch].tangent(x),
        }
    }

    /// Whether it is infinitely steep at zero.
    pub fn is_steep_at_zero(&self) -> bool {
        match self {
            Self::Power(law) => law.is_steep_at_zero(),
            Self::Curve(curve) => curve.pieces[self.stretch(0.0)].is_steep_at_zero(),
        }
    }

    /// Whether the law is one analytic function for all displacements.
    pub fn is_analytic(&self) -> bool {
        self.knots_m().is_empty()
    }

    /// Whether there is no spring at all.
    pub fn is_absent(&self) -> bool {
        self.power().is_some_and(PowerLaw::is_absent)
    }

    /// Force at x, N.
    #[inline]
    pub fn force(&self, x: f64) -> f64 {
        match self {
            Self::Power(law) => law.force(x),
            Self::Curve(curve) => curve.pieces[self.stretch(x)].force(x),
        }
    }

    /// dF/dx at x, N/m; above a knot at a knot.
    pub fn tangent(&self, x: f64) -> f64 {
        self.tangent_in(self.stretch(x), x)
    }

    /// Energy stored at x, J: zero at the lowest point.
    #[inline]
    pub fn energy(&self, x: f64) -> f64 {
        match self {
            Self::Power(law) => law.integral(x),
            Self::Curve(curve) => curve.energy_in(self.stretch(x), x),
        }
    }

    /// The greatest energy stored between two displacements, J.
    pub fn greatest_energy(&self, from_m: f64, to_m: f64) -> f64 {
        let (low, high) = if from_m < to_m { (from_m, to_m) } else { (to_m, from_m) };
        let inside = self.stations_m().0.iter().copied().filter(|x| (low..=high).contains(x));
        inside.chain([low, high]).map(|x| self.energy(x)).fold(0.0, larger)
    }

    /// Where the plate can go from x with this much energy, motion and stored together, forward, 1, or back, -1, m; infinite where
    /// nothing holds it.
    #[inline]
    pub fn reach(&self, x: f64, energy_j: f64, way: f64) -> f64 {
        if let Self::Power(law) = self {
            return way * law.at_integral(energy_j);
        }
        let missing = |x: f64| self.energy(x) - energy_j;
        self.first_place(x, way, |missing| missing > 0.0, missing)
    }

    /// The first place on the way from x, past the stations ahead and on beyond them, where a function that is below zero before has
    /// risen to zero, as `is_past` says of its value; x itself where it has already, infinite where it never does.
    fn first_place(
        &self,
        x: f64,
        way: f64,
        is_past: impl Fn(f64) -> bool,
        function: impl Fn(f64) -> f64,
    ) -> f64 {
        let (stations_m, scale_m) = self.stations_m();
        let is_ahead = |at: &f64| way * (at - x) > 0.0;
        let mut ahead: Vec<f64> = stations_m.iter().copied().filter(is_ahead).collect();
        ahead.sort_by(|a, b| (way * a).total_cmp(&(way * b)));
        let last = ahead.last().copied().unwrap_or(x);
        // Steps that double: 1, 3, 7, ... sizes of the law.
        let beyond = (1..=DOUBLINGS).map(|i| last + way * scale_m * (2f64.powi(i) - 1.0));
        let mut from = x;
        for to in ahead.into_iter().chain(beyond) {
            if is_past(function(to)) {
                return if function(from) >= 0.0 {
                    from
                } else if from == 0.0 && self.is_steep_at_zero() {
                    // What a steep law does next to its zero is spread over the logarithm of the place.
                    let log = |l: f64| function(way * l.exp());
                    way * bracketed_root(f64::MIN_POSITIVE.ln(), (way * to).ln(), log).exp()
                } else {
                    bracketed_root(from, to, function)
                };
            }
            from = to;
        }
        way * f64::INFINITY
    }

    /// Where, ahead of x, nothing drives a plate forward any more that is driven so at x; x itself otherwise, infinite where nothing
    /// ends that, m.
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

    /// The least displacement forward at which the force is this, m; infinite where it never is.
    pub fn at_force(&self, force_n: f64) -> f64 {
        if let Self::Power(law) = self {
            return law.at_force(force_n);
        }
        let missing = |x: f64| self.force(x) - force_n.abs();
        self.first_place(0.0, 1.0, |missing| missing >= 0.0, missing)
    }

    /// The least and the greatest of zero and the forces between two displacements, N; infinite where it runs away on the way to an infinite one.
    pub fn forces_between(&self, low_m: f64, high_m: f64) -> (f64, f64) {
        if let Self::Power(law) = self {
            return (smaller(law.force(low_m), 0.0), larger(law.force(high_m), 0.0));
        }
        let inside = self.stations_m().0.iter().filter(|x| (low_m..=high_m).contains(*x));
        let ends = [low_m, high_m].map(|x| self.force_towards(x)).into_iter();
        ends.chain(inside.map(|x| self.force(*x)))
            .fold((0.0, 0.0), |(least, most), it| (smaller(it, least), larger(it, most)))
    }

    /// Whether there is no force between two displacements.
    pub fn is_slack(&self, low_m: f64, high_m: f64) -> bool {
        self.forces_between(low_m, high_m) == (0.0, 0.0)
    }

    /// The force at x, or what it goes to where x is infinite, N.
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
