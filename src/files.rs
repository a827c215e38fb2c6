//! Scenes, presets, sessions and exports on disk.
//!
//! All input is validated here; an error has file, line, key, value, allowed values and remedy. Files are written atomically. TOML is read
//! and written here, CSV is read here and written by `report`; the model does not depend on file formats. This module depends on neither
//! screens nor threads nor standard output.

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

pub mod inputs;
mod read_stack;
mod read_sweep;
pub mod read_table;
pub mod read_traces;
mod reader;

pub use cmra_studies::report::clean;
