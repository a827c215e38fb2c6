//! The inertia that a mechanism adds to the plate: the rotation of what turns with it, and the springs' own mass.
//!
//! A plate that turns by dphi/dx per displacement has the kinetic energy of an additional mass `I_z (dphi/dx)²` (thesis 6.2.7,
//! the principle of rotational transfer). Of a spring's own mass a part moves with the plate: that with the kinetic energy
//! of its static shape, 1/3 of a coil spring (Rayleigh), 33/140 of a cantilever, 13/35 of a beam guided at its end. A coil
//! spring weighs at least `4 rho G U/tau²` for the energy U it has to store; U is that of the cocked spring and of
//! projectile, plate and the spring's own moving part at common velocity, together.

use crate::model::design::coil_spring_mass_kg;
use crate::model::mechanism::Spring;
use crate::model::scene::{self, OwnMass, Scene, WhichSpring};
use crate::numerics::larger;

/// The additional mass that moves with the plate, kg.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Inertia {
    /// `I_z (dphi/dx)²` of what turns.
    pub rotation_kg: f64,
    /// The moving part of the springs' own mass.
    pub springs_kg: f64,
    /// The springs' whole mass, where that of every spring is known; an absent one has none.
    pub spring_mass_kg: Option<f64>,
    /// The mass of those springs whose mass is known.
    known_kg: f64,
}

impl Inertia {
    /// Of a valid scene; nothing on a rigid mount.
    pub fn of(scene: &Scene) -> Self {
        if scene.is_rigid() {
            return Self::default();
        }
        let mut sum = Self::default();
        for spring in scene.mechanism.acting() {
            sum.rotation_kg += spring.law().rotation_kg();
        }
        for (_, spring) in present(scene) {
            let Some(mass_kg) = mass_kg(scene, spring) else { continue };
            sum.known_kg += mass_kg;
            if spring.own_mass == OwnMass::Counted {
                sum.springs_kg += spring.moving_part() * mass_kg;
            }
        }
        let is_known = present(scene).all(|(_, spring)| mass_kg(scene, spring).is_some());
        sum.spring_mass_kg = (is_known && present(scene).next().is_some()).then_some(sum.known_kg);
        sum
    }

    /// The springs' whole mass where it is known, else the greater of its lower bounds: the least by their energy, and what is known, kg.
    pub fn spring_kg(&self, least_kg: Option<f64>) -> Option<f64> {
        self.spring_mass_kg.or_else(|| Some(larger(least_kg?, self.known_kg)))
    }

    /// All of it, kg.
    pub fn added_kg(&self) -> f64 {
        self.rotation_kg + self.springs_kg
    }
}

/// The mass that answers when the plate is pushed: `m_2` and what its mechanism adds, kg.
#[inline]
pub fn moving_plate_kg(scene: &Scene) -> f64 {
    if scene.mechanism.is_plain() {
        return scene.plate_mass_kg();
    }
    scene.plate_mass_kg() + Inertia::of(scene).added_kg()
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
    /// The spring of which most moves.
    pub which: WhichSpring,
}

impl OmittedMass {
    /// Of a run whose springs stored this energy at most, J; `None` where all of it counts or nothing is known of it.
    pub fn of(scene: &Scene, stored_j: Option<f64>) -> Option<Self> {
        let (mut known, mut counted_kg, mut greatest_kg) = (None, 0.0, 0.0);
        for (which, spring) in present(scene) {
            let Some(mass_kg) = mass_kg(scene, spring) else { continue };
            if spring.own_mass == OwnMass::Counted {
                counted_kg += mass_kg;
                continue;
            }
            let none = Self { mass_kg: 0.0, is_least: false, moving_kg: 0.0, which };
            let sum = known.get_or_insert(none);
            let moving_kg = spring.moving_part() * mass_kg;
            sum.mass_kg += mass_kg;
            sum.moving_kg += moving_kg;
            if moving_kg > greatest_kg {
                (greatest_kg, sum.which) = (moving_kg, which);
            }
        }
        let unknown = present(scene).find(|(_, spring)| {
            spring.own_mass == OwnMass::Ignored && mass_kg(scene, spring).is_none()
        });
        let least = unknown.and_then(|(which, spring)| {
            let mass_kg = scene.mechanism.least_spring_kg(stored_j?)? - counted_kg;
            let moving_kg = spring.moving_part() * mass_kg;
            Some(Self { mass_kg, is_least: true, moving_kg, which })
        });
        // Each is a lower bound.
        let both = [known, least].into_iter().flatten();
        both.max_by(|a, b| a.moving_kg.total_cmp(&b.moving_kg))
    }
}

/// The springs that act and are there.
fn present(scene: &Scene) -> impl Iterator<Item = (WhichSpring, &scene::Spring)> {
    let mechanism = &scene.mechanism;
    let acting = WhichSpring::ALL.into_iter().filter(|which| mechanism.acts(*which));
    let springs = acting.map(|which| (which, mechanism.one(which)));
    springs.filter(|(_, spring)| !scene.is_rigid() && !spring.is_absent())
}

/// A spring's mass: given, of its beams, or, where its mass is to count, the least its energy needs in wire, kg.
fn mass_kg(scene: &Scene, spring: &scene::Spring) -> Option<f64> {
    spring
        .mass_kg
        .or_else(|| spring.law().mass_kg(spring))
        .or_else(|| coil_kg(scene, spring).filter(|_| spring.own_mass == OwnMass::Counted))
}

/// The spring whose mass is to count and is not known: it counts as nothing.
pub fn uncounted(scene: &Scene) -> Option<WhichSpring> {
    let is_unknown =
        |spring| mass_kg(scene, spring).is_none() && spring.own_mass == OwnMass::Counted;
    present(scene).find(|(_, spring)| is_unknown(spring)).map(|(which, _)| which)
}

/// The wire that stores what a spring holds cocked and what projectile, plate and its own moving part keep at common velocity, kg.
/// Of two springs each is taken to store all of the latter, without the inertia of the other: an upper bound. `None` of other springs
/// than coils where no specific energy is given.
fn coil_kg(scene: &Scene, spring: &scene::Spring) -> Option<f64> {
    let coil_j_kg = || spring.law().is_coil().then(|| 1.0 / coil_spring_mass_kg(1.0, &spring.wire));
    let energy_j_kg = scene.mechanism.energy_j_kg.or_else(coil_j_kg)?;
    let alone = scene::Mechanism { spring: spring.clone(), ..scene::Mechanism::default() };
    let cocked_j = Spring::of(&alone).energy(0.0 - scene.plate.cocking_m);
    let (m_p, cos) = (scene.projectile.mass_kg, scene.cos_obliquity());
    let momentum = m_p * scene.projectile.velocity_m_s * cos;
    let bodies_kg = m_p * cos * cos + scene.plate_mass_kg();
    // m e = U_cocked + momentum²/(2 (bodies + part m)) is quadratic in m.
    let part = spring.moving_part();
    let half = 0.5 * (bodies_kg * energy_j_kg - part * cocked_j);
    let product = bodies_kg * cocked_j + 0.5 * momentum * momentum;
    let root = (half * half + part * energy_j_kg * product).sqrt();
    Some(if half > 0.0 { product / (half + root) } else { (root - half) / (part * energy_j_kg) })
}
