//! The one table of quantities, the inputs by name, face and mass, and the envelope of validity, as a user meets them.

use std::collections::BTreeSet;

use cmra_engine::model::run::RunResult;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::simulate::{RunSnapshot, Settings, simulate};
use cmra_engine::model::variables::changed;
use cmra_studies::study::envelope::Check;
use cmra_studies::study::quantities::find;
use serde_json::Value;

use crate::support::{cmra, printed, says};

fn object(command: &str, arguments: &[&str], code: i32) -> Value {
    let (text, _) = says(command, &[arguments, &["--json"]].concat(), code);
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

fn warnings(found: &Value) -> String {
    found["warnings"].as_array().unwrap().iter().map(|it| it.as_str().unwrap()).collect()
}

/// A rigid mount takes the contact force along the normal, which at 30 degrees is `cos(30°)` of it; of a spring alone the greatest force is
/// `k x`. Both the result of a run, whose error is estimated, and the quantity say so.
#[test]
fn valid_the_mount_force_has_one_definition() {
    for (changes, known) in
        [("mount=rigid theta=30deg", "contact"), ("mount=rigid", "contact"), ("gamma=2", "spring")]
    {
        let scene = std::sync::Arc::new(changed(Scene::default(), changes).unwrap());
        let go_on = &mut |_: &RunSnapshot<'_>| std::ops::ControlFlow::Continue(());
        let run = simulate(&scene, &Settings::default(), go_on).unwrap();
        let angle_rad = scene.projectile.obliquity_deg.to_radians();
        let expected = if known == "contact" {
            run.peak_contact_force_n.unwrap() * angle_rad.cos()
        } else {
            scene.mechanism.spring.coefficient * run.max_plate_displacement_m.unwrap()
        };
        let quantity = find("peak_mount_force_n").unwrap().value(&run);
        for found in [RunResult::PeakMountForce.value(&run), quantity] {
            assert!((found.unwrap() / expected - 1.0).abs() < 1e-9, "{changes}: {found:?}");
        }
    }
}

/// In closed form, rigid, Table 9.1: 232.295378 m/s at h = 25.4 mm.
#[test]
fn a_limit_velocity_is_a_goal_like_any_other() {
    let goal = ["--goal", "limit_velocity_m_s=232.295378"];
    let found = object(
        "seek",
        &[&["--set", "mount=rigid", "--over", "h=5mm..40mm"], &goal[..]].concat(),
        0,
    );
    let h = found["solutions"][0]["at"].as_f64().unwrap();
    assert!((h - 0.0254).abs() < 1e-9, "{h}");
}

/// `rho h face²/m_p` = 2710 * 0.003 * 0.1²/0.0295, in whatever order they are given.
#[test]
fn the_mass_ratio_follows_from_the_face() {
    let face = ["--set", "face=100mm"];
    let h = ["--set", "thickness=3mm"];
    for order in [[face, h].concat(), [h, face].concat()] {
        let run = object("run", &order, 0);
        let gamma = run["variables"]["plate.mass_ratio"].as_f64().unwrap();
        assert!((gamma - 2.755_932_203_389_83).abs() < 1e-12, "{gamma}");
        assert!((run["plate_face_m"].as_f64().unwrap() - 0.1).abs() < 1e-15);
    }
    let run = object("run", &["--set", "m_2=81.3g"], 0);
    assert!((run["plate_mass_kg"].as_f64().unwrap() - 0.0813).abs() < 1e-15);
}

/// The lightest plate that is 3 D wide: 2710 * 0.0254 * (3 * 0.0127)²/0.0295 = 3.38712.
#[test]
fn least_mass_is_not_least_tile() {
    let over = ["free-plate", "--over", "gamma=0.8..7", "--minimise", "plate_mass_kg"];
    let quick = ["--samples", "512", "--set", "interface=plastic"];
    let best = |extra: &[&str]| {
        let found = object("optimise", &[&over[..], &quick, extra].concat(), 0);
        found["designs"][0]["gamma"].as_f64().unwrap()
    };
    let feasible = best(&[]);
    assert!((feasible - 3.387_118).abs() < 1e-4, "{feasible}");
    assert!((best(&["--no-feasibility"]) - 0.8).abs() < 1e-6);
}

#[test]
fn every_study_warns_outside_the_validity() {
    let stop = object("limit", &["--set", "x_stop=30mm"], 0);
    assert!(warnings(&stop).contains("rigid stop asks the fused interface"), "{stop}");
    let (page, _) = says("limit", &[], 0);
    let first = page.split("\nwarnings\n").nth(1).and_then(|rest| rest.lines().next());
    assert!(
        first.is_some_and(|line| line.starts_with("  ! outside validity: h/D = 2: ")),
        "{page}"
    );
    let (csv, _) = says(
        "seek",
        &["free-plate", "--over", "gamma=0.8..7", "--goal", "stroke_m=1", "--csv", "-"],
        1,
    );
    assert!(csv.lines().next().unwrap().ends_with(",warnings"), "{csv}");
    let narrow = object("run", &["--set", "gamma=12"], 0);
    assert!(warnings(&narrow).contains("the thesis has no figure there"));
    assert!(!warnings(&narrow).contains("still valid"));
    // Another shot has nothing to do with the range of the thesis.
    let other = object("run", &["--set", "gamma=12", "--set", "m_p=5g"], 0);
    assert!(!warnings(&other).contains("Table 9.2"));
}

#[test]
fn variables_and_quantities_are_explained() {
    let (page, _) = says("explain", &["thickness"], 0);
    assert!(page.starts_with("h: plate thickness") && page.contains("0.0254 m"), "{page}");
    for name in ["limit velocity m s", "limit velocity"] {
        let (page, _) = says("explain", &[name], 0);
        assert!(page.contains("many shots"), "{page}");
    }
    let (list, _) = says("explain", &[], 0);
    for name in ["mass_efficiency", "stop_position", "gamma"] {
        assert!(list.contains(name), "{list} lacks {name}");
    }
    // Each example works as it is written.
    for name in ["spring", "combine", "model"] {
        let (page, _) = says("explain", &[name], 0);
        let set = page.split("--set ").nth(1).and_then(|rest| rest.lines().next()).unwrap();
        says("run", &["--set", set], 0);
    }
    let (_, error) = says("explain", &["thicknes"], 2);
    assert!(error.contains("neither a variable ("), "{error}");
    let (_, error) = says("explain", &["stoke"], 2);
    assert!(error.contains("nor a quantity (did you mean `stroke_m`"), "{error}");
}

/// Returns the labels of a page: what stands before two blanks and a text, without numbers and pictures, and all headings of columns.
fn labels(page: &str) -> Vec<String> {
    let lines = page.lines().filter(|line| !line.starts_with(['|', '+']) && !line.contains('!'));
    let parts = lines.flat_map(|line| {
        let parts: Vec<&str> = line.trim().split("  ").collect();
        let is_head = parts.iter().all(|part| !part.contains(|c: char| c.is_ascii_digit()));
        let shown = if parts.len() < 2 {
            0
        } else if is_head && line.starts_with("   ") || parts[0] == "scene" {
            parts.len()
        } else {
            1
        };
        parts.into_iter().take(shown).map(str::trim).collect::<Vec<_>>()
    });
    let is_label = |part: &&str| !part.is_empty() && !part.contains(|c: char| c.is_ascii_digit());
    parts.filter(is_label).map(str::to_owned).collect()
}

/// The pages of `design` have the name last, before its source in brackets.
#[test]
fn every_label_of_a_page_is_explained() {
    let mut all = BTreeSet::new();
    for (study, scenes) in [
        (
            "run",
            "; spring=helix d=0.1; interface=plastic b=20 x_stop=5mm weight=on; v_i=400; gamma=0.5 interface=plastic g=0; own_mass=counted",
        ),
        ("limit", "; b=100; mount=rigid"),
        ("compare", "; own_mass=counted"),
    ] {
        for changes in scenes.split(';') {
            let set = changes.split_whitespace().flat_map(|change| ["--set", change]);
            all.extend(labels(&printed(study, &set.collect::<Vec<_>>())));
        }
    }
    for changes in [&["--set", "weight=on"][..], &["--set", "mount=rigid", "--c-t", "1"]] {
        let page = printed("design", changes);
        let names = page.lines().filter(|line| line.starts_with("     "));
        let names = names.filter_map(|line| line.trim().split_once("  "));
        all.extend(names.map(|(_, name)| name.trim().split(" (").next().unwrap().to_owned()));
    }
    all.extend(labels(&printed("stability", &["thesis-baseline"])));
    assert!(all.len() > 60, "{all:?}");
    let is_known = |label: &&String| cmra("explain", &[label]).output().unwrap().status.success();
    let unknown: Vec<&String> = all.iter().filter(|label| !is_known(label)).collect();
    assert!(unknown.is_empty(), "{unknown:#?}");
}

/// Rows lack the force that turns a geared mass: 3.5 kN at most for a helix whose result is 5.6 kN.
#[test]
fn a_mount_force_says_what_the_rows_have_of_it() {
    let (page, _) = says("explain", &["mount force"], 0);
    let page = page.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(page.contains("rows of a CSV are without that"), "{page}");
    let (page, _) = says("help", &["csv"], 0);
    assert!(page.contains("turns a geared mass"), "{page}");
}

/// By the name that begins its line below a run; a name that a variable has, too, explains both.
#[test]
fn a_warning_is_explained_by_its_name() {
    let (page, _) = says("run", &[], 0);
    assert!(page.contains("plate face is 20.7 mm square, 1.63 D: "), "{page}");
    for name in Check::WORDS {
        let (page, _) = says("explain", &[name], 0);
        let text = page.split(&format!("{name}: a warning\n")).nth(1);
        let text = text.unwrap_or_else(|| panic!("{name}: {page}")).to_lowercase();
        let direction = ["conservative", "not known"].iter().any(|words| text.contains(words));
        assert!(direction && text.contains("cure:"), "{text}");
    }
    let (both, _) = says("explain", &["spring"], 0);
    assert!(both.contains("--set spring=") && both.contains("spring: a warning"), "{both}");
}

/// The closure's yield strength stands in the place of `S_y`, a beam's own measures in that of k.
#[test]
fn monte_carlo_varies_the_variables_that_the_scene_uses() {
    let symbols = |arguments: &[&str]| -> Vec<String> {
        let found = object("montecarlo", &[arguments, &["--samples", "2"]].concat(), 0);
        let inputs = found["inputs"].as_array().unwrap();
        inputs.iter().map(|it| it["variable"].as_str().unwrap().to_owned()).collect()
    };
    let closed = symbols(&["--set", "closure=double-yield"]);
    assert!(closed.contains(&"Y".to_owned()) && !closed.contains(&"S_y".to_owned()), "{closed:?}");
    let beam = symbols(&["--set", "spring=prbm-cantilever"]);
    assert!(beam.contains(&"l_beam".to_owned()) && !beam.contains(&"k".to_owned()), "{beam:?}");
}
