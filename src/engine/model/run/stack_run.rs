//! Result of a shot into a stack of plates.

use std::sync::Arc;

use crate::model::run::Run;
use crate::model::run::outcome::Outcome;

/// Result of a shot into a stack.
#[derive(Clone, Debug, PartialEq)]
pub struct StackRun {
    /// Runs of the struck elements behind the first, in order; the base plate is last if it was struck.
    pub behind: Vec<Arc<Run>>,
    /// Number of elements, without the base plate.
    pub elements: usize,
    /// Outcome of the shot in the last struck plate; in the base plate by the criterion of the scene.
    pub outcome: Outcome,
    /// Perforated thickness along the shot's line plus the depth in the stopping plate, m; `None` if no plate stopped the shot.
    pub penetration_m: Option<f64>,
    /// Residual velocity behind a perforated base plate, m/s.
    pub residual_velocity_m_s: Option<f64>,
}

impl StackRun {
    /// Returns the name of the plate with this index, starting at 0.
    pub fn name(&self, plate: usize) -> String {
        plate_name(plate, self.elements)
    }

    /// Returns the outcome of a struck plate, by the criterion of the scene if it is the base plate.
    pub fn outcome_of(&self, plate: usize, run: &Run) -> Outcome {
        if plate < self.elements { run.outcome } else { run.shot_outcome() }
    }

    /// Describes the outcome: `stopped in element 2 of 3, 31.20 mm in all`.
    pub fn sentence(&self) -> String {
        let name = self.name(self.behind.len());
        let last = if self.behind.len() < self.elements { name } else { format!("the {name}") };
        let out_m = self.behind.last().and_then(|base| base.protrusion_m());
        match (self.outcome, self.penetration_m) {
            (Outcome::Perforated, _) if out_m.is_some() => format!(
                "stack: perforated by the army criterion (protrusion): the nose stands {:.4} mm out of {last}",
                out_m.unwrap_or_default() * 1e3
            ),
            (Outcome::Perforated, _) => "stack: perforated, including the base plate".to_owned(),
            (outcome @ (Outcome::Arrested | Outcome::Separated), Some(depth)) => {
                let is_back = outcome == Outcome::Separated;
                let how = if is_back { "thrown back by" } else { "stopped in" };
                format!("stack: {how} {last}, {:.4} mm in all", depth * 1e3)
            }
            (Outcome::Unmeasured, _) => {
                format!("stack: not measured whether the shot goes through {last}")
            }
            _ => format!("stack: undecided in {last}"),
        }
    }
}

/// Returns the name of the plate with this index, starting at 0, in a stack of this many elements.
pub(in crate::model) fn plate_name(plate: usize, elements: usize) -> String {
    if plate < elements { format!("element {}", plate + 1) } else { "base plate".to_owned() }
}
