//! `cmra compare` as a user meets it.

use serde_json::Value;

use crate::support::{assert_near, cmra, json, printed, says};

#[test]
fn valid_numbers_in_closed_form_are_reproduced() {
    let found = json("compare", &[]);
    let number = |candidate: &str, key: &str| found["candidates"][candidate][key].as_f64().unwrap();
    for (candidate, depth, limit) in [
        ("rigid_mount", 7.113_055e-3, 232.295_378),
        ("free_plate", 4.568_088_344_392e-3, 347.708_052),
    ] {
        assert!((number(candidate, "penetration_m") - depth).abs() < 5e-10);
        assert!((number(candidate, "limit_velocity_m_s") - limit).abs() < 5e-7);
    }
    // The solid plate's thickness is that of all the mass over the plate's face.
    let mass = 0.0295 + found["counted_spring_mass_kg"].as_f64().unwrap();
    let thickness = mass / 0.0295 * 0.0254;
    assert!((number("solid_plate", "thickness_m") / thickness - 1.0).abs() < 1e-12);
    assert!(found["candidates"]["free_plate"]["stroke_m"].is_null());
    // A rigid mount takes all of the momentum, m_p v.
    assert!((number("rigid_mount", "mount_impulse_n_s") / 2.95 - 1.0).abs() < 1e-12);
    assert!(found["candidates"]["free_plate"]["peak_mount_force_n"].is_null());
}

/// A spring that is sized for a shot holds that, and nothing faster; the scene's own holds what its plate does.
#[test]
fn one_design_velocity_sizes_and_judges() {
    for v in ["10", "30", "50", "100"] {
        let found = json("compare", &["--size", "--set", &format!("v_i={v}")]);
        let own = &found["candidates"]["scene"];
        let limit = own["limit_if_spring_survives_m_s"].as_f64().unwrap();
        assert!((limit / v.parse::<f64>().unwrap() - 1.0).abs() < 1e-5, "{v}: {limit}");
        assert_eq!(own["governed_by"], "spring full");
        assert!(own["stored_energy_if_spring_survives_j"].as_f64().unwrap() > 0.0);
        assert!(own["stroke_if_spring_survives_m"].as_f64().unwrap() > 0.0);
        let scenes = json("compare", &["--set", &format!("v_i={v}")]);
        let own = &scenes["candidates"]["scene"];
        assert_eq!(own["limit_if_spring_survives_m_s"], own["limit_velocity_m_s"]);
        assert_eq!(scenes["mass_efficiency"], found["mass_efficiency"]);
    }
}

#[test]
fn the_page_begins_with_the_verdict_and_says_how_mass_was_taken() {
    let page = printed("compare", &["--set", "e_spring=20kJ/kg"]);
    let at = |words: &str| page.find(words).unwrap_or_else(|| panic!("{words}: {page}"));
    assert!(at("the mechanism pays") < at("if spring holds, m/s"));
    assert!(at("if spring holds, m/s") < at("stroke, mm"));
    assert!(at("stroke, mm") < at("mount force, kN") && at("mount force, kN") < at("\ndepth, mm"));
    assert!(page.lines().all(|line| line.len() <= 80), "{page}");
    // With the mass of a steel spring the same scene does not pay.
    assert!(printed("compare", &[]).contains("the mechanism does not pay"));
    let perforated = printed("compare", &["--set", "h=3mm", "--set", "v_i=300"]);
    assert!(perforated.contains("not met: the design shot perforates"), "{perforated}");
    assert!(!perforated.replace("not met", "").contains("met:"), "{perforated}");
}

#[test]
fn a_limit_beyond_the_range_is_reported_without_a_number() {
    for scene in [&["gamma=0.05"][..], &["gamma=0.00056", "n=1", "interface=plastic"]] {
        let set: Vec<&str> = scene.iter().flat_map(|pair| ["--set", pair]).collect();
        let page = printed("compare", &set);
        assert!(page.contains("beyond 3000"), "{page}");
        assert!(!page.contains("inf") && !page.contains("NaN"), "{page}");
        // No number of more than 1e12.
        let digits = page.split(|letter: char| !letter.is_ascii_digit());
        assert!(digits.map(str::len).all(|length| length <= 12) && !page.contains("e8"), "{page}");
    }
}

/// In the words of `cmra limit`: they are its limits.
#[test]
fn oblique_limits_come_with_a_caution() {
    let oblique = ["--set", "theta=30deg"];
    let limit = says("limit", &["--json", oblique[0], oblique[1]], 0).0;
    let limit: Value = serde_json::from_str(&limit).unwrap();
    let caution = limit["caution"].as_str().unwrap();
    assert!(printed("compare", &oblique).contains("caution: "), "{}", printed("compare", &oblique));
    assert_eq!(json("compare", &oblique)["caution"].as_str(), Some(caution));
    assert!(!printed("compare", &[]).contains("caution"));
    assert!(json("compare", &[])["caution"].is_null());
}

#[test]
fn candidates_are_rows_and_bad_options_are_refused() {
    let table = printed("compare", &["--csv", "-", "--set", "v_i=400"]);
    let lines: Vec<&str> = table.lines().collect();
    assert!(lines[0].starts_with("scene,candidate,outcome,verdict,governed_by,mass_efficiency,"));
    let words: Vec<&str> = lines[1..].iter().filter_map(|line| line.split(',').nth(1)).collect();
    assert_eq!(words, ["scene", "rigid mount", "free plate", "solid plate"]);
    // Perforated: no depth.
    assert!(lines[2].contains(",,\"outside validity"), "{}", lines[2]);
    for (option, value, told) in
        [("--map", "v_i", "two variables"), ("--map", "v_i,nonsense", "nonsense")]
    {
        let refused = cmra("compare", &[option, value]).assert().code(2);
        let text = String::from_utf8(refused.get_output().stderr.clone()).unwrap();
        assert!(text.contains(told), "{text}");
    }
}

#[test]
fn the_map_is_drawn_with_its_line_and_written_as_rows() {
    let map =
        ["--map", "v_i=10..90:21,gamma=0.2..7:11:log", "--set", "dishing=off", "--set", "k=1"];
    let page = printed("compare", &map);
    for words in ["mass efficiency, up: gamma", "line of 1", "scale"] {
        assert!(page.contains(words), "{words}: {page}");
    }
    let mut csv = map.to_vec();
    csv.extend(["--csv", "-"]);
    let table = printed("compare", &csv);
    let lines: Vec<&str> = table.lines().collect();
    assert_eq!(lines[0], "scene,v_i,gamma,mass_efficiency,no_mass_efficiency,warnings");
    assert_eq!(lines.len(), 1 + 21 * 11);
    // At gamma = 7 the line is at (2 (1 + 7) 196.785)^(1/2) = 56.11 m/s: 54 m/s pays and 58 m/s does not.
    let at = |v_i: &str| -> f64 {
        let start = format!(",{v_i},7,");
        let row = lines.iter().find(|line| line.contains(&start)).unwrap();
        row.split(',').nth(3).unwrap().parse().unwrap()
    };
    assert!(at("54") > 1.0 && at("58") < 1.0, "{table}");
}

/// A damper has no mass in the model: the verdict says so.
#[test]
fn an_armour_that_pays_only_by_a_massless_damper_says_so() {
    let heavy = ["--set", "k=0", "--set", "b=2000"];
    assert_eq!(json("compare", &heavy)["mass_not_counted"], serde_json::json!(["damper"]));
    let page = printed("compare", &heavy);
    assert!(page.contains("the mechanism pays, without the mass of\n  its damper"), "{page}");
    assert!(page.contains("damper: takes up energy, and its mass is not counted"), "{page}");
}

#[test]
fn a_missing_mount_impulse_has_its_reason() {
    let reason = "mount impulse: known of model = hydrodynamic alone";
    assert!(!printed("compare", &[]).contains(reason));
    for model in ["model=half-sine", "model=lumped"] {
        let page = printed("compare", &["--set", model]);
        assert!(page.contains(reason), "{page}");
    }
    let (page, _) = says("explain", &["mount impulse"], 0);
    assert!(page.contains("known of model = hydrodynamic alone"), "{page}");
}

/// Each row of the file has the warnings of its own point: 90 m/s is not below 50 m/s.
#[test]
fn a_map_has_the_warnings_of_each_point() {
    let csv = printed("compare", &["--map", "v_i=10..90:2,gamma=1..7:2", "--csv", "-"]);
    let slow = csv.lines().filter(|line| line.contains("v_i = 10 m/s is below")).count();
    let narrow = csv.lines().filter(|line| line.contains("1.63 D")).count();
    assert_eq!((slow, narrow), (2, 2), "{csv}");
}

#[test]
fn a_comparison_without_a_least_thickness_gives_the_reason() {
    let page = printed("compare", &["--set", "d=0.1"]);
    assert!(
        page.contains("undecided (100.0 m/s): even the thinnest plate within the model's range"),
        "{page}"
    );
}

/// A preloaded mechanism can push a foil of nanometres away from the shot: no search may offer that as an armour.
#[test]
fn an_armour_thinner_than_the_models_range_has_no_mass_efficiency() {
    let found = json(
        "compare",
        &[
            "--set",
            "gamma=3.688693467536329",
            "--set",
            "d=0.057668197886270964",
            "--set",
            "b=321.88345213421053",
            "--set",
            "k=1288072.3658931719",
            "--set",
            "n=1.065450852088438",
        ],
    );
    assert!(found["candidates"]["scene"]["mass_efficiency"].is_null(), "{found}");
}

/// A plate that nothing stops has no mass efficiency: neither in a map nor in the object.
#[test]
fn a_plate_that_nothing_stops_has_no_mass_efficiency() {
    let csv = printed("compare", &["--map", "k=0..1e5:2,v_i=100..150:2", "--csv", "-"]);
    let lines: Vec<&str> = csv.lines().skip(1).collect();
    let empty = |line: &&&str| line.contains(",,nothing stops plate and projectile,");
    assert_eq!((lines.len(), lines.iter().filter(empty).count()), (4, 2), "{csv}");
    let found = json("compare", &["--set", "k=0"]);
    assert!(found["mass_efficiency"].is_null(), "{found}");
    assert_eq!(found["conclusion"], "not met: nothing stops plate and projectile");
}

/// A measured spring that cannot stop its plate fails at the end of its table, and not only where the plate is perforated. Its force of
/// at most 100 N takes less than 2 J within 20 mm, straight lines between its points 1.25 J; two bodies of 29.5 g have m v^2 / 4.
#[test]
fn a_spring_that_does_not_stop_its_plate_does_not_survive() {
    let place = tempfile::tempdir().unwrap();
    let file = place.path().join("curve.csv");
    std::fs::write(&file, "x_m,force_n\n0,0\n0.01,100\n0.02,50\n").unwrap();
    let table = format!("table={}", file.display());
    let found = json("compare", &["--set", &table, "--set", "m_spring=0.01"]);
    assert!(found["mass_efficiency"].is_null(), "{found}");
    let conclusion = found["conclusion"].as_str().unwrap();
    assert!(conclusion.starts_with("not met") && conclusion.contains("the table ends"), "{found}");
    let own = &found["candidates"]["scene"];
    assert_eq!(own["governed_by"], "spring law");
    let survives_m_s = own["limit_if_spring_survives_m_s"].as_f64().unwrap();
    let at_j = |energy_j: f64| (4.0 * energy_j / 0.0295).sqrt();
    assert!(at_j(1.25) < survives_m_s && survives_m_s < at_j(2.0), "{survives_m_s}");
}

/// Slow shots are stopped by plates thinner than the model's range: the page says so.
#[test]
fn a_sized_armour_thinner_than_the_models_range_is_named() {
    let page = printed("compare", &["--set", "v_i=10"]);
    assert!(page.contains("thinner than 0.5 mm"), "{page}");
}

/// Where the face of the tile is given it is kept: sized plates get lighter with their thickness.
#[test]
fn a_given_face_is_kept_when_the_plate_is_sized() {
    let page = printed("compare", &["--set", "face=150mm"]);
    let flat = page.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(flat.contains("mm over a face of 150.0 mm square and"), "{page}");
    let page = printed("compare", &[]);
    let flat = page.split_whitespace().collect::<Vec<_>>().join(" ");
    // 1.34312 mm just stop the shot: classical Runge-Kutta over the travel, apart from this program. m_2 = m_p: (29.5 g / (2710 kg/m³
    // 1.343 mm))^(1/2).
    assert!(flat.contains("1.343 mm over a face of 90.03 mm square (the mass ratio is"), "{page}");
}

/// A mechanism that is never moved has a mass efficiency of 1, and no rounding decides whether it pays.
#[test]
fn a_mechanism_that_does_not_move_makes_no_difference() {
    for velocity in ["v_i=11", "v_i=15", "v_i=20"] {
        let crush = ["--set", "spring=crush", "--set", "F_crush=50kN", "--set", "m_spring=1e-9"];
        let set = [&crush[..], &["--set", "gamma=6.31", "--set", velocity]].concat();
        assert_eq!(
            json("compare", &set)["conclusion"],
            "the mechanism makes no difference to a solid plate"
        );
    }
}

/// Two inputs for one number: each would win somewhere.
#[test]
fn two_sizes_of_a_plate_are_refused() {
    let map = ["--map", "v_i=10..20:2,gamma=1..2:2", "--set", "face=100mm"];
    let (_, error) = says("compare", &map, 2);
    assert!(error.contains("gamma varies, but the scene has face = 0.1 m"), "{error}");
    let axes = ["--over", "gamma=1..2:3", "--over", "m_2=1..2:3"];
    let (_, error) = says("sweep", &axes, 2);
    assert!(error.contains("axis m_2: gamma is an axis too"), "{error}");
}

/// An absorber is as heavy as it is long: F x over its energy per mass, whether or not a shot uses all of the stroke.
#[test]
fn valid_a_crush_absorber_weighs_its_stroke() {
    let mass = |stroke: &str| {
        let words = format!(
            "--set spring=crush --set F_crush=5kN --set k_crush=10MN/m --set e_spring=19460 --set x_crush={stroke}"
        );
        let words: Vec<&str> = words.split(' ').collect();
        json("compare", &words)["candidates"]["scene"]["counted_spring_mass_kg"].as_f64().unwrap()
    };
    for (stroke, metres) in [("20mm", 0.02), ("1000mm", 1.0)] {
        assert!((mass(stroke) / (5e3 * metres / 19460.0) - 1.0).abs() < 1e-12, "{stroke}");
    }
}

/// Without line breaks.
fn told(command: &str, arguments: &[&str]) -> String {
    printed(command, arguments).split_whitespace().collect::<Vec<_>>().join(" ")
}

/// At 400 m/s the plate is perforated: its spring is that of the shot just below the limit, which stores more than the design shot.
#[test]
fn the_shot_that_sizes_the_spring_is_named() {
    let (slow, fast) = (told("compare", &[]), told("compare", &["--set", "v_i=400"]));
    assert!(slow.contains("the least for the design shot at"), "{slow}");
    assert!(fast.contains("the least for the fastest shot that is stopped"), "{fast}");
    let found = json("compare", &["--set", "v_i=400"]);
    let own = &found["candidates"]["scene"];
    let at_limit_j = own["stored_energy_if_spring_survives_j"].as_f64().unwrap();
    let mass_kg = found["counted_spring_mass_kg"].as_f64().unwrap();
    let energy_j_kg = found["spring_energy_j_per_kg"].as_f64().unwrap();
    assert!((mass_kg * energy_j_kg / at_limit_j - 1.0).abs() < 1e-6);
}

/// A spring whose counted mass follows from the shot is another one at each velocity: the limits of the two commands differ.
#[test]
fn a_limit_says_which_spring_it_is_for() {
    let counted = ["--set", "gamma=7", "--set", "own_mass=counted"];
    let own = [&counted[..], &["--set", "m_spring=100g"]].concat();
    for (command, words) in [
        ("limit", "each shot has a spring of its own mass"),
        ("compare", "keeps the spring of the design shot at every velocity"),
    ] {
        assert!(told(command, &counted).contains(words), "{command}");
        for given in [&own[..], &[]] {
            assert!(!told(command, given).contains(words), "{command}");
        }
    }
}

#[test]
fn candidates_at_rest_are_told_apart_from_a_plate_that_moves() {
    let words = "the other candidates are at rest before the shot";
    assert!(told("compare", &["--set", "w_0=50"]).contains(words));
    assert!(!told("compare", &[]).contains(words));
}

/// A shot that the plate does not stop, by the scene's criterion, sizes no spring: then a run, a sweep and a comparison have no areal mass.
/// The one at the limit is that of the plate, times one plus the mass of the spring that stores the energy at the limit over the plate's.
#[test]
fn the_areal_mass_is_that_of_a_run() {
    for (pairs, is_stopped) in [
        (&["v_i=100"][..], true),
        (&["v_i=400"], false),
        (&["v_i=230", "h=10mm", "criterion=protrusion"], false),
    ] {
        let sets: Vec<&str> = pairs.iter().flat_map(|pair| ["--set", pair]).collect();
        let (found, run) = (json("compare", &sets), json("run", &sets));
        let own = &found["candidates"]["scene"];
        assert_eq!(own["areal_mass_kg_m2"], run["areal_mass_kg_m2"], "{pairs:?}");
        assert_eq!(own["areal_mass_kg_m2"].is_f64(), is_stopped, "{pairs:?}");
        let over = ["--over", "k=1e5..2e5:2", "--outputs", "areal_mass_kg_m2", "--csv", "-"];
        let rows = printed("sweep", &[&sets[..], &over].concat());
        let is_absent = |row: &str| row.split(',').nth(3) == Some("");
        assert_eq!(rows.lines().any(is_absent), !is_stopped, "{pairs:?}: {rows}");
        let number = |object: &Value, key: &str| object[key].as_f64().unwrap();
        let spring_kg = number(own, "stored_energy_if_spring_survives_j")
            / number(&found, "spring_energy_j_per_kg");
        let plate_kg_m2 = 2710.0 * number(own, "thickness_m");
        let areal = plate_kg_m2 * (1.0 + spring_kg / 0.0295);
        assert!(
            (number(own, "areal_mass_if_spring_survives_kg_m2") / areal - 1.0).abs() < 1e-12,
            "{pairs:?}"
        );
    }
}

/// A key has one meaning: a number of a comparison is that of a run and of a limit of the same scene, also if the spring fails below the
/// limit. `null` in a run: a limit needs more shots than its own.
#[test]
fn a_key_of_a_comparison_is_that_of_a_run_and_of_a_limit() {
    for pairs in ["d=0", "spring=crush", "spring=prbm-guided d=5mm", "spring=crush m_spring=50g"] {
        let sets: Vec<&str> = pairs.split(' ').flat_map(|pair| ["--set", pair]).collect();
        let found = json("compare", &sets);
        for (command, elsewhere) in [("run", "limit_velocity_m_s"), ("limit", "")] {
            let other = json(command, &sets);
            let objects = [&found, &found["candidates"]["scene"]];
            for (key, value) in objects.into_iter().flat_map(|it| it.as_object().unwrap()) {
                let Some(value) = value.as_f64().filter(|_| key != elsewhere) else { continue };
                let Some(other) = other.get(key) else { continue };
                let is_same =
                    other.as_f64().is_some_and(|it| (it - value).abs() <= 1e-9 * value.abs());
                assert!(is_same, "{pairs} {command} {key}: {value} {other}");
            }
        }
    }
}

/// The page names the velocity up to which the spring survives in front of what is of that shot: a crushed absorber stores F x, no more.
#[test]
fn the_rows_of_the_shot_that_a_spring_survives_say_so() {
    let page = printed("compare", &["--set", "spring=crush"]);
    let row =
        |label: &str| page.lines().filter(|line| line.trim_start().starts_with(label)).count();
    assert_eq!((row("if spring holds, J"), row("at the limit")), (1, 0), "{page}");
    let found = json("compare", &["--set", "spring=crush"]);
    let own = &found["candidates"]["scene"];
    assert_eq!(own["stored_energy_if_spring_survives_j"], 1.25);
}

/// Springs are sized by the displacement of the shot that the least thickness just stops, which changes as the root of the distance to it.
#[test]
fn a_point_of_the_map_is_the_comparison_of_its_scene() {
    let pairs = "k=1.215e5 b=100.9 S_y=1.577e8 h=5.333mm";
    let set: Vec<&str> = pairs.split(' ').flat_map(|pair| ["--set", pair]).collect();
    let json = |more: &[&str]| -> Value {
        serde_json::from_str(&printed("compare", &[&set[..], more, &["--json"]].concat())).unwrap()
    };
    let map = json(&["--map", "v_i=246.02..300:2,gamma=1.714..3:2"]);
    for (row, [v_i, gamma]) in [(0, ["v_i=246.02", "gamma=1.714"]), (3, ["v_i=300", "gamma=3"])] {
        let alone = json(&["--set", v_i, "--set", gamma])["mass_efficiency"].as_f64().unwrap();
        assert_near(map[row]["mass_efficiency"].as_f64().unwrap(), alone, 1e-12);
    }
}
