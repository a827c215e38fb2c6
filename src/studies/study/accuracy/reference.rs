//! References: what the results of a method are compared with, always of a method with other steps.
//!
//! Depth and time of the stored scenes are known to 18 digits, by an 80-bit Taylor series and 30-digit arithmetic. Everything else is
//! computed twice on the simulation's loop, by the engine's own steps and by DOP853, or where that cannot follow by Radau IIA of order
//! five: each is the reference of the methods with other steps, and their difference the uncertainty of both. The loop's equations are
//! checked elsewhere, by tests with equations of their own.

use std::sync::Arc;

use crate::study::accuracy::method::{Answer, RESULTS, Results, answer_of, printed};
use cmra_engine::model::impact::IntegrationMethod;
use cmra_engine::model::impact::step_by;
use cmra_engine::model::reference::Stored;
use cmra_engine::model::run::Outcome;
use cmra_engine::model::scene::{InterfaceLaw, Scene};
use cmra_engine::model::variables::{Group, VARIABLES, changed_free_plate, is_used};
use cmra_engine::numerics::larger;

/// Steps of a contact by the printed scheme that are near its limit.
const PRINTED_STEPS: f64 = 5e4;
/// Tolerances of the references.
const TIGHT: f64 = 1e-13;
const TIGHT_OF_ORDER_FIVE: f64 = 1e-12;
/// A displacement of this part of the nose radius is as good as none: a spring that holds the plate lets it move by less.
const NO_LENGTH: f64 = 1e-9;

/// Where a reference comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReferenceSource {
    /// Depth and time are the stored digits of this row.
    Stored(&'static str),
    /// The engine at its tightest tolerance.
    Engine,
    /// DOP853 on the same loop.
    Dop853,
    /// Radau IIA of order five, where an explicit method cannot follow.
    Radau,
    /// Limit of the printed scheme for a vanishing step size.
    OwnLimit,
}

impl ReferenceSource {
    /// A short text.
    pub fn label(self) -> String {
        match self {
            Self::Stored(row) => format!("stored digits, row {row}"),
            Self::Engine => "engine at 1e-13".to_owned(),
            Self::Dop853 => "DOP853 at 1e-13".to_owned(),
            Self::Radau => "Radau IIA 5 at 1e-12".to_owned(),
            Self::OwnLimit => "its own limit".to_owned(),
        }
    }

    /// The letter behind an error on a page.
    pub fn letter(self) -> char {
        match self {
            Self::Stored(_) => 's',
            Self::Engine => 't',
            Self::Dop853 => 'D',
            Self::Radau => 'R',
            Self::OwnLimit => 'T',
        }
    }
}

/// Results to compare with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reference {
    /// Where they come from.
    pub basis: ReferenceSource,
    /// How the shot ends.
    pub outcome: Outcome,
    /// The results.
    pub results: Results,
    /// How far depth and time may be off, relative; `None` when there is nothing to tell it from.
    pub uncertainty: Option<f64>,
}

impl Reference {
    fn new(basis: ReferenceSource, answer: &Answer) -> Self {
        let Answer { outcome, results, .. } = *answer;
        Self { basis, outcome, results, uncertainty: None }
    }

    /// The errors of a method's results: relative, of the last velocity over the impact velocity.
    pub fn errors(&self, scene: &Scene, results: &Results) -> Results {
        let shot = &scene.projectile;
        let least = [0.0, 0.0, NO_LENGTH * shot.tip_radius_m, 0.0, shot.velocity_m_s, 0.0, 0.0];
        std::array::from_fn(|at| {
            let (own, right) = (results[at]?, self.results[at]?);
            let scale = larger(right.abs(), larger(least[at], f64::MIN_POSITIVE));
            Some((own - right).abs() / scale)
        })
    }

    /// The greatest error of all results; NaN where one of them exists on one side only.
    pub fn error_of_all(&self, scene: &Scene, results: &Results) -> f64 {
        if results.map(|own| own.is_some()) != self.results.map(|right| right.is_some()) {
            return f64::NAN;
        }
        self.errors(scene, results).into_iter().flatten().fold(0.0, larger)
    }

    /// The time of first arrest or exit, s.
    pub fn end_s(&self) -> f64 {
        self.results[1].unwrap_or(f64::NAN)
    }
}

/// The references of a scene: for methods without the engine's steps, and for those with them.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct References {
    /// By the engine's own steps.
    pub engine: Option<Reference>,
    /// By other steps.
    pub other: Option<Reference>,
}

impl References {
    /// Computes the references of a valid scene.
    pub fn from_scene(scene: &Arc<Scene>) -> Self {
        let by = |stepping: IntegrationMethod| {
            let run = step_by(stepping, scene).ok().flatten()?;
            answer_of(&run).ok()
        };
        let engine = by(IntegrationMethod::Collocation(TIGHT));
        let other = by(IntegrationMethod::Dop853(TIGHT))
            .map(|answer| (ReferenceSource::Dop853, answer))
            .or_else(|| {
                Some((ReferenceSource::Radau, by(IntegrationMethod::Radau5(TIGHT_OF_ORDER_FIVE))?))
            });
        let mut both = Self {
            engine: engine.map(|answer| Reference::new(ReferenceSource::Engine, &answer)),
            other: other.map(|(basis, answer)| Reference::new(basis, &answer)),
        };
        let apart = both.engine.zip(both.other).and_then(|(one, other)| {
            let errors = one.errors(scene, &other.results);
            let worst = errors[..2].iter().flatten().copied().fold(f64::EPSILON, larger);
            (one.outcome == other.outcome).then_some(worst)
        });
        let stored = stored(scene);
        for reference in [&mut both.engine, &mut both.other].into_iter().flatten() {
            reference.uncertainty = apart;
            if let Some((row, uncertainty)) = &stored {
                reference.basis = ReferenceSource::Stored(row.name);
                reference.outcome = row.outcome;
                let is_arrested = row.outcome == Outcome::Arrested;
                reference.results[0] = is_arrested.then_some(row.depth_m);
                reference.results[1] = Some(row.t_s);
                reference.uncertainty = Some(*uncertainty);
            }
        }
        both
    }

    /// Whichever there is.
    pub fn any(&self) -> Option<Reference> {
        self.engine.or(self.other)
    }
}

/// The stored row of a scene and its uncertainty, if there is one. Its digits are those of a fused interface.
pub(in crate::study) fn stored(scene: &Scene) -> Option<(Stored, f64)> {
    if scene.interface.law != InterfaceLaw::Fused {
        return None;
    }
    let counts = |group: Group| !matches!(group, Group::Interface | Group::Run);
    let is_same = |own: &Scene| {
        let used = VARIABLES.iter().filter(|variable| {
            counts(variable.group) && (is_used(variable, scene) || is_used(variable, own))
        });
        used.into_iter().all(|variable| variable.show(own) == variable.show(scene))
    };
    let row = Stored::rows()
        .find(|row| changed_free_plate(&row.changes).is_ok_and(|own| is_same(&own)))?;
    let uncertainty = larger(10f64.powi(-row.trusted), f64::EPSILON);
    Some((row, uncertainty))
}

/// The depth that the printed scheme approaches as its step goes to zero, from two fine steps of a scheme of first order.
pub(super) fn printed_limit(scene: &Scene, end_s: f64) -> Option<Reference> {
    let by = |steps: f64| printed(scene, end_s / steps).ok()?.results[0];
    let (coarse_m, fine_m) = (by(PRINTED_STEPS)?, by(2.0 * PRINTED_STEPS)?);
    let depth_m = 2.0 * fine_m - coarse_m;
    let mut results = [None; RESULTS.len()];
    // It ends on a whole step: no step makes that error of the time smaller.
    results[0] = Some(depth_m);
    Some(Reference {
        basis: ReferenceSource::OwnLimit,
        outcome: Outcome::Arrested,
        results,
        uncertainty: Some(larger((depth_m / fine_m - 1.0).abs(), f64::EPSILON)),
    })
}
