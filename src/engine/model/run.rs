//! Results of a run: time series, events, outcome, energy balance, cost and warnings; plain data in SI units. A quantity that does not
//! exist for a scene is `None`, never zero. A run that ends early has partial results, and a reason [`Run::end`].

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::model::labelled_enum::labelled_enum;
use crate::model::plug;
use crate::model::scene::{Criterion, GRAVITY_M_S2, Projectile, Scene};
use crate::numerics::larger;

pub(in crate::model) mod check;
mod error_estimate;
mod outcome;
mod result;
mod settings;
mod stack_run;
mod warning;

pub use check::{Check, Direction, Warning};
pub use error_estimate::{ErrorEstimate, EstimateBasis, LeftOut};
pub use outcome::{AtLeast, EndReason, Outcome};
pub use result::RunResult;
pub use settings::{EVERY_ROWS_MAX, Settings, WORK_MAX};
pub use stack_run::StackRun;
pub(in crate::model) use stack_run::plate_name;
pub use warning::{NotModelled, RunWarning};

/// Work of a step, a reversal or a contact event besides its evaluations of the equations of motion, as a number of evaluations.
const STEP_WORK: usize = 60;

/// Tolerance of the displacement of a reversal for that of the maximum, which can follow from the energy.
const REACHED: f64 = 1e-6;

/// End of the time range of a chart of the contact, relative to the end of the contact; beyond it, so that the end is visible.
pub const CONTACT_WINDOW: f64 = 1.1;

/// State of a run in progress.
pub struct RunSnapshot<'a> {
    /// Simulated time, s.
    pub t_s: f64,
    /// Returns the run so far, without its error estimate; `None` for the listing of Appendix A, and for further plates of a stack.
    pub so_far: &'a dyn Fn() -> Option<Run>,
}

/// Callback before every step; `Break` cancels the run.
pub type Observer<'a> = &'a mut dyn FnMut(&RunSnapshot<'_>) -> ControlFlow<()>;

/// Results of one impact.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Run {
    /// Scene of the run.
    pub scene: Arc<Scene>,
    /// Outcome of the shot.
    pub outcome: Outcome,
    /// Reason for the end of the computation.
    pub end: EndReason,
    /// First zero of the relative velocity; the end of penetration in the thesis.
    pub first_arrest: Option<Arrest>,
    /// Depth of the hole.
    pub penetration: Penetration,
    /// Maximum contact force while penetrating, N; `None` for an instantaneous collision.
    pub peak_contact_force_n: Option<f64>,
    /// Maximum displacement of the plate, m; `None` if nothing stops the plate, or if the run ended before.
    pub max_plate_displacement_m: Option<f64>,
    /// Lower bounds of depth and displacement that are not final.
    pub at_least: AtLeast,
    /// Departure of the projectile through the rear or the entry face.
    pub departure: Departure,
    /// Loads of the fused interface.
    pub interface: InterfaceLoad,
    /// Relative error estimates of the results.
    pub estimate: ErrorEstimate,
    /// Time series; two rows at the same time at a discontinuity. Empty unless requested.
    pub series: Vec<Sample>,
    /// Events in order of time.
    pub events: Vec<Event>,
    /// Energy balance.
    pub ledger: EnergyLedger,
    /// Loads of the mechanism.
    pub mechanism: MechanismLoad,
    /// Run of the further plates of a stack.
    pub stack: Option<Arc<StackRun>>,
    /// Results of the same shot with a plastic interface; `Some` for a fused run if both were requested.
    pub plastic: Option<Arc<Self>>,
    /// Cost of the computation.
    pub cost: Cost,
    /// Terms without effect in this scene, which were not computed.
    pub omitted: Vec<&'static str>,
    /// Warnings.
    pub warnings: Vec<RunWarning>,
}

/// Depth of the hole that a run leaves.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Penetration {
    /// Final depth, m; for a perforation the depth at which the nose left the rear face.
    pub final_m: Option<f64>,
    /// Depth of the same shot with a rigid mount, m; `None` for a perforation, or a contact model without depth.
    pub baseline_m: Option<f64>,
    /// Upper bound of a depth that is not final, by energy, m; `None` if the depth is final, or if the bound perforates.
    pub at_most_m: Option<f64>,
}

/// State at the first arrest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrest {
    /// Time since first contact, s.
    pub t_s: f64,
    /// Depth, m.
    pub penetration_m: f64,
    /// Plate displacement, m.
    pub plate_displacement_m: f64,
    /// Plate velocity, m/s.
    pub plate_velocity_m_s: f64,
}

/// Departure of the projectile from the plate; all `None` while it stays.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Departure {
    /// Time at which the nose left the rear face, s.
    pub exit_time_s: Option<f64>,
    /// Projectile velocity after perforation, m/s.
    pub residual_velocity_m_s: Option<f64>,
    /// Time and velocities at which the projectile left through the entry face.
    pub separation: Option<Parting>,
    /// Velocity of the plate when the projectile leaves it through either face, m/s.
    pub plate_velocity_m_s: Option<f64>,
}

/// Time and velocities when projectile and plate part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parting {
    /// Time since first contact, s.
    pub t_s: f64,
    /// Velocity of the projectile, m/s.
    pub velocity_m_s: f64,
    /// Velocity of the plate, m/s.
    pub plate_velocity_m_s: f64,
}

/// Loads of the fused interface.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct InterfaceLoad {
    /// Maximum compression, relative to the strength A `S_y`.
    pub demand_ratio: Option<f64>,
    /// Maximum tension, relative to the strength `g A S_y`; infinite for g = 0, `None` for an interface that can separate.
    pub tension_ratio: Option<f64>,
}

labelled_enum! {
    /// Contact mode.
    #[derive(Default)]
    pub enum ContactMode: word {
        #[default]
        Penetrating = "penetrating",
        Fused = "fused",
        Withdrawing = "withdrawing",
        /// Out of contact, or in the hole without force.
        FreeFlight = "free-flight",
        /// Moving in the hole towards its bottom.
        Closing = "closing",
        Perforated = "perforated",
    }
}

/// Row of the time series.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Sample {
    /// Time since first contact, s.
    pub t_s: f64,
    /// Contact mode.
    pub mode: ContactMode,
    /// Depth of the nose in the plate now, m (negative once it has left through the entry face).
    pub penetration_m: f64,
    /// Projectile displacement along its axis since first contact, m.
    pub projectile_displacement_m: f64,
    /// Projectile velocity along its axis, m/s.
    pub projectile_velocity_m_s: f64,
    /// Plate displacement from neutral, m.
    pub plate_displacement_m: f64,
    /// Plate velocity, m/s.
    pub plate_velocity_m_s: f64,
    /// Force between projectile and plate along the projectile's axis; positive pushes them apart, N.
    pub contact_force_n: f64,
    /// Spring force on the mount, N.
    pub spring_force_n: f64,
    /// Damper force on the mount, N.
    pub damper_force_n: f64,
    /// Force of the stop on the plate (elastic, or while the plate rests on a rigid one), N.
    pub stop_force_n: f64,
}

impl Sample {
    /// Force of spring, damper and stop together on the mount, N.
    pub fn mount_force_n(&self) -> f64 {
        self.spring_force_n + self.damper_force_n + self.stop_force_n
    }
}

/// Event of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// Time, s.
    pub t_s: f64,
    /// Kind of the event.
    pub kind: EventKind,
}

labelled_enum! {
    /// Kinds of events that charts mark.
    pub enum EventKind: words {
        FirstArrest = "projectile first stops",
        Arrest = "arrest",
        /// The nose is buried to its full radius.
        NoseBuried = "nose buried",
        RearFace = "rear face reached",
        /// A blunt nose picks up the plug that it shears out.
        Plug = "plug picked up",
        Perforation = "perforation",
        Resumption = "penetration resumes",
        PullOut = "pull-out begins",
        Separation = "separation",
        Recontact = "contact again",
        GreatestDisplacement = "greatest displacement",
        StopHit = "stop hit",
        StopHold = "held by the stop",
        StopRelease = "leaves the stop",
        /// The load of the fused interface first exceeds its strength.
        InterfaceExceeded = "interface limit exceeded",
    }
}

/// Energy balance, J: initial kinetic energy and preload of the spring, and the terms they were converted into.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct EnergyLedger {
    /// Kinetic energy of the projectile at the start.
    pub initial_kinetic_j: f64,
    /// Kinetic energy of the plate and of parts that move with it, at the start.
    pub initial_plate_j: f64,
    /// Energy preloaded in the cocked spring.
    pub initial_spring_j: f64,
    /// Kinetic energy of the projectile at the end.
    pub projectile_j: f64,
    /// Kinetic energy of the plate at the end.
    pub plate_j: f64,
    /// Kinetic energy of rotation and of the mass of the springs at the end.
    pub inertia_j: f64,
    /// Energy stored in the spring at the end.
    pub spring_j: f64,
    /// Energy dissipated by crushing of absorbers.
    pub crush_j: f64,
    /// Energy dissipated by the damper.
    pub damper_j: f64,
    /// Work done in the hole: penetration, and friction on the way out or in.
    pub penetration_j: f64,
    /// Energy lost when a plug is picked up.
    pub pick_up_j: f64,
    /// Work of shearing the plug out.
    pub shear_j: f64,
    /// Energy stored in or dissipated by the stop.
    pub stop_j: f64,
    /// Work of the weight of the projectile, if it is included.
    pub weight_j: f64,
}

impl EnergyLedger {
    /// Returns the total energy at the start, J.
    pub fn initial_j(&self) -> f64 {
        self.initial_kinetic_j + self.initial_plate_j + self.initial_spring_j
    }

    /// Returns the total energy at the start plus the work of the weight, J.
    pub fn given_j(&self) -> f64 {
        self.initial_j() + self.weight_j
    }

    /// Returns the sum of all terms at the end, J.
    pub fn final_j(&self) -> f64 {
        self.projectile_j
            + self.plate_j
            + self.inertia_j
            + self.spring_j
            + self.crush_j
            + self.damper_j
            + self.penetration_j
            + self.pick_up_j
            + self.shear_j
            + self.stop_j
    }

    /// Returns the energy residual, relative to the energy at the start.
    pub fn residual(&self) -> f64 {
        (self.final_j() - self.given_j()) / self.initial_j()
    }
}

/// Loads of the mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct MechanismLoad {
    /// Maximum energy stored in the springs, J; `None` without a spring, or if unknown.
    pub stored_j: Option<f64>,
    /// Yield strength over the maximum bending stress of the beams; `None` without beams.
    pub yield_margin: Option<f64>,
    /// Mass that the mechanism adds to the plate, kg; `None` without one.
    pub added_kg: Option<f64>,
    /// Mass of the springs, kg; `None` if unknown.
    pub spring_mass_kg: Option<f64>,
    /// Displacement, m, and time, s, of the plate's reversal farthest ahead; a hit on the stop is one. `None` if it was not followed so far.
    pub turn: Option<[f64; 2]>,
    /// Minimum displacement of the plate over the whole motion, rebound included, m; `None` on a rigid mount, or if unknown.
    pub backmost_m: Option<f64>,
    /// Maximum of the total force of spring, damper and elastic stop over the whole motion, rebound included, N; `None` on a rigid mount.
    pub peak_mount_n: Option<f64>,
    /// Maximum energy of rotation at the steps of the solver, J; `None` without rotation.
    pub rotation_j: Option<f64>,
}

/// Cost of a computation.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Cost {
    /// Number of accepted steps.
    pub steps: usize,
    /// Number of rejected steps.
    pub rejected: usize,
    /// Number of reversals of the plate, two for each oscillation.
    pub turns: usize,
    /// Number of events of contact, interface and stop.
    pub events: usize,
    /// Number of evaluations of the equations of motion.
    pub rhs_evaluations: usize,
    /// Elapsed time with the error estimate, as measured by the caller, s.
    pub took_s: Option<f64>,
    /// Name of the method.
    pub method: &'static str,
    /// Reason for the method.
    pub reason: &'static str,
}

impl Cost {
    /// Work of a run, in evaluations of the equations of motion.
    pub fn work(&self) -> usize {
        self.rhs_evaluations + STEP_WORK * (self.steps + self.turns + self.events)
    }
}

impl Run {
    /// Returns the final depth over that on a rigid mount, percent, exactly 100 if equal; `None` without both, or for a perforation.
    pub fn percent_of_baseline(&self) -> Option<f64> {
        let percent = 100.0 * (self.penetration.final_m? / self.penetration.baseline_m?);
        (self.outcome != Outcome::Perforated).then_some(percent)
    }

    /// Returns the outcome of the shot by the criterion of the scene; for a stack that in the last plate struck.
    pub fn shot_outcome(&self) -> Outcome {
        if let Some(stack) = &self.stack {
            return stack.outcome;
        }
        let by_protrusion = self.scene.target.criterion == Criterion::Protrusion;
        if !by_protrusion || self.protrusion_m().is_none() {
            return self.outcome;
        }
        if plug::is_law_low(&self.scene) { Outcome::Unmeasured } else { Outcome::Perforated }
    }

    /// Returns `true` if the run is complete and the outcome of the shot is decided.
    pub fn is_decided(&self) -> bool {
        self.end.is_complete() && self.shot_outcome() != Outcome::Moving
    }

    /// Returns the runs of the plates that were struck, in order.
    pub fn plates(&self) -> impl Iterator<Item = &Self> {
        let behind = self.stack.iter().flat_map(|stack| stack.behind.iter());
        std::iter::once(self).chain(behind.map(|run| &**run))
    }

    /// Returns the depth of the shot, m; for a stack the thickness of the perforated plates plus the depth in the last one.
    pub fn shot_depth_m(&self) -> Option<f64> {
        self.stack.as_ref().map_or(self.penetration.final_m, |stack| stack.penetration_m)
    }

    /// Returns the relative error estimate of a result; for a stack the maximum over its plates.
    pub fn error_of(&self, name: &str) -> Option<f64> {
        let errors = self.plates().flat_map(|run| &run.estimate.by_result);
        errors.filter(|error| error.0 == name).map(|error| error.1).reduce(larger)
    }

    /// Returns the relative error estimate of the final depth, of a stack the greatest of its plates; infinite if one is unknown.
    pub fn depth_error(&self) -> Option<f64> {
        self.plates().filter_map(|run| run.estimate.main).reduce(larger)
    }

    /// Returns the residual velocity behind the plate, or behind the last plate of a stack, m/s.
    pub fn shot_residual_m_s(&self) -> Option<f64> {
        self.stack
            .as_ref()
            .map_or(self.departure.residual_velocity_m_s, |stack| stack.residual_velocity_m_s)
    }

    /// Returns how far the nose of an arrested projectile protrudes from the rear face, m: by the army criterion a complete penetration.
    pub fn protrusion_m(&self) -> Option<f64> {
        let depth = self.penetration.final_m.or(self.at_least.penetration_m)?;
        let out = depth - self.scene.effective_thickness_m();
        (self.outcome != Outcome::Perforated && out > 0.0).then_some(out)
    }

    /// Returns the warning of a penetration that resumed, from the depths of the first stop and of the last; a perforation is deeper.
    pub(in crate::model) fn resumed(&self, t_s: f64) -> RunWarning {
        let depth_m = self.penetration.final_m.or(self.at_least.penetration_m);
        let both_m = depth_m.zip(self.first_arrest.map(|arrest| arrest.penetration_m));
        let least = 1.0 + self.scene.run.tolerance;
        let is_deeper = both_m.is_none_or(|(depth_m, first_m)| depth_m > least * first_m);
        RunWarning::PenetrationResumed { t_s, is_deeper }
    }

    /// Returns the stroke, m: maximum displacement plus cocking distance.
    pub fn stroke_m(&self) -> Option<f64> {
        Some(self.max_plate_displacement_m? + self.scene.start_m().abs())
    }

    /// Returns the minimum and maximum displacement of a sprung plate, m; `None` without a maximum.
    pub fn displacements_m(&self) -> Option<[f64; 2]> {
        let far_m = self.max_plate_displacement_m.filter(|_| self.scene.is_sprung())?;
        Some([self.mechanism.backmost_m.unwrap_or_else(|| self.scene.start_m()), far_m])
    }

    /// Returns the time of maximum displacement, s; `None` if the plate only approaches it, or if its motion was not followed so far.
    pub fn max_displacement_time_s(&self) -> Option<f64> {
        let far_m = self.max_plate_displacement_m.filter(|_| self.scene.is_sprung())?;
        let is_there = |x_m: f64| far_m - x_m <= REACHED * far_m.abs();
        let turned = self.mechanism.turn.filter(|[x_m, _]| is_there(*x_m)).map(|[_, t_s]| t_s);
        // A plate that is thrown back, or stands still, is farthest at the start.
        turned.or_else(|| is_there(self.scene.start_m()).then_some(0.0))
    }

    /// Returns the work of the projectile's weight over the stroke, relative to the kinetic energy of the impact; `None` without a stroke.
    pub fn weight_fraction(&self) -> Option<f64> {
        let scene = &self.scene;
        let Projectile { mass_kg, velocity_m_s, .. } = scene.projectile;
        let way_m = self.stroke_m().filter(|_| scene.is_sprung())?;
        Some(mass_kg * GRAVITY_M_S2 * way_m / (0.5 * mass_kg * velocity_m_s * velocity_m_s))
    }

    /// Returns the end of the contact, s: first arrest, perforation, or end of the run.
    pub fn contact_end_s(&self) -> f64 {
        let arrest = self.first_arrest.map(|arrest| arrest.t_s);
        arrest
            .or(self.departure.exit_time_s)
            .unwrap_or_else(|| self.series.last().map_or(0.0, |row| row.t_s))
    }
}
