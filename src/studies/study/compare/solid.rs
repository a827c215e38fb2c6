//! The plate with a given limit velocity, rigid or free, in closed form.

use crate::model::closed_form::Passage;
use crate::model::contact::Geometry;
use crate::model::scene::{ContactModel, Criterion, Scene, Target};
use crate::numerics::larger;
use crate::numerics::root::in_bracket;

/// The thickness, m, at which a free (`moves`) or rigid plate of the scene's material has this limit velocity, m/s, against the scene's
/// projectile; `None` for another contact model, or without strength or limit. A closure that depends on thickness gives the thinner of
/// two such plates; where its limit jumps over this one, that of the jump.
pub(super) fn thickness_of_limit(scene: &Scene, limit_m_s: f64, moves: bool) -> Option<f64> {
    let of_nose = |tip_radius_m: f64| {
        let target = scene.target.in_effect(tip_radius_m);
        of_stated_closure(&Scene { target, ..scene.clone() }, limit_m_s, moves)
    };
    // Under a nose without end every plate is thin, under none every plate is thick.
    let thin = of_nose(f64::INFINITY)?;
    let thick_from_m = Target::thick_from_m(scene.projectile.tip_radius_m);
    if scene.closure_by_thickness().is_none() || thin < thick_from_m {
        return Some(thin);
    }
    Some(larger(of_nose(0.0)?, thick_from_m))
}

fn of_stated_closure(scene: &Scene, limit_m_s: f64, moves: bool) -> Option<f64> {
    if scene.contact.model != ContactModel::Hydrodynamic || limit_m_s <= 0.0 {
        return None;
    }
    let swept = |thickness_m: f64| {
        let mut own = scene.clone();
        own.target.thickness_m = thickness_m;
        let geometry = Geometry::of(&own);
        let through_m = match own.target.criterion {
            Criterion::Passage => geometry.exit_m,
            Criterion::Protrusion => geometry.travel_m(own.effective_thickness_m()),
        };
        geometry.swept_m3(through_m)
    };
    let geometry = Geometry::of(scene);
    let plate_m_s = if moves { scene.plate_velocity_m_s() * scene.cos_obliquity() } else { 0.0 };
    let velocity_m_s = limit_m_s - plate_m_s;
    let passage = Passage { velocity_m_s, ..Passage::unsprung(scene, &geometry, moves) };
    // At the limit the perforation takes just the volume that stops the shot, which does not depend on the thickness.
    let volume = passage.stopping_volume_m3()?;
    let (mut thin, mut thick) = (scene.target.thickness_m, scene.target.thickness_m);
    for _ in 0..200 {
        if swept(thin) > volume {
            thin *= 0.5;
        } else if swept(thick) < volume {
            thick *= 2.0;
        } else {
            return Some(in_bracket(thin, thick, |thickness| swept(thickness) - volume));
        }
    }
    None
}
