//! The workbench.

pub mod chart;
pub mod message;
pub mod theme;
