//! Searches for designs: goal seek, and constrained optimisation with Pareto fronts.
//!
//! All of them take the measures of designs from one [`design_space::DesignSpace`], many at once, by the same evaluation as sweeps.
//! Must not know files, screens or a clock.

pub mod design_space;
pub mod front;
pub mod nsga;
pub mod recommended;
pub mod seek;
