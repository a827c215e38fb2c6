//! Contacts whose end is known to 18 digits: an 80-bit Taylor series and 30-digit arithmetic agree on them.

use crate::model::run::Outcome;
use crate::model::scene::Scene;
use crate::model::variables::{VariableError, changed_free_plate};

/// A row of `data/reference.csv`.
#[derive(Clone, Debug, PartialEq)]
pub struct Stored {
    /// Its name.
    pub name: &'static str,
    /// Changes to Table 9.1 with gamma = 1 and neither spring nor damper.
    pub changes: String,
    /// How the contact ends: arrested or perforated.
    pub outcome: Outcome,
    /// Time, s, depth, m, and plate displacement, m, in all their digits.
    pub digits: [&'static str; 3],
    /// The digits of time and depth that can be trusted.
    pub trusted: i32,
}

impl Stored {
    /// Every row.
    pub fn rows() -> impl Iterator<Item = Self> {
        let lines = include_str!("../data/reference.csv").lines().skip(1);
        lines.filter_map(|line| {
            let fields: Vec<&'static str> = line.split(',').collect();
            let [name, changes, end, t_s, depth_m, plate_m, _, trusted] = fields[..] else {
                return None;
            };
            let mut trusted = trusted.split([':', ' ']).filter_map(|part| part.parse().ok());
            Some(Self {
                name,
                changes: changes.replace("base", ""),
                outcome: if end == "perf" { Outcome::Perforated } else { Outcome::Arrested },
                digits: [t_s, depth_m, plate_m],
                trusted: trusted.next()?,
            })
        })
    }

    /// Its scene.
    ///
    /// # Errors
    /// A [`VariableError`] when a change is not understood, which a test rules out.
    pub fn scene(&self) -> Result<Scene, VariableError> {
        changed_free_plate(&self.changes)
    }

    /// Time, s, depth, m, and plate displacement, m, to double precision.
    pub fn values(&self) -> [f64; 3] {
        self.digits.map(|digits| digits.parse().unwrap_or(f64::NAN))
    }
}
