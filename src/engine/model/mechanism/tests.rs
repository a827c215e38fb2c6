//! Every kind of spring against its own definition: force, tangent, energy, limits.

use super::*;
use crate::model::scene::{self, Combination, Spring as Parameters, SpringKind};
use crate::model::variables::scene_with;

/// The law of a spring alone.
fn law(spring: Parameters) -> Spring {
    Spring::new(&scene::Mechanism { spring, ..scene::Mechanism::default() }, 0.0)
}

/// A kind with its default values.
fn of_kind(kind: SpringKind) -> Parameters {
    Parameters { kind, ..Parameters::default() }
}

/// Every kind with its default values, and combinations of unlike ones.
fn springs() -> Vec<(&'static str, Spring)> {
    let of_word =
        |kind: SpringKind| (kind.word(), law(Parameters { exponent: 1.4, ..of_kind(kind) }));
    let mut list: Vec<_> = SpringKind::ALL.into_iter().map(of_word).collect();
    let mechanism = scene::Mechanism {
        spring: of_kind(SpringKind::Bistable),
        combination: Combination::Parallel,
        second: PowerLaw { coefficient: 1e7, exponent: 1.5 },
        ..scene::Mechanism::default()
    };
    list.push(("bistable and power law", Spring::new(&mechanism, 0.0)));
    list
}

#[test]
fn the_force_of_a_power_law_is_the_derivative_of_its_integral_and_its_tangent_that_of_the_force() {
    for exponent in [0.3, 0.5, 1.0, 1.4, 2.0, 3.0] {
        let law = PowerLaw { coefficient: 7.0, exponent };
        for z in [-0.8, -0.1, 0.2, 1.7] {
            let h = 1e-6;
            let force = (law.integral(z + h) - law.integral(z - h)) / (2.0 * h);
            let tangent = (law.force(z + h) - law.force(z - h)) / (2.0 * h);
            assert!((force - law.force(z)).abs() < 1e-6 * (1.0 + force.abs()));
            assert!((tangent - law.tangent(z)).abs() < 1e-5 * (1.0 + tangent.abs()));
            assert_eq!(law.force(-z).to_bits(), (-law.force(z)).to_bits());
        }
        assert!((law.force(law.at_force(3.0)) - 3.0).abs() < 1e-13);
        assert!((law.integral(law.at_integral(3.0)) - 3.0).abs() < 1e-13);
    }
}

#[test]
fn forces_are_slopes_of_energies_tangents_slopes_of_forces_and_both_are_continuous() {
    for (name, spring) in springs() {
        for i in -40..=40 {
            let x = 0.000_731 * f64::from(i) + 1.3e-5;
            let h = 1e-7;
            assert!(spring.energy(x) >= -1e-12, "{name} at {x}");
            let far = |knot: &f64| (knot - x).abs() > 2.0 * h;
            if !spring.knots_m().iter().all(far) {
                continue;
            }
            let force = (spring.energy(x + h) - spring.energy(x - h)) / (2.0 * h);
            let tangent = (spring.force(x + h) - spring.force(x - h)) / (2.0 * h);
            let size = 1e-6 * (10.0 + spring.energy(x) / h.sqrt());
            assert!((force - spring.force(x)).abs() < size, "{name} at {x}: {force}");
            let close = (tangent - spring.tangent(x)).abs() < 1e-4 * (1e3 + tangent.abs());
            assert!(close, "{name} at {x}: {tangent} is not {}", spring.tangent(x));
        }
        for (at, knot) in spring.knots_m().iter().enumerate() {
            let (below, above) = (spring.force_in(at, *knot), spring.force_in(at + 1, *knot));
            assert!((below - above).abs() < 1e-9 * (1.0 + below.abs()), "{name} at {knot}");
            // Also around a knot at zero.
            let near = 1e-15 * (1e-3 + knot.abs());
            let step = spring.energy(knot + near) - spring.energy(knot - near);
            let moved = 4.0 * (near * below).abs();
            assert!(step.abs() < 1e-9 + moved, "{name} at {knot}: {step}");
        }
    }
}

/// Closed form of the reach on a power law: `((n + 1) E/k)^(1/(n + 1))`, down to energies whose reach a bisection of the position does not
/// find. A plate on its stop would be followed for 8,000 steps with a rounded one.
#[test]
fn valid_a_steep_spring_beside_a_stop_reaches_as_far_as_alone() {
    let (k, n) = (4.68e6, 0.16);
    let spring = law(Parameters { coefficient: k, exponent: n, ..of_kind(SpringKind::PowerLaw) });
    let spring = spring.beside_stop(1e-3, 1e9);
    for energy in [1e-90, 1e-60, 1e-30, 1e-9, 1.0] {
        let expected = ((n + 1.0) * energy / k).powf(1.0 / (n + 1.0));
        for direction in [1.0, -1.0] {
            let found = spring.reach(0.0, energy, direction);
            assert!((direction * found / expected - 1.0).abs() < 1e-12, "{energy:e}: {found:e}");
        }
    }
}

#[test]
fn a_plate_goes_as_far_as_its_energy() {
    for (name, spring) in springs() {
        for x in [-0.003, 0.0, 0.004] {
            let energy = spring.energy(x) + 5.0;
            let (back, far) = (spring.reach(x, energy, -1.0), spring.reach(x, energy, 1.0));
            // An absorber only pushes: nothing holds the plate on its way back.
            let only_pushes = name == "crush";
            assert_eq!(back.is_infinite(), only_pushes, "{name} from {x}: {back}");
            let back = if only_pushes { x - 0.01 } else { back };
            for end in if only_pushes { [far, far] } else { [back, far] } {
                assert!(
                    (spring.energy(end) / energy - 1.0).abs() < 1e-12,
                    "{name} from {x}: {end}"
                );
            }
            assert!(back < x && x < far, "{name}: {back} {far}");
            // Nothing on the way is higher.
            for i in 1..200 {
                let at = back + (far - back) * f64::from(i) / 200.0;
                assert!(spring.energy(at) <= energy * (1.0 + 1e-12), "{name} at {at}");
            }
        }
    }
}

/// Points on a line are one stretch whatever their rounding, alone or among others.
#[test]
fn a_straight_stretch_of_a_table_is_one_piece() {
    let table = |points: Vec<[f64; 2]>| {
        let mut spring = of_kind(SpringKind::Table);
        spring.table.points = points.into();
        law(spring)
    };
    let row = |i: i32| [1e-4 * f64::from(i), 10.0 * f64::from(i)];
    let straight = table((-1000..1000).map(row).collect());
    assert_eq!(straight.knots_m(), []);
    assert!((straight.force(0.03) - 3e3).abs() < 1e-9);
    assert_eq!(table((0..1000).map(row).collect()).knots_m(), []);
    // Level from 0.5 mm on: the curve leaves the line at the point before, and is level from the bend on.
    let bent = |i: i32| [1e-4 * f64::from(i), 10.0 * f64::from(i.min(5))];
    let knots_m = table((0..10).map(bent).collect()).knots_m().to_vec();
    assert_eq!(knots_m, [-5e-4, -4e-4, 4e-4, 5e-4]);
}

#[test]
fn a_bistable_plate_does_not_pass_its_barrier_without_the_energy() {
    let parameters = of_kind(SpringKind::Bistable);
    let barrier_n = parameters.bistable.barrier_n;
    let spring = law(parameters);
    let barrier = spring.energy(0.01) - spring.energy(0.0);
    assert!(spring.reach(0.0, spring.energy(0.0) + 0.99 * barrier, 1.0) < 0.01);
    assert!(spring.reach(0.0, spring.energy(0.0) + 1.01 * barrier, 1.0) > 0.02);
    // The greatest force on the way out is the barrier's, and both wells are equally deep.
    let most = (1..1000).map(|i| spring.force(1e-5 * f64::from(i))).fold(0.0, f64::max);
    assert!((most / barrier_n - 1.0).abs() < 1e-5, "{most}");
    assert!(spring.energy(0.0).abs() < 1e-12 && spring.energy(0.02).abs() < 1e-12);
    assert!(spring.force(0.0).abs() < 1e-12 && spring.force(0.02).abs() < 1e-9);
}

/// Titanium of 4430 kg/m³ in Table 9.3's beam, of which 33/140 moves with the end; and 12 E I/l³ for each of two guided ones, of which
/// the pseudo-rigid body is 4 % stiffer.
#[test]
fn valid_beams_are_as_heavy_and_as_stiff_as_their_material_and_beam_theory_have_them() {
    let spring = of_kind(SpringKind::Cantilever);
    let mass_kg = spring.law().mass_kg(&spring, None).unwrap();
    let moving_kg = spring.moving_part() * mass_kg;
    assert!((mass_kg - 0.598).abs() < 1e-3 && (moving_kg - 0.141).abs() < 1e-3);
    let spring = Parameters { count: 2.0, ..of_kind(SpringKind::FixedGuided) };
    let beam = &spring.beam;
    let inertia = beam.width_m * beam.height_m.powi(3) / 12.0;
    let theory = 2.0 * 12.0 * beam.modulus_pa * inertia / beam.length_m.powi(3);
    let stiffness = law(spring).tangent(0.0);
    assert!((stiffness / theory - 4.0 * 2.65 / 0.85 / 12.0).abs() < 1e-12, "{stiffness}");
}

/// Cocked, and joined with a third of the spring after the impact.
#[test]
fn valid_a_coil_spring_weighs_5_08_g_a_joule() {
    for pairs in ["", "d=0.01", "d=0.5", "theta=30deg gamma=7", "k=1e3 v_i=1"] {
        let scene = scene_with(&format!("own_mass=counted {pairs}"));
        let (shot, d) = (scene.projectile, scene.plate.cocking_m);
        let cos = scene.cos_obliquity();
        let inertia = Inertia::from_scene(&scene);
        let mass = inertia.spring_mass_kg.unwrap();
        assert!((inertia.added_kg / (mass / 3.0) - 1.0).abs() < 1e-12);
        let bodies = shot.mass_kg * cos * cos + scene.plate_mass_kg() + inertia.added_kg;
        let common = shot.mass_kg * shot.velocity_m_s * cos / bodies;
        let energy =
            0.5 * scene.mechanism.spring.coefficient * d * d + 0.5 * bodies * common * common;
        assert!((mass / (energy * 5.081_673_469e-3) - 1.0).abs() < 1e-6, "{pairs}: {mass}");
    }
}

/// 147.5/2 J need 374.8 g of wire, of which the 1 g of the first spring is a part; what is known is a lower bound too, and an absent
/// spring is none.
#[test]
fn a_known_mass_of_one_spring_hides_no_other() {
    for (pairs, mass_kg) in
        [("k=1e4 m_spring=1g", 0.3748), ("k=1e4 m_spring=1kg", 1.0), ("k=0 m_spring=1g", 0.3748)]
    {
        let scene = scene_with(&format!("combine=parallel k_2=1e6 {pairs}"));
        let own = Inertia::from_scene(&scene);
        assert_eq!((own.spring_mass_kg, own.spring_kg(Some(0.3748))), (None, Some(mass_kg)));
        let (omitted_kg, is_least) = own.omitted_kg(scene.mechanism.min_spring_kg(Some(73.75)));
        assert_eq!(is_least, mass_kg < 1.0, "{pairs}");
        assert!((omitted_kg - mass_kg).abs() < 5e-5, "{pairs}: {omitted_kg}");
    }
}

/// With 500 J/kg the spring m stores what is left of 2.95 kg m/s: 500 m = 2.95²/2/(0.059 + m/3). No spring and no mass weigh nothing.
#[test]
fn a_counted_mass_follows_from_the_specific_energy_that_is_given() {
    let scene = |pairs: &str| scene_with(&format!("own_mass=counted {pairs}"));
    for kind in ["power-law", "column", "constant"] {
        let mass =
            Inertia::from_scene(&scene(&format!("e_spring=500 spring={kind}"))).spring_mass_kg;
        let mass = mass.unwrap();
        assert!((500.0 * mass * (0.059 + mass / 3.0) - 4.351_25).abs() < 1e-9, "{kind}: {mass}");
    }
    for kind in ["column", "constant"] {
        let own = Inertia::from_scene(&scene(&format!("spring={kind}")));
        assert_eq!((own.added_kg, own.spring_mass_kg, own.is_uncounted), (0.0, None, true));
    }
    // 5 kN over 0.1 m at 500 J/kg.
    let crush = "e_spring=500 spring=crush F_crush=5e3 k_crush=1e7 x_crush=0.1";
    assert!((Inertia::from_scene(&scene(crush)).spring_mass_kg.unwrap() - 1.0).abs() < 1e-12);
    assert_eq!(Inertia::from_scene(&scene("k=0")), Inertia::default());
}

/// The wire of a coil takes up 196.8 J/kg; of aluminium honeycomb 19460 J/kg are known, of a crush force alone nothing.
#[test]
fn only_coils_have_a_least_mass_without_a_specific_energy() {
    let least_g = |pairs: &str| {
        let mechanism = scene_with(pairs).mechanism;
        assert_eq!(mechanism.min_spring_kg(Some(0.0)), Some(0.0), "{pairs}");
        mechanism.min_spring_kg(Some(73.65)).map(|kg| (1e4 * kg).round() / 10.0)
    };
    assert_eq!(least_g(""), Some(374.3));
    assert_eq!(least_g("spring=normalised"), Some(374.3));
    assert_eq!(least_g("spring=crush"), None);
    assert_eq!(least_g("combine=parallel spring=crush"), None);
    assert_eq!(least_g("spring=crush e_spring=19460"), Some(3.8));
}

/// Beyond its points, 0, 1 mm and 1.1 mm, the table continues along its tangent, three times the last secant of -10 N/m. Both bodies at
/// 72.5 m/s spend their energy on it before its zero at 3.3 m, 3000 times the table's width; a cubic's energy is the trapezoid's and a
/// twelfth of the squared width times the difference of the slopes.
#[test]
fn valid_a_straight_end_of_a_table_turns_the_plate_before_its_zero_far_out() {
    let mut scene = scene_with("gamma=1 spring=table model=initial-velocity v_i=145");
    let points = [[0.0, 0.0], [1e-3, 100.0], [1.1e-3, 99.999]];
    scene.mechanism.spring.table.points = std::sync::Arc::from(points);
    let (end_n, secant): (f64, f64) = (99.999, -0.001 / 1e-4);
    let (slope, first) = (3.0 * secant, 1e5 + 1e-3 * (1e5 - secant) / 1.1e-3);
    let points_j =
        0.5e-3 * 100.0 + 1e-6 / 12.0 * first + 0.5e-4 * (100.0 + end_n) - 1e-8 / 12.0 * slope;
    let left_j = 0.5 * 0.059 * 72.5 * 72.5 - points_j;
    let way_m = (end_n - (end_n * end_n + 2.0 * slope * left_j).sqrt()) / -slope;
    let run = crate::model::simulate::bare_run(&scene);
    let far_m = run.max_plate_displacement_m.unwrap();
    assert!((far_m / (1.1e-3 + way_m) - 1.0).abs() < 1e-9, "{far_m} {way_m}");
    // A little faster it passes the zero, and nothing stops it.
    scene.projectile.velocity_m_s = 155.0;
    assert_eq!(crate::model::simulate::bare_run(&scene).max_plate_displacement_m, None);
}
