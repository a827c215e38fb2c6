//! Absorber in compression: crushed at a constant force, elastic unloading from the crushed length.

use super::{Curve, Law, Piece, Spring, VariableError, parts};
use crate::model::units;
use crate::numerics::{larger, smaller};

/// Relative increase of the displacement below which crushing is rounding error.
const ROUNDING: f64 = 1e-12;

parts! {
    /// Absorber: crush force, stiffness and stroke.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Crush at (mechanism.spring: Spring.crush) {
        pub force_n: f64 = 5e3 => "F_crush", "crush force", "force at which the absorber is crushed",
            number(Force, Positive).is_log(true);
        pub stroke_m: f64 = 0.05 => "x_crush", "crush length", "displacement at which the absorber is flat and solid",
            number(Length, Positive);
        pub stiffness_n_m: f64 = 1e7 => "k_crush", "crush stiffness",
            "stiffness before the absorber is crushed and when it unloads", number(Stiffness, Positive).is_log(true);
    }
}

impl Crush {
    /// Returns the displacement at which a new absorber starts to be crushed, m.
    pub fn rise_m(&self) -> f64 {
        self.force_n / self.stiffness_n_m
    }

    /// Returns the crushed length after a reversal at x, m; `None` if it does not exceed the length before.
    pub fn crushed_by(&self, x_m: f64, before_m: f64) -> Option<f64> {
        let farthest_m = larger(before_m, self.rise_m()) * (1.0 + ROUNDING);
        (before_m < self.stroke_m && x_m > farthest_m).then_some(x_m)
    }
}

impl Law for Crush {
    /// Returns the law: no force up to the residual displacement, elastic up to the crushed length, the crush force up to the stroke, and
    /// solid beyond.
    fn curve(&self, spring: &Spring, crushed_m: f64) -> Curve {
        let (force, stiffness) = (spring.count * self.force_n, spring.count * self.stiffness_n_m);
        let (rise, stroke) = (self.rise_m(), self.stroke_m);
        let from = smaller(larger(crushed_m, rise), stroke);
        let elastic = |at: f64| Piece::line(at, force, stiffness);
        // Exactly zero at the start of the plate.
        let new = Piece::line(0.0, 0.0, stiffness);
        let mut laws = vec![
            (f64::NEG_INFINITY, Piece::line(0.0, 0.0, 0.0)),
            (from - rise, if from > rise { elastic(from) } else { new }),
        ];
        if from < stroke {
            laws.extend([(from, Piece::line(from, force, 0.0)), (stroke, elastic(stroke))]);
        }
        Curve::new(laws, stroke)
    }

    /// Checks that the stroke exceeds the elastic displacement.
    fn check(&self) -> Result<(), VariableError> {
        if self.stroke_m > self.rise_m() {
            return Ok(());
        }
        let problem = format!(
            "x_crush (mechanism.spring.crush.stroke_m) = {} m does not exceed F_crush/k_crush = {} m, where it begins to be crushed: it must \
             be more; raise x_crush or k_crush",
            units::shortest(self.stroke_m),
            units::shortest(self.rise_m())
        );
        Err(VariableError::together(&["mechanism.spring.crush.stroke_m"], problem))
    }

    fn limits(&self, _: &Spring, side: f64) -> Vec<(f64, &'static str)> {
        let limit_m = if side > 0.0 { self.stroke_m } else { f64::NEG_INFINITY };
        vec![(limit_m, "the absorber is crushed flat; it is solid from there on")]
    }

    /// Returns the mass of the whole stroke, kg, even if a shot uses only a part of it.
    fn mass_kg(&self, spring: &Spring, energy_j_kg: Option<f64>) -> Option<f64> {
        Some(spring.count * self.force_n * self.stroke_m / energy_j_kg?)
    }
}
