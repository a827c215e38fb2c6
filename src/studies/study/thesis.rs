//! Reproduction of the thesis: numbers of tables and figures, trends, and results of the listing.
//!
//! A claim has a statement of the thesis, the verdict, the reason, and a function that computes the statement. The function runs twice:
//! with the engine, and with the listing of Appendix A as printed. A row holds if the result of the engine agrees with the verdict.

use std::sync::Arc;

use crate::study::context::{CancelFlag, Context};
use crate::study::statistics;
use cmra_engine::model::run::{Outcome, Run};
use cmra_engine::model::scene::{ContactModel, Listing, Scene};
use cmra_engine::model::simulate::{self, Settings};
use cmra_engine::model::units::significant;
use cmra_engine::model::variables;
use cmra_engine::numerics::{larger, smaller};

mod captions;
mod figures;
mod tables;

pub use captions::caption;

enumeration! {
    /// Verdict on a claim.
    #[derive(PartialOrd, Ord)]
    pub enum ClaimVerdict in VerdictRow {
        /// Text in tables and files.
        words: &'static str,
        /// Letter for narrow columns.
        letter: char,
    }
    /// As stated.
    Reproduced { words: "reproduced", letter: '=' }
    /// As stated, after the correction that the cause names.
    Corrected { words: "reproduced with correction", letter: '~' }
    /// A wrong number or word; the intended one is computed.
    Misprint { words: "misprint", letter: 'M' }
    /// Not as stated.
    NotReproduced { words: "not reproduced", letter: '-' }
}

/// Statement of the thesis that is computed again.
#[derive(Debug)]
pub struct Claim {
    /// Permanent short name.
    pub id: &'static str,
    /// Section, table or figure of the thesis.
    pub place: &'static str,
    /// Statement of the thesis, paraphrased.
    pub says: &'static str,
    /// Reason for the verdict.
    pub cause: &'static str,
    /// Verdict.
    pub verdict: ClaimVerdict,
    /// Bundled preset that shows the claim.
    pub preset: Option<&'static str>,
    /// Function that computes the statement with one method.
    check: fn(&Shots<'_>) -> Check,
}

/// Creates a claim from name, place, verdict and preset, the statement, the reason, and the function.
const fn claim(
    (id, place, verdict, preset): (&'static str, &'static str, ClaimVerdict, Option<&'static str>),
    says: &'static str,
    cause: &'static str,
    check: fn(&Shots<'_>) -> Check,
) -> Claim {
    Claim { id, place, says, cause, verdict, preset, check }
}

/// Result of one method.
struct Check {
    /// Text.
    text: String,
    /// Whether the result agrees with the verdict; evaluated for the engine only.
    holds: bool,
}

impl Check {
    /// Creates a result from a description, values with their unit, and a condition.
    fn new(what: &str, values: &[f64], unit: &str, holds: bool) -> Self {
        Self { text: format!("{what} {}", list(values, unit)), holds }
    }
}

/// Claim with its results.
#[derive(Clone, Debug)]
pub struct Row {
    /// Claim.
    pub claim: &'static Claim,
    /// Result of the engine.
    pub computed: String,
    /// Result of the listing as printed; empty if it is equal.
    pub as_printed: String,
    /// Whether the result of the engine agrees with the verdict.
    pub holds: bool,
}

/// Returns every claim: tables and listing, then figures.
pub fn claims() -> impl Iterator<Item = &'static Claim> {
    tables::CLAIMS.iter().chain(figures::CLAIMS)
}

/// Checks every claim and reports the rows in order. A stopped study returns the rows of the finished claims.
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

/// Counts the rows by verdict, in the order of [`ClaimVerdict::ALL`].
pub fn tally(rows: &[Row]) -> [usize; ClaimVerdict::ALL.len()] {
    ClaimVerdict::ALL.map(|verdict| rows.iter().filter(|row| row.claim.verdict == verdict).count())
}

/// Impacts computed by one method.
struct Shots<'a> {
    stop: &'a CancelFlag,
    /// Listing of Appendix A; `None` for the engine.
    listing: Option<Listing>,
}

/// Time limit of a run for its depth, s; longer than every contact of this study.
const CONTACT_S: f64 = 1e-3;

impl Shots<'_> {
    /// Returns the impacts by the listing as printed.
    fn printed(&self) -> Self {
        self.by(Listing::default())
    }

    /// Returns the impacts by a listing.
    fn by(&self, listing: Listing) -> Self {
        Self { listing: Some(listing), ..*self }
    }

    /// Returns the scene of chapter 9 (gamma = 1, k = 1e5 N/m, n = 1) with changes in the syntax of `--set`.
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

    /// Returns the depth at the first arrest, m; infinite for a perforation, NaN without a first arrest.
    fn depth_m(&self, changes: &str) -> f64 {
        let mut scene = self.scene(changes);
        if self.listing.is_some() {
            // The listing integrates the oscillation of the plate, too; the depth is final at the end of the contact.
            scene.run.horizon_s = Some(CONTACT_S);
        }
        let run = self.simulate(scene, false);
        match (run.outcome, run.first_arrest) {
            (Outcome::Perforated, _) => f64::INFINITY,
            (_, arrest) => arrest.map_or(f64::NAN, |arrest| arrest.penetration_m),
        }
    }

    /// Returns the depth at the first arrest, relative to the depth on a rigid mount, percent.
    fn percent(&self, changes: &str) -> f64 {
        100.0 * self.depth_m(changes) / self.depth_m(&format!("{changes} mount=rigid"))
    }

    /// Returns the maximum displacement of the plate, mm; infinite if nothing stops the plate.
    fn travel_mm(&self, changes: &str) -> f64 {
        self.run(changes).max_plate_displacement_m.map_or(f64::INFINITY, |x| 1e3 * x)
    }

    /// Returns [`Shots::percent`] over a range of a variable.
    fn depths(&self, changes: &str, range: &Range) -> Curve {
        Curve::new("%", range, |x| self.percent(&format!("{changes} {}={x}", range.variable)))
    }

    /// Returns [`Shots::travel_mm`] over a range of a variable.
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

/// Quantity as a function of a variable: the points with finite values.
struct Curve {
    variable: &'static str,
    unit: &'static str,
    points: Vec<(f64, f64)>,
}

/// Tolerance of a trend, relative to the range of the curve; above the error of the step size of the listing.
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

    /// Returns `true` if the curve increases monotonically, within [`NOISE`].
    fn rises(&self) -> bool {
        self.goes(1.0)
    }

    /// Returns `true` if the curve decreases monotonically, within [`NOISE`].
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

    /// Returns `true` if the absolute slope decreases monotonically, within [`NOISE`].
    fn flattens(&self) -> bool {
        let slope = |pair: &[(f64, f64)]| ((pair[1].1 - pair[0].1) / (pair[1].0 - pair[0].0)).abs();
        let slopes: Vec<f64> = self.points.windows(2).map(slope).collect();
        let noise = 2.0 * NOISE * slopes.iter().copied().fold(0.0, larger);
        slopes.windows(2).all(|pair| pair[1] <= pair[0] + noise)
    }

    /// Returns the value at `x` by linear interpolation.
    fn at(&self, x: f64) -> f64 {
        if self.points.len() < 2 {
            return f64::NAN;
        }
        let after =
            self.points.partition_point(|point| point.0 < x).clamp(1, self.points.len() - 1);
        let ((x0, y0), (x1, y1)) = (self.points[after - 1], self.points[after]);
        y0 + (y1 - y0) * (x - x0) / (x1 - x0)
    }

    /// Returns the slope of the least-squares line.
    fn slope(&self) -> f64 {
        statistics::slope(&self.points)
    }

    /// Returns the position at which a decreasing curve crosses the mean of its ends; NaN if it does not.
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

    /// Returns the largest difference between neighbouring points.
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

/// Formats values with four significant digits and their unit.
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
