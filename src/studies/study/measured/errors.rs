//! Errors of the law and of the expected limit: by row, by class, and leaving one paper out.

use crate::study::context::Context;
use crate::study::limit;
use crate::study::measured::class::{Sample, classes};
use crate::study::measured::known::sample;
use crate::study::measured::table::{Measured, Measurement, OUTPUTS};
use crate::study::quantities::find;
use crate::study::run_with;
use crate::study::statistics::moments;
use crate::study::verdict::Verdict;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::simulate::Settings;

/// Group of the rows without a class.
pub const WITHOUT_CLASS: &str = "no class: the law alone";

/// A row of a table of measurements with the values computed for it.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The measurement.
    pub measurement: Measurement,
    /// Computed values, or the reason why there are none.
    pub computed: Result<Computed, String>,
}

/// Values computed for a measured shot.
#[derive(Clone, Debug, PartialEq)]
pub struct Computed {
    /// Verdict with the limit by the law and the expected limit.
    pub verdict: Verdict,
    /// Depth, m; `None` if it was not measured.
    pub depth_m: Option<f64>,
    /// Residual velocity, m/s; `None` if it was not measured.
    pub residual_velocity_m_s: Option<f64>,
    /// Quantities of a plate that moves, in the order of [`OUTPUTS`], SI; `None` if one was not measured.
    pub outputs: [Option<f64>; OUTPUTS.len()],
}

impl Row {
    /// Returns the relative error of the expected limit, else of the law's limit; `None` without a computed and a measured limit.
    pub fn limit_error(&self) -> Option<f64> {
        let (found, measured) = self.limits()?;
        Some(found / measured - 1.0)
    }

    /// Returns the expected limit, else the law's limit, and the measured limit, m/s.
    fn limits(&self) -> Option<(f64, f64)> {
        let computed = self.computed.as_ref().ok()?;
        Some((computed.verdict.headline_m_s()?, self.measurement.measured.limit_m_s?))
    }

    /// Returns `true` if the measured limit is inside the band; `None` without a band or a measured limit.
    pub fn is_inside(&self) -> Option<bool> {
        let measured = self.measurement.measured.limit_m_s?;
        let expected = self.computed.as_ref().ok()?.verdict.expected.as_ref()?;
        Some((expected.low_m_s..=expected.high_m_s).contains(&measured))
    }

    /// Returns the verdict; `None` for a row that cannot be computed.
    pub fn verdict(&self) -> Option<&Verdict> {
        self.computed.as_ref().ok().map(|computed| &computed.verdict)
    }

    /// Returns the class in words, or [`WITHOUT_CLASS`].
    pub fn group(&self) -> &str {
        let expected = self.verdict().and_then(|verdict| verdict.expected.as_ref());
        expected.map_or(WITHOUT_CLASS, |expected| &expected.class)
    }
}

/// Computes the values for a measurement with the classes of the built-in table. A row that lacks the value of a measured quantity is
/// refused.
fn computed(measurement: &Measurement) -> Result<Computed, String> {
    let scene = measurement.scene.as_ref().map_err(String::clone)?;
    let Measured { limit_m_s, depth_m, residual_velocity_m_s, outputs, .. } = measurement.measured;
    // A search costs some hundred runs.
    let law = match (limit::closed_form(scene), limit_m_s) {
        (Some(law), _) => Some(law),
        (None, Some(_)) => Some(limit::velocity_m_s(scene)?),
        (None, None) => None,
    };
    let is_run = measurement.measured.needs_run();
    let run = is_run.then(|| run_with(scene, Settings::SERIES)).flatten();
    let depth = || run.as_ref()?.shot_depth_m();
    let residual = || run.as_ref()?.shot_residual_m_s();
    let computed = Computed {
        verdict: Verdict::with_limit(scene, law),
        depth_m: depth_m.and_then(|_| depth()),
        residual_velocity_m_s: residual_velocity_m_s.and_then(|_| residual()),
        outputs: std::array::from_fn(|at| {
            outputs[at].and_then(|_| find(OUTPUTS[at].0)?.value(run.as_ref()?))
        }),
    };
    // A quantity that is measured but not computed would be missing in all statistics: the row is refused.
    let shot = [
        ("depth_m", depth_m, computed.depth_m),
        ("residual_velocity_m_s", residual_velocity_m_s, computed.residual_velocity_m_s),
    ];
    let of_plate = (0..OUTPUTS.len()).map(|at| (OUTPUTS[at].0, outputs[at], computed.outputs[at]));
    let mut pairs = shot.into_iter().chain(of_plate);
    if let Some((name, ..)) =
        pairs.find(|(_, measured, found)| measured.is_some() && found.is_none())
    {
        let outcome = run.as_ref().map_or("not computed", |run| run.shot_outcome().word());
        return Err(format!("the computed shot, {outcome}, has no {name}"));
    }
    Ok(computed)
}

/// Computes all measurements; fewer if cancelled.
pub fn evaluate(measurements: &[Measurement], context: &mut Context<'_>) -> Vec<Row> {
    context.expect(measurements.len());
    let row = |measurement: &Measurement| {
        Some(Row { measurement: measurement.clone(), computed: computed(measurement) })
    };
    context.map_items(measurements, row, |context, _| context.should_continue())
}

/// Computes a row with the law's limit in closed form and without a class; `None` without a closed form.
fn by_law(measurement: &Measurement) -> Option<Row> {
    let law = limit::closed_form(measurement.scene.as_ref().ok()?);
    let verdict = |scene: &Scene| Verdict::by_classes(scene, law, || &[]);
    let computed = measurement.scene.as_ref().map(|scene| Computed {
        verdict: verdict(scene),
        depth_m: None,
        residual_velocity_m_s: None,
        outputs: [None; OUTPUTS.len()],
    });
    Some(Row { computed: computed.map_err(String::clone), measurement: measurement.clone() })
}

/// Computes each measurement with the limit expected from all other papers. The result is the error for an unseen paper.
pub fn leave_out(measurements: &[Measurement]) -> Vec<Row> {
    let mut rows: Vec<Row> = measurements.iter().filter_map(by_law).collect();
    let samples: Vec<Option<Sample>> =
        rows.iter().map(|row| sample(&row.measurement, row.verdict()?.limit_m_s)).collect();
    let mut papers: Vec<String> = rows.iter().map(|row| row.measurement.source.clone()).collect();
    papers.sort();
    papers.dedup();
    for paper in papers {
        let others = samples.iter().flatten().filter(|sample| sample.paper != paper).cloned();
        let classes = classes(&others.collect::<Vec<_>>());
        for row in rows.iter_mut().filter(|row| row.measurement.source == paper) {
            let (Ok(scene), Ok(computed)) = (&row.measurement.scene, &mut row.computed) else {
                continue;
            };
            let law = computed.verdict.limit_m_s;
            computed.verdict = Verdict::by_classes(scene, law, || &classes);
        }
    }
    rows
}

/// Error statistics of a group of rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Errors {
    /// Class in words; `None` for all rows.
    pub group: Option<String>,
    /// Number of rows with a computed and a measured limit.
    pub rows: usize,
    /// Number of papers.
    pub papers: usize,
    /// Mean of computed over measured, less 1.
    pub bias: f64,
    /// Standard deviation of computed over measured; `None` for one row.
    pub deviation: Option<f64>,
    /// Mean absolute error, m/s.
    pub mean_absolute_m_s: f64,
    /// RMS error, m/s.
    pub rms_m_s: f64,
    /// Number of rows with a band.
    pub banded: usize,
    /// Number of rows inside their band.
    pub inside: usize,
}

impl Errors {
    /// Computes the errors of rows; `None` if no row has a computed and a measured limit.
    fn new<'r>(group: Option<&str>, rows: impl Iterator<Item = &'r Row>) -> Option<Self> {
        let rows: Vec<&Row> = rows.filter(|row| row.limits().is_some()).collect();
        let limits: Vec<(f64, f64)> = rows.iter().filter_map(|row| row.limits()).collect();
        let ratios: Vec<f64> =
            limits.iter().map(|(found, measured)| found / measured - 1.0).collect();
        let count = limits.len() as f64;
        let mean = |of: fn(f64) -> f64| {
            limits.iter().map(|(found, measured)| of(found - measured)).sum::<f64>() / count
        };
        let mut papers: Vec<&str> =
            rows.iter().map(|row| row.measurement.source.as_str()).collect();
        papers.sort_unstable();
        papers.dedup();
        let inside = rows.iter().filter_map(|row| row.is_inside());
        (!limits.is_empty()).then(|| Self {
            group: group.map(str::to_owned),
            rows: limits.len(),
            papers: papers.len(),
            bias: ratios.iter().sum::<f64>() / count,
            deviation: moments(&ratios).map(|(_, deviation)| deviation),
            mean_absolute_m_s: mean(f64::abs),
            rms_m_s: mean(|error| error * error).sqrt(),
            banded: inside.clone().count(),
            inside: inside.filter(|is_inside| *is_inside).count(),
        })
    }

    /// Returns the fraction of the rows with a band that are inside it; `None` without a band.
    pub fn share_inside(&self) -> Option<f64> {
        (self.banded > 0).then(|| self.inside as f64 / self.banded as f64)
    }
}

/// Computes the errors by class, the largest class first, then for the rows without a class, and last for all rows.
pub fn errors(rows: &[Row]) -> Vec<Errors> {
    let mut groups: Vec<&str> = rows.iter().map(Row::group).collect();
    groups.sort_unstable();
    groups.dedup();
    let own =
        |group: &&str| Errors::new(Some(group), rows.iter().filter(|row| row.group() == *group));
    let mut list: Vec<Errors> = groups.iter().filter_map(own).collect();
    let is_without = |it: &Errors| it.group.as_deref() == Some(WITHOUT_CLASS);
    list.sort_by_key(|it| (is_without(it), std::cmp::Reverse(it.rows)));
    list.extend(Errors::new(None, rows.iter()));
    list
}
