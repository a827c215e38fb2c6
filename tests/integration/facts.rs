//! Facts that stand in one place: what the help prints of them, and what other code spells of them, is compared with that place.

use std::fs;
use std::path::PathBuf;

use cmra::files::bundled;
use cmra_engine::model::variables::VARIABLES;
use cmra_studies::study::monte_carlo::{
    self, DEFAULT_DEVIATION, DEFAULT_LIMIT_SAMPLES, DEFAULT_SAMPLES,
};
use cmra_studies::study::quantities::QUANTITIES;
use cmra_studies::study::search::front::{self, Constraint};
use cmra_studies::study::search::seek::DEFAULT_SCAN;
use cmra_studies::study::sensitivity;

use crate::support::{cmra, files_below, in_repository};

/// Commands with defaults.
const COMMANDS: [&str; 13] = [
    "run",
    "sweep",
    "limit",
    "compare",
    "seek",
    "optimise",
    "sensitivity",
    "montecarlo",
    "accuracy",
    "stability",
    "reproduce",
    "validate",
    "report",
];

/// The defaults that a command's help prints, each on one line.
fn defaults(command: &str) -> Vec<String> {
    let output = cmra(command, &["--help"]).output().unwrap();
    let words = String::from_utf8(output.stdout).unwrap();
    let words = words.split_whitespace().collect::<Vec<&str>>().join(" ");
    let found = words.split("[default: ").skip(1);
    found.map(|text| text.split(']').next().unwrap().to_owned()).collect()
}

/// Every number and name among the defaults is that of the request; what is left is words.
#[test]
fn defaults_in_help_are_those_of_the_requests() {
    let samples = monte_carlo::Request::default().samples;
    assert_eq!(samples, None, "the number follows from the outputs");
    let bounds = front::Request::default().subject_to;
    let bound: Constraint = "stroke_m<=1m".parse().unwrap();
    assert_eq!(bounds, [bound]);
    let known = [
        bundled::BASELINE.to_owned(),
        DEFAULT_SCAN.to_string(),
        "'stroke_m<=1m' where the stroke is minimised".to_owned(),
        front::Request::default().samples.to_string(),
        sensitivity::OUTPUT.to_owned(),
        format!(
            "velocity, masses, lengths, strength, density, drag, spring and damper, each lognormal by {} %",
            100.0 * DEFAULT_DEVIATION
        ),
        format!("{DEFAULT_SAMPLES}, or {DEFAULT_LIMIT_SAMPLES} where each takes a limit search"),
        monte_carlo::Request::default().seed.to_string(),
        // Of the parser itself.
        "auto".to_owned(),
        "1/1".to_owned(),
        "thesis".to_owned(),
    ];
    let words = [
        "one for each core",
        "the ranges of Table 9.2; for another projectile than that of the thesis, gamma of plates 3 to 12 diameters wide",
        "the design and analysis variables that the scene uses, over the ranges of Table 9.2, else a quarter to four times their \
         values by logarithm",
        "all but those about the computation",
        "that of the scene's class in `cmra validate`, else 0",
        "as for the bias",
        "the built-in ones, by class",
    ];
    let mut seen = vec![false; known.len()];
    for command in COMMANDS {
        let printed = defaults(command);
        assert!(!printed.is_empty(), "{command}");
        for text in printed {
            let at = known.iter().position(|it| *it == text);
            if let Some(at) = at {
                seen[at] = true;
            }
            assert!(at.is_some() || words.contains(&&*text), "{command}: [default: {text}]");
        }
    }
    assert!(seen.iter().all(|seen| *seen), "{seen:?}");
}

/// Strings in quotes in a line of code.
fn literals(line: &str) -> impl Iterator<Item = &str> {
    line.split("//").next().unwrap_or_default().split('"').skip(1).step_by(2)
}

/// Key with a unit at its end: `stroke_m`.
fn has_unit(text: &str) -> bool {
    const UNITS: [&str; 9] = ["_m", "_n", "_s", "_m_s", "_j", "_kg", "_kg_m2", "_n_s", "_pa"];
    let is_key = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
    text.chars().all(is_key) && text.len() > 4 && UNITS.iter().any(|unit| text.ends_with(unit))
}

/// Sources by their names below `src`, without their tests.
fn sources() -> Vec<(String, String)> {
    let root = in_repository("src");
    let source = |path: &PathBuf| {
        let text = fs::read_to_string(path).unwrap();
        let code = text.split("#[cfg(test)]\nmod tests").next().unwrap().to_owned();
        (path.strip_prefix(&root).unwrap().to_str().unwrap().to_owned(), code)
    };
    let all = files_below(&root, "rs");
    all.iter().map(source).filter(|it| !it.0.ends_with("tests.rs")).collect()
}

/// A key spelled outside the tables of quantities and variables is one of theirs, or a column of a report or a table of measurements.
#[test]
fn keys_of_quantities_are_those_of_the_table() {
    const OF_COLUMNS: [&str; 2] = ["studies/report/", "studies/study/measured/table.rs"];
    // Fields of the fitted laws of residual velocities, which are written by their names.
    const OF_LAWS: [&str; 2] = ["v_bl_m_s", "misfit_m_s"];
    let (tables, others): (Vec<_>, Vec<_>) = sources()
        .into_iter()
        .partition(|it| OF_COLUMNS.iter().any(|start| it.0.starts_with(start)));
    let columns: Vec<&str> =
        tables.iter().flat_map(|it| it.1.lines().flat_map(literals)).chain(OF_LAWS).collect();
    let mut complaints = Vec::new();
    for (name, code) in &others {
        for (number, line) in code.lines().enumerate() {
            // The name of a field in files, and the short form of a library's key.
            if line.contains("serde(rename") || line.contains("aliases(") {
                continue;
            }
            for key in literals(line).filter(|text| has_unit(text)) {
                let is_quantity = QUANTITIES.iter().any(|it| it.name == key);
                let is_variable = VARIABLES.iter().any(|it| it.key.rsplit('.').next() == Some(key));
                if !is_quantity && !is_variable && !columns.contains(&key) {
                    complaints.push(format!("{name}:{}: {key}", number + 1));
                }
            }
        }
    }
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

/// A string one or two letters from the name of a quantity is a misspelled one, wherever it stands.
#[test]
fn no_name_of_a_quantity_is_misspelled() {
    for (name, code) in sources() {
        let is_key = |text: &&str| text.contains('_') && !text.contains('.');
        for key in code.lines().flat_map(literals).filter(is_key) {
            let is_known = QUANTITIES.iter().any(|it| it.name == key);
            // A plural is a word of its own.
            let near = |name: &str| {
                name.len() > 8 && !key.starts_with(name) && strsim::osa_distance(name, key) <= 2
            };
            let meant = QUANTITIES.iter().find(|it| near(it.name)).filter(|_| !is_known);
            assert!(meant.is_none(), "{name}: {key}: {:?}", meant.map(|it| it.name));
        }
    }
}
