//! The part of a scene that says what stands behind its plate: further elements, each a plate on its mechanism, and a base
//! plate at the end. The scene's own plate is the first element.

use super::{Mechanism, Plate, Target};

/// Most further elements that a scene may list: the time of a run and of a key grows with the square of their number.
pub const LAYERS_MAX: usize = 50;

/// What stands behind the scene's own plate.
#[derive(Clone, Debug, PartialEq)]
pub struct Stack {
    /// Thickness of the base plate, > 0 m; `None`: there is no stack.
    pub base_thickness_m: Option<f64>,
    /// Flow strength of the base plate, >= 0 Pa; `None`: as the scene's plate.
    pub base_strength_pa: Option<f64>,
    /// How many equal elements the scene's own plate stands for, a whole number from 1 up.
    pub elements: f64,
    /// Clear distance behind each plate, > 0 m; `None`: enough.
    pub gap_m: Option<f64>,
    /// Further elements that are not like the first, in order.
    pub layers: Vec<Layer>,
}

/// One element of a stack: a plate on its mechanism.
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    /// The plate's material.
    pub target: Target,
    /// The plate as a body.
    pub plate: Plate,
    /// What carries it.
    pub mechanism: Mechanism,
}

impl Default for Stack {
    fn default() -> Self {
        Self {
            base_thickness_m: None,
            base_strength_pa: None,
            elements: 1.0,
            gap_m: None,
            layers: Vec::new(),
        }
    }
}
