//! The evaluation of one candidate: the mass of its hardware, and the velocity at which plate or hardware fails.

use std::sync::Arc;

use crate::study::compare::hardware::{InstalledSpring, MechanismLoadCase, is_held};
use crate::study::compare::sizing::sized;
use crate::study::compare::{Candidate, Entry, Failure, Hardware, hold_spring_mass};
use crate::study::context::{Context, never_cancel};
use crate::study::limit::{self, BESIDE_LIMIT, Limit};
use crate::study::outcome::PointOutcome;
use crate::study::verdict::Verdict;
use cmra_engine::model::run::{EndReason, Run};
use cmra_engine::model::scene::Scene;
use cmra_engine::model::simulate::{Settings, simulate};
use cmra_engine::model::variables;

/// Relative width of the final bracket around the velocity at which the hardware fails.
const WIDTH: f64 = 1e-9;

/// Evaluation of a candidate.
pub(super) struct CandidateEvaluator<'c, 'w> {
    pub(super) scene: Arc<Scene>,
    pub(super) hardware: Hardware,
    pub(super) context: &'c mut Context<'w>,
}

/// Limit velocities of plate and hardware.
struct Limits {
    /// Ballistic limit of the plate alone.
    perforation: Limit,
    /// The shot at the design velocity.
    run: Run,
    /// Fastest shot that the plate alone stops, just below its ballistic limit.
    fastest: Option<Run>,
    built: InstalledSpring,
    /// Whether that shot sizes the springs, since the design shot perforates.
    is_sized_at_limit: bool,
    /// Limit of plate and hardware, m/s.
    limit_m_s: Option<f64>,
    /// Part that fails at the limit before the plate is perforated.
    failure: Option<Failure>,
}

/// Computes the limit velocity of a valid scene if its spring must survive, m/s.
pub fn limit_if_spring_survives_m_s(scene: &Scene) -> Result<f64, String> {
    variables::require_single(scene).map_err(|error| error.to_string())?;
    let mut own = scene.clone();
    hold_spring_mass(&mut own);
    let mut watch = never_cancel;
    let context = &mut Context::new(1, &mut watch);
    let limits =
        CandidateEvaluator { scene: Arc::new(own), hardware: Hardware::default(), context }
            .limits();
    let Limits { perforation, limit_m_s, failure, .. } = limits.ok_or("no limit was found")?;
    let why = || match failure {
        Some(failure) => failure.words.to_owned(),
        None => perforation.absence().unwrap_or_default(),
    };
    limit_m_s.ok_or_else(why)
}

impl CandidateEvaluator<'_, '_> {
    /// Computes the limits of plate and hardware; `None` if cancelled.
    fn limits(&mut self) -> Option<Limits> {
        let scene = Arc::clone(&self.scene);
        let perforation = limit::alone(&scene, self.context).ok()?;
        if perforation == Limit::Unknown {
            return None;
        }
        let design_m_s = scene.projectile.velocity_m_s;
        let run = self.fire(design_m_s)?;
        let plate_m_s = perforation.velocity_m_s();
        let never_m_s = (perforation == Limit::Never).then_some(limit::RANGE_M_S.1);
        let top_m_s = plate_m_s.or(never_m_s);
        let fastest = match top_m_s.and_then(|limit_m_s| self.below(limit_m_s)) {
            Some(velocity_m_s) => Some(self.fire(velocity_m_s)?),
            None => None,
        };
        // If the design shot perforates, the hardware is that of the fastest shot that is stopped.
        let is_through = PointOutcome::from_run(&run).is_through() && plate_m_s.is_some();
        let is_sized_at_limit = is_through && fastest.is_some();
        let sizing = fastest.as_ref().filter(|_| is_through).unwrap_or(&run);
        let built = InstalledSpring::from_scene(&scene, self.hardware, &demand(sizing));
        let at_design = built.failure(&scene, &demand(&run)).map(|failure| (design_m_s, failure));
        let at_design = at_design.filter(|_| top_m_s.is_some_and(|top_m_s| design_m_s < top_m_s));
        let at_top = fastest.as_ref().and_then(|run| built.failure(&scene, &demand(run)));
        let fails = at_design.or_else(|| top_m_s.zip(at_top));
        let (limit_m_s, failure) = match fails {
            Some(fails) => {
                let (limit_m_s, failure) = self.overload(fails, &built)?;
                (limit_m_s, Some(failure))
            }
            None => (plate_m_s, None),
        };
        Some(Limits { perforation, run, fastest, built, is_sized_at_limit, limit_m_s, failure })
    }

    /// Evaluates a candidate; `None` if cancelled.
    pub(super) fn entry(&mut self, candidate: Candidate) -> Option<Entry> {
        let scene = Arc::clone(&self.scene);
        let Limits { perforation, run, fastest, built, is_sized_at_limit, limit_m_s, failure } =
            self.limits()?;
        let at_limit = match limit_m_s.and_then(|limit_m_s| self.below(limit_m_s)) {
            Some(_) if failure.is_none() => fastest,
            Some(velocity_m_s) => Some(self.fire(velocity_m_s)?),
            None => None,
        };
        if !self.context.should_continue() {
            return None;
        }
        Some(Entry {
            shot: Verdict::with_limit(&scene, perforation.velocity_m_s()),
            candidate,
            is_held: is_held(&scene),
            areal_kg_m2: built.areal_kg_m2(&scene),
            spring_kg: built.spring_kg,
            is_sized_at_limit,
            perforation,
            limit_m_s,
            failure,
            sized: sized(&scene, self.hardware),
            at_limit,
            run,
        })
    }

    fn aimed(&self, velocity_m_s: f64) -> Scene {
        let mut aimed = (*self.scene).clone();
        aimed.projectile.velocity_m_s = velocity_m_s;
        aimed
    }

    /// Returns `true` if a shot is fast enough to reach a plate that has a velocity of its own.
    fn reaches(&self, velocity_m_s: f64) -> bool {
        self.aimed(velocity_m_s).closing_velocity_m_s() > 0.0
    }

    /// Runs a shot that reaches the plate, with its series for the mount force; `None` if cancelled.
    fn fire(&mut self, velocity_m_s: f64) -> Option<Run> {
        let aimed = Arc::new(self.aimed(velocity_m_s));
        let run = simulate(&aimed, &Settings::SERIES, &mut self.context.observer()).ok()?;
        (run.end != EndReason::Cancelled).then_some(run)
    }

    /// Returns a velocity just below a limit, m/s; `None` if it does not reach the plate.
    fn below(&self, limit_m_s: f64) -> Option<f64> {
        Some(limit_m_s * (1.0 - BESIDE_LIMIT)).filter(|it| self.reaches(*it))
    }

    /// Finds the velocity above which the hardware fails before the plate is perforated, m/s, and the part that fails; `None` if cancelled.
    /// There is no velocity if it fails in every shot that reaches the plate.
    fn overload(
        &mut self,
        (mut fails_m_s, mut failure): (f64, Failure),
        built: &InstalledSpring,
    ) -> Option<(Option<f64>, Failure)> {
        let scene = Arc::clone(&self.scene);
        let mut holds_m_s = 0.0;
        let mut has_held = false;
        while fails_m_s > limit::RANGE_M_S.0 {
            if fails_m_s - holds_m_s <= WIDTH * fails_m_s {
                return Some((Some(fails_m_s).filter(|_| has_held), failure));
            }
            let between_m_s = 0.5 * (holds_m_s + fails_m_s);
            if !self.reaches(between_m_s) {
                holds_m_s = between_m_s;
                continue;
            }
            match built.failure(&scene, &demand(&self.fire(between_m_s)?)) {
                None => (holds_m_s, has_held) = (between_m_s, true),
                Some(found) => (fails_m_s, failure) = (between_m_s, found),
            }
        }
        Some((None, failure))
    }
}

fn demand(run: &Run) -> MechanismLoadCase {
    MechanismLoadCase::from_scene(&run.scene, run.displacements_m())
}
