//! A thousand random scenes of the working range by each method of `cmra accuracy`: the fraction of scenes that reaches a measured
//! error, and how long that takes: `cargo bench -p cmra-benches -- methods`.

use std::io::Write;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Instant;

use cmra_engine::model::scene::Scene;
use cmra_engine::model::variables::changed;
use cmra_engine::numerics::random::Random;
use cmra_studies::report::accuracy::{TARGETS, seconds};
use cmra_studies::study::accuracy::method::{Method, Parameter};
use cmra_studies::study::accuracy::{AccuracyReport, ComparisonOptions, MethodReport, compare};
use cmra_studies::study::context::Context;
use cmra_studies::study::statistics::{quantile, sorted_by};

const SCENES: usize = 1000;
const SEED: u64 = 2007;

/// Prints a row for each method and target.
pub(crate) fn print(out: &mut impl Write) -> std::io::Result<()> {
    let mut random = Random::new(SEED);
    let reports: Vec<AccuracyReport> =
        (0..SCENES).filter_map(|_| report(&changes(&mut random))).collect();
    writeln!(out, "\n{} scenes, seed {SEED}", reports.len())?;
    writeln!(out, "\n| method | error | reached | kept | median | 95th percentile | slowest |")?;
    writeln!(out, "| --- | --- | ---: | ---: | ---: | ---: | ---: |")?;
    for (index, method) in Method::ALL.into_iter().enumerate() {
        for target in TARGETS {
            let own = || reports.iter().filter_map(|report| report.methods.get(index));
            let times_s = own().filter_map(|it| Some(it.cheapest(target)?.min_s)).collect();
            let times_s = sorted_by(times_s, |time_s| *time_s);
            let percent = |count: usize| 100.0 * count as f64 / reports.len() as f64;
            let asked = own().filter(|it| tolerance_is_kept(it, target).is_some()).count();
            let kept = own().filter(|it| tolerance_is_kept(it, target) == Some(true)).count();
            let kept = match asked {
                0 => "-".to_owned(),
                _ => format!("{:.1} %", percent(kept)),
            };
            let time = |fraction: f64| match times_s[..] {
                [] => "-".to_owned(),
                _ => seconds(quantile(&times_s, fraction)),
            };
            writeln!(
                out,
                "| {} | {target:e} | {:.1} % | {kept} | {} | {} | {} |",
                method.name(),
                percent(times_s.len()),
                time(0.5),
                time(0.95),
                time(1.0),
            )?;
        }
    }
    Ok(())
}

/// Whether the error at a tolerance is at most the tolerance; `None` for methods of fixed steps and tolerances that were not run.
fn tolerance_is_kept(report: &MethodReport, tolerance: f64) -> Option<bool> {
    let at = |it: &Parameter| matches!(it, Parameter::Tolerance(value) if (value / tolerance - 1.0).abs() < 1e-9);
    report
        .points
        .iter()
        .find(|point| at(&point.parameter))
        .map(|point| point.result.as_ref().is_ok_and(|measured| measured.error() <= tolerance))
}

/// Changes to the default scene within the thesis's ranges: Table 9.2, and its mechanisms.
fn changes(random: &mut Random) -> String {
    let mut log = |low: f64, high: f64| low * (high / low).powf(random.unit());
    let (gamma, v_i, k, b, d) =
        (log(0.8, 7.0), log(30.0, 400.0), log(1e4, 1e7), log(10.0, 1e4), log(1e-3, 0.5));
    let (n, x_stop) = (log(0.2, 3.0), log(1e-3, 0.1));
    let mut changes = format!("gamma={gamma} v_i={v_i} k={k}");
    let mut add = |fraction: f64, text: String| {
        if random.unit() < fraction {
            changes += &text;
        }
    };
    add(0.5, format!(" n={n}"));
    add(0.5, format!(" b={b}"));
    add(0.3, format!(" d={d}"));
    add(0.2, format!(" x_stop={x_stop}"));
    add(0.3, " interface=plastic".to_owned());
    add(0.2, " theta=30deg".to_owned());
    changes
}

fn report(changes: &str) -> Option<AccuracyReport> {
    let scene = Arc::new(changed(Scene::default(), changes).ok()?);
    let start = Instant::now();
    let clock = &mut || start.elapsed().as_secs_f64();
    let watch = &mut |_, _: Option<&AccuracyReport>| ControlFlow::Continue(());
    compare(&scene, ComparisonOptions::QUICK, clock, &mut Context::new(1, watch)).ok()
}
