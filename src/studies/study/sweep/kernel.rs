//! Points by the contact kernel: the first contact alone, then an energy balance for the maximum displacement.
//!
//! Valid where nothing after the first arrest (or perforation) changes the outputs: the fused interface, no stop, and, for
//! the displacement, no damper. All other points have no answer here and are simulated.
//!
//! The answers agree with those of the simulation within the scene's tolerance, not to the last digit: the contact is integrated
//! by other steps.

use crate::model::closed_form::{Ending, Passage};
use crate::model::contact::Geometry;
use crate::model::contact_kernel::{Contact, ContactEnd, contact_end};
use crate::model::mechanism::{Mechanism, moving_plate_kg};
use crate::model::run::Outcome;
use crate::model::scene::{ContactModel, Criterion, InterfaceLaw, Mount, Scene};
use crate::model::variables::Group;
use crate::numerics::larger;
use crate::study::load::holds_still;
use crate::study::quantities::{FromContact, turn_tells_force};
use crate::study::sweep::Plan;
use crate::study::sweep::evaluate::PointOutcome;

/// Fraction of the scene's tolerance that the contact may use up.
pub(in crate::study) const TOLERANCE_FRACTION: f64 = 0.3;

/// The result at a point.
#[derive(Clone, Copy, Debug)]
pub(in crate::study) struct KernelResult {
    pub(in crate::study) end: ContactEnd,
    /// Penetration of the same shot on a rigid mount, m; `None` when that perforates.
    pub(in crate::study) baseline_m: Option<f64>,
    /// The greatest displacement, m, where an output needs it; `None` where nothing stops the plate.
    pub(in crate::study) max_displacement_m: Option<f64>,
    pub(in crate::study) start_m: f64,
}

impl KernelResult {
    /// The greatest displacement of a plate that stops the shot: another shot does not size its springs.
    pub(in crate::study) fn stopped_displacement_m(&self) -> Option<f64> {
        self.max_displacement_m.filter(|_| self.end.arrested)
    }

    /// The end of a contact that ends in an arrest.
    pub(in crate::study) fn arrest(&self) -> Option<ContactEnd> {
        self.end.arrested.then_some(self.end)
    }
}

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
    answers: Vec<Option<(PointOutcome, KernelResult)>>,
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
    pub(super) fn found(&self, place: usize) -> Option<&(PointOutcome, KernelResult)> {
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
            let contact = Contact::of(scene);
            let end = if self.displacement {
                contact.run_minding_plate(tolerance)
            } else {
                contact.run(tolerance)
            };
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

    fn finish(&self, scene: &Scene, end: ContactEnd) -> (PointOutcome, KernelResult) {
        let baseline_m = match self.baseline {
            Baseline::Fixed(depth_m) => depth_m,
            Baseline::ByPoint => baseline_m(scene, &Geometry::of(scene)),
        };
        let max_displacement_m =
            if self.displacement { max_displacement_m(scene, &end) } else { None };
        let outcome = if is_through(scene, &end) { Outcome::Perforated } else { Outcome::Arrested };
        (
            PointOutcome::Ended(outcome),
            KernelResult { end, baseline_m, max_displacement_m, start_m: scene.start_m() },
        )
    }
}

/// The results of a shot to keep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::study) enum Wanted {
    /// Whether it goes through, however long that takes.
    Passage,
    Contact,
    /// The same and the maximum displacement.
    Displacement,
}

/// The end of the first contact to this tolerance, where that alone decides what is wanted.
pub(in crate::study) fn contact(
    scene: &Scene,
    wanted: Wanted,
    tolerance: f64,
) -> Option<ContactEnd> {
    decides(scene, wanted).then(|| contact_end(scene, tolerance))?
}

/// Whether a shot whose first contact ends so has perforated the plate, by the scene's criterion.
pub(in crate::study) fn is_through(scene: &Scene, end: &ContactEnd) -> bool {
    let by_protrusion = scene.target.criterion == Criterion::Protrusion;
    !end.arrested || by_protrusion && end.penetration_m > scene.effective_thickness_m()
}

/// Whether the first contact alone decides that: what is fused at the first arrest stays. All else takes the simulation.
fn decides(scene: &Scene, wanted: Wanted) -> bool {
    let mechanism = &scene.mechanism;
    let sprung = scene.plate.mount == Mount::Sprung;
    let stays = scene.contact.model == ContactModel::Hydrodynamic
        && scene.interface.law == InterfaceLaw::Fused;
    let is_free = !(sprung && mechanism.stop.position_m.is_some()) && scene.run.horizon_s.is_none();
    let is_damped = sprung && !mechanism.damper.is_absent();
    let is_alone = !scene.is_stack();
    stays
        && is_alone
        && match wanted {
            Wanted::Passage => true,
            Wanted::Contact => is_free,
            Wanted::Displacement => is_free && !is_damped,
        }
}

/// Penetration of the same shot on a rigid mount, m; `None` when that perforates.
fn baseline_m(scene: &Scene, geometry: &Geometry) -> Option<f64> {
    let rigid = Passage::rigid(scene, geometry);
    match rigid.ending() {
        Ending::Arrest { travel_m } => Some(geometry.depth_m(travel_m)),
        Ending::Exit { .. } => None,
    }
}

/// The maximum displacement without a damper: within the contact, or where all energy is in the spring; `None` where nothing
/// stops the plate.
pub(in crate::study) fn max_displacement_m(scene: &Scene, end: &ContactEnd) -> Option<f64> {
    if scene.plate.mount == Mount::Rigid {
        return Some(0.0);
    }
    let spring = Mechanism::of(scene).spring;
    let w = end.plate_velocity_m_s;
    if spring.is_absent() {
        return (w <= 0.0).then_some(end.max_displacement_m);
    }
    let cos = scene.cos_obliquity();
    let joined = if end.arrested { scene.projectile.mass_kg * cos * cos } else { 0.0 };
    let x = end.plate_displacement_m;
    let kinetic = 0.5 * (moving_plate_kg(scene) + joined) * w * w;
    let reach = spring.forward(x, kinetic + spring.energy(x));
    reach.is_finite().then(|| larger(reach, end.max_displacement_m))
}
