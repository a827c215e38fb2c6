//! The thinnest armour of a scene's kind that stops its shot, and the thinnest solid plate that does.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::model::run::{Outcome, Run};
use crate::model::scene::{ClosureInEffect, Mount, Scene};
use crate::model::stack;
use crate::model::units::fixed_significant;
use crate::numerics::{larger, smaller};
use crate::study::compare::closures::ByClosure;
use crate::study::compare::hardware::{Built, Demand, Failure, Hardware};
use crate::study::compare::solid::{Thickness, thickness_of_limit};
use crate::study::compare::{elements, face_m2, is_held};
use crate::study::limit::Criterion;
use crate::study::limit::verdict::{Change, Gap, ONE_POINT, ShotOutcome, decide, digits_apart};
use crate::study::sweep::kernel::{self, Wanted};

/// Relative width to which the thickness is closed in.
pub const WIDTH: f64 = 1e-9;
/// How often a bracket is widened by a factor of two before the search is given up.
const WIDENED_MAX: usize = 20;
/// The least thickness of the numerical envelope, m (model page, section 8).
pub(super) const THINNEST_M: f64 = 5e-4;

/// Why there is no such armour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Absence {
    /// No solid plate has this limit velocity: no strength, or another contact model.
    NoSolid,
    /// No thickness within a factor of a million of the solid plate's is enough.
    NoThickness,
    /// Every thickness of the numerical envelope is enough: of a preloaded mechanism, or a light plate of given face.
    EveryThickness,
    /// Runs at thicknesses between two end undecided, however long they are followed.
    Undecided {
        /// The thickest plate below that is known to be perforated, m.
        perforated_m: Option<f64>,
        /// The thinnest plate above that is known to stop the shot, m.
        stopped_m: f64,
    },
    /// The comparison is decided by the change of a closure by thickness alone.
    ClosureChange(ByClosure),
    /// Nothing stops plate and projectile.
    NothingStops,
    /// The spring's mass is not known.
    NoSpringMass,
    /// The mechanism fails under the shot.
    Fails(Failure),
}

impl Absence {
    /// The mass efficiencies by either closure, where there is no other.
    pub fn by_closure(self) -> Option<ByClosure> {
        if let Self::ClosureChange(by_closure) = self { Some(by_closure) } else { None }
    }

    /// Whether it is the verdict that it leaves open, and not the armour that is missing.
    pub(super) fn is_open(self) -> bool {
        matches!(self, Self::Undecided { .. } | Self::ClosureChange(_))
    }

    /// The letter that stands for it in maps.
    pub fn letter(self) -> char {
        match self {
            Self::NoSolid => 'N',
            Self::NoThickness | Self::EveryThickness => 'T',
            Self::Undecided { .. } => '?',
            Self::ClosureChange(by_closure) => by_closure.letter(),
            Self::NothingStops => 'U',
            Self::NoSpringMass => 'M',
            Self::Fails(_) => 'F',
        }
    }

    /// In words that hold for all points with its letter.
    pub fn brief(self) -> String {
        match self {
            Self::Undecided { .. } => "least thickness not decided".to_owned(),
            Self::ClosureChange(by_closure) => by_closure.brief(),
            _ => self.words(),
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
            Self::Undecided { perforated_m, stopped_m } => {
                let digits = perforated_m.map_or(6, |it| digits_apart(1e3 * it, 1e3 * stopped_m));
                let shown = |metres: f64| fixed_significant(1e3 * metres, digits);
                format!(
                    "least thickness not decided: it lies above {} and below {} mm (stopped); runs between these thicknesses end \
                     before their outcome is known",
                    perforated_m.map_or_else(|| "0".to_owned(), |it| shown(it) + " mm (perforated)"),
                    shown(stopped_m),
                )
            }
            Self::ClosureChange(by_closure) => by_closure.words(),
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
    let by_closure = || ByClosure::of(scene, hardware, width);
    let solid = thickness_of_limit(scene, velocity_m_s, false).ok_or(Absence::NoSolid)?;
    let Thickness::Root(solid_m) = solid else {
        return Err(Absence::ClosureChange(by_closure()?));
    };
    let sized = armour(scene, hardware, solid_m, width)?;
    let own = closures_by_thickness(&sized.scene);
    let below = scaled(scene, sized.factor * (1.0 - 2.0 * larger(width, ONE_POINT)));
    if own != closures_by_thickness(&below) {
        return Err(Absence::ClosureChange(by_closure()?));
    }
    let solid = scaled(scene, solid_m / scene.target.thickness_m).closure();
    let contradicts = |it: &ByClosure| it.contradict(sized.mass_efficiency());
    match own.iter().any(|it| *it != solid).then(by_closure) {
        Some(Ok(by_closure)) if contradicts(&by_closure) => Err(Absence::ClosureChange(by_closure)),
        _ => Ok(sized),
    }
}

/// The closures that the thicknesses of a scene's plates choose.
fn closures_by_thickness(scene: &Scene) -> Vec<ClosureInEffect> {
    stack::plates(scene).iter().filter_map(Scene::closure_by_thickness).collect()
}

/// The thinnest armour, beside a solid plate of this thickness, m.
fn armour(scene: &Scene, hardware: &Hardware, solid_m: f64, width: f64) -> Result<Sized, Absence> {
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
    verdict: ShotOutcome,
    demands: Vec<Demand>,
}

/// The shot at a scene, by the contact kernel where that is enough.
fn shoot(scene: Scene) -> Option<Shot> {
    let tolerance = kernel::TOLERANCE_FRACTION * scene.run.tolerance;
    if let Some(end) = kernel::contact(&scene, Wanted::Displacement, tolerance) {
        let demand = Demand::of(&scene, kernel::max_displacement_m(&scene, &end));
        let verdict = if end.arrested { ShotOutcome::Stopped } else { ShotOutcome::Perforated };
        return Some(Shot { verdict, demands: vec![demand] });
    }
    let elements = elements(&scene);
    let go_on = &mut |_: f64| ControlFlow::Continue(());
    let (run, verdict) = decide(&Arc::new(scene), Criterion::Passage, go_on)?;
    Some(Shot { verdict, demands: Demand::of_run(&run, &elements) })
}

/// The least factor of the thicknesses that stops the shot, and that shot.
fn least_factor(scene: &Scene, solid: f64, width: f64) -> Result<(f64, Shot), Absence> {
    let search = Search { scene, width };
    // A plate that its mechanism does not help is as good as a free or a rigid one.
    let free = thickness_of_limit(scene, scene.projectile.velocity_m_s, true)
        .map_or(solid, |thickness| thickness.m() / scene.target.thickness_m);
    let (mut thin, mut thick) = if scene.is_stack() {
        // Between what all its plates together and what each of them alone would need.
        (0.5 * solid, 1.1 * solid)
    } else if scene.plate.mount == Mount::Rigid {
        (solid * (1.0 - width), solid * (1.0 + width))
    } else {
        (free * (1.0 - width), solid * (1.0 + width))
    };
    let mut stops = search.try_out(thick)?;
    for _ in 0..WIDENED_MAX {
        match stops.verdict {
            ShotOutcome::Stopped => break,
            ShotOutcome::Perforated => thin = thick,
            ShotOutcome::Undecided => {}
        }
        thick *= 2.0;
        stops = search.try_out(thick)?;
    }
    if stops.verdict != ShotOutcome::Stopped {
        return Err(Absence::NoThickness);
    }
    // Slow shots are stopped by thinner plates than the envelope has: for these the least is a free plate.
    let thinnest = smaller(thin, THINNEST_M / scene.target.thickness_m);
    loop {
        let shot = search.try_out(thin)?;
        match shot.verdict {
            ShotOutcome::Perforated => break,
            ShotOutcome::Stopped if thin <= thinnest => return Err(Absence::EveryThickness),
            ShotOutcome::Stopped => (thick, stops) = (thin, shot),
            ShotOutcome::Undecided if thin <= thinnest => return Err(search.undecided(None, thick)),
            ShotOutcome::Undecided => {}
        }
        thin = larger(0.5 * thin, thinnest);
    }
    search.close_in(thin, thick, stops)
}

/// The search for the least factor of a scene's thicknesses, to a relative width.
struct Search<'s> {
    scene: &'s Scene,
    width: f64,
}

impl Search<'_> {
    fn try_out(&self, factor: f64) -> Result<Shot, Absence> {
        shoot(scaled(self.scene, factor)).ok_or(Absence::NoThickness)
    }

    /// Closes in the least factor between one that is perforated and one that stops the shot.
    fn close_in(
        &self,
        mut thin: f64,
        mut thick: f64,
        mut stops: Shot,
    ) -> Result<(f64, Shot), Absence> {
        // A soft spring hardly moves the limit of a free plate: the first steps keep near the thin end.
        let mut step = Some(2.0 * self.width);
        while thick - thin > self.width * thick {
            let middle = 0.5 * (thin + thick);
            let near = step.map(|step| thin * (1.0 + step)).filter(|near| *near < middle);
            let next = near.unwrap_or(middle);
            let shot = self.try_out(next)?;
            step = near.and(step).map(|step| 32.0 * step);
            match shot.verdict {
                ShotOutcome::Perforated => thin = next,
                ShotOutcome::Stopped => (thick, stops, step) = (next, shot, None),
                ShotOutcome::Undecided => return self.beside(thin, next, thick),
            }
        }
        Ok((thick, stops))
    }

    /// The least factor beside one that no run decides.
    fn beside(&self, thin: f64, undecided: f64, thick: f64) -> Result<(f64, Shot), Absence> {
        let width = larger(self.width, ONE_POINT);
        let gap = Gap {
            from: (thin, ShotOutcome::Perforated),
            undecided,
            to: (Some(thick), ShotOutcome::Stopped),
            width,
        };
        match gap.change(|factor| Some(self.try_out(factor).ok()?.verdict)) {
            Some(Change::At { to: thick, .. }) => Ok((thick, self.try_out(thick)?)),
            Some(Change::Between { from: thin, to: Some(thick) }) => {
                Err(self.undecided(Some(thin), thick))
            }
            Some(Change::Between { to: None, .. }) | None => Err(Absence::NoThickness),
        }
    }

    fn undecided(&self, thin: Option<f64>, thick: f64) -> Absence {
        let thickness_m = self.scene.target.thickness_m;
        Absence::Undecided {
            perforated_m: thin.map(|thin| thin * thickness_m),
            stopped_m: thick * thickness_m,
        }
    }
}
