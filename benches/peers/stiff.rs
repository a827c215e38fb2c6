//! `differential-equations`: its BDF and its Radau IIA 5 with an analytic Jacobian and its own event location.

use differential_equations::prelude::{
    BackwardDifferentiationFormula, CrossingDirection, Event, EventConfig, IVP, ImplicitRungeKutta,
    Matrix, Solution, Status,
};

use crate::equations::Equations;
use crate::solvers::{Job, Outcome};

/// Later than any contact ends, in R/v.
const UNTIL: f64 = 1e4;
/// Steps after which it has failed.
const STEPS_MAX: usize = 100_000;

struct Peer(Equations);

impl differential_equations::ode::ODE<f64, [f64; 4]> for Peer {
    fn diff(&self, _: f64, y: &[f64; 4], rates: &mut [f64; 4]) {
        *rates = self.0.rates(*y);
    }

    fn jacobian(&self, _: f64, y: &[f64; 4], j: &mut Matrix<f64>) {
        for (row, values) in self.0.jacobian(*y).iter().enumerate() {
            for (column, value) in values.iter().enumerate() {
                j[(row, column)] = *value;
            }
        }
    }
}

/// Common velocity.
struct Arrest;

impl Event<f64, [f64; 4]> for Arrest {
    fn config(&self) -> EventConfig {
        EventConfig::new(CrossingDirection::Negative, Some(1))
    }

    fn event(&self, _: f64, y: &[f64; 4]) -> f64 {
        y[1]
    }
}

fn outcome<E>(peer: &Peer, found: Result<Solution<f64, [f64; 4]>, E>) -> Outcome {
    let Ok(solution) = found else { return Outcome::Failed };
    match (solution.status, solution.t.last(), solution.y.last()) {
        (Status::Interrupted, Some(t), Some(y)) => Outcome::Answer(peer.0.end(*t, y[0])),
        (_, _, _) => Outcome::Failed,
    }
}

/// BDF at a tolerance.
pub(crate) fn bdf(equations: &Equations, tolerance: f64) -> Job {
    let peer = Peer(*equations);
    Box::new(move || {
        let method = BackwardDifferentiationFormula::adaptive();
        let method = method.rtol(tolerance).atol(tolerance).max_steps(STEPS_MAX);
        let problem = IVP::ode(&peer, 0.0, UNTIL, peer.0.start());
        outcome(&peer, problem.event(&Arrest).method(method).solve())
    })
}

/// Radau IIA 5 at a tolerance.
pub(crate) fn radau5(equations: &Equations, tolerance: f64) -> Job {
    let peer = Peer(*equations);
    Box::new(move || {
        let method = ImplicitRungeKutta::radau5();
        let method = method.rtol(tolerance).atol(tolerance).max_steps(STEPS_MAX);
        let problem = IVP::ode(&peer, 0.0, UNTIL, peer.0.start());
        outcome(&peer, problem.event(&Arrest).method(method).solve())
    })
}
