//! Figures 9.7 to 9.12 as surfaces of 101 x 101 runs: `cargo bench -p cmra-benches -- surfaces`.
//!
//! The sweep engine as the Surface tab uses it, at its loosest tolerance whose measured error is below 1e-6: depth in percent of
//! the baseline and greatest displacement (against itself or a nanometre), at every thirty-seventh point, against the full
//! simulation at 1e-12, which shares no step with the contact kernel. Beside it the same points by a plain loop over single
//! contacts on both cores, and by the fastest peer solver at its own measured 1e-6, contact alone. Then runs per second against
//! the number of runs: the cost is linear.

use std::io::Write;
use std::ops::{ControlFlow, Range};
use std::sync::Arc;
use std::time::Instant;

use cmra::files::preset;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::simulate::{Settings, simulate};
use cmra_studies::study::context::CancelFlag;
use cmra_studies::study::parallel::{self, Work, cores};
use cmra_studies::study::quantities::named;
use cmra_studies::study::sweep::evaluate::{Evaluator, Point};
use cmra_studies::study::sweep::grid::PIECE;
use cmra_studies::study::sweep::{Axis, DEFAULT_OUTPUTS, Plan, Spacing};

use crate::equations::Equations;
use crate::explicit;
use crate::first_contact::first_contact;
use crate::solvers::Outcome;

/// Measured error of both outputs.
const TARGET: f64 = 1e-6;
/// Stride of the points that are checked.
const CHECKED: usize = 37;
/// Displacements below this are not known relative to themselves, m.
const NANOMETRE: f64 = 1e-9;
/// Repetitions, of which the least time counts.
const ROUNDS: usize = 15;

pub(crate) fn print(out: &mut impl Write) -> std::io::Result<()> {
    let machine = cores();
    writeln!(
        out,
        "\nsurfaces of 101 x 101 runs, ms, {machine} threads: least of {ROUNDS}; plain and peer: the same points one by one"
    )?;
    writeln!(
        out,
        "{:12} {:>7} {:>8} {:>8} {:>9} {:>12} {:>8} {:>10} {:>7}",
        "figure", "tol", "error", "ms", "1 thread", "runs/s/core", "plain", "dop853", "ratio"
    )?;
    for figure in ["9.7", "9.8", "9.9", "9.10", "9.11", "9.12"] {
        let name = format!("figure-{figure}");
        let scene = preset::resolve(&name, None).expect("a bundled preset").scene;
        surface(out, &name, &scene, machine)?;
    }
    linear(out)
}

fn surface(out: &mut impl Write, name: &str, scene: &Scene, machine: usize) -> std::io::Result<()> {
    let exact = Plan::from_scene(&at(scene, 1e-12)).expect("a preset's sweep");
    let known = simulated(&exact);
    let mut found = None;
    for half in (6..=24).rev() {
        let tolerance = 10f64.powf(-0.5 * f64::from(half));
        let plan = Plan::from_scene(&at(scene, tolerance)).expect("a preset's sweep");
        let error = worst(&known, &rows(&plan, machine));
        if error > TARGET {
            break;
        }
        found = Some((tolerance, error, plan));
    }
    let Some((tolerance, error, plan)) = found else {
        return writeln!(out, "{name:12} does not reach {TARGET:e}");
    };
    let (mut both_s, mut alone_s, mut plain_s) = (f64::MAX, f64::MAX, f64::MAX);
    for _ in 0..ROUNDS {
        both_s = both_s.min(seconds(|| drop(rows(&plan, machine))));
        alone_s = alone_s.min(seconds(|| drop(rows(&plan, 1))));
        plain_s = plain_s.min(seconds(|| plain(&plan, machine)));
    }
    let peer_s = peer(&plan) / machine as f64;
    writeln!(
        out,
        "{name:12} {tolerance:7.0e} {error:8.1e} {:8.2} {:9.2} {:12.0} {:8.2} {:10.1} {:7.1}",
        1e3 * both_s,
        1e3 * alone_s,
        plan.points() as f64 / alone_s,
        1e3 * plain_s,
        1e3 * peer_s,
        peer_s / both_s
    )?;
    out.flush()
}

/// Cost against the number of runs, on a polynomial surface.
fn linear(out: &mut impl Write) -> std::io::Result<()> {
    writeln!(out, "\nruns of a polynomial surface (gamma and k), one thread, tolerance 1e-6")?;
    for count in [32, 100, 316, 1000] {
        let axis = |symbol, ends| Axis::new(symbol, ends, count, Spacing::Linear);
        let axes = [axis("gamma", (0.8, 7.0)), axis("k", (0.0, 7.5e6))];
        let axes = axes.into_iter().collect::<Result<_, _>>().expect("sound axes");
        let scene = at(&Scene::default(), 1e-6);
        let plan = Plan::new(&scene, axes, &DEFAULT_OUTPUTS).expect("sound");
        let time_s = (0..3).map(|_| seconds(|| drop(rows(&plan, 1)))).fold(f64::MAX, f64::min);
        let points = plan.points() as f64;
        writeln!(out, "{points:9.0} runs  {time_s:9.5} s  {:10.0} runs/s", points / time_s)?;
    }
    Ok(())
}

fn at(scene: &Scene, tolerance: f64) -> Scene {
    let mut scene = scene.clone();
    scene.run.tolerance = tolerance;
    scene
}

fn seconds(work: impl FnOnce()) -> f64 {
    let start = Instant::now();
    work();
    start.elapsed().as_secs_f64()
}

/// The engine, all of it: placing, contacts, threads, results in order.
fn rows(plan: &Plan, threads: usize) -> Vec<Point> {
    let stop = CancelFlag::default();
    let mut all = Vec::new();
    let worker = || {
        let mut evaluator = Evaluator::new(plan, &stop);
        move |piece: Range<u64>| evaluator.points(&piece.collect::<Vec<u64>>())
    };
    let work = Work { count: plan.points(), at_once: PIECE };
    let _whole = parallel::map(&threads.into(), work, worker, |news| {
        all.extend(news.into_iter().flat_map(|(_, points)| points));
        ControlFlow::Continue(())
    });
    all
}

/// (point, outputs) by the full simulation.
fn simulated(plan: &Plan) -> Vec<(usize, [Option<f64>; 2])> {
    let columns = DEFAULT_OUTPUTS.map(|name| named(name).expect("a result"));
    let settings = Settings::BARE;
    let mut known = Vec::new();
    for index in (0..plan.points()).step_by(CHECKED) {
        let scene = Arc::new(plan.scene(index));
        let run = simulate(&scene, &settings, &mut |_| ControlFlow::Continue(()));
        let run = run.expect("a sound scene");
        known
            .push((usize::try_from(index).expect("few"), columns.map(|column| column.value(&run))));
    }
    known
}

/// The greatest relative error; infinite where one has a value and the other has none.
fn worst(known: &[(usize, [Option<f64>; 2])], found: &[Point]) -> f64 {
    let mut worst = 0.0f64;
    for (index, exact) in known {
        for (place, exact) in exact.iter().enumerate() {
            let value = found[*index].values[place];
            let error = match (value, exact) {
                (Some(value), Some(exact)) => (value - exact).abs() / exact.abs().max(NANOMETRE),
                (None, None) => 0.0,
                _ => f64::INFINITY,
            };
            worst = worst.max(error);
        }
    }
    worst
}

/// Every point's scene through the one door to a first contact, the points dealt out to the threads.
fn plain(plan: &Plan, threads: usize) {
    std::thread::scope(|scope| {
        for first in 0..threads as u64 {
            scope.spawn(move || {
                for index in (first..plan.points()).step_by(threads) {
                    std::hint::black_box(first_contact(&Arc::new(plan.scene(index))));
                }
            });
        }
    });
}

/// DOP853 over the same points, every thirty-seventh of them taken for all, at the loosest tolerance that is right to the
/// target in the median: on small exponents it fails or is wrong at every one, and is timed all the same.
fn peer(plan: &Plan) -> f64 {
    let scenes: Vec<Scene> =
        (0..plan.points()).step_by(CHECKED).map(|index| plan.scene(index)).collect();
    let exact: Vec<Option<f64>> = scenes
        .iter()
        .map(|scene| first_contact(&Arc::new(at(scene, 1e-11))).map(|end| end.depth_m))
        .collect();
    let mut time_s = 0.0;
    for half in 6..=20 {
        let tolerance = 10f64.powf(-0.5 * f64::from(half));
        let mut errors = Vec::new();
        time_s = 0.0;
        for (scene, exact) in scenes.iter().zip(&exact) {
            let mut job = explicit::dop853(&Equations::from_scene(scene), tolerance);
            let start = Instant::now();
            let outcome = job();
            time_s += start.elapsed().as_secs_f64();
            if let (Outcome::Answer((_, depth_m)), Some(exact)) = (outcome, exact) {
                errors.push((depth_m / exact - 1.0).abs());
            } else {
                errors.push(f64::INFINITY);
            }
        }
        errors.sort_by(f64::total_cmp);
        if errors[errors.len() / 2] <= TARGET {
            break;
        }
    }
    time_s * plan.points() as f64 / scenes.len() as f64
}
