//! Work made of many runs.
//!
//! Knows the model and its methods; must not know files, threads, screens or the command line. Whoever wants a time measured
//! passes the clock in.

pub mod accuracy;
pub mod stability;
