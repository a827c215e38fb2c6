//! The rules of a stack.

use super::{VariableError, springs};
use crate::model::scene::{ContactModel, Layer, Scene, Stack};
use crate::model::units;

/// A base at the end, a whole number of elements, each of which makes sense by itself, and the model that knows what is left
/// of a shot.
pub(super) fn check(scene: &Scene) -> Result<(), VariableError> {
    let stack = &scene.stack;
    let whole = stack.elements.fract() == 0.0;
    if !whole {
        return Err(VariableError(format!(
            "elements (stack.elements) = {} is not whole: there are 1 to 50 of them; round it",
            units::shortest(stack.elements)
        )));
    }
    if stack.base_thickness_m.is_none() {
        if stack.elements > 1.0 || !stack.layers.is_empty() {
            let elements = stack.elements + stack.layers.len() as f64;
            return Err(VariableError(format!(
                "elements (stack.elements, stack.layer) = {} without h_base (stack.base_thickness_m): a stack must end in a \
                 base plate; write its thickness, for example stack.base_thickness_m = 0.01, or omit the stack",
                units::shortest(elements)
            )));
        }
        return Ok(());
    }
    if scene.contact.model != ContactModel::Hydrodynamic {
        return Err(VariableError(format!(
            "model (contact.model) = {} gives no residual velocity, which a stack (stack.base_thickness_m) needs: set \
             model = hydrodynamic, or h_base = none",
            scene.contact.model.word()
        )));
    }
    for (index, Layer { target, plate, mechanism }) in stack.layers.iter().enumerate() {
        let mut own = Scene { stack: Stack::default(), ..scene.clone() };
        (own.target, own.plate, own.mechanism) = (*target, *plate, mechanism.clone());
        let number = index + 1;
        super::validate(&own)
            .and_then(|()| springs::check(&own))
            .map_err(|error| VariableError(format!("stack.layer {number}: {error}")))?;
    }
    Ok(())
}

/// For studies that look at one plate.
///
/// # Errors
/// [`VariableError`] when the scene is a stack.
pub fn require_single(scene: &Scene) -> Result<(), VariableError> {
    match scene.stack.base_thickness_m {
        None => Ok(()),
        Some(base) => Err(VariableError(format!(
            "h_base (stack.base_thickness_m) = {} m makes the scene a stack, and this study looks at one plate: set h_base = none, \
             elements = 1",
            units::shortest(base)
        ))),
    }
}
