//! What designs are judged by: every result of a run, and what a mechanism weighs and puts into its mount.

use crate::model::mechanism::Mechanism;
use crate::model::results::{self, RESULTS, ResultColumn};
use crate::model::scene::{Mount, Scene};
use crate::model::units::{self, Bare, Quantity};
use crate::numerics::larger;
use crate::study::compare::{load, spring_energy_j};
use crate::study::sweep::{self, SweepError};

/// The greatest displacement, on which the masses and, without a damper, the force into the mount depend.
pub(super) const FARTHEST: &str = "max_plate_displacement_m";
/// The force into a rigid mount comes from this.
pub(super) const CONTACT_FORCE: &str = "peak_contact_force_n";

/// What runs do not tell by themselves.
#[rustfmt::skip]
pub static DESIGN_MEASURES: [ResultColumn; 4] = [
    ResultColumn { name: "plate_mass_kg", meaning: "mass of the plate: gamma times that of the projectile", get: |run| Some(run.scene.plate_mass_kg()) },
    ResultColumn { name: "least_spring_mass_kg", meaning: "least mass of a helical steel spring for the greatest energy stored", get: |run| spring_kg(&run.scene, run.max_plate_displacement_m) },
    ResultColumn { name: "system_mass_kg", meaning: "plate and least spring together", get: |run| system_kg(&run.scene, run.max_plate_displacement_m) },
    ResultColumn { name: "peak_mount_force_n", meaning: "greatest force into the mount: spring, damper and elastic stop", get: load::peak_n },
];

/// How a measure is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Way {
    /// A result of the evaluation, by its place there.
    Result(usize),
    /// From the scene alone, or with its greatest displacement.
    Masses,
    /// From the greatest displacement, the contact force of a rigid mount, or a run with its series.
    MountForce,
}

/// The measure with this name: a key of `cmra run --json`, or one of [`DESIGN_MEASURES`].
///
/// # Errors
/// [`SweepError::Output`] with the nearest names.
pub fn measure(name: &str) -> Result<&'static ResultColumn, SweepError> {
    let own = DESIGN_MEASURES.iter().find(|column| column.name == name.trim());
    own.or_else(|| results::find(name.trim())).ok_or_else(|| sweep::no_output(name, &own_names()))
}

/// Read a value of a measure: SI, or with a unit (`45mm`, `20 kN`); percentages as they are shown (`60` or `60 %`).
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

/// Every measure.
pub fn all() -> impl Iterator<Item = &'static ResultColumn> {
    RESULTS.iter().chain(&DESIGN_MEASURES)
}

fn own_names() -> Vec<&'static str> {
    DESIGN_MEASURES.iter().map(|column| column.name).collect()
}

/// The spring's least mass, kg; `None` where its energy is not known.
fn spring_kg(scene: &Scene, farthest_m: Option<f64>) -> Option<f64> {
    spring_energy_j(scene, 0.0 - scene.plate.cocking_m, farthest_m)
        .map(|energy| energy / scene.mechanism.specific_energy_j_kg())
}

fn system_kg(scene: &Scene, farthest_m: Option<f64>) -> Option<f64> {
    Some(scene.plate_mass_kg() + spring_kg(scene, farthest_m)?)
}

/// A mass of a design.
pub(super) fn mass_kg(name: &str, scene: &Scene, farthest_m: Option<f64>) -> Option<f64> {
    match name {
        "plate_mass_kg" => Some(scene.plate_mass_kg()),
        "least_spring_mass_kg" => spring_kg(scene, farthest_m),
        _ => system_kg(scene, farthest_m),
    }
}

/// Whether the force into the mount has to be looked for along the whole course of a run.
pub(super) fn needs_course(scene: &Scene) -> bool {
    let mechanism = Mechanism::of(scene);
    let sprung = scene.plate.mount == Mount::Sprung;
    sprung && (mechanism.stop.is_some() || mechanism.damper.coefficient > 0.0)
}

/// The force into the mount where no series is needed for it.
pub(super) fn mount_force_n(
    scene: &Scene,
    farthest_m: Option<f64>,
    contact_n: Option<f64>,
) -> Option<f64> {
    if scene.plate.mount == Mount::Rigid {
        return Some(contact_n? * scene.cos_obliquity());
    }
    let mechanism = Mechanism::of(scene);
    if mechanism.is_absent() {
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
