//! The one integration test binary.

mod physics;
