//! Whole runs on every kind of mechanism, against closed forms and against each other.

use cmra::files::read;
use cmra_engine::model::contact_kernel::Contact;
use cmra_engine::model::mechanism::{Mechanism, load};
use cmra_engine::model::run::{Outcome, Run, RunWarning};
use cmra_engine::model::scene::{Scene, SpringKind};
use cmra_engine::model::variables;

use crate::support::{assert_near, run, scene, scene_file};

/// Depth, time, plate displacement and velocity at the first arrest, and the greatest displacement.
fn outcome(run: &Run) -> [f64; 5] {
    let arrest = run.first_arrest.unwrap();
    [
        arrest.penetration_m,
        arrest.t_s,
        arrest.plate_displacement_m,
        arrest.plate_velocity_m_s,
        run.max_plate_displacement_m.unwrap(),
    ]
}

#[track_caller]
fn assert_same(one: &Run, other: &Run, tolerance: f64) {
    for (a, b) in outcome(one).into_iter().zip(outcome(other)) {
        assert_near(a, b, tolerance);
    }
}

#[test]
fn a_straight_table_is_the_linear_spring() {
    for start in ["", "d=0.02 ", "x_stop=0.01 ", "b=20 ", "v_i=150 gamma=3 "] {
        let linear = run(scene(&format!("{start}k=1e5")));
        assert_same(&run(scene(&format!("{start}spring=table"))), &linear, 1e-10);
    }
}

/// The terms of the force cancel far from the first point, and leave their rounding to a plate that creeps to rest.
#[test]
fn an_overdamped_plate_on_a_straight_table_comes_to_rest() {
    let mut own = scene("spring=table d=50mm b=1000");
    own.mechanism.spring.table.points = [[-2.0, -12_080.0], [2.0, 12_080.0]].into();
    let (table, linear) = (run(own), run(scene("k=6040 d=50mm b=1000")));
    assert!(table.end.is_complete(), "{:?} {:?}", table.end, table.cost);
    assert_eq!(
        outcome(&table).map(|value| value.abs() < 1e-12),
        [false, false, false, false, true]
    );
    for (a, b) in outcome(&table).into_iter().zip(outcome(&linear)).take(4) {
        assert_near(a, b, 1e-10);
    }
}

#[test]
fn two_linear_springs_are_one() {
    let pair = run(scene("combine=parallel k=1e5 k_2=3e5 d=0.004"));
    assert_same(&pair, &run(scene("k=4e5 d=0.004")), 1e-12);
    // Two power laws of one exponent are one, too, and three equal ones are three times one.
    let bent = run(scene("combine=parallel k=1e6 k_2=3e6 n=1.4 n_2=1.4"));
    assert_same(&bent, &run(scene("k=4e6 n=1.4")), 1e-10);
    assert_same(&run(scene("k=1e6 n=1.4 N_spring=3")), &run(scene("k=3e6 n=1.4")), 1e-13);
}

/// Straight very close to zero, a steep law of a combination starts like the same law alone, which starts singular.
#[test]
fn a_spring_that_does_nothing_beside_a_steep_one_changes_nothing() {
    for (law, tolerance) in [("n=0.3 k=1e5", 2e-10), ("n=0.5 k=1e5", 1e-11), ("n=0.2 k=1e3", 2e-9)]
    {
        let pair = law.replace('=', "_2=");
        let pair = run(scene(&format!("combine=parallel n=1 k=1e-9 {pair}")));
        assert_same(&pair, &run(scene(law)), tolerance);
    }
}

#[test]
fn the_normalised_law_is_the_power_law_and_follows_its_reference() {
    let k = 900.0 / 0.02f64.powf(1.4);
    let power = run(scene(&format!("k={k} n=1.4")));
    assert_same(&run(scene("spring=normalised F_ref=900 x_ref=0.02 n=1.4")), &power, 1e-12);
}

/// A plate at rest on a knot starts into the stretch that it goes to, whatever the sign of a force that is only rounding.
#[test]
fn a_force_of_rounding_at_a_knot_does_not_decide_where_the_plate_goes() {
    let with = |force_n: f64| {
        let mut scene = scene("spring=table v_i=60");
        scene.mechanism.spring.table.points =
            [[-0.05, 0.0], [0.0, force_n], [5e-4, 2e4], [0.05, 2.1e4]].into();
        run(scene)
    };
    let exact = with(0.0);
    for force_n in [1e-14, 3e-13, 4e-12, 1e-10] {
        assert_same(&with(force_n), &exact, 1e-11);
    }
}

/// Energy is kept on every kind, forward and back, cocked or not, with a stop, damped, and after the projectile has gone.
#[test]
fn energy_is_kept_on_every_kind() {
    // But for the power law itself, the first.
    let kinds = &SpringKind::WORDS[1..];
    let ways = [
        "",
        "d=0.013",
        "horizon=0.02",
        "d=0.013 horizon=0.02",
        "x_stop=0.006 d=0.003 e=0.4",
        "x_stop=0.006 stop_kind=elastic k_stop=3e6 b_stop=20",
        "interface=plastic horizon=0.008",
        "b=40 horizon=0.01",
        "h=0.004 v_i=150",
        "theta=0.4rad tol=1e-11",
    ];
    for kind in kinds {
        for more in ways {
            let own = scene(&format!("spring={kind} {more} own_mass=counted m_spring=0.05"));
            let run = run(own);
            assert!(run.end.is_complete(), "{kind} {more}: {:?}", run.end);
            let residual = run.ledger.residual();
            assert!(residual.abs() < 2e-12, "{kind} {more}: {residual:e}");
            let error = run.estimate.main.unwrap_or(0.0);
            assert!(error < 1e-8, "{kind} {more}: {error:e}");
        }
    }
}

#[test]
fn energy_is_kept_on_combinations() {
    for first in ["prbm-cantilever", "prbm-guided", "table", "bistable", "column"] {
        for second in ["n_2=1 k_2=2e5", "n_2=1.5 k_2=1e7", "n_2=0.7 k_2=2e4"] {
            for more in ["", "d=0.01 horizon=0.01"] {
                let own = scene(&format!("combine=parallel spring={first} {second} {more}"));
                let run = run(own);
                let residual = run.ledger.residual();
                assert!(
                    run.end.is_complete() && residual.abs() < 1e-10,
                    "{first} {second} {more}: {residual:e}"
                );
            }
        }
    }
}

/// The spring's law changes where the stop begins, and the plate turns at once.
#[test]
fn energy_is_kept_where_a_spring_changes_at_the_stop() {
    let spring = "spring=constant x_c=0.002 F_c=2.084e4 k=0 d=0.00802";
    let stop = "x_stop=0.002 stop_kind=elastic k_stop=3.508e8 b_stop=2.579e4";
    let run = run(scene(&format!("{spring} {stop} gamma=6.43 v_i=14.17 h=0.0055 horizon=0.0172")));
    assert!(run.ledger.residual().abs() < 1e-10, "{:e}", run.ledger.residual());
}

#[test]
fn a_constant_force_makes_a_parabola() {
    let run = run(scene("spring=constant F_c=3000 x_c=0.0005 horizon=0.0008"));
    let arrest = run.first_arrest.unwrap();
    let (x, w) = (arrest.plate_displacement_m, arrest.plate_velocity_m_s);
    assert!(x > 0.0005, "the force is constant by then");
    let rate = 3000.0 / 0.059;
    assert_near(run.max_plate_displacement_m.unwrap(), x + w * w / (2.0 * rate), 1e-12);
    let mut compared = 0;
    for row in run.series.iter().filter(|row| row.t_s > arrest.t_s) {
        let t = row.t_s - arrest.t_s;
        if row.plate_displacement_m > 0.0006 {
            assert_near(row.plate_displacement_m, x + t * (w - 0.5 * rate * t), 1e-11);
            assert!((row.plate_velocity_m_s - (w - rate * t)).abs() < 1e-9 * w);
            compared += 1;
        }
    }
    assert!(compared > 5, "{compared}");
}

/// At its turn all energy of the joined bodies is in the spring: K Theta²/2, and the quartic of the double well.
#[test]
fn the_turn_of_a_beam_and_of_a_double_well_is_a_balance_of_energies() {
    let at_turn = |run: &Run, energy: &dyn Fn(f64) -> f64| {
        let arrest = run.first_arrest.unwrap();
        let (x, w) = (arrest.plate_displacement_m, arrest.plate_velocity_m_s);
        let turn = run.max_plate_displacement_m.unwrap();
        assert_near(energy(turn), energy(x) + 0.5 * 0.059 * w * w, 1e-12);
        assert!(turn > 0.01, "{turn}");
    };
    let torsional = 0.85 * 2.65 * 113.8e9 * 0.03 * 0.015f64.powi(3) / 12.0 / 0.3;
    at_turn(&run(scene("spring=prbm-cantilever")), &|x| {
        0.5 * torsional * (x / (0.85 * 0.3)).asin().powi(2)
    });
    // F = C x (x - u)(x - s), u = s/2: the barrier is at x = s (1/2 - 1/sqrt(12)).
    let s: f64 = 0.02;
    let top = s * (0.5 - 1.0 / 12f64.sqrt());
    let c = 1e3 / (top * (top - 0.5 * s) * (top - s));
    at_turn(&run(scene("spring=bistable")), &|x| {
        c * (x.powi(4) / 4.0 - 0.5 * s * x.powi(3) + 0.25 * s * s * x * x)
    });
}

/// A plate that turns with its displacement answers as a heavier one.
#[test]
fn rotation_is_mass() {
    // I_z twist² = 4e-6 * 50² = 0.01 kg.
    let turning = run(scene("spring=helix k_helix=1e5 twist=50 I_z=4e-6"));
    let heavy = run(scene(&format!("k=1e5 gamma={}", 1.0 + 0.01 / 0.0295)));
    assert_same(&turning, &heavy, 1e-13);
    let load = turning.mechanism;
    assert_near(load.added_kg.unwrap(), 0.01, 1e-12);
    let w = turning.first_arrest.unwrap().plate_velocity_m_s;
    assert!(load.rotation_j.unwrap() >= 0.5 * 0.01 * w * w * (1.0 - 1e-12));
    // A spring's own mass likewise: a third of 0.03 kg.
    let counted = run(scene("k=1e5 own_mass=counted m_spring=0.03"));
    assert_same(&counted, &heavy, 1e-13);
}

/// A plate that turns before 5 mm does not depend on a column's or table's law beyond it.
#[test]
fn below_the_onset_a_column_is_a_linear_spring() {
    let column = run(scene("spring=column k_col=2e6 F_crit=20000 F_plat=100 v_i=60"));
    let linear = run(scene("k=2e6 v_i=60"));
    assert!(linear.max_plate_displacement_m.unwrap() < 0.01);
    assert_same(&column, &linear, 1e-12);
}

#[test]
fn a_soft_column_gives_way_at_its_onset() {
    let run = run(scene("spring=column k_col=5e6 F_crit=5000 F_plat=3000 x_fall=0.002"));
    let most = run.series.iter().map(|row| row.spring_force_n).fold(0.0, f64::max);
    assert!(most <= 5000.0 * (1.0 + 1e-12) && most > 4900.0, "{most}");
    let last = run.series.iter().find(|row| row.plate_displacement_m > 0.0031).unwrap();
    assert_near(last.spring_force_n, 3000.0, 1e-12);
}

/// Impossible numbers never come out of any mixture: the run ends with a closed ledger or says why not.
#[test]
fn random_mechanisms_keep_their_energy() {
    use cmra_engine::numerics::random::Random;
    let mut random = Random::new(20_070_401);
    let kinds = SpringKind::ALL;
    for _ in 0..300 {
        let mut own = Scene::default();
        let mechanism = &mut own.mechanism;
        let spring = &mut mechanism.spring;
        spring.kind = kinds[random.below(kinds.len())];
        let mut scale = |value: &mut f64| *value *= 10f64.powf(2.0 * random.unit() - 1.0);
        scale(&mut spring.coefficient);
        scale(&mut spring.normalised.force_n);
        scale(&mut spring.beam.length_m);
        scale(&mut spring.bistable.second_m);
        scale(&mut spring.bistable.barrier_n);
        scale(&mut spring.constant.force_n);
        scale(&mut spring.column.critical_n);
        scale(&mut spring.column.plateau_n);
        scale(&mut spring.column.fall_m);
        scale(&mut mechanism.second.coefficient);
        spring.exponent = 0.4 + 2.0 * random.unit();
        mechanism.second.exponent = 0.4 + 2.0 * random.unit();
        if random.unit() < 0.3 {
            own.mechanism.combination = cmra_engine::model::scene::Combination::Parallel;
        }
        own.plate.cocking_m = if random.unit() < 0.5 { 0.0 } else { 0.02 * random.unit() };
        own.mechanism.damper.coefficient = if random.unit() < 0.5 { 0.0 } else { 200.0 };
        own.projectile.velocity_m_s = 40.0 + 260.0 * random.unit();
        let told = format!("{:?} {:?}", own.mechanism, own.plate);
        let run = run(own);
        assert!(run.end.is_complete(), "{:?}: {told}", run.end);
        let residual = run.ledger.residual();
        assert!(residual.abs() < 1e-9, "{residual:e}: {told}");
    }
}

/// A sweep, a limit and a quick contact go the full way for every kind: the contact kernel takes no curve, and the rest as a run does.
#[test]
fn the_contact_kernel_leaves_curves_to_the_simulation() {
    for kind in SpringKind::ALL {
        let own = scene(&format!("spring={}", kind.word()));
        let quick = Contact::from_scene(&own).and_then(|contact| contact.run(own.run.tolerance));
        let is_curve = Mechanism::from_scene(&own).spring.power().is_none();
        assert_eq!(quick.is_none(), is_curve, "{}", kind.word());
        if let Some(quick) = quick {
            assert_near(quick.penetration_m, run(own).first_arrest.unwrap().penetration_m, 1e-9);
        }
    }
}

#[test]
fn cocked_mechanisms_push_the_plate_with_the_shot() {
    for kind in ["prbm-cantilever", "prbm-guided", "constant", "table", "helix"] {
        let rest = run(scene(&format!("spring={kind}")));
        let cocked = run(scene(&format!("spring={kind} d=0.01")));
        assert_eq!(cocked.outcome, Outcome::Arrested);
        assert!(outcome(&cocked)[0] < outcome(&rest)[0], "{kind}");
        assert!(cocked.ledger.initial_spring_j > 0.0, "{kind}");
    }
}

#[test]
fn an_impossible_value_is_refused_with_name_value_rule_and_cure() {
    let refused = |pairs: &str| {
        let own = scene(pairs);
        variables::validate(&own).unwrap_err().to_string()
    };
    let cases = [
        (
            "spring=bistable x_2=0.01 x_u=0.02",
            vec!["x_u", "0.02", "0.01", "less than x_2", "midway"],
        ),
        ("model=appendix spring=helix", vec!["appendix", "helix", "power-law"]),
        ("model=appendix combine=parallel", vec!["appendix", "in parallel", "alone"]),
    ];
    for (pairs, words) in cases {
        let text = refused(pairs);
        for word in words {
            assert!(text.contains(word), "{pairs}: {text}");
        }
    }
    let mut own = Scene::default();
    let height = variables::find("mechanism.spring.beam.height_m").unwrap();
    let text = height.set(&mut own, variables::Value::Number(0.0)).unwrap_err().to_string();
    for word in ["h_beam", "mechanism.spring.beam.height_m", "= 0 m", "greater than 0 m", "0.015"] {
        assert!(text.contains(word), "{text}");
    }
}

/// A plate that nothing turns passes the last point of its table, on either side and wherever the record of the run ends. Force falls to
/// 0 at 40 mm and -40 mm and drives the plate on from there.
#[test]
fn a_plate_that_nothing_turns_is_beyond_the_end_of_its_table() {
    let limits = |changes: &str| -> Vec<(f64, f64)> {
        let mut own = scene(&format!("spring=table {changes}"));
        own.mechanism.spring.table.points = [[0.0, 0.0], [0.01, 100.0], [0.02, 50.0]].into();
        let limit = |warning: &RunWarning| match warning {
            RunWarning::Limit(limit) => Some((limit.required_m, limit.limit_m)),
            _ => None,
        };
        run(own).warnings.iter().filter_map(limit).collect()
    };
    for changes in ["", "b=0.1", "gamma=0.05 v_i=400", "w_0=-60"] {
        assert_eq!(limits(changes), [(f64::INFINITY, 0.02)], "{changes}");
    }
    for changes in ["w_0=-60 v_i=1", "w_0=-150", "w_0=-150 x_stop=0.05"] {
        assert_eq!(limits(changes), [(f64::NEG_INFINITY, -0.02)], "{changes}");
    }
    // A stop ends the way, and so does the spring, which takes at least 1.25 J within its table: 59 g at 5 m/s have 0.74 J.
    assert_eq!(limits("x_stop=1"), [(1.0, 0.02)]);
    assert_eq!(limits("v_i=10"), []);
    assert_eq!(limits("mount=rigid"), []);
}

#[test]
fn a_table_that_does_not_rise_is_refused_at_its_place() {
    let text = "format = 1\n[mechanism.spring]\nkind = \"table\"\n[mechanism.spring.table]\npoints = [[0.0, 0.0], [0.01, 5.0], [0.01, 7.0]]\n";
    let told = read::scene(text, "own.toml").unwrap_err().to_string();
    for word in
        ["own.toml:", "mechanism.spring.table", "x = 0.01 m of point 3", "must rise", "sort"]
    {
        assert!(told.contains(word), "{told}");
    }
    // The first 1.2 mm were not measured: nothing is known of the force at rest.
    let late = text.replace("[0.0, 0.0], [0.01, 5.0]", "[0.0012, 35.0], [0.005, 50.0]");
    let told = read::scene(&late, "own.toml").unwrap_err().to_string();
    assert!(told.contains("x = 0.0012 m, F = 35 N") && told.contains("add the point"), "{told}");
    let short = text.replace(", [0.01, 5.0], [0.01, 7.0]", "");
    let told = read::scene(&short, "own.toml").unwrap_err().to_string();
    assert!(told.contains("has 1 points: it must have 2"), "{told}");
}

#[test]
fn a_measured_curve_is_read_from_its_file_and_kept_in_the_scene() {
    let place = tempfile::tempdir().unwrap();
    let folder = place.path();
    std::fs::write(folder.join("curve.csv"), "x_m,force_n\n0,0\n0.002,900\n0.01,1500\n").unwrap();
    let path = folder.join("scene.toml");
    let text = "format = 1\n[mechanism.spring]\nkind = \"table\"\ntable.file = \"curve.csv\"\n";
    std::fs::write(&path, text).unwrap();
    let own = scene_file(&path).unwrap();
    assert_eq!(
        own.mechanism.spring.table.points.as_ref(),
        [[0.0, 0.0], [0.002, 900.0], [0.01, 1500.0]]
    );
    let written = cmra::files::write::fresh(&own);
    assert_eq!(read::scene(&written, "elsewhere.toml").unwrap(), own, "{written}");
    std::fs::write(folder.join("curve.csv"), "x_m,force_n\n0,0\n0.002 900\n").unwrap();
    let told = scene_file(&path).unwrap_err().to_string();
    for word in ["curve.csv", "line 3", "0.002 900", "0.01,1000"] {
        assert!(told.contains(word), "{told}");
    }
}

#[test]
fn a_measured_curve_is_taken_from_the_command_line() {
    let place = tempfile::tempdir().unwrap();
    let folder = place.path();
    let file = folder.join("curve.csv");
    // The baseline's spring as measured points: the same answer.
    std::fs::write(&file, "x_m,force_n\n0,0\n0.02,2000\n0.1,10000\n").unwrap();
    let cmra = |argument: &str| {
        let command = crate::support::program();
        let mut command = command;
        command.args(["run", "--json", "--set", argument]).output().unwrap()
    };
    let found = cmra(&format!("table={}", file.display()));
    assert!(found.status.success());
    let run: serde_json::Value = serde_json::from_slice(&found.stdout).unwrap();
    assert_near(
        run["first_arrest_penetration_m"].as_f64().unwrap(),
        0.004_571_788_754_106_379,
        1e-11,
    );
    std::fs::write(&file, "0,0\n0.02,2000\n0.01,10000\n").unwrap();
    for (file, words) in [
        (file.display().to_string(), &["line 3", "from 0.02 to 0.01 m, an unloading branch"][..]),
        (folder.join("none.csv").display().to_string(), &["none.csv", "cannot read"][..]),
    ] {
        let refused = cmra(&format!("table={file}"));
        assert_eq!(refused.status.code(), Some(2));
        let told = String::from_utf8(refused.stderr).unwrap();
        assert!(words.iter().all(|word| told.contains(word)), "{told}");
    }
}

#[test]
fn every_kind_is_written_and_read_without_loss() {
    for kind in SpringKind::ALL {
        for how in ["alone", "parallel"] {
            let pairs = format!(
                "spring={} combine={how} n_2=1.5 own_mass=counted h_beam=0.02 N_spring=3",
                kind.word()
            );
            let own = scene(&pairs);
            let text = cmra::files::write::fresh(&own);
            assert_eq!(read::scene(&text, "own.toml").unwrap(), own, "{text}");
            let plain = cmra::files::write::fresh(&Scene::default());
            let updated = cmra::files::write::updated(&plain, "own.toml", &own).unwrap();
            assert_eq!(read::scene(&updated, "own.toml").unwrap(), own, "{updated}");
        }
    }
}

/// Behind its rest position this spring has no force. There a damper alone takes up the momentum of plate and projectile, over a way of
/// momentum over b; without damper nothing does, whether they move backwards at once or come back from the spring.
#[test]
fn a_plate_that_runs_off_the_backward_end_of_a_table_is_said_to() {
    for (pairs, back_m) in [
        ("v_i=5 w_0=-50 b=10", 0.0295 * (5.0 - 50.0) / 10.0),
        ("v_i=5 w_0=-50", f64::NEG_INFINITY),
        ("v_i=50", f64::NEG_INFINITY),
        ("v_i=50 x_stop=1mm e=1", f64::NEG_INFINITY),
    ] {
        let mut own = scene(&format!("spring=table {pairs}"));
        own.mechanism.spring.table.points = [[-1e-3, 0.0], [0.0, 0.0], [0.5, 5e4]].into();
        let found = run(own);
        let warned = found.warnings.iter().find_map(|warning| match warning {
            RunWarning::Limit(limit) => Some(limit.required_m),
            _ => None,
        });
        let warned_m = warned.unwrap_or_else(|| panic!("{pairs}: {:?}", found.warnings));
        assert!((1.0 / warned_m - 1.0 / back_m).abs() < 1e-5, "{pairs}: {warned_m}");
        let margin = load::travel_margin(&found.scene, found.displacements_m().unwrap()).unwrap();
        assert!((margin - 1e-3 / back_m.abs()).abs() < 1e-7, "{pairs}: {margin}");
        assert!(found.mechanism.stored_j.unwrap().is_finite(), "{pairs}");
    }
}
