//! Comparison at equal areal mass: tests whether moving armour pays.
//!
//! The comparison has a single design velocity: the impact velocity v of the scene.
//!
//! - Areal mass: total mass of plate and spring over the face of the plate, rho h (1 + spring/`m_2`). The plate is a block of its
//!   material, so its face is `m_2`/(rho h). Damper, stop and mount are not counted.
//! - Spring: that of the scene. If its mass is unknown, the mass is the maximum energy stored under the shot at v over the energy per
//!   mass. If that shot perforates, the fastest stopped shot is used.
//! - Limit if the spring must survive: the smallest impact velocity at which the plate is perforated or the hardware fails. A spring fails
//!   if its stored energy exceeds the capacity of its given mass, or if it leaves the range of its law (a beam yields, a table ends). A
//!   spring of unknown mass has no energy limit, unless it is sized: then its capacity is the energy of the shot at v.
//! - Mass efficiency: areal mass of the thinnest solid plate on a rigid mount that stops the shot at v, over that of the thinnest armour
//!   of the scene's kind that does. That armour has the scene's mass ratio and mechanism, but its own thickness; excess thickness of the
//!   scene's plate has no effect. The mechanism pays if the mass efficiency exceeds 1.
//!
//! Closed form: without dishing a perforation takes the volume pi R² h, and the limit velocity depends only on volume over reduced mass. A
//! free plate therefore needs gamma/(1 + gamma) of the solid plate's thickness. A soft spring then stores the energy of the common motion,
//! `m_p` v²/(2 (1 + gamma)). With an energy per mass e, J/kg, the mass efficiency is (1 + 1/gamma)/(1 + v²/(2 gamma (1 + gamma) e)): above
//! 1 if and only if e > v²/(2 (1 + gamma)).
//!
//! Does not depend on files, threads, the terminal or a clock.

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
pub use hardware::{Failure, Hardware, is_held};
pub use sizing::{Absence, SizedArmour, THINNEST_M, known_absence, mass_efficiency};

use candidate::CandidateEvaluator;

enumeration! {
    /// Armour candidates of the comparison.
    pub enum Candidate in CandidateRow {
        /// Keyword in files and on screens.
        word: &'static str,
    }
    /// The scene unchanged.
    Scene { word: "scene" }
    /// The scene's plates on a rigid mount.
    Rigid { word: "rigid mount" }
    /// The scene's plates without spring, damper, stop and cocking.
    Free { word: "free plate" }
    /// A solid plate of the scene's areal mass on a rigid mount.
    Solid { word: "solid plate" }
}

/// Results for one candidate; `None` if a quantity does not exist.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Candidate of the entry.
    pub candidate: Candidate,
    /// Shot at the design velocity.
    pub run: Run,
    /// Whether a mount, spring, damper or stop stops the plate.
    pub is_held: bool,
    /// Total counted mass over the face of the plate, kg/m², with springs that the fastest stopped shot sizes if the design shot perforates;
    /// `None` if the spring's mass is unknown.
    pub areal_kg_m2: Option<f64>,
    /// Mass of the springs, kg.
    pub spring_kg: Option<f64>,
    /// Whether the fastest shot that is stopped sizes the springs, since the design shot perforates.
    pub is_sized_at_limit: bool,
    /// Ballistic limit of the plate alone.
    pub perforation: Limit,
    /// Limit velocity if the spring must survive, m/s.
    pub limit_m_s: Option<f64>,
    /// Hardware failure at that velocity; `None` if the plate is perforated first.
    pub failure: Option<Failure>,
    /// Thinnest armour of this kind that stops the shot.
    pub sized: Result<SizedArmour, Absence>,
    /// Shot just below the limit velocity; `None` without a limit.
    pub at_limit: Option<Run>,
    /// Verdict on the shot at the design velocity.
    pub shot: ShotVerdict,
}

impl Entry {
    /// Returns the mass efficiency at the design velocity.
    pub fn mass_efficiency(&self) -> Option<f64> {
        self.sized.as_ref().ok().map(SizedArmour::mass_efficiency)
    }

    /// Returns the depth of the hole, m; `None` if perforated.
    pub fn depth_m(&self) -> Option<f64> {
        let stays = matches!(self.run.shot_outcome(), Outcome::Arrested | Outcome::Separated);
        self.run.penetration.final_m.filter(|_| stays)
    }

    /// Returns `true` if no velocity of the search range perforates the plate or makes the hardware fail.
    pub fn is_beyond(&self) -> bool {
        self.limit_m_s.is_none() && self.perforation == Limit::Never
    }

    /// Explains why there is no limit velocity; `None` if there is one.
    pub fn no_limit(&self) -> Option<String> {
        if self.limit_m_s.is_some() { None } else { self.perforation.absence() }
    }
}

/// Returns `true` if a mass efficiency is 1 within the accuracy of the limits; always so for a mechanism that does not move.
pub fn is_equal(mass_efficiency: f64) -> bool {
    // Tolerance: the accuracy of the limit velocities.
    (mass_efficiency - 1.0).abs() <= 1e-4
}

/// Verdict on the mechanism: whether it pays.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// The armour stops the shot, with this mass efficiency.
    Stops(f64),
    /// The armour does not stop the shot, for this reason.
    NotMet(String),
    /// Unknown: the run is undecided, or a quantity is missing.
    Unknown,
}

impl Verdict {
    /// Returns the verdict as a text for a page.
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

    /// Returns `true` if the mechanism pays; `None` if unknown.
    pub fn pays(&self) -> Option<bool> {
        match self {
            Self::Stops(efficiency) => Some(*efficiency > 1.0 && !is_equal(*efficiency)),
            Self::NotMet(_) => Some(false),
            Self::Unknown => None,
        }
    }
}

/// Result of the comparison.
#[derive(Clone, Debug, PartialEq)]
pub struct ComparisonReport {
    /// Compared scene; its impact velocity is the design velocity.
    pub scene: Arc<Scene>,
    /// Hardware for which the limits are computed.
    pub hardware: Hardware,
    /// Face of the first plate, m².
    pub face_m2: f64,
    /// Whether the mass of the springs is given.
    pub spring_is_own: bool,
    /// Energy-absorbing parts whose mass is not counted (damper, stop); empty if all mass is counted.
    pub uncounted: Vec<&'static str>,
    /// Evaluated candidates; without those that are impossible or were cancelled.
    pub entries: Vec<Entry>,
}

impl ComparisonReport {
    /// Returns the results of a candidate.
    pub fn entry(&self, candidate: Candidate) -> Option<&Entry> {
        self.entries.iter().find(|entry| entry.candidate == candidate)
    }

    /// Returns the first requirement of chapter 4: the depth divided by the depth in a solid plate of equal mass.
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

    /// Returns the verdict on the mechanism.
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
            // The limit decides a run that still oscillates.
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

/// Request for a comparison; `Display` writes the equivalent command.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Request {
    /// Hardware for which the limits are computed.
    pub hardware: Hardware,
    /// Axes of a map of the mass efficiency; `None` to compare the candidates of the scene only.
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

/// Compares the candidates of a scene.
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
    // The areal mass of the scene itself applies to the other candidates.
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

/// Returns the energy-absorbing parts of a scene whose mass is not counted.
fn uncounted(scene: &Scene) -> Vec<&'static str> {
    if !scene.is_sprung() {
        return Vec::new();
    }
    let mechanism = Mechanism::from_scene(scene);
    let damper = (!mechanism.damper.is_absent()).then_some("damper");
    damper.into_iter().chain(mechanism.stop.is_some().then_some("stop")).collect()
}

/// Returns the face of a plate, m²: mass over rho h.
pub fn face_m2(scene: &Scene) -> f64 {
    scene.plate_mass_kg() / (scene.target.density_kg_m3 * scene.target.thickness_m)
}

/// Builds a candidate from a scene of the given areal mass; `None` if the candidate needs an areal mass that is unknown.
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

/// Returns the counted mass of a spring that is sized by the energy of the scene's shot, kg; `None` for other springs.
fn mass_by_shot_kg(scene: &Scene) -> Option<f64> {
    let spring = &scene.mechanism.spring;
    let is_sized = spring.own_mass == OwnMass::Counted && spring.mass_kg.is_none();
    Inertia::from_scene(scene).spring_mass_kg.filter(|_| is_sized && scene.is_sprung())
}

/// Returns `true` if a shot of another velocity has a spring of another mass.
pub fn is_spring_sized_by_shot(scene: &Scene) -> bool {
    mass_by_shot_kg(scene).is_some()
}

/// Fixes the mass of a spring that is sized by energy to the mass for the design shot.
fn hold_spring_mass(scene: &mut Scene) {
    if let Some(mass_kg) = mass_by_shot_kg(scene) {
        scene.mechanism.spring.mass_kg = Some(mass_kg);
    }
}

#[cfg(test)]
mod tests;
