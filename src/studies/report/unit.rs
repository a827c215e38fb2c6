//! SI prefixes: the factor and the unit that make the numbers of an axis short.

use std::borrow::Cow;

use crate::model::units::Prefix;

/// How to show a quantity: numbers times `factor` are in `unit`.
#[derive(Clone, Debug, PartialEq)]
pub struct Unit<'a> {
    /// Shown number = value * factor; finite and > 0.
    pub factor: f64,
    /// Name of the shown unit; empty for a pure number.
    pub name: Cow<'a, str>,
}

impl Default for Unit<'_> {
    /// That of a pure number.
    fn default() -> Self {
        Self::new("")
    }
}

impl<'a> Unit<'a> {
    /// A unit as it is.
    pub fn new(name: impl Into<Cow<'a, str>>) -> Self {
        Self { factor: 1.0, name: name.into() }
    }

    /// The prefix under which a number of this size is from 1 to below 1000: 0.0071 m gives mm. Units that take
    /// no prefix (none, `kg`, `deg`, `%`, powers such as `m^2`) are left alone.
    pub fn with_prefix(size: f64, unit: &'a str) -> Self {
        let prefix = Prefix::for_unit(size, unit);
        Self { factor: prefix.in_one, name: format!("{}{unit}", prefix.letter).into() }
    }
}
