//! The constraints on the designs of a search: requested bounds, and feasibility.

use crate::model::run::envelope;
use crate::model::units;
use crate::study::quantities::{self, Quantity};

/// A measure with a bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constraint {
    /// The measure.
    pub measure: &'static Quantity,
    /// It must be this at most; otherwise at least.
    pub at_most: bool,
    /// The bound, SI; percent for percentages.
    pub bound: f64,
    /// It is one of [`feasibility`], and kept where its measure does not exist: a design without beams cannot yield.
    pub is_feasibility: bool,
}

/// What a design must keep to be built, and to be what the model takes it for: name, at most, bound.
const FEASIBILITY: [(&str, bool, f64); 6] = [
    ("interface_demand_ratio", true, 1.0),
    ("interface_tension_ratio", true, 1.0),
    ("yield_margin", false, 1.0),
    ("travel_margin", false, 1.0),
    ("fused_stop_hits", true, 0.0),
    ("face_over_diameter", false, envelope::FACE_LEAST),
];

/// The constraints of feasibility: the interface carries its load in compression and in tension, no beam yields, no spring leaves its law, no rigid
/// stop is hit under a fused interface, and the plate's face is large enough. The own mass of the mechanism is in the masses.
pub fn feasibility() -> impl Iterator<Item = Constraint> {
    FEASIBILITY.iter().filter_map(|(name, at_most, bound)| {
        let measure = quantities::find(name)?;
        Some(Constraint { measure, at_most: *at_most, bound: *bound, is_feasibility: true })
    })
}

impl Constraint {
    /// Read `QUANTITY<=VALUE` or `QUANTITY>=VALUE`, SI or with a unit.
    ///
    /// # Errors
    /// What is wrong, in words.
    pub fn parse(text: &str) -> Result<Self, String> {
        let split = |sign: &str| text.split_once(sign);
        let (name, value, at_most) = split("<=")
            .map(|(name, value)| (name, value, true))
            .or_else(|| split(">=").map(|(name, value)| (name, value, false)))
            .ok_or("write QUANTITY<=VALUE or QUANTITY>=VALUE, for example 'stroke_m<=50mm'")?;
        let measure = quantities::named(name.trim()).map_err(|error| error.to_string())?;
        let bound = measure.parse(value)?;
        Ok(Self { measure, at_most, bound, is_feasibility: false })
    }

    /// How far a value is from the bound, relative to that; negative where it breaks the constraint.
    pub(super) fn margin(&self, value: Option<f64>) -> f64 {
        let Some(value) = value else { return if self.is_feasibility { 1.0 } else { -1.0 } };
        let left = if self.at_most { self.bound - value } else { value - self.bound };
        left / if self.bound == 0.0 { 1.0 } else { self.bound.abs() }
    }

    /// By how much a value violates it, relative to the bound; 0 where it keeps it, infinite where it has to exist and does not.
    pub fn violation(&self, value: Option<f64>) -> f64 {
        if value.is_none() && !self.is_feasibility {
            return f64::INFINITY;
        }
        let margin = self.margin(value);
        if margin < 0.0 { -margin } else { 0.0 }
    }

    /// As it is read: `stroke_m<=0.05`.
    pub fn text(&self) -> String {
        let sign = if self.at_most { "<=" } else { ">=" };
        format!("{}{sign}{}", self.measure.name, units::shortest(self.bound))
    }

    /// In words: `stroke <= 50 mm`.
    pub fn words(&self) -> String {
        let sign = if self.at_most { "<=" } else { ">=" };
        format!("{} {sign} {}", self.measure.title(), self.measure.show(self.bound, 4))
    }
}
