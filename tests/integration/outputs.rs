//! Outputs that appear in several places: one number, one name, nothing cut, no format under another's name.

use serde_json::Value;

use crate::support::{json, says};

const README: [&str; 14] = [
    "--threat",
    "borvik-hemisphere",
    "--material",
    "aa6061-t6511",
    "--set",
    "v_i=150",
    "--set",
    "h=12mm",
    "--set",
    "face=300mm",
    "--set",
    "k=1MN/m",
    "--absorber",
    "steel-coil-1200",
];

/// Masses of the spring by both commands follow from the wire's 1200 `MPa`. The mass of `design` is for all energy after the collision; the run leaves a little of it
/// in the hole.
#[test]
fn a_spring_is_sized_alike_by_formulas_and_by_the_comparison() {
    let rows = json("design", &README);
    let rows = rows["rows"].as_array().or(rows.as_array()).unwrap();
    let spring =
        |row: &&Value| row["name"].as_str().unwrap().starts_with("least mass of the spring");
    let by_formula = rows.iter().find(spring).unwrap()["value"].as_f64().unwrap();
    let by_run = json("compare", &README)["counted_spring_mass_kg"].as_f64().unwrap();
    assert!((by_formula / by_run - 1.0).abs() < 0.01, "{by_formula} {by_run}");
}

#[test]
fn a_scene_is_named_alike_in_every_table() {
    for arguments in
        [&["--compare", "models", "--csv", "-"][..], &["--compare", "models", "--json"]]
    {
        let table = says("run", arguments, 0).0;
        assert!(table.contains("thesis-baseline"), "{table}");
        assert!(!table.contains("Baseline of chapter 9"), "{table}");
    }
}

/// A program that reads a pipe cannot ask for the rest.
#[test]
fn warnings_go_into_a_pipe_in_full() {
    let scene = ["--set", "gamma=0.05", "--set", "k=7.5e6", "--set", "d=0.5"];
    let commands: [(&str, &[&str]); 5] = [
        ("run", &[]),
        ("limit", &[]),
        ("compare", &[]),
        ("montecarlo", &["--samples", "20"]),
        ("seek", &["--over", "b=0..100:3", "--goal", "stroke_m=0.95"]),
    ];
    for (command, more) in commands {
        let arguments = [&scene[..], more].concat();
        let page = says(command, &arguments, 0).0;
        let page = page.split_whitespace().collect::<Vec<_>>().join(" ");
        let object = json(command, &arguments);
        let warnings = object["warnings"].as_array().unwrap();
        assert!(warnings.len() > 1, "{command}");
        for warning in warnings {
            assert!(page.contains(warning.as_str().unwrap()), "{command}: {warning}\n{page}");
        }
    }
}

#[test]
fn no_format_is_written_under_the_name_of_another() {
    let place = tempfile::tempdir().unwrap();
    let at = |name: &str| place.path().join(name).display().to_string();
    for (option, name, cure) in [
        ("--csv", "run.xlsx", "run.csv"),
        ("--csv", "run.JSON", "run.csv"),
        ("--csv", "run.toml", "run.csv"),
        ("--csv", "run.svg", "run.csv"),
        ("--svg", "run.png", "run.svg"),
        ("--svg", "run.csv", "run.svg"),
        ("--svg", "run.html", "run.svg"),
    ] {
        let error = says("run", &[option, &at(name)], 2).1;
        assert!(error.contains(name) && error.contains(cure), "{error}");
    }
    assert_eq!(std::fs::read_dir(place.path()).unwrap().count(), 0);
    for name in ["a.csv", "b.CSV", "c.txt", "d", "e.2"] {
        says("run", &["--csv", &at(name)], 0);
    }
}

#[test]
fn a_map_names_its_vertical_axis_once() {
    let page = says("stability", &["--map", "k", "--quick"], 0).0;
    assert_eq!(page.matches("up: k").count(), 1, "{page}");
}

#[test]
fn rows_that_texts_cite_exist() {
    let claims: Vec<&str> = cmra_studies::study::thesis::claims().map(|claim| claim.id).collect();
    let mut cited = 0;
    for it in &cmra_studies::study::validation::measurements().not_checked {
        for text in [it.says, it.why, it.source] {
            let Some((_, rows)) = text.split_once("rows ") else { continue };
            let rows = rows.split("of `cmra reproduce`").next().unwrap();
            for row in rows.split([' ', ',']).filter(|word| word.contains('-')) {
                assert!(claims.contains(&row), "{}: {row}", it.id);
                cited += 1;
            }
        }
    }
    assert!(cited >= 2);
}

/// The digits, whoever computes them.
#[test]
fn threads_change_no_digit() {
    let cases: [(&str, &[&str]); 3] = [
        ("limit", &["--set", "b=500", "--csv", "-"]),
        ("compare", &["--set", "b=500", "--csv", "-"]),
        ("stability", &["--map", "k", "--quick", "--csv", "-"]),
    ];
    for (command, arguments) in cases {
        let by = |threads| says(command, &[arguments, &["--threads", threads]].concat(), 0).0;
        assert_eq!(by("1"), by("3"), "{command}");
    }
}

/// A row of `design` whose name starts so.
fn row(scene: &str, name: &str) -> Option<f64> {
    let pairs: Vec<&str> = scene.split_whitespace().flat_map(|pair| ["--set", pair]).collect();
    let found = json("design", &pairs);
    let rows = found["rows"].as_array().or(found.as_array()).unwrap();
    rows.iter().find(|row| row["name"].as_str().unwrap().starts_with(name))?["value"].as_f64()
}

/// By hand: momentum along the normal, `m_p v cos + m_2 w_0 = (m_p cos² + m_2) w`; projectile and plate are equally heavy, 29.5 g.
#[test]
fn valid_formulas_count_all_momentum_along_the_normal() {
    for (scene, w, joined_kg) in [
        ("", 50.0, 0.059),
        ("w_0=20", 60.0, 0.059),
        ("w_0=-20", 40.0, 0.059),
        ("theta=60deg", 40.0, 1.25 * 0.0295),
        ("theta=60deg w_0=10", 48.0, 1.25 * 0.0295),
    ] {
        let common_m_s = row(scene, "common velocity").unwrap();
        assert!((common_m_s / w - 1.0).abs() < 1e-12, "{scene}: {common_m_s}");
        let energy_j = row(scene, "energy after it").unwrap();
        assert!((energy_j / (0.5 * joined_kg * w * w) - 1.0).abs() < 1e-12, "{scene}: {energy_j}");
    }
    // Equal bodies exchange their velocities.
    assert!((row("w_0=20", "projectile velocity, elastic").unwrap() - 20.0).abs() < 1e-12);
    assert!((row("w_0=20", "plate velocity, elastic").unwrap() - 100.0).abs() < 1e-12);
}

/// `k x²/2 = E + m_p g x`, solved for x. A steel coil takes 5.0817 g a joule.
#[test]
fn valid_a_spring_is_sized_by_formulas_for_the_work_of_the_weight_too() {
    let scene = "weight=on m_p=45 v_i=7.789 k=5e3 m_2=47.1 R=5cm h=6mm";
    let (w, k): (f64, f64) = (45.0 * 7.789 / 92.1, 5e3);
    let (energy_j, weight_n) = (0.5 * 92.1 * w * w, 45.0 * 9.80665);
    let x = (weight_n + (weight_n * weight_n + 2.0 * k * energy_j).sqrt()) / k;
    let mass_kg = row(scene, "least mass").unwrap();
    let expected_kg = 5.081_673_469_387_755e-3 * 0.5 * k * x * x;
    assert!((mass_kg / expected_kg - 1.0).abs() < 1e-9, "{mass_kg} {expected_kg}");
}

#[test]
fn formulas_give_a_rigid_mount_no_motion_and_no_spring() {
    for name in ["common velocity", "energy after it", "plate velocity", "least mass"] {
        assert_eq!(row("mount=rigid", name), None, "{name}");
    }
    assert!(row("mount=rigid", "critical obliquity").is_some());
}
