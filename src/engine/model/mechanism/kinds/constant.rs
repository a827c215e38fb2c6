//! Constant-force spring: linear up to the force, then constant.

use super::{Curve, Law, NO_VALUES, Piece, Spring, parts};

parts! {
    /// Constant force and the displacement at which it is reached.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct ConstantForce at (mechanism.spring: Spring.constant) {
        pub force_n: f64 = 2e3 => "F_c", "constant force", "the constant force",
            number(Force, NonNegative).is_log(true).source(NO_VALUES);
        pub rise_m: f64 = 1e-3 => "x_c", "ramp length", "displacement over which the constant force is reached",
            number(Length, Positive);
    }
}

impl Law for ConstantForce {
    fn curve(&self, spring: &Spring, _crushed_m: f64) -> Curve {
        let (rise, force) = (self.rise_m, spring.count * self.force_n);
        let pieces =
            [(0.0, Piece::line(0.0, 0.0, force / rise)), (rise, Piece::line(0.0, force, 0.0))];
        Curve::odd(&pieces, rise)
    }
}
