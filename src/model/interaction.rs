//! The other models of the force between projectile and plate, of thesis section 8.2 and Table 8.1: the half-sine force
//! history, the initial velocity, Wu's lumped parameters, and the listing of Appendix A.
//!
//! Each gives an ordinary [`Run`], so that it can be drawn, exported and compared like one of the hydrodynamic model. What a
//! model does not contain is absent: no depth where it knows none, no peak force where the collision takes no time. They
//! share the mechanism's laws with the engine but not its code: two bodies in `pair.rs`, their events in `course.rs`.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::model::contact::Geometry;
use crate::model::impact::{self, window::Window};
use crate::model::run::{AtLeast, Cost, EnergyLedger, Observer, Run, Settings};
use crate::model::scene::{ContactModel, InterfaceLaw, Mount, Scene};

mod coast;
mod course;
mod half_sine;
mod initial_velocity;
mod listing;
mod lumped;
mod pair;

/// `k_unload` over `k_load` unless given: a hundredth of the dent springs back, a tenth of the speed.
const UNLOAD_PER_LOAD: f64 = 100.0;

/// Simulate a valid scene by the model it names.
pub fn run(scene: &Arc<Scene>, settings: Settings, observer: Observer<'_>) -> Run {
    let mut run = match scene.contact.model {
        ContactModel::Hydrodynamic => {
            return impact::run(scene, settings, observer, &Window::default());
        }
        ContactModel::HalfSine => half_sine::run(scene, settings, observer),
        ContactModel::InitialVelocity => initial_velocity::run(scene, settings, observer),
        ContactModel::Lumped => lumped::run(scene, settings, observer),
        ContactModel::Appendix => listing::run(scene, settings, observer),
    };
    let quiet = Settings { series: false, estimate: false };
    if scene.plate.mount == Mount::Rigid {
        run.baseline_penetration_m = run.final_penetration_m;
    } else if run.end.is_complete() {
        let rigid = self::run(&Arc::new(on_rigid_mount(scene)), quiet, observer);
        run.baseline_penetration_m = rigid.final_penetration_m;
    }
    run
}

/// The same shot into the same plate on a rigid mount, by the same model with the same parameters.
fn on_rigid_mount(scene: &Scene) -> Scene {
    let mut rigid = scene.clone();
    rigid.plate.mount = Mount::Rigid;
    rigid.run.horizon_s = None;
    let values = Values::of(scene);
    rigid.contact.duration_s = Some(values.duration_s);
    rigid.contact.load_stiffness_n_m = Some(values.load_stiffness_n_m);
    rigid.contact.unload_stiffness_n_m = Some(values.unload_stiffness_n_m);
    rigid
}

/// The parameters of the models, with what was left open filled in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Values {
    /// `t_d`, s.
    pub duration_s: f64,
    /// `k_load`, N/m.
    pub load_stiffness_n_m: f64,
    /// `k_unload`, N/m.
    pub unload_stiffness_n_m: f64,
}

impl Values {
    /// The values a valid scene's models work with.
    pub fn of(scene: &Scene) -> Self {
        let contact = &scene.contact;
        let (duration_s, load_stiffness_n_m) =
            match (contact.duration_s, contact.load_stiffness_n_m) {
                (Some(duration_s), Some(load)) => (duration_s, load),
                (duration_s, load) => {
                    let (own_s, own_n_m) = hydrodynamic_on_rigid_mount(scene);
                    (duration_s.unwrap_or(own_s), load.unwrap_or(own_n_m))
                }
            };
        let unload = contact.unload_stiffness_n_m;
        Self {
            duration_s,
            load_stiffness_n_m,
            unload_stiffness_n_m: unload.unwrap_or(UNLOAD_PER_LOAD * load_stiffness_n_m),
        }
    }
}

/// How long the hydrodynamic contact lasts on a rigid mount, s, and the spring that is pressed in as far, N/m. A plate that
/// is perforated counts with its exit.
fn hydrodynamic_on_rigid_mount(scene: &Scene) -> (f64, f64) {
    let mut rigid = scene.clone();
    rigid.plate.mount = Mount::Rigid;
    rigid.contact.model = ContactModel::Hydrodynamic;
    rigid.run.horizon_s = None;
    let quiet = Settings { series: false, estimate: false };
    let (m_p, v) = (scene.projectile.mass_kg, scene.projectile.velocity_m_s);
    let geometry = Geometry::of(scene);
    let go_on = &mut |_| ControlFlow::Continue(());
    let run = impact::run(&Arc::new(rigid), quiet, go_on, &Window::default());
    let (duration_s, travel_m) = match run.first_arrest {
        Some(arrest) => (arrest.t_s, geometry.travel_m(arrest.penetration_m)),
        None => (run.exit_time_s.unwrap_or(geometry.exit_m / v), geometry.exit_m),
    };
    (duration_s, m_p * v * v / (travel_m * travel_m))
}

/// What is not to be said of a model, and so is left out of its run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ModelNote {
    /// The prescribed force goes on although the bodies have reached common velocity.
    Overruns {
        /// First common velocity, s.
        t_s: f64,
        /// `t_d`, s.
        duration_s: f64,
    },
    /// The model knows no rear face, and the depth is beyond it.
    DeeperThanPlate,
    /// The plastic interface law belongs to the hydrodynamic model.
    NoPlasticLaw,
    /// The listing has no stop.
    NoStop,
    /// The listing goes on with projectile and plate as one although the plate is perforated.
    JoinedThroughHole,
}

impl ModelNote {
    /// The sentence.
    pub fn words(self) -> String {
        match self {
            Self::Overruns { t_s, duration_s } => format!(
                "the half-sine history is that of a fixed plate: here both bodies have the same velocity at {:.4} us, and the \
                 force goes on to t_d = {:.4} us",
                t_s * 1e6,
                duration_s * 1e6
            ),
            Self::DeeperThanPlate => {
                "the depth is beyond the rear face, of which this model knows nothing: the plate would be perforated".to_owned()
            }
            Self::NoPlasticLaw => {
                "interface = plastic is ignored: only the hydrodynamic model has an interface that can yield".to_owned()
            }
            Self::NoStop => "the stop is ignored: the listing of Appendix A has none".to_owned(),
            Self::JoinedThroughHole => {
                "as printed, projectile and plate move on as one body although the plate is perforated; \
                 contact.appendix.afterwards = corrected parts them"
                    .to_owned()
            }
        }
    }
}

/// What every model has to say of a scene.
fn notes_of(scene: &Scene, depth_m: Option<f64>) -> Vec<ModelNote> {
    let mut notes = Vec::new();
    if depth_m.is_some_and(|depth_m| depth_m > scene.effective_thickness_m()) {
        notes.push(ModelNote::DeeperThanPlate);
    }
    if scene.interface.law == InterfaceLaw::Plastic {
        notes.push(ModelNote::NoPlasticLaw);
    }
    notes
}

/// A run with nothing in it yet.
fn blank(scene: &Arc<Scene>) -> Run {
    Run {
        scene: Arc::clone(scene),
        outcome: crate::model::run::Outcome::Moving,
        end: crate::model::run::EndReason::Decided,
        first_arrest: None,
        final_penetration_m: None,
        baseline_penetration_m: None,
        peak_contact_force_n: None,
        max_plate_displacement_m: None,
        at_least: AtLeast::default(),
        penetration_at_most_m: None,
        residual_velocity_m_s: None,
        exit_time_s: None,
        separation: None,
        interface_demand_ratio: None,
        error_estimate: None,
        error_estimates: Vec::new(),
        series: Vec::new(),
        events: Vec::new(),
        ledger: EnergyLedger::default(),
        mechanism: crate::model::run::MechanismLoad::default(),
        stack: None,
        cost: Cost::default(),
        omitted: Vec::new(),
        warnings: Vec::new(),
    }
}

#[cfg(test)]
mod tests;
