//! The interaction models in the workbench: compared by one key, with their variables shown only where they matter.

use cmra::model::scene::{ContactModel, SpringKind};

use super::bench::Bench;

#[test]
fn one_key_pins_every_other_model_and_takes_them_away_again() {
    let mut bench = Bench::ascii(120, 40);
    bench.keys(":every contact<Enter>");
    bench.answer();
    let names: Vec<&str> = bench.app.pins.iter().map(|pin| pin.name.as_str()).collect();
    assert_eq!(names, ["lumped", "half-sine", "initial-velocity", "appendix"]);
    assert!(bench.app.pins.iter().all(|pin| pin.scene.contact.model != ContactModel::Hydrodynamic));
    bench.keys(":every contact<Enter>");
    assert!(bench.app.pins.is_empty());
    // Five pins of one's own leave no room for four.
    for _ in 0..5 {
        bench.keys(" l");
    }
    bench.keys(":every contact<Enter>");
    assert_eq!(bench.app.pins.len(), 5);
    assert!(bench.message().contains("3 of the eight pins are free"));
}

/// At 80 columns five readouts have no room; those that are there are whole.
#[test]
fn the_readout_of_many_runs_ends_with_a_whole_one() {
    for (columns, rows) in [(60, 20), (80, 24), (90, 24)] {
        let mut bench = Bench::ascii(columns, rows);
        bench.keys(":every contact<Enter>");
        let screen = bench.screen();
        let row = screen.lines().find(|line| line.contains("  first arrest")).expect(&screen);
        let readout = row.rsplit_once("|| ").map_or(row, |(_, right)| right).trim_end_matches('|');
        let readout = readout.trim().strip_suffix("first arrest").unwrap();
        let items = readout.split("  ");
        for item in items.filter(|item| !item.trim().is_empty() && item.trim() != "..") {
            let words: Vec<&str> = item.split_whitespace().collect();
            let whole = matches!(words[..], [_, _, "mm"] | [_, "-"]);
            assert!(whole, "{item:?} at {columns} columns in\n{row}");
        }
        assert_eq!(readout.contains("now "), columns >= 80, "{row}");
        assert!(readout.trim_end().ends_with(".."), "{row}");
    }
}

#[test]
fn a_model_that_cannot_run_a_spring_is_not_drawn_and_the_message_names_it() {
    for kind in [SpringKind::Helix, SpringKind::Column] {
        let mut bench = Bench::ascii(120, 40);
        std::sync::Arc::make_mut(&mut bench.app.scene).mechanism.spring.kind = kind;
        bench.keys(":every contact<Enter>");
        let names: Vec<&str> = bench.app.pins.iter().map(|pin| pin.name.as_str()).collect();
        assert_eq!(names, ["lumped", "half-sine", "initial-velocity"]);
        assert!(bench.message().contains("are not drawn"), "{}", bench.message());
        bench.keys(":every contact<Enter>");
        assert!(bench.app.pins.is_empty());
    }
}

#[test]
fn variables_of_a_model_are_listed_only_with_it() {
    let mut bench = Bench::ascii(120, 60);
    assert!(!bench.screen().contains("t_d"));
    std::sync::Arc::make_mut(&mut bench.app.scene).contact.model = ContactModel::Appendix;
    let listed = bench.app.editor.listed(&bench.app.scene);
    let symbols: Vec<&str> =
        listed.iter().map(|index| cmra::model::variables::VARIABLES[*index].symbol).collect();
    assert!(symbols.contains(&"dt"));
    assert!(!symbols.contains(&"t_d") && !symbols.contains(&"k_load"));
}
