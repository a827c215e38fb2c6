//! Plates that oscillate through the zero of a power law that is not smooth there, against closed forms.

use std::sync::Arc;

use cmra_engine::model::impact::{IntegrationMethod, step_by};
use cmra_engine::model::run::{
    ContactMode, EndReason, EventKind, Outcome, Run, RunSnapshot, RunWarning, Sample,
};

use crate::support::{assert_near, run, says, scene};

/// Spring exponents, and the beta function B(1/(n+1), 1/2) = gamma(1/(n+1)) gamma(1/2) / gamma(1/(n+1) + 1/2), by the gamma function of
/// another language's standard library.
const EXPONENTS: [(f64, f64); 6] = [
    (0.05, 2.061_030_050_039_808_4),
    (0.3, 2.357_622_987_761_592),
    (0.5, 2.587_109_559_229_79),
    (0.7, 2.811_633_147_841_681),
    (1.4, 3.572_553_620_320_031_4),
    (2.3, 4.519_761_184_655_091),
];
/// Stiffness, N/m^n, and how long the plate is watched, s.
const STIFFNESS: f64 = 2e5;
const WATCHED_S: f64 = 0.1;

/// Integral from 0 to 1 of ds/(1 + 2 e (1 - s^(n+1)))^(1/2), by Simpson's rule with s = y^4.
fn way(part: f64, n: f64) -> f64 {
    let count = 400;
    let of = |i: i32| {
        let y = f64::from(i) / f64::from(count);
        let weight = if i == 0 || i == count { 1.0 } else { f64::from(2 + 2 * (i % 2)) };
        let square = 1.0 + 2.0 * part * (1.0 - y.powf(4.0 * (n + 1.0)));
        weight * 4.0 * y.powi(3) / square.sqrt()
    };
    (0..=count).map(of).sum::<f64>() / f64::from(3 * count)
}

/// Times at which joined bodies of a mass on a spring k x^n come through zero, and their speed then: from the row before, where the spring has
/// the part e of twice the kinetic energy, it takes x/w times the integral [`way`].
fn passages(run: &Run, n: f64, mass: f64) -> Vec<(f64, f64)> {
    let joined: Vec<_> = run.series.iter().filter(|row| row.mode == ContactMode::Fused).collect();
    let at_zero = joined.windows(2).filter(|pair| {
        pair[0].plate_displacement_m * pair[1].plate_displacement_m <= 0.0
            && pair[0].plate_displacement_m != 0.0
    });
    let passage = |pair: &[&Sample]| {
        let Sample { t_s, plate_displacement_m, plate_velocity_m_s, .. } = *pair[0];
        let twice_kinetic = mass * plate_velocity_m_s * plate_velocity_m_s;
        let stored = STIFFNESS / (n + 1.0) * plate_displacement_m.abs().powf(n + 1.0);
        let part = stored / twice_kinetic;
        let way_s = -plate_displacement_m / plate_velocity_m_s;
        let speed = plate_velocity_m_s.abs() * (1.0 + 2.0 * part).sqrt();
        (t_s + way_s * way(part, n), speed)
    };
    at_zero.map(passage).collect()
}

/// Half a swing of a mass M with the energy E on a spring k x^n takes 2 X sqrt(M / 2 E) B(1/(n+1), 1/2) / (n+1), with its
/// greatest displacement X = ((n+1) E / k)^(1/(n+1)).
#[test]
fn undamped_plates_swing_in_the_time_of_the_closed_form() {
    for (n, beta) in EXPONENTS {
        // A stop, which is out of reach, leaves the motion to the integrator.
        let told = format!("n={n} k={STIFFNESS} d=0.002 x_stop=1000 run.horizon_s={WATCHED_S}");
        let own = scene(&told);
        let mass = own.projectile.mass_kg + own.plate_mass_kg();
        let found = run(own);
        let passages = passages(&found, n, mass);
        assert!(passages.len() >= 3, "{told}: {} passages", passages.len());
        for pair in passages.windows(2) {
            let energy = 0.5 * mass * pair[0].1 * pair[0].1;
            let reach = ((n + 1.0) * energy / STIFFNESS).powf(1.0 / (n + 1.0));
            let half = 2.0 * reach * (mass / (2.0 * energy)).sqrt() * beta / (n + 1.0);
            assert_near(pair[1].0 - pair[0].0, half, 1e-9);
            assert_near(pair[1].1, pair[0].1, 1e-12);
            let between =
                found.series.iter().filter(|row| row.t_s > pair[0].0 && row.t_s < pair[1].0);
            let farthest = between.map(|row| row.plate_displacement_m.abs()).fold(0.0, f64::max);
            assert_near(farthest, reach, 1e-11);
        }
    }
}

/// Counts the steps: one passage leads across the zero of a spring; some twenty lead up to that of a damper, each half of the way, and as
/// many away.
#[test]
fn a_swing_takes_few_steps() {
    for (pairs, most) in [
        ("n=0.3 b=0", 15),
        ("n=0.5 m=0.5 b=20", 70),
        ("n=1 m=0.3 b=20", 90),
        ("n=2.5 m=1.5 b=0.5", 60),
    ] {
        let found = run(scene(&format!("{pairs} k=1e6 d=0.002 run.horizon_s=0.05")));
        let turns = found.cost.turns;
        assert!(turns >= 6, "{pairs}: {turns} turns");
        let steps = found.cost.steps;
        assert!(steps < most * turns, "{pairs}: {steps} steps, {turns} turns");
        assert!(found.ledger.residual().abs() < 1e-10, "{pairs}: {:e}", found.ledger.residual());
    }
}

/// A plate that is thrown off oscillates for ever, and does not meet the slow projectile again within the work of a run.
#[test]
fn an_undecided_oscillation_ends_as_moving_unless_a_horizon_is_set() {
    let pairs = "k=7.5e6 d=0.5 gamma=1e-3 v_i=1 S_y=0 C_d=0 h=1 interface=plastic";
    let found = run(scene(pairs));
    assert_eq!((found.outcome, found.end), (Outcome::Moving, EndReason::Oscillates));
    assert!(found.penetration.final_m.is_none() && found.end.is_complete());
    let asked = run(scene(&format!("{pairs} run.horizon_s=1e-4")));
    assert_eq!((asked.outcome, asked.end), (Outcome::Moving, EndReason::Horizon));
    assert_near(asked.series.last().unwrap().t_s, 1e-4, 1e-12);
}

/// On a spring with n < 1 a damped plate oscillates ever faster while it dies down: what is left after some hundred oscillations is not
/// followed to a horizon far beyond; everything else is known by then, and the energies balance.
#[test]
fn a_plate_that_decays_in_ever_faster_oscillations_is_decided_before_its_horizon() {
    let found = run(scene(
        "n=0.3 k=4.88e5 b=246 d=0.00944 gamma=0.313 v_i=226 interface=plastic g=0.12 h=0.05 run.horizon_s=1",
    ));
    assert_eq!((found.outcome, found.end), (Outcome::Arrested, EndReason::StepBudget));
    let told = |it: &RunWarning| matches!(it, RunWarning::HorizonNotReached { .. });
    assert!(found.warnings.iter().any(told), "{:?}", found.warnings);
    assert!(found.ledger.residual().abs() < 1e-12, "{:e}", found.ledger.residual());
    // It has swung both ways, with ever smaller greatest displacements.
    let farthest = found.max_plate_displacement_m.unwrap();
    let last_s = found.series.last().unwrap().t_s;
    let late = found.series.iter().filter(|row| row.t_s > 0.9 * last_s);
    let most = late.map(|row| row.plate_displacement_m.abs()).fold(0.0, f64::max);
    assert!(most > 0.0 && most < 1e-6 * farthest, "{most:e} {farthest:e}");
}

/// A value of the row at a time in a table of rows at equal time steps.
fn at(settings: &[&str], dt: &str, t_us: f64, column: &str) -> f64 {
    let sets = settings.iter().flat_map(|pair| ["--set", pair]);
    let arguments: Vec<&str> = ["--csv", "-", "--dt", dt].into_iter().chain(sets).collect();
    let table = says("run", &arguments, 0).0;
    let mut lines = table.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let header = lines.next().unwrap();
    let number = |row: &[&str], name: &str| {
        let place = header.iter().position(|it| *it == name).unwrap();
        row[place].parse::<f64>().unwrap()
    };
    let row = lines.find(|row| (1e6 * number(row, "time_s") - t_us).abs() < 1e-6).unwrap();
    number(&row, column)
}

/// Values of an independent integrator, where a step passes the zero of a power law.
#[test]
fn valid_rows_at_equal_time_steps_lie_on_the_trajectory() {
    let damped: &[&str] = &["b=100", "m=0.5"];
    let bent: &[&str] = &["n=0.5", "k=1e6", "run.horizon_s=240us"];
    for (settings, t_us, column, expected, tolerance) in [
        (damped, 4.0, "plate_velocity_m_s", 0.1106, 2e-4),
        (damped, 36.0, "spring_force_n", 9.68, 5e-4),
        (damped, 66.0, "penetration_m", 3.6876e-3, 2e-5),
        (damped, 66.0, "contact_force_n", 16_091.0, 5e-5),
        (bent, 230.0, "contact_force_n", -834.0, 1e-3),
    ] {
        assert_near(at(settings, "2us", t_us, column), expected, tolerance);
    }
}

/// The last row of a run that ends there is exact.
#[test]
fn rows_at_equal_time_steps_of_a_closed_form_lie_on_the_trajectory() {
    for settings in [["k=0", "v_i=100"], ["k=0", "theta=40deg"], ["mount=rigid", "v_i=100"]] {
        let to_there = [settings[0], settings[1], "run.horizon_s=21us"];
        for column in ["penetration_m", "projectile_velocity_m_s", "contact_force_n"] {
            let exact = at(&to_there, "21us", 21.0, column);
            assert_near(at(&settings, "7us", 21.0, column), exact, 2e-6);
        }
    }
}

/// The first step leaves a knot of the spring, where rounding is no crossing back. DOP853 has the same depth.
#[test]
fn valid_a_plate_leaves_the_knot_that_it_starts_at() {
    let pairs = "v_i=6.00279 gamma=0.464065 m_p=0.00991278 R=0.00912804 b=1.62703 spring=normalised F_ref=739.329 n=1.31131 \
                 model=lumped k_load=320044 k_unload=2.87667e6 b_2=1.70433";
    let go_on = &mut |_: &RunSnapshot<'_>| std::ops::ControlFlow::Continue(());
    let stepping = IntegrationMethod::Dop853(1e-13);
    let exact = step_by(stepping, &Arc::new(scene(pairs)), go_on).unwrap().unwrap();
    for tolerance in ["1e-3", "1e-6", "1e-8", "1e-9", "1e-10", "1e-12"] {
        let found = run(scene(&format!("{pairs} tol={tolerance}")));
        assert_eq!((found.outcome, found.end), (Outcome::Separated, EndReason::Decided));
        let [depth, exact] = [&found, &exact].map(|run| run.penetration.final_m.unwrap());
        assert_near(depth, exact, 1e-8);
    }
}

/// A velocity of the plate that is negligible changes nothing, however steep its spring is.
#[test]
fn valid_a_plate_that_hardly_moves_at_first_is_as_one_at_rest() {
    for spring in ["n=0.2 k=1e6", "n=0.15 k=3e4", "n=0.28 k=1e7", "n=0.2 k=1e6 interface=plastic"] {
        let at_rest = run(scene(spring));
        for w_0 in ["1e-11", "-1e-11"] {
            let found = run(scene(&format!("{spring} w_0={w_0}")));
            assert_eq!((found.outcome, found.end), (at_rest.outcome, at_rest.end), "{spring}");
            let of = |run: &Run| {
                let arrest = run.first_arrest.unwrap();
                [arrest.penetration_m, arrest.plate_displacement_m, arrest.t_s]
            };
            for (found, exact) in of(&found).into_iter().zip(of(&at_rest)) {
                assert_near(found, exact, 1e-11);
            }
        }
    }
}

/// The swing of a plate that a spring holds keeps its action: the oscillation about the balance of the contact has the amplitude
/// `(4 c w_0 X/(pi r))^(1/2)`, with the integral c < 1 of w over the swing, as parts of `w_0` and its turn X, and the frequency r there.
#[test]
fn valid_an_estimate_has_the_swing_of_a_plate_that_its_spring_holds() {
    let (n, k, w_0) = (0.2f64, 1e6f64, 1e-6f64);
    let found = run(scene(&format!("n={n} k={k} w_0={w_0}")));
    let x = found.first_arrest.unwrap().plate_displacement_m;
    let kg = found.scene.plate_mass_kg();
    let rate = (n * k * x.powf(n - 1.0) / kg).sqrt();
    let turn = ((n + 1.0) * 0.5 * kg * w_0 * w_0 / k).powf(1.0 / (n + 1.0));
    let mean: f64 =
        (0..1000).map(|i| (1.0 - ((f64::from(i) + 0.5) / 1e3).powf(n + 1.0)).sqrt()).sum();
    let amplitude = (4.0 * 1e-3 * mean * w_0 * turn / (std::f64::consts::PI * rate)).sqrt();
    let estimate = found.error_of("first_arrest_plate_displacement_m").unwrap();
    assert!(estimate * x >= amplitude && estimate * x < 1.5 * amplitude, "{estimate} {amplitude}");
}

/// With a damper that takes a part of some 1e-13 of the energy the swing is integrated, without one it has a closed form. Beyond the zero
/// of the spring the interface is pulled: the projectile comes out at the same time and velocity.
#[test]
fn an_interface_is_pulled_by_the_spring_of_the_side_it_is_on() {
    for n in [0.5f64, 1.5, 2.0, 4.0] {
        let k = 4e4 / 0.02f64.powf(n);
        let out = |b: &str| {
            let found = run(scene(&format!("n={n} k={k} g=0.02 interface=plastic b={b}")));
            let begins = found.events.iter().find(|event| event.kind == EventKind::PullOut);
            (begins.unwrap().t_s, found.departure.separation.unwrap().velocity_m_s)
        };
        let (integrated, exact) = (out("1e-9"), out("0"));
        assert_near(integrated.0, exact.0, 1e-9);
        assert_near(integrated.1, exact.1, 1e-8);
    }
}

/// Thrown back at first, joined at once: the common velocity of 49.5 m/s leads forwards, up to where `k x^(n+1)/(n+1)` is its energy.
#[test]
fn valid_bodies_that_join_at_once_swing_the_way_of_their_common_velocity() {
    for n in [0.5, 1.5, 2.0f64] {
        let own = format!("model=initial-velocity n={n} w_0=-1 k=1e6 run.horizon_s=5e-3 gamma=1");
        let found = run(scene(&own));
        let energy = 0.5 * 0.059 * 49.5 * 49.5;
        let reach = ((n + 1.0) * energy / 1e6).powf(1.0 / (n + 1.0));
        assert_near(found.max_plate_displacement_m.unwrap(), reach, 1e-11);
        assert!(found.ledger.residual().abs() < 1e-11, "{n}");
        for row in found.series.iter().filter(|row| row.mode == ContactMode::Fused) {
            let Sample { plate_displacement_m: x, plate_velocity_m_s: w, .. } = *row;
            assert_near(
                0.5 * 0.059 * w * w + 1e6 / (n + 1.0) * x.abs().powf(n + 1.0),
                energy,
                1e-11,
            );
            assert!(row.contact_force_n * x >= 0.0, "n={n} {row:?}");
        }
    }
}
