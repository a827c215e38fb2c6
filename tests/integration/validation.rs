//! Measurements from outside the thesis: the table is computed, and agrees with an independent computation of the same law.

use crate::support::assert_near;
use cmra::files::validation;
use cmra_engine::model::scene::{Closure, Scene};
use cmra_engine::model::variables;
use cmra_studies::study::context::{Context, never_cancel};
use cmra_studies::study::validation::{NOT_COUNTED, Row, measurements};

fn row(id: &str) -> Row {
    let report = validation::report(&mut Context::new(2, &mut never_cancel)).unwrap();
    report.into_iter().find(|row| row.case.id == id).unwrap()
}

/// Computed by a separate port of the model: 299.8, 298.5, 290.5 and 290.6 m/s, 204.6 and 170.4, 507.
#[test]
fn valid_the_limits_of_a_separate_port() {
    let first = row("borvik-hemispherical");
    assert_near(first.computed.unwrap(), 299.8, 2e-4);
    assert_near(first.other.unwrap(), 298.5, 2e-4);
    assert!((first.error(first.computed.unwrap()) - 0.026).abs() < 1e-3);
    let lower = row("borvik-lower-yield");
    assert_near(lower.computed.unwrap(), 290.5, 2e-4);
    assert_near(lower.other.unwrap(), 290.6, 2e-4);
    assert_near(row("sphere-on-thin-steel").computed.unwrap(), 204.6, 1e-3);
    assert_near(row("sphere-lower-yield").computed.unwrap(), 170.4, 1e-3);
    assert_near(row("ap-core-on-aluminium").computed.unwrap(), 507.0, 1e-3);
}

#[test]
fn every_case_has_a_value_a_source_and_a_caution() {
    for row in validation::report(&mut Context::new(2, &mut never_cancel)).unwrap() {
        assert!(row.computed.is_some(), "{}", row.case.id);
        assert!(!row.case.source.is_empty() && !row.case.caution.is_empty(), "{}", row.case.id);
        let preset = cmra::files::preset::resolve(row.case.preset, None).unwrap();
        assert!(
            preset.comment.to_lowercase().contains("not "),
            "{}: where it is not to be used",
            row.case.preset
        );
        variables::changed(preset.scene, row.case.set).unwrap();
    }
}

/// The limit of a plate without dishing: W = pi R² h/cos(theta), so the limit goes nearly with the root of 1/cos(theta) where the
/// drag is small, while the measured one goes with 1/cos(theta).
#[test]
fn valid_oblique_limits_fall_behind_the_measured_ones() {
    for (id, degrees) in
        [("ap-core-15-deg", 15f64), ("ap-core-30-deg", 30.0), ("ap-core-45-deg", 45.0)]
    {
        let (straight, slanted) = (row("ap-core-on-aluminium"), row(id));
        let secant = 1.0 / degrees.to_radians().cos();
        let ratio = slanted.computed.unwrap() / straight.computed.unwrap();
        assert!((ratio / secant.sqrt() - 1.0).abs() < 0.01, "{id}: {ratio}");
        let measured = slanted.case.measured / straight.case.measured;
        assert!((measured / secant - 1.0).abs() < 0.01, "{id}: {measured}");
        assert!(slanted.case.caution.contains("must not"), "{id}");
    }
    // The same of the bullet, by its ratios (a separate port: 1.030, 1.158, 1.433).
    assert!((row("ap-bullet-30-deg").case.measured - 1.158).abs() < 1e-3);
    assert_near(
        row("ap-bullet-30-deg").computed.unwrap(),
        row("pair-aa7085-t711-18.5mm").computed.unwrap(),
        0.01,
    );
}

/// 2/3 · Y · (1 + ln(2 E/3 Y)) beside A Y, with Y = 276e6 Pa, E = 68.9e9 Pa, A = 5.04; and the bulge that dishing takes up.
#[test]
fn valid_strength_and_bulge() {
    let rod = row("rod-6061-strength");
    assert_near(rod.computed.unwrap(), 184e6 * (1.0 + (137.8f64 / 0.828).ln()), 1e-12);
    assert_near(rod.other.unwrap(), 552e6, 1e-12);
    assert_near(rod.case.measured, 1_391.04e6, 1e-12);
    assert_near(row("borvik-bulge").computed.unwrap(), 0.02, 1e-12);
    assert_eq!(row("borvik-bulge").other, None);
}

/// Errors of the series of plates by an independent computation, in percent; one of them by the closed form v^2 = S/c (exp(2 c pi R^2 h/m)
/// - 1).
#[test]
fn valid_the_ladder_of_thickness() {
    let near = |id: &str, percent: f64| {
        let row = row(id);
        let own = 100.0 * row.error(row.computed.unwrap());
        // Whole percents, some of them cut off and not rounded.
        assert!((own - percent).abs() < 0.7, "{id}: {own}");
    };
    let mild = [-5.0, -3.0, -4.0, -5.0, -7.0, -18.0, -20.0];
    for (h, percent) in ["4.7", "6", "10", "12", "16", "20", "25"].into_iter().zip(mild) {
        near(&format!("mild-steel-{h}mm"), percent);
    }
    let closed = |y: f64, h: f64| {
        let (s, c) = (2.0 / 3.0 * y * (1.0 + (400e9 / (3.0 * y)).ln()), 0.106 * 7850.0);
        let volume = std::f64::consts::PI * 0.003_124_2f64.powi(2) * h;
        (s / c * (2.0 * c * volume / 0.0053).exp_m1()).sqrt()
    };
    assert_near(row("mild-steel-10mm").computed.unwrap(), closed(250e6, 0.01), 1e-9);
}

/// Twelve measured pairs at 30 deg have a mean ratio of 1.117 +- 0.032, the model 1.077, 1/cos(30 deg) is 1.155.
#[test]
fn valid_the_pairs_at_30_degrees() {
    let pairs: Vec<Row> = validation::report(&mut Context::new(2, &mut never_cancel))
        .unwrap()
        .into_iter()
        .filter(|row| row.case.class == "limit at an angle over that at 0 deg")
        .collect();
    assert_eq!(pairs.len(), 12);
    let mean = |get: fn(&Row) -> f64| pairs.iter().map(get).sum::<f64>() / 12.0;
    let measured = mean(|row| row.case.measured);
    assert!((measured - 1.117).abs() < 5e-4, "{measured}");
    let spread: f64 = pairs.iter().map(|row| (row.case.measured - measured).powi(2)).sum();
    assert!(((spread / 11.0).sqrt() - 0.032).abs() < 1e-3, "{spread}");
    let computed = mean(|row| row.computed.unwrap());
    assert!((computed - 1.077).abs() < 1.5e-3, "{computed}");
}

/// Acceptance needs less than the classes of measurements let expect: 7.62 mm APM2 on rolled armour of 6 to 16 mm.
#[test]
fn least_required_limits_of_rolled_armour_are_below_the_expected_ones() {
    let report = validation::report(&mut Context::new(2, &mut never_cancel)).unwrap();
    let least: Vec<&Row> =
        report.iter().filter(|row| row.case.id.starts_with("rha-least-")).collect();
    let required = [469.0, 565.0, 647.0, 720.0, 787.0, 850.0];
    assert_eq!(least.iter().map(|row| row.case.measured).collect::<Vec<_>>(), required);
    for row in least {
        assert!(row.case.class == NOT_COUNTED && row.case.caution.starts_with("least required"));
        assert!(row.error(row.computed.unwrap()).abs() < 0.1, "{row:?}");
    }
}

/// Common velocities by momentum: `m_2/(m_p + m_2)` of the closing velocity, times 1.95088 for a restitution of 0.95088, and the rest of
/// the momentum for the plate. A soft absorber is crushed by `m v^2/(2 F)` beyond the elastic rise.
#[test]
fn valid_moving_plates_and_mounts() {
    for shot in 1..=5 {
        assert_near(row(&format!("air-track-fused-{shot}")).computed.unwrap(), 205.0 / 412.0, 1e-9);
    }
    for shot in 1..=4 {
        let id = format!("air-track-elastic-{shot}");
        assert_near(row(&id).computed.unwrap(), 1.95088 * 205.0 / 412.0, 1e-6);
        assert_near(row(&(id + "-plate")).computed.unwrap(), 1.95088 * 207.0 / 412.0, 1e-6);
    }
    // Restitution 0.2: the root of 1e6 over 2.5e7.
    assert_near(row("polo-5.5mph").computed.unwrap(), 1.2 * 770.0 / 1720.0, 1e-6);
    assert_near(row("polo-5.5mph-struck").computed.unwrap(), 1.2 * 950.0 / 1720.0, 1e-6);
    assert_near(row("yang-xi-travel").computed.unwrap(), 0.04540, 1e-3);
    assert_near(row("honeycomb-2").computed.unwrap(), 108_981.0, 1e-9);
    let (m, v, f, k) = (5291.91, 8.35965, 587_165.0, 1e8);
    assert_near(
        row("collision-post-stroke").computed.unwrap(),
        0.5 * m * v * v / f + 0.5 * f / k,
        1e-4,
    );
}

/// N equal hits at one place open the hole of one limit shot: `N m/(2 c) ln(1 + c v_N^2/S)` is the same volume for every N. Without
/// drag that is `v_1/root(N)`.
#[test]
fn valid_hits_at_the_same_place() {
    let first = row("sphere-on-thin-steel").computed.unwrap();
    let scene = cmra::files::preset::resolve("validation-thin-sphere", None).unwrap().scene;
    let (s, c) = (scene.flow_strength_pa(), scene.drag_kg_m3());
    let volume = (c * first * first / s).ln_1p();
    for (id, hits) in [("sphere-second-hit", 2.0), ("sphere-third-hit-fe", 3.0)] {
        assert_near(row(id).computed.unwrap(), (s / c * (volume / hits).exp_m1()).sqrt(), 1e-9);
        assert_near(row(id).computed.unwrap(), first / f64::sqrt(hits), 0.04);
    }
    assert!(row("sphere-second-hit").case.caution.contains("UNCONSERVATIVE"));
}

#[test]
fn bias_and_scatter_are_of_the_rows_and_stale_statements_are_gone() {
    let report = validation::report(&mut Context::new(2, &mut never_cancel)).unwrap();
    let biases = cmra_studies::study::validation::biases(&report);
    let mild = biases.iter().find(|it| it.class == Some("AP core on mild steel")).unwrap();
    // The mean of -5, -3, -4, -5, -7, -18 and -20 percent.
    assert!(mild.points == 7 && (mild.mean + 0.089).abs() < 5e-3, "{}", mild.mean);
    let all = biases.last().unwrap();
    let counted = report.iter().filter(|row| row.case.class != NOT_COUNTED).count();
    assert_eq!((all.class, all.points), (None, counted));
    assert_eq!(biases.iter().map(|it| it.points).sum::<usize>(), 2 * counted);
    let mut texts: Vec<&str> = report.iter().map(|row| row.case.caution).collect();
    texts.extend(measurements().not_checked.iter().map(|it| it.why));
    for text in texts {
        for stale in ["numbers are not at hand", "bullet's mass", "and projectile are not given"] {
            assert!(!text.contains(stale), "{text}");
        }
    }
}

#[test]
fn the_other_closure_is_never_a_combination() {
    for case in &measurements().cases {
        let scene = cmra::files::preset::resolve(case.preset, None).unwrap().scene;
        assert!(!(scene.target.closure == Closure::Cavity && scene.target.dishing), "{}", case.id);
    }
    // Nor is it reached by a layer of a stack.
    let layered = "format = 1\n[target]\nyield_pa = 3e8\nmodulus_pa = 7e10\n[stack]\nbase_thickness_m = 0.01\n\
                   [[stack.layer]]\ntarget.closure = \"cavity\"\n";
    let told = cmra::files::read::scene(layered, "layered").map_err(|error| error.to_string());
    assert!(told.as_ref().is_err_and(|text| text.contains("corrects twice")), "{told:?}");
}

#[test]
fn closures_give_their_strength_and_are_never_combined() {
    let mut scene = Scene::default();
    (scene.target.yield_pa, scene.target.modulus_pa) = (490e6, 200e9);
    assert!((scene.flow_strength_pa() - 1.52e8).abs() < 1.0);
    scene.target.closure = Closure::DoubleYield;
    assert!((scene.flow_strength_pa() - 980e6).abs() < 1.0);
    variables::validate(&scene).unwrap();
    scene.target.closure = Closure::Cavity;
    // 2/3 · 490 MPa · (1 + ln(2 · 200/(3 · 0.49))).
    assert!((scene.flow_strength_pa() / 2.158_026e9 - 1.0).abs() < 1e-6);
    let told = variables::validate(&scene).unwrap_err().to_string();
    for word in ["closure", "cavity", "dishing", "corrects twice", "set dishing = off"] {
        assert!(told.contains(word), "{told}");
    }
    scene.target.dishing = false;
    variables::validate(&scene).unwrap();
    scene.target.modulus_pa = 1e8;
    let told = variables::validate(&scene).unwrap_err().to_string();
    assert!(told.contains("E (target.modulus_pa)") && told.contains("greater than Y"), "{told}");
}

#[test]
fn the_command_prints_the_table_as_page_csv_and_json() {
    let cmra = |arguments: &[&str]| {
        let output = crate::support::program().args(arguments).output().unwrap();
        assert!(output.status.success());
        String::from_utf8(output.stdout).unwrap()
    };
    let page = cmra(&["validate"]);
    for text in
        ["379   13 -1.8 %  4.7 %", "steel core on light alloy", "597   20", "never combined"]
    {
        assert!(page.contains(text), "{text}: {page}");
    }
    assert!(
        !page.contains("299.8 m/s (+2.6 %)") && page.lines().all(|it| it.chars().count() <= 80),
        "{page}"
    );
    let all = cmra(&["validate", "--rows"]);
    assert!(all.contains("299.8 m/s (+2.6 %)") && all.lines().count() > 597, "{all}");
    let csv = cmra(&["validate", "--csv", "-"]);
    assert!(
        csv.starts_with(
            "line,source,measured_limit_m_s,deviation_m_s,limit_velocity_m_s,expected_limit_m_s,"
        ),
        "{csv}"
    );
    assert_eq!(csv.lines().count(), 1 + 597);
    assert!(all.contains("yu-beam  [cannot be checked]") && all.contains("hinge"), "{all}");
    let object: serde_json::Value = serde_json::from_str(&cmra(&["validate", "--json"])).unwrap();
    assert_eq!(object["cases"][0]["case"], "borvik-hemispherical");
    assert!((object["cases"][0]["relative_error"].as_f64().unwrap() - 0.0264).abs() < 1e-3);
    assert_eq!(object["rows"].as_array().unwrap().len(), 597);
    assert_eq!(object["errors"].as_array().unwrap().last().unwrap()["class"], "all");
}

/// A file of one's own measurements: the classes are those of the built-in table, whose own rows err by less than papers left out.
#[test]
fn a_users_own_measurements_are_read_computed_and_judged() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.csv");
    let cmra = |text: &str, more: &[&str]| {
        std::fs::write(&file, text).unwrap();
        let output =
            crate::support::program().arg("validate").arg(&file).args(more).output().unwrap();
        let [out, told] = [output.stdout, output.stderr].map(|it| String::from_utf8(it).unwrap());
        (output.status.code(), out, told)
    };
    let head = "nose,core,R [mm],m_p [g],h [mm],rho [kg/m3],E [GPa],Y [MPa],UTS [MPa],theta [deg],mount,closure,C_d,limit_m_s,source";
    let row = "pointed,steel,3.1242,5.3,20,2700,70,260,290,0,rigid,cylindrical,0.212,501,mine";
    let (status, out, told) = cmra(&format!("{head}\n{row}\n"), &["--json"]);
    assert_eq!((status, told.as_str()), (Some(0), ""));
    let found: serde_json::Value = serde_json::from_str(&out).unwrap();
    let first = &found["rows"][0];
    // The independent band of this shot.
    for (key, value) in [
        ("limit_velocity_m_s", 500.136_675_3),
        ("expected_limit_m_s", 494.673_326_3),
        ("expected_low_m_s", 457.606_943_8),
        ("expected_high_m_s", 534.742_103_8),
    ] {
        assert_near(first[key].as_f64().unwrap(), value, 1e-7);
    }
    assert_eq!(
        (&first["class"], &first["refused"]),
        (&"steel core on light alloy".into(), &serde_json::Value::Null)
    );
    assert_eq!(first["measured_limit_m_s"], 501.0);
    // A row without mass keeps its place, and a page names it.
    let (status, out, told) =
        cmra(&format!("{head}\n{}\n{row}\n", row.replacen(",5.3,", ",,", 1)), &[]);
    assert_eq!(status, Some(1));
    assert!(
        out.contains("refused: line 2: no value of m_p") && told.contains("line 2"),
        "{out} {told}"
    );
    for (text, problem) in [
        ("R [mm],calibre,limit_m_s\n1,2,3\n", "`calibre` is no column"),
        ("R [mm],limit_m_s\n1in,3\n", "write numbers only"),
    ] {
        let (status, _, told) = cmra(text, &[]);
        assert_eq!((status, told.trim().lines().count()), (Some(2), 1), "{told}");
        assert!(told.contains(problem), "{told}");
    }
}
