//! Limit velocities by the closures of the flow strength under a hemisphere, and their range.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::study::context::Context;
use crate::study::limit::search::ShotWork;
use crate::study::limit::shot_outcome::{ShotOutcome, decide};
use crate::study::limit::{Limit, alone_within};
use cmra_engine::model::closed_form::ballistic_limit_m_s as closed_form;
use cmra_engine::model::scene::{Closure, ContactModel, Nose, Scene, Target};
use cmra_engine::model::simulate::{RunSnapshot, Settings};
use cmra_engine::numerics::{larger, smaller};

/// Maximum relative distance of a thickness from that of a closure change for the jump to be reported.
const NEAR: f64 = 0.25;

/// Limit velocities by the three closures, m/s; `None` without a limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closures {
    /// Limit with the flow strength 2 Y and dishing, a rule for thin plates.
    pub double_yield_m_s: Option<f64>,
    /// Drag coefficient of the double-yield rule.
    pub double_yield_drag: f64,
    /// Limit with the pressure in an expanding spherical cavity, without dishing and with twice the drag coefficient; a rule for thick
    /// plates.
    pub cavity_m_s: Option<f64>,
    /// Drag coefficient of cavity expansion.
    pub cavity_drag: f64,
    /// Limit with the pressure in an expanding cylindrical cavity of a hardening metal, without dishing and with the drag of the spherical
    /// rule.
    pub cylindrical_m_s: Option<f64>,
}

impl Closures {
    /// Computes the limits by the three closures; `None` if the flow strength does not follow from a yield stress, if the nose is not a
    /// hemisphere (other noses have one law), or if cancelled.
    pub(super) fn from_scene(
        scene: &Scene,
        context: &mut Context<'_>,
        work: &mut ShotWork,
    ) -> Option<Self> {
        let has_one = scene.projectile.nose != Nose::Hemispherical;
        if has_one || scene.closure() == Closure::Given {
            return None;
        }
        let mut by = |closure: Closure| {
            let own = Arc::new(by_closure(scene, closure));
            let limit = alone_within(&own, context, work).ok();
            let drag = own.target_in_effect().drag_coefficient;
            (limit.and_then(Limit::decided_m_s), drag)
        };
        let (double_yield_m_s, double_yield_drag) = by(Closure::DoubleYield);
        let (cavity_m_s, cavity_drag) = by(Closure::Cavity);
        let (cylindrical_m_s, _) = by(Closure::Cylindrical);
        Some(Self { double_yield_m_s, double_yield_drag, cavity_m_s, cavity_drag, cylindrical_m_s })
    }

    /// Returns the range of the limits, m/s, lower end first; `None` if a closure has no limit.
    pub fn band_m_s(self) -> Option<(f64, f64)> {
        let (a, b) = self.double_yield_m_s.zip(self.cavity_m_s)?;
        let c = self.cylindrical_m_s?;
        Some((smaller(smaller(a, b), c), larger(larger(a, b), c)))
    }
}

/// Returns `true` if a valid scene's shot is stopped by each of the three closures for a hemisphere, none of which is favoured by
/// measurements. Always `true` if there is only one closure.
pub fn is_stopped_by_every_closure(scene: &Scene) -> bool {
    let has_one = scene.projectile.nose != Nose::Hemispherical
        || scene.contact.model != ContactModel::Hydrodynamic
        || scene.closure() == Closure::Given;
    let closures = [Closure::DoubleYield, Closure::Cavity, Closure::Cylindrical];
    has_one
        || closures.into_iter().filter(|closure| *closure != scene.closure()).all(|closure| {
            let own = by_closure(scene, closure);
            if let Some(limit_m_s) = closed_form(&own) {
                return own.projectile.velocity_m_s < limit_m_s;
            }
            let go_on = &mut |_: &RunSnapshot<'_>| ControlFlow::Continue(());
            let shot = decide(&Arc::new(own), &Settings::BARE, go_on);
            shot.is_some_and(|(_, outcome)| outcome == ShotOutcome::Stopped)
        })
}

/// Computes the limits, m/s, on either side of the nearest thickness at which the closure of a scene changes; `None` if the closure does
/// not depend on the thickness, or if the plate's thickness is not close to that of the change.
pub(super) fn jump(
    scene: &Scene,
    context: &mut Context<'_>,
    work: &mut ShotWork,
) -> Option<(f64, f64)> {
    let nose = scene.projectile.nose;
    if scene.target.closure != Closure::ByThickness || nose != Nose::Hemispherical {
        return None;
    }
    let tip_radius_m = scene.projectile.tip_radius_m;
    let change_m = scene.target.nearest_change_m(tip_radius_m);
    if (scene.target.thickness_m / change_m - 1.0).abs() > NEAR || scene.is_stack() {
        return None;
    }
    let ranges = Target::by_thickness(tip_radius_m);
    let after = ranges.iter().position(|(_, from_m)| from_m.to_bits() == change_m.to_bits())?;
    let mut at_change = |closure: Closure| {
        let mut own = Scene { sweep: None, ..scene.clone() };
        own.target.thickness_m = change_m;
        own.target = own.target.under(closure, nose);
        // Fix the drag of this closure; a cylindrical closure would choose another.
        own.target.give_drag();
        alone_within(&Arc::new(own), context, work).ok()?.decided_m_s()
    };
    at_change(ranges[after - 1].0).zip(at_change(ranges[after].0))
}

/// Returns a scene whose flow strengths follow from their yield stresses by this closure, with its dishing and drag.
fn by_closure(scene: &Scene, closure: Closure) -> Scene {
    let mut own = scene.clone();
    own.sweep = None;
    let layers = own.stack.layers.iter_mut().map(|layer| &mut layer.target);
    for target in std::iter::once(&mut own.target).chain(layers) {
        *target = target.in_effect(&scene.projectile);
        if target.closure == Closure::Given {
            continue;
        }
        // A given drag stays in proportion to that of the closure.
        let nose = scene.projectile.nose;
        let (own, other) = (target.by_law(target.closure, nose), target.by_law(closure, nose));
        let factor = other.drag_coefficient / own.drag_coefficient;
        *target = Target { drag_coefficient: factor * target.drag_coefficient, ..other };
        target.give_drag();
    }
    own
}
