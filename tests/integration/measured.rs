//! Verdicts of measurements on a shot and a moving plate, in every command: thin plates under cylinders, three rules under hemispheres,
//! the bending of the plate, the sizes of `compare`, and tables of one's own.

use serde_json::Value;

use crate::support::{assert_near, number, says};

fn sets(changes: &str) -> Vec<String> {
    changes.split_whitespace().flat_map(|set| ["--set".to_owned(), set.to_owned()]).collect()
}

fn told(command: &str, changes: &str, more: &[&str], code: i32) -> (String, String) {
    let sets = sets(changes);
    let arguments: Vec<&str> =
        sets.iter().map(String::as_str).chain(more.iter().copied()).collect();
    says(command, &arguments, code)
}

fn json(command: &str, changes: &str, more: &[&str]) -> Value {
    let out = told(command, changes, &[more, &["--json"]].concat(), 0).0;
    serde_json::from_str(&out).unwrap_or_else(|_| panic!("{command} {changes}: {out}"))
}

/// A cylinder of 20 mm on 8 mm of steel, 0.4 of its diameter.
const CYLINDER: &str = "mount=rigid nose=blunt m_p=197g R=10mm rho=7850 closure=cylindrical E=200GPa Y=490MPa UTS=567MPa h=8mm v_i=300";

/// The law is low there: no command says from it that the shot perforates, with which velocity, or what it does to the plate behind.
#[test]
fn a_low_law_never_says_that_a_thin_plate_is_perforated() {
    for mount in ["mount=rigid", "mount=sprung k=1e6 m_2=1"] {
        let changes = format!("{CYLINDER} {mount}");
        let (page, _) = told("run", &changes, &[], 0);
        let page = page.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(page.contains("not-measured: ") && page.contains("safe for stopping"), "{page}");
        assert!(!page.contains("perforates") && !page.contains("perforated"), "{page}");
        let run = json("run", &changes, &[]);
        assert_eq!(
            (&run["outcome"], &run["verdict"]),
            (&"not-measured".into(), &"not-measured".into())
        );
        for absent in ["residual_velocity_m_s", "exit_time_s", "final_penetration_m"] {
            assert!(run[absent].is_null(), "{absent}: {run}");
        }
        let energy = run["energy_j"].as_object().unwrap();
        let known: Vec<&str> =
            energy.iter().filter(|it| !it.1.is_null()).map(|it| it.0.as_str()).collect();
        assert_eq!(known, ["initial_kinetic", "initial_plate", "initial_spring"], "{run}");
        assert!(page.contains("at the end not measured"), "{page}");
        let limit = json("limit", &changes, &[]);
        let shots = limit["shots"].as_array().unwrap();
        assert!(shots.iter().all(|shot| shot["outcome"] != "perforated"), "{limit}");
        assert!(shots.iter().all(|shot| shot["residual_velocity_m_s"].is_null()), "{limit}");
        assert!(number(&limit["limit_velocity_m_s"]) < 300.0, "{limit}");
        let (page, _) = told("limit", &changes, &[], 0);
        let page = page.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(
            page.contains("safe for stopping") && !page.contains("300.0 m/s perforates"),
            "{page}"
        );
    }
    let stack = json("run", &format!("{CYLINDER} h_base=50mm"), &[]);
    assert_eq!(
        (&stack["outcome"], &stack["stack"]["plates"].as_array().unwrap().len()),
        (&"not-measured".into(), &1)
    );
    // What it stops is stopped.
    assert_eq!(json("run", &format!("{CYLINDER} v_i=60"), &[])["outcome"], "arrested");
}

/// 12.7 mm on 20 mm of an alloy, h/D 1.57: of the limits by three rules only a shot below the lowest is said to be stopped.
#[test]
fn under_a_hemisphere_only_the_lowest_rule_stops_a_shot() {
    let plate = "mount=rigid h=20mm rho=2710 closure=cavity dishing=off C_d=1 Y=276MPa UTS=310MPa E=68.9GPa";
    let limits = json("limit", plate, &[]);
    let each = ["double_yield_dishing_m_s", "cavity_no_dishing_m_s", "cylindrical_no_dishing_m_s"];
    let each = each.map(|key| number(&limits["closures"][key]));
    let lowest = each.into_iter().fold(f64::INFINITY, f64::min);
    let own = number(&limits["limit_velocity_m_s"]);
    assert!(lowest < 0.97 * own, "{each:?}");
    for (v, words) in [
        (0.99 * lowest, "is stopped"),
        (0.5 * (lowest + own), "not by the lowest of the three rules"),
    ] {
        for command in ["run", "limit"] {
            let (page, _) = told(command, &format!("{plate} v_i={v}"), &[], 0);
            let page = page.split_whitespace().collect::<Vec<_>>().join(" ");
            assert!(page.contains(words), "{command} at {v}: {page}");
        }
    }
}

/// pi Y h² of 12 mm and 276e6 Pa is 124.9 kN: one line says so where the peak of the contact's force is above it, and only there.
#[test]
fn valid_the_collapse_load_of_the_plate() {
    let load_n = std::f64::consts::PI * 276e6 * 0.012 * 0.012;
    let shot = "mount=rigid m_p=53.78g rho=2700 closure=cylindrical Y=276MPa UTS=310MPa E=68.3GPa h=12mm v_i=200";
    for (more, bends) in [("nose=fragment R=9.95mm", true), ("nose=pointed R=3mm", false)] {
        let run = json("run", &format!("{shot} {more}"), &[]);
        let peak_n = number(&run["peak_contact_force_n"]);
        assert_eq!(peak_n > load_n, bends, "{more}: {peak_n}");
        let warnings = run["warnings"].as_array().unwrap().iter().map(|it| it.as_str().unwrap());
        let line: Vec<&str> = warnings.filter(|it| it.contains("collapse load")).collect();
        assert_eq!(line.len(), usize::from(bends), "{more}: {line:?}");
        assert!(line.iter().all(|it| it.contains("125 kN") && it.contains("inertia")), "{line:?}");
    }
}

/// The solid plate and the armour on a rigid mount are as thick as the lower end of the band asks: 500 m/s, and not the law's 27.6 mm.
#[test]
fn compare_sizes_by_the_rule_of_designs() {
    let shot = "nose=fragment m_p=53.78g R=9.95mm v_i=500 rho=2700 E=68.3GPa Y=276MPa UTS=310MPa closure=cylindrical";
    let (page, _) = told("compare", &format!("mount=rigid h=25.7mm {shot}"), &[], 0);
    let page = page.split_whitespace().collect::<Vec<_>>().join(" ");
    let solid = page.split("a solid plate of ").nth(1).unwrap_or_else(|| panic!("{page}"));
    let h: f64 = solid.split(' ').next().unwrap().parse().unwrap();
    assert!(page.contains("below the band of measured limits"), "{page}");
    let sized = json("limit", &format!("mount=rigid h={h}mm {shot}"), &[]);
    assert!((number(&sized["expected_low_m_s"]) / 500.0 - 1.0).abs() < 1e-3, "{h}: {sized}");
    let moving = "face=200mm k=1e6 h=25.7mm";
    let (page, _) = told("compare", &format!("{moving} {shot}"), &[], 0);
    let page = page.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(page.contains(&format!("a solid plate of {h}")), "{page}");
    assert!(page.contains("an assumption for a plate that moves"), "{page}");
}

fn validated(text: &str, code: i32) -> (String, String) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.csv");
    std::fs::write(&file, text).unwrap();
    says("validate", &[file.to_str().unwrap(), "--json"], code)
}

/// 2 kg at 3 m/s into 1 kg that moves towards it at 1 m/s become one: 5/3 m/s. On 1000 N/m, 2 kg at 3 m/s and 1 kg at rest, joined at
/// once: 2 m/s, 2 (3/1000)^(1/2) m after a quarter of the period, 1000 times as much force.
#[test]
fn valid_moving_plates_are_columns_of_a_table() {
    let free = "m_p [kg],v_i [m/s],w_0 [m/s],m_2 [kg],mount,k,R [mm],h [mm],rho,S_y [MPa],closure,first_arrest_plate_velocity_m_s";
    let text = format!("{free}\n2,3,-1,1,sprung,0,10,100,2700,300,given,1.7\n");
    let object: Value = serde_json::from_str(&validated(&text, 0).0).unwrap();
    let row = &object["rows"][0];
    assert_near(number(&row["first_arrest_plate_velocity_m_s"]), 5.0 / 3.0, 1e-9);
    assert_eq!(row["measured_first_arrest_plate_velocity_m_s"], 1.7);
    assert!(row["measured_peak_mount_force_n"].is_null() && row["refused"].is_null());
    // A model without penetration needs no plate material and no nose.
    let head = "model,m_p [kg],v_i [m/s],m_2 [kg],mount,k,max_plate_displacement_m,max_plate_displacement_time_s,peak_mount_force_n,source";
    let text = format!("{head}\ninitial-velocity,2,3,1,sprung,1000,0.11,0.09,110,spring\n");
    let object: Value = serde_json::from_str(&validated(&text, 0).0).unwrap();
    let row = &object["rows"][0];
    let way = 2.0 * (3.0f64 / 1000.0).sqrt();
    let quarter = std::f64::consts::FRAC_PI_2 * (3.0f64 / 1000.0).sqrt();
    for (key, exact, off) in [
        ("max_plate_displacement_m", way, 1e-9),
        ("max_plate_displacement_time_s", quarter, 2e-3),
        ("peak_mount_force_n", 1000.0 * way, 1e-9),
    ] {
        assert_near(number(&row[key]), exact, off);
    }
}

/// Whatever a row measures that the computed shot lacks is refused and counted, by the same sentence: 100 m/s is stopped, and
/// its bodies stay joined; 400 m/s perforates the plate without a common velocity.
#[test]
fn a_row_without_the_value_of_a_measured_quantity_is_refused() {
    let head = "R [mm],m_p [g],h [mm],rho,S_y,closure,C_d,mount,k,v_i";
    let plate = "6.35,29.5,25.4,2710,1.52e8,given,0.5,sprung,1e5";
    for (v_m_s, outcome, column) in [
        (100, "arrested", "residual_velocity_m_s"),
        (100, "arrested", "separation_velocity_m_s"),
        (400, "perforated", "first_arrest_plate_velocity_m_s"),
    ] {
        let text = format!("{head},{column},note\n{plate},{v_m_s},0.01,{column}\n");
        let (out, told) = validated(&text, 1);
        let object: Value = serde_json::from_str(&out).unwrap();
        let why = format!("the computed shot, {outcome}, has no {column}");
        assert_eq!(
            (&object["refused"], &object["rows"][0]["refused"]),
            (&1.into(), &why.clone().into())
        );
        assert!(told.contains(&format!("line 2: {why}")), "{told}");
    }
}

/// The literal beginning of a file, with whatever such tables have: other units, blanks, UTS below Y, 45 deg, concrete, no closure.
#[test]
fn a_table_of_many_rows_gives_no_refusals() {
    let head = "nose,core,R [mm],m_p [g],h [mm],rho [kg/m3],E [GPa],Y [MPa],UTS [MPa],theta [deg],mount,closure,C_d,limit_m_s,source";
    let rows = [
        "pointed,steel,3.1242,5.3,20,2700,70,260,290,0,rigid,cylindrical,0.212,501,a",
        "pointed,steel,3.1242,5.3,20,2700,70,260,250,45,rigid,cylindrical,0.212,601,a",
        "pointed,tungsten-carbide,3,5,12,7850,207,1350,1640,30,rigid,,,700,b",
        "pointed,,3,5,100,2300,30,40,,0,rigid,,,600,concrete",
        "fragment,,9.95,53.78,25.1,2660,70.9,254,365,0,,,,440,c",
        "fragment,steel,6.3,13.4,10.4,7850,207,1350,1640,20,rigid,cylindrical,1,760,c",
        "blunt,steel,10,197,12,7850,200,490,567,0,rigid,cylindrical,1,184.5,d",
        "hemispherical,steel,10,197,12,7850,200,490,567,0,rigid,cylindrical,1,292,d",
        "ball,lead,3.9,9.5,6,7850,207,900,1020,0,rigid,cylindrical,0.212,800,e",
        "rod,tungsten,2,60,40,7850,207,900,1020,0,rigid,cylindrical,1,1200,e",
        "pointed,steel,3.1242,5.3,20,1400,3,60,60,0,rigid,cylindrical,0.212,300,polymer",
    ];
    let text = (0..438).fold(format!("{head}\n"), |text, at| text + rows[at % rows.len()] + "\n");
    let object: Value = serde_json::from_str(&validated(&text, 0).0).unwrap();
    assert_eq!((&object["refused"], object["rows"].as_array().unwrap().len()), (&0.into(), 438));
    let inches = "nose,R [in],m_p [gr],h [in],rho [kg/m3],E [psi],Y [ksi],UTS [ksi],limit_m_s [fps],source\n\
                  pointed,0.123,81.79,0.78740157,2700,10152642,37.7098,42.0609,1643.7,a\n";
    let found: Value = serde_json::from_str(&validated(inches, 0).0).unwrap();
    let row = &found["rows"][0];
    assert_near(number(&row["measured_limit_m_s"]), 501.0, 1e-4);
    assert_near(number(&row["limit_velocity_m_s"]), 500.14, 1e-3);
    assert_eq!(row["class"], "steel core on light alloy");
}

/// Bad input gets one line each, with the cure.
#[test]
fn what_cannot_be_computed_is_said_in_one_line() {
    let heavy = "nose=fragment m_p=53.78g R=9.95mm rho=2700 closure=cylindrical Y=276MPa UTS=310MPa E=68.3GPa h=25mm";
    for (changes, words) in [
        (format!("{heavy} mount=sprung gamma=0.2"), ["the whole plate is the plug", "raise gamma"]),
        (format!("{heavy} rho=8900 mount=rigid"), ["no plug law for this metal", "set nose"]),
        (format!("{heavy} closure=given mount=rigid"), ["closure", "set closure"]),
        (format!("{heavy} mount=rigid h_base=10mm S_base=1e9"), ["base plate", "closure"]),
    ] {
        let (_, error) = told("run", &changes, &[], 2);
        let lines = error.lines().filter(|line| !line.starts_with("warning: "));
        assert_eq!(lines.count(), 1, "{error}");
        assert!(words.iter().all(|word| error.contains(word)), "{changes}: {error}");
    }
}

/// Variables that a row omits have the values of thesis-baseline.
#[test]
fn a_row_without_dishing_is_the_run_without_it() {
    let text = "R [mm],m_p [g],h [mm],rho,S_y,mount,v_i,residual_velocity_m_s,closure,C_d\n\
                6.35,29.5,25.4,2710,1.52e8,rigid,300,170,given,0.5\n";
    let object: Value = serde_json::from_str(&validated(text, 0).0).unwrap();
    let by_row = object["rows"][0]["residual_velocity_m_s"].as_f64().unwrap();
    let run = says("run", &["--set", "mount=rigid", "--set", "v_i=300", "--json"], 0).0;
    let run: Value = serde_json::from_str(&run).unwrap();
    let by_run = run["residual_velocity_m_s"].as_f64().unwrap();
    assert!((by_row / by_run - 1.0).abs() < 1e-9, "{by_row} {by_run}");
}
