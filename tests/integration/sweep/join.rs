//! Parts of a sweep and what joins them.

use std::fs;
use std::path::Path;

use super::{Done, cmra};

const WHAT: &str = "sweep figure-9.7 --over gamma=0.8..7:5 --over k=1e3,1e6,1e4";

fn ok(place: &Path, arguments: &str) -> Done {
    let done = cmra(place, arguments);
    assert_eq!(done.code, 0, "{arguments}: {}", done.err);
    done
}

/// Parts 1 to 3 of a sweep in `NAME1.csv` to `NAME3.csv`.
fn parts(place: &Path, name: &str, options: &str) {
    for part in 1..=3 {
        ok(place, &format!("{WHAT} {options} --shard {part}/3 --csv {name}{part}.csv"));
    }
}

#[test]
fn joined_parts_are_the_file_of_one_run_to_the_byte() {
    let place = tempfile::tempdir().unwrap();
    let read = |name: &str| fs::read(place.path().join(name)).unwrap();
    for options in [
        "",
        "--outputs all --csv-style crlf",
        "--design lhs --points 20 --seed 3",
        "--csv-style excel-eu",
    ] {
        ok(place.path(), &format!("{WHAT} {options} --csv all.csv --force"));
        let (table, scene) = (read("all.csv"), read("all.toml"));
        parts(place.path(), "p", &format!("{options} --force"));
        ok(place.path(), "join p2.csv p3.csv p1.csv --csv all.csv --force");
        assert_eq!((read("all.csv"), read("all.toml")), (table.clone(), scene), "{options}");
        assert_eq!(ok(place.path(), "join p1.csv p2.csv p3.csv").out.as_bytes(), table);
    }
}

#[test]
fn gaps_doubles_mixtures_and_changed_parts_are_refused_in_one_line() {
    let place = tempfile::tempdir().unwrap();
    parts(place.path(), "p", "");
    parts(place.path(), "other", "--set v_i=90");
    parts(place.path(), "sobol", "--design sobol --points 15");
    ok(place.path(), &format!("{WHAT} --shard 1/2 --csv half.csv"));
    ok(place.path(), &format!("{WHAT} --shard 2/3 --meta inline --csv inline.csv"));
    ok(place.path(), &format!("{WHAT} --csv whole.csv"));
    let copy = |from: &str, to: &str, change: fn(&str) -> String| {
        let read = |name: &str| fs::read_to_string(place.path().join(name)).unwrap();
        fs::write(place.path().join(format!("{to}.csv")), change(&read(&format!("{from}.csv"))))
            .unwrap();
        fs::write(place.path().join(format!("{to}.toml")), read(&format!("{from}.toml"))).unwrap();
    };
    copy("p2", "short", |text| text.split_inclusive('\n').take(2).collect());
    copy("p2", "swapped", |text| text.split_inclusive('\n').rev().collect());
    copy("p2", "again", str::to_owned);
    copy("p2", "fused", |text| text.replacen('\n', "", 1));
    copy("p2", "unended", |text| text.trim_end().to_owned());
    copy("p2", "wider", |text| text.replacen('\n', ",1\n", 1));
    copy("p2", "blank", |text| text.replacen('\n', "\n\n", 1));
    copy("p2", "crlf", |text| text.replace('\n', "\r\n"));
    copy("p2", "bom", |text| format!("\u{feff}{text}"));
    copy("p2", "edited", |text| text.replacen("arrested", "separated", 1));
    copy("p1", "headed", |text| text.replacen("outcome", "ending", 1));
    copy("p2", "moved", str::to_owned);
    let moved = place.path().join("moved.toml");
    let text = fs::read_to_string(&moved).unwrap();
    fs::write(moved, text.replace("# shard: 2/3", "# shard: 3/3")).unwrap();
    for (named, fragments) in [
        ("p1 p3", &["part 2/3 is missing", "--shard 2/3"][..]),
        ("p1 p2 p3 again", &["`p2.csv` and `again.csv` are both part 2/3"]),
        ("p1 other2 p3", &["different sweeps", "v_i is 100 in one and 90 in the other"]),
        ("p1 sobol2 p3", &["different sweeps", "the design is factorial in one and sobol"]),
        ("half p2 p3", &["different sweeps", "the number of parts is 2 in one and 3"]),
        ("p1 inline p3", &["`inline.csv` has no `inline.toml` beside it"]),
        ("p1 whole p3", &["`whole.csv`: not a part of a sweep"]),
        ("p1 short p3", &["`short.csv`", "was changed after it was written", "--shard 2/3"]),
        ("p1 swapped p3", &["`swapped.csv`", "was changed"]),
        ("p1 fused p3", &["`fused.csv`", "was changed"]),
        ("p1 unended p3", &["`unended.csv`", "was changed"]),
        ("p1 wider p3", &["`wider.csv`", "was changed"]),
        ("p1 blank p3", &["`blank.csv`", "was changed"]),
        ("p1 crlf p3", &["`crlf.csv`", "was changed"]),
        ("p1 bom p3", &["`bom.csv`", "was changed"]),
        ("p1 edited p3", &["`edited.csv`", "was changed"]),
        ("headed p2 p3", &["`headed.csv`", "was changed", "--shard 1/3"]),
        ("p1 p2 moved", &["`moved.toml` beside it was changed"]),
        ("p1 none p3", &["`none.csv`", "no such file"]),
    ] {
        let files: Vec<String> = named.split(' ').map(|name| format!("{name}.csv")).collect();
        let done = cmra(place.path(), &format!("join {} --csv out.csv", files.join(" ")));
        assert_eq!((done.code, done.err.lines().count()), (2, 1), "{named}: {}", done.err);
        for fragment in fragments {
            assert!(done.err.contains(fragment), "{named}: {}", done.err);
        }
        assert!(!place.path().join("out.csv").exists(), "{named}");
    }
}
