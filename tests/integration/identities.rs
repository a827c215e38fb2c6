//! Identities that hold for every run, over random scenes of every kind: peaks and rows, the energy ledger, pages and numbers.

use std::fmt::Write as _;
use std::sync::Arc;

use cmra_engine::model::mechanism::Mechanism;
use cmra_engine::model::run::{ContactMode, Run, RunWarning};
use cmra_engine::model::scene::{ContactModel, Scene, SpringKind};
use cmra_engine::model::variables::{VARIABLES, Value, Variable, validate};
use cmra_studies::report::run::json;
use cmra_studies::report::run::page::{results, sentence};
use serde_json::Value as Json;

use crate::random::Random;
use crate::support::run;

/// Scenes of a test; ten times as many are run by hand.
const SCENES: usize = 400;

/// Part of a peak by which rows may exceed it.
const ROUNDING: f64 = 2e-9;

/// Sizes that overflow, underflow or vanish somewhere.
const ODD: [f64; 6] = [0.0, 1e-300, 1e-20, 1e9, 1e20, 1e300];

/// A number about the size of the default value, sometimes far from it.
fn number(random: &mut Random, default: f64) -> f64 {
    let size = if default == 0.0 { 1e-2 } else { default };
    let sign = if random.unit() < 0.1 { -1.0 } else { 1.0 };
    match random.unit() {
        share if share < 0.1 => sign * random.of(&ODD),
        share if share < 0.3 => sign * size * random.log(1e-8, 1e8),
        _ => sign * size * random.log(1e-2, 1e2),
    }
}

fn value(random: &mut Random, variable: &Variable) -> Value {
    match variable.value(&Scene::default()) {
        Value::Switch(_) => Value::Switch(random.unit() < 0.5),
        Value::Word(_) => Value::Word(random.of(variable.keys())),
        Value::Number(default) => Value::Number(number(random, default)),
        Value::Absent => Value::Number(number(random, 1e-2)),
    }
}

/// A scene with a few variables changed at random, and the changes as they are typed.
fn scene(random: &mut Random) -> (Scene, String) {
    let mut scene = Scene::default();
    let mut typed = String::new();
    for _ in 0..=random.below(7) {
        let variable = &VARIABLES[random.below(VARIABLES.len())];
        let before = scene.clone();
        // What a variable or a rule between them refuses is not changed.
        let is_set = variable.set(&mut scene, value(random, variable)).is_ok();
        if is_set && validate(&scene).is_ok() {
            let _ = write!(typed, " --set '{}={}'", variable.key, variable.show(&scene));
        } else {
            scene = before;
        }
    }
    (scene, typed)
}

/// Prefixes of the units on a page.
const PREFIXES: [(&str, f64); 10] = [
    ("f", 1e-15),
    ("p", 1e-12),
    ("n", 1e-9),
    ("u", 1e-6),
    ("m", 1e-3),
    ("k", 1e3),
    ("M", 1e6),
    ("G", 1e9),
    ("T", 1e12),
    ("P", 1e15),
];

/// A number with its unit as a page has it, in SI: `19.37 kN`.
fn read(text: &str) -> Option<f64> {
    let mut words = text.split_whitespace();
    let number: f64 = words.next()?.parse().ok()?;
    let unit = words.next().unwrap_or("");
    for base in ["N", "m/s", "m", "s", "J"] {
        let Some(prefix) = unit.strip_suffix(base) else { continue };
        if prefix.is_empty() {
            return Some(number);
        }
        if let Some((_, factor)) = PREFIXES.iter().find(|(known, _)| *known == prefix) {
            return Some(number * factor);
        }
    }
    None
}

/// The lines of a page and the keys of the JSON that say the same.
const SAID: [(&str, &str); 9] = [
    ("first stop, depth", "first_arrest_penetration_m"),
    ("final depth", "final_penetration_m"),
    ("  on a rigid mount", "baseline_penetration_m"),
    ("exit time", "exit_time_s"),
    ("residual velocity", "residual_velocity_m_s"),
    ("peak contact force", "peak_contact_force_n"),
    ("peak mount force", "peak_mount_force_n"),
    ("max plate displacement", "max_plate_displacement_m"),
    ("stroke", "stroke_m"),
];

/// Returns the identities that a run violates.
fn faults(run: &Run) -> Vec<String> {
    let object: Json = serde_json::from_str(&json("random", run, None)).unwrap();
    let key = |name: &str| object[name].as_f64();
    let mut faults = Vec::new();
    // The listing draws some of its rows at places that it then takes back.
    let is_listing = run.scene.contact.model == ContactModel::Appendix;
    // A displacement is known to the rounding of the cocking distance at best.
    let known = 1e-12 * run.scene.start_m().abs();
    let mut exceeds = |name: &str, rows: f64, peak: Option<f64>| {
        if !is_listing && peak.is_some_and(|peak| rows > peak + ROUNDING * peak.abs() + known) {
            faults.push(format!("{name} = {peak:?}, and a row has {rows}"));
        }
    };
    let greatest = |f: &dyn Fn(&cmra_engine::model::run::Sample) -> f64| {
        run.series.iter().map(f).fold(f64::NEG_INFINITY, f64::max)
    };
    let turns = run.mechanism.added_kg.is_some();
    if run.scene.is_sprung() && !turns {
        let rows = greatest(&|row| row.mount_force_n().abs());
        exceeds("peak_mount_force_n", rows, key("peak_mount_force_n"));
    }
    if run.scene.is_sprung() {
        let rows = greatest(&|row| row.plate_displacement_m);
        exceeds("max_plate_displacement_m", rows, key("max_plate_displacement_m"));
        let spring = Mechanism::from_scene(&run.scene).spring;
        let rows = greatest(&|row| spring.energy(row.plate_displacement_m));
        let crushes = run.scene.mechanism.spring.kind == SpringKind::Crush;
        exceeds("stored_energy_j", rows, key("stored_energy_j").filter(|_| !crushes));
    }
    let pushed = |row: &cmra_engine::model::run::Sample| match row.mode {
        ContactMode::Penetrating => row.contact_force_n,
        _ => 0.0,
    };
    exceeds("peak_contact_force_n", greatest(&pushed), key("peak_contact_force_n"));
    if run.stack.is_none() {
        let rows = greatest(&|row| row.penetration_m);
        let depth = key("final_penetration_m").filter(|_| run.outcome.word() == "arrested");
        let flows = run.scene.contact.model == ContactModel::Hydrodynamic;
        exceeds("final_penetration_m", rows, depth.filter(|_| flows));
    }
    let residual = key("energy_residual");
    let warned =
        |run: &Run| run.warnings.iter().any(|it| matches!(it, RunWarning::EnergyDrift { .. }));
    if residual.is_none_or(|residual| residual.abs() > 1e-6) && !run.plates().any(warned) {
        faults.push(format!("energy_residual = {residual:?} without its warning"));
    }
    let has_warning = object["warnings"].as_array().unwrap().iter().any(|it| {
        let text = it.as_str().unwrap();
        text.contains("energy balance") || text.contains("diverged")
    });
    if residual.is_none_or(|residual| residual.abs() > 1e-6) && !has_warning {
        faults.push(format!("energy_residual = {residual:?}: no text {:?}", object["warnings"]));
    }
    let goes_back = run.series.windows(2).find(|pair| pair[1].t_s < pair[0].t_s);
    if let Some([before, after]) = goes_back {
        faults.push(format!("a row at {:e} s after one at {:e} s", after.t_s, before.t_s));
    }
    if object["complete"] == true && object["outcome"] == "moving" {
        faults.push("complete, and still moving".to_owned());
    }
    if run.stack.is_none() {
        faults.extend(faults_of_page(run, &object));
    }
    faults
}

/// Where the page of a run says something else than its JSON.
fn faults_of_page(run: &Run, object: &Json) -> Vec<String> {
    let mut faults = Vec::new();
    let lower = object["lower_bounds"].as_array().unwrap();
    let word = object["outcome"].as_str().unwrap();
    let text = sentence(run);
    if !text.contains(word) {
        faults.push(format!("outcome {word}, and the page says: {text}"));
    }
    let lines = results(run);
    for (label, name) in SAID {
        let line = lines.iter().find(|line| line.0 == label);
        let said = line.and_then(|line| read(&line.1));
        let value = object[name].as_f64().filter(|_| !lower.iter().any(|it| it == name));
        if let (Some(said), Some(value)) = (said, value)
            // A page shows what is below a thousandth of its smallest prefix as zero.
            && (said - value).abs() > 1e-18_f64.max(1e-5 * value.abs())
        {
            faults.push(format!("{name} = {value}, and the page says {line:?}"));
        }
        if value.is_some_and(|value| value.abs() > 1e-12 && value.abs() < 1e15) && said.is_none() {
            faults.push(format!("{name} = {value:?} is not on the page: {line:?}"));
        }
    }
    faults
}

fn check(seed: u64, scenes: usize) {
    let mut random = Random(seed);
    let mut all = Vec::new();
    for _ in 0..scenes {
        let (scene, typed) = scene(&mut random);
        let scene = Arc::new(scene);
        let found = std::panic::catch_unwind(|| faults(&run(Scene::clone(&scene))));
        let found = found.unwrap_or_else(|_| vec!["panicked".to_owned()]);
        all.extend(found.into_iter().map(|fault| format!("cmra run{typed}\n    {fault}")));
    }
    assert!(all.is_empty(), "{} faults:\n{}", all.len(), all.join("\n"));
}

/// Peaks are not below rows, an energy balance that does not close is said, pages say what the JSON says, and nothing panics.
#[test]
fn random_scenes_keep_the_identities() {
    check(20_261_129, SCENES);
}

/// Checks the identities over many more scenes.
#[test]
#[ignore = "by hand: takes minutes"]
fn many_random_scenes_keep_the_identities() {
    let seed = std::env::var("SEED").map_or(1, |seed| seed.parse().unwrap());
    let scenes = std::env::var("SCENES").map_or(20_000, |scenes| scenes.parse().unwrap());
    check(seed, scenes);
}
