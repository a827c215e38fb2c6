//! Parts of a scene: structs that have beside each field its default value and its row of the table of variables.

use super::{Allowed, Group, Kind, Number, Variable};
use crate::model::scene::Scene;
use crate::model::units::Dimension;

/// Sources of many defaults.
pub(in crate::model) const TABLE_9_1: &str = "thesis Table 9.1";
pub(in crate::model) const TABLE_9_2: &str = "thesis Table 9.2 (range searched)";
/// The source of most defaults of the springs.
pub(in crate::model) const NO_VALUES: &str = "assumption: the thesis gives no values";

/// Defines structs whose fields are variables, each with its place in a scene. A field has its type, its default value, its symbol, its
/// label (a noun of at most sixteen letters), its meaning, the kind of its value, and its further attributes, which are
/// fields of the row:
///
/// ```text
/// pub velocity_m_s: f64 = 100.0 => "v_i", "impact velocity", "impact velocity", number(Velocity, Positive).source(TABLE_9_1);
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
                        $kind:ident($($of_kind:tt)*) $(.$attribute:ident($value:expr))*)?;
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
                $crate::model::variables::part::rows! {
                    $place $($($field: $type => $($symbol, $label, $meaning,)?
                        $kind($($of_kind)*) $(.$attribute($value))*;)?)+
                }
            }
        }
    )+};
}

/// The rows of the fields of a part of a scene.
macro_rules! rows {
    ($place:tt $($field:ident: $type:ty => $($symbol:literal, $label:literal, $meaning:literal,)?
        $kind:ident($($of_kind:tt)*) $(.$attribute:ident($value:expr))*;)*) => {{
        let rows: &[Vec<_>] = &[$($crate::model::variables::part::row! {
            $place $field: $type, [$($symbol, $label, $meaning)?], $kind($($of_kind)*) $(.$attribute($value))*
        }),*];
        rows.concat()
    }};
}

/// The rows that belong to a field: one with a symbol, or those a function lists.
macro_rules! row {
    ($place:tt $field:ident: $type:ty, [], each($rows:expr)) => {
        $rows()
    };
    (
        ($($place:ident).+) $field:ident: $type:ty, [$symbol:literal, $label:literal, $meaning:literal],
        $kind:ident($($of_kind:tt)*) $(.$attribute:ident($value:expr))*
    ) => {{
        let row = &mut $crate::model::variables::Variable::new(
            [concat!($(stringify!($place), ".",)+ stringify!($field)), $symbol, $label, $meaning],
            $crate::model::variables::part::kind!($($place).+.$field: $type, $kind($($of_kind)*)),
        );
        $(row.$attribute = $value;)*
        vec![*row]
    }};
}

/// The kind of a variable that is a field of a scene, with its access.
macro_rules! kind {
    // A required number.
    ($($field:ident).+: $type:ty, number($quantity:ident, $($allowed:tt)+)) => {{
        use $crate::model::variables::{Allowed, Kind, Number};
        Kind::Number(Number {
            get: |scene| Some(scene.$($field).+),
            set: |scene, value| scene.$($field).+ = value.unwrap_or_default(),
            ..Number::new($crate::model::units::Dimension::$quantity, Allowed::$($allowed)+)
        })
    }};
    // An optional number, with the word for its absence.
    ($($field:ident).+: $type:ty, optional($quantity:ident, $allowed:ident, $absent:literal)) => {{
        use $crate::model::variables::{Allowed, Kind, Number};
        Kind::Number(Number {
            absent: Some($absent),
            get: |scene| scene.$($field).+,
            set: |scene, value| scene.$($field).+ = value,
            ..Number::new($crate::model::units::Dimension::$quantity, Allowed::$allowed)
        })
    }};
    // One of a few words.
    ($($field:ident).+: $type:ty, choice()) => {
        $crate::model::variables::Kind::Choice {
            words: &<$type>::WORDS,
            get: |scene| scene.$($field).+ as usize,
            set: |scene, index| scene.$($field).+ = <$type>::ALL[index],
        }
    };
    // Anything else.
    ($($field:ident).+: $type:ty, is($kind:expr)) => {
        $kind
    };
}

pub(in crate::model) use {kind, parts, row, rows};

/// The rows of a part of a scene in a group of the editor: whether a list shows them at all, and whether they then have any effect.
pub(in crate::model) fn placed(
    group: Group,
    listed: fn(&Scene) -> bool,
    used: fn(&Scene) -> bool,
    mut rows: Vec<Variable>,
) -> Vec<Variable> {
    for row in &mut rows {
        (row.group, row.part) = (group, [listed, used]);
    }
    rows
}

impl Variable {
    /// A row without further attributes; the part of the scene it belongs to follows.
    pub(in crate::model) fn new(words: [&'static str; 4], kind: Kind) -> Self {
        let [key, symbol, label, meaning] = words;
        Self {
            key,
            symbol,
            label,
            own_name: "",
            aliases: &[],
            is_seldom: false,
            listed: |_| true,
            used: |_| true,
            when: |_| true,
            part: [|_| true; 2],
            group: Group::Run,
            meaning,
            source: "assumption",
            thesis_range: None,
            is_log: false,
            kind,
        }
    }
}

impl Number {
    /// A number that is required; its access follows.
    pub(in crate::model) const fn new(quantity: Dimension, allowed: Allowed) -> Self {
        Self { quantity, allowed, absent: None, get: |_| None, set: |_, _| {} }
    }
}
