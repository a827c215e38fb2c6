//! Parts of a scene: structs that declare the default value and the table row of each field.

use super::row::{Allowed, Group, Row, RowKind, RowNumber};
use crate::model::units::Dimension;

/// Source of many defaults.
pub(in crate::model) const TABLE_9_1: &str = "thesis Table 9.1";
pub(in crate::model) const TABLE_9_2: &str = "thesis Table 9.2 (range searched)";
/// Source of most defaults of the springs.
pub(in crate::model) const NO_VALUES: &str = "assumption: the thesis gives no values";

/// Returns the part of type `P` of a scene.
pub(in crate::model) fn part<P>(scene: &impl AsRef<P>) -> &P {
    scene.as_ref()
}

/// Returns the part of type `P` of a scene, to change it.
pub(in crate::model) fn part_mut<P>(scene: &mut impl AsMut<P>) -> &mut P {
    scene.as_mut()
}

/// Defines structs whose fields are variables of a scene. A field has a type, default value, symbol, label (a noun of at most sixteen
/// letters), meaning, kind of value, and further attributes, which are fields of the row:
///
/// ```text
/// pub velocity_m_s: f64 = 100.0 => "v_i", "impact velocity", "impact velocity", number(Velocity, Positive).source(TABLE_9_1);
/// ```
///
/// A field without a row is a part of its own, or `each(function)` returns its rows.
///
/// The head states where files have the struct, and the part of the scene that contains it: `at (mechanism.spring: Spring.beam)` is the
/// field `beam` of the part `Spring`, with the key `mechanism.spring.beam`. `reads(...)` lists the other parts that the rows read.
macro_rules! parts {
    ($(
        $(#[$meta:meta])*
        pub struct $name:ident at $place:tt $(reads($($read:ty),+))? {
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
            $crate::model::variables::part::rows! {
                /// Returns the rows of the fields, in order.
                fn rows at $place $(reads($($read),+))?;
                $($($field: $type => $($symbol, $label, $meaning,)?
                    $kind($($of_kind)*) $(.$attribute($value))*;)?)+
            }
        }
    )+};
}

/// Defines a function that returns the rows of the fields of a part of a scene.
macro_rules! rows {
    (
        $(#[$doc:meta])*
        fn $name:ident at ($($place:ident).+: $part:ident $(.$sub:ident)*) $($rest:tt)*
    ) => {
        $crate::model::variables::part::rows! {
            in $part: $(#[$doc])*
            fn $name at ($($place).+: $part $(.$sub)*) $($rest)*
        }
    };
    (
        in $part:ident: $(#[$doc:meta])*
        fn $name:ident at $place:tt $(reads($($read:ty),+))?;
        $($field:ident: $type:ty => $($symbol:literal, $label:literal, $meaning:literal,)?
            $kind:ident($($of_kind:tt)*) $(.$attribute:ident($value:expr))*;)*
    ) => {
        $(#[$doc])*
        pub(in crate::model) fn $name<S>() -> Vec<$crate::model::variables::row::Row<S>>
        where
            S: AsRef<$part> + AsMut<$part> $($(+ AsRef<$read>)+)?,
        {
            let rows: [Vec<$crate::model::variables::row::Row<S>>; _] =
                [$($crate::model::variables::part::row! {
                    $place $field: $type, [$($symbol, $label, $meaning)?],
                    $kind($($of_kind)*) $(.$attribute($value))*
                }),*];
            rows.into_iter().flatten().collect()
        }
    };
}

/// Returns the rows of a field: one with a symbol, or those of a function.
macro_rules! row {
    ($place:tt $field:ident: $type:ty, [], each($rows:expr)) => {
        $rows()
    };
    (
        ($($place:ident).+: $part:ident $(.$sub:ident)*) $field:ident: $type:ty,
        [$symbol:literal, $label:literal, $meaning:literal],
        $kind:ident($($of_kind:tt)*) $(.$attribute:ident($value:expr))*
    ) => {
        vec![$crate::model::variables::row::Row {
            $($attribute: $value,)*
            ..$crate::model::variables::row::Row::new(
                [
                    concat!($(stringify!($place), ".",)+ $(stringify!($sub), ".",)* stringify!($field)),
                    $symbol,
                    $label,
                    $meaning,
                ],
                $crate::model::variables::part::kind!($part $(.$sub)*.$field: $type, $kind($($of_kind)*)),
            )
        }]
    };
}

/// Kind of a variable that is a field of a part of a scene, with its access.
macro_rules! kind {
    // Required number.
    ($part:ident $(.$field:ident)+: $type:ty, number($quantity:ident, $($allowed:tt)+)) => {{
        use $crate::model::variables::part::{part, part_mut};
        use $crate::model::variables::row::{Allowed, RowKind, RowNumber};
        RowKind::Number(RowNumber {
            get: |scene| Some(part::<$part>(scene)$(.$field)+),
            set: |scene, value| part_mut::<$part>(scene)$(.$field)+ = value.unwrap_or_default(),
            ..RowNumber::new($crate::model::units::Dimension::$quantity, Allowed::$($allowed)+)
        })
    }};
    // Optional number, with the keyword for a missing value.
    ($part:ident $(.$field:ident)+: $type:ty, optional($quantity:ident, $allowed:ident, $absent:literal)) => {{
        use $crate::model::variables::part::{part, part_mut};
        use $crate::model::variables::row::{Allowed, RowKind, RowNumber};
        RowKind::Number(RowNumber {
            absent: Some($absent),
            get: |scene| part::<$part>(scene)$(.$field)+,
            set: |scene, value| part_mut::<$part>(scene)$(.$field)+ = value,
            ..RowNumber::new($crate::model::units::Dimension::$quantity, Allowed::$allowed)
        })
    }};
    // Choice between keywords.
    ($part:ident $(.$field:ident)+: $type:ty, choice()) => {{
        use $crate::model::variables::part::{part, part_mut};
        $crate::model::variables::row::RowKind::Choice {
            words: &<$type>::WORDS,
            get: |scene| part::<$part>(scene)$(.$field)+ as usize,
            set: |scene, index| part_mut::<$part>(scene)$(.$field)+ = <$type>::ALL[index],
        }
    }};
    // Switch.
    ($part:ident $(.$field:ident)+: $type:ty, switch()) => {{
        use $crate::model::variables::part::{part, part_mut};
        $crate::model::variables::row::RowKind::Switch {
            get: |scene| part::<$part>(scene)$(.$field)+,
            set: |scene, on| part_mut::<$part>(scene)$(.$field)+ = on,
        }
    }};
    // Other kinds.
    ($part:ident $(.$field:ident)+: $type:ty, is($kind:expr)) => {
        $kind
    };
}

pub(in crate::model) use {kind, parts, row, rows};

/// Assigns the rows of a part to a group of the editor, with the conditions under which they are listed and have an effect.
pub(in crate::model) fn placed<S>(
    group: Group,
    listed: fn(&S) -> bool,
    used: fn(&S) -> bool,
    mut rows: Vec<Row<S>>,
) -> Vec<Row<S>> {
    for row in &mut rows {
        (row.group, row.part) = (group, [listed, used]);
    }
    rows
}

impl<S> Row<S> {
    /// Creates a row without further attributes; its part of the scene is set later.
    pub(in crate::model) fn new(words: [&'static str; 4], kind: RowKind<S>) -> Self {
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

impl<S> RowNumber<S> {
    /// Creates a required number; its access is set later.
    pub(in crate::model) fn new(quantity: Dimension, allowed: Allowed) -> Self {
        Self { quantity, allowed, absent: None, get: |_| None, set: |_, _| {} }
    }
}
