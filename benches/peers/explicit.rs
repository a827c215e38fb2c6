//! `ode_solvers`: DOP853 restarted at the joints of the area law, and DOPRI5. It has no event location: a stretch ends by
//! `solout` after a crossing, and the same solver then walks onto it with the event's own variable as the independent one
//! (Hénon 1982). Time is a fifth component, for its DOP853 has a wrong node for a right-hand side that uses t.

use ode_solvers::dop_shared::OutputType;
use ode_solvers::{Dop853, Dopri5, SVector, System};

use crate::equations::Equations;
use crate::solvers::{Job, Outcome};

type Y = SVector<f64, 5>;

/// Later than any contact ends, in R/v.
const UNTIL: f64 = 1e4;
/// Steps after which it has failed.
const STEPS_MAX: u32 = 50_000;

/// Independent variable of the equations.
#[derive(Clone, Copy)]
enum Independent {
    Time,
    Travel,
    Slip,
}

/// Method of the library.
#[derive(Clone, Copy)]
enum Method {
    Dop853,
    Dopri5,
}

#[derive(Clone, Copy)]
struct Peer {
    equations: Equations,
    independent: Independent,
    /// Travel at which a stretch ends.
    joint: f64,
}

impl System<f64, Y> for Peer {
    fn system(&self, _: f64, y: &Y, dy: &mut Y) {
        let rate = self.equations.rates([y[0], y[1], y[2], y[3]]);
        let per = match self.independent {
            Independent::Time => 1.0,
            Independent::Travel => 1.0 / rate[0],
            Independent::Slip => 1.0 / rate[1],
        };
        for (dy, rate) in dy.iter_mut().zip(rate) {
            *dy = rate * per;
        }
        dy[4] = per;
    }

    fn solout(&mut self, _: f64, y: &Y, _: &Y) -> bool {
        matches!(self.independent, Independent::Time) && (y[1] < 0.0 || y[0] > self.joint)
    }
}

impl Peer {
    fn integrate(self, method: Method, (from, to): (f64, f64), y: Y, tolerance: f64) -> Option<Y> {
        let (most, sparse) = ((to - from).abs(), OutputType::Sparse);
        match method {
            Method::Dop853 => {
                let mut solver = Dop853::from_param(
                    self,
                    from,
                    to,
                    0.0,
                    y,
                    tolerance,
                    tolerance,
                    0.9,
                    0.0,
                    0.333,
                    6.0,
                    most,
                    0.0,
                    STEPS_MAX,
                    u32::MAX,
                    sparse,
                );
                solver.integrate().ok()?;
                solver.y_out().last().copied()
            }
            Method::Dopri5 => {
                let mut solver = Dopri5::from_param(
                    self,
                    from,
                    to,
                    0.0,
                    y,
                    tolerance,
                    tolerance,
                    0.9,
                    0.04,
                    0.2,
                    10.0,
                    most,
                    0.0,
                    STEPS_MAX,
                    u32::MAX,
                    sparse,
                );
                solver.integrate().ok()?;
                solver.y_out().last().copied()
            }
        }
    }
}

fn contact(equations: &Equations, method: Method, tolerance: f64) -> Option<(f64, f64)> {
    let [q, u, x, w] = equations.start();
    let mut y = Y::from([q, u, x, w, 0.0]);
    for joint in equations.joints() {
        let on = |independent| Peer { equations: *equations, independent, joint };
        y = on(Independent::Time).integrate(method, (0.0, UNTIL), y, tolerance)?;
        if y[0] <= joint {
            y = on(Independent::Slip).integrate(method, (y[1], 0.0), y, tolerance)?;
            break;
        }
        y = on(Independent::Travel).integrate(method, (y[0], joint), y, tolerance)?;
        y[0] = joint;
    }
    Some(equations.end(y[4], y[0]))
}

fn job(equations: &Equations, method: Method, tolerance: f64) -> Job {
    let equations = *equations;
    Box::new(move || {
        contact(&equations, method, tolerance).map_or(Outcome::Failed, Outcome::Answer)
    })
}

/// DOP853 at a tolerance.
pub(crate) fn dop853(equations: &Equations, tolerance: f64) -> Job {
    job(equations, Method::Dop853, tolerance)
}

/// DOPRI5 at a tolerance.
pub(crate) fn dopri5(equations: &Equations, tolerance: f64) -> Job {
    job(equations, Method::Dopri5, tolerance)
}
