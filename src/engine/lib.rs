//! Simulation of an impact: physics ([`model`]) and numerical methods ([`numerics`]).
//!
//! The engine is a separate package, which is optimised in every build profile and compiled only when it changes.

#![forbid(unsafe_code)]

pub mod model;
pub mod numerics;
