//! Looking for designs: goal seek, and constrained optimisation with Pareto fronts.
//!
//! All of them ask one [`design_space::DesignSpace`] for the measures of designs, many at once, by the same evaluation as sweeps.
//! Must not know files, screens or a clock.

pub mod design_space;
pub mod front;
pub mod nsga;
pub mod recommended;
pub mod seek;
