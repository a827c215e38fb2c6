//! The quantities of the table that a run does not tell by itself, and how the values of a request are found.
//!
//! Masses follow from the greatest displacement, the force into the mount from the run's course, limits from shots of their own.
//! Nothing is computed that is not requested.

use std::sync::Arc;

use crate::model::mechanism::{Inertia, Mechanism};
use crate::model::results::{self, ResultColumn, Source, Studied};
use crate::model::run::Run;
use crate::model::scene::{ContactModel, Mount, Scene};
use crate::model::units::{self, Bare, Quantity};
use crate::numerics::larger;
use crate::study::compare::{self, Hardware, load, spring_energy_j};
use crate::study::context::{Context, to_its_end};
use crate::study::sweep::SweepError;
use crate::study::{limit, sweep};

/// The quantity with this name.
///
/// # Errors
/// [`SweepError::Output`] with the nearest names.
pub fn quantity(name: &str) -> Result<&'static ResultColumn, SweepError> {
    sweep::output(name)
}

/// Read a value of a quantity: SI, or with a unit (`45mm`, `20 kN`); percentages as they are shown (`60` or `60 %`).
///
/// # Errors
/// What is wrong with the text, in words.
pub fn parse_value(column: &ResultColumn, text: &str) -> Result<f64, String> {
    let quantity = match column.unit() {
        "m" => Quantity::Length,
        "s" => Quantity::Time,
        "N" => Quantity::Force,
        "m/s" => Quantity::Velocity,
        "kg" => Quantity::Mass,
        _ => Quantity::Number,
    };
    let bare = if column.unit() == "%" { text.trim().trim_end_matches('%') } else { text };
    units::parse(bare, quantity, Bare::Si).map_err(|problem| problem.to_string())
}

/// The value of a quantity for a run; `None` where it does not exist.
pub fn value(column: &ResultColumn, run: &Run) -> Option<f64> {
    let Source::Study(studied) = column.source else { return column.value(run) };
    let scene = &run.scene;
    let found = match studied {
        Studied::LeastSpringMass | Studied::SystemMass | Studied::ArealMass => {
            mass(studied, scene, run.max_plate_displacement_m)
        }
        Studied::MountForce => peak_mount_force_n(run),
        Studied::MountImpulse => load::impulse_n_s(run).filter(|_| !run.series.is_empty()),
        Studied::LimitVelocity => limit_velocity_m_s(scene),
        Studied::MassEfficiency => mass_efficiency(scene),
    };
    found.filter(|value| value.is_finite())
}

/// A mass from the greatest displacement; `None` where that is needed and not known.
pub(in crate::study) fn mass(
    studied: Studied,
    scene: &Scene,
    farthest_m: Option<f64>,
) -> Option<f64> {
    let least = || {
        spring_energy_j(scene, 0.0 - scene.plate.cocking_m, farthest_m)
            .map(|energy_j| energy_j / scene.mechanism.specific_energy_j_kg())
    };
    if studied == Studied::LeastSpringMass {
        return least();
    }
    let spring_kg = Inertia::of(scene).spring_mass_kg.or_else(least)?;
    let plate_kg = scene.plate_mass_kg();
    if studied == Studied::SystemMass {
        return Some(plate_kg + spring_kg);
    }
    let plate_kg_m2 = scene.target.density_kg_m3 * scene.target.thickness_m;
    Some(plate_kg_m2 * (1.0 + spring_kg / plate_kg))
}

/// The greatest force into the mount, from the run's course where that is needed.
fn peak_mount_force_n(run: &Run) -> Option<f64> {
    let scene = &run.scene;
    let quickly = mount_force_n(scene, run.max_plate_displacement_m);
    let course_missing = needs_course(scene) && run.series.is_empty();
    if course_missing { None } else { quickly.or_else(|| load::peak_n(run)) }
}

/// Whether the force into the mount has to be looked for in the rows of a run: other models than the simulation do not locate it.
pub(in crate::study) fn needs_course(scene: &Scene) -> bool {
    let is_simulated = scene.contact.model == ContactModel::Hydrodynamic;
    scene.plate.mount == Mount::Sprung && !is_simulated && !turn_tells_force(scene)
}

/// Whether the greatest force into the mount follows from where the plate starts and turns: without stop and damper.
pub(in crate::study) fn turn_tells_force(scene: &Scene) -> bool {
    let mechanism = Mechanism::of(scene);
    mechanism.stop.is_none() && mechanism.damper.coefficient == 0.0
}

/// The force into the mount of a spring alone, from where the plate starts and turns; `None` where that is not all.
pub(in crate::study) fn mount_force_n(scene: &Scene, farthest_m: Option<f64>) -> Option<f64> {
    let mechanism = Mechanism::of(scene);
    let is_rigid = scene.plate.mount == Mount::Rigid;
    if is_rigid || mechanism.is_absent() || !turn_tells_force(scene) {
        return None;
    }
    if load::holds_still(scene, farthest_m) {
        return None;
    }
    let (start_m, farthest_m) = (0.0 - scene.plate.cocking_m, farthest_m?);
    // A curve's greatest force may lie on the way.
    let (least, most) = mechanism.spring.curve().map_or_else(
        || (mechanism.spring.force(start_m), mechanism.spring.force(farthest_m)),
        |curve| curve.forces_between(start_m, farthest_m),
    );
    Some(larger(least.abs(), most.abs()))
}

/// The ballistic limit of a scene; `None` where there is none.
pub fn limit_velocity_m_s(scene: &Scene) -> Option<f64> {
    let mut own = scene.clone();
    own.sweep = None;
    let found = limit::alone(&Arc::new(own), &mut Context::new(1, &mut to_its_end));
    found.ok()?.velocity_m_s()
}

fn mass_efficiency(scene: &Scene) -> Option<f64> {
    let mut own = scene.clone();
    own.sweep = None;
    compare::mass_efficiency(&own, &Hardware::default())
}

/// The quantities that tell of a design, in the order of tables: what tells of the computation is left out, and limits.
pub fn usual() -> impl Iterator<Item = &'static ResultColumn> {
    const COMPUTING: [&str; 5] =
        ["energy_residual", "error_estimate", "steps", "rejected", "rhs_evaluations"];
    results::of_run().filter(|column| !COMPUTING.contains(&column.name))
}

/// Whether a run of a scene has to keep its course in time for these quantities.
pub(in crate::study) fn need_course(columns: &[&'static ResultColumn], scene: &Scene) -> bool {
    columns.iter().any(|column| match column.source {
        Source::Study(Studied::MountForce) => needs_course(scene),
        Source::Study(Studied::MountImpulse) => true,
        Source::Study(_) | Source::Scene(_) | Source::Run(_) => false,
    })
}
