//! The constants of one impact, derived once from its scene.

use std::sync::{Arc, OnceLock};

use crate::model::closed_form::Passage;
use crate::model::contact::Geometry;
use crate::model::contact_models::{self, ContactLaw, Scales};
use crate::model::fixed_plate::plate_is_fixed;
use crate::model::impact::straight_core::with_straight_core;
use crate::model::mechanism::{Inertia, Mechanism, PowerLaw, Spring};
use crate::model::scene::{ContactModel, InterfaceLaw, Scene};
use crate::numerics::{larger, smaller};

/// Part of its displacement at which a plate that creeps back has arrived, and how many times its first time constant it is
/// waited for at most.
const RETURNED: f64 = 1e-14;
const DECAY_MAX: f64 = 50.0;

/// Oscillations of the spring, with all energy in it, after which a run ends at the latest, and where the interface may yield.
const OSCILLATIONS: f64 = 20.0;
const PLASTIC_OSCILLATIONS: f64 = 100.0;

/// Oscillations (in radians) within the contact that Taylor steps can still follow.
const OSCILLATION_MAX_RAD: f64 = 1e5;
/// Time constants of the damper within the contact up to which Taylor steps are the cheaper way.
const DECAYS_MAX: f64 = 3e3;

/// Everything the run needs to know about its scene.
#[derive(Clone, Debug)]
pub(super) struct Problem {
    pub(super) scene: Arc<Scene>,
    pub(super) geometry: Geometry,
    pub(super) mechanism: Mechanism,
    pub(super) contact: Arc<dyn ContactLaw>,
    pub(super) projectile_kg: f64,
    /// `m_2` and what its mechanism adds, kg.
    pub(super) plate_kg: f64,
    pub(super) inertia: Inertia,
    /// `m_2` + `m_p` cos², the mass that moves with the plate when both move together, kg.
    pub(super) joined_kg: f64,
    /// Part of the mechanism's force that the interface carries while fused: `m_p` cos / joined mass.
    pub(super) interface_fraction: f64,
    pub(super) cos: f64,
    /// `S_y`, Pa.
    pub(super) strength_pa: f64,
    pub(super) drag_kg_m3: f64,
    /// g.
    pub(super) grip: f64,
    pub(super) velocity_m_s: f64,
    /// Of projectile and spring at first contact, J.
    pub(super) energy_j: f64,
    pub(super) rigid: bool,
    /// The plastic interface law.
    pub(super) plastic: bool,
    pub(super) start_m: f64,
    /// When the run ends at the latest, s.
    pub(super) horizon_s: f64,
    pub(super) plate_response: PlateResponse,
    /// How far the plate yields within the contact, relative to the travel.
    pub(super) yields_part: f64,
    /// Penetration on a rigid mount, m; `None` where that perforates, or the contact model knows no depth.
    pub(super) baseline_m: Option<f64>,
    /// The scene gives the horizon: the run goes on to it.
    pub(super) horizon_is_given: bool,
    /// How many times as long as usual a run that oscillates on undecided is followed.
    pub(super) oscillation_factor: usize,
    /// How far the absorber has been crushed, m.
    pub(super) crushed_m: f64,
    /// The same impact once it is crushed farther.
    pub(super) next: OnceLock<Box<Self>>,
}

/// How the plate answers to the contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum PlateResponse {
    Rigid,
    /// The mechanism cannot move it noticeably.
    Fixed,
    /// Only its inertia answers.
    Free,
    /// The mechanism matters: integrate.
    Mechanism,
}

/// How fast things happen.
#[derive(Clone, Copy, Debug)]
pub(super) struct TimeScales {
    pub(super) contact_s: f64,
    /// How far the mechanism yields to the contact force, relative to the travel.
    pub(super) yields_part: f64,
    /// Angular frequency of the plate on its spring, 1/s.
    frequency_rad_s: f64,
    /// Decay rate of the plate's velocity by its damper, 1/s.
    decay_per_s: f64,
}

impl TimeScales {
    /// Whether the implicit method should have the contact from the start. NaN counts as stiff.
    pub(super) fn is_stiff(&self) -> bool {
        let oscillations = self.frequency_rad_s * self.contact_s;
        let decays = self.decay_per_s * self.contact_s;
        !(oscillations < OSCILLATION_MAX_RAD && decays < DECAYS_MAX)
    }
}

#[cfg(test)]
impl Problem {
    /// Of the default scene with these variables.
    pub(super) fn with(pairs: &str) -> Self {
        Self::of(&Arc::new(crate::model::variables::scene_with(pairs)))
    }
}

impl Problem {
    pub(super) fn of(scene: &Arc<Scene>) -> Self {
        let geometry = Geometry::of(scene);
        let contact = contact_models::of(scene, &geometry);
        let flows = scene.contact.model == ContactModel::Hydrodynamic;
        let mut mechanism = Mechanism::of(scene);
        mechanism.spring = with_straight_core(mechanism.spring);
        let rigid = scene.is_rigid();
        let cos = geometry.nose.cos;
        let inertia = Inertia::of(scene);
        let projectile_kg = scene.projectile.mass_kg;
        let plate_kg = scene.plate_mass_kg() + inertia.added_kg();
        let joined_kg = plate_kg + projectile_kg * cos * cos;
        let velocity_m_s = scene.projectile.velocity_m_s;
        let start_m = scene.start_m();
        let energy_j =
            0.5 * projectile_kg * velocity_m_s * velocity_m_s + mechanism.spring.energy(start_m);
        let mut problem = Self {
            scene: Arc::clone(scene),
            geometry,
            mechanism,
            contact,
            projectile_kg,
            plate_kg,
            inertia,
            joined_kg,
            interface_fraction: projectile_kg * cos / joined_kg,
            cos,
            strength_pa: if flows { scene.flow_strength_pa() } else { 0.0 },
            drag_kg_m3: if flows { scene.drag_kg_m3() } else { 0.0 },
            grip: scene.interface.grip,
            velocity_m_s,
            energy_j,
            rigid,
            plastic: flows && scene.interface.law == InterfaceLaw::Plastic,
            start_m,
            horizon_s: 0.0,
            plate_response: PlateResponse::Mechanism,
            yields_part: 1.0,
            baseline_m: None,
            horizon_is_given: scene.run.horizon_s.is_some(),
            oscillation_factor: 1,
            crushed_m: 0.0,
            next: OnceLock::new(),
        };
        let baseline = problem.contact.hole_on_rigid_mount_m();
        problem.baseline_m = baseline.map(|travel_m| problem.geometry.depth_m(travel_m));
        problem.plate_response = problem.find_plate_response();
        problem.yields_part = problem.time_scales().yields_part;
        problem.horizon_s = scene.run.horizon_s.unwrap_or_else(|| problem.horizon_of_scene());
        problem
    }

    /// How the plate answers: what the contact has to be computed with.
    fn find_plate_response(&self) -> PlateResponse {
        if !self.flows() {
            PlateResponse::Mechanism
        } else if self.rigid {
            PlateResponse::Rigid
        } else if self.mechanism.is_absent() && self.mechanism.stop.is_none() {
            PlateResponse::Free
        } else if plate_is_fixed(&self.passage(false), &self.mechanism, self.start_m) {
            PlateResponse::Fixed
        } else {
            PlateResponse::Mechanism
        }
    }

    /// Whether the contact is the flow of the target at its strength: the hydrodynamic model.
    pub(super) fn flows(&self) -> bool {
        self.scene.contact.model == ContactModel::Hydrodynamic
    }

    /// Whether the force into the mount does not follow from the displacement alone: there is a damper, or a stop.
    pub(super) fn follows_mount_force(&self) -> bool {
        !self.mechanism.damper.is_absent() || self.mechanism.stop.is_some()
    }

    /// Whether the spring is a combination with a power law that is infinitely steep at zero.
    pub(super) fn straightens(&self) -> bool {
        let mechanism = &self.scene.mechanism;
        let second = mechanism.second_law();
        let first = mechanism.spring.power_law().unwrap_or(PowerLaw::NONE);
        self.mechanism.spring.curve().is_some()
            && !second.is_absent()
            && (first.is_steep_at_zero() || second.is_steep_at_zero())
    }

    /// 1/mu: how strongly the contact force slows the slip, 1/kg.
    pub(super) fn slip_mobility(&self, plate_moves: bool) -> f64 {
        let projectile = 1.0 / self.projectile_kg;
        if plate_moves { projectile + self.cos * self.cos / self.plate_kg } else { projectile }
    }

    /// The relative motion alone, for a plate that is rigid or free.
    pub(super) fn passage(&self, plate_moves: bool) -> Passage<'_> {
        Passage::unsprung(&self.scene, &self.geometry, plate_moves)
    }

    /// Depth at a travel, m; not a number where the contact model knows none.
    pub(super) fn depth_m(&self, travel_m: f64) -> f64 {
        let known = self.contact.hole_m(travel_m);
        known.map_or(f64::NAN, |_| self.geometry.depth_m(travel_m))
    }

    /// How long the contact lasts, and how fast the mechanism answers within it, by order of magnitude.
    pub(super) fn time_scales(&self) -> TimeScales {
        let (spring, damper) = (&self.mechanism.spring, self.mechanism.damper);
        let (v, m_2) = (self.velocity_m_s, self.plate_kg);
        let Scales { travel_m, duration_s, force_n: contact_n } = self.contact.scales();
        let mut contact_s = duration_s;
        let preload = spring.force(self.start_m).abs();
        // A cocked plate that is thrown forward at the projectile's speed ends the contact.
        if preload > 0.0 && damper.at_force(preload) > v {
            contact_s = smaller(contact_s, m_2 * v / preload);
        }
        let drive = larger(contact_n, preload);
        let thrown = drive * contact_s / m_2;
        let yields = smaller(spring.at_force(contact_n), 0.5 * thrown * contact_s);
        let x = larger(yields, self.start_m.abs());
        let w = smaller(damper.at_force(drive), thrown);
        TimeScales {
            contact_s,
            yields_part: smaller(yields / travel_m, 1.0),
            frequency_rad_s: (spring.tangent(x).abs() / m_2).sqrt(),
            decay_per_s: damper.tangent(w) / m_2,
        }
    }

    /// Long enough for the contact, many oscillations of the spring with all energy in it, and a plate that
    /// creeps back against its damper (`d=0.1 b=2000 k=1e5` takes 0.6 s).
    fn horizon_of_scene(&self) -> f64 {
        let passage_s = self.geometry.exit_m / self.velocity_m_s;
        let longest_s = if self.flows() { passage_s } else { self.contact.scales().duration_s };
        let contact = 50.0 * longest_s;
        if self.rigid {
            return contact;
        }
        let energy = self.energy_j;
        let speed = (2.0 * energy / self.plate_kg).sqrt();
        let far = match &self.mechanism.spring {
            Spring::Power(law) => law.at_integral(energy),
            Spring::Curve(curve) => {
                let (x, e) = (self.start_m, energy);
                // An absorber holds the plate on one side only.
                let ways = [curve.forward(x, e), curve.backward(x, e)].map(f64::abs);
                ways.into_iter().filter(|far| far.is_finite()).fold(0.0, larger)
            }
        };
        let oscillation = far / speed * 8.0;
        // The first half-oscillation of a joined body decides; one that slips in its hole loses energy for many oscillations.
        let oscillations = if self.plastic { PLASTIC_OSCILLATIONS } else { OSCILLATIONS };
        let rest = [oscillations * oscillation, self.creeping_s(far)];
        contact + rest.into_iter().filter(|part| part.is_finite()).sum::<f64>()
    }

    /// The time in which a plate without inertia comes back from a displacement to [`RETURNED`] of it, s: b w^m = k x^n. It is an
    /// exponential decay for n = m and ends in a finite time for n < m; for n > m it goes on for ever, and is cut short.
    fn creeping_s(&self, far_m: f64) -> f64 {
        let (spring, damper) = (&self.mechanism.spring, self.mechanism.damper);
        let Some(law) = spring.power().filter(|law| !law.is_absent()) else { return 0.0 };
        if damper.is_absent() {
            return 0.0;
        }
        let speed = (law.force(far_m) / damper.coefficient).powf(1.0 / damper.exponent);
        let power = 1.0 - law.exponent / damper.exponent;
        // The integral of z^(power - 1) from RETURNED to 1.
        let decay =
            if power.abs() < 1e-6 { -RETURNED.ln() } else { (1.0 - RETURNED.powf(power)) / power };
        smaller(decay, DECAY_MAX) * far_m / speed
    }
}
