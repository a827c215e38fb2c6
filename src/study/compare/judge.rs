//! The evaluation of one candidate: the mass of its hardware, and the velocity at which plate or hardware fails.

use std::sync::Arc;

use crate::model::run::{EndReason, Outcome, Run};
use crate::model::scene::Scene;
use crate::model::simulate::{Settings, simulate};
use crate::study::compare::hardware::Built;
use crate::study::compare::sized::{self, sized};
use crate::study::compare::solid::thickness_of_limit_m;
use crate::study::compare::{Candidate, Entry, Failure, Hardware, Load, is_held};
use crate::study::context::Context;
use crate::study::limit::{self, Limit};

/// How far below a limit the shot is fired that shows what the mechanism bears there, relative.
const BELOW_LIMIT: f64 = 1e-6;
/// Relative width to which the velocity is closed in at which the hardware fails.
const WIDTH: f64 = 1e-9;

/// The limit velocity with the hardware, and what fails there; without a failure the plate is perforated.
#[derive(Clone, Copy, Debug, Default)]
struct BuiltLimit {
    limit_m_s: Option<f64>,
    failure: Option<Failure>,
}

/// One candidate on its way to an entry.
pub(super) struct Judge<'c, 'w> {
    pub(super) scene: Arc<Scene>,
    pub(super) hardware: Hardware,
    pub(super) context: &'c mut Context<'w>,
}

impl Judge<'_, '_> {
    /// The entry; `None` when stopped.
    pub(super) fn entry(&mut self, candidate: Candidate) -> Option<Entry> {
        let scene = Arc::clone(&self.scene);
        let design_m_s = scene.projectile.velocity_m_s;
        let perforation = limit::alone(&scene, self.context).ok()?;
        if perforation == Limit::Unknown {
            return None;
        }
        let run = self.fire(design_m_s)?;
        // Where the design shot perforates, the hardware is that of the fastest shot that is stopped.
        let sizing = match perforation.velocity_m_s() {
            Some(limit) if run.shot_outcome() == Outcome::Perforated => {
                Some(self.fire_below(limit)?)
            }
            Some(_) | None => None,
        };
        let built = Built::of(&scene, &self.hardware, sizing.as_ref().unwrap_or(&run));
        let BuiltLimit { limit_m_s, failure } = self.limit(perforation, &built)?;
        let limit_load = match limit_m_s {
            Some(limit) => Load::of(&self.fire_below(limit)?),
            None => Load::default(),
        };
        if !self.context.goes_on() {
            return None;
        }
        let sized = sized(&scene, &self.hardware, sized::WIDTH);
        let areal_kg_m2 = built.areal_kg_m2(&scene);
        let equivalent_m = limit_m_s.and_then(|limit| thickness_of_limit_m(&scene, limit));
        let equivalent = equivalent_m.map(|thickness| thickness * scene.target.density_kg_m3);
        let stays = matches!(run.shot_outcome(), Outcome::Arrested | Outcome::Separated);
        let depth_m =
            run.stack.as_ref().map_or(run.final_penetration_m, |stack| stack.penetration_m);
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
            depth_m: depth_m.filter(|_| stays),
            residual_m_s: run.shot_residual_m_s(),
            scene,
        })
    }

    /// One run, with its series for the mount force; `None` when it was stopped.
    fn fire(&mut self, velocity_m_s: f64) -> Option<Run> {
        let settings = Settings { series: true, estimate: false };
        let mut aimed = (*self.scene).clone();
        aimed.projectile.velocity_m_s = velocity_m_s;
        let run = simulate(&Arc::new(aimed), &settings, &mut self.context.observer()).ok()?;
        (run.end != EndReason::Cancelled).then_some(run)
    }

    fn fire_below(&mut self, limit_m_s: f64) -> Option<Run> {
        self.fire(limit_m_s * (1.0 - BELOW_LIMIT))
    }

    /// The limit velocity with this hardware, and what fails there; `None` when stopped.
    fn limit(&mut self, perforation: Limit, built: &Built) -> Option<BuiltLimit> {
        let plate_m_s = perforation.velocity_m_s();
        let top_m_s = match plate_m_s {
            Some(velocity_m_s) => velocity_m_s,
            None if perforation == Limit::Never => limit::RANGE_M_S.1,
            None => return Some(BuiltLimit::default()),
        };
        let at_top = self.fire_below(top_m_s)?;
        let Some(mut failure) = built.failure(&at_top) else {
            return Some(BuiltLimit { limit_m_s: plate_m_s, failure: None });
        };
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
        for velocity_m_s in [design_m_s, design_m_s * (1.0 + BELOW_LIMIT)] {
            if velocity_m_s < fails {
                look(velocity_m_s, &mut holds, &mut fails)?;
            }
        }
        if holds >= design_m_s && fails <= design_m_s * (1.0 + BELOW_LIMIT) {
            return Some(BuiltLimit { limit_m_s: Some(design_m_s), failure: Some(failure) });
        }
        while fails - holds > WIDTH * fails && fails > limit::RANGE_M_S.0 {
            look(0.5 * (holds + fails), &mut holds, &mut fails)?;
        }
        let limit_m_s = (fails > limit::RANGE_M_S.0).then_some(fails);
        Some(BuiltLimit { limit_m_s, failure: Some(failure) })
    }
}
