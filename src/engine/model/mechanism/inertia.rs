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
    /// The mass of the first spring, where it is known, else none.
    known_kg: f64,
}

impl Inertia {
    /// Of a valid scene; nothing on a rigid mount.
    pub fn of(scene: &Scene) -> Self {
        let spring = &scene.mechanism.spring;
        let law = spring.law();
        let own_kg = mass_kg(scene);
        let counted_kg = own_kg.filter(|_| spring.own_mass == OwnMass::Counted);
        let rotation_kg = if scene.is_rigid() { 0.0 } else { law.rotation_kg() };
        Self {
            rotation_kg,
            added_kg: rotation_kg + counted_kg.map_or(0.0, |kg| law.moving_part(spring) * kg),
            // Of the second spring no mass is known.
            spring_mass_kg: own_kg.filter(|_| scene.mechanism.second_law().is_absent()),
            known_kg: own_kg.unwrap_or(0.0),
        }
    }

    /// The springs' whole mass where it is known, else the greater of its lower bounds: the least by their energy, and what is known, kg.
    pub fn spring_kg(&self, least_kg: Option<f64>) -> Option<f64> {
        self.spring_mass_kg.or_else(|| Some(larger(least_kg?, self.known_kg)))
    }
}

/// The mass that answers when the plate is pushed: `m_2` and what its mechanism adds, kg.
#[inline]
pub fn moving_plate_kg(scene: &Scene) -> f64 {
    if scene.mechanism.is_plain() {
        return scene.plate_mass_kg();
    }
    scene.plate_mass_kg() + Inertia::of(scene).added_kg
}

/// The springs' own mass that a run omits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OmittedMass {
    /// All of it, kg: known, or the least that the stored energy needs.
    pub mass_kg: f64,
    /// Whether it is the least.
    pub is_least: bool,
    /// The part that would move with the plate, kg.
    pub moving_kg: f64,
}

impl OmittedMass {
    /// Of a run whose springs stored this energy at most, J; `None` where all of it counts or nothing is known of it.
    pub fn of(scene: &Scene, stored_j: Option<f64>) -> Option<Self> {
        let mechanism = &scene.mechanism;
        if scene.is_rigid() || !mechanism.has_springs() {
            return None;
        }
        let spring = &mechanism.spring;
        let part = spring.law().moving_part(spring);
        let of = |mass_kg, is_least| Self { mass_kg, is_least, moving_kg: part * mass_kg };
        let own_kg = mass_kg(scene);
        let is_counted = spring.own_mass == OwnMass::Counted;
        let (counted_kg, known_kg) = if is_counted { (own_kg, None) } else { (None, own_kg) };
        let is_all_known = own_kg.is_some() || spring.is_absent() || is_counted;
        let least_kg = (!is_all_known || !mechanism.second_law().is_absent())
            .then(|| mechanism.least_spring_kg(stored_j?))
            .flatten()
            .map(|least_kg| larger(least_kg - counted_kg.unwrap_or(0.0), 0.0));
        // Each is a lower bound.
        let known = known_kg.map(|mass_kg| of(mass_kg, false)).into_iter();
        let both = known.chain(least_kg.map(|mass_kg| of(mass_kg, true)));
        both.max_by(|a, b| a.moving_kg.total_cmp(&b.moving_kg))
    }
}

/// The mass of the first spring, where there is one: given, of its beams, of an absorber that is crushed all the energy of its stroke
/// over its energy per mass, or, where it is to count, the least its energy needs in wire, kg.
fn mass_kg(scene: &Scene) -> Option<f64> {
    let spring = &scene.mechanism.spring;
    if scene.is_rigid() || spring.is_absent() {
        return None;
    }
    spring
        .mass_kg
        .or_else(|| spring.law().mass_kg(spring, scene.mechanism.energy_j_kg))
        .or_else(|| coil_kg(scene, spring).filter(|_| spring.own_mass == OwnMass::Counted))
}

/// Whether the spring's mass is to count and is not known: it counts as nothing.
pub fn is_uncounted(scene: &Scene) -> bool {
    let spring = &scene.mechanism.spring;
    let is_there = !scene.is_rigid() && !spring.is_absent();
    is_there && spring.own_mass == OwnMass::Counted && mass_kg(scene).is_none()
}

/// The wire that stores what a spring holds cocked and what projectile, plate and its own moving part keep at common velocity, kg.
/// Beside a second spring it is taken to store all of the latter: an upper bound. `None` of other springs than coils where no specific
/// energy is given.
fn coil_kg(scene: &Scene, spring: &scene::Spring) -> Option<f64> {
    let energy_j_kg = scene.mechanism.specific_energy_j_kg()?;
    let alone = scene::Mechanism { spring: spring.clone(), ..scene::Mechanism::default() };
    let cocked_j = Spring::of(&alone, 0.0).energy(0.0 - scene.plate.cocking_m);
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
