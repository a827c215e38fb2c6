//! Parts of a scene: structs that declare the default value and the table row of each field.

use super::{Allowed, Group, Kind, Number, Variable};
use crate::model::scene::Scene;
use crate::model::units::Dimension;

/// Source of many defaults.
pub(in crate::model) const TABLE_9_1: &str = "thesis Table 9.1";
pub(in crate::model) const TABLE_9_2: &str = "thesis Table 9.2 (range searched)";
/// Source of most defaults of the springs.
pub(in crate::model) const NO_VALUES: &str = "assumption: the thesis gives no values";

/// Defines structs whose fields are variables of a scene. A field has a type, default value, symbol, label (a noun of at most sixteen
/// letters), meaning, kind of value, and further attributes, which are fields of the row:
///
/// ```text
/// pub velocity_m_s: f64 = 100.0 => "v_i", "impact velocity", "impact velocity", number(Velocity, Positive).source(TABLE_9_1);
/// ```
///
/// A field without a row is a part of its own, or `each(function)` returns its rows.
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
            /// Returns the rows of the fields, in order.
            pub(in crate::model) fn rows() -> Vec<$crate::model::variables::Variable> {
                $crate::model::variables::part::rows! {
                    $place $($($field: $type => $($symbol, $label, $meaning,)?
                        $kind($($of_kind)*) $(.$attribute($value))*;)?)+
                }
            }
        }
    )+};
}

/// Returns the rows of the fields of a part of a scene.
macro_rules! rows {
    ($place:tt $($field:ident: $type:ty => $($symbol:literal, $label:literal, $meaning:literal,)?
        $kind:ident($($of_kind:tt)*) $(.$attribute:ident($value:expr))*;)*) => {{
        let rows: &[Vec<_>] = &[$($crate::model::variables::part::row! {
            $place $field: $type, [$($symbol, $label, $meaning)?], $kind($($of_kind)*) $(.$attribute($value))*
        }),*];
        rows.concat()
    }};
}

/// Returns the rows of a field: one with a symbol, or those of a function.
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

/// Kind of a variable that is a field of a scene, with its access.
macro_rules! kind {
    // Required number.
    ($($field:ident).+: $type:ty, number($quantity:ident, $($allowed:tt)+)) => {{
        use $crate::model::variables::{Allowed, Kind, Number};
        Kind::Number(Number {
            get: |scene| Some(scene.$($field).+),
            set: |scene, value| scene.$($field).+ = value.unwrap_or_default(),
            ..Number::new($crate::model::units::Dimension::$quantity, Allowed::$($allowed)+)
        })
    }};
    // Optional number, with the keyword for a missing value.
    ($($field:ident).+: $type:ty, optional($quantity:ident, $allowed:ident, $absent:literal)) => {{
        use $crate::model::variables::{Allowed, Kind, Number};
        Kind::Number(Number {
            absent: Some($absent),
            get: |scene| scene.$($field).+,
            set: |scene, value| scene.$($field).+ = value,
            ..Number::new($crate::model::units::Dimension::$quantity, Allowed::$allowed)
        })
    }};
    // Choice between keywords.
    ($($field:ident).+: $type:ty, choice()) => {
        $crate::model::variables::Kind::Choice {
            words: &<$type>::WORDS,
            get: |scene| scene.$($field).+ as usize,
            set: |scene, index| scene.$($field).+ = <$type>::ALL[index],
        }
    };
    // Other kinds.
    ($($field:ident).+: $type:ty, is($kind:expr)) => {
        $kind
    };
}

pub(in crate::model) use {kind, parts, row, rows};

/// Assigns the rows of a part to a group of the editor, with the conditions under which they are listed and have an effect.
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
    /// Creates a row without further attributes; its part of the scene is set later.
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
    /// Creates a required number; its access is set later.
    pub(in crate::model) const fn new(quantity: Dimension, allowed: Allowed) -> Self {
        Self { quantity, allowed, absent: None, get: |_| None, set: |_, _| {} }
    }
}
