//! The spring of an armour: its mass, and its limits.

use crate::study::load::{areal_kg_m2_with, spring_energy_j};
use cmra_engine::model::mechanism::load::{exceeded, stress_ratio};
use cmra_engine::model::mechanism::{Inertia, Mechanism};
use cmra_engine::model::scene::Scene;

/// Relative tolerance for equal energies.
const SAME: f64 = 1e-9;

/// Hardware for which the limits are computed.
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
    /// Extreme displacements of the plate, m; `None` if nothing stops the plate or they are unknown.
    ends_m: Option<[f64; 2]>,
    /// Maximum energy stored in the springs, J.
    stored_j: Option<f64>,
}

impl MechanismLoadCase {
    pub(super) fn from_scene(scene: &Scene, ends_m: Option<[f64; 2]>) -> Self {
        Self { ends_m, stored_j: spring_energy_j(scene, ends_m) }
    }
}

/// Returns `true` if the mass of a scene's springs is given.
pub(super) fn is_own(scene: &Scene) -> bool {
    Inertia::from_scene(scene).spring_mass_kg.is_some()
}

/// Returns `true` if the scene has a spring, damper, stop or mount that stops the plate.
pub fn is_held(scene: &Scene) -> bool {
    let mechanism = Mechanism::from_scene(scene);
    !scene.is_sprung() || !mechanism.is_absent() || mechanism.stop.is_some()
}

/// Springs of a scene as built: mass and energy capacity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct InstalledSpring {
    /// Mass of the springs, kg; `None` if unknown.
    pub(super) spring_kg: Option<f64>,
    /// Energy capacity, J.
    capacity_j: f64,
}

impl InstalledSpring {
    /// Determines the springs from this load case if their mass is not given.
    pub(super) fn from_scene(
        scene: &Scene,
        hardware: Hardware,
        demand: &MechanismLoadCase,
    ) -> Self {
        let least_kg = scene.mechanism.min_spring_kg(demand.stored_j);
        let spring_kg = Inertia::from_scene(scene).spring_kg(least_kg);
        // The law of a beam is bounded: it gives its own maximum displacement.
        let is_bounded =
            stress_ratio(scene, 0.0).is_none() && (hardware == Hardware::Sized || is_own(scene));
        let capacity_j =
            spring_kg.zip(scene.mechanism.specific_energy_j_kg()).map(|(kg, e)| kg * e);
        let capacity_j = capacity_j.filter(|_| is_bounded).unwrap_or(f64::INFINITY);
        Self { spring_kg, capacity_j }
    }

    /// Returns the areal mass of a scene with this hardware, kg/m².
    pub(super) fn areal_kg_m2(&self, scene: &Scene) -> Option<f64> {
        Some(areal_kg_m2_with(scene, self.spring_kg?))
    }

    /// Returns the part that fails under a load case; `None` if all hold.
    pub(super) fn failure(&self, scene: &Scene, demand: &MechanismLoadCase) -> Option<Failure> {
        if !scene.is_sprung() {
            return None;
        }
        // A plate that nothing stops passes the end of every law.
        let ends_m = demand.ends_m.unwrap_or_else(|| [scene.start_m(), f64::INFINITY]);
        if let Some(limit) = exceeded(scene, ends_m).first() {
            return Some(Failure { word: "spring law", words: limit.what });
        }
        let is_full = |stored: &f64| *stored > self.capacity_j * (1.0 + SAME);
        let full = Failure { word: "spring full", words: "the spring reaches its energy capacity" };
        demand.stored_j.filter(is_full).map(|_| full)
    }
}
