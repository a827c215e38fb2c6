//! The rows of the table of variables, in the order of the editor: one file a subject.

use std::sync::LazyLock;

use super::visible::Visible;
use super::{Allowed, Kind, Number, Step, Variable};
use crate::model::scene::{Combination, Scene};
use crate::model::units::Quantity;

/// The group of the editor that a path of the scene belongs to.
macro_rules! group {
    (projectile $($rest:tt)+) => {
        Group::Projectile
    };
    (target $($rest:tt)+) => {
        Group::Target
    };
    (plate $($rest:tt)+) => {
        Group::Plate
    };
    (mechanism.stop $($rest:tt)+) => {
        Group::Stop
    };
    (mechanism $($rest:tt)+) => {
        Group::Mechanism
    };
    (stack $($rest:tt)+) => {
        Group::Stack
    };
    (run $($rest:tt)+) => {
        Group::Run
    };
    ($($rest:tt)+) => {
        Group::Interface
    };
}

/// A variable by its path in the scene, which is its key, and its kind. What else there is to say of it follows.
macro_rules! variable {
    ($first:ident $(. $rest:ident)+, $kind:expr) => {
        Variable {
            key: concat!(stringify!($first) $(, ".", stringify!($rest))+),
            symbol: "",
            label: "",
            aliases: &[],
            visible: Visible::ALWAYS,
            group: group!($first $(. $rest)+),
            meaning: "",
            source: "assumption",
            kind: $kind,
        }
    };
}

/// A required number at a path of the scene.
macro_rules! number {
    ($quantity:ident, $allowed:expr, $($field:ident).+) => {
        variable!(
            $($field).+,
            Kind::Number(Number {
                get: |scene| Some(scene.$($field).+),
                set: |scene, value| scene.$($field).+ = value.unwrap_or_default(),
                ..Number::of(Quantity::$quantity, $allowed)
            })
        )
    };
}

/// A required number on which the plate's mass ratio may depend.
macro_rules! sizing {
    ($quantity:ident, $($field:ident).+) => {
        variable!(
            $($field).+,
            Kind::Number(Number {
                get: |scene| Some(scene.$($field).+),
                set: |scene, value| {
                    scene.$($field).+ = value.unwrap_or_default();
                    scene.follow_size();
                },
                ..Number::of(Quantity::$quantity, Allowed::Positive)
            })
        )
    };
}

/// An optional number at a path of the scene, with the word for its absence.
macro_rules! optional {
    ($quantity:ident, $allowed:expr, $absent:literal, $($field:ident).+) => {
        variable!(
            $($field).+,
            Kind::Number(Number {
                absent: Some($absent),
                get: |scene| scene.$($field).+,
                set: |scene, value| scene.$($field).+ = value,
                ..Number::of(Quantity::$quantity, $allowed)
            })
        )
    };
}

/// A choice at a path of the scene.
macro_rules! choice {
    ($type:ident, $($field:ident).+) => {
        variable!(
            $($field).+,
            Kind::Choice(Choice {
                words: &$type::WORDS,
                get: |scene| scene.$($field).+ as usize,
                set: |scene, index| {
                    scene.$($field).+ = $type::ALL[index.min($type::ALL.len() - 1)];
                },
            })
        )
    };
}

mod bodies;
mod contact;
mod mechanism;
mod spring;

const TABLE_9_1: &str = "thesis Table 9.1";
const TABLE_9_2: &str = "thesis Table 9.2 (range searched)";

/// The attributes of a row besides its path and kind.
impl Variable {
    const fn named(self, symbol: &'static str, label: &'static str) -> Self {
        Self { symbol, label, ..self }
    }

    const fn also(self, aliases: &'static [&'static str]) -> Self {
        Self { aliases, ..self }
    }

    const fn means(self, meaning: &'static str) -> Self {
        Self { meaning, ..self }
    }

    /// Where the default comes from.
    const fn from(self, source: &'static str) -> Self {
        Self { source, ..self }
    }

    const fn visible_when(self, visible: Visible) -> Self {
        Self { visible, ..self }
    }

    const fn when(self, used: fn(&Scene) -> bool) -> Self {
        self.visible_when(Visible { listed: used, used })
    }

    /// Always listed, but with an effect only here.
    const fn used_when(self, used: fn(&Scene) -> bool) -> Self {
        self.visible_when(Visible { used, ..Visible::ALWAYS })
    }

    /// Listed only here, and with an effect.
    const fn listed_when(self, listed: fn(&Scene) -> bool) -> Self {
        self.visible_when(Visible { listed, ..Visible::ALWAYS })
    }

    /// The range the thesis searched.
    const fn searched(mut self, range: Option<(f64, f64)>) -> Self {
        if let Kind::Number(number) = &mut self.kind {
            number.thesis_range = range;
        }
        self
    }

    /// The editor's arrow keys multiply it.
    const fn log(mut self) -> Self {
        if let Kind::Number(number) = &mut self.kind {
            number.step = Step::Log;
        }
        self
    }
}

impl Number {
    /// A number that is required; its path follows later.
    const fn of(quantity: Quantity, allowed: Allowed) -> Self {
        let (thesis_range, step, absent) = (None, Step::Linear, None);
        Self { quantity, allowed, thesis_range, step, absent, get: |_| None, set: |_, _| {} }
    }
}

/// The rows whose values a run of this scene may read: a plain spring has no need of the rest.
pub(super) fn checked(scene: &Scene) -> impl Iterator<Item = &'static Variable> {
    let alone = scene.mechanism.combination == Combination::Alone;
    let first = if scene.mechanism.is_plain() { spring::PLAIN } else { spring::FIRST.len() };
    let second = if alone { 0 } else { spring::SECOND.len() };
    let before = bodies::ROWS.iter().chain(mechanism::DAMPER).chain(&spring::FIRST[..first]);
    before
        .chain(&spring::SECOND[..second])
        .chain(mechanism::STOP)
        .chain(mechanism::STACK)
        .chain(contact::ROWS)
}

/// Every variable there is.
pub static VARIABLES: LazyLock<Vec<Variable>> = LazyLock::new(|| {
    let tables: [&[Variable]; 8] = [
        bodies::ROWS,
        mechanism::DAMPER,
        spring::FIRST,
        mechanism::COMBINATION,
        spring::SECOND,
        mechanism::STOP,
        mechanism::STACK,
        contact::ROWS,
    ];
    tables.concat()
});

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use super::VARIABLES;

    #[test]
    fn names_are_unique() {
        let mut seen = HashSet::new();
        for variable in VARIABLES.iter() {
            for name in [variable.symbol, variable.key].iter().chain(variable.aliases) {
                assert!(seen.insert(*name), "{name} twice");
            }
        }
    }
}
