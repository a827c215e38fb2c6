//! Outputs that appear in several places: one number, one name, nothing cut, no format under another's name.

use serde_json::Value;

use crate::support::{json, says};

const README: [&str; 14] = [
    "--threat",
    "borvik-hemisphere",
    "--material",
    "aa6061-t6511",
    "--set",
    "v_i=150",
    "--set",
    "h=12mm",
    "--set",
    "face=300mm",
    "--set",
    "k=1MN/m",
    "--absorber",
    "steel-coil-1200",
];

/// Masses of the spring by both commands follow from the wire's 1200 `MPa`. The mass of `design` is for all energy after the collision; the run leaves a little of it
/// in the hole.
#[test]
fn a_spring_is_sized_alike_by_formulas_and_by_the_comparison() {
    let rows = json("design", &README);
    let rows = rows["rows"].as_array().or(rows.as_array()).unwrap();
    let spring =
        |row: &&Value| row["name"].as_str().unwrap().starts_with("least mass of the spring");
    let by_formula = rows.iter().find(spring).unwrap()["value"].as_f64().unwrap();
    let by_run = json("compare", &README)["spring_mass_kg"].as_f64().unwrap();
    assert!((by_formula / by_run - 1.0).abs() < 0.01, "{by_formula} {by_run}");
}

#[test]
fn a_scene_is_named_alike_in_every_table() {
    for arguments in
        [&["--compare", "models", "--csv", "-"][..], &["--compare", "models", "--json"]]
    {
        let table = says("run", arguments, 0).0;
        assert!(table.contains("thesis-baseline"), "{table}");
        assert!(!table.contains("Baseline of chapter 9"), "{table}");
    }
}

/// A program that reads a pipe cannot ask for the rest.
#[test]
fn warnings_go_into_a_pipe_in_full() {
    let scene = ["--set", "gamma=0.05", "--set", "k=7.5e6", "--set", "d=0.5"];
    let commands: [(&str, &[&str]); 5] = [
        ("run", &[]),
        ("limit", &[]),
        ("compare", &[]),
        ("montecarlo", &["--samples", "20"]),
        ("seek", &["--over", "b=0..100:3", "--goal", "stroke_m=0.95"]),
    ];
    for (command, more) in commands {
        let arguments = [&scene[..], more].concat();
        let page = says(command, &arguments, 0).0;
        let page = page.split_whitespace().collect::<Vec<_>>().join(" ");
        let object = json(command, &arguments);
        let warnings = object["warnings"].as_array().unwrap();
        assert!(warnings.len() > 1, "{command}");
        for warning in warnings {
            assert!(page.contains(warning.as_str().unwrap()), "{command}: {warning}\n{page}");
        }
    }
}

#[test]
fn no_format_is_written_under_the_name_of_another() {
    let place = tempfile::tempdir().unwrap();
    let at = |name: &str| place.path().join(name).display().to_string();
    for (option, name, cure) in [
        ("--csv", "run.xlsx", "run.csv"),
        ("--csv", "run.JSON", "run.csv"),
        ("--csv", "run.toml", "run.csv"),
        ("--svg", "run.png", "run.svg"),
    ] {
        let error = says("run", &[option, &at(name)], 2).1;
        assert!(error.contains(name) && error.contains(cure), "{error}");
    }
    assert_eq!(std::fs::read_dir(place.path()).unwrap().count(), 0);
    for name in ["a.csv", "b.CSV", "c.txt", "d", "e.2"] {
        says("run", &["--csv", &at(name)], 0);
    }
}

#[test]
fn a_map_names_its_vertical_axis_once() {
    let page = says("stability", &["--map", "k", "--quick"], 0).0;
    assert_eq!(page.matches("up: k").count(), 1, "{page}");
}

#[test]
fn rows_that_texts_cite_exist() {
    let claims: Vec<&str> = cmra_studies::study::thesis::claims().map(|claim| claim.id).collect();
    let mut cited = 0;
    for it in &cmra_studies::study::validation::measurements().not_checked {
        for text in [it.says, it.why, it.source] {
            let Some((_, rows)) = text.split_once("rows ") else { continue };
            let rows = rows.split("of `cmra reproduce`").next().unwrap();
            for row in rows.split([' ', ',']).filter(|word| word.contains('-')) {
                assert!(claims.contains(&row), "{}: {row}", it.id);
                cited += 1;
            }
        }
    }
    assert!(cited >= 2);
}

/// The digits, whoever computes them.
#[test]
fn threads_change_no_digit() {
    let cases: [(&str, &[&str]); 3] = [
        ("limit", &["--set", "b=500", "--csv", "-"]),
        ("compare", &["--set", "b=500", "--csv", "-"]),
        ("stability", &["--map", "k", "--quick", "--csv", "-"]),
    ];
    for (command, arguments) in cases {
        let by = |threads| says(command, &[arguments, &["--threads", threads]].concat(), 0).0;
        assert_eq!(by("1"), by("3"), "{command}");
    }
}
