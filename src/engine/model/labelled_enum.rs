//! Enums whose variants have a word each, or a few, in files and on screens.

/// Defines enums, their variants and the words of these in order, and the method that gives a variant's. The words are its
/// documentation where they say enough.
macro_rules! labelled_enum {
    ($(
        $(#[$meta:meta])*
        pub enum $name:ident: $method:ident {
            $($(#[$doc:meta])* $variant:ident = $word:literal,)+
        }
    )+) => {$(
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum $name {
            $($(#[$doc])* #[doc = concat!("`", $word, "`")] $variant,)+
        }

        impl $name {
            /// Every one, in order.
            pub const ALL: [Self; [$($word),+].len()] = [$(Self::$variant),+];
            /// Their words.
            pub const WORDS: [&'static str; Self::ALL.len()] = [$($word),+];

            /// The word, or the words, in files and on screens.
            pub const fn $method(self) -> &'static str {
                Self::WORDS[self as usize]
            }
        }
    )+};
}

pub(in crate::model) use labelled_enum;
