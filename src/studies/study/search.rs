//! Searches for designs: goal seek, and constrained optimisation with Pareto fronts.
//!
//! All of them take the measures of designs from one [`crate::study::sweep::Plan`], many at once, by the same evaluation as sweeps.
//! Must not know files, screens or a clock.

pub mod front;
pub mod sampling;
pub mod seek;
