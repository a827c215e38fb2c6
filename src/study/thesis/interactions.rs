//! Claims of section 9.3.5: mass ratio, spring coefficient and exponent, two at a time, over their figures' ranges.

use crate::model::scene::Scene;
use crate::study::thesis::lab::Measure::{Percent, Travel};
use crate::study::thesis::lab::{
    Axis, LAWS, Law, both, found, misprint_verdict, number, pc, trend_verdict, with,
};
use crate::study::thesis::shape::{edge, range, rises};
use crate::study::thesis::spread::{falling, greater, judged, list, ranges, rising};
use crate::study::thesis::{Claim, Opens};

const GAMMA: Axis = ("gamma", 0.8, 7.0, 9);
const SPRING: Axis = ("k", 0.0, 7.5e6, 9);
const EXPONENT: Axis = ("n", 0.1, 3.0, 15);

fn stiff() -> Scene {
    with(&[("k", 1e6)])
}

pub(super) static CLAIMS: &[Claim] = &[
    Claim {
        id: "9.7a-gamma",
        place: "9.3.5, Figure 9.7(a)",
        says: "less mass helps depth more than less stiffness does",
        opens: Opens::Preset("figure-9.7"),
        check: |lab| {
            let values = LAWS.map(|law| {
                [
                    range(&lab.curve(law, Percent, &with(&[]), GAMMA)),
                    range(&lab.curve(law, Percent, &with(&[]), SPRING)),
                ]
            });
            greater("change over all gamma, over all k", values, "over the ranges of Table 9.2")
        },
    },
    Claim {
        id: "9.7b-word",
        place: "9.3.5, Figure 9.7(b)",
        says: "penetration is about equally sensitive to mass ratio and stiffness",
        opens: Opens::Preset("figure-9.7"),
        check: |lab| {
            let ratio = |measure, scene: &Scene| {
                let gamma = range(&lab.curve(Law::Sound, measure, scene, GAMMA));
                gamma / range(&lab.curve(Law::Sound, measure, scene, ("k", 1e5, 7.5e6, 9)))
            };
            let (depth, travel) = (ratio(Percent, &with(&[])), ratio(Travel, &with(&[])));
            let equal = |ratio: f64| (0.5..2.0).contains(&ratio);
            found(
                format!(
                    "gamma's part over k's: depth {}, displacement {}",
                    number(depth),
                    number(travel)
                ),
                misprint_verdict(equal(depth), equal(travel)),
                "the figure shows displacement; that is what is meant, and so it is",
            )
        },
    },
    Claim {
        id: "9.7b-gamma",
        place: "9.3.5, Figure 9.7(b)",
        says: "the mass ratio moves displacement less as the spring stiffens",
        opens: Opens::Preset("figure-9.7"),
        check: |lab| {
            let values =
                LAWS.map(|law| ranges((lab, law, Travel), &[], GAMMA, ("k", [1e5, 1e6, 7.5e6])));
            judged(
                "spread over gamma at k = 1e5, 1e6, 7.5e6",
                "mm",
                values,
                falling,
                "the whole oscillation shrinks",
            )
        },
    },
    Claim {
        id: "9.7b-k",
        place: "9.3.5, Figure 9.7(b)",
        says: "stiffness moves displacement more at low mass ratios",
        opens: Opens::Preset("figure-9.7"),
        check: |lab| {
            let axis = ("k", 1e5, 7.5e6, 9);
            let values =
                LAWS.map(|law| ranges((lab, law, Travel), &[], axis, ("gamma", [0.8, 2.0, 7.0])));
            judged(
                "spread over k at gamma = 0.8, 2, 7",
                "mm",
                values,
                falling,
                "the lighter plate carries more energy",
            )
        },
    },
    Claim {
        id: "9.8a-low",
        place: "9.3.5, Figure 9.8(a)",
        says: "below n = 0.5 even a low mass ratio hardly helps (k = 1e5)",
        opens: Opens::Preset("figure-9.8"),
        check: |lab| {
            let at = |law, k| lab.percent(law, &with(&[("gamma", 0.8), ("n", 0.45), ("k", k)]));
            let told = |law| {
                format!(
                    "gamma = 0.8, n = 0.45: {} at k = 1e5, {} at 1e6",
                    pc(at(law, 1e5)),
                    pc(at(law, 1e6))
                )
            };
            let little = |percent: f64| percent > 90.0;
            both(
                told(Law::Sound),
                told(Law::Printed),
                misprint_verdict(little(at(Law::Sound, 1e5)), little(at(Law::Sound, 1e6))),
                "true of k = 1e6, as in Figure 9.6; at the caption's k the plate has long been let go",
            )
        },
    },
    Claim {
        id: "9.8a-high",
        place: "9.3.5, Figure 9.8(a)",
        says: "above n = 0.5 the mass ratio matters more to depth than the exponent",
        opens: Opens::Preset("figure-9.8"),
        check: |lab| {
            let axis = ("n", 0.6, 3.0, 13);
            let values = LAWS.map(|law| {
                [
                    range(&lab.curve(law, Percent, &with(&[]), GAMMA)),
                    range(&lab.curve(law, Percent, &with(&[]), axis)),
                ]
            });
            greater(
                "change over all gamma, over n from 0.6",
                values,
                "there the spring is nearly absent",
            )
        },
    },
    Claim {
        id: "9.8b-spread",
        place: "9.3.5, Figure 9.8(b)",
        says: "the mass ratio moves displacement more at high exponents",
        opens: Opens::Preset("figure-9.8"),
        check: |lab| {
            let values =
                LAWS.map(|law| ranges((lab, law, Travel), &[], GAMMA, ("n", [0.5, 1.0, 2.0, 3.0])));
            judged(
                "spread over gamma at n = 0.5, 1, 2, 3",
                "mm",
                values,
                rising,
                "softer springs, longer oscillations",
            )
        },
    },
    Claim {
        id: "9.8b-rises",
        place: "9.3.5, Figure 9.8(b)",
        says: "displacement grows with the exponent at every mass ratio",
        opens: Opens::Preset("figure-9.8"),
        check: |lab| {
            let curves = [0.8, 2.0, 7.0]
                .map(|gamma| lab.curve(Law::Sound, Travel, &with(&[("gamma", gamma)]), EXPONENT));
            let last = |curve: &[super::lab::P]| curve.last().map_or(f64::NAN, |point| point.1);
            found(
                format!(
                    "at n = 3 and gamma = 0.8, 2, 7: {}",
                    list(&[last(&curves[0]), last(&curves[1]), last(&curves[2])], "mm")
                ),
                trend_verdict(curves.iter().all(|curve| rises(curve))),
                "below a metre the higher power is the softer spring",
            )
        },
    },
    Claim {
        id: "9.9a-plateau",
        place: "9.3.5, Figure 9.9(a)",
        says: "the plateau at low exponents narrows as the coefficient falls",
        opens: Opens::Preset("figure-9.9"),
        check: |lab| {
            let edges = |law| {
                [1e5, 1e6, 7.5e6].map(|k| {
                    let curve = lab.curve(law, Percent, &with(&[("k", k)]), ("n", 0.1, 1.5, 57));
                    edge(&curve).unwrap_or(f64::NAN)
                })
            };
            judged(
                "edge at k = 1e5, 1e6, 7.5e6",
                "",
                LAWS.map(edges),
                rising,
                "a weaker spring holds the plate only at a lower power",
            )
        },
    },
    Claim {
        id: "9.9a-gamma",
        place: "9.3.5, Figure 9.9(a)",
        says: "depth is sensitive to the exponent up to gamma = 1.5",
        opens: Opens::Preset("figure-9.9"),
        check: |lab| {
            let part =
                |from, to| range(&lab.curve(Law::Sound, Percent, &stiff(), ("n", from, to, 9)));
            let (below, beyond) = (part(0.4, 1.5), part(1.5, 3.0));
            found(
                format!(
                    "change over n from 0.4 to 1.5: {}, from 1.5 to 3: {}",
                    pc(below),
                    pc(beyond)
                ), // The figure is drawn at one mass ratio: as written the sentence has no subject.
                misprint_verdict(GAMMA.0 == EXPONENT.0, below > 10.0 * beyond),
                "n = 1.5 is meant: gamma is 1 throughout the figure",
            )
        },
    },
    Claim {
        id: "9.9b-low",
        place: "9.3.5, Figure 9.9(b)",
        says: "displacement depends on the coefficient the more the higher the exponent",
        opens: Opens::Preset("figure-9.9"),
        check: |lab| {
            let axis = ("k", 1e5, 7.5e6, 9);
            let values =
                LAWS.map(|law| ranges((lab, law, Travel), &[], axis, ("n", [0.3, 1.0, 2.0, 3.0])));
            judged(
                "spread over k at n = 0.3, 1, 2, 3",
                "mm",
                values,
                rising,
                "in millimetres; relative to its size it is the reverse",
            )
        },
    },
    Claim {
        id: "9.9b-soft",
        place: "9.3.5, Figure 9.9(b)",
        says: "the exponent moves displacement more at low coefficients",
        opens: Opens::Preset("figure-9.9"),
        check: |lab| {
            let axis = ("n", 0.5, 3.0, 11);
            let values =
                LAWS.map(|law| ranges((lab, law, Travel), &[], axis, ("k", [1e5, 1e6, 7.5e6])));
            judged(
                "spread over n at k = 1e5, 1e6, 7.5e6",
                "mm",
                values,
                falling,
                "softer springs, longer oscillations",
            )
        },
    },
    Claim {
        id: "9.9b-largest",
        place: "9.3.5, Figure 9.9(b)",
        says: "displacement is largest where the coefficient is low and the coefficient is high",
        opens: Opens::Preset("figure-9.9"),
        check: |lab| {
            let mut best = (0.0, 0.0, 0.0);
            for k in [1e5, 2e6, 7.5e6] {
                for n in [0.3, 1.0, 3.0] {
                    let travel = lab.travel_mm(Law::Sound, &with(&[("k", k), ("n", n)]));
                    best = if travel > best.0 { (travel, k, n) } else { best };
                }
            }
            let (travel, k, n) = best;
            let meant = k < 2e5 && n > 2.5;
            found(
                format!("largest, {} mm, at k = {}, n = {}", number(travel), number(k), number(n)),
                misprint_verdict(!meant, meant),
                "the exponent is meant: one coefficient cannot be both",
            )
        },
    },
];
