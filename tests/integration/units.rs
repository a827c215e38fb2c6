//! Units and bare numbers on the command line.

use cmra_engine::model::variables::VARIABLES;

use crate::support::{json, says};

#[test]
fn customary_units_give_the_run_of_their_metric_values() {
    let customary = ["m_p=455.2546gr", "v_i=328.0839895013123fps", "h=1in", "S_y=22.04573616ksi"];
    let metric = ["m_p=29.5g", "v_i=100", "h=25.4mm", "S_y=152MPa"];
    let depth = |sets: [&str; 4]| {
        let sets = sets.iter().flat_map(|set| ["--set", set]);
        let arguments: Vec<&str> = sets.chain(["--set", "k=1e5"]).collect();
        json("run", &arguments)["final_penetration_m"].as_f64().unwrap()
    };
    let (one, other) = (depth(customary), depth(metric));
    assert!((one / other - 1.0).abs() < 1e-6, "{one} {other}");
}

#[test]
fn an_angle_is_in_degrees_where_its_name_says_so_and_needs_a_unit_elsewhere() {
    let depth = |set: &str| json("run", &["--set", set])["final_penetration_m"].clone();
    assert_eq!(depth("projectile.obliquity_deg=1"), depth("theta=1deg"));
    let (_, error) = says("run", &["--set", "theta=0.5"], 2);
    assert!(error.contains("`0.5 deg` or `0.5 rad`"), "{error}");
}

#[test]
fn a_range_has_two_units_or_none() {
    let (_, error) = says("sweep", &["--over", "h=1..2mm:3"], 2);
    assert!(error.contains("`1 mm..2mm` or `1 m..2mm`"), "{error}");
    let (_, error) = says("montecarlo", &["--vary", "h=uniform:24mm..27"], 2);
    assert!(error.contains("`24mm..27 mm` or `24mm..27 m`"), "{error}");
}

#[test]
fn a_table_needs_its_file() {
    let (_, error) = says("run", &["--set", "spring=table"], 2);
    assert!(error.contains("--set table=FILE"), "{error}");
    let folder = tempfile::tempdir().unwrap();
    let curve = folder.path().join("curve.csv");
    std::fs::write(&curve, "0,0\n0.05,5000\n").unwrap();
    let set = format!("table={}", curve.display());
    for order in [["spring=table", &set], [&set, "spring=table"]] {
        let sets = order.iter().flat_map(|set| ["--set", set]);
        let arguments: Vec<&str> = sets.collect();
        assert_eq!(says("run", &arguments, 0).1, "");
    }
}

/// The refusal of a value names every word that the variable takes in place of a number, on the command line and in a file.
#[test]
fn a_refused_value_is_told_the_words_that_are_allowed() {
    let place = tempfile::tempdir().unwrap();
    let file = place.path().join("scene.toml");
    let mut optional = 0;
    for variable in VARIABLES.iter() {
        let number = variable.number();
        let absent = number.and_then(|it| it.absent);
        let words: Vec<&str> = variable.keys().iter().copied().chain(absent).collect();
        optional += usize::from(absent.is_some());
        let refused = |value: &str| {
            let (_, error) = says("run", &["--set", &format!("{}={value}", variable.symbol)], 2);
            assert!(words.iter().all(|word| error.contains(word)), "{error}");
        };
        refused("no-such-word");
        if number.is_some_and(|it| absent.is_some() && !it.allowed.contains(-1.0)) {
            refused("-1");
        }
        if absent.is_some() {
            std::fs::write(&file, format!("format = 1\n{} = \"off\"\n", variable.key)).unwrap();
            let (_, error) = says("run", &[file.to_str().unwrap()], 2);
            assert!(words.iter().all(|word| error.contains(word)), "{error}");
        }
    }
    assert!(optional > 5, "{optional}");
}
