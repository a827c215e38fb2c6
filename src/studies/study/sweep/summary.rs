//! A sweep in a few numbers, gathered as it goes by: the outcomes of its points, and the minimum and maximum of each output.

use std::fmt;

use crate::model::run::Outcome;
use crate::study::quantities::Quantity;
use crate::study::sweep::{PointOutcome, Rows};

/// The least and the greatest value of an output and the points where they were found first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremes {
    /// Least value and its point.
    pub least: (f64, u64),
    /// Greatest value and its point.
    pub greatest: (f64, u64),
}

/// The result of a sweep.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Summary {
    /// How the points ended.
    pub outcomes: OutcomeCounts,
    /// Of each output, where it has any value that counts; see [`PointOutcome::counts`].
    pub extremes: Vec<Option<Extremes>>,
    outputs: Vec<&'static Quantity>,
}

/// How many points ended how.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct OutcomeCounts {
    ended: [u64; Outcome::ALL.len()],
    /// There is no result.
    pub failed: u64,
}

impl OutcomeCounts {
    /// Count a point.
    pub fn add(&mut self, outcome: PointOutcome) {
        *match outcome {
            PointOutcome::Ended(outcome) => &mut self.ended[outcome as usize],
            PointOutcome::Failed(_) => &mut self.failed,
        } += 1;
    }

    /// How many shots ended like this.
    pub fn of(self, outcome: Outcome) -> u64 {
        self.ended[outcome as usize]
    }

    /// All points.
    pub fn total(self) -> u64 {
        self.each().map(|(_, count)| count).sum()
    }

    /// Each count with its word, those of no point among them.
    pub fn each(self) -> impl Iterator<Item = (&'static str, u64)> {
        Outcome::WORDS.into_iter().zip(self.ended).chain([("failed", self.failed)])
    }
}

impl fmt::Display for OutcomeCounts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let known = self.each().filter(|(_, count)| *count > 0);
        let parts: Vec<String> = known.map(|(word, count)| format!("{count} {word}")).collect();
        f.write_str(if parts.is_empty() { "no point" } else { "" })?;
        f.write_str(&parts.join(", "))
    }
}

impl Summary {
    /// Of a sweep with these outputs.
    pub fn new(outputs: &[&'static Quantity]) -> Self {
        let outcomes = OutcomeCounts::default();
        Self { outcomes, extremes: vec![None; outputs.len()], outputs: outputs.to_vec() }
    }

    /// How many points have gone by.
    pub fn points(&self) -> u64 {
        self.outcomes.total()
    }

    /// Add rows, which show these points.
    pub fn add(&mut self, points: impl Iterator<Item = u64>, rows: &Rows) {
        for (row, point) in (0..rows.len()).zip(points) {
            let outcome = rows.outcome(row);
            self.outcomes.add(outcome);
            for output in 0..self.outputs.len() {
                let value = rows.value(row, output);
                if let Some(value) = value.filter(|_| outcome.counts(self.outputs[output])) {
                    self.consider(output, value, point);
                }
            }
        }
    }

    fn consider(&mut self, output: usize, value: f64, point: u64) {
        let here = (value, point);
        let extremes =
            self.extremes[output].get_or_insert(Extremes { least: here, greatest: here });
        if value < extremes.least.0 {
            extremes.least = here;
        }
        if value > extremes.greatest.0 {
            extremes.greatest = here;
        }
    }
}
