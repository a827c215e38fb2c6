//! The physics: a projectile, a plate on a spring and damper, and the force between them.
//!
//! Equations and signs are those of C. S. Andersen's thesis (BYU 2007), chapter 8 and Appendix A, with its errors corrected; the
//! assumptions beyond it are named where they are made. SI units throughout; every physical field's name ends in its unit.
//! **Invariants:** no file, no screen, no clock and no thread is known here; `simulate` is a pure function of its arguments; a scene
//! that makes no physical sense is refused with an `Err`, and whatever goes wrong later is reported in the result.
//!
//! # How one run goes from a scene to its result
//!
//! 1. A [`scene::Scene`] holds the values; [`variables::VARIABLES`] describes each of them, [`units`] reads and writes them, and
//!    [`library`] fills in threats, materials and absorbers. [`simulate::simulate`] begins with [`variables::validate`] and takes
//!    [`impact::run`] for every model but the listing of the thesis's Appendix, which has a scheme of its own
//!    (`appendix::listing`).
//! 2. `impact::problem::Problem::of` derives the constants of the impact once: masses, [`contact::Geometry::of`] (engaged area by
//!    travel, in pieces), [`contact_models`] (the force of each mode, what ends it, what follows), [`mechanism::Mechanism::of`]
//!    (spring, damper, stop), whether these can move the plate at all (`fixed_plate`), the horizon.
//! 3. `Simulation` is a run in progress: the `Body` (state, mode, equations; `impact/body.rs`), the `StepControl`, the `Record` and
//!    the `Termination`. `Simulation::begin` (`impact/contact.rs`) takes the contact in closed form ([`closed_form::Passage`]) where
//!    only inertia resists the projectile; else `Simulation::start` steps over a singular start.
//! 4. `Simulation::run` (`impact/simulation.rs`) is the loop. Each pass:
//!    - `finished` (`impact/termination.rs`) decides by `Body::outcome` and energy bounds whether the result can still change;
//!      `budget_used_up` whether the run has done its work;
//!    - `Body::missed_event` finds an event that rounding has put behind the state;
//!    - one step is taken: `cross_singularity` (`impact/singular_crossing.rs`) through the zero of a power law, `taylor_step`
//!      (`impact/taylor.rs`) where the motion is smooth, or `stiff_step` (`impact/stiff.rs`). All step the equations of
//!      `motion::Motion`, which are one form for every mode and contact model;
//!    - `Body::active_events` lists what may end the step in the present mode, each as an event function (`event_function.rs`),
//!      which falls through zero there; the first of them to change its sign is located (on implicit and crossing steps by
//!      `numerics/event.rs`), and `project_onto_event` puts the state exactly on it;
//!    - `Record` (`impact/record.rs`) keeps the rows, the work done and the greatest forces (`note_extremes`);
//!    - `apply_transition` lets `handle` (`impact/events.rs`) decide by the contact model which mode follows.
//! 5. `report::gather` makes the [`run::Run`]: outcome, depth, displacement, events, energy ledger, warnings. [`run::envelope`]
//!    has the range of validity of the model, and warns outside.
//! 6. A second, tighter computation gives [`estimate::set`] the error of each result: by `hybrid`, an engine of its own with one
//!    integrator for all (Radau collocation), where that knows the scene and comes to an end, else by this one with another order.
//! 7. [`stack::follow`] sends a projectile that has perforated into the next plate, if the scene is a stack.
//!
//! Sweeps and searches that need the first contact only take the [`contact_kernel`] where it serves the scene, else the
//! simulation. [`appendix`] is the scheme of the thesis with equations of its own, and uses [`contact::Geometry`] to name its events;
//! [`mod@reference`] has stored digits. [`design`] has the formulas that need no simulation.

pub mod appendix;
pub mod closed_form;
pub mod contact;
pub mod contact_kernel;
pub mod contact_models;
pub mod design;
pub mod estimate;
mod fixed_plate;
pub mod impact;
pub mod library;
pub mod mechanism;
pub mod reference;
pub mod run;
pub mod scene;
pub mod simulate;
pub mod stack;
pub mod units;
pub mod variables;
mod worded;
