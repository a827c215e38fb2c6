//! Whether the mechanism cannot move the plate noticeably, decided from bounds before the integration.

use std::f64::consts::PI;

use crate::model::closed_form::{Ending, Passage};
use crate::model::mechanism::Mechanism;
use crate::numerics::smaller;

/// A mechanism that lets the plate move less than this part of the travel within the contact is as good as rigid.
const FIXED_MOTION: f64 = 1e-13;
/// A contact that ends in an arrest lasts less than this many times as long as its travel takes at the impact velocity.
const SLOWEST: f64 = 6.0;

/// Whether an uncocked mechanism holds the plate so still during the contact that it is as good as a rigid mount.
///
/// `rigid` is the passage into the same plate on a rigid mount. The contact force never exceeds pi R² (S + c v²); against it the
/// spring yields at most to where its energy equals the work, k x^(n+1)/(n+1) = F x, and the damper at most at the speed
/// (F/b)^(1/m).
pub(super) fn plate_is_fixed(rigid: &Passage<'_>, mechanism: &Mechanism, start_m: f64) -> bool {
    let (geometry, v) = (rigid.geometry, rigid.velocity_m_s);
    let radius = geometry.nose.radius_m;
    let pressure = rigid.strength_pa + rigid.drag_kg_m3 * v * v;
    if start_m != 0.0 || (mechanism.stop_at_m <= 0.0 && pressure > 0.0) {
        return false;
    }
    let force = PI * radius * radius * pressure * geometry.nose.cos;
    let Some(spring) = mechanism.spring.power() else {
        return false;
    };
    let yields = spring.at_force((spring.exponent + 1.0) * force);
    let creeps_m_s = mechanism.damper.at_force(force);
    // No contact is shorter than its passage at the impact velocity: most scenes are done with here.
    if smaller(yields, creeps_m_s * geometry.exit_m / v) > FIXED_MOTION * geometry.exit_m {
        return false;
    }
    let (travel_m, time_s) = match rigid.ending() {
        Ending::Arrest { travel_m } => (travel_m, SLOWEST * travel_m / v),
        Ending::Exit { velocity_m_s } => (geometry.exit_m, geometry.exit_m / velocity_m_s),
    };
    smaller(yields, creeps_m_s * time_s) <= FIXED_MOTION * travel_m
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::contact::Geometry;
    use crate::model::variables::scene_without_spring as scene;

    fn still(pairs: &str) -> bool {
        let scene = scene(pairs);
        let geometry = Geometry::of(&scene);
        let rigid = Passage::rigid(&scene, &geometry);
        plate_is_fixed(&rigid, &Mechanism::of(&scene), 0.0 - scene.plate.cocking_m)
    }

    /// F is about 2e4 N: (F/k)^(1/n) is 7e-18 m for k = 1e6 and n = 0.1, 4e-6 m for n = 0.3, 2e-4 m for k = 1e8 and n = 1.
    #[test]
    fn a_spring_that_yields_by_1e_17_m_holds_unless_it_is_cocked_and_one_that_yields_by_a_micrometre_does_not()
     {
        assert!(still("k=1e6 n=0.1"));
        for pairs in ["k=1e6 n=0.3", "k=1e8", "", "k=1e6 n=0.1 d=0.001"] {
            assert!(!still(pairs), "{pairs}");
        }
    }

    #[test]
    fn a_plate_that_nothing_pushes_holds_still_on_whatever_it_stands() {
        assert!(still("S_y=0 C_d=0 k=1e6 x_stop=0"));
        assert!(!still("S_y=1e9 C_d=0 k=1e6 x_stop=0"));
    }
}
