//! `cmra libraries`, and its entries as options of every command that takes a scene.

use serde_json::Value;

use crate::support::{cmra, says};

fn limit_m_s(arguments: &[&str]) -> f64 {
    let arguments = [&["--json", "--set", "mount=rigid"], arguments].concat();
    let found: Value = serde_json::from_str(&says("limit", &arguments, 0).0).unwrap();
    found["limit_velocity_m_s"].as_f64().unwrap()
}

/// Borvik 2002 by 2 Y with dishing, 299.8 m/s, and the AP core on AA6082 by cavity expansion, 507 m/s: closed forms computed by
/// hand, not by this program.
#[test]
fn valid_limits_follow_from_the_names_alone() {
    let steel = ["--threat", "borvik-hemisphere", "--material", "weldox-460e", "--set", "h=12mm"];
    assert!((limit_m_s(&steel) - 299.8).abs() < 0.1, "{}", limit_m_s(&steel));
    let core = ["--threat", "m2-ap-core", "--material", "aa6082-t651", "--set", "h=20mm"];
    let ogive = [&core[..], &["--set", "closure=cavity"], &["--set", "dishing=off"]].concat();
    let ogive = [&ogive[..], &["--set", "C_d=0.212"]].concat();
    assert!((limit_m_s(&ogive) - 507.0).abs() < 1.0, "{}", limit_m_s(&ogive));
    // 20 mm are 3.2 diameters: cavity expansion is chosen without being named, with a drag coefficient of 1.
    let chosen = [&core[..], &["--set", "v_i=850"]].concat();
    let named = [&ogive[..], &["--set", "C_d=1"]].concat();
    assert_eq!(limit_m_s(&chosen).to_bits(), limit_m_s(&named).to_bits());
}

#[test]
fn set_wins_over_an_entry_and_a_flow_strength_of_ones_own_counts() {
    let found = |more: &[&str]| -> Value {
        let arguments = [&["--json", "--material", "weldox-460e"], more].concat();
        serde_json::from_str(&says("run", &arguments, 0).0).unwrap()
    };
    let variables = found(&["--set", "rho=2700", "--threat", "thesis-shot"])["variables"].clone();
    assert_eq!(variables["target.density_kg_m3"], 2700.0);
    assert_eq!(variables["target.yield_pa"], 490e6);
    assert_eq!(variables["target.closure"], "cavity");
    let given = found(&["--set", "S_y=152MPa"])["variables"].clone();
    assert_eq!(given["target.closure"], "given");
    let thin = found(&["--set", "h=3mm", "--set", "v_i=50"])["variables"].clone();
    assert_eq!(
        (&thin["target.closure"], &thin["target.dishing"]),
        (&"double-yield".into(), &true.into())
    );
}

#[test]
fn every_command_that_takes_a_scene_has_the_options() {
    for command in [
        "run",
        "sweep",
        "limit",
        "worth",
        "seek",
        "optimise",
        "sensitivity",
        "scatter",
        "accuracy",
        "stability",
    ] {
        let help = says(command, &["--help"], 0).0;
        for option in ["--threat <NAME>", "--material <NAME>", "--absorber <NAME>"] {
            assert!(help.contains(option), "{command}: {option}");
        }
    }
}

#[test]
fn an_unknown_name_gets_the_nearest_and_a_blunt_nose_a_warning() {
    let (_, error) = says("run", &["--threat", "m80bal"], 2);
    assert!(
        error.contains("`m80bal` is not one of the threats: did you mean `m80-ball`?"),
        "{error}"
    );
    let (_, error) = says("run", &["--material", "unobtainium"], 2);
    assert!(error.contains("aa6061-t6511") && error.contains("cmra libraries"), "{error}");
    let (page, error) = says("run", &["--threat", "fsp-22"], 0);
    assert!(
        page.contains("blunt chisel nose") && error.contains("no velocity: v_i = 100 m/s"),
        "{error}"
    );
    let (_, error) = says("run", &["--threat", "fsp-22", "--set", "v_i=438"], 0);
    assert!(!error.contains("velocity"), "{error}");
}

#[test]
fn the_list_names_status_and_source_also_as_json() {
    let page = says("libraries", &[], 0).0;
    for words in
        ["threats: --threat NAME", "m80-ball: 7.62 x 51 mm", "standard", "NIJ Standard 0123.00"]
    {
        assert!(page.contains(words), "{words}: {page}");
    }
    assert!(page.lines().all(|line| line.chars().count() <= 100), "{page}");
    let found: Value = serde_json::from_str(&says("libraries", &["--json"], 0).0).unwrap();
    for library in ["threats", "materials", "absorbers"] {
        for entry in found[library].as_array().unwrap() {
            let status = entry["status"].as_str().unwrap();
            assert!(["measured", "standard", "typical"].contains(&status), "{entry}");
            assert!(entry["source"].as_str().unwrap().len() > 10, "{entry}");
        }
    }
    let only: Value =
        serde_json::from_str(&says("libraries", &["absorbers", "--json"], 0).0).unwrap();
    assert!(only["threats"].is_null());
    assert_eq!(only["absorbers"][0]["values"]["mechanism.energy_j_kg"], 19460.0);
}

#[test]
fn the_scene_beside_an_export_holds_the_values_and_names_the_source() {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("out.csv");
    let file = path.to_str().unwrap();
    says("run", &["--csv", file, "--threat", "m80-ball", "--absorber", "steel-coil-1200"], 0);
    let scene = std::fs::read_to_string(place.path().join("out.toml")).unwrap();
    for words in ["mass_kg = 0.0095", "energy_j_kg = 578.3", "NIJ Standard 0123.00", "Wahl"] {
        assert!(scene.contains(words), "{words}: {scene}");
    }
    assert!(scene.contains("# again: cmra run ./out.toml --csv -"), "{scene}");
    // The warning of the bullet goes with the scene into every study of it.
    let again = place.path().join("out.toml");
    let again = again.to_str().unwrap();
    let over = ["--over", "v_i=100..200:3", "--outputs", "stroke_m"];
    let map = ["--map", "v_i=20..40:2,gamma=1..2:2"];
    let studies: [(&str, &[&str]); 5] = [
        ("run", &[]),
        ("sweep", &over),
        ("compare", &[]),
        ("compare", &map),
        ("limit", &["--monte-carlo", "0"]),
    ];
    for (command, more) in studies {
        let page = says(command, &[&[again], more].concat(), 0).0;
        assert!(page.contains("threat warning: m80-ball: lead core"), "{command}: {page}");
    }
}

#[test]
fn own_entries_are_found_and_wrong_ones_reported() {
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("cmra/library");
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(
        folder.join("materials.toml"),
        "[mine]\ntitle = \"my plate\"\nstatus = \"measured\"\nsource = \"my tensile tests\"\n\
         [mine.target]\nyield_pa = 3e8\n[bad]\ntarget.yield_pa = -1\n",
    )
    .unwrap();
    let with = |subcommand: &str, arguments: &[&str]| {
        let mut command = cmra(subcommand, arguments);
        let output = command.env("XDG_DATA_HOME", place.path()).output().unwrap();
        let text = |bytes| String::from_utf8(bytes).unwrap();
        (output.status.code(), text(output.stdout), text(output.stderr))
    };
    let (code, page, error) = with("libraries", &["materials"]);
    assert_eq!(code, Some(0));
    assert!(page.contains("mine: my plate, your own") && page.contains("weldox-460e"), "{page}");
    assert!(error.contains("not listed:") && error.contains("bad"));
    let (code, json, _) = with("run", &["--json", "--material", "mine"]);
    assert_eq!(code, Some(0));
    let found: Value = serde_json::from_str(&json).unwrap();
    assert_eq!(found["variables"]["target.yield_pa"], 3e8);
}
