//! The structs of a scene, whose fields have their default values beside them.

/// Defines structs, and their defaults by the value of each field. What a field means, its unit and what it may be is written in
/// the row of its path in [`VARIABLES`](crate::model::variables::VARIABLES).
macro_rules! defaulted {
    ($(
        $(#[$meta:meta])*
        pub struct $name:ident {
            $($(#[$doc:meta])* pub $field:ident: $type:ty = $value:expr,)+
        }
    )+) => {$(
        $(#[$meta])*
        #[expect(missing_docs, reason = "the table of variables says what each field means")]
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
