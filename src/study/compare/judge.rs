//! The evaluation of one candidate: the mass of its hardware, and the velocity at which plate or hardware fails.

use std::sync::Arc;

use crate::model::run::{EndReason, Outcome, Run};
use crate::model::scene::Scene;
use crate::model::simulate::{Settings, simulate};
use crate::model::variables::VariableError;
use crate::study::compare::hardware::Built;
use crate::study::compare::sized::{self, sized};
use crate::study::compare::solid::thickness_of_limit_m;
use crate::study::compare::{
    Candidate, Entry, Failure, Hardware, Load, is_held, outcome, residual_m_s,
};
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
    pub(super) fn entry(&mut self, candidate: Candidate) -> Result<Option<Entry>, VariableError> {
        let scene = Arc::clone(&self.scene);
        let design_m_s = scene.projectile.velocity_m_s;
        let perforation = limit::alone(&scene, self.context)?;
        if perforation == Limit::Unknown {
            return Ok(None);
        }
        let Some(run) = self.fire(design_m_s)? else { return Ok(None) };
        // Where the design shot perforates, the hardware is that of the fastest shot that is stopped.
        let sizing = match perforation.velocity_m_s() {
            Some(limit) if outcome(&run) == Outcome::Perforated => {
                let Some(run) = self.fire(limit * (1.0 - BELOW_LIMIT))? else { return Ok(None) };
                Some(run)
            }
            Some(_) | None => None,
        };
        let built = Built::of(&scene, &self.hardware, sizing.as_ref().unwrap_or(&run));
        let Some(BuiltLimit { limit_m_s, failure }) = self.limit(perforation, &built)? else {
            return Ok(None);
        };
        let limit_load = match limit_m_s {
            Some(limit) => {
                let Some(run) = self.fire(limit * (1.0 - BELOW_LIMIT))? else { return Ok(None) };
                Load::of(&run)
            }
            None => Load::default(),
        };
        if !self.context.goes_on() {
            return Ok(None);
        }
        let sized = sized(&scene, &self.hardware, sized::WIDTH);
        let areal_kg_m2 = built.areal_kg_m2(&scene);
        let equivalent_m = limit_m_s.and_then(|limit| thickness_of_limit_m(&scene, limit));
        let equivalent = equivalent_m.map(|thickness| thickness * scene.target.density_kg_m3);
        let stays = matches!(outcome(&run), Outcome::Arrested | Outcome::Separated);
        let depth_m =
            run.stack.as_ref().map_or(run.final_penetration_m, |stack| stack.penetration_m);
        Ok(Some(Entry {
            candidate,
            outcome: outcome(&run),
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
            residual_m_s: residual_m_s(&run),
            scene,
        }))
    }

    /// One run, with its series for the mount force; `None` when it was stopped.
    fn fire(&mut self, velocity_m_s: f64) -> Result<Option<Run>, VariableError> {
        let settings = Settings { series: true, estimate: false };
        let mut aimed = (*self.scene).clone();
        aimed.projectile.velocity_m_s = velocity_m_s;
        let run = simulate(&Arc::new(aimed), &settings, &mut self.context.observer())?;
        Ok((run.end != EndReason::Cancelled).then_some(run))
    }

    /// The limit velocity with this hardware, and what fails there; `None` when stopped.
    fn limit(
        &mut self,
        perforation: Limit,
        built: &Built,
    ) -> Result<Option<BuiltLimit>, VariableError> {
        let plate_m_s = perforation.velocity_m_s();
        let top_m_s = match plate_m_s {
            Some(velocity_m_s) => velocity_m_s,
            None if perforation == Limit::Never => limit::RANGE_M_S.1,
            None => return Ok(Some(BuiltLimit::default())),
        };
        let failure_at = |judge: &mut Self, velocity_m_s: f64| {
            judge.fire(velocity_m_s).map(|run| run.map(|run| built.failure(&run)))
        };
        let Some(at_top) = failure_at(self, top_m_s * (1.0 - BELOW_LIMIT))? else {
            return Ok(None);
        };
        let Some(mut failure) = at_top else {
            return Ok(Some(BuiltLimit { limit_m_s: plate_m_s, failure: None }));
        };
        // What was sized for a shot holds it, and nothing faster.
        let design_m_s = self.scene.projectile.velocity_m_s;
        let (mut holds, mut fails) = (0.0, top_m_s);
        for velocity_m_s in [design_m_s, design_m_s * (1.0 + BELOW_LIMIT)] {
            if velocity_m_s < fails {
                match failure_at(self, velocity_m_s)? {
                    None => return Ok(None),
                    Some(None) => holds = velocity_m_s,
                    Some(Some(found)) => (fails, failure) = (velocity_m_s, found),
                }
            }
        }
        if holds >= design_m_s && fails <= design_m_s * (1.0 + BELOW_LIMIT) {
            return Ok(Some(BuiltLimit { limit_m_s: Some(design_m_s), failure: Some(failure) }));
        }
        while fails - holds > WIDTH * fails && fails > limit::RANGE_M_S.0 {
            let middle = 0.5 * (holds + fails);
            match failure_at(self, middle)? {
                None => return Ok(None),
                Some(None) => holds = middle,
                Some(Some(found)) => (fails, failure) = (middle, found),
            }
        }
        let limit_m_s = (fails > limit::RANGE_M_S.0).then_some(fails);
        Ok(Some(BuiltLimit { limit_m_s, failure: Some(failure) }))
    }
}
