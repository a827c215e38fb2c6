//! The weight of a projectile that falls on a plate: energy balances, statics, and the warning where it is not counted.

use cmra_engine::model::run::{ContactMode, Outcome, Run, RunWarning};

use crate::support::{assert_near, run, says, scene};

const GRAVITY_M_S2: f64 = 9.80665;

/// 45 kg fall on a steel plate, 6 mm thick and 1 m square, on 5 kN/m: joined at once.
fn falling(more: &str) -> Run {
    run(scene(&format!("m_p=45 v_i=7.789 m_2=47.1 k=5e3 model=initial-velocity {more}")))
}

/// `k x²/2 = (m_1 + m_2) w²/2 + m_1 g x`, w the common velocity.
#[test]
fn valid_the_stroke_is_where_spring_takes_energy_and_weight() {
    let w_m_s = 45.0 * 7.789 / 92.1;
    let energy_j = 0.5 * 92.1 * w_m_s * w_m_s;
    let weight_n = 45.0 * GRAVITY_M_S2;
    let heavy_m = (weight_n + (weight_n * weight_n + 2.0 * 5e3 * energy_j).sqrt()) / 5e3;
    assert_near(heavy_m, 0.612, 1e-3);
    let stroke_m = |run: &Run| run.max_plate_displacement_m.unwrap();
    let (with, without) = (falling("weight=on"), falling(""));
    assert_near(stroke_m(&with), heavy_m, 1e-12);
    assert_near(stroke_m(&without), w_m_s * (92.1f64 / 5e3).sqrt(), 1e-12);
    assert_near(stroke_m(&without), 0.5165, 1e-4);
    assert_near(with.mechanism.peak_mount_n.unwrap(), 5e3 * heavy_m, 1e-9);
    // Followed in steps, up to a horizon, instead of found by the energy.
    let followed = falling("weight=on horizon=0.4");
    assert_near(stroke_m(&followed), heavy_m, 1e-9);
    assert_near(
        followed.ledger.weight_j,
        weight_n * followed.series.last().unwrap().plate_displacement_m,
        1e-9,
    );
    assert!(followed.ledger.residual().abs() < 1e-12);
    // A rigid stop on the way is met all the same, with what the weight has given up to there.
    let stopped = falling("weight=on x_stop=600mm");
    assert_near(stroke_m(&stopped), 0.6, 1e-12);
    assert!(stopped.ledger.stop_j > 0.0);
}

/// By steps of the law: an elastic stop, a damper, a table of force, an oblique guide. The energy is all accounted for.
#[test]
fn valid_the_energy_of_a_falling_body_is_accounted_for() {
    for more in [
        "b=200",
        "b=20 m=2",
        "n=1.5 k=9e3",
        "n=0.5 k=2e3",
        "x_stop=0.3 stop_kind=elastic k_stop=2e4 b_stop=50",
        "x_stop=0.3 e=0.5",
        "d=0.2",
        "w_0=2",
        "theta=30deg",
        "spring=crush F_crush=3e3 x_crush=1 k_crush=1e6",
        "spring=constant F_c=2e3 x_c=0.01",
        "k=0 b=500",
        "k=0 x_stop=0.3 e=0.2",
        "model=hydrodynamic R=0.1 h=0.1 interface=plastic",
        "model=half-sine t_d=5ms",
        "model=lumped k_load=1e6 b_2=2e3",
    ] {
        let run = falling(&format!("weight=on {more} horizon=1"));
        assert!(run.ledger.residual().abs() < 1e-10, "{more}: {}", run.ledger.residual());
        assert!(run.ledger.weight_j.abs() > 1.0, "{more}");
    }
}

/// A damped mount comes to rest where the spring bears the weight, which the interface then carries.
#[test]
fn valid_at_rest_the_spring_bears_the_weight() {
    let run = run(scene(
        "m_p=45 v_i=0.3 R=0.1 h=0.1 m_2=47.1 k=5e3 b=600 interface=plastic weight=on horizon=8",
    ));
    let last = run.series.last().unwrap();
    assert_near(last.plate_displacement_m, 45.0 * GRAVITY_M_S2 / 5e3, 1e-6);
    assert_near(last.contact_force_n, 45.0 * GRAVITY_M_S2, 1e-6);
    assert_eq!((run.outcome, last.mode), (Outcome::Arrested, ContactMode::Fused));
}

/// Nothing bears it: the plate is driven on for ever.
#[test]
fn nothing_stops_a_plate_without_a_spring() {
    for more in ["k=0", "k=0 b=50", "k=0 b=50 interface=plastic model=hydrodynamic R=0.1 h=0.1"] {
        let run = falling(&format!("weight=on {more}"));
        assert_eq!(
            (run.outcome, run.max_plate_displacement_m),
            (Outcome::Arrested, None),
            "{more}"
        );
        assert!(run.end.is_complete(), "{more}: {:?}", run.end);
    }
}

/// 45 kg times 9.81 m/s² over 516.5 mm are 16.7 % of 1365 J.
#[test]
fn valid_a_weight_that_is_not_counted_is_reported_where_it_matters() {
    let fraction = |run: &Run| {
        run.warnings.iter().find_map(|warning| match warning {
            RunWarning::WeightOmitted { fraction } => Some(*fraction),
            _ => None,
        })
    };
    assert_near(fraction(&falling("")).unwrap(), 45.0 * GRAVITY_M_S2 * 0.5165 / 1365.02, 1e-3);
    for light in ["weight=on", "k=5e6", "mount=rigid"] {
        assert_eq!(fraction(&falling(light)), None, "{light}");
    }
    assert_eq!(fraction(&run(scene("k=1e5"))), None);
    let (page, _) = says("explain", &["weight"], 0);
    assert!(page.contains("projectile.weight"), "{page}");
}
