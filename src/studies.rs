//! What is asked of the simulation, and how the answers are told: studies (`study`) and their tables, charts and pages (`report`).
//!
//! A crate of its own, so that it is compiled beside the terminal's parts and again only when it changes. `cmra` re-exports both
//! modules.

#![forbid(unsafe_code)]

pub use cmra_engine::{model, numerics};

pub mod report;
pub mod study;
