//! The classical Runge-Kutta method of order four with a fixed step.
//!
//! W. Kutta, *Zeitschrift für Mathematik und Physik* 46 (1901) 435-453. Boundaries are either landed on or only noticed after
//! the step that crossed them, as a program without event location does.

use super::landing::Ends;
use super::{Count, Point, Reached, Start, Stepper, StopReason, System, is_finite};

/// The event at a boundary.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Crossing {
    /// It is located, and landed on.
    Locate,
    /// The stretch ends with the step that crossed it.
    Notice,
}

/// The method with a fixed step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rk4 {
    /// Length of a step, > 0.
    pub step: f64,
    /// What happens at a boundary.
    pub crossing: Crossing,
}

impl<const N: usize, S: System<N>> Stepper<N, S> for Rk4 {
    fn lands(&self) -> bool {
        self.crossing == Crossing::Locate
    }

    fn integrate(&self, system: &S, start: Start<N>, count: &mut Count) -> Reached<N> {
        let Self { step: h, crossing } = *self;
        let (mut t, mut y) = (start.t, start.y);
        let mut f = system.rate(&y);
        count.evaluations += 1;
        let ended = |t: f64, y: [f64; N], stop: StopReason| Reached { t, y, stop, step: h };
        let before = count.steps;
        loop {
            // The time of step i is start + i h: a sum of steps would drift.
            let t_next = start.t + (count.steps + 1 - before) as f64 * h;
            if let Some(stop) = count.forbids(t, t_next - t) {
                return ended(t, y, stop);
            }
            let from = Point { y: &y, f: &f };
            let y_next = step(system, from, h, count);
            let f_next = system.rate(&y_next);
            count.evaluations += 1;
            count.steps += 1;
            if !(is_finite(&y_next) && is_finite(&f_next)) {
                return ended(t, y, StopReason::NonFinite);
            }
            let ends = Ends { h, y0: &y, f0: &f, y1: &y_next, f1: &f_next };
            match crossing {
                Crossing::Notice => {
                    if let Some(index) = ends.first(system.boundaries()) {
                        return ended(t_next, y_next, StopReason::Boundary(index));
                    }
                }
                Crossing::Locate => {
                    let anew = |s: f64| step(system, from, s * h, count);
                    if let Some((index, part, y)) = ends.land(system.boundaries(), anew) {
                        return ended(t + part * h, y, StopReason::Boundary(index));
                    }
                }
            }
            (t, y, f) = (t_next, y_next, f_next);
        }
    }
}

fn step<const N: usize>(
    system: &impl System<N>,
    Point { y, f }: Point<'_, N>,
    h: f64,
    count: &mut Count,
) -> [f64; N] {
    let shifted = |k: &[f64; N], h: f64| std::array::from_fn(|i| y[i] + h * k[i]);
    let k2 = system.rate(&shifted(f, 0.5 * h));
    let k3 = system.rate(&shifted(&k2, 0.5 * h));
    let k4 = system.rate(&shifted(&k3, h));
    count.evaluations += 3;
    std::array::from_fn(|i| y[i] + h / 6.0 * (f[i] + 2.0 * (k2[i] + k3[i]) + k4[i]))
}

#[cfg(test)]
mod tests {
    use super::super::tests::{BELL, Bell};
    use super::*;

    #[test]
    fn observed_order_is_four_and_each_step_costs_four() {
        let error = |steps: usize| {
            let h = 1.0 / steps as f64;
            let mut count = Count::up_to(10_000);
            let bell = Bell::up_to(1.0 - 0.5 * h);
            let method = Rk4 { step: h, crossing: Crossing::Notice };
            let end = method.integrate(&bell, BELL, &mut count);
            assert_eq!((count.steps, count.evaluations), (steps, 4 * steps + 1));
            (end.y[0] - 0.5).abs()
        };
        let order = (error(16) / error(64)).log2() / 2.0;
        assert!((order - 4.0).abs() < 0.3, "{order}");
    }
}
