//! Limit velocities by both closures of the flow strength, and the band between them.

use std::sync::Arc;

use crate::model::scene::{Closure, Nose, Scene, Target};
use crate::study::context::Context;
use crate::study::limit::alone;

/// How near to the thickness at which a closure changes a plate has to be for the jump there to matter, relative.
const NEAR: f64 = 0.25;

/// Limit velocities by the two closures, m/s; `None` where there is none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closures {
    /// Flow strength 2 Y, with dishing: made for thin plates.
    pub double_yield_m_s: Option<f64>,
    /// Its drag coefficient.
    pub double_yield_drag: f64,
    /// Pressure in an expanding cavity, without dishing, with twice that drag coefficient: made for thick ones.
    pub cavity_m_s: Option<f64>,
    /// Its drag coefficient.
    pub cavity_drag: f64,
}

impl Closures {
    /// By both closures; `None` where the flow strength does not come from a yield stress, or when stopped.
    pub(super) fn of(scene: &Scene, context: &mut Context<'_>) -> Option<Self> {
        // Both were made for a hemisphere.
        let is_other = scene.projectile.nose != Nose::Hemispherical;
        if is_other || matches!(scene.closure(), Closure::Given | Closure::Cylindrical) {
            return None;
        }
        let mut by = |closure: Closure| {
            let own = Arc::new(by_closure(scene, closure));
            let limit = alone(&own, context).ok();
            (limit.and_then(super::Limit::velocity_m_s), own.target.drag_coefficient)
        };
        let (double_yield_m_s, double_yield_drag) = by(Closure::DoubleYield);
        let (cavity_m_s, cavity_drag) = by(Closure::Cavity);
        Some(Self { double_yield_m_s, double_yield_drag, cavity_m_s, cavity_drag })
    }

    /// The band, m/s, the lower end first; `None` where a closure has no limit.
    pub fn band_m_s(self) -> Option<(f64, f64)> {
        let (a, b) = self.double_yield_m_s.zip(self.cavity_m_s)?;
        Some(if a < b { (a, b) } else { (b, a) })
    }
}

/// Between which limits, m/s, the limit of a scene jumps at the thickness where its closure changes; `None` where its closure does not
/// depend on the thickness, or its plate is not near that thickness.
pub(super) fn jump(scene: &Scene, context: &mut Context<'_>) -> Option<(f64, f64)> {
    scene.closure_by_thickness()?;
    let change_m = Target::thick_from_m(scene.projectile.tip_radius_m);
    let is_near = (scene.target.thickness_m / change_m - 1.0).abs() <= NEAR;
    let mut at_change = scene.clone();
    at_change.target.thickness_m = change_m;
    let by = Closures::of(&at_change, context).filter(|_| is_near && !scene.is_stack())?;
    by.double_yield_m_s.zip(by.cavity_m_s)
}

/// A scene whose flow strengths come from their yield stresses by this closure, with the dishing and the drag that belong to it.
fn by_closure(scene: &Scene, closure: Closure) -> Scene {
    let mut own = scene.clone();
    own.sweep = None;
    let layers = own.stack.layers.iter_mut().map(|layer| &mut layer.target);
    for target in std::iter::once(&mut own.target).chain(layers) {
        *target = target.in_effect(&scene.projectile);
        if matches!(target.closure, Closure::Given | Closure::Cylindrical) {
            continue;
        }
        if target.closure != closure {
            // Virostek's law has half the drag of cavity expansion on a hemisphere.
            target.drag_coefficient *= if closure == Closure::Cavity { 2.0 } else { 0.5 };
        }
        (target.closure, target.dishing) = (closure, closure == Closure::DoubleYield);
    }
    own
}
