//! Decided and undecided results at the end of a run.

use cmra_engine::model::run::{AtLeast, ContactMode, EndReason, EventKind, Outcome, Run};
use cmra_studies::study::quantities::find;

use crate::random::Random;
use crate::support::{assert_near, run, scene};

/// Random plastic scenes, and their horizon in durations of the first contact.
const RANDOM_SCENES: usize = 50;
const PERIODS: f64 = 300.0;

fn run_of(pairs: &str) -> Run {
    run(scene(pairs))
}

/// An independent integration: 150.715 m/s.
#[test]
fn valid_a_tighter_tolerance_keeps_the_answer() {
    for tolerance in ["1e-9", "1e-11"] {
        let found =
            run_of(&format!("gamma=0.82 k=3.1e6 n=0.205 v_i=286.6 run.tolerance={tolerance}"));
        assert_eq!(found.outcome, Outcome::Perforated, "{tolerance}");
        assert!(
            (found.departure.residual_velocity_m_s.unwrap() - 150.715).abs() < 5e-4,
            "{tolerance}"
        );
    }
}

/// Bodies without a grip, held back by strong dampers: joined where they can part at a billionth of the impact velocity at most, parted where
/// they are a million times faster than the rounding of an energy stored far from zero makes them seem.
#[test]
fn bodies_without_a_grip_part_or_stay_whatever_the_tolerance() {
    for (pairs, outcome) in [
        (
            "n=4.39375 m=0.5 k=5.13956 b=0.587885 d=4.39599e-5 gamma=45.957 v_i=4.62009 h=7.72019e-4 theta=10.4238deg S_y=8.18066e8 \
             C_d=0.0134182",
            Outcome::Arrested,
        ),
        (
            "n=4.85783 m=0.304656 k=5.02852e4 b=1.35409e4 gamma=1.53013 v_i=1.17628e-2 h=7.68621e-5 theta=50.8729deg S_y=5.57242e7 \
             C_d=0.0257779",
            Outcome::Arrested,
        ),
        (
            "n=4.15034 m=3 k=8.80968e4 b=4.12141e6 d=0.160819 gamma=5.25319 v_i=1.01715e-2 h=5.2948e-2 theta=75.9064deg S_y=3.98194e5 \
             C_d=1.26277 x_stop=-0.160818727733 stop_kind=elastic k_stop=6.02329e11 b_stop=5.77696e4",
            Outcome::Separated,
        ),
    ] {
        for tolerance in ["1e-6", "1e-9", "1e-10", "1e-11", "1e-12"] {
            let found = run_of(&format!("{pairs} interface=plastic g=0 tol={tolerance}"));
            assert_eq!((found.outcome, found.end), (outcome, EndReason::Decided), "{tolerance}");
            let parts = found.events.iter().any(|it| it.kind == EventKind::Separation);
            assert_eq!(parts, outcome == Outcome::Separated, "{tolerance}");
        }
    }
}

/// Without a spring nothing brings back a plate that its elastic stop has thrown back with the projectile in it.
#[test]
fn a_free_plate_that_leaves_its_elastic_stop_with_the_projectile_is_decided() {
    let found = run_of("k=0 interface=plastic x_stop=0.005 stop_kind=elastic");
    assert_eq!((found.outcome, found.end), (Outcome::Arrested, EndReason::Decided));
    assert!(found.max_plate_displacement_m.unwrap() > 0.005);
    assert_eq!(found.at_least, AtLeast::default());
}

/// A plate that creeps to zero with b/k = 20 ms has the cocking distance as its stroke.
#[test]
fn valid_a_plate_that_creeps_back_against_its_damper_has_its_stroke() {
    let found = run_of("d=0.1 b=2000 k=1e5");
    assert_eq!((found.outcome, found.end), (Outcome::Arrested, EndReason::Decided));
    assert_near(found.stroke_m().unwrap(), 0.1, 1e-9);
}

/// On k x^n with n > 1 it comes ever more slowly, x' = -k x^n/b, and never to zero: that is as far as it goes.
#[test]
fn valid_a_plate_that_creeps_back_for_ever_goes_as_far_as_zero() {
    for law in ["fused", "plastic"] {
        let found = run_of(&format!("d=0.05 b=400 k=1e4 n=2.3 interface={law}"));
        assert_eq!((found.outcome, found.end), (Outcome::Arrested, EndReason::Decided));
        assert_eq!(found.max_plate_displacement_m, Some(0.0), "{law}");
    }
}

/// Friction holds the projectile more and more, half a millimetre from the bottom of its hole. Followed for much longer, the hole
/// gets no deeper and the plate goes no farther.
#[test]
fn valid_a_projectile_that_slips_in_its_hole_far_from_its_bottom_is_arrested() {
    let pairs = "interface=plastic gamma=5.730200106507319 k=7068377.128327877";
    let found = run_of(pairs);
    assert_eq!((found.outcome, found.end), (Outcome::Arrested, EndReason::Decided));
    let long = run_of(&format!("{pairs} run.horizon_s=0.3"));
    assert_eq!(found.penetration.final_m, long.penetration.final_m);
    assert_eq!(found.max_plate_displacement_m, long.max_plate_displacement_m);
}

/// Over the plane of mass ratio and stiffness each plastic scene has an end. A depth given as an interval holds what a longer run finds.
#[test]
fn valid_every_plastic_scene_of_a_surface_is_decided() {
    let mut intervals = 0;
    for (n, horizon) in [("1", "0.1"), ("0.5", "0.02")] {
        for (i, j) in (0..7).flat_map(|i| (0..7).map(move |j| (i, j))) {
            let (gamma, power) = (0.8 + 6.2 * f64::from(i) / 6.0, 4.0 + 0.5 * f64::from(j));
            let pairs = format!("interface=plastic n={n} gamma={gamma} k={}", 10f64.powf(power));
            let found = run_of(&pairs);
            assert_eq!(found.end, EndReason::Decided, "{pairs}");
            assert_ne!(found.outcome, Outcome::Moving, "{pairs}");
            let Some(most_m) = found.penetration.at_most_m else { continue };
            let least_m = found.penetration.final_m.unwrap();
            intervals += 1;
            let width = (most_m - least_m) / least_m;
            assert!(found.estimate.main.unwrap() >= width, "{pairs}");
            assert!(width < 2e-3, "{pairs}: {least_m} {most_m}");
            let long = run_of(&format!("{pairs} run.horizon_s={horizon}"));
            let long_m = long.penetration.final_m.or(long.at_least.penetration_m).unwrap();
            assert!(long_m <= most_m * (1.0 + 1e-9), "{pairs}: {long_m} {most_m}");
        }
    }
    assert!(intervals > 5, "{intervals}");
}

/// Slip of a joined projectile in its hole, m, inwards positive.
#[derive(Clone, Copy, Debug)]
struct Slip {
    length_m: f64,
    /// Part of it above the bottom of the hole; what is beyond deepens the hole.
    above_m: f64,
}

/// Returns the slips of a run with a series; the first goes all the way into the plate.
fn slips(run: &Run) -> Vec<Slip> {
    let (mut slips, mut from, mut before_m, mut bottom_m) = (Vec::new(), None, 0.0, 0.0);
    for row in &run.series {
        let now_m = row.penetration_m;
        match (row.mode == ContactMode::Fused, from) {
            (false, None) => from = Some((before_m, bottom_m)),
            (true, Some((start_m, bottom_m))) => {
                let above_m = f64::min(now_m, bottom_m) - start_m;
                slips.push(Slip { length_m: now_m - start_m, above_m });
                from = None;
            }
            _ => {}
        }
        (before_m, bottom_m) = (now_m, f64::max(bottom_m, now_m));
    }
    slips
}

/// The first slip into the plate and the next are not of the oscillation: the others are no longer above the bottom of the hole than the one
/// before, as far as they are resolved.
fn assert_slips_get_shorter(slips: &[Slip], pairs: &str) {
    for pair in slips.get(2..).unwrap_or_default().windows(2) {
        let (before_m, now_m) = (pair[0].length_m.abs(), pair[1].above_m.abs());
        assert!(now_m <= before_m || now_m < 1e-12, "{pairs}: {pair:?}");
    }
}

/// The interval of the depth rests on it: each slip goes back, and is no longer than the one before.
#[test]
fn slips_in_a_plastic_hole_get_shorter() {
    for pairs in [
        "gamma=1.93 k=4.33e5",
        "gamma=3.05 k=2.85e6",
        "gamma=5.31 k=1e7",
        "gamma=2.87 k=1e5 n=0.5",
        "gamma=5.97 k=1e7 n=0.5",
        "gamma=4.93 k=3.16e5 n=0.5",
        "gamma=4 k=2e5 n=0.4 b=1",
        "gamma=4 k=2e8 n=1.6",
    ] {
        let found = run_of(&format!("interface=plastic {pairs} run.horizon_s=0.05"));
        let slips = slips(&found);
        assert!(slips.len() > 32, "{pairs}: {}", slips.len());
        assert_slips_get_shorter(&slips, pairs);
        for pair in slips[2..].windows(2) {
            let is_resolved = pair[1].length_m.abs() > 1e-12;
            assert!(pair[0].length_m * pair[1].length_m < 0.0 || !is_resolved, "{pairs}: {pair:?}");
        }
    }
}

/// Random springs that push about as hard as the hole holds, dampers, grips, thicknesses and obliquities.
#[test]
fn slips_get_shorter_in_random_plastic_scenes_and_stay_within_the_interval() {
    let mut random = Random(77);
    let (mut slipping, mut intervals) = (0, 0);
    for _ in 0..RANDOM_SCENES {
        let n = random.log(0.25, 3.0);
        let k = random.log(2e3, 2e5) / random.log(1e-5, 1e-2).powf(n);
        let (gamma, v, h) = (random.log(0.5, 20.0), random.log(30.0, 400.0), random.log(0.01, 0.1));
        let (b, m) = (random.log_or_zero(0.7, 0.1, 100.0), random.of(&[0.5, 1.0, 2.0]));
        let (g, d) = (random.log(0.02, 1.5), random.log_or_zero(0.7, 1e-5, 1e-2));
        let theta = if random.unit() < 0.7 { 0.0 } else { 60.0 * random.unit() };
        let pairs = format!(
            "interface=plastic n={n} k={k:e} gamma={gamma} v_i={v} h={h} b={b} m={m} g={g} d={d} theta={theta}deg"
        );
        let decided = run_of(&pairs);
        let Some(arrest) = decided.first_arrest.filter(|_| decided.outcome == Outcome::Arrested)
        else {
            continue;
        };
        let horizon_s = f64::min(PERIODS * arrest.t_s, 0.05);
        let long = run_of(&format!("{pairs} run.horizon_s={horizon_s:e}"));
        let slips = slips(&long);
        assert_slips_get_shorter(&slips, &pairs);
        slipping += usize::from(slips.len() > 5);
        let Some(most_m) = decided.penetration.at_most_m else { continue };
        intervals += 1;
        let long_m = long.penetration.final_m.or(long.at_least.penetration_m).unwrap();
        assert!(long_m <= most_m * (1.0 + 1e-9), "{pairs}: {long_m} {most_m}");
    }
    assert!(slipping > RANDOM_SCENES / 5 && intervals > 0, "{slipping} {intervals}");
}

/// An undecided depth lies between the depth reached and the bound by the energy; a longer run confirms it.
#[test]
fn valid_an_undecided_depth_has_a_lower_and_an_upper_bound() {
    let pairs = "interface=plastic gamma=3 k=5e6 v_i=20";
    let short = run_of(&format!("{pairs} run.horizon_s=0.001"));
    assert_eq!(short.outcome, Outcome::Moving);
    assert!(short.penetration.final_m.is_none());
    let (least, most) =
        (short.at_least.penetration_m.unwrap(), short.penetration.at_most_m.unwrap());
    let long = run_of(&format!("{pairs} run.horizon_s=0.1"));
    let depth = long.penetration.final_m.or(long.at_least.penetration_m).unwrap();
    assert!(least < depth && depth < most, "{least} {depth} {most}");
    // So little energy is left that the plate has been at its farthest.
    assert!(short.max_plate_displacement_m.is_some());
    assert_eq!(short.max_plate_displacement_m, long.max_plate_displacement_m);
}

/// The nose is out of the back of the plate, and stays there.
#[test]
fn a_nose_beyond_the_rear_face_is_reported() {
    let found = run_of("h=0.012 v_i=170 mount=rigid");
    assert_eq!(found.outcome, Outcome::Arrested);
    let out = found.protrusion_m().unwrap();
    assert_near(out, found.penetration.final_m.unwrap() - 0.012, 1e-12);
    assert!(run_of("mount=rigid").protrusion_m().is_none());
}

/// A run ends by the motion that remains, however small its energy. On a damper of power 2 a plate moves like ln t and reaches any stop. A
/// tiny nose moves a heavy plate by `(S_y + c v²) V/v` over `(m_2 k)^(1/2)`, with V = 7/3 pi R³ for a plate as thin as R. An over-damped
/// dent creeps to the turning point of its own spring (in 40-digit arithmetic).
#[test]
fn valid_a_run_ends_by_what_is_still_to_come() {
    // Within a part of the exact value, and within its own estimate.
    let near = |run: &Run, key: &str, expected: f64, part: f64, of: &str| {
        let found = find(key).unwrap().value(run).unwrap_or(f64::NAN);
        let error = (found / expected - 1.0).abs();
        assert!(error < part, "{of}: {found} {expected}");
        let estimate = run.error_of(key).unwrap();
        assert!(error <= estimate, "{of}: {error:e} with an estimate of {estimate:e}");
    };
    let (far, deep) = ("max_plate_displacement_m", "final_penetration_m");
    for stop in ["", " stop_kind=elastic", " interface=plastic"] {
        let pairs = format!("k=0 b=2000 m=2 x_stop=5mm{stop}");
        near(&run_of(&pairs), far, 5e-3, 1e-12, &pairs);
    }
    // With m = 2.5 it comes to it at w, 1/w^(1/2) greater by b x/(2 M), and presses it by w (M/k)^(1/2).
    let pressed = "gamma=1 k=0 b=2000 m=2.5 x_stop=5mm stop_kind=elastic k_stop=1e6";
    let found = run_of(pressed);
    let arrest = found.first_arrest.unwrap();
    let way_m = 5e-3 - arrest.plate_displacement_m;
    let w_m_s = (arrest.plate_velocity_m_s.powf(-0.5) + 1000.0 * way_m / 0.059).powi(-2);
    let pressed_m = 5e-3 + w_m_s * (0.059f64 / 1e6).sqrt();
    assert_near(found.max_plate_displacement_m.unwrap(), pressed_m, 1e-9);
    let heavy = "R=10um h=10um m_p=100 v_i=300 gamma=1 k=1e5";
    let volume_m3 = 7.0 / 3.0 * std::f64::consts::PI * 1e-15;
    let impulse_n_s = (1.52e8 + 0.25 * 2710.0 * 9e4) * volume_m3 / 300.0;
    near(&run_of(heavy), far, impulse_n_s / 1e7f64.sqrt(), 1e-9, heavy);
    for (pairs, dent_m) in [
        ("k_load=1e4 b_2=1e5", 1.946_999_061_552_32e-5),
        ("k_load=1 b_2=1e7", 1.946_999_999_999_98e-7),
    ] {
        for tolerance in ["1e-9", "1e-12"] {
            let pairs = format!("model=lumped mount=rigid {pairs} tol={tolerance}");
            near(&run_of(&pairs), deep, dent_m, 1e-9, &pairs);
        }
    }
}

/// A shot too slow to feel more than the first slope of the area and a linear spring is the same at any velocity, but for its scale.
#[test]
fn valid_a_slow_shot_keeps_its_digits() {
    for more in ["", " interface=plastic"] {
        let [slow, slower] = ["1e-9", "1e-11"].map(|v| run_of(&format!("k=1e9 v_i={v}{more}")));
        assert_eq!(slow.outcome, slower.outcome, "{more}");
        assert_near(slower.first_arrest.unwrap().t_s, slow.first_arrest.unwrap().t_s, 1e-9);
        let values = |run: &Run| {
            [run.penetration.final_m, run.max_plate_displacement_m, run.peak_contact_force_n]
        };
        for (less, more) in values(&slower).into_iter().zip(values(&slow)) {
            assert_near(less.unwrap(), 1e-2 * more.unwrap(), 1e-9);
        }
        assert!(slower.ledger.residual().abs() < 1e-9, "{}", slower.ledger.residual());
    }
}
