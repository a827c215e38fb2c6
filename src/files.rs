//! The edge: scenes, presets, sessions and exports on disk.
//!
//! Everything read is checked here, with errors that give file, line, key, value, what is allowed and the cure; everything
//! written is written whole or not at all. TOML is read and written here, CSV is read here and written by `report`: the model
//! knows no format. No screen, no thread and no standard output is known here.

pub mod atomic;
pub mod bundled;
pub mod config;
pub mod error;
pub mod export;
pub mod library;
pub mod paths;
pub mod preset;
pub mod read;
pub mod recent;
pub mod report;
pub mod session;
pub mod validation;
pub mod write;

mod inputs;
mod read_stack;
mod read_sweep;
pub mod read_table;
pub mod read_traces;
mod reader;

pub use cmra_studies::report::clean;
