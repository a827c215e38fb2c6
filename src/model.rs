//! The physics: a projectile, a plate on a spring and damper, and the force between them.
//!
//! Equations and signs are those of C. S. Andersen's thesis (BYU 2007), chapter 8 and Appendix A, with its errors corrected;
//! the assumptions beyond it are named where they are made. SI units throughout; every physical field's name ends in
//! its unit. **Invariants:** no file, no screen, no clock and no thread is known here; `simulate` is a pure
//! function of its arguments; nothing but `Err` for a scene that cannot start is refused.

pub mod appendix;
pub mod closed_form;
pub mod contact;
pub mod contact_phase;
pub mod design;
pub mod estimate;
pub mod first_contact;
pub mod impact;
pub mod interaction;
pub mod library;
pub mod mechanism;
pub mod motion;
pub mod plan;
pub mod results;
pub mod run;
pub mod scene;
pub mod simulate;
pub mod stack;
pub mod units;
pub mod variables;
