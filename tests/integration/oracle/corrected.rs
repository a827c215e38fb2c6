//! Scenes on which the program was wrong.

use cmra_engine::model::run::{EndReason, EventKind, Outcome, Sample};

use super::{agree, draw, program};

#[track_caller]
fn all_agree(scenes: &[&str]) {
    for words in scenes {
        assert!(agree(words).is_some(), "{words} rattles");
    }
}

/// A table's force that falls at its end goes on falling, and drives the plate away: the plate's remaining energy is not a bound then. All of it
/// by hand: beyond 4 mm the force is `F_2 + s (x - x_2)` with the three-point slope s = -2.5e6 N/m of the points, so the plate goes on
/// like exp(t sqrt(-s/m)), and a projectile that only grips cannot follow.
#[test]
fn valid_a_spring_that_drives_the_plate_away_holds_nothing() {
    for b in ["b=0", "b=100", "b=20 m=1.5"] {
        let table = "spring=table table=0:0,0.002:1000,0.004:-2000";
        let plastic = draw::read(&format!("{table} interface=plastic {b}"));
        let run = program(&plastic);
        assert_eq!(run.outcome, Outcome::Separated, "{b}");
        assert_eq!(run.end, EndReason::Decided, "{b}");
        assert!(run.max_plate_displacement_m.is_none(), "{b}");
        assert!(run.cost.steps < 100, "{b}");
        all_agree(&[&format!("{table} interface=plastic {b} run.horizon_s=5e-4")]);
        let fused = program(&draw::read(&format!("{table} {b}")));
        assert_eq!(fused.outcome, Outcome::Arrested, "{b}");
        assert!(fused.max_plate_displacement_m.is_none(), "{b}");
        // Drawn back from its start, it never comes forward again.
        let back = "spring=table table=-0.002:1000,0:200,0.002:400";
        let run = program(&draw::read(&format!("{back} d=0.001 v_i=20 gamma=8 {b}")));
        assert!(run.max_plate_displacement_m.is_some_and(|far| far < 0.01), "{b}");
    }
}

/// A spring that pulls the plate off the stop at which it starts.
#[test]
fn valid_a_plate_that_starts_at_its_stop_is_not_held_there_by_nothing() {
    all_agree(&[
        "spring=table table=0:0,2.0543e-4:-908.8 b=15.91 d=0.014964 gamma=3.5192 v_i=385.85 h=0.0074518 interface=plastic g=0.6 run.horizon_s=5.1646e-4 x_stop=-0.014964 e=0.9",
        "spring=table table=-0.01:500,0:1000,0.01:3000 x_stop=0 run.horizon_s=5e-4",
    ]);
}

/// Without grip the projectile stays behind where the spring's force changes its sign, at zero or elsewhere.
#[test]
fn valid_nothing_pulls_a_projectile_without_grip_at_any_zero_of_a_spring() {
    all_agree(&[
        "spring=bistable x_2=0.013227 F_bar=10938 x_u=6.335099422801329e-3 gamma=0.37414 v_i=180.73 h=0.016798 interface=plastic g=0 run.horizon_s=1.0209e-3",
        "spring=bistable x_2=0.0016023 F_bar=5333.8 d=0.00024594 gamma=1.1109 v_i=120.84 h=0.0064937 interface=plastic g=0 run.horizon_s=1.0295e-3",
    ]);
}

/// The lumped interface: touched again sooner than a step takes, pushed again by its damper before the dent is left, and with a plate
/// at rest at its rigid stop.
#[test]
fn valid_a_lumped_interface_is_never_passed_through() {
    all_agree(&[
        "n=1.5 k=1.076e8 m=1.007 b=1.542 d=0.00058365 gamma=0.27352 v_i=48.047 h=0.0097793 g=0 run.horizon_s=5.7387e-4 model=lumped b_2=21.14 k_load=3.5517e7 k_unload=2.543976159e8",
        "n=0.5 k=1.588e5 m=1.3204 b=7.145 d=0.005071 gamma=0.20809 v_i=136.45 h=0.0061878 g=0 run.horizon_s=8.1402e-4 x_stop=4.7046e-3 e=0 model=lumped",
        "n=0.5 k=2.165e5 b=150 gamma=0.52689 v_i=43.734 h=0.0064109 run.horizon_s=4.7327e-4 model=lumped b_2=2.8216 k_load=1.1969e7 k_unload=6.46290093e8",
        "n=1.5 k=4.58e6 gamma=0.28651 v_i=77.601 h=0.0087184 run.horizon_s=5.9243e-4 dishing=false x_stop=0 stop_kind=elastic k_stop=1750200 model=lumped b_2=233.02 k_load=6.5834e7 k_unload=6.356141032e9",
        "k=0 gamma=1.5595 v_i=43.913 h=0.042135 run.horizon_s=1.2333e-3 theta=17.6deg x_stop=6.4978e-4 e=0 model=lumped k_load=3.0892e7 k_unload=1.016439476e9",
        "n=2.2999 k=1.2e9 m=0.5 b=1263 gamma=0.5795 v_i=471.38 h=0.039241 run.horizon_s=1.287e-3 model=lumped b_2=237.8 k_load=3.8506e6 k_unload=1.528534176e8",
        "n=2 k=4.206e7 m=1.1699 b=77.79 gamma=0.4055 v_i=33.534 h=0.015963 run.horizon_s=7.9778e-4 theta=26.9deg x_stop=0 e=0.8 model=lumped k_load=2.0664e7 k_unload=2.87828856e8",
        "k=0 d=0.00021185 gamma=1.374 v_i=53.479 h=0.013033 run.horizon_s=4.2057e-4 x_stop=8.0665e-4 e=0 model=lumped k_load=2.3546e7 k_unload=2.6242017e8",
        "k=0 m=1.8563 b=0.6394 gamma=3.5884 v_i=32.645 h=0.023887 run.horizon_s=5.5366e-4 theta=50deg x_stop=1.6781e-4 e=0.2 model=lumped b_2=1.5897",
        "k=0 gamma=0.44075 v_i=99.015 h=0.044067 run.horizon_s=4.9837e-4 x_stop=0 stop_kind=elastic k_stop=204590 model=lumped b_2=734.24 k_load=1.4962e7 k_unload=1.152118886e9",
    ]);
}

/// The half-sine history: a plate that bounces on its stop under it, one that rests there to its end, and one that is thrown back at the
/// projectile twice.
#[test]
fn valid_a_half_sine_history_with_a_stop_and_a_second_approach() {
    all_agree(&[
        "n=0.76583 k=1.039e5 b=112.9 gamma=0.31039 v_i=86.519 h=0.016955 g=1 run.horizon_s=1.7381e-3 x_stop=2.1617e-4 e=0.5 model=half-sine",
        "n=0.98766 k=1.285e6 m=1.5 b=53.03 d=0.00082234 gamma=0.30416 v_i=136.68 h=0.012872 run.horizon_s=9.6388e-4 x_stop=-7.97527e-4 e=0 model=half-sine t_d=1.2355e-4",
        "n=1.5 k=7.13e7 d=0.0052719 gamma=0.20429 v_i=343.01 h=0.0071525 run.horizon_s=1.7524e-3 model=half-sine t_d=2.6986e-4",
    ]);
}

/// A cocked spring presses the plate on the undamped elastic stop at which it starts: it oscillates between its start and twice the rest's
/// place, k d^n / `k_stop`, beyond, and comes back to the stop with no speed at all each time. It once went through it there.
#[test]
fn valid_a_plate_that_turns_at_its_elastic_stop_stays_on_it() {
    let scene = "n=0.665328 k=21.96 d=0.530422 gamma=4.00112e4 v_i=1.92683e-3 h=6.93114e-3 theta=70.9473deg S_y=0 \
        C_d=0.161997 x_stop=-0.530422 stop_kind=elastic k_stop=2.27056e8 run.horizon_s=0.6";
    let rest_m = 21.96 * 0.530_422_f64.powf(0.665_328) / 2.27056e8;
    for tolerance in [1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12] {
        let run = program(&draw::read(&format!("{scene} tolerance={tolerance:e}")));
        let beyond = |row: &Sample| row.plate_displacement_m + 0.530_422;
        let (least, most) = run
            .series
            .iter()
            .map(beyond)
            .fold((0.0, 0.0), |(least, most), x| (f64::min(least, x), f64::max(most, x)));
        assert!(least.abs() < 1e-5 * rest_m, "{tolerance:e}: {least:e}");
        // The contact adds some 1e-10 N to the spring's 14.
        assert!((most / (2.0 * rest_m) - 1.0).abs() < 1e-3, "{tolerance:e}: {most:e}");
    }
}

/// A damper with m = 0.2 while the plate meets its rigid stop: all energies balance wherever the stop is met.
#[test]
fn a_plate_that_meets_its_stop_within_a_stride_is_put_on_it_where_it_is() {
    let scene = "n=5.37204 m=0.201045 k=2.70515 b=3.14827e-2 d=0.888103 gamma=2.97828e-4 v_i=0.242486 h=7.04153e-5 \
        S_y=2.25583e5 C_d=1.23921e-2 x_stop=-0.88810271567";
    for tolerance in [1e-7, 1e-8, 3e-9, 1e-9, 3e-10, 1e-10, 1e-11] {
        let run = program(&draw::read(&format!("{scene} tolerance={tolerance:e}")));
        assert!(run.ledger.residual().abs() < 1e-12, "{tolerance:e}: {:e}", run.ledger.residual());
    }
}

/// Bounces of a plate pressed on its stop lose 1 - e^2 of their energy each: a hundred of them leave nothing that could be told from
/// rest. They once went on for ever, since the way back ended beyond the stop.
#[test]
fn valid_bounces_on_a_rigid_stop_die_down() {
    let scene = "spring=table table=-3.8592e-3:-67.72,-2.7626e-3:171.77,-2.39803e-3:227.82,0:400 own_mass=counted \
        m_spring=0.012621 m=0.5 b=14.73 d=0.0033517 gamma=3.2204 v_i=97.115 h=0.0025046 interface=plastic g=0.1 \
        x_stop=-3.311575e-3 e=0.8 run.horizon_s=7.1877e-4";
    let run = program(&draw::read(scene));
    let hits = run.events.iter().filter(|event| event.kind == EventKind::StopHit).count();
    let kept: f64 = 0.8;
    // Down to the part of the impact velocity below which a rebound is none.
    let most = 1e-9_f64.ln() / kept.ln();
    assert!(hits >= 10 && hits as f64 <= most, "{hits} of {most}");
    all_agree(&[scene]);
}
