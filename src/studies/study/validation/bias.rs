//! Bias and scatter of the model, for classes of measurements and for all.

use super::{NOT_COUNTED, Row, measurements};
use crate::study::statistics::moments;
use cmra_engine::numerics::{larger, smaller};

/// Bias and scatter of a set of measurements.
#[derive(Clone, Debug, PartialEq)]
pub struct Bias {
    /// Class of measurements; `None` for all.
    pub class: Option<&'static str>,
    /// Number of points.
    pub points: usize,
    /// Mean of computed over measured, less 1.
    pub mean: f64,
    /// Standard deviation of computed over measured; `None` for one point.
    pub deviation: Option<f64>,
    /// Minimum and maximum of computed over measured, less 1.
    pub range: (f64, f64),
}

/// Computes bias and scatter by class, and last over all counted points.
pub fn biases(report: &[Row]) -> Vec<Bias> {
    let own = |class: &&'static str| {
        let errors: Vec<f64> =
            report.iter().filter(|row| row.case.class == *class).filter_map(own_error).collect();
        bias(Some(*class), &errors)
    };
    let counted = report.iter().filter(|row| row.case.class != NOT_COUNTED);
    let all: Vec<f64> = counted.filter_map(own_error).collect();
    measurements().classes.iter().filter_map(own).chain(bias(None, &all)).collect()
}

fn own_error(row: &Row) -> Option<f64> {
    row.computed.map(|value| row.error(value))
}

fn bias(class: Option<&'static str>, errors: &[f64]) -> Option<Bias> {
    let own = moments(errors);
    Some(Bias {
        class,
        points: errors.len(),
        // The mean of a single point is the point.
        mean: own.map_or(*errors.first()?, |(mean, _)| mean),
        deviation: own.map(|(_, deviation)| deviation),
        range: (
            errors.iter().copied().fold(f64::INFINITY, smaller),
            errors.iter().copied().fold(f64::NEG_INFINITY, larger),
        ),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Errors -0.1, 0, 0.4: mean 0.1, sum of squares 0.04 + 0.01 + 0.09 = 0.14, standard deviation (0.14/2)^(1/2).
    #[test]
    fn mean_and_standard_deviation() {
        let known = bias(None, &[-0.1, 0.0, 0.4]).unwrap();
        assert!((known.mean - 0.1).abs() < 1e-15);
        assert!((known.deviation.unwrap() - 0.07f64.sqrt()).abs() < 1e-15);
        assert_eq!(known.range, (-0.1, 0.4));
        assert_eq!(bias(None, &[0.2]).unwrap().deviation, None);
        assert_eq!(bias(None, &[]), None);
    }
}
