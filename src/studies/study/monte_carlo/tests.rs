//! Scatter with a known solution: quantiles through a monotone closed form, moments of the distributions, proportions.

use std::f64::consts::PI;

use super::*;
use crate::study::context::never_cancel;
use crate::study::limit::closed_form;
use crate::study::testing::rigid;

fn task(vary: Vec<Tolerance>, measures: &[&str], samples: usize) -> Request {
    let outputs = measures.iter().map(|name| find(name).unwrap()).collect();
    Request { vary, outputs, samples: Some(samples), ..Request::default() }
}

fn sampled(scene: &Scene, task: &Request) -> MonteCarloReport {
    run(scene, task, &mut Context::new(2, &mut never_cancel)).unwrap()
}

/// Depth p <= R on a rigid mount is an increasing function of velocity: V(p) = m/(2c) ln(1 + c v²/S). Its quantiles follow from those of
/// the velocity.
#[test]
fn valid_quantiles_through_a_monotone_closed_form() {
    let mut scene = rigid();
    scene.projectile.velocity_m_s = 60.0;
    let (mean, deviation) = (60.0, 3.0);
    let velocity = Tolerance::new("v_i", Distribution(Kind::Normal, (mean, deviation))).unwrap();
    let report = sampled(&scene, &task(vec![velocity], &["final_penetration_m"], 20_000));
    let summary = &report.summaries[0];
    // Standard normal quantiles, Abramowitz and Stegun table 26.5.
    for (fraction, z) in [(0.01, -2.326_348), (0.25, -0.674_490), (0.5, 0.0), (0.95, 1.644_854)] {
        let v = mean + deviation * z;
        let (s, c) = (scene.target.flow_strength_pa, scene.drag_kg_m3());
        let volume = scene.projectile.mass_kg / (2.0 * c) * (c * v * v / s).ln_1p();
        let depth = depth_of(&scene, volume);
        let found = summary.quantile(fraction).unwrap();
        assert!(found.low_95 < found.value && found.value < found.high_95);
        // Check with twice the interval; 95 % of the intervals contain the exact value.
        let width = found.high_95 - found.low_95;
        assert!((found.value - depth).abs() < width, "{fraction}: {found:?} {depth}");
        assert!(width < 0.02 * depth);
    }
    assert_eq!((report.samples, report.outcomes.count(Outcome::Arrested)), (20_000, 20_000));
    let PerforatedShare { least: value, low_95, high_95, .. } = report.perforated.unwrap();
    assert!(value == 0.0 && low_95 == 0.0 && (1e-4..3e-4).contains(&high_95), "{high_95}");
}

/// Depth at which a hemisphere has swept a volume under dishing, by bisection.
fn depth_of(scene: &Scene, volume: f64) -> f64 {
    let (r, h) = (scene.projectile.tip_radius_m, scene.target.thickness_m);
    let swept = |p: f64| (h + 2.0 * r) / h * PI * (r * p * p - p.powi(3) / 3.0);
    let (mut low, mut high) = (0.0, r);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if swept(middle) < volume { low = middle } else { high = middle }
    }
    low
}

#[test]
fn valid_moments_of_the_distributions() {
    let mut random = Random::new(11);
    let mut moments = |distribution: Distribution| {
        let values: Vec<f64> = (0..40_000).map(|_| distribution.draw(&mut random)).collect();
        let mean = values.iter().sum::<f64>() / 40_000.0;
        (mean, (values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / 40_000.0).sqrt())
    };
    let near = |(mean, deviation): (f64, f64), exact: (f64, f64)| {
        // Five standard errors.
        assert!((mean - exact.0).abs() < 0.025 * exact.1, "{mean} {exact:?}");
        assert!((deviation - exact.1).abs() < 0.025 * exact.1, "{deviation} {exact:?}");
    };
    near(moments(Distribution(Kind::Normal, (3.0, 0.5))), (3.0, 0.5));
    near(moments(Distribution(Kind::Uniform, (1.0, 4.0))), (2.5, 3.0 / 12f64.sqrt()));
    // Mean exp(sigma²/2); standard deviation: the mean times sqrt(exp(sigma²) - 1).
    let (mean, s2) = (0.02f64.exp(), 0.04f64);
    near(moments(Distribution(Kind::LogNormal, (1.0, 0.2))), (mean, mean * s2.exp_m1().sqrt()));
}

#[test]
fn what_is_impossible_is_drawn_again_and_counted() {
    let thick = Distribution(Kind::Normal, (0.0254, 0.0254));
    let thickness = Tolerance::new("h", thick).unwrap();
    let report = sampled(&rigid(), &task(vec![thickness], &["percent_of_baseline"], 2000));
    // A normal variable with its mean one deviation above zero is negative in 15.87 % of draws, so there are 0.1886 repeated draws per
    // sample.
    let fraction = report.redrawn[0] as f64 / 2000.0;
    assert!((fraction - 0.1886).abs() < 0.04, "{fraction}");
    assert_eq!(report.samples, 2000);
}

#[test]
fn what_is_impossible_together_is_drawn_again_and_counted() {
    // A quarter of the shots is slower than the plate that flees from them: a third of a repeated draw per sample.
    let mut scene = Scene::default();
    scene.plate.velocity_m_s = 90.0;
    let slow = Tolerance::new("v_i", Distribution(Kind::Uniform, (80.0, 120.0))).unwrap();
    let report = sampled(&scene, &task(vec![slow], &["final_penetration_m"], 900));
    assert_eq!((report.samples, &*report.redrawn), (900, &[0][..]));
    let fraction = report.redrawn_together as f64 / 900.0;
    // Five standard deviations of the negative binomial distribution.
    assert!((fraction - 1.0 / 3.0).abs() < 0.11, "{fraction}");
}

#[test]
fn tolerances_are_read_as_people_write_them() {
    let scene = Scene::default();
    let read =
        |name: &str, text: &str| Tolerance::parse(name, text, &scene).map(|it| it.distribution);
    let normal = |mean, deviation| Ok(Distribution(Kind::Normal, (mean, deviation)));
    assert_eq!(read("v_i", "normal:2%"), normal(100.0, 2.0));
    assert_eq!(read("v_i", "2%"), normal(100.0, 2.0));
    assert_eq!(read("projectile.velocity_m_s", "normal: 3 m/s"), normal(100.0, 3.0));
    let uniform = Distribution(Kind::Uniform, (0.024, 0.027));
    assert_eq!(read("h", "uniform:24mm..27mm"), Ok(uniform));
    let Ok(Distribution(Kind::LogNormal, (median, deviation))) = read("S_y", "lognormal:5%") else {
        panic!("not lognormal")
    };
    assert!((median - 1.52e8).abs() < 1.0 && (deviation - 0.05).abs() < 1e-12);
    for (name, text, told) in [
        ("v_i", "normal:2kg", "`kg` is not a unit"),
        ("v_i", "normal:-3", "greater than 0"),
        ("h", "uniform:27mm..24mm", "lower one"),
        ("h", "uniform:-27mm..-24mm", "nothing that is allowed"),
        ("d", "lognormal:5%", "above 0"),
        ("interface", "normal:2%", "no numbers"),
        ("gama", "normal:2%", "did you mean"),
        ("x_stop", "normal:1mm", "absent"),
    ] {
        let error = read(name, text).unwrap_err().to_string();
        assert!(error.contains(told), "{name} {text}: {error}");
    }
}

/// To first order, the squared sensitivities of the closed form add to the squared spread of the model. A bias of 25 % is a factor on V50.
/// The limit without model error is reported too.
#[test]
fn valid_scatter_of_a_limit_is_that_of_its_inputs_and_of_the_model() {
    let mut scene = rigid();
    scene.projectile.velocity_m_s = 232.295_378;
    let (model_bias, model_spread) = (Some(0.25), Some(0.08));
    let vary = default_tolerances(&scene, 0.03);
    let v50 = Request { vary, model_bias, model_spread, samples: Some(400), ..Request::v50() };
    let report = sampled(&scene, &v50);
    assert_eq!(report, sampled(&scene, &v50), "the same seed gives the same digits");
    // Derivatives d ln v/d ln x by finite differences.
    let sensitivity = |changed: &dyn Fn(&mut Scene, f64)| {
        let at = |factor: f64| {
            let mut own = scene.clone();
            changed(&mut own, factor);
            closed_form(&own).unwrap().ln()
        };
        (at(1.001) - at(0.999)) / 0.002
    };
    let all: [f64; 6] = [
        sensitivity(&|own, by| own.projectile.mass_kg *= by),
        sensitivity(&|own, by| own.projectile.tip_radius_m *= by),
        sensitivity(&|own, by| own.target.thickness_m *= by),
        sensitivity(&|own, by| own.target.density_kg_m3 *= by),
        sensitivity(&|own, by| own.target.flow_strength_pa *= by),
        sensitivity(&|own, by| own.target.drag_coefficient *= by),
    ];
    let inputs = 0.03 * all.iter().map(|s| s * s).sum::<f64>().sqrt();
    let [both, bare] = &report.summaries[..] else { panic!("{:?}", report.summaries) };
    assert!(both.has_model_error && !bare.has_model_error);
    for (summary, median, spread) in
        [(bare, 232.295_378, inputs), (both, 232.295_378 / 1.25, inputs.hypot(0.08))]
    {
        assert!((summary.nominal.unwrap() / median - 1.0).abs() < 1e-8);
        assert!((summary.quantile(0.5).unwrap().value / median - 1.0).abs() < 0.02);
        let found = summary.deviation.unwrap() / median;
        assert!((found / spread - 1.0).abs() < 0.15, "{found} {spread}");
    }
    // The law's limit is 1.25 times the median of the limits. A shot at that velocity perforates with the normal probability of ln 1.25
    // over the scatter, to which `v_i` adds. Three standard errors for 400 samples are 0.02.
    let z = 1.25_f64.ln() / inputs.hypot(0.08).hypot(0.03);
    let density = |at: f64| (-0.5 * at * at).exp() / std::f64::consts::TAU.sqrt();
    let below = (0..1000).map(|i| density(z * (f64::from(i) + 0.5) / 1000.0)).sum::<f64>();
    let expected = 0.5 + z * below / 1000.0;
    assert!((report.perforated.unwrap().least - expected).abs() < 0.02, "{expected}");
}

/// Wilson's interval by hand for 10 and for 34 of 40: 0.1419 to 0.4019 and 0.7093 to 0.9294.
#[test]
fn valid_undecided_samples_count_as_stopped_and_as_perforated() {
    let mut counts = OutcomeCounts::default();
    for (outcome, count) in
        [(Outcome::Arrested, 6), (Outcome::Perforated, 10), (Outcome::Moving, 24)]
    {
        (0..count).for_each(|_| counts.add(PointOutcome::Ended(outcome)));
    }
    let share = perforated(counts).unwrap();
    let found = [share.least, share.most, share.low_95, share.high_95];
    for (found, right) in found.into_iter().zip([0.25, 0.85, 0.1419, 0.9294]) {
        assert!((found - right).abs() < 1e-4, "{share:?}");
    }
}
