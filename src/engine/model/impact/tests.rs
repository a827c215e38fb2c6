//! Whole runs against values from other methods: stored digits, closed forms, the interface law's reference.

use std::ops::ControlFlow;
use std::sync::Arc;

use super::run::Extent;
use super::stepping::{Stepping, run_by};
use crate::model::impact::window::Window;
use crate::model::run::{CONTACT_WINDOW, EndReason, Outcome, Run, Sample, Settings};
use crate::model::scene::Scene;
use crate::model::simulate::simulate;
use crate::model::variables::scene_with;

fn run_to_end(scene: &Arc<Scene>, stepping: Stepping, extent: Extent<'_>) -> Run {
    run_by(scene, extent, stepping, &mut |_| ControlFlow::Continue(()))
}

fn shot(pairs: &str) -> Run {
    let scene = Arc::new(scene_with(pairs));
    let found = run_to_end(&scene, Stepping::Collocation(1e-12), Extent::BARE);
    assert_eq!(found.end, EndReason::Decided, "{pairs}");
    found
}

fn is_near(value: f64, exact: f64, part: f64) -> bool {
    (value - exact).abs() <= part * exact.abs()
}

/// The scenes whose digits are stored were computed with 34 digits by a method of its own.
#[test]
fn valid_stored_digits_of_a_contact() {
    let stored = include_str!("../../data/reference.csv");
    for line in stored.lines().skip(1) {
        let fields: Vec<&str> = line.split(',').collect();
        let changes = fields[1].replace("base", "").replace("vi=", "v_i=");
        let run = shot(&format!("gamma=1 k=0 b=0 d=0 {changes}"));
        let number = |field: usize| fields[field].parse::<f64>().unwrap();
        let rows = if fields[2] == "perf" {
            assert_eq!(run.outcome, Outcome::Perforated);
            vec![(run.exit_time_s.unwrap(), 3), (run.final_penetration_m.unwrap(), 4)]
        } else {
            let arrest = run.first_arrest.unwrap();
            let rows = [arrest.t_s, arrest.penetration_m, arrest.plate_displacement_m];
            rows.into_iter().zip(3..).chain([(arrest.plate_velocity_m_s, 6)]).collect()
        };
        for (value, field) in rows {
            let exact = number(field);
            let is_close = (value - exact).abs() <= 1e-12 * exact.abs().max(1e-6);
            assert!(is_close, "{}: {value}, not {exact}", fields[0]);
        }
    }
}

/// Two integrators agree on these to 11 digits.
#[test]
fn valid_the_interface_law_on_a_stiff_spring() {
    let pairs = "gamma=0.8 k=7.5e6 b=0 d=0 n=1 m=1";
    let fused = shot(pairs);
    assert!(is_near(fused.first_arrest.unwrap().penetration_m, 4.699_302_779_9e-3, 1e-11));
    assert!(is_near(fused.max_plate_displacement_m.unwrap(), 4.330_068_475_2e-3, 1e-11));
    let plastic = shot(&format!("{pairs} interface=plastic g=0.1"));
    assert_eq!(plastic.outcome, Outcome::Separated);
    assert!(is_near(plastic.first_arrest.unwrap().penetration_m, 4.699_302_779_9e-3, 1e-11));
    assert!(is_near(plastic.final_penetration_m.unwrap(), 4.699_991_272_2e-3, 1e-11));
    assert!(is_near(plastic.max_plate_displacement_m.unwrap(), 4.330_004_180_4e-3, 1e-11));
    assert!(is_near(plastic.separation.unwrap().velocity_m_s, -43.646_136_826, 1e-10));
}

/// A grip that cannot be pulled out and an oscillation 1 % above the strength: the first slip is on the way to the greatest
/// displacement, which is 4.29333 mm by tiny steps of the law itself.
#[test]
fn valid_slips_before_the_greatest_displacement_are_followed_and_those_after_it_summed() {
    let run = shot("gamma=0.8 k=7.6e6 interface=plastic g=2");
    assert_eq!(run.outcome, Outcome::Arrested);
    let far_m = run.max_plate_displacement_m.unwrap();
    assert!((far_m - 4.293_33e-3).abs() < 5e-9, "{far_m}");
    // Afterwards the interface just holds.
    assert!(is_near(run.interface_demand_ratio.unwrap(), 1.0, 1e-12));
}

/// The travel after which a rigid or free plate has stopped the shot, or the speed that is left: closed forms.
#[test]
fn valid_rigid_and_free_plates() {
    let rigid = shot("mount=rigid");
    assert!(is_near(rigid.final_penetration_m.unwrap(), 7.113_054_853_423_409e-3, 1e-13));
    assert!(is_near(rigid.first_arrest.unwrap().t_s, 1.850_116_460_604_822e-4, 1e-13));
    let free = shot("gamma=1 k=0");
    assert!(is_near(free.final_penetration_m.unwrap(), 4.568_088_344_392e-3, 1e-12));
    assert!(is_near(free.first_arrest.unwrap().plate_velocity_m_s, 50.0, 1e-13));
    assert_eq!(free.max_plate_displacement_m, None);
    for (pairs, limit) in [("mount=rigid", 232.295_378), ("gamma=1 k=0", 347.708_052)] {
        let below = shot(&format!("{pairs} v_i={}", limit - 1e-4));
        let above = shot(&format!("{pairs} v_i={}", limit + 1e-4));
        assert_eq!(below.outcome, Outcome::Arrested, "{pairs}");
        assert_eq!(above.outcome, Outcome::Perforated, "{pairs}");
    }
}

/// Seen from a free plate it is at rest, and the projectile comes with the difference of both velocities.
#[test]
fn valid_a_free_plate_that_moves_is_struck_as_one_at_rest_by_a_slower_shot() {
    for (plate_m_s, theta) in [(30.0, 0.0_f64), (-40.0, 0.0), (30.0, 30.0)] {
        let along_m_s = plate_m_s * theta.to_radians().cos();
        for v in [100.0, 500.0] {
            let of =
                |v: f64, w: f64| shot(&format!("gamma=1 k=0 theta={theta}deg v_i={v} w_0={w}"));
            let (moving, resting) = (of(v, plate_m_s), of(v - along_m_s, 0.0));
            assert_eq!(moving.outcome, resting.outcome);
            let same = |it: fn(&Run) -> Option<f64>, more: f64| {
                let (own, other) = (it(&moving), it(&resting));
                assert_eq!(own.is_some(), other.is_some());
                let pair = own.zip(other);
                assert!(pair.is_none_or(|(own, other)| is_near(own, other + more, 1e-11)));
            };
            same(|run| run.first_arrest.map(|it| it.penetration_m), 0.0);
            same(|run| run.first_arrest.map(|it| it.t_s), 0.0);
            same(|run| run.exit_time_s, 0.0);
            same(|run| run.peak_contact_force_n, 0.0);
            same(|run| run.residual_velocity_m_s, along_m_s);
            same(|run| run.first_arrest.map(|it| it.plate_velocity_m_s), plate_m_s);
        }
    }
}

/// At the turn the spring has all energy but what the hole took, by a formula of its own for k x^n.
#[test]
fn valid_a_plate_that_moves_at_first_contact_brings_its_energy() {
    for (n, k) in [(1.0, 1e5), (1.5, 1e6), (0.5, 2e4)] {
        for w in [40.0, -40.0] {
            let run = shot(&format!("gamma=1 d=0.002 k={k} n={n} w_0={w}"));
            let stored_j = |x_m: f64| k * x_m.powf(n + 1.0) / (n + 1.0);
            let initial_j = 0.5 * 0.0295 * (100.0 * 100.0 + w * w) + stored_j(0.002);
            let spent_j =
                run.ledger.penetration_j + stored_j(run.max_plate_displacement_m.unwrap());
            assert!(is_near(spent_j, initial_j, 1e-10), "{n} {w}: {spent_j} J, not {initial_j} J");
        }
    }
}

/// A rigid stop under the fused law: all momentum of the joined body is gone, and the stop is the greatest displacement.
#[test]
fn valid_a_rigid_stop_is_the_greatest_displacement() {
    let fused = shot("gamma=1 k=1e5 x_stop=0.005");
    assert!(is_near(fused.max_plate_displacement_m.unwrap(), 5e-3, 1e-15));
    // By the plastic law the stop takes the plate alone: 83 % of the baseline of 7.113 mm, not 64 %.
    let depth = |law: &str| {
        let run = shot(&format!("gamma=1 k=0 x_stop=0.005 interface={law}"));
        run.final_penetration_m.unwrap() / 7.113_055e-3
    };
    assert!((depth("fused") - 0.64).abs() < 5e-3 && (depth("plastic") - 0.83).abs() < 5e-3);
}

/// At the turn all energy of 59 g at `w` is in the spring, or gone: of the force from 0.5 mm on, of the quartic of the double well, of
/// the absorber's crush force.
#[test]
fn valid_springs_that_are_curves_turn_the_plate_where_its_energy_is_spent() {
    let turn = |pairs: &str| {
        let run = shot(&format!("gamma=1 {pairs}"));
        let arrest = run.first_arrest.unwrap();
        let kinetic_j = 0.5 * 0.059 * arrest.plate_velocity_m_s * arrest.plate_velocity_m_s;
        (arrest.plate_displacement_m, kinetic_j, run.max_plate_displacement_m.unwrap())
    };
    for pairs in
        ["spring=constant F_c=3000 x_c=0.0005", "spring=crush F_crush=3000 k_crush=6e6 x_crush=0.1"]
    {
        let (x_m, kinetic_j, far_m) = turn(pairs);
        assert!(
            x_m > 0.0005 && is_near(far_m, x_m + kinetic_j / 3000.0, 1e-12),
            "{pairs}: {far_m}"
        );
    }
    let (x_m, kinetic_j, far_m) = turn("spring=bistable x_2=0.02 F_bar=1e3");
    // C x (x - 1 cm) (x - 2 cm), greatest at 1 cm (1 - 1/3^(1/2)).
    let top = 0.01 * (1.0 - 1.0 / 3f64.sqrt());
    let c = 1e3 / (top * (top - 0.01) * (top - 0.02));
    let energy_j = |x: f64| c * x * x * (0.25 * x * x - 0.01 * x + 1e-4);
    assert!(is_near(energy_j(far_m), energy_j(x_m) + kinetic_j, 1e-11), "{far_m}");
}

/// Springs whose exponents differ by nothing that matters are one, however steep.
#[test]
fn valid_two_steep_springs_in_parallel_are_one_of_the_sum() {
    for n in [0.15, 0.35, 0.6, 1.5] {
        let one = shot(&format!("k=1e6 n={n}"));
        let two = format!("k=5e5 n={n} combine=parallel k_2=5e5 n_2={}", n * (1.0 + 1e-15));
        let two = shot(&two);
        assert!(is_near(two.final_penetration_m.unwrap(), one.final_penetration_m.unwrap(), 1e-12));
        assert!(two.cost.steps < 2 * one.cost.steps, "{n}: {:?} {:?}", two.cost, one.cost);
    }
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
    assert!(is_near(rigid.final_penetration_m.unwrap(), 5e-3, 1e-12));
    assert!(is_near(rigid.first_arrest.unwrap().t_s, 1e-4, 1e-12));
}

/// A collision at once leaves 50 m/s to 59 g: w (M/k)^(1/2); there is neither depth nor force.
#[test]
fn valid_an_initial_velocity_has_no_contact() {
    let run = shot("gamma=1 k=1e5 model=initial-velocity");
    assert_eq!(
        (run.final_penetration_m, run.peak_contact_force_n, run.first_arrest),
        (None, None, None)
    );
    assert!(is_near(run.max_plate_displacement_m.unwrap(), 50.0 * (0.059f64 / 1e5).sqrt(), 1e-12));
}

/// On a rigid mount the lumped interface is pressed in by v (m/k)^(1/2), a quarter of which springs back at a stiffness of 4 k, with half
/// of the speed.
#[test]
fn valid_the_lumped_interface_throws_the_projectile_back() {
    let run = shot("mount=rigid dishing=off model=lumped k_load=1e7 k_unload=4e7");
    let pressed_m = 100.0 * (0.0295f64 / 1e7).sqrt();
    assert_eq!(run.outcome, Outcome::Separated);
    assert!(is_near(run.final_penetration_m.unwrap(), 0.75 * pressed_m, 1e-12));
    assert!(is_near(run.peak_contact_force_n.unwrap(), 1e7 * pressed_m, 1e-12));
    assert!(is_near(run.separation.unwrap().velocity_m_s, -50.0, 1e-12));
}

/// Fewer stages and a looser tolerance: nothing in common but the law.
#[test]
fn the_two_members_agree() {
    for pairs in ["k=1e5", "k=1e6 n=0.5", "k=1e6 n=0.2", "b=2000 k=1e5", "k=1e5 theta=30deg"] {
        let scene = Arc::new(scene_with(pairs));
        let nine = run_to_end(&scene, Stepping::Collocation(1e-12), Extent::BARE);
        let seven = run_to_end(&scene, Stepping::Second(1e-11), Extent::BARE);
        let depth = |run: &Run| run.final_penetration_m.unwrap();
        assert!(is_near(depth(&nine), depth(&seven), 1e-11), "{pairs}");
        assert!(nine.cost.steps < 300, "{pairs}: {:?}", nine.cost);
    }
}

/// What is used up before anything is decided is said, with what is known.
#[test]
fn a_run_that_is_cancelled_says_so() {
    let scene = Arc::new(scene_with("k=1e5"));
    let mut steps = 0;
    let run = run_by(&scene, Extent::BARE, Stepping::Collocation(1e-12), &mut |_| {
        steps += 1;
        if steps > 2 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    assert_eq!((run.end, run.outcome), (EndReason::Cancelled, Outcome::Moving));
    assert!(run.at_least.penetration_m.unwrap() > 0.0);
}

/// Methods of four families, one of them without events: each approaches the same run.
#[test]
fn valid_every_method_steps_to_the_same_end() {
    for pairs in ["k=1e5", "k=1e5 interface=plastic gamma=0.8 b=50", "h=0.003 v_i=400 k=1e5"] {
        let scene = Arc::new(scene_with(pairs));
        let end = |stepping: Stepping| {
            let run = run_to_end(&scene, stepping, Extent::BARE);
            assert!(run.end.is_complete(), "{pairs}: {stepping:?} {:?}", run.end);
            let time_s = run.first_arrest.map(|arrest| arrest.t_s).or(run.exit_time_s);
            [time_s, run.final_penetration_m, run.peak_contact_force_n].map(Option::unwrap)
        };
        let exact = end(Stepping::Collocation(1e-13));
        for (stepping, within) in [
            (Stepping::Radau5(1e-11), 1e-9),
            (Stepping::Dop853(1e-12), 1e-9),
            (Stepping::Rk4(2e-7), 1e-8),
            (Stepping::Rk4WithoutEvents(1e-7), 1e-2),
        ] {
            for (found, exact) in end(stepping).into_iter().zip(exact) {
                let off = (found / exact - 1.0).abs();
                assert!(off < within, "{pairs}: {stepping:?} {off:e}");
            }
        }
    }
}

/// Nothing but momentum passes between a free plate and its shot: `m_p v + m_2 w` at every row, both masses 29.5 g.
#[test]
fn valid_rows_at_equal_times_lie_on_the_motion() {
    let scene = Arc::new(scene_with("gamma=1 k=0"));
    let window = Window::with_steps(1e-6, 1_000);
    let extent = Extent { keep_series: true, window: Some(&window), ..Extent::BARE };
    let found = run_to_end(&scene, Stepping::Collocation(1e-12), extent);
    let rows = window.rows();
    let end_s = CONTACT_WINDOW * found.first_arrest.unwrap().t_s;
    assert!((rows.len() as f64 - 1.0 - (end_s / 1e-6).floor()).abs() < 0.5, "{}", rows.len());
    for (index, row) in rows.iter().enumerate() {
        assert!((row.t_s - index as f64 * 1e-6).abs() < 1e-18);
        let momentum = row.projectile_velocity_m_s + row.plate_velocity_m_s;
        assert!((momentum - 100.0).abs() < 1e-11, "{row:?}");
        let way_m = row.projectile_displacement_m + row.plate_displacement_m;
        assert!((way_m - 100.0 * row.t_s).abs() < 1e-15, "{row:?}");
    }
    assert!(found.series.len() > 8 * found.cost.steps, "{}", found.series.len());
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
        let results = |keep_series: bool| {
            let extent = Extent { keep_series, ..Extent::BARE };
            let found = run_to_end(&scene, Stepping::Collocation(1e-12), extent);
            assert_eq!(found.series.is_empty(), !keep_series);
            Run { series: Vec::new(), events: Vec::new(), omitted: Vec::new(), ..found }
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
        assert!(is_near(found.interface_tension_ratio.unwrap(), expected, 1e-8), "{b}");
    }
}

/// Work is summed by its own rule, energies are those of the end: together they are all there was.
#[test]
fn valid_the_energy_ledger_closes() {
    for pairs in [
        "k=1e5",
        "k=1e6 b=50 m=0.7",
        "k=1e5 x_stop=2mm stop_kind=elastic k_stop=1e7 b_stop=100",
        "k=1e5 x_stop=2mm e=0.5 interface=plastic",
        "d=0.1 k=1e6 theta=20deg",
        "h=3mm v_i=400 k=1e5",
    ] {
        let found = shot(pairs);
        assert!(found.ledger.residual().abs() < 1e-10, "{pairs}: {:e}", found.ledger.residual());
    }
}

/// Against a force F a damper lets the plate go (F/b)^(1/m) fast: on a plate that hardly moves, F is that on a rigid mount. What is off
/// because it is taken as linear near zero is within ten times the estimate.
#[test]
fn valid_a_plate_creeps_as_far_as_its_damper_lets_it() {
    let window = Window::with_steps(1e-7, 4_000);
    let extent = Extent { window: Some(&window), keep_series: true, ..Extent::BARE };
    let rigid = Arc::new(scene_with("mount=rigid"));
    let _ = run_to_end(&rigid, Stepping::Collocation(1e-12), extent);
    let rows = window.rows();
    for (b, m) in [(5e4, 0.1), (1e5, 0.1), (1.5e5, 0.1), (1e5, 0.05), (1e5, 0.2), (5e4, 0.3)] {
        let speed_m_s = |row: &Sample| (row.contact_force_n / b).powf(1.0 / m);
        let crept_m: f64 = rows.windows(2).map(|pair| 1e-7 * speed_m_s(&pair[0])).sum();
        let scene = Arc::new(scene_with(&format!("k=0 b={b} m={m}")));
        let run = simulate(&scene, &Settings::default(), &mut |_| ControlFlow::Continue(()));
        let run = run.unwrap();
        let found_m = run.first_arrest.unwrap().plate_displacement_m;
        let name = "first_arrest_plate_displacement_m";
        let estimate = run.error_estimates.iter().find(|error| error.name == name).unwrap();
        let off = (found_m - crept_m).abs() / found_m;
        assert!(off < 10.0 * estimate.relative + 1e-2, "{b} {m}: {off:e} {estimate:?}");
    }
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
