//! Claims of sections 9.3.1 to 9.3.4: one variable at a time, each over its own figure's range.

use crate::model::scene::Scene;
use crate::study::thesis::lab::Measure::{Percent, Travel};
use crate::study::thesis::lab::{
    Axis, LAWS, Lab, Law, P, both, ends, found, misprint_verdict, number, pc, trend_verdict, with,
};
use crate::study::thesis::shape::{at, edge, falls, flattens, range, rises, slope};
use crate::study::thesis::spread::{falling, judged, list, rising};
use crate::study::thesis::{Claim, Opens, Verdict};

const GAMMA: Axis = ("gamma", 0.8, 7.0, 32);
const COCKING: Axis = ("d", 0.0, 0.5, 26);
const DAMPING: Axis = ("b", 0.0, 2000.0, 21);
const SPRING: Axis = ("k", 0.0, 7.5e6, 26);
const EXPONENT: Axis = ("n", 0.1, 3.0, 30);

/// The scene of Figure 9.4: a damper and no spring.
fn damped() -> Scene {
    with(&[("k", 0.0)])
}

/// The scene Figure 9.6 must have been made with.
fn stiff() -> Scene {
    with(&[("k", 1e6)])
}

fn gentle() -> Scene {
    with(&[])
}

/// Depth over the exponent in narrow steps.
fn edge_curve(lab: &Lab, law: Law, scene: &Scene, count: usize) -> Vec<P> {
    lab.curve(law, Percent, scene, ("n", 0.1, 1.0, count))
}

fn edge_at(lab: &Lab, law: Law, scene: &Scene) -> f64 {
    edge(&edge_curve(lab, law, scene, 46)).unwrap_or(f64::NAN)
}

/// The greatest step between neighbours of a curve.
fn greatest_step(curve: &[P]) -> f64 {
    curve.windows(2).map(|pair| (pair[1].1 - pair[0].1).abs()).fold(0.0, crate::numerics::larger)
}

pub(super) static CLAIMS: &[Claim] = &[
    Claim {
        id: "9.2a-rises",
        place: "9.3.1, Figure 9.2(a)",
        says: "depth grows with the mass ratio, ever less steeply",
        opens: Opens::Preset("figure-9.2"),
        check: |lab| {
            let property = |curve: &[P]| rises(curve) && flattens(curve);
            lab.trend(
                (Percent, GAMMA),
                &gentle(),
                property,
                "the heavier plate runs away more slowly",
            )
        },
    },
    Claim {
        id: "9.2a-low",
        place: "9.3.1",
        says: "a very low mass ratio cuts depth significantly",
        opens: Opens::Preset("figure-9.2"),
        check: |lab| {
            let property = |curve: &[P]| at(curve, 0.8) < 75.0;
            lab.trend(
                (Percent, GAMMA),
                &gentle(),
                property,
                "by four tenths; the printed coupling hides half of it",
            )
        },
    },
    Claim {
        id: "9.2b-falls",
        place: "9.3.1, Figure 9.2(b)",
        says: "the greatest displacement falls with the mass ratio",
        opens: Opens::Preset("figure-9.2"),
        check: |lab| {
            lab.trend(
                (Travel, GAMMA),
                &gentle(),
                falls,
                "the heavier body sets out more slowly with less energy",
            )
        },
    },
    Claim {
        id: "9.3a-falls",
        place: "9.3.2, Figure 9.3(a)",
        says: "depth falls with the cocking distance",
        opens: Opens::Preset("figure-9.3"),
        check: |lab| {
            lab.trend(
                (Percent, COCKING),
                &gentle(),
                falls,
                "the cocked spring pulls the plate away from the shot",
            )
        },
    },
    Claim {
        id: "9.3b-slope",
        place: "9.3.2, Figure 9.3(b)",
        says: "the greatest displacement grows with cocking, nearly linearly at 1 m/m",
        opens: Opens::Preset("figure-9.3"),
        check: |lab| {
            let metres = |curve: &[P]| slope(curve) / 1e3;
            let [sound, printed] = LAWS.map(|law| lab.curve(law, Travel, &gentle(), COCKING));
            both(
                format!("slope {} m/m over d = 0 to 0.5 m", number(metres(&sound))),
                format!("slope {} m/m", number(metres(&printed))),
                trend_verdict(rises(&sound) && (metres(&sound) - 1.0).abs() < 0.1),
                "the stored energy outweighs the shot's: the plate passes neutral to the other side",
            )
        },
    },
    Claim {
        id: "9.3-some",
        place: "9.3.2",
        says: "some cocking cuts depth significantly without much more displacement",
        opens: Opens::Preset("figure-9.3"),
        check: |lab| {
            let axis = ("d", 0.0, 0.1, 51);
            let price = |law| {
                let depth = lab.curve(law, Percent, &gentle(), axis);
                let travel = lab.curve(law, Travel, &gentle(), axis);
                let wanted = 0.8 * depth[0].1;
                let d = depth.iter().find(|point| point.1 <= wanted).map(|point| point.0);
                d.map(|d| (d, (at(&travel, d) + 1e3 * d) / travel[0].1))
            };
            let told = |found: Option<(f64, f64)>| {
                found.map_or_else(
                    || "a fifth less depth is not reached by d = 0.1 m".to_owned(),
                    |(d, ratio)| {
                        format!(
                            "a fifth less depth at d = {} m, for {} times the stroke",
                            number(d),
                            number(ratio)
                        )
                    },
                )
            };
            let [sound, printed] = LAWS.map(price);
            both(
                told(sound),
                told(printed),
                trend_verdict(sound.is_some_and(|(_, ratio)| ratio < 1.5)),
                "the stroke contains d on both sides of neutral: depth is bought with several times the space",
            )
        },
    },
    Claim {
        id: "9.4a-levels",
        place: "9.3.3, Figure 9.4(a)",
        says: "depth grows with damping and levels off near 1000 N s/m",
        opens: Opens::Preset("figure-9.4"),
        check: |lab| {
            let property = |curve: &[P]| {
                let (first, later) =
                    (at(curve, 1000.0) - at(curve, 0.0), at(curve, 2000.0) - at(curve, 1000.0));
                rises(curve) && later < first / 3.0
            };
            lab.trend(
                (Percent, DAMPING),
                &damped(),
                property,
                "it grows all along, and half as fast beyond 1000: only the printed coupling makes it level off there",
            )
        },
    },
    Claim {
        id: "9.4b-levels",
        place: "9.3.3, Figure 9.4(b)",
        says: "the greatest displacement falls with damping and levels off near 300 N s/m",
        opens: Opens::Preset("figure-9.4"),
        check: |lab| {
            let axis = ("b", 20.0, 2000.0, 100);
            let property = |curve: &[P]| {
                falls(curve) && at(curve, 300.0) - at(curve, 2000.0) < 0.1 * range(curve)
            };
            lab.trend(
                (Travel, axis),
                &damped(),
                property,
                "it goes like momentum over b: where it levels off depends on how the figure is cut",
            )
        },
    },
    Claim {
        id: "9.4-adverse",
        place: "9.3.3",
        says: "damping is bad for penetration",
        opens: Opens::Preset("figure-9.4"),
        check: |lab| {
            let property = |curve: &[P]| at(curve, 1000.0) > 1.2 * at(curve, 0.0);
            lab.trend(
                (Percent, DAMPING),
                &damped(),
                property,
                "the damper holds the plate against the shot",
            )
        },
    },
    Claim {
        id: "9.4-caption",
        place: "Figure 9.4, caption",
        says: "k = 0 and n = 1",
        opens: Opens::Preset("figure-9.4"),
        check: |lab| {
            let shares = [0.1, 1.0, 3.0]
                .map(|n| lab.percent(Law::Sound, &with(&[("k", 0.0), ("b", 1000.0), ("n", n)])));
            found(
                format!(
                    "{}, {}, {} at n = 0.1, 1, 3 with b = 1000",
                    pc(shares[0]),
                    pc(shares[1]),
                    pc(shares[2])
                ),
                if range(&[(0.0, shares[0]), (1.0, shares[1]), (2.0, shares[2])]) < 1e-9 {
                    Verdict::Corrected
                } else {
                    Verdict::TrendFails
                },
                "a spring that is not there has no exponent: it changes nothing",
            )
        },
    },
    Claim {
        id: "9.5a-rises",
        place: "9.3.4, Figure 9.5(a)",
        says: "depth grows with the spring's stiffness",
        opens: Opens::Preset("figure-9.5"),
        check: |lab| {
            lab.trend(
                (Percent, SPRING),
                &gentle(),
                rises,
                "the stiffer mount is nearer to the rigid one",
            )
        },
    },
    Claim {
        id: "9.5a-force",
        place: "9.3.4",
        says: "a stiffer spring means greater contact forces",
        opens: Opens::Preset("figure-9.5"),
        check: |lab| {
            let peak = |law, k: f64| {
                lab.run(law, &with(&[("k", k)])).peak_contact_force_n.unwrap_or(f64::NAN) / 1e3
            };
            judged(
                "peak at k = 0, 1e6, 3e6, 7.5e6",
                "kN",
                LAWS.map(|law| [0.0, 1e6, 3e6, 7.5e6].map(|k| peak(law, k))),
                rising,
                "the deeper nose engages more area",
            )
        },
    },
    Claim {
        id: "9.5a-slower",
        place: "9.3.4",
        says: "stiffness costs less depth than damping does",
        opens: Opens::Preset("figure-9.5"),
        check: |lab| {
            let cost = |law| {
                [
                    range(&lab.curve(law, Percent, &gentle(), SPRING)),
                    range(&lab.curve(law, Percent, &damped(), DAMPING)),
                ]
            };
            let [sound, printed] = LAWS.map(cost);
            let told =
                |pair: [f64; 2]| format!("{} over all k, {} over all b", pc(pair[0]), pc(pair[1]));
            both(
                told(sound),
                told(printed),
                trend_verdict(sound[0] < sound[1]),
                "over the ranges of Table 9.2; they are arbitrary, and N/m and N s/m do not compare",
            )
        },
    },
    Claim {
        id: "9.5b-falls",
        place: "9.3.4, Figure 9.5(b)",
        says: "the greatest displacement falls with stiffness",
        opens: Opens::Preset("figure-9.5"),
        check: |lab| {
            lab.trend((Travel, SPRING), &gentle(), falls, "the same energy over a stiffer spring")
        },
    },
    Claim {
        id: "9.5-compete",
        place: "9.3.4",
        says: "depth and displacement pull in opposite directions",
        opens: Opens::Preset("figure-9.5"),
        check: |lab| {
            let depth = lab.curve(Law::Sound, Percent, &gentle(), SPRING);
            let travel = lab.curve(Law::Sound, Travel, &gentle(), SPRING);
            found(
                format!("{}; {}", ends(Percent, "k", &depth), ends(Travel, "k", &travel)),
                trend_verdict(rises(&depth) && falls(&travel)),
                "a stiffer spring stops the plate sooner, and holds it up",
            )
        },
    },
    Claim {
        id: "9.6-caption",
        place: "Figure 9.6, caption",
        says: "k = 1e5: the edge of depth is at n near 0.5",
        opens: Opens::Preset("figure-9.6"),
        check: |lab| {
            let edges = |law| [edge_at(lab, law, &gentle()), edge_at(lab, law, &stiff())];
            let [sound, printed] = LAWS.map(edges);
            let told = |pair: [f64; 2]| {
                format!("k = 1e5: edge at n = {}; k = 1e6: {}", number(pair[0]), number(pair[1]))
            };
            let near_half = |n: f64| (n - 0.5).abs() < 0.1;
            both(
                told(sound),
                told(printed),
                misprint_verdict(near_half(sound[0]), near_half(sound[1])),
                "the caption's k is ten times too small",
            )
        },
    },
    Claim {
        id: "9.6a-discontinuity",
        place: "9.3.4, Figure 9.6(a)",
        says: "an abrupt discontinuity at n near 0.5, of unknown cause",
        opens: Opens::Preset("figure-9.6"),
        check: |lab| {
            let steps = |law| {
                [45, 181, 721].map(|count| greatest_step(&edge_curve(lab, law, &stiff(), count)))
            };
            let sound = steps(Law::Sound);
            let printed = [45, 181]
                .map(|count| greatest_step(&edge_curve(lab, Law::Printed, &stiff(), count)));
            // A continuous curve's greatest step shrinks with the spacing; a jump's does not.
            let continuous = sound[1] < 0.5 * sound[0] && sound[2] < 0.5 * sound[1];
            let told = |steps: &[f64]| {
                steps.iter().map(|step| number(*step)).collect::<Vec<_>>().join(", ")
            };
            both(
                format!("greatest step with dn = 0.02, 0.005, 0.00125: {} %", told(&sound)),
                format!("with dn = 0.02, 0.005: {} %", told(&printed)),
                if continuous { Verdict::Corrected } else { Verdict::TrendHolds },
                "a steep smooth edge, no jump: there k x^n at the plate's natural millimetre equals the contact force, \
                        and below it the spring holds the plate like a rigid mount",
            )
        },
    },
    Claim {
        id: "9.6a-force",
        place: "9.3.4, Figure 9.6(a)",
        says: "low exponents act like a very stiff spring",
        opens: Opens::Preset("figure-9.6"),
        check: |lab| {
            let edge_n = edge_at(lab, Law::Sound, &stiff());
            let natural = lab
                .run(Law::Sound, &with(&[("k", 0.0)]))
                .first_arrest
                .map_or(f64::NAN, |arrest| arrest.plate_displacement_m);
            let force = 1e6 * natural.powf(edge_n);
            let low = lab.percent(Law::Sound, &with(&[("k", 1e6), ("n", 0.2)]));
            both(
                format!(
                    "{} at n = 0.2; at the edge k x^n = {} kN for x = {} mm",
                    pc(low),
                    number(force / 1e3),
                    number(1e3 * natural)
                ),
                pc(lab.percent(Law::Printed, &with(&[("k", 1e6), ("n", 0.2)]))),
                trend_verdict(low > 98.0 && (5e3..80e3).contains(&force)),
                "the contact force is about 19 kN: the edge is where the spring's equals it",
            )
        },
    },
    Claim {
        id: "9.6a-levels",
        place: "9.3.4, Figure 9.6(a)",
        says: "depth levels off at n near 1 and does not change beyond 1.5",
        opens: Opens::Preset("figure-9.6"),
        check: |lab| {
            let property = |curve: &[P]| {
                let whole = range(curve);
                at(curve, 1.0) - at(curve, 1.5) < 0.15 * whole
                    && (at(curve, 1.5) - at(curve, 3.0)).abs() < 0.01 * whole
            };
            lab.trend(
                (Percent, EXPONENT),
                &stiff(),
                property,
                "with k = 1e6; x is in metres, so k x^n of a millimetre vanishes for n > 1: an artefact of the unit",
            )
        },
    },
    Claim {
        id: "9.6a-soft",
        place: "9.3.4",
        says: "with an exponent above one the spring's force is very low for travels below a metre",
        opens: Opens::Preset("figure-9.6"),
        check: |lab| {
            let force = |n: f64| {
                let run = lab.run(Law::Sound, &with(&[("k", 1e6), ("n", n)]));
                run.first_arrest.map_or(f64::NAN, |it| 1e6 * it.plate_displacement_m.powf(n))
            };
            let values = [0.5, 1.0, 1.5, 3.0].map(force);
            found(
                format!("at first arrest, n = 0.5, 1, 1.5, 3: {}", list(&values, "N")),
                trend_verdict(falling(&values) && values[2] < 200.0),
                "beside a contact force of 18 kN: an artefact of the metre (row 9.5.1-normalised)",
            )
        },
    },
    Claim {
        id: "9.6b-rises",
        place: "9.3.4, Figure 9.6(b)",
        says: "the greatest displacement grows with the exponent",
        opens: Opens::Preset("figure-9.6"),
        check: |lab| {
            lab.trend(
                (Travel, EXPONENT),
                &stiff(),
                rises,
                "below a metre the higher power is the softer spring",
            )
        },
    },
];
