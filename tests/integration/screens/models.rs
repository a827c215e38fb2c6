//! The interaction models in the workbench: their variables are shown only where they matter.

use cmra_engine::model::scene::ContactModel;

use super::bench::Bench;

#[test]
fn variables_of_a_model_are_listed_only_with_it() {
    let mut bench = Bench::ascii(120, 60);
    assert!(!bench.screen().contains("t_d"));
    std::sync::Arc::make_mut(&mut bench.app.scene).contact.model = ContactModel::Appendix;
    let listed = bench.app.pages.run.editor.listed(&bench.app.scene);
    let symbols: Vec<&str> = listed
        .iter()
        .map(|index| cmra_engine::model::variables::VARIABLES[*index].symbol)
        .collect();
    assert!(symbols.contains(&"dt"));
    assert!(!symbols.contains(&"t_d") && !symbols.contains(&"k_load"));
}
