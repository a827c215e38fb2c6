//! References: answers that share no code with the method they check.
//!
//! The stored digits were computed by an 80-bit Taylor series and by 30-digit arithmetic, which agree to the digits given. Other
//! scenes are computed in double-double arithmetic where that can follow them, else by whatever shares no code.

use std::sync::Arc;

use crate::model::contact_phase::{Answer, Ending, fine};
use crate::model::scene::{Mechanism, Mount, Scene};
use crate::numerics::larger;
use crate::study::accuracy::method::{Job, Knob, Method};
use crate::study::changed_free_plate;

const STEPS_MAX: usize = 400_000;
const TIGHT: f64 = 1e-14;
/// That of the implicit one, whose order is lower.
const TIGHT_IMPLICIT: f64 = 1e-13;

struct Stored {
    name: &'static str,
    /// Changes to Table 9.1 with gamma = 1 and neither spring nor damper.
    parameters: &'static str,
    ending: Ending,
    t_s: f64,
    depth_m: f64,
    /// Digits that can be trusted.
    digits: i32,
}

const fn row(
    name: &'static str,
    parameters: &'static str,
    (t_s, depth_m): (f64, f64),
    digits: i32,
) -> Stored {
    Stored { name, parameters, ending: Ending::Arrest, t_s, depth_m, digits }
}

/// The rows of `tests/cases/reference.csv`, rounded to double precision.
const STORED: [Stored; 10] = [
    row("S1", "", (0.000_113_407_312_427_867_65, 0.004_568_088_344_391_97), 18),
    row("S2", "k=100000", (0.000_113_597_172_897_240_72, 0.004_571_788_754_106_379), 18),
    row("S4", "k=1e+06 n=0.5", (0.000_197_151_917_116_086_18, 0.006_919_384_198_354_558), 18),
    row("S5", "k=100000 n=0.3", (0.000_145_261_805_493_910_93, 0.005_532_972_624_185_593), 18),
    row("S7", "b=1000", (0.000_159_594_820_947_785_5, 0.005_836_233_349_205_975), 18),
    row("S8", "b=2000 k=100000", (0.000_172_186_175_510_781_18, 0.006_358_209_064_563_398), 18),
    row("S10", "d=0.5 k=100000", (0.000_047_606_806_905_173_61, 0.001_658_338_066_423_099), 18),
    row("S13", "k=1e+06 n=0.1", (0.000_185_011_646_060_482_2, 0.007_113_054_853_423_405), 14),
    row("S15", "k=1e+09", (0.000_184_567_176_552_508_06, 0.007_107_818_207_444_599), 18),
    Stored {
        name: "S17",
        parameters: "h=0.003 v_i=400 k=100000",
        ending: Ending::Perforation,
        t_s: 0.000_058_297_967_935_076_06,
        depth_m: 0.009_35,
        digits: 18,
    },
];

/// Where a reference comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Basis {
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
}

impl Basis {
    /// A short text.
    pub fn words(self) -> String {
        match self {
            Self::Stored(row) => format!("stored digits, row {row}"),
            Self::ClosedForm => "closed form".to_owned(),
            Self::DoubleDouble => "31-digit Taylor series".to_owned(),
            Self::Dop853 => "DOP853 at 1e-14".to_owned(),
            Self::Radau => "Radau IIA at 1e-13".to_owned(),
            Self::Engine => "engine at 1e-14".to_owned(),
        }
    }

    /// The code that computes it.
    fn code(self) -> Code {
        match self {
            Self::Stored(_) => Code::Elsewhere,
            Self::DoubleDouble => Code::DoubleDouble,
            Self::ClosedForm | Self::Engine => Code::Engine,
            Self::Dop853 | Self::Radau => Code::SecondForm,
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
    pub basis: Basis,
    /// How the contact ends.
    pub ending: Ending,
    /// When, s.
    pub t_s: f64,
    /// Depth then, m.
    pub depth_m: f64,
    /// How far it may be off, relative: what it was stored with, or its difference to an independent one. `None` when there
    /// is nothing to tell it from.
    pub uncertainty: Option<f64>,
}

impl Reference {
    /// Relative errors of depth and time. A perforation's depth is a matter of definition, so its error counts as zero.
    pub fn errors(&self, answer: &Answer) -> (f64, f64) {
        let depth = match self.ending {
            Ending::Arrest => (answer.depth_m / self.depth_m - 1.0).abs(),
            Ending::Perforation => 0.0,
        };
        (depth, (answer.t_s / self.t_s - 1.0).abs())
    }

    fn of(basis: Basis, answer: &Answer) -> Self {
        let Answer { ending, t_s, depth_m, .. } = *answer;
        Self { basis, ending, t_s, depth_m, uncertainty: None }
    }

    fn difference(&self, other: &Self) -> Option<f64> {
        if self.ending != other.ending {
            return None;
        }
        let depth = (self.depth_m / other.depth_m - 1.0).abs();
        let time = (self.t_s / other.t_s - 1.0).abs();
        Some(if depth > time { depth } else { time })
    }
}

/// The stored digits of a scene, if there are any.
pub(in crate::study) fn stored(scene: &Scene) -> Option<Reference> {
    let row = STORED.iter().find(|row| is_row(scene, row))?;
    let digits = 10f64.powi(-row.digits);
    Some(Reference {
        basis: Basis::Stored(row.name),
        ending: row.ending,
        t_s: row.t_s,
        depth_m: row.depth_m,
        uncertainty: Some(larger(digits, f64::EPSILON)),
    })
}

/// All references of a scene, the most trustworthy first.
pub fn references(scene: &Arc<Scene>) -> Vec<Reference> {
    let mut list = Vec::new();
    list.extend(stored(scene));
    if let Ok(answer) = fine::solve(scene) {
        let own = fine::uncertainty(scene, &answer).ok();
        list.push(Reference {
            uncertainty: own.map(|own| larger(own, f64::EPSILON)),
            ..Reference::of(Basis::DoubleDouble, &answer.answer())
        });
    }
    // The engine first without a horizon: it alone needs no idea of when the contact ends.
    let horizon_s = f64::INFINITY;
    let computed = [
        (Basis::ClosedForm, Method::ClosedForm, Knob::None),
        (Basis::Dop853, Method::Dop853, Knob::Tolerance(TIGHT)),
        (Basis::Engine, Method::Auto, Knob::Tolerance(TIGHT)),
    ];
    let solve = |method, knob| Job::new(method, knob, scene, horizon_s, STEPS_MAX).run();
    for (basis, method, knob) in computed {
        if let Ok(answer) = solve(method, knob) {
            list.push(Reference::of(basis, &answer));
        }
    }
    if list.iter().all(|found| found.basis.shares_code_with(Method::Auto))
        && let Ok(answer) = solve(Method::Radau, Knob::Tolerance(TIGHT_IMPLICIT))
    {
        list.insert(0, Reference::of(Basis::Radau, &answer));
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

fn is_row(scene: &Scene, row: &Stored) -> bool {
    let Ok(own) = changed_free_plate(row.parameters) else { return false };
    let mechanism = normal(scene);
    scene.mechanism.is_plain()
        && scene.projectile == own.projectile
        && scene.target == own.target
        && scene.plate == own.plate
        && scene.plate.mount == Mount::Sprung
        && scene.contact == own.contact
        && mechanism.stop.position_m.is_none()
        && mechanism.spring == normal(&own).spring
        && mechanism.damper == normal(&own).damper
}

/// The mechanism with the exponents of absent laws set to one.
fn normal(scene: &Scene) -> Mechanism {
    let mut mechanism = scene.mechanism.clone();
    if mechanism.spring.coefficient == 0.0 {
        mechanism.spring.exponent = 1.0;
    }
    if mechanism.damper.coefficient == 0.0 {
        mechanism.damper.exponent = 1.0;
    }
    mechanism
}
