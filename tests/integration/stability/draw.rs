//! Quasi-random scenes over the ranges the engine promises to serve: a scrambled Halton sequence with a fixed seed.
//!
//! Each scene is written as the changes a person would type, so that a complaint can be pasted behind `cmra run --set`.

use std::fmt::Write as _;
use std::sync::Arc;

use cmra_engine::model::scene::Scene;
use cmra_engine::model::variables;

/// Bases of the Halton sequence, one for each dimension.
const BASES: [u64; 21] =
    [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67, 71, 73];
/// Multiplies and shifts the digits, so that large bases do not march in step.
const SEED: u64 = 20_070_412;
/// Exponents that are not drawn but chosen, in part of the scenes.
const ROUND: [f64; 6] = [0.5, 1.0, 1.5, 2.0, 3.0, 5.0];

/// The radical inverse of `index` with its digits d replaced by (a d + c) mod base; zero keeps its place in the tail.
fn halton(index: u64, dimension: usize) -> f64 {
    let base = BASES[dimension];
    let a = 1 + (SEED / (dimension as u64 + 1)) % (base - 1);
    let (mut rest, mut weight, mut value) = (index, 1.0, 0.0);
    while rest > 0 {
        weight /= base as f64;
        value += weight * ((a * (rest % base)) % base) as f64;
        rest /= base;
    }
    value
}

/// The point of one index.
struct Point(u64);

impl Point {
    fn at(&self, dimension: usize) -> f64 {
        halton(self.0, dimension)
    }

    /// Equal ratios from `low` to `high`.
    fn log(&self, dimension: usize, (low, high): (f64, f64)) -> f64 {
        rounded(low * (high / low).powf(self.at(dimension)))
    }

    /// `None` in the first `share` of the dimension, else what is left of it, stretched to 0..1, at equal ratios.
    fn log_or_none(&self, dimension: usize, share: f64, (low, high): (f64, f64)) -> Option<f64> {
        let left = (self.at(dimension) - share) / (1.0 - share);
        (left >= 0.0).then(|| rounded(low * (high / low).powf(left)))
    }
}

/// Six digits: short to paste, and exactly what the text says.
fn rounded(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap()
}

/// Ranges of the variables.
struct Ranges {
    n: (f64, f64),
    m: (f64, f64),
    /// Greatest spring coefficient of a cocked plate and of an uncocked one.
    k: (f64, f64),
    b: f64,
    gamma: (f64, f64),
    v_i: (f64, f64),
    h: (f64, f64),
    theta_deg: f64,
    s_y: (f64, f64),
    /// Part of the targets that have no strength.
    strengthless: f64,
}

/// Far beyond any use.
const WHOLE: Ranges = Ranges {
    n: (0.05, 6.0),
    m: (0.2, 3.0),
    k: (1e9, 1e12),
    b: 1e8,
    gamma: (1e-4, 1e6),
    v_i: (1e-3, 3e3),
    h: (1e-5, 5.0),
    theta_deg: 85.0,
    s_y: (1e5, 3e9),
    strengthless: 0.1,
};

/// The numerical envelope.
const INSIDE: Ranges = Ranges {
    n: (0.1, 5.0),
    m: (0.2, 5.0),
    k: (7.5e7, 7.5e7),
    b: 2e4,
    gamma: (0.05, 70.0),
    v_i: (1.0, 3e3),
    h: (5e-4, 1.0),
    theta_deg: 80.0,
    s_y: (1e6, 1e10),
    strengthless: 0.0,
};

/// The changes that make scene number `index`, 1 and up.
pub(super) fn changes(index: u64) -> Vec<(&'static str, String)> {
    changes_in(index, &WHOLE)
}

/// The changes that make scene number `index` inside the numerical envelope.
pub(super) fn changes_inside(index: u64) -> Vec<(&'static str, String)> {
    changes_in(index, &INSIDE)
}

fn changes_in(index: u64, ranges: &Ranges) -> Vec<(&'static str, String)> {
    let point = Point(index);
    let mut list = Vec::new();
    let mut set = |name: &'static str, value: String| list.push((name, value));
    let number = |value: f64| format!("{value:e}");
    let exponent = |dimension: usize, (low, high): (f64, f64)| {
        let drawn = point.at(dimension);
        // The first quarter of the dimension is dealt out among the round ones.
        let dealt = |index: &usize| drawn < 0.25 * (index + 1) as f64 / ROUND.len() as f64;
        let chosen = (0..ROUND.len()).find(dealt).map(|index| ROUND[index]);
        chosen
            .filter(|z| *z >= low && *z <= high)
            .unwrap_or_else(|| rounded(low * (high / low).powf((drawn - 0.25).abs() / 0.75)))
    };
    set("n", number(exponent(0, ranges.n)));
    set("m", number(exponent(1, ranges.m)));
    let d = point.log_or_none(4, 0.4, (1e-6, 1.0));
    let stiffest = if d.is_some() { ranges.k.0 } else { ranges.k.1 };
    set("k", number(point.log_or_none(2, 0.1, (1.0, stiffest)).unwrap_or(0.0)));
    set("b", number(point.log_or_none(3, 0.35, (1e-2, ranges.b)).unwrap_or(0.0)));
    set("d", number(d.unwrap_or(0.0)));
    set("gamma", number(point.log(5, ranges.gamma)));
    set("v_i", number(point.log(6, ranges.v_i)));
    set("h", number(point.log(7, ranges.h)));
    let theta = rounded(((point.at(8) - 0.4) / 0.6).max(0.0) * ranges.theta_deg);
    set("theta", format!("{theta}deg"));
    set("S_y", number(point.log_or_none(9, ranges.strengthless, ranges.s_y).unwrap_or(0.0)));
    set("C_d", number(point.log_or_none(10, 0.1, (1e-2, 2.0)).unwrap_or(0.0)));
    set("interface", if point.at(11) < 0.5 { "fused" } else { "plastic" }.to_owned());
    set("g", number(point.log_or_none(12, 0.15, (1e-2, 2.0)).unwrap_or(0.0)));
    set("dishing", (point.at(13) > 0.15).to_string());
    set("mount", if point.at(14) < 0.04 { "rigid" } else { "sprung" }.to_owned());
    stop(&point, d.unwrap_or(0.0), &mut set);
    list
}

/// No stop, one without gap, or one with.
fn stop(point: &Point, cocking_m: f64, set: &mut impl FnMut(&'static str, String)) {
    let drawn = point.at(15);
    if drawn < 0.6 {
        return;
    }
    let gap = if drawn < 0.7 { 0.0 } else { point.log(16, (1e-7, 0.3)) };
    set("x_stop", format!("{:e}", gap - cocking_m));
    if point.at(17) < 0.5 {
        set("stop_kind", "rigid".to_owned());
        set("e", format!("{:e}", point.log_or_none(18, 0.4, (0.01, 1.0)).unwrap_or(0.0)));
    } else {
        set("stop_kind", "elastic".to_owned());
        set("k_stop", format!("{:e}", point.log(19, (1e2, 1e12))));
        set("b_stop", format!("{:e}", point.log_or_none(20, 0.4, (1e-2, 1e6)).unwrap_or(0.0)));
    }
}

/// The changes as a person would type them.
pub(super) fn typed(changes: &[(&'static str, String)]) -> String {
    let mut text = String::new();
    for (name, value) in changes {
        let _ = write!(text, " --set {name}={value}");
    }
    text
}

/// The scene they make.
pub(super) fn scene(changes: &[(&'static str, String)]) -> Arc<Scene> {
    let mut scene = Scene::default();
    for (name, value) in changes {
        variables::set_by_name(&mut scene, name, value)
            .unwrap_or_else(|error| panic!("{name}={value}: {error}"));
    }
    Arc::new(scene)
}
