//! A force law of any shape: analytic pieces between knots, with what a run needs to know of it in advance.

use crate::model::mechanism::PowerLaw;
use crate::model::mechanism::piece::Piece;
use crate::numerics::larger;
use crate::numerics::root::bracketed_root;

/// Sampling points within each stretch at which the sign of the force, or of its tangent, is compared.
const LOOKS: usize = 64;
/// Length of an infinite stretch that is sampled evenly, in sizes of the law.
const FAR: f64 = 20.0;
/// Doublings of that length at which an infinite stretch is sampled further: a straight end may have its zero far out.
const DOUBLINGS: i32 = 32;

/// A length for a law that has none, m: a plate's travel, about.
pub(super) const SCALE_M: f64 = 1e-3;

/// A force law over all displacements.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Rising, m.
    pub(super) knots_m: Vec<f64>,
    /// Between the knots, one more than those: the first goes to minus, the last to plus infinity.
    pub(super) pieces: Vec<Piece>,
    /// Integration constants of the pieces' energies, J: the sum is continuous, and zero at the lowest point.
    offsets_j: Vec<f64>,
    /// Knots, zeros of the force and where it turns, rising: energy and force rise or fall all the way between two of them, m.
    pub(super) stations_m: Vec<f64>,
    /// A length that the law is made of, m.
    pub(super) scale_m: f64,
}

impl Curve {
    /// A law of pieces, each from where it begins, rising; the first goes to minus infinity. `scale_m` > 0 is a length it is made of.
    pub fn new(laws: Vec<(f64, Piece)>, scale_m: f64) -> Self {
        let (begins, pieces): (Vec<f64>, Vec<Piece>) = laws.into_iter().unzip();
        let mut curve = Self {
            knots_m: begins[1..].to_vec(),
            offsets_j: vec![0.0; pieces.len()],
            stations_m: Vec::new(),
            scale_m,
            pieces,
        };
        for (at, knot) in curve.knots_m.iter().enumerate() {
            let reached = curve.energy_in(at, *knot);
            curve.offsets_j[at + 1] = reached - curve.pieces[at + 1].energy(*knot);
        }
        let mut stations = curve.changes(Piece::force);
        stations.extend_from_slice(&curve.knots_m);
        let energies = stations.iter().map(|x| curve.energy_in(stretch(&curve.knots_m, *x), *x));
        let lowest = energies.min_by(f64::total_cmp).unwrap_or(0.0);
        for offset in &mut curve.offsets_j {
            *offset -= lowest;
        }
        stations.extend(curve.changes(Piece::tangent));
        stations.sort_by(f64::total_cmp);
        stations.dedup();
        curve.stations_m = stations;
        curve
    }

    /// The odd law whose positive side has these pieces, each from where it begins; the first begins at 0.
    pub(super) fn odd(laws: &[(f64, Piece)], scale_m: f64) -> Self {
        let begins = laws.iter().skip(1).rev().map(|(from_m, _)| -from_m);
        let mirrored = laws.iter().rev().map(|(_, piece)| piece.mirrored());
        let behind = [f64::NEG_INFINITY].into_iter().chain(begins).zip(mirrored);
        let mut both: Vec<(f64, Piece)> = behind.chain(laws.iter().cloned()).collect();
        // Where the first piece is its own mirror image zero is no knot.
        both.dedup_by(|ahead, behind| ahead.1 == behind.1);
        Self::new(both, scale_m)
    }

    /// A power law, to be combined with others: a piece on either side of zero, or one where it goes smoothly through it.
    pub(super) fn power(law: PowerLaw) -> Self {
        let mut laws = vec![(f64::NEG_INFINITY, Piece::Power { law, side: -1.0 })];
        if !law.is_smooth_at_zero() {
            laws.push((0.0, Piece::Power { law, side: 1.0 }));
        }
        Self::new(laws, SCALE_M)
    }

    /// Combines two laws in parallel: equal displacement, added forces.
    #[must_use]
    pub fn parallel(&self, other: &Self) -> Self {
        let mut begins = [&[f64::NEG_INFINITY], &self.knots_m[..], &other.knots_m].concat();
        begins.sort_by(f64::total_cmp);
        begins.dedup();
        let at = |curve: &Self, from_m| curve.pieces[stretch(&curve.knots_m, from_m)].clone();
        let both = |from_m| Piece::Parallel(Box::new([at(self, from_m), at(other, from_m)]));
        let laws = begins.into_iter().map(|from_m| (from_m, both(from_m))).collect();
        Self::new(laws, larger(self.scale_m, other.scale_m))
    }

    /// Energy stored at x by the law of a stretch, J: zero at the lowest point.
    pub(super) fn energy_in(&self, stretch: usize, x: f64) -> f64 {
        self.pieces[stretch].energy(x) + self.offsets_j[stretch]
    }

    /// Places where a function of the pieces changes sign, in no order, m.
    fn changes(&self, f: impl Fn(&Piece, f64) -> f64) -> Vec<f64> {
        let mut found = Vec::new();
        for (region, piece) in self.pieces.iter().enumerate() {
            for (i, pair) in self.looks_m(region).windows(2).enumerate() {
                let (a, b) = (pair[0], pair[1]);
                let (fa, fb) = (f(piece, a), f(piece, b));
                if fa == 0.0 && fb != 0.0 && i > 0 {
                    found.push(a);
                } else if (fa > 0.0 && fb < 0.0) || (fa < 0.0 && fb > 0.0) {
                    found.push(bracketed_root(a, b, |x| f(piece, x)));
                }
            }
        }
        found
    }

    /// Sampling points of a stretch, rising, m.
    fn looks_m(&self, stretch: usize) -> Vec<f64> {
        let far = FAR * self.scale_m;
        let (below, above) = ends(&self.knots_m, stretch);
        // Finite ends of the even part in place of the infinite ones.
        let (low, high) = match (below, above) {
            (f64::NEG_INFINITY, f64::INFINITY) => (-far, far),
            (f64::NEG_INFINITY, high) => (high - far, high),
            (low, f64::INFINITY) => (low, low + far),
            both => both,
        };
        let beyond =
            |is_open: bool| (1..=if is_open { DOUBLINGS } else { 0 }).map(|i| far * 2f64.powi(i));
        let before = beyond(below.is_infinite()).rev().map(|more| low - more);
        let even = (0..=LOOKS).map(|i| low + (high - low) * i as f64 / LOOKS as f64);
        let after = beyond(above.is_infinite()).map(|more| high + more);
        before.chain(even).chain(after).collect()
    }
}

/// The stretch between rising knots that x lies in; a knot belongs to the stretch above it.
pub(super) fn stretch(knots_m: &[f64], x: f64) -> usize {
    knots_m.partition_point(|knot| *knot <= x)
}

/// The ends of a stretch, m; infinite at either end of the law.
pub(super) fn ends(knots_m: &[f64], stretch: usize) -> (f64, f64) {
    let below = if stretch == 0 { f64::NEG_INFINITY } else { knots_m[stretch - 1] };
    (below, knots_m.get(stretch).copied().unwrap_or(f64::INFINITY))
}
