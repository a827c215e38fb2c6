//! `cmra accuracy` as a user meets it: page, CSV, JSON, exit status. What is asserted are errors and rows, never a time.

use std::path::Path;

use serde_json::Value;

fn cmra(arguments: &[&str]) -> std::process::Output {
    crate::support::program().args(arguments).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

#[test]
fn the_page_has_chart_table_answers_and_reasons() {
    let output = cmra(&["accuracy", "--quick"]);
    assert!(output.status.success());
    let page = text(&output.stdout);
    for part in [
        "thesis-baseline: error against run time",
        "relative error",
        "printed scheme: 29 % off at any step",
        "DOP853 + events",
        "contact kernel",
        "by auto at tol",
        "omitted",
        "motion after the contact",
        "1e-6: ",
        "stored digits, row S2",
    ] {
        assert!(page.contains(part), "{part} is missing from\n{page}");
    }
    assert!(page.is_ascii());
}

#[test]
fn pages_of_odd_scenes_keep_to_80_columns() {
    for changes in ["", "x_stop=0.001", "spring=bistable", "n=0.1 k=1e6", "theta=80deg h=1e-3"] {
        let mut arguments = vec!["accuracy", "--quick"];
        for change in changes.split_whitespace() {
            arguments.extend(["--set", change]);
        }
        let output = cmra(&arguments);
        assert!(output.status.success(), "{changes}: {}", text(&output.stderr));
        let page = text(&output.stdout);
        let long: Vec<&str> = page.lines().filter(|line| line.chars().count() > 80).collect();
        assert!(long.is_empty(), "{changes}: {long:#?}");
    }
}

#[test]
fn csv_keeps_a_row_for_each_point_with_the_reason_for_a_missing_result() {
    // The printed listing knows no stop.
    let scenes = ["accuracy", "--set", "x_stop=1mm"];
    let output = cmra(&[&scenes[..], &["--quick", "--csv", "-"]].concat());
    assert!(output.status.success());
    let mut reader = csv::Reader::from_reader(output.stdout.as_slice());
    let headers = reader.headers().unwrap().clone();
    let place = |name: &str| headers.iter().position(|header| header == name).unwrap();
    let (mut refused, mut points) = (0, 0);
    for row in reader.records() {
        let row = row.unwrap();
        points += 1;
        let failed = !row[place("refused")].is_empty();
        assert_eq!(row[place("error")].is_empty(), failed);
        assert_eq!(row[place("run_time_s_min")].is_empty(), failed);
        refused += usize::from(failed);
        if !failed {
            let error: f64 = row[place("error")].parse().unwrap();
            let floor: f64 = row[place("reference_uncertainty")].parse().unwrap();
            assert!(error >= floor);
        }
    }
    assert!(refused >= 1 && points > 20);
}

#[test]
fn json_is_an_object_with_references_answers_and_points() {
    let output = cmra(&["accuracy", "--quick", "--json", "--set", "k=1e6", "--set", "n=0.5"]);
    assert!(output.status.success());
    let scene: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(scene["references"][0]["basis"], "stored digits, row S4");
    assert_eq!(scene["answers"][1]["error"], 1e-6);
    assert!(scene["answers"][1]["method"].is_string());
    let points = scene["points"].as_array().unwrap();
    let auto = points.iter().filter(|point| point["letter"] == "A");
    let least = auto.filter_map(|point| point["error"].as_f64()).fold(1.0, f64::min);
    assert!(least < 1e-9, "{least}");
}

#[test]
fn a_file_is_written_once_and_bad_input_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("accuracy.csv");
    let path = path.to_str().unwrap();
    let write = ["accuracy", "rigid-mount", "--quick", "--csv", path];
    assert!(cmra(&write).status.success());
    let again = cmra(&write);
    assert_eq!(again.status.code(), Some(2));
    assert!(text(&again.stderr).contains("already exists"));
    assert!(Path::new(path).exists());
    let beside = std::fs::read_to_string(Path::new(path).with_extension("toml")).unwrap();
    assert!(beside.contains("# again: cmra accuracy ./accuracy.toml --quick --csv -"), "{beside}");
    let changed = cmra(&["accuracy", "--quick", "--set", "gamma=2"]);
    assert!(text(&changed.stdout).starts_with("changed: gamma=2\n"), "{}", text(&changed.stdout));
    let unknown = cmra(&["accuracy", "no-such-scene"]);
    assert_eq!(unknown.status.code(), Some(2));
    let refused = cmra(&["accuracy", "--set", "gamma=-1"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(text(&refused.stderr).contains("gamma"));
}

/// Methods that know the thesis's spring only keep their rows and say why; all others run, compared with one another.
#[test]
fn springs_of_every_kind_are_measured() {
    let output = cmra(&["accuracy", "concept-helical-spring", "--quick"]);
    assert!(output.status.success());
    let page = text(&output.stdout);
    assert!(page.contains("not applicable: only a massless"), "{page}");
    let output = cmra(&["accuracy", "concept-buckling-tube", "--quick", "--csv", "-"]);
    let mut reader = csv::Reader::from_reader(output.stdout.as_slice());
    let headers = reader.headers().unwrap().clone();
    let place = |name: &str| headers.iter().position(|header| header == name).unwrap();
    let mut best = std::collections::BTreeMap::new();
    for row in reader.records().map(Result::unwrap) {
        let error: f64 = row[place("error")].parse().unwrap_or(f64::INFINITY);
        let least = best.entry(row[place("letter")].to_owned()).or_insert(f64::INFINITY);
        *least = if error < *least { error } else { *least };
    }
    for letter in ["D", "I", "N", "A"] {
        assert!(best[letter] < 1e-10, "{letter}: {best:?}");
    }
    assert!(best["T"].is_infinite(), "{best:?}");
}

#[test]
fn the_stability_map_names_its_variable() {
    let output = cmra(&["stability", "--map", "k", "concept-helical-spring"]);
    assert_eq!(output.status.code(), Some(2));
    let told = text(&output.stderr);
    for words in ["helix", "varies k, n or b", "set spring = power-law"] {
        assert!(told.contains(words), "{told}");
    }
}
