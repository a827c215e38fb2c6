//! Table of all variables, in the order of the editor.

use std::sync::LazyLock;

use super::part::placed;
use super::row::{Group, Row, RowKind, RowNumber};
use crate::model::mechanism::kinds::spring_rows;
use crate::model::scene::{
    Combination, Contact, ContactModel, Interface, Listing, Mechanism, Plate, Projectile,
    RunSettings, Scene, Stack, Stop, Target, Wire, damper_rows, is_listing, may_stop, second_rows,
};

/// Row of the table of variables of a scene.
pub type Variable = Row<Scene>;
/// Kind of the value of a variable of a scene.
pub type Kind = RowKind<Scene>;
/// Numeric variable of a scene.
pub type Number = RowNumber<Scene>;

/// All variables in the order of the editor, with the group of each part of a scene and the conditions under which it is listed and used.
pub static VARIABLES: LazyLock<Vec<Variable>> = LazyLock::new(|| {
    let always = |_: &Scene| true;
    [
        placed(Group::Projectile, always, always, Projectile::rows()),
        placed(Group::Target, always, always, Target::rows()),
        placed(Group::Plate, always, always, Plate::rows()),
        placed(Group::Mechanism, always, Scene::is_sprung, damper_rows()),
        spring_rows(Scene::is_sprung),
        placed(Group::Mechanism, has_mass_of_wire, Scene::is_sprung, Wire::rows()),
        placed(Group::Mechanism, always, Scene::is_sprung, Mechanism::rows()),
        placed(Group::Mechanism, has_second, always, second_rows()),
        placed(Group::Stop, always, may_stop, Stop::rows()),
        placed(Group::Stack, always, always, Stack::rows()),
        placed(Group::Interface, always, always, Contact::rows()),
        placed(Group::Interface, is_listing, always, Listing::rows()),
        placed(Group::Interface, always, is_hydrodynamic, Interface::rows()),
        placed(Group::Run, always, always, RunSettings::rows()),
    ]
    .into_iter()
    .flatten()
    .collect()
});

/// Returns `true` if the mass of a coil spring follows from its wire: without a given specific energy.
fn has_mass_of_wire(scene: &Scene) -> bool {
    let mechanism = &scene.mechanism;
    let is_coil = mechanism.spring.power_law().is_some();
    is_coil && mechanism.energy_j_kg.is_none() && mechanism.has_springs()
}

/// Returns `true` if a second spring acts.
fn has_second(scene: &Scene) -> bool {
    scene.is_sprung() && scene.mechanism.combination == Combination::Parallel
}

fn is_hydrodynamic(scene: &Scene) -> bool {
    scene.contact.model == ContactModel::Hydrodynamic
}
