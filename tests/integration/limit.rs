//! `cmra limit` as a user meets it.

use cmra_studies::study::context::{Context, never_cancel};
use serde_json::Value;

use crate::support::{cmra, json, printed, says};

#[test]
fn valid_limits_in_closed_form_come_with_their_margin() {
    for (set, limit) in [(["mount=rigid", "b=0"], 232.295_378), (["k=0", "gamma=1"], 347.708_052)] {
        let found = json("limit", &["--set", set[0], "--set", set[1]]);
        let number = |key: &str| found[key].as_f64().unwrap();
        assert!((number("limit_velocity_m_s") - limit).abs() < 5e-7, "{found}");
        assert!((number("margin") - (limit / 100.0 - 1.0)).abs() < 1e-8);
        assert_eq!(found["basis"], "closed form");
        assert!(found["no_limit"].is_null());
        assert_eq!(found["shots"].as_array().unwrap().len(), 30);
    }
}

#[test]
fn the_page_has_its_sections_and_reasons_for_missing_ones() {
    let page = printed("limit", &["--set", "v_i=400"]);
    for words in
        ["limit velocity  344.328", "400.0 m/s perforates", "Lambert-Jonas", "moves along with"]
    {
        assert!(page.contains(words), "{words}: {page}");
    }
    assert!(page.lines().all(|line| line.chars().count() <= 80), "{page}");
    let stopped = printed("limit", &["--set", "x_stop=10mm", "--set", "k=1e3"]);
    assert!(stopped.contains("mount force unknown"), "{stopped}");
    assert!(stopped.contains("mechanism       taken to hold"), "{stopped}");
    let never = printed("limit", &["--set", "h=5"]);
    assert!(
        never.contains("limit beyond 3000 m/s: no shot tried from 1 to 3000 m/s perforates"),
        "{never}"
    );
    let always = printed("limit", &["--set", "S_y=0"]);
    assert!(always.contains("no limit: a shot at 1 m/s perforates already"), "{always}");
    assert!(json("limit", &["--set", "S_y=0"])["limit_velocity_m_s"].is_null());
}

/// Between the limits by protrusion and by passage the criterion alone decides, whichever command is asked.
#[test]
fn the_criterion_is_the_scenes_in_every_command() {
    let plate = ["--set", "mount=rigid", "--set", "h=5mm", "--set"];
    let by = |word: &str| json("limit", &[&plate[..], &[&format!("criterion={word}")]].concat());
    let (passage, protrusion) = (by("passage"), by("protrusion"));
    let limit = |found: &Value| found["limit_velocity_m_s"].as_f64().unwrap();
    assert!(limit(&protrusion) < limit(&passage));
    assert!(printed("limit", &[]).contains("complete passage"));
    let velocity = format!("v_i={}", 0.5 * (limit(&protrusion) + limit(&passage)));
    for (word, outcome) in [("passage", "arrested"), ("protrusion", "perforated")] {
        let criterion = format!("criterion={word}");
        let scene = [&plate[..], &[&criterion, "--set", &velocity, "--json"]].concat();
        let ask = |command: &str, more: &[&str]| {
            let said = cmra(command, &[&scene[..], more].concat()).output().unwrap();
            serde_json::from_slice::<Value>(&said.stdout).unwrap()
        };
        let run = ask("run", &[]);
        assert_eq!((&run["outcome"], &run["criterion"]), (&outcome.into(), &word.into()));
        let sweep = ask("sweep", &["--over", "m_p=29.5g,30g"]);
        assert_eq!(sweep["rows"][0]["outcome"], outcome, "{sweep}");
        let compare = ask("compare", &[]);
        assert_eq!(compare["criterion"], word);
        let own = &compare["candidates"]["scene"];
        assert_eq!((&own["outcome"], limit(own)), (&outcome.into(), limit(&by(word))), "{own}");
        let seek = ask("seek", &["--over", "S_y=1e7..2e9", "--goal", "final_penetration_m=1mm"]);
        assert_eq!(seek["criterion"], word);
    }
}

#[test]
fn shots_are_rows_and_absent_velocities_empty() {
    let table = printed("limit", &["--csv", "-"]);
    let mut lines = table.lines();
    let head = "scene,impact_velocity_m_s,outcome,residual_velocity_m_s,recht_ipson_m_s,lambert_jonas_m_s,limit_velocity_m_s,warnings";
    assert_eq!(lines.next(), Some(head));
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), 30);
    for row in rows {
        assert_eq!(row[3].is_empty(), row[2] != "perforated", "{row:?}");
    }
}

/// The caution about oblique limits agrees with `cmra validate`, at the measured angle that is nearest.
#[test]
fn valid_an_oblique_limit_says_how_far_it_is_off() {
    use cmra_studies::study::envelope::OBLIQUE_LOW;
    let report = cmra::files::validation::report(&mut Context::new(2, &mut never_cancel)).unwrap();
    let class = "AP core on aluminium, oblique";
    let rows: Vec<_> = report.iter().filter(|row| row.case.class == class).collect();
    assert_eq!(rows.len(), OBLIQUE_LOW.len());
    for (row, (_, percent)) in rows.iter().zip(OBLIQUE_LOW) {
        let error = row.computed.unwrap() / row.case.measured - 1.0;
        assert!((100.0 * error + percent).abs() < 0.1, "{percent} {error}");
    }
    let told = "below measured ones, by 8.6 % at 30 deg on a rigid mount (cmra validate)";
    let steep = printed("limit", &["--set", "theta=60deg"]);
    assert!(steep.contains("16.1 %"), "{steep}");
    let oblique = ["--set", "theta=30deg"];
    let words: Vec<String> =
        printed("limit", &oblique).split_whitespace().map(str::to_owned).collect();
    assert!(words.join(" ").contains(told));
    assert!(json("limit", &oblique)["caution"].as_str().is_some_and(|text| text.contains(told)));
    assert!(json("limit", &[])["caution"].is_null());
    assert!(!printed("limit", &[]).contains("oblique"));
    // Without a limit there is no caution.
    assert!(json("limit", &["--set", "theta=30deg", "--set", "h=5"])["caution"].is_null());
}

/// 3 mm of 6061 on a tile of 100 mm against 1.10 g: 367 to 423 m/s, 2 Y with dishing and cavity expansion without. By the closed
/// form of a free plate, evaluated apart from this program: 423.35 m/s, 398.92 by a spherical and 366.85 by a cylindrical cavity.
#[test]
fn valid_band_between_the_closures() {
    let pairs = [
        "m_p=1.10g",
        "R=2.73mm",
        "h=3mm",
        "rho=2700",
        "closure=double-yield",
        "Y=276MPa",
        "E=68.9GPa",
        "gamma=73.63636363636364",
        "k=0",
        "v_i=438",
    ];
    let set: Vec<&str> = pairs.iter().flat_map(|pair| ["--set", pair]).collect();
    let found = json("limit", &set);
    let number = |key: &str| found["closures"][key].as_f64().unwrap();
    assert!((number("double_yield_dishing_m_s") - 423.351_634).abs() < 5e-6, "{found}");
    assert!((number("cavity_no_dishing_m_s") - 398.920_895).abs() < 5e-6, "{found}");
    assert!((number("cylindrical_no_dishing_m_s") - 366.845_163).abs() < 5e-6, "{found}");
    assert!((found["limit_velocity_m_s"].as_f64().unwrap() - 423.351_634).abs() < 5e-6);
    let page = printed("limit", &set);
    assert!(page.contains("by each rule") && page.contains("366.8 to 423.4 m/s"), "{page}");
    assert!(page.contains("2 Y with dishing (C_d = 0.5) 423.4 m/s"), "{page}");
    assert!(page.contains("spherical cavity without dishing (C_d = 1) 398.9 m/s"), "{page}");
    assert_eq!(found["closures"]["double_yield_drag_coefficient"], 0.5, "{found}");
    assert_eq!(found["closures"]["cavity_drag_coefficient"], 1.0, "{found}");
    // A strength that is given has no such band.
    assert!(json("limit", &[])["closures"].is_null());
}

/// The page begins with the limit expected from measurements, and the law's number beside it; a shot without measurements says so.
#[test]
fn a_limit_says_what_measurements_let_expect() {
    let pairs = "nose=pointed m_p=5.3g R=3.1242mm h=20mm rho=2700 E=70GPa Y=260MPa UTS=290MPa closure=cylindrical v_i=450";
    let set: Vec<&str> = pairs.split(' ').flat_map(|pair| ["--set", pair]).collect();
    let rigid = [&set[..], &["--set", "mount=rigid"]].concat();
    let page = printed("limit", &rigid);
    let flat = page.split_whitespace().collect::<Vec<_>>().join(" ");
    for words in [
        "verdict stops: 450.0 m/s is below the band of measured limits, 457.6 to 534.7 m/s",
        "expected limit 494.7 m/s (457.6 to 534.7 m/s): steel core on light alloy, 381 measured limits of 13 papers",
        "law alone 500.137 m/s, closed form",
        "half of the shots perforate",
        "second and third hit at one place: about 0.59 and 0.46 of the first limit",
    ] {
        assert!(flat.contains(words), "{words}: {page}");
    }
    let found = json("limit", &rigid);
    assert_eq!((&found["measurements"], &found["papers"]), (&381.into(), &13.into()));
    let sprung = printed("limit", &set);
    assert!(
        sprung.contains("verdict         not measured: no measured limit of a spring"),
        "{sprung}"
    );
    assert!(json("limit", &set)["expected_limit_m_s"].is_null());
}

/// Just below the limit of a soft spring projectile and plate go on together, and the spring takes all of their energy,
/// `m_p` v²/(2 (1 + gamma)); the stroke is v/(1 + gamma) over the frequency.
#[test]
fn the_limit_comes_with_stroke_energy_and_mount_force() {
    let found = json("limit", &["--set", "k=1e3"]);
    let number = |key: &str| found[key].as_f64().unwrap();
    let limit = number("limit_velocity_m_s");
    let energy = 0.0295 * limit * limit / 4.0;
    assert!((number("stored_energy_at_limit_j") / energy - 1.0).abs() < 1e-2, "{found}");
    let stroke = 0.5 * limit * (0.059f64 / 1e3).sqrt();
    assert!((number("stroke_at_limit_m") / stroke - 1.0).abs() < 1e-2);
    assert!((number("peak_mount_force_at_limit_n") / (1e3 * stroke) - 1.0).abs() < 1e-2);
    let page = printed("limit", &["--set", "k=1e3"]);
    assert!(page.contains("at the limit") && page.contains("mount force"), "{page}");
    assert!(printed("limit", &["free-plate"]).contains("nothing stops plate"));
}

/// Three plates on rigid mounts without dishing and drag take their energies one after the other: v² = 2 S pi R² (h1 + h2 + h3)/m.
/// The shot at the limit is stopped: its warnings are there whether or not rounding lets the limit itself through.
#[test]
fn warnings_are_those_of_the_shot_just_below_the_limit() {
    let thin = ["--material", "aa6061-t6511", "--set", "h=3mm"];
    let (page, _) = says("limit", &thin, 0);
    let flat = page.split_whitespace().collect::<Vec<_>>().join(" ");
    for fragment in ["spring end moves at", "interface push is"] {
        assert!(flat.contains(fragment), "{page}");
    }
}

#[test]
fn stacks_have_limits() {
    let pairs =
        ["dishing=off", "C_d=0", "mount=rigid", "h=3mm", "elements=2", "h_base=3mm", "v_i=60"];
    let set: Vec<&str> = pairs.iter().flat_map(|pair| ["--set", pair]).collect();
    let found = json("limit", &set);
    let volume = std::f64::consts::PI * 0.00635f64.powi(2) * 9e-3;
    let limit = (2.0 * 1.52e8 * volume / 0.0295).sqrt();
    assert!((found["limit_velocity_m_s"].as_f64().unwrap() / limit - 1.0).abs() < 1e-8, "{found}");
    // The preset's own shot of 250 m/s is stopped by the base plate.
    let preset = json("limit", &["array-stacked"]);
    assert!(preset["limit_velocity_m_s"].as_f64().unwrap() > 250.0, "{preset}");
}

/// The limits just below and at h = D, and at 1.6 D, are those between which the page says that the limit jumps.
#[test]
fn valid_the_jump_at_one_diameter_is_said() {
    let at = |h: f64| {
        let words = format!(
            "--threat borvik-hemisphere --material aa6082-t651 --set mount=rigid --set h={h}"
        );
        let words: Vec<&str> = words.split(' ').collect();
        json("limit", &words)
    };
    let limit = |found: &Value| found["limit_velocity_m_s"].as_f64().unwrap();
    for change_m in [0.02, 0.032] {
        let found = at(change_m * (1.0 + 1e-9));
        let jump: Vec<f64> =
            found["jump_m_s"].as_array().unwrap().iter().map(|it| it.as_f64().unwrap()).collect();
        for (side, part) in jump.iter().zip([1.0 - 1e-9, 1.0 + 1e-9]) {
            assert!((limit(&at(change_m * part)) / side - 1.0).abs() < 1e-6, "{jump:?}");
        }
        assert!((jump[1] / jump[0] - 1.0).abs() > 0.01, "{jump:?}");
    }
    let words = [
        "--threat",
        "borvik-hemisphere",
        "--material",
        "aa6082-t651",
        "--set",
        "mount=rigid",
        "--set",
        "h=19mm",
    ];
    let page = printed("limit", &words);
    let page: Vec<&str> = page.split_whitespace().collect();
    assert!(page.join(" ").contains("the strength rule changes and the limit jumps from"));
    assert!(at(0.05)["jump_m_s"].is_null());
}

/// Shots of 250 m/s perforate, by a run of their own.
#[test]
fn shots_that_end_undecided_are_not_said_to_be_stopped() {
    let scene = ["--set", "x_stop=1e-9", "--set", "e=1"];
    let run = json("run", &[&scene[..], &["--set", "v_i=250"]].concat());
    assert_eq!(run["outcome"], "perforated");
    let found = json("limit", &scene);
    if found["limit_velocity_m_s"].is_null() {
        let why = found["no_limit"].as_str().unwrap();
        assert!(why.starts_with("limit not known"), "{why}");
        assert!(found["undecided_at_m_s"].is_number(), "{found}");
    }
}

/// The load of the interface of a plate that moves away is not monotone in the velocity.
#[test]
fn a_fused_interface_is_said_to_hold_only_where_its_shots_do() {
    let is_overloaded = |w: &str, v: &str| {
        let run = json("run", &["--set", w, "--set", v]);
        run["interface_tension_ratio"].as_f64().unwrap() > 1.0
    };
    // At all velocities.
    assert!(["v_i=21", "v_i=25", "v_i=80", "v_i=200"].iter().all(|v| is_overloaded("w_0=20", v)));
    let page = printed("limit", &["--set", "w_0=20"]);
    assert!(page.contains("no more than its strength at no velocity"), "{page}");
    // In the slowest shots and in the fastest.
    let ends = ["v_i=1.05", "v_i=40", "v_i=200"].map(|v| is_overloaded("w_0=1", v));
    assert_eq!(ends, [true, false, true]);
    let page = printed("limit", &["--set", "w_0=1"]);
    assert!(!page.contains("no more than its strength"), "{page}");
    let page = page.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(page.contains("just below the limit and in the slowest shots"), "{page}");
    assert!(json("limit", &["--set", "w_0=1"])["interface_holds_m_s"].is_null());
}
