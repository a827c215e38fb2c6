//! `cmra`: a workbench for compliant mechanically reactive armour.
//!
//! A projectile strikes a plate carried on a spring and a damper. The library computes what happens; the binary of the
//! same name shows it in a terminal, or prints it.
//!
//! Modules import only what stands to their right:
//! `cli -> tui -> worker -> files -> report -> study -> model -> numerics`. A test reads the source and holds them to it.

pub mod cli;
pub mod files;
// Public for the tests only.
#[doc(hidden)]
pub mod tui;
#[doc(hidden)]
pub mod worker;
