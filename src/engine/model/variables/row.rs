//! Row of the table of variables, for any type of scene with the parts that the row reads.
//!
//! The rows are declared beside the fields of the parts. They are generic in the scene, because the scene contains the parts.

use crate::model::labelled_enum::labelled_enum;
use crate::model::units::{self, Bare, Dimension};
use crate::model::variables::error::VariableError;

/// Row of the table of variables. `S` is the scene.
pub struct Row<S> {
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
    pub listed: fn(&S) -> bool,
    /// Whether the variable has an effect; the editor dims variables without one.
    pub used: fn(&S) -> bool,
    /// Condition for both `listed` and `used`.
    pub when: fn(&S) -> bool,
    /// Conditions under which the part of the scene is listed and has an effect.
    pub part: [fn(&S) -> bool; 2],
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
    pub kind: RowKind<S>,
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
pub enum RowKind<S> {
    /// Number.
    Number(RowNumber<S>),
    /// Choice between keywords.
    Choice {
        /// Keywords, in order.
        words: &'static [&'static str],
        /// Returns the index into `words`.
        get: fn(&S) -> usize,
        /// Sets the choice by its index into `words`.
        set: fn(&mut S, usize),
    },
    /// Switch, `true` or `false`.
    Switch {
        /// Returns the value.
        get: fn(&S) -> bool,
        /// Sets the value.
        set: fn(&mut S, bool),
    },
}

/// Numeric variable.
pub struct RowNumber<S> {
    /// Dimension, which determines the units.
    pub quantity: Dimension,
    /// Physically possible values.
    pub allowed: Allowed,
    /// Keyword for a missing value (`none`, `auto`); `None` if the value is required.
    pub absent: Option<&'static str>,
    /// Returns the value in the stored unit; `None` if absent.
    pub get: fn(&S) -> Option<f64>,
    /// Sets the value, in the stored unit.
    pub set: fn(&mut S, Option<f64>),
}

/// Minimum value of a positive quantity, in its stored unit: 1e-15 m is the size of a nucleus. Products and powers of smaller values
/// underflow.
pub(super) const LEAST: f64 = 1e-15;

/// Maximum value of a positive quantity, in its stored unit: 1e15 kg is the mass of a mountain. Squares of a velocity that such a mass
/// shares with a projectile keep their digits.
pub(super) const MOST: f64 = 1e15;
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

impl<S: Default> Row<S> {
    /// Returns the value in a scene.
    pub fn value(&self, scene: &S) -> Value {
        match &self.kind {
            RowKind::Number(number) => (number.get)(scene).map_or(Value::Absent, Value::Number),
            RowKind::Choice { words, get, .. } => Value::Word(words[get(scene)]),
            RowKind::Switch { get, .. } => Value::Switch(get(scene)),
        }
    }

    /// Sets the value; rejects values without physical sense and leaves the scene unchanged.
    pub fn set(&self, scene: &mut S, value: Value) -> Result<(), VariableError> {
        self.check(value)?;
        match (&self.kind, value) {
            (RowKind::Number(number), Value::Number(new)) => (number.set)(scene, Some(new)),
            (RowKind::Number(RowNumber { absent: Some(_), set, .. }), Value::Absent) => {
                set(scene, None);
            }
            (RowKind::Choice { words, set, .. }, Value::Word(word)) => {
                let index = words.iter().position(|it| *it == word);
                set(scene, index.ok_or_else(|| self.not_a_choice(word))?);
            }
            (RowKind::Switch { set, .. }, Value::Switch(on)) => set(scene, on),
            (_, other) => return Err(self.not_a_choice(&self.written(other))),
        }
        Ok(())
    }

    /// Parses a value of this variable; numbers may be relative to the scene's present value. [`Row::set`] checks the physical sense.
    pub fn parse(&self, scene: &S, text: &str, bare: Bare<'_>) -> Result<Value, VariableError> {
        let word = text.trim();
        match &self.kind {
            RowKind::Number(number) => {
                if number.absent == Some(word) {
                    return Ok(Value::Absent);
                }
                let old = (number.get)(scene).unwrap_or(0.0);
                let value = units::parse_relative(text, old, number.quantity, bare);
                let Self { symbol, key, .. } = *self;
                let refuse = |source| VariableError::Unreadable { symbol, key, source };
                value.map(Value::Number).map_err(refuse)
            }
            RowKind::Choice { words, .. } => {
                let found = words.iter().find(|it| **it == word).map(|it| Value::Word(it));
                found.ok_or_else(|| self.not_a_choice(word))
            }
            RowKind::Switch { .. } => match word {
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

    /// Formats the value so that [`Row::parse`] returns it exactly: shortest digits, no unit.
    pub fn show(&self, scene: &S) -> String {
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
        if let RowKind::Choice { words, .. } = self.kind { words } else { &[] }
    }

    /// Returns the name of the stored unit; empty for pure numbers and words.
    pub fn unit(&self) -> &'static str {
        self.number().map_or("", |number| number.quantity.unit())
    }

    /// Returns the numeric properties; `None` for a choice or a switch.
    pub fn number(&self) -> Option<&RowNumber<S>> {
        if let RowKind::Number(number) = &self.kind { Some(number) } else { None }
    }

    /// Describes the allowed values.
    pub fn allowed(&self) -> String {
        match &self.kind {
            RowKind::Number(number) => {
                let rule = number.allowed.describe(number.quantity);
                let rule = match number.allowed {
                    Allowed::Positive => {
                        format!("{rule}: {}", SENSIBLE.describe(number.quantity))
                    }
                    _ => rule,
                };
                number.absent.map_or_else(|| rule.clone(), |word| format!("{rule}, or `{word}`"))
            }
            RowKind::Choice { words, .. } => {
                format!("{} or {}", words[..words.len() - 1].join(", "), words[words.len() - 1])
            }
            RowKind::Switch { .. } => "true or false".to_owned(),
        }
    }

    fn not_a_choice(&self, text: &str) -> VariableError {
        let Self { symbol, key, .. } = *self;
        let (value, allowed) = (text.to_owned(), self.allowed());
        VariableError::NotAChoice { symbol, key, value, allowed }
    }

    /// Rejects a number that makes no physical sense by itself.
    pub(super) fn check(&self, value: Value) -> Result<(), VariableError> {
        let (RowKind::Number(number), Value::Number(value)) = (&self.kind, value) else {
            return Ok(());
        };
        let RowNumber { quantity, allowed, get, .. } = number;
        if allowed.contains(value) {
            return Ok(());
        }
        let cure = match get(&S::default()) {
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
