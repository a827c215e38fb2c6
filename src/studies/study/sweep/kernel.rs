//! The points of a sweep that the first contact decides, all of a piece together. All other points have no answer here and are
//! simulated.

use crate::model::contact::Geometry;
use crate::model::contact_kernel::{Contact, ContactEnd};
use crate::model::mechanism::Mechanism;
use crate::model::run::Outcome;
use crate::model::scene::{Mount, Scene};
use crate::model::variables::Group;
use crate::study::first_contact::{
    FirstContact, TOLERANCE_FRACTION, Wanted, baseline_m, decides, is_through, max_displacement_m,
};
use crate::study::load::holds_still;
use crate::study::outcome::PointOutcome;
use crate::study::quantities::{FromContact, turn_tells_force};
use crate::study::sweep::Plan;

#[derive(Clone, Copy, Debug)]
enum Baseline {
    /// No axis changes it: this, m, or none where a rigid mount is perforated.
    Fixed(Option<f64>),
    /// The axes change projectile or target.
    ByPoint,
}

pub(super) struct Kernel<'p> {
    plan: &'p Plan,
    /// An output needs the maximum displacement.
    displacement: bool,
    /// An output is the force into the mount.
    force: bool,
    /// An output needs the scene of its point.
    needs_scene: bool,
    baseline: Baseline,
    answers: Vec<Option<(PointOutcome, FirstContact)>>,
}

impl<'p> Kernel<'p> {
    /// The kernel for a plan whose outputs all follow from the first contact.
    pub(super) fn of(plan: &'p Plan) -> Option<Self> {
        let ways = || plan.outputs().iter().map(|output| output.from_contact);
        if ways().any(|way| matches!(way, FromContact::No)) {
            return None;
        }
        let displaces =
            |way| matches!(way, FromContact::Displacement(_) | FromContact::WithScene(_));
        let changes = |group: Group| plan.axes().iter().any(|axis| axis.variable().group == group);
        let fixed = !(changes(Group::Projectile) || changes(Group::Target));
        Some(Self {
            plan,
            displacement: ways().any(displaces),
            force: plan.outputs().iter().any(|output| output.name == "peak_mount_force_n"),
            needs_scene: ways()
                .any(|way| matches!(way, FromContact::WithScene(_) | FromContact::Scene)),
            baseline: if fixed {
                Baseline::Fixed(baseline_m(plan.base(), &Geometry::of(plan.base())))
            } else {
                Baseline::ByPoint
            },
            answers: Vec::new(),
        })
    }

    /// Whether a value needs the scene of its point.
    pub(super) fn needs_scene(&self) -> bool {
        self.needs_scene
    }

    /// The answer at a place of the piece computed last, if there is one.
    pub(super) fn found(&self, place: usize) -> Option<&(PointOutcome, FirstContact)> {
        self.answers.get(place)?.as_ref()
    }

    /// Computes those of these points that the first contact decides. `scene` is the plan's base, for placing them.
    pub(super) fn answer(&mut self, points: &[u64], scene: &mut Scene) {
        self.answers.clear();
        self.answers.resize(points.len(), None);
        let wanted = if self.displacement { Wanted::Displacement } else { Wanted::Contact };
        let tolerance = TOLERANCE_FRACTION * scene.run.tolerance;
        for (place, index) in points.iter().enumerate() {
            self.plan.place(scene, *index);
            if !(decides(scene, wanted) && self.tells_force(scene)) {
                continue;
            }
            let run = if self.displacement { Contact::run_minding_plate } else { Contact::run };
            let end = Contact::of(scene).and_then(|contact| run(&contact, tolerance));
            let answer = end.map(|end| self.finish(scene, end));
            // The mount of a plate that never moves bears the contact force, which takes a simulation.
            let still = |displaced_m| self.force && holds_still(scene, displaced_m);
            self.answers[place] = answer.filter(|answer| !still(answer.1.max_displacement_m));
        }
    }

    /// Whether the force into the mount, where it is an output, follows from where the plate starts and turns.
    fn tells_force(&self, scene: &Scene) -> bool {
        let sprung = scene.plate.mount == Mount::Sprung;
        !self.force || (sprung && turn_tells_force(scene) && !Mechanism::of(scene).is_absent())
    }

    fn finish(&self, scene: &Scene, end: ContactEnd) -> (PointOutcome, FirstContact) {
        let baseline_m = match self.baseline {
            Baseline::Fixed(depth_m) => depth_m,
            Baseline::ByPoint => baseline_m(scene, &Geometry::of(scene)),
        };
        let max_displacement_m =
            if self.displacement { max_displacement_m(scene, &end) } else { None };
        let outcome = if is_through(scene, &end) { Outcome::Perforated } else { Outcome::Arrested };
        (
            PointOutcome::Ended(outcome),
            FirstContact { end, baseline_m, max_displacement_m, start_m: scene.start_m() },
        )
    }
}
