//! Sizing: the thinnest armour of a scene's kind that stops its shot, and the thinnest solid plate that does.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::study::compare::hardware::{
    Hardware, InstalledSpring, MechanismLoadCase, is_held, is_own,
};
use crate::study::compare::solid::{solid_thickness, thickness_of_limit};
use crate::study::first_contact::{self, ContactOutput};
use crate::study::limit::shot_outcome::{ShotOutcome, decide, edge};
use crate::study::load::spring_energy_j;
use crate::study::verdict::Verdict;
use cmra_engine::model::scene::{ContactModel, Scene};
use cmra_engine::model::simulate::Settings;
use cmra_engine::numerics::{larger, smaller};

/// Relative width of the final bracket around the thickness. The displacement, and with it the mass of a spring, changes as its square root.
const WIDTH: f64 = 1e-9;
/// Maximum number of times that a bracket is doubled.
const WIDENED_MAX: usize = 19;
/// Displacement at which a spring stores energy, m, unless it has no force.
const PROBE_M: f64 = 1e-3;
/// Minimum thickness of the numerical envelope, m.
pub const THINNEST_M: f64 = 5e-4;

/// Reason why no armour of the required kind exists.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Absence {
    /// Letter that marks the reason in maps.
    pub letter: char,
    /// Short text of the reason.
    pub label: &'static str,
    /// Rest of the text, starting with its punctuation mark; may be empty.
    pub more: &'static str,
}

impl Absence {
    /// No solid plate has this limit velocity: the target has no strength, or the contact model is another one.
    const NO_SOLID: Self = Self::new('N', "no solid plate to compare with");
    /// No thickness up to a million times that of the solid plate stops the shot.
    const NO_THICKNESS: Self = Self::new('T', "no thickness stops the shot");
    /// Every thickness of the numerical envelope stops the shot: for a preloaded mechanism, or a light plate of given face.
    const EVERY_THICKNESS: Self =
        Self::new('E', "even the thinnest plate within the model's range stops the shot")
            .with(": there is no least thickness");
    /// Runs with plates near the minimum thickness end undecided at any horizon.
    const UNDECIDED: Self = Self::new('?', "least thickness not decided")
        .with(": runs end before their outcome is known");
    const STACK: Self =
        Self::new('S', "a stack is compared with nothing").with(": its mechanisms share one shot");
    const NOTHING_STOPS: Self = Self::new('U', "nothing stops plate and projectile");
    const NO_SPRING_MASS: Self = Self::new('M', "the spring's mass is not known");

    const fn new(letter: char, label: &'static str) -> Self {
        Self { letter, label, more: "" }
    }

    const fn with(self, more: &'static str) -> Self {
        Self { more, ..self }
    }

    /// Returns the full text of the reason.
    pub fn words(&self) -> String {
        format!("{}{}", self.label, self.more)
    }

    /// Returns `true` if moving cannot pay: no plate of the kind stops the shot. Any other reason leaves that open.
    pub fn rules_out(self) -> bool {
        self == Self::NO_THICKNESS
    }

    /// Returns `true` if the minimum thickness is undecided; `false` if no such armour exists.
    pub fn is_open(self) -> bool {
        self == Self::UNDECIDED
    }
}

/// The thinnest armour of a scene's kind that stops its shot.
#[derive(Clone, Debug, PartialEq)]
pub struct SizedArmour {
    /// Scene with the minimum thickness.
    pub scene: Arc<Scene>,
    /// Mass of the springs, kg.
    pub spring_kg: f64,
    /// Areal mass, kg/m².
    pub areal_kg_m2: f64,
    /// Areal mass of the thinnest solid plate on a rigid mount that stops the shot, kg/m².
    pub solid_areal_kg_m2: f64,
    /// Ratio of the law's limit velocity to the velocity for which this armour is sized; 1 if no such shots were measured.
    pub margin: f64,
}

impl SizedArmour {
    /// Returns the areal mass of the solid plate over that of the armour.
    pub fn mass_efficiency(&self) -> f64 {
        self.solid_areal_kg_m2 / self.areal_kg_m2
    }
}

/// Returns the reason why a scene has no mass efficiency, if it is known without a shot; it holds at every velocity and size of the plate.
pub fn known_absence(scene: &Scene) -> Option<Absence> {
    let mechanism = &scene.mechanism;
    let is_weightless = spring_energy_j(scene, Some([0.0, PROBE_M])) == Some(0.0);
    let has_mass = is_own(scene) || is_weightless || mechanism.specific_energy_j_kg().is_some();
    if scene.is_stack() {
        Some(Absence::STACK)
    } else if !is_held(scene) {
        Some(Absence::NOTHING_STOPS)
    } else if scene.contact.model != ContactModel::Hydrodynamic {
        Some(Absence::NO_SOLID)
    } else {
        (!has_mass).then_some(Absence::NO_SPRING_MASS)
    }
}

/// Computes the mass efficiency of a valid scene at its own impact velocity. Pure function: does not access files or shared state.
pub fn mass_efficiency(scene: &Scene, hardware: Hardware) -> Result<f64, Absence> {
    if !is_held(scene) {
        return Err(Absence::NOTHING_STOPS);
    }
    sized(scene, hardware).map(|sized| sized.mass_efficiency())
}

/// Sizes a valid scene for its own impact velocity.
pub(super) fn sized(scene: &Scene, hardware: Hardware) -> Result<SizedArmour, Absence> {
    if scene.is_stack() {
        return Err(Absence::STACK);
    }
    let solid = solid_thickness(scene);
    let solid_m = solid.ok_or(Absence::NO_SOLID)?;
    let (factor, shot) = min_factor(scene, solid_m / scene.target.thickness_m)?;
    let own = scaled(scene, factor);
    let built = InstalledSpring::from_scene(&own, hardware, &shot.demand);
    if let Some(failure) = built.failure(&own, &shot.demand) {
        return Err(Absence::new('F', failure.words));
    }
    let known = built.areal_kg_m2(&own).zip(built.spring_kg);
    let (areal_kg_m2, spring_kg) = known.ok_or(Absence::NO_SPRING_MASS)?;
    let solid_areal_kg_m2 = solid_m * scene.target.density_kg_m3;
    let margin = Verdict::margin(&own);
    Ok(SizedArmour { scene: Arc::new(own), spring_kg, areal_kg_m2, solid_areal_kg_m2, margin })
}

/// Returns the scene with its thickness multiplied by a factor. A given face of the plate is kept; otherwise the mass ratio is kept and the
/// face changes.
fn scaled(scene: &Scene, factor: f64) -> Scene {
    let mut own = scene.clone();
    own.target.thickness_m *= factor;
    own
}

struct Shot {
    verdict: ShotOutcome,
    demand: MechanismLoadCase,
}

/// Runs the shot at a scene, by the contact kernel if that suffices. Counts the shot as stopped only with the margin of the measured
/// limits.
fn shoot(scene: Scene) -> Option<Shot> {
    let margin = Verdict::margin(&scene);
    let mut faster = scene.clone();
    faster.projectile.velocity_m_s *= margin;
    let shot = shoot_by_law(scene)?;
    if margin <= 1.0 || shot.verdict != ShotOutcome::Stopped {
        return Some(shot);
    }
    Some(Shot { verdict: shoot_by_law(faster)?.verdict, ..shot })
}

fn shoot_by_law(scene: Scene) -> Option<Shot> {
    let tolerance = first_contact::TOLERANCE_FRACTION * scene.run.tolerance;
    if let Some(end) = first_contact::contact(&scene, ContactOutput::Displacement, tolerance) {
        let far_m = first_contact::max_displacement_m(&scene, &end);
        let ends_m = far_m.map(|far_m| [scene.start_m(), far_m]);
        let demand = MechanismLoadCase::from_scene(&scene, ends_m);
        return Some(Shot { verdict: ShotOutcome::of_contact(&scene, &end), demand });
    }
    let (run, verdict) =
        decide(&Arc::new(scene), &Settings::BARE, &mut |_| ControlFlow::Continue(()))?;
    let demand = MechanismLoadCase::from_scene(&run.scene, run.displacements_m());
    Some(Shot { verdict, demand })
}

/// Finds the smallest thickness factor that stops the shot; returns it with that shot.
fn min_factor(scene: &Scene, solid: f64) -> Result<(f64, Shot), Absence> {
    let thickness_m = scene.target.thickness_m;
    let try_out = |factor: f64| shoot(scaled(scene, factor)).ok_or(Absence::NO_THICKNESS);
    // A plate that gains nothing from its mechanism is equivalent to a free or a rigid plate.
    let free = thickness_of_limit(scene, scene.projectile.velocity_m_s, true)
        .filter(|_| scene.is_sprung())
        .map_or(solid, |free_m| free_m / thickness_m);
    let (mut thin, mut thick) = (free * (1.0 - WIDTH), solid * (1.0 + WIDTH));
    let (mut widened, mut absence) = (0, Absence::NO_THICKNESS);
    loop {
        let Some(shot) = shoot(scaled(scene, thick)) else { return Err(absence) };
        match shot.verdict {
            ShotOutcome::Stopped => break,
            ShotOutcome::Perforated => thin = thick,
            ShotOutcome::Undecided => absence = Absence::UNDECIDED,
        }
        if widened == WIDENED_MAX {
            return Err(absence);
        }
        widened += 1;
        thick *= 2.0;
    }
    // Slow shots are stopped by plates thinner than the numerical envelope. For these the minimum is that of a free plate.
    let thinnest = smaller(thin, THINNEST_M / thickness_m);
    loop {
        match try_out(thin)?.verdict {
            ShotOutcome::Perforated => break,
            ShotOutcome::Stopped if thin <= thinnest => return Err(Absence::EVERY_THICKNESS),
            ShotOutcome::Undecided if thin <= thinnest => return Err(Absence::UNDECIDED),
            ShotOutcome::Stopped => thick = thin,
            ShotOutcome::Undecided => {}
        }
        thin = larger(0.5 * thin, thinnest);
    }
    let look = &mut |factor| Some(try_out(factor).ok()?.verdict);
    match edge(thin, (thick, ShotOutcome::Stopped), WIDTH, look).ok_or(Absence::NO_THICKNESS)?.1 {
        (_, ShotOutcome::Undecided) => Err(Absence::UNDECIDED),
        (thick, _) => Ok((thick, try_out(thick)?)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::testing::scene;
    use cmra_engine::model::variables::find;
    use std::collections::BTreeSet;

    #[test]
    fn every_reason_has_a_letter_of_its_own() {
        let reasons = [
            Absence::NO_SOLID,
            Absence::NO_THICKNESS,
            Absence::EVERY_THICKNESS,
            Absence::UNDECIDED,
            Absence::STACK,
            Absence::NOTHING_STOPS,
            Absence::NO_SPRING_MASS,
        ];
        let letters: BTreeSet<char> = reasons.iter().map(|it| it.letter).chain(['F']).collect();
        assert_eq!(letters.len(), reasons.len() + 1, "{letters:?}");
    }

    /// The energies of the cocked spring and of the shot, k d^1.3/1.3 = 7.9 kJ and 0.015 J, are those of a hole of 0.41 m against pi R² `S_y`
    /// alone: a thicker plate is not perforated, whether or not its run ends undecided.
    #[test]
    fn shots_that_end_undecided_do_not_rule_out_a_thickness() {
        let scene = scene("interface=plastic k=1e7 n=0.3 d=5mm v_i=1");
        let found = sized(&scene, Hardware::Own).map(|sized| sized.areal_kg_m2);
        assert!(found.is_ok() || found.is_err_and(Absence::is_open), "{found:?}");
    }

    /// Absences that are known without a shot are those found by shots: for every kind of spring, and for other models.
    #[test]
    fn a_known_absence_is_that_of_the_shots() {
        let mut known = 0;
        let kinds = find("spring").unwrap().keys().iter().map(|kind| format!("spring={kind} m=1"));
        let others = ["", "k=0", "k=0 x_stop=1mm", "model=half-sine", "mount=rigid", "base=0.02"];
        for changes in kinds.chain(others.map(str::to_owned)) {
            for v in [1.0, 30.0, 400.0] {
                let scene = scene(&format!("{changes} v_i={v}"));
                let found = mass_efficiency(&scene, Hardware::Own);
                if let Some(absence) = known_absence(&scene) {
                    known += 1;
                    assert!(found.is_err(), "{changes} {v}: {absence:?} {found:?}");
                }
                let is_mass_known = found != Err(Absence::NO_SPRING_MASS);
                assert!(is_mass_known || known_absence(&scene).is_some(), "{changes} {v}");
            }
        }
        assert!(known > 8, "{known}");
    }
}
