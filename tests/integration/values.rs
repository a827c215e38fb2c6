//! Values of runs, each from a source of its own: closed forms, momentum, energy, or the oracle's tiny steps.

use cmra_engine::model::run::{EndReason, Outcome};
use cmra_engine::model::scene::Scene;
use cmra_oracle::Shot;
use serde_json::Value;

use crate::support::{assert_near, run, says, scene};

/// Where the oracle has the plate at a time, m.
fn stepped_m(pairs: &str, step_s: f64, t_s: f64) -> f64 {
    stepped(&scene(pairs), step_s, t_s).place()[2]
}

/// A shot by the oracle's steps up to a time.
fn stepped(own: &Scene, step_s: f64, t_s: f64) -> Shot<'_> {
    let mut shot = Shot::new(own, step_s);
    assert!(shot.go_to(t_s));
    shot
}

fn set(pairs: &str) -> Vec<&str> {
    pairs.split_whitespace().flat_map(|pair| ["--set", pair]).collect()
}

fn json(pairs: &str) -> Value {
    let arguments = [set(pairs), vec!["--json"]].concat();
    serde_json::from_str(&says("run", &arguments, 0).0).unwrap()
}

/// The numbers that tests of screens and pages look for (`screens/cases.rs`, `terminal.rs`, `cli.rs`, `limit.rs`), as they round them.
#[test]
fn valid_numbers_that_screens_are_searched_for_are_those_of_tiny_steps() {
    let baseline = scene("k=1e5");
    let mut shot = Shot::new(&baseline, 1e-8);
    let mut peak_n: f64 = 0.0;
    for i in 1..=1200 {
        let before_m_s = shot.velocity_m_s(shot.state);
        assert!(shot.go_to(f64::from(i) * 1e-7));
        let slowed_m_s = before_m_s - shot.velocity_m_s(shot.state);
        peak_n = peak_n.max(0.0295 * slowed_m_s / 1e-7);
    }
    assert_eq!(format!("{:.3}", 1e3 * shot.hole_m()), "4.572");
    assert_eq!(format!("{:.2}", 1e-3 * peak_n), "17.74");
    let farthest_m = stepped(&baseline, 1e-7, 2e-3).farthest_m;
    assert_eq!(format!("{:.2}", 1e3 * farthest_m), "38.38");
    assert_eq!(format!("{:.5}", 1e-3 * 1e5 * farthest_m), "3.83798");
    for (v_m_s, perforates) in [(344.327, false), (344.329, true)] {
        let near_limit = scene(&format!("v_i={v_m_s}"));
        assert_eq!(stepped(&near_limit, 1e-8, 1e-3).exit.is_some(), perforates, "{v_m_s}");
    }

    let perforated = scene("v_i=400");
    let shot = stepped(&perforated, 1e-8, 2e-4);
    let (_, at_exit) = shot.exit.unwrap();
    assert_eq!(format!("{:.1}", shot.velocity_m_s(at_exit)), "279.9");

    let heavier = scene("gamma=1.1");
    let shot = stepped(&heavier, 1e-8, 1.3e-4);
    let (_, at_arrest) = shot.first_arrest.unwrap();
    assert_eq!(format!("{:.3}", 1e3 * shot.depth_m(at_arrest[0])), "4.700");

    let cocked = scene("d=0.5 k=1e5");
    let stroke_m = stepped(&cocked, 1e-7, 4e-3).farthest_m + 0.5;
    assert_eq!(format!("{stroke_m:.3}"), "1.003");

    let yielding = scene("d=0.5 interface=plastic");
    let shot = stepped(&yielding, 1e-7, 2e-2);
    assert_eq!(format!("{:.1}", shot.velocity_m_s(shot.state)), "-20.8");

    for (pairs, t_s, depth_mm) in
        [("", 0.1, "5.269"), ("gamma=0.8 k=7.5e6", 1e-2, "4.700"), ("x_stop=10mm", 1e-2, "5.799")]
    {
        let own = scene(&format!("{pairs} interface=plastic"));
        assert_eq!(format!("{:.3}", 1e3 * stepped(&own, 2e-8, t_s).hole_m()), depth_mm, "{pairs}");
    }
}

/// A plate that hardly moves has the contact force of a plate that is held, which its spring balances.
#[test]
fn valid_a_spring_of_a_tenth_power_gives_way_by_the_tenth_power_of_the_force() {
    let held_n = run(scene("mount=rigid")).peak_contact_force_n.unwrap();
    let by_force_m = (held_n / 1e5).powi(10);
    assert_near(run(scene("n=0.1")).max_plate_displacement_m.unwrap(), by_force_m, 1e-3);
}

/// A plate that moves by 1e-13 m and less is left as fast as a plate on a rigid mount, whose residual velocity has a closed form.
#[test]
fn valid_a_shot_leaves_a_plate_on_a_stiff_spring_as_it_leaves_a_rigid_mount() {
    for pairs in ["k=6e7 n=0.3 R=2mm", "k=2e7 n=0.3 R=2mm", "k=6e7 n=0.3 R=3mm v_i=200"] {
        let left_m_s = |more: &str| {
            let found = run(scene(&format!("{pairs} {more}")));
            assert_eq!(found.outcome, Outcome::Perforated, "{pairs} {more}");
            found.departure.residual_velocity_m_s.unwrap()
        };
        assert_near(left_m_s(""), left_m_s("mount=rigid"), 1e-10);
    }
}

#[test]
fn valid_rows_at_equal_time_steps_of_a_closed_form_are_where_the_plate_is() {
    for horizon in ["horizon=1.2e-4", "horizon=3e-4"] {
        let pairs = format!("k=0 {horizon}");
        let arguments = [set(&pairs), vec!["--dt", "1us", "--csv", "-"]].concat();
        let (rows, _) = says("run", &arguments, 0);
        let mut rows = rows.lines().map(|line| line.split(',').collect::<Vec<_>>());
        let at = rows.next().unwrap().iter().position(|key| *key == "plate_displacement_m");
        let row = rows.find(|row| row[0].parse::<f64>().unwrap() > 0.99e-6).unwrap();
        let found: f64 = row[at.unwrap()].parse().unwrap();
        assert_near(found, stepped_m(&pairs, 1e-10, 1e-6), 1e-3);
    }
}

/// Springs whose exponents differ by nothing that matters are one.
#[test]
fn valid_two_steep_springs_in_parallel_are_one_spring_of_the_sum() {
    for n in [0.15, 0.35, 0.6, 1.5] {
        let one = run(scene(&format!("k=1e6 n={n}")));
        let two = scene(&format!("k=5e5 n={n} combine=parallel k_2=5e5 n_2={}", n * (1.0 + 1e-15)));
        let two = run(two);
        assert_near(two.penetration.final_m.unwrap(), one.penetration.final_m.unwrap(), 1e-12);
        assert!(two.cost.steps < 2 * one.cost.steps, "{} {}", two.cost.steps, one.cost.steps);
    }
}

/// Against a linear damper the whole momentum of the projectile is b x.
#[test]
fn valid_a_damper_that_holds_the_plate_gives_way_by_the_momentum_over_its_coefficient() {
    for b in [1e17, 1e25] {
        let found = run(scene(&format!("k=0 b={b}"))).first_arrest.unwrap();
        assert_near(found.plate_displacement_m, 0.0295 * 100.0 / b, 2e-3);
    }
}

/// The spring has the contact's force when the bodies become one, and swings back by as much: half of it pulls at a tenth.
#[test]
fn valid_a_spring_too_steep_to_move_asks_as_much_of_the_interface_as_one_that_moves() {
    for n in [0.11, 0.12] {
        let found = json(&format!("k=1e6 n={n}"));
        let warnings = found["warnings"].as_array().unwrap();
        let is_told = |it: &Value| it.as_str().unwrap().contains("pull is 5 times");
        assert!(warnings.iter().any(is_told), "{n}: {warnings:?}");
    }
}

/// After arrest the plate goes on for ever; at the horizon it is where the figure has it.
#[test]
fn valid_the_displacement_at_the_horizon_of_a_plate_that_nothing_stops() {
    let found: Value = serde_json::from_str(&says("run", &["yang-xi", "--json"], 0).0).unwrap();
    let pairs = "m_p=0.034 gamma=5.735294117647059 v_i=118.2 h=0.01 rho=2600 k=0";
    let there_m = stepped_m(pairs, 1e-8, 2.714e-3);
    assert_near(found["max_plate_displacement_m"].as_f64().unwrap(), there_m, 1e-6);
}

#[test]
fn valid_a_straight_table_is_a_straight_spring() {
    let folder = tempfile::tempdir().unwrap();
    let table = folder.path().join("straight.csv");
    let row = |i: i32| format!("{},{}\n", 1e-4 * f64::from(i), 10.0 * f64::from(i));
    std::fs::write(&table, (-1000..1000).map(row).collect::<String>()).unwrap();
    let table = format!("table={}", table.display());
    let curve: Value =
        serde_json::from_str(&says("run", &["--set", &table, "--json"], 0).0).unwrap();
    let law = json("k=1e5");
    for key in ["final_penetration_m", "max_plate_displacement_m"] {
        assert_near(curve[key].as_f64().unwrap(), law[key].as_f64().unwrap(), 1e-9);
    }
    let steps = |run: &Value| run["steps"].as_u64().unwrap();
    assert!(steps(&curve) < 4 * steps(&law), "{} {}", steps(&curve), steps(&law));
}

/// Without damping the swing back pulls as hard as the swing forward has pushed, at a tenth of the strength.
#[test]
fn valid_the_tension_of_the_interface_does_not_depend_on_whether_a_series_is_kept() {
    let found = json("k=1e6");
    let tension = 10.0 * found["interface_demand_ratio"].as_f64().unwrap();
    let with_horizon = json("k=1e6 horizon=5ms");
    let asked = ["--over", "gamma=1..2:2", "--outputs", "interface_tension_ratio", "--csv", "-"];
    let (rows, _) = says("sweep", &[set("k=1e6"), asked.to_vec()].concat(), 0);
    let swept = rows.lines().nth(1).unwrap().split(',').nth(3).unwrap().parse::<f64>().unwrap();
    for value in [&found, &with_horizon].map(|run| run["interface_tension_ratio"].as_f64()) {
        assert_near(value.unwrap(), tension, 1e-9);
    }
    assert_near(swept, tension, 1e-9);
}

/// A crushed absorber returns the energy of its elastic rise, F²/(2 k).
#[test]
fn valid_an_absorber_stores_what_it_gives_back() {
    let found = run(scene("spring=crush F_crush=5e3 k_crush=1e7 x_crush=0.1 gamma=1"));
    assert_near(found.mechanism.stored_j.unwrap(), 5e3 * 5e3 / 2e7, 1e-9);
}

/// The plate drifts slower and slower toward its stop, where what is left of its speed can move nothing any more.
#[test]
fn valid_a_plate_whose_steep_damper_stops_it_short_of_its_stop_is_decided() {
    for (b, m, x) in [(10, 3, 0.02), (100, 4, 0.02), (300, 3, 0.005), (1000, 3, 0.005)] {
        let found = run(scene(&format!("k=0 b={b} m={m} gamma=1 x_stop={x} interface=plastic")));
        assert_eq!((found.outcome, found.end), (Outcome::Arrested, EndReason::Decided), "{b} {m}");
    }
}

/// Bounces on a stop are followed until those left cannot move the depth: a run to a tighter tolerance ends where this one does.
#[test]
fn valid_bounces_that_are_left_out_move_the_depth_by_less_than_the_tolerance() {
    for pairs in [
        "k=1e5 x_stop=2mm e=0.9",
        "k=1e5 x_stop=5mm e=0.97",
        "k=0 b=50 x_stop=3mm e=0.95 v_i=60",
        "k=1e4 n=2 d=1mm x_stop=1mm e=0.9 gamma=2",
    ] {
        let depth = |tolerance: &str| {
            let own = format!("{pairs} interface=plastic run.tolerance={tolerance}");
            run(scene(&own)).penetration.final_m.unwrap()
        };
        assert_near(depth("1e-9"), depth("1e-12"), 1e-8);
    }
}

/// A plate behind an exit turns by its spring, whatever the exponent of its damper: 0.2 us before and after that the oracle has it back.
#[test]
fn valid_the_greatest_displacement_has_its_time_with_every_damper() {
    for m in ["0.3", "0.9", "0.999999", "1", "1.000001", "1.2", "1.5", "2", "2.7"] {
        let pairs = format!("b=200 m={m} h=5mm v_i=300");
        let found = json(&pairs);
        let t_s = found["max_plate_displacement_time_s"].as_f64().unwrap();
        let mut events = found["events"].as_array().unwrap().iter();
        let marked = events.find(|it| it["event"] == "greatest displacement").unwrap();
        assert_near(marked["time_s"].as_f64().unwrap(), t_s, 0.0);
        let own = scene(&pairs);
        let speed_m_s = |t_s: f64| {
            let [before_m, after_m] =
                [t_s - 1e-8, t_s + 1e-8].map(|t_s| stepped(&own, 1e-9, t_s).place()[2]);
            (after_m - before_m) / 2e-8
        };
        assert!(speed_m_s(t_s - 2e-7) > 0.0 && speed_m_s(t_s + 2e-7) < 0.0, "{m} {t_s}");
    }
}
