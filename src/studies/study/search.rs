//! Searches for designs: goal seek, and constrained optimisation with Pareto fronts.
//!
//! All searches evaluate designs through [`crate::study::sweep::Plan`], many at once, as sweeps do. This module depends on neither files
//! nor screens nor a clock.

pub mod front;
pub mod sampling;
pub mod seek;
