//! Rules between the values of the springs.

use super::VariableError;
use crate::model::mechanism::{curve_of, power_law_of};
use crate::model::scene::{self, Combination, ContactModel, Mount, OwnMass, Scene, SpringKind};
use crate::model::units;

/// Most points of a table: a measurement has fewer, and each is an event of the run.
const POINTS_MAX: usize = 2_000;

/// Whether there is a spring at all.
pub(super) fn acts(mechanism: &scene::Mechanism) -> bool {
    mechanism.combination != Combination::Alone
        || power_law_of(&mechanism.spring).is_none_or(|law| !law.is_absent())
}

/// The rules between the values of the springs, and between them and the rest of the scene.
pub(super) fn check(scene: &Scene) -> Result<(), VariableError> {
    if scene.plate.mount == Mount::Rigid {
        return Ok(());
    }
    let mechanism = &scene.mechanism;
    check_one(&mechanism.spring, "mechanism.spring")?;
    if mechanism.combination != Combination::Alone {
        check_one(&mechanism.second, "mechanism.second")?;
    }
    if mechanism.combination == Combination::Series {
        check_rising(&mechanism.spring, "mechanism.spring")?;
        check_rising(&mechanism.second, "mechanism.second")?;
    }
    check_model(scene)
}

/// A refusal of values that make no sense together.
fn refuse(text: String) -> Result<(), VariableError> {
    Err(VariableError(text))
}

fn check_one(spring: &scene::Spring, table: &str) -> Result<(), VariableError> {
    match spring.kind {
        SpringKind::Bistable => {
            let (second, unstable) = (spring.bistable.second_m, spring.bistable.unstable_m);
            match unstable {
                Some(unstable) if unstable >= second => refuse(format!(
                    "x_u ({table}.bistable.unstable_m) = {} m does not lie between the stable positions 0 and x_2 = {} m: it \
                     must be less than x_2; reduce it, or write `midway`",
                    units::shortest(unstable),
                    units::shortest(second)
                )),
                _ => Ok(()),
            }
        }
        SpringKind::Crush => check_stroke(&spring.crush, table),
        SpringKind::Table => check_points(&spring.table.points, table),
        _ => Ok(()),
    }
}

/// An absorber begins to be crushed before it is flat.
fn check_stroke(crush: &scene::Crush, table: &str) -> Result<(), VariableError> {
    if crush.stroke_m > crush.rise_m() {
        return Ok(());
    }
    refuse(format!(
        "x_crush ({table}.crush.stroke_m) = {} m does not exceed F_crush/k_crush = {} m, where it begins to be crushed: it must be \
         more; raise x_crush or k_crush",
        units::shortest(crush.stroke_m),
        units::shortest(crush.rise_m())
    ))
}

/// A table's rules: enough points, finite, and rising in x.
fn check_points(points: &[[f64; 2]], table: &str) -> Result<(), VariableError> {
    let count = points.len();
    if !(2..=POINTS_MAX).contains(&count) {
        return refuse(format!(
            "{table}.table has {count} points: it must have 2 to {POINTS_MAX}; write points = [[x, F], ...] in m and N, or \
             file = \"curve.csv\""
        ));
    }
    if let Some(at) = points.iter().position(|point| !point.iter().all(|value| value.is_finite())) {
        return refuse(format!(
            "{table}.table: point {} is not finite: every x (m) and F (N) must be a number; remove the point",
            at + 1
        ));
    }
    if let Some(at) = points.windows(2).position(|pair| pair[1][0] <= pair[0][0]) {
        return refuse(format!(
            "{table}.table: x = {} m of point {} does not exceed x = {} m of the point before it: a table must rise in x; sort \
             the points and leave only one at each x",
            units::shortest(points[at + 1][0]),
            at + 2,
            units::shortest(points[at][0])
        ));
    }
    Ok(())
}

/// In series each force must belong to one displacement.
fn check_rising(spring: &scene::Spring, table: &str) -> Result<(), VariableError> {
    if curve_of(spring).is_rising() {
        return Ok(());
    }
    refuse(format!(
        "combine (mechanism.combination) = series needs a force that rises everywhere, and that of {table} (kind = {}) does \
         not: take another kind or a coefficient above 0, or combine = parallel",
        spring.kind.word()
    ))
}

fn check_model(scene: &Scene) -> Result<(), VariableError> {
    let mechanism = &scene.mechanism;
    if scene.contact.model != ContactModel::Appendix || mechanism.is_plain() {
        return Ok(());
    }
    refuse(format!(
        "model (contact.model) = appendix needs a power law, and {} is not one: set model = hydrodynamic, or spring = power-law, \
         combine = alone, own_mass = ignored",
        described(mechanism)
    ))
}

/// The mechanism in a few words, for refusals.
fn described(mechanism: &scene::Mechanism) -> String {
    let kind = mechanism.spring.kind.word();
    let own = if mechanism.spring.own_mass == OwnMass::Counted { " with its own mass" } else { "" };
    match mechanism.combination {
        Combination::Alone => format!("spring (mechanism.spring.kind) = {kind}{own}"),
        Combination::Parallel => {
            format!("{kind} in parallel with {}", mechanism.second.kind.word())
        }
        Combination::Series => format!("{kind} in series with {}", mechanism.second.kind.word()),
    }
}

/// For the stability map, whose axes are the thesis's own mechanism's.
///
/// # Errors
/// [`VariableError`] when the scene has another one.
pub fn require_plain(scene: &Scene) -> Result<(), VariableError> {
    if scene.plate.mount == Mount::Rigid || scene.mechanism.is_plain() {
        return Ok(());
    }
    refuse(format!(
        "{} is not for the stability map, which varies k, n or b of the thesis's spring k |x|^n and damper: set spring = \
         power-law, combine = alone, own_mass = ignored, N_spring = 1",
        described(&scene.mechanism)
    ))
}
