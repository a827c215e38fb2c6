//! Results of a shot by formulas alone, without a simulation, as a page and a table.

use crate::report::page::{Block, Page};
use crate::report::table::Table;
use crate::study::design;
use crate::study::envelope;
use crate::study::library;
use cmra_engine::model::mechanism::{Mechanism, moving_plate_kg};
use cmra_engine::model::run::Warning;
use cmra_engine::model::scene::{Scene, Wire};
use cmra_engine::model::units::engineering;
use cmra_engine::model::variables;

/// Returns the page of a scene's results by formulas, with warnings.
pub fn page(heading: &str, found: &[Formula], warnings: Vec<Warning>) -> Page {
    let mut page = Page::new(format!("{heading}: by formulas alone"));
    page.space();
    for (name, value, unit, source) in found {
        let shown = engineering(*value, unit, 4);
        page.fact(format!("{shown:>14}  "), 16, format!("{name} ({source})"));
    }
    page.push(Block::Warnings(warnings));
    page
}

/// Returns the table of results by formulas.
pub fn table(found: &[Formula]) -> Table<'_, &Formula> {
    Table::new(found)
        .field("name", |it| it.0)
        .field("value", |it| it.1)
        .field("unit", |it| it.2)
        .field("source", |it| it.3)
}

/// Returns the warnings about a scene without a run.
pub fn warnings(scene: &Scene) -> Vec<Warning> {
    let breaches = envelope::of_scene(scene);
    let breaches = breaches.iter().map(Warning::from);
    let others = variables::range_warnings(scene).into_iter().chain(library::warnings(scene));
    breaches.chain(others).collect()
}

/// Name of a value, the value by its formula, unit, and source of the formula.
pub type Formula = (&'static str, f64, &'static str, &'static str);

/// Computes the results of a shot by formulas.
pub fn formulas(scene: &Scene, c_t: Option<f64>) -> Vec<Formula> {
    let (m, v) = (scene.projectile.mass_kg, scene.projectile.velocity_m_s);
    let (r, rho) = (scene.projectile.tip_radius_m, scene.target.density_kg_m3);
    let stone = design::stone_depth_m(m, v, r, rho, c_t.unwrap_or(1.0));
    let rod_m = design::rod_length_m(&scene.projectile);
    let critical_deg = design::critical_obliquity_deg(scene);
    let tate = "Tate, eq. 2.3; rho_p and Y_p are assumptions";
    let mut found = vec![
        ("critical obliquity", critical_deg, "deg", tate),
        ("  length of the rod", rod_m, "m", "m_p/(rho_p pi R^2)"),
        ("effective thickness", scene.effective_thickness_m(), "m", "h/cos(theta), Figure 4.1"),
    ];
    if scene.is_sprung() {
        found.extend(moving(scene));
    }
    found.push(match c_t {
        Some(_) => ("Stone's depth P", stone, "m", "eq. 2.4"),
        None => ("Stone's depth times c_t", stone, "m3/s2", "eq. 2.4; give --c-t"),
    });
    found
}

/// Computes the results for a plate that moves: collisions along its normal, and the energy that its spring takes up.
fn moving(scene: &Scene) -> Vec<Formula> {
    let (m, v, cos) =
        (scene.projectile.mass_kg, scene.projectile.velocity_m_s, scene.cos_obliquity());
    // Along the projectile's axis the plate has the velocity w cos(theta) and acts as a mass m_2/cos(theta)^2.
    let (m_2, w) = (moving_plate_kg(scene) / (cos * cos), scene.plate_velocity_m_s() * cos);
    let common = design::inelastic(m, v, m_2, w);
    let [back, forward] = design::elastic(m, v, m_2, w);
    let left = 0.5 * (m + m_2) * common * common;
    let spring = Mechanism::from_scene(scene).spring;
    let drawn = spring.energy(scene.start_m());
    let weighed =
        design::work_of_weight_j(&spring, scene.start_m(), left + drawn, scene.weight_n());
    let known_kg = scene.mechanism.min_spring_kg(weighed.map(|weighed| left + drawn + weighed));
    let integral = "the integral of its force; k d^(n+1)/(n+1) of a power law";
    let mut found = vec![
        ("common velocity, inelastic", common / cos, "m/s", "eq. 2.2 and 8.11, along the normal"),
        ("energy after it", left, "J", "kinetic energy of both bodies together"),
        ("projectile velocity, elastic", back, "m/s", "eq. 2.1 with momentum"),
        ("plate velocity, elastic", forward / cos, "m/s", "eq. 2.1 with momentum"),
        ("energy stored by cocking", drawn, "J", integral),
    ];
    if let Some(weighed) = weighed.filter(|_| scene.weight_n() > 0.0) {
        let source = "m_p g on the way to the greatest displacement";
        found.push(("work of the weight", weighed, "J", source));
    }
    found.extend(weighed.map(|weighed| {
        if let Some(known_kg) = known_kg {
            let source =
                "over e_spring, or what its wire takes up; without the spring's work in the impact";
            ("least mass of the spring for all of it", known_kg, "kg", source)
        } else {
            let all = left + drawn + weighed;
            let least_kg = all / Wire::default().specific_energy_j_kg();
            let source = "4 rho G U/tau^2, 700 MPa, section 9.5.1";
            ("least mass of a steel coil for all of it", least_kg, "kg", source)
        }
    }));
    found
}
