//! Spring with two stable positions, the first at x = 0.

use super::{Curve, Law, NO_VALUES, Piece, Spring, VariableError, parts};
use crate::model::units;

parts! {
    /// Bistable spring: two stable positions and the barrier between them.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Bistable at (mechanism.spring: Spring.bistable) {
        pub second_m: f64 = 0.02 => "x_2", "second position", "second stable position; the first is x = 0",
            number(Length, Positive).source(NO_VALUES);
        pub unstable_m: Option<f64> = None => "x_u", "unstable point",
            "unstable position between the stable ones: near 0 means much energy stored in the first",
            optional(Length, Positive, "midway").source("absent: midway, both equally deep");
        pub barrier_n: f64 = 1e3 => "F_bar", "barrier force",
            "greatest force on the way out of the first stable position", number(Force, Positive).is_log(true).source(NO_VALUES);
    }
}

impl Law for Bistable {
    /// Returns C x (x - u) (x - s): stable at 0 and s, unstable at u, with C from the maximum force between 0 and u.
    fn curve(&self, spring: &Spring, _crushed_m: f64) -> Curve {
        let s = self.second_m;
        let u = self.unstable_m.unwrap_or(0.5 * s);
        // The derivative 3x² - 2(u + s)x + us is zero at the maximum force.
        let sum = u + s;
        let top = (sum - (sum * sum - 3.0 * u * s).sqrt()) / 3.0;
        let factor = spring.count * self.barrier_n / (top * (top - u) * (top - s));
        let c = [0.0, factor * u * s, -factor * sum, factor];
        // One cubic, with knots at its zeros, between which the energy is monotone.
        let law = |from_m: f64| (from_m, Piece::Cubic { from_m: 0.0, c });
        Curve::new([f64::NEG_INFINITY, 0.0, u, s].map(law).to_vec(), s)
    }

    fn check(&self) -> Result<(), VariableError> {
        let Some(unstable) = self.unstable_m.filter(|unstable| *unstable >= self.second_m) else {
            return Ok(());
        };
        let problem = format!(
            "x_u (mechanism.spring.bistable.unstable_m) = {} m does not lie between the stable positions 0 and x_2 = {} m: it must be less \
             than x_2; reduce it, or write `midway`",
            units::shortest(unstable),
            units::shortest(self.second_m)
        );
        Err(VariableError::together(&["mechanism.spring.bistable.unstable_m"], problem))
    }
}
