//! Structs whose fields have their default values beside them.

/// Defines structs, and their defaults by the value of each field.
macro_rules! defaulted {
    ($(
        $(#[$meta:meta])*
        pub struct $name:ident {
            $($(#[$doc:meta])* pub $field:ident: $type:ty = $value:expr,)+
        }
    )+) => {$(
        $(#[$meta])*
        pub struct $name {
            $($(#[$doc])* pub $field: $type,)+
        }

        impl Default for $name {
            fn default() -> Self {
                Self { $($field: $value,)+ }
            }
        }
    )+};
}

pub(in crate::model) use defaulted;
