//! The reproduction report: enough rows, in order, with the verdicts that were looked through and stored.

use std::collections::HashSet;

use cmra::files::bundled::BUNDLED;
use cmra::report::thesis::claims as table_of;
use cmra::study::context::{Context, to_its_end};
use cmra::study::thesis::{self, ClaimVerdict, Evidence, Opens, differences, reproduce, tally};

#[test]
fn every_verdict_is_the_stored_one() {
    let report = reproduce(&mut Context::new(2, &mut to_its_end));
    assert!(report.len() >= 190, "{}", report.len());
    assert_eq!(differences(&report), Vec::<String>::new());
    let counts = tally(&report);
    assert_eq!(counts.iter().sum::<usize>(), report.len());
    assert!(counts.iter().all(|count| *count > 0), "{counts:?}");
    let on = |basis| report.iter().filter(|row| row.found.basis == basis).count();
    assert!(on(Evidence::Read) >= 15 && on(Evidence::Computed) > 150, "{}", on(Evidence::Read));
    // What was computed is reported, unless nothing can be.
    for row in &report {
        let told = !row.found.sound.is_empty() || !row.found.printed.is_empty();
        assert!(told || row.found.verdict == ClaimVerdict::Unchecked, "{}", row.claim.id);
        assert!(
            !row.claim.cause.is_empty() && !row.found.sound.contains("NaN"),
            "{}",
            row.claim.id
        );
    }
    let table = table_of(&report);
    assert_eq!(table.rows.len(), report.len());
    assert!(
        table.csv().starts_with("id,where,says,sound,as_printed,verdict,cause,preset,runs,basis\n")
    );
}

#[test]
fn a_changed_verdict_is_reported() {
    let mut report: Vec<_> = thesis::claims()[2..5].iter().map(thesis::check).collect();
    report[1].found.verdict = ClaimVerdict::Reproduced;
    let told = differences(&report);
    assert!(
        told[0].starts_with("2.3.1-constant: reproduced, stored is reproduced with correction"),
        "{}",
        told[0]
    );
    // The rows that were not computed are missing.
    assert_eq!(told.len(), 1 + thesis::claims().len() - 3);
}

#[test]
fn claims_have_unique_names_and_open_existing_scenes() {
    let mut ids = HashSet::new();
    for claim in thesis::claims() {
        assert!(ids.insert(claim.id), "{} twice", claim.id);
        if let Opens::Preset(name) = claim.opens() {
            assert!(BUNDLED.iter().any(|preset| preset.name == name), "{}: {name}", claim.id);
        }
    }
}

#[test]
fn the_claims_see_the_concepts_as_the_presets_have_them() {
    for concept in cmra::study::screening::CONCEPTS {
        let name = concept.preset;
        let own = thesis::scene(&name.replace('-', "_")).expect(name);
        let preset = cmra::files::preset::resolve(name, None).unwrap().scene;
        assert_eq!(own.mechanism, preset.mechanism, "{name}");
        assert_eq!((own.projectile, own.target), (preset.projectile, preset.target), "{name}");
        assert_eq!((own.plate, own.contact), (preset.plate, preset.contact), "{name}");
    }
}

#[test]
fn the_command_prints_rows_as_text_and_json_and_holds_them_to_the_stored_table() {
    let output = crate::support::program()
        .args(["reproduce", "--only", "A.2", "--json"])
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(0));
    let rows: Vec<serde_json::Value> = serde_json::from_slice(&output.stdout).unwrap();
    assert!(rows.len() >= 5);
    let coupling = rows.iter().find(|row| row["id"] == "A.2-coupling").unwrap();
    assert_eq!(coupling["verdict"], "reproduced with correction");
    assert!(coupling["sound"].as_str().unwrap().starts_with("64."));
    assert!(coupling["as_printed"].as_str().unwrap().starts_with("82."));
}

fn found(id: &str) -> thesis::ClaimResult {
    thesis::check(thesis::find(id).expect(id)).found
}

/// What issue and thesis say, with numbers worked out by hand.
#[test]
fn corrected_rows_quote_the_thesis() {
    // Closed form: limits of 73.459 m/s (rigid) and 109.955 m/s (free, gamma = 1) at 1.52e7 Pa: a tenth of the strength takes
    // the root of ten off 232.295 and 347.708 m/s.
    let strength = found("9.1-strength").sound;
    assert!(strength.contains("perforated on the rigid mount (limit 73.46 m/s)"), "{strength}");
    assert!(strength.contains("held by a free plate of gamma = 1 (limit 110"), "{strength}");
    // Depth is the requirement's measure: 48.9 % of the solid plate's.
    let requirement = found("4.1-requirement");
    assert_eq!(requirement.verdict, ClaimVerdict::TrendHolds, "{}", requirement.sound);
    // 113 us and 185 us to common speed, 1.275 ms until the projectile stands.
    let duration = found("4.4.1-duration").sound;
    for time in ["185.0 us", "1.275 ms", "113."] {
        assert!(duration.contains(time), "{duration}");
    }
    // 100 cos 30 and 100 cos 45.
    let normal = found("4.3.1-normal");
    assert_eq!(normal.verdict, ClaimVerdict::TrendHolds);
    assert!(
        normal.sound.contains("86.60 m/s") && normal.sound.contains("70.71 m/s"),
        "{}",
        normal.sound
    );
    // 0.1 kg of 2710 kg/m3, 25.4 mm thick: 1.5 in a side.
    assert!(found("A.1-case").sound.contains("38.11"), "{}", found("A.1-case").sound);
    // Figure 8.4's caption as printed.
    let figure = found("8.2.2-figure");
    assert!(figure.sound.contains("\"Simple ballistic impact lumped-parameter model\""));
    assert_eq!(figure.basis, Evidence::Read);
    assert_eq!(found("9.5.2-table").basis, Evidence::Read);
    assert_eq!(found("7.1-totals").basis, Evidence::Computed);
    assert_eq!(found("4.1-stone").basis, Evidence::None);
    // What a row varies, and what it holds.
    for (id, settings) in [
        ("9.12a-falls", "d = 0.25 m: "),
        ("9.5.1-low-n", "d = 0.1 m: "),
        ("9.6-mass", "d = 0.1 m: "),
        ("9.6-damping", "d = 0.1 m: "),
    ] {
        assert!(found(id).sound.starts_with(settings), "{}", found(id).sound);
    }
    assert!(found("9.10b-slope").sound.contains("over d = 0 to 0.5 m"));
    assert!(thesis::find("9.2.2-size").is_none());
}

#[test]
fn reproduce_refuses_a_text_without_a_match_and_counts_its_rows() {
    let (page, error, status) = cmra(&["reproduce", "--only", "nope"]);
    assert_eq!((page.as_str(), status), ("", 2));
    assert!(error.contains("--only nope: none of the 199 rows"), "{error}");
    let (page, _, status) = cmra(&["reproduce", "--only", "7.1"]);
    assert_eq!(status, 0);
    assert_eq!(page.lines().last(), Some("Every verdict is the one stored with this program."));
    let counts = page.lines().rfind(|line| line.contains("rows: "));
    assert!(counts.is_some_and(|line| line.contains("read from the text")), "{page}");
}

fn cmra(arguments: &[&str]) -> (String, String, i32) {
    let output = crate::support::program().args(arguments).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (text(output.stdout), text(output.stderr), output.status.code().unwrap())
}

#[test]
fn weights_of_ones_own_change_the_ranking() {
    let (page, _, status) = cmra(&["design", "screening", "--weight", "analysis=0"]);
    assert_eq!(status, 0);
    let fourth = page.lines().find(|line| line.starts_with("   4  ")).unwrap();
    assert!(fourth.contains("Helical rotating spring") && fourth.contains("3.3 (2)"), "{page}");
    for wrong in ["analysis=101", "analysis", "a=5", "magic=5"] {
        let (_, error, status) = cmra(&["design", "screening", "--weight", wrong]);
        assert_eq!(status, 2, "{wrong}");
        assert!(error.contains("ease of analysis"), "{error}");
    }
    let (json, _, _) = cmra(&["design", "principles", "--json"]);
    let rows: Vec<serde_json::Value> = serde_json::from_str(&json).unwrap();
    assert_eq!(rows.len(), 7);
}

#[test]
fn a_shot_beyond_the_critical_obliquity_is_warned_of() {
    let (page, _, status) = cmra(&["design", "shot"]);
    assert_eq!(status, 0);
    assert!(page.contains("critical obliquity") && page.contains("36."), "{page}");
    let steep = ["run", "--set", "theta=50deg", "--json"];
    let (json, _, _) = cmra(&steep);
    assert!(json.contains("ricochet is likely"), "{json}");
    // A stronger rod holds out longer: Tate's tangent falls with the cube root of Y_p.
    let (json, _, _) = cmra(&["run", "--set", "theta=30deg", "--set", "Y_p=1GPa", "--json"]);
    assert!(!json.contains("ricochet"));
    let (json, _, _) = cmra(&["run", "--set", "theta=30deg", "--set", "Y_p=5GPa", "--json"]);
    assert!(json.contains("ricochet"));
}

#[test]
fn principles_and_concepts_link_to_presets_that_exist() {
    let known = |name: &str| BUNDLED.iter().any(|preset| preset.name == name);
    for principle in cmra::study::principles::PRINCIPLES.iter() {
        let mut presets = principle.preset.iter().chain(&principle.see_also);
        assert!(presets.all(|name| known(name)), "{}", principle.name);
    }
    for concept in cmra::study::screening::CONCEPTS {
        assert!(known(concept.preset), "{}", concept.name);
    }
}
