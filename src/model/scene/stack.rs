//! The part of a scene that says what stands behind its plate: further elements, each a plate on its mechanism, and a base
//! plate at the end. The scene's own plate is the first element.

use crate::model::defaulted::defaulted;

use super::{Mechanism, Plate, Target};

/// Most further elements that a scene may list: the time of a run and of a key grows with the square of their number.
pub const LAYERS_MAX: usize = 50;

defaulted! {
    /// What stands behind the scene's own plate.
    #[derive(Clone, Debug, PartialEq)]
    pub struct Stack {
        /// Thickness of the base plate, > 0 m; `None`: there is no stack.
        pub base_thickness_m: Option<f64> = None,
        /// Flow strength of the base plate, >= 0 Pa; `None`: as the scene's plate.
        pub base_strength_pa: Option<f64> = None,
        /// How many equal elements the scene's own plate stands for, a whole number from 1 up.
        pub elements: f64 = 1.0,
        /// Clear distance behind each plate, > 0 m; `None`: enough.
        pub gap_m: Option<f64> = None,
        /// Further elements that are not like the first, in order.
        pub layers: Vec<Layer> = Vec::new(),
    }
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
