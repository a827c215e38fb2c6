//! Comparison at equal areal mass: does moving armour pay?
//!
//! The comparison has a single design velocity: the impact velocity v of the scene.
//!
//! - Areal mass: the plate is a block of its material, so its face is `m_2`/(rho h). Plate and spring together are divided by that
//!   face: rho h (1 + spring/`m_2`). A damper, a stop and the mount are not counted.
//! - Spring: the one that the scene has. Where its mass is not known it weighs the greatest energy that it stores under the shot at v,
//!   over its energy per mass; where that shot perforates, under the fastest shot that is stopped.
//! - Limit if the spring must survive: the least impact velocity at which the plate is perforated or the hardware fails: the spring
//!   would have to store more than its known mass can, or leaves the range of its law (a beam yields, a table ends). A spring whose mass is not known holds whatever it stores, unless it is to be sized: then it has just the
//!   mass that the shot at v needs, and holds no faster one.
//! - Mass efficiency: areal mass of the thinnest solid plate on a rigid mount that stops the shot at v, over the areal mass of
//!   the thinnest armour of the scene's kind that does. That armour has the scene's mass ratio and mechanism, and a thickness of its
//!   own. A plate thicker than the shot needs gains nothing and loses nothing here. The mechanism pays where this is above 1.
//!
//! Closed form: without dishing a passage takes the volume pi R² h, and a limit velocity depends on volume over reduced mass alone. A
//! free plate therefore needs gamma/(1 + gamma) of the solid plate's thickness. A soft spring then stores the energy of the common
//! motion, `m_p` v²/(2 (1 + gamma)), and with e J/kg the mass efficiency is (1 + 1/gamma)/(1 + v²/(2 gamma (1 + gamma) e)): above 1
//! if and only if e > v²/(2 (1 + gamma)). Must not know files, threads, screens or a clock.

use std::fmt;
use std::sync::Arc;

use crate::study::context::{Context, Progress};
use crate::study::limit::Limit;
use crate::study::sweep::Axis;
use crate::study::verdict::{Decision, Verdict as ShotVerdict};
use cmra_engine::model::mechanism::{Inertia, Mechanism};
use cmra_engine::model::run::{Outcome, Run};
use cmra_engine::model::scene::{Mount, OwnMass, Scene};
use cmra_engine::model::variables::{self, VariableError};

mod candidate;
mod hardware;
pub mod map;
mod sizing;
mod solid;

pub use candidate::limit_if_spring_survives_m_s;
pub use hardware::{Failure, Hardware};
pub use sizing::{Absence, SizedArmour, THINNEST_M, WIDTH, mass_efficiency};

use candidate::CandidateEvaluator;

enumeration! {
    /// Who is compared.
    pub enum Candidate in CandidateRow {
        /// The word in files and on screens.
        word: &'static str,
    }
    /// The scene as it is.
    Scene { word: "scene" }
    /// Plates on a rigid mount.
    Rigid { word: "rigid mount" }
    /// Plates without spring, damper, stop and cocking.
    Free { word: "free plate" }
    /// A solid plate of the scene's areal mass, held rigidly.
    Solid { word: "solid plate" }
}

/// The figures of one candidate; `None` where a figure does not exist.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Candidate of the entry.
    pub candidate: Candidate,
    /// The shot at the design velocity.
    pub run: Run,
    /// The plate is stopped by something: a mount, a spring, a damper or a stop.
    pub is_held: bool,
    /// Everything of it over the plate's face, kg/m²; `None` where the spring's mass is not known.
    pub areal_kg_m2: Option<f64>,
    /// The mass of the springs, kg.
    pub spring_kg: Option<f64>,
    /// The limit of the plate alone: perforation.
    pub perforation: Limit,
    /// The limit if the spring must survive, m/s.
    pub limit_m_s: Option<f64>,
    /// The failure at that velocity; `None`: the plate is perforated.
    pub failure: Option<Failure>,
    /// The thinnest armour of this kind that stops the shot.
    pub sized: Result<SizedArmour, Absence>,
    /// A shot just below the limit velocity, where there is one.
    pub at_limit: Option<Run>,
    /// The verdict on the shot at the design velocity.
    pub shot: ShotVerdict,
}

impl Entry {
    /// Mass efficiency at the design velocity.
    pub fn mass_efficiency(&self) -> Option<f64> {
        self.sized.as_ref().ok().map(SizedArmour::mass_efficiency)
    }

    /// Depth of the hole, m; `None` when perforated.
    pub fn depth_m(&self) -> Option<f64> {
        let stays = matches!(self.run.shot_outcome(), Outcome::Arrested | Outcome::Separated);
        self.run.final_penetration_m.filter(|_| stays)
    }

    /// Whether nothing in the range of velocities looked at goes through, and nothing fails.
    pub fn is_beyond(&self) -> bool {
        self.limit_m_s.is_none() && self.perforation == Limit::Never
    }

    /// Why there is no limit velocity; `None` where there is one.
    pub fn no_limit(&self) -> Option<String> {
        if self.limit_m_s.is_some() { None } else { self.perforation.absence() }
    }
}

/// Whether an armour of this mass efficiency weighs what the solid plate does: a mechanism that does not move has no other.
pub fn is_equal(mass_efficiency: f64) -> bool {
    // A mechanism that does not move has no other, to the accuracy of the limits.
    (mass_efficiency - 1.0).abs() <= 1e-4
}

/// Whether the mechanism pays.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// Stops the shot, with this mass efficiency.
    Stops(f64),
    /// Does not stop the shot, for this reason.
    NotMet(String),
    /// Unknown: the run is undecided, or a figure is missing.
    Unknown,
}

impl Verdict {
    /// In words, for a page.
    pub fn message(&self) -> String {
        match self {
            Self::Stops(efficiency) if is_equal(*efficiency) => {
                "the mechanism makes no difference to a solid plate".to_owned()
            }
            Self::Stops(efficiency) if *efficiency > 1.0 => "the mechanism pays".to_owned(),
            Self::Stops(_) => "the mechanism does not pay".to_owned(),
            Self::NotMet(why) => format!("not met: {why}"),
            Self::Unknown => "undecided".to_owned(),
        }
    }

    /// Whether it pays; `None` where that is not known.
    pub fn pays(&self) -> Option<bool> {
        match self {
            Self::Stops(efficiency) => Some(*efficiency > 1.0 && !is_equal(*efficiency)),
            Self::NotMet(_) => Some(false),
            Self::Unknown => None,
        }
    }
}

/// The comparison.
#[derive(Clone, Debug, PartialEq)]
pub struct ComparisonReport {
    /// The scene; its impact velocity is the design velocity.
    pub scene: Arc<Scene>,
    /// Whose spring is judged.
    pub hardware: Hardware,
    /// The first plate's face, m².
    pub face_m2: f64,
    /// The springs know their own mass.
    pub spring_is_own: bool,
    /// The parts that take up energy and whose mass is not counted: a damper, a stop; empty: all mass is.
    pub uncounted: Vec<&'static str>,
    /// The candidates, without those that cannot be made or were not reached.
    pub entries: Vec<Entry>,
}

impl ComparisonReport {
    /// Returns the figures of a candidate.
    pub fn entry(&self, candidate: Candidate) -> Option<&Entry> {
        self.entries.iter().find(|entry| entry.candidate == candidate)
    }

    /// First requirement of chapter 4: depth over that in a solid plate of equal mass.
    pub fn depth_over_solid(&self) -> Option<f64> {
        Some(self.entry(Candidate::Scene)?.depth_m()? / self.entry(Candidate::Solid)?.depth_m()?)
    }

    /// Warns of an undecided mass efficiency, or of limits that measurements contradict; see [`Limit::caution`].
    pub fn caution(&self) -> Option<String> {
        let own = self.entry(Candidate::Scene).and_then(|own| own.sized.as_ref().err());
        own.filter(|absence| absence.is_open()).map(Absence::words).or_else(|| {
            self.entries.iter().find_map(|entry| entry.perforation.caution(&entry.run.scene))
        })
    }

    /// Whether the mechanism pays.
    pub fn verdict(&self) -> Verdict {
        let Some(own) = self.entry(Candidate::Scene) else { return Verdict::Unknown };
        let not_met = |why: &str| Verdict::NotMet(why.to_owned());
        let is_below_design = |it: f64| it < self.scene.projectile.velocity_m_s;
        if matches!(own.shot.decision, Decision::Open | Decision::Perforates) {
            return not_met("the design shot is not below the band of measured limits");
        }
        match own.run.shot_outcome() {
            Outcome::Perforated => return not_met("the design shot perforates the plate as built"),
            Outcome::Unmeasured => return Verdict::Unknown,
            _ if !own.is_held => return not_met("nothing stops plate and projectile"),
            // A run that still oscillates is decided by the limit.
            Outcome::Moving if own.perforation.velocity_m_s().is_none_or(is_below_design) => {
                return Verdict::Unknown;
            }
            Outcome::Arrested | Outcome::Separated | Outcome::Moving => {}
        }
        match (own.failure, &own.sized) {
            (Some(failure), _) if own.limit_m_s.is_none_or(is_below_design) => {
                not_met(&format!("under the design shot {}", failure.words))
            }
            (_, Ok(sized)) => Verdict::Stops(sized.mass_efficiency()),
            (_, Err(_)) => Verdict::Unknown,
        }
    }
}

/// The request; shown, it is the command that asks the same of a scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Request {
    /// Whose spring is judged.
    pub hardware: Hardware,
    /// The axes of a map of the mass efficiency; `None`: the candidates of the scene alone.
    pub map: Option<[Axis; 2]>,
}

impl fmt::Display for Request {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let is_sized = self.hardware == Hardware::Sized;
        f.write_str(if is_sized { "compare --size" } else { "compare" })?;
        if let Some([x, y]) = &self.map {
            write!(f, " --map {x},{y}")?;
        }
        Ok(())
    }
}

/// Compare.
pub fn compare(
    scene: &Arc<Scene>,
    hardware: Hardware,
    context: &mut Context<'_>,
) -> Result<ComparisonReport, VariableError> {
    variables::validate(scene)?;
    variables::require_single(scene)?;
    let mut report = ComparisonReport {
        scene: Arc::clone(scene),
        hardware,
        face_m2: face_m2(scene),
        spring_is_own: hardware::is_own(scene),
        uncounted: uncounted(scene),
        entries: Vec::new(),
    };
    context.expect(Candidate::ALL.len());
    // The areal mass of the scene is that of the solid plate.
    let [own, others @ ..] = Candidate::ALL;
    for (candidates, hardware) in [(&[own][..], hardware), (&others[..], Hardware::default())] {
        let areal = report.entries.first().and_then(|entry: &Entry| entry.areal_kg_m2);
        let made =
            candidates.iter().filter_map(|it| Some((*it, Arc::new(make(scene, *it, areal)?))));
        let made: Vec<(Candidate, Arc<Scene>)> = made.collect();
        made.iter().try_for_each(|(_, made)| variables::validate(made))?;
        let stop = context.stop();
        let judge = |(candidate, made): &(Candidate, Arc<Scene>)| {
            let watch = &mut |_: Progress, _: Option<&()>| stop.flow();
            let context = &mut Context::new(1, watch);
            CandidateEvaluator { scene: Arc::clone(made), hardware, context }.entry(*candidate)
        };
        let entries = context.map_items(&made, judge, |context, _| context.should_continue());
        let is_whole = entries.len() == made.len();
        report.entries.extend(entries);
        if !is_whole {
            break;
        }
    }
    Ok(report)
}

/// The parts of a scene that take up energy and whose mass is not counted.
fn uncounted(scene: &Scene) -> Vec<&'static str> {
    if !scene.is_sprung() {
        return Vec::new();
    }
    let mechanism = Mechanism::from_scene(scene);
    let damper = (!mechanism.damper.is_absent()).then_some("damper");
    damper.into_iter().chain(mechanism.stop.is_some().then_some("stop")).collect()
}

/// The area of a plate, m²: its mass over rho h.
pub fn face_m2(scene: &Scene) -> f64 {
    scene.plate_mass_kg() / (scene.target.density_kg_m3 * scene.target.thickness_m)
}

/// A candidate, given the areal mass of the scene itself; `None` where that would be needed and is not known.
fn make(scene: &Scene, candidate: Candidate, areal_kg_m2: Option<f64>) -> Option<Scene> {
    let mut own = scene.clone();
    own.sweep = None;
    if candidate == Candidate::Scene {
        hold_spring_mass(&mut own);
        return Some(own);
    }
    if candidate == Candidate::Solid {
        own.target.thickness_m = areal_kg_m2? / scene.target.density_kg_m3;
    }
    own.plate.mount = if candidate == Candidate::Free { Mount::Sprung } else { Mount::Rigid };
    let nothing_behind =
        "d=0 w_0=0 x_stop=none combine=alone spring=power-law k=0 own_mass=ignored b=0";
    variables::changed(own, nothing_behind).ok()
}

/// A spring whose mass is counted by the energy of the shot keeps the mass that the design shot gives it.
fn hold_spring_mass(scene: &mut Scene) {
    let mass_kg = Inertia::from_scene(scene).spring_mass_kg;
    let spring = &mut scene.mechanism.spring;
    if spring.own_mass == OwnMass::Counted {
        spring.mass_kg = spring.mass_kg.or(mass_kg);
    }
}

#[cfg(test)]
mod tests;
