//! Events on a step: where a function of the state goes from positive to negative.
//!
//! The sign change is located on the step's dense output and then landed on by new steps from the same start, so that the state
//! there has the full order of the method. Knows no method and no system.

use crate::numerics::root::in_bracket;

/// New steps after which the best so far has to do.
const STEPS_MAX: usize = 40;
/// Part of its place by which the slope of a function there is taken on the dense output.
const SLOPE: f64 = 1e-4;

/// Where a function changes its sign on a step, by the dense output.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SignChange {
    pub(crate) part: f64,
    /// Parts on either side: the last at which it is known to be positive, the first at which it is not.
    pub(crate) between: (f64, f64),
}

/// The first sign change of a function that is positive at the start of a step, by samples (part and value) in their order. `at`
/// is the function on the dense output.
pub(crate) fn first_sign_change(
    samples: impl IntoIterator<Item = (f64, f64)>,
    at: impl FnMut(f64) -> f64,
) -> Option<SignChange> {
    let mut low = 0.0;
    for (high, value) in samples {
        if value <= 0.0 {
            return Some(SignChange { part: in_bracket(low, high, at), between: (low, high) });
        }
        low = high;
    }
    None
}

/// A new step that ends at a sign change, with the part of the step; `None` where no step ends closer to it than `near` allows.
/// Secants, the first with the slope of the dense output, kept in the bracket by bisection.
///
/// `dense` is the state at a part of the step by its dense output; `anew` takes a step from the same start to that part, and gives
/// the state at its end, or nothing where the method finds no step.
pub(crate) fn land<State, Step>(
    sign_change: &SignChange,
    dense: impl Fn(f64) -> State,
    mut anew: impl FnMut(f64) -> Option<(State, Step)>,
    value: impl Fn(&State) -> f64,
    near: impl Fn(&State) -> f64,
) -> Option<(f64, Step)> {
    let SignChange { part: mut s, between: (mut low, mut high) } = *sign_change;
    let shown = |part: f64| value(&dense(part));
    let mut slope = (shown(s) - shown(s * (1.0 - SLOPE))) / (s * SLOPE);
    let mut best: Option<Landing<Step>> = None;
    let mut last = None;
    for _ in 0..STEPS_MAX {
        let step = anew(s);
        let distance = step.as_ref().map_or_else(|| shown(s), |(end, _)| value(end));
        if let Some((part, at_part)) = last.replace((s, distance)) {
            slope = (distance - at_part) / (s - part);
        }
        let improves = best.as_ref().is_none_or(|best| distance.abs() < best.distance);
        if let Some((end, step)) = step.filter(|_| improves) {
            let is_near = distance.abs() <= near(&end);
            best = Some(Landing { part: s, distance: distance.abs(), is_near, step });
        }
        if distance > 0.0 {
            low = s;
        } else {
            high = s;
        }
        let secant = s - distance / slope;
        let next = if secant > low && secant < high { secant } else { 0.5 * (low + high) };
        let is_found = !improves && best.as_ref().is_some_and(|best| best.is_near);
        if distance == 0.0 || is_found || (next - s).abs() <= 2.0 * f64::EPSILON * s {
            break;
        }
        s = next;
    }
    best.filter(|best| best.is_near).map(|best| (best.part, best.step))
}

/// A step that ends close to a sign change.
struct Landing<S> {
    part: f64,
    distance: f64,
    is_near: bool,
    step: S,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A height (s - 1/2)² - depth above a plane, known to the dense output only up to an error.
    struct Dip {
        depth: f64,
        error: f64,
        exists: bool,
    }

    impl Dip {
        fn dense(&self, part: f64) -> f64 {
            self.exact(part) + self.error * part * (1.0 - part)
        }

        fn exact(&self, part: f64) -> f64 {
            (part - 0.5) * (part - 0.5) - self.depth
        }
    }

    fn found(dip: &Dip, parts: &[f64]) -> Option<f64> {
        let samples = parts.iter().map(|part| (*part, dip.dense(*part)));
        let found = first_sign_change(samples, |part| dip.dense(part))?;
        let anew = |part| dip.exists.then(|| (dip.exact(part), ()));
        land(&found, |part| dip.dense(part), anew, |height| *height, |_| 1e-9)
            .map(|(part, ())| part)
    }

    #[test]
    fn a_sign_change_is_located_by_new_steps_despite_errors_of_the_dense_output() {
        for error in [0.0, 1e-3, -1e-3, 0.05] {
            let dip = Dip { depth: 0.04, error, exists: true };
            let part = found(&dip, &[0.5, 1.0]).unwrap();
            assert!((part - 0.3).abs() < 1e-15, "{error}: {part}");
        }
    }

    #[test]
    fn a_sign_change_between_two_samples_is_not_seen_and_one_that_is_only_near_is_not_landed_on() {
        let dip = Dip { depth: 0.04, error: 0.0, exists: true };
        assert_eq!(found(&dip, &[1.0]), None);
        // The dense output touches the plane, the steps do not.
        let above = Dip { depth: -1e-3, error: -0.01, exists: true };
        assert!(above.dense(0.5) < 0.0);
        assert_eq!(found(&above, &[0.5, 1.0]), None);
        let none = Dip { depth: 0.04, error: 0.0, exists: false };
        assert_eq!(found(&none, &[0.5]), None);
    }
}
