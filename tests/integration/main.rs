//! The one integration test binary.

mod charts;
mod physics;
