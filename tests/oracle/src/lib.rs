//! An independent reading of the law of an impact, which knows no modes, no events and no Taylor series: the reference for the
//! integration tests in `tests/integration/oracle.rs`. A package of its own, so that it is optimised where the tests are not.

mod contacts;
mod law;
mod plug;
mod springs;

pub use law::{Shot, State};

/// Asserts that a value is exact to a relative tolerance.
///
/// # Panics
/// If it is not.
#[track_caller]
pub fn assert_near(value: f64, exact: f64, tolerance: f64) {
    let is_near = (value - exact).abs() <= tolerance * exact.abs();
    assert!(is_near, "{value} is not {exact} to {tolerance:e}");
}
