//! The evaluation of one candidate: the mass of its hardware, and the velocity at which plate or hardware fails.

use std::ops::Range;
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

/// A shot that the hardware does not hold.
#[derive(Clone, Copy)]
struct Overload {
    /// A slower shot that it holds, m/s; 0 where none is known.
    holds_m_s: f64,
    fails_m_s: f64,
    failure: Failure,
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
    /// A shot slower than the design shot that the hardware does not hold, m/s, and what fails.
    slower: Option<(f64, Failure)>,
}

/// How many plates of a stack a shot perforates.
fn passed(run: &Run) -> usize {
    run.stack.as_ref().map_or(0, |stack| stack.passed())
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
        let design_m_s = scene.projectile.velocity_m_s;
        let (mut overload, mut slower) = (None, None);
        if let Some((top_m_s, fastest)) = &fastest {
            let design = passed(&run);
            overload = self.overload(design_m_s, *top_m_s, design..passed(fastest), &built).ok()?;
            let at_top = built.failure(fastest).map(|failure| (*top_m_s, failure));
            let at_design = built.failure(&run).filter(|_| design_m_s < *top_m_s);
            let at_end = at_design.map(|failure| (design_m_s, failure)).or(at_top);
            if at_design.is_some() || overload.is_none() {
                overload = at_end.map(|(fails_m_s, failure)| Overload {
                    holds_m_s: 0.0,
                    fails_m_s,
                    failure,
                });
            }
            if let Some(found) = self.overload(0.0, design_m_s, 0..design, &built).ok()? {
                let (velocity_m_s, failure) = self.limit(found, &built)?;
                slower = velocity_m_s.map(|velocity_m_s| (velocity_m_s, failure));
            }
        }
        let (limit_m_s, failure) = match overload {
            Some(overload) => {
                let (limit_m_s, failure) = self.limit(overload, &built)?;
                (limit_m_s, Some(failure))
            }
            None => (plate_m_s, None),
        };
        Some(Limits { perforation, run, fastest, built, limit_m_s, failure, slower })
    }

    /// The entry; `None` when stopped.
    pub(super) fn entry(&mut self, candidate: Candidate) -> Option<Entry> {
        let scene = Arc::clone(&self.scene);
        let Limits { perforation, run, fastest, built, limit_m_s, failure, slower } =
            self.limits()?;
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
            slower,
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

    /// The slowest shot at which the hardware fails, of those from one velocity up to another that load a plate most; an error when
    /// stopped. Each is just too slow to perforate one more plate of a stack, from so many on: faster ones load that plate less.
    fn overload(
        &mut self,
        from_m_s: f64,
        to_m_s: f64,
        plates: Range<usize>,
        built: &Built,
    ) -> Result<Option<Overload>, ()> {
        let mut known_m_s = from_m_s;
        for plate in plates {
            let (mut low, mut high) = (known_m_s, to_m_s);
            while high - low > WIDTH * high && high > limit::RANGE_M_S.0 {
                let middle = 0.5 * (low + high);
                let is_through = passed(&self.fire(middle).ok_or(())?) > plate;
                (low, high) = if is_through { (low, middle) } else { (middle, high) };
            }
            if let Some(failure) = built.failure(&self.fire_below(high).ok_or(())?) {
                return Ok(Some(Overload { holds_m_s: known_m_s, fails_m_s: high, failure }));
            }
            known_m_s = high;
        }
        Ok(None)
    }

    /// The limit velocity with hardware that fails before the plate is perforated, and what fails there; `None` when stopped.
    fn limit(&mut self, overload: Overload, built: &Built) -> Option<(Option<f64>, Failure)> {
        let design_m_s = self.scene.projectile.velocity_m_s;
        let Overload { holds_m_s: mut holds, fails_m_s: mut fails, mut failure } = overload;
        let mut look = |velocity_m_s: f64, holds: &mut f64, fails: &mut f64| {
            match built.failure(&self.fire(velocity_m_s)?) {
                None => *holds = velocity_m_s,
                Some(found) => (*fails, failure) = (velocity_m_s, found),
            }
            Some(())
        };
        // What was sized for a shot holds it, and nothing faster.
        for velocity_m_s in [design_m_s, design_m_s * (1.0 + JUST_BELOW)] {
            if holds < velocity_m_s && velocity_m_s < fails {
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
