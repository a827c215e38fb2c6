//! Quantities of the mount, from the initial and turning positions of the plate: mount force, and masses of spring and plate.

use crate::study::load::{self, areal_kg_m2_with, spring_energy_j};
use crate::study::outcome::PointOutcome;
use cmra_engine::model::mechanism::{Inertia, Mechanism};
use cmra_engine::model::run::Run;
use cmra_engine::model::scene::Scene;
use cmra_engine::numerics::larger;

/// Returns the minimum mass of a spring for its maximum stored energy, kg; `None` if unknown.
pub(super) fn min_spring_kg(scene: &Scene, ends_m: Option<[f64; 2]>) -> Option<f64> {
    scene.mechanism.min_spring_kg(spring_energy_j(scene, ends_m))
}

/// Returns the extreme plate displacements of a run with a stopped shot, m. A perforation does not size the springs.
pub(super) fn stopped_displacements_m(run: &Run) -> Option<[f64; 2]> {
    run.displacements_m().filter(|_| !PointOutcome::from_run(run).is_through())
}

/// Returns the given mass of the springs, else their minimum mass, kg.
fn spring_kg(scene: &Scene, ends_m: Option<[f64; 2]>) -> Option<f64> {
    Inertia::from_scene(scene).spring_kg(min_spring_kg(scene, ends_m))
}

/// Returns the mass of plate and springs, kg.
pub(super) fn system_kg(scene: &Scene, ends_m: Option<[f64; 2]>) -> Option<f64> {
    Some(scene.plate_mass_kg() + spring_kg(scene, ends_m)?)
}

/// Returns the mass of plate and springs over the face of the plate, kg/m².
pub(super) fn areal_kg_m2(scene: &Scene, ends_m: Option<[f64; 2]>) -> Option<f64> {
    Some(areal_kg_m2_with(scene, spring_kg(scene, ends_m)?))
}

/// Returns the maximum mount force of a run that ended before the maximum plate displacement, a lower bound.
pub(super) fn min_peak_n(run: &Run) -> Option<f64> {
    run.at_least.plate_displacement_m.and_then(|_| load::peak_so_far_n(run))
}

/// Returns `true` if the maximum mount force follows from the initial and turning positions: for a sprung plate on an odd power law without
/// stop, damper and rotating parts.
pub(in crate::study) fn turn_tells_force(scene: &Scene) -> bool {
    let mechanism = Mechanism::from_scene(scene);
    if !scene.is_sprung() || mechanism.is_absent() {
        return false;
    }
    let is_odd = mechanism.spring.power().is_some();
    let is_alone = mechanism.stop.is_none() && mechanism.damper.coefficient == 0.0;
    is_odd && is_alone && Inertia::from_scene(scene).rotation_kg == 0.0
}

/// Computes the mount force of a spring alone, without a simulation, from the initial and turning positions; `None` if other parts
/// contribute.
pub(super) fn force_n(scene: &Scene, max_displacement_m: Option<f64>) -> Option<f64> {
    if !turn_tells_force(scene) || load::holds_still(scene, max_displacement_m) {
        return None;
    }
    let mechanism = Mechanism::from_scene(scene);
    let (start_m, max_displacement_m) = (scene.start_m(), max_displacement_m?);
    let [at_start, at_turn] = [start_m, max_displacement_m].map(|x| mechanism.spring.force(x));
    Some(larger(at_start.abs(), at_turn.abs()))
}
