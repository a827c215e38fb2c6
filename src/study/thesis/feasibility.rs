//! Claims of sections 9.5 and 9.6: what can be built, stops, and the advice to designers.

use crate::model::design::beam::Cantilever;
use crate::model::design::coil_spring_mass_kg;
use crate::model::mechanism::PowerLaw;
use crate::model::scene::{InterfaceLaw, Scene};
use crate::study::principles::PRINCIPLES;
use crate::study::screening::CONCEPTS;
use crate::study::thesis::lab::Measure::Percent;
use crate::study::thesis::lab::{
    LAWS, Law, both, changed, found, misprint_verdict, mm, near, number, number_verdict, pc, read,
    spelled, trend_verdict, unit, with,
};
use crate::study::thesis::numbering::{SYMBOLS, has_table};
use crate::study::thesis::shape::{at, falls, rises};
use crate::study::thesis::{Claim, Opens, Verdict};

/// Spring steel: density, shear modulus, and a shear stress it may bear.
const STEEL: (f64, f64, f64) = (7850.0, 79.3e9, 700e6);

/// A rigid stop met right after the first arrest, under the plastic law.
fn stopped() -> Scene {
    let mut scene = with(&[("k", 0.0), ("x_stop", 0.01)]);
    scene.interface.law = InterfaceLaw::Plastic;
    scene
}

/// A spring told by its force at a length.
fn normalised() -> Scene {
    changed(spelled(&[("spring", "normalised")]), &[("F_ref", 1e4), ("x_ref", 1e-3)])
}

fn stopped_heavy() -> Scene {
    let mut scene = stopped();
    scene.plate.mass_ratio = 3.0;
    scene
}

/// What the cantilever of Table 9.3 can do at its yield.
fn cantilever() -> Scene {
    with(&[("k", 0.111e6), ("d", 0.03)])
}

/// The least mass of a coil spring over the projectile's, for a spring that takes the swing after arrest.
fn coil_ratio(k: f64, d: f64) -> f64 {
    let after = 0.5 * 0.059 * 50.0 * 50.0;
    let drawn = PowerLaw { coefficient: k, exponent: 1.0 }.integral(d);
    coil_spring_mass_kg(after + drawn, STEEL.0, STEEL.1, STEEL.2) / 0.0295
}

pub(super) static CLAIMS: &[Claim] = &[
    Claim {
        id: "9.5.1-springs",
        place: "9.5.1",
        says: "steel coil springs of these stiffnesses weigh more than 25 projectiles, mostly",
        opens: Opens::Preset("cocked"),
        check: |_| {
            let uncocked = coil_ratio(1e5, 0.0);
            let cocked = coil_ratio(1e5, 0.5);
            let mut heavy = 0;
            for k in 1..=10 {
                for d in 1..=10 {
                    heavy +=
                        usize::from(coil_ratio(0.75e6 * f64::from(k), 0.05 * f64::from(d)) > 25.0);
                }
            }
            found(
                format!(
                    "at least {} projectiles uncocked at any k, {} at d = 0.5; {heavy} of 100 cocked designs above 25",
                    number(uncocked),
                    number(cocked)
                ),
                number_verdict(false, uncocked < 25.0 && heavy > 50),
                "a spring's mass goes with the energy it stores, not with its stiffness; gamma is the plate's ratio elsewhere",
            )
        },
    },
    Claim {
        id: "9.5.1-surge",
        place: "9.5.1",
        says: "a plate with a spring on its rear surface could be practicable",
        opens: Opens::Scene(Scene::default),
        check: |lab| {
            let (rho, shear, stress) = STEEL;
            let bears = stress / (2.0 * rho * shear).sqrt();
            let speed = lab
                .run(Law::Sound, &with(&[]))
                .first_arrest
                .map_or(f64::NAN, |arrest| arrest.plate_velocity_m_s);
            found(
                format!(
                    "the plate leaves the contact with {}; the end of a steel coil bears {}",
                    unit(speed, "m/s"),
                    unit(bears, "m/s")
                ),
                trend_verdict(speed < bears),
                "tau/sqrt(2 rho G), whatever the wire: a faster end sends a wave that breaks it, or the coils clash",
            )
        },
    },
    Claim {
        id: "9.5.1-polynomial",
        place: "9.5.1",
        says: "k x^n is a low-order polynomial",
        opens: Opens::Nothing,
        check: |_| {
            let whole = (1..=30).filter(|tenths| tenths % 10 == 0).count();
            read(
                format!("{whole} of 30 exponents from 0.1 to 3 are whole numbers"),
                misprint_verdict(whole == 30, whole > 0),
                "a power law; only n = 1, 2, 3 are polynomials",
            )
        },
    },
    Claim {
        id: "9.5.1-density",
        place: "9.5.1",
        says: "plate and projectile together have a greatly decreased sectional density",
        opens: Opens::Nothing,
        check: |_| {
            let alone = 0.0295 / (std::f64::consts::PI * 0.00635 * 0.00635);
            let joined = [1.0, 7.0]
                .map(|gamma: f64| (1.0 + gamma) * 0.0295 / (gamma * 0.0295 / (2710.0 * 0.0254)));
            found(
                format!(
                    "{} kg/m2 alone; with a plate of gamma = 1 {}, of 7 {}",
                    number(alone),
                    number(joined[0]),
                    number(joined[1])
                ),
                trend_verdict(joined.iter().all(|density| *density < 0.7 * alone)),
                "over the whole plate's face; what is behind it is hit by a plate, not by a nose",
            )
        },
    },
    Claim {
        id: "9.5.1-stop",
        place: "9.5.1, 9.6",
        says: "a stop after common speed carries no danger of further penetration",
        opens: Opens::Scene(stopped),
        check: |lab| {
            let final_percent = |scene: &Scene| {
                lab.run(Law::Sound, scene).percent_of_baseline().unwrap_or(f64::INFINITY)
            };
            let first = [stopped(), stopped_heavy()].map(|scene| lab.percent(Law::Sound, &scene));
            let end = [stopped(), stopped_heavy()].map(|scene| final_percent(&scene));
            both(
                format!(
                    "gamma = 1: {} become {}; gamma = 3: {} become {}",
                    pc(first[0]),
                    pc(end[0]),
                    pc(first[1]),
                    pc(end[1])
                ),
                "no stop, and no second penetration in it".to_owned(),
                trend_verdict(end[0] < first[0] + 1.0),
                "the plate stands, the projectile still has the common speed: by the same law it goes on, and half the gain is lost",
            )
        },
    },
    Claim {
        id: "9.5.1-exponent",
        place: "9.5.1",
        says: "uncocked, the exponent should be above about 1.4",
        opens: Opens::Preset("figure-9.6"),
        check: |lab| {
            let curve = |law| lab.curve(law, Percent, &with(&[("k", 1e6)]), ("n", 0.2, 3.0, 15));
            let [sound, printed] = LAWS.map(curve);
            let told = |curve: &[(f64, f64)]| {
                format!(
                    "{} at n = 1, {} at 1.4, {} at 3",
                    pc(at(curve, 1.0)),
                    pc(at(curve, 1.4)),
                    pc(at(curve, 3.0))
                )
            };
            both(
                told(&sound),
                told(&printed),
                trend_verdict(falls(&sound) && at(&sound, 1.4) - at(&sound, 3.0) < 1.0),
                "with x in metres such a spring is as good as absent; F = F_ref (x/x_ref)^n would not say so",
            )
        },
    },
    Claim {
        id: "9.5.1-normalised",
        place: "9.5.1, 9.3.4",
        says: "uncocked, a higher exponent means less depth",
        opens: Opens::Scene(normalised),
        check: |lab| {
            let at = |x_ref: f64, n: f64| {
                let own = changed(normalised(), &[("x_ref", x_ref), ("n", n)]);
                lab.percent(Law::Sound, &own)
            };
            let exponents = [0.3, 1.0, 1.4, 3.0];
            let short = exponents.map(|n| at(1e-3, n));
            let long = exponents.map(|n| at(1e-1, n));
            found(
                format!(
                    "10 kN at 1 mm, n = 0.3, 1, 1.4, 3: {}; 10 kN at 100 mm: {}",
                    short.map(pc).join(" "),
                    long.map(pc).join(" ")
                ),
                trend_verdict(short[2] < short[1] && short[3] < short[2]),
                "for a spring given by its force at a length, the exponent helps or harms depending on whether the plate stays below that length",
            )
        },
    },
    Claim {
        id: "9.5.1-low-n",
        place: "9.5.1, 9.6",
        says: "cocked, the exponent should be low",
        opens: Opens::Preset("figure-9.12"),
        check: |lab| {
            lab.trend(
                (Percent, ("n", 0.1, 3.0, 16)),
                &with(&[("d", 0.1)]),
                rises,
                "consistent only with the split into cocked and uncocked",
            )
        },
    },
    Claim {
        id: "9.6-stiffness",
        place: "9.5.1, 9.6",
        says: "the spring should be as soft as possible, and cocked",
        opens: Opens::Preset("figure-9.11"),
        check: |lab| {
            let property = |curve: &[(f64, f64)]| rises(curve);
            lab.trend(
                (Percent, ("k", 0.0, 7.5e6, 16)),
                &with(&[("d", 0.1)]),
                property,
                "cocked, a stiffer spring means less depth, as 9.3.5 and 9.5.2 say: the advice contradicts them",
            )
        },
    },
    Claim {
        id: "9.6-mass",
        place: "9.6",
        says: "the plate should be light",
        opens: Opens::Preset("figure-9.2"),
        check: |lab| {
            lab.trend(
                (Percent, ("gamma", 0.8, 7.0, 16)),
                &with(&[("d", 0.1)]),
                rises,
                "cocked or not",
            )
        },
    },
    Claim {
        id: "9.6-damping",
        place: "9.6",
        says: "there should be no damping",
        opens: Opens::Preset("figure-9.4"),
        check: |lab| {
            lab.trend(
                (Percent, ("b", 0.0, 2000.0, 11)),
                &with(&[("d", 0.1)]),
                rises,
                "cocked or not, the damper holds the plate up",
            )
        },
    },
    Claim {
        id: "symbols",
        place: "chapters 2 to 9",
        says: "a symbol stands for one thing",
        opens: Opens::Nothing,
        check: |_| {
            let told: Vec<String> = SYMBOLS
                .iter()
                .map(|(symbol, meanings)| format!("{symbol}: {}", meanings.join(", ")))
                .collect();
            read(
                told.join("; "),
                misprint_verdict(SYMBOLS.is_empty(), true),
                "read with care: the gamma of 9.5.1 is a spring's mass, the d of Figure 4.1 a thickness",
            )
        },
    },
    Claim {
        id: "9.5.2-table",
        place: "9.5.2",
        says: "the beam's parameters are in Table 9.5.2",
        opens: Opens::Nothing,
        check: |_| {
            read(
                format!(
                    "Table 9.5.2 exists: {}; Table 9.3 exists: {}",
                    has_table("9.5.2"),
                    has_table("9.3")
                ),
                misprint_verdict(has_table("9.5.2"), has_table("9.3")),
                "Table 9.3 is meant",
            )
        },
    },
    Claim {
        id: "9.3-torsion",
        place: "Table 9.3, K",
        says: "the torsional spring constant is 7200",
        opens: Opens::Nothing,
        check: |_| {
            let stiffness = Cantilever::TABLE_9_3.torsional_n_m();
            found(
                format!("{} N m/rad", number(stiffness)),
                number_verdict(near(stiffness, 7200.0, 2e-3), false),
                "gamma K_Theta E I/l; the table's unit N/rad should be N m/rad, and its gamma is a radius factor",
            )
        },
    },
    Claim {
        id: "9.5.2-stiffness",
        place: "9.5.2, Figure 9.14",
        says: "at d = 0.03 m the effective stiffness is 0.111 MN/m",
        opens: Opens::Scene(cantilever),
        check: |_| {
            let beam = Cantilever::TABLE_9_3;
            let (start, tangent) = (beam.tangent_n_m(0.0), beam.tangent_n_m(0.03));
            let secant = beam.force_n(0.03) / 0.03;
            let stated = |value: f64| (value / 1e6 - 0.111).abs() < 5e-4;
            found(
                format!(
                    "{} at rest; at 0.03 m tangent {}, secant {}",
                    unit(start, "N/m"),
                    unit(tangent, "N/m"),
                    unit(secant, "N/m")
                ),
                number_verdict(stated(tangent) || stated(secant), stated(start)),
                "the stated value is the slope at rest",
            )
        },
    },
    Claim {
        id: "9.5.2-increase",
        place: "9.5.2, Figure 9.14",
        says: "stiffness grows with deflection, a little",
        opens: Opens::Nothing,
        check: |_| {
            let beam = Cantilever::TABLE_9_3;
            let growth = beam.tangent_n_m(beam.yield_at_m()) / beam.tangent_n_m(0.0) - 1.0;
            found(
                format!("by {} up to yield", pc(100.0 * growth)),
                trend_verdict((0.0..0.1).contains(&growth)),
                "the pseudo-rigid-body model's geometry",
            )
        },
    },
    Claim {
        id: "9.5.2-yield",
        place: "9.5.2, Figure 9.14",
        says: "yield is reached at d near 0.03 m",
        opens: Opens::Scene(cantilever),
        check: |_| {
            let at = Cantilever::TABLE_9_3.yield_at_m();
            found(
                mm(at),
                number_verdict(near(at, 0.03, 0.02), false),
                "bending stress at the root reaches 880 MPa",
            )
        },
    },
    Claim {
        id: "9.5.2-minimal",
        place: "9.5.2",
        says: "this beam's cocking would hardly reduce depth",
        opens: Opens::Scene(cantilever),
        check: |lab| {
            let values = LAWS.map(|law| {
                [lab.percent(law, &with(&[("k", 0.111e6)])), lab.percent(law, &cantilever())]
            });
            let told = |pair: [f64; 2]| {
                format!("{} uncocked, {} cocked by 0.03 m", pc(pair[0]), pc(pair[1]))
            };
            both(
                told(values[0]),
                told(values[1]),
                trend_verdict(values[0][1] > 0.9 * values[0][0]),
                "at gamma = 1, as if the beam had no mass",
            )
        },
    },
    Claim {
        id: "9.5.2-gamma",
        place: "9.5.2",
        says: "the mass ratio could be kept near one with this beam",
        opens: Opens::Nothing,
        check: |_| {
            let beam = Cantilever::TABLE_9_3;
            let ratio = beam.tip_mass_kg() / 0.0295;
            found(
                format!(
                    "the beam alone counts as {} g at its tip: {} projectiles; at yield it stores {} of 147.5 J",
                    number(1e3 * beam.tip_mass_kg()),
                    number(ratio),
                    unit(beam.energy_j(beam.yield_at_m()), "J")
                ),
                trend_verdict(ratio < 1.0),
                "33/140 of a titanium beam of 0.6 kg moves with the plate",
            )
        },
    },
    Claim {
        id: "9.5.3-helical",
        place: "9.5.3",
        says: "the helical rotating spring magnifies the effect of cocking",
        opens: Opens::Nothing,
        check: |_| {
            found(
                String::new(),
                Verdict::Unchecked,
                "no dimension of the spring is given, so nothing can be computed of it",
            )
        },
    },
    Claim {
        id: "9.6-feasible",
        place: "9.6",
        says: "all three designs appear feasible",
        opens: Opens::Nothing,
        check: |_| {
            let coil = coil_ratio(1e5, 0.0);
            let beam = Cantilever::TABLE_9_3.tip_mass_kg() / 0.0295;
            found(
                format!(
                    "moving or stored mass: coil {} projectiles, beam {}",
                    number(coil),
                    number(beam)
                ),
                trend_verdict(coil < 2.0 && beam < 2.0),
                "9.5.2 and 9.5.3 say themselves that the useful region is out of reach",
            )
        },
    },
    Claim {
        id: "9.6-plate",
        place: "9.6",
        says: "the Helical Rotating Plate was selected, too",
        opens: Opens::Nothing,
        check: |_| {
            let there = |name: &str| CONCEPTS.iter().any(|it| it.name == name);
            let (named, meant) =
                (there("Helical rotating plate"), there("Helical rotating spring"));
            read(
                format!("a concept of that name: {named}; Helical rotating spring: {meant}"),
                misprint_verdict(named, meant),
                "the Helical Rotating Spring is meant",
            )
        },
    },
    Claim {
        id: "10.1.6-confirm",
        place: "10.1.6",
        says: "the sensitivity plots confirm the importance of the design principles",
        opens: Opens::Nothing,
        check: |_| {
            // What the variables of Figures 9.2 to 9.12 act on: d, and gamma, b, k, n.
            let moved = ["Relative velocity reduction", "Transfer rate minimization"];
            let shown = PRINCIPLES.iter().filter(|it| moved.contains(&it.name)).count();
            read(
                format!("{shown} of {} principles are varied in chapter 9", PRINCIPLES.len()),
                number_verdict(shown == PRINCIPLES.len(), shown > 0),
                "of relative velocity and transfer rate; nothing there turns, spreads, or makes the shot glance off",
            )
        },
    },
];
