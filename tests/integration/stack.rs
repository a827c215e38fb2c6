//! Stacks of elements: against closed forms, against the single run, and what is refused.

use std::f64::consts::PI;
use std::sync::Arc;

use cmra::files::{preset, read, write};
use cmra_engine::model::run::{Outcome, Run, RunWarning};
use cmra_engine::model::variables;
use cmra_studies::study::quantities;

use crate::support::{assert_near, cmra, run, says, scene};

#[test]
fn a_stack_of_one_element_is_the_single_run() {
    for pairs in ["k=1e5", "spring=column", "h=0.003 v_i=200", "k=1e6 n=1.4 d=0.01"] {
        let single = run(scene(pairs));
        let mut stacked = run(scene(&format!("{pairs} base=0.01")));
        let stack = stacked.stack.take().unwrap();
        // What goes through the first plate of a stack meets the next: no warning says that it goes through a rigid one, too.
        stacked
            .warnings
            .extend(single.warnings.iter().filter(|it| **it == RunWarning::NoBaseline).copied());
        stacked.scene = Arc::clone(&single.scene);
        assert_eq!(stacked, single, "{pairs}");
        let reached_base = single.outcome == Outcome::Perforated;
        assert_eq!(stack.behind.len(), usize::from(reached_base), "{pairs}");
        if !reached_base {
            assert_eq!(stack.penetration_m, single.penetration.final_m);
            assert_eq!((stack.behind.len(), stack.outcome), (0, single.outcome));
        }
    }
}

/// The preset's shot goes through two elements and is stopped by the base plate.
#[test]
fn the_outcome_of_a_stack_is_that_of_all_its_plates() {
    let json = |arguments: &[&str]| {
        let (out, _) = says(arguments[0], &arguments[1..], 0);
        serde_json::from_str::<serde_json::Value>(&out).unwrap()
    };
    let found = json(&["run", "array-stacked", "--json"]);
    assert_eq!(found["outcome"], "arrested");
    assert!(found["residual_velocity_m_s"].is_null());
    // Behind the first element; from an independent computation: classical Runge-Kutta at 5 ns.
    let behind = found["stack"]["plates"][0]["residual_velocity_m_s"].as_f64().unwrap();
    assert_near(behind, 220.961_130_452_846_33, 1e-6);
    let (page, _) = says("sweep", &["array-stacked", "--over", "v_i=200,250,300", "--csv", "-"], 0);
    let outcomes: Vec<&str> = page
        .lines()
        .skip(1)
        .map(|line| if line.contains(",arrested,") { "arrested" } else { "perforated" })
        .collect();
    assert_eq!(outcomes, ["arrested", "arrested", "perforated"], "{page}");
}

/// `run`, `sweep` and `limit` take a stack as any scene, by the outcome of its shot; what belongs to one plate is empty.
#[test]
fn studies_take_a_stack_by_the_outcome_of_its_shot() {
    let json = |command: &str, more: &[&str]| {
        let out = says(command, &[&["array-stacked", "--json"], more].concat(), 0).0;
        serde_json::from_str::<serde_json::Value>(&out).unwrap()
    };
    let number = |value: &serde_json::Value| value.as_f64().unwrap();
    let found = json("run", &[]);
    // Classical Runge-Kutta, plate by plate: 149.741 m/s behind three elements of 3 mm, 9.3286997 mm into the base plate.
    assert_near(number(&found["final_penetration_m"]), 18.328_699_7e-3, 1e-8);
    assert!(found["stroke_m"].is_null() && found["percent_of_baseline"].is_null());
    let outputs = "final_penetration_m,residual_velocity_m_s,limit_velocity_m_s";
    let swept = json("sweep", &["--over", "v_i=250,300", "--outputs", outputs]);
    let rows = &swept["rows"];
    assert_eq!(rows[0]["final_penetration_m"], found["final_penetration_m"]);
    assert!(
        rows[0]["residual_velocity_m_s"].is_null()
            && number(&rows[1]["residual_velocity_m_s"]) > 0.0
    );
    let limit = number(&json("limit", &[])["limit_velocity_m_s"]);
    assert!((250.0..300.0).contains(&limit), "{limit}");
    assert_near(number(&rows[0]["limit_velocity_m_s"]), limit, 1e-9);
}

/// Free plates: by momentum, and the closed form of the relative motion (Recht-Ipson's with p = 2).
#[test]
fn valid_free_plates_leave_the_velocity_of_the_closed_form() {
    let (m, r, h, c, s): (f64, f64, f64, f64, f64) = (0.0295, 0.00635, 0.003, 677.5, 1.52e8);
    let cap = PI * h * h * (r - h / 3.0);
    let volume = cap * (h + 2.0 * r) / h + PI * r * r * h - cap;
    let found = run(scene("k=0 h=0.003 v_i=250 base=0.02 elements=3"));
    let stack = found.stack.as_ref().unwrap();
    let mut velocity: f64 = 250.0;
    let mu = 0.5 * m;
    let runs: Vec<&Run> =
        std::iter::once(&found).chain(stack.behind.iter().map(|run| &**run)).collect();
    for run in &runs[..3] {
        assert_near(run.scene.projectile.velocity_m_s, velocity, 1e-10);
        let limit = s / c * (2.0 * c * volume / mu).exp_m1();
        let slip = ((velocity * velocity - limit) * (-2.0 * c * volume / mu).exp()).sqrt();
        velocity = 0.5 * (velocity + slip);
        assert_near(run.departure.residual_velocity_m_s.unwrap(), velocity, 1e-10);
    }
    // The base plate is rigid: it stops where V = m/(2c) ln(1 + c v²/S).
    assert_eq!((stack.behind.len(), stack.outcome), (3, Outcome::Arrested));
    let base = runs[3];
    assert_near(base.scene.projectile.velocity_m_s, velocity, 1e-10);
    let depth = base.penetration.final_m.unwrap();
    assert!(depth > r, "the nose is buried");
    let swept = PI * r * r * (depth - r / 3.0) * (0.02 + 2.0 * r) / 0.02;
    assert_near(swept, m / (2.0 * c) * (c * velocity * velocity / s).ln_1p(), 1e-10);
    assert_near(stack.penetration_m.unwrap(), 3.0 * h + depth, 1e-12);
}

#[test]
fn a_base_plate_too_thin_is_perforated_with_a_residual_velocity() {
    let found = run(scene("h=0.002 v_i=400 base=0.002 elements=2"));
    let stack = found.stack.as_ref().unwrap();
    assert_eq!(
        (stack.behind.len(), stack.outcome, stack.penetration_m),
        (2, Outcome::Perforated, None)
    );
    let left = stack.residual_velocity_m_s.unwrap();
    assert_eq!(Some(left), stack.behind.last().unwrap().departure.residual_velocity_m_s);
    assert!(left > 200.0 && left < 400.0, "{left}");
}

#[test]
fn elements_may_differ_and_are_kept() {
    let text = "format = 1\nprojectile.velocity_m_s = 300.0\ntarget.thickness_m = 0.003\nmechanism.stop.position_m = 0.01\n\
                [stack]\nbase_thickness_m = 0.02\ngap_m = 0.002\n\
                [[stack.layer]]\ntarget.thickness_m = 0.004\nmechanism.spring.kind = \"column\"\n\
                [[stack.layer]]\nmechanism.stop.position_m = \"none\"\n\
                mechanism.spring.kind = \"table\"\nmechanism.spring.table.points = [[0.0, 0.0], [0.01, 3e3]]\n";
    let own = read::scene(text, "own.toml").unwrap();
    assert_eq!(own.stack.layers.len(), 2);
    assert_eq!(own.stack.layers[1].mechanism.stop.position_m, None);
    assert_eq!(own.stack.layers[0].mechanism.stop.position_m, Some(0.01));
    let fresh = write::fresh(&own);
    assert_eq!(read::scene(&fresh, "own.toml").unwrap(), own, "{fresh}");
    let updated = write::updated("# mine\nformat = 1\n", "own.toml", &own).unwrap();
    assert_eq!(read::scene(&updated, "own.toml").unwrap(), own, "{updated}");
    let found = run(own);
    let stack = found.stack.as_ref().unwrap();
    let thicknesses: Vec<f64> =
        stack.behind.iter().map(|run| run.scene.target.thickness_m).collect();
    assert_eq!(thicknesses, [0.004, 0.003, 0.02]);
    let meets = found.warnings.iter().filter(|it| matches!(it, RunWarning::PlateMeetsNext { .. }));
    assert_eq!(meets.count(), 3);
}

/// Values that an element omits are the first plate's when the file is read, whatever changes later.
#[test]
fn saving_another_first_plate_leaves_the_elements_as_they_are() {
    let text = "format = 1\n[target]\nthickness_m = 0.02\n[stack]\nbase_thickness_m = 0.02\n\
                [[stack.layer]] # as the first\n\
                [[stack.layer]] # thin\ntarget.thickness_m = 0.004 # m\n[[stack.layer]]\nplate.mass_kg = 0.04\n";
    let mut own = read::scene(text, "own.toml").unwrap();
    for (name, value) in [("gamma", "1.5"), ("m_2", "0.05"), ("face", "0.1"), ("x_stop", "1mm")] {
        variables::set_by_name(&mut own, name, value).unwrap();
        let (updated, fresh) =
            (write::updated(text, "own.toml", &own).unwrap(), write::fresh(&own));
        for written in [&updated, &fresh] {
            assert_eq!(&read::scene(written, "own.toml").unwrap(), &own, "{written}");
        }
        let places = ["[target]", "[stack]", "# as the first", "# thin\ntarget", "0.004 # m"];
        let places = places.map(|part| updated.find(part));
        assert!(places.is_sorted() && places[0].is_some(), "{updated}");
    }
    // One more is written below the others' place.
    own.stack.layers.push(own.stack.layers[1].clone());
    let updated = write::updated(text, "own.toml", &own).unwrap();
    assert_eq!(read::scene(&updated, "own.toml").unwrap(), own, "{updated}");
    assert!(updated.find("[stack]") < updated.find("[[stack.layer]]"), "{updated}");
}

/// rho h face^2 of 2710 kg/m3, 5 mm and 0.1 m is 0.1355 kg, whatever strikes it.
#[test]
fn an_element_of_a_given_face_keeps_its_mass_under_another_projectile() {
    let text = "format = 1\nplate.face_m = 0.1\n[stack]\nbase_thickness_m = 0.02\n\
                [[stack.layer]]\ntarget.thickness_m = 0.005\n";
    let mut own = read::scene(text, "own.toml").unwrap();
    variables::set_by_name(&mut own, "m_p", "50g").unwrap();
    let element = &cmra_engine::model::stack::plates(&own)[1];
    assert!((element.plate_mass_kg() - 0.1355).abs() < 1e-15, "{}", element.plate_mass_kg());
}

#[test]
fn a_stack_without_a_base_is_refused_and_so_are_studies_of_one_plate() {
    let refused = |pairs: &str| variables::validate(&scene(pairs)).unwrap_err().to_string();
    let cases = [
        (
            "elements=3",
            vec!["elements", "= 3", "h_base", "must end in a base plate", "omit the stack"],
        ),
        ("elements=2.5 base=0.01", vec!["stack.elements", "2.5", "not whole"]),
        ("model=half-sine base=0.01", vec!["half-sine", "stack.base_thickness_m", "hydrodynamic"]),
    ];
    for (pairs, words) in cases {
        let text = refused(pairs);
        for word in words {
            assert!(text.contains(word), "{pairs}: {text}");
        }
    }
    let told = variables::require_single(&scene("base=0.01")).unwrap_err().to_string();
    assert!(told.contains("h_base") && told.contains("0.01") && told.contains("h_base = none"));
    let text =
        "format = 1\n[stack]\nbase_thickness_m = 0.01\n[[stack.layer]]\nprojectile.mass_kg = 1.0\n";
    let told = read::scene(text, "own.toml").unwrap_err().to_string();
    assert!(
        told.contains("stack.layer.projectile") && told.contains("target, plate, mechanism"),
        "{told}"
    );
}

/// The springs of the preset have 100 kN/m: the plate-by-plate table has k x of each, and the contact force of the base plate, which
/// is the greatest.
#[test]
fn valid_the_table_of_a_stack_gives_the_mount_force_of_each_plate() {
    let (page, _) = says("run", &["array-stacked"], 0);
    let rows =
        page.lines().filter(|line| line.starts_with("element ") && line.contains("  perforated"));
    let mut elements = 0;
    for row in rows {
        let numbers: Vec<f64> = row.split_whitespace().filter_map(|it| it.parse().ok()).collect();
        let [.., travel_mm, mount_kn] = numbers[..] else { panic!("{row}") };
        assert_near(mount_kn, 0.1 * travel_mm, 1e-4);
        elements += 1;
    }
    assert_eq!(elements, 3, "{page}");
    assert!(page.contains("peak mount force of a plate: 20.06 kN, base plate"), "{page}");
}

/// The depth of a stack is that in all its plates, and no better known than that in any of them.
#[test]
fn the_error_of_a_stack_is_that_of_its_least_known_plate() {
    let mut stack = preset::resolve("array-stacked", None).unwrap().scene;
    stack.run.tolerance = 1e-3;
    let found = run(stack);
    let errors: Vec<f64> = found.plates().map(|plate| plate.estimate.main.unwrap()).collect();
    let greatest = errors.iter().copied().fold(0.0, f64::max);
    assert!(errors[0] < greatest, "{errors:?}");
    let shown = quantities::find("error_estimate").unwrap().value(&found);
    assert_eq!(shown, Some(greatest));
}

/// The verdict is that of the shot, and stands above what is of the first element alone.
#[test]
fn the_verdict_of_a_stack_stands_above_its_first_element() {
    let sets = ["elements=2", "h=5mm", "h_base=5mm", "v_i=200", "interface=plastic"];
    let (page, _) = says("run", &sets.map(|set| ["--set", set]).concat(), 0);
    let at = |words: &str| page.find(words).unwrap_or_else(|| panic!("{words}: {page}"));
    assert!(at("by the law alone") < at("element 1 in full:"), "{page}");
    assert_eq!(page.matches("by the law alone").count(), 1, "{page}");
}

/// As `seek` and `sensitivity`, before any run.
#[test]
fn studies_refuse_results_that_a_stack_lacks() {
    for (command, arguments) in [
        ("optimise", &["--minimise", "stroke_m"][..]),
        ("optimise", &["--minimise", "final_penetration_m", "--subject-to", "stroke_m<=1"]),
        ("sweep", &["--over", "v_i=200,250", "--outputs", "final_penetration_m,stroke_m"]),
        ("sweep", &["--over", "v_i=200,250", "--outputs", "stroke_m", "--csv", "-"]),
        ("montecarlo", &["--outputs", "stroke_m"]),
        ("montecarlo", &["--outputs", "final_penetration_m,stroke_m"]),
    ] {
        let refused = cmra(command, &[&["array-stacked"], arguments].concat()).assert().code(2);
        let text = String::from_utf8(refused.get_output().stderr.clone()).unwrap();
        assert!(text.contains("stroke: a stack has none; take final_penetration_m"), "{text}");
    }
}

/// Without a goal or an output, a study takes those that a stack has.
#[test]
fn the_default_results_of_a_stack_are_those_it_has() {
    let front = says("optimise", &["array-stacked", "--samples", "64", "--json"], 0).0;
    let front: serde_json::Value = serde_json::from_str(&front).unwrap();
    let designs = front["designs"].as_array().unwrap();
    assert!(designs.iter().all(|it| it["final_penetration_m"].is_f64()), "{front}");
    let page = says("sweep", &["array-stacked", "--over", "v_i=200,250"], 0).0;
    assert!(page.contains("final depth") && !page.contains("no value anywhere"), "{page}");
}
