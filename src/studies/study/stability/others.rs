//! Whether other methods can compute a scene's contact: an explicit adaptive one, an implicit one, and the thesis's.

use crate::model::appendix;
use crate::model::run::EndReason;
use crate::model::scene::Scene;
use crate::study::accuracy::method::{Method, Parameter, Refusal};
use crate::study::accuracy::reference::Reference;

/// Tolerance requested from the adaptive methods.
pub const TOLERANCE: f64 = 1e-9;
/// Relative error up to which an adaptive method counts as accurate there.
pub const ACCURATE_ADAPTIVE: f64 = 1e-6;
/// Relative error up to which a fixed-step method counts as accurate.
pub const ACCURATE_FIXED: f64 = 1e-2;
/// Relative error from which an answer counts as diverged.
pub const BLOWN_UP: f64 = 10.0;

enumeration! {
    /// A method that is looked at beside `auto`.
    pub enum Other in OtherRow {
        /// The key of how it fares in CSV and JSON.
        key: &'static str,
        /// The key of its error.
        error_key: &'static str,
        /// The heading on a page.
        heading: &'static str,
        /// The method.
        method: Method,
        /// Its parameter.
        knob: Parameter,
    }
    /// DOP853 with events located, at [`TOLERANCE`].
    Explicit {
        key: "explicit", error_key: "explicit_error", heading: "expl",
        method: Method::Dop853, knob: Parameter::Tolerance(TOLERANCE)
    }
    /// Radau IIA with events located, at [`TOLERANCE`].
    Implicit {
        key: "implicit", error_key: "implicit_error", heading: "impl",
        method: Method::Radau, knob: Parameter::Tolerance(TOLERANCE)
    }
    /// Appendix A as printed, dt = 1e-6 s.
    ThesisCoarse {
        key: "thesis_1e-6", error_key: "thesis_1e-6_error", heading: "th-6",
        method: Method::ThesisPrinted, knob: Parameter::Step(1e-6)
    }
    /// Appendix A as printed, dt = 1e-7 s.
    ThesisFine {
        key: "thesis_1e-7", error_key: "thesis_1e-7_error", heading: "th-7",
        method: Method::ThesisPrinted, knob: Parameter::Step(1e-7)
    }
}

enumeration! {
    /// Why a method has no error on a contact.
    pub enum Fault in FaultRow {
        /// One word for files.
        word: &'static str,
        /// Words for screens.
        words: &'static str,
        /// At most four characters for tables.
        brief: &'static str,
    }
    /// It ends in another way than the reference.
    WrongEnding { word: "wrong-ending", words: "wrong ending", brief: "end!" }
    /// Values grow without bound.
    BlownUp { word: "blown-up", words: "diverged", brief: "DIV" }
    /// Steps too small to move time, or no end.
    Stuck { word: "stuck", words: "stuck", brief: "stop" }
    /// The step budget was used up.
    TooManySteps { word: "too-many-steps", words: "too many steps", brief: "many" }
    /// It has no equations for this scene.
    NotApplicable { word: "not-applicable", words: "not applicable", brief: "-" }
    /// There is no answer to compare with.
    NoReference { word: "no-reference", words: "no reference", brief: "-" }
    /// Omitted: time was up.
    CutOff { word: "cut-off", words: "cut off", brief: "late" }
}

/// How a method fares on a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    /// With this relative error.
    Accurate(f64),
    /// It ends, with this relative error.
    Inaccurate(f64),
    /// It has no error.
    None(Fault),
}

impl Verdict {
    /// At most four characters for tables: `ok`, the error, or what went wrong.
    pub fn brief(self) -> String {
        match self {
            Self::Accurate(_) => "ok".to_owned(),
            Self::Inaccurate(error) => format!("{error:.0e}"),
            Self::None(fault) => fault.brief().to_owned(),
        }
    }

    /// Words for screens.
    pub fn words(self) -> &'static str {
        match self {
            Self::Accurate(_) | Self::Inaccurate(_) => self.word(),
            Self::None(fault) => fault.words(),
        }
    }

    /// One word for files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Accurate(_) => "accurate",
            Self::Inaccurate(_) => "inaccurate",
            Self::None(fault) => fault.word(),
        }
    }

    /// The relative error, where there is one.
    pub fn error(self) -> Option<f64> {
        match self {
            Self::Accurate(error) | Self::Inaccurate(error) => Some(error),
            Self::None(_) => None,
        }
    }
}

/// How a method fares on a scene that should end like the reference.
pub fn verdict(other: Other, scene: &Scene, reference: Option<&Reference>) -> Verdict {
    let Some(reference) = reference else { return Verdict::None(Fault::NoReference) };
    let answer = match other.method().solve(other.knob(), scene) {
        Ok(answer) => answer,
        Err(refusal) => return Verdict::None(fault(refusal)),
    };
    if answer.outcome != reference.outcome {
        return Verdict::None(Fault::WrongEnding);
    }
    let accurate = match other {
        Other::Explicit | Other::Implicit => ACCURATE_ADAPTIVE,
        Other::ThesisCoarse | Other::ThesisFine => ACCURATE_FIXED,
    };
    match reference.error_of_shot(scene, &answer.results) {
        error if error <= accurate => Verdict::Accurate(error),
        error if error < BLOWN_UP => Verdict::Inaccurate(error),
        _ => Verdict::None(Fault::BlownUp),
    }
}

fn fault(refusal: Refusal) -> Fault {
    match refusal {
        Refusal::NonFinite
        | Refusal::Listing(appendix::Refusal::NonFinite)
        | Refusal::Ended(EndReason::NonFinite) => Fault::BlownUp,
        Refusal::OtherOutcome | Refusal::Listing(appendix::Refusal::Separated) => {
            Fault::WrongEnding
        }
        Refusal::Ended(EndReason::StepBudget) | Refusal::Listing(appendix::Refusal::StepBudget) => {
            Fault::TooManySteps
        }
        Refusal::Listing(_) | Refusal::NeedsSimulation => Fault::NotApplicable,
        Refusal::Ended(_) | Refusal::NoReference | Refusal::TooSlow => Fault::Stuck,
    }
}
