//! The inertia that a mechanism adds to the plate: the rotation of what turns with it, and the springs' own mass.
//!
//! A plate that turns by dphi/dx per displacement has the kinetic energy of an additional mass `I_z (dphi/dx)²` (thesis 6.2.7,
//! the principle of rotational transfer). Of a spring's own mass a part moves with the plate: that with the kinetic energy
//! of its static shape, 1/3 of a coil spring (Rayleigh), 33/140 of a cantilever, 13/35 of a beam guided at its end. A coil
//! spring weighs at least `4 rho G U/tau²` for the energy U it has to store; U is that of the cocked spring and of
//! projectile, plate and the spring's own moving part at common velocity, together.

use crate::model::mechanism::Spring;
use crate::model::scene::{self, OwnMass, Scene};
use crate::numerics::larger;

/// The additional mass that moves with the plate, kg.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Inertia {
    /// `I_z (dphi/dx)²` of what turns.
    pub rotation_kg: f64,
    /// All of it: that, and the moving part of the springs' own mass.
    pub added_kg: f64,
    /// The springs' whole mass, where it is known; an absent one has none.
    pub spring_mass_kg: Option<f64>,
    /// Whether the first spring's mass is to count and is not known: it counts as nothing.
    pub is_uncounted: bool,
    /// The mass of the first spring, where it is known, else none.
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
        // Given, of beams, of an absorber by the energy of its whole stroke, or, where it is to count, of wire.
        let own_kg = spring
            .mass_kg
            .or_else(|| spring.law().mass_kg(spring, scene.mechanism.energy_j_kg))
            .or_else(|| is_counted.then(|| coil_kg(scene)).flatten())
            .filter(|_| !spring.is_absent());
        let counted_kg = own_kg.filter(|_| is_counted).unwrap_or(0.0);
        let rotation_kg = spring.law().rotation_kg();
        Self {
            rotation_kg,
            added_kg: rotation_kg + spring.law().moving_part(spring) * counted_kg,
            // Of the second spring no mass is known.
            spring_mass_kg: own_kg.filter(|_| scene.mechanism.second_law().is_absent()),
            is_uncounted: is_counted && own_kg.is_none() && !spring.is_absent(),
            known_kg: own_kg.unwrap_or(0.0),
            counted_kg,
        }
    }

    /// The springs' whole mass where it is known, else the greater of its lower bounds: the least by their energy, and what is known, kg.
    pub fn spring_kg(&self, least_kg: Option<f64>) -> Option<f64> {
        self.spring_mass_kg.or_else(|| Some(larger(least_kg?, self.known_kg)))
    }

    /// Returns the mass of the springs that is neglected, kg, if known, and whether it follows from the least mass.
    pub fn omitted_kg(&self, least_kg: Option<f64>) -> (f64, bool) {
        let all_kg = self.spring_kg(least_kg).unwrap_or(self.known_kg);
        (all_kg - self.counted_kg, all_kg > self.known_kg)
    }
}

/// The mass that answers when the plate is pushed: `m_2` and what its mechanism adds, kg.
pub fn moving_plate_kg(scene: &Scene) -> f64 {
    scene.plate_mass_kg() + Inertia::from_scene(scene).added_kg
}

/// The wire that stores what a spring holds cocked and what projectile, plate and its own moving part keep at common velocity, kg.
/// Beside a second spring it is taken to store all of the latter: an upper bound. `None` of other springs than coils where no specific
/// energy is given.
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
    let part = spring.law().moving_part(spring);
    let half = 0.5 * (bodies_kg * energy_j_kg - part * cocked_j);
    let product = bodies_kg * cocked_j + 0.5 * momentum * momentum;
    let root = (half * half + part * energy_j_kg * product).sqrt();
    Some(if half > 0.0 { product / (half + root) } else { (root - half) / (part * energy_j_kg) })
}
