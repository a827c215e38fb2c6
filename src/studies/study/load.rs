//! The load of the mount in a run: the greatest force, the impulse, and the energy in the springs.

use cmra_engine::model::mechanism::{Inertia, Mechanism, moving_plate_kg};
use cmra_engine::model::run::{ContactMode, EventKind, Outcome, Run, RunResult, Sample};
use cmra_engine::model::scene::{ContactModel, Scene};
use cmra_engine::numerics::larger;

/// Part of the greatest displacement at which it is reached.
const REACHED: f64 = 1e-9;
/// Part of it by which rounding may put it off.
const SAME: f64 = 4.0 * f64::EPSILON;

/// The greatest force into the mount, N.
///
/// A rigid mount takes all of the contact force along the plate's normal. The run records the maximum over all its states, way back
/// included. `None` if the run ended before the greatest displacement, or if a rigid stop was hit.
pub fn peak_n(run: &Run) -> Option<f64> {
    peak_so_far_n(run).filter(|_| run.at_least.plate_displacement_m.is_none())
}

/// Returns the peak force up to the end of a run that ended before the maximum plate displacement, N.
pub(in crate::study) fn peak_so_far_n(run: &Run) -> Option<f64> {
    if !run.end.is_complete() {
        return None;
    }
    let mechanism = Mechanism::from_scene(&run.scene);
    let hit = |kind| run.events.iter().any(|event| event.kind == kind);
    if mechanism.rigid_stop().is_some() && hit(EventKind::StopHit) {
        // It stops the plate in no time.
        return None;
    }
    if run.scene.is_sprung() && mechanism.is_absent() && mechanism.stop.is_none() {
        return None;
    }
    RunResult::PeakMountForce.value(run).filter(|force_n| force_n.is_finite())
}

/// Whether a sprung plate never leaves its place: a singular spring takes whatever comes, like a rigid mount.
pub(in crate::study) fn holds_still(scene: &Scene, max_displacement_m: Option<f64>) -> bool {
    let mechanism = Mechanism::from_scene(scene);
    scene.is_sprung()
        && !mechanism.is_absent()
        && mechanism.spring.force(scene.start_m()) == 0.0
        && max_displacement_m.is_some_and(|farthest| farthest.abs() < f64::MIN_POSITIVE)
}

/// The impulse into the mount along the plate's normal, N s: the momentum that projectile and plate had and the weight has given them, less
/// what is left when the plate has its greatest displacement, or at the end of the run where nothing stops it.
pub(in crate::study) fn impulse_n_s(run: &Run) -> Option<f64> {
    let scene = &run.scene;
    // The other models do not all keep the momentum of the projectile.
    let is_over = run.end.is_complete() && run.at_least.plate_displacement_m.is_none();
    if !is_over || scene.contact.model != ContactModel::Hydrodynamic {
        return None;
    }
    let (m_p, cos) = (scene.projectile.mass_kg, scene.cos_obliquity());
    let struck = scene.projectile.velocity_m_s;
    if !scene.is_sprung() {
        let left = match run.outcome {
            Outcome::Arrested => 0.0,
            Outcome::Perforated => run.departure.residual_velocity_m_s?,
            Outcome::Separated => run.departure.separation?.velocity_m_s,
            Outcome::Moving | Outcome::Unmeasured => return None,
        };
        return Some(m_p * cos * (struck - left));
    }
    let mechanism = Mechanism::from_scene(scene);
    // Nothing pushes the mount, or something that does so without end.
    if mechanism.is_absent() && mechanism.stop.is_none() || run.mechanism.peak_mount_n.is_none() {
        return None;
    }
    // What the mount turns with the plate moves at its cost.
    let plate_kg = moving_plate_kg(scene) - Inertia::from_scene(scene).rotation_kg;
    let plate_n_s = plate_kg * scene.plate.velocity_m_s;
    // The weight acts until the projectile has left.
    let gone_s = run.departure.exit_time_s.or_else(|| Some(run.departure.separation?.t_s));
    let given_n_s = |t_s: f64| {
        let acts_s = gone_s.filter(|gone_s| *gone_s < t_s).unwrap_or(t_s);
        m_p * cos * struck + plate_n_s + scene.weight_n() * cos * cos * acts_s
    };
    let lost = |row: &Sample| given_n_s(row.t_s) - m_p * cos * row.projectile_velocity_m_s;
    // Up to a row from which on the plate is at rest, with a projectile that is in it.
    let at_rest = |row: &Sample| {
        if row.mode == ContactMode::Fused { given_n_s(row.t_s) } else { lost(row) }
    };
    let last = run.series.last()?;
    // A weight acts without an end on a plate that slows down without an end.
    let in_the_end = || Some(at_rest(last)).filter(|_| scene.weight_n() == 0.0);
    let Some(far_m) = run.max_plate_displacement_m else {
        return if mechanism.damper.is_absent() {
            Some(lost(last) - plate_kg * last.plate_velocity_m_s)
        } else {
            in_the_end()
        };
    };
    let most_m = run.series.iter().map(|row| row.plate_displacement_m).fold(f64::MIN, larger);
    let is_there = |row: &&Sample| most_m - row.plate_displacement_m <= SAME * far_m.abs();
    match run.max_displacement_time_s() {
        // Thrown back, the plate has loaded nothing yet.
        Some(0.0) if scene.plate.velocity_m_s < 0.0 => Some(0.0),
        // On a stop it may stay, or be there again and again: the last time counts.
        Some(_) if far_m - most_m <= REACHED * far_m.abs() => {
            run.series.iter().rfind(is_there).map(at_rest)
        }
        Some(_) => None,
        None => Some(last).filter(is_there).and_then(|_| in_the_end()),
    }
}

/// Returns the mass of a plate and springs of this mass over the face of the plate, kg/m².
pub(in crate::study) fn areal_kg_m2_with(scene: &Scene, spring_kg: f64) -> f64 {
    let plate_kg_m2 = scene.target.density_kg_m3 * scene.target.thickness_m;
    plate_kg_m2 * (1.0 + spring_kg / scene.plate_mass_kg())
}

/// Greatest energy in the springs between the extreme displacements of the plate, J.
pub(in crate::study) fn spring_energy_j(scene: &Scene, ends_m: Option<[f64; 2]>) -> Option<f64> {
    let spring = Mechanism::from_scene(scene).spring;
    if !scene.is_sprung() || spring.is_absent() {
        return Some(0.0);
    }
    let [from_m, to_m] = ends_m?;
    Some(spring.greatest_energy(from_m, to_m))
}
