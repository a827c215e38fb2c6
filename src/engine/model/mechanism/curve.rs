//! A force law of any shape: analytic pieces between knots, with what a run needs to know of it in advance: stored energy,
//! how far an energy carries the plate, and the greatest forces on the way.

use crate::model::mechanism::piece::Piece;
use crate::model::mechanism::sign;
use crate::numerics::larger;
use crate::numerics::root::in_bracket;

/// Places looked at within each stretch to find where the force, or its tangent, changes sign.
const LOOKS: usize = 64;
/// How far beyond the last knot zeros and extremes are sought, in sizes of the law.
const FAR: f64 = 20.0;
/// Doublings on the way to where an energy ends, or a force is reached, beyond the last knot.
const DOUBLINGS: i32 = 80;

/// A length for a law that has none, m: a plate's travel, about.
pub(super) const SCALE_M: f64 = 1e-3;

/// A force law over all displacements.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Rising, m.
    knots_m: Vec<f64>,
    /// Between the knots, one more than those: the first goes to minus, the last to plus infinity.
    pieces: Vec<Piece>,
    /// What each piece's energy lacks: continuous, and zero at the lowest point, J.
    offsets_j: Vec<f64>,
    /// Knots and zeros of the force, rising: the energy rises or falls all the way between two of them, m.
    stations_m: Vec<f64>,
    /// Where the force turns, m.
    extremes_m: Vec<f64>,
    /// A length that the law is made of, m.
    scale_m: f64,
    steep: bool,
}

impl Curve {
    /// A law of pieces between rising knots, one more than those; `scale_m` > 0 is a length it is made of.
    pub fn new(knots_m: Vec<f64>, pieces: Vec<Piece>, scale_m: f64) -> Self {
        let mut curve = Self {
            offsets_j: vec![0.0; pieces.len()],
            stations_m: Vec::new(),
            extremes_m: Vec::new(),
            scale_m,
            steep: pieces.iter().any(Piece::is_steep_at_zero),
            knots_m,
            pieces,
        };
        for (at, knot) in curve.knots_m.iter().enumerate() {
            let reached = curve.pieces[at].energy(*knot) + curve.offsets_j[at];
            curve.offsets_j[at + 1] = reached - curve.pieces[at + 1].energy(*knot);
        }
        let mut stations = curve.changes(Piece::force);
        stations.extend_from_slice(&curve.knots_m);
        stations.sort_by(f64::total_cmp);
        stations.dedup();
        curve.extremes_m = curve.changes(Piece::tangent);
        let lowest =
            stations.iter().map(|x| curve.energy(*x)).min_by(f64::total_cmp).unwrap_or(0.0);
        for offset in &mut curve.offsets_j {
            *offset -= lowest;
        }
        curve.stations_m = stations;
        curve
    }

    /// The odd law whose positive side has these pieces, each from where it begins; the first begins at 0.
    pub(super) fn odd(laws: &[(f64, Piece)], scale_m: f64) -> Self {
        let mirrored = laws.iter().rev().map(|(_, piece)| mirror(piece));
        let straight = straight_through_zero(&laws[0].1);
        let skip = usize::from(straight);
        let pieces: Vec<Piece> =
            mirrored.chain(laws.iter().skip(skip).map(|(_, piece)| piece.clone())).collect();
        let behind = laws.iter().skip(1).rev().map(|(from, _)| -from);
        let ahead = laws.iter().skip(skip).map(|(from, _)| *from);
        Self::new(behind.chain(ahead).collect(), pieces, scale_m)
    }

    /// It and another law, displaced alike: the forces add.
    #[must_use]
    pub fn parallel(&self, other: &Self) -> Self {
        let mut knots_m = [self.knots_m.as_slice(), &other.knots_m].concat();
        knots_m.sort_by(f64::total_cmp);
        knots_m.dedup();
        let begins = [f64::NEG_INFINITY].iter().chain(&knots_m);
        let at = |curve: &Self, begin: f64| curve.piece(curve.region(begin)).clone();
        let both = |begin: &f64| Piece::Parallel(Box::new([at(self, *begin), at(other, *begin)]));
        let pieces = begins.map(both).collect();
        Self::new(knots_m, pieces, larger(self.scale_m, other.scale_m))
    }

    /// The ends of its pieces, rising, m.
    pub fn knots_m(&self) -> &[f64] {
        &self.knots_m
    }

    /// The stretch that x lies in; a knot belongs to the stretch above it.
    pub fn region(&self, x: f64) -> usize {
        self.knots_m.partition_point(|knot| *knot <= x)
    }

    /// The same, but a knot belongs to the stretch below it.
    pub fn region_below(&self, x: f64) -> usize {
        self.knots_m.partition_point(|knot| *knot < x)
    }

    /// The ends of a stretch, m; infinite at either end of the law.
    pub fn ends(&self, region: usize) -> (f64, f64) {
        let knots = &self.knots_m;
        let below = if region == 0 { f64::NEG_INFINITY } else { knots[region - 1] };
        (below, knots.get(region).copied().unwrap_or(f64::INFINITY))
    }

    /// The analytic law of a stretch.
    pub fn piece(&self, region: usize) -> &Piece {
        &self.pieces[region]
    }

    /// Whether the law is infinitely steep at zero.
    pub fn is_steep_at_zero(&self) -> bool {
        self.steep
    }

    /// Force at x, N.
    pub fn force(&self, x: f64) -> f64 {
        self.piece(self.region(x)).force(x)
    }

    /// dF/dx at x, N/m; above a knot at a knot.
    pub fn tangent(&self, x: f64) -> f64 {
        self.piece(self.region(x)).tangent(x)
    }

    /// Energy stored at x, J: zero at the lowest point.
    pub fn energy(&self, x: f64) -> f64 {
        let region = self.region(x);
        self.piece(region).energy(x) + self.offsets_j[region]
    }

    /// Where the plate can go from x with this much energy, motion and stored together, forward, 1, or back, -1, m; infinite where
    /// nothing holds it.
    pub fn reach(&self, x: f64, energy_j: f64, way: f64) -> f64 {
        let missing = |x: f64| self.energy(x) - energy_j;
        let marks = ahead(&self.stations_m, x, way);
        self.first_place(x, way, marks, |x| missing(x) > 0.0, missing)
            .unwrap_or(way * f64::INFINITY)
    }

    /// The first place on the way from x, past these marks and on beyond them, where a function that is below zero before has
    /// risen to zero, as `is_past` says; x itself where it has already.
    fn first_place(
        &self,
        x: f64,
        way: f64,
        marks: Vec<f64>,
        is_past: impl Fn(f64) -> bool,
        function: impl Fn(f64) -> f64,
    ) -> Option<f64> {
        let last = marks.last().copied().unwrap_or(x);
        // Steps that double: 1, 3, 7, ... sizes of the law.
        let beyond = (1..=DOUBLINGS).map(|i| last + way * self.scale_m * (2f64.powi(i) - 1.0));
        let mut from = x;
        for to in marks.into_iter().chain(beyond) {
            if is_past(to) {
                return Some(if function(from) >= 0.0 {
                    from
                } else if from == 0.0 && self.steep {
                    // What a steep law does next to its zero is spread over the logarithm of the place.
                    let log = |l: f64| function(way * l.exp());
                    way * in_bracket(f64::MIN_POSITIVE.ln(), (way * to).ln(), log).exp()
                } else {
                    in_bracket(from, to, function)
                });
            }
            from = to;
        }
        None
    }

    /// Where, ahead of x, nothing drives a plate forward any more that is driven so at x; x itself otherwise, infinite where nothing
    /// ends that, m.
    pub fn rest_ahead(&self, x: f64) -> f64 {
        let marks = ahead(&self.stations_m, x, 1.0);
        let force = |x: f64| self.force(x);
        if force(x) >= 0.0 {
            return x;
        }
        self.first_place(x, 1.0, marks, |x| force(x) >= 0.0, force).unwrap_or(f64::INFINITY)
    }

    /// Which way, 1 or -1, the law drives the plate on from x for ever: beyond the end of a table whose force runs away.
    pub fn drives_away(&self, x: f64) -> Option<f64> {
        let outward = -sign(self.force(x));
        let ahead = self.stations_m.iter().any(|station| outward * (station - x) > 0.0);
        let for_ever =
            outward != 0.0 && !ahead && self.reach(x, self.energy(x), outward).is_infinite();
        for_ever.then_some(outward)
    }

    /// The greatest energy stored between two displacements, J.
    pub fn greatest_energy(&self, from_m: f64, to_m: f64) -> f64 {
        let (low, high) = if from_m < to_m { (from_m, to_m) } else { (to_m, from_m) };
        let inside = self.stations_m.iter().copied().filter(|x| (low..=high).contains(x));
        inside.chain([low, high]).map(|x| self.energy(x)).fold(0.0, larger)
    }

    /// The least and the greatest of zero and the forces between two displacements, N; infinite where it runs away on the way to an infinite one.
    pub fn forces_between(&self, low: f64, high: f64) -> (f64, f64) {
        let inside = |x: &&f64| (low..=high).contains(*x);
        let ends = [low, high].into_iter().map(|x| self.force_towards(x));
        let marks = self.stations_m.iter().chain(&self.extremes_m).filter(inside);
        ends.chain(marks.map(|x| self.force(*x))).fold((0.0, 0.0), |(least, most), force| {
            (if force < least { force } else { least }, larger(force, most))
        })
    }

    /// Whether there is no force between two displacements.
    pub fn is_slack(&self, low: f64, high: f64) -> bool {
        self.forces_between(low, high) == (0.0, 0.0)
    }

    /// The force at x, or what it goes to where x is infinite, N.
    fn force_towards(&self, x: f64) -> f64 {
        if x.is_finite() {
            return self.force(x);
        }
        let way = sign(x);
        let edge = if way > 0.0 { self.stations_m.last() } else { self.stations_m.first() };
        let far = edge.copied().unwrap_or(0.0) + way * self.scale_m;
        let tangent = self.tangent(far);
        if tangent == 0.0 { self.force(far) } else { tangent * x }
    }

    /// The least x ahead of zero at which the force is `force_n`; infinite where it never is.
    pub fn at_force(&self, force_n: f64) -> f64 {
        let missing = |x: f64| self.force(x) - force_n;
        let mut all: Vec<f64> = self.stations_m.iter().chain(&self.extremes_m).copied().collect();
        all.sort_by(f64::total_cmp);
        let marks = ahead(&all, 0.0, 1.0);
        let place = self.first_place(0.0, 1.0, marks, |x| missing(x) >= 0.0, missing);
        place.unwrap_or(f64::INFINITY)
    }

    /// Where a function of the pieces changes sign, rising order not promised, m.
    fn changes(&self, f: impl Fn(&Piece, f64) -> f64) -> Vec<f64> {
        let mut found = Vec::new();
        for (region, piece) in self.pieces.iter().enumerate() {
            let (low, high) = self.span(region);
            let place = |i: usize| low + (high - low) * i as f64 / LOOKS as f64;
            for i in 0..LOOKS {
                let (a, b) = (place(i), place(i + 1));
                let (fa, fb) = (f(piece, a), f(piece, b));
                if fa == 0.0 && i > 0 {
                    found.push(a);
                } else if (fa > 0.0 && fb < 0.0) || (fa < 0.0 && fb > 0.0) {
                    found.push(in_bracket(a, b, |x| f(piece, x)));
                }
            }
        }
        found
    }

    /// The ends of a stretch, finite ones in place of the infinite ones.
    fn span(&self, region: usize) -> (f64, f64) {
        let (low, high) = self.ends(region);
        let far = FAR * self.scale_m;
        match (low.is_finite(), high.is_finite()) {
            (true, true) => (low, high),
            (true, false) => (low, low + far),
            (false, true) => (high - far, high),
            (false, false) => (-far, far),
        }
    }
}

/// The places of a rising list that lie ahead of x, in their order on the way.
fn ahead(places_m: &[f64], x: f64, way: f64) -> Vec<f64> {
    if way > 0.0 {
        return places_m[places_m.partition_point(|at| *at <= x)..].to_vec();
    }
    places_m[..places_m.partition_point(|at| *at < x)].iter().rev().copied().collect()
}

/// Whether a piece is its own mirror image: then zero is not a knot.
fn straight_through_zero(piece: &Piece) -> bool {
    matches!(piece, Piece::Cubic { from_m, c } if *from_m == 0.0 && c[0] == 0.0 && c[2] == 0.0)
}

/// -F(-x) of a cubic.
fn mirror(piece: &Piece) -> Piece {
    match piece {
        Piece::Cubic { from_m, c } => {
            Piece::Cubic { from_m: -from_m, c: [-c[0], c[1], -c[2], c[3]] }
        }
        _ => piece.clone(),
    }
}
