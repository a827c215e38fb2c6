//! A sweep in a few numbers, gathered as it goes by: how its points ended, and where each output is least and greatest.

use crate::study::sweep::{Fate, Rows};

/// The least and the greatest value of an output and the points where they were found first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremes {
    /// Least value and its point.
    pub least: (f64, u64),
    /// Greatest value and its point.
    pub greatest: (f64, u64),
}

/// What a sweep came to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Summary {
    /// Points that were arrested, perforated, separated, left moving, failed.
    pub census: [u64; 5],
    /// Of each output, where it has any value; perforations and points without an end do not count.
    pub extremes: Vec<Option<Extremes>>,
}

/// The words for [`Summary::census`].
pub const CENSUS_WORDS: [&str; 5] =
    ["arrested", "perforated", "separated", "still moving at the horizon", "failed"];

impl Summary {
    /// Of a sweep with so many outputs.
    pub fn new(outputs: usize) -> Self {
        Self { census: [0; 5], extremes: vec![None; outputs] }
    }

    /// How many points have gone by.
    pub fn points(&self) -> u64 {
        self.census.iter().sum()
    }

    /// How many failed.
    pub fn failed(&self) -> u64 {
        self.census[4]
    }

    /// Add rows, the first of which is point `first`.
    pub fn add(&mut self, first: u64, rows: &Rows) {
        for (row, point) in (0..rows.len()).zip(first..) {
            self.count(rows.fate(row));
            for output in 0..self.extremes.len() {
                let told = matches!(rows.fate(row), Fate::Arrested | Fate::Separated);
                if let Some(value) = rows.value(row, output).filter(|_| told) {
                    self.consider(output, value, point);
                }
            }
        }
    }

    fn count(&mut self, fate: Fate) {
        self.census[match fate {
            Fate::Arrested => 0,
            Fate::Perforated => 1,
            Fate::Separated => 2,
            Fate::Moving => 3,
            Fate::Failed(_) => 4,
        }] += 1;
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

    /// How the points ended, in words.
    pub fn words(&self) -> String {
        let parts = self.census.iter().zip(CENSUS_WORDS).filter(|(count, _)| **count > 0);
        let parts: Vec<String> = parts.map(|(count, word)| format!("{count} {word}")).collect();
        if parts.is_empty() { "no point".to_owned() } else { parts.join(", ") }
    }
}
