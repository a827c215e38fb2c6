//! `cmra optimise` as a user meets it.

use serde_json::Value;

use crate::support::{cmra, says};

const QUICK: [&str; 3] = ["--samples", "512", "--no-feasibility"];

/// The heaviest free plate with a depth of at most 4.568088344392 mm has gamma = 1.
#[test]
fn a_best_design_under_a_constraint_is_the_closed_form() {
    let asked = ["free-plate", "--over", "gamma=0.8..7", "--maximise", "plate_mass_kg", "--json"];
    let bound = ["--subject-to", "final_penetration_m<=4.568088344392mm"];
    let (text, _) = says("optimise", &[&asked[..], &bound, &QUICK].concat(), 0);
    let found: Value = serde_json::from_str(&text).unwrap();
    let designs = found["designs"].as_array().unwrap();
    assert_eq!(designs.len(), 1);
    assert!((designs[0]["gamma"].as_f64().unwrap() - 1.0).abs() < 1e-6, "{text}");
    assert!((designs[0]["plate_mass_kg"].as_f64().unwrap() - 0.0295).abs() < 1e-7);
}

#[test]
fn a_front_is_that_of_the_scenes_law_whatever_the_threads() {
    let over = ["--over", "gamma=0.8..7", "--over", "k=1e4..7.5e6:log", "--over", "d=0..0.1"];
    let minimise = ["--minimise", "final_penetration_m,stroke_m"];
    let asked = [&over[..], &minimise, &QUICK].concat();
    let (page, _) = says("optimise", &asked, 0);
    assert!(page.contains("interface fused: a front of"), "{page}");
    // Cocked by 0.1 m an interface gives way: beside such a design stands what a plastic one comes to.
    assert!(page.contains("on a plastic interface") && page.contains("plastic: "), "{page}");
    assert_eq!(page, says("optimise", &[&asked[..], &["--threads", "1"]].concat(), 0).0);
    let plastic = says("optimise", &[&asked[..], &["--set", "interface=plastic"]].concat(), 0).0;
    assert!(plastic.contains("interface plastic: a front of"), "{plastic}");
    let (csv, _) = says("optimise", &[&asked[..], &["--csv", "-"]].concat(), 0);
    assert!(csv.starts_with(
        "scene,interface,gamma,k,d,final_penetration_m,stroke_m,outcome,held,verdict,plastic,warnings\n"
    ));
    // A row of a front runs to the same numbers.
    let row: Vec<&str> = csv.lines().nth(1).unwrap().split(',').collect();
    let sets = [2, 3, 4].map(|at| format!("{}={}", ["gamma", "k", "d"][at - 2], row[at]));
    let mut run = cmra("run", &["--json"]);
    for set in &sets {
        run.args(["--set", set]);
    }
    let run: Value = serde_json::from_slice(&run.output().unwrap().stdout).unwrap();
    for (at, key) in [(5, "final_penetration_m"), (6, "stroke_m")] {
        let (there, here): (f64, f64) = (row[at].parse().unwrap(), run[key].as_f64().unwrap());
        assert!((there - here).abs() <= 1e-8 * here, "{key} {there} {here}");
    }
}

#[test]
fn an_objective_that_no_design_has_is_named_with_the_reason() {
    let scene = ["--threat", "m2-ap-core", "--material", "aa6082-t651", "--set", "face=100mm"];
    let task = ["--over", "h=2mm..12mm", "--minimise", "areal_mass_kg_m2"];
    let (page, _) = says("optimise", &[&scene[..], &task, &QUICK].concat(), 1);
    let page = page.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(page.contains("interface fused: no design ("), "{page}");
    assert!(
        page.contains("areal_mass_kg_m2 does not exist in")
            && page.contains("v_i = 878 m/s perforates"),
        "{page}"
    );
}

/// The spring sized for 20 m/s holds no faster shot, however thick the plate.
#[test]
fn a_limit_beside_a_mass_is_that_of_the_plate() {
    let task = ["--set", "k=1e3", "--set", "v_i=20", "--over", "h=10mm..12mm"];
    let effort = ["--samples", "64", "--no-feasibility", "--json"];
    let front = ["--minimise", "areal_mass_kg_m2", "--maximise", "limit_velocity_m_s"];
    let (text, _) = says("optimise", &[&task[..], &front, &effort].concat(), 0);
    let found: Value = serde_json::from_str(&text).unwrap();
    let designs = found["designs"].as_array().unwrap();
    assert!(designs.iter().all(|it| it["limit_velocity_m_s"].as_f64().unwrap() > 100.0));
    assert!(found["warnings"].to_string().contains("whatever its springs have to store"));
}

#[test]
fn unsatisfiable_constraints_exit_1_and_bad_requests_are_refused() {
    let over = ["--over", "gamma=0.8..7"];
    let impossible = ["--subject-to", "percent_of_baseline<=1"];
    let (page, _) = says("optimise", &[&over[..], &impossible, &QUICK].concat(), 1);
    assert!(page.contains("no design satisfies every constraint"), "{page}");
    for (arguments, told) in [
        (&["--samples", "7"][..], "7 is not in 64.."),
        (&["--subject-to", "stroke_m<5"], "QUANTITY<=VALUE"),
        (&["--subject-to", "stroke_m<=5kg"], "`kg` is not a unit"),
        (&["--minimise", "depth"], "output depth"),
        (&["--over", "gamma=2..2"], "both ends are 2"),
        (&["--set", "mount=rigid"], "no variable of Table 9.2"),
    ] {
        let (_, error) = says("optimise", arguments, 2);
        assert!(error.contains(told), "{error}");
    }
}

/// A face of 3 diameters weighs 3.387 times the projectile: no design of a smaller gamma is feasible, and the page says why.
#[test]
fn without_a_feasible_design_the_checks_are_named() {
    let over = ["free-plate", "--over", "gamma=0.8..3", "--minimise", "plate_mass_kg"];
    let (page, _) = says("optimise", &[&over[..], &["--samples", "64"]].concat(), 1);
    assert!(page.contains("infeasible, of ") && page.contains("plate face"), "{page}");
}

/// A plate without spring, damper and stop.
#[test]
fn a_design_that_nothing_holds_says_so() {
    let over = ["--over", "gamma=4..7", "--minimise", "plate_mass_kg", "--samples", "64"];
    for (k, is_held) in [("k=0", false), ("k=1e5", true)] {
        let asked = [&["--set", k][..], &over].concat();
        let (page, _) = says("optimise", &asked, 0);
        for mark in ["\n1*", "* nothing stops plate and projectile"] {
            assert_eq!(page.contains(mark), !is_held, "{page}");
        }
        let (text, _) = says("optimise", &[&asked[..], &["--json"]].concat(), 0);
        let found: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(found["designs"][0]["held"], is_held, "{text}");
    }
}
