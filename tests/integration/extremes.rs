//! Extremes that a run reports: located, the same with and without a series, and never below the run's own rows.

use std::ops::ControlFlow;
use std::sync::Arc;

use cmra_engine::model::contact_kernel::Contact;
use cmra_engine::model::run::{ContactMode, EndReason, EventKind, Run, RunWarning, Sample};
use cmra_engine::model::scene::{PlateSize, Scene};
use cmra_engine::model::simulate::{Settings, simulate};

use crate::random::{Random, scene as random_scene, typed};
use crate::support::{assert_near, run, scene};

fn without_series(scene: &Scene) -> Run {
    simulate(&Arc::new(scene.clone()), &Settings::BARE, &mut |_| ControlFlow::Continue(())).unwrap()
}

/// The greatest contact force among the rows in which the hole deepens, N.
fn greatest_of_rows(run: &Run) -> f64 {
    let rows = run.series.iter().filter(|row| row.mode == ContactMode::Penetrating);
    rows.map(|row| row.contact_force_n).fold(0.0, f64::max)
}

/// The engaged area of a nose of radius `r` that has passed a face by the depth `p` at obliquity `theta`, m², by counting strips
/// of its disk: each is behind the face where its surface lies beyond the face's height over the sphere's centre.
fn area_m2(r: f64, theta: f64, p: f64) -> f64 {
    let (sin, cos) = theta.sin_cos();
    let strips = 20_000;
    let height = r - p * cos;
    let mut area = 0.0;
    for strip in 0..strips {
        let eta = r * (2.0 * (f64::from(strip) + 0.5) / f64::from(strips) - 1.0);
        let half = (r * r - eta * eta).sqrt();
        // On the strip xi sin + sqrt(half² - xi²) cos > height holds between the two roots, or up to the rim.
        let root = half * half - height * height;
        let length = if root <= 0.0 {
            if height < 0.0 { 2.0 * half } else { 0.0 }
        } else {
            let (middle, reach) = (height * sin, cos * root.sqrt());
            let (low, high) = (middle - reach, middle + reach);
            let beyond = if height <= half * sin { half } else { high.min(half) };
            let low = if height < -half * sin { -half } else { low.max(-half) };
            (beyond - low).max(0.0)
        };
        area += length * 2.0 * r / f64::from(strips);
    }
    area
}

/// An oblique foil: the force is `A(p) - A(p - h_e)` times the pressure, and no row of the closed form is near its peak. The speed
/// hardly changes (200 to 199.8 m/s), so that the peak is that of the area to a few parts in a thousand.
#[test]
fn valid_the_peak_on_an_oblique_foil_is_that_of_the_engaged_area() {
    let own = scene("k=0 h=0.00001 theta=75deg v_i=200");
    let theta = 75f64.to_radians();
    let (r, h_e) = (0.00635, 1e-5 / theta.cos());
    let pressure = 1.52e8 + 0.25 * 2710.0 * 200f64.powi(2);
    let depths = (1..2_000).map(|part| 2.0 * r / theta.cos() * f64::from(part) / 2_000.0);
    let areas = depths.map(|p| area_m2(r, theta, p) - area_m2(r, theta, p - h_e));
    let exact = pressure * areas.fold(0.0, f64::max);
    let peak = run(own).peak_contact_force_n.unwrap();
    assert_near(peak, exact, 3e-3);
    // By an independent 80-bit computation.
    assert_near(peak, 23.974, 1e-4);
}

/// Whatever steps: with a series, and without, to rounding the same, and no row above it by more than the tolerance.
#[test]
fn the_peak_force_bounds_the_rows_and_does_not_depend_on_them() {
    let mut random = Random(0x5eed_0015);
    let mut told = Vec::new();
    for _ in 0..150 {
        let mut changes = random.changes();
        let last = changes.len() - 1;
        changes[last].1 = random.of(&[1e-4, 1e-6, 1e-9]);
        let own = random_scene(&changes);
        let mut steps = 0;
        let found = simulate(&own, &Settings::SERIES, &mut |_| {
            steps += 1;
            if steps > 20_000 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        })
        .unwrap();
        if found.end == EndReason::Cancelled {
            continue;
        }
        let peak = found.peak_contact_force_n.unwrap();
        if greatest_of_rows(&found) > peak * (1.0 + 1e-12 + own.run.tolerance) {
            told.push(format!("rows: {}", typed(&changes)));
        }
        let alone = without_series(&own).peak_contact_force_n.unwrap();
        if (alone / peak - 1.0).abs() > 1e-13 {
            told.push(format!("{alone}, not {peak}: {}", typed(&changes)));
        }
    }
    assert!(told.is_empty(), "{}", told.join("\n"));
}

/// The force into the mount is located within the steps: no row is above it, by any step, with a stop, a damper and both.
#[test]
fn the_force_into_the_mount_bounds_the_rows_and_does_not_depend_on_them() {
    let mount_n = |row: &Sample| (row.spring_force_n + row.damper_force_n + row.stop_force_n).abs();
    let mut random = Random(0x5eed_0016);
    let mut judged = 0;
    for index in 0..120 {
        let mut own = Scene::clone(&random_scene(&random.changes()));
        own.run.tolerance = [1e-4, 1e-6, 1e-9][index % 3];
        own.mechanism.damper.coefficient += 10.0;
        if index % 2 == 0 {
            own.mechanism.stop.position_m = Some(1e-3);
            own.mechanism.stop.kind = cmra_engine::model::scene::StopKind::Elastic;
        }
        // A plate that moves at first contact has its greatest force there, or on its way back.
        if index % 5 < 2 {
            let factor = if index % 5 == 0 { -0.8 } else { 0.15 };
            own.plate.velocity_m_s = factor * own.projectile.velocity_m_s;
        }
        let found = run(own.clone());
        if !found.end.is_complete() {
            continue;
        }
        judged += 1;
        let (peak, rows) = (
            found.mechanism.peak_mount_n.unwrap(),
            found.series.iter().map(mount_n).fold(0.0, f64::max),
        );
        assert!(rows <= peak * (1.0 + 1e-12 + own.run.tolerance), "{index}: {rows} {peak}");
        // A run that keeps its rows may go on for longer.
        let alone = without_series(&own).mechanism.peak_mount_n.unwrap();
        assert!(alone <= peak * (1.0 + 1e-13), "{index}: {alone} {peak}");
    }
    assert!(judged > 100, "{judged}");
}

/// A damper that alone meets a plate thrown by its impact: the force is greatest at the arrest, b times the common velocity there, and
/// rows at the steps only would do no better; in the middle of the contact it is b w at w's greatest.
#[test]
fn valid_the_damper_force_into_the_mount_is_b_times_the_greatest_velocity() {
    let own = scene("k=0 b=200 m=1 gamma=1");
    let found = without_series(&own);
    let arrest = found.first_arrest.unwrap();
    // The plate is only ever slowed after the arrest, and driven before it.
    assert_near(found.mechanism.peak_mount_n.unwrap(), 200.0 * arrest.plate_velocity_m_s, 1e-9);
}

/// A loose tolerance makes long steps: the peak is located within them, on the state, not on the force's own series.
#[test]
fn the_peak_force_of_oblique_shots_follows_the_tolerance() {
    for theta in [40.0f64, 50.0, 60.0] {
        let of = |tolerance: f64| {
            let pairs = format!("theta={theta}deg run.tolerance={tolerance:e}");
            without_series(&scene(&pairs)).peak_contact_force_n.unwrap()
        };
        assert_near(of(1e-4), of(1e-12), 1e-5);
        assert_near(of(1e-9), of(1e-12), 1e-9);
    }
}

/// The plate has turned before the first arrest, and oscillates forward again, undamped: what the interface then carries is
/// `m_p/(m_p + m_2 ...) k x` over `A S_y` at the x at which its energy is all in the spring. An independent run gave 0.790.
#[test]
fn valid_the_interface_demand_is_that_of_the_swing_to_come() {
    let own = scene("m=0.39 gamma=0.43 theta=59deg S_y=2.04e7");
    for found in [run(own.clone()), without_series(&own)] {
        let arrest = found.first_arrest.unwrap();
        assert!(arrest.plate_velocity_m_s < 0.0);
        let (m_p, cos) = (0.0295, own.cos_obliquity());
        let joined = 0.43 * m_p + m_p * cos * cos;
        let (x, w) = (arrest.plate_displacement_m, arrest.plate_velocity_m_s);
        let farthest = (x * x + joined * w * w / 1e5).sqrt();
        // The whole disk is engaged: the hole is deeper than the nose and the plate thicker than the hole.
        let rows = found.series.iter().filter(|row| row.mode == ContactMode::Fused);
        assert!(rows.clone().count() > 2 || found.series.is_empty());
        let geometry = cmra_engine::model::contact::Geometry::from_scene(&own);
        let area = geometry.area_m2(geometry.travel_m(arrest.penetration_m));
        let exact = m_p * cos / joined * 1e5 * farthest / (area * 2.04e7);
        assert_near(found.interface.demand_ratio.unwrap(), exact, 1e-9);
    }
}

/// A cocked plate pulls on its interface by more than `g A S_y` from the first arrest on. The joined bodies then swing as a sine,
/// `r^2 = k/(m_p + m_2)`: forwards the interface carries `k x/2`, up to more than `A S_y`. A negligible damper makes it a motion by steps.
#[test]
fn valid_the_interface_is_overloaded_when_the_swing_passes_its_strength() {
    for damper in ["", " b=1e-9"] {
        let own = scene(&format!("d=0.1 k=1e6{damper}"));
        let found = run(own.clone());
        let arrest = found.first_arrest.unwrap();
        let geometry = cmra_engine::model::contact::Geometry::from_scene(&own);
        let limit_n = geometry.area_m2(geometry.travel_m(arrest.penetration_m)) * 1.52e8;
        let swing_s = (0.059f64 / 1e6).sqrt();
        let (x, lag) = (arrest.plate_displacement_m, arrest.plate_velocity_m_s * swing_s);
        let phase = (2.0 * limit_n / 1e6 / x.hypot(lag)).asin() - x.atan2(lag);
        let events = found.events.iter().filter(|event| event.kind == EventKind::InterfaceExceeded);
        let times_s: Vec<f64> = events.map(|event| event.t_s).collect();
        assert_eq!(times_s.len(), 2, "{damper}");
        assert_near(times_s[0], arrest.t_s, 1e-12);
        assert_near(times_s[1], arrest.t_s + phase * swing_s, 1e-9);
    }
}

/// A cocked plate is struck while its spring still pulls: at the first arrest the joined interface carries the tension
/// `m_p/(m_p + m_2) k |x|`, over `g A S_y`, and on the way back that of the x at which all energy is in the spring; without a grip it
/// carries none.
#[test]
fn valid_the_interface_tension_is_that_of_the_swing_back() {
    let own = scene("d=0.1 k=1e6");
    let found = run(own.clone());
    let arrest = found.first_arrest.unwrap();
    assert!(arrest.plate_displacement_m < 0.0);
    let geometry = cmra_engine::model::contact::Geometry::from_scene(&own);
    let area = geometry.area_m2(geometry.travel_m(arrest.penetration_m));
    let back_m =
        arrest.plate_displacement_m.hypot(arrest.plate_velocity_m_s * 0.059f64.sqrt() / 1e3);
    let exact = 0.5 * 1e6 * back_m / (0.1 * area * 1.52e8);
    assert!(exact > 1.0, "{exact}");
    assert_near(found.interface.tension_ratio.unwrap(), exact, 1e-9);
    let exact = cmra_engine::model::units::significant(exact, 4);
    let text = format!("interface pull is {exact} times its strength g A S_y");
    assert!(found.warnings.iter().any(|warning| warning.to_string().contains(&text)));
    let gripless = run(scene("d=0.1 k=1e6 grip=0"));
    assert!(gripless.interface.tension_ratio.unwrap().is_infinite());
    assert_eq!(run(scene("d=0.1 k=1e6 interface=plastic")).interface.tension_ratio, None);
    assert_eq!(run(scene("mount=rigid")).interface.tension_ratio, None);
}

/// A plate that oscillates ever faster about the zero of a singular spring: the horizon is not reached, and that is reported.
#[test]
fn a_horizon_that_is_not_reached_is_reported_and_the_series_is_bounded() {
    let mut own = scene("n=0.2 k=7.5e6 S_y=2.1e9 run.horizon_s=0.1");
    own.title = String::new();
    let mut steps = 0;
    let found = simulate(&Arc::new(own), &Settings::SERIES, &mut |_| {
        steps += 1;
        if steps > 200_000 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    })
    .unwrap();
    assert!(!found.end.is_complete(), "{:?}", found.end);
    let last = found.series.last().unwrap().t_s;
    let told = found.warnings.iter().any(|warning| {
        matches!(warning, RunWarning::HorizonNotReached { t_s, horizon_s, .. }
            if *t_s >= last * (1.0 - 1e-9) && *horizon_s > 0.09)
    });
    assert!(told, "{:?}", found.warnings);
    // The budget of work, and the points within the first steps.
    assert!(found.series.len() < 420_000, "{} rows", found.series.len());
    let ordered = |rows: &[Sample]| rows.windows(2).all(|pair| pair[0].t_s <= pair[1].t_s);
    assert!(ordered(&found.series));
}

/// The lumped model on stops of either kind: what the stop takes is what the bodies lose. A plate on an undamped spring comes to
/// its rigid stop again and again with no speed left.
#[test]
fn the_lumped_model_books_the_energy_of_its_stop() {
    for pairs in [
        "k=54712 gamma=0.97143 v_i=132.76 x_stop=0.00028285 e=0.17752848754688444",
        "k=13935 gamma=4.4696 v_i=22.712 x_stop=0.0005437 e=0",
        "k=2071.3 gamma=8.8957 v_i=46.616 x_stop=0.0063656 e=0.16240682310291843 d=0.00012252",
        "k=33151 gamma=0.2954 v_i=13.158 x_stop=0.00030245 e=0",
        "k=2164.1 gamma=0.26586 v_i=19.427 x_stop=0.0018311 e=0 d=0.0084915",
    ] {
        let found = run(scene(&format!("model=lumped b=0 {pairs}")));
        let residual = found.ledger.residual();
        assert!(residual.abs() < 1e-9, "{pairs}: {residual:e}");
    }
    // With a damper that acts at once the plate touches its stop ever more lightly: what is left is what such touches are worth.
    let pairs = "k=2876.9 gamma=0.10275 v_i=39.949 x_stop=0.0019604 stop_kind=elastic k_stop=140960000 b_stop=957.05";
    let found = run(scene(&format!("model=lumped b=0 {pairs}")));
    assert!(found.ledger.residual().abs() < 2e-6, "{:e}", found.ledger.residual());
}

/// A strong damper slows the plate, so that the depth is slightly below the closed form of a rigid mount at any tolerance.
#[test]
fn a_plate_that_creeps_is_decided_at_loose_tolerances_too() {
    for pairs in [
        "gamma=3.025 v_i=45.71 k=3415 n=0.638 b=1.698e4 m=0.2352",
        "gamma=6.933 v_i=62.19 k=1.067e6 n=0.6811 b=2.552e4 m=0.1122",
        "gamma=0.8739 v_i=111.7 k=2.296e4 n=0.1677 b=4.644e4 m=0.1447",
        "gamma=0.3636 v_i=13.89 k=5.911e4 n=0.3799 b=2183 m=0.1893",
    ] {
        let depths_m = [1e-3, 1e-4, 1e-5, 1e-9].map(|tolerance| {
            let found = without_series(&scene(&format!("{pairs} tol={tolerance:e}")));
            assert_eq!(found.end, EndReason::Decided, "{pairs} {tolerance:e}");
            let part = found.percent_of_baseline().unwrap();
            assert!(part > 90.0 && part < 100.0, "{pairs} {tolerance:e}: {part}");
            found.penetration.final_m.unwrap()
        });
        for (depth_m, tolerance) in depths_m.into_iter().zip([1e-3, 1e-4, 1e-5]) {
            assert_near(depth_m, depths_m[3], 10.0 * tolerance);
        }
    }
}

/// The contact kernel of sweeps and the simulation take other steps: they agree within the scene's tolerance.
#[test]
fn a_sweep_and_a_run_agree_within_the_tolerance() {
    let mut random = Random(4_711);
    for tolerance in [1e-6, 1e-9] {
        for _ in 0..100 {
            let mut own = Scene::default();
            own.plate.size = PlateSize::Ratio(0.8 + 6.2 * random.unit());
            own.mechanism.spring.coefficient = 7.5e6 * random.unit();
            own.mechanism.spring.exponent = 0.5 + 1.5 * random.unit();
            own.mechanism.damper.coefficient = random.log_or_zero(0.5, 1.0, 2e3);
            own.run.tolerance = tolerance;
            let end = Contact::from_scene(&own).unwrap().run(0.3 * tolerance);
            let (Some(end), Some(arrest)) = (end, without_series(&own).first_arrest) else {
                continue;
            };
            assert!(end.arrested);
            assert_near(end.penetration_m, arrest.penetration_m, tolerance);
            assert_near(end.t_s, arrest.t_s, tolerance);
        }
    }
}
