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

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(hi: f64, unit: &str) -> (f64, String) {
        let unit = Unit::with_prefix(hi, unit);
        (unit.factor, unit.name.into_owned())
    }

    #[test]
    fn the_greatest_number_is_from_one_to_a_thousand() {
        assert_eq!(shown(0.0071, "m"), (1e3, "mm".to_owned()));
        assert_eq!(shown(200e-6, "s"), (1e6, "us".to_owned()));
        assert_eq!(shown(18_300.0, "N"), (1e-3, "kN".to_owned()));
        assert_eq!(shown(100.0, "m/s"), (1.0, "m/s".to_owned()));
        assert_eq!(shown(0.001, "s"), (1e3, "ms".to_owned()));
        assert_eq!(shown(7.5e6, "N/m"), (1e-6, "MN/m".to_owned()));
    }
}
