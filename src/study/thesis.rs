//! Every checkable claim of the thesis against what is computed, in thesis order.
//!
//! A claim says where it stands, what it says (paraphrased), and how it is checked: by the sound model (the engine, first
//! arrest fused as the thesis has it) and by the Appendix as printed. Expected values are the thesis's; results come from
//! the solver each time; the verdict follows from both. Nothing is typed in. Reads no clock and no file.

use std::ops::{ControlFlow, Range};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::model::scene::Scene;
use crate::study::sweep::crew::Crew;
use lab::Lab;

mod appendix;
mod chapter4;
mod chapter8;
mod cocking;
mod concepts;
mod connection;
mod early;
mod elastica;
mod feasibility;
mod interactions;
mod lab;
mod modelling;
mod numbering;
mod rating;
mod shape;
mod spread;
mod tables;
mod trends;

/// What became of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// Computed as stated.
    Reproduced,
    /// Computed as stated once something is put right, which the cause names.
    Corrected,
    /// A wrong number, symbol or word; what was meant is computed.
    Misprint,
    /// A trend that is there over the whole range of its figure.
    TrendHolds,
    /// A trend that is not.
    TrendFails,
    /// Cannot be checked; the cause says why.
    Unchecked,
}

impl Verdict {
    /// All verdicts.
    pub const ALL: [Self; 6] = [
        Self::Reproduced,
        Self::Corrected,
        Self::Misprint,
        Self::TrendHolds,
        Self::TrendFails,
        Self::Unchecked,
    ];

    /// The words in tables and files.
    pub fn words(self) -> &'static str {
        match self {
            Self::Reproduced => "reproduced",
            Self::Corrected => "reproduced with correction",
            Self::Misprint => "misprint",
            Self::TrendHolds => "trend holds",
            Self::TrendFails => "trend fails",
            Self::Unchecked => "cannot be checked",
        }
    }

    /// One letter, for narrow columns.
    pub fn letter(self) -> char {
        match self {
            Self::Reproduced => '=',
            Self::Corrected => '~',
            Self::Misprint => 'M',
            Self::TrendHolds => '+',
            Self::TrendFails => '-',
            Self::Unchecked => '?',
        }
    }
}

/// What opens when a claim's row is chosen.
#[derive(Clone, Copy, Debug)]
pub enum Opens {
    /// Nothing: no scene shows it.
    Nothing,
    /// This scene.
    Scene(fn() -> Scene),
    /// The bundled preset of this name.
    Preset(&'static str),
}

/// A claim of the thesis.
#[derive(Debug)]
pub struct Claim {
    /// A short name that stays: rows are compared by it.
    pub id: &'static str,
    /// Where it stands.
    pub place: &'static str,
    /// What it says, in other words.
    pub says: &'static str,
    /// What shows it.
    pub opens: Opens,
    check: fn(&Lab) -> Found,
}

/// What a verdict rests on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Basis {
    /// A computation.
    Computed,
    /// A comparison of what the thesis says in two places: nothing is computed.
    Read,
    /// Nothing: the claim cannot be checked.
    None,
}

impl Basis {
    /// The words in tables and files.
    pub fn words(self) -> &'static str {
        match self {
            Self::Computed => "computed",
            Self::Read => "read from the text",
            Self::None => "not checked",
        }
    }
}

/// What was found for a claim.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// By the sound model.
    pub sound: String,
    /// By the Appendix as printed; empty where it has nothing to say.
    pub printed: String,
    /// What became of the claim.
    pub verdict: Verdict,
    /// Why, in one sentence.
    pub cause: &'static str,
    /// What the verdict rests on.
    pub basis: Basis,
}

/// A claim with its result.
#[derive(Clone, Debug)]
pub struct Row {
    /// The claim.
    pub claim: &'static Claim,
    /// The result.
    pub found: Found,
    /// How many impacts were simulated for it.
    pub runs: usize,
}

/// Every claim, in thesis order.
pub fn claims() -> impl Iterator<Item = &'static Claim> {
    early::CLAIMS
        .iter()
        .chain(chapter4::CLAIMS)
        .chain(concepts::CLAIMS)
        .chain(rating::CLAIMS)
        .chain(modelling::CLAIMS)
        .chain(chapter8::CLAIMS)
        .chain(tables::CLAIMS)
        .chain(trends::CLAIMS)
        .chain(interactions::CLAIMS)
        .chain(cocking::CLAIMS)
        .chain(connection::CLAIMS)
        .chain(feasibility::CLAIMS)
        .chain(appendix::CLAIMS)
}

/// The concepts of chapter 6 as the claims have them, each with the name of the bundled preset it is to be equal to.
pub fn concepts() -> impl Iterator<Item = (&'static str, Scene)> {
    concepts::CONCEPT_SCENES.iter().map(|(name, scene)| (*name, scene()))
}

fn checked_on(lab: &Lab, claim: &'static Claim) -> Row {
    let found = (claim.check)(lab);
    Row { claim, found, runs: lab.runs() }
}

/// Check one claim.
pub fn check(claim: &'static Claim) -> Row {
    checked_on(&Lab::default(), claim)
}

/// Check every claim, as [`check_all`] does.
pub fn reproduce(watch: Watch<'_>, stop: &Arc<AtomicBool>) -> Vec<Row> {
    check_all(&claims().collect::<Vec<_>>(), watch, stop)
}

/// Given what there is so far, and how many rows there will be; `Break` stops.
pub type Watch<'a> = &'a mut dyn FnMut(&[Row], usize) -> ControlFlow<()>;

/// Check claims on all cores, in their order. `stop` ends a claim at its next step: that row and those after it are left out.
pub fn check_all(claims: &[&'static Claim], watch: Watch<'_>, stop: &Arc<AtomicBool>) -> Vec<Row> {
    let crew = Crew { piece: 1, ..Crew::of_machine() };
    let check_one = |piece: Range<u64>| {
        let claim = claims.get(usize::try_from(piece.start).ok()?)?;
        let lab = Lab::stopped_by(stop);
        let row = checked_on(&lab, claim);
        (!lab.is_stopped()).then_some(row)
    };
    let mut rows = Vec::new();
    let _ = crew.work_heard(
        0..claims.len() as u64,
        || check_one,
        |news| {
            if let Some((_, row)) = news {
                let Some(row) = row else { return ControlFlow::Break(()) };
                rows.push(row);
            }
            let asked = watch(&rows, claims.len());
            if asked.is_break() {
                stop.store(true, Ordering::Relaxed);
            }
            asked
        },
    );
    rows
}

/// How many rows have each verdict, in the order of [`Verdict::ALL`].
pub fn tally(rows: &[Row]) -> [usize; 6] {
    Verdict::ALL.map(|verdict| rows.iter().filter(|row| row.found.verdict == verdict).count())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Runs end at their first step then, so that whatever a claim makes of them is made of almost nothing.
    #[test]
    fn a_claim_that_is_stopped_ends_quietly() {
        let stop = Arc::new(AtomicBool::new(true));
        for claim in claims() {
            assert_eq!(checked_on(&Lab::stopped_by(&stop), claim).claim.id, claim.id);
        }
        let watch = &mut |_: &[Row], _: usize| ControlFlow::Continue(());
        assert!(reproduce(watch, &stop).is_empty());
    }
}
