//! What a run that ends undecided has reached so far.

/// Lower bounds: what a run that ends undecided has reached so far. `None` where the value is final, or nothing is known.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct AtLeast {
    /// Depth of the hole so far, m.
    pub penetration_m: Option<f64>,
    /// Greatest plate displacement so far, m.
    pub plate_displacement_m: Option<f64>,
}

impl AtLeast {
    /// Whether there is none: every value is final.
    pub fn is_empty(self) -> bool {
        self == Self::default()
    }
}
