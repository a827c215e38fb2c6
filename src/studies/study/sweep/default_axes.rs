//! Default variables of a search, with their ranges.

use crate::study::envelope::FACE_LEAST;
use crate::study::sweep::{Axis, Spacing, StudyError};
use cmra_engine::model::scene::Scene;
use cmra_engine::model::units::significant;
use cmra_engine::model::variables::{self, VARIABLES, Variable};

/// Side of the plate at the upper bound of the mass ratio, in diameters of the projectile.
const FACE_MOST: f64 = 4.0 * FACE_LEAST;

/// Returns axes over the ranges of Table 9.2, for every variable with a range and an effect within it.
///
/// The range of the mass ratio applies to the projectile of the thesis. For another projectile it is that of plates from [`FACE_LEAST`] to
/// 12 diameters wide.
pub fn thesis_axes(scene: &Scene) -> Result<Vec<Axis>, StudyError> {
    let ranges = || {
        let of = |it: &'static Variable| Some((it, it.number()?, thesis_ends(scene, it)?));
        VARIABLES.iter().filter_map(of)
    };
    // A variable can have an effect only together with others: an exponent needs a spring. The effect is checked at the upper ends.
    let mut far = scene.clone();
    for (_, number, (_, high)) in ranges() {
        (number.set)(&mut far, Some(high));
    }
    ranges()
        .filter(|(variable, ..)| {
            // A mass ratio that follows from the side of the plate is not an input.
            variables::is_used(variable, &far) && !variables::overrules_size(variable, scene)
        })
        .map(|(variable, _, ends)| Axis::new(variable.symbol, ends, 2, Spacing::Linear))
        .collect()
}

/// Returns the range of a variable in Table 9.2, that of the mass ratio as in [`thesis_axes`]; `None` if the table has none.
pub(in crate::study) fn thesis_ends(scene: &Scene, variable: &Variable) -> Option<(f64, f64)> {
    let ends = variable.thesis_range?;
    Some(if variable.symbol == "gamma" { mass_ratios(scene, ends) } else { ends })
}

fn mass_ratios(scene: &Scene, table: (f64, f64)) -> (f64, f64) {
    let (own, thesis) = (&scene.projectile, Scene::default().projectile);
    if (own.mass_kg, own.tip_radius_m) == (thesis.mass_kg, thesis.tip_radius_m) {
        return table;
    }
    let ratio = |face: f64| {
        let side_m = 2.0 * face * own.tip_radius_m;
        let kg = scene.target.density_kg_m3 * scene.target.thickness_m * side_m * side_m;
        let ratio = kg / own.mass_kg;
        significant(ratio, 3).parse().unwrap_or(ratio)
    };
    (ratio(FACE_LEAST), ratio(FACE_MOST))
}

/// These axes, or where there are none the usual ones.
pub fn or_usual(
    axes: &[Axis],
    usual: impl FnOnce() -> Result<Vec<Axis>, StudyError>,
) -> Result<Vec<Axis>, StudyError> {
    let axes = if axes.is_empty() { usual()? } else { axes.to_vec() };
    if axes.is_empty() {
        return Err(StudyError::NoUsualAxis);
    }
    Ok(axes)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::testing::scene;

    /// A ball of 9.5 g and 7.62 mm on 6 mm of steel: plates of 22.86 and 91.44 mm weigh 24.6 and 394 g.
    #[test]
    fn valid_mass_ratios_of_another_threat() {
        let gamma = |scene: &Scene| {
            let axes = thesis_axes(scene).unwrap();
            axes.iter().find(|axis| axis.symbol() == "gamma").unwrap().ends()
        };
        assert_eq!(gamma(&Scene::default()), (0.8, 7.0));
        assert_eq!(gamma(&scene("m_p=9.5g R=3.81mm h=6mm rho=7850")), (2.59, 41.5));
    }
}
