//! The bounds that the designs of a search have to keep.

use std::fmt;
use std::str::FromStr;

use crate::study::quantities::{Quantity, named};
use cmra_engine::model::units;

/// A measure with a bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constraint {
    /// The measure.
    pub measure: &'static Quantity,
    /// Whether the bound is an upper one; otherwise a lower one.
    pub at_most: bool,
    /// The bound, SI; percent for percentages.
    pub bound: f64,
}

/// Reads `QUANTITY<=VALUE` or `QUANTITY>=VALUE`, SI or with a unit.
impl FromStr for Constraint {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let split = |sign: &str| text.split_once(sign);
        let (name, value, at_most) = split("<=")
            .map(|(name, value)| (name, value, true))
            .or_else(|| split(">=").map(|(name, value)| (name, value, false)))
            .ok_or("write QUANTITY<=VALUE or QUANTITY>=VALUE, for example 'stroke_m<=50mm'")?;
        let measure = named(name.trim()).map_err(|error| error.to_string())?;
        let bound = measure.parse(value)?;
        Ok(Self { measure, at_most, bound })
    }
}

/// As it is read: `stroke_m<=0.05`.
impl fmt::Display for Constraint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}{}", self.measure.name, self.sign(), units::shortest(self.bound))
    }
}

impl Constraint {
    /// `<=` or `>=`.
    pub fn sign(&self) -> &'static str {
        if self.at_most { "<=" } else { ">=" }
    }

    /// By how much a value violates it, relative to the bound; 0 where it keeps it, infinite where there is no value.
    pub fn violation(&self, value: Option<f64>) -> f64 {
        let Some(value) = value else { return f64::INFINITY };
        let beyond = if self.at_most { value - self.bound } else { self.bound - value };
        let scale = if self.bound == 0.0 { 1.0 } else { self.bound.abs() };
        if beyond > 0.0 { beyond / scale } else { 0.0 }
    }

    /// In words: `stroke <= 50 mm`.
    pub fn label(&self) -> String {
        format!("{} {} {}", self.measure.title(), self.sign(), self.measure.show(self.bound, 4))
    }
}
