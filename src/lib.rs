//! `cmra`: a workbench for compliant mechanically reactive armour.
//!
//! A projectile strikes a plate on a spring and a damper. The packages `cmra-engine` and `cmra-studies` compute the impact and studies of
//! many impacts. This package has the workbench, the command line and the files.
//!
//! A module imports only modules to its right: `cli -> tui -> worker -> files -> report -> study -> model -> numerics`. A test checks it.

#[cfg(not(unix))]
compile_error!(
    "cmra runs on Unix only (Linux, macOS); on Windows, build it in the Windows Subsystem for Linux"
);

pub mod cli;
pub mod files;
// Public only for the integration tests.
#[doc(hidden)]
pub mod tui;
#[doc(hidden)]
pub mod worker;
