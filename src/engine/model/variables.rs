//! Table of all variables: key, symbol, unit, meaning, ranges, default, source, and access in a scene.
//!
//! The editor, `--set`, TOML files, CSV headers, the help page and sweeps use [`VARIABLES`], so every user-visible variable has a row.
//! Values outside the range searched by the thesis are legal and give a warning. Values without physical sense are rejected with name,
//! value, allowed range and remedy.
//!
//! `row` has the type of a row, `part` the macros that declare rows beside the fields of a scene, and `table` collects them.

use crate::model::run::check::Warning;
use crate::model::scene::Scene;
use crate::model::units;

pub(in crate::model) mod error;
mod names;
pub(in crate::model) mod part;
pub(in crate::model) mod row;
mod rules;
mod table;
mod visible;

pub use error::VariableError;
#[cfg(test)]
pub(in crate::model) use names::scene_with;
pub use names::{changed, changed_free_plate, close, did_you_mean, find, nearest, set_by_name};
pub use row::{Allowed, Group, Value};
pub use rules::{require_hydrodynamic, require_plain, require_single, validate};
pub use table::{Kind, Number, VARIABLES, Variable};
pub use visible::{
    can_be_used, exclude_each_other, gives_mass, is_listed, is_offered, is_used, overrules_size,
    sizes_plate, used_where,
};

impl Variable {
    /// Returns a warning if the value is outside the range searched by the thesis: `gamma = 12 is outside 0.8..7 of Table 9.2: the thesis
    /// has no figure there`.
    pub fn range_warning(&self, scene: &Scene) -> Option<Warning> {
        let (low, high) = self.thesis_range?;
        let value = (self.number()?.get)(scene)?;
        (!(low..=high).contains(&value)).then(|| {
            let value = format!(
                "{} = {} is outside {}..{} of Table 9.2",
                self.symbol,
                units::significant(value, 6),
                units::shortest(low),
                units::shortest(high)
            );
            Warning::remark(value, ": the thesis has no figure there")
        })
    }
}

/// Returns warnings for legal values outside the ranges searched by the thesis. The ranges do not apply to another shot or target than the
/// thesis's.
pub fn range_warnings(scene: &Scene) -> Vec<Warning> {
    let usual = Scene::default();
    let is_of_thesis = ["m_p", "R", "rho", "S_y", "closure", "face", "m_2"]
        .iter()
        .all(|name| find(name).is_ok_and(|variable| variable.show(scene) == variable.show(&usual)));
    VARIABLES
        .iter()
        .filter(|variable| is_of_thesis && is_used(variable, scene))
        .filter_map(|variable| variable.range_warning(scene))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::row::{LEAST, MOST};
    use super::*;

    /// Every positive number has a minimum and a maximum, which its description states and beyond which it is rejected.
    #[test]
    fn numbers_above_zero_have_a_least_and_a_greatest_value() {
        let mut exponents = 0;
        for variable in VARIABLES.iter() {
            let Some(number) = variable.number() else { continue };
            let least = match number.allowed {
                Allowed::Positive => LEAST,
                Allowed::From(least) => {
                    exponents += 1;
                    least
                }
                _ => continue,
            };
            assert!(variable.allowed().contains(&units::shortest(least)), "{}", variable.key);
            let set = |value| variable.set(&mut Scene::default(), Value::Number(value));
            assert!(set(least).is_ok() && set(least.next_down()).is_err(), "{}", variable.key);
            if number.allowed == Allowed::Positive {
                assert!(variable.allowed().contains("1e15"), "{}", variable.allowed());
                assert!(set(MOST).is_ok() && set(MOST.next_up()).is_err(), "{}", variable.key);
            }
        }
        assert_eq!(exponents, 3);
        let refusal = set_by_name(&mut Scene::default(), "n", "1e-20").unwrap_err().to_string();
        assert!(refusal.contains("0.01 or more"), "{refusal}");
    }
}
