//! Keys of JSON objects: `explain` knows each that a command writes.

use std::collections::BTreeSet;

use cmra_studies::report::thesis;
use serde_json::Value;

use crate::support::{cmra, in_folder};

/// Commands that together write every object, on small scenes. `mine.csv` and `trace.csv` are files of a user.
const COMMANDS: [&str; 22] = [
    "run",
    "run array-stacked",
    "run --set interface=plastic",
    "run --with trace.csv",
    "sweep --over v_i=50,100",
    "sweep --over v_i=50..100:2 --outputs all",
    "limit",
    "limit --threat fsp-22 --material aa6061-t651 --set mount=rigid",
    "compare",
    "compare --map v_i=50..100:2,gamma=1..3:2",
    "seek --goal percent_of_baseline=60 --over d=0..0.5:11",
    "seek --goal percent_of_baseline=600 --over d=0..0.5:11",
    "optimise --samples 64",
    "sensitivity --over gamma=1..2 --over k=1e5..1e6",
    "montecarlo --samples 20 --outputs stroke_m",
    "accuracy --quick",
    "stability --quick",
    "stability thesis-baseline",
    "stability --map k --quick",
    "design",
    "validate --rows",
    "validate mine.csv",
];

/// Adds the keys of an object, and of all objects in it.
fn gather(value: &Value, keys: &mut BTreeSet<String>) {
    match value {
        Value::Object(object) => {
            for (key, value) in object {
                keys.insert(key.clone());
                gather(value, keys);
            }
        }
        Value::Array(list) => list.iter().for_each(|value| gather(value, keys)),
        _ => {}
    }
}

#[test]
fn every_key_of_json_is_explained() {
    let place = tempfile::tempdir().unwrap();
    let mine = "R [mm],m_p [g],h [mm],rho,S_y,mount,v_i,residual_velocity_m_s,limit_m_s,closure,C_d\n\
                6.35,29.5,25.4,2710,1.52e8,rigid,300,170,240,given,0.5\n";
    std::fs::write(place.path().join("mine.csv"), mine).unwrap();
    let trace = "t_s,plate_displacement_m\n0,0\n1e-4,0.002\n1e-3,0.03\n";
    std::fs::write(place.path().join("trace.csv"), trace).unwrap();
    let mut keys: BTreeSet<String> =
        thesis::claims(&[]).keys().iter().map(|it| (*it).to_owned()).collect();
    for command in COMMANDS {
        let done = in_folder(place.path(), &format!("{command} --json"));
        let object: Value =
            serde_json::from_str(&done.out).unwrap_or_else(|_| panic!("{command}: {}", done.err));
        gather(&object, &mut keys);
    }
    assert!(keys.len() > 300, "{}", keys.len());
    let is_unknown = |key: &&String| !cmra("explain", &[key]).output().unwrap().status.success();
    let unknown: Vec<&String> = keys.iter().filter(is_unknown).collect();
    assert!(unknown.is_empty(), "{} of {}: {unknown:?}", unknown.len(), keys.len());
}
