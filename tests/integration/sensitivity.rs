//! `cmra sensitivity` as a user meets it.

use serde_json::Value;

use crate::support::{cmra, json, printed, says};

/// The row of a variable.
fn row(found: &Value, symbol: &str) -> Value {
    let all = found["variables"].as_array().unwrap();
    all.iter().find(|entry| entry["variable"] == symbol).unwrap().clone()
}

/// The depth of a run of its own, m.
fn depth(pairs: &[&str]) -> f64 {
    let set: Vec<&str> = pairs.iter().flat_map(|pair| ["--set", pair]).collect();
    let text = says("run", &[&["--json"], &set[..]].concat(), 0).0;
    let run: Value = serde_json::from_str(&text).unwrap();
    run["final_penetration_m"].as_f64().unwrap()
}

/// The baseline, whose depths were computed by another program of the design's author: both ends of every row are those of single
/// runs, and the rows lie between the depths given there.
#[test]
fn valid_the_effects_on_the_baseline() {
    let found = json("sensitivity", &[]);
    for (symbol, low, high) in [
        ("gamma", "gamma=0.8", "gamma=7"),
        ("d", "d=0", "d=0.5"),
        ("k", "k=0", "k=7.5e6"),
        ("n", "n=0.1", "n=3"),
        ("b", "b=0", "b=2000"),
        ("v_i", "v_i=25", "v_i=400"),
        ("m_p", "m_p=7.375g", "m_p=118g"),
        ("R", "R=1.5875mm", "R=25.4mm"),
        ("h", "h=6.35mm", "h=101.6mm"),
        ("S_y", "S_y=38e6", "S_y=608e6"),
    ] {
        let row = row(&found, symbol);
        for (end, pair) in [("output_at_low", low), ("output_at_high", high)] {
            let (value, exact) = (row[end].as_f64().unwrap(), depth(&[pair]));
            assert!((value - exact).abs() < 1e-7 * exact, "{pair}: {value} {exact}");
        }
    }
    // In mm, from the design.
    for (symbol, least, greatest) in [
        ("gamma", 4.27, 6.49),
        ("d", 1.66, 4.57),
        ("k", 4.57, 4.93),
        ("b", 4.57, 6.36),
        ("v_i", 1.03, 31.75),
        ("h", 3.08, 5.45),
    ] {
        let row = row(&found, symbol);
        let mm = |key: &str| 1e3 * row[key].as_f64().unwrap();
        assert!((mm("least") - least).abs() < 6e-3, "{symbol}: {}", mm("least"));
        assert!((mm("greatest") - greatest).abs() < 6e-3, "{symbol}: {}", mm("greatest"));
    }
    assert_eq!(row(&found, "v_i")["outcome_at_high"], "perforated");
    // The slope, by a wider difference: its error is 4e-4 of it.
    let slope = row(&found, "gamma")["slope"].as_f64().unwrap();
    let wide = (depth(&["gamma=1.02"]) - depth(&["gamma=0.98"])) / 0.04;
    assert!((slope / wide - 1.0).abs() < 1e-3, "{slope} {wide}");
}

/// On a rigid mount the mass ratio does nothing.
#[test]
fn a_variable_without_effect_has_no_swing() {
    let asked = ["--set", "mount=rigid", "--over", "gamma=1..2", "--over", "v_i=80..120"];
    let found = json("sensitivity", &asked);
    assert_eq!(row(&found, "gamma")["swing"], 0.0);
    assert_eq!(row(&found, "gamma")["slope"], 0.0);
    assert_eq!(found["variables"][0]["variable"], "v_i", "the greatest comes first");
    assert!((found["output_of_scene"].as_f64().unwrap() - 7.113_055e-3).abs() < 5e-10);
}

#[test]
fn the_page_has_a_bar_for_each_variable_and_the_ranges_of_the_thesis() {
    let page = printed("sensitivity", &[]);
    for words in ["final depth", "one variable at a time", "95th percentile", "perforate"] {
        assert!(page.contains(words), "{words}: {page}");
    }
    assert!(page.contains("Table 9.2") && page.contains("--over"), "{page}");
    assert!(!printed("sensitivity", &["--over", "gamma=1..2"]).contains("Table 9.2"));
    let line = page.lines().find(|line| line.starts_with("gamma")).expect("a row of gamma");
    for words in ["|", "4.27 to 6.49 mm", "um for +0.1", "0.8 to 7"] {
        assert!(line.contains(words), "{words}: {line}");
    }
    assert!(page.lines().filter(|line| line.matches('|').count() == 2).count() == 12, "{page}");
    assert!(page.lines().all(|line| line.chars().count() <= 80), "{page}");
    assert!(printed("sensitivity", &["--glyphs", "block"]).contains('█') && page.is_ascii());
    assert_eq!(page, printed("sensitivity", &["--threads", "1"]));
    let table = printed("sensitivity", &["--csv", "-"]);
    // A heading, five variables of Table 9.2, and seven that are given.
    assert_eq!(table.lines().count(), 13);
    assert!(table.starts_with("scene,output,variable,key,value,low,high,"));
}

#[test]
fn bad_options_are_refused_before_anything_runs() {
    for (arguments, told) in [
        (&["--over", "gamma=2..2"][..], "both ends are 2"),
        (&["--over", "gamma=1..2", "--over", "gamma=2..3"], "given twice"),
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
    let scene = ["--set", "v_i=400", "--over", "gamma=1..2", "--output", "percent_of_baseline"];
    let (page, _) = says("sensitivity", &scene, 1);
    assert!(page.contains("no run has this result") && page.contains("--output"), "{page}");
    assert!(!page.contains('|'), "{page}");
}
