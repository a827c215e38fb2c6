//! The setup of V50: how uncertain the inputs and the model are, as rows that can be stepped and typed into. No drawing.

use cmra_studies::enumeration;

use crate::study::limit::monte_carlo::{ModelError, Sampling};
use crate::tui::pages::run::steps::Input;
use crate::tui::widgets::form::{Line, percent};

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

/// The uncertainties, percent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setup {
    inputs: f64,
    bias: f64,
    spread: f64,
}

impl Default for Setup {
    fn default() -> Self {
        Self { inputs: 2.0, bias: 0.0, spread: 0.0 }
    }
}

impl Setup {
    fn value(&mut self, row: Row) -> &mut f64 {
        match row {
            Row::Inputs => &mut self.inputs,
            Row::Bias => &mut self.bias,
            Row::Spread => &mut self.spread,
        }
    }

    pub(crate) fn line(mut self, row: Row) -> Line {
        Line::percent(row.label(), *self.value(row)).means(row.meaning())
    }

    pub(crate) fn change(&mut self, row: Row, input: Input<'_>) -> Result<(), String> {
        let (least, most) = row.ends();
        let value = self.value(row);
        *value = match input {
            Input::Text(text) => percent(text, least..=most)?,
            Input::Step(press) => (*value + STEP * press.by() as f64).clamp(least, most),
        };
        Ok(())
    }

    /// The request.
    pub fn sampling(self) -> Sampling {
        let model = ModelError { bias: self.bias / 100.0, spread: self.spread / 100.0 };
        Sampling { deviation: self.inputs / 100.0, samples: SAMPLES, seed: SEED, model }
    }
}
