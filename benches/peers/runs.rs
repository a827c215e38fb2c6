//! Whole runs of twelve scenes: run time against true error by each method, and what leaving out gains, as `cmra accuracy` measures
//! them: `cargo bench -p cmra-benches -- runs`.

use std::io::Write;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Instant;

use cmra_engine::model::scene::Scene;
use cmra_engine::model::variables::changed;
use cmra_studies::report::accuracy::{TARGETS, gain, seconds};
use cmra_studies::study::accuracy::method::Method;
use cmra_studies::study::accuracy::{AccuracyReport, ComparisonOptions, MethodReport, compare};
use cmra_studies::study::context::Context;

/// Name and changes to the default scene.
const SCENES: [(&str, &str); 12] = [
    ("baseline", "k=1e5"),
    ("stiff spring", "k=7.5e6"),
    ("n = 1/2", "k=1e6 n=0.5"),
    ("n = 0.2", "k=1e6 n=0.2"),
    ("damper", "k=1e5 b=2000"),
    ("cocked", "k=1e5 d=0.5"),
    ("plastic interface", "k=1e5 interface=plastic"),
    ("rigid stop", "k=1e5 x_stop=5mm"),
    ("oblique", "k=1e5 theta=30deg"),
    ("perforated", "k=1e5 v_i=400"),
    ("free plate", "k=0"),
    ("rigid mount", "mount=rigid"),
];
/// The methods of the first table: the engine to both targets, the others to the looser one.
const OTHERS: [Method; 4] =
    [Method::Rk4Events, Method::Dop853, Method::Radau, Method::ContactKernel];

/// Prints both tables.
pub(crate) fn print(out: &mut impl Write) -> std::io::Result<()> {
    // The first scene once more than the others, while the processor takes up speed.
    let _ = report(SCENES[0].1);
    let reports: Vec<(&str, AccuracyReport)> =
        SCENES.iter().map(|(name, changes)| (*name, report(changes))).collect();
    write!(out, "\n| scene | changes | as shown | auto to 1e-6 | auto to 1e-9 | least error |")?;
    for method in OTHERS {
        write!(out, " {} |", method.name())?;
    }
    writeln!(out, "\n| --- | --- |{}", " ---: |".repeat(4 + OTHERS.len()))?;
    for ((name, report), (_, changes)) in reports.iter().zip(SCENES) {
        let cell = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), seconds);
        let by = |method: Method| report.methods.iter().find(|it| it.method == method);
        let to = |method: Method, target: f64| {
            cell(by(method).and_then(|it| it.cheapest(target)).map(|found| found.min_s))
        };
        let [loose, tight] = TARGETS;
        let least = by(Method::Auto).and_then(MethodReport::min_error);
        let least = least.map_or_else(|| "-".to_owned(), |error| format!("{error:.0e}"));
        let (shown, one, other) =
            (cell(report.run_s), to(Method::Auto, loose), to(Method::Auto, tight));
        write!(out, "| {name} | {changes} | {shown} | {one} | {other} | {least} |")?;
        for method in OTHERS {
            write!(out, " {} |", to(method, loose))?;
        }
        writeln!(out)?;
    }
    let parts = reports[0].1.savings.iter().map(|saving| saving.part);
    write!(out, "\n| scene |")?;
    for part in parts.clone() {
        write!(out, " {part} |")?;
    }
    writeln!(out, "\n| --- |{}", " ---: |".repeat(parts.clone().count()))?;
    for (name, report) in &reports {
        write!(out, "| {name} |")?;
        for part in parts.clone() {
            let found = report.savings.iter().find(|saving| saving.part == part);
            write!(out, " {} |", found.map_or_else(|| "-".to_owned(), gain))?;
        }
        writeln!(out)?;
    }
    Ok(())
}

fn report(changes: &str) -> AccuracyReport {
    let scene = Arc::new(changed(Scene::default(), changes).expect("a valid scene"));
    let start = Instant::now();
    let clock = &mut || start.elapsed().as_secs_f64();
    let watch = &mut |_, _: Option<&AccuracyReport>| ControlFlow::Continue(());
    compare(&scene, ComparisonOptions::FULL, clock, &mut Context::new(1, watch))
        .expect("a valid scene")
}
