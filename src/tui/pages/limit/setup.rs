//! The setup of V50: how uncertain the inputs and the model are, as rows that can be stepped and typed into. No drawing.

use cmra_studies::enumeration;

use crate::study::limit::monte_carlo::{ModelError, Sampling};
use crate::tui::pages::run::steps::Input;
use crate::tui::widgets::form::{FormRow, percent};

/// Number of samples, and the seed of their random numbers.
const SAMPLES: usize = 200;
const SEED: u64 = 1;

/// What arrow keys add, percent.
const STEP: f64 = 0.5;

enumeration! {
    /// A row of the setup.
    #[derive(Default)]
    pub enum Row in RowText {
        /// Its name.
        label: &'static str,
        /// Its meaning, for the message area.
        meaning: &'static str,
        /// The least and the greatest value, percent.
        ends: (f64, f64),
    }
    /// The spread of the inputs.
    #[default]
    Inputs {
        label: "inputs",
        meaning: "standard deviation of every input, for V50 and its spread",
        ends: (0.1, 50.0)
    }
    /// How far limits come out high or low.
    Bias {
        label: "model bias",
        meaning: "mean ratio of model to measurement, minus 1: -4 % where limits come out low; corrects V50",
        ends: (-99.0, 1000.0)
    }
    /// How much the model scatters about measurements.
    Spread {
        label: "model spread",
        meaning: "standard deviation of the ratio of model to measurement; widens the band of V50",
        ends: (0.0, 50.0)
    }
}

/// The uncertainties in the order of their rows, percent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setup([f64; 3]);

impl Default for Setup {
    fn default() -> Self {
        Self([2.0, 0.0, 0.0])
    }
}

impl Setup {
    pub(crate) fn line(self, row: Row) -> FormRow {
        FormRow::percent(row.label(), self.0[row as usize]).means(row.meaning())
    }

    pub(crate) fn change(&mut self, row: Row, input: Input<'_>) -> Result<(), String> {
        let (least, most) = row.ends();
        let value = &mut self.0[row as usize];
        *value = match input {
            Input::Text(text) => percent(text, least..=most)?,
            Input::Step(press) => (*value + STEP * press.by() as f64).clamp(least, most),
        };
        Ok(())
    }

    /// The request.
    pub fn sampling(self) -> Sampling {
        let [deviation, bias, spread] = self.0.map(|percent| percent / 100.0);
        Sampling { deviation, samples: SAMPLES, seed: SEED, model: ModelError { bias, spread } }
    }
}
