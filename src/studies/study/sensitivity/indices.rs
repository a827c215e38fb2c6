//! Sobol's indices of any function of the unit cube: how much of its variance each input explains alone, and with all its
//! interactions.
//!
//! A. Saltelli et al., *Computer Physics Communications* 181 (2010) 259-270: two independent designs A and B, and for every
//! input a design that is A with the column of B. First order after that paper's table 2 (b), total after Jansen (f).
//! Confidence intervals by bootstrap over the rows. The designs are the halves of one Sobol sequence.

use crate::numerics::random::Random;
use crate::numerics::sobol;
use crate::study::monte_carlo::Estimate;
use crate::study::sensitivity::Function;

/// The most inputs.
pub const INPUTS_MAX: usize = sobol::DIMENSIONS / 2;
const RESAMPLINGS: usize = 400;
const BATCH: usize = 1024;

/// The indices of one input, 0 to 1 up to their error, each with what encloses 95 % of its resampled estimates; `None` where the function does not vary or has too few values.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Indices {
    /// Part of the variance the input explains alone.
    pub first: Option<Estimate>,
    /// Part of the variance that goes with the input, interactions included.
    pub total: Option<Estimate>,
}

/// Its outcome.
#[derive(Clone, Debug, PartialEq)]
pub struct Sobol {
    /// The indices, input by input.
    pub inputs: Vec<Indices>,
    /// Mean of the function.
    pub mean: f64,
    /// Variance of the function.
    pub variance: f64,
    /// Rows of the design.
    pub rows: usize,
    /// Rows that were used: the others have a point without a value.
    pub used: usize,
}

/// A row of the designs: the function's values at A and B, and for each input what A with its column of B adds to the sums.
#[derive(Clone, Copy)]
struct Row {
    a: f64,
    b: f64,
    /// The difference to A, and half of its square.
    mixed: [(f64, f64); INPUTS_MAX],
}

impl Row {
    /// Of the values of its points; `None` where one is missing.
    fn of(values: &[f64]) -> Option<Self> {
        let [a, b, rest @ ..] = values else { return None };
        let mut mixed = [(0.0, 0.0); INPUTS_MAX];
        for (own, value) in mixed.iter_mut().zip(rest) {
            *own = (value - a, 0.5 * (a - value).powi(2));
        }
        values.iter().all(|value| value.is_finite()).then_some(Self { a: *a, b: *b, mixed })
    }
}

/// First and total index of every input over some rows, and mean and variance; the indices are not finite where the variance is zero.
fn estimate(rows: &[Row]) -> ([[f64; 2]; INPUTS_MAX], f64, f64) {
    let count = rows.len() as f64;
    let (mut sum, mut squares) = (0.0, 0.0);
    // Shifted by a value, so that a small variance does not drown in a great mean.
    let origin = rows[0].a;
    for value in rows.iter().flat_map(|row| [row.a, row.b]) {
        sum += value - origin;
        squares += (value - origin).powi(2);
    }
    let shift = sum / (2.0 * count);
    let (mean, variance) = (origin + shift, squares / (2.0 * count) - shift * shift);
    let mut found = [[0.0; 2]; INPUTS_MAX];
    for row in rows {
        for ([first, total], (difference, half_square)) in found.iter_mut().zip(row.mixed) {
            *first += (row.b - mean) * difference;
            *total += half_square;
        }
    }
    for index in found.iter_mut().flatten() {
        *index /= count * variance;
    }
    (found, mean, variance)
}

/// The indices of a function of a given number of inputs (1 to [`INPUTS_MAX`]) from a given number of rows, each of which costs two evaluations
/// and one an input. `None` when the function was stopped.
pub fn sobol(inputs: usize, rows: usize, seed: u64, function: Function<'_>) -> Option<Sobol> {
    let mut all = Vec::with_capacity(rows);
    let mut next = 0;
    while next < rows {
        let until = if next + BATCH < rows { next + BATCH } else { rows };
        let points: Vec<Vec<f64>> =
            (next..until).flat_map(|row| designs(inputs, row, seed)).collect();
        let values = function(&points)?;
        all.extend(values.chunks(inputs + 2).filter_map(Row::of));
        next = until;
    }
    let used = all.len();
    let mut result = Sobol {
        inputs: vec![Indices::default(); inputs],
        mean: f64::NAN,
        variance: f64::NAN,
        rows,
        used,
    };
    if used < 2 {
        return Some(result);
    }
    let (found, mean, variance) = estimate(&all);
    (result.mean, result.variance) = (mean, variance);
    // Rounding is all the variance there is.
    if variance <= 1e-24 * mean * mean {
        return Some(result);
    }
    let resampled = bootstrap(&all, seed);
    for (input, indices) in result.inputs.iter_mut().enumerate() {
        let index = |order: usize| {
            let samples = resampled.iter().map(|sample| sample[input][order]).collect();
            let (low_95, high_95) = range95(samples);
            Estimate { value: found[input][order], low_95, high_95 }
        };
        *indices = Indices { first: Some(index(0)), total: Some(index(1)) };
    }
    Some(result)
}

/// The points of one of the rows: A, B, and A with each column of B.
fn designs(inputs: usize, row: usize, seed: u64) -> Vec<Vec<f64>> {
    let column = |axis: usize| sobol::share(row as u64, axis, seed);
    let a: Vec<f64> = (0..inputs).map(column).collect();
    let b: Vec<f64> = (inputs..2 * inputs).map(column).collect();
    let mixed = (0..inputs).map(|input| {
        let mut point = a.clone();
        point[input] = b[input];
        point
    });
    let mixed: Vec<Vec<f64>> = mixed.collect();
    [a, b].into_iter().chain(mixed).collect()
}

fn bootstrap(rows: &[Row], seed: u64) -> Vec<[[f64; 2]; INPUTS_MAX]> {
    let mut random = Random::new(seed);
    let mut picked = rows.to_vec();
    let mut sample = || {
        picked.fill_with(|| rows[random.below(rows.len())]);
        estimate(&picked).0
    };
    (0..RESAMPLINGS).map(|_| sample()).collect()
}

fn range95(mut values: Vec<f64>) -> (f64, f64) {
    values.sort_by(f64::total_cmp);
    let cut = values.len() / 40;
    (values[cut], values[values.len() - 1 - cut])
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    /// Ishigami and Homma's function with a = 7, b = 0.1.
    fn ishigami(point: &[f64]) -> f64 {
        let x: Vec<f64> = point.iter().map(|share| PI * (2.0 * share - 1.0)).collect();
        x[0].sin() + 7.0 * x[1].sin().powi(2) + 0.1 * x[2].powi(4) * x[0].sin()
    }

    fn indices(inputs: usize, rows: usize, seed: u64, f: fn(&[f64]) -> f64) -> Sobol {
        let function: Function<'_> = &mut |points| Some(points.iter().map(|x| f(x)).collect());
        sobol(inputs, rows, seed, function).unwrap()
    }

    #[test]
    fn valid_indices_of_ishigamis_function() {
        let first = [0.313_9, 0.442_4, 0.0];
        let total = [0.557_6, 0.442_4, 0.243_7];
        for seed in [1, 2, 3] {
            let found = indices(3, 8192, seed, ishigami);
            assert!((found.mean - 3.5).abs() < 0.01, "{}", found.mean);
            // a²/8 + b pi⁴/5 + b² pi⁸/18 + 1/2
            assert!((found.variance - 13.844_588).abs() < 0.05, "{}", found.variance);
            for (input, indices) in found.inputs.iter().enumerate() {
                for (index, exact) in [(indices.first, first[input]), (indices.total, total[input])]
                {
                    let index = index.unwrap();
                    assert!((index.value - exact).abs() < 0.01, "{seed} {input} {index:?} {exact}");
                    let Estimate { low_95: low, high_95: high, .. } = index;
                    assert!(low - 0.01 < exact && exact < high + 0.01, "{input} {index:?}");
                    assert!(low <= index.value && index.value <= high && high - low < 0.2);
                }
            }
        }
    }

    /// Of the sum of i times input i the index of input i is i² over the sum of all squares, 650: alone and in total.
    #[test]
    fn valid_indices_of_as_many_inputs_as_there_may_be() {
        let sum = |point: &[f64]| point.iter().zip(1..).map(|(x, i)| x * f64::from(i)).sum();
        let found = indices(INPUTS_MAX, 8192, 1, sum);
        for (input, i) in found.inputs.iter().zip(1..) {
            let exact = f64::from(i * i) / 650.0;
            for index in [input.first, input.total] {
                let index = index.unwrap();
                assert!((index.value - exact).abs() < 0.02, "{i}: {index:?}, {exact}");
            }
        }
    }

    #[test]
    fn intervals_narrow_with_the_root_of_the_rows_and_a_seed_gives_its_digits() {
        let width = |rows: usize| {
            let first = indices(3, rows, 5, ishigami).inputs[0].first.unwrap();
            first.high_95 - first.low_95
        };
        let ratio = width(512) / width(8192);
        assert!((2.5..6.5).contains(&ratio), "{ratio}");
        assert_eq!(indices(3, 512, 5, ishigami), indices(3, 512, 5, ishigami));
        assert_ne!(indices(3, 512, 5, ishigami), indices(3, 512, 6, ishigami));
    }

    #[test]
    fn a_constant_result_has_no_indices_and_missing_values_are_counted() {
        let flat = indices(2, 64, 1, |_| 0.1);
        assert!(flat.inputs.iter().all(|input| input.first.is_none() && input.total.is_none()));
        let holes = indices(2, 256, 1, |x| if x[0] > 0.9 { f64::NAN } else { x[1] });
        assert_eq!(holes.rows, 256);
        assert!((150..256).contains(&holes.used), "{}", holes.used);
        assert!((holes.inputs[1].first.unwrap().value - 1.0).abs() < 0.1);
        assert!(holes.inputs[0].total.unwrap().value.abs() < 1e-12);
        assert!(sobol(2, 8, 1, &mut |_| None).is_none());
    }
}
