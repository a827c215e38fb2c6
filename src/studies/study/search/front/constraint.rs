//! Constraints of a search: upper and lower bounds of quantities.

use std::fmt;
use std::str::FromStr;

use crate::study::error::TargetError;
use crate::study::quantities::{Quantity, named};
use cmra_engine::model::units::{self, UnitError};

/// Upper or lower bound of a quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constraint {
    /// Quantity.
    pub measure: &'static Quantity,
    /// Upper bound if `true`, else lower bound.
    pub at_most: bool,
    /// Bound, SI; percent for percentages.
    pub bound: f64,
}

/// Parses `QUANTITY<=VALUE` or `QUANTITY>=VALUE`, SI or with a unit.
impl FromStr for Constraint {
    type Err = TargetError;

    fn from_str(text: &str) -> Result<Self, TargetError> {
        Self::parse_with(text, Quantity::parse)
    }
}

/// Formats the constraint as it is parsed: `stroke_m<=0.05`.
impl fmt::Display for Constraint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}{}", self.measure.name, self.sign(), units::shortest(self.bound))
    }
}

impl Constraint {
    /// Parses a constraint whose bare number is in the unit on screens: `stroke_m<=50` is 50 mm.
    pub fn parse_in_shown_unit(text: &str) -> Result<Self, TargetError> {
        Self::parse_with(text, |measure, value| measure.parse_in(value, measure.shown_unit()))
    }

    fn parse_with(
        text: &str,
        parse: impl Fn(&Quantity, &str) -> Result<f64, UnitError>,
    ) -> Result<Self, TargetError> {
        let split = |sign: &str| text.split_once(sign);
        let (name, value, at_most) = split("<=")
            .map(|(name, value)| (name, value, true))
            .or_else(|| split(">=").map(|(name, value)| (name, value, false)))
            .ok_or(TargetError::NoBound)?;
        let measure = named(name.trim())?;
        let bound = parse(measure, value)?;
        Ok(Self { measure, at_most, bound })
    }

    /// Returns `<=` or `>=`.
    pub fn sign(&self) -> &'static str {
        if self.at_most { "<=" } else { ">=" }
    }

    /// Returns the relative excess of a value over the bound; 0 if the constraint is satisfied, infinite without a value.
    pub fn violation(&self, value: Option<f64>) -> f64 {
        let Some(value) = value else { return f64::INFINITY };
        let beyond = if self.at_most { value - self.bound } else { self.bound - value };
        let scale = if self.bound == 0.0 { 1.0 } else { self.bound.abs() };
        if beyond > 0.0 { beyond / scale } else { 0.0 }
    }

    /// Formats the constraint for pages: `stroke <= 50 mm`.
    pub fn label(&self) -> String {
        format!("{} {} {}", self.measure.title(), self.sign(), self.measure.show(self.bound, 4))
    }
}
