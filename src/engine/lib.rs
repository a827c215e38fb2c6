//! The simulation by itself: the physics (`model`) and the methods that know no physics (`numerics`).
//!
//! A crate of its own, so that it is optimised in every profile while the rest of the program is not, and compiled again only when
//! it changes. `cmra` re-exports both modules.

#![forbid(unsafe_code)]

pub mod model;
pub mod numerics;
