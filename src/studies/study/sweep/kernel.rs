//! A point of a sweep that its first contact decides. All other points have no answer here and are simulated.

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
use cmra_engine::model::mechanism::Mechanism;
use cmra_engine::model::run::Outcome;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::variables::Group;

#[derive(Clone, Copy, Debug)]
enum Baseline {
    /// Depth on a rigid mount, which no axis changes, m; `None` if that is perforated.
    Fixed(Option<f64>),
    /// The axes change projectile or target.
    ByPoint,
}

pub(super) struct Kernel {
    /// An output needs the maximum displacement.
    displacement: bool,
    /// An output is the force into the mount.
    force: bool,
    baseline: Baseline,
}

impl Kernel {
    /// The kernel for a plan whose outputs all follow from the first contact.
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

    /// The first contact of the scene of a point, where that decides it.
    pub(super) fn answer(&self, scene: &Scene) -> Option<(PointOutcome, FirstContact)> {
        let wanted =
            if self.displacement { ContactOutput::Displacement } else { ContactOutput::Contact };
        // The force into the mount, where it is an output, follows from where the plate starts and turns.
        let tells_force = || {
            let sprung = scene.is_sprung();
            !self.force
                || (sprung && turn_tells_force(scene) && !Mechanism::from_scene(scene).is_absent())
        };
        if !(decides(scene, wanted) && tells_force()) {
            return None;
        }
        let (contact, tolerance) =
            (Contact::from_scene(scene)?, TOLERANCE_FRACTION * scene.run.tolerance);
        let end = contact.run(tolerance)?;
        let max_displacement_m =
            if self.displacement { max_displacement_m(scene, &end) } else { None };
        // The mount of a plate that never moves bears the contact force, which takes a simulation.
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
