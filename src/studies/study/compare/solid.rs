//! Thickness of a rigid or free plate with a given limit velocity, in closed form.

use crate::study::verdict::Verdict;
use cmra_engine::model::closed_form::Passage;
use cmra_engine::model::contact::Geometry;
use cmra_engine::model::plug::Plug;
use cmra_engine::model::scene::{Closure, ContactModel, Criterion, Mount, Nose, Scene, Target};
use cmra_engine::numerics::larger;
use cmra_engine::numerics::root::bracketed_root;

/// Ratio of successive trial thicknesses in the search for a plate with the margin of the measured limits, and number of trials.
const STEP: f64 = 1.05;
const STEPS: i32 = 60;
/// Relative distance beyond a root at which the limit must still be finite.
const BESIDE: f64 = 1e-9;

/// Computes the thickness, m, at which a free (`moves`) or rigid plate of the scene's material has this limit velocity, m/s, against the
/// scene's projectile; `None` for another contact model, or without strength or limit. Returns the thinner of two plates if the closure
/// depends on the thickness; returns the thickness of a jump if the limit jumps across this velocity.
pub(super) fn thickness_of_limit(scene: &Scene, limit_m_s: f64, moves: bool) -> Option<f64> {
    let Scene { target, projectile, .. } = scene;
    let with =
        |target: Target| of_stated_closure(&Scene { target, ..scene.clone() }, limit_m_s, moves);
    if target.closure != Closure::ByThickness || projectile.nose != Nose::Hemispherical {
        return with(target.in_effect(projectile));
    }
    let ranges = Target::by_thickness(projectile.tip_radius_m);
    for (at, (closure, from_m)) in ranges.into_iter().enumerate() {
        let thickness_m = with(target.under(closure, projectile.nose))?;
        let to_m = ranges.get(at + 1).map_or(f64::INFINITY, |(_, to_m)| *to_m);
        if thickness_m < to_m {
            return Some(larger(thickness_m, from_m));
        }
    }
    None
}

/// Computes the thickness, m, of the thinnest solid plate on a rigid mount that stops the scene's shot: below the band of the measured
/// limits if such shots were measured, else by the law.
pub(super) fn solid_thickness(scene: &Scene) -> Option<f64> {
    let v_m_s = scene.projectile.velocity_m_s;
    let by_law_m = thickness_of_limit(scene, v_m_s, false)?;
    let mut rigid = Scene { sweep: None, ..scene.clone() };
    rigid.plate.mount = Mount::Rigid;
    let excess_m_s = |thickness_m: f64| {
        let mut own = rigid.clone();
        own.target.thickness_m = thickness_m;
        Verdict::from_scene(&own).expected.map_or(0.0, |band| band.low_m_s - v_m_s)
    };
    // Beyond the thickness of the measured plates the law decides.
    if excess_m_s(by_law_m) >= 0.0 {
        return Some(by_law_m);
    }
    let thick_m =
        (1..STEPS).map(|more| by_law_m * STEP.powi(more)).find(|it| excess_m_s(*it) >= 0.0)?;
    Some(bracketed_root(thick_m / STEP, thick_m, excess_m_s))
}

fn of_stated_closure(scene: &Scene, limit_m_s: f64, moves: bool) -> Option<f64> {
    if scene.contact.model != ContactModel::Hydrodynamic || limit_m_s <= 0.0 {
        return None;
    }
    let swept = |thickness_m: f64| {
        let mut own = scene.clone();
        own.target.thickness_m = thickness_m;
        let geometry = Geometry::from_scene(&own);
        let through_m = match own.target.criterion {
            Criterion::Passage => geometry.exit_m,
            Criterion::Protrusion => geometry.travel_m(own.effective_thickness_m()),
        };
        geometry.swept_m3(through_m)
    };
    let geometry = Geometry::from_scene(scene);
    let plate_m_s = if moves { scene.plate_velocity_m_s() * scene.cos_obliquity() } else { 0.0 };
    let velocity_m_s = limit_m_s - plate_m_s;
    let mut passage = Passage::unsprung(scene, &geometry, moves);
    passage.velocity_m_s = velocity_m_s;
    if scene.projectile.nose.shears() {
        return thickness_that_shears(scene, velocity_m_s, moves);
    }
    // At the limit the perforated volume is exactly the volume that stops the shot. It does not depend on the thickness.
    let volume = passage.stopping_volume_m3()?;
    root(scene.target.thickness_m, |thickness_m| swept(thickness_m) - volume)
}

/// Returns the thickness for a nose that shears out a plug, by its limit relative to the plate; `None` if the whole plate is the plug at a
/// smaller thickness.
fn thickness_that_shears(scene: &Scene, velocity_m_s: f64, moves: bool) -> Option<f64> {
    let excess_m_s = |thickness_m: f64| {
        let mut own = scene.clone();
        own.target.thickness_m = thickness_m;
        let plug_kg = Plug::from_scene(&own).map_or(0.0, |plug| plug.mass_kg);
        if moves && plug_kg >= own.plate_mass_kg() {
            return f64::INFINITY;
        }
        let geometry = Geometry::from_scene(&own);
        Passage::unsprung(&own, &geometry, moves).limit_velocity_m_s() - velocity_m_s
    };
    let found_m = root(scene.target.thickness_m, excess_m_s)?;
    // Where the whole plate becomes the plug, the bracket may enclose a jump instead of a root.
    excess_m_s(found_m * (1.0 + BESIDE)).is_finite().then_some(found_m)
}

/// Finds the root of an increasing function of the thickness, m, starting from a value near it.
fn root(near_m: f64, excess: impl Fn(f64) -> f64) -> Option<f64> {
    let (mut thin, mut thick) = (near_m, near_m);
    for _ in 0..200 {
        if excess(thin) > 0.0 {
            thin *= 0.5;
        } else if excess(thick) < 0.0 {
            thick *= 2.0;
        } else {
            return Some(bracketed_root(thin, thick, excess));
        }
    }
    None
}
