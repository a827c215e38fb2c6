//! Claims of chapters 2 to 7: collisions, ricochet, design principles, the screening matrix.

use crate::model::design::{self, Rod};
use crate::model::scene::Scene;
use crate::numerics::larger;
use crate::study::principles::{Function, PRINCIPLES};
use crate::study::screening::{CONCEPTS, WEIGHTS_PERCENT, rank, ranking};
use crate::study::thesis::lab::{
    Law, changed, limit_m_s, misprint_verdict, mm, near, number, number_verdict, pc, rigid,
    trend_verdict, unit, with,
};
use crate::study::thesis::{Claim, Found, Opens, Verdict};

/// A steel rod like the thesis's projectile: its mass in a cylinder of its radius.
const ROD: Rod = Rod {
    density_kg_m3: 7850.0,
    strength_pa: 1e9,
    velocity_m_s: 100.0,
    length_m: 0.0297,
    diameter_m: 0.0127,
};

fn free() -> Scene {
    with(&[("k", 0.0)])
}

fn rigid_base() -> Scene {
    rigid(with(&[]))
}

fn oblique() -> Scene {
    changed(rigid_base(), &[("theta", 30.0)])
}

pub(super) static CLAIMS: &[Claim] = &[
    Claim {
        id: "2.3.1-invert",
        place: "2.3.1, eq. 2.1",
        says: "in an elastic collision of equal masses the relative velocity is inverted",
        opens: Opens::Nothing,
        check: |_| {
            let inverted = |m_b: f64| {
                let (a, b) = design::elastic((1.0, 100.0), (m_b, 0.0));
                near(b - a, 100.0, 1e-12)
            };
            let any = [0.1, 1.0, 3.0, 50.0].into_iter().all(inverted);
            Found {
                sound: "inverted at mass ratios 0.1, 1, 3 and 50".to_owned(),
                printed: String::new(),
                verdict: if any {
                    Verdict::Corrected
                } else {
                    number_verdict(inverted(1.0), false)
                },
                cause: "it holds for any masses: the condition is not needed",
            }
        },
    },
    Claim {
        id: "2.3.1-constant",
        place: "2.3.1",
        says: "the relative velocity stays the same through an elastic collision",
        opens: Opens::Nothing,
        check: |_| {
            let (a, b) = design::elastic((1.0, 100.0), (2.0, 0.0));
            Found {
                sound: format!("v_A - v_B: 100 m/s before, {} m/s after", number(a - b)),
                printed: String::new(),
                verdict: misprint_verdict(near(a - b, 100.0, 1e-9), near(b - a, 100.0, 1e-9)),
                cause: "its size stays, its sign changes, as equation 2.1 has it",
            }
        },
    },
    Claim {
        id: "2.3.1-inelastic",
        place: "2.3.1, eq. 2.2",
        says: "after a perfectly inelastic collision both move at m_A v_A/(m_A + m_B)",
        opens: Opens::Scene(free),
        check: |lab| {
            let speed = |law| {
                lab.run(law, &free()).first_arrest.map_or(f64::NAN, |it| it.plate_velocity_m_s)
            };
            let stated = design::inelastic((1.0, 100.0), (1.0, 0.0));
            Found {
                sound: unit(speed(Law::Sound), "m/s"),
                printed: unit(speed(Law::Printed), "m/s"),
                verdict: number_verdict(near(speed(Law::Sound), stated, 1e-6), false),
                cause: "a free plate of the projectile's mass is at common speed when penetration ends",
            }
        },
    },
    Claim {
        id: "2.4.1-insensitive",
        place: "2.4.1, eq. 2.3",
        says: "the critical obliquity for ricochet hardly depends on the parameters",
        opens: Opens::Nothing,
        check: |_| {
            let angle = |rod: Rod| rod.critical_obliquity_deg(2710.0);
            let own = angle(ROD);
            let tenth = [
                Rod { density_kg_m3: 1.1 * ROD.density_kg_m3, ..ROD },
                Rod { strength_pa: 1.1 * ROD.strength_pa, ..ROD },
                Rod { velocity_m_s: 1.1 * ROD.velocity_m_s, ..ROD },
                Rod { length_m: 1.1 * ROD.length_m, ..ROD },
            ];
            let most =
                tenth.map(|rod| (angle(rod) / own - 1.0).abs()).into_iter().fold(0.0, larger);
            Found {
                sound: format!(
                    "{} deg; a tenth more of any changes it by {} at most",
                    number(own),
                    pc(100.0 * most)
                ),
                printed: String::new(),
                verdict: trend_verdict(most < 0.1),
                cause: "the tangent goes with the cube root; a steel rod of 1 GPa is assumed",
            }
        },
    },
    Claim {
        id: "2.4.2-stone",
        place: "2.4.2, eq. 2.4",
        says: "Stone's depth follows from energy per area, target density and a parameter c_t",
        opens: Opens::Scene(rigid_base),
        check: |lab| {
            let depth = lab.depth_m(Law::Sound, &rigid_base());
            let at_one = design::stone_depth_m((0.0295, 100.0, 0.00635), 2710.0, 1.0);
            let speed = (at_one / depth).sqrt();
            Found {
                sound: format!("the baseline's depth would need c_t = ({})^2", unit(speed, "m/s")),
                printed: String::new(),
                verdict: Verdict::Unchecked,
                cause: "c_t is not given, and to give a length it must be the square of a speed",
            }
        },
    },
    Claim {
        id: "4.1-requirement",
        place: "4.1",
        says: "armour must be penetrated less than a solid plate of equal mass",
        opens: Opens::Scene(Scene::default),
        check: |lab| Found {
            sound: format!(
                "plate alone, gamma = 1: {} of the fixed plate's depth",
                pc(lab.percent(Law::Sound, &with(&[])))
            ),
            printed: pc(lab.percent(Law::Printed, &with(&[]))),
            verdict: Verdict::Unchecked,
            cause: "the mass of spring, guide and base is not given, so no equal mass can be formed",
        },
    },
    Claim {
        id: "4.3.1-thickness",
        place: "4.3.1, Figure 4.1",
        says: "obliquity makes the plate effectively thicker",
        opens: Opens::Scene(oblique),
        check: |_| {
            let thickness = design::effective_thickness_m(0.0254, 30.0);
            let (straight, slanted) = (limit_m_s(&rigid_base()), limit_m_s(&oblique()));
            Found {
                sound: format!(
                    "25.4 mm become {} at 30 deg; the ballistic limit rises from {} to {}",
                    mm(thickness),
                    unit(straight, "m/s"),
                    unit(slanted, "m/s")
                ),
                printed: String::new(),
                verdict: trend_verdict(thickness > 0.0254 && slanted > straight),
                cause: "h/cos(theta), along the projectile's path",
            }
        },
    },
    Claim {
        id: "4.3.2-velocity",
        place: "4.3.2",
        says: "less relative velocity before impact means less penetration",
        opens: Opens::Scene(rigid_base),
        check: |lab| {
            let depths = [40.0, 60.0, 80.0, 100.0, 120.0]
                .map(|v| lab.depth_m(Law::Sound, &changed(rigid_base(), &[("v_i", v)])));
            Found {
                sound: format!("{} at 40 m/s, {} at 120 m/s", mm(depths[0]), mm(depths[4])),
                printed: String::new(),
                verdict: trend_verdict(depths.windows(2).all(|pair| pair[1] > pair[0])),
                cause: "depth grows with the energy to be spent",
            }
        },
    },
    Claim {
        id: "4.4.1-duration",
        place: "4.4.1, eq. 4.1",
        says: "a softer mount reduces penetration by making the impact last longer",
        opens: Opens::Scene(free),
        check: |lab| {
            let contact =
                |law, scene: &Scene| lab.run(law, scene).first_arrest.map_or(f64::NAN, |it| it.t_s);
            let [sound, printed] = [Law::Sound, Law::Printed]
                .map(|law| [contact(law, &rigid_base()), contact(law, &free())]);
            let told = |pair: [f64; 2]| {
                format!("fixed {}, free plate {}", unit(pair[0], "s"), unit(pair[1], "s"))
            };
            Found {
                sound: told(sound),
                printed: told(printed),
                verdict: trend_verdict(sound[1] > sound[0]),
                cause: "the contact becomes shorter, not longer: the plate runs away, and less velocity has to be taken off",
            }
        },
    },
    Claim {
        id: "4.4.2-mass",
        place: "4.4.2 against 9.6",
        says: "more mass taking part means less penetration",
        opens: Opens::Preset("figure-9.2"),
        check: |lab| {
            let light = lab.percent(Law::Sound, &with(&[("gamma", 0.8)]));
            let heavy = lab.percent(Law::Sound, &with(&[("gamma", 7.0)]));
            Found {
                sound: format!("plate mass: {} at gamma = 0.8, {} at 7", pc(light), pc(heavy)),
                printed: String::new(),
                verdict: Verdict::Unchecked,
                cause: "4.4.2 means material that bears stress, which a rigid plate has not; of inertia the opposite is true",
            }
        },
    },
    Claim {
        id: "4.4.3-section",
        place: "4.4.3",
        says: "less mass per cross section means less penetration",
        opens: Opens::Scene(rigid_base),
        check: |lab| {
            let depths = [0.8, 1.0, 1.2].map(|factor| {
                lab.depth_m(Law::Sound, &changed(rigid_base(), &[("R", factor * 0.00635)]))
            });
            Found {
                sound: format!("{} at 0.8 R, {} at 1.2 R", mm(depths[0]), mm(depths[2])),
                printed: String::new(),
                verdict: trend_verdict(depths.windows(2).all(|pair| pair[1] < pair[0])),
                cause: "the same energy is spent over a larger area",
            }
        },
    },
    Claim {
        id: "5.1.3-cocked",
        place: "5.1.3 against Table 5.1",
        says: "accelerated elements satisfy transfer rate minimization, too",
        opens: Opens::Nothing,
        check: |_| {
            let rate = PRINCIPLES.iter().find(|it| it.name == "Transfer rate minimization");
            let listed =
                rate.is_some_and(|it| it.functions.contains(&Function::AcceleratedElements));
            let stiffness =
                rate.is_some_and(|it| it.functions.contains(&Function::ControlledStiffness));
            Found {
                sound: format!(
                    "in Table 5.1: accelerated elements {listed}, controlled stiffness {stiffness}"
                ),
                printed: String::new(),
                verdict: misprint_verdict(listed, stiffness),
                cause: "the table leaves the function out that the text names",
            }
        },
    },
    Claim {
        id: "7.1-weights",
        place: "Table 7.1",
        says: "the weights are parts of a whole",
        opens: Opens::Nothing,
        check: |_| {
            let sum: f64 = WEIGHTS_PERCENT.iter().sum();
            Found {
                sound: pc(sum),
                printed: String::new(),
                verdict: number_verdict(near(sum, 100.0, 1e-12), false),
                cause: "the seven weights add up",
            }
        },
    },
    Claim {
        id: "7.1-totals",
        place: "Table 7.1",
        says: "eight weighted totals from 2.02 to 3.78",
        opens: Opens::Nothing,
        check: |_| {
            let places = rank(&WEIGHTS_PERCENT);
            let right =
                places.iter().all(|it| (it.total - CONCEPTS[it.concept].total).abs() < 5e-3);
            let totals: Vec<String> = places.iter().map(|it| number(it.total)).collect();
            Found {
                sound: totals.join(" "),
                printed: String::new(),
                verdict: number_verdict(right, false),
                cause: "ratings times weights give the printed totals",
            }
        },
    },
    Claim {
        id: "7.1-ranks",
        place: "Table 7.1, 7.2.3",
        says: "the cocked cantilever ranks first, the helical rotating spring second",
        opens: Opens::Nothing,
        check: |_| {
            let right =
                rank(&WEIGHTS_PERCENT).iter().all(|it| it.rank == CONCEPTS[it.concept].rank);
            let order: Vec<&str> =
                ranking(&WEIGHTS_PERCENT).iter().map(|it| CONCEPTS[it.concept].name).collect();
            Found {
                sound: order[..3].join(", "),
                printed: String::new(),
                verdict: number_verdict(right, false),
                cause: "all eight ranks follow from the totals",
            }
        },
    },
    Claim {
        id: "7.2.2-weights",
        place: "7.2.2",
        says: "the weights reflect how important the mechanical functions are",
        opens: Opens::Nothing,
        check: |_| {
            let mut weights = WEIGHTS_PERCENT;
            weights[6] = 0.0;
            let places = rank(&weights);
            let helical = places[7];
            Found {
                sound: format!(
                    "without ease of analysis (35 %) the helical spring is {}th with {}",
                    helical.rank,
                    number(helical.total)
                ),
                printed: String::new(),
                verdict: trend_verdict(helical.rank <= 2),
                cause: "ease of analysis decides the selection; plate acceleration, which chapter 9 finds strongest, has 3 %",
            }
        },
    },
    Claim {
        id: "7.2.2-reference",
        place: "7.2.2",
        says: "the angled four-bar is the reference the others are rated against",
        opens: Opens::Nothing,
        check: |_| {
            let reference = |name: &str| {
                let all_equal = |ratings: &[f64; 7]| ratings.iter().all(|it| near(*it, 3.0, 1e-12));
                CONCEPTS.iter().any(|it| it.name == name && all_equal(&it.ratings))
            };
            Found {
                sound: "the emergent four-bar alone has a 3 everywhere".to_owned(),
                printed: String::new(),
                verdict: misprint_verdict(
                    reference("Angled four-bar"),
                    reference("Emergent four-bar"),
                ),
                cause: "no concept has that name: the emergent four-bar is meant",
            }
        },
    },
];
