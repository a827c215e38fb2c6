//! The thinnest armour of a scene's kind that stops its shot, and the thinnest solid plate that does.

use std::sync::Arc;

use crate::model::run::{Outcome, Run};
use crate::model::scene::{Mount, Scene};
use crate::numerics::{larger, smaller};
use crate::study::compare::hardware::{Built, Demand, Failure, Hardware};
use crate::study::compare::solid::thickness_of_limit_m;
use crate::study::compare::{elements, face_m2, is_held};
use crate::study::plain_run;
use crate::study::sweep::kernel::{self, Wanted};

/// Relative width to which the thickness is closed in.
pub const WIDTH: f64 = 1e-9;
/// How often a bracket is widened by a factor of two before the search is given up.
const WIDENED_MAX: usize = 20;
/// The least thickness of the numerical envelope, m (model page, section 8).
pub(super) const THINNEST_M: f64 = 5e-4;

/// Why there is no such armour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Absence {
    /// No solid plate has this limit velocity: no strength, or another contact model.
    NoSolid,
    /// No thickness within a factor of a million of the solid plate's is enough.
    NoThickness,
    /// Every thickness of the numerical envelope is enough: of a preloaded mechanism, or a light plate of given face.
    EveryThickness,
    /// Nothing stops plate and projectile.
    NothingStops,
    /// The spring's mass is not known.
    NoSpringMass,
    /// The mechanism fails under the shot.
    Fails(Failure),
}

impl Absence {
    /// The letter that stands for it in maps.
    pub fn letter(self) -> char {
        match self {
            Self::NoSolid => 'N',
            Self::NoThickness | Self::EveryThickness => 'T',
            Self::NothingStops => 'U',
            Self::NoSpringMass => 'M',
            Self::Fails(_) => 'F',
        }
    }

    /// In words.
    pub fn words(self) -> String {
        match self {
            Self::NoSolid => "no solid plate to compare with".to_owned(),
            Self::NoThickness => "no thickness stops the shot".to_owned(),
            Self::EveryThickness => {
                "even the thinnest plate within the model's range stops the shot: there is no least thickness"
                    .to_owned()
            }
            Self::NothingStops => "nothing stops plate and projectile".to_owned(),
            Self::NoSpringMass => "the spring's mass is not known".to_owned(),
            Self::Fails(failure) => failure.words(),
        }
    }
}

/// The thinnest armour of a scene's kind that stops its shot.
#[derive(Clone, Debug, PartialEq)]
pub struct Sized {
    /// The scene with that thickness.
    pub scene: Arc<Scene>,
    /// Its thicknesses over the scene's.
    pub factor: f64,
    /// The mass of its springs, kg.
    pub spring_kg: f64,
    /// Its areal mass, kg/m².
    pub areal_kg_m2: f64,
    /// Areal mass of the thinnest solid plate on a rigid mount that stops the shot, kg/m².
    pub solid_areal_kg_m2: f64,
}

impl Sized {
    /// Areal mass of the solid plate over that of the armour.
    pub fn mass_efficiency(&self) -> f64 {
        self.solid_areal_kg_m2 / self.areal_kg_m2
    }
}

/// Mass efficiency of a valid scene at its own impact velocity, its thickness sized to a relative width. Opens no file and keeps
/// nothing: scene in, number out.
///
/// # Errors
/// Why there is none.
pub fn mass_efficiency(scene: &Scene, hardware: &Hardware, width: f64) -> Result<f64, Absence> {
    if !is_held(scene) {
        return Err(Absence::NothingStops);
    }
    sized(scene, hardware, width).map(|sized| sized.mass_efficiency())
}

/// A run's scene as built, its springs sized for that shot; a shot that perforates does not size them.
fn built(run: &Run) -> Built {
    let elements = elements(&run.scene);
    let demands = if run.shot_outcome() == Outcome::Perforated {
        elements.iter().map(|element| Demand::of(element, None)).collect()
    } else {
        Demand::of_run(run, &elements)
    };
    Built::for_demands(elements, &Hardware::default(), &demands)
}

/// Areal mass of the scene of a run as built, its springs sized for that shot, kg/m²; `None` where it is not known, as for springs
/// behind a plate that is perforated.
pub fn areal_mass_of_run(run: &Run) -> Option<f64> {
    built(run).areal_kg_m2(&run.scene)
}

/// The same in all: plates and springs, kg.
pub(in crate::study) fn system_mass_of_run(run: &Run) -> Option<f64> {
    Some(plates_kg(&run.scene) + built(run).spring_kg()?)
}

/// The mass of all plates of a scene, kg: a base plate is as large as the first plate.
pub(in crate::study) fn plates_kg(scene: &Scene) -> f64 {
    let Some(base_m) = scene.stack.base_thickness_m else { return scene.plate_mass_kg() };
    let base_kg = base_m * scene.target.density_kg_m3 * face_m2(scene);
    elements(scene).iter().map(Scene::plate_mass_kg).sum::<f64>() + base_kg
}

/// Size a valid scene for its own impact velocity, to this relative width of its thickness.
pub(super) fn sized(scene: &Scene, hardware: &Hardware, width: f64) -> Result<Sized, Absence> {
    let velocity_m_s = scene.projectile.velocity_m_s;
    let solid_m = thickness_of_limit_m(scene, velocity_m_s, false).ok_or(Absence::NoSolid)?;
    let (factor, shot) = least_factor(scene, solid_m / scene.target.thickness_m, width)?;
    let own = scaled(scene, factor);
    let built = Built::for_demands(elements(&own), hardware, &shot.demands);
    if let Some(failure) = built.failure_under(&shot.demands) {
        return Err(Absence::Fails(failure));
    }
    let known = built.areal_kg_m2(&own).zip(built.spring_kg());
    let (areal_kg_m2, spring_kg) = known.ok_or(Absence::NoSpringMass)?;
    let solid_areal_kg_m2 = solid_m * scene.target.density_kg_m3;
    Ok(Sized { scene: Arc::new(own), factor, spring_kg, areal_kg_m2, solid_areal_kg_m2 })
}

/// The scene with all thicknesses times a factor. Where the plate's face is given it stays, else the mass ratio does, and the face
/// changes.
fn scaled(scene: &Scene, factor: f64) -> Scene {
    let mut own = scene.clone();
    own.target.thickness_m *= factor;
    own.stack.base_thickness_m = own.stack.base_thickness_m.map(|thickness| thickness * factor);
    for layer in &mut own.stack.layers {
        layer.target.thickness_m *= factor;
    }
    own.follow_size();
    own
}

struct Shot {
    stopped: bool,
    demands: Vec<Demand>,
}

/// The shot at a scene, by the contact kernel where that is enough.
fn shoot(scene: &Scene) -> Option<Shot> {
    let tolerance = kernel::TOLERANCE_FRACTION * scene.run.tolerance;
    if let Some(end) = kernel::contact(scene, Wanted::Displacement, tolerance) {
        let demand = Demand::of(scene, kernel::max_displacement_m(scene, &end));
        return Some(Shot { stopped: end.arrested, demands: vec![demand] });
    }
    let run = plain_run(scene)?;
    // An undecided run is not a proof that the plate stops the shot.
    let stopped = match run.shot_outcome() {
        Outcome::Arrested | Outcome::Separated => true,
        Outcome::Moving => run.final_penetration_m.or(run.penetration_at_most_m).is_some(),
        Outcome::Perforated => false,
    };
    Some(Shot { stopped, demands: Demand::of_run(&run, &elements(scene)) })
}

/// The least factor of the thicknesses that stops the shot, and that shot.
fn least_factor(scene: &Scene, solid: f64, width: f64) -> Result<(f64, Shot), Absence> {
    let try_out = |factor: f64| shoot(&scaled(scene, factor)).ok_or(Absence::NoThickness);
    let is_stack = scene.stack.base_thickness_m.is_some();
    // A plate that its mechanism does not help is as good as a free or a rigid one.
    let free = thickness_of_limit_m(scene, scene.projectile.velocity_m_s, true)
        .map_or(solid, |thickness| thickness / scene.target.thickness_m);
    let (mut thin, mut thick) = if is_stack {
        // Between what all its plates together and what each of them alone would need.
        (0.5 * solid, 1.1 * solid)
    } else if scene.plate.mount == Mount::Rigid {
        (solid * (1.0 - width), solid * (1.0 + width))
    } else {
        (free * (1.0 - width), solid * (1.0 + width))
    };
    let mut stops = try_out(thick)?;
    for _ in 0..WIDENED_MAX {
        if stops.stopped {
            break;
        }
        thin = thick;
        thick *= 2.0;
        stops = try_out(thick)?;
    }
    if !stops.stopped {
        return Err(Absence::NoThickness);
    }
    // Slow shots are stopped by thinner plates than the envelope has: for these the least is a free plate.
    let thinnest = smaller(thin, THINNEST_M / scene.target.thickness_m);
    loop {
        let shot = try_out(thin)?;
        if !shot.stopped {
            break;
        }
        if thin <= thinnest {
            return Err(Absence::EveryThickness);
        }
        (thick, stops) = (thin, shot);
        thin = larger(0.5 * thin, thinnest);
    }
    close_in((thin, thick), stops, width, &try_out)
}

/// Closes in the least factor between one that is perforated and one that is not.
fn close_in(
    (mut thin, mut thick): (f64, f64),
    mut stops: Shot,
    width: f64,
    try_out: &dyn Fn(f64) -> Result<Shot, Absence>,
) -> Result<(f64, Shot), Absence> {
    // A soft spring hardly moves the limit of a free plate: the first steps keep near the thin end.
    let mut step = 2.0 * width;
    while thin * (1.0 + step) < 0.5 * (thin + thick) {
        let near = thin * (1.0 + step);
        let shot = try_out(near)?;
        if shot.stopped {
            (thick, stops) = (near, shot);
            break;
        }
        thin = near;
        step *= 32.0;
    }
    while thick - thin > width * thick {
        let middle = 0.5 * (thin + thick);
        let shot = try_out(middle)?;
        if shot.stopped { (thick, stops) = (middle, shot) } else { thin = middle }
    }
    Ok((thick, stops))
}
