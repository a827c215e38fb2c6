//! Piecewise analytic force law between knots, with precomputed energies, zeros and extrema.

use crate::model::mechanism::piece::Piece;
use crate::model::power_law::PowerLaw;
use crate::numerics::larger;
use crate::numerics::root::bracketed_root;

/// Number of sampling points within a piece for sign changes of the force and its derivative.
const LOOKS: usize = 64;
/// Length of an infinite piece that is sampled evenly, in characteristic lengths.
const FAR: f64 = 20.0;
/// Number of doublings of that length for further sampling points; a linear end can have a distant zero.
const DOUBLINGS: i32 = 32;

/// Default characteristic length, m: a typical displacement of a plate.
pub(super) const SCALE_M: f64 = 1e-3;

/// Force law for all displacements.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Knots, increasing, m.
    pub(super) knots_m: Vec<f64>,
    /// Pieces between the knots; the first and the last one are infinite.
    pub(super) pieces: Vec<Piece>,
    /// Integration constants of the energies of the pieces, J; the energy is continuous, with minimum 0.
    offsets_j: Vec<f64>,
    /// Stations: knots, zeros and extrema of the force, increasing, m. Energy and force are monotone between two stations.
    pub(super) stations_m: Vec<f64>,
    /// Characteristic length of the law, m.
    pub(super) scale_m: f64,
}

impl Curve {
    /// Creates a law from pieces with their lower ends, increasing; that of the first is minus infinity. `scale_m` > 0 is the
    /// characteristic length.
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

    /// Creates an odd law from the pieces of its positive side with their lower ends; that of the first is 0.
    pub(super) fn odd(laws: &[(f64, Piece)], scale_m: f64) -> Self {
        let begins = laws.iter().skip(1).rev().map(|(from_m, _)| -from_m);
        let mirrored = laws.iter().rev().map(|(_, piece)| piece.mirrored());
        let behind = [f64::NEG_INFINITY].into_iter().chain(begins).zip(mirrored);
        let mut both: Vec<(f64, Piece)> = behind.chain(laws.iter().cloned()).collect();
        // Zero is not a knot if the first piece is odd.
        both.dedup_by(|ahead, behind| ahead.1 == behind.1);
        Self::new(both, scale_m)
    }

    /// Creates a power law: a piece on each side of zero, or one piece if it is analytic at zero.
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

    /// Returns the energy at x by the law of a piece, J.
    pub(super) fn energy_in(&self, stretch: usize, x: f64) -> f64 {
        self.pieces[stretch].energy(x) + self.offsets_j[stretch]
    }

    /// Returns the positions of sign changes of a function of the pieces, unsorted, m.
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

    /// Returns the sampling points of a piece, increasing, m.
    fn looks_m(&self, stretch: usize) -> Vec<f64> {
        let far = FAR * self.scale_m;
        let (below, above) = ends(&self.knots_m, stretch);
        // Ends of the evenly sampled part of an infinite piece.
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

/// Returns the index of the piece at x; a knot belongs to the piece above it.
pub(super) fn stretch(knots_m: &[f64], x: f64) -> usize {
    knots_m.partition_point(|knot| *knot <= x)
}

/// Returns the ends of a piece, m; infinite at the ends of the law.
pub(super) fn ends(knots_m: &[f64], stretch: usize) -> (f64, f64) {
    let below = if stretch == 0 { f64::NEG_INFINITY } else { knots_m[stretch - 1] };
    (below, knots_m.get(stretch).copied().unwrap_or(f64::INFINITY))
}
