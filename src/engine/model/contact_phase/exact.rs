//! The contact phase in closed form, where only inertia (or a rigid mount) resists the projectile.

use crate::model::closed_form::{self, Passage, Rule};
use crate::model::contact::Geometry;
use crate::model::contact_phase::{ContactSolution, Ending, Refusal};
use crate::model::mechanism::Mechanism;
use crate::model::scene::Scene;

/// Solve the contact phase of a scene without spring, damper and stop, or on a rigid mount.
///
/// # Errors
/// [`Refusal::NoClosedForm`] when a mechanism acts; [`Refusal::NonFinite`] at the ballistic limit itself, where the time is
/// infinite.
pub fn solve(scene: &Scene) -> Result<ContactSolution, Refusal> {
    let mechanism = &scene.mechanism;
    let rigid = scene.is_rigid();
    let acts = !Mechanism::of(scene).is_absent() || mechanism.stop.position_m.is_some();
    if acts && !rigid {
        return Err(Refusal::NoClosedForm);
    }
    let geometry = Geometry::of(scene);
    let passage = Passage::unsprung(scene, &geometry, !rigid);
    let found = passage.ending();
    let (ending, travel_m) = match found {
        closed_form::Ending::Arrest { travel_m } => (Ending::Arrest, travel_m),
        closed_form::Ending::Exit { .. } => (Ending::Perforation, geometry.exit_m),
    };
    let t_s = passage.history(found, Rule::FINEST).last().map_or(f64::NAN, |moment| moment.t_s);
    if !t_s.is_finite() {
        return Err(Refusal::NonFinite);
    }
    Ok(ContactSolution::free(ending, t_s, geometry.depth_m(travel_m)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::contact_phase::Phase;
    use crate::model::scene::Mount;
    use crate::model::variables::scene_without_spring as scene;
    use crate::numerics::stepper::dop853::Dop853;

    #[test]
    fn the_closed_form_and_dop853_agree_from_thin_to_thick_and_from_normal_to_oblique() {
        for pairs in ["", "h=0.003 v_i=400", "theta=30deg", "theta=60deg h=0.01 v_i=300"] {
            for mount in Mount::WORDS {
                let scene = scene(&format!("mount={mount} {pairs}"));
                let exact = solve(&scene).unwrap();
                let method = Dop853 { tolerance: 1e-12 };
                let other = Phase::of(&scene).solve(&method, 100_000).unwrap();
                assert_eq!(exact.ending, other.ending);
                let (time, depth) =
                    (exact.t_s / other.t_s - 1.0, exact.depth_m / other.depth_m - 1.0);
                assert!(time.abs() < 1e-10 && depth.abs() < 1e-10, "{pairs}: {time:e} {depth:e}");
            }
        }
    }

    #[test]
    fn a_mechanism_is_refused() {
        assert_eq!(solve(&Scene::default()), Err(Refusal::NoClosedForm));
    }
}
