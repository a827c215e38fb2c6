//! Error estimates of runs, compared with the true errors over random scenes.
//!
//! The truth is another family of methods: DOP853 at three tolerances that agree. Shortfalls are printed (`--nocapture`) as a person would type
//! them.

use std::ops::ControlFlow;
use std::sync::Arc;

use cmra_engine::model::impact::IntegrationMethod;
use cmra_engine::model::impact::step_by;
use cmra_engine::model::run::{EstimateBasis, Outcome, Run, RunSnapshot};
use cmra_engine::model::scene::{InterfaceLaw, Scene};
use cmra_engine::model::simulate::{Settings, simulate};
use cmra_engine::numerics::larger;
use cmra_studies::report::run as report;
use cmra_studies::study::quantities;

use crate::random::{Random, scene, typed};
use crate::support;

/// Number of scenes compared, and of those compared in every run of the tests.
const JUDGED: usize = 5_000;
const SAMPLE: usize = 150;
/// Tolerances of the runs, each with the percentages of outputs whose error may exceed the estimate, and ten times the estimate.
const TOLERANCES: [(f64, f64, f64); 3] = [(1e-3, 2.5, 0.6), (1e-6, 0.5, 0.1), (1e-9, 0.2, 0.1)];
/// Ratio of estimate to error above which an estimate is too high, and the percentage of them that may be.
const ABOVE: f64 = 1e3;
const TOO_HIGH: f64 = 1.0;
/// Outputs of one scene whose plate is displaced once.
const ONE_SCENE: usize = 3;
/// Least estimate from a second computation.
const LEAST: f64 = 1e-12;
/// Steps a run may take here.
const STEPS_MAX: usize = 20_000;
/// Tolerances of the reference. Its greatest forces lie on its interpolant, of a lower order than its steps: two tolerances may have nearly
/// the same error of it.
const REFERENCES: [f64; 3] = [1e-12, 1e-13, 1e-14];
/// Uncertainty of the reference: three times the greatest difference from its tightest tolerance, and what all have in common. It lands on
/// singular zeros within its own rounding.
const UNCERTAINTY: f64 = 3.0;
const EXPLICIT_FLOOR: f64 = 2e-12;
/// A reference with a greater uncertainty is not used.
const UNCERTAINTY_MAX: f64 = 1e-10;
/// How far below the true error the estimate of any result of a shot may be.
const BELOW: f64 = 10.0;
/// Shots of which every result is compared with itself, and the loose tolerance they are computed at.
const SHOTS: usize = 300;
const LOOSE: f64 = 1e-4;
/// Least estimate that says that no digit is known.
const KNOWN_DIGITS: f64 = 0.1;
/// Percentage of the results at the loose tolerance that may be far too low.
const FAR_TOO_LOW: f64 = 0.3;
const SEED: u64 = 0x5eed_2007_0412;

/// A run by DOP853, if it came to its end.
fn by_dop853(scene: &Arc<Scene>, tolerance: f64) -> Option<Run> {
    let go_on = &mut |_: &RunSnapshot<'_>| ControlFlow::Continue(());
    let run = step_by(IntegrationMethod::Dop853(tolerance), scene, go_on).unwrap()?;
    (run.end.is_complete() && run.outcome != Outcome::Moving).then_some(run)
}

#[test]
fn valid_estimates_are_above_the_true_errors() {
    assert_estimates_hold(SAMPLE);
}

#[test]
#[ignore = "takes minutes: five thousand scenes in place of the sample"]
fn valid_all_thousand_estimates_are_above_the_true_errors() {
    assert_estimates_hold(JUDGED);
}

/// Counts of compared outputs, errors above the estimate, errors above ten times the estimate, estimates above the least, and of these the
/// ones that are too high.
#[derive(Clone, Copy, Debug, Default)]
struct Counts {
    outputs: usize,
    low: usize,
    far_too_low: usize,
    above_least: usize,
    too_high: usize,
}

/// Compares every estimated result of random scenes, one in four with a plastic interface, at three tolerances.
fn assert_estimates_hold(count: usize) {
    let mut random = Random(SEED);
    let mut counts = [Counts::default(); 3];
    for index in 0..count {
        let changes = random.changes();
        let mut own = Scene::clone(&scene(&changes));
        if index % 4 == 0 {
            own.interface.law = InterfaceLaw::Plastic;
        }
        let shot = Arc::new(own.clone());
        let [Some(loose), Some(tight), Some(truth)] = REFERENCES.map(|it| by_dop853(&shot, it))
        else {
            continue;
        };
        for (counts, (tolerance, ..)) in counts.iter_mut().zip(TOLERANCES) {
            own.run.tolerance = tolerance;
            let run = run_of(&Arc::new(own.clone()));
            let outcomes = [run.outcome, loose.outcome, tight.outcome];
            if run.end.is_complete() && outcomes == [truth.outcome; 3] {
                let law = own.interface.law.word();
                let told =
                    format!("{} --set interface={law} --set tol={tolerance:e}", typed(&changes));
                compare(counts, &run, [&loose, &tight, &truth], &told);
            }
        }
    }
    for (counts, (tolerance, low, far_too_low)) in counts.into_iter().zip(TOLERANCES) {
        println!("{tolerance:e}: {counts:?}");
        let within =
            |part: usize, whole: usize, percent: f64| part as f64 <= percent / 100.0 * whole as f64;
        assert!(counts.outputs > 3 * count, "{counts:?}");
        assert!(within(counts.low, counts.outputs, low), "{tolerance:e}: {counts:?}");
        assert!(
            within(counts.far_too_low, counts.outputs, far_too_low),
            "{tolerance:e}: {counts:?}"
        );
        // One scene of a sample may be too high in three outputs that are one: displacement, greatest displacement and stroke.
        let too_high = counts.too_high.saturating_sub(ONE_SCENE);
        assert!(within(too_high, counts.above_least, TOO_HIGH), "{tolerance:e}: {counts:?}");
    }
}

/// Counts the outputs of a run against those of the references, the tightest last.
fn compare(counts: &mut Counts, run: &Run, references: [&Run; 3], told: &str) {
    for (name, estimate) in &run.estimate.by_result {
        let quantity = quantities::find(name).unwrap();
        let [Some(loose), Some(tight), Some(truth)] = references.map(|it| quantity.value(it))
        else {
            continue;
        };
        let Some(own) = quantity.value(run) else { continue };
        let spread = |other: f64| (other / truth - 1.0).abs();
        let off = UNCERTAINTY * larger(spread(loose), spread(tight)) + EXPLICIT_FLOOR;
        let error = (own / truth - 1.0).abs();
        if own == 0.0 || off.is_nan() || off >= UNCERTAINTY_MAX || !error.is_finite() {
            continue;
        }
        counts.outputs += 1;
        counts.low += usize::from(error > estimate + off);
        counts.above_least += usize::from(*estimate > LEAST);
        let is_too_high =
            *estimate > LEAST && *estimate > ABOVE * if error > off { error } else { off };
        counts.too_high += usize::from(is_too_high);
        let is_far_too_low = error > 10.0 * estimate + off;
        counts.far_too_low += usize::from(is_far_too_low);
        if is_far_too_low || is_too_high {
            println!("{name}: estimate {estimate:.1e}, error {error:.1e} ({off:.0e}): {told}");
        }
    }
}

fn run_of(scene: &Arc<Scene>) -> Run {
    let mut steps = 0;
    let settings = Settings { estimate: true, ..Settings::BARE };
    simulate(scene, &settings, &mut |_| {
        steps += 1;
        if steps > STEPS_MAX { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    })
    .unwrap()
}

/// Every estimated result, after the contact too, at a loose tolerance against the same run at a tight one: the estimate is below the error
/// by more than a factor of ten in at most `FAR_TOO_LOW` percent. Values whose estimate says that no digit is known do not count.
#[test]
fn each_estimate_covers_the_difference_to_a_tight_run() {
    let mut random = Random(SEED + 2);
    let (mut judged, mut perforated, mut outputs, mut told) = (0, 0, 0, Vec::new());
    for index in 0..SHOTS {
        let mut changes = random.changes();
        let last = changes.len() - 1;
        changes[last].1 = LOOSE;
        let mut own = Scene::clone(&scene(&changes));
        if index % 3 == 0 {
            own.interface.law = InterfaceLaw::Plastic;
        }
        let run = run_of(&Arc::new(own.clone()));
        own.run.tolerance = 1e-12;
        let tight = run_of(&Arc::new(own));
        if !(run.end.is_complete() && tight.end.is_complete()) || run.outcome != tight.outcome {
            continue;
        }
        judged += 1;
        perforated += usize::from(run.outcome == Outcome::Perforated);
        for (name, relative) in run.estimate.by_result.iter().filter(|it| it.1 < KNOWN_DIGITS) {
            let column = quantities::find(name).unwrap();
            let Some((own, exact)) = column.value(&run).zip(column.value(&tight)) else { continue };
            let off = (own / exact - 1.0).abs();
            outputs += 1;
            if off > BELOW * relative {
                told.push(format!("{name}: {relative:.1e}, not {off:.1e}: {}", typed(&changes)));
            }
        }
    }
    assert!(judged > SHOTS * 9 / 10 && perforated > SHOTS / 5, "{perforated} of {judged}");
    println!("{} of {outputs}: {}", told.len(), told.join("\n"));
    assert!(told.len() as f64 <= FAR_TOO_LOW / 100.0 * f64::from(outputs), "{}", told.join("\n"));
}

/// At a loose tolerance a plate on a stiff spring is held again while the nose leaves; a tight run follows it. The estimate shows the
/// difference.
#[test]
fn a_plate_that_is_held_again_counts_in_the_estimate() {
    let shot = "n=0.46919 k=5.9057e7 gamma=5.5856 v_i=978.32 h=14.49mm S_y=2.3515e8 C_d=0.066859";
    let at =
        |tolerance: &str| run_of(&Arc::new(support::scene(&format!("{shot} tol={tolerance}"))));
    let (loose, tight) = (at("1e-3"), at("1e-12"));
    for name in ["exit_time_s", "residual_velocity_m_s"] {
        let value = |run: &Run| quantities::find(name).unwrap().value(run).unwrap();
        let off = (value(&loose) / value(&tight) - 1.0).abs();
        assert!(off > 1e-9 && loose.error_of(name).unwrap() > off, "{name}: {off}");
    }
}

/// The exit time at 232.7 m/s on a rigid mount, s.
const EXIT_TIME_S: f64 = 0.000_571_271_081_253_093;

/// Times of closed forms: 232.7 m/s is just above the limit of 232.295 m/s. The time is the integral of dq/u, by
/// tanh-sinh quadrature of the same closed form with 30 digits.
#[test]
fn the_time_of_an_exit_just_above_the_rigid_limit_is_right_to_rounding() {
    let mut own = Scene::default();
    own.plate.mount = cmra_engine::model::scene::Mount::Rigid;
    own.projectile.velocity_m_s = 232.7;
    for series in [true, false] {
        let settings = Settings { series, ..Settings::default() };
        let run = simulate(&Arc::new(own.clone()), &settings, &mut |_| ControlFlow::Continue(()));
        let run = run.unwrap();
        let error = (run.departure.exit_time_s.unwrap() / EXIT_TIME_S - 1.0).abs();
        let estimate = run.estimate.main.unwrap();
        // Rounding grows by the square of 232.7 m/s over the residual velocity.
        assert!(error < 3e-13, "{error:e}");
        assert!(error <= BELOW * estimate, "{error:e} {estimate:e}");
    }
}

/// Scenes in which both computations of an estimate damp the same oscillation of the plate about its balance, or begin with nearly the same
/// error of a singular damper, and the greatest displacement, m. The first three by extrapolation (Gragg, Bulirsch, Stoer) with 64-bit
/// mantissas from the power series at first contact, the last by DOP853 with steps to 1e-14.
const SHARED: [(&str, f64); 4] = [
    (
        "n=0.4856 k=2.9388e8 gamma=2.6154 v_i=117.52 h=28.28mm S_y=5.2848e7 C_d=0.21269",
        3.099_255_713_974_69e-10,
    ),
    (
        "n=0.5311 k=8.7215e8 gamma=1.3572 v_i=429.08 h=1.2mm S_y=1.7344e8 C_d=0.24366",
        5.069_221_179_159_78e-10,
    ),
    (
        "n=0.5 k=6.1013e7 gamma=15.331 v_i=52.202 h=3.4923mm S_y=1.6527e7 C_d=0.72756",
        8.952_632_900_395_20e-10,
    ),
    (
        "n=0.75231 m=2.0555 k=5.7439e5 b=1.1003e4 d=24.781um gamma=2.4165 v_i=7.1528 h=35.701mm \
         theta=0.9095511061614223rad S_y=1.4672e9 C_d=0.24975 interface=plastic",
        1.095_407_655_057_47e-5,
    ),
];

#[test]
fn valid_estimates_cover_what_both_computations_share() {
    for (changes, exact_m) in SHARED {
        for tolerance in [1e-3, 1e-6, 1e-9] {
            let mut own =
                cmra_engine::model::variables::changed(Scene::default(), changes).unwrap();
            own.run.tolerance = tolerance;
            let run = run_of(&Arc::new(own));
            let error = (run.max_plate_displacement_m.unwrap() / exact_m - 1.0).abs();
            let estimate = run.error_of("max_plate_displacement_m").unwrap();
            assert!(error <= estimate, "{changes} {tolerance:e}: {error:e} {estimate:e}");
            // And not by much more than a safety factor.
            assert!(
                estimate < 1e2 * (error + 1e-12),
                "{changes} {tolerance:e}: {error:e} {estimate:e}"
            );
        }
    }
}

/// Slips that an early decision leaves out push harder in a deeper hole, and fused bodies start with the force of the spring at the arrest:
/// values by DOP853 with steps to 1e-14, which follow both.
#[test]
fn valid_estimates_cover_forces_that_follow_from_what_is_left_out() {
    for (changes, name, exact) in [
        (
            "k=3.243e4 gamma=2.6123 v_i=21.758 h=2.3532mm S_y=1.3198e7 C_d=1.2631 interface=plastic",
            "peak_contact_force_n",
            814.150_935_799_247,
        ),
        (
            "n=0.4511 m=2.0329 k=1.6476e8 b=753.21 gamma=1.5994 v_i=93.499 h=16.558mm S_y=4.2883e7 C_d=1.5866",
            "interface_demand_ratio",
            0.384_704_288_945_153,
        ),
    ] {
        let mut own = cmra_engine::model::variables::changed(Scene::default(), changes).unwrap();
        own.run.tolerance = 1e-3;
        let run = run_of(&Arc::new(own));
        let value = quantities::find(name).unwrap().value(&run).unwrap();
        let (error, estimate) = ((value / exact - 1.0).abs(), run.error_of(name).unwrap());
        assert!(error > 1e-8 && error <= estimate, "{changes}: {error:e} {estimate:e}");
    }
}

/// The force of a contact that a cubic spring opens at its zero has about a triple zero there. Runge-Kutta of order 4 in 80 bits, with 600,000
/// and 1,200,000 steps.
#[test]
fn valid_estimates_cover_an_ill_conditioned_end_of_the_contact() {
    let changes = "v_i=18.8896 gamma=0.553923 d=0.00218263 k=7317.16 n=3 x_stop=0.19407 stop_kind=elastic k_stop=143305 \
                   model=lumped k_load=3.65899e6 k_unload=1.35938e8 b_2=378.052";
    for tolerance in [1e-3, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-12] {
        let mut own = cmra_engine::model::variables::changed(Scene::default(), changes).unwrap();
        own.run.tolerance = tolerance;
        let run = run_of(&Arc::new(own));
        let found_s = run.departure.separation.unwrap().t_s;
        let error = (found_s / 0.038_161_108_368_7 - 1.0).abs();
        let estimate = run.error_of("separation_time_s").unwrap();
        assert!(error <= estimate, "{tolerance:e}: {error:e} {estimate:e}");
    }
}

/// Two computations that end differently say nothing of each other.
#[test]
fn an_estimate_from_two_outcomes_is_unknown() {
    let scene = Arc::new(Scene::default());
    let mut run = run_of(&scene);
    let mut second = run.clone();
    second.outcome = Outcome::Perforated;
    second.departure.exit_time_s = Some(1.0);
    run.estimate.by_result.clear();
    cmra_engine::model::estimate::set(&mut run, &second, EstimateBasis::SecondComputation);
    assert_eq!(run.estimate.basis, Some(EstimateBasis::OutcomeDiffers(Outcome::Perforated)));
    assert_eq!(quantities::find("error_estimate").unwrap().value(&run), None);
    assert!(run.estimate.by_result.is_empty());
}

#[test]
fn a_rigid_or_free_plate_is_held_against_its_closed_form() {
    for (changes, basis) in [
        ("mount=rigid", EstimateBasis::ClosedForm),
        ("k=0", EstimateBasis::ClosedForm),
        ("mount=rigid v_i=1e-10", EstimateBasis::ClosedForm),
        ("k=0 v_i=1e-15", EstimateBasis::ClosedForm),
        ("k=1e5", EstimateBasis::SecondComputation),
        ("mount=rigid horizon=1ms", EstimateBasis::SecondComputation),
    ] {
        let scene = cmra_engine::model::variables::changed(Scene::default(), changes).unwrap();
        let run = run_of(&Arc::new(scene));
        assert_eq!(run.estimate.basis, Some(basis), "{changes}");
        assert!(run.error_of("peak_contact_force_n").unwrap() <= LEAST, "{changes}");
        assert!(run.estimate.main.unwrap() <= LEAST, "{changes}: {:?}", run.estimate.main);
    }
}

/// An estimate belongs to a value: where a result is null, its estimate is absent, and that of the depth is null. Over presets, stacks, what
/// is not measured, and shots drawn at random.
#[test]
fn a_result_without_a_value_has_no_error_estimate() {
    let presets = support::files_in(&support::in_repository("presets"), "toml");
    let presets = presets
        .iter()
        .map(|path| (path.display().to_string(), Arc::new(support::scene_file(path).unwrap())));
    let thin = "mount=rigid nose=blunt m_p=197g R=10mm rho=7850 closure=cylindrical E=200GPa Y=490MPa UTS=567MPa h=8mm";
    let named = [format!("{thin} v_i=300"), format!("{thin} v_i=60"), "k=0 v_i=400".to_owned()];
    let named = named.into_iter().map(|pairs| (pairs.clone(), Arc::new(support::scene(&pairs))));
    let mut random = Random(SEED);
    let drawn = std::iter::repeat_with(move || random.changes()).take(SAMPLE / 2);
    let drawn = drawn.map(|changes| (typed(&changes), scene(&changes)));
    let (mut nulls, mut found) = (0, 0);
    for (name, scene) in presets.chain(named).chain(drawn) {
        let go_on = &mut |_: &RunSnapshot<'_>| ControlFlow::Continue(());
        let Ok(run) = simulate(&scene, &Settings::default(), go_on) else { continue };
        let object: serde_json::Value =
            serde_json::from_str(&report::json("", &run, None)).unwrap();
        let estimates = object["error_estimates"].as_object().unwrap();
        for (key, estimate) in estimates {
            assert!(!object[key].is_null(), "{key}: {estimate} of {name}");
        }
        nulls += quantities::of_runs().filter(|it| object[it.name].is_null()).count();
        found += estimates.len();
        let depth = ["error_estimate", "final_penetration_m"].map(|key| object[key].is_null());
        assert!(depth[0] || !depth[1], "{name}");
    }
    assert!(nulls > 100 && found > 100, "{nulls} {found}");
}
