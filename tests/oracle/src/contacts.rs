//! Contact models of thesis section 8.2, implemented a second time from the README and the thesis.

use cmra_engine::model::scene::{ContactModel, Mount, Scene};
use std::f64::consts::PI;

use crate::law::Shot;

/// Step and end of the shot on a rigid mount from which what is left open comes, s.
const STEP_S: f64 = 2e-8;
const END_S: f64 = 3e-3;

/// The half-sine force history and the lumped interface.
#[derive(Clone, Copy)]
pub(crate) struct Contact {
    pub(crate) model: ContactModel,
    /// `t_d`, s.
    pub(crate) duration_s: f64,
    /// Greatest force of the history: its impulse is the projectile's whole momentum, N.
    peak_n: f64,
    /// `k_load`, `k_unload`, N/m, and `b_2`, N s/m.
    load: f64,
    unload: f64,
    damping: f64,
}

impl Contact {
    pub(crate) fn new(scene: &Scene) -> Self {
        let given = &scene.contact;
        let (m_p, v) = (scene.projectile.mass_kg, scene.projectile.velocity_m_s);
        let (mut duration_s, mut load) =
            (given.duration_s.unwrap_or(0.0), given.load_stiffness_n_m.unwrap_or(0.0));
        let needed = match given.model {
            ContactModel::HalfSine => given.duration_s.is_none(),
            ContactModel::Lumped => given.load_stiffness_n_m.is_none(),
            _ => false,
        };
        if needed {
            let (t_s, travel_m) = on_rigid_mount(scene);
            duration_s = given.duration_s.unwrap_or(t_s);
            load = given.load_stiffness_n_m.unwrap_or_else(|| m_p * (v / travel_m).powi(2));
        }
        Self {
            model: given.model,
            duration_s,
            peak_n: m_p * v * PI / (2.0 * duration_s),
            load,
            unload: given.unload_stiffness_n_m.unwrap_or(100.0 * load),
            damping: given.damping_n_s_m,
        }
    }

    /// The history, N.
    pub(crate) fn pulse_n(&self, t_s: f64) -> f64 {
        self.peak_n * (PI * t_s / self.duration_s).sin()
    }

    /// Where the interface is slack after it was pressed in so far, m.
    pub(crate) fn slack_m(&self, deepest_m: f64) -> f64 {
        deepest_m * (1.0 - self.load / self.unload)
    }

    /// Spring and damper, deeper than ever.
    pub(crate) fn loads_n(&self, q: f64, u: f64) -> f64 {
        self.load * q + self.damping * u
    }

    /// Spring and damper above the greatest depth.
    pub(crate) fn springs_n(&self, q: f64, u: f64, deepest_m: f64) -> f64 {
        self.unload * (q - self.slack_m(deepest_m)) + self.damping * u
    }
}

/// When the hydrodynamic contact on a rigid mount ends, s, and at which travel, m.
fn on_rigid_mount(scene: &Scene) -> (f64, f64) {
    let mut rigid = scene.clone();
    rigid.plate.mount = Mount::Rigid;
    rigid.contact.model = ContactModel::Hydrodynamic;
    let mut shot = Shot::new(&rigid, STEP_S);
    let mut until_s = 1e-5;
    while shot.first_arrest.is_none() && shot.exit.is_none() && until_s < END_S {
        assert!(shot.go_to(until_s));
        until_s *= 1.5;
    }
    let (t_s, state) = shot.first_arrest.or(shot.exit).expect("it ends");
    (t_s, state[0])
}
