//! Event location: the first sign change of the event functions on a step, from positive to negative.

use crate::numerics::maximum;
use crate::numerics::root::bracketed_root;
use crate::numerics::{larger, smaller};

/// Number of equal subintervals of a step; the event functions are sampled at their ends.
pub(crate) const CELLS: usize = 16;
/// Threshold for a minimum between sampling points, relative to the smallest of three samples. If the parabola through the samples falls
/// below it, the minimum is located and checked for two sign changes. A step is smooth: the parabola is accurate to this fraction.
const DEEP: f64 = 0.25;

/// Result of the search for a sign change of the event functions on a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum EventSearch {
    /// No sign change.
    Nothing,
    /// Index of the event function with the first sign change, and the fraction of the step at which it occurs.
    Fall(usize, f64),
    /// Event function that starts at zero and is negative at the first sampling point; it may have changed sign twice before.
    Unresolved(usize),
}

/// Locates the first sign change, given samples of each event function and the function itself by fraction of the step and index.
///
/// An event function that starts at zero triggers only after it has been positive. With `dips`, two sign changes between samples are found,
/// too.
pub(crate) fn first_crossing(
    gaps: &[[f64; CELLS + 1]],
    dips: bool,
    gap: impl Fn(f64, usize) -> f64,
) -> EventSearch {
    let mut first: Option<(usize, f64)> = None;
    for (which, gaps) in gaps.iter().enumerate() {
        if gaps[0] <= 0.0 && gaps[1] < 0.0 {
            return EventSearch::Unresolved(which);
        }
        if let Some(place) = fall(gaps, dips, |part| gap(part, which))
            && first.is_none_or(|(_, earlier)| place < earlier)
        {
            first = Some((which, place));
        }
    }
    first.map_or(EventSearch::Nothing, |(which, place)| EventSearch::Fall(which, place))
}

/// Returns the fraction of the step at the first sign change of an event function.
fn fall(gaps: &[f64; CELLS + 1], dips: bool, gap: impl Fn(f64) -> f64) -> Option<f64> {
    let end = |cell: usize| cell as f64 / CELLS as f64;
    (1..=CELLS).find_map(|cell| {
        let (before, here) = (gaps[cell - 1], gaps[cell]);
        if dips && cell > 1 && is_deep([gaps[cell - 2], before, here]) {
            let bottom = maximum::in_bracket(end(cell - 2), end(cell), &|part| -gap(part));
            if gap(bottom) < 0.0 {
                return Some(bracketed_root(end(cell - 2), bottom, &gap));
            }
        }
        let falls = before > 0.0 && here <= 0.0;
        falls.then(|| bracketed_root(end(cell - 1), end(cell), &gap))
    })
}

/// Returns `true` if the parabola through three positive samples has a minimum near or below zero between the outer two.
fn is_deep([a, b, c]: [f64; 3]) -> bool {
    let (bend, slope) = (a - 2.0 * b + c, 0.5 * (c - a));
    let (least, lowest) = (smaller(smaller(a, b), c), b - 0.5 * slope * slope / bend);
    // A function that starts at zero, apart from the rounding of the step, is positive at the first sampling point.
    let rounding = f64::EPSILON * larger(larger(a, b), c);
    least > rounding && slope.abs() < bend && (lowest < DEEP * least || b < DEEP * smaller(a, c))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn find(gap: impl Fn(f64) -> f64) -> EventSearch {
        of_all(&[gap])
    }

    fn of_all<const N: usize>(gaps: &[impl Fn(f64) -> f64; N]) -> EventSearch {
        let at_ends =
            gaps.each_ref().map(|gap| std::array::from_fn(|end| gap(end as f64 / CELLS as f64)));
        first_crossing(&at_ends, true, |part, which| gaps[which](part))
    }

    fn is_at(found: EventSearch, exact: f64) -> bool {
        matches!(found, EventSearch::Fall(0, at) if (at - exact).abs() < 1e-14)
    }

    #[test]
    fn a_fall_is_found_to_rounding_and_a_rise_is_none() {
        assert!(is_at(find(|t| 0.3 - t), 0.3));
        assert!(is_at(find(|t| 1.0 - t), 1.0));
        assert!(is_at(find(|t| 0.01 - t), 0.01));
        assert_eq!(find(|t| t), EventSearch::Nothing);
        assert_eq!(find(|t| 1.1 - t), EventSearch::Nothing);
    }

    #[test]
    fn a_gap_that_begins_at_zero_has_to_rise_before_it_falls() {
        assert!(is_at(find(|t| t * (0.5 - t)), 0.5));
        assert_eq!(find(|t| -t), EventSearch::Unresolved(0));
        assert_eq!(find(|t| t * (0.01 - t)), EventSearch::Unresolved(0));
    }

    #[test]
    fn a_dip_between_two_looks_is_found() {
        // 0.53 is between 8/16 and 9/16, 0.03 before 1/16, 0.97 beyond 15/16.
        for dip in [0.03, 0.53, 0.97] {
            assert!(is_at(find(|t| (t - dip).powi(2) - 1e-6), dip - 1e-3), "{dip}");
            assert_eq!(find(|t| (t - dip).powi(2) + 1e-6), EventSearch::Nothing);
        }
        // The parabola's bottom is beside that of a gap that bends more on one side.
        let found = find(|t| (t - 0.53).powi(2) * (1.0 + 9.0 * t) - 1e-9);
        assert!(matches!(found, EventSearch::Fall(0, at) if (at - 0.53).abs() < 1e-4), "{found:?}");
    }

    /// Near the start of a step its polynomials have the rounding error of the values at its end.
    #[test]
    fn rounding_at_the_start_is_no_dip() {
        let off = |t: f64| if t > 0.0 && t < 1e-6 { -1e-17 } else { 1e-20 };
        assert_eq!(find(|t| t * t * t + off(t)), EventSearch::Nothing);
    }

    #[test]
    fn of_several_gaps_the_first_to_fall_counts() {
        let found = of_all(&[0.52, 0.51, 0.9].map(|end| move |t| end - t));
        assert!(
            matches!(found, EventSearch::Fall(1, at) if (at - 0.51).abs() < 1e-14),
            "{found:?}"
        );
    }
}
