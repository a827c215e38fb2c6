//! Inertia that a mechanism adds to the plate: geared rotation and the mass of the springs.
//!
//! A plate with the rotation dphi/dx has the kinetic energy of an additional mass `I_z (dphi/dx)²` (thesis 6.2.7, rotational transfer). The
//! moving fraction of the mass of a spring is that with the kinetic energy of its static shape: 1/3 for a coil spring (Rayleigh), 33/140
//! for a cantilever, 13/35 for a beam with a guided end. A coil spring is taken to weigh `4 rho G U/tau²`, where U, whatever the run
//! stores, is the energy of the cocked spring plus the kinetic energy of projectile, plate and moving part of the spring at common
//! velocity.

use crate::model::mechanism::Spring;
use crate::model::scene::{self, OwnMass, Scene};
use crate::numerics::larger;

/// Additional mass that moves with the plate.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Inertia {
    /// Mass equivalent to the rotation, `I_z (dphi/dx)²`, kg.
    pub rotation_kg: f64,
    /// Total additional mass: rotation and moving fraction of the springs, kg.
    pub added_kg: f64,
    /// Total mass of the springs if known, kg; 0 for an absent spring.
    pub spring_mass_kg: Option<f64>,
    /// Whether the mass of the first spring is to be included but is unknown; it is then 0.
    pub is_uncounted: bool,
    /// Mass of the first spring if known, else 0, kg.
    known_kg: f64,
    /// Mass of the springs that moves with the plate, kg.
    counted_kg: f64,
}

impl Inertia {
    /// Computes the inertia of a valid scene; zero on a rigid mount.
    pub fn from_scene(scene: &Scene) -> Self {
        if !scene.is_sprung() {
            return Self::default();
        }
        let spring = &scene.mechanism.spring;
        let is_counted = spring.own_mass == OwnMass::Counted;
        // Mass as given, of beams, of an absorber by its specific energy, or of wire if it is to be included.
        let own_kg = spring
            .mass_kg
            .or_else(|| spring.law().mass_kg(spring, scene.mechanism.energy_j_kg))
            .or_else(|| is_counted.then(|| coil_kg(scene)).flatten())
            .filter(|_| !spring.is_absent());
        let counted_kg = own_kg.filter(|_| is_counted).unwrap_or(0.0);
        let rotation_kg = spring.law().rotation_kg();
        Self {
            rotation_kg,
            added_kg: rotation_kg + spring.moving_part() * counted_kg,
            // The mass of the second spring is unknown.
            spring_mass_kg: own_kg.filter(|_| scene.mechanism.second_law().is_absent()),
            is_uncounted: is_counted && own_kg.is_none() && !spring.is_absent(),
            known_kg: own_kg.unwrap_or(0.0),
            counted_kg,
        }
    }

    /// Returns the total mass of the springs, kg; if unknown, the larger of its lower bounds (by energy, and the known part).
    pub fn spring_kg(&self, least_kg: Option<f64>) -> Option<f64> {
        self.spring_mass_kg.or_else(|| Some(larger(least_kg?, self.known_kg)))
    }

    /// Returns the mass of the springs that is neglected, kg, if known, and whether it follows from the least mass.
    pub fn omitted_kg(&self, least_kg: Option<f64>) -> (f64, bool) {
        let all_kg = self.spring_kg(least_kg).unwrap_or(self.known_kg);
        (all_kg - self.counted_kg, all_kg > self.known_kg)
    }
}

/// Returns the effective mass of the plate, kg: `m_2` plus the mass that the mechanism adds.
pub fn moving_plate_kg(scene: &Scene) -> f64 {
    scene.plate_mass_kg() + Inertia::from_scene(scene).added_kg
}

/// Returns the mass of wire that stores the energy of the cocked spring and the kinetic energy at common velocity, kg; an upper bound with
/// a second spring. `None` for a spring that is not a coil, without a given specific energy.
fn coil_kg(scene: &Scene) -> Option<f64> {
    let spring = &scene.mechanism.spring;
    let energy_j_kg = scene.mechanism.specific_energy_j_kg()?;
    let alone = scene::Mechanism { spring: spring.clone(), ..scene::Mechanism::default() };
    let cocked_j = Spring::new(&alone, 0.0).energy(0.0 - scene.plate.cocking_m);
    let (m_p, cos) = (scene.projectile.mass_kg, scene.cos_obliquity());
    let plate_kg = scene.plate_mass_kg();
    let momentum =
        m_p * scene.projectile.velocity_m_s * cos + plate_kg * scene.plate_velocity_m_s();
    let bodies_kg = m_p * cos * cos + plate_kg;
    // m e = U_cocked + momentum²/(2 (bodies + part m)) is quadratic in m.
    let part = spring.moving_part();
    let half = 0.5 * (bodies_kg * energy_j_kg - part * cocked_j);
    let product = bodies_kg * cocked_j + 0.5 * momentum * momentum;
    let root = (half * half + part * energy_j_kg * product).sqrt();
    Some(if half > 0.0 { product / (half + root) } else { (root - half) / (part * energy_j_kg) })
}
