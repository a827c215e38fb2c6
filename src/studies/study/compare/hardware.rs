//! The spring of an armour: its mass, and its limits.

use crate::study::load::spring_energy_j;
use cmra_engine::model::mechanism::load::{exceeded, stress_ratio};
use cmra_engine::model::mechanism::{Inertia, Mechanism};
use cmra_engine::model::scene::Scene;

/// Energies this part apart are the same.
const SAME: f64 = 1e-9;

/// Whose spring is judged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Hardware {
    /// Hardware of the scene; its capacity follows from its law, and from its mass if given.
    #[default]
    Own,
    /// Hardware without a given mass, sized for the energy of the design shot and no more.
    Sized,
}

/// The failure before the plate is perforated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Failure {
    /// Short name for a table.
    pub word: &'static str,
    /// The failure, as the end of a sentence.
    pub words: &'static str,
}

/// The load of a shot on the mechanism.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct MechanismLoadCase {
    /// Greatest displacement, m; `None` where nothing stops the plate, or where it is not known.
    max_displacement_m: Option<f64>,
    /// Greatest energy in the springs, J.
    stored_j: Option<f64>,
}

impl MechanismLoadCase {
    pub(super) fn from_scene(scene: &Scene, max_displacement_m: Option<f64>) -> Self {
        let stored_j = spring_energy_j(scene, scene.start_m(), max_displacement_m);
        Self { max_displacement_m, stored_j }
    }
}

/// Whether the springs of a scene know their own mass.
pub(super) fn is_own(scene: &Scene) -> bool {
    Inertia::from_scene(scene).spring_mass_kg.is_some()
}

/// Whether something stops the plate of a scene.
pub(super) fn is_held(scene: &Scene) -> bool {
    let mechanism = Mechanism::from_scene(scene);
    !scene.is_sprung() || !mechanism.is_absent() || mechanism.stop.is_some()
}

/// A scene's hardware as it is built.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct InstalledSpring {
    /// The springs' mass, kg; `None` where it is not known.
    pub(super) spring_kg: Option<f64>,
    /// Energy capacity, J.
    capacity_j: f64,
}

impl InstalledSpring {
    /// For this demand, where the springs do not know their own mass.
    pub(super) fn from_scene(
        scene: &Scene,
        hardware: Hardware,
        demand: &MechanismLoadCase,
    ) -> Self {
        let least_kg = scene.mechanism.min_spring_kg(demand.stored_j);
        let spring_kg = Inertia::from_scene(scene).spring_kg(least_kg);
        // The law of a beam says itself how far it goes.
        let is_bounded =
            stress_ratio(scene, 0.0).is_none() && (hardware == Hardware::Sized || is_own(scene));
        let capacity_j =
            spring_kg.zip(scene.mechanism.specific_energy_j_kg()).map(|(kg, e)| kg * e);
        let capacity_j = capacity_j.filter(|_| is_bounded).unwrap_or(f64::INFINITY);
        Self { spring_kg, capacity_j }
    }

    /// Areal mass of a scene with this hardware, kg/m².
    pub(super) fn areal_kg_m2(&self, scene: &Scene) -> Option<f64> {
        let plate_kg_m2 = scene.target.density_kg_m3 * scene.target.thickness_m;
        Some(plate_kg_m2 * (1.0 + self.spring_kg? / scene.plate_mass_kg()))
    }

    /// Returns the part that fails under a load case; `None` if all hold.
    pub(super) fn failure(&self, scene: &Scene, demand: &MechanismLoadCase) -> Option<Failure> {
        let max_displacement_m = demand.max_displacement_m.filter(|_| scene.is_sprung())?;
        if let Some(limit) = exceeded(scene, max_displacement_m).next() {
            return Some(Failure { word: "spring law", words: limit.what });
        }
        let is_full = |stored: &f64| *stored > self.capacity_j * (1.0 + SAME);
        let full = Failure { word: "spring full", words: "the spring reaches its energy capacity" };
        demand.stored_j.filter(is_full).map(|_| full)
    }
}
