//! Convergence of one scene: steps, error and energy residual of the automatic method at several tolerances, and the stiffness ratio of the
//! mount.

use std::sync::Arc;

use crate::study::accuracy::reference::ReferenceSource;
use crate::study::context::Context;
use crate::study::stability::{error_of, reference_of};
use cmra_engine::model::mechanism::Mechanism;
use cmra_engine::model::mechanism::inertia::moving_plate_kg;
use cmra_engine::model::run::Run;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::simulate::{Settings, simulate};
use cmra_engine::model::variables::{self, VariableError};
use cmra_engine::numerics::larger;

/// Tolerances of the runs, loosest first.
pub const TOLERANCES: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];

/// Runs of one scene at several tolerances.
#[derive(Clone, Debug)]
pub struct SceneStability {
    /// Ratio of the contact time to the shortest time scale of spring and damper at first arrest; `None` without a mount or an arrest.
    pub stiffness_ratio: Option<f64>,
    /// Source of the reference; `None` if no reference run finished.
    pub basis: Option<ReferenceSource>,
    /// Runs, loosest tolerance first.
    pub rows: Vec<ToleranceRow>,
}

/// Run at a tolerance.
#[derive(Clone, Debug)]
pub struct ToleranceRow {
    /// Run with the automatic method; the tolerance is in its scene.
    pub run: Run,
    /// Largest relative error of all results; NaN if the outcome differs from that of the reference, `None` without a reference.
    pub error: Option<f64>,
}

/// Runs a scene at each of [`TOLERANCES`] and compares it with a reference by another family of methods; without one, by the engine at
/// 1e-13.
///
/// # Errors
/// A [`VariableError`] if the scene is physically impossible.
pub fn run(
    scene: &Scene,
    context: &mut Context<'_, SceneStability>,
) -> Result<SceneStability, VariableError> {
    variables::validate(scene)?;
    let stop = context.stop();
    context.expect(TOLERANCES.len());
    let mut reference = None;
    let mut found = SceneStability { stiffness_ratio: None, basis: None, rows: Vec::new() };
    for tolerance in TOLERANCES {
        if !context.show(&found) {
            break;
        }
        let mut own = scene.clone();
        own.run.tolerance = tolerance;
        let run = simulate(
            &Arc::new(own),
            &Settings { series: false, ..Settings::default() },
            &mut |_| stop.flow(),
        )?;
        if stop.is_set() {
            break;
        }
        context.count(1);
        let reference = reference.get_or_insert_with(|| reference_of(&run, &stop));
        let error = reference.and_then(|reference| error_of(&run, &reference));
        found.basis = reference.map(|it| it.basis);
        found.stiffness_ratio = stiffness_ratio(&run);
        found.rows.push(ToleranceRow { run, error });
    }
    context.show(&found);
    Ok(found)
}

/// Returns the ratio of the contact time to the shortest time scale of the mount at first arrest: `sqrt(m_2 / k_t)` of the spring's tangent,
/// `m_2 / b_t` of the damper's.
fn stiffness_ratio(run: &Run) -> Option<f64> {
    let arrest = run.first_arrest.filter(|_| run.scene.is_sprung())?;
    let Mechanism { spring, damper, .. } = Mechanism::from_scene(&run.scene);
    let plate_kg = moving_plate_kg(&run.scene);
    let by_spring = (spring.tangent(arrest.plate_displacement_m).abs() / plate_kg).sqrt();
    let by_damper = damper.tangent(arrest.plate_velocity_m_s) / plate_kg;
    Some(arrest.t_s * larger(by_spring, by_damper))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::changed_free_plate;
    use crate::study::context::never_cancel;

    fn found(pairs: &str) -> SceneStability {
        let scene = changed_free_plate(pairs).unwrap();
        run(&scene, &mut Context::new(1, &mut never_cancel)).unwrap()
    }

    /// `t sqrt(k / m_2)` and `t b / m_2` of the reference scenes S2 and S7 ([`cmra_engine::model::reference`]).
    #[test]
    fn valid_the_stiffness_of_a_spring_and_of_a_damper() {
        let spring = found("k=1e5").stiffness_ratio.unwrap();
        assert!((spring / (1.135_971_728_972e-4 * (1e5f64 / 0.0295).sqrt()) - 1.0).abs() < 1e-8);
        let damper = found("b=1000").stiffness_ratio.unwrap();
        assert!((damper / (1.595_948_209_478e-4 * 1e3 / 0.0295) - 1.0).abs() < 1e-8);
        assert_eq!(found("k=0 mount=rigid").stiffness_ratio, None);
    }

    #[test]
    fn errors_are_within_tolerances_and_known_for_each() {
        for pairs in ["k=1e5", "k=1e6 n=0.5", "k=7.5e6 interface=plastic", "model=half-sine k=1e5"]
        {
            let found = found(pairs);
            for (row, tolerance) in found.rows.iter().zip(TOLERANCES) {
                assert!(
                    row.error.unwrap() < larger(10.0 * tolerance, 1e-10),
                    "{pairs} {tolerance}"
                );
                assert!(row.run.estimate.main.is_some() && row.run.cost.steps > 0, "{pairs}");
            }
            assert_eq!(found.rows.len(), TOLERANCES.len());
        }
    }
}
