//! Reproduction of the thesis: numbers of its tables and figures, its trends, the outputs of its listing.
//!
//! A row has the thesis's statement, the verdict, the reason, and one function that computes the statement. The function is called twice:
//! with the engine, and with the listing of Appendix A as printed. The engine's result must agree with the verdict.

use std::sync::Arc;

use crate::study::context::{CancelFlag, Context};
use cmra_engine::model::run::{Outcome, Run};
use cmra_engine::model::scene::{ContactModel, Listing, Scene};
use cmra_engine::model::simulate::{self, Settings};
use cmra_engine::model::units::significant;
use cmra_engine::model::variables;
use cmra_engine::numerics::statistics;
use cmra_engine::numerics::{larger, smaller};

mod figures;
mod tables;

enumeration! {
    /// The verdict on a claim.
    #[derive(PartialOrd, Ord)]
    pub enum ClaimVerdict in VerdictRow {
        /// The words in tables and files.
        words: &'static str,
        /// Letter for narrow columns.
        letter: char,
    }
    /// As stated.
    Reproduced { words: "reproduced", letter: '=' }
    /// As stated once something is put right, which the cause names.
    Corrected { words: "reproduced with correction", letter: '~' }
    /// A wrong number or word; what was meant is computed.
    Misprint { words: "misprint", letter: 'M' }
    /// Not as stated.
    NotReproduced { words: "not reproduced", letter: '-' }
}

/// A statement of the thesis that is computed again.
#[derive(Debug)]
pub struct Claim {
    /// A short name that stays.
    pub id: &'static str,
    /// Where it stands in the thesis.
    pub place: &'static str,
    /// Statement of the thesis, paraphrased.
    pub says: &'static str,
    /// Why the verdict is what it is.
    pub cause: &'static str,
    /// The verdict.
    pub verdict: ClaimVerdict,
    /// The bundled preset that shows it, if one does.
    pub preset: Option<&'static str>,
    /// Computes it by one method.
    check: fn(&Shots<'_>) -> Check,
}

/// A claim of a name, a place, a verdict and a preset, with what the thesis says, why the verdict is what it is, and the check.
const fn claim(
    (id, place, verdict, preset): (&'static str, &'static str, ClaimVerdict, Option<&'static str>),
    says: &'static str,
    cause: &'static str,
    check: fn(&Shots<'_>) -> Check,
) -> Claim {
    Claim { id, place, says, cause, verdict, preset, check }
}

/// The result by one method.
struct Check {
    /// In words.
    text: String,
    /// Whether it bears out the verdict; asked of the engine.
    holds: bool,
}

impl Check {
    /// Values, what they are of, and whether they bear out the verdict.
    fn new(what: &str, values: &[f64], unit: &str, holds: bool) -> Self {
        Self { text: format!("{what} {}", list(values, unit)), holds }
    }
}

/// A claim with its results.
#[derive(Clone, Debug)]
pub struct Row {
    /// The claim.
    pub claim: &'static Claim,
    /// By the engine.
    pub computed: String,
    /// By the listing as printed; empty where it says the same.
    pub as_printed: String,
    /// Whether the computation bears out the verdict.
    pub holds: bool,
}

/// Every claim: tables and listing, then figures.
pub fn claims() -> impl Iterator<Item = &'static Claim> {
    tables::CLAIMS.iter().chain(figures::CLAIMS)
}

/// Checks every claim and shows the rows as they come. A stop ends a claim at its next run: it has no row, nor have those after it.
pub fn reproduce(context: &mut Context<'_, [Row]>) -> Vec<Row> {
    let claims: Vec<&Claim> = claims().collect();
    let stop = context.stop();
    let check = |claim: &&'static Claim| {
        let row = check(claim, &stop);
        (!stop.is_set()).then_some(row)
    };
    context.expect(claims.len());
    context.map_items(&claims, check, Context::show)
}

/// Checks one claim.
pub fn check(claim: &'static Claim, stop: &CancelFlag) -> Row {
    let engine = Shots { stop, listing: None };
    let Check { text, holds } = (claim.check)(&engine);
    let printed = (claim.check)(&engine.printed()).text;
    Row {
        claim,
        as_printed: if printed == text { String::new() } else { printed },
        computed: text,
        holds,
    }
}

/// How many rows have each verdict, in the order of [`ClaimVerdict::ALL`].
pub fn tally(rows: &[Row]) -> [usize; ClaimVerdict::ALL.len()] {
    ClaimVerdict::ALL.map(|verdict| rows.iter().filter(|row| row.claim.verdict == verdict).count())
}

/// Impacts by one method.
struct Shots<'a> {
    stop: &'a CancelFlag,
    /// Listing of Appendix A; `None` for the engine.
    listing: Option<Listing>,
}

/// Longer than any contact here, s.
const CONTACT_S: f64 = 1e-3;

impl Shots<'_> {
    /// By the listing as printed.
    fn printed(&self) -> Self {
        self.by(Listing::default())
    }

    /// By this listing.
    fn by(&self, listing: Listing) -> Self {
        Self { listing: Some(listing), ..*self }
    }

    /// The plate of chapter 9 (gamma = 1, k = 1e5 N/m, n = 1) with changes as `--set` takes them.
    fn scene(&self, changes: &str) -> Scene {
        let mut scene = variables::changed(Scene::default(), changes)
            .expect("the changes are literals of this study");
        if let Some(listing) = self.listing {
            scene.contact.model = ContactModel::Appendix;
            scene.contact.appendix = listing;
        }
        scene
    }

    fn simulate(&self, scene: Scene, series: bool) -> Run {
        let settings = Settings { series, ..Settings::BARE };
        simulate::simulate(&Arc::new(scene), &settings, &mut |_| self.stop.flow())
            .expect("the scenes of this study make physical sense")
    }

    fn run(&self, changes: &str) -> Run {
        self.simulate(self.scene(changes), false)
    }

    fn run_with_series(&self, changes: &str) -> Run {
        self.simulate(self.scene(changes), true)
    }

    /// Depth at the first arrest, m; infinite for a perforation, NaN where there is none.
    fn depth_m(&self, changes: &str) -> f64 {
        let mut scene = self.scene(changes);
        if self.listing.is_some() {
            // The listing follows the plate for as long as it oscillates; its depth is known when the contact ends.
            scene.run.horizon_s = Some(CONTACT_S);
        }
        let run = self.simulate(scene, false);
        match (run.outcome, run.first_arrest) {
            (Outcome::Perforated, _) => f64::INFINITY,
            (_, arrest) => arrest.map_or(f64::NAN, |arrest| arrest.penetration_m),
        }
    }

    /// Depth at the first arrest over that on a rigid mount, percent.
    fn percent(&self, changes: &str) -> f64 {
        100.0 * self.depth_m(changes) / self.depth_m(&format!("{changes} mount=rigid"))
    }

    /// The plate's greatest displacement, mm; infinite where nothing stops the plate.
    fn travel_mm(&self, changes: &str) -> f64 {
        self.run(changes).max_plate_displacement_m.map_or(f64::INFINITY, |x| 1e3 * x)
    }

    /// [`Shots::percent`] over a range of a variable.
    fn depths(&self, changes: &str, range: &Range) -> Curve {
        Curve::new("%", range, |x| self.percent(&format!("{changes} {}={x}", range.variable)))
    }

    /// [`Shots::travel_mm`] over a range of a variable.
    fn travels(&self, changes: &str, range: &Range) -> Curve {
        Curve::new("mm", range, |x| self.travel_mm(&format!("{changes} {}={x}", range.variable)))
    }
}

/// Evenly spaced values of a variable.
struct Range {
    variable: &'static str,
    from: f64,
    to: f64,
    count: u32,
}

impl Range {
    fn values(&self) -> impl Iterator<Item = f64> {
        let step = (self.to - self.from) / f64::from(self.count - 1);
        (0..self.count).map(move |i| self.from + step * f64::from(i))
    }
}

const fn range(variable: &'static str, from: f64, to: f64, count: u32) -> Range {
    Range { variable, from, to, count }
}

/// A quantity along a variable: the points where it is finite.
struct Curve {
    variable: &'static str,
    unit: &'static str,
    points: Vec<(f64, f64)>,
}

/// The noise level of a trend, relative to the curve's whole range.
const NOISE: f64 = 1e-3;

impl Curve {
    fn new(unit: &'static str, range: &Range, value: impl Fn(f64) -> f64) -> Self {
        let points = range.values().map(|x| (x, value(x))).filter(|point| point.1.is_finite());
        Self { variable: range.variable, unit, points: points.collect() }
    }

    /// Formats both ends of the curve: `60.0 % at gamma = 0.8, 91.5 % at 7`.
    fn ends(&self) -> String {
        let (Some(first), Some(last)) = (self.points.first(), self.points.last()) else {
            return "nothing finite".to_owned();
        };
        let [from, low, to, high] = [first.0, first.1, last.0, last.1].map(four);
        let Self { variable, unit, .. } = self;
        format!("{low} {unit} at {variable} = {from}, {high} {unit} at {to}")
    }

    /// Builds a check from both ends of the curve and from a condition.
    fn that(&self, holds: impl Fn(&Self) -> bool) -> Check {
        Check { text: self.ends(), holds: holds(self) }
    }

    fn values(&self) -> impl Iterator<Item = f64> {
        self.points.iter().map(|point| point.1)
    }

    fn span(&self) -> f64 {
        self.values().fold(f64::NEG_INFINITY, larger) - self.values().fold(f64::INFINITY, smaller)
    }

    /// Whether it rises all along, but for noise.
    fn rises(&self) -> bool {
        self.goes(1.0)
    }

    /// Whether it falls all along, but for noise.
    fn falls(&self) -> bool {
        self.goes(-1.0)
    }

    fn goes(&self, sign: f64) -> bool {
        let noise = NOISE * self.span();
        let change = |from: &(f64, f64), to: &(f64, f64)| sign * (to.1 - from.1);
        let ends = self.points.first().zip(self.points.last());
        self.points.windows(2).all(|pair| change(&pair[0], &pair[1]) >= -noise)
            && ends.is_some_and(|(first, last)| change(first, last) > 0.0)
    }

    /// Whether it becomes ever less steep, but for noise.
    fn flattens(&self) -> bool {
        let slope = |pair: &[(f64, f64)]| ((pair[1].1 - pair[0].1) / (pair[1].0 - pair[0].0)).abs();
        let slopes: Vec<f64> = self.points.windows(2).map(slope).collect();
        let noise = 2.0 * NOISE * slopes.iter().copied().fold(0.0, larger);
        slopes.windows(2).all(|pair| pair[1] <= pair[0] + noise)
    }

    /// The value at `x`, on the straight line between the points around it.
    fn at(&self, x: f64) -> f64 {
        if self.points.len() < 2 {
            return f64::NAN;
        }
        let after =
            self.points.partition_point(|point| point.0 < x).clamp(1, self.points.len() - 1);
        let ((x0, y0), (x1, y1)) = (self.points[after - 1], self.points[after]);
        y0 + (y1 - y0) * (x - x0) / (x1 - x0)
    }

    /// The slope of its least-squares line.
    fn slope(&self) -> f64 {
        statistics::slope(&self.points)
    }

    /// Where a falling curve crosses the middle between its ends; NaN where it does not.
    fn edge(&self) -> f64 {
        let (Some(first), Some(last)) = (self.points.first(), self.points.last()) else {
            return f64::NAN;
        };
        let middle = 0.5 * (first.1 + last.1);
        let pair = self.points.windows(2).find(|pair| pair[0].1 > middle && pair[1].1 <= middle);
        pair.map_or(f64::NAN, |pair| {
            let part = (pair[0].1 - middle) / (pair[0].1 - pair[1].1);
            pair[0].0 + part * (pair[1].0 - pair[0].0)
        })
    }

    /// The greatest step between neighbours.
    fn step(&self) -> f64 {
        self.points.windows(2).map(|pair| (pair[1].1 - pair[0].1).abs()).fold(0.0, larger)
    }
}

fn near(value: f64, stated: f64, relative: f64) -> bool {
    (value / stated - 1.0).abs() <= relative
}

fn four(value: f64) -> String {
    significant(value, 4)
}

fn millimetres(value_m: f64) -> String {
    if value_m.is_finite() { format!("{:.4} mm", 1e3 * value_m) } else { "perforated".to_owned() }
}

/// Four figures of each value, and their unit.
fn list(values: &[f64], unit: &str) -> String {
    let values: Vec<String> = values.iter().copied().map(four).collect();
    format!("{} {unit}", values.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn valid_shapes_are_distinguished() {
        let curve = |f: fn(f64) -> f64| Curve::new("", &range("x", 0.0, 2.0, 21), f);
        let root = curve(f64::sqrt);
        assert!(root.rises() && root.flattens() && !root.falls());
        let square = curve(|x| x * x);
        assert!(square.rises() && !square.flattens());
        assert!((square.at(1.05) - 1.105).abs() < 1e-12);
        assert!((curve(|x| 3.0 * x - 1.0).slope() - 3.0).abs() < 1e-12);
        let step = curve(|x| if x < 0.75 { 10.0 } else { 2.0 });
        assert!((step.edge() - 0.75).abs() < 0.06 && (step.step() - 8.0).abs() < 1e-12);
        let wave = curve(|x| (3.0 * x).sin());
        assert!(!wave.rises() && !wave.falls());
    }
}
