//! `cmra seek` as a user meets it.

use serde_json::Value;

use crate::support::says;

/// The free plate: 4.568088344392 mm at gamma = 1.
#[test]
fn the_mass_ratio_of_a_known_depth_is_found_and_runs_to_it() {
    let goal = "final_penetration_m=4.568088344392mm";
    let arguments = ["free-plate", "--over", "gamma=0.8..7", "--goal", goal, "--json"];
    let answer: Value = serde_json::from_str(&says("seek", &arguments, 0).0).unwrap();
    let gamma = answer["solutions"][0]["at"].as_f64().unwrap();
    assert!((gamma - 1.0).abs() < 1e-9, "{gamma}");
    assert_eq!(answer["solutions"].as_array().unwrap().len(), 1);
    assert_eq!(answer["complete"], true);
    let set = format!("gamma={gamma}");
    let (run, _) = says("run", &["free-plate", "--set", &set, "--json"], 0);
    let run: Value = serde_json::from_str(&run).unwrap();
    let depth = run["final_penetration_m"].as_f64().unwrap();
    assert!((depth - 4.568_088_344_392e-3).abs() < 1e-12, "{depth}");
}

/// A fused interface holds at any depth: 50 % are reached at d = 97.9977 mm, where a real interface would be torn (by classical
/// Runge-Kutta in steps of 0.2 us, bisected).
#[test]
fn a_solution_that_no_interface_holds_has_the_plastic_answer_beside_it() {
    let goal = ["--over", "d=0..0.5", "--goal", "percent_of_baseline=50"];
    let (page, _) = says("seek", &goal, 0);
    let line = page.lines().find(|line| line.contains("d = 97.9977 mm: 50 %")).unwrap();
    assert!(line.contains("; plastic: ") && page.contains("`--set d=0.0979"), "{page}");
    let (json, _) = says("seek", &[&goal[..], &["--json"]].concat(), 0);
    let found: Value = serde_json::from_str(&json).unwrap();
    assert_eq!(found["interface"], "fused");
    assert!(found["solutions"][0]["plastic"].as_str().unwrap().starts_with("plastic: "), "{json}");
    let (page, _) = says("seek", &[&goal[..], &["--set", "interface=plastic"]].concat(), 1);
    assert!(page.contains("nothing reaches 50 %"), "{page}");
}

/// The plate has turned although the projectile may still move in it: its stroke is final, the depth is not.
#[test]
fn a_final_quantity_of_an_undecided_run_is_a_value() {
    let goal = ["--over", "h=26mm..60mm", "--goal", "stroke_m=38.382mm", "--json"];
    let undecided = ["--set", "interface=plastic", "--set", "run.horizon_s=5ms"];
    let goal = [&goal[..], &undecided].concat();
    let found: Value = serde_json::from_str(&says("seek", &goal, 0).0).unwrap();
    let solution = &found["solutions"][0];
    assert_eq!((&solution["outcome"], &found["interface"]), (&"moving".into(), &"plastic".into()));
    let set = format!("h={}", solution["at"]);
    let run = [&["--set", &set, "--json"], &undecided[..]].concat();
    let run: Value = serde_json::from_str(&says("run", &run, 0).0).unwrap();
    assert!((run["stroke_m"].as_f64().unwrap() - 0.038_382).abs() < 1e-9, "{run}");
    let bounds = run["lower_bounds"].as_array().unwrap();
    assert!(bounds.contains(&"final_penetration_m".into()) && !bounds.contains(&"stroke_m".into()));
}

/// Uncocked, the plate's common energy goes into the spring: `m_p` v²/2 is 147.5 J, of which it keeps 1/(1 + gamma).
#[test]
fn a_goal_has_the_units_of_its_quantity() {
    let over = ["--over", "gamma=0.5..7", "--json", "--goal"];
    let found = |goal: &str| -> Value {
        serde_json::from_str(&says("seek", &[&over[..], &[goal]].concat(), 0).0).unwrap()
    };
    let kilojoule = found("stored_energy_j=0.059kJ");
    assert_eq!(kilojoule["solutions"], found("stored_energy_j=59")["solutions"]);
    let gamma = kilojoule["solutions"][0]["at"].as_f64().unwrap();
    assert!((gamma - 1.5).abs() < 0.01, "{kilojoule}");
    let comma = ["--over", "gamma=0.8..7", "--goal", "stroke_m=12,5mm"];
    let (_, error) = says("seek", &comma, 2);
    assert!(error.contains("write `12.5mm`"), "{error}");
}

/// The scene's 25.4 mm are 3.26 D of the bullet, the ends of the range 0.64 and 7.7 D; one face is held. None of them is the answer.
#[test]
fn warnings_are_those_of_the_solutions_alone() {
    let scene = ["--threat", "m80-ball", "--material", "aa6082-t651", "--set", "face=300mm"];
    let more = ["--set", "k=2MN/m", "--over", "h=5mm..60mm", "--json"];
    let goal = |value| ["--goal", value];
    let found = |value, code| -> Value {
        let arguments = [&scene[..], &more, &goal(value)].concat();
        serde_json::from_str(&says("seek", &arguments, code).0).unwrap()
    };
    let warned = found("limit_velocity_m_s=700", 0);
    let h = warned["solutions"][0]["at"].as_f64().unwrap();
    let warnings: Vec<&str> =
        warned["warnings"].as_array().unwrap().iter().map(|it| it.as_str().unwrap()).collect();
    let (of_solution, of_threat): (Vec<&str>, Vec<&str>) =
        warnings.iter().copied().partition(|text| text.starts_with("solution (h=0.0"));
    assert!(
        matches!(of_threat[..], [text] if text.starts_with("threat warning: ")),
        "{warnings:?}"
    );
    // They are those of a run of the solution.
    let set = format!("h={h}");
    let run = [&scene[..], &["--set", "k=2MN/m", "--set", &set]];
    let run = says("run", &[&run.concat()[..], &["--json"]].concat(), 0).0;
    let run: Value = serde_json::from_str(&run).unwrap();
    assert!(!of_solution.is_empty(), "{warnings:?}");
    for text in of_solution {
        let own = text.split_once("): ").unwrap().1;
        assert!(run["warnings"].as_array().unwrap().contains(&own.into()), "{own}: {run}");
    }
    let none = found("limit_velocity_m_s=5000", 1);
    assert_eq!(none["warnings"].as_array().unwrap().len(), 1, "{none}");
}

#[test]
fn an_unreachable_goal_exits_1_and_names_the_nearest_value() {
    let arguments = ["--over", "k=0..7.5MN/m", "--goal", "percent_of_baseline=60"];
    let (page, _) = says("seek", &arguments, 1);
    for fragment in ["nothing reaches 60 %", "nearest: 64.2", "65 points from 0 N/m^n"] {
        assert!(page.contains(fragment), "{page} lacks {fragment}");
    }
    let (csv, _) = says("seek", &[&arguments[..], &["--csv", "-"]].concat(), 1);
    assert!(csv.starts_with(
        "scene,kind,variable,key,at,until,output,target,value,outcome,interface,plastic,verdict,\
         expected_limit_m_s,expected_low_m_s,expected_high_m_s,class,measurements,papers,warnings\n"
    ));
    assert!(csv.contains("thesis-baseline,nearest,k,mechanism.spring.coefficient,0,"), "{csv}");
}

#[test]
fn bad_goals_and_bounds_are_refused_with_the_cure() {
    for (arguments, fragments) in [
        (
            ["--over", "k=0..1e6", "--goal", "depth=3"],
            &["output depth", "did you mean `final_penetration_m`"][..],
        ),
        (["--over", "k=0..1e6", "--goal", "stroke_m"], &["QUANTITY=VALUE"]),
        (["--over", "k=0..1e6", "--goal", "stroke_m=3kg"], &["`kg` is not a unit", "mm"]),
        (["--over", "k=1..1", "--goal", "stroke_m=3mm"], &["both ends are 1"]),
        (["--over", "k=0..1:log", "--goal", "stroke_m=3mm"], &["equal ratios"]),
        (
            ["--over", "k=0..1:2", "--goal", "stroke_m=3mm"],
            &["count = 2", "3 to 100000 points here"],
        ),
        (["--over", "gama=0..1", "--goal", "stroke_m=3mm"], &["did you mean `gamma`"]),
    ] {
        let (_, error) = says("seek", &arguments, 2);
        for fragment in fragments {
            assert!(error.contains(fragment), "{error} lacks {fragment}");
        }
    }
}

/// An angle has no unit of its own on the command line.
#[test]
fn the_line_that_runs_a_solution_is_taken_as_it_stands() {
    let goal = ["--over", "theta=0deg..60deg", "--goal", "final_penetration_m=5mm"];
    let (page, _) = says("seek", &goal, 0);
    let line =
        page.lines().find_map(|line| line.split_once("`--set ")?.1.strip_suffix("` runs it"));
    let (run, _) = says("run", &["--set", line.unwrap(), "--json"], 0);
    let run: Value = serde_json::from_str(&run).unwrap();
    let depth = run["final_penetration_m"].as_f64().unwrap();
    assert!((depth / 5e-3 - 1.0).abs() < 1e-6, "{line:?}: {depth}");
}
