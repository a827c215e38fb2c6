//! Physics: a projectile, a plate on a spring and a damper, and the contact force between them.
//!
//! Equations and signs are those of C. S. Andersen's thesis (BYU 2007), chapter 8 and Appendix A, with corrections; further assumptions are
//! named where they are made. Units are SI; the name of every physical field ends in its unit.
//! **Invariants:** This module depends on neither files nor screens nor clocks nor threads. `simulate` is a pure function. A physically
//! impossible scene is an `Err`; later problems are reported in the result.
//!
//! # How one run goes from a scene to its result
//!
//! 1. A [`scene::Scene`] holds the values; [`variables::VARIABLES`] describes each of them, and [`units`] reads and writes
//!    them. [`simulate::simulate`] begins with [`variables::validate`] and takes
//!    `impact::run` for every model but the listing of the thesis's Appendix, which has a scheme of its own
//!    (`appendix::listing`).
//! 2. `impact::equations` derives the constants of the impact once (masses, [`contact::Geometry`], [`contact_models`],
//!    [`mechanism::Mechanism`]) and has the motion: forces, accelerations and their derivatives. [`strength`] and [`plug`] contain the
//!    laws of the plate's metal; once a plug is picked up, a second set of constants holds.
//! 3. `impact::modes` contains the discrete states between two events (penetrating, sticking, apart, locked, on a stop) and the transition
//!    at each event; `impact::plate_lock` treats the plate as fixed while a singular spring holds it. Functions of mode and state only.
//! 4. `impact::run` is the integration loop. Each pass decides by energy whether the result can still change (`outcome`). It takes one
//!    step (`numerics::collocation`, or another method of `impact::method`), whose result is a polynomial, and finds the first event on it
//!    (`events`, `numerics::event_location`). A shortened step ends at the event, `modes` applies the transition, and `recorder` keeps
//!    rows, work and peak forces.
//! 5. `impact::results` builds the [`run::Run`]: outcome, depth, displacement, events, energy ledger, warnings.
//! 6. The [`closed_form`] of a plate that is rigid or free, or else a second computation by another member of the family of methods,
//!    gives [`estimate::set`] the error of each result.
//! 7. [`stack::follow`] sends a projectile that has perforated into the next plate, if the scene is a stack.
//!
//! Sweeps and searches that need only the first contact use the [`contact_kernel`] if it applies to the scene, else the simulation.
//! [`closed_form`] has solutions without time steps, [`appendix`] the time stepping of the thesis with its own equations,
//! and [`mod@reference`] stored reference results.

pub mod appendix;
pub mod closed_form;
pub mod contact;
pub mod contact_kernel;
pub mod contact_models;
pub mod estimate;
pub mod impact;
mod labelled_enum;
pub mod mechanism;
pub mod plug;
mod power_law;
pub mod reference;
pub mod run;
pub mod scene;
pub mod simulate;
pub mod stack;
pub mod strength;
pub mod units;
pub mod variables;
