//! `cmra run --compare`, and models set by name.

fn cmra(arguments: &[&str]) -> (String, i32) {
    let output = crate::support::program().args(arguments).output().unwrap();
    let text =
        String::from_utf8(output.stdout).unwrap() + &String::from_utf8(output.stderr).unwrap();
    (text, output.status.code().unwrap())
}

#[test]
fn the_models_stand_in_one_table_and_as_rows() {
    let (page, status) = cmra(&["run", "--compare", "models"]);
    assert_eq!(status, 0);
    for name in ["hydrodynamic", "lumped", "half-sine", "initial-velocity", "appendix", "finite"] {
        assert!(page.lines().any(|line| line.starts_with(name)), "{name}: {page}");
    }
    assert!(page.lines().all(|line| line.chars().count() <= 100), "{page}");
    let (json, status) = cmra(&["run", "--compare", "models", "--json"]);
    assert_eq!(status, 0);
    let rows: Vec<serde_json::Value> = serde_json::from_str(&json).unwrap();
    assert_eq!(rows.len(), 5);
    // The printed coupling: 82.4 instead of 64.4 % of the depth on a rigid mount.
    let row = |name: &str| rows.iter().find(|row| row["run"] == name).unwrap();
    let depth = |name: &str| row(name)["final_penetration_m"].as_f64().unwrap();
    assert!((depth("appendix") / depth("hydrodynamic") - 1.28).abs() < 0.01, "{json}");
    let at_once = row("initial-velocity");
    assert!(at_once["final_penetration_m"].is_null() && at_once["peak_contact_force_n"].is_null());
    let (csv, _) = cmra(&["run", "--compare", "models", "--csv", "-"]);
    assert_eq!(csv.lines().count(), 6);
    assert!(csv.starts_with("run,scene,outcome,"));
}

#[test]
fn who_cannot_run_a_spring_says_so_and_the_others_stand() {
    let (page, status) = cmra(&["run", "concept-helical-spring", "--compare", "models"]);
    assert_eq!(status, 0, "{page}");
    for line in [
        "hydrodynamic",
        "lumped  ",
        "half-sine  ",
        "initial-velocity  ",
        "not run: appendix: model",
    ] {
        assert!(page.lines().any(|own| own.starts_with(line)), "{line}: {page}");
    }
    let (text, status) = cmra(&["run", "--set", "closure=cavity", "--compare", "models"]);
    assert_eq!(status, 2);
    assert!(text.contains("corrects twice"), "{text}");
}

#[test]
fn a_model_is_set_by_name_and_unknown_names_are_refused() {
    let (json, status) = cmra(&["run", "--set", "model=half-sine", "--set", "t_d=150us", "--json"]);
    assert_eq!(status, 0);
    let run: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!(run["model"], "half-sine");
    // m_p v pi/(2 t_d)
    let peak = run["peak_contact_force_n"].as_f64().unwrap();
    assert!((peak / 30_892.328 - 1.0).abs() < 1e-6, "{peak}");
    let (text, status) = cmra(&["run", "--set", "model=magic"]);
    assert_eq!(status, 2);
    assert!(text.contains("hydrodynamic, half-sine, initial-velocity"), "{text}");
    let (text, status) = cmra(&["run", "--set", "t_d=0"]);
    assert_eq!(status, 2);
    assert!(text.contains("t_d (contact.duration_s) = 0 s is impossible"), "{text}");
    let stiff =
        ["run", "--set", "model=lumped", "--set", "k_load=2MN/m", "--set", "k_unload=1MN/m"];
    let (text, status) = cmra(&stiff);
    assert_eq!(status, 2);
    assert!(text.contains("k_unload") && text.contains("must be 2e6 N/m or more"), "{text}");
    let (text, status) = cmra(&["accuracy", "--quick", "--set", "model=appendix"]);
    assert_eq!(status, 2);
    assert!(text.contains("set model = hydrodynamic"), "{text}");
}

/// The loading stiffness that `auto` takes is as little above the unloading one as a given one, at each point of a sweep and in each draw.
#[test]
fn a_lumped_interface_never_gives_back_more_than_it_took() {
    let lumped = ["--set", "model=lumped", "--set", "k_unload=1e3"];
    for (command, more) in [
        ("run", &[][..]),
        ("run", &["--set", "mount=rigid"]),
        ("sweep", &["--over", "gamma=1..2:2"]),
        ("montecarlo", &["--samples", "2", "--vary", "gamma=uniform:1..2"]),
        ("optimise", &["--samples", "64", "--over", "gamma=1..2"]),
    ] {
        let (text, status) = cmra(&[&[command], &lumped[..], more].concat());
        assert_eq!(status, 2, "{command} {more:?}: {text}");
        let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(words.contains("is below k_load = auto = 2.59"), "{words}");
        assert!(words.contains("give back more than it took"), "{words}");
    }
    // m_p (v_i/q)^2, q = 1.5 times the depth of 7.113055 mm on a rigid mount: 2.5914 MN/m.
    for (unload, status) in [("2.591e6", 2), ("2.592e6", 0)] {
        let unload = format!("k_unload={unload}");
        assert_eq!(cmra(&["run", "--set", "model=lumped", "--set", &unload]).1, status, "{unload}");
    }
}

/// A model without a rear face reports no shot as stopped, and no limit.
#[test]
fn a_model_that_cannot_perforate_stops_nothing() {
    for model in ["half-sine", "initial-velocity", "lumped"] {
        let model = format!("model={model}");
        let shot = ["--set", &model, "--set", "h=1mm", "--set", "v_i=400"];
        let (page, _) = cmra(&[&["run"], &shot[..]].concat());
        assert!(page.contains("cannot perforate") && !page.contains("is stopped"), "{page}");
        let (page, _) = cmra(&[&["limit"], &shot[..]].concat());
        assert!(page.contains("cannot perforate") && !page.contains("3000 m/s"), "{page}");
    }
}

/// The listing of Appendix A has no stop, and its row goes through the one of the scene.
#[test]
fn a_model_without_the_stop_of_the_scene_says_so() {
    let stopped = ["run", "--set", "x_stop=5mm", "--compare", "models"];
    let (page, _) = cmra(&stopped);
    let words = page.split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(words.matches("the stop is ignored").count(), 1, "{page}");
    assert!(!cmra(&["run", "--compare", "models"]).0.contains("ignored"));
    let (text, _) = cmra(&[&stopped[..], &["--json"]].concat());
    let rows: serde_json::Value = serde_json::from_str(&text).unwrap();
    let ignores = |row: &&serde_json::Value| {
        row["warnings"].as_str().unwrap().contains("the stop is ignored")
    };
    let who: Vec<_> =
        rows.as_array().unwrap().iter().filter(ignores).map(|row| &row["run"]).collect();
    assert_eq!(who, ["appendix"], "{text}");
}
