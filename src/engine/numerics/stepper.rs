//! One-step methods that end where something happens: classical Runge-Kutta with a fixed step, and DOP853 with step control.
//!
//! A `System` gives rates and names `Boundary`s: planes in its space at which a stretch of smooth motion ends. A boundary
//! is found on the interpolant of the step that crosses it, and then *landed on* by stepping again from the step's start, so
//! that the state there has the full order of the method. The caller decides what follows, and starts the next
//! stretch. Fixed-size arrays, no allocation, every loop bounded. Must not know what it integrates.

pub mod dop853;
mod landing;
pub mod rk4;

/// A one-step method for systems of N components of the kind S.
pub trait Stepper<const N: usize, S> {
    /// Integrates from `start` until a boundary of the system or a limit, and counts its work.
    fn integrate(&self, system: &S, start: Start<N>, count: &mut Count) -> Reached<N>;

    /// Whether it lands on boundaries, or only notices them after the step that crossed them.
    fn lands(&self) -> bool {
        true
    }
}

/// A system y' = f(y) of N components.
pub(crate) trait System<const N: usize> {
    fn rate(&self, y: &[f64; N]) -> [f64; N];

    /// Where the present stretch ends; nowhere by default.
    fn boundaries(&self) -> &[Boundary<N>] {
        &[]
    }
}

/// A plane: the stretch ends where `offset + slope . y` falls to zero.
///
/// One that is not positive at the start of a step does not count in it, so that one just landed on does not fire again.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Boundary<const N: usize> {
    pub(crate) offset: f64,
    pub(crate) slope: [f64; N],
}

impl<const N: usize> Boundary<N> {
    /// Distance from the plane, in its own measure; the stretch lies on the positive side.
    pub(crate) fn at(&self, y: &[f64; N]) -> f64 {
        self.offset + self.along(y)
    }

    /// How fast that changes with the rate `f`.
    pub(crate) fn along(&self, f: &[f64; N]) -> f64 {
        let mut sum = 0.0;
        for (slope, f) in self.slope.iter().zip(f) {
            sum += slope * f;
        }
        sum
    }

    /// Whether a state is on its positive side, by more than the rounding of one just landed on.
    pub(crate) fn is_armed(&self, y: &[f64; N]) -> bool {
        self.at(y) > 2.0 * self.noise(y)
    }

    /// The size below which the distance is rounding.
    fn noise(&self, y: &[f64; N]) -> f64 {
        let mut size = self.offset.abs();
        for (slope, y) in self.slope.iter().zip(y) {
            size += (slope * y).abs();
        }
        2.0 * f64::EPSILON * size
    }
}

/// Where a stretch begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start<const N: usize> {
    pub(crate) t: f64,
    pub(crate) y: [f64; N],
    /// Step to try first; `None`: chosen from the rates. The fixed-step method does not look at it.
    pub(crate) step: Option<f64>,
}

/// State and rate where a step begins.
#[derive(Clone, Copy)]
struct Point<'a, const N: usize> {
    y: &'a [f64; N],
    f: &'a [f64; N],
}

/// The work done, over all stretches it was passed to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Count {
    pub(crate) steps: usize,
    pub(crate) rejected: usize,
    pub(crate) evaluations: usize,
    /// Steps, accepted and rejected, after which it is given up.
    most: usize,
}

impl Count {
    /// Nothing done yet of so many steps.
    pub(crate) fn up_to(most: usize) -> Self {
        Self { steps: 0, rejected: 0, evaluations: 0, most }
    }

    /// Why a step of the length `h` cannot be taken from the time `t`, if so.
    pub(crate) fn forbids(&self, t: f64, h: f64) -> Option<StopReason> {
        if self.steps + self.rejected >= self.most {
            return Some(StopReason::StepBudget);
        }
        // So is a length that is not a number.
        (!(t + h > t && h.is_finite())).then_some(StopReason::StepUnderflow)
    }
}

/// Why a stretch ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopReason {
    /// At the boundary of this index.
    Boundary(usize),
    /// The steps allowed are used up.
    StepBudget,
    /// Steps are too small to move time.
    StepUnderflow,
    /// A value is not finite.
    NonFinite,
}

/// The end of a stretch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reached<const N: usize> {
    pub(crate) t: f64,
    pub(crate) y: [f64; N],
    pub(crate) stop: StopReason,
    /// The step that would have been tried next.
    pub(crate) step: f64,
}

fn is_finite<const N: usize>(y: &[f64; N]) -> bool {
    y.iter().all(|y| y.is_finite())
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::dop853::Dop853;
    use super::rk4::{Crossing, Rk4};
    use super::*;

    /// y'' = -y as (y, y'), with a count of its evaluations and the planes to stop at.
    struct Oscillator {
        calls: Cell<usize>,
        planes: Vec<Boundary<2>>,
    }

    impl System<2> for Oscillator {
        fn rate(&self, y: &[f64; 2]) -> [f64; 2] {
            self.calls.set(self.calls.get() + 1);
            [y[1], -y[0]]
        }
        fn boundaries(&self) -> &[Boundary<2>] {
            &self.planes
        }
    }

    fn oscillator(planes: &[Boundary<2>]) -> Oscillator {
        Oscillator { calls: Cell::new(0), planes: planes.to_vec() }
    }

    const HALF: Boundary<2> = Boundary { offset: -0.5, slope: [1.0, 0.0] };
    const START: Start<2> = Start { t: 0.0, y: [1.0, 0.0], step: None };

    fn many() -> Count {
        Count::up_to(100_000)
    }

    /// y' = -2 t y², solution 1/(1 + t²), as (y, t) up to some t.
    pub(super) struct Bell([Boundary<2>; 1]);

    pub(super) const BELL: Start<2> = Start { t: 0.0, y: [1.0, 0.0], step: None };

    impl Bell {
        pub(super) fn up_to(t: f64) -> Self {
            Self([Boundary { offset: t, slope: [0.0, -1.0] }])
        }
    }

    impl System<2> for Bell {
        fn rate(&self, y: &[f64; 2]) -> [f64; 2] {
            [-2.0 * y[1] * y[0] * y[0], 1.0]
        }
        fn boundaries(&self) -> &[Boundary<2>] {
            &self.0
        }
    }

    #[test]
    fn a_boundary_is_landed_on_with_the_full_order() {
        let exact = std::f64::consts::FRAC_PI_3;
        for tolerance in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
            let (system, mut count) = (oscillator(&[HALF]), many());
            let end = Dop853 { tolerance }.integrate(&system, START, &mut count);
            assert_eq!(end.stop, StopReason::Boundary(0));
            assert!((end.y[0] - 0.5).abs() < 1e-15, "{tolerance}");
            assert!(
                (end.t - exact).abs() < 10.0 * tolerance + 1e-15,
                "{tolerance}: {}",
                end.t - exact
            );
            assert_eq!(count.evaluations, system.calls.get());
        }
        let error = |h: f64| {
            let mut count = many();
            let system = oscillator(&[HALF]);
            let end =
                Rk4 { step: h, crossing: Crossing::Locate }.integrate(&system, START, &mut count);
            assert_eq!(end.stop, StopReason::Boundary(0));
            assert_eq!(count.evaluations, system.calls.get());
            (end.t - exact).abs()
        };
        // Steps of different length at the end, so over a range: four halvings.
        let order = (error(0.2) / error(0.2 / 16.0)).log2() / 4.0;
        assert!((order - 4.0).abs() < 0.3, "{order}");
    }

    #[test]
    fn without_location_the_stretch_ends_with_the_step_that_crossed() {
        let (system, mut count) = (oscillator(&[HALF]), many());
        let method = Rk4 { step: 0.1, crossing: Crossing::Notice };
        let end = method.integrate(&system, START, &mut count);
        assert_eq!(end.stop, StopReason::Boundary(0));
        assert!((end.t - 1.1).abs() < 1e-15);
    }

    #[test]
    fn the_nearest_of_several_boundaries_counts_and_one_just_left_does_not() {
        let earlier = Boundary { offset: -0.8, slope: [1.0, 0.0] };
        let (system, mut count) = (oscillator(&[HALF, earlier]), many());
        let end = Dop853 { tolerance: 1e-10 }.integrate(&system, START, &mut count);
        assert_eq!(end.stop, StopReason::Boundary(1));
        let again = Start { t: end.t, y: end.y, step: Some(end.step) };
        let end = Dop853 { tolerance: 1e-10 }.integrate(&system, again, &mut count);
        assert_eq!(end.stop, StopReason::Boundary(0));
        assert!((end.t - std::f64::consts::FRAC_PI_3).abs() < 1e-9);
    }

    #[test]
    fn a_dip_within_one_step_is_not_stepped_over() {
        // y falls from 1 to its least value -1 at pi; a plane at -0.99 is crossed twice within 0.3.
        let plane = Boundary { offset: 0.99, slope: [1.0, 0.0] };
        let (system, mut count) = (oscillator(&[plane]), many());
        let end = Dop853 { tolerance: 1e-3 }.integrate(&system, START, &mut count);
        assert_eq!(end.stop, StopReason::Boundary(0));
        assert!((end.t - (-0.99f64).acos()).abs() < 0.03, "{}", end.t);
    }

    struct Cliff;

    impl System<1> for Cliff {
        fn rate(&self, y: &[f64; 1]) -> [f64; 1] {
            [if y[0] > 1.0 { f64::NAN } else { 1.0 }]
        }
    }

    /// A rate that oscillates 1e9 times a second.
    struct Fast;

    impl System<2> for Fast {
        fn rate(&self, y: &[f64; 2]) -> [f64; 2] {
            [1e9 * y[1], -1e9 * y[0]]
        }
    }

    #[test]
    fn nan_budget_and_underflow_are_reported() {
        let start = Start { t: 0.0, y: [0.0], step: None };
        let dop853 = Dop853 { tolerance: 1e-6 };
        let end = dop853.integrate(&Cliff, start, &mut many());
        assert_eq!(end.stop, StopReason::NonFinite);
        assert!(end.y[0] <= 1.0 && end.y[0] > 0.999, "{}", end.y[0]);
        let rk4 = |step| Rk4 { step, crossing: Crossing::Locate };
        let end = rk4(0.1).integrate(&Cliff, start, &mut many());
        assert_eq!(end.stop, StopReason::NonFinite);
        assert!(end.y[0] <= 1.0);

        let mut count = Count::up_to(500);
        let end = dop853.integrate(&Fast, START, &mut count);
        assert_eq!(end.stop, StopReason::StepBudget);
        assert_eq!(count.steps + count.rejected, 500);

        let late = Start { t: 1e9, y: [1.0, 0.0], step: None };
        let end = dop853.integrate(&Fast, late, &mut many());
        assert_eq!(end.stop, StopReason::StepUnderflow);
        let end = rk4(1e-9).integrate(&Fast, late, &mut many());
        assert_eq!(end.stop, StopReason::StepUnderflow);
    }
}
