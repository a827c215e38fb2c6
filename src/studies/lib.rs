//! Studies of the simulation (`study`), and their tables, charts and pages (`report`).
//!
//! A crate of its own, so that it is compiled beside the terminal's parts and again only when it changes.

#![forbid(unsafe_code)]

/// Defines an enum whose variants are the rows of a table: a method for each column gives a variant's entry.
#[macro_export]
macro_rules! enumeration {
    ($(#[$about:meta])* $vis:vis enum $name:ident in $row:ident {
        $($(#[$column_doc:meta])* $column:ident: $type:ty,)+
    }
    $($(#[$doc:meta])* $variant:ident { $($key:ident: $value:expr),+ })+) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        $vis enum $name {
            $($(#[$doc])* $variant,)+
        }

        struct $row {
            $($column: $type,)+
        }

        impl $name {
            /// All of them, in the order of tables.
            $vis const ALL: [Self; [$(Self::$variant),+].len()] = [$(Self::$variant),+];

            const fn row(self) -> &'static $row {
                match self {
                    $(Self::$variant => &const { $row { $($key: $value),+ } },)+
                }
            }

            $($(#[$column_doc])*
            $vis const fn $column(self) -> $type {
                self.row().$column
            })+
        }
    };
}

pub mod report;
pub mod study;
