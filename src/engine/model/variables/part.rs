//! Parts of a scene: structs that have beside each field its default value and its row of the table of variables.

use super::visible::Visible;
use super::{Allowed, Group, Kind, Number, Step, Variable};
use crate::model::scene::Scene;
use crate::model::units::Dimension;

/// Sources of many defaults.
pub(in crate::model) const TABLE_9_1: &str = "thesis Table 9.1";
pub(in crate::model) const TABLE_9_2: &str = "thesis Table 9.2 (range searched)";
/// The source of most defaults of the springs.
pub(in crate::model) const NO_VALUES: &str = "assumption: the thesis gives no values";

/// Defines structs whose fields are variables, each with its place in a scene. A field has its type, its default value, its symbol, its
/// label (a noun of at most sixteen letters), its meaning, the kind of its value, and its further attributes:
///
/// ```text
/// pub velocity_m_s: f64 = 100.0 => "v_i", "impact velocity", "impact velocity", number(Velocity, Positive).from(TABLE_9_1);
/// ```
///
/// A field without a row is a part by itself, or `each(function)` lists rows for it.
macro_rules! parts {
    ($(
        $(#[$meta:meta])*
        pub struct $name:ident at $place:tt {
            $(
                $(#[$doc:meta])*
                pub $field:ident: $type:ty = $default:expr
                    $(=> $($symbol:literal, $label:literal, $meaning:literal,)?
                        $kind:ident($($of_kind:tt)*) $(.$more:ident($($value:expr),*))*)?;
            )+
        }
    )+) => {$(
        $(#[$meta])*
        pub struct $name {
            $(
                $(#[$doc])*
                $($(#[doc = concat!($meaning, ".")])?)?
                pub $field: $type,
            )+
        }

        impl Default for $name {
            fn default() -> Self {
                Self { $($field: $default,)+ }
            }
        }

        impl $name {
            /// The rows of its fields, in order.
            pub(in crate::model) fn rows() -> Vec<$crate::model::variables::Variable> {
                let rows: &[Vec<_>] = &[$($($crate::model::variables::part::row! {
                    $place $field: $type, [$($symbol, $label, $meaning)?], $kind($($of_kind)*)
                    $(.$more($($value),*))*
                },)?)+];
                rows.concat()
            }
        }
    )+};
}

/// The rows that belong to a field: one with a symbol, or those a function lists.
macro_rules! row {
    ($place:tt $field:ident: $type:ty, [], each($rows:expr)) => {
        $rows()
    };
    (
        ($($place:ident).+) $field:ident: $type:ty, [$symbol:literal, $label:literal, $meaning:literal],
        $kind:ident($($of_kind:tt)*) $(.$more:ident($($value:expr),*))*
    ) => {
        vec![
            $crate::model::variables::Variable::new(
                concat!($(stringify!($place), ".",)+ stringify!($field)),
                $crate::model::variables::part::kind!($($place).+.$field: $type, $kind($($of_kind)*)),
            )
            .named($symbol, $label, $meaning)
            $(.$more($($value),*))*
        ]
    };
}

/// The kind of a variable that is a field of a scene, with its access.
macro_rules! kind {
    // A required number.
    ($($field:ident).+: $type:ty, number($quantity:ident, $($allowed:tt)+)) => {{
        use $crate::model::variables::{Allowed, Kind, Number};
        Kind::Number(Number {
            get: |scene| Some(scene.$($field).+),
            set: |scene, value| {
                scene.$($field).+ = value.unwrap_or_default();
                // The plate's mass ratio may depend on it.
                scene.follow_size();
            },
            ..Number::of($crate::model::units::Dimension::$quantity, Allowed::$($allowed)+)
        })
    }};
    // An optional number, with the word for its absence.
    ($($field:ident).+: $type:ty, optional($quantity:ident, $allowed:ident, $absent:literal)) => {{
        use $crate::model::variables::{Allowed, Kind, Number};
        Kind::Number(Number {
            absent: Some($absent),
            get: |scene| scene.$($field).+,
            set: |scene, value| scene.$($field).+ = value,
            ..Number::of($crate::model::units::Dimension::$quantity, Allowed::$allowed)
        })
    }};
    // One of a few words.
    ($($field:ident).+: $type:ty, choice()) => {{
        use $crate::model::variables::{Choice, Kind};
        Kind::Choice(Choice {
            words: &<$type>::WORDS,
            get: |scene| scene.$($field).+ as usize,
            set: |scene, index| scene.$($field).+ = <$type>::ALL[index],
        })
    }};
    // Anything else.
    ($($field:ident).+: $type:ty, is($kind:expr)) => {
        $kind
    };
}

pub(in crate::model) use {kind, parts, row};

/// The rows of a part of a scene in a group of the editor: whether a list shows them at all, and whether they then have any effect.
pub(in crate::model) fn placed(
    group: Group,
    listed: fn(&Scene) -> bool,
    used: fn(&Scene) -> bool,
    rows: Vec<Variable>,
) -> Vec<Variable> {
    let part = Visible { listed, used };
    rows.into_iter().map(|row| Variable { part, group, ..row }).collect()
}

impl Variable {
    /// A variable of a key; its further attributes, and the part of the scene it belongs to, follow.
    pub(in crate::model) const fn new(key: &'static str, kind: Kind) -> Self {
        Self {
            key,
            symbol: "",
            label: "",
            own_name: "",
            aliases: &[],
            is_seldom: false,
            part: Visible::ALWAYS,
            visible: Visible::ALWAYS,
            group: Group::Run,
            meaning: "",
            source: "assumption",
            kind,
        }
    }

    pub(in crate::model) fn named(
        self,
        symbol: &'static str,
        label: &'static str,
        meaning: &'static str,
    ) -> Self {
        Self { symbol, label, meaning, ..self }
    }

    /// Its name in words where its key does not give it.
    pub(in crate::model) fn called(self, own_name: &'static str) -> Self {
        Self { own_name, ..self }
    }

    pub(in crate::model) fn also(self, aliases: &'static [&'static str]) -> Self {
        Self { aliases, ..self }
    }

    /// Where the default comes from.
    pub(in crate::model) fn from(self, source: &'static str) -> Self {
        Self { source, ..self }
    }

    /// A file has it only where its value is not the default.
    pub(in crate::model) fn seldom(self) -> Self {
        Self { is_seldom: true, ..self }
    }

    /// Listed only here, and with an effect only here.
    pub(in crate::model) fn when(self, used: fn(&Scene) -> bool) -> Self {
        self.listed_when(used).used_when(used)
    }

    /// With an effect only here.
    pub(in crate::model) fn used_when(self, used: fn(&Scene) -> bool) -> Self {
        Self { visible: Visible { used, ..self.visible }, ..self }
    }

    /// Listed only here.
    pub(in crate::model) fn listed_when(self, listed: fn(&Scene) -> bool) -> Self {
        Self { visible: Visible { listed, ..self.visible }, ..self }
    }

    /// The range the thesis searched.
    pub(in crate::model) fn searched(mut self, low: f64, high: f64) -> Self {
        if let Kind::Number(number) = &mut self.kind {
            number.thesis_range = Some((low, high));
        }
        self
    }

    /// The editor's arrow keys multiply it.
    pub(in crate::model) fn log(mut self) -> Self {
        if let Kind::Number(number) = &mut self.kind {
            number.step = Step::Log;
        }
        self
    }
}

impl Number {
    /// A number that is required; its access follows.
    pub(in crate::model) const fn of(quantity: Dimension, allowed: Allowed) -> Self {
        let (thesis_range, step, absent) = (None, Step::Linear, None);
        Self { quantity, allowed, thesis_range, step, absent, get: |_| None, set: |_, _| {} }
    }
}
