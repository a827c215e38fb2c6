//! The outcome of a shot into a stack of elements.

use std::sync::Arc;

use crate::model::run::{Outcome, Run};
use crate::numerics::larger;

/// The outcome of a shot into a stack.
#[derive(Clone, Debug, PartialEq)]
pub struct StackRun {
    /// The elements after the first that were struck, in order; the base plate, where it was, at the end.
    pub behind: Vec<Arc<Run>>,
    /// How many elements there are, the base plate not counted.
    pub elements: usize,
    /// The outcome of the shot in the last that was struck.
    pub outcome: Outcome,
    /// Thickness perforated along the shot's line, and the depth in what stopped it, m; `None` where nothing did.
    pub penetration_m: Option<f64>,
    /// Velocity behind a perforated base plate, m/s.
    pub residual_velocity_m_s: Option<f64>,
}

impl Run {
    /// The runs of the plates that were struck, in order; of a stack, the base plate at the end where it was.
    pub fn plates(&self) -> impl Iterator<Item = &Self> {
        let behind = self.stack.iter().flat_map(|stack| stack.behind.iter());
        std::iter::once(self).chain(behind.map(|run| &**run))
    }

    /// The depth of the whole shot: into a stack, all thickness perforated and the depth in what stopped it, m.
    pub fn shot_depth_m(&self) -> Option<f64> {
        self.stack.as_ref().map_or(self.final_penetration_m, |stack| stack.penetration_m)
    }

    /// The relative error estimate of a result; of a stack, the greatest of its plates.
    pub fn error_of(&self, name: &str) -> Option<f64> {
        let errors = self.plates().flat_map(|run| &run.error_estimates);
        errors.filter(|error| error.name == name).map(|error| error.relative).reduce(larger)
    }
}

impl StackRun {
    /// How many plates were perforated, the base plate included.
    pub fn passed(&self) -> usize {
        // The first was passed exactly when another was struck.
        let struck = self.behind.len() + 1;
        if self.outcome == Outcome::Perforated { struck } else { struck - 1 }
    }

    /// The name of the plate with this number, 0 for the first.
    pub fn name(&self, plate: usize) -> String {
        if plate < self.elements {
            format!("element {}", plate + 1)
        } else {
            "base plate".to_owned()
        }
    }

    /// The sentence: `stopped in element 2 of 3, 31.20 mm in all`.
    pub fn sentence(&self) -> String {
        let name = self.name(self.behind.len());
        let last = if self.behind.len() < self.elements { name } else { format!("the {name}") };
        match (self.outcome, self.penetration_m) {
            (Outcome::Arrested, Some(depth)) => {
                format!("stack: stopped in {last}, {:.4} mm in all", depth * 1e3)
            }
            (Outcome::Separated, Some(depth)) => {
                format!("stack: thrown back by {last}, {:.4} mm in all", depth * 1e3)
            }
            (Outcome::Perforated, _) => "stack: perforated, including the base plate".to_owned(),
            (Outcome::Arrested | Outcome::Separated | Outcome::Moving, _) => {
                format!("stack: undecided in {last}")
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sentence_names_the_plate_that_stopped_the_shot() {
        let stopped = |elements| StackRun {
            behind: Vec::new(),
            elements,
            outcome: Outcome::Arrested,
            penetration_m: Some(0.01),
            residual_velocity_m_s: None,
        };
        assert_eq!(stopped(1).sentence(), "stack: stopped in element 1, 10.0000 mm in all");
        assert_eq!(stopped(0).sentence(), "stack: stopped in the base plate, 10.0000 mm in all");
    }
}
