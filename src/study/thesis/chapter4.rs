//! Claims of chapter 4: the requirement, and the design principles.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::model::design;
use crate::model::run::{EventKind, Sample};
use crate::model::scene::Scene;
use crate::study::compare::{self, Candidate, Hardware};
use crate::study::thesis::early::ROD;
use crate::study::thesis::lab::{
    Lab, Law, both, changed, found, limit_m_s, mm, near, number, number_verdict, pc, rigid,
    spelled, trend_verdict, unit, with,
};
use crate::study::thesis::spread::{falling, rising};
use crate::study::thesis::{Claim, Opens, Verdict};

fn free() -> Scene {
    with(&[("k", 0.0)])
}

fn rigid_base() -> Scene {
    rigid(with(&[]))
}

fn oblique() -> Scene {
    changed(rigid_base(), &[("theta", 30.0)])
}

/// Three plates of 3 mm before a base plate, at 250 m/s.
pub(super) fn spaced() -> Scene {
    spelled(&[("v_i", "250"), ("h", "0.003"), ("h_base", "0.01"), ("elements", "3")])
}

/// The helical rotating spring, and the same without anything that turns.
fn helical() -> Scene {
    (super::concepts::CONCEPT_SCENES[7].1)()
}

fn unturned() -> Scene {
    changed(helical(), &[("I_z", 0.0)])
}

/// Momentum the contact takes from the projectile, and its force summed over time, N s.
fn momentum(lab: &Lab, scene: &Scene) -> (f64, f64) {
    let run = lab.run_with(Law::Sound, scene, true);
    let end_s = run.first_arrest.map_or(f64::NAN, |arrest| arrest.t_s);
    let contact: Vec<&Sample> =
        run.series.iter().take_while(|row| row.t_s <= end_s * (1.0 + 1e-12)).collect();
    let part = |pair: &[&Sample]| {
        0.5 * (pair[0].contact_force_n + pair[1].contact_force_n) * (pair[1].t_s - pair[0].t_s)
    };
    // The last sample may be that after the arrest, where the force has ended.
    let inside: Vec<&Sample> = contact
        .iter()
        .copied()
        .filter(|row| row.contact_force_n > 0.0 || row.t_s < end_s)
        .collect();
    let (Some(first), Some(last)) = (inside.first(), inside.last()) else {
        return (f64::NAN, f64::NAN);
    };
    let lost = 0.0295 * (first.projectile_velocity_m_s - last.projectile_velocity_m_s);
    (lost, inside.windows(2).map(part).sum())
}

/// Energy drawn into the spring for a fifth less depth than uncocked, J.
fn energy_for_a_fifth_j(lab: &Lab, gamma: f64) -> f64 {
    let depth = |d: f64| lab.percent(Law::Sound, &with(&[("gamma", gamma), ("d", d)]));
    let wanted = 0.8 * depth(0.0);
    let d = crate::numerics::root::in_bracket(0.0, 0.5, |d| depth(d) - wanted);
    0.5 * 1e5 * d * d
}

pub(super) static CLAIMS: &[Claim] = &[
    Claim {
        id: "4.1-requirement",
        place: "4.1, requirement 1",
        says: "the armor plate is to be penetrated less than a solid plate of equal mass",
        opens: Opens::Scene(Scene::default),
        check: |_| {
            let scene = Arc::new(with(&[]));
            let report =
                compare::compare(
                    &scene,
                    Hardware::default(),
                    &mut |_, _| ControlFlow::Continue(()),
                )
                .ok();
            let depth = report.as_ref().and_then(compare::Report::depth_over_solid);
            let efficiency = report
                .as_ref()
                .and_then(|report| report.of(Candidate::Scene)?.mass_efficiency())
                .unwrap_or(f64::NAN);
            let depth = depth.unwrap_or(f64::NAN);
            found(
                format!(
                    "with the least steel spring, gamma = 1: depth {} of the solid plate's; mass efficiency by the ballistic \
                     limit {}",
                    pc(100.0 * depth),
                    number(efficiency)
                ),
                trend_verdict(depth < 1.0),
                "met by depth, which the requirement names; by the ballistic limit, which 4.1 names before it, the system \
                 loses: the spring alone weighs twelve projectiles (cmra compare)",
            )
        },
    },
    Claim {
        id: "4.1-stone",
        place: "4.1",
        says: "the principles follow from equation 2.4",
        opens: Opens::Nothing,
        check: |_| {
            found(
                String::new(),
                Verdict::Unchecked,
                "2.4 is for blunt noses in slabs without end; chapter 8 has round ones in a plate, and compliance is not in 2.4",
            )
        },
    },
    Claim {
        id: "4.2.1-large",
        place: "4.2.1",
        says: "critical angles for ricochet are rather large: the plate has to turn far",
        opens: Opens::Nothing,
        check: |_| {
            let angles = [5e8, 1e9, 2e9].map(|strength_pa| {
                design::Rod { strength_pa, ..ROD }.critical_obliquity_deg(2710.0)
            });
            found(
                format!(
                    "{}, {}, {} deg from the normal for rods of 0.5, 1, 2 GPa",
                    number(angles[0]),
                    number(angles[1]),
                    number(angles[2])
                ),
                trend_verdict(angles.iter().all(|angle| *angle > 25.0)),
                "Tate's formula with the thesis's shot as a steel rod",
            )
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
            found(
                format!(
                    "25.4 mm become {} at 30 deg; the ballistic limit rises from {} to {}",
                    mm(thickness),
                    unit(straight, "m/s"),
                    unit(slanted, "m/s")
                ),
                trend_verdict(thickness > 0.0254 && slanted > straight),
                "h/cos(theta), along the projectile's path",
            )
        },
    },
    Claim {
        id: "4.3.1-normal",
        place: "4.3.1",
        says: "obliquity takes from the velocity along the plate's normal",
        opens: Opens::Scene(oblique),
        check: |lab| {
            let angles = [0.0f64, 15.0, 30.0, 45.0];
            let normal = angles.map(|degrees| 100.0 * degrees.to_radians().cos());
            let depths = angles.map(|degrees| {
                let own = changed(rigid_base(), &[("theta", degrees)]);
                lab.depth_m(Law::Sound, &own) * degrees.to_radians().cos()
            });
            found(
                format!(
                    "of 100 m/s {} at 30 deg, {} at 45; the hole is {} deep at 0 deg, {} at 30, {} at 45, along the normal",
                    unit(normal[2], "m/s"),
                    unit(normal[3], "m/s"),
                    mm(depths[0]),
                    mm(depths[2]),
                    mm(depths[3])
                ),
                trend_verdict(falling(&normal)),
                "geometry, and true; the contact law does not use it: it takes the whole velocity along the path, and only \
                 that path becomes longer",
            )
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
            found(
                format!("{} at 40 m/s, {} at 120 m/s", mm(depths[0]), mm(depths[4])),
                trend_verdict(depths.windows(2).all(|pair| pair[1] > pair[0])),
                "depth grows with the energy to be spent",
            )
        },
    },
    Claim {
        id: "4.3.2-spaced",
        place: "4.3.2",
        says: "sacrificial layers at a distance slow the shot before it reaches the base armour",
        opens: Opens::Preset("array-stacked"),
        check: |lab| {
            let run = lab.run(Law::Sound, &spaced());
            let arriving: Vec<f64> = run.stack.as_ref().map_or_else(Vec::new, |stack| {
                stack.behind.iter().map(|run| run.scene.projectile.velocity_m_s).collect()
            });
            let told: Vec<String> = arriving.iter().map(|v| unit(*v, "m/s")).collect();
            found(
                format!(
                    "250 m/s into three plates of 3 mm, gamma = 1; behind them {}",
                    told.join(", ")
                ),
                trend_verdict(arriving.len() == 3 && falling(&arriving)),
                "each plate takes its share; the shot stays whole and straight in this model",
            )
        },
    },
    Claim {
        id: "4.3.2-cocked",
        place: "4.3.2",
        says: "to set the plate moving takes much stored energy and a very light plate",
        opens: Opens::Preset("figure-9.10"),
        check: |lab| {
            let energies = [0.8, 1.0, 2.0, 3.0].map(|gamma| energy_for_a_fifth_j(lab, gamma));
            let told = energies.map(|energy| unit(energy, "J"));
            found(
                format!("a fifth less depth at gamma = 0.8, 1, 2, 3 takes {}", told.join(", ")),
                trend_verdict(rising(&energies) && energies[0] > 147.5),
                "the shot itself has 147.5 J; k = 1e5 N/m",
            )
        },
    },
    Claim {
        id: "4.1-impulse",
        place: "4.4.1, eq. 4.1",
        says: "the velocity lost times mass is force times duration",
        opens: Opens::Scene(Scene::default),
        check: |lab| {
            let pairs = [rigid_base(), with(&[])].map(|scene| momentum(lab, &scene));
            found(
                format!(
                    "fixed: {} and {} N s; gamma = 1: {} and {} N s",
                    number(pairs[0].0),
                    number(pairs[0].1),
                    number(pairs[1].0),
                    number(pairs[1].1)
                ),
                number_verdict(pairs.iter().all(|(lost, given)| near(*given, *lost, 5e-3)), false),
                "with the mean force; the run's own history, summed by the trapezoid",
            )
        },
    },
    Claim {
        id: "4.4.1-force",
        place: "4.4.1",
        says: "a softer mount lowers the impact force",
        opens: Opens::Scene(free),
        check: |lab| {
            let peak =
                |scene: &Scene| lab.run(Law::Sound, scene).peak_contact_force_n.unwrap_or(f64::NAN);
            let forces = [peak(&rigid_base()), peak(&with(&[("k", 7.5e6)])), peak(&free())];
            found(
                format!(
                    "peak {} fixed, {} at k = 7.5e6, {} free",
                    unit(forces[0], "N"),
                    unit(forces[1], "N"),
                    unit(forces[2], "N")
                ),
                trend_verdict(falling(&forces)),
                "the nose is buried less deep, and engages less area",
            )
        },
    },
    Claim {
        id: "4.4.1-duration",
        place: "4.4.1, eq. 4.1",
        says: "a softer mount reduces penetration: the projectile takes longer to stop completely",
        opens: Opens::Scene(Scene::default),
        check: |lab| {
            // Time to the common velocity, time to the projectile's full stop, and depth: fixed, and on the spring.
            let times = |law, scene: &Scene| {
                let run = lab.run(law, scene);
                let common = run.first_arrest.map_or(f64::NAN, |it| it.t_s);
                let turning =
                    run.events.iter().find(|it| it.kind == EventKind::GreatestDisplacement);
                (common, turning.map_or(common, |it| it.t_s))
            };
            let told = |law| {
                let (fixed, soft) = (times(law, &rigid_base()), times(law, &with(&[])));
                format!(
                    "fixed: at rest after {}; spring of 0.1 MN/m: at rest after {}, common speed after {}",
                    unit(fixed.1, "s"),
                    unit(soft.1, "s"),
                    unit(soft.0, "s")
                )
            };
            let (fixed, soft) = (times(Law::Sound, &rigid_base()), times(Law::Sound, &with(&[])));
            let longer = soft.1 > fixed.1 && soft.0 < fixed.0;
            let shallower = lab.percent(Law::Sound, &with(&[])) < 100.0;
            both(
                told(Law::Sound),
                told(Law::Printed),
                number_verdict(false, longer && shallower),
                "longer to a full stop, as the text says; the contact itself, in which the hole is made, becomes shorter, since \
                 less velocity has to be taken off",
            )
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
            found(
                format!("plate mass: {} at gamma = 0.8, {} at 7", pc(light), pc(heavy)),
                Verdict::Unchecked,
                "4.4.2 means material that bears stress, which a rigid plate has not; of inertia the opposite is true",
            )
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
            found(
                format!("{} at 0.8 R, {} at 1.2 R", mm(depths[0]), mm(depths[2])),
                trend_verdict(depths.windows(2).all(|pair| pair[1] < pair[0])),
                "the same energy is spent over a larger area",
            )
        },
    },
    Claim {
        id: "4.4.4-rotation",
        place: "4.4.4",
        says: "energy spent on rotation cannot penetrate: elements that turn reduce depth",
        opens: Opens::Preset("concept-helical-spring"),
        check: |lab| {
            let (with_it, without) =
                (lab.depth_m(Law::Sound, &helical()), lab.depth_m(Law::Sound, &unturned()));
            found(
                format!("{} with the plate's rotation, {} without", mm(with_it), mm(without)),
                trend_verdict(with_it < without),
                "what turns makes the plate slower to give way: it takes its energy afterwards, and deepens the hole before",
            )
        },
    },
    Claim {
        id: "4.4.4-lateral",
        place: "4.4.4",
        says: "lateral motion of the element removes penetrating power",
        opens: Opens::Nothing,
        check: |_| {
            found(
                String::new(),
                Verdict::Unchecked,
                "the plate is guided along its normal here and in the thesis's own model: nothing moves sideways",
            )
        },
    },
];
