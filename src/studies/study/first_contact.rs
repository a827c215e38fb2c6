//! The first contact of a shot alone, by the contact kernel, then an energy balance for the greatest displacement.
//!
//! Valid where nothing after the first arrest (or perforation) changes what is wanted: the fused interface, no stop, and, for
//! the displacement, no damper. All else takes the simulation.
//!
//! The answers agree with those of the simulation within the scene's tolerance, not to the last digit: the contact is integrated
//! by other steps.

use cmra_engine::model::closed_form::Passage;
use cmra_engine::model::contact::Geometry;
use cmra_engine::model::contact_kernel::{Contact, ContactEnd};
use cmra_engine::model::mechanism::{Mechanism, moving_plate_kg};
use cmra_engine::model::scene::{ContactModel, Criterion, InterfaceLaw, Scene};
use cmra_engine::numerics::larger;

/// Fraction of the scene's tolerance that the contact may use up.
pub(in crate::study) const TOLERANCE_FRACTION: f64 = 0.3;

/// Result of the first contact, and the plate's motion after it.
#[derive(Clone, Copy, Debug)]
pub(in crate::study) struct FirstContact {
    pub(in crate::study) end: ContactEnd,
    /// Penetration of the same shot on a rigid mount, m; `None` when that perforates.
    pub(in crate::study) baseline_m: Option<f64>,
    /// The greatest displacement, m, where an output needs it; `None` where nothing stops the plate.
    pub(in crate::study) max_displacement_m: Option<f64>,
    pub(in crate::study) start_m: f64,
}

impl FirstContact {
    /// Where the plate starts and its greatest displacement. Without damper and stop it stores no more on the way back.
    pub(in crate::study) fn displacements_m(&self) -> Option<[f64; 2]> {
        Some([self.start_m, self.max_displacement_m?])
    }

    /// The displacements of a plate that stops the shot: another shot does not size its springs.
    pub(in crate::study) fn stopped_displacements_m(&self, scene: &Scene) -> Option<[f64; 2]> {
        self.displacements_m().filter(|_| !is_perforated(scene, &self.end))
    }

    /// The end of a contact that ends in an arrest.
    pub(in crate::study) fn arrest(&self) -> Option<ContactEnd> {
        self.end.arrested.then_some(self.end)
    }
}

/// The results of a shot to keep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::study) enum ContactOutput {
    /// Whether it goes through, however long that takes.
    Passage,
    Contact,
    /// First contact and maximum plate displacement.
    Displacement,
}

/// The end of the first contact to this tolerance, where that alone decides what is wanted.
pub(in crate::study) fn contact(
    scene: &Scene,
    wanted: ContactOutput,
    tolerance: f64,
) -> Option<ContactEnd> {
    decides(scene, wanted).then(|| Contact::from_scene(scene)?.run(tolerance))?
}

/// Whether a shot whose first contact ends so has perforated the plate, by the scene's criterion.
pub(in crate::study) fn is_perforated(scene: &Scene, end: &ContactEnd) -> bool {
    let by_protrusion = scene.target.criterion == Criterion::Protrusion;
    !end.arrested || by_protrusion && end.penetration_m > scene.effective_thickness_m()
}

/// Whether the first contact alone decides that: what is fused at the first arrest stays. All else takes the simulation.
pub(in crate::study) fn decides(scene: &Scene, wanted: ContactOutput) -> bool {
    let mechanism = &scene.mechanism;
    let sprung = scene.is_sprung();
    let stays = scene.contact.model == ContactModel::Hydrodynamic
        && scene.interface.law == InterfaceLaw::Fused;
    let is_free = !(sprung && mechanism.stop.position_m.is_some()) && scene.run.horizon_s.is_none();
    let is_damped = sprung && !mechanism.damper.is_absent();
    let goes_back = sprung && scene.plate.velocity_m_s < 0.0;
    let is_alone = !scene.is_stack();
    stays
        && is_alone
        && match wanted {
            ContactOutput::Passage => true,
            ContactOutput::Contact => is_free,
            // A plate that first goes back may store more energy there than at its greatest displacement.
            ContactOutput::Displacement => is_free && !is_damped && !goes_back,
        }
}

/// Penetration of the same shot on a rigid mount, m; `None` when that perforates.
pub(in crate::study) fn baseline_m(scene: &Scene, geometry: &Geometry) -> Option<f64> {
    Passage::rigid(scene, geometry).arrest_m().map(|q_m| geometry.depth_m(q_m))
}

/// The maximum displacement without a damper: within the contact, or where all energy is in the spring; `None` where nothing
/// stops the plate.
pub(in crate::study) fn max_displacement_m(scene: &Scene, end: &ContactEnd) -> Option<f64> {
    if !scene.is_sprung() {
        return Some(0.0);
    }
    let spring = Mechanism::from_scene(scene).spring;
    let w = end.plate_velocity_m_s;
    if spring.is_absent() {
        return (w <= 0.0).then_some(end.max_displacement_m);
    }
    let cos = scene.cos_obliquity();
    let joined = if end.arrested { scene.projectile.mass_kg * cos * cos } else { 0.0 };
    let x = end.plate_displacement_m;
    let kinetic = 0.5 * (moving_plate_kg(scene) + joined) * w * w;
    let reach = spring.reach(x, kinetic + spring.energy(x), 1.0);
    reach.is_finite().then(|| larger(reach, end.max_displacement_m))
}
