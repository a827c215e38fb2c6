//! Claims of the figures of chapter 9 and the advice of section 9.6.

use super::ClaimVerdict::{Corrected, Misprint, NotReproduced, Reproduced};
use super::{Check, Claim, Curve, Range, claim, four, list, range};

const GAMMA: Range = range("gamma", 0.8, 7.0, 32);
const FEW_GAMMAS: Range = range("gamma", 0.8, 7.0, 9);
const COCKING: Range = range("d", 0.0, 0.5, 26);
const DAMPING: Range = range("b", 0.0, 2000.0, 21);
const STIFFNESS: Range = range("k", 0.0, 7.5e6, 26);
const FEW_STIFFNESSES: Range = range("k", 1e5, 7.5e6, 9);
const EXPONENT: Range = range("n", 0.1, 3.0, 30);
const HIGH_EXPONENT: Range = range("n", 0.5, 3.0, 26);
const LOW_EXPONENT: Range = range("n", 0.1, 1.0, 46);

pub(super) const CLAIMS: &[Claim] = &[
    claim(
        ("9.2a", "9.3.1, Figure 9.2(a)", Reproduced, Some("figure-9.2")),
        "depth grows with the mass ratio, ever less steeply; a very low one cuts it significantly",
        "the heavier plate accelerates more slowly; the printed coupling hides half of the gain",
        |shots| {
            let curve = shots.depths("", &GAMMA);
            curve.that(|it| it.rises() && it.flattens() && it.at(0.8) < 75.0)
        },
    ),
    claim(
        ("9.2b", "9.3.1, Figure 9.2(b)", Reproduced, Some("figure-9.2")),
        "the greatest displacement falls with the mass ratio",
        "the heavier body starts more slowly, with less energy",
        |shots| shots.travels("", &GAMMA).that(Curve::falls),
    ),
    claim(
        ("9.3a", "9.3.2, Figure 9.3(a)", Reproduced, Some("figure-9.3")),
        "depth falls with the cocking distance",
        "the cocked spring pulls the plate away from the shot",
        |shots| shots.depths("", &COCKING).that(Curve::falls),
    ),
    claim(
        ("9.3b", "9.3.2, Figure 9.3(b)", Reproduced, Some("figure-9.3")),
        "the greatest displacement grows with cocking, nearly linearly at 1 m/m",
        "the stored energy exceeds that of the projectile: the plate passes neutral and goes as far again",
        |shots| {
            let curve = shots.travels("", &COCKING);
            let slope = curve.slope() / 1e3;
            Check::new("slope", &[slope], "m/m", curve.rises() && (slope - 1.0).abs() < 0.1)
        },
    ),
    claim(
        ("9.4a", "9.3.3, Figure 9.4(a)", NotReproduced, Some("figure-9.4")),
        "depth grows with damping and levels off near 1000 N s/m",
        "it grows all along; only the printed coupling makes it level off there",
        |shots| {
            let at = |curve: &Curve| [0.0, 1000.0, 2000.0].map(|b| curve.at(b));
            let levels = |[none, middle, most]: [f64; 3]| most - middle < (middle - none) / 3.0;
            let curve = shots.depths("k=0", &DAMPING);
            let printed = at(&shots.printed().depths("k=0", &DAMPING));
            let holds = curve.rises() && !levels(at(&curve)) && levels(printed);
            Check::new("b = 0, 1000, 2000:", &at(&curve), "%", holds)
        },
    ),
    claim(
        ("9.4b", "9.3.3, Figure 9.4(b)", Reproduced, Some("figure-9.4")),
        "the greatest displacement falls with damping and levels off near 300 N s/m",
        "it goes as momentum over b: where it levels off depends on the range of the figure",
        |shots| {
            let curve = shots.travels("k=0", &range("b", 20.0, 2000.0, 100));
            curve.that(|it| it.falls() && it.at(300.0) - it.at(2000.0) < 0.1 * it.span())
        },
    ),
    claim(
        ("9.5a", "9.3.4, Figure 9.5(a)", Reproduced, Some("figure-9.5")),
        "depth grows with the spring's stiffness",
        "the stiffer mount is nearer to the rigid one",
        |shots| shots.depths("", &STIFFNESS).that(Curve::rises),
    ),
    claim(
        ("9.5b", "9.3.4, Figure 9.5(b)", Reproduced, Some("figure-9.5")),
        "the greatest displacement falls with stiffness",
        "the same energy in a stiffer spring",
        |shots| shots.travels("", &STIFFNESS).that(Curve::falls),
    ),
    claim(
        ("9.5a-damping", "9.3.4, Figure 9.5(a)", Reproduced, Some("figure-9.5")),
        "depth grows more slowly with the spring's coefficient than with the damper's",
        "over the ranges of Table 9.2",
        |shots| {
            let spans = [shots.depths("k=0", &DAMPING).span(), shots.depths("", &STIFFNESS).span()];
            Check::new("change over all b, over all k:", &spans, "%", spans[0] > spans[1])
        },
    ),
    claim(
        ("9.6a-edge", "9.3.4, Figure 9.6(a)", NotReproduced, Some("figure-9.6")),
        "at k = 1e5 depth drops at n near 0.5",
        "0.5 lies between the edges at k = 1e5 and at 1e6. That the figure was made with 1e6 is an inference, \
                from the levelling near n = 1 and from Figure 9.8",
        |shots| {
            let edges = ["k=1e5", "k=1e6"].map(|k| shots.depths(k, &LOW_EXPONENT).edge());
            let [low, high] = edges.map(four);
            let text = format!("half way down at n = {low} with k = 1e5, at {high} with 1e6");
            Check { text, holds: edges[0] < 0.4 && edges[1] > 0.5 }
        },
    ),
    claim(
        ("9.6a-discontinuity", "9.3.4, Figure 9.6(a)", Corrected, Some("figure-9.6")),
        "the drop is an abrupt discontinuity of unknown cause",
        "a steep, smooth edge: there k x^n at the plate's natural millimetre equals the contact force, and below it the \
                spring holds the plate as a rigid mount does",
        |shots| {
            // The largest step of a continuous curve decreases with the spacing; that of a discontinuity does not.
            let step = |count| shots.depths("k=1e6", &range("n", 0.4, 0.9, count)).step();
            let steps = [26, 101, 401].map(step);
            let unit = "% with dn = 0.02, 0.005, 0.00125";
            let holds = steps[1] < 0.5 * steps[0] && steps[2] < 0.5 * steps[1];
            Check::new("k = 1e6: greatest step", &steps, unit, holds)
        },
    ),
    claim(
        ("9.6a-levels", "9.3.4, Figure 9.6(a)", Reproduced, Some("figure-9.6")),
        "depth begins to level off at n near 1 and does not change beyond 1.5",
        "with k = 1e6; x is in metres, so that k x^n of a millimetre vanishes for n > 1",
        |shots| {
            let curve = shots.depths("k=1e6", &EXPONENT);
            let values = [0.1, 1.0, 1.5, 3.0].map(|n| curve.at(n));
            let [_, one, more, most] = values;
            let holds =
                one - more < 0.15 * curve.span() && (more - most).abs() < 0.01 * curve.span();
            Check::new("k = 1e6, n = 0.1, 1, 1.5, 3:", &values, "%", holds)
        },
    ),
    claim(
        ("9.6b", "9.3.4, Figure 9.6(b)", Reproduced, Some("figure-9.6")),
        "the greatest displacement grows with the exponent",
        "below a metre the higher power is the softer spring",
        |shots| shots.travels("", &EXPONENT).that(Curve::rises),
    ),
    claim(
        ("9.7a", "9.3.5, Figure 9.7(a)", Reproduced, Some("figure-9.7")),
        "less mass helps depth more than less stiffness does",
        "over the ranges of Table 9.2",
        |shots| {
            let mass = shots.depths("", &FEW_GAMMAS).span();
            let stiffness = shots.depths("", &FEW_STIFFNESSES).span();
            let spans = [mass, stiffness];
            Check::new("change over all gamma, over all k:", &spans, "%", mass > stiffness)
        },
    ),
    claim(
        ("9.7b", "9.3.5, Figure 9.7(b)", Misprint, Some("figure-9.7")),
        "penetration is about equally sensitive to mass ratio and stiffness",
        "the figure shows displacement, which is meant",
        |shots| {
            let over = [FEW_GAMMAS, FEW_STIFFNESSES];
            let [gamma, k] = over.each_ref().map(|range| shots.depths("", range).span());
            let depth = gamma / k;
            let [gamma, k] = over.each_ref().map(|range| shots.travels("", range).span());
            let travel = gamma / k;
            let holds = depth > 2.0 && (0.5..2.0).contains(&travel);
            let [depth, travel] = [depth, travel].map(four);
            let text =
                format!("change over gamma by that over k: depth {depth}, displacement {travel}");
            Check { text, holds }
        },
    ),
    claim(
        ("9.7b-interaction", "9.3.5, Figure 9.7(b)", Reproduced, Some("figure-9.7")),
        "the mass ratio has less effect on displacement as the coefficient grows, and the coefficient as the mass ratio grows",
        "a stiff spring stops every plate early, and a heavy plate moves little on any spring",
        |shots| {
            let over_gamma =
                ["k=1e5", "k=1e6", "k=7.5e6"].map(|k| shots.travels(k, &FEW_GAMMAS).span());
            let over_k = ["gamma=0.8", "gamma=2", "gamma=7"]
                .map(|gamma| shots.travels(gamma, &FEW_STIFFNESSES).span());
            let falls = |spans: &[f64]| spans.is_sorted_by(|a, b| a > b);
            let holds = falls(&over_gamma) && falls(&over_k);
            let [over_gamma, over_k] = [over_gamma, over_k].map(|spans| list(&spans, "mm"));
            let text = format!(
                "change over gamma at k = 1e5, 1e6, 7.5e6: {over_gamma}; over k at gamma = 0.8, 2, 7: {over_k}"
            );
            Check { text, holds }
        },
    ),
    claim(
        ("9.8a", "9.3.5, Figure 9.8(a)", NotReproduced, Some("figure-9.8")),
        "at k = 1e5 and below n = 0.5 even a low mass ratio hardly helps",
        "so it is at k = 1e6: at the k of the caption the spring is already too soft",
        |shots| {
            let depths =
                ["k=1e5", "k=1e6"].map(|k| shots.percent(&format!("gamma=0.8 n=0.45 {k}")));
            let holds = depths[0] < 90.0 && depths[1] > 90.0;
            Check::new("gamma = 0.8, n = 0.45, k = 1e5, 1e6:", &depths, "%", holds)
        },
    ),
    claim(
        ("9.8a-mass", "9.3.5, Figure 9.8(a)", Reproduced, Some("figure-9.8")),
        "above n = 0.5 the mass ratio has more effect on depth than the exponent",
        "at the k of the caption; at k = 1e6 the drop lies above n = 0.5, and the exponent has more effect on a light plate",
        |shots| {
            let over_gamma = ["n=0.5", "n=1", "n=3"].map(|n| shots.depths(n, &FEW_GAMMAS).span());
            let over_n = ["gamma=0.8", "gamma=2", "gamma=7"]
                .map(|gamma| shots.depths(gamma, &HIGH_EXPONENT).span());
            let holds = over_gamma.iter().all(|gamma| over_n.iter().all(|n| gamma > n));
            let [over_gamma, over_n] = [over_gamma, over_n].map(|spans| list(&spans, "%"));
            let text = format!(
                "change over gamma at n = 0.5, 1, 3: {over_gamma}; over n at gamma = 0.8, 2, 7: {over_n}"
            );
            Check { text, holds }
        },
    ),
    claim(
        ("9.8b", "9.3.5, Figure 9.8(b)", Reproduced, Some("figure-9.8")),
        "the mass ratio moves displacement more at high exponents",
        "softer springs, longer oscillations",
        |shots| {
            let spans =
                [0.5, 1.0, 2.0, 3.0].map(|n| shots.travels(&format!("n={n}"), &FEW_GAMMAS).span());
            Check::new("change over gamma at n = 0.5, 1, 2, 3:", &spans, "mm", spans.is_sorted())
        },
    ),
    claim(
        ("9.9a", "9.3.5, Figure 9.9(a)", Reproduced, Some("figure-9.9")),
        "the plateau of depth at low exponents narrows as the coefficient falls",
        "a weaker spring holds the plate only at a lower power",
        |shots| {
            let plateau = range("n", 0.1, 1.5, 57);
            let edges = ["k=1e5", "k=1e6", "k=7.5e6"].map(|k| shots.depths(k, &plateau).edge());
            let what = "half way down with k = 1e5, 1e6, 7.5e6 at n =";
            Check::new(what, &edges, "", edges.is_sorted())
        },
    ),
    claim(
        ("9.9b", "9.3.5, Figure 9.9(b)", Misprint, Some("figure-9.9")),
        "displacement is largest where the coefficient is low and the coefficient is high",
        "the exponent is meant: one coefficient cannot be both",
        |shots| {
            let corners = ["k=1e5 n=0.3", "k=1e5 n=3", "k=7.5e6 n=0.3", "k=7.5e6 n=3"]
                .map(|it| shots.travel_mm(it));
            let holds = [0, 2, 3].iter().all(|other| corners[1] > corners[*other]);
            Check::new("low k at n = 0.3, 3, high k at n = 0.3, 3:", &corners, "mm", holds)
        },
    ),
    claim(
        ("9.9b-low", "9.3.5, Figure 9.9(b)", Reproduced, Some("figure-9.9")),
        "at low exponents displacement hardly depends on the coefficient, at higher ones ever more",
        "the low power holds the plate at every k of the range",
        |shots| {
            let spans = [0.1, 0.3, 1.0, 2.0, 3.0]
                .map(|n| shots.travels(&format!("n={n}"), &FEW_STIFFNESSES).span());
            let holds = spans.is_sorted() && spans[1] < 0.05 * spans[4];
            Check::new("change over k at n = 0.1, 0.3, 1, 2, 3:", &spans, "mm", holds)
        },
    ),
    claim(
        ("9.10a", "9.3.5, Figure 9.10(a)", Reproduced, Some("figure-9.10")),
        "cocking cuts depth at every mass ratio, more so at low ones",
        "the spring pulls every plate away, the light one faster",
        |shots| {
            let curves =
                [0.8, 2.0, 7.0].map(|gamma| shots.depths(&format!("gamma={gamma}"), &COCKING));
            let spans: Vec<f64> = curves.iter().map(Curve::span).collect();
            let holds = curves.iter().all(Curve::falls) && spans.is_sorted_by(|a, b| a > b);
            Check::new("change over d at gamma = 0.8, 2, 7:", &spans, "%", holds)
        },
    ),
    claim(
        ("9.10a-mass", "9.3.5, Figure 9.10(a)", Reproduced, Some("figure-9.10")),
        "over the ranges of the figure the mass ratio has more effect on depth than cocking",
        "the mean of the changes along each variable",
        |shots| {
            let over_gamma = mean_span(&COCKING, |d| shots.depths(&format!("d={d}"), &GAMMA));
            let over_d =
                mean_span(&GAMMA, |gamma| shots.depths(&format!("gamma={gamma}"), &COCKING));
            let spans = [over_gamma, over_d];
            Check::new("mean change over gamma, over d:", &spans, "%", over_gamma > over_d)
        },
    ),
    claim(
        ("9.10b", "9.3.5, Figure 9.10(b)", NotReproduced, Some("figure-9.10")),
        "cocking makes displacement orders of magnitude greater, and the mass ratio matters less to it",
        "one order of magnitude, not several",
        |shots| {
            let ratio = |gamma| {
                let at = |d| shots.travel_mm(&format!("gamma={gamma} d={d}"));
                at(0.5) / at(0.0)
            };
            let ratios = [0.8, 1.0, 7.0].map(ratio);
            let spans = [0.0, 0.5].map(|d| shots.travels(&format!("d={d}"), &FEW_GAMMAS).span());
            let change = format!("times; change over gamma {}", list(&spans, "mm"));
            let holds = ratios.iter().all(|ratio| *ratio < 100.0) && spans[1] < spans[0];
            Check::new("d = 0.5 m against uncocked at gamma = 0.8, 1, 7:", &ratios, &change, holds)
        },
    ),
    claim(
        ("9.11a", "9.3.5, Figure 9.11(a)", Reproduced, Some("figure-9.11")),
        "stiffness hardly matters to depth uncocked; cocked but a little, a stiffer spring means less depth",
        "the preload k d pulls the plate away from the shot",
        |shots| {
            let [uncocked, cocked] = ["d=0", "d=0.05"].map(|d| shots.depths(d, &STIFFNESS));
            let text = format!("d = 0: {}; d = 0.05 m: {}", uncocked.ends(), cocked.ends());
            Check { text, holds: uncocked.span() < 15.0 && cocked.falls() }
        },
    ),
    claim(
        ("9.11b", "9.3.5, Figure 9.11(b)", Reproduced, Some("figure-9.11")),
        "displacement goes with cocking alike for every stiffness",
        "the plate passes neutral and travels as far as it was cocked, whatever the spring",
        |shots| {
            let slopes =
                ["k=1e5", "k=1e6", "k=7.5e6"].map(|k| shots.travels(k, &COCKING).slope() / 1e3);
            let holds = slopes.iter().all(|slope| (slope - 1.0).abs() < 0.1);
            Check::new("slope at k = 1e5, 1e6, 7.5e6:", &slopes, "m/m", holds)
        },
    ),
    claim(
        ("9.12a", "9.3.5, Figure 9.12(a)", Reproduced, Some("figure-9.12")),
        "uncocked, depth has the plateau of Figure 9.6(a); cocked, a lower exponent means much less depth",
        "below a metre the lower power is the stronger spring; the plateau ends at n near 0.3 here",
        |shots| {
            let [uncocked, cocked] = ["d=0", "d=0.25"].map(|d| shots.depths(d, &EXPONENT));
            let text = format!("d = 0: {}; d = 0.25 m: {}", uncocked.ends(), cocked.ends());
            Check { text, holds: uncocked.at(0.1) > 99.0 && cocked.rises() }
        },
    ),
    claim(
        ("9.12b", "9.3.5, Figure 9.12(b)", Corrected, Some("figure-9.12")),
        "displacement goes with cocking alike for every exponent",
        "fairly so from 0.1 m on; over the whole range a high exponent makes the spring too soft",
        |shots| {
            let slopes = |from_m| {
                let cocking = range("d", from_m, 0.5, 9);
                [0.5, 1.0, 2.0, 3.0]
                    .map(|n| shots.travels(&format!("n={n}"), &cocking).slope() / 1e3)
            };
            let (whole, later) = (slopes(0.0), slopes(0.1));
            let holds = whole[3] < 0.7 && later.iter().all(|slope| (0.7..1.3).contains(slope));
            let [whole, later] = [whole, later].map(|slopes| list(&slopes, "m/m"));
            let text =
                format!("slope at n = 0.5, 1, 2, 3: {whole} over all d, {later} from 0.1 m on");
            Check { text, holds }
        },
    ),
    claim(
        ("9.6-mass", "9.6", Reproduced, Some("figure-9.10")),
        "the mass of the plate should be low",
        "cocked (here by 0.1 m) or not, the light plate is away sooner",
        |shots| shots.depths("d=0.1", &GAMMA).that(Curve::rises),
    ),
    claim(
        ("9.6-cocking", "9.6", Reproduced, Some("figure-9.3")),
        "the mechanism should be cocked as much as is reasonable",
        "a fifth less depth costs several times the stroke, which counts d on both sides of neutral",
        |shots| {
            let cocked = range("d", 0.0, 0.1, 51);
            let depth = shots.depths("", &cocked);
            let fifth = depth.points.iter().find(|point| point.1 <= 0.8 * depth.at(0.0));
            let text = fifth.map_or_else(
                || "a fifth less depth is not reached by d = 0.1 m".to_owned(),
                |(d_m, _)| {
                    let stroke = shots.travel_mm(&format!("d={d_m}")) + 1e3 * d_m;
                    let [d, times] = [*d_m, stroke / shots.travel_mm("")].map(four);
                    format!("a fifth less depth at d = {d} m, for {times} times the stroke")
                },
            );
            Check { text, holds: depth.falls() }
        },
    ),
    claim(
        ("9.6-stiffness", "9.5.1, 9.6", NotReproduced, Some("figure-9.11")),
        "the spring should be soft, and cocked",
        "cocked (here by 0.1 m), a stiffer spring means less depth, as 9.3.5 says: the advice contradicts it",
        |shots| shots.depths("d=0.1", &STIFFNESS).that(Curve::falls),
    ),
    claim(
        ("9.6-exponent", "9.5.1, 9.6", Reproduced, Some("figure-9.12")),
        "cocked, the exponent should be low; uncocked, above about 1.4",
        "cocked by 0.1 m here; x is in metres, so that uncocked such a spring hardly acts",
        |shots| {
            let [cocked, uncocked] = ["d=0.1", "k=1e6"].map(|it| shots.depths(it, &EXPONENT));
            let text = format!("cocked {}; k = 1e6, uncocked {}", cocked.ends(), uncocked.ends());
            Check { text, holds: cocked.rises() && uncocked.at(1.4) - uncocked.at(3.0) < 1.0 }
        },
    ),
    claim(
        ("9.6-damping", "9.6", Reproduced, Some("figure-9.4")),
        "there should be no damping",
        "cocked (here by 0.1 m) or not, the damper slows the plate",
        |shots| shots.depths("d=0.1", &DAMPING).that(Curve::rises),
    ),
];

/// Returns the mean span of the curves along a second variable.
fn mean_span(range: &Range, curve: impl Fn(f64) -> Curve) -> f64 {
    let spans = range.values().map(|x| curve(x).span());
    spans.sum::<f64>() / f64::from(range.count)
}
