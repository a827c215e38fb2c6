//! The thinnest armour of a scene's kind that stops its shot, and the thinnest solid plate that does.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::study::compare::hardware::{Hardware, InstalledSpring, MechanismLoadCase, is_held};
use crate::study::compare::solid::{solid_thickness, thickness_of_limit};
use crate::study::first_contact::{self, ContactOutput};
use crate::study::limit::shot_outcome::{ShotOutcome, decide, edge};
use crate::study::verdict::Verdict;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::simulate::Settings;
use cmra_engine::numerics::{larger, smaller};

/// Relative width to which the thickness is closed in.
pub const WIDTH: f64 = 1e-9;
/// How often a bracket is widened by a factor of two before the search is given up.
const WIDENED_MAX: usize = 19;
/// The least thickness of the numerical envelope, m.
pub const THINNEST_M: f64 = 5e-4;

/// Why there is no such armour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Absence {
    /// The letter that stands for it in maps.
    pub letter: char,
    /// The reason in a few words.
    pub label: &'static str,
    /// Rest of the reason, from its punctuation mark on; may be empty.
    pub more: &'static str,
}

impl Absence {
    /// No solid plate has this limit velocity: no strength, or another contact model.
    const NO_SOLID: Self = Self::new('N', "no solid plate to compare with");
    /// No thickness within a factor of a million of the solid plate's is enough.
    const NO_THICKNESS: Self = Self::new('T', "no thickness stops the shot");
    /// Every thickness of the numerical envelope is enough: of a preloaded mechanism, or a light plate of given face.
    const EVERY_THICKNESS: Self =
        Self::new('T', "even the thinnest plate within the model's range stops the shot")
            .with(": there is no least thickness");
    /// Runs of the plates just thick enough end undecided, however long they are followed.
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

    /// The whole reason.
    pub fn words(&self) -> String {
        format!("{}{}", self.label, self.more)
    }

    /// Whether it is the verdict that it leaves open, and not the armour that is missing.
    pub fn is_open(self) -> bool {
        self == Self::UNDECIDED
    }
}

/// The thinnest armour of a scene's kind that stops its shot.
#[derive(Clone, Debug, PartialEq)]
pub struct SizedArmour {
    /// The scene with that thickness.
    pub scene: Arc<Scene>,
    /// The mass of its springs, kg.
    pub spring_kg: f64,
    /// Areal mass, kg/m².
    pub areal_kg_m2: f64,
    /// Areal mass of the thinnest solid plate on a rigid mount that stops the shot, kg/m².
    pub solid_areal_kg_m2: f64,
    /// Factor between the limit by the law and the velocity for which this armour is sized; 1 where no such shots were measured.
    pub margin: f64,
}

impl SizedArmour {
    /// Areal mass of the solid plate over that of the armour.
    pub fn mass_efficiency(&self) -> f64 {
        self.solid_areal_kg_m2 / self.areal_kg_m2
    }
}

/// Mass efficiency of a valid scene at its own impact velocity, its thickness sized to a relative width. Opens no file and keeps
/// nothing: scene in, number out.
pub fn mass_efficiency(scene: &Scene, hardware: Hardware, width: f64) -> Result<f64, Absence> {
    if !is_held(scene) {
        return Err(Absence::NOTHING_STOPS);
    }
    sized(scene, hardware, width).map(|sized| sized.mass_efficiency())
}

/// Size a valid scene for its own impact velocity, to this relative width of its thickness.
pub(super) fn sized(scene: &Scene, hardware: Hardware, width: f64) -> Result<SizedArmour, Absence> {
    if scene.is_stack() {
        return Err(Absence::STACK);
    }
    let solid = solid_thickness(scene);
    let solid_m = solid.ok_or(Absence::NO_SOLID)?;
    let (factor, shot) = min_factor(scene, solid_m / scene.target.thickness_m, width)?;
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

/// The scene with its thickness times a factor. Where the plate's face is given it stays, else the mass ratio does, and the face
/// changes.
fn scaled(scene: &Scene, factor: f64) -> Scene {
    let mut own = scene.clone();
    own.target.thickness_m *= factor;
    own
}

struct Shot {
    verdict: ShotOutcome,
    demand: MechanismLoadCase,
}

/// The shot at a scene, by the contact kernel where that is enough. It counts as stopped with the margin of measured limits only.
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
        let demand =
            MechanismLoadCase::from_scene(&scene, first_contact::max_displacement_m(&scene, &end));
        return Some(Shot { verdict: ShotOutcome::of_contact(&scene, &end), demand });
    }
    let (run, verdict) =
        decide(&Arc::new(scene), &Settings::BARE, &mut |_| ControlFlow::Continue(()))?;
    let demand = MechanismLoadCase::from_scene(&run.scene, run.max_plate_displacement_m);
    Some(Shot { verdict, demand })
}

/// The least factor of the thickness that stops the shot, to a relative width, and that shot.
fn min_factor(scene: &Scene, solid: f64, width: f64) -> Result<(f64, Shot), Absence> {
    let thickness_m = scene.target.thickness_m;
    let try_out = |factor: f64| shoot(scaled(scene, factor)).ok_or(Absence::NO_THICKNESS);
    // A plate that its mechanism does not help is as good as a free or a rigid one.
    let free = thickness_of_limit(scene, scene.projectile.velocity_m_s, true)
        .filter(|_| scene.is_sprung())
        .map_or(solid, |free_m| free_m / thickness_m);
    let (mut thin, mut thick) = (free * (1.0 - width), solid * (1.0 + width));
    let mut widened = 0;
    loop {
        match try_out(thick)?.verdict {
            ShotOutcome::Stopped => break,
            _ if widened == WIDENED_MAX => return Err(Absence::NO_THICKNESS),
            ShotOutcome::Perforated => thin = thick,
            ShotOutcome::Undecided => {}
        }
        widened += 1;
        thick *= 2.0;
    }
    // Slow shots are stopped by thinner plates than the envelope has: for these the least is a free plate.
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
    match edge(thin, (thick, ShotOutcome::Stopped), width, look).ok_or(Absence::NO_THICKNESS)?.1 {
        (_, ShotOutcome::Undecided) => Err(Absence::UNDECIDED),
        (thick, _) => Ok((thick, try_out(thick)?)),
    }
}
