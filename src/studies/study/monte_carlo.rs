//! Monte Carlo over tolerances: the spread of the results for scattered inputs, and the probability of perforation.
//!
//! Inputs are independent and drawn by one seeded stream, so that no digit depends on the number of threads. A draw without
//! physical sense is drawn again and counted: the distribution is the one requested, truncated to what is allowed. The values
//! of a result are kept for its quantiles, eight bytes each: [`SAMPLES`] is the limit. Must not know files, screens or a
//! clock.

use std::fmt;
use std::ops::RangeInclusive;

use crate::study::context::Context;
use crate::study::limit;
use crate::study::option;
use crate::study::outcome::OutcomeCounts;
use crate::study::quantities::{self, Needs, Quantity, find};
use crate::study::sweep::{Axis, Plan, PointOutcome, Spacing, StudyError};
use crate::study::verdict::Verdict;
use cmra_engine::model::run::Outcome;
use cmra_engine::model::scene::{OwnMass, Scene, SpringKind};
use cmra_engine::model::variables::{self, Number, VARIABLES, Variable};
use cmra_engine::numerics::random::Random;
use cmra_engine::numerics::statistics::{Z95, moments, quantile, wilson};
pub use tolerance::{Distribution, Kind, Tolerance};

mod tolerance;

/// Numbers of samples that are accepted; the greatest takes some 80 MB a result.
pub const SAMPLES: RangeInclusive<usize> = 2..=10_000_000;
/// Samples if no number is given.
pub const DEFAULT_SAMPLES: usize = 10_000;
/// Samples if no number is given and each takes a limit search.
pub const DEFAULT_LIMIT_SAMPLES: usize = 200;
/// Seed if none is given.
pub const DEFAULT_SEED: u64 = 1;
/// Samples evaluated at once.
const BATCH: usize = 2048;
/// Draws of one sample before it is given up.
const DRAWS_MAX: usize = 10_000;
pub use crate::study::quantities::LIMIT;
/// Relative deviation if none is given.
pub const DEFAULT_DEVIATION: f64 = 0.02;

/// Error of the law in limit velocities.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ModelError {
    /// Law over measurement, less 1: negative where limits come out low; > -1.
    pub bias: f64,
    /// Standard deviation of the logarithm of law over measurement, >= 0.
    pub spread: f64,
}

impl ModelError {
    /// The correction factor of a computed limit, drawn.
    fn factor(self, random: &mut Random) -> f64 {
        let spread = if self.spread > 0.0 { (self.spread * random.normal()).exp() } else { 1.0 };
        spread / (1.0 + self.bias)
    }
}

/// Request for a Monte Carlo study.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// The inputs that scatter; empty: [`default_tolerances`] by [`DEFAULT_DEVIATION`].
    pub vary: Vec<Tolerance>,
    /// The measures; empty: all but those of the computation.
    pub outputs: Vec<&'static Quantity>,
    /// Number of samples, >= 2; `None`: fewer where each takes a limit search.
    pub samples: Option<usize>,
    /// Seed.
    pub seed: u64,
    /// Bias of the model in every limit velocity; `None`: the one known.
    pub model_bias: Option<f64>,
    /// Spread of the model there; `None`: the one known.
    pub model_spread: Option<f64>,
}

impl Default for Request {
    fn default() -> Self {
        let (vary, outputs, samples) = (Vec::new(), Vec::new(), None);
        Self { vary, outputs, samples, seed: DEFAULT_SEED, model_bias: None, model_spread: None }
    }
}

/// The command's name and options.
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
    /// V50: the limit velocity under the usual tolerances and the known error of the model.
    pub fn v50() -> Self {
        Self { outputs: find(LIMIT).into_iter().collect(), ..Self::default() }
    }

    /// The inputs that scatter.
    fn tolerances(&self, scene: &Scene) -> Vec<Tolerance> {
        if self.vary.is_empty() {
            return default_tolerances(scene, DEFAULT_DEVIATION);
        }
        self.vary.clone()
    }

    /// Names of the measures.
    fn measures(&self) -> Vec<&'static str> {
        if self.outputs.is_empty() {
            return quantities::usual().map(|it| it.name).collect();
        }
        self.outputs.iter().map(|it| it.name).collect()
    }

    /// Number of samples.
    fn count(&self) -> usize {
        let is_searched = self.outputs.iter().any(|it| it.needs() == Needs::Limit);
        self.samples.unwrap_or(if is_searched { DEFAULT_LIMIT_SAMPLES } else { DEFAULT_SAMPLES })
    }

    /// The error of the model.
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

/// An estimate and its 95 % confidence interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The estimate.
    pub value: f64,
    /// The lower end of the interval.
    pub low_95: f64,
    /// Upper end of the interval.
    pub high_95: f64,
}

/// How one measure scatters.
#[derive(Clone, Debug, PartialEq)]
pub struct Summary {
    /// The measure.
    pub measure: &'static Quantity,
    /// Whether the error of the model is in its values.
    pub has_model_error: bool,
    /// Value of the unscattered scene.
    pub nominal: Option<f64>,
    /// Mean; there is one where there is a deviation.
    pub mean: Option<Estimate>,
    /// Standard deviation; `None` without two values.
    pub deviation: Option<f64>,
    /// All values, rising.
    pub sorted: Vec<f64>,
}

/// The result.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MonteCarloReport {
    /// The inputs.
    pub tolerances: Vec<Tolerance>,
    /// Draws of each input that made no physical sense and were drawn again.
    pub redrawn: Vec<usize>,
    /// Seed.
    pub seed: u64,
    /// Samples done.
    pub samples: usize,
    /// How they ended.
    pub outcomes: OutcomeCounts,
    /// The outcome of the scene itself.
    pub nominal: Option<PointOutcome>,
    /// Part of the samples that perforate, of those that came to an end (interval: Wilson's); `None` without any.
    pub perforated: Option<Estimate>,
    /// The error of the model.
    pub model: ModelError,
    /// Measure by measure; a limit velocity with the error of the model, and then without it.
    pub summaries: Vec<Summary>,
}

/// Variables of every scene that scatter by default, besides its springs. The results of a seed depend on the order.
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

/// The inputs that scatter where none are named, lognormal by a relative deviation: all of `DEFAULT_KEYS`, the springs' own
/// parameters and the stop, where the scene uses them and they are not zero. Shapes (exponents) and numbers of springs are taken as
/// they are, unless the spring has no other parameter.
pub fn default_tolerances(scene: &Scene, deviation: f64) -> Vec<Tolerance> {
    let bodies = DEFAULT_KEYS.iter().filter_map(|key| variables::find(key).ok());
    let springs = VARIABLES.iter().filter(|variable| is_springs_own(variable.key, scene));
    let scatters = |variable: &&Variable| {
        // What follows from another input varies with that.
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

/// Whether a key is a parameter of a spring that scatters.
fn is_springs_own(key: &str, scene: &Scene) -> bool {
    let spring = &scene.mechanism.spring;
    if key == "mechanism.second.coefficient" {
        return true;
    }
    let Some(row) = key.strip_prefix("mechanism.spring.") else { return false };
    match row {
        "exponent" | "mass_kg" => false,
        // A measured curve scatters in force.
        "count" => spring.kind == SpringKind::Table,
        // The wire's moves the plate only where its mass counts.
        _ if row.starts_with("wire.") => {
            spring.own_mass == OwnMass::Counted && spring.mass_kg.is_none()
        }
        _ => true,
    }
}

/// Draw and evaluate.
///
/// # Errors
/// A [`StudyError`] when something about it is bad: then nothing has run; or when no draw makes sense.
pub fn run(
    scene: &Scene,
    request: &Request,
    context: &mut Context<'_, MonteCarloReport>,
) -> Result<MonteCarloReport, StudyError> {
    let (tolerances, model) = (request.tolerances(scene), request.model(scene));
    let (wanted, seed) = (request.count(), request.seed);
    let space = space(scene, request, &tolerances)?;
    let (mut random, mut redrawn) = (Random::new(seed), vec![0; tolerances.len()]);
    let mut drawn_scene = scene.clone();
    let mut sample = || sample(&tolerances, &mut drawn_scene, &mut random, &mut redrawn);
    let mut report = MonteCarloReport {
        tolerances: tolerances.clone(),
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
        let batch = (drawn..wanted).take(BATCH).map(|_| sample());
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
    report.redrawn = redrawn;
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

/// The outcome of a sample whose limit is known with the error of the law, m/s: the same draw decides both.
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

/// Where the samples are evaluated.
fn space(scene: &Scene, request: &Request, tolerances: &[Tolerance]) -> Result<Plan, StudyError> {
    if tolerances.is_empty() {
        let text = "nothing scatters: name an input, for example v_i=normal:2%";
        return Err(StudyError::Samples(text.to_owned()));
    }
    let samples = request.count();
    if !SAMPLES.contains(&samples) {
        return Err(StudyError::Samples(format!(
            "samples = {samples} is outside {} to {}: {DEFAULT_SAMPLES} is usual",
            SAMPLES.start(),
            SAMPLES.end()
        )));
    }
    for (at, tolerance) in tolerances.iter().enumerate() {
        if tolerances[..at].iter().any(|other| other.symbol() == tolerance.symbol()) {
            let symbol = tolerance.symbol();
            let text = format!("{symbol} scatters twice: give each input one distribution");
            return Err(StudyError::Samples(text));
        }
    }
    let axes = tolerances.iter().map(|tolerance| tolerance.axis(scene));
    let axes = axes.collect::<Result<Vec<Axis>, StudyError>>()?;
    Plan::for_designs(scene, axes, &request.measures())
}

/// A value for every input, which together make physical sense in the scene; counts how often each input is drawn again.
fn sample(
    tolerances: &[Tolerance],
    scene: &mut Scene,
    random: &mut Random,
    redrawn: &mut [usize],
) -> Result<Vec<f64>, StudyError> {
    let mut last = String::new();
    for _ in 0..DRAWS_MAX {
        let mut values = Vec::with_capacity(tolerances.len());
        for (tolerance, redrawn) in tolerances.iter().zip(&mut *redrawn) {
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
    }
    Err(StudyError::Samples(format!(
        "none of {DRAWS_MAX} draws makes physical sense, the last because {last}"
    )))
}

/// The part that perforates, of all that came to an end.
fn perforated(counts: OutcomeCounts) -> Option<Estimate> {
    let open = counts.count(Outcome::Moving) + counts.count(Outcome::Unmeasured);
    let ended = (counts.total() - counts.failed - open) as f64;
    let part = counts.count(Outcome::Perforated) as f64 / ended;
    (ended > 0.0).then(|| {
        let (low_95, high_95) = wilson(part, ended);
        Estimate { value: part, low_95, high_95 }
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

    /// The value below which a given part lies, with the order statistics that enclose it with 95 % confidence (normal
    /// approximation of the binomial); `None` without two values.
    pub fn quantile(&self, share: f64) -> Option<Estimate> {
        self.deviation?;
        let half = Z95 * (share * (1.0 - share) / self.sorted.len() as f64).sqrt();
        let at = |share: f64| quantile(&self.sorted, share.clamp(0.0, 1.0));
        Some(Estimate { value: at(share), low_95: at(share - half), high_95: at(share + half) })
    }
}

#[cfg(test)]
mod tests;
