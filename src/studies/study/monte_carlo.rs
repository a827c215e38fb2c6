//! Monte Carlo over tolerances: the spread of the results for scattered inputs, and the probability of perforation.
//!
//! Inputs are independent and drawn from one seeded stream, so results do not depend on the number of threads. A draw without physical
//! sense is repeated and counted: the distribution is the requested one, truncated to allowed values. All values of a result are stored for
//! its quantiles, eight bytes each; [`SAMPLES`] bounds the memory. Does not depend on files, the terminal or a clock.

use std::fmt;
use std::ops::RangeInclusive;

use crate::study::context::Context;
use crate::study::limit;
use crate::study::option;
use crate::study::outcome::OutcomeCounts;
use crate::study::quantities::{self, Needs, Quantity, find};
use crate::study::statistics::{Z95, moments, quantile, wilson};
use crate::study::sweep::{Axis, Plan, PointOutcome, Spacing, StudyError};
use crate::study::verdict::Verdict;
use cmra_engine::model::run::Outcome;
use cmra_engine::model::scene::{OwnMass, Scene, SpringKind};
use cmra_engine::model::variables::{self, Number, VARIABLES, Variable};
use cmra_engine::numerics::random::Random;
pub use tolerance::{Distribution, Kind, Tolerance};

mod tolerance;

/// Allowed numbers of samples; the maximum takes about 80 MB for each result.
pub const SAMPLES: RangeInclusive<usize> = 2..=10_000_000;
/// Default number of samples.
pub const DEFAULT_SAMPLES: usize = 10_000;
/// Default number of samples if each takes a limit search.
pub const DEFAULT_LIMIT_SAMPLES: usize = 200;
/// Default seed.
pub const DEFAULT_SEED: u64 = 1;
/// Samples evaluated per batch.
const BATCH: usize = 2048;
/// Maximum number of draws for one sample.
const DRAWS_MAX: usize = 10_000;
pub use crate::study::quantities::LIMIT;
/// Default relative standard deviation.
pub const DEFAULT_DEVIATION: f64 = 0.02;

/// Error of the law for limit velocities.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ModelError {
    /// Law over measurement, less 1; > -1. Negative if computed limits are too low.
    pub bias: f64,
    /// Standard deviation of ln(law/measured), >= 0.
    pub spread: f64,
}

impl ModelError {
    /// Draws the correction factor of a computed limit.
    fn factor(self, random: &mut Random) -> f64 {
        let spread = if self.spread > 0.0 { (self.spread * random.normal()).exp() } else { 1.0 };
        spread / (1.0 + self.bias)
    }
}

/// Request for a Monte Carlo study.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// Scattered inputs; empty for [`default_tolerances`] with [`DEFAULT_DEVIATION`].
    pub vary: Vec<Tolerance>,
    /// Measures; empty for all except those that describe the computation.
    pub outputs: Vec<&'static Quantity>,
    /// Number of samples, >= 2; `None` for the default, which is smaller if each sample takes a limit search.
    pub samples: Option<usize>,
    /// Seed of the random stream.
    pub seed: u64,
    /// Bias of the model in every limit velocity; `None` for the known bias.
    pub model_bias: Option<f64>,
    /// Spread of the model in every limit velocity; `None` for the known spread.
    pub model_spread: Option<f64>,
}

impl Default for Request {
    fn default() -> Self {
        let (vary, outputs, samples) = (Vec::new(), Vec::new(), None);
        Self { vary, outputs, samples, seed: DEFAULT_SEED, model_bias: None, model_spread: None }
    }
}

/// Writes the name and options of the command.
impl fmt::Display for Request {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let vary: String = self.vary.iter().map(|it| option("vary", Some(it))).collect();
        let names: Vec<&str> = self.outputs.iter().map(|it| it.name).collect();
        let outputs = option("outputs", (!names.is_empty()).then(|| names.join(",")));
        let samples = option("samples", self.samples);
        let bias = option("model-bias", self.model_bias);
        let spread = option("model-spread", self.model_spread);
        let seed = option("seed", Some(self.seed).filter(|seed| *seed != Self::default().seed));
        write!(f, "montecarlo{vary}{outputs}{samples}{bias}{spread}{seed}")
    }
}

impl Request {
    /// Creates the request for V50: the limit velocity under the default tolerances and the known model error.
    pub fn v50() -> Self {
        Self { outputs: find(LIMIT).into_iter().collect(), ..Self::default() }
    }

    /// Returns the scattered inputs.
    fn tolerances(&self, scene: &Scene) -> Vec<Tolerance> {
        if self.vary.is_empty() {
            return default_tolerances(scene, DEFAULT_DEVIATION);
        }
        self.vary.clone()
    }

    /// Returns the names of the measures.
    fn measures(&self) -> Vec<&'static str> {
        if self.outputs.is_empty() {
            return quantities::usual().map(|it| it.name).collect();
        }
        self.outputs.iter().map(|it| it.name).collect()
    }

    /// Returns the number of samples.
    fn count(&self) -> usize {
        let is_searched = self.outputs.iter().any(|it| it.needs() == Needs::Limit);
        self.samples.unwrap_or(if is_searched { DEFAULT_LIMIT_SAMPLES } else { DEFAULT_SAMPLES })
    }

    /// Returns the model error.
    fn model(&self, scene: &Scene) -> ModelError {
        let known = Verdict::from_scene(scene).expected;
        let known = known.map_or_else(ModelError::default, |it| ModelError {
            bias: it.bias,
            spread: it.deviation,
        });
        ModelError {
            bias: self.model_bias.unwrap_or(known.bias),
            spread: self.model_spread.unwrap_or(known.spread),
        }
    }
}

/// Estimate with its 95 % confidence interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// Estimated value.
    pub value: f64,
    /// Lower end of the interval.
    pub low_95: f64,
    /// Upper end of the interval.
    pub high_95: f64,
}

/// Fraction of the samples that perforate: least and greatest value, which are equal if all samples are decided, and the 95 % confidence
/// interval of both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PerforatedShare {
    /// Fraction if no undecided sample perforates.
    pub least: f64,
    /// Fraction if all undecided samples perforate.
    pub most: f64,
    /// Lower end of the interval.
    pub low_95: f64,
    /// Upper end of the interval.
    pub high_95: f64,
}

/// Scatter of one measure.
#[derive(Clone, Debug, PartialEq)]
pub struct Summary {
    /// Scattered measure.
    pub measure: &'static Quantity,
    /// Whether the values include the model error.
    pub has_model_error: bool,
    /// Value of the unscattered scene.
    pub nominal: Option<f64>,
    /// Mean; `None` if there is no standard deviation.
    pub mean: Option<Estimate>,
    /// Standard deviation; `None` for fewer than two values.
    pub deviation: Option<f64>,
    /// All values, in ascending order.
    pub sorted: Vec<f64>,
}

/// Result of a Monte Carlo study.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MonteCarloReport {
    /// Scattered inputs.
    pub tolerances: Vec<Tolerance>,
    /// Number of repeated draws of each input, because the value made no physical sense.
    pub redrawn: Vec<usize>,
    /// Number of samples drawn again, because their values were not allowed together.
    pub redrawn_together: usize,
    /// Seed of the random stream.
    pub seed: u64,
    /// Number of evaluated samples.
    pub samples: usize,
    /// Number of samples with each outcome.
    pub outcomes: OutcomeCounts,
    /// Outcome of the unscattered scene.
    pub nominal: Option<PointOutcome>,
    /// Fraction of the samples that perforate, with Wilson's interval; `None` if no sample is decided.
    pub perforated: Option<PerforatedShare>,
    /// Model error.
    pub model: ModelError,
    /// Summary of each measure; a limit velocity has one with and one without the model error.
    pub summaries: Vec<Summary>,
}

/// Variables that scatter by default in every scene, besides its springs. Their order determines the results of a seed.
const DEFAULT_KEYS: [&str; 14] = [
    "projectile.velocity_m_s",
    "projectile.mass_kg",
    "projectile.tip_radius_m",
    "target.thickness_m",
    "target.density_kg_m3",
    "target.flow_strength_pa",
    "target.yield_pa",
    "target.modulus_pa",
    "target.drag_coefficient",
    "plate.mass_ratio",
    "plate.mass_kg",
    "plate.face_m",
    "plate.cocking_m",
    "mechanism.damper.coefficient",
];
const STOP: &str = "mechanism.stop.position_m";

/// Returns the default scattered inputs, lognormal with a relative deviation: `DEFAULT_KEYS`, the parameters of the springs and the stop,
/// if the scene uses them and they are not zero. Exponents and numbers of springs do not scatter unless the spring has no other parameter.
pub fn default_tolerances(scene: &Scene, deviation: f64) -> Vec<Tolerance> {
    let bodies = DEFAULT_KEYS.iter().filter_map(|key| variables::find(key).ok());
    let springs = VARIABLES.iter().filter(|variable| is_springs_own(variable.key, scene));
    let scatters = |variable: &&Variable| {
        // An input that follows from another one varies with it.
        !variables::overrules_size(variable, scene)
            && variables::is_listed(variable, scene)
            && variables::is_used(variable, scene)
    };
    bodies
        .chain(springs)
        .chain(variables::find(STOP).ok())
        .filter(scatters)
        .filter_map(|variable| {
            let number = variable.number()?;
            let median = (number.get)(scene).filter(|value| *value > 0.0)?;
            let distribution = Distribution(Kind::LogNormal, (median, deviation));
            Tolerance::new(variable.symbol, distribution).ok()
        })
        .collect()
}

/// Returns `true` if a key is a spring parameter that scatters by default.
fn is_springs_own(key: &str, scene: &Scene) -> bool {
    let spring = &scene.mechanism.spring;
    if key == "mechanism.second.coefficient" {
        return true;
    }
    let Some(row) = key.strip_prefix("mechanism.spring.") else { return false };
    match row {
        "exponent" | "mass_kg" => false,
        // The force of a measured curve scatters.
        "count" => spring.kind == SpringKind::Table,
        // The wire's parameters affect the plate only if its mass counts.
        _ if row.starts_with("wire.") => {
            spring.own_mass == OwnMass::Counted && spring.mass_kg.is_none()
        }
        _ => true,
    }
}

/// Draws and evaluates the samples.
///
/// # Errors
/// Returns a [`StudyError`] for an invalid request, before any run, or if no draw makes physical sense.
pub fn run(
    scene: &Scene,
    request: &Request,
    context: &mut Context<'_, MonteCarloReport>,
) -> Result<MonteCarloReport, StudyError> {
    let (tolerances, model) = (request.tolerances(scene), request.model(scene));
    let (wanted, seed) = (request.count(), request.seed);
    let space = space(scene, request, &tolerances)?;
    let mut random = Random::new(seed);
    let mut drawn_scene = scene.clone();
    let mut report = MonteCarloReport {
        tolerances: tolerances.clone(),
        redrawn: vec![0; tolerances.len()],
        seed,
        model,
        ..MonteCarloReport::default()
    };
    let limit = space.outputs().iter().position(|it| it.name == LIMIT);
    let has_error = model != ModelError::default();
    let limit = limit.filter(|_| has_error);
    let (mut errors, mut corrected) = (Random::new(!seed), Vec::new());
    let own = space.design_of(scene);
    context.expect(wanted);
    let nominal = context.uncounted(|context| space.evaluate(&[own], context)).into_iter().next();
    let mut values: Vec<Vec<f64>> = vec![Vec::new(); space.outputs().len()];
    let mut drawn = 0;
    while drawn < wanted && !context.is_stopped() {
        let sample = |_| sample(&mut report, &mut drawn_scene, &mut random);
        let batch = (drawn..wanted).take(BATCH).map(sample);
        let designs = batch.collect::<Result<Vec<_>, _>>()?;
        drawn += designs.len();
        let found = space.evaluate(&designs, context);
        report.samples += found.len();
        for (design, found) in designs.iter().zip(found) {
            let factor = model.factor(&mut errors);
            let limit_m_s = limit.and_then(|at| Some(factor * found.values[at]?));
            corrected.extend(limit_m_s);
            let outcome = has_error.then(|| {
                let scene = space.scene_of(design);
                let by_law = || Some(factor * limit::closed_form(&scene)?);
                by_limit(found.outcome, scene.projectile.velocity_m_s, limit_m_s.or_else(by_law))
            });
            report.outcomes.add(outcome.unwrap_or(found.outcome));
            for (list, value) in values.iter_mut().zip(found.values) {
                list.extend(value);
            }
        }
    }
    report.perforated = perforated(report.outcomes);
    report.nominal = nominal.as_ref().map(|found| found.outcome);
    let summary = |(at, values)| {
        let nominal = nominal.as_ref().and_then(|found| found.values[at]);
        Summary::new(space.outputs()[at], nominal, values)
    };
    report.summaries = values.into_iter().enumerate().map(summary).collect();
    if let Some(at) = limit {
        let bare = report.summaries[at].nominal;
        let nominal = bare.map(|limit_m_s| limit_m_s / (1.0 + model.bias));
        let summary = Summary::new(space.outputs()[at], nominal, corrected);
        report.summaries.insert(at, Summary { has_model_error: true, ..summary });
    }
    Ok(report)
}

/// Returns the outcome of a sample whose limit, m/s, includes the model error. The same draw of the error decides outcome and limit.
fn by_limit(outcome: PointOutcome, v_m_s: f64, limit_m_s: Option<f64>) -> PointOutcome {
    let (PointOutcome::Ended(ended), Some(limit_m_s)) = (outcome, limit_m_s) else {
        return outcome;
    };
    PointOutcome::Ended(match ended {
        _ if v_m_s > limit_m_s => Outcome::Perforated,
        Outcome::Perforated => Outcome::Arrested,
        stopped => stopped,
    })
}

/// Returns the evaluation plan of the samples.
fn space(scene: &Scene, request: &Request, tolerances: &[Tolerance]) -> Result<Plan, StudyError> {
    if tolerances.is_empty() {
        return Err(StudyError::NothingScatters);
    }
    let samples = request.count();
    if !SAMPLES.contains(&samples) {
        let (least, most) = (*SAMPLES.start(), *SAMPLES.end());
        return Err(StudyError::Samples { samples, least, most, usual: DEFAULT_SAMPLES });
    }
    for (at, tolerance) in tolerances.iter().enumerate() {
        if tolerances[..at].iter().any(|other| other.symbol() == tolerance.symbol()) {
            return Err(StudyError::ScattersTwice { symbol: tolerance.symbol() });
        }
    }
    let axes = tolerances.iter().map(|tolerance| tolerance.axis(scene));
    let axes = axes.collect::<Result<Vec<Axis>, StudyError>>()?;
    request.outputs.iter().try_for_each(|output| output.check_exists(scene))?;
    Plan::for_designs(scene, axes, &request.measures())
}

/// Draws values of all inputs that together make physical sense in the scene; counts the repeated draws of each input and of all together.
fn sample(
    report: &mut MonteCarloReport,
    scene: &mut Scene,
    random: &mut Random,
) -> Result<Vec<f64>, StudyError> {
    let mut last = String::new();
    for _ in 0..DRAWS_MAX {
        let mut values = Vec::with_capacity(report.tolerances.len());
        for (tolerance, redrawn) in report.tolerances.iter().zip(&mut report.redrawn) {
            let mut value = tolerance.distribution.draw(random);
            for _ in 0..DRAWS_MAX {
                if tolerance.number.allowed.contains(value) {
                    break;
                }
                *redrawn += 1;
                value = tolerance.distribution.draw(random);
            }
            (tolerance.number.set)(scene, Some(value));
            values.push(value);
        }
        match variables::validate(scene) {
            Ok(()) => return Ok(values),
            Err(error) => last = error.to_string(),
        }
        report.redrawn_together += 1;
    }
    Err(StudyError::NoDraw { draws: DRAWS_MAX, last })
}

/// Computes the fraction of the samples that perforate. The undecided ones are no random part: they lie beside the limit.
fn perforated(counts: OutcomeCounts) -> Option<PerforatedShare> {
    let through = counts.count(Outcome::Perforated);
    let open = counts.count(Outcome::Moving) + counts.count(Outcome::Unmeasured);
    let total = counts.total() - counts.failed;
    let [least, most] = [through, through + open].map(|count| count as f64 / total as f64);
    (open < total).then(|| {
        let n = total as f64;
        PerforatedShare { least, most, low_95: wilson(least, n).0, high_95: wilson(most, n).1 }
    })
}

impl Summary {
    fn new(measure: &'static Quantity, nominal: Option<f64>, mut values: Vec<f64>) -> Self {
        values.sort_by(f64::total_cmp);
        let n = values.len() as f64;
        let mean = |(mean, deviation)| {
            let half = Z95 * deviation / n.sqrt();
            Estimate { value: mean, low_95: mean - half, high_95: mean + half }
        };
        let moments = moments(&values);
        let deviation = moments.map(|(_, deviation)| deviation);
        let mean = moments.map(mean);
        Self { measure, has_model_error: false, nominal, mean, deviation, sorted: values }
    }

    /// Returns a quantile with its 95 % confidence interval from order statistics (normal approximation of the binomial); `None` for fewer
    /// than two values.
    pub fn quantile(&self, fraction: f64) -> Option<Estimate> {
        self.deviation?;
        let half = Z95 * (fraction * (1.0 - fraction) / self.sorted.len() as f64).sqrt();
        let at = |fraction: f64| quantile(&self.sorted, fraction.clamp(0.0, 1.0));
        Some(Estimate {
            value: at(fraction),
            low_95: at(fraction - half),
            high_95: at(fraction + half),
        })
    }
}

#[cfg(test)]
mod tests;
