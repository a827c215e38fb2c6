//! Integration methods of the loop.

/// Integration method of the loop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum IntegrationMethod {
    /// Radau IIA with a tolerance, the method of the engine: seven stages if the laws of the mechanism are analytic, else nine. Seven
    /// stages need less work for a step, but more steps near a singular zero.
    Collocation(f64),
    /// Collocation; the plate is integrated to its turning point even if its energy gives the maximum displacement.
    CollocationInFull(f64),
    /// Collocation with two more stages, for the error estimate of one to this tolerance; its own is tighter. Events force both
    /// computations to the same steps, on which a member with equally many stages would have the same errors.
    Second(f64),
    /// Radau IIA with three stages (order five) and a tolerance.
    Radau5(f64),
    /// DOP853 with a tolerance.
    Dop853(f64),
    /// Classical Runge-Kutta method with this step size, s, and event location.
    Rk4(f64),
    /// Classical Runge-Kutta method with this step size, s; events take effect at the end of a step.
    Rk4WithoutEvents(f64),
}
