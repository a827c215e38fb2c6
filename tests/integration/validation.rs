//! Measurements from outside the thesis: the table is computed, and agrees with an independent computation of the same law.

use assert_cmd::Command;
use cmra::files::validation;
use cmra::model::scene::{Closure, Scene};
use cmra::model::units::Bare;
use cmra::model::variables;
use cmra::study::validation::Row;

fn row(id: &str) -> Row {
    let report = validation::report().unwrap();
    report.into_iter().find(|row| row.case.id == id).unwrap()
}

#[track_caller]
fn assert_near(value: Option<f64>, exact: f64, tolerance: f64) {
    let value = value.unwrap();
    assert!((value / exact - 1.0).abs() <= tolerance, "{value} is not {exact} to {tolerance:e}");
}

/// The field notes' table 2.3, computed there by a separate port: 299.8, 298.5, 290.5 and 290.6 m/s, 204.6 and 170.4, 507.
#[test]
fn valid_the_limits_of_the_field_notes() {
    let first = row("borvik-hemispherical");
    assert_near(first.computed, 299.8, 2e-4);
    assert_near(first.other, 298.5, 2e-4);
    assert!((first.error(first.computed.unwrap()) - 0.026).abs() < 1e-3);
    let lower = row("borvik-lower-yield");
    assert_near(lower.computed, 290.5, 2e-4);
    assert_near(lower.other, 290.6, 2e-4);
    assert_near(row("sphere-on-thin-steel").computed, 204.6, 1e-3);
    assert_near(row("sphere-lower-yield").computed, 170.4, 1e-3);
    assert_near(row("ap-core-on-aluminium").computed, 507.0, 1e-3);
}

#[test]
fn every_case_has_a_value_a_source_and_a_caution() {
    for row in validation::report().unwrap() {
        assert!(row.computed.is_some(), "{}", row.case.id);
        assert!(!row.case.source.is_empty() && !row.case.caution.is_empty(), "{}", row.case.id);
        let preset = cmra::files::preset::resolve(row.case.preset, None).unwrap();
        assert!(
            preset.comment.to_lowercase().contains("not "),
            "{}: where it is not to be used",
            row.case.preset
        );
        for (name, value) in row.case.set {
            let mut scene = preset.scene.clone();
            variables::set_by_name(&mut scene, name, value, Bare::Si).unwrap();
        }
    }
}

/// The limit of a plate without dishing: W = pi R² h/cos(theta), so the limit goes nearly with the root of 1/cos(theta) where the
/// drag is small, while the measured one goes with 1/cos(theta).
#[test]
fn valid_oblique_limits_fall_behind_the_measured_ones() {
    for (id, degrees) in
        [("ap-core-15-deg", 15f64), ("ap-core-30-deg", 30.0), ("ap-core-45-deg", 45.0)]
    {
        let (straight, slanted) = (row("ap-core-on-aluminium"), row(id));
        let secant = 1.0 / degrees.to_radians().cos();
        let ratio = slanted.computed.unwrap() / straight.computed.unwrap();
        assert!((ratio / secant.sqrt() - 1.0).abs() < 0.01, "{id}: {ratio}");
        let measured = slanted.case.measured / straight.case.measured;
        assert!((measured / secant - 1.0).abs() < 0.01, "{id}: {measured}");
        assert!(slanted.case.caution.contains("must not"), "{id}");
    }
    // The same of the bullet, by its ratios (field notes: 1.030, 1.158, 1.433).
    assert!((row("ap-bullet-30-deg").case.measured - 1.158).abs() < 1e-3);
    assert_near(row("ap-bullet-30-deg").computed, row("aa7085-30-deg").computed.unwrap(), 0.01);
}

/// 2/3 · Y · (1 + ln(2 E/3 Y)) beside A Y, with Y = 276e6 Pa, E = 68.9e9 Pa, A = 5.04; and the bulge that dishing takes up.
#[test]
fn valid_strength_and_bulge() {
    let rod = row("rod-6061-strength");
    assert_near(rod.computed, 184e6 * (1.0 + (137.8f64 / 0.828).ln()), 1e-12);
    assert_near(rod.other, 552e6, 1e-12);
    assert_near(Some(rod.case.measured), 1_391.04e6, 1e-12);
    assert_near(row("borvik-bulge").computed, 0.02, 1e-12);
    assert_eq!(row("borvik-bulge").other, None);
}

#[test]
fn the_other_closure_is_never_a_combination() {
    for case in cmra::study::validation::CASES {
        let scene = cmra::files::preset::resolve(case.preset, None).unwrap().scene;
        assert!(!(scene.target.closure == Closure::Cavity && scene.target.dishing), "{}", case.id);
    }
    // Nor is it reached by a layer of a stack.
    let layered = "format = 1\n[target]\nyield_pa = 3e8\nmodulus_pa = 7e10\n[stack]\nbase_thickness_m = 0.01\n\
                   [[stack.layer]]\ntarget.closure = \"cavity\"\n";
    let told = cmra::files::read::scene(layered, "layered").map_err(|error| error.to_string());
    assert!(told.as_ref().is_err_and(|text| text.contains("corrects twice")), "{told:?}");
}

#[test]
fn closures_give_their_strength_and_are_never_combined() {
    let mut scene = Scene::default();
    (scene.target.yield_pa, scene.target.modulus_pa) = (490e6, 200e9);
    assert!((scene.flow_strength_pa() - 1.52e8).abs() < 1.0);
    scene.target.closure = Closure::DoubleYield;
    assert!((scene.flow_strength_pa() - 980e6).abs() < 1.0);
    variables::validate(&scene).unwrap();
    scene.target.closure = Closure::Cavity;
    // 2/3 · 490 MPa · (1 + ln(2 · 200/(3 · 0.49))).
    assert!((scene.flow_strength_pa() / 2.158_026e9 - 1.0).abs() < 1e-6);
    let told = variables::validate(&scene).unwrap_err().to_string();
    for word in ["closure", "cavity", "dishing", "corrects twice", "set dishing = off"] {
        assert!(told.contains(word), "{told}");
    }
    scene.target.dishing = false;
    variables::validate(&scene).unwrap();
    scene.target.modulus_pa = 1e8;
    let told = variables::validate(&scene).unwrap_err().to_string();
    assert!(told.contains("E (target.modulus_pa)") && told.contains("greater than Y"), "{told}");
}

#[test]
fn the_command_prints_the_table_as_page_csv_and_json() {
    let cmra = |arguments: &[&str]| {
        let output = Command::cargo_bin("cmra").unwrap().args(arguments).output().unwrap();
        assert!(output.status.success());
        String::from_utf8(output.stdout).unwrap()
    };
    let page = cmra(&["validate"]);
    assert!(page.contains("299.8 m/s (+2.6 %)") && page.contains("never combined"), "{page}");
    let csv = cmra(&["validate", "--csv", "-"]);
    assert!(csv.starts_with("case,preset,quantity,unit,measured,"), "{csv}");
    // Nineteen measurements, ten that cannot be checked.
    assert_eq!(csv.lines().count(), 1 + 19 + 10);
    assert!(page.contains("yu-beam  [cannot be checked]") && page.contains("hinge"), "{page}");
    let list: serde_json::Value = serde_json::from_str(&cmra(&["validate", "--json"])).unwrap();
    assert_eq!(list[0]["case"], "borvik-hemispherical");
    assert!((list[0]["relative_error"].as_f64().unwrap() - 0.0264).abs() < 1e-3);
}
