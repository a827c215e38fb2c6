//! Every checkable claim of the thesis, compared with computed results, in the order of the thesis.
//!
//! The claims are data, in `data/claims.toml`: where a claim stands, what it says, and how it is checked, by the
//! engine and by the Appendix as printed. Results come from the solver each time, and the verdict follows from them.

use std::sync::LazyLock;

use crate::model::scene::Scene;
use crate::study::context::Context;
use claim::Claims;
use runs::{Runs, SharedRuns};

mod check;
mod claim;
mod elastica;
mod expression;
mod functions;
mod quantities;
mod runs;
mod series;
mod shape;
mod text;
mod value;

pub use claim::Claim;

const CLAIMS: &str = include_str!("../data/claims.toml");

enumeration! {
    /// The outcome of a claim.
    #[derive(PartialOrd, Ord)]
    pub enum ClaimVerdict in VerdictRow {
        /// The words in tables and files.
        words: &'static str,
        /// One word, for counts in a narrow row.
        brief: &'static str,
        /// One letter, for narrow columns.
        letter: char,
    }
    /// Computed as stated.
    Reproduced { words: "reproduced", brief: "reproduced", letter: '=' }
    /// Computed as stated once something is put right, which the cause names.
    Corrected { words: "reproduced with correction", brief: "corrected", letter: '~' }
    /// A wrong number, symbol or word; what was meant is computed.
    Misprint { words: "misprint", brief: "misprint", letter: 'M' }
    /// A trend that is there over the whole range of its figure.
    TrendHolds { words: "trend holds", brief: "hold", letter: '+' }
    /// A trend that is not.
    TrendFails { words: "trend fails", brief: "fail", letter: '-' }
    /// Cannot be checked; the cause says why.
    Unchecked { words: "cannot be checked", brief: "unchecked", letter: '?' }
}

/// The scene that opens with a claim's row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Opens {
    /// Nothing: no scene shows it.
    Nothing,
    /// This scene.
    Scene(&'static Scene),
    /// The bundled preset of this name.
    Preset(&'static str),
}

enumeration! {
    /// The basis of a verdict.
    pub enum Evidence in BasisRow {
        /// The words in tables and files.
        words: &'static str,
    }
    /// A computation.
    Computed { words: "computed" }
    /// A comparison of what the thesis says in two places: nothing is computed.
    Read { words: "read from the text" }
    /// Nothing: the claim cannot be checked.
    None { words: "not checked" }
}

/// The result for a claim.
#[derive(Clone, Debug, PartialEq)]
pub struct ClaimResult {
    /// By the sound model.
    pub sound: String,
    /// By the Appendix as printed; empty where it has nothing to say.
    pub printed: String,
    /// The outcome of the claim.
    pub verdict: ClaimVerdict,
    /// The basis of the verdict.
    pub basis: Evidence,
}

/// A claim with its result.
#[derive(Clone, Debug)]
pub struct Row {
    /// The claim.
    pub claim: &'static Claim,
    /// The result.
    pub found: ClaimResult,
    /// How many impacts it took, those shared with other claims included.
    pub runs: usize,
}

/// Every claim, in thesis order; none where the file is wrong, which the tests refuse.
pub fn claims() -> &'static [Claim] {
    &file().all
}

/// The scene that the claims are checked on under this name.
pub fn scene(name: &str) -> Option<&'static Scene> {
    file().scenes.get(name)
}

fn file() -> &'static Claims {
    static FILE: LazyLock<Claims> = LazyLock::new(|| claim::read(CLAIMS).unwrap_or_default());
    &FILE
}

/// The claim of this name.
pub fn find(id: &str) -> Option<&'static Claim> {
    claims().iter().find(|claim| claim.id == id)
}

fn row(claim: &'static Claim, shared: &SharedRuns) -> Row {
    let runs = Runs::new(shared);
    let found = check::check(claim, &file().scenes, &runs);
    Row { claim, found, runs: runs.impacts() }
}

/// Check one claim.
pub fn check(claim: &'static Claim) -> Row {
    row(claim, &SharedRuns::default())
}

/// Check every claim, as [`check_all`] does.
pub fn reproduce(context: &mut Context<'_, [Row]>) -> Vec<Row> {
    check_all(&claims().iter().collect::<Vec<_>>(), context)
}

/// Check claims, in their order, and show the rows as they come. A stop ends a claim at its next step: it has no row,
/// nor have those after it.
pub fn check_all(claims: &[&'static Claim], context: &mut Context<'_, [Row]>) -> Vec<Row> {
    let stop = context.stop();
    let shared = SharedRuns::stopped_by(stop.clone());
    let check = |claim: &&'static Claim| {
        let row = row(claim, &shared);
        (!stop.is_set()).then_some(row)
    };
    context.expect(claims.len());
    let show = |context: &mut Context<'_, [Row]>, rows: &[Row]| context.show(rows);
    context.map_items(claims, check, show)
}

/// Where the verdicts of these rows differ from the expected ones, in words.
pub fn changed(report: &[Row]) -> Vec<String> {
    report
        .iter()
        .filter(|row| row.found.verdict != row.claim.expected)
        .map(|row| {
            let (now, before) = (row.found.verdict.words(), row.claim.expected.words());
            format!("{}: {now}, stored is {before}", row.claim.id)
        })
        .collect()
}

/// The same of a whole report; rows that are missing count, too.
pub fn differences(report: &[Row]) -> Vec<String> {
    let missing = claims().iter().filter(|it| report.iter().all(|row| row.claim.id != it.id));
    let missing =
        missing.map(|it| format!("{}: no such row, stored is {}", it.id, it.expected.words()));
    changed(report).into_iter().chain(missing).collect()
}

/// How many rows have each verdict, in the order of [`ClaimVerdict::ALL`].
pub fn tally(rows: &[Row]) -> [usize; 6] {
    ClaimVerdict::ALL.map(|verdict| rows.iter().filter(|row| row.found.verdict == verdict).count())
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;

    use super::*;
    use crate::study::context::CancelFlag;

    #[test]
    fn the_file_of_claims_is_right() {
        let claims = claim::read(CLAIMS).unwrap_or_else(|problem| panic!("{problem}"));
        assert!(claims.all.len() >= 199, "{}", claims.all.len());
    }

    /// Runs end at their first step then, so that whatever a claim makes of them is made of almost nothing.
    #[test]
    fn a_claim_that_is_stopped_ends_quietly() {
        let stop = CancelFlag::default();
        stop.store(true);
        for claim in claims() {
            assert_eq!(row(claim, &SharedRuns::stopped_by(stop.clone())).claim.id, claim.id);
        }
        let watch = &mut |_, _: Option<&[Row]>| ControlFlow::Break(());
        assert!(reproduce(&mut Context::new(2, watch)).len() <= 1);
    }

    /// Not only between two claims: the longest take most of a second.
    #[test]
    fn the_claims_are_stopped_within_a_claim() {
        // Claims are checked in parallel. After Ctrl-C or Esc no further one starts, and those not finished are not in the result.
        let mut asked = 0;
        let watch = &mut |_, _: Option<&[Row]>| {
            asked += 1;
            if asked > 6 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let (rows, all) = (reproduce(&mut Context::new(2, watch)), claims().len());
        assert!(rows.len() < all / 2, "{} of {all}", rows.len());
    }
}
