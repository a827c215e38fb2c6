//! `cmra libraries`, and its entries as options of every command that takes a scene.

use serde_json::Value;

use crate::support::{cmra, says};

/// Limit of a fragment of 13.4 g and 12.6 mm on 12 mm of 6061-T651, from W and the masses in another program, m/s.
const FRAGMENT_M_S: f64 = 324.329_217;

fn limit_m_s(arguments: &[&str]) -> f64 {
    let arguments = [&["--json", "--set", "mount=rigid"], arguments].concat();
    let found: Value = serde_json::from_str(&says("limit", &arguments, 0).0).unwrap();
    found["limit_velocity_m_s"].as_f64().unwrap()
}

/// Borvik 2002 by 2 Y with dishing, 299.8 m/s, and the AP core on AA6082, 507 m/s by a spherical cavity and 500.14 m/s by a cylindrical
/// one: closed forms computed by hand and by adaptive quadrature, not by this program.
#[test]
fn valid_limits_follow_from_the_names_alone() {
    let steel = ["--threat", "borvik-hemisphere", "--material", "weldox-460e", "--set", "h=12mm"];
    assert!((limit_m_s(&steel) - 299.8).abs() < 0.1, "{}", limit_m_s(&steel));
    let core = ["--threat", "m2-ap-core", "--material", "aa6082-t651", "--set", "h=20mm"];
    let ogive = [&core[..], &["--set", "closure=cavity"], &["--set", "dishing=off"]].concat();
    let ogive = [&ogive[..], &["--set", "C_d=0.212"]].concat();
    assert!((limit_m_s(&ogive) - 507.0).abs() < 1.0, "{}", limit_m_s(&ogive));
    // The entries choose the cylindrical cavity and the ogive's drag without more.
    assert!((limit_m_s(&core) - 500.136_675).abs() < 1e-4, "{}", limit_m_s(&core));
    // 12 mm of aluminium under the .50 fragment simulating projectile are all plug.
    let fragment = ["--threat", "fsp-50", "--material", "aa6061-t651", "--set", "h=12mm"];
    assert!((limit_m_s(&fragment) - FRAGMENT_M_S).abs() < 1e-4, "{}", limit_m_s(&fragment));
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
    assert_eq!(variables["target.closure"], "by-thickness");
    let given = found(&["--set", "S_y=152MPa"])["variables"].clone();
    assert_eq!(given["target.closure"], "given");
    let thin = found(&["--set", "h=3mm", "--set", "v_i=50"])["variables"].clone();
    assert_eq!(
        (&thin["target.closure"], &thin["target.dishing"]),
        (&"by-thickness".into(), &true.into())
    );
    assert_eq!(found(&["--set", "h=3mm", "--set", "v_i=50"])["closure"], "double-yield");
    let own = found(&["--set", "h=3mm", "--set", "C_d=0.7"])["variables"].clone();
    assert_eq!(
        (&own["target.closure"], &own["target.dishing"], &own["target.drag_coefficient"]),
        (&"by-thickness".into(), &true.into(), &0.7.into())
    );
}

fn with<'s>(sets: &[&'s str]) -> Vec<&'s str> {
    let shot = ["--threat", "borvik-hemisphere", "--material", "aa6082-t651", "--set", "v_i=850"];
    shot.into_iter().chain(sets.iter().flat_map(|set| ["--set", *set])).collect()
}

/// The projectile has 20 mm: a plate of 5 mm dishes, one of 30 mm does not, also with a drag coefficient of one's own, wherever it comes
/// from.
#[test]
fn a_drag_of_ones_own_leaves_the_closure_by_thickness() {
    for (h, closure, dishing) in
        [("h=5mm", "double-yield", "dishing=on"), ("h=30mm", "cavity", "dishing=off")]
    {
        let stated = [h, &format!("closure={closure}"), dishing, "C_d=0.212"];
        let stated = limit_m_s(&with(&stated)).to_bits();
        assert_eq!(limit_m_s(&with(&[h, "C_d=0.212"])).to_bits(), stated, "{h}");
        let set_first = with(&["C_d=0.212", "closure=by-thickness", h]);
        assert_eq!(limit_m_s(&set_first).to_bits(), stated, "{h}");
        assert_ne!(limit_m_s(&with(&[h])).to_bits(), stated, "{h}");
        let axis = ["--over", "C_d=0.212,0.3", "--outputs", "limit_velocity_m_s", "--csv", "-"];
        let rigid = ["--set", "mount=rigid"];
        let swept = says("sweep", &[&with(&[h])[..], &rigid, &axis].concat(), 0).0;
        let first = swept.lines().nth(1).and_then(|row| row.split(',').nth(3)).unwrap();
        let first: f64 = first.parse().unwrap();
        assert!((first / f64::from_bits(stated) - 1.0).abs() < 1e-9, "{swept}");
    }
    let place = tempfile::tempdir().unwrap();
    // Files keep it, and a file of before, with the coefficient in effect, follows the thickness.
    let exported = place.path().join("out.csv");
    let exported = exported.to_str().unwrap();
    let scene = place.path().join("out.toml");
    let scene = scene.to_str().unwrap();
    for (sets, thin) in
        [(&["h=30mm", "C_d=0.212"][..], &["h=5mm", "C_d=0.212"][..]), (&["h=30mm"], &["h=5mm"])]
    {
        says("run", &[&with(sets)[..], &["--csv", exported, "--force"]].concat(), 0);
        let again = limit_m_s(&[scene, "--set", "h=5mm"]);
        assert_eq!(again.to_bits(), limit_m_s(&with(thin)).to_bits(), "{sets:?}");
    }
    // What is relative counts once, and a dishing of one's own says what it does to the closure.
    let sets = with(&["h=5mm", "v_i=*2", "dishing=off", "C_d=0.3"]);
    let (found, note) = says("run", &[&sets[..], &["--json"]].concat(), 0);
    let found: Value = serde_json::from_str(&found).unwrap();
    assert_eq!(found["variables"]["projectile.velocity_m_s"], 1700.0);
    assert_eq!(found["variables"]["target.closure"], "double-yield");
    assert_eq!(found["variables"]["target.dishing"], false);
    assert_eq!(found["variables"]["target.drag_coefficient"], 0.3);
    assert!(note.contains("dishing is set: closure = double-yield"), "{note}");
}

/// Samples take the closure that suits their own thickness.
#[test]
fn the_base_plate_of_a_stack_has_its_own_closure() {
    // The base plate, thicker than the elements, keeps its closure: hardly scattered, V50 is the limit.
    let stack = ["array-stacked", "--material", "aa6061-t6511", "--set", "h_base=20mm", "--json"];
    let vary = ["--vary", "h=0.001%", "--outputs", "limit_velocity_m_s", "--samples", "30"];
    let found: Value =
        serde_json::from_str(&says("montecarlo", &[&stack[..], &vary].concat(), 0).0).unwrap();
    let output = &found["outputs"][0];
    let (limit, mean) = (output["nominal"].as_f64().unwrap(), output["mean"].as_f64().unwrap());
    assert!((mean / limit - 1.0).abs() < 1e-3, "{mean} {limit}");
}

/// A value that was changed after its entry was taken is named beside what the entry says, each in its own paragraph.
#[test]
fn a_set_without_effect_or_in_the_unit_of_another_law_is_named() {
    let notes = |sets: &[&str]| {
        let sets: Vec<&str> = sets.iter().flat_map(|set| ["--set", set]).collect();
        says("run", &sets, 0).1
    };
    for (sets, note) in [
        (
            &["Y=300MPa"][..],
            "Y has no effect on this scene: it is used where closure = double-yield",
        ),
        (
            &["mount=rigid", "k=1e6"],
            "k has no effect on this scene: it is used where mount = sprung",
        ),
        (
            &["face=0.1", "mount=rigid"],
            "face changes only masses here, not the motion: it is used where mount = sprung",
        ),
        (&["e=0.5"], "e has no effect on this scene: it is used where x_stop given"),
        (&["l_beam=0.2"], "l_beam has no effect on this scene: it is used where spring = prbm"),
        (&["t_d=1e-4"], "t_d has no effect on this scene: it is used where model = half-sine"),
        (&["k=2MN/m", "n=2"], "k is in N/m^n with an exponent of 2 here; it is taken as k=2e6"),
    ] {
        let found = notes(sets);
        assert!(found.split_whitespace().collect::<Vec<_>>().join(" ").contains(note), "{found}");
    }
    for sets in [
        &["k=2MN/m"][..],
        &["tau_wire=1190MPa"],
        &["g=0.2"],
        &["k=2e6", "n=2"],
        &["closure=double-yield", "Y=80MPa"],
    ] {
        let found = notes(sets);
        assert!(!found.contains("no effect") && !found.contains("taken as"), "{found}");
    }
}

/// A variable that another one makes effective is not called ineffective where that one varies.
#[test]
fn a_set_that_takes_effect_where_another_variable_varies_is_not_named() {
    for (command, arguments) in [
        ("sweep", &["m=2", "--over", "b=0..100:2"][..]),
        ("sweep", &["e=0.5", "--over", "x_stop=1mm..5mm:2"]),
        ("sweep", &["n=2", "--set", "k=0", "--over", "k=1e4,1e5"]),
        ("seek", &["m=2", "--over", "b=1..100:3", "--goal", "stroke_m=10mm"]),
        ("optimise", &["m=2", "--over", "b=1..100", "--samples", "64"]),
        ("optimise", &["m=2", "--samples", "64"]),
        ("sensitivity", &["m=2", "--over", "b=1..100"]),
        ("sensitivity", &["m=2"]),
        ("montecarlo", &["m=2", "--vary", "b=uniform:1..100", "--samples", "2"]),
        ("compare", &["m=2", "--map", "b=1..100:2,gamma=1..2:2"]),
        ("stability", &["m=2", "--map", "b", "--quick"]),
        ("stability", &["n=2", "--set", "k=0", "--map", "k", "--quick"]),
        ("run", &["k_unload=1e7", "--compare", "models"]),
        ("run", &["d=1mm", "--set", "k=0", "--set", "b=456"]),
    ] {
        let output = cmra(command, &[&["--set"], arguments].concat()).output().unwrap();
        let found = String::from_utf8(output.stderr).unwrap();
        assert_ne!(output.status.code(), Some(2), "{command} {arguments:?}: {found}");
        assert!(!found.contains("has no effect on this scene"), "{command} {arguments:?}: {found}");
    }
    // Another variable that varies changes nothing about it.
    for (command, arguments) in [
        ("sweep", &["m=2", "--over", "gamma=1..2:2"][..]),
        ("montecarlo", &["m=2", "--vary", "gamma=uniform:1..2", "--samples", "2"]),
        ("limit", &["m=2"]),
        ("run", &["l_beam=0.2", "--compare", "models"]),
    ] {
        let found = says(command, &[&["--set"], arguments].concat(), 0).1;
        assert!(found.contains("has no effect on this scene"), "{command} {arguments:?}: {found}");
    }
}

/// A sphere of 6.2 mm and the mass of the core: plates of 3 and 5 mm dish, one of 8 mm does not, in a sweep as one by one.
#[test]
fn valid_each_plate_of_a_sweep_has_the_closure_of_its_own_thickness() {
    let set = ["--threat", "m2-ap-core", "--material", "aa6082-t651", "--set", "face=100mm"];
    let round = ["--set", "nose=hemispherical", "--set", "closure=by-thickness"];
    let set = [&set[..], &round].concat();
    let sweep = ["--over", "h=3mm,5mm,8mm", "--outputs", "limit_velocity_m_s", "--csv", "-"];
    let swept = says("sweep", &[&set[..], &sweep[..]].concat(), 0).0;
    let of_sweep: Vec<f64> = swept
        .lines()
        .skip(1)
        .map(|line| line.split(',').nth(3).unwrap().parse().unwrap())
        .collect();
    let alone: Vec<f64> = ["h=3mm", "h=5mm", "h=8mm"]
        .map(|h| {
            let one = [&set[..], &["--set", h, "--json"]].concat();
            let found: Value = serde_json::from_str(&says("limit", &one, 0).0).unwrap();
            found["limit_velocity_m_s"].as_f64().unwrap()
        })
        .to_vec();
    for (swept, alone) in of_sweep.iter().zip(&alone) {
        assert!((swept / alone - 1.0).abs() < 1e-5, "{of_sweep:?} {alone:?}");
    }
    // By 2 Y with dishing, from a separate computation: classical Runge-Kutta over the travel, and bisection of the velocity.
    for (swept, exact) in of_sweep.iter().zip([216.196_753, 254.514_089]) {
        assert!((swept / exact - 1.0).abs() < 1e-6, "{of_sweep:?}");
    }
    // What is sized for the shot does not depend on the plate it starts from.
    let efficiency = |h: &str| -> f64 {
        let one = [&set[..], &["--set", h, "--set", "v_i=350", "--json"]].concat();
        let found: Value = serde_json::from_str(&says("compare", &one, 0).0).unwrap();
        found["mass_efficiency"].as_f64().unwrap()
    };
    assert!((efficiency("h=4mm") / efficiency("h=7mm") - 1.0).abs() < 1e-6);
}

#[test]
fn every_command_that_takes_a_scene_has_the_options() {
    for command in [
        "run",
        "sweep",
        "limit",
        "compare",
        "seek",
        "optimise",
        "sensitivity",
        "montecarlo",
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
fn an_unknown_name_gets_the_nearest_and_a_lead_core_a_warning() {
    let (_, error) = says("run", &["--threat", "m80bal"], 2);
    assert!(
        error.contains("`m80bal` is not one of the threats: did you mean `m80-ball`?"),
        "{error}"
    );
    let (_, error) = says("run", &["--material", "unobtainium"], 2);
    assert!(error.contains("aa6061-t6511") && error.contains("cmra libraries"), "{error}");
    let (_, error) = says("run", &["--threat", "fsp-22"], 0);
    assert!(error.contains("no velocity: v_i = 100 m/s"), "{error}");
    for command in
        [&["design"][..], &["stability", "--map", "k", "--quick"], &["accuracy", "--quick"]]
    {
        let more = [&command[1..], &["--threat", "m80-ball", "--set", "v_i=300"]].concat();
        let page = says(command[0], &more, 0).0;
        assert!(page.contains("lead core"), "{command:?}: {page}");
        if command[0] != "design" {
            let of = |option: &[&str]| says(command[0], &[&more[..], option].concat(), 0).0;
            let found: Value = serde_json::from_str(&of(&["--json"])).unwrap();
            let object = if found.is_array() { &found[0] } else { &found };
            let warning = object["warnings"][0].as_str().unwrap();
            assert!(warning.contains("lead core"), "{warning}");
            let csv = of(&["--csv", "-"]);
            assert!(csv.lines().nth(1).unwrap().contains("lead core"), "{csv}");
        }
    }
    let (_, error) = says("run", &["--threat", "fsp-22", "--set", "v_i=438"], 0);
    assert!(!error.contains("velocity"), "{error}");
}

#[test]
fn the_list_names_status_and_source() {
    let page = says("libraries", &[], 0).0;
    for words in
        ["threats: --threat NAME", "m80-ball: 7.62 x 51 mm", "standard", "NIJ Standard 0123.00"]
    {
        assert!(page.contains(words), "{words}: {page}");
    }
    assert!(page.lines().all(|line| line.chars().count() <= 100), "{page}");
    let only = says("libraries", &["absorbers"], 0).0;
    assert!(only.starts_with("absorbers: ") && !only.contains("m80-ball"), "{only}");
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
    let studies: [(&str, &[&str]); 5] =
        [("run", &[]), ("sweep", &over), ("compare", &[]), ("compare", &map), ("limit", &[])];
    for (command, more) in studies {
        let page = says(command, &[&[again, "--verbose"], more].concat(), 0).0;
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
    let (code, _, error) = with("run", &["--material", "bad"]);
    assert_eq!((code, error.lines().count()), (Some(2), 1), "{error}");
    assert!(!error.contains('\u{fffd}') && error.contains("materials.toml:"), "{error}");
}
