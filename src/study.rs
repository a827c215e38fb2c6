//! Work made of many runs.
//!
//! Knows the model and its methods; must not know files, screens or the command line, and threads only in `parallel.rs`.
//! Whoever wants a time measured passes the clock in.

pub mod accuracy;
pub mod compare;
pub mod context;
pub mod fit;
pub mod limit;
pub mod models;
pub mod monte_carlo;
pub mod parallel;
pub mod principles;
pub mod quantities;
pub mod screening;
pub mod search;
pub mod sensitivity;
pub mod stability;
pub mod stack;
pub mod sweep;
pub mod thesis;
pub mod validation;
pub mod validity;
