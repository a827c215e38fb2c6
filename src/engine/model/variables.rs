//! THE table of variables: key, symbol, unit, meaning, ranges, default and source, and how each is read and set.
//!
//! The editor, `--set`, TOML files, CSV headers, the help page and the sweeps are all fed from here: a variable that is
//! not in [`VARIABLES`] does not exist for a user. Values outside the range the thesis searched are legal and
//! earn a warning; values without physical sense are refused with name, value, what is allowed and the cure.

use std::sync::LazyLock;

use crate::model::labelled_enum::labelled_enum;
use crate::model::mechanism::kinds::spring_rows;
use crate::model::run::Warning;
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
pub use rules::{require_hydrodynamic, require_plain, require_single};
pub use visible::{
    exclude_each_other, gives_mass, is_listed, is_offered, is_used, overrules_size, sizes_plate,
    used_where,
};

/// Every variable there is, in the order of the editor: the group of each part of a scene, and when it is listed and, of that, used.
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
    /// Full key as in a scene file, for example `plate.mass_ratio`.
    pub key: &'static str,
    /// The thesis's symbol, or a short name: `gamma`.
    pub symbol: &'static str,
    /// The noun for it, of at most sixteen letters: `mass ratio`.
    pub label: &'static str,
    /// Long name if the key does not give it; else empty.
    pub own_name: &'static str,
    /// Other short words `--set` accepts.
    pub aliases: &'static [&'static str],
    /// Whether a file has it only where its value is not the default.
    pub is_seldom: bool,
    /// Whether a list shows it: what belongs to another kind of spring or contact model is not even dimmed.
    pub listed: fn(&Scene) -> bool,
    /// Whether it has an effect: rows without are dimmed in the editor.
    pub used: fn(&Scene) -> bool,
    /// Where both hold; elsewhere neither does.
    pub when: fn(&Scene) -> bool,
    /// Whether its part of the scene is listed, and whether it has an effect.
    pub part: [fn(&Scene) -> bool; 2],
    /// The group of the editor it stands in.
    pub group: Group,
    /// Meaning, as a sentence.
    pub meaning: &'static str,
    /// Where its default comes from.
    pub source: &'static str,
    /// The range the thesis searched (Table 9.2), where it gives one.
    pub thesis_range: Option<(f64, f64)>,
    /// Whether the editor's arrow keys multiply it by 10^0.1; else they add to its last significant digit.
    pub is_log: bool,
    /// The kind of its value, and its access in a scene.
    pub kind: Kind,
}

labelled_enum! {
    /// The groups of the editor, in order.
    pub enum Group: title {
        Projectile = "Projectile",
        /// The plate's material.
        Target = "Target",
        Plate = "Plate",
        Mechanism = "Mechanism",
        Stop = "Stop",
        /// The stack behind the plate.
        Stack = "Stack",
        /// The interface between projectile and plate.
        Interface = "Interface",
        /// How the run is computed.
        Run = "Analysis",
    }
}

/// The kind of value of a variable.
#[derive(Clone, Copy)]
pub enum Kind {
    /// A number.
    Number(Number),
    /// Choice between a few words.
    Choice {
        /// The words, in order.
        words: &'static [&'static str],
        /// Index into `words`.
        get: fn(&Scene) -> usize,
        /// Set by index into `words`.
        set: fn(&mut Scene, usize),
    },
    /// true or false.
    Switch {
        /// Read it.
        get: fn(&Scene) -> bool,
        /// Set it.
        set: fn(&mut Scene, bool),
    },
}

/// A numeric variable.
#[derive(Clone, Copy)]
pub struct Number {
    /// Dimension, which gives the units.
    pub quantity: Dimension,
    /// The physically possible values.
    pub allowed: Allowed,
    /// Whether it may be absent, and the word shown then (`none`, `auto`).
    pub absent: Option<&'static str>,
    /// Read it, in the stored unit; `None` when absent.
    pub get: fn(&Scene) -> Option<f64>,
    /// Set it, in the stored unit.
    pub set: fn(&mut Scene, Option<f64>),
}

/// Least value of a quantity that must be greater than zero, in its stored unit: 1e-15 m is the size of a nucleus. Products and powers
/// of smaller values underflow.
const LEAST: f64 = 1e-15;

/// The values that make physical sense.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Allowed {
    /// Greater than zero: `LEAST` or more.
    Positive,
    /// This or more.
    From(f64),
    /// Zero or more.
    NonNegative,
    /// Any finite number.
    Any,
    /// A velocity of the plate at which the projectile reaches it: a rule between values.
    Closing,
    /// From the first to the second, both included.
    Between(f64, f64),
    /// From the first, included, to below the second.
    Below(f64, f64),
}

impl Allowed {
    /// Whether `value` is finite and allowed.
    pub fn contains(self, value: f64) -> bool {
        value.is_finite()
            && match self {
                Self::Positive => value >= LEAST,
                Self::From(least) => value >= least,
                Self::NonNegative => value >= 0.0,
                Self::Any | Self::Closing => true,
                Self::Between(low, high) => (low..=high).contains(&value),
                Self::Below(low, high) => (low..high).contains(&value),
            }
    }

    /// Whether its numbers have one sign.
    fn has_sign(self) -> bool {
        matches!(self, Self::Positive | Self::From(_) | Self::NonNegative)
    }

    /// The rule in words, with the unit: `greater than 0 kg`.
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

/// A variable's value, independent of its place in the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// A number in the stored unit.
    Number(f64),
    /// An optional number that is not there.
    Absent,
    /// Word of a choice.
    Word(&'static str),
    /// A switch.
    Switch(bool),
}

impl Variable {
    /// Read the value from a scene.
    pub fn value(&self, scene: &Scene) -> Value {
        match &self.kind {
            Kind::Number(number) => (number.get)(scene).map_or(Value::Absent, Value::Number),
            Kind::Choice { words, get, .. } => Value::Word(words[get(scene)]),
            Kind::Switch { get, .. } => Value::Switch(get(scene)),
        }
    }

    /// Set the value, refusing what makes no physical sense by itself; the scene is unchanged then.
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

    /// Read a text as a value of this variable; numbers may be relative to the scene's present value. Whether a number makes sense
    /// is found when it is set.
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

    /// The unit of a bare number under this name on the command line: the full key ends in its unit.
    pub fn bare(&self, name: &str) -> Bare<'static> {
        if name == self.key { Bare::Stored } else { Bare::Si }
    }

    /// The value as text that [`Variable::parse`] reads back exactly: shortest digits, no unit.
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

    /// The words of a choice, in order; none for a number or a switch.
    pub fn keys(&self) -> &'static [&'static str] {
        if let Kind::Choice { words, .. } = self.kind { words } else { &[] }
    }

    /// The stored unit's name; empty for pure numbers and words.
    pub fn unit(&self) -> &'static str {
        self.number().map_or("", |number| number.quantity.unit())
    }

    /// Returns the numeric properties; `None` for a choice or a switch.
    pub fn number(&self) -> Option<&Number> {
        if let Kind::Number(number) = &self.kind { Some(number) } else { None }
    }

    /// The allowed values, in words.
    pub fn allowed(&self) -> String {
        match &self.kind {
            Kind::Number(number) => {
                let rule = number.allowed.describe(number.quantity);
                let rule = match number.allowed {
                    Allowed::Positive => {
                        format!("{rule}: {}", Allowed::From(LEAST).describe(number.quantity))
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

    /// A warning when the value is outside the range the thesis searched: `gamma = 12 is outside 0.8..7 of Table 9.2: the thesis
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

    /// Refuses a number that makes no physical sense by itself.
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
        // A positive variable has a stated minimum.
        let is_tiny = *allowed == Allowed::Positive && value > 0.0;
        let rule = if is_tiny { Allowed::From(LEAST) } else { *allowed };
        let (value, allowed) = (format!("{written} {}", quantity.unit()), rule.describe(*quantity));
        let value = value.trim_end().to_owned();
        let Self { symbol, key, meaning, .. } = *self;
        Err(VariableError::Impossible { symbol, key, value, meaning, allowed, cure })
    }
}

/// Set a variable by name from text, as `--set NAME=VALUE` does; the scene is unchanged where that is refused.
pub fn set_by_name(scene: &mut Scene, name: &str, text: &str) -> Result<(), VariableError> {
    let variable = find(name.trim())?;
    let value = variable.parse(scene, text, variable.bare(name.trim()))?;
    variable.set(scene, value)
}

/// Check every value and the rules between values, in the order of the table.
pub fn validate(scene: &Scene) -> Result<(), VariableError> {
    for variable in VARIABLES.iter() {
        variable.check(variable.value(scene))?;
    }
    rules::check(scene)
}

/// A scene with variables changed, as `--set` takes them: `k=1e5 n=0.5`.
pub fn changed(mut scene: Scene, changes: &str) -> Result<Scene, VariableError> {
    for change in changes.split_whitespace() {
        let (name, value) = change.split_once('=').unwrap_or((change, ""));
        set_by_name(&mut scene, name, value)?;
    }
    Ok(scene)
}

/// As [`changed`], of Table 9.1 with gamma = 1 and neither spring nor damper.
pub fn changed_free_plate(changes: &str) -> Result<Scene, VariableError> {
    changed(Scene::default(), &format!("k=0 {changes}"))
}

/// Every value that is legal yet outside the range the thesis searched. Another shot or target than that of the thesis has nothing to
/// do with its range.
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

/// The default scene with changes like `k=1e6 n=0.5`, in SI units.
#[cfg(test)]
pub(in crate::model) fn scene_with(pairs: &str) -> Scene {
    changed(Scene::default(), pairs).expect("values the variables take")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every number above zero has a least value, which its description says and below which it is refused.
    #[test]
    fn numbers_above_zero_have_a_least_value() {
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
        }
        assert_eq!(exponents, 3);
        let refusal = set_by_name(&mut Scene::default(), "n", "1e-20").unwrap_err().to_string();
        assert!(refusal.contains("0.01 or more"), "{refusal}");
    }
}
