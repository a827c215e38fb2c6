//! Common behaviour of all studies' commands: tables can be made again from their sidecar, pages repeat the changes, and no request is
//! ignored.

use std::collections::HashSet;
use std::fs;
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

use cmra_studies::study::compare::{Hardware, compare};
use cmra_studies::study::context::{Context, never_cancel};
use cmra_studies::study::limit;
use cmra_studies::study::parallel::{Clock, Threads, WorkClock};
use cmra_studies::study::stability::map::{FixedStep, MapVariable, StabilityMapRequest, map};

use crate::pty::HANG;
use crate::support::{in_folder, scene};

/// Rows without the column of the scene's name, which is the file's in the second run.
fn rows(csv: &str) -> Vec<Vec<String>> {
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .comment(Some(b'#'))
        .from_reader(csv.as_bytes());
    let mut rows: Vec<Vec<String>> =
        reader.records().map(|row| row.unwrap().iter().map(str::to_owned).collect()).collect();
    if let Some(at) = rows[0].iter().position(|name| name == "scene") {
        for row in &mut rows {
            row.remove(at);
        }
    }
    rows
}

const STUDIES: [&str; 6] = [
    "limit rigid-mount --set h=3mm --set criterion=protrusion",
    "montecarlo --set gamma=2 --samples 50 --seed 3 --outputs percent_of_baseline",
    "seek --set b=20 --over gamma=1..5:5 --goal percent_of_baseline=75",
    "sensitivity --set gamma=2 --over d=0..0.1 --over k=1e5..1e6 --output percent_of_baseline",
    "compare --set gamma=2",
    "stability --set gamma=2 --map k --quick",
];

#[test]
fn the_file_beside_a_study_makes_its_rows_again() {
    let place = tempfile::tempdir().unwrap();
    for (number, words) in STUDIES.into_iter().enumerate() {
        let done = in_folder(place.path(), &format!("{words} --csv {number}.csv"));
        assert!(done.code <= 1, "{words}: {}", done.err);
        assert!(done.err.contains(&format!("wrote {number}.toml")), "{words}: {}", done.err);
        let beside = fs::read_to_string(place.path().join(format!("{number}.toml"))).unwrap();
        let again = beside.lines().find_map(|line| line.strip_prefix("# again: cmra ")).unwrap();
        assert!(again.contains(&format!("./{number}.toml")) && !again.contains("--set"), "{again}");
        // No digit depends on the number of threads.
        let second = in_folder(place.path(), &format!("{again} --threads 1"));
        assert_eq!(second.code, done.code, "{again}: {}", second.err);
        let first = fs::read_to_string(place.path().join(format!("{number}.csv"))).unwrap();
        assert_eq!(rows(&first), rows(&second.out), "{again}");
    }
}

#[test]
fn pages_list_the_changed_inputs() {
    let place = tempfile::tempdir().unwrap();
    for words in [
        "limit",
        "compare",
        "run",
        "sweep --over k=1e5..1e6:2",
        "montecarlo --samples 4",
        "seek --over k=1e5..1e6:3 --goal percent_of_baseline=65",
    ] {
        let done = in_folder(place.path(), &format!("{words} --set x_stop=30mm --set gamma=1.25"));
        assert!(done.out.contains("changed: x_stop=30mm, gamma=1.25\n"), "{words}: {}", done.out);
        let json = in_folder(place.path(), &format!("{words} --set gamma=1.25 --json"));
        assert!(json.out.starts_with(['{', '[']), "{words}: {}", json.out);
    }
    assert!(!in_folder(place.path(), "limit").out.contains("changed:"));
}

#[test]
fn two_results_for_standard_output_are_refused() {
    let place = tempfile::tempdir().unwrap();
    for words in ["run", "sweep --over k=1e5..1e6:2", "limit", "validate", "reproduce", "compare"] {
        let done = in_folder(place.path(), &format!("{words} --json --csv -"));
        assert_eq!((done.code, done.out.as_str()), (2, ""), "{words}");
        assert!(
            done.err.contains("--json and --csv - both write to standard output"),
            "{}",
            done.err
        );
    }
}

/// Counts the threads that do a study's pieces.
fn threads_of(study: &dyn Fn(Threads), given: usize) -> usize {
    let seen = Arc::new(Mutex::new(HashSet::new()));
    let of_thread: Clock = {
        let seen = Arc::clone(&seen);
        Arc::new(move || {
            seen.lock().unwrap().insert(thread::current().id());
            thread::yield_now();
            Duration::ZERO
        })
    };
    let clock = WorkClock::new(of_thread, Arc::new(|| Duration::ZERO));
    study(Threads::from(given).timed(&clock));
    seen.lock().unwrap().len()
}

/// On a busy machine one thread can have done everything before another one starts: then the study is run again.
#[test]
fn limits_comparisons_and_maps_use_the_threads_they_are_given() {
    let scene = Arc::new(scene("b=500"));
    let find = |threads| {
        limit::find(&scene, &mut Context::new(threads, &mut never_cancel)).unwrap();
    };
    let compare = |threads| {
        compare(&scene, Hardware::default(), &mut Context::new(threads, &mut never_cancel))
            .unwrap();
    };
    let (method, variable) = (FixedStep::ALL[0], MapVariable::ALL[0]);
    let wanted = StabilityMapRequest { method, variable, size: (8, 8) };
    let map = |threads| {
        map(&scene, wanted, &mut Context::new(threads, &mut never_cancel)).unwrap();
    };
    let studies: [(&str, &dyn Fn(Threads)); 3] =
        [("limit", &find), ("compare", &compare), ("stability --map", &map)];
    for (name, study) in studies {
        let deadline = Instant::now() + HANG;
        let alone = threads_of(study, 1);
        while threads_of(study, 3) <= alone {
            assert!(Instant::now() < deadline, "{name} uses one thread");
        }
    }
}
