//! Claims of chapter 2: mechanisms, collisions, ricochet and penetration.

use crate::model::design::beam::Cantilever;
use crate::model::design::{self, Rod};
use crate::model::scene::Scene;
use crate::numerics::larger;
use crate::study::thesis::elastica;
use crate::study::thesis::lab::{
    Lab, Law, both, changed, found, mm, near, number, number_verdict, pc, rigid, trend_verdict,
    unit, with,
};
use crate::study::thesis::{Claim, Opens, Verdict};

/// A steel rod like the thesis's projectile: its mass in a cylinder of its radius.
pub(super) const ROD: Rod = Rod {
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

/// The pseudo-rigid body's tip load over the elastica's, at a displacement over length.
fn load_ratio(displacement: f64) -> f64 {
    let beam = Cantilever::TABLE_9_3;
    let l = beam.length_m;
    let rigidity = beam.modulus_pa * beam.width_m * beam.height_m.powi(3) / 12.0;
    beam.force_n(displacement * l) * l * l / rigidity / elastica::load(displacement)
}

/// d ln(depth)/d ln(variable) about the rigid baseline.
fn power(lab: &Lab, name: &str, value: f64) -> f64 {
    let depth =
        |factor: f64| lab.depth_m(Law::Sound, &changed(rigid_base(), &[(name, factor * value)]));
    (depth(1.02) / depth(0.98)).ln() / (1.02f64 / 0.98).ln()
}

pub(super) static CLAIMS: &[Claim] = &[
    Claim {
        id: "2.2.1-beam",
        place: "2.2.1",
        says: "the pseudo-rigid-body model preserves the behaviour of the compliant beam",
        opens: Opens::Preset("concept-cocked-cantilever"),
        check: |_| {
            let off = [1e-3, 0.1, 0.3, 0.5].map(|x| 100.0 * (load_ratio(x) - 1.0));
            let told = off.map(|off| format!("{off:+.1} %"));
            found(
                format!("tip load at x/l = 0.001, 0.1, 0.3, 0.5: {} off", told.join(", ")),
                trend_verdict(off.iter().all(|off| off.abs() < 5.0)),
                "against the elastic line of a cantilever under a load across it",
            )
        },
    },
    Claim {
        id: "2.3.1-centre",
        place: "2.3.1",
        says: "the velocity of the centre of mass stays the same through an elastic collision",
        opens: Opens::Nothing,
        check: |_| {
            let kept = [0.1, 1.0, 3.0, 50.0].into_iter().all(|m_b: f64| {
                let (a, b) = design::elastic((1.0, 100.0), (m_b, 0.0));
                near(a + m_b * b, 100.0, 1e-12)
            });
            found(
                "m_A v_A + m_B v_B is kept at mass ratios 0.1, 1, 3 and 50".to_owned(),
                number_verdict(kept, false),
                "momentum",
            )
        },
    },
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
            found(
                "inverted at mass ratios 0.1, 1, 3 and 50".to_owned(),
                if any { Verdict::Corrected } else { number_verdict(inverted(1.0), false) },
                "it holds for any masses: the condition is not needed",
            )
        },
    },
    Claim {
        id: "2.3.1-constant",
        place: "2.3.1",
        says: "the relative velocity stays the same through an elastic collision",
        opens: Opens::Nothing,
        check: |_| {
            let (a, b) = design::elastic((1.0, 100.0), (2.0, 0.0));
            found(
                format!("v_A - v_B: 100 m/s before, {} m/s after", number(a - b)),
                number_verdict(near(a - b, 100.0, 1e-9), near(b - a, 100.0, 1e-9)),
                "a misstatement: its size stays, its sign changes, as equation 2.1 has it",
            )
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
            both(
                unit(speed(Law::Sound), "m/s"),
                unit(speed(Law::Printed), "m/s"),
                number_verdict(near(speed(Law::Sound), stated, 1e-6), false),
                "a free plate of the projectile's mass is at common speed when penetration ends",
            )
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
            found(
                format!(
                    "{} deg; a tenth more of any changes it by {} at most",
                    number(own),
                    pc(100.0 * most)
                ),
                trend_verdict(most < 0.1),
                "the tangent goes with the cube root; a steel rod of 1 GPa is assumed",
            )
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
            found(
                format!("the baseline's depth would need c_t = ({})^2", unit(speed, "m/s")),
                Verdict::Unchecked,
                "c_t is not given, and to give a length it must be the square of a speed",
            )
        },
    },
    Claim {
        id: "2.4.2-powers",
        place: "2.4.2, eq. 2.4",
        says: "depth goes with mass, with the square of velocity, and against the square of the radius",
        opens: Opens::Scene(rigid_base),
        check: |lab| {
            let powers = [("m_p", 0.0295), ("v_i", 100.0), ("R", 0.00635)]
                .map(|(name, value)| power(lab, name, value));
            found(
                format!(
                    "powers of the rigid baseline: mass {}, velocity {}, radius {}",
                    number(powers[0]),
                    number(powers[1]),
                    number(powers[2])
                ),
                trend_verdict(
                    near(powers[0], 1.0, 0.1)
                        && near(powers[1], 2.0, 0.1)
                        && near(powers[2], -2.0, 0.1),
                ),
                "Stone's nose is blunt, his slab without end; chapter 8's is round and enters over a third of the depth",
            )
        },
    },
    Claim {
        id: "2.4.2-energy",
        place: "2.4.2",
        says: "what counts is the kinetic energy per area that is struck",
        opens: Opens::Scene(rigid_base),
        check: |lab| {
            let depths = [(4.0, 0.5), (1.0, 1.0), (0.25, 2.0)].map(|(m, v)| {
                let own = changed(rigid_base(), &[("m_p", m * 0.0295), ("v_i", v * 100.0)]);
                lab.depth_m(Law::Sound, &own)
            });
            found(
                format!(
                    "147.5 J at 50, 100, 200 m/s: {}, {}, {}",
                    mm(depths[0]),
                    mm(depths[1]),
                    mm(depths[2])
                ),
                trend_verdict(depths.iter().all(|depth| near(*depth, depths[1], 0.1))),
                "the drag, which alone knows the velocity, is small beside the strength",
            )
        },
    },
];
