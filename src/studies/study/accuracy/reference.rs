//! References: answers that share no code with the method they check.
//!
//! The stored digits were computed by an 80-bit Taylor series and by 30-digit arithmetic, which agree to the digits given. Other
//! scenes are computed in double-double arithmetic where that can follow them, else by whatever shares no code.

use std::sync::Arc;

use crate::model::contact_phase::stored::Stored;
use crate::model::contact_phase::{ContactSolution, Ending, Phase, fine};
use crate::model::scene::Scene;
use crate::numerics::larger;
use crate::study::accuracy::method::{Method, Parameter};

const STEPS_MAX: usize = 400_000;
/// Steps of a contact by the printed scheme that are near its limit.
const PRINTED_STEPS: f64 = 5e4;
const TIGHT: f64 = 1e-14;
/// That of the implicit one, whose order is lower.
const TIGHT_IMPLICIT: f64 = 1e-13;

/// Where a reference comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReferenceSource {
    /// Stored digits of this row.
    Stored(&'static str),
    /// Closed form.
    ClosedForm,
    /// Taylor series of their own in double-double arithmetic.
    DoubleDouble,
    /// The second form of the equations, by DOP853 at 1e-14.
    Dop853,
    /// The same by Radau IIA at 1e-13, where an explicit method cannot follow.
    Radau,
    /// The engine at its tightest tolerance.
    Engine,
    /// What the printed scheme approaches as its step goes to zero.
    OwnLimit,
}

impl ReferenceSource {
    /// A short text.
    pub fn words(self) -> String {
        match self {
            Self::Stored(row) => format!("stored digits, row {row}"),
            Self::ClosedForm => "closed form".to_owned(),
            Self::DoubleDouble => "31-digit Taylor series".to_owned(),
            Self::Dop853 => "DOP853 at 1e-14".to_owned(),
            Self::Radau => "Radau IIA at 1e-13".to_owned(),
            Self::Engine => "engine at 1e-14".to_owned(),
            Self::OwnLimit => "its own limit".to_owned(),
        }
    }

    /// The code that computes it.
    fn code(self) -> Code {
        match self {
            Self::Stored(_) => Code::Elsewhere,
            Self::DoubleDouble => Code::DoubleDouble,
            Self::ClosedForm | Self::Engine => Code::Engine,
            Self::Dop853 | Self::Radau | Self::OwnLimit => Code::SecondForm,
        }
    }

    /// Whether it shares code with a method: the engine's methods share its areas, and the thesis's scheme those of the second form.
    pub fn shares_code_with(self, method: Method) -> bool {
        self.code() == if method.is_of_engine() { Code::Engine } else { Code::SecondForm }
    }
}

/// Codes that have neither areas nor equations in common.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Code {
    Elsewhere,
    DoubleDouble,
    Engine,
    SecondForm,
}

/// An answer to compare with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reference {
    /// Where it comes from.
    pub basis: ReferenceSource,
    /// The answer.
    pub answer: ContactSolution,
    /// How far it may be off, relative: what it was stored with, or its difference to an independent one. `None` when there
    /// is nothing to tell it from.
    pub uncertainty: Option<f64>,
}

impl Reference {
    /// Relative errors of depth and time. A perforation's depth is a matter of definition, so its error counts as zero.
    pub fn errors(&self, answer: &ContactSolution) -> (f64, f64) {
        let depth = match self.answer.ending {
            Ending::Arrest => (answer.depth_m / self.answer.depth_m - 1.0).abs(),
            Ending::Perforation => 0.0,
        };
        (depth, (answer.t_s / self.answer.t_s - 1.0).abs())
    }

    fn difference(&self, other: &Self) -> Option<f64> {
        let (depth, time) = self.errors(&other.answer);
        (self.answer.ending == other.answer.ending).then_some(larger(depth, time))
    }
}

/// The stored digits of a scene, if there are any.
pub(in crate::study) fn stored(scene: &Scene) -> Option<Reference> {
    let phase = Phase::of(scene);
    let is_same = |row: &Stored| row.scene().is_ok_and(|own| Phase::of(&own) == phase);
    let row = Stored::rows().find(is_same)?;
    let uncertainty = Some(larger(10f64.powi(-row.trusted), f64::EPSILON));
    Some(Reference { basis: ReferenceSource::Stored(row.name), answer: row.answer(), uncertainty })
}

/// The depth that the printed scheme approaches as its step goes to zero, from two fine steps of a scheme of first order.
pub(super) fn printed_limit(scene: &Scene, end_s: f64) -> Option<Reference> {
    let by = |steps: f64| {
        let step = Parameter::Step(end_s / steps);
        Method::ThesisPrinted.solve(step, scene, STEPS_MAX).ok()
    };
    let (coarse, fine) = (by(PRINTED_STEPS)?, by(2.0 * PRINTED_STEPS)?);
    let depth_m = 2.0 * fine.depth_m - coarse.depth_m;
    let answer = ContactSolution { depth_m, ..fine };
    let uncertainty = Some(larger((depth_m / fine.depth_m - 1.0).abs(), f64::EPSILON));
    Some(Reference { basis: ReferenceSource::OwnLimit, answer, uncertainty })
}

/// All references of a scene, the most trustworthy first.
pub fn references(scene: &Arc<Scene>) -> Vec<Reference> {
    let mut list = Vec::new();
    list.extend(stored(scene));
    if let Ok(answer) = fine::solve(scene) {
        let own = fine::uncertainty(scene, &answer).ok();
        list.push(Reference {
            basis: ReferenceSource::DoubleDouble,
            answer: answer.answer(),
            uncertainty: own.map(|own| larger(own, f64::EPSILON)),
        });
    }
    let computed = [
        (ReferenceSource::ClosedForm, Method::ClosedForm, Parameter::None),
        (ReferenceSource::Dop853, Method::Dop853, Parameter::Tolerance(TIGHT)),
        (ReferenceSource::Engine, Method::Auto, Parameter::Tolerance(TIGHT)),
    ];
    for (basis, method, parameter) in computed {
        if let Ok(answer) = method.solve(parameter, scene, STEPS_MAX) {
            list.push(Reference { basis, answer, uncertainty: None });
        }
    }
    if list.iter().all(|found| found.basis.shares_code_with(Method::Auto))
        && let Ok(answer) =
            Method::Radau.solve(Parameter::Tolerance(TIGHT_IMPLICIT), scene, STEPS_MAX)
    {
        list.insert(0, Reference { basis: ReferenceSource::Radau, answer, uncertainty: None });
    }
    for index in 0..list.len() {
        let own = list[index];
        let others = list.iter().filter(|other| own.basis.code() != other.basis.code());
        let least = others.filter_map(|other| own.difference(other)).min_by(f64::total_cmp);
        let found = least.map(|difference| larger(difference, f64::EPSILON));
        list[index].uncertainty = own.uncertainty.or(found);
    }
    list
}
