//! An absorber that is crushed: closed forms of a constant force, and what it does not give back.

use cmra_engine::model::run::{Cost, Outcome, Run};

use crate::support::{assert_near, run, scene};

/// F, k and the rise F/k of the scenes below.
const FORCE_N: f64 = 5e3;
const STIFFNESS_N_M: f64 = 1e7;
const RISE_M: f64 = FORCE_N / STIFFNESS_N_M;

fn crushed(more: &str) -> Run {
    run(scene(&format!("spring=crush F_crush=5e3 k_crush=1e7 x_crush=0.1 gamma=1 {more}")))
}

/// Stroke = energy / force, and half the elastic rise.
#[test]
fn valid_the_stroke_is_the_energy_over_the_force() {
    for more in ["", "v_i=80", "gamma=3 v_i=150", "theta=30deg", "N_spring=2"] {
        let run = crushed(more);
        assert_eq!(run.outcome, Outcome::Arrested, "{more}");
        let force_n = FORCE_N * run.scene.mechanism.spring.count;
        let energy_j = run.ledger.initial_j() - run.ledger.penetration_j;
        // Oblique, the projectile keeps its velocity along the plate.
        let (mass, v) = (run.scene.projectile.mass_kg, run.scene.projectile.velocity_m_s);
        let along = v * run.scene.projectile.obliquity_deg.to_radians().sin();
        let energy_j = energy_j - 0.5 * mass * along * along;
        let stroke_m = run.max_plate_displacement_m.unwrap();
        if run.scene.projectile.obliquity_deg == 0.0 {
            assert_near(stroke_m, energy_j / force_n + 0.5 * RISE_M, 1e-9);
        }
        assert!(stroke_m > RISE_M && run.ledger.residual().abs() < 1e-11, "{more}");
    }
}

/// A weak absorber takes all of the common velocity's energy: 0.5 x 0.059 kg x (50 m/s)^2 = 73.75 J over 100 N are 738 mm.
#[test]
fn valid_a_weak_absorber_takes_the_energy_of_the_common_velocity() {
    let run = run(scene("spring=crush F_crush=100 k_crush=1e7 x_crush=1 gamma=1"));
    assert_near(run.max_plate_displacement_m.unwrap(), 73.75 / 100.0, 0.01);
}

/// An absorber returns the elastic energy F^2/(2 k); it dissipates the rest, F (x - F/k).
#[test]
fn valid_only_the_elastic_energy_comes_back() {
    let run = crushed("run.horizon_s=0.05");
    let ledger = run.ledger;
    let stroke_m = run.max_plate_displacement_m.unwrap();
    assert_near(ledger.crush_j, FORCE_N * (stroke_m - RISE_M), 1e-9);
    assert_near(ledger.plate_j + ledger.projectile_j, 0.5 * FORCE_N * RISE_M, 1e-8);
    assert!(ledger.spring_j.abs() < 1e-12 && ledger.residual().abs() < 1e-11, "{ledger:?}");
    let last = run.series.last().unwrap();
    assert!(last.plate_velocity_m_s < 0.0 && last.spring_force_n == 0.0);
}

/// Thrown forward again by a second spring, the absorber unloads and loads along one line and is crushed on from where it was.
#[test]
fn an_absorber_beside_a_spring_is_crushed_less_and_less() {
    let run = crushed("combine=parallel k_2=2e5 n_2=1 run.horizon_s=0.05");
    assert!(run.end.is_complete(), "{:?}", run.end);
    assert!(run.ledger.residual().abs() < 1e-10, "{:e}", run.ledger.residual());
    let stroke_m = run.max_plate_displacement_m.unwrap();
    assert_near(run.ledger.crush_j, FORCE_N * (stroke_m - RISE_M), 1e-8);
    let back = run.series.iter().filter(|row| row.plate_displacement_m < stroke_m - RISE_M);
    let after = back.filter(|row| row.plate_velocity_m_s < 0.0);
    // Behind its set there is the spring's force alone.
    for row in after {
        assert!((row.spring_force_n - 2e5 * row.plate_displacement_m).abs() < 1e-6, "{row:?}");
    }
}

#[test]
fn a_flat_absorber_is_solid_and_warned_about() {
    let run = crushed("x_crush=5mm");
    assert!(run.max_plate_displacement_m.unwrap() > 0.005);
    assert!(run.warnings.iter().any(|warning| warning.to_string().contains("crushed flat")));
    assert!(run.ledger.residual().abs() < 1e-11);
}

#[test]
fn a_stroke_that_is_shorter_than_the_rise_is_refused() {
    let (_, error) = crate::support::says(
        "run",
        &["--set", "spring=crush", "--set", "k_crush=1e3", "--set", "x_crush=1mm"],
        2,
    );
    assert!(error.contains("x_crush") && error.contains("raise x_crush or k_crush"), "{error}");
}

/// Scenes in which `F - k (F/k)` is not zero in floating point: depth in mm, greatest displacement in mm and common velocity in m/s of
/// an independent integrator.
#[test]
fn valid_the_rounding_of_the_elastic_rise_does_not_matter() {
    for (pairs, depth_mm, displacement_mm, common_m_s) in [
        ("F_crush=3e3 k_crush=5e6", 4.710_634, 23.593_17, None),
        ("F_crush=3e4 k_crush=1e8", 7.000_968, f64::NAN, Some(-0.534_04)),
        ("F_crush=15e3 k_crush=2e8 N_spring=3 v_i=50 h=10mm", f64::NAN, 21.60e-3, None),
    ] {
        let run = run(scene(&format!("spring=crush {pairs}")));
        let arrest = run.first_arrest.unwrap();
        for (found, expected, tolerance) in [
            (1e3 * arrest.penetration_m, depth_mm, 2e-7),
            (1e3 * run.max_plate_displacement_m.unwrap(), displacement_mm, 3e-4),
            (arrest.plate_velocity_m_s, common_m_s.unwrap_or(f64::NAN), 2e-5),
        ] {
            let is_near = (found / expected - 1.0).abs() < tolerance;
            assert!(is_near || expected.is_nan(), "{pairs}: {found} for {expected}");
        }
        let first: Vec<f64> =
            run.series.iter().take(40).map(|row| row.plate_displacement_m).collect();
        assert!(first.is_sorted(), "{pairs}: {first:?}");
    }
}

/// Behind the absorber nothing but the damper takes the momentum of 2.95 N s: a linear one over 2.95/b, a quadratic one never, so that the
/// plate comes to the absorber however late.
#[test]
fn valid_a_cocked_plate_coasts_towards_the_absorber() {
    for (changes, farthest_m) in [
        ("d=100mm b=100", -0.1 + 0.0295),
        ("d=100mm b=2000", -0.1 + 2.95 / 2000.0),
        ("d=20mm b=2000 m=2", 0.0),
        ("d=100mm b=50 m=2", 0.0),
        ("d=100mm b=200 x_stop=-50mm m=2 e=0", -0.05),
    ] {
        let run = crushed(changes);
        assert!(run.end.is_complete(), "{changes}: {:?}", run.end);
        let found_m = run.max_plate_displacement_m.unwrap();
        assert!((found_m - farthest_m).abs() < 1e-11, "{changes}: {found_m}");
    }
}

/// Thrown back off its stop, the plate leaves the absorber behind: the rounding of a force that ends is no pull, which would take the
/// projectile out of a hole without grip after 1e27 s.
#[test]
fn a_plate_thrown_back_from_its_absorber_takes_the_projectile_with_it() {
    let run = run(scene(
        "gamma=2.61 spring=crush d=0.104 x_stop=0.0108 stop_kind=elastic k_stop=1.51e7 b_stop=1e4 interface=plastic g=0 dishing=off \
         v_i=121",
    ));
    let depth_m = run.penetration.final_m.or(run.at_least.penetration_m).unwrap();
    // All the energy of the projectile in A S of the full nose, and the nose itself.
    let most_m = 0.00635 + 0.5 * 0.0295 * 121.0 * 121.0 / (1.2668e-4 * 1.52e8);
    assert!(depth_m > 0.009 && depth_m < most_m, "{depth_m}");
}

/// The absorber has no force behind x = 0, to which the plate creeps back while the shot is pulled out: rounding takes it across no more.
#[test]
fn a_plate_that_creeps_to_the_absorber_takes_few_evaluations() {
    let run = run(scene(
        "gamma=6.1382 h=0.11097 R=0.0020646 m_p=0.12883 theta=79.78deg b=5784.7 interface=plastic g=0 spring=crush",
    ));
    assert_eq!(run.outcome, Outcome::Separated);
    let Cost { steps, rhs_evaluations, .. } = run.cost;
    assert!(rhs_evaluations < 150 * steps, "{rhs_evaluations} in {steps} steps");
}
