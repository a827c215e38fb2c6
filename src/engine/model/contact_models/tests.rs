//! The limits each model has by itself, and the listing's numbers by an independent port of it.

use std::f64::consts::PI;
use std::ops::ControlFlow;
use std::sync::Arc;

use super::lumped::stiffnesses_n_m;
use crate::model::appendix::Scheme;
use crate::model::mechanism::{Inertia, Mechanism};
use crate::model::run::{EndReason, EventKind, NotModelled, Outcome, Run, RunWarning, Sample};
use crate::model::scene::{Listing, Scene, SpringKind};
use crate::model::simulate::{self, RunSnapshot, Settings};
use crate::model::variables::scene_with;

/// The travel of the default plate that is a unit of depth: it dishes by one diameter.
const TRAVEL_PER_DEPTH: f64 = (0.0254 + 2.0 * 0.00635) / 0.0254;

fn run_of(scene: &Scene) -> Run {
    let go_on = &mut |_: &RunSnapshot<'_>| ControlFlow::Continue(());
    simulate::simulate(&Arc::new(scene.clone()), &Settings::default(), go_on).unwrap()
}

fn run(pairs: &str) -> Run {
    run_of(&scene_with(pairs))
}

fn depth_mm(run: &Run) -> f64 {
    run.penetration.final_m.unwrap() * 1e3
}

fn close(value: f64, expected: f64, relative: f64) -> bool {
    (value / expected - 1.0).abs() < relative
}

/// The integral of the contact force over time, by the trapezoid of the series' points.
fn impulse(run: &Run, until_s: f64) -> f64 {
    let pairs = run.series.windows(2).take_while(|pair| pair[1].t_s <= until_s * (1.0 + 1e-12));
    let mean = |a: &Sample, b: &Sample| 0.5 * (a.contact_force_n + b.contact_force_n);
    pairs.map(|pair| mean(&pair[0], &pair[1]) * (pair[1].t_s - pair[0].t_s)).sum()
}

#[test]
fn valid_the_half_sine_carries_the_whole_momentum() {
    let rigid = run("model=half-sine t_d=150e-6 mount=rigid");
    assert_eq!(rigid.percent_of_baseline(), Some(100.0));
    for pairs in ["gamma=1 k=0", "gamma=1 k=1e5", "gamma=3 k=1e6"] {
        let run = run(&format!("model=half-sine t_d=150e-6 {pairs}"));
        assert!(close(impulse(&run, 150e-6), 0.0295 * 100.0, 1e-3), "{pairs}");
        let amplitude = 0.0295 * 100.0 * PI / (2.0 * 150e-6);
        assert!(close(run.peak_contact_force_n.unwrap(), amplitude, 1e-12));
        assert!(run.ledger.residual().abs() < 1e-9, "{}", run.ledger.residual());
        // A plate that is free to move has the projectile's velocity before the end.
        let overrun = |warning: &RunWarning| matches!(warning, RunWarning::Overruns { .. });
        assert!(run.warnings.iter().any(overrun), "{pairs}");
    }
}

#[test]
fn valid_the_initial_velocity_is_the_limit_of_short_histories() {
    for pairs in ["b=0", "b=200", "theta=30deg"] {
        let farthest =
            |model: &str| run(&format!("gamma=1.5 {pairs} {model}")).max_plate_displacement_m;
        let limit = farthest("model=initial-velocity").unwrap();
        let mut last = f64::INFINITY;
        for t_d in ["1e-4", "1e-5", "1e-6", "1e-7"] {
            let found = farthest(&format!("model=half-sine t_d={t_d}")).unwrap();
            let error = (found / limit - 1.0).abs();
            assert!(error < 0.3 * last, "{pairs} {t_d}: {error}");
            last = error;
        }
        assert!(last < 1e-4, "{last}");
    }
}

#[test]
fn valid_the_lumped_interface_conserves_momentum_and_dissipates_by_its_hysteresis() {
    for (pairs, gamma) in [("gamma=2 k=0", 2.0), ("mount=rigid", f64::INFINITY)] {
        let run = run(&format!("model=lumped {pairs} k_load=2e6 k_unload=8e6"));
        assert_eq!(run.outcome, Outcome::Separated);
        for sample in run.series.iter().filter(|_| gamma.is_finite()) {
            let (v, w) = (sample.projectile_velocity_m_s, sample.plate_velocity_m_s);
            assert!(close(v + gamma * w, 100.0, 1e-9), "{v} {w}");
        }
        // Half of the relative speed comes back: sqrt(k_load/k_unload).
        let last = run.series.last().unwrap();
        let slip = last.projectile_velocity_m_s - last.plate_velocity_m_s;
        assert!(close(slip, -50.0, 1e-12), "{slip}");
        let mu = 0.0295 / (1.0 + 1.0 / gamma);
        assert!(close(run.ledger.penetration_j, 0.5 * mu * 1e4 * 0.75, 1e-12));
        // delta_max = u sqrt(mu/k_load); a quarter of it springs back.
        let pressed_m = 100.0 * (mu / 2e6f64).sqrt();
        assert!(close(run.peak_contact_force_n.unwrap(), 2e6 * pressed_m, 1e-12));
        let pressed_mm = 1e3 * pressed_m / TRAVEL_PER_DEPTH;
        assert!(close(depth_mm(&run), 0.75 * pressed_mm, 1e-12));
        assert!(close(run.first_arrest.unwrap().penetration_m * 1e3, pressed_mm, 1e-12));
    }
}

#[test]
fn the_lumped_interface_only_pushes_and_its_ledger_closes_on_a_spring_with_a_damper() {
    let run = run("model=lumped k=1e6 b=20 b_2=30");
    let strongest = run.peak_contact_force_n.unwrap();
    assert!(run.series.iter().all(|row| row.contact_force_n > -1e-6 * strongest));
    assert!(run.ledger.residual().abs() < 1e-8, "{}", run.ledger.residual());
    assert!(run.events.iter().any(|event| event.kind == EventKind::FirstArrest));
    assert!(run.estimate.main.unwrap() < 1e-8);
}

#[test]
fn values_left_open_are_those_of_the_hydrodynamic_contact_on_a_rigid_mount() {
    let (load_n_m, unload_n_m) = stiffnesses_n_m(&Scene::default());
    // Rigid, Table 9.1: 7.113055 mm deep, so 10.669583 mm of travel.
    let travel = 7.113_055e-3 * TRAVEL_PER_DEPTH;
    assert!(close(load_n_m, 0.0295 * 1e4 / (travel * travel), 1e-6));
    assert!(close(unload_n_m, 100.0 * load_n_m, 1e-12));
    let run = run("model=lumped mount=rigid");
    assert!(close(run.first_arrest.unwrap().penetration_m, 7.113_055e-3, 1e-6));
    assert_eq!(run.outcome, Outcome::Separated);
}

/// The plate begins with the common velocity, on the very zero of a power law: all its energy goes into the spring.
#[test]
fn valid_a_joined_plate_goes_as_far_on_any_spring_as_its_energy_allows() {
    let kinds = SpringKind::WORDS.map(|kind| format!("gamma=2 v_i=20 spring={kind}"));
    let powers = [0.5, 1.308, 1.5, 2.5, 3.5].into_iter().flat_map(|n| {
        ["k=1e3 v_i=184.738", "k=1e3 v_i=600", "k=1e6 v_i=20"].map(|k| format!("n={n} {k}"))
    });
    for pairs in kinds.into_iter().chain(powers) {
        let scene = scene_with(&format!("model=initial-velocity {pairs}"));
        let spring = Mechanism::from_scene(&scene).spring;
        let joined_kg = 0.0295 + scene.plate_mass_kg() + Inertia::from_scene(&scene).added_kg;
        let energy_j = 0.5 * (0.0295 * scene.projectile.velocity_m_s).powi(2) / joined_kg;
        let run = run_of(&scene);
        assert_eq!((run.penetration.final_m, run.peak_contact_force_n), (None, None));
        assert_eq!(run.first_arrest, None);
        assert!(run.ledger.residual().abs() < 1e-11, "{pairs}: {}", run.ledger.residual());
        if let Some(reach_m) = run.max_plate_displacement_m {
            assert!(close(spring.energy(reach_m), energy_j, 1e-11), "{pairs}: {reach_m}");
        } else {
            assert!(spring.reach(0.0, energy_j, 1.0).is_infinite(), "{pairs}");
        }
    }
}

#[test]
fn every_model_closes_its_ledger_on_every_spring_and_holds_on_every_stop() {
    let springs = SpringKind::WORDS.map(|kind| (format!("gamma=2 spring={kind} b=20"), None));
    let place_m = 0.5e-3 * (1.0 + 1e-9);
    let stops = [("e=0", place_m), ("e=0.5", place_m), ("stop_kind=elastic", 2.5e-3)];
    let stops = stops.map(|(stop, reach_m)| (format!("x_stop=0.0005 {stop}"), Some(reach_m)));
    for model in ["half-sine", "initial-velocity", "lumped"] {
        for (pairs, reach_m) in springs.iter().chain(&stops) {
            let run = run(&format!("model={model} {pairs}"));
            assert!(run.end.is_complete(), "{model} {pairs}: {:?}", run.end);
            let residual = run.ledger.residual();
            assert!(residual.abs() < 1e-8, "{model} {pairs}: {residual:e}");
            if let Some(reach_m) = reach_m {
                let reached_m = run.max_plate_displacement_m.unwrap();
                assert!(reached_m <= *reach_m, "{model} {pairs}: {reached_m}");
            }
        }
    }
}

/// By the listing, with the strength of its constants: twice 75.8 `MPa`.
fn listing(pairs: &str) -> Run {
    listed(pairs, Listing::default())
}

fn listed(pairs: &str, listing: Listing) -> Run {
    let mut scene = scene_with(&format!("model=appendix S_y=1.516e8 {pairs}"));
    scene.contact.appendix = Listing { step_s: scene.contact.appendix.step_s, ..listing };
    run_of(&scene)
}

/// Depths by an independent port of the listing, as printed and by the relative travel: the ladder of time steps on a rigid mount, mm,
/// and percents of 7.129 mm on springs.
#[test]
fn valid_depths_are_those_of_an_independent_port_by_either_coupling() {
    let ladder = [
        ("rho=2710 dt=1e-6", 7.1547),
        ("rho=2710 dt=1e-7", 7.1288),
        ("dt=2e-6", 7.1809),
        ("dt=1e-6", 7.1519),
        ("dt=5e-7", 7.1375),
        ("dt=2e-7", 7.1289),
    ];
    let on_springs = [
        ("gamma=0.8", [78.4, 60.1]),
        ("gamma=1", [82.4, 64.4]),
        ("gamma=2", [92.2, 76.7]),
        ("gamma=5", [98.4, 88.6]),
        ("gamma=7", [99.2, 91.5]),
        ("d=0.01", [80.92, 62.67]),
        ("d=0.1", [70.49, 49.94]),
        ("d=0.5", [40.06, 23.65]),
    ];
    let ladder = ladder.map(|(pairs, mm)| (format!("mount=rigid {pairs}"), [mm, mm], 6e-5));
    let on_springs = on_springs
        .map(|(pairs, percents)| (pairs.to_owned(), percents.map(|it| 0.07129 * it), 4e-3));
    for (pairs, expected_mm, tolerance_mm) in ladder.into_iter().chain(on_springs) {
        for (corrects_coupling, mm) in [false, true].into_iter().zip(expected_mm) {
            let listing = Listing { corrects_coupling, ..Listing::default() };
            let found = depth_mm(&listed(&format!("rho=2780 {pairs}"), listing));
            assert!((found - mm).abs() < tolerance_mm, "{pairs} {corrects_coupling}: {found}");
        }
    }
}

/// The relative travel of a free plate is that of one at rest and a slower shot; as printed the first step takes the shot's own velocity.
#[test]
fn valid_a_plate_that_moves_at_first_contact() {
    let fixed = Listing::coupled(1e-7);
    let depth_mm = |pairs: &str| depth_mm(&listed(&format!("dt=1e-7 k=0 {pairs}"), fixed));
    let (moving, resting) = (depth_mm("v_i=100 w_0=20"), depth_mm("v_i=80"));
    assert!(close(moving, resting, 1e-9), "{moving}, not {resting}");
    let start = Scheme::from_scene(&scene_with("d=0.01 w_0=20"), Listing::default()).start;
    assert_eq!((start.plate, start.slip_m_s), ([-0.01, 20.0], 100.0));
}

/// `impdur`, ms, `MaxPen`, mm, `PeakForce`, kN, and `MaxDisp`, mm, of a port of the listing line by line, with the stop time `tmax` for the horizon.
#[test]
fn valid_the_listing_prints_what_an_independent_port_of_it_prints() {
    for (pairs, expected) in [
        (
            "m_2=0.1 k=0 rho=2780 horizon=2e-4",
            [0.150, 6.880_580_860_392, 19.256_917_122_32, 2.512_974_287_221],
        ),
        ("horizon=2e-4", [0.109, 5.871_654_900_887, 19.095_300_870_21, 6.554_956_162_982]),
        ("horizon=2e-3", [0.109, 5.871_654_900_887, 19.095_300_870_21, 38.174_613_125_89]),
        // The list of positions begins with a zero: these plates are still behind it.
        ("d=0.5 horizon=2e-4", [0.045, 2.855_855_941_699, 13.389_516_170_97, 0.0]),
        ("d=0.01 b=2000 horizon=2e-4", [0.170, 7.116_038_466_753, 19.292_006_755_39, 0.0]),
        (
            "h=0.003 v_i=300 horizon=2e-4",
            [0.076, 9.488_956_883_539, 17.978_646_182_61, 3.856_748_279_311],
        ),
        (
            "gamma=2 k=1e6 n=0.5 b=100 horizon=3e-4",
            [0.186, 7.169_136_517_047, 19.316_904_863_97, 0.671_413_638_827_7],
        ),
    ] {
        let run = listing(pairs);
        let contact_s =
            run.first_arrest.map_or(run.departure.exit_time_s, |arrest| Some(arrest.t_s));
        let found = [
            1e3 * contact_s.unwrap(),
            depth_mm(&run),
            1e-3 * run.peak_contact_force_n.unwrap(),
            1e3 * run.max_plate_displacement_m.unwrap(),
        ];
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found - expected).abs() <= 1e-10 * expected, "{pairs}: {found} {expected}");
        }
    }
}

#[test]
fn a_listing_without_a_stop_time_says_how_far_the_plate_is_when_its_steps_are_used_up() {
    // The damper lets the plate creep towards neutral, which it does not reach.
    let run = listing("d=0.1 b=1000 n=2.5 dt=1e-7");
    assert_eq!(run.end, EndReason::StepBudget);
    assert_eq!(
        (run.max_plate_displacement_m, run.at_least.plate_displacement_m),
        (None, Some(0.0))
    );
    assert!(run.penetration.baseline_m.is_some());
    assert_eq!(listing("dt=1e-11 mount=rigid").end, EndReason::StepBudget);
    assert!(listing("k=0").max_plate_displacement_m.is_none());
}

#[test]
fn valid_every_error_corrected_the_listing_converges_to_the_simulation() {
    let corrected = Listing {
        corrects_stopping: true,
        corrects_afterwards: true,
        corrects_scheme: true,
        ..Listing::coupled(1e-7)
    };
    let own = listed("b=100 dt=1e-7", corrected);
    let reference = run("b=100 S_y=1.516e8");
    assert!(close(depth_mm(&own), depth_mm(&reference), 1e-6));
    let travel = reference.max_plate_displacement_m.unwrap();
    assert!(close(own.max_plate_displacement_m.unwrap(), travel, 1e-5));
    assert!(own.estimate.main.unwrap() < 1e-5);
}

#[test]
fn ignored_jumps_end_in_no_number_and_what_the_listing_lacks_is_noted() {
    let ignored = Listing { corrects_jumps: false, ..Listing::default() };
    let run = listed("mount=rigid", ignored);
    assert_eq!(run.end, EndReason::NonFinite);
    assert!(!run.series.is_empty() && run.penetration.final_m.is_none());
    for (pairs, missing) in
        [("x_stop=0.001", NotModelled::Stop), ("h=0.003 v_i=300", NotModelled::PartingBehindHole)]
    {
        assert!(listing(pairs).warnings.contains(&RunWarning::NotModelled(missing)), "{pairs}");
    }
}

/// Two equal masses on a spring that gives back what it took exchange their velocities: the projectile is at rest.
#[test]
fn valid_a_velocity_that_is_rounding_is_zero() {
    for k_load in ["1e7", "3e6", "1e5", "7.7e8"] {
        let run = run(&format!("gamma=1 k=0 model=lumped k_load={k_load} k_unload={k_load}"));
        assert_eq!(run.departure.separation.unwrap().velocity_m_s.to_bits(), 0, "{k_load}");
    }
}

/// A model that knows no depth has no baseline, which says nothing of a perforation; the hydrodynamic shot at 232.3 m/s does perforate
/// the plate on a rigid mount.
#[test]
fn valid_a_missing_baseline_is_a_perforation_only_where_the_model_has_a_depth() {
    let warns = |pairs: &str| run(pairs).warnings.contains(&RunWarning::NoBaseline);
    for pairs in ["", "v_i=10", "mount=rigid", "k=0", "v_i=500"] {
        assert!(!warns(&format!("model=initial-velocity {pairs}")), "{pairs}");
    }
    assert!(!warns("v_i=232.29") && warns("v_i=232.3") && warns("v_i=232.3 mount=rigid"));
}
