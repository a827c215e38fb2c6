//! Table of all variables: key, symbol, unit, meaning, ranges, default, source, and access in a scene.
//!
//! The editor, `--set`, TOML files, CSV headers, the help page and sweeps use [`VARIABLES`], so every user-visible variable has a row.
//! Values outside the range searched by the thesis are legal and give a warning. Values without physical sense are rejected with name,
//! value, allowed range and remedy.

use std::sync::LazyLock;

use crate::model::labelled_enum::labelled_enum;
use crate::model::mechanism::kinds::spring_rows;
use crate::model::run::check::Warning;
use crate::model::scene::{
    Contact, Interface, Listing, Mechanism, Plate, Projectile, RunSettings, Scene, Stack, Stop,
    Target, damper_rows, second_rows,
};
use crate::model::units::{self, Bare, Dimension};

use part::placed;
use visible::{has_second, is_hydrodynamic, is_listing, may_stop};

mod error;
mod names;
pub(in crate::model) mod part;
mod rules;
pub(in crate::model) mod visible;

pub use error::VariableError;
pub use names::{close, did_you_mean, find, nearest};
pub use rules::{require_hydrodynamic, require_plain, require_single, validate};
pub use visible::{
    exclude_each_other, gives_mass, is_listed, is_offered, is_used, overrules_size, sizes_plate,
    used_where,
};

/// All variables in the order of the editor, with the group of each part of a scene and the conditions under which it is listed and used.
pub static VARIABLES: LazyLock<Vec<Variable>> = LazyLock::new(|| {
    let always = |_: &Scene| true;
    [
        placed(Group::Projectile, always, always, Projectile::rows()),
        placed(Group::Target, always, always, Target::rows()),
        placed(Group::Plate, always, always, Plate::rows()),
        placed(Group::Mechanism, always, Scene::is_sprung, damper_rows()),
        spring_rows(),
        placed(Group::Mechanism, always, Scene::is_sprung, Mechanism::rows()),
        placed(Group::Mechanism, has_second, always, second_rows()),
        placed(Group::Stop, always, may_stop, Stop::rows()),
        placed(Group::Stack, always, always, Stack::rows()),
        placed(Group::Interface, always, always, Contact::rows()),
        placed(Group::Interface, is_listing, always, Listing::rows()),
        placed(Group::Interface, always, is_hydrodynamic, Interface::rows()),
        placed(Group::Run, always, always, RunSettings::rows()),
    ]
    .concat()
});

/// Row of the table of variables.
#[derive(Clone, Copy)]
pub struct Variable {
    /// Full key in a scene file, such as `plate.mass_ratio`.
    pub key: &'static str,
    /// Symbol of the thesis, or a short name: `gamma`.
    pub symbol: &'static str,
    /// Noun of at most sixteen letters: `mass ratio`.
    pub label: &'static str,
    /// Long name if the key does not give it; else empty.
    pub own_name: &'static str,
    /// Further short names accepted by `--set`.
    pub aliases: &'static [&'static str],
    /// Whether files omit the variable at its default value.
    pub is_seldom: bool,
    /// Whether lists show the variable. Variables of another kind of spring or contact model are hidden, not dimmed.
    pub listed: fn(&Scene) -> bool,
    /// Whether the variable has an effect; the editor dims variables without one.
    pub used: fn(&Scene) -> bool,
    /// Condition for both `listed` and `used`.
    pub when: fn(&Scene) -> bool,
    /// Conditions under which the part of the scene is listed and has an effect.
    pub part: [fn(&Scene) -> bool; 2],
    /// Group in the editor.
    pub group: Group,
    /// Meaning, as a sentence.
    pub meaning: &'static str,
    /// Source of the default.
    pub source: &'static str,
    /// Range searched by the thesis (Table 9.2), if given.
    pub thesis_range: Option<(f64, f64)>,
    /// Whether the arrow keys of the editor multiply by 10^0.1; else they change the last significant digit.
    pub is_log: bool,
    /// Kind of the value, and its access in a scene.
    pub kind: Kind,
}

labelled_enum! {
    /// Groups of the editor, in order.
    pub enum Group: title {
        Projectile = "Projectile",
        /// Material of the plate.
        Target = "Target",
        Plate = "Plate",
        Mechanism = "Mechanism",
        Stop = "Stop",
        /// Stack behind the plate.
        Stack = "Stack",
        /// Interface between projectile and plate.
        Interface = "Interface",
        /// Computation of the run.
        Run = "Analysis",
    }
}

/// Kind of the value of a variable.
#[derive(Clone, Copy)]
pub enum Kind {
    /// Number.
    Number(Number),
    /// Choice between keywords.
    Choice {
        /// Keywords, in order.
        words: &'static [&'static str],
        /// Returns the index into `words`.
        get: fn(&Scene) -> usize,
        /// Sets the choice by its index into `words`.
        set: fn(&mut Scene, usize),
    },
    /// Switch, `true` or `false`.
    Switch {
        /// Returns the value.
        get: fn(&Scene) -> bool,
        /// Sets the value.
        set: fn(&mut Scene, bool),
    },
}

/// Numeric variable.
#[derive(Clone, Copy)]
pub struct Number {
    /// Dimension, which determines the units.
    pub quantity: Dimension,
    /// Physically possible values.
    pub allowed: Allowed,
    /// Keyword for a missing value (`none`, `auto`); `None` if the value is required.
    pub absent: Option<&'static str>,
    /// Returns the value in the stored unit; `None` if absent.
    pub get: fn(&Scene) -> Option<f64>,
    /// Sets the value, in the stored unit.
    pub set: fn(&mut Scene, Option<f64>),
}

/// Minimum value of a positive quantity, in its stored unit: 1e-15 m is the size of a nucleus. Products and powers of smaller values
/// underflow.
const LEAST: f64 = 1e-15;

/// Maximum value of a positive quantity, in its stored unit: 1e15 kg is the mass of a mountain. Squares of a velocity that such a mass
/// shares with a projectile keep their digits.
const MOST: f64 = 1e15;
/// Values of a positive quantity.
const SENSIBLE: Allowed = Allowed::Between(LEAST, MOST);

/// Physically possible values of a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Allowed {
    /// Greater than zero: from `LEAST` to `MOST`.
    Positive,
    /// This value or more.
    From(f64),
    /// Zero or more.
    NonNegative,
    /// Any finite number.
    Any,
    /// Plate velocity at which the projectile reaches the plate; a rule between several values.
    Closing,
    /// Closed interval.
    Between(f64, f64),
    /// Half-open interval without its upper end.
    Below(f64, f64),
}

impl Allowed {
    /// Returns `true` if `value` is finite and allowed.
    pub fn contains(self, value: f64) -> bool {
        value.is_finite()
            && match self {
                Self::Positive => (LEAST..=MOST).contains(&value),
                Self::From(least) => value >= least,
                Self::NonNegative => value >= 0.0,
                Self::Any | Self::Closing => true,
                Self::Between(low, high) => (low..=high).contains(&value),
                Self::Below(low, high) => (low..high).contains(&value),
            }
    }

    /// Returns `true` if all allowed values have the same sign.
    fn has_sign(self) -> bool {
        matches!(self, Self::Positive | Self::From(_) | Self::NonNegative)
    }

    /// Describes the rule with the unit: `greater than 0 kg`.
    pub fn describe(self, quantity: Dimension) -> String {
        let unit = format!(" {}", quantity.unit());
        let unit = unit.trim_end();
        let show = units::shortest;
        match self {
            Self::Positive => format!("a number greater than 0{unit}"),
            Self::From(least) => format!("{}{unit} or more", show(least)),
            Self::NonNegative => format!("0{unit} or more"),
            Self::Any => "any finite number".to_owned(),
            Self::Closing => "below v_i/cos(theta)".to_owned(),
            Self::Between(low, high) => format!("{} to {}{unit}", show(low), show(high)),
            Self::Below(low, high) => format!("{} to less than {}{unit}", show(low), show(high)),
        }
    }
}

/// Value of a variable, independent of its field in the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// Number in the stored unit.
    Number(f64),
    /// Missing optional number.
    Absent,
    /// Keyword of a choice.
    Word(&'static str),
    /// Switch.
    Switch(bool),
}

impl Variable {
    /// Returns the value in a scene.
    pub fn value(&self, scene: &Scene) -> Value {
        match &self.kind {
            Kind::Number(number) => (number.get)(scene).map_or(Value::Absent, Value::Number),
            Kind::Choice { words, get, .. } => Value::Word(words[get(scene)]),
            Kind::Switch { get, .. } => Value::Switch(get(scene)),
        }
    }

    /// Sets the value; rejects values without physical sense and leaves the scene unchanged.
    pub fn set(&self, scene: &mut Scene, value: Value) -> Result<(), VariableError> {
        self.check(value)?;
        match (&self.kind, value) {
            (Kind::Number(number), Value::Number(new)) => (number.set)(scene, Some(new)),
            (Kind::Number(Number { absent: Some(_), set, .. }), Value::Absent) => set(scene, None),
            (Kind::Choice { words, set, .. }, Value::Word(word)) => {
                let index = words.iter().position(|it| *it == word);
                set(scene, index.ok_or_else(|| self.not_a_choice(word))?);
            }
            (Kind::Switch { set, .. }, Value::Switch(on)) => set(scene, on),
            (_, other) => return Err(self.not_a_choice(&self.written(other))),
        }
        Ok(())
    }

    /// Parses a value of this variable; numbers may be relative to the scene's present value. [`Variable::set`] checks the physical sense.
    pub fn parse(&self, scene: &Scene, text: &str, bare: Bare<'_>) -> Result<Value, VariableError> {
        let word = text.trim();
        match &self.kind {
            Kind::Number(number) => {
                if number.absent == Some(word) {
                    return Ok(Value::Absent);
                }
                let old = (number.get)(scene).unwrap_or(0.0);
                let value = units::parse_relative(text, old, number.quantity, bare);
                let Self { symbol, key, .. } = *self;
                let refuse = |problem| VariableError::Unreadable { symbol, key, problem };
                value.map(Value::Number).map_err(refuse)
            }
            Kind::Choice { words, .. } => {
                let found = words.iter().find(|it| **it == word).map(|it| Value::Word(it));
                found.ok_or_else(|| self.not_a_choice(word))
            }
            Kind::Switch { .. } => match word {
                "true" | "on" | "yes" | "1" => Ok(Value::Switch(true)),
                "false" | "off" | "no" | "0" => Ok(Value::Switch(false)),
                _ => Err(self.not_a_choice(word)),
            },
        }
    }

    /// Returns the unit of a bare number under this name on the command line. A full key ends in its unit.
    pub fn bare(&self, name: &str) -> Bare<'static> {
        if name == self.key { Bare::Stored } else { Bare::Si }
    }

    /// Formats the value so that [`Variable::parse`] returns it exactly: shortest digits, no unit.
    pub fn show(&self, scene: &Scene) -> String {
        self.written(self.value(scene))
    }

    fn written(&self, value: Value) -> String {
        match value {
            Value::Number(number) => units::shortest(number),
            Value::Absent => self.number().and_then(|it| it.absent).unwrap_or("none").to_owned(),
            Value::Word(word) => word.to_owned(),
            Value::Switch(on) => on.to_string(),
        }
    }

    /// Returns the keywords of a choice, in order; empty for a number or a switch.
    pub fn keys(&self) -> &'static [&'static str] {
        if let Kind::Choice { words, .. } = self.kind { words } else { &[] }
    }

    /// Returns the name of the stored unit; empty for pure numbers and words.
    pub fn unit(&self) -> &'static str {
        self.number().map_or("", |number| number.quantity.unit())
    }

    /// Returns the numeric properties; `None` for a choice or a switch.
    pub fn number(&self) -> Option<&Number> {
        if let Kind::Number(number) = &self.kind { Some(number) } else { None }
    }

    /// Describes the allowed values.
    pub fn allowed(&self) -> String {
        match &self.kind {
            Kind::Number(number) => {
                let rule = number.allowed.describe(number.quantity);
                let rule = match number.allowed {
                    Allowed::Positive => {
                        format!("{rule}: {}", SENSIBLE.describe(number.quantity))
                    }
                    _ => rule,
                };
                number.absent.map_or_else(|| rule.clone(), |word| format!("{rule}, or `{word}`"))
            }
            Kind::Choice { words, .. } => {
                format!("{} or {}", words[..words.len() - 1].join(", "), words[words.len() - 1])
            }
            Kind::Switch { .. } => "true or false".to_owned(),
        }
    }

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

    fn not_a_choice(&self, text: &str) -> VariableError {
        let Self { symbol, key, .. } = *self;
        let (value, allowed) = (text.to_owned(), self.allowed());
        VariableError::NotAChoice { symbol, key, value, allowed }
    }

    /// Rejects a number that makes no physical sense by itself.
    fn check(&self, value: Value) -> Result<(), VariableError> {
        let (Kind::Number(number), Value::Number(value)) = (&self.kind, value) else {
            return Ok(());
        };
        let Number { quantity, allowed, get, .. } = number;
        if allowed.contains(value) {
            return Ok(());
        }
        let cure = match get(&Scene::default()) {
            _ if *quantity == Dimension::Angle && value >= 90.0 => {
                "write degrees as for example `30deg`".to_owned()
            }
            _ if allowed.has_sign() && allowed.contains(-value) => {
                format!("did you mean {}?", units::shortest(-value))
            }
            Some(default) => format!("the default is {}", units::shortest(default)),
            None => "omit it to have none".to_owned(),
        };
        let written = if value.is_finite() { units::shortest(value) } else { value.to_string() };
        // A positive variable has a stated minimum and maximum.
        let is_extreme = *allowed == Allowed::Positive && value > 0.0;
        let rule = if is_extreme { SENSIBLE } else { *allowed };
        let (value, allowed) = (format!("{written} {}", quantity.unit()), rule.describe(*quantity));
        let value = value.trim_end().to_owned();
        let Self { symbol, key, meaning, .. } = *self;
        Err(VariableError::Impossible { symbol, key, value, meaning, allowed, cure })
    }
}

/// Sets a variable by name from text, as `--set NAME=VALUE` does; the scene is unchanged on error.
pub fn set_by_name(scene: &mut Scene, name: &str, text: &str) -> Result<(), VariableError> {
    let variable = find(name.trim())?;
    let value = variable.parse(scene, text, variable.bare(name.trim()))?;
    variable.set(scene, value)
}

/// Returns a scene with changed variables, in the format of `--set`: `k=1e5 n=0.5`.
pub fn changed(mut scene: Scene, changes: &str) -> Result<Scene, VariableError> {
    for change in changes.split_whitespace() {
        let (name, value) = change.split_once('=').unwrap_or((change, ""));
        set_by_name(&mut scene, name, value)?;
    }
    Ok(scene)
}

/// Applies [`changed`] to the scene of Table 9.1 with gamma = 1 and without spring and damper.
pub fn changed_free_plate(changes: &str) -> Result<Scene, VariableError> {
    changed(Scene::default(), &format!("k=0 {changes}"))
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

/// Returns the default scene with changes such as `k=1e6 n=0.5`, in SI units.
#[cfg(test)]
pub(in crate::model) fn scene_with(pairs: &str) -> Scene {
    changed(Scene::default(), pairs).expect("values the variables take")
}

#[cfg(test)]
mod tests {
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
