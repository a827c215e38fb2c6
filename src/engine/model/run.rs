//! The results of a run: series, events, outcome, energy ledger, cost and warnings. Plain data in SI units.
//!
//! A quantity that does not exist for a scene is `None`, never zero. A run that had to end early keeps all it has and says
//! why in [`Run::end`]. Nothing here reads a clock: the caller measures the time.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::model::labelled_enum::labelled_enum;
use crate::model::scene::{Criterion, GRAVITY_M_S2, Projectile, RunSettings, Scene};
use crate::numerics::larger;

mod check;
pub mod envelope;
mod result;
mod warning;

pub use crate::model::stack::StackRun;
pub use result::RunResult;
pub use warning::{NotModelled, RunWarning, Warning};

/// The output that a run delivers besides its results.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Keep the series to draw from.
    pub series: bool,
    /// Distance in time of its rows, s, greater than 0, instead of the solver's own steps; no rows follow the first [`EVERY_ROWS_MAX`].
    pub every_s: Option<f64>,
    /// Compute the error estimate (from a closed form or a second computation).
    pub estimate: bool,
    /// Work after which a run ends undecided, as [`Cost::work`] counts it; `None` for [`WORK_MAX`], and more at a tight tolerance.
    pub work_max: Option<usize>,
}

impl Settings {
    /// The results alone.
    pub const BARE: Self = Self { series: false, every_s: None, estimate: false, work_max: None };
    /// The series too.
    pub const SERIES: Self = Self { series: true, ..Self::BARE };

    /// Work after which a run to a tolerance ends undecided.
    pub(in crate::model) fn most_work(&self, tolerance: f64) -> usize {
        let more = DIGIT_WORK.powf((RunSettings::default().tolerance / tolerance).log10());
        self.work_max.unwrap_or_else(|| (WORK_MAX as f64 * larger(more, 1.0)) as usize)
    }
}

/// Work after which a run ends undecided at the default tolerance, as [`Cost::work`] counts it: about 0.1 s, at 0.05 us each.
pub const WORK_MAX: usize = 2_200_000;
/// Factor on this for each digit by which a tolerance is tighter: shorter steps, and more of what happens is resolved.
const DIGIT_WORK: f64 = 1.5;
/// Work of a step, a turn or a change of the contact beside its evaluations: states on the step, events, forces and work on it take about
/// as long as so many evaluations.
const STEP_WORK: usize = 60;

/// Most rows at equal times: a series of that many takes about half a gigabyte.
pub const EVERY_ROWS_MAX: usize = 5_000_000;

impl Default for Settings {
    fn default() -> Self {
        Self { estimate: true, ..Self::SERIES }
    }
}

/// Part of the greatest displacement at which it is reached.
const REACHED: f64 = 1e-6;

/// The end of the time in which a contact is drawn, relative to its own end: a little beyond it, so that it is seen.
pub const CONTACT_WINDOW: f64 = 1.1;

/// A look at a run that goes on.
pub struct RunSnapshot<'a> {
    /// The time reached, s.
    pub t_s: f64,
    /// The run so far: as if it had been cancelled there, or whole but for its error estimate. `None` of the listing of Appendix A, and of
    /// the plates of a stack behind the first.
    pub so_far: &'a dyn Fn() -> Option<Run>,
}

/// Called before every step; `Break` ends the run as cancelled.
pub type Observer<'a> = &'a mut dyn FnMut(&RunSnapshot<'_>) -> ControlFlow<()>;

/// Results of one impact.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Run {
    /// The scene as it was run.
    pub scene: Arc<Scene>,
    /// The outcome of the shot.
    pub outcome: Outcome,
    /// Why the computation ended.
    pub end: EndReason,
    /// The first moment of common velocity, the thesis's end of penetration.
    pub first_arrest: Option<Arrest>,
    /// Depth of the hole at the end; of a perforation, the depth at which the nose was clear of the rear face, m.
    pub final_penetration_m: Option<f64>,
    /// Penetration of the same shot into the same plate on a rigid mount, m; `None` if that perforates, or if the contact model knows no
    /// depth.
    pub baseline_penetration_m: Option<f64>,
    /// Greatest contact force while penetrating, N; `None` for a collision that takes no time.
    pub peak_contact_force_n: Option<f64>,
    /// Greatest plate displacement x; `None` where nothing ever stops the plate or the run ended before it was known, m.
    pub max_plate_displacement_m: Option<f64>,
    /// Bounds of depth and displacement where they are not final.
    pub at_least: AtLeast,
    /// The greatest depth for which an undecided run has energy left, or to which further slips can deepen the hole of an arrested projectile,
    /// m; `None` where the depth is final, or would perforate.
    pub penetration_at_most_m: Option<f64>,
    /// Projectile velocity after perforation, m/s.
    pub residual_velocity_m_s: Option<f64>,
    /// When the nose was clear of the rear face, s.
    pub exit_time_s: Option<f64>,
    /// When the projectile left through the entry face, and the velocities then.
    pub separation: Option<Departure>,
    /// Plate velocity when projectile and plate part for good, at either face, m/s; `None` where they do not.
    pub plate_velocity_after_m_s: Option<f64>,
    /// Greatest N/(A `S_y`) the interface carried, or would have had to carry, while fused.
    pub interface_demand_ratio: Option<f64>,
    /// Greatest tension that the fused interface carried up to the end of the run, over its strength `g A S_y`; infinite where
    /// there is no grip g, `None` where the interface can let go.
    pub interface_tension_ratio: Option<f64>,
    /// Error estimate of the final penetration (of the exit time, for a perforation), relative to it; infinite where it is not known.
    pub error_estimate: Option<f64>,
    /// How the estimates were obtained, where any were.
    pub estimate_basis: Option<EstimateBasis>,
    /// Error estimates of the results by their names, each relative to it, as far as they exist.
    pub error_estimates: Vec<(&'static str, f64)>,
    /// The series to draw, in order of time; two samples at the same time where something jumps. Empty unless requested.
    pub series: Vec<Sample>,
    /// Located events, in order of time.
    pub events: Vec<Event>,
    /// Where the energy went.
    pub ledger: EnergyLedger,
    /// The load of the mechanism.
    pub mechanism: MechanismLoad,
    /// The outcome of the shot behind this plate, where the scene is a stack.
    pub stack: Option<Arc<StackRun>>,
    /// Results of the same shot with a plastic interface; `Some` for a fused run if both were requested.
    pub plastic: Option<Arc<Self>>,
    /// The cost of the computation.
    pub cost: Cost,
    /// The terms that this scene did not need.
    pub omitted: Vec<&'static str>,
    /// Warnings.
    pub warnings: Vec<RunWarning>,
}

labelled_enum! {
    /// The outcome of the shot.
    #[derive(Default)]
    pub enum Outcome: word {
        Arrested = "arrested",
        Perforated = "perforated",
        /// The projectile left through the entry face and will not come back.
        Separated = "separated",
        #[default]
        Moving = "moving",
        /// By a law that is too low for the shot the plate is perforated: whether it is, is not measured.
        Unmeasured = "not-measured",
    }

    /// Why the computation ended.
    #[derive(Default)]
    pub enum EndReason: words {
        #[default]
        Decided = "outcome decided",
        Horizon = "horizon reached",
        /// No horizon was given, and a plate oscillates on, or touches again and again, undecided.
        Oscillates = "undecided after many turns and touches",
        StepBudget = "ended early: the step budget was used up",
        StepUnderflow = "ended early: steps became too small to move time forward",
        NonFinite = "ended early: a value stopped being finite",
        BreaksOff = "ended early: the printed listing breaks off at a negative depth",
        Cancelled = "cancelled: what was finished is kept",
    }
}

impl EndReason {
    /// Whether the run is complete: decided, or run as far as it was to go.
    pub fn is_complete(self) -> bool {
        matches!(self, Self::Decided | Self::Horizon | Self::Oscillates)
    }
}

/// The state at the first moment of common velocity.
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

/// A projectile that leaves the plate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Departure {
    /// Time since first contact, s.
    pub t_s: f64,
    /// Velocity of the projectile then, m/s.
    pub velocity_m_s: f64,
    /// Velocity of the plate then, m/s.
    pub plate_velocity_m_s: f64,
}

labelled_enum! {
    /// The mode of motion.
    #[derive(Default)]
    pub enum ContactMode: word {
        #[default]
        Penetrating = "penetrating",
        Fused = "fused",
        Withdrawing = "withdrawing",
        /// Apart, or in the hole without force.
        FreeFlight = "free-flight",
        /// In the hole again, moving towards its bottom.
        Closing = "closing",
        Perforated = "perforated",
    }
}

/// Row of the series.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Sample {
    /// Time since first contact, s.
    pub t_s: f64,
    /// The mode of motion.
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

/// Something that happened at a located moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// When, s.
    pub t_s: f64,
    /// Kind of the event.
    pub kind: EventKind,
}

labelled_enum! {
    /// The kinds of events a person wants marked on a chart.
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

/// How an error estimate was obtained.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EstimateBasis {
    /// Difference from a second computation of higher order and tighter tolerance, times a safety factor.
    SecondComputation,
    /// Difference from the closed form.
    ClosedForm,
    /// Unknown: the other computation ended otherwise, with this outcome.
    OutcomeDiffers(Outcome),
    /// Twice the difference to the same first-order scheme at half the step: against the scheme's own limit.
    HalfStep,
}

/// Where the energy went, in J. Every term is what has left the bodies' initial kinetic energy and the spring's preload.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct EnergyLedger {
    /// Projectile's kinetic energy at the start.
    pub initial_kinetic_j: f64,
    /// Plate's kinetic energy at the start, with what moves with it.
    pub initial_plate_j: f64,
    /// Energy preloaded in the cocked spring.
    pub initial_spring_j: f64,
    /// Projectile's kinetic energy at the end.
    pub projectile_j: f64,
    /// Plate's kinetic energy at the end.
    pub plate_j: f64,
    /// Kinetic energy at the end of what moves with the plate: its rotation, the springs' own mass.
    pub inertia_j: f64,
    /// Energy stored in the spring at the end.
    pub spring_j: f64,
    /// Energy that absorbers have taken by being crushed.
    pub crush_j: f64,
    /// Energy the damper has taken.
    pub damper_j: f64,
    /// Work done in the hole: penetration, and friction on the way out or in.
    pub penetration_j: f64,
    /// Energy lost when a plug is picked up.
    pub pick_up_j: f64,
    /// Work of shearing the plug out.
    pub shear_j: f64,
    /// Energy stored in, or taken by, the stop.
    pub stop_j: f64,
    /// Energy that the weight of the projectile has given, where it is counted.
    pub weight_j: f64,
}

impl EnergyLedger {
    /// All energy at the start, J.
    pub fn initial_j(&self) -> f64 {
        self.initial_kinetic_j + self.initial_plate_j + self.initial_spring_j
    }

    /// All energy at the start, and what the weight has given since, J.
    pub fn given_j(&self) -> f64 {
        self.initial_j() + self.weight_j
    }

    /// All energy accounted for at the end, J.
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

    /// The error of the balance, relative to the energy at the start.
    pub fn residual(&self) -> f64 {
        (self.final_j() - self.given_j()) / self.initial_j()
    }
}

/// Lower bounds: what a run that ends undecided has reached so far. `None` where the value is final, or nothing is known.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct AtLeast {
    /// Depth of the hole so far, m.
    pub penetration_m: Option<f64>,
    /// Greatest plate displacement so far, m.
    pub plate_displacement_m: Option<f64>,
}

/// The load of the mechanism in a run.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct MechanismLoad {
    /// Greatest energy stored in the springs, cocked or on the way, J; `None` without a spring, or where it is not known.
    pub stored_j: Option<f64>,
    /// Yield strength over the greatest bending stress of the beams; `None` without beams.
    pub yield_margin: Option<f64>,
    /// The mass that the mechanism adds to the plate, kg; `None` if none.
    pub added_kg: Option<f64>,
    /// The springs' own mass, kg; `None` where it is not known.
    pub spring_mass_kg: Option<f64>,
    /// Greatest force of spring, damper and elastic stop together over the whole motion, way back included, N; `None` on a rigid mount.
    pub peak_mount_n: Option<f64>,
    /// Greatest energy of rotation at the solver's own steps, J; `None` where nothing turns.
    pub rotation_j: Option<f64>,
}

/// The cost of the computation.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Cost {
    /// Accepted steps.
    pub steps: usize,
    /// Rejected steps.
    pub rejected: usize,
    /// Times the plate turned, twice an oscillation: each takes steps.
    pub turns: usize,
    /// Events that changed what the bodies do: contact, interface and stop.
    pub events: usize,
    /// Evaluations of the equations of motion.
    pub rhs_evaluations: usize,
    /// The wall-clock time it took with its error estimate, as whoever ran it measured, s; `None` where nobody did.
    pub took_s: Option<f64>,
    /// The method that did it, or the methods.
    pub method: &'static str,
    /// Why that method.
    pub reason: &'static str,
}

impl Cost {
    /// Work of a run, in evaluations of the equations of motion.
    pub fn work(&self) -> usize {
        self.rhs_evaluations + STEP_WORK * (self.steps + self.turns + self.events)
    }
}

impl Run {
    /// Final penetration over the rigid mount's, in percent; `None` where either does not exist or the plate is perforated.
    pub fn percent_of_baseline(&self) -> Option<f64> {
        // The quotient first: what is equal is 100 %.
        let percent = 100.0 * (self.final_penetration_m? / self.baseline_penetration_m?);
        (self.outcome != Outcome::Perforated).then_some(percent)
    }

    /// The outcome of the whole shot by the scene's criterion: into a stack, that in the last plate struck. What protrudes from one
    /// before the base plate does not count.
    pub fn shot_outcome(&self) -> Outcome {
        let outcome = self.stack.as_ref().map_or(self.outcome, |stack| stack.outcome);
        let is_in_base = self.stack.as_ref().is_none_or(|stack| {
            stack.behind.len() == stack.elements && outcome != Outcome::Separated
        });
        let base = self.plates().last().filter(|_| is_in_base);
        let by_protrusion = self.scene.target.criterion == Criterion::Protrusion;
        match base.filter(|run| by_protrusion && run.protrusion_m().is_some()) {
            Some(base) if envelope::is_law_low(&base.scene) => Outcome::Unmeasured,
            Some(_) => Outcome::Perforated,
            None => outcome,
        }
    }

    /// Whether the run reached its end and the outcome of the shot is decided.
    pub fn is_decided(&self) -> bool {
        self.end.is_complete() && self.shot_outcome() != Outcome::Moving
    }

    /// The runs of the plates that were struck, in order; of a stack, the base plate at the end where it was.
    pub fn plates(&self) -> impl Iterator<Item = &Self> {
        let behind = self.stack.iter().flat_map(|stack| stack.behind.iter());
        std::iter::once(self).chain(behind.map(|run| &**run))
    }

    /// The depth of the whole shot: into a stack, all thickness perforated and the depth in what stopped it, m.
    pub fn shot_depth_m(&self) -> Option<f64> {
        self.stack.as_ref().map_or(self.final_penetration_m, |stack| stack.penetration_m)
    }

    /// The relative error estimate of a result; of a stack, the greatest of its plates.
    pub fn error_of(&self, name: &str) -> Option<f64> {
        let errors = self.plates().flat_map(|run| &run.error_estimates);
        errors.filter(|error| error.0 == name).map(|error| error.1).reduce(larger)
    }

    /// The residual velocity behind the plate, or behind the base plate of a stack, m/s.
    pub fn shot_residual_m_s(&self) -> Option<f64> {
        self.stack.as_ref().map_or(self.residual_velocity_m_s, |stack| stack.residual_velocity_m_s)
    }

    /// By how much the nose of a shot that is not perforated stands out of the rear face, m; `None` where it does not. By the
    /// army criterion that is a complete penetration.
    pub fn protrusion_m(&self) -> Option<f64> {
        let depth = self.final_penetration_m.or(self.at_least.penetration_m)?;
        let out = depth - self.scene.effective_thickness_m();
        (self.outcome != Outcome::Perforated && out > 0.0).then_some(out)
    }

    /// Greatest displacement plus cocking distance: the space the mechanism needs, m.
    pub fn stroke_m(&self) -> Option<f64> {
        Some(self.max_plate_displacement_m? + self.scene.start_m().abs())
    }

    /// When the plate comes to its greatest displacement, s; `None` without a series that goes so far.
    pub fn max_displacement_time_s(&self) -> Option<f64> {
        let far_m = self.max_plate_displacement_m.filter(|_| self.scene.is_sprung())?;
        let is_there = |row: &&Sample| far_m - row.plate_displacement_m <= REACHED * far_m.abs();
        self.series.iter().find(is_there).map(|row| row.t_s)
    }

    /// Work of the projectile's weight along the stroke of a mechanism, over the kinetic energy of the impact; `None` where there is no
    /// stroke.
    pub fn weight_share(&self) -> Option<f64> {
        let scene = &self.scene;
        let Projectile { mass_kg, velocity_m_s, .. } = scene.projectile;
        let way_m = self.stroke_m().filter(|_| scene.is_sprung())?;
        Some(mass_kg * GRAVITY_M_S2 * way_m / (0.5 * mass_kg * velocity_m_s * velocity_m_s))
    }

    /// The end of the contact window: first arrest, perforation, or the end of the run, s.
    pub fn contact_end_s(&self) -> f64 {
        let arrest = self.first_arrest.map(|arrest| arrest.t_s);
        arrest.or(self.exit_time_s).unwrap_or_else(|| self.series.last().map_or(0.0, |row| row.t_s))
    }
}
