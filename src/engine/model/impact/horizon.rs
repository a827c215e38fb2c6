//! How long a run goes that was given no horizon.

use crate::model::impact::equations::Setup;
use crate::numerics::{larger, smaller};

/// Passages of the projectile at the closing velocity for the contact.
const PASSAGES: f64 = 50.0;
/// Oscillations of the spring with all energy in it: the first half decides over a joined body; one that slips in its hole loses energy
/// for many of them.
const OSCILLATIONS: f64 = 20.0;
const PLASTIC_OSCILLATIONS: f64 = 100.0;
/// An oscillation takes no longer than this many times the way to its end at its greatest speed.
const QUARTERS: f64 = 8.0;
/// Part of its displacement at which a plate that creeps back has arrived, and how many times its first time constant it is
/// waited for at most.
const RETURNED: f64 = 1e-14;
const DECAY_MAX: f64 = 50.0;

/// Long enough for the contact, many oscillations of the spring with all energy in it, and a plate that creeps back against its
/// damper, s.
pub(super) fn of(setup: &Setup) -> f64 {
    let passage_s = setup.geometry.exit_m / setup.closing_m_s;
    let contact_s =
        PASSAGES * setup.law.on_rigid_mount().map_or(passage_s, |(duration_s, _)| duration_s);
    if setup.still {
        return contact_s;
    }
    let spring = &setup.spring;
    let energy_j = setup.initial_j() + spring.energy(setup.start_m);
    let speed = (2.0 * energy_j / setup.plate_kg).sqrt();
    // An absorber holds the plate on one side only.
    let ways = [1.0, -1.0].map(|way| spring.reach(setup.start_m, energy_j, way));
    let far_m = ways.map(f64::abs).into_iter().filter(|way| way.is_finite()).fold(0.0, larger);
    let oscillations = if setup.plastic { PLASTIC_OSCILLATIONS } else { OSCILLATIONS };
    let rest = [oscillations * QUARTERS * far_m / speed, creeping_s(setup, far_m)];
    contact_s + rest.into_iter().filter(|part| part.is_finite()).sum::<f64>()
}

/// The time in which a plate without inertia comes back from a displacement to [`RETURNED`] of it, s: `b w^m = k x^n`. It is an
/// exponential decay for n = m and ends in a finite time for n < m; for n > m it goes on for ever, and is cut short.
fn creeping_s(setup: &Setup, far_m: f64) -> f64 {
    let damper = setup.damper;
    let Some(law) = setup.spring.power().filter(|law| !law.is_absent()) else { return 0.0 };
    if damper.is_absent() {
        return 0.0;
    }
    let speed = (law.force(far_m) / damper.coefficient).powf(1.0 / damper.exponent);
    let power = 1.0 - law.exponent / damper.exponent;
    // The integral of z^(power - 1) from RETURNED to 1.
    let decay =
        if power.abs() < 1e-6 { -RETURNED.ln() } else { (1.0 - RETURNED.powf(power)) / power };
    smaller(decay, DECAY_MAX) * far_m / speed
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::variables::scene_with;

    fn horizon_s(pairs: &str) -> f64 {
        of(&Setup::of(&scene_with(pairs), 1e-12))
    }

    /// The plate of 29.5 g on 100 kN/m oscillates in 3.4 ms; with `b/k` = 20 ms it takes 0.6 s to creep back.
    #[test]
    fn there_is_time_for_the_contact_the_oscillations_and_the_way_back() {
        let passage_s = horizon_s("mount=rigid");
        assert!(passage_s > 1e-2 && passage_s < 0.1, "{passage_s}");
        assert!(horizon_s("k=1e5") > passage_s + 20.0 * 3.4e-3);
        assert!(horizon_s("k=1e5 interface=plastic") > passage_s + 100.0 * 3.4e-3);
        assert!(horizon_s("d=0.1 b=2000 k=1e5") > 0.6);
    }
}
