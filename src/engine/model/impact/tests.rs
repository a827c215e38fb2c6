//! Whole runs against values from other methods: stored digits, closed forms, the interface law's reference. `look` serves the tests of
//! the files as well.

use std::ops::ControlFlow;
use std::sync::Arc;

use super::equations::Equations;
use super::method::IntegrationMethod;
use super::modes::{Contact, HybridMode};
use super::parameters::ImpactParameters;
use super::run_by;
use super::state::State;
use super::transitions::first;
use crate::model::run::{EndReason, MechanismLoad, Outcome, Run, Sample, Settings};
use crate::model::scene::Scene;
use crate::model::simulate::simulate;
use crate::model::variables::scene_with;
use crate::numerics::larger;
use crate::numerics::random::Random;

fn run_to_end(scene: &Arc<Scene>, stepping: IntegrationMethod, settings: Settings) -> Run {
    run_by(scene, settings, stepping, &mut |_| ControlFlow::Continue(()))
}

fn shot(pairs: &str) -> Run {
    let scene = Arc::new(scene_with(pairs));
    let found = run_to_end(&scene, IntegrationMethod::Collocation(1e-12), Settings::BARE);
    assert_eq!(found.end, EndReason::Decided, "{pairs}");
    found
}

/// Looks at a state (q, u, x, w) after 0.1 ms, in a hole of 5 mm of travel.
pub(super) fn look<T>(
    pairs: &str,
    contact: Contact,
    [q_m, u_m_s, x_m, w_m_s]: [f64; 4],
    look: impl Fn(&Equations<'_>, &State) -> T,
) -> T {
    let setup = ImpactParameters::from_scene(&scene_with(pairs), 1e-12);
    let mode = HybridMode {
        contact,
        deepest_m: 5e-3,
        piece: setup.geometry.piece(q_m),
        is_pressed: x_m > setup.stop.position_m,
        w_side: 1f64.copysign(w_m_s),
        ..first(&setup).0
    };
    let state = State { t_s: 1e-4, q_m, u_m_s, x_m, w_m_s };
    look(&Equations { setup: &setup, mode: &mode }, &state)
}

pub(super) fn is_near(value: f64, exact: f64, fraction: f64) -> bool {
    (value - exact).abs() <= fraction * exact.abs()
}

/// A run without a horizon continues as one with a horizon does while a load can grow: here the greatest load comes after two reversals.
#[test]
fn valid_a_peak_load_after_many_reversals_counts() {
    let pairs = "n=0.17729 k=545.64 gamma=0.55492 v_i=54.733 h=1.1444mm S_y=169.78MPa C_d=0.25103 x_stop=0.73556mm stop_kind=elastic \
                 k_stop=7.5151e9 b_stop=65992";
    let [found, followed] =
        [pairs.to_owned(), format!("{pairs} horizon=10ms")].map(|pairs| shot(&pairs));
    let [found, followed] = [found, followed].map(|run| run.interface.demand_ratio.unwrap());
    assert!(followed > 0.72 && is_near(found, followed, 1e-9), "{found} {followed}");
}

/// On a free plate of the projectile's mass u = v cos(pi t/T): common velocity after half of the history, at a travel of v T/pi, and
/// where the plate is v T (1/4 - 1/(2 pi)); afterwards both go on together. A rigid mount sees all of it: v T/2.
#[test]
fn valid_a_half_sine_on_a_free_plate_and_on_a_rigid_mount() {
    let pi = std::f64::consts::PI;
    let free = shot("gamma=1 k=0 dishing=off model=half-sine t_d=1e-4");
    let arrest = free.first_arrest.unwrap();
    assert!(is_near(arrest.t_s, 5e-5, 1e-12));
    assert!(is_near(arrest.penetration_m, 0.01 / pi, 1e-12));
    assert!(is_near(arrest.plate_displacement_m, 0.01 * (0.25 - 0.5 / pi), 1e-12));
    assert!(is_near(free.peak_contact_force_n.unwrap(), 0.5 * pi * 0.0295 * 100.0 / 1e-4, 1e-12));
    let rigid = shot("mount=rigid dishing=off model=half-sine t_d=1e-4");
    assert!(is_near(rigid.penetration.final_m.unwrap(), 5e-3, 1e-12));
    assert!(is_near(rigid.first_arrest.unwrap().t_s, 1e-4, 1e-12));
}

/// Methods of four families, one of them without events: each approaches the same run.
#[test]
fn valid_every_method_steps_to_the_same_end() {
    for pairs in ["k=1e5", "k=1e5 interface=plastic gamma=0.8 b=50", "h=0.003 v_i=400 k=1e5"] {
        let scene = Arc::new(scene_with(pairs));
        let end = |stepping: IntegrationMethod| {
            let run = run_to_end(&scene, stepping, Settings::BARE);
            assert!(run.end.is_complete(), "{pairs}: {stepping:?} {:?}", run.end);
            let time_s = run.first_arrest.map(|arrest| arrest.t_s).or(run.departure.exit_time_s);
            [time_s, run.penetration.final_m, run.peak_contact_force_n].map(Option::unwrap)
        };
        let exact = end(IntegrationMethod::Collocation(1e-13));
        for (stepping, within) in [
            (IntegrationMethod::Radau5(1e-11), 1e-9),
            (IntegrationMethod::Dop853(1e-12), 1e-9),
            (IntegrationMethod::Rk4(2e-7), 1e-8),
            (IntegrationMethod::Rk4WithoutEvents(1e-7), 1e-2),
        ] {
            for (found, exact) in end(stepping).into_iter().zip(exact) {
                let off = (found / exact - 1.0).abs();
                assert!(off < within, "{pairs}: {stepping:?} {off:e}");
            }
        }
    }
}

#[test]
fn results_do_not_depend_on_whether_a_series_is_kept() {
    for pairs in [
        "k=1e6",
        "k=1e6 b=50",
        "k=7.5e6 gamma=0.8 interface=plastic",
        "k=1e5 x_stop=5mm e=0.5",
        "k=0 x_stop=5mm stop_kind=elastic k_stop=1e7",
        "d=0.1 k=1e6",
        "h=3mm v_i=400 k=1e5",
        "k=1e6 n=0.5 horizon=2ms",
    ] {
        let scene = Arc::new(scene_with(pairs));
        let results = |series: bool| {
            let settings = Settings { series, ..Settings::BARE };
            let found = run_to_end(&scene, IntegrationMethod::Collocation(1e-12), settings);
            assert_eq!(found.series.is_empty(), !series);
            // The way to the turn is followed for the series.
            let mechanism = MechanismLoad { turn: None, ..found.mechanism };
            Run { mechanism, series: Vec::new(), events: Vec::new(), omitted: Vec::new(), ..found }
        };
        assert_eq!(results(true), results(false), "{pairs}");
    }
}

/// From the first arrest on both bodies swing as one damped oscillator: x'' = -(k x + b x')/M, whose greatest pull the way back has.
#[test]
fn valid_the_way_back_pulls_as_a_damped_oscillator_does() {
    for b in [10.0, 40.0, 80.0] {
        let found = shot(&format!("k=1e5 b={b} grip=0.1"));
        let arrest = found.first_arrest.unwrap();
        let (x, v) = (arrest.plate_displacement_m, arrest.plate_velocity_m_s);
        let (mass, k) = (0.059, 1e5);
        let decay: f64 = b / (2.0 * mass);
        let w = (k / mass - decay * decay).sqrt();
        let at = |t: f64| {
            let (sin, cos) = (w * t).sin_cos();
            let (a, c) = (x, (v + decay * x) / w);
            let place = (-decay * t).exp() * (a * cos + c * sin);
            let speed = (-decay * t).exp() * w * (c * cos - a * sin) - decay * place;
            -(k * place + b * speed)
        };
        let times = (0..200_000).map(|i| f64::from(i) * 1e-5 * 2.0 * std::f64::consts::PI / w);
        let pull_n = times.map(at).fold(0.0, f64::max);
        // Of the mount's force the projectile has the half, over what the interface bears: pi p (2 R - p) S_y.
        let p = arrest.penetration_m;
        let strength_n = std::f64::consts::PI * p * (2.0 * 0.00635 - p) * 1.52e8;
        let expected = 0.5 * pull_n / (0.1 * strength_n);
        assert!(is_near(found.interface.tension_ratio.unwrap(), expected, 1e-8), "{b}");
    }
}

/// Against a force F a damper lets the plate go (F/b)^(1/m) fast: on a plate that hardly moves, F is that on a rigid mount. What is off
/// because it is taken as linear near zero is within ten times the estimate.
#[test]
fn valid_a_plate_creeps_as_far_as_its_damper_lets_it() {
    let settings = Settings { every_s: Some(1e-7), ..Settings::SERIES };
    let rigid = Arc::new(scene_with("mount=rigid"));
    let rows = run_to_end(&rigid, IntegrationMethod::Collocation(1e-12), settings).series;
    for (b, m) in [(5e4, 0.1), (1e5, 0.1), (1.5e5, 0.1), (1e5, 0.05), (1e5, 0.2), (5e4, 0.3)] {
        let speed_m_s = |row: &Sample| (row.contact_force_n / b).powf(1.0 / m);
        let crept_m: f64 = rows.windows(2).map(|pair| 1e-7 * speed_m_s(&pair[0])).sum();
        let scene = Arc::new(scene_with(&format!("k=0 b={b} m={m}")));
        let run = simulate(&scene, &Settings::default(), &mut |_| ControlFlow::Continue(()));
        let run = run.unwrap();
        let found_m = run.first_arrest.unwrap().plate_displacement_m;
        let name = "first_arrest_plate_displacement_m";
        let estimate = run.error_of(name).unwrap();
        let off = (found_m - crept_m).abs() / found_m;
        assert!(off < 10.0 * estimate + 1e-2, "{b} {m}: {off:e} {estimate:?}");
    }
}

/// k x^n is the greatest contact force, which is within a step: nothing of what holds the plate is its inertia here.
#[test]
fn valid_a_held_plate_is_farthest_where_the_contact_pushes_most() {
    for tolerance in ["1e-3", "1e-6", "1e-9"] {
        let run = shot(&format!("k=1e6 n=0.1 tol={tolerance}"));
        let exact_m = (run.peak_contact_force_n.unwrap() / 1e6).powi(10);
        let found_m = run.max_plate_displacement_m.unwrap();
        assert!(is_near(found_m, exact_m, 1e-12), "{tolerance}: {found_m} {exact_m}");
    }
}

/// Pushed back from 76 mm the plate comes to rest at the steep zero of its spring long before the shot arrives: it is held there, where it
/// would oscillate by 1e-32 m.
#[test]
fn a_plate_at_rest_at_a_steep_zero_is_held_before_the_contact_too() {
    let run = shot(
        "n=0.484736 m=0.5 k=1.27202e7 b=7250.57 d=76.4316mm gamma=1.60001 v_i=20.027 h=17.0884mm theta=46.6639deg \
                    S_y=3.44223e9 C_d=0.955122 interface=plastic g=0",
    );
    assert_eq!(run.outcome, Outcome::Separated);
    assert!(run.cost.steps < 8000 && run.ledger.residual().abs() < 1e-9, "{run:?}");
    let explicit = run_to_end(&run.scene, IntegrationMethod::Dop853(1e-11), Settings::BARE)
        .penetration
        .final_m;
    let (found, explicit) = (run.penetration.final_m.unwrap(), explicit.unwrap());
    assert!(is_near(found, explicit, 1e-8), "{found} {explicit}");
}

/// From -d towards the spring's zero, up to the stop.
#[test]
fn a_plate_that_creeps_comes_to_rest_on_its_stop() {
    for (pairs, stop_m) in [
        ("d=0.01 x_stop=-0.005 b=1e5 m=0.1 k=1e4", -0.005),
        ("d=0.05 x_stop=-0.02 b=1e6 m=0.1 k=1e5", -0.02),
        ("d=0.01 b=1e6 m=0.1 k=1e4", 0.0),
    ] {
        let reached_m = shot(pairs).max_plate_displacement_m.unwrap();
        assert!((reached_m - stop_m).abs() < 1e-15, "{pairs}: {reached_m}");
    }
}

/// Half way through its slip the rim of the plug has half of its area left, if its shearing is ductile: F(s) pushed and a tenth pulled.
#[test]
fn valid_the_rim_of_a_plug_carries_its_shear_force() {
    let pairs = "nose=blunt R=10mm h=12mm closure=cylindrical rho=7850 Y=490MPa UTS=567MPa E=200GPa gamma=9";
    let setup = ImpactParameters::from_scene(&scene_with(pairs), 1e-12);
    let plug = setup.at(0.0);
    let mode = HybridMode { contact: Contact::Fused, deepest_m: 6e-3, ..first(plug).0 };
    let state = State { q_m: 6e-3, ..State::default() };
    let (push_n, pull_n) = Equations { setup: plug, mode: &mode }.limit_loads_n(&state);
    // F(0) = 314.049 kN.
    assert!(is_near(push_n, 0.5 * 314_048.999, 1e-7) && is_near(pull_n, 0.1 * push_n, 1e-14));
}

/// Integrates both bodies in absolute coordinates by classical Runge-Kutta steps of equal length. Bisection locates the pick-up of the
/// plug, the perforation and the arrest. Returns time, travel, plate displacement, plate velocity and relative velocity at the end.
fn by_equal_steps(
    [m_p, m_2, k, b]: [f64; 4],
    (hole_m, plug): (impl Fn(f64) -> f64, [f64; 5]),
    v: f64,
) -> [f64; 5] {
    let [hole_end_m, plug_kg, rim_n_m, thickness_m, slip_m] = plug;
    let mut y = [0.0, v, 0.0, 0.0];
    let (mut t, mut is_sheared) = (0.0, hole_end_m == 0.0);
    let pick_up = |y: &mut [f64; 4]| y[1] = (m_p * y[1] + plug_kg * y[3]) / (m_p + plug_kg);
    if is_sheared {
        pick_up(&mut y);
    }
    let step = |y: [f64; 4], h: f64, is_sheared: bool| -> [f64; 4] {
        let rate = |y: [f64; 4]| {
            let (q, u) = (y[0] - y[2], y[1] - y[3]);
            let force =
                if is_sheared { rim_n_m * (thickness_m - (q - hole_end_m)) } else { hole_m(u) };
            let kg = if is_sheared { plug_kg } else { 0.0 };
            [y[1], -force / (m_p + kg), y[3], (force - k * y[2] - b * y[3]) / (m_2 - kg)]
        };
        let ahead = |d: [f64; 4], fraction: f64| std::array::from_fn(|i| y[i] + fraction * d[i]);
        let k1 = rate(y);
        let k2 = rate(ahead(k1, 0.5 * h));
        let k3 = rate(ahead(k2, 0.5 * h));
        let k4 = rate(ahead(k3, h));
        std::array::from_fn(|i| y[i] + h * ((k1[i] + k4[i]) / 6.0 + (k2[i] + k3[i]) / 3.0))
    };
    let h = 1e-8;
    loop {
        let end_m = if is_sheared { hole_end_m + slip_m } else { hole_end_m };
        let is_over = |y: [f64; 4]| y[0] - y[2] >= end_m || y[1] <= y[3];
        let next = step(y, h, is_sheared);
        if !is_over(next) {
            (y, t) = (next, t + h);
            continue;
        }
        let (mut low, mut high) = (0.0, h);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            *(if is_over(step(y, middle, is_sheared)) { &mut high } else { &mut low }) = middle;
        }
        (y, t) = (step(y, high, is_sheared), t + high);
        if is_sheared || y[1] - y[3] < 1e-3 {
            return [t, y[0] - y[2], y[2], y[3], y[1] - y[3]];
        }
        pick_up(&mut y);
        is_sheared = true;
    }
}

/// A fragment of 12.6 mm on aluminium and on steel, and a rigid cylinder, on a spring and a damper: stopped in the hole or in the plug, or
/// through. Ledger, momentum and events of the same runs.
#[test]
fn valid_a_plug_is_sheared_as_by_equal_steps_of_both_bodies() {
    let pi = std::f64::consts::PI;
    for (nose, metal, h, v, through) in [
        ("fragment", 0, 0.01, 200.0, false),
        ("fragment", 0, 0.01, 600.0, true),
        ("fragment", 0, 0.022, 400.0, false),
        ("fragment", 0, 0.022, 900.0, true),
        ("blunt", 0, 0.022, 150.0, false),
        ("blunt", 1, 0.02, 700.0, false),
        ("fragment", 1, 0.01, 900.0, true),
    ] {
        let (rho, y, u, e) =
            [(2700.0, 276e6, 310e6, 68.3e9), (7850.0, 1350e6, 1640e6, 207e9)][metal];
        let (m_p, m_2, k, b) = (0.0134, 0.3, 1e7, 500.0);
        let pairs = format!(
            "m_p={m_p} R=6.3mm nose={nose} closure=cylindrical rho={rho} Y={y} UTS={u} E={e} h={h} v_i={v} m_2={m_2} k={k} b={b}"
        );
        let run = shot(&pairs);
        // The laws once more, with the constants of the alloys from elsewhere.
        let (s, sigma) =
            [(1_103.065_098_444e6, 395.376_675_796e6), (5_366.407_403_343e6, 2_322.436_110_613e6)]
                [metal];
        let (d, tau) = (0.0126, sigma / 3f64.sqrt());
        let is_fragment = nose == "fragment";
        let area = if is_fragment { 2.0 } else { 1.0 } * pi * d * d / 4.0;
        let h_p = if h > 1.35 * d { 1.35 * d } else { h };
        let d_p = if is_fragment && metal == 1 { 2f64.sqrt() * d } else { d };
        let w = if 0.5 * tau < [95e6, 250e6][metal] { 0.5 * tau } else { [95e6, 250e6][metal] };
        let slip = h_p * (1.0 - (1.0 - 2.0 * w / tau).sqrt());
        let plug_kg = rho * pi * d_p * d_p / 4.0 * h_p;
        let plug = [h - h_p, plug_kg, pi * d_p * tau, h_p, slip];
        let hole = |u: f64| area * (s + 0.5 * rho * u * u);
        let [t, q, x, plate, left] = by_equal_steps([m_p, m_2, k, b], (hole, plug), v);
        let near = |found: f64, expected: f64| {
            assert!(is_near(found, expected, 1e-8), "{pairs}: {found} {expected}");
        };
        assert_eq!(run.outcome == Outcome::Perforated, through, "{pairs}");
        if through {
            near(run.departure.exit_time_s.unwrap(), t);
            near(run.departure.residual_velocity_m_s.unwrap(), left + plate);
            near(run.penetration.final_m.unwrap(), h - h_p + slip);
        } else {
            let arrest = run.first_arrest.unwrap();
            near(arrest.t_s, t);
            near(arrest.penetration_m, q);
            near(arrest.plate_displacement_m, x);
            near(arrest.plate_velocity_m_s, plate);
        }
        assert!(run.ledger.residual().abs() < 1e-11, "{pairs}: {:?}", run.ledger);
        let is_picked_up =
            run.events.iter().any(|it| it.kind == crate::model::run::EventKind::Plug);
        assert_eq!(is_picked_up, q > h - h_p, "{pairs}");
        if through {
            let work = pi * d_p * h_p * h_p * w;
            near(run.ledger.shear_j, work);
        }
    }
}

/// A run that needs more work than it may take is undecided, with the greatest depth for which there is energy. One whose second
/// computation needs more has no error.
#[test]
fn a_run_takes_no_more_work_than_it_may() {
    let scene = Arc::new(scene_with("k=1e6 gamma=2"));
    let by = |work_max: usize| {
        let settings = Settings { estimate: true, work_max: Some(work_max), ..Settings::BARE };
        simulate(&scene, &settings, &mut |_| ControlFlow::Continue(())).unwrap()
    };
    let whole = by(usize::MAX);
    let needed = whole.cost.work();
    let depth_m = whole.penetration.final_m.unwrap();
    let few = by(needed / 2);
    assert_eq!((few.end, few.penetration.final_m), (EndReason::StepBudget, None));
    assert!(few.cost.work() < needed && few.estimate.main.is_none());
    assert!(few.at_least.penetration_m.unwrap() < depth_m);
    assert!(few.penetration.at_most_m.is_none_or(|most_m| most_m > depth_m));
    let alone = by(needed);
    assert_eq!(alone.penetration.final_m, whole.penetration.final_m);
    assert!(whole.estimate.main.unwrap() < 1e-9 && alone.estimate.main == Some(f64::INFINITY));
}

/// Greatest travel and displacement of a lumped contact, m, by the classical Runge-Kutta method in equal steps: masses, spring and damper of
/// the plate, stiffnesses and damping of the interface. Without a spring the damper alone takes what is left of the velocity.
fn lumped_by_equal_steps(
    [projectile_kg, plate_kg]: [f64; 2],
    [stiffness, damping, exponent]: [f64; 3],
    [load, unload, contact_damping]: [f64; 3],
) -> [f64; 2] {
    let step_s = 5e-8;
    let (mut at, mut deepest) = ([0.0, 100.0, 0.0, 0.0], 0.0);
    let mut farthest_m = 0.0;
    for _ in 0..2_000_000 {
        let slope = |[q, u, x, w]: [f64; 4]| {
            let is_deeper = q >= deepest;
            let (k, slack) =
                if is_deeper { (load, 0.0) } else { (unload, deepest * (1.0 - load / unload)) };
            let contact = larger(k * (q - slack) + contact_damping * u, 0.0);
            let damper = damping * w.abs().powf(exponent) * w.signum();
            let plate = (contact - stiffness * x - damper) / plate_kg;
            [u, -contact / projectile_kg - plate, w, plate]
        };
        let moved = |by: [f64; 4], fraction: f64| {
            std::array::from_fn(|i| at[i] + fraction * step_s * by[i])
        };
        let first = slope(at);
        let second = slope(moved(first, 0.5));
        let third = slope(moved(second, 0.5));
        let last = slope(moved(third, 1.0));
        let rate = |i: usize| (first[i] + 2.0 * (second[i] + third[i]) + last[i]) / 6.0;
        at = std::array::from_fn(|i| at[i] + step_s * rate(i));
        deepest = larger(deepest, at[0]);
        farthest_m = larger(farthest_m, at[2]);
    }
    let power = 2.0 - exponent;
    // In contact both move with the plate's velocity.
    let moving_kg = if at[1].abs() < 1e-6 { projectile_kg + plate_kg } else { plate_kg };
    let coasts_m = moving_kg * larger(at[3], 0.0).powf(power) / (damping * power);
    [deepest, if stiffness == 0.0 { at[2] + coasts_m } else { farthest_m }]
}

/// Damped contacts on damped plates: m below, at and above one, with a spring and without.
#[test]
fn valid_lumped_bodies_that_come_to_rest_by_equal_steps() {
    let mut random = Random::new(53);
    for index in 0..12 {
        let mut log = |low: f64, high: f64| low * (high / low).powf(random.unit());
        let exponent = [0.7, 1.0, 1.5][index % 3];
        let (gamma, load, stiffer) = (log(0.5, 5.0), log(1e5, 1e6), log(2.0, 20.0));
        let contact_damping = log(0.2, 5.0) * 2.0 * (0.0295 * load * stiffer).sqrt();
        let stiffness = if index % 2 == 0 { 0.0 } else { log(1e4, 1e5) };
        let damping = log(2.0, 6.0) * (0.0295 * (1.0 + gamma) * larger(stiffness, 1e4)).sqrt();
        let pairs = format!(
            "model=lumped dishing=off gamma={gamma} k={stiffness} b={damping} m={exponent} \
             k_load={load} k_unload={} b_2={contact_damping}",
            load * stiffer
        );
        let run = simulate(&Arc::new(scene_with(&pairs)), &Settings::BARE, &mut |_| {
            ControlFlow::Continue(())
        })
        .unwrap();
        let [deepest, farthest] = lumped_by_equal_steps(
            [0.0295, 0.0295 * gamma],
            [stiffness, damping, exponent],
            [load, load * stiffer, contact_damping],
        );
        assert_eq!(
            run.end,
            EndReason::Decided,
            "{pairs} {:?} {:?} {:?} {:?}",
            run.cost,
            run.ledger,
            run.departure.separation,
            run.first_arrest
        );
        let depth = run.penetration.final_m.unwrap();
        assert!(
            is_near(depth, deepest * (1.0 - 1.0 / stiffer), 1e-6),
            "{pairs}: {depth} {deepest}"
        );
        let found = run.max_plate_displacement_m.unwrap();
        assert!(is_near(found, farthest, 1e-6), "{pairs}: {found} {farthest}");
    }
}

/// On a damper of power 2 a plate moves like ln t: without end, or to its stop.
#[test]
fn valid_lumped_bodies_go_as_far_as_their_damper_lets_them() {
    let contact = "model=lumped gamma=1 k=0 k_load=1e6 k_unload=1e7 b_2=2e3";
    for (pairs, expected) in [
        ("b=2000 m=2", None),
        ("b=2000 m=2 x_stop=5mm", Some(5e-3)),
        ("b=2000 m=2.5 x_stop=5mm stop_kind=elastic k_stop=1e12", Some(5e-3)),
    ] {
        let scene = Arc::new(scene_with(&format!("{contact} {pairs}")));
        let run = simulate(&scene, &Settings::BARE, &mut |_| ControlFlow::Continue(())).unwrap();
        assert_eq!(run.end, EndReason::Decided, "{pairs}");
        let found = run.max_plate_displacement_m;
        assert_eq!(found.is_some(), expected.is_some(), "{pairs}: {found:?}");
        if let Some((found, expected)) = found.zip(expected) {
            assert!(is_near(found, expected, 1e-6), "{pairs}: {found} {expected}");
        }
    }
}

/// A needle of 1 um through 25.4 mm barely moves a plate: the steep damper balances its force F at w = (F/b)², on the way of each depth in
/// proportion to A². The nose enters on 8/15 R and leaves on R/5; dishing makes the way (h + 2 R)/h times as long up to the rear face.
#[test]
fn valid_a_steep_damper_holds_a_plate_that_is_hardly_touched() {
    let (r, h, v) = (1e-6, 0.0254, 100.0);
    let force_n = std::f64::consts::PI * r * r * (1.52e8 + 6.775e6);
    let way_m = (8.0 / 15.0 * r + h - r) * (h + 2.0 * r) / h + r / 5.0;
    for b in [1e2, 1e3, 1e4] {
        let scene = scene_with(&format!("R=1um gamma=1 k=0 m=0.5 b={b}"));
        let run = simulate(&Arc::new(scene), &Settings::BARE, &mut |_| ControlFlow::Continue(()))
            .unwrap();
        let expected = (force_n / b).powi(2) * way_m / v;
        let found = run.max_plate_displacement_m.unwrap();
        assert!(is_near(found, expected, 1e-5), "{b}: {found:e} {expected:e}");
    }
}
