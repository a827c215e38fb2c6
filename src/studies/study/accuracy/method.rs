//! The methods that are compared, each with its letter, its parameter and the function that runs it. Those of the engine simulate
//! the whole run, the others its first contact. The printed scheme of the thesis stands last: what it computes is another model.

use std::fmt;
use std::ops::ControlFlow;
use std::sync::Arc;

use crate::model::appendix;
use crate::model::contact_kernel::Contact;
use crate::model::contact_phase::radau::Radau;
use crate::model::contact_phase::{self, ContactSolution, Ending, Phase, Refusal, exact};
use crate::model::impact::{Forced, simulate_by};
use crate::model::run::Run;
use crate::model::scene::{Reading, Scene};
use crate::model::simulate::{Settings, simulate};
use crate::numerics::stepper::dop853::Dop853;
use crate::numerics::stepper::rk4::{Crossing, Rk4};

/// The result of a method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    /// Of the first contact.
    pub contact: ContactSolution,
    /// Of what only a whole run has; `None` of a method that computes the contact alone.
    pub whole: Option<WholeRun>,
}

/// Results of a whole run, as far as they exist.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WholeRun {
    /// The plate's greatest displacement, m.
    pub displacement_m: Option<f64>,
    /// The peak contact force, N.
    pub force_n: Option<f64>,
    /// The projectile's velocity after a perforation, m/s.
    pub residual_m_s: Option<f64>,
}

impl From<ContactSolution> for Answer {
    fn from(contact: ContactSolution) -> Self {
        Self { contact, whole: None }
    }
}

/// The parameter that makes a method more accurate and more expensive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Parameter {
    /// It has none.
    None,
    /// Time step, s.
    Step(f64),
    /// Tolerance.
    Tolerance(f64),
}

impl Parameter {
    /// Its value, if it has one.
    pub fn value(self) -> Option<f64> {
        match self {
            Self::None => None,
            Self::Step(value) | Self::Tolerance(value) => Some(value),
        }
    }
}

impl fmt::Display for Parameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::None => Ok(()),
            Self::Step(dt_s) => f.pad(&format!("dt {dt_s:.0e} s")),
            Self::Tolerance(tolerance) => f.pad(&format!("tol {tolerance:.0e}")),
        }
    }
}

/// How finely parameters are turned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ladder {
    /// Every value.
    Full,
    /// Few values, none of them expensive.
    Quick,
}

/// The values of a parameter that are tried.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ParameterRange {
    /// It has none.
    None,
    /// Time steps that make a given number of steps per contact at most, and how many of a decade are taken.
    Steps(f64, i32),
    /// Tolerances down to this power of ten, every power or every second.
    Tolerances(i32, i32),
}

/// The parameters of those who choose their steps.
const TIGHT: [ParameterRange; 2] =
    [ParameterRange::Tolerances(13, 1), ParameterRange::Tolerances(11, 2)];

enumeration! {
    /// A way to compute a scene.
    pub enum Method in MethodRow {
        /// The letter on charts.
        letter: char,
        /// The name in tables and files.
        name: &'static str,
        /// Whether it is one of the engine's own, which have their areas and equations in common.
        is_of_engine: bool,
        /// The values of its parameter on the full ladder and on the quick one.
        ranges: [ParameterRange; 2],
        /// The function that runs it.
        run: fn(&Job) -> Result<Answer, Refusal>,
    }
    /// Appendix A with its coupling and damper corrected.
    ThesisCorrected {
        letter: 'M', name: "thesis, corrected", is_of_engine: false,
        ranges: [ParameterRange::Steps(3e5, 1), ParameterRange::Steps(3e3, 1)],
        run: |job| appendix::contact(&job.scene, job.value(), Reading::Corrected, job.steps_max).map(Answer::from)
    }
    /// Classical Runge-Kutta, fixed step, events only noticed.
    Rk4 {
        letter: 'R', name: "RK4, no events", is_of_engine: false,
        ranges: [ParameterRange::Steps(3e4, 2), ParameterRange::Steps(1.5e3, 2)],
        run: |job| job.rk4(Crossing::Notice)
    }
    /// The same with events located and joints restarted at.
    Rk4Events {
        letter: 'E', name: "RK4 + events", is_of_engine: false,
        ranges: [ParameterRange::Steps(1e4, 2), ParameterRange::Steps(1.5e3, 2)],
        run: |job| job.rk4(Crossing::Locate)
    }
    /// DOP853 with events located and joints restarted at.
    Dop853 {
        letter: 'D', name: "DOP853 + events", is_of_engine: false, ranges: TIGHT,
        run: |job| job.phase(&Dop853 { tolerance: job.value() })
    }
    /// Radau IIA of order 5, implicit and L-stable, with events located and joints restarted at.
    Radau {
        letter: 'I', name: "Radau IIA 5", is_of_engine: false,
        ranges: [ParameterRange::Tolerances(12, 1), ParameterRange::Tolerances(11, 2)],
        run: |job| job.phase(&Radau { tolerance: job.value() })
    }
    /// The simulation by Taylor steps alone.
    Taylor {
        letter: 'S', name: "Taylor series 16", is_of_engine: true, ranges: TIGHT,
        run: |job| forced(Forced::Taylor, &job.scene)
    }
    /// Closed form, where only inertia resists.
    ClosedForm {
        letter: 'C', name: "closed form", is_of_engine: true, ranges: [ParameterRange::None; 2],
        run: |job| exact::solve(&job.scene).map(Answer::from)
    }
    /// The contact kernel, as sweeps and searches use it.
    ContactKernel {
        letter: 'L', name: "contact kernel", is_of_engine: true, ranges: TIGHT,
        run: |job| contact_kernel(&job.scene, job.value())
    }
    /// The simulation without omitted terms.
    Full {
        letter: 'N', name: "no term omitted", is_of_engine: true, ranges: TIGHT,
        run: |job| forced(Forced::General, &job.scene)
    }
    /// The work of `simulate`.
    Auto {
        letter: 'A', name: "auto", is_of_engine: true, ranges: TIGHT,
        run: |job| auto(&job.scene)
    }
    /// Appendix A as printed.
    ThesisPrinted {
        letter: 'T', name: "printed scheme", is_of_engine: false,
        ranges: [ParameterRange::Steps(3e5, 1), ParameterRange::Steps(3e3, 1)],
        run: |job| appendix::contact(&job.scene, job.value(), Reading::Printed, job.steps_max).map(Answer::from)
    }
}

impl Method {
    /// Computes the contact phase of a valid scene whose end time is unknown.
    ///
    /// # Errors
    /// A [`Refusal`] when the method gives no answer.
    pub fn solve(
        self,
        parameter: Parameter,
        scene: &Scene,
        steps_max: usize,
    ) -> Result<ContactSolution, Refusal> {
        Ok(Job::new(self, parameter, scene, steps_max).run()?.contact)
    }

    /// The values of its parameter for a contact of about `end_s`, the coarsest first.
    pub fn parameters(self, end_s: f64, ladder: Ladder) -> Vec<Parameter> {
        match self.ranges()[ladder as usize] {
            ParameterRange::None => vec![Parameter::None],
            ParameterRange::Steps(most, per_decade) => steps(end_s, most, per_decade),
            ParameterRange::Tolerances(tightest, every) => tolerances(tightest, every),
        }
    }
}

/// Time steps 1 and 3 times powers of ten (or powers of ten alone) that make 10 to `steps_max` steps: fewer make no sense.
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

/// Tolerances from 1e-3 down, every power of ten or every second.
fn tolerances(tightest: i32, every: i32) -> Vec<Parameter> {
    let powers = (3..=tightest).filter(|power| (power - 3) % every == 0);
    powers
        .map(|power| Parameter::Tolerance(format!("1e-{power}").parse().unwrap_or(f64::NAN)))
        .collect()
}

/// One computation, ready to be repeated.
pub struct Job {
    method: Method,
    parameter: Parameter,
    scene: Arc<Scene>,
    steps_max: usize,
}

impl Job {
    /// Prepares a computation of a valid scene.
    pub fn new(method: Method, parameter: Parameter, scene: &Scene, steps_max: usize) -> Self {
        let mut own = scene.clone();
        if let Parameter::Tolerance(tolerance) = parameter {
            own.run.tolerance = tolerance;
        }
        Self { method, parameter, scene: Arc::new(own), steps_max }
    }

    /// The scene, with the tolerance.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Do it.
    ///
    /// # Errors
    /// A [`Refusal`] when the method gives no answer.
    pub fn run(&self) -> Result<Answer, Refusal> {
        (self.method.run())(self)
    }

    fn value(&self) -> f64 {
        self.parameter.value().unwrap_or(f64::NAN)
    }

    fn phase(&self, method: &contact_phase::Method) -> Result<Answer, Refusal> {
        Phase::of(&self.scene).solve(method, self.steps_max).map(Answer::from)
    }

    fn rk4(&self, crossing: Crossing) -> Result<Answer, Refusal> {
        let phase = Phase::of(&self.scene);
        let step = phase.scaled_time(self.value());
        phase.solve(&Rk4 { step, crossing }, self.steps_max).map(Answer::from)
    }
}

fn auto(scene: &Arc<Scene>) -> Result<Answer, Refusal> {
    let run = simulate(scene, &Settings::BARE, &mut |_| ControlFlow::Continue(()));
    whole(&run.map_err(|_invalid| Refusal::EndedEarly)?)
}

fn forced(method: Forced, scene: &Arc<Scene>) -> Result<Answer, Refusal> {
    let run = simulate_by(method, scene).map_err(|_invalid| Refusal::EndedEarly)?;
    whole(&run.ok_or(Refusal::TooStiff)?)
}

fn whole(run: &Run) -> Result<Answer, Refusal> {
    let whole = WholeRun {
        displacement_m: run.max_plate_displacement_m,
        force_n: run.peak_contact_force_n,
        residual_m_s: run.residual_velocity_m_s,
    };
    Ok(Answer { contact: answer_of(run)?, whole: Some(whole) })
}

fn contact_kernel(scene: &Scene, tolerance: f64) -> Result<Answer, Refusal> {
    let end = Contact::of(scene).run(tolerance).ok_or(Refusal::NeedsSimulation)?;
    let ending = if end.arrested { Ending::Arrest } else { Ending::Perforation };
    let free = ContactSolution::free(ending, end.t_s, end.penetration_m);
    Ok(ContactSolution { steps: end.steps, evaluations: end.steps, ..free }.into())
}

/// The contact phase of a run, if it came to its end.
pub(in crate::study) fn answer_of(run: &Run) -> Result<ContactSolution, Refusal> {
    let (ending, t_s, depth_m) = match (run.first_arrest, run.exit_time_s, run.final_penetration_m)
    {
        (Some(arrest), _, _) => (Ending::Arrest, arrest.t_s, arrest.penetration_m),
        (None, Some(t_s), Some(depth_m)) => (Ending::Perforation, t_s, depth_m),
        (None, _, _) => return Err(Refusal::EndedEarly),
    };
    let cost = run.cost;
    Ok(ContactSolution {
        ending,
        t_s,
        depth_m,
        steps: cost.steps,
        rejected: cost.rejected,
        evaluations: cost.rhs_evaluations,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn knobs_go_from_coarse_to_fine() {
        for method in Method::ALL {
            for ladder in [Ladder::Full, Ladder::Quick] {
                let parameters = method.parameters(1.1e-4, ladder);
                assert!(!parameters.is_empty(), "{method:?}");
                assert!(parameters.windows(2).all(|pair| pair[0].value() > pair[1].value()));
            }
        }
        let thesis = Method::ThesisPrinted.parameters(1.1e-4, Ladder::Full);
        assert!(thesis.contains(&Parameter::Step(1e-6)), "the thesis's own step");
        assert_eq!(thesis.len(), 5);
        assert!(!Method::Rk4.parameters(1e3, Ladder::Quick).is_empty());
    }

    #[test]
    fn letters_are_unique() {
        let mut letters = Method::ALL.map(Method::letter).to_vec();
        letters.sort_unstable();
        letters.dedup();
        assert_eq!(letters.len(), Method::ALL.len());
    }
}
