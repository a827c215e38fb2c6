//! Rules between the values of the springs.

use super::VariableError;
use crate::model::scene::{self, Combination, ContactModel, Mount, OwnMass, Scene, WhichSpring};

/// The rules between the values of the springs, and between them and the rest of the scene.
pub(super) fn check(scene: &Scene) -> Result<(), VariableError> {
    if scene.plate.mount == Mount::Rigid {
        return Ok(());
    }
    let mechanism = &scene.mechanism;
    for which in WhichSpring::ALL.into_iter().filter(|which| mechanism.acts(*which)) {
        mechanism.one(which).law().check(which.key())?;
    }
    if mechanism.combination == Combination::Series {
        for which in WhichSpring::ALL {
            check_rising(mechanism.one(which), which.key())?;
        }
    }
    check_model(scene)
}

/// A refusal of values that make no sense together.
fn refuse(text: String) -> Result<(), VariableError> {
    Err(VariableError(text))
}

/// In series each force must belong to one displacement.
fn check_rising(spring: &scene::Spring, table: &str) -> Result<(), VariableError> {
    if spring.curve().is_rising() {
        return Ok(());
    }
    refuse(format!(
        "combine (mechanism.combination) = series needs a force that rises everywhere, and that of {table} (kind = {}) does \
         not: take another kind or a coefficient above 0, or combine = parallel",
        spring.kind.word()
    ))
}

fn check_model(scene: &Scene) -> Result<(), VariableError> {
    let mechanism = &scene.mechanism;
    if scene.contact.model != ContactModel::Appendix || mechanism.is_plain() {
        return Ok(());
    }
    refuse(format!(
        "model (contact.model) = appendix needs a power law, and {} is not one: set model = hydrodynamic, or spring = power-law, \
         combine = alone, own_mass = ignored",
        described(mechanism)
    ))
}

/// The mechanism in a few words, for refusals.
fn described(mechanism: &scene::Mechanism) -> String {
    let kind = mechanism.spring.kind.word();
    let own = if mechanism.spring.own_mass == OwnMass::Counted { " with its own mass" } else { "" };
    match mechanism.combination {
        Combination::Alone => format!("spring (mechanism.spring.kind) = {kind}{own}"),
        Combination::Parallel => {
            format!("{kind} in parallel with {}", mechanism.second.kind.word())
        }
        Combination::Series => format!("{kind} in series with {}", mechanism.second.kind.word()),
    }
}

/// For the stability map, whose axes are the thesis's own mechanism's.
///
/// # Errors
/// [`VariableError`] when the scene has another one.
pub fn require_plain(scene: &Scene) -> Result<(), VariableError> {
    if scene.plate.mount == Mount::Rigid || scene.mechanism.is_plain() {
        return Ok(());
    }
    refuse(format!(
        "{} is not for the stability map, which varies k, n or b of the thesis's spring k |x|^n and damper: set spring = \
         power-law, combine = alone, own_mass = ignored, N_spring = 1",
        described(&scene.mechanism)
    ))
}
