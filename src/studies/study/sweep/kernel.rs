//! Points of a sweep that the first contact determines; all other points are simulated.

use crate::study::first_contact::{
    ContactOutput, FirstContact, TOLERANCE_FRACTION, baseline_m, decides, is_perforated,
    max_displacement_m,
};
use crate::study::load::holds_still;
use crate::study::outcome::PointOutcome;
use crate::study::quantities::{FromContact, turn_tells_force};
use crate::study::sweep::Plan;
use cmra_engine::model::contact::Geometry;
use cmra_engine::model::contact_kernel::Contact;
use cmra_engine::model::run::Outcome;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::variables::Group;

#[derive(Clone, Copy, Debug)]
enum Baseline {
    /// Depth on a rigid mount, independent of the axes, m; `None` for a perforation.
    Fixed(Option<f64>),
    /// The axes change projectile or target.
    ByPoint,
}

pub(super) struct Kernel {
    /// Whether a quantity needs the maximum displacement.
    displacement: bool,
    /// Whether a quantity is the mount force.
    force: bool,
    baseline: Baseline,
}

impl Kernel {
    /// Creates the kernel of a plan; `None` unless all quantities follow from the first contact.
    pub(super) fn from_plan(plan: &Plan) -> Option<Self> {
        let ways = || plan.outputs().iter().map(|output| output.from_contact);
        if ways().any(|way| matches!(way, FromContact::No)) {
            return None;
        }
        let displaces = |way| matches!(way, FromContact::Displacement(_));
        let changes = |group: Group| plan.axes().iter().any(|axis| axis.variable().group == group);
        let fixed = !(changes(Group::Projectile) || changes(Group::Target));
        Some(Self {
            displacement: ways().any(displaces),
            force: plan.outputs().iter().any(|output| output.name == "peak_mount_force_n"),
            baseline: if fixed {
                Baseline::Fixed(baseline_m(plan.base(), &Geometry::from_scene(plan.base())))
            } else {
                Baseline::ByPoint
            },
        })
    }

    /// Computes the first contact of a point; `None` if it does not determine the results.
    pub(super) fn answer(&self, scene: &Scene) -> Option<(PointOutcome, FirstContact)> {
        let wanted =
            if self.displacement { ContactOutput::Displacement } else { ContactOutput::Contact };
        // The peak mount force follows from the start and the turning points of the plate.
        if !decides(scene, wanted) || self.force && !turn_tells_force(scene) {
            return None;
        }
        let (contact, tolerance) =
            (Contact::from_scene(scene)?, TOLERANCE_FRACTION * scene.run.tolerance);
        let end = contact.run(tolerance)?;
        let max_displacement_m =
            if self.displacement { max_displacement_m(scene, &end) } else { None };
        // The mount force of a locked plate is the contact force, which needs a simulation.
        if self.force && holds_still(scene, max_displacement_m) {
            return None;
        }
        let baseline_m = match self.baseline {
            Baseline::Fixed(depth_m) => depth_m,
            Baseline::ByPoint => baseline_m(scene, &Geometry::from_scene(scene)),
        };
        let outcome =
            if is_perforated(scene, &end) { Outcome::Perforated } else { Outcome::Arrested };
        let start_m = scene.start_m();
        let contact = FirstContact { end, baseline_m, max_displacement_m, start_m };
        Some((PointOutcome::Ended(outcome), contact))
    }
}
