//! Published problems with known fronts: E. Zitzler, K. Deb and L. Thiele, *Evolutionary Computation* 8 (2000) 173-195, and the
//! constrained problem CONSTR of Deb's book.

use std::f64::consts::PI;

use super::*;

const EFFORT: EvolutionOptions = EvolutionOptions { population: 100, generations: 250, seed: 1 };
/// Where hypervolume is measured from.
const CORNER: (f64, f64) = (1.1, 1.1);

fn solve(
    inputs: usize,
    effort: EvolutionOptions,
    f: impl Fn(&[f64]) -> (Vec<f64>, f64),
) -> Vec<Individual<()>> {
    let judge = |x: &Vec<f64>| {
        let (objectives, violation) = f(x);
        (Judged { objectives, violation }, ())
    };
    let function: Function<'_, ()> = &mut |points| Some(points.iter().map(judge).collect());
    front(&evolve(inputs, &[], effort, function, &mut |_, _| {}))
}

fn points(front: &[Individual<()>]) -> Vec<(f64, f64)> {
    let of = |one: &Individual<()>| (one.judged.objectives[0], one.judged.objectives[1]);
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

fn zdt(x: &[f64], shape: impl Fn(f64, f64) -> f64) -> (Vec<f64>, f64) {
    let g = 1.0 + 9.0 * x[1..].iter().sum::<f64>() / (x.len() - 1) as f64;
    (vec![x[0], g * shape(x[0], g)], 0.0)
}

fn drawn(shape: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    (0..=20_000).map(|i| f64::from(i) / 20_000.0).map(|x| (x, shape(x))).collect()
}

#[test]
fn valid_front_of_zdt1() {
    let found = points(&solve(30, EFFORT, |x| zdt(x, |x, g| 1.0 - (x / g).sqrt())));
    assert!(found.len() > 80, "{}", found.len());
    assert!(distance(&found, &drawn(|x| 1.0 - x.sqrt())) < 3e-3);
    // 0.1 + 2/3 under the front, and the strip beyond f1 = 1.
    let exact = 0.1 + 2.0 / 3.0 + 0.11;
    let volume = hypervolume(&found);
    assert!(volume < exact && volume > 0.99 * exact, "{volume} {exact}");
    assert!(found[0].0 < 0.01 && found[found.len() - 1].0 > 0.99);
}

#[test]
fn valid_front_of_zdt2() {
    let found = points(&solve(30, EFFORT, |x| zdt(x, |x, g| 1.0 - (x / g).powi(2))));
    assert!(distance(&found, &drawn(|x| 1.0 - x * x)) < 3e-3);
    let exact = 0.1 + 1.0 / 3.0 + 0.11;
    let volume = hypervolume(&found);
    assert!(volume < exact && volume > 0.98 * exact, "{volume} {exact}");
}

/// Five separate pieces: what is dominated of 1 - sqrt x - x sin(10 pi x) is taken out of the drawn curve.
#[test]
fn valid_front_of_zdt3() {
    let shape = |x: f64, g: f64| 1.0 - (x / g).sqrt() - x / g * (10.0 * PI * x).sin();
    let found = points(&solve(30, EFFORT, |x| zdt(x, shape)));
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
    let found = points(&solve(2, EFFORT, |s| {
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

#[test]
fn a_seed_gives_its_digits_and_another_others() {
    let effort = EvolutionOptions { population: 20, generations: 10, seed: 7 };
    let with = |seed| {
        solve(3, EvolutionOptions { seed, ..effort }, |x| zdt(x, |x, g| 1.0 - (x / g).sqrt()))
    };
    assert_eq!(with(7), with(7));
    assert_ne!(with(7), with(8));
}

#[test]
fn points_without_a_value_lose_and_a_stop_keeps_the_last_generation() {
    let holes = solve(2, EvolutionOptions { generations: 40, ..EFFORT }, |x| {
        let violation = if x[0] > 0.5 { f64::INFINITY } else { 0.0 };
        (vec![x[1] - x[0]], violation)
    });
    assert_eq!(holes.len(), 1);
    assert!((holes[0].shares[0] - 0.5).abs() < 1e-3 && holes[0].shares[1] < 1e-3);
    let mut calls = 0;
    let function: Function<'_, ()> = &mut |points| {
        calls += 1;
        let judge = |x: &Vec<f64>| (Judged { objectives: vec![x[0]], violation: 0.0 }, ());
        (calls < 4).then(|| points.iter().map(judge).collect())
    };
    let mut generations = 0;
    let kept = evolve(1, &[vec![0.25]], EFFORT, function, &mut |at, _| generations = at);
    assert_eq!((kept.len(), generations), (100, 2));
}
