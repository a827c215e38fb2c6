//! `cmra worth` as a user meets it.

use serde_json::Value;

use crate::support::{cmra, says};

fn output(arguments: &[&str]) -> String {
    says("worth", arguments, 0).0
}

#[test]
fn valid_numbers_of_the_model_page_stand_side_by_side() {
    let found: Value = serde_json::from_str(&output(&["--json"])).unwrap();
    let number = |candidate: &str, key: &str| found["candidates"][candidate][key].as_f64().unwrap();
    for (candidate, depth, limit) in [
        ("rigid_mount", 7.113_055e-3, 232.295_378),
        ("free_plate", 4.568_088_344_392e-3, 347.708_052),
    ] {
        assert!((number(candidate, "penetration_m") - depth).abs() < 5e-10);
        assert!((number(candidate, "limit_velocity_m_s") - limit).abs() < 5e-7);
    }
    // The solid plate's thickness is that of all the mass over the plate's face.
    let mass = 0.0295 + found["spring_mass_kg"].as_f64().unwrap();
    let thickness = mass / 0.0295 * 0.0254;
    assert!((number("solid_plate", "thickness_m") / thickness - 1.0).abs() < 1e-12);
    assert!(found["candidates"]["free_plate"]["stroke_m"].is_null());
    assert!(found["candidates"]["free_plate"]["peak_mount_force_n"].is_null());
}

#[test]
fn the_page_answers_both_requirements_and_says_how_mass_was_taken() {
    let page = output(&["--spring-mass", "2g", "--mount-mass", "0.001"]);
    for words in [
        "less penetration than a solid plate of equal mass: met",
        "as good as a heavier solid plate: met",
        "merely free plate",
        "spring: 2.00 g as given",
        "mount: 1.00 g",
    ] {
        assert!(page.contains(words), "{words}: {page}");
    }
    // With the spring's own mass the same scene does not pay.
    assert!(output(&[]).contains("as good as a heavier solid plate: not met"));
}

/// In the words of `cmra limit`: they are its limits.
#[test]
fn oblique_limits_come_with_a_caution() {
    let oblique = ["--set", "theta=30deg"];
    let limit = says("limit", &["--json", "--scatter", "0", oblique[0], oblique[1]], 0).0;
    let limit: Value = serde_json::from_str(&limit).unwrap();
    let caution = limit["caution"].as_str().unwrap();
    assert!(output(&oblique).contains(&format!("caution: {caution}")), "{}", output(&oblique));
    let found: Value = serde_json::from_str(&output(&["--json", oblique[0], oblique[1]])).unwrap();
    assert_eq!(found["caution"].as_str(), Some(caution));
    assert!(!output(&[]).contains("caution"));
    let straight: Value = serde_json::from_str(&output(&["--json"])).unwrap();
    assert!(straight["caution"].is_null());
}

#[test]
fn candidates_are_rows_and_bad_masses_are_refused() {
    let table = output(&["--csv", "-", "--set", "v_i=400"]);
    let lines: Vec<&str> = table.lines().collect();
    assert!(lines[0].starts_with("scene,candidate,outcome,thickness_m,areal_mass_kg_m2,"));
    let words: Vec<&str> = lines[1..].iter().filter_map(|line| line.split(',').nth(1)).collect();
    assert_eq!(words, ["scene", "rigid mount", "free plate", "solid plate"]);
    // Perforated: no depth.
    assert_eq!(lines[2].split(',').nth(5), Some(""));
    for (option, value, told) in
        [("--mount-mass", "-1g", "0 kg or more"), ("--spring-mass", "2mm", "--spring-mass 2mm")]
    {
        let refused = cmra("worth", &[option, value]).assert().code(2);
        let text = String::from_utf8(refused.get_output().stderr.clone()).unwrap();
        assert!(text.contains(told), "{text}");
    }
}
