//! Claims about how far one variable moves a result while another is held: ranges, and what is said of them.

use crate::study::thesis::Found;
use crate::study::thesis::lab::{Axis, Lab, Law, Measure, both, number, trend_verdict, with};
use crate::study::thesis::shape::range;

/// Ranges of a measure along `axis`, one for each value of another variable.
pub(super) fn ranges<const M: usize>(
    (lab, law, measure): (&Lab, Law, Measure),
    fixed: &[(&str, f64)],
    axis: Axis,
    (name, values): (&'static str, [f64; M]),
) -> [f64; M] {
    values.map(|value| {
        let mut changes = fixed.to_vec();
        changes.push((name, value));
        range(&lab.curve(law, measure, &with(&changes), axis))
    })
}

/// Whether values rise, or fall, one after the other.
pub(super) fn rising(values: &[f64]) -> bool {
    values.windows(2).all(|pair| pair[1] > pair[0])
}

pub(super) fn falling(values: &[f64]) -> bool {
    values.windows(2).all(|pair| pair[1] < pair[0])
}

pub(super) fn list(values: &[f64], unit: &str) -> String {
    let words: Vec<String> = values.iter().map(|value| number(*value)).collect();
    format!("{} {unit}", words.join(", "))
}

/// A claim on ranges: told for both laws, judged by the sound one.
pub(super) fn judged<const M: usize>(
    what: &str,
    unit: &str,
    values: [[f64; M]; 2],
    property: impl Fn(&[f64]) -> bool,
    cause: &'static str,
) -> Found {
    let told = |values: &[f64; M]| format!("{what}: {}", list(values, unit));
    both(told(&values[0]), told(&values[1]), trend_verdict(property(&values[0])), cause)
}

/// A claim that the first of two ranges is the greater.
pub(super) fn greater(what: &str, values: [[f64; 2]; 2], cause: &'static str) -> Found {
    judged(what, "%", values, |pair| pair[0] > pair[1], cause)
}
