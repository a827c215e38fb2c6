//! Figures 9.2 to 9.12: each preset holds what the caption says, and shows the trends section 9.3 describes.

use std::sync::Arc;

use cmra::files::preset;
use cmra::model::run::Outcome;
use cmra::model::scene::Scene;
use cmra::study::context::{Context, to_its_end};
use cmra::study::sweep::grid::{Grid, PIECE};
use cmra::study::sweep::{Plan, PointOutcome};

fn scene(figure: u32) -> Scene {
    preset::resolve(&format!("figure-9.{figure}"), None).unwrap().scene
}

/// The figure's sweep with a given number of points along every axis.
fn grid(figure: u32, count: usize) -> Grid {
    let mut scene = scene(figure);
    let sweep = scene.sweep.as_mut().unwrap();
    for axis in &mut sweep.axes {
        axis.count = count;
    }
    let grid = Grid::new(Arc::new(Plan::of(&scene).unwrap())).unwrap();
    grid.fill(PIECE, &mut Context::new(2, &mut to_its_end))
}

const DEPTH: usize = 0;
const TRAVEL: usize = 1;

/// An output along the first axis, at a point of the second.
fn along(grid: &Grid, output: usize, y: usize) -> Vec<f64> {
    let (count, _) = grid.counts();
    (0..count).map(|x| grid.value(x, y, output).unwrap_or(f64::NAN)).collect()
}

/// An output along the second axis, at a point of the first.
fn across(grid: &Grid, output: usize, x: usize) -> Vec<f64> {
    let (_, count) = grid.counts();
    (0..count).map(|y| grid.value(x, y, output).unwrap_or(f64::NAN)).collect()
}

fn rises(values: &[f64]) -> bool {
    values.windows(2).all(|pair| pair[1] > pair[0])
}

fn falls(values: &[f64]) -> bool {
    values.windows(2).all(|pair| pair[1] < pair[0])
}

fn span(values: &[f64]) -> f64 {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for value in values.iter().filter(|value| !value.is_nan()) {
        low = low.min(*value);
        high = high.max(*value);
    }
    high - low
}

#[test]
fn every_figure_agrees_with_its_caption() {
    // Held: gamma, d, b, k, n; NaN where the figure sweeps it. Ranges of Table 9.2.
    let nan = f64::NAN;
    let ranges = [
        ("gamma", 0.8, 7.0),
        ("d", 0.0, 0.5),
        ("b", 0.0, 2000.0),
        ("k", 0.0, 7.5e6),
        ("n", 0.1, 3.0),
    ];
    let figures = [
        (2, ["gamma", ""], [nan, 0.0, 0.0, 1e5, 1.0]),
        (3, ["d", ""], [1.0, nan, 0.0, 1e5, 1.0]),
        (4, ["b", ""], [1.0, 0.0, nan, 0.0, 1.0]),
        (5, ["k", ""], [1.0, 0.0, 0.0, nan, 1.0]),
        // The caption has k = 1e5; the text fits 1e6 better.
        (6, ["n", ""], [1.0, 0.0, 0.0, 1e6, nan]),
        (7, ["gamma", "k"], [nan, 0.0, 0.0, nan, 1.0]),
        (8, ["gamma", "n"], [nan, 0.0, 0.0, 1e5, nan]),
        (9, ["k", "n"], [1.0, 0.0, 0.0, nan, nan]),
        (10, ["d", "gamma"], [nan, nan, 0.0, 1e5, 1.0]),
        (11, ["d", "k"], [1.0, nan, 0.0, nan, 1.0]),
        (12, ["d", "n"], [1.0, nan, 0.0, 1e5, nan]),
    ];
    for (figure, axes, held) in figures {
        let scene = scene(figure);
        let sweep = scene.sweep.as_ref().unwrap();
        let names: Vec<&str> = sweep.axes.iter().map(|axis| axis.name.as_str()).collect();
        let expected: Vec<&str> = axes.into_iter().filter(|name| !name.is_empty()).collect();
        assert_eq!(names, expected, "figure 9.{figure}");
        assert_eq!(sweep.outputs, ["percent_of_baseline", "max_plate_displacement_m"]);
        for axis in &sweep.axes {
            let (_, from, to) = *ranges.iter().find(|range| range.0 == axis.name).unwrap();
            assert_eq!([axis.from, axis.to].map(f64::to_bits), [from, to].map(f64::to_bits));
            assert!(!axis.log && axis.count >= 41);
        }
        let (spring, damper) = (scene.mechanism.spring, scene.mechanism.damper);
        let found = [
            scene.plate.mass_ratio,
            scene.plate.cocking_m,
            damper.coefficient,
            spring.coefficient,
            spring.exponent,
        ];
        for (found, held) in found.into_iter().zip(held).filter(|(_, held)| !held.is_nan()) {
            assert_eq!(found.to_bits(), held.to_bits(), "figure 9.{figure}");
        }
        assert_eq!(scene.mechanism.damper.exponent.to_bits(), 1f64.to_bits());
    }
}

#[test]
fn valid_9_3_1_mass_ratio() {
    let grid = grid(2, 32);
    let (depth, travel) = (along(&grid, DEPTH, 0), along(&grid, TRAVEL, 0));
    let steps: Vec<f64> = depth.windows(2).map(|pair| pair[1] - pair[0]).collect();
    assert!(rises(&depth) && falls(&steps), "with a decreasing slope");
    assert!(falls(&travel));
    // gamma = 1 is the second of 32 points; the preset's comment has the value.
    assert!((depth[1] - 64.27).abs() < 0.005, "{}", depth[1]);
}

#[test]
fn valid_9_3_2_cocking_distance() {
    let grid = grid(3, 26);
    let (depth, travel) = (along(&grid, DEPTH, 0), along(&grid, TRAVEL, 0));
    assert!(falls(&depth) && rises(&travel));
    let slope = (travel[25] - travel[13]) / (0.5 * 12.0 / 25.0);
    assert!((slope - 1.0).abs() < 0.1, "nearly linear, one to one: {slope}");
}

#[test]
fn valid_9_3_3_damping() {
    let grid = grid(4, 41);
    let (depth, travel) = (along(&grid, DEPTH, 0), along(&grid, TRAVEL, 0));
    assert!(rises(&depth));
    assert!(travel[0].is_nan(), "nothing stops the plate at b = 0");
    assert!(falls(&travel[1..]));
    // Levels off from 1000 N s/m on: the second half of the range gives less than half of what the first gave.
    assert!(depth[40] - depth[20] < 0.5 * (depth[20] - depth[0]));
    // Displacement levels off near 300 N s/m.
    assert!(travel[6] - travel[40] < 0.2 * (travel[1] - travel[40]));
}

#[test]
fn valid_9_3_4_spring() {
    let by_k = grid(5, 31);
    let (depth, travel) = (along(&by_k, DEPTH, 0), along(&by_k, TRAVEL, 0));
    assert!(rises(&depth));
    assert!(travel[0].is_nan() && falls(&travel[1..]));
    let by_b = along(&grid(4, 3), DEPTH, 0);
    assert!(span(&depth) < span(&by_b), "the spring raises depth less than the damper does");

    let by_n = grid(6, 30);
    let (depth, travel) = (along(&by_n, DEPTH, 0), along(&by_n, TRAVEL, 0));
    // n = 0.1, 0.2, ...: the rigid mount's plateau, the edge near 0.5, level from 1.5 on.
    assert!((depth[0] - 100.0).abs() < 0.01, "{}", depth[0]);
    assert!((depth[4] - 100.0 * 6.919_384 / 7.113_055).abs() < 1e-4, "{}", depth[4]);
    assert!(depth[4] - depth[6] > 10.0, "the edge");
    assert!(span(&depth[14..]) < 0.5, "no appreciable effect beyond 1.5");
    assert!(rises(&travel));
}

#[test]
fn valid_9_7_mass_ratio_matters_more_than_stiffness() {
    let grid = grid(7, 9);
    let by_gamma = (0..9).map(|y| span(&along(&grid, DEPTH, y)));
    let by_k: Vec<f64> = (0..9).map(|x| span(&across(&grid, DEPTH, x))).collect();
    assert!(by_gamma.into_iter().all(|gamma| by_k.iter().all(|k| gamma > 2.0 * *k)));
    // gamma loses its hold on the displacement as k grows, and k as gamma grows.
    let hold: Vec<f64> = (1..9).map(|y| span(&along(&grid, TRAVEL, y))).collect();
    assert!(falls(&hold));
    let hold: Vec<f64> = (0..9).map(|x| span(&across(&grid, TRAVEL, x))).collect();
    assert!(falls(&hold));
}

#[test]
fn valid_9_8_a_small_exponent_holds_any_plate() {
    let grid = grid(8, 9);
    assert!(along(&grid, DEPTH, 0).iter().all(|depth| *depth > 95.0), "the plateau");
    assert!((0..9).all(|x| rises(&across(&grid, TRAVEL, x))));
    let hold: Vec<f64> = (0..9).map(|y| span(&along(&grid, TRAVEL, y))).collect();
    assert!(rises(&hold), "sensitivity to gamma grows with n");
    // Past the edge gamma has the more profound influence.
    assert!((2..9).all(|y| span(&along(&grid, DEPTH, y)) > span(&across(&grid, DEPTH, 0)[2..])));
}

#[test]
fn valid_9_9_the_plateau_narrows_with_k() {
    let grid = grid(9, 16);
    let edge = |x: usize| across(&grid, DEPTH, x).iter().take_while(|depth| **depth > 95.0).count();
    let edges: Vec<usize> = (1..16).map(edge).collect();
    assert!(edges.windows(2).all(|pair| pair[0] <= pair[1]) && edges[0] < edges[14], "{edges:?}");
    // The greatest displacement stands at low k and high n (k = 0 has none).
    let corner = grid.value(1, 15, TRAVEL).unwrap();
    for x in 1..16 {
        for y in 0..16 {
            assert!(grid.value(x, y, TRAVEL).unwrap() <= corner);
        }
    }
    let hold: Vec<f64> = (0..16).map(|y| span(&along(&grid, TRAVEL, y)[1..])).collect();
    assert!(rises(&hold), "at low n the displacement hardly depends on k");
}

#[test]
fn valid_9_10_cocking_helps_every_plate_and_light_ones_most() {
    let grid = grid(10, 9);
    let drops: Vec<f64> = (0..9)
        .map(|y| {
            let depth = along(&grid, DEPTH, y);
            assert!(falls(&depth));
            depth[0] - depth[8]
        })
        .collect();
    assert!(falls(&drops));
    // Displacement against d hardly depends on gamma, and is far greater than without cocking.
    let gains: Vec<f64> = (0..9)
        .map(|y| {
            let travel = along(&grid, TRAVEL, y);
            assert!(rises(&travel) && travel[8] > 10.0 * travel[0]);
            travel[8] - travel[4]
        })
        .collect();
    assert!(span(&gains) < 0.1 * gains[0], "{gains:?}");
}

#[test]
fn valid_9_11_a_little_cocking_makes_a_stiff_spring_useful() {
    let grid = grid(11, 9);
    assert!(rises(&across(&grid, DEPTH, 0)), "without cocking a stiff spring only hurts");
    let (without, with) = (span(&across(&grid, DEPTH, 0)), span(&across(&grid, DEPTH, 1)));
    assert!(without < 0.2 * with, "and hardly: {without} {with}");
    for x in 1..9 {
        assert!(falls(&across(&grid, DEPTH, x)), "with it, it helps");
    }
    // Displacement follows d almost whatever k is.
    let travel = across(&grid, TRAVEL, 8);
    assert!(span(&travel[1..]) < 0.05 * 0.5 + 0.05, "{travel:?}");
    assert_eq!(grid.outcomes().of(Outcome::Arrested), 81);
    assert_eq!(grid.outcome(0, 0), Some(PointOutcome::Ended(Outcome::Arrested)));
}

#[test]
fn valid_9_12_with_cocking_a_small_exponent_is_best() {
    let grid = grid(12, 16);
    assert!(across(&grid, DEPTH, 0)[0] > 99.0, "the plateau without cocking");
    for x in 1..16 {
        assert!(rises(&across(&grid, DEPTH, x)), "with it the smallest n is best");
    }
}
