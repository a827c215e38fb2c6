//! The README's table of keys is the program's own.

use std::fmt::Write as _;

use cmra::tui::message::{BINDINGS, Place};

const PLACES: [(Place, &str); 17] = [
    (Place::Anywhere, "anywhere"),
    (Place::Variables, "Variables"),
    (Place::Charts, "Charts"),
    (Place::Runs, "Runs"),
    (Place::Setup, "Setup"),
    (Place::Lines, "Sweep"),
    (Place::Surface, "Surface"),
    (Place::Accuracy, "Accuracy"),
    (Place::Map, "Map"),
    (Place::Battery, "Battery"),
    (Place::Log, "Log"),
    (Place::Claims, "Claims"),
    (Place::Principles, "Principles"),
    (Place::Screening, "Screening"),
    (Place::Limit, "Limit"),
    (Place::SearchSetup, "Search setup"),
    (Place::Search, "Search"),
];

/// The key table as the README has it.
fn table() -> String {
    let mut text = String::from("| where | keys | what they do |\n| --- | --- | --- |\n");
    for (place, name) in PLACES {
        for row in BINDINGS.iter().filter(|row| row.place == place) {
            let keys = row.keys_in_words().replace('|', "\\|");
            let _ = writeln!(text, "| {name} | `{keys}` | {} |", row.help);
        }
    }
    text
}

#[test]
fn the_table_of_keys_is_the_programs() {
    let readme = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/README.md"));
    let readme = readme.expect("README.md can be read");
    let (_, rest) = readme.split_once("<!-- keys -->\n").expect("where the table begins");
    let (found, _) = rest.split_once("<!-- end of keys -->").expect("where the table ends");
    let right = table();
    assert!(found == right, "README.md, between the marks `keys`, should read:\n{right}");
    assert_eq!(right.lines().count(), BINDINGS.len() + 2, "a place is missing in PLACES");
}
