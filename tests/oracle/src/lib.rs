//! An independent reading of the law of an impact, which knows no modes, no events and no Taylor series: the reference for the
//! integration tests in `tests/integration/oracle.rs`. A package of its own, so that it is optimised where the tests are not.

mod contacts;
mod law;
mod plug;
mod springs;

pub use law::{Shot, State};
