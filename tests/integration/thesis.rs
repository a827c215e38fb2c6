//! The reproduction report by its command, and what it links to.

use std::collections::HashSet;

use cmra::files::bundled::BUNDLED;
use cmra_engine::model::mechanism::Mechanism;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::variables;
use cmra_studies::study::principles::{CONCEPTS, PRINCIPLES};
use cmra_studies::study::thesis;

use crate::readme::readme;

fn cmra(arguments: &[&str]) -> (String, i32) {
    let output = crate::support::program().args(arguments).output().unwrap();
    (String::from_utf8(output.stdout).unwrap(), output.status.code().unwrap())
}

#[test]
fn presets_that_are_named_exist() {
    let claims = thesis::claims().filter_map(|claim| claim.preset);
    let principles = PRINCIPLES.iter().map(|it| it.preset);
    for name in claims.chain(principles).chain(CONCEPTS.iter().map(|it| it.preset)) {
        assert!(BUNDLED.iter().any(|preset| preset.0 == name), "{name}");
    }
}

/// Closed forms, and values of two independent integrations.
#[test]
fn valid_rows_have_the_known_numbers() {
    let (json, status) = cmra(&["reproduce", "--json"]);
    assert_eq!(status, 0);
    let rows: Vec<serde_json::Value> = serde_json::from_str(&json).unwrap();
    let text = |id: &str, column: &str| {
        let row = rows.iter().find(|row| row["id"] == id).expect(id);
        row[column].as_str().unwrap_or_default().to_owned()
    };
    for (id, column, expected) in [
        // A tenth of the strength takes the root of ten off the limit of 232.295 m/s.
        ("9.1-strength", "computed", "limit 73.46 m/s"),
        ("9.1-strength", "computed", "7.1131 mm at 1.52e8"),
        ("9.3-baseline", "computed", "7.1260 mm"),
        ("9.3-baseline", "as_printed", "7.1547 mm"),
        ("4.4.1-duration", "computed", "185.0 us"),
        ("4.4.1-duration", "computed", "1.275 ms"),
        ("A.2-coupling", "computed", "64.2"),
        ("A.2-coupling", "as_printed", "82."),
        ("9.3-torsion", "computed", "7209"),
        ("A.1-case", "computed", "38.1"),
        ("A.1-case", "as_printed", "6.8806 mm"),
        ("9.5.1-stop", "computed", "64.22 % at the first stop, 82.7"),
        // A sweep of 101 x 101 points gives 45.4 and 31.1.
        ("9.10a-mass", "computed", "45.29, 31.06"),
        ("9.5.2-reduction", "computed", "64.28, 58.8"),
    ] {
        assert!(text(id, column).contains(expected), "{id}: {}", text(id, column));
    }
    assert!(rows.iter().all(|row| row["holds"] == true) && !json.contains("NaN"));
    let names: HashSet<&str> = rows.iter().filter_map(|row| row["id"].as_str()).collect();
    assert_eq!((rows.len(), names.len()), (thesis::claims().count(), rows.len()));
    // Said in the README, too.
    let masses = "12.7 projectiles uncocked, 2166 at d = 0.5 m";
    assert!(text("9.5.1-mass", "computed").contains(masses) && readme().contains(masses));
}

/// K. E. Bisshopp and D. C. Drucker, *Quarterly of Applied Mathematics* 3 (1945) 272: the tip's displacement over the length for
/// loads `P l^2/(E I)` of 1 and 2, where a pseudo-rigid body is within 5 %.
#[test]
fn valid_the_beam_follows_the_elastic_line() {
    let scene = variables::changed(Scene::default(), "spring=prbm-cantilever").unwrap();
    let beam = scene.mechanism.spring.beam;
    let rigidity = beam.modulus_pa * beam.width_m * beam.height_m.powi(3) / 12.0;
    for (load, tip) in [(1.0, 0.30172), (2.0, 0.49346)] {
        let force_n = Mechanism::from_scene(&scene).spring.force(tip * beam.length_m);
        let own = force_n * beam.length_m * beam.length_m / rigidity;
        assert!((own / load - 1.0).abs() < 0.05, "{own} for {load}");
    }
}

#[test]
fn a_shot_beyond_the_critical_obliquity_is_warned_of() {
    let (page, status) = cmra(&["design"]);
    assert_eq!(status, 0);
    assert!(page.contains("critical obliquity") && page.contains("36."), "{page}");
    let steep = ["run", "--set", "theta=50deg", "--json"];
    let (json, _) = cmra(&steep);
    assert!(json.contains("ricochet is likely"), "{json}");
    // A stronger rod holds out longer: Tate's tangent falls with the cube root of Y_p.
    let (json, _) = cmra(&["run", "--set", "theta=30deg", "--set", "Y_p=1GPa", "--json"]);
    assert!(!json.contains("ricochet"));
    let (json, _) = cmra(&["run", "--set", "theta=30deg", "--set", "Y_p=5GPa", "--json"]);
    assert!(json.contains("ricochet"));
}
