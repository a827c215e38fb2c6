//! The workbench.

pub mod message;
