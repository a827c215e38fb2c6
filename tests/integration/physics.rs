//! The simulation against answers from elsewhere: the stored digits of independent high-precision computations, closed forms
//! in 30-digit arithmetic, and the numbers the model page recomputed.

use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Instant;

use cmra::model::impact::{Settings, simulate};
use cmra::model::run::{EndReason, Outcome, Run, Warning};
use cmra::model::scene::{InterfaceLaw, Mount, Scene};
use cmra::model::units::Bare;
use cmra::model::variables;

fn run(scene: Scene) -> Run {
    simulate(&Arc::new(scene), &Settings::default(), &mut |_| ControlFlow::Continue(())).unwrap()
}

/// A scene from `name=value` pairs; the spring is absent unless named.
fn scene(pairs: &str) -> Scene {
    let mut scene = Scene::default();
    scene.mechanism.spring.coefficient = 0.0;
    for pair in pairs.split_whitespace().filter(|pair| *pair != "base") {
        let (name, value) = pair.split_once('=').unwrap();
        variables::set_by_name(&mut scene, name, value, Bare::Si).unwrap();
    }
    scene
}

fn relative(value: f64, exact: f64) -> f64 {
    (value / exact - 1.0).abs()
}

#[test]
fn valid_every_row_of_the_reference_to_1e_9_in_depth_and_time() {
    let mut reader = csv::Reader::from_path("tests/cases/reference.csv").unwrap();
    let mut rows = 0;
    for row in reader.records() {
        let row = row.unwrap();
        let number = |i: usize| row[i].parse::<f64>().unwrap();
        let started = Instant::now();
        let run = run(scene(&row[1]));
        let took = started.elapsed();
        let (t_s, depth_m) = if &row[2] == "perf" {
            assert_eq!(run.outcome, Outcome::Perforated, "{}", &row[0]);
            (run.exit_time_s.unwrap(), run.final_penetration_m.unwrap())
        } else {
            let arrest = run.first_arrest.unwrap();
            println!(
                "   x {:.1e} w {:.1e}",
                relative(arrest.plate_displacement_m, number(5)),
                relative(arrest.plate_velocity_m_s, number(6))
            );
            (arrest.t_s, arrest.penetration_m)
        };
        println!(
            "{:4} {t_s:.17e} t {:.1e} p {:.1e} est {:?} resid {:.1e} steps {} {} {took:?} {:?} {:?}",
            &row[0],
            relative(t_s, number(3)),
            relative(depth_m, number(4)),
            run.error_estimate.map(|e| e.relative),
            run.ledger.residual(),
            run.cost.steps,
            run.cost.method,
            run.outcome,
            run.end,
        );
        assert!(relative(t_s, number(3)) < 1e-9, "{} t", &row[0]);
        assert!(relative(depth_m, number(4)) < 1e-9, "{} p", &row[0]);
        rows += 1;
    }
    assert_eq!(rows, 10);
}

#[test]
fn explore() {
    for pairs in [
        "d=0.5 k=1e5",
        "d=0.5 k=1e5 interface=plastic",
        "gamma=0.8 k=7.5e6",
        "gamma=0.8 k=7.5e6 interface=plastic",
        "k=1e5 x_stop=0.01",
        "k=1e5 x_stop=0.01 interface=plastic",
        "x_stop=0.001 e=0.5 k=1e5",
        "x_stop=0 k=1e5",
        "x_stop=0.01 stop_kind=elastic k_stop=1e7 b_stop=100 k=1e5",
        "x_stop=0.001 stop_kind=elastic k_stop=1e9 interface=plastic k=1e5",
        "theta=30deg k=1e5",
        "theta=60deg k=1e5 interface=plastic",
        "theta=85deg k=1e5",
        "mount=rigid",
        "mount=rigid h=0.003 v_i=400",
        "h=0.003 v_i=400",
        "b=1000",
        "b=1000 m=0.5",
        "b=1000 m=0.5 k=1e5",
        "b=1000 m=0.2",
        "b=1e6",
        "b=1e8",
        "b=1e8 m=0.2",
        "b=1e8 m=3",
        "b=100 m=2 k=1e5 n=2",
        "k=1e12",
        "k=1e12 gamma=1e-4",
        "k=1e5 n=0.1",
        "k=1e6 n=0.2",
        "k=1e5 n=0.05",
        "k=1e12 n=0.05",
        "k=1e5 n=6",
        "k=1e12 n=6",
        "k=1e5 gamma=1e6",
        "k=1e5 gamma=1e-4",
        "k=1e5 v_i=1e-3",
        "k=1e5 v_i=3000",
        "d=1 k=1e9",
        "d=1 k=1e9 interface=plastic",
        "S_y=0 k=1e5",
        "S_y=0 C_d=0 k=1e5",
        "C_d=0 k=1e5",
        "S_y=0 k=1e5 interface=plastic d=0.01",
        "k=7.5e6 n=0.1",
        "k=1e6 n=0.5 interface=plastic",
        "k=1e5 n=1.4 d=0.1 interface=plastic",
        "b=2000 k=1e5 horizon=0.02",
        "k=1e6 n=0.5 horizon=0.01",
        "gamma=1e-4 b=1e8 m=0.2 k=1e12 n=0.05 d=1 v_i=3000",
        "gamma=1e-4 b=1e8 m=0.5 k=1e9 n=0.5 d=0.1 v_i=1e-3",
        "k=1e12 v_i=1e-3 interface=plastic",
        "k=1e12 gamma=1e-4 v_i=1e-3",
    ] {
        let started = Instant::now();
        let scene = Arc::new(scene(pairs));
        let run = simulate(&scene, &Settings { estimate: false, series: true }, &mut |_| {
            ControlFlow::Continue(())
        })
        .unwrap();
        let took = started.elapsed();
        println!(
            "{pairs:60} {} {:?} first {:?} final {:?} xmax {:?} res {:.1e} demand {:?} steps {} rej {} {} ev {} sep {:?} vr {:?} {took:?} t_end {:?}",
            run.outcome,
            run.end,
            run.first_arrest.map(|a| a.penetration_m * 1e3),
            run.final_penetration_m.map(|p| p * 1e3),
            run.max_plate_displacement_m.map(|x| x * 1e3),
            run.ledger.residual(),
            run.interface_demand_ratio,
            run.cost.steps,
            run.cost.rejected,
            run.cost.method,
            run.events.len(),
            run.separation,
            run.residual_velocity_m_s,
            run.series.last().map(|s| s.t_s)
        );
        for w in &run.warnings {
            println!("      {w}");
        }
    }
}
