//! Claims of section 9.3.5: cocking together with mass ratio, stiffness or exponent, over their figures' ranges.

use crate::numerics::larger;
use crate::study::thesis::lab::Measure::{Percent, Travel};
use crate::study::thesis::lab::{
    Axis, LAWS, Lab, Law, both, found, number, number_verdict, trend_verdict, with,
};
use crate::study::thesis::shape::{curvature, edge, falls, rises, slope};
use crate::study::thesis::spread::{falling, greater, judged, list, ranges, rising};
use crate::study::thesis::{Claim, Found, Opens, Verdict};

const GAMMA: Axis = ("gamma", 0.8, 7.0, 9);
const SPRING: Axis = ("k", 0.0, 7.5e6, 9);
const EXPONENT: Axis = ("n", 0.1, 3.0, 15);
const COCKING: Axis = ("d", 0.0, 0.5, 11);

/// Slopes of the greatest displacement over the cocking distance, for three or four values of another variable: over the
/// whole range of Table 9.2, by which the claim is judged, and without its first part, where the shot's own energy counts.
fn slopes<const M: usize>(
    lab: &Lab,
    (name, values): (&'static str, [f64; M]),
    property: impl Fn(&[f64]) -> bool,
    cause: &'static str,
) -> Found {
    let over = |law, from| {
        values.map(|value| {
            let curve = lab.curve(law, Travel, &with(&[(name, value)]), ("d", from, 0.5, 9));
            1e-3 * slope(&curve)
        })
    };
    let told = |law| {
        format!(
            "slope at {name} = {}: {} over d = 0 to 0.5 m, {} from 0.1 m on",
            values.map(number).join(", "),
            list(&over(law, 0.0), "m/m"),
            list(&over(law, 0.1), "m/m")
        )
    };
    let verdict = if property(&over(Law::Sound, 0.0)) {
        Verdict::TrendHolds
    } else {
        number_verdict(false, property(&over(Law::Sound, 0.1)))
    };
    both(told(Law::Sound), told(Law::Printed), verdict, cause)
}

/// Slopes that do not depend on the other variable, within a tenth of 1 m/m.
fn alike(values: &[f64]) -> bool {
    values.iter().all(|it| (it - 1.0).abs() < 0.1)
}

pub(super) static CLAIMS: &[Claim] = &[
    Claim {
        id: "9.10a-falls",
        place: "9.3.5, Figure 9.10(a)",
        says: "cocking cuts depth at every mass ratio",
        opens: Opens::Preset("figure-9.10"),
        check: |lab| {
            let all = [0.8, 1.5, 3.0, 5.0, 7.0]
                .map(|gamma| lab.curve(Law::Sound, Percent, &with(&[("gamma", gamma)]), COCKING));
            let last = all.each_ref().map(|curve| curve.last().map_or(f64::NAN, |point| point.1));
            found(
                format!("at d = 0.5 and gamma = 0.8, 1.5, 3, 5, 7: {}", list(&last, "%")),
                trend_verdict(all.iter().all(|curve| falls(curve))),
                "the spring pulls every plate away, the heavy ones less",
            )
        },
    },
    Claim {
        id: "9.10a-light",
        place: "9.3.5, Figure 9.10(a)",
        says: "cocking matters more to depth at low mass ratios",
        opens: Opens::Preset("figure-9.10"),
        check: |lab| {
            let values = LAWS
                .map(|law| ranges((lab, law, Percent), &[], COCKING, ("gamma", [0.8, 2.0, 7.0])));
            judged(
                "change over d at gamma = 0.8, 2, 7",
                "%",
                values,
                falling,
                "the light plate is the quicker one",
            )
        },
    },
    Claim {
        id: "9.10a-gamma",
        place: "9.3.5, Figure 9.10(a)",
        says: "depth is generally more sensitive to the mass ratio than to cocking",
        opens: Opens::Preset("figure-9.10"),
        check: |lab| {
            let mean = |values: [f64; 3]| values.iter().sum::<f64>() / 3.0;
            let values = LAWS.map(|law| {
                [
                    mean(ranges((lab, law, Percent), &[], GAMMA, ("d", [0.0, 0.25, 0.5]))),
                    mean(ranges((lab, law, Percent), &[], COCKING, ("gamma", [0.8, 2.0, 7.0]))),
                ]
            });
            greater("mean change over gamma, over d", values, "over the figure's ranges")
        },
    },
    Claim {
        id: "9.10b-slope",
        place: "9.3.5, Figure 9.10(b)",
        says: "displacement goes with cocking alike at every mass ratio",
        opens: Opens::Preset("figure-9.10"),
        check: |lab| {
            slopes(
                lab,
                ("gamma", [0.8, 2.0, 7.0]),
                alike,
                "the plate passes neutral and travels as far as it was cocked",
            )
        },
    },
    Claim {
        id: "9.10b-gamma",
        place: "9.3.5, Figure 9.10(b)",
        says: "the mass ratio moves displacement less at greater cocking",
        opens: Opens::Preset("figure-9.10"),
        check: |lab| {
            let values =
                LAWS.map(|law| ranges((lab, law, Travel), &[], GAMMA, ("d", [0.0, 0.1, 0.5])));
            judged(
                "spread over gamma at d = 0, 0.1, 0.5",
                "mm",
                values,
                falling,
                "the stored energy does not depend on it",
            )
        },
    },
    Claim {
        id: "9.10b-orders",
        place: "9.3.5, Figure 9.10(b)",
        says: "cocking makes displacement orders of magnitude greater",
        opens: Opens::Preset("figure-9.10"),
        check: |lab| {
            let ratio = |law| {
                [0.8, 1.0, 7.0].map(|gamma| {
                    let at = |d| lab.travel_mm(law, &with(&[("gamma", gamma), ("d", d)]));
                    at(0.5) / at(0.0)
                })
            };
            let property = |values: &[f64]| values.iter().copied().fold(0.0, larger) >= 100.0;
            judged(
                "d = 0.5 over d = 0 at gamma = 0.8, 1, 7",
                "times",
                LAWS.map(ratio),
                property,
                "one order of magnitude, not several",
            )
        },
    },
    Claim {
        id: "9.11a-similar",
        place: "9.3.5, Figure 9.11(a)",
        says: "cocking and stiffness have similar effects on depth",
        opens: Opens::Preset("figure-9.11"),
        check: |lab| {
            let mean = |values: [f64; 3]| values.iter().sum::<f64>() / 3.0;
            let values = LAWS.map(|law| {
                [
                    mean(ranges((lab, law, Percent), &[], COCKING, ("k", [1e5, 2e6, 7.5e6]))),
                    mean(ranges(
                        (lab, law, Percent),
                        &[],
                        ("k", 0.0, 7.5e6, 9),
                        ("d", [0.1, 0.25, 0.5]),
                    )),
                ]
            });
            let property = |pair: &[f64]| (0.5..2.0).contains(&(pair[0] / pair[1]));
            judged(
                "mean change over d, over k (cocked)",
                "%",
                values,
                property,
                "over the figure's ranges; both act by the preload k d",
            )
        },
    },
    Claim {
        id: "9.11a-linear",
        place: "9.3.5, Figure 9.11(a)",
        says: "depth falls nearly linearly with cocking for a soft spring, ever more sharply for a stiff one",
        opens: Opens::Preset("figure-9.11"),
        check: |lab| {
            let bend = |law| {
                [1e4, 1e5, 1e6, 7.5e6].map(|k| {
                    curvature(&lab.curve(law, Percent, &with(&[("k", k)]), ("d", 0.0, 0.5, 26)))
                })
            };
            let property = |values: &[f64]| values[0] < 0.1 && rising(values);
            judged(
                "distance from a straight line at k = 1e4, 1e5, 1e6, 7.5e6",
                "of the range",
                LAWS.map(bend),
                property,
                "a stiff spring has done its work after a short draw",
            )
        },
    },
    Claim {
        id: "9.11a-uncocked",
        place: "9.3.5, Figure 9.11(a)",
        says: "without cocking the coefficient has little influence on depth",
        opens: Opens::Preset("figure-9.11"),
        check: |lab| {
            let values =
                LAWS.map(|law| ranges((lab, law, Percent), &[], SPRING, ("d", [0.0, 0.5])));
            judged(
                "change over k at d = 0, 0.5",
                "%",
                values,
                |pair| pair[0] < 15.0 && pair[0] < 0.5 * pair[1],
                "the spring has not moved yet when the contact is over",
            )
        },
    },
    Claim {
        id: "9.11a-cocked",
        place: "9.3.5, Figure 9.11(a)",
        says: "cocked but a little, a stiffer spring means less depth",
        opens: Opens::Preset("figure-9.11"),
        check: |lab| {
            lab.trend(
                (Percent, ("k", 0.0, 7.5e6, 16)),
                &with(&[("d", 0.05)]),
                falls,
                "the preload k d pulls the plate away from the shot",
            )
        },
    },
    Claim {
        id: "9.11a-sooner",
        place: "9.3.5, Figure 9.11(a)",
        says: "a stiffer cocked spring lowers the contact force and brings common velocity sooner",
        opens: Opens::Preset("figure-9.11"),
        check: |lab| {
            let at = |k: f64| {
                let run = lab.run(Law::Sound, &with(&[("d", 0.1), ("k", k)]));
                let t_s = run.first_arrest.map_or(f64::NAN, |arrest| arrest.t_s);
                (1e-3 * run.peak_contact_force_n.unwrap_or(f64::NAN), 1e6 * t_s)
            };
            let values = [0.0, 1e5, 1e6, 7.5e6].map(at);
            let (forces, times) = (values.map(|it| it.0), values.map(|it| it.1));
            found(
                format!(
                    "d = 0.1, k = 0, 1e5, 1e6, 7.5e6: peak {}, common velocity after {}",
                    list(&forces, "kN"),
                    list(&times, "us")
                ),
                trend_verdict(falling(&forces) && falling(&times)),
                "assumed there, and so it is: spring and shot push the plate the same way",
            )
        },
    },
    Claim {
        id: "9.11b-slope",
        place: "9.3.5, Figure 9.11(b)",
        says: "displacement goes with cocking alike for every stiffness",
        opens: Opens::Preset("figure-9.11"),
        check: |lab| {
            slopes(
                lab,
                ("k", [1e5, 1e6, 7.5e6]),
                alike,
                "the plate passes neutral and travels as far as it was cocked, whatever the spring",
            )
        },
    },
    Claim {
        id: "9.12a-plateau",
        place: "9.3.5, Figure 9.12(a)",
        says: "uncocked, the plateau of Figure 9.6(a) at low exponents is there again",
        opens: Opens::Preset("figure-9.12"),
        check: |lab| {
            let curve = |law| lab.curve(law, Percent, &with(&[]), ("n", 0.1, 1.0, 46));
            let told = |curve: &[super::lab::P]| {
                format!("edge at n = {}", edge(curve).map_or_else(|| "none".to_owned(), number))
            };
            let [sound, printed] = LAWS.map(curve);
            let flat = sound.first().is_some_and(|point| point.1 > 99.0);
            both(
                told(&sound),
                told(&printed),
                trend_verdict(flat && edge(&sound).is_some()),
                "for k = 1e5 it ends at n near 0.3, not at the 0.5 of Figure 9.6(a)",
            )
        },
    },
    Claim {
        id: "9.12a-falls",
        place: "9.3.5, Figure 9.12(a)",
        says: "cocked, a lower exponent means much less depth",
        opens: Opens::Preset("figure-9.12"),
        check: |lab| {
            lab.trend(
                (Percent, ("n", 0.1, 3.0, 16)),
                &with(&[("d", 0.25)]),
                rises,
                "below a metre the lower power is the stronger spring, here pulling the plate away",
            )
        },
    },
    Claim {
        id: "9.12b-slope",
        place: "9.3.5, Figure 9.12(b)",
        says: "displacement goes with cocking alike for every exponent",
        opens: Opens::Preset("figure-9.12"),
        check: |lab| {
            slopes(
                lab,
                ("n", [0.5, 1.0, 2.0, 3.0]),
                |values| values.iter().all(|slope| (0.7..1.3).contains(slope)),
                "the plate passes neutral and travels as far as it was cocked: fairly so from 0.1 m on, less over the whole range, where a high exponent \
                 makes the spring soft",
            )
        },
    },
    Claim {
        id: "9.12b-spread",
        place: "9.3.5, Figure 9.12(b)",
        says: "the exponent moves displacement less at greater cocking",
        opens: Opens::Preset("figure-9.12"),
        check: |lab| {
            let values =
                LAWS.map(|law| ranges((lab, law, Travel), &[], EXPONENT, ("d", [0.0, 0.1, 0.5])));
            judged(
                "spread over n at d = 0, 0.1, 0.5",
                "mm",
                values,
                falling,
                "the energy drawn in outweighs the shot's",
            )
        },
    },
];
