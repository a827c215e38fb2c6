//! Simulation of an impact: physics ([`model`]) and numerical methods ([`numerics`]).
//!
//! The engine is a separate package, which is optimised in every build profile and compiled only when it changes.
//!
//! # Example
//!
//! Changes to the scene of Table 9.1 are written as on the command line. [`simulate`](model::simulate::simulate) refuses an impossible scene;
//! the closure is called at every step and may cancel the run.
//!
//! ```
//! use cmra_engine::model::scene::Scene;
//! use cmra_engine::model::simulate::{Settings, simulate};
//! use cmra_engine::model::variables::changed;
//! use std::ops::ControlFlow;
//!
//! let scene = changed(Scene::default(), "k=100kN/m gamma=1 v_i=100")?;
//! let run = simulate(&scene.into(), &Settings::default(), &mut |_| ControlFlow::Continue(()))?;
//!
//! let arrest = run.first_arrest.expect("the projectile stops in the plate");
//! let depth_mm = 1e3 * arrest.penetration_m;
//! assert!((depth_mm - 4.571_788_754_106).abs() < 1e-9); // reference of 19 digits
//! assert!(run.estimate.main.expect("a complete run has an estimate") < 1e-9);
//! # Ok::<(), cmra_engine::model::variables::VariableError>(())
//! ```

#![forbid(unsafe_code)]

pub mod model;
pub mod numerics;
