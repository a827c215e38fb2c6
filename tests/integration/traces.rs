//! A run beside a measured trace or another program's histories, as a user meets it.

use std::fs;

use serde_json::Value;

use crate::support::{json, says};

const SCIPY: &str = "tests/cases/traces/baseline-scipy.csv";
const YANG_XI: &str = "tests/cases/traces/yang-xi.csv";

/// The histories of another program, by another method: each agrees over the whole time to a part of its peak. The force jumps at the
/// arrest, where rows of 2 us miss its end.
#[test]
fn valid_the_histories_of_another_program() {
    let found = json("run", &["--with", SCIPY]);
    assert_eq!(found["with"]["file"], SCIPY);
    let traces = found["with"]["traces"].as_array().unwrap();
    assert_eq!(traces.len(), 5);
    for trace in traces {
        let number = |key: &str| trace[key].as_f64().unwrap();
        let (name, size) = (trace["column"].as_str().unwrap(), number("measured_peak").abs());
        assert_eq!(trace["rows"], 501, "{name}");
        assert!(number("rms_difference") < 1e-3 * size, "{name}: {}", number("rms_difference"));
        assert!(number("greatest_difference").abs() < 5e-3 * size, "{name}");
        assert!((number("computed_end") - number("measured_end")).abs() < 1e-3 * size, "{name}");
    }
    assert_eq!(json("run", &[])["with"], Value::Null);
}

/// The one point of the photographs: 45.40 mm are computed where 42 mm were read.
#[test]
fn the_travel_of_yang_and_xi_is_off_by_3_4_mm() {
    let found = json("run", &["yang-xi", "--with", YANG_XI]);
    let trace = &found["with"]["traces"][0];
    let mm = |key: &str| 1e3 * trace[key].as_f64().unwrap();
    assert!((mm("measured_peak") - 42.0).abs() < 1e-9);
    assert!((mm("greatest_difference") - 3.4).abs() < 0.01, "{}", mm("greatest_difference"));
    let (page, _) = says("run", &["yang-xi", "--with", YANG_XI, "--plain"], 0);
    for words in [
        "beside tests/cases",
        "peak, measured",
        "42.00 mm",
        "RMS difference",
        "greatest difference 3.40 mm",
    ] {
        assert!(page.contains(words), "{words}: {page}");
    }
    let has_mark = |line: &&str| line.starts_with('|') && line.contains('M');
    let marked: Vec<&str> = page.lines().filter(has_mark).collect();
    // The legends of both displacement charts, and the point.
    assert_eq!(marked.len(), 3, "{page}");
}

/// The point is at 2.714 ms; the run of the baseline ends at its greatest displacement, 1.275 ms.
#[test]
fn a_trace_without_a_common_time_says_why() {
    let (page, _) = says("run", &["--with", YANG_XI], 0);
    let words = page.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        words.contains("the run, which ends at 1.275 ms; the first row is at 2.714 ms"),
        "{page}"
    );
    assert!(!page.contains("RMS difference"), "{page}");
    let (page, _) = says("run", &["--set", "horizon=3ms", "--with", YANG_XI], 0);
    assert!(page.contains("RMS difference"), "{page}");
}

/// The run ends at 1.275 ms: of five rows the last is not compared, and the trace's own peak and end, 2.2 mm, are not those shown.
#[test]
fn rows_after_the_end_of_the_run_are_counted() {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("trace.csv");
    let rows = "0,0\n10,0.01\n50,0.5\n100,1.6\n5000,2.2\n";
    fs::write(&path, format!("time [us],plate displacement [mm]\n{rows}")).unwrap();
    let with = ["--with", path.to_str().unwrap()];
    let trace = json("run", &with)["with"]["traces"][0].clone();
    assert_eq!((&trace["rows"], &trace["omitted_rows"]), (&4.into(), &1.into()));
    let (page, _) = says("run", &with, 0);
    let words = page.split_whitespace().collect::<Vec<_>>().join(" ");
    let told = "1 of 5 rows is omitted, since the run, which ends at 1.275 ms, has no value then: peak and end are those of the rows compared; run longer";
    assert!(words.contains(told), "{page}");
    let (page, _) = says("run", &["--set", "horizon=6ms", with[0], with[1]], 0);
    assert!(!page.contains("of 5 rows"), "{page}");
}

/// The workbench without a terminal prints the same.
#[test]
fn the_workbench_takes_it_too_and_a_picture_has_it() {
    let (page, _) = says("thesis-baseline", &["--with", SCIPY], 0);
    assert!(page.contains("beside tests/cases") && page.contains("RMS difference"), "{page}");
    let (drawn, _) = says("run", &["--with", SCIPY, "--svg", "-"], 0);
    assert!(drawn.contains("greatest difference") && drawn.contains("penetration (mm)"), "{drawn}");
}

#[test]
fn what_cannot_be_read_is_one_line_with_the_cure() {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("trace.csv");
    for (text, told) in [
        ("x_mm,force_kN\n0,1\n", "no column of time"),
        ("time_s,t_ms,force_kN\n0,0,1\n", "are columns of time: keep one"),
        ("time_ms,force_kN\n0,1\n1,2\n0.5,3\n", "sort the rows by time"),
        ("time_fortnight,force_kN\n0,1\n", "write s, ms or us"),
    ] {
        fs::write(&path, text).unwrap();
        for subcommand in ["run", "thesis-baseline"] {
            let (out, error) = says(subcommand, &["--with", path.to_str().unwrap()], 2);
            assert!(out.is_empty() && error.contains(told), "{subcommand}: {out}{error}");
            assert_eq!(error.trim_end().lines().count(), 1, "{error}");
        }
    }
    let (_, error) = says("run", &["--with", "gone.csv"], 2);
    assert!(error.contains("gone.csv") && error.contains("no such file"), "{error}");
}
