//! `cmra optimise` as a user meets it.

use serde_json::Value;

use crate::support::{cmra, says};

fn out(arguments: &[&str], code: i32) -> (String, String) {
    says("optimise", arguments, code)
}

const QUICK: [&str; 5] = ["--population", "20", "--generations", "15", "--no-feasibility"];

/// Of free plates no deeper than 4.568088344392 mm the heaviest has gamma = 1 (model page, section 2).
#[test]
fn a_best_design_under_a_constraint_is_the_closed_form() {
    let asked = ["free-plate", "--over", "gamma=0.8..7", "--maximise", "plate_mass_kg", "--json"];
    let bound = ["--subject-to", "final_penetration_m<=4.568088344392mm", "--laws", "fused"];
    let (text, _) = out(&[&asked[..], &bound, &QUICK].concat(), 0);
    let found: Value = serde_json::from_str(&text).unwrap();
    let designs = found["fronts"][0]["designs"].as_array().unwrap();
    assert_eq!(designs.len(), 1);
    assert!((designs[0]["gamma"].as_f64().unwrap() - 1.0).abs() < 1e-6, "{text}");
    assert!((designs[0]["plate_mass_kg"].as_f64().unwrap() - 0.0295).abs() < 1e-7);
}

#[test]
fn a_front_has_both_laws_and_the_designs_of_the_thesis() {
    let over = ["--over", "gamma=0.8..7", "--over", "k=1e4..7.5e6:log", "--over", "d=0..0.1"];
    let minimise = ["--minimise", "final_penetration_m,stroke_m"];
    let asked = [&over[..], &minimise, &QUICK].concat();
    let (page, _) = out(&asked, 0);
    for words in ["interface fused", "interface plastic", "the scene itself", "cocked cantilever"] {
        assert!(page.contains(words), "{page} lacks {words}");
    }
    assert_eq!(page, out(&[&asked[..], &["--threads", "1"]].concat(), 0).0);
    assert_ne!(page, out(&[&asked[..], &["--seed", "2"]].concat(), 0).0);
    let (csv, _) = out(&[&asked[..], &["--csv", "-"]].concat(), 0);
    assert!(csv.starts_with(
        "scene,interface,design,gamma,k,d,final_penetration_m,stroke_m,outcome,warnings\n"
    ));
    // A row of a front runs to the same numbers.
    let row: Vec<&str> = csv.lines().nth(1).unwrap().split(',').collect();
    let sets = [3, 4, 5].map(|at| format!("{}={}", ["gamma", "k", "d"][at - 3], row[at]));
    let mut run = cmra("run", &["--json"]);
    for set in &sets {
        run.args(["--set", set]);
    }
    let run: Value = serde_json::from_slice(&run.output().unwrap().stdout).unwrap();
    for (at, key) in [(6, "final_penetration_m"), (7, "stroke_m")] {
        let (there, here): (f64, f64) = (row[at].parse().unwrap(), run[key].as_f64().unwrap());
        assert!((there - here).abs() <= 1e-8 * here, "{key} {there} {here}");
    }
}

#[test]
fn an_objective_that_no_design_has_is_named_with_the_reason() {
    let scene = ["--threat", "m2-ap-core", "--material", "aa6082-t651", "--set", "face=100mm"];
    let task = ["--over", "h=2mm..12mm", "--minimise", "areal_mass_kg_m2", "--laws", "fused"];
    let (page, _) = out(&[&scene[..], &task, &QUICK].concat(), 1);
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
    let task = ["--set", "k=1e3", "--set", "v_i=20", "--over", "h=10mm..12mm", "--laws", "fused"];
    let effort = ["--population", "8", "--generations", "0", "--no-feasibility", "--json"];
    let front = ["--minimise", "areal_mass_kg_m2", "--maximise", "limit_velocity_m_s"];
    let (text, _) = out(&[&task[..], &front, &effort].concat(), 0);
    let found: Value = serde_json::from_str(&text).unwrap();
    let designs = found["fronts"][0]["designs"].as_array().unwrap();
    assert!(designs.iter().all(|it| it["limit_velocity_m_s"].as_f64().unwrap() > 100.0));
    assert!(found["warnings"].to_string().contains("whatever its springs have to store"));
}

#[test]
fn unsatisfiable_constraints_exit_1_and_bad_requests_are_refused() {
    let over = ["--over", "gamma=0.8..7", "--laws", "fused"];
    let impossible = ["--subject-to", "percent_of_baseline<=1"];
    let (page, _) = out(&[&over[..], &impossible, &QUICK].concat(), 1);
    assert!(page.contains("no design satisfies every constraint"), "{page}");
    for (arguments, told) in [
        (&["--population", "7"][..], "even number"),
        (&["--subject-to", "stroke_m<5"], "QUANTITY<=VALUE"),
        (&["--subject-to", "stroke_m<=5kg"], "`kg` is not a unit"),
        (&["--minimise", "depth"], "output depth"),
        (&["--over", "gamma=2..2"], "both ends are 2"),
        (&["--set", "mount=rigid"], "no variable of Table 9.2"),
    ] {
        let (_, error) = out(arguments, 2);
        assert!(error.contains(told), "{error}");
    }
}
