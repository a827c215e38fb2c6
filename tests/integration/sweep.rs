//! Sweeps as a script sees them.

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use serde_json::Value;

use crate::support::{Done, in_folder, json, says};

/// Run `cmra sweep` with arguments split at spaces, in a directory.
fn sweep(place: &Path, arguments: &str) -> Done {
    in_folder(place, &format!("sweep {arguments}"))
}

fn rows(text: &str) -> Vec<Vec<String>> {
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(text.as_bytes());
    let record = |record: csv::StringRecord| record.iter().map(str::to_owned).collect();
    reader.records().map(|row| record(row.unwrap())).collect()
}

#[test]
fn a_csv_has_the_axes_first_then_every_key_of_a_run() {
    let place = tempfile::tempdir().unwrap();
    let done = sweep(place.path(), "--over gamma=0.8..7:3 --over d=0..50mm:2 --csv -");
    assert_eq!(done.code, 0, "{}", done.err);
    let rows = rows(&done.out);
    assert_eq!(rows.len(), 1 + 6);
    assert_eq!(rows[0][..3], ["gamma", "d", "scene"]);
    let run = Command::new(env!("CARGO_BIN_EXE_cmra"))
        .current_dir(place.path())
        .env_clear()
        .env("HOME", place.path())
        .args(["run", "--json", "--set", "gamma=3.9", "--set", "d=50mm"])
        .output()
        .unwrap();
    let run: Value = serde_json::from_slice(&run.stdout).unwrap();
    let place_of = |name: &str| rows[0].iter().position(|have| have == name).unwrap();
    let row = &rows[4];
    assert_eq!(row[..2], ["3.9", "0.05"]);
    for (key, value) in run.as_object().unwrap() {
        if !rows[0].contains(key) {
            let elsewhere = [
                "title",
                "closure",
                "complete",
                "run_time_s",
                "error_estimate_basis",
                "no_limit",
                "method_reason",
                "energy_j",
                "events",
                "variables",
                "version",
                "criterion",
                "error_estimates",
                "penetration_at_most_m",
                "nose_protrusion_m",
                "plastic",
                // These need the series of a run.
                "max_plate_displacement_time_s",
                "mount_impulse_n_s",
            ];
            assert!(elsewhere.contains(&key.as_str()), "{key} is missing");
            continue;
        }
        let field = &row[place_of(key)];
        match value {
            Value::Null => assert_eq!(field, "", "{key}"),
            Value::Number(number) => {
                let (found, exact) = (field.parse::<f64>().unwrap(), number.as_f64().unwrap());
                // A run with a series takes other steps than one without: the last digits differ.
                let close = (found - exact).abs() <= 1e-10 * exact.abs() + 1e-12;
                assert!(close || key.contains("energy") || key.contains("estimate"), "{key}");
            }
            Value::String(text) => assert_eq!(field, text, "{key}"),
            Value::Array(list) => {
                let mut words: Vec<&str> = list.iter().filter_map(Value::as_str).collect();
                // A point of a sweep needs no series.
                words.extend(["series"].iter().filter(|_| key == "omitted"));
                assert_eq!(*field, words.join("; "), "{key}");
            }
            Value::Bool(_) | Value::Object(_) => panic!("{key}"),
        }
    }
}

/// Rows of undecided runs have the values so far of their object, named as lower bounds.
#[test]
fn a_row_of_an_undecided_run_has_its_lower_bounds() {
    let column = "theta=47.16deg h=5.6728mm gamma=10.5905 d=48.2349mm spring=column F_crit=27602.8 F_plat=18832.2 x_fall=4.10278mm";
    let pairs = column.split(' ').chain(["interface=plastic", "v_i=87.2332"]);
    let sets: Vec<&str> = pairs.flat_map(|pair| ["--set", pair]).collect();
    let found = json("run", &sets);
    let row = &json("sweep", &[&sets[..], &["--over", "v_i=80,87.2332"]].concat())["rows"][1];
    assert_eq!(row["outcome"], "moving");
    assert_eq!(row["lower_bounds"], "final_penetration_m; percent_of_baseline");
    let [one, other] = [&found, row].map(|it| it["final_penetration_m"].as_f64().unwrap());
    assert!((one / other - 1.0).abs() < 1e-9, "{one} {other}");
    let chosen = ["--over", "v_i=80,87.2332", "--outputs", "final_penetration_m"];
    let chosen = &json("sweep", &[&sets[..], &chosen].concat())["rows"][1];
    assert_eq!(chosen["lower_bounds"], "final_penetration_m");
    assert_eq!(chosen["final_penetration_m"], row["final_penetration_m"]);
    let page = says("compare", &sets, 0).0;
    assert!(page.contains("`cmra run` has lower bounds"), "{page}");
}

#[test]
fn a_list_of_values_gives_its_rows_in_its_order_from_options_and_from_files() {
    let place = tempfile::tempdir().unwrap();
    let listed = sweep(
        place.path(),
        "--over k=1MN/m,10kN/m --over gamma=1,3 --outputs stroke --csv list.csv",
    );
    assert_eq!(listed.code, 0, "{}", listed.err);
    let text = fs::read_to_string(place.path().join("list.csv")).unwrap();
    let found: Vec<[String; 2]> =
        rows(&text)[1..].iter().map(|row| [row[0].clone(), row[1].clone()]).collect();
    assert_eq!(found, [["1e6", "1"], ["1e6", "3"], ["10000", "1"], ["10000", "3"]]);
    // The file beside it has the list, and makes the same rows.
    let beside = fs::read_to_string(place.path().join("list.toml")).unwrap();
    assert!(beside.contains("values = [1e6, 10000.0]"), "{beside}");
    assert_eq!(sweep(place.path(), "./list.toml --csv -").out, text);
    let page = sweep(place.path(), "--over k=1MN/m,10kN/m");
    assert!(page.out.contains("k = 1e6, 10000 N/m^n, 2 points"), "{}", page.out);
}

#[test]
fn each_part_has_every_third_row_below_the_header() {
    let place = tempfile::tempdir().unwrap();
    let what = "figure-9.7 --over gamma=0.8..7:23 --over k=1e3..7.5e6:11:log";
    for format in ["", "--outputs all "] {
        let whole = sweep(place.path(), &format!("{what} {format}--threads 1 --csv -"));
        assert_eq!(whole.code, 0, "{}", whole.err);
        let whole: Vec<&str> = whole.out.lines().collect();
        assert_eq!(whole.len(), 1 + 23 * 11);
        for part in 1..=3 {
            let arguments = format!("{what} {format}--threads 2 --shard {part}/3 --csv -");
            let found = sweep(place.path(), &arguments).out;
            let rows = whole[1..].iter().skip(part - 1).step_by(3);
            let expected: Vec<&str> = whole[..1].iter().chain(rows).copied().collect();
            assert_eq!(found.lines().collect::<Vec<_>>(), expected);
        }
    }
}

/// The file beside a part makes the same part again.
#[test]
fn a_part_is_made_again_from_its_scene() {
    let place = tempfile::tempdir().unwrap();
    let what = "--over gamma=0.8..7:7 --outputs stroke_m --set k=1e6 --shard 2/3 --csv part2.csv";
    assert_eq!(sweep(place.path(), what).code, 0);
    let beside = fs::read_to_string(place.path().join("part2.toml")).unwrap();
    let again = "cmra sweep ./part2.toml --shard 2/3 --csv -";
    assert!(beside.contains(&format!("\n# again: {again}\n")), "{beside}");
    let part = fs::read_to_string(place.path().join("part2.csv")).unwrap();
    assert_eq!(in_folder(place.path(), again.strip_prefix("cmra ").unwrap()).out, part);
}

#[test]
fn json_is_one_object_with_the_same_rows() {
    let place = tempfile::tempdir().unwrap();
    let done = sweep(place.path(), "figure-9.4 --over b=0..2000:5 --json");
    let value: Value = serde_json::from_str(&done.out).unwrap();
    assert_eq!(value["axes"][0]["name"], "b");
    assert_eq!(value["rows"].as_array().unwrap().len(), 5);
    // A reader of JSON would not see a key that is there twice.
    assert_eq!((&value["complete"], &value["points_done"]), (&true.into(), &5.into()));
    for key in ["scene", "points", "axes", "outputs", "version", "rows", "complete"] {
        assert_eq!(done.out.matches(&format!("\n  \"{key}\":")).count(), 1, "{key}");
    }
    // Nothing stops the free plate.
    assert!(value["rows"][0]["max_plate_displacement_m"].is_null());
    assert_eq!(value["rows"][0]["outcome"], "arrested");
    // Depth at b = 1000 N s/m by classical Runge-Kutta in steps of 0.1 us, over that on a rigid mount.
    let depth = value["rows"][2]["percent_of_baseline"].as_f64().unwrap();
    assert!((depth - 100.0 * 5.836_233 / 7.113_055).abs() < 1e-4, "{depth}");
}

#[test]
fn a_perforated_point_keeps_its_row_and_says_so() {
    let place = tempfile::tempdir().unwrap();
    let done = sweep(
        place.path(),
        "rigid-mount --over v_i=230..240:2 --outputs percent_of_baseline,residual_velocity_m_s --csv -",
    );
    let rows = rows(&done.out);
    assert_eq!(rows[1][..3], ["230", "arrested", "not-measured"]);
    assert!((rows[1][3].parse::<f64>().unwrap() - 100.0).abs() < 1e-9 && rows[1][4].is_empty());
    assert_eq!(rows[2][1..4], ["perforated", "not-measured", ""]);
    assert!(rows[2][4].parse::<f64>().unwrap() > 0.0);
}

#[test]
fn a_failed_point_keeps_its_row_and_says_why() {
    let place = tempfile::tempdir().unwrap();
    // A horizon within the contact: that is `moving`, not failed, and the depth is a lower bound.
    let done = sweep(place.path(), "--set horizon=50us --over gamma=1..2:2 --csv -");
    assert_eq!(done.code, 0, "{}", done.err);
    let rows = rows(&done.out);
    let outcome = rows[0].iter().position(|name| name == "outcome").unwrap();
    let bounds = rows[0].iter().position(|name| name == "lower_bounds").unwrap();
    assert_eq!(rows[1][outcome], "moving");
    assert!(rows[1][bounds].contains("final_penetration_m"), "{:?}", rows[1]);
}

#[test]
fn bad_sweeps_are_refused_before_anything_runs() {
    let place = tempfile::tempdir().unwrap();
    for (arguments, fragments) in [
        ("--csv -", &["thesis-baseline", "--over gamma=0.8..7:101"][..]),
        ("--over k=0..1e6:5 --over k=0..1:3 --csv x.csv", &["axis k", "twice"]),
        ("--over x_stop=-1..1:5 --csv x.csv", &["x_stop=-1", "behind the plate's start"]),
        ("--over gamma=1..2:5 --shard 3/2 --csv x.csv", &["shard 3/2", "I/N"]),
        (
            "--over gamma=1..2:5 --outputs depth --csv x.csv",
            &["output depth", "did you mean `final_penetration_m`"],
        ),
    ] {
        let done = sweep(place.path(), arguments);
        assert_eq!(done.code, 2, "{arguments}: {}", done.err);
        assert_eq!(done.out, "");
        for fragment in fragments {
            assert!(done.err.contains(fragment), "{arguments}: {} lacks {fragment}", done.err);
        }
        assert!(!place.path().join("x.csv").exists());
    }
}

#[test]
fn a_set_value_of_a_swept_variable_is_reported_to_have_no_effect() {
    let place = tempfile::tempdir().unwrap();
    let done = sweep(place.path(), "figure-9.2 --set b=20 --set gamma=3 --csv -");
    assert_eq!(done.code, 0, "{}", done.err);
    assert!(done.err.contains("--set gamma=3 has no effect"), "{}", done.err);
    assert!(!done.err.contains("b=20"), "{}", done.err);
    // Nothing is cocked: the plate starts at 0, not at -0.
    let done = sweep(place.path(), "--over x_stop=-1..1:3 --csv -");
    assert!(done.err.contains("it must be 0 m or more"), "{}", done.err);
}

#[test]
fn an_existing_file_is_left_alone_unless_forced() {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("x.csv");
    fs::write(&path, "mine").unwrap();
    let what = "figure-9.2 --over gamma=1..2:3 --csv x.csv";
    let done = sweep(place.path(), what);
    assert_eq!(done.code, 2);
    assert!(done.err.contains("--force"), "{}", done.err);
    assert_eq!(fs::read_to_string(&path).unwrap(), "mine");
    let done = sweep(place.path(), &format!("{what} --force"));
    assert_eq!(done.code, 0, "{}", done.err);
    assert_eq!(rows(&fs::read_to_string(&path).unwrap()).len(), 4);
}

#[test]
fn the_scene_beside_the_rows_makes_them_again() {
    let place = tempfile::tempdir().unwrap();
    let read = |name: &str| fs::read_to_string(place.path().join(name)).unwrap();
    for (name, what) in [
        ("a", "figure-9.7 --set b=20 --over gamma=0.8..7:5 --over k=1e3..1e6:4:log"),
        ("b", "--over d=0..0.5:4 --outputs all"),
    ] {
        let done = sweep(place.path(), &format!("{what} --csv {name}.csv"));
        assert_eq!(done.code, 0, "{}", done.err);
        let sidecar = read(&format!("{name}.toml"));
        let again = sidecar.lines().find_map(|line| line.strip_prefix("# again: cmra sweep "));
        let again = sweep(place.path(), again.expect("how to make it again"));
        assert_eq!(again.code, 0, "{}", again.err);
        // The scene's name is the file's now.
        let rows_of = |text: &str| -> Vec<Vec<String>> {
            let mut rows = rows(text);
            if let Some(at) = rows[0].iter().position(|name| name == "scene") {
                for row in &mut rows {
                    row.remove(at);
                }
            }
            rows
        };
        assert_eq!(rows_of(&again.out), rows_of(&read(&format!("{name}.csv"))), "{what}");
    }
    // Someone's own scene is never replaced, and that is reported before anything runs.
    fs::write(place.path().join("mine.toml"), "format = 1\n").unwrap();
    let done = sweep(place.path(), "figure-9.2 --csv mine.csv --force");
    assert_eq!(done.code, 2, "{}", done.err);
    assert!(!place.path().join("mine.csv").exists());
}

#[cfg(unix)]
#[test]
fn an_interrupted_sweep_says_so_in_the_file_and_in_json() {
    let place = tempfile::tempdir().unwrap();
    let what = "sweep --over gamma=0.8..7:10000 --over k=1..7.5e6:1000 --json --csv x.csv";
    let child = begun(place.path(), what);
    stop(&child);
    let done = child.wait_with_output().unwrap();
    assert_eq!(done.status.code(), Some(1));
    let err = String::from_utf8(done.stderr).unwrap();
    assert!(err.contains("interrupted") && err.contains("are kept"), "{err}");
    let json = fs::read(place.path().join("out.txt")).unwrap();
    let value: Value = serde_json::from_slice(&json).unwrap();
    let rows = value["rows"].as_array().unwrap().len();
    assert_eq!((&value["complete"], &value["points_done"]), (&false.into(), &rows.into()));
    let table = fs::read_to_string(place.path().join("x.csv.partial")).unwrap();
    assert_eq!(table.lines().count(), 1 + rows);
    let beside = fs::read_to_string(place.path().join("x.csv.partial.toml")).unwrap();
    let missing = format!("# not complete: {rows} of 10000000 points");
    assert_eq!(beside.lines().nth(1), Some(missing.as_str()));
}

#[cfg(unix)]
#[test]
fn a_name_that_is_taken_meanwhile_costs_no_row() {
    let place = tempfile::tempdir().unwrap();
    let child = begun(place.path(), "sweep --over gamma=0.8..7:10000 --csv x.csv");
    fs::write(place.path().join("x.csv"), "mine").unwrap();
    let done = child.wait_with_output().unwrap();
    let err = String::from_utf8(done.stderr).unwrap();
    assert_eq!(done.status.code(), Some(1), "{err}");
    assert!(
        err.contains("`x.csv` already exists") && err.contains("is kept in `x.csv.partial`"),
        "{err}"
    );
    assert_eq!(fs::read_to_string(place.path().join("x.csv")).unwrap(), "mine");
    assert_eq!(
        rows(&fs::read_to_string(place.path().join("x.csv.partial")).unwrap()).len(),
        10_001
    );
}

#[test]
fn one_file_for_two_results_is_refused_before_anything_runs() {
    let place = tempfile::tempdir().unwrap();
    for (csv, svg) in [("a.csv", "./a.csv"), ("a.csv", "a.toml")] {
        let what = format!("--over gamma=1..2:3 --csv {csv} --svg {svg} --force");
        let done = sweep(place.path(), &what);
        assert_eq!(done.code, 2, "{}", done.err);
        assert!(done.err.contains("--csv writes to the same file"), "{}", done.err);
        assert_eq!(fs::read_dir(place.path()).unwrap().count(), 0);
    }
    // The table is not written either.
    fs::write(place.path().join("a.toml"), "# exported by cmra").unwrap();
    let done = sweep(place.path(), "--over gamma=1..2:3 --csv a.csv");
    assert_eq!(done.code, 2, "{}", done.err);
    assert!(!place.path().join("a.csv").exists());
}

/// A sweep that has written its first rows.
#[cfg(unix)]
fn begun(place: &Path, what: &str) -> std::process::Child {
    use std::process::Stdio;
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_cmra"));
    command.current_dir(place).env_clear().env("HOME", place).args(what.split(' '));
    // A pipe would fill.
    let out = fs::File::create(place.join("out.txt")).unwrap();
    let child = command.stdout(out).stderr(Stdio::piped()).spawn().unwrap();
    let written = || {
        let entries = fs::read_dir(place).unwrap();
        let sizes = entries.map(|entry| entry.unwrap().metadata().map_or(0, |found| found.len()));
        sizes.sum::<u64>()
    };
    crate::pty::wait_while("nothing is written", || written() < 10_000);
    child
}

#[cfg(unix)]
fn send(child: &std::process::Child, signal: rustix::process::Signal) {
    let pid = rustix::process::Pid::from_raw(i32::try_from(child.id()).unwrap()).unwrap();
    rustix::process::kill_process(pid, signal).unwrap();
}

#[cfg(unix)]
fn stop(child: &std::process::Child) {
    send(child, rustix::process::Signal::INT);
}

/// As `timeout` does, which sends its signal to the process and to the group.
#[cfg(unix)]
#[test]
fn a_signal_that_comes_twice_keeps_the_finished_rows() {
    let place = tempfile::tempdir().unwrap();
    let what = "sweep --over gamma=0.8..7:10000 --over k=1..7.5e6:1000 --csv x.csv";
    let mut child = begun(place.path(), what);
    for _ in 0..2 {
        send(&child, rustix::process::Signal::TERM);
    }
    assert_eq!(child.wait().unwrap().code(), Some(1));
    assert!(rows(&fs::read_to_string(place.path().join("x.csv.partial")).unwrap()).len() > 10);
}

/// Rows of a killed sweep remain in a file that the next sweep does not replace.
#[cfg(unix)]
#[test]
fn a_killed_sweep_leaves_its_rows_in_sight() {
    let place = tempfile::tempdir().unwrap();
    let what = "sweep --over gamma=0.8..7:10000 --over k=1..7.5e6:1000 --csv x.csv";
    let mut child = begun(place.path(), what);
    child.kill().unwrap();
    child.wait().unwrap();
    let left = || fs::read(place.path().join("x.csv.partial")).unwrap();
    let before = left();
    assert!(before.starts_with(b"gamma,k,") && before.len() >= 10_000);
    assert_eq!(in_folder(place.path(), "sweep --over gamma=1..2:3 --csv x.csv").code, 0);
    assert_eq!(left(), before);
    assert_eq!(rows(&fs::read_to_string(place.path().join("x.csv")).unwrap()).len(), 4);
}

/// The rows of the table and the chart count the same values; the depth of a perforation is none of them.
#[test]
fn what_the_table_shows_counts_in_charts() {
    let place = tempfile::tempdir().unwrap();
    let page = |arguments: &str| sweep(place.path(), arguments).out;
    let residual = page("--set h=5mm --over v_i=300..500:5 --outputs residual_velocity_m_s");
    assert!(residual.contains("5 perforated") && !residual.contains("no value"), "{residual}");
    let force = page("--set k=1e6 --over h=5mm,25mm --set v_i=300 --outputs peak_mount_force_n");
    assert!(force.contains("1 perforated") && !force.contains("no value"), "{force}");
    let depth = page("--over h=5mm,25mm --set v_i=300 --outputs final_penetration_m");
    assert!(depth.contains("1 of 2 points have no value"), "{depth}");
    let through = depth.lines().find(|line| line.contains("perforated")).unwrap();
    assert!(through.trim_end().ends_with('-'), "{depth}");
}

#[test]
fn the_page_shows_curves_and_maps() {
    let place = tempfile::tempdir().unwrap();
    let page = |arguments: &str| {
        let done = sweep(place.path(), arguments);
        assert_eq!(done.code, 0, "{}", done.err);
        let timed = |line: &&str| !line.contains(" in ");
        done.out.lines().filter(timed).collect::<Vec<_>>().join("\n")
    };
    insta::assert_snapshot!("sweep_page_one_axis", page("figure-9.4 --over b=0..2050:41"));
    let two = "figure-9.7 --over gamma=0.8..7:21 --over k=0..7.5e6:21";
    insta::assert_snapshot!("sweep_page_two_axes", page(two));
    let three = "--over gamma=0.8..7:3 --over k=0..7.5e6:3 --over v_i=100..400:4";
    insta::assert_snapshot!("sweep_page_three_axes", page(three));
}

/// A model without depth has none on a rigid mount either, which is no perforation.
#[test]
fn a_missing_depth_is_not_reported_as_a_perforation() {
    for mount in ["sprung", "rigid"] {
        let set = format!("mount={mount}");
        let scene = ["--set", "model=initial-velocity", "--set", &set];
        for (command, more) in [("run", &[][..]), ("sweep", &["--over", "v_i=10..20:2"])] {
            let page = says(command, &[&scene[..], more].concat(), 0).0;
            let is_said = ["perforates", "perforated"].iter().any(|word| page.contains(word));
            assert!(!is_said, "{command} {mount}: {page}");
        }
    }
}
