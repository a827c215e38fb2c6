//! `cmra sensitivity` as a user meets it.

use serde_json::Value;

use crate::support::{cmra, says};

fn output(arguments: &[&str]) -> String {
    says("sensitivity", arguments, 0).0
}

const QUICK: [&str; 2] = ["--samples", "64"];

/// On a rigid mount the mass ratio does nothing, and what is left explains everything.
#[test]
fn an_input_without_effect_has_indices_of_zero() {
    let asked = ["--json", "--set", "mount=rigid", "--over", "gamma=1..2", "--over", "v_i=80..120"];
    let text = output(&[&asked[..], &["--output", "final_penetration_m"], &QUICK].concat());
    let found: Value = serde_json::from_str(&text).unwrap();
    let by = |symbol: &str| {
        let all = found["variables"].as_array().unwrap();
        all.iter().find(|entry| entry["variable"] == symbol).unwrap().clone()
    };
    assert_eq!(by("gamma")["swing"], 0.0);
    assert!(by("gamma")["sobol_total"].as_f64().unwrap().abs() < 1e-12);
    assert!((by("v_i")["sobol_total"].as_f64().unwrap() - 1.0).abs() < 0.2);
    assert!((found["output_of_scene"].as_f64().unwrap() - 7.113_055e-3).abs() < 5e-10);
    assert_eq!(found["samples_used"], 64);
}

#[test]
fn the_page_has_both_and_the_bounds_of_the_thesis() {
    let page = output(&QUICK);
    for words in ["% of rigid-mount depth", "one at a time", "Sobol", "####"] {
        assert!(page.contains(words), "{words}: {page}");
    }
    assert!(page.contains("4 % either way") && page.contains("--over"), "{page}");
    let named = output(&[&["--over", "gamma=1..2"][..], &QUICK].concat());
    assert!(!named.contains("either way"), "{named}");
    let gamma = |line: &str| line.split_whitespace().take(3).eq(["gamma", "0.8", "7"]);
    assert!(page.lines().any(gamma), "{page}");
    assert_eq!(page, output(&[&QUICK[..], &["--threads", "1"]].concat()));
    assert_ne!(page, output(&[&QUICK[..], &["--seed", "2"]].concat()));
    let table = output(&[&QUICK[..], &["--csv", "-"]].concat());
    // A heading, five variables of Table 9.2, and seven of the shot and the plate.
    assert_eq!(table.lines().count(), 13);
    assert!(table.starts_with("scene,output,variable,key,low,high,"));
}

#[test]
fn bad_options_are_refused_before_anything_runs() {
    for (arguments, told) in [
        (&["--samples", "1000"][..], "write 1024"),
        (&["--over", "gamma=2..2"], "both ends are 2"),
        (&["--over", "gama=1..2"], "did you mean `gamma`"),
        (&["--output", "depth"], "depth"),
        (
            &["array-stacked", "--output", "percent_of_baseline"],
            "a stack has none; take final_penetration_m",
        ),
    ] {
        let refused = cmra("sensitivity", arguments).assert().code(2);
        let text = String::from_utf8(refused.get_output().stderr.clone()).unwrap();
        assert!(text.contains(told), "{text}");
    }
}

/// Every shot at 400 m/s perforates, rigid mount or not: there is no percentage of a depth.
#[test]
fn without_the_result_there_are_no_bars_but_a_cure() {
    let scene = ["--set", "v_i=400", "--over", "gamma=1..2"];
    let (page, _) = says("sensitivity", &[&scene[..], &QUICK].concat(), 1);
    assert!(page.contains("no run has this result") && page.contains("--output"), "{page}");
    assert!(!page.contains('#'), "{page}");
}

/// Where shots perforate there is no percentage: the indices are those of the others, and the first line says so.
#[test]
fn indices_of_a_result_that_is_not_everywhere_are_conditional_from_the_first_line_on() {
    let asked = ["--over", "v_i=200..400", "--over", "gamma=1..2"];
    let first = |more: &[&str]| {
        let page = output(&[&asked[..], more, &QUICK].concat());
        page.split("\nthe scene itself").next().unwrap().to_owned()
    };
    let conditional = first(&[]);
    assert!(conditional.contains("Sobol's indices are of") && conditional.contains("of 64"));
    assert!(!first(&["--set", "h=100mm"]).contains("only"));
    // Also where the scene itself has none.
    let page = output(&[&asked[..], &["--output", "residual_velocity_m_s"], &QUICK].concat());
    assert!(page.contains("of the variance") && !page.contains("no run has this result"), "{page}");
}
