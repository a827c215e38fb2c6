//! The evaluation of one candidate: the mass of its hardware, and the velocity at which plate or hardware fails.

use std::sync::Arc;

use crate::model::run::{EndReason, Outcome, Run};
use crate::model::scene::Scene;
use crate::model::simulate::{Settings, simulate};
use crate::study::compare::hardware::Built;
use crate::study::compare::sized::{self, sized};
use crate::study::compare::solid::{Thickness, thickness_of_limit};
use crate::study::compare::{Candidate, Entry, Failure, Hardware, Load, is_held, make};
use crate::study::context::{Context, to_its_end};
use crate::study::limit::{self, JUST_BELOW, Limit};

/// Relative width to which the velocity is closed in at which the hardware fails.
const WIDTH: f64 = 1e-9;

/// One candidate on its way to an entry.
pub(super) struct Judge<'c, 'w> {
    pub(super) scene: Arc<Scene>,
    pub(super) hardware: Hardware,
    pub(super) context: &'c mut Context<'w>,
}

/// Up to which velocity plate and hardware hold.
struct Limits {
    /// Of the plate alone.
    perforation: Limit,
    /// The shot at the design velocity.
    run: Run,
    /// The fastest shot that the plate itself stops, just below its limit, m/s.
    fastest: Option<(f64, Run)>,
    built: Built,
    /// Of plate and hardware, m/s.
    limit_m_s: Option<f64>,
    /// What fails there before the plate is perforated.
    failure: Option<Failure>,
}

/// The limit velocity of a valid scene with its hardware, which is sized for the scene's own shot, m/s.
///
/// # Errors
/// Why there is none.
pub fn limit_with_hardware_m_s(scene: &Scene) -> Result<f64, String> {
    let scene = Arc::new(make(scene, Candidate::Scene, None).ok_or("no such armour")?);
    let mut watch = to_its_end;
    let context = &mut Context::new(1, &mut watch);
    let limits = Judge { scene, hardware: Hardware::default(), context }.limits();
    let Limits { perforation, limit_m_s, failure, .. } = limits.ok_or("no limit was found")?;
    let why = || failure.map_or_else(|| perforation.absence().unwrap_or_default(), Failure::words);
    limit_m_s.ok_or_else(why)
}

impl Judge<'_, '_> {
    /// The limits of plate and hardware; `None` when stopped.
    fn limits(&mut self) -> Option<Limits> {
        let scene = Arc::clone(&self.scene);
        let perforation = limit::alone(&scene, self.context).ok()?;
        if perforation == Limit::Unknown {
            return None;
        }
        let run = self.fire(scene.projectile.velocity_m_s)?;
        let plate_m_s = perforation.velocity_m_s();
        let never_m_s = (perforation == Limit::Never).then_some(limit::RANGE_M_S.1);
        let fastest = match plate_m_s.or(never_m_s) {
            Some(limit_m_s) => Some((limit_m_s, self.fire_below(limit_m_s)?)),
            None => None,
        };
        // Where the design shot perforates, the hardware is that of the fastest shot that is stopped.
        let is_through = run.shot_outcome() == Outcome::Perforated && plate_m_s.is_some();
        let sizing = fastest.as_ref().filter(|_| is_through).map_or(&run, |(_, run)| run);
        let built = Built::of(&scene, &self.hardware, sizing);
        let failure = fastest.as_ref().and_then(|(_, run)| built.failure(run));
        let (limit_m_s, failure) = match (&fastest, failure) {
            (Some((top_m_s, _)), Some(failure)) => {
                let (limit_m_s, failure) = self.limit(*top_m_s, failure, &built)?;
                (limit_m_s, Some(failure))
            }
            (_, _) => (plate_m_s, None),
        };
        Some(Limits { perforation, run, fastest, built, limit_m_s, failure })
    }

    /// The entry; `None` when stopped.
    pub(super) fn entry(&mut self, candidate: Candidate) -> Option<Entry> {
        let scene = Arc::clone(&self.scene);
        let Limits { perforation, run, fastest, built, limit_m_s, failure } = self.limits()?;
        let limit_load = match (limit_m_s, &fastest) {
            (Some(_), Some((_, run))) if failure.is_none() => Load::of(run),
            (Some(limit), _) => Load::of(&self.fire_below(limit)?),
            (None, _) => Load::default(),
        };
        if !self.context.goes_on() {
            return None;
        }
        let sized = sized(&scene, &self.hardware, sized::WIDTH);
        let areal_kg_m2 = built.areal_kg_m2(&scene);
        let equivalent = limit_m_s.and_then(|limit| thickness_of_limit(&scene, limit, false));
        let equivalent_m = equivalent.and_then(Thickness::root_m);
        let equivalent = equivalent_m.map(|thickness| thickness * scene.target.density_kg_m3);
        let stays = matches!(run.shot_outcome(), Outcome::Arrested | Outcome::Separated);
        Some(Entry {
            candidate,
            outcome: run.shot_outcome(),
            is_held: is_held(&scene),
            areal_kg_m2,
            spring_kg: built.spring_kg(),
            perforation,
            limit_m_s,
            failure,
            sized,
            equivalent_m,
            as_built: equivalent.zip(areal_kg_m2).map(|(equal, own)| equal / own),
            load: Load::of(&run),
            limit_load,
            depth_m: run.shot_depth_m().filter(|_| stays),
            residual_m_s: run.shot_residual_m_s(),
            scene,
        })
    }

    /// One run, with its series for the mount force; `None` when it was stopped.
    fn fire(&mut self, velocity_m_s: f64) -> Option<Run> {
        let mut aimed = (*self.scene).clone();
        aimed.projectile.velocity_m_s = velocity_m_s;
        let run =
            simulate(&Arc::new(aimed), &Settings::SERIES, &mut self.context.observer()).ok()?;
        (run.end != EndReason::Cancelled).then_some(run)
    }

    fn fire_below(&mut self, limit_m_s: f64) -> Option<Run> {
        self.fire(limit_m_s * (1.0 - JUST_BELOW))
    }

    /// The limit velocity with hardware that fails before the plate is perforated, and what fails there; `None` when stopped.
    fn limit(
        &mut self,
        top_m_s: f64,
        mut failure: Failure,
        built: &Built,
    ) -> Option<(Option<f64>, Failure)> {
        let design_m_s = self.scene.projectile.velocity_m_s;
        let (mut holds, mut fails) = (0.0, top_m_s);
        let mut look = |velocity_m_s: f64, holds: &mut f64, fails: &mut f64| {
            match built.failure(&self.fire(velocity_m_s)?) {
                None => *holds = velocity_m_s,
                Some(found) => (*fails, failure) = (velocity_m_s, found),
            }
            Some(())
        };
        // What was sized for a shot holds it, and nothing faster.
        for velocity_m_s in [design_m_s, design_m_s * (1.0 + JUST_BELOW)] {
            if velocity_m_s < fails {
                look(velocity_m_s, &mut holds, &mut fails)?;
            }
        }
        if holds >= design_m_s && fails <= design_m_s * (1.0 + JUST_BELOW) {
            return Some((Some(design_m_s), failure));
        }
        while fails - holds > WIDTH * fails && fails > limit::RANGE_M_S.0 {
            look(0.5 * (holds + fails), &mut holds, &mut fails)?;
        }
        Some(((fails > limit::RANGE_M_S.0).then_some(fails), failure))
    }
}
