//! Methods of the comparison: letter, parameter and function of each.
//!
//! All methods but two integrate the whole run with the loop of the simulation. The contact kernel computes only the first contact; the
//! printed scheme of the thesis, the last method, computes another model.

use std::fmt;
use std::ops::ControlFlow;
use std::sync::Arc;

use crate::study::quantities;
use cmra_engine::model::contact_kernel::Contact;
use cmra_engine::model::impact::IntegrationMethod;
use cmra_engine::model::impact::step_by;
use cmra_engine::model::run::{Cost, EndReason, Outcome, Run, RunSnapshot, Sample};
use cmra_engine::model::scene::{ContactModel, InterfaceLaw, Listing, Scene};
use cmra_engine::model::simulate::{Settings, simulate_by_law_alone, simulate_by_listing};

enumeration! {
    /// Result that methods are compared by.
    pub enum Compared in ComparedRow {
        /// Key of its error in files.
        key: &'static str,
        /// Label on screens.
        label: &'static str,
    }
    /// Depth of the hole of an arrested projectile, m.
    Depth { key: "penetration_error", label: "depth" }
    /// Time of first arrest or of exit, s.
    Time { key: "time_error", label: "time" }
    /// Greatest plate displacement, m.
    Displacement { key: "displacement_error", label: "displacement" }
    /// Peak contact force, N.
    Force { key: "force_error", label: "force" }
    /// Velocity of a projectile that leaves the plate through either face, m/s.
    LastVelocity { key: "last_velocity_error", label: "last velocity" }
    /// Time at which it leaves, s.
    LastTime { key: "last_time_error", label: "last time" }
    /// Greatest force into the mount, N.
    MountForce { key: "mount_force_error", label: "mount force" }
}

/// A number for each compared result; `None` if the result does not exist, or the method does not know it.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Results([Option<f64>; Compared::ALL.len()]);

impl Results {
    /// Creates the numbers by a function of the result.
    pub fn new(get: impl Fn(Compared) -> Option<f64>) -> Self {
        Self(Compared::ALL.map(get))
    }

    /// The number of a result.
    pub fn get(&self, of: Compared) -> Option<f64> {
        self.0[of as usize]
    }

    /// Sets the number of a result.
    pub fn set(&mut self, of: Compared, value: Option<f64>) {
        self.0[of as usize] = value;
    }

    /// The numbers that exist, with their results.
    pub fn known(&self) -> impl Iterator<Item = (Compared, f64)> {
        Compared::ALL.into_iter().filter_map(|of| Some((of, self.get(of)?)))
    }

    /// The results that exist.
    pub fn exist(&self) -> [bool; Compared::ALL.len()] {
        self.0.map(|value| value.is_some())
    }
}

/// Result of a method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    /// Outcome of the shot.
    pub outcome: Outcome,
    /// Results that are compared.
    pub results: Results,
    /// Number of accepted steps.
    pub steps: usize,
    /// Number of rejected steps.
    pub rejected: usize,
    /// Number of evaluations of the right-hand side.
    pub evaluations: usize,
}

/// Reason for a missing result of a method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// The contact kernel does not apply to the scene.
    NeedsSimulation,
    /// The listing of the thesis has one plate and the hydrodynamic law.
    OtherContact,
    /// The listing of the thesis has only one massless power-law spring.
    NoPowerLaw,
    /// The plate reaches its stop during the contact; the listing has no stop.
    StopActs,
    /// The run ended early, or undecided.
    Ended(EndReason),
    /// Outcome differs from the reference.
    OtherOutcome,
    /// A result is not finite.
    NonFinite,
    /// No reference of another method could be computed.
    NoReference,
    /// A coarser point exceeded the limit of evaluations.
    TooMuchWork,
}

impl Refusal {
    /// Returns the reason as text.
    pub fn message(self) -> &'static str {
        match self {
            Self::NeedsSimulation => "left to the simulation, as in a sweep",
            Self::OtherContact => "not applicable: one plate, hydrodynamic law only",
            Self::NoPowerLaw => "not applicable: only a massless spring k |x|^n",
            Self::StopActs => "not applicable: a stop acts",
            Self::Ended(EndReason::BreaksOff) => "wrong: projectile leaves through the entry face",
            Self::Ended(EndReason::StepBudget) => "gave up: its work is used up",
            Self::Ended(EndReason::StepUnderflow) => "gave up: steps too small to move time",
            Self::Ended(EndReason::NonFinite) | Self::NonFinite => {
                "diverged: a value is not finite"
            }
            Self::Ended(_) => "undecided",
            Self::OtherOutcome => "wrong: the outcome differs from the reference",
            Self::NoReference => "not run: no independent reference",
            Self::TooMuchWork => "not run: too much work",
        }
    }
}

impl Refusal {
    /// Returns `true` if the evaluations of a run did not suffice.
    pub(super) fn is_of_work(self) -> bool {
        matches!(self, Self::Ended(EndReason::StepBudget | EndReason::Oscillates))
    }
}

/// Parameter that sets accuracy and run time of a method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Parameter {
    /// Time step, s.
    Step(f64),
    /// Tolerance.
    Tolerance(f64),
}

impl Parameter {
    /// Returns `true` for a step size.
    pub(super) fn is_step(self) -> bool {
        matches!(self, Self::Step(_))
    }

    /// Returns the step size or tolerance.
    pub fn value(self) -> f64 {
        match self {
            Self::Step(value) | Self::Tolerance(value) => value,
        }
    }
}

impl fmt::Display for Parameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Step(dt_s) => f.pad(&format!("dt {dt_s:.0e} s")),
            Self::Tolerance(tolerance) => f.pad(&format!("tol {tolerance:.0e}")),
        }
    }
}

/// Set of parameter values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SettingGrid {
    /// All values.
    Full,
    /// A few values without long run times.
    Quick,
}

/// Range of a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ParameterRange {
    /// Step sizes: maximum number of steps per contact, and values per decade.
    Steps(f64, i32),
    /// Tolerances: smallest one as a negative power of ten, and increment of the power.
    Tolerances(u32, usize),
}

/// Tolerances of methods with an adaptive step size, for the full and the quick grid.
const TIGHT: [ParameterRange; 2] =
    [ParameterRange::Tolerances(13, 1), ParameterRange::Tolerances(11, 2)];
/// Step sizes of methods of order four, for the full and the quick grid.
const STEPS: [ParameterRange; 2] = [ParameterRange::Steps(3e3, 2), ParameterRange::Steps(3e2, 2)];

enumeration! {
    /// Method of the comparison.
    pub enum Method in MethodRow {
        /// Letter on charts.
        letter: char,
        /// Name in tables and files.
        name: &'static str,
        /// Whether the method has the steps of the engine: its reference then comes from another method.
        has_own_steps: bool,
        /// Parameter values of the full and the quick grid.
        ranges: [ParameterRange; 2],
        /// Function that computes a result.
        run: fn(&Job) -> Result<Answer, Refusal>,
    }
    /// Classical Runge-Kutta method with a fixed step size; events take effect at the end of a step.
    Rk4 {
        letter: 'R', name: "RK4, no events", has_own_steps: false, ranges: STEPS,
        run: |job| job.by(IntegrationMethod::Rk4WithoutEvents(job.parameter.value()))
    }
    /// Classical Runge-Kutta method with a fixed step size and event location.
    Rk4Events {
        letter: 'E', name: "RK4 + events", has_own_steps: false, ranges: STEPS,
        run: |job| job.by(IntegrationMethod::Rk4(job.parameter.value()))
    }
    /// DOP853 with event location.
    Dop853 {
        letter: 'D', name: "DOP853 + events", has_own_steps: false, ranges: TIGHT,
        run: |job| job.by(IntegrationMethod::Dop853(job.parameter.value()))
    }
    /// Radau IIA of order 5, implicit and L-stable, with event location.
    Radau {
        letter: 'I', name: "Radau IIA 5", has_own_steps: false,
        ranges: [ParameterRange::Tolerances(12, 1), ParameterRange::Tolerances(11, 2)],
        run: |job| job.by(IntegrationMethod::Radau5(job.parameter.value()))
    }
    /// Contact kernel, as in sweeps and searches.
    ContactKernel {
        letter: 'L', name: "contact kernel", has_own_steps: false, ranges: TIGHT,
        run: |job| contact_kernel(&job.scene, job.parameter.value())
    }
    /// Engine without omissions: integrates the motion of the plate also where the energy balance gives its maximum displacement.
    Full {
        letter: 'N', name: "nothing omitted", has_own_steps: true, ranges: TIGHT,
        run: |job| job.by(IntegrationMethod::CollocationInFull(job.parameter.value()))
    }
    /// Method of `simulate`.
    Auto {
        letter: 'A', name: "auto", has_own_steps: true, ranges: TIGHT,
        run: |job| auto(&job.scene)
    }
    /// Listing of Appendix A as printed.
    ThesisPrinted {
        letter: 'T', name: "printed scheme", has_own_steps: false,
        ranges: [ParameterRange::Steps(3e5, 1), ParameterRange::Steps(3e3, 1)],
        run: |job| printed(&job.scene, job.parameter.value())
    }
}

impl Method {
    /// Returns the parameter values for a contact of about `end_s`, coarsest first.
    pub fn parameters(self, end_s: f64, ladder: SettingGrid) -> Vec<Parameter> {
        match self.ranges()[ladder as usize] {
            ParameterRange::Steps(most, per_decade) => steps(end_s, most, per_decade),
            // The largest tolerance is 1e-3.
            ParameterRange::Tolerances(tightest, every) => {
                let tolerance = |power| format!("1e-{power}").parse().unwrap_or(f64::NAN);
                (3..=tightest)
                    .step_by(every)
                    .map(|it| Parameter::Tolerance(tolerance(it)))
                    .collect()
            }
        }
    }
}

/// Returns step sizes for 10 to `steps_max` steps: powers of ten, or 1 and 3 times powers of ten.
fn steps(end_s: f64, steps_max: f64, per_decade: i32) -> Vec<Parameter> {
    let mut list = Vec::new();
    for power in (-60..20).rev() {
        for mantissa in [3.0, 1.0] {
            let dt_s = format!("{mantissa}e{power}").parse().unwrap_or(f64::NAN);
            let count = end_s / dt_s;
            if (10.0..=steps_max).contains(&count) && (per_decade == 2 || mantissa < 2.0) {
                list.push(Parameter::Step(dt_s));
            }
        }
    }
    list
}

/// Computation that can be repeated for timing.
pub struct Job {
    method: Method,
    parameter: Parameter,
    scene: Arc<Scene>,
}

impl Job {
    /// Prepares a computation of a valid scene.
    pub fn new(method: Method, parameter: Parameter, scene: &Scene) -> Self {
        let mut own = scene.clone();
        if let Parameter::Tolerance(tolerance) = parameter {
            own.run.tolerance = tolerance;
        }
        Self { method, parameter, scene: Arc::new(own) }
    }

    /// Runs the computation.
    pub fn run(&self) -> Result<Answer, Refusal> {
        (self.method.run())(self)
    }

    fn by(&self, stepping: IntegrationMethod) -> Result<Answer, Refusal> {
        let go_on = &mut |_: &RunSnapshot<'_>| ControlFlow::Continue(());
        let run = step_by(stepping, &self.scene, go_on).ok().flatten();
        answer_of(&run.ok_or(Refusal::NeedsSimulation)?)
    }
}

fn auto(scene: &Arc<Scene>) -> Result<Answer, Refusal> {
    let run = simulate_by_law_alone(scene, &Settings::BARE, &mut |_| ControlFlow::Continue(()));
    answer_of(&run.map_err(|_invalid| Refusal::NonFinite)?)
}

/// Returns the results of a run; an error if its outcome is undecided. For a stack the outcome, the depth and the last velocity are those of
/// the whole shot, the other results those of the first plate.
pub(in crate::study) fn answer_of(run: &Run) -> Result<Answer, Refusal> {
    let outcome = run.stack.as_ref().map_or(run.outcome, |stack| stack.outcome);
    let last = run.plates().last().unwrap_or(run);
    if matches!(outcome, Outcome::Moving | Outcome::Unmeasured) || !last.end.is_complete() {
        return Err(Refusal::Ended(last.end));
    }
    let time_s = run.first_arrest.map(|arrest| arrest.t_s).or(run.departure.exit_time_s);
    // A stack that only its protruding nose perforates has a depth, and no other perforated one.
    let is_stopped = run.stack.is_some() || outcome != Outcome::Perforated;
    let depth_m = run.shot_depth_m().filter(|_| is_stopped);
    let cost = run.cost;
    Ok(Answer {
        outcome,
        results: Results::new(|of| match of {
            Compared::Depth => depth_m,
            Compared::Time => time_s,
            Compared::Displacement => run.max_plate_displacement_m,
            Compared::Force => run.peak_contact_force_n,
            Compared::LastVelocity => last
                .departure
                .residual_velocity_m_s
                .or_else(|| Some(last.departure.separation?.velocity_m_s)),
            Compared::LastTime => {
                run.departure.exit_time_s.or_else(|| Some(run.departure.separation?.t_s))
            }
            Compared::MountForce => {
                quantities::find("peak_mount_force_n").and_then(|force| force.value(run))
            }
        }),
        steps: cost.steps,
        rejected: cost.rejected,
        evaluations: cost.rhs_evaluations,
    })
}

/// Returns depth and time of the first arrest, which an undecided run has as well; `None` without an arrest. For a stack they are those of
/// the first plate.
pub(in crate::study) fn first_arrest_of(run: &Run) -> Option<Answer> {
    let arrest = run.first_arrest?;
    let mut results = Results::default();
    results.set(Compared::Depth, Some(arrest.penetration_m));
    results.set(Compared::Time, Some(arrest.t_s));
    let Cost { steps, rejected, rhs_evaluations: evaluations, .. } = run.cost;
    Some(Answer { outcome: Outcome::Moving, results, steps, rejected, evaluations })
}

/// Runs the contact kernel. It computes the first contact only: its depth is final unless the interface can yield later.
fn contact_kernel(scene: &Scene, tolerance: f64) -> Result<Answer, Refusal> {
    let contact = Contact::from_scene(scene).filter(|_| !scene.is_stack());
    let end = contact.and_then(|contact| contact.run(tolerance));
    let end = end.ok_or(Refusal::NeedsSimulation)?;
    let outcome = if end.arrested { Outcome::Arrested } else { Outcome::Perforated };
    let is_final = end.arrested && scene.interface.law == InterfaceLaw::Fused;
    let mut results = Results::default();
    results.set(Compared::Depth, is_final.then_some(end.penetration_m));
    results.set(Compared::Time, Some(end.t_s));
    Ok(Answer { outcome, results, steps: end.steps, rejected: 0, evaluations: end.steps })
}

/// Runs the listing as printed, up to the horizon or the end of the contact, whichever is later.
pub(super) fn printed(scene: &Scene, dt_s: f64) -> Result<Answer, Refusal> {
    if scene.contact.model != ContactModel::Hydrodynamic || scene.is_stack() {
        return Err(Refusal::OtherContact);
    }
    if scene.is_sprung() && !scene.mechanism.is_plain() {
        return Err(Refusal::NoPowerLaw);
    }
    let mut contact = scene.clone();
    contact.run.horizon_s = Some(dt_s);
    let listing = Listing { step_s: dt_s, ..Listing::default() };
    let stop_m = scene.mechanism.stop.position_m.filter(|_| scene.is_sprung());
    let go_on = &mut |_: &RunSnapshot<'_>| ControlFlow::Continue(());
    let contact = Arc::new(contact);
    let Ok(run) = simulate_by_listing(&contact, listing, stop_m.is_some(), go_on) else {
        return Err(Refusal::OtherContact);
    };
    let is_beyond = |row: &Sample| stop_m.is_some_and(|stop_m| row.plate_displacement_m >= stop_m);
    if run.series.iter().any(is_beyond) {
        return Err(Refusal::StopActs);
    }
    let mut answer = answer_of(&run)?;
    // The listing prints the time at the start of its last step.
    answer.results.set(Compared::Time, Some(answer.steps as f64 * dt_s));
    Ok(answer)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parameters_go_from_coarse_to_fine() {
        for method in Method::ALL {
            for ladder in [SettingGrid::Full, SettingGrid::Quick] {
                let parameters = method.parameters(1.1e-4, ladder);
                assert!(!parameters.is_empty(), "{method:?}");
                assert!(parameters.windows(2).all(|pair| pair[0].value() > pair[1].value()));
            }
        }
        let thesis = Method::ThesisPrinted.parameters(1.1e-4, SettingGrid::Full);
        assert!(thesis.contains(&Parameter::Step(1e-6)), "the thesis's own step");
        assert_eq!(thesis.len(), 5);
        assert!(!Method::Rk4.parameters(1e3, SettingGrid::Quick).is_empty());
    }
}
