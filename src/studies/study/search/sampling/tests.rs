//! Published problems with known fronts: E. Zitzler, K. Deb and L. Thiele, *Evolutionary Computation* 8 (2000) 173-195, and the
//! constrained problem CONSTR of Deb's book.

use std::f64::consts::PI;

use super::*;

const EVALUATIONS: usize = 1 << 14;
/// Where hypervolume is measured from.
const CORNER: (f64, f64) = (1.1, 1.1);

fn solve(inputs: usize, f: impl Fn(&[f64]) -> (Vec<f64>, f64)) -> Vec<Sample<()>> {
    let judge = |x: &Vec<f64>| {
        let (objectives, violation) = f(x);
        (Evaluation { objectives, violation }, ())
    };
    let function: Function<'_, ()> = &mut |points, _| Some(points.iter().map(judge).collect());
    let best = search(inputs, None, EVALUATIONS, function);
    front(&best).into_iter().cloned().collect()
}

fn points(front: &[Sample<()>]) -> Vec<(f64, f64)> {
    let of = |one: &Sample<()>| (one.judged.objectives[0], one.judged.objectives[1]);
    let mut points: Vec<(f64, f64)> = front.iter().map(of).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points
}

/// Area between a front, sorted by its first objective, and the corner.
fn hypervolume(points: &[(f64, f64)]) -> f64 {
    let (mut area, mut lowest) = (0.0, CORNER.1);
    for (x, y) in points {
        if *x < CORNER.0 && *y < lowest {
            area += (CORNER.0 - x) * (lowest - y);
            lowest = *y;
        }
    }
    area
}

/// Mean distance of the points to the nearest of a finely drawn front.
fn distance(points: &[(f64, f64)], exact: &[(f64, f64)]) -> f64 {
    let nearest = |(x, y): &(f64, f64)| {
        exact.iter().map(|(a, b)| (x - a).hypot(y - b)).fold(f64::INFINITY, f64::min)
    };
    points.iter().map(nearest).sum::<f64>() / points.len() as f64
}

fn drawn(shape: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    (0..=20_000).map(|i| f64::from(i) / 20_000.0).map(|x| (x, shape(x))).collect()
}

/// Five separate pieces: what is dominated of 1 - sqrt x - x sin(10 pi x) is taken out of the drawn curve.
#[test]
fn valid_front_of_zdt3() {
    let shape = |x: f64, g: f64| 1.0 - (x / g).sqrt() - x / g * (10.0 * PI * x).sin();
    let found = points(&solve(4, |x| {
        let g = 1.0 + 9.0 * x[1..].iter().sum::<f64>() / (x.len() - 1) as f64;
        (vec![x[0], g * shape(x[0], g)], 0.0)
    }));
    let mut exact = Vec::new();
    let mut lowest = f64::INFINITY;
    for (x, y) in drawn(|x| shape(x, 1.0)) {
        if y < lowest {
            lowest = y;
            exact.push((x, y));
        }
    }
    assert!(distance(&found, &exact) < 3e-3);
    let (volume, exact) = (hypervolume(&found), hypervolume(&exact));
    assert!(volume <= exact && volume > 0.99 * exact, "{volume} {exact}");
    for piece in [(0.0, 0.083), (0.182, 0.258), (0.409, 0.454), (0.618, 0.653), (0.823, 0.852)] {
        assert!(found.iter().any(|(x, _)| (piece.0..=piece.1).contains(x)), "{piece:?}");
    }
}

/// CONSTR: f1 = x, f2 = (1 + y)/x with y + 9x >= 6 and 9x - y >= 1; the front is (7 - 9 f1)/f1 up to f1 = 2/3, then 1/f1.
#[test]
fn valid_front_of_a_constrained_problem() {
    let found = points(&solve(2, |s| {
        let (x, y) = (0.1 + 0.9 * s[0], 5.0 * s[1]);
        let violation = (6.0 - y - 9.0 * x).max(0.0) + (1.0 + y - 9.0 * x).max(0.0);
        (vec![x, (1.0 + y) / x], violation)
    }));
    assert!(found.len() > 80);
    let exact = |f1: f64| if f1 < 2.0 / 3.0 { (7.0 - 9.0 * f1) / f1 } else { 1.0 / f1 };
    for (f1, f2) in &found {
        assert!(*f1 > 7.0 / 18.0 - 1e-9 && f2 - exact(*f1) > -1e-9, "{f1} {f2}");
    }
    let drawn: Vec<(f64, f64)> =
        drawn(exact).into_iter().filter(|(x, _)| *x > 7.0 / 18.0).collect();
    // Its height is 8.
    assert!(distance(&found, &drawn) < 0.01, "{}", distance(&found, &drawn));
    assert!(found[0].0 < 0.4 && found[found.len() - 1].0 > 0.99);
}

/// Problem g06 of the constrained test suite: optimum -6961.81388 at (14.095, 0.84296), in a sliver between two circles.
#[test]
fn valid_optimum_of_g06() {
    let found = solve(2, |fractions| {
        let (x, y) = (13.0 + 87.0 * fractions[0], 100.0 * fractions[1]);
        let outside = 100.0 - (x - 5.0).powi(2) - (y - 5.0).powi(2);
        let inside = (x - 6.0).powi(2) + (y - 5.0).powi(2) - 82.81;
        (vec![(x - 10.0).powi(3) + (y - 20.0).powi(3)], outside.max(0.0) + inside.max(0.0))
    });
    let value = found[0].judged.objectives[0];
    assert!(found.len() == 1 && (-6_961.82..-6_900.0).contains(&value), "{found:?}");
}

#[test]
fn points_without_a_value_lose_and_a_stop_keeps_the_round_before() {
    let holes = solve(2, |x| {
        let violation = if x[0] > 0.5 { f64::INFINITY } else { 0.0 };
        (vec![x[1] - x[0]], violation)
    });
    assert_eq!(holes.len(), 1);
    assert!((holes[0].fractions[0] - 0.5).abs() < 1e-3 && holes[0].fractions[1] < 1e-3);
    let mut calls = 0;
    let function: Function<'_, ()> = &mut |points, _| {
        calls += 1;
        let judge = |x: &Vec<f64>| (Evaluation { objectives: vec![x[0]], violation: 0.0 }, ());
        (calls < 2).then(|| points.iter().map(judge).collect())
    };
    let kept = search(1, Some(vec![0.25]), 80, function);
    // The first twenty points of the sequence, one of them on the bound.
    assert!(kept.len() == KEPT_LEAST && front(&kept)[0].fractions == [0.0], "{kept:?}");
}
