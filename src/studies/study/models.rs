//! One scene by every interaction model: Table 8.1 of the thesis.

use crate::model::scene::{ContactModel, Scene};

/// The same scene by every model, in the order of the table.
pub fn by_every_model(scene: &Scene) -> [(ContactModel, Scene); ContactModel::ALL.len()] {
    let mut models = ContactModel::ALL;
    models.sort_by_key(|model| model.about().place);
    models.map(|model| {
        let mut own = scene.clone();
        own.contact.model = model;
        (model, own)
    })
}
