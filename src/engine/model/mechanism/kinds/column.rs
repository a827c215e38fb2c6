//! Elastic buckling column or folding tube: unloading follows the loading curve.

use super::{Curve, Law, NO_VALUES, Piece, Spring, parts};
use crate::numerics::monotone;

parts! {
    /// Column: elastic up to a critical force, then a plateau.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Column at (mechanism.spring: Spring.column) {
        pub stiffness_n_m: f64 = 5e6 => "k_col", "column stiffness", "stiffness of the column before it buckles",
            number(Stiffness, Positive).is_log(true).source(NO_VALUES);
        pub critical_n: f64 = 5e3 => "F_crit", "buckling force", "force at which the column buckles",
            number(Force, Positive).is_log(true).source(NO_VALUES);
        pub plateau_n: f64 = 3e3 => "F_plat", "plateau force", "force of the buckled column",
            number(Force, NonNegative).is_log(true);
        pub fall_m: f64 = 2e-3 => "x_fall", "fall length", "displacement over which the force goes from F_crit to F_plat",
            number(Length, Positive);
    }
}

impl Law for Column {
    /// Returns the law: linear up to the critical force, a smooth transition, and the plateau.
    fn curve(&self, spring: &Spring, _crushed_m: f64) -> Curve {
        let count = spring.count;
        let onset = self.critical_n / self.stiffness_n_m;
        let folded = onset + self.fall_m;
        let (critical, plateau) = (count * self.critical_n, count * self.plateau_n);
        let fall = monotone::cubic([onset, critical], [folded, plateau], [0.0, 0.0]);
        let pieces = [
            (0.0, Piece::line(0.0, 0.0, count * self.stiffness_n_m)),
            (onset, Piece::Cubic { from_m: onset, c: fall }),
            (folded, Piece::line(0.0, plateau, 0.0)),
        ];
        Curve::odd(&pieces, folded)
    }
}
