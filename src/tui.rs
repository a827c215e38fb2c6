//! The workbench: options, and the loop that everything passes through.
//!
//! One inbox takes what the terminal, the worker, the clerk and signals have to say. The loop takes a message, lets `update`
//! change the state, does the effects, takes all else that waits, and draws once. Idle, it draws nothing and wakes four times a
//! second to see whether the terminal is still there. What is drawn and what keys mean is not known here.

pub mod chart;
pub mod message;
pub mod theme;
