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
    let listed = bench.app.pages.run.editor.listed(&bench.app.scene);
    let symbols: Vec<&str> =
        listed.iter().map(|index| cmra::model::variables::VARIABLES[*index].symbol).collect();
    assert!(symbols.contains(&"dt"));
    assert!(!symbols.contains(&"t_d") && !symbols.contains(&"k_load"));
}
