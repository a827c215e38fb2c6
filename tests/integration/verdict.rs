//! Verdicts: every command gives the same answer to "does this armour stop this shot?".

use serde_json::Value;

use crate::support::number;

/// Whatever a shot needs to be set on the baseline; its impact velocity stands in each.
pub(crate) const SHOTS: [(&str, &str); 5] = [
    (
        "fragment of 20 mm on 25.7 mm of 6061",
        "nose=fragment m_p=53.78g R=9.95mm v_i=500 h=25.7mm rho=2700 E=68.3GPa Y=276MPa UTS=310MPa closure=cylindrical",
    ),
    (
        "APM2 core on 20 mm of 6082-T651",
        "nose=pointed m_p=5.3g R=3.1242mm v_i=450 h=20mm rho=2700 E=70GPa Y=260MPa UTS=290MPa closure=cylindrical",
    ),
    (
        "APM2 core on 10 mm of RHA",
        "nose=pointed m_p=5.3g R=3.1242mm v_i=650 h=10mm rho=7850 E=207GPa Y=900MPa UTS=1020MPa closure=cylindrical",
    ),
    (
        "M80 ball on 6.35 mm of RHA",
        "nose=pointed core=deformable m_p=9.5g R=3.91mm v_i=847 h=6.35mm rho=7850 E=207GPa Y=900MPa UTS=1020MPa closure=cylindrical",
    ),
    ("the baseline", "v_i=100"),
];

fn json(arguments: &[&str]) -> Value {
    let output = crate::support::program().args(arguments).arg("--json").output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    serde_json::from_str(&text).unwrap_or_else(|_| panic!("{arguments:?}: {told}"))
}

fn asked(command: &str, changes: &str, more: &[&str]) -> Value {
    let sets: Vec<String> = changes.split_whitespace().map(str::to_owned).collect();
    let mut arguments = vec![command, "thesis-baseline"];
    for set in &sets {
        arguments.extend(["--set", set]);
    }
    arguments.extend(more);
    json(&arguments)
}

/// Returns a command's answer for a shot: the verdict, and the expected limit with its band.
#[track_caller]
fn answer(object: &Value) -> (String, [Option<f64>; 3]) {
    let number = |key: &str| object[key].as_f64();
    let verdict = object["verdict"].as_str().unwrap_or_else(|| panic!("no verdict: {object}"));
    (
        verdict.to_owned(),
        ["expected_low_m_s", "expected_limit_m_s", "expected_high_m_s"].map(number),
    )
}

/// Independent: law, classes and bands in Python with `SciPy`, from the same file of measurements. The ball deforms, and nothing measures the
/// baseline's hemisphere.
const BANDS: [[f64; 3]; 3] = [
    [406.111_420_5, 447.429_107_1, 492.950_446_0],
    [457.606_943_8, 494.673_326_3, 534.742_103_8],
    [522.640_391_2, 598.526_605_9, 685.431_327_7],
];

#[test]
fn valid_every_command_gives_one_answer() {
    let rigid = ["perforates", "stops", "open", "not-measured", "not-measured"];
    for (mount, expected) in [("rigid", rigid), ("sprung", ["not-measured"; 5])] {
        for (at, ((name, shot), verdict)) in SHOTS.iter().zip(expected).enumerate() {
            let changes = format!("mount={mount} {shot}");
            let run = answer(&asked("run", &changes, &[]));
            assert_eq!(run.0, verdict, "{name}, {mount}");
            let band = BANDS.get(at).filter(|_| mount == "rigid");
            for (at, found) in run.1.into_iter().enumerate() {
                assert_eq!(found.is_some(), band.is_some(), "{name}, {mount}");
                let is_near =
                    found.zip(band).is_none_or(|(it, band)| (it / band[at] - 1.0).abs() < 1e-7);
                assert!(is_near, "{name}, {mount}: {found:?}");
            }
            let same = |command: &str, object: &Value| {
                assert_eq!(answer(object), run, "{command}: {name}, {mount}");
            };
            same("limit", &asked("limit", &changes, &[]));
            let compared = asked("compare", &changes, &[]);
            same("compare", &compared);
            same("compare's scene", &compared["candidates"]["scene"]);
            same(
                "montecarlo",
                &asked("montecarlo", &changes, &["--samples", "4", "--vary", "m_p=1%"]),
            );
            let h =
                shot.split_whitespace().find_map(|it| it.strip_prefix("h=")).unwrap_or("25.4mm");
            let over = format!("h={h},1m");
            let swept =
                asked("sweep", &changes, &["--over", &over, "--outputs", "final_penetration_m"]);
            assert_eq!(swept["rows"][0]["verdict"], run.0, "sweep: {name}, {mount}");
        }
    }
}

/// Designs are judged by the shot's own verdict, too: at the thickness of each shot seek, the front of optimise and the report have the
/// answer of `run`; a shot that is not below its band is in no front.
#[test]
fn designs_and_reports_give_the_same_answer() {
    for mount in ["rigid", "sprung"] {
        for (name, shot) in SHOTS {
            let changes = format!("mount={mount} {shot}");
            let value = |key: &str| shot.split_whitespace().find_map(|it| it.strip_prefix(key));
            let run = asked("run", &changes, &[]);
            let in_mm = |text: &str| text.trim_end_matches("mm").parse::<f64>().unwrap();
            let (h, r) =
                (in_mm(value("h=").unwrap_or("25.4mm")), in_mm(value("R=").unwrap_or("6.35mm")));
            let over = format!("h={}mm..{}mm", 0.999 * h, 1.001 * h);
            let goal = format!("thickness_over_diameter={}", 0.5 * h / r);
            let sought = asked("seek", &changes, &["--over", &over, "--goal", &goal]);
            let solution = &sought["solutions"][0];
            assert_eq!(solution["verdict"], run["verdict"], "seek: {name}, {mount}: {sought}");
            let more =
                ["--over", &over, "--minimise", "thickness_over_diameter", "--samples", "64"];
            let front = asked("optimise", &changes, &more);
            let designs = front["designs"].as_array().unwrap();
            let verdicts = ["open", "perforates"];
            assert!(
                designs.is_empty() || !verdicts.contains(&run["verdict"].as_str().unwrap()),
                "{name}, {mount}"
            );
            for design in designs {
                assert_eq!(design["verdict"], run["verdict"], "optimise: {name}, {mount}");
                assert_ne!(design["outcome"], "perforated", "optimise: {name}, {mount}");
            }
            let sets: Vec<&str> =
                changes.split_whitespace().flat_map(|set| ["--set", set]).collect();
            let report = [&["thesis-baseline"], &sets[..], &["-o", "-"]].concat();
            let (html, _) = crate::support::says("report", &report, 0);
            let words = match run["verdict"].as_str().unwrap() {
                "stops" => "stops: ",
                "open" => "open: ",
                "perforates" => "perforates: ",
                _ => "not measured: ",
            };
            assert!(html.contains(words), "report: {name}, {mount}");
        }
    }
}

/// Seek and optimise design for the lower end of the band, and what they find is stopped by its own run and by the verdict. By the law alone
/// 27.6 mm would do against the fragment.
#[test]
fn designs_stop_their_shot() {
    let (_, shot) = SHOTS[0];
    let changes = format!("mount=rigid {shot}");
    let sought =
        asked("seek", &changes, &["--over", "h=20mm..50mm:9", "--goal", "limit_velocity_m_s=500"]);
    let solution = &sought["solutions"][0];
    assert!((number(&solution["expected_low_m_s"]) / 500.0 - 1.0).abs() < 1e-6, "{solution}");
    for objective in ["areal_mass_kg_m2", "plate_mass_kg"] {
        let more = ["--over", "h=10mm..50mm", "--minimise", objective, "--samples", "128"];
        let front = asked("optimise", &changes, &more);
        let designs = front["designs"].as_array().unwrap();
        assert!(!designs.is_empty(), "{front}");
        for design in designs {
            let h = number(&design["h"]);
            let run = asked("run", &format!("{changes} h={h}"), &[]);
            assert_eq!(
                (&run["verdict"], &design["verdict"]),
                (&"stops".into(), &"stops".into()),
                "{design}"
            );
            assert_eq!(run["outcome"], "arrested");
        }
    }
}

/// A ball is measured by nobody: the law decides, and no design is perforated by its own run. The baseline has designs.
#[test]
fn no_design_is_perforated_by_its_own_run() {
    let (_, ball) = SHOTS[3];
    let more = ["--over", "h=2mm..40mm", "--minimise", "plate_mass_kg", "--samples", "128"];
    let front = asked("optimise", &format!("mount=rigid {ball}"), &more);
    let designs = front["designs"].as_array().unwrap();
    assert!(
        designs.iter().all(|it| it["outcome"] == "arrested" && it["verdict"] == "not-measured"),
        "{front}"
    );
    let baseline = asked("optimise", "v_i=100", &["--samples", "256"]);
    let designs = baseline["designs"].as_array().unwrap();
    assert!(!designs.is_empty() && designs.iter().all(|it| it["verdict"] == "not-measured"));
}

/// V50 and the probability of perforation come from the same draws: with the velocity held, as many samples perforate as have a limit
/// below it.
#[test]
fn perforation_and_limit_are_of_the_same_draws() {
    let (_, shot) = SHOTS[0];
    let changes = format!("mount=rigid {shot} v_i=447");
    let more = ["--samples", "400", "--vary", "h=0.001%", "--outputs", "limit_velocity_m_s"];
    let found = asked("montecarlo", &changes, &more);
    let share = number(&found["perforation"]["probability"]);
    let limit = &found["outputs"][0];
    assert_eq!(limit["model_error"], "included");
    let median = number(&limit["quantiles"][3]["value"]);
    // Half of the limits lie below their median, 447.4 m/s: some 5 % of scatter, 400 draws.
    assert!((median / 447.4 - 1.0).abs() < 0.015, "{median}");
    assert!((share - 0.5).abs() < 0.08, "{share}");
}
