//! Reference results of a comparison, each by another family of methods than the compared one.
//!
//! For stored scenes depth and time are known to 18 digits, by an 80-bit Taylor series and 30-digit arithmetic. All other results are
//! computed twice with the loop of the simulation: by the steps of the engine, and by DOP853 (Radau IIA of order five for stiff scenes).
//! Each is the reference for the other, and their difference is the uncertainty of both. Both have the same equations of motion, which
//! tests check against independent ones.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::study::accuracy::method::{
    Answer, Compared, Results, answer_of, first_arrest_of, printed,
};
use cmra_engine::model::impact::IntegrationMethod;
use cmra_engine::model::impact::reference_by;
use cmra_engine::model::reference::Stored;
use cmra_engine::model::run::{Observer, Outcome, Run, RunSnapshot};
use cmra_engine::model::scene::{ContactModel, InterfaceLaw, Scene};
use cmra_engine::model::variables::{Group, VARIABLES, changed_free_plate, is_used};
use cmra_engine::numerics::larger;

/// Number of steps per contact for the limit of the printed scheme; a second run with another number gives the extrapolation.
const PRINTED_STEPS: f64 = 5e4;
/// Tolerance of the references.
const TIGHT: f64 = 1e-13;
/// Tolerance of the reference by Radau IIA of order five, whose run time grows faster with the accuracy.
const TIGHT_OF_ORDER_FIVE: f64 = 1e-12;
/// Negligible displacement, relative to the nose radius; a locked plate moves less.
const NO_LENGTH: f64 = 1e-9;

/// Source of a reference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReferenceSource {
    /// Depth and time of this stored scene.
    Stored(&'static str),
    /// Engine with the tolerance of a reference.
    Engine,
    /// DOP853 with the same loop.
    Dop853,
    /// Radau IIA of order five with the same loop, for stiff scenes.
    Radau,
    /// Limit of the printed scheme for a vanishing step size.
    OwnLimit,
}

impl ReferenceSource {
    /// Returns a short text.
    pub fn label(self) -> String {
        match self {
            Self::Stored(row) => format!("stored digits, row {row}"),
            Self::Engine => "engine at 1e-13".to_owned(),
            Self::Dop853 => "DOP853 at 1e-13".to_owned(),
            Self::Radau => "Radau IIA 5 at 1e-12".to_owned(),
            Self::OwnLimit => "its own limit".to_owned(),
        }
    }

    /// Returns the letter after an error on a page.
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

/// Reference results.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reference {
    /// Source of the results.
    pub basis: ReferenceSource,
    /// Outcome of the shot.
    pub outcome: Outcome,
    /// Results.
    pub results: Results,
    /// Relative uncertainty of depth and time; `None` if there is no second result.
    pub uncertainty: Option<f64>,
}

impl Reference {
    fn new(basis: ReferenceSource, answer: &Answer) -> Self {
        let Answer { outcome, results, .. } = *answer;
        Self { basis, outcome, results, uncertainty: None }
    }

    /// Returns the relative errors of results; that of the last velocity is relative to the impact velocity.
    pub fn errors(&self, scene: &Scene, results: &Results) -> Results {
        let shot = &scene.projectile;
        let least = |of| match of {
            Compared::Displacement => NO_LENGTH * shot.tip_radius_m,
            Compared::LastVelocity => shot.velocity_m_s,
            Compared::Depth
            | Compared::Time
            | Compared::Force
            | Compared::LastTime
            | Compared::MountForce => 0.0,
        };
        Results::new(|of| {
            let (own, right) = (results.get(of)?, self.results.get(of)?);
            let scale = larger(right.abs(), larger(least(of), f64::MIN_POSITIVE));
            Some((own - right).abs() / scale)
        })
    }

    /// Returns the largest error of all results; NaN if a result exists only here or only in the reference.
    pub fn error_of_all(&self, scene: &Scene, results: &Results) -> f64 {
        if results.exist() != self.results.exist() {
            return f64::NAN;
        }
        self.errors(scene, results).known().map(|it| it.1).fold(0.0, larger)
    }

    /// Returns the time of first arrest or exit, s.
    pub fn end_s(&self) -> f64 {
        self.results.get(Compared::Time).unwrap_or(f64::NAN)
    }
}

/// References of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct References {
    /// Reference by the steps of the engine, for all other methods.
    pub engine: Option<Reference>,
    /// Reference by another family of methods, for the engine.
    pub other: Option<Reference>,
}

impl References {
    /// Computes the references of a valid scene.
    pub fn from_scene(scene: &Arc<Scene>, observer: Observer<'_>) -> Self {
        Self::new(scene, |run| answer_of(run).ok(), observer)
    }

    /// Computes the references for the first arrest in a valid scene whose outcome stays undecided; their outcome is
    /// [`Outcome::Moving`].
    pub fn of_first_arrest(scene: &Arc<Scene>, observer: Observer<'_>) -> Self {
        let until_arrest = &mut |look: &RunSnapshot<'_>| match (look.so_far)() {
            Some(run) if run.first_arrest.is_some() => ControlFlow::Break(()),
            _ => observer(look),
        };
        Self::new(scene, first_arrest_of, until_arrest)
    }

    fn new(
        scene: &Arc<Scene>,
        answer_of: impl Fn(&Run) -> Option<Answer>,
        observer: Observer<'_>,
    ) -> Self {
        let mut by = |stepping: IntegrationMethod| {
            answer_of(&reference_by(stepping, scene, &mut *observer).ok().flatten()?)
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
            let of_end = [Compared::Depth, Compared::Time].map(|of| errors.get(of));
            let worst = of_end.into_iter().flatten().fold(f64::EPSILON, larger);
            (one.outcome == other.outcome).then_some(worst)
        });
        let stored = stored(scene);
        for reference in [&mut both.engine, &mut both.other].into_iter().flatten() {
            reference.uncertainty = apart;
            if let Some((row, uncertainty)) = &stored {
                reference.basis = ReferenceSource::Stored(row.name);
                reference.outcome = row.outcome;
                let is_arrested = row.outcome == Outcome::Arrested;
                reference.results.set(Compared::Depth, is_arrested.then_some(row.depth_m));
                reference.results.set(Compared::Time, Some(row.t_s));
                reference.uncertainty = Some(*uncertainty);
            }
        }
        both
    }

    /// Returns a reference, that of the engine if it exists.
    pub fn any(&self) -> Option<Reference> {
        self.engine.or(self.other)
    }
}

/// Returns the stored results of a scene and their uncertainty; `None` for another scene. The stored scenes have one plate, the
/// hydrodynamic law and a fused interface.
pub(in crate::study) fn stored(scene: &Scene) -> Option<(Stored, f64)> {
    let is_other = scene.contact.model != ContactModel::Hydrodynamic || scene.is_stack();
    if is_other || scene.interface.law != InterfaceLaw::Fused {
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

/// Returns the limit of the printed scheme for a vanishing step size, by extrapolation from two small step sizes of a first-order scheme.
pub(super) fn printed_limit(scene: &Scene, end_s: f64) -> Option<Reference> {
    let by = |steps: f64| printed(scene, end_s / steps).ok()?.results.get(Compared::Depth);
    let (coarse_m, fine_m) = (by(PRINTED_STEPS)?, by(2.0 * PRINTED_STEPS)?);
    let depth_m = 2.0 * fine_m - coarse_m;
    let mut results = Results::default();
    // The scheme ends at the end of a step: the time has an error of the order of the step size.
    results.set(Compared::Depth, Some(depth_m));
    Some(Reference {
        basis: ReferenceSource::OwnLimit,
        outcome: Outcome::Arrested,
        results,
        uncertainty: Some(larger((depth_m / fine_m - 1.0).abs(), f64::EPSILON)),
    })
}
