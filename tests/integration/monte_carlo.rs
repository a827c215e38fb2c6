//! `cmra montecarlo` as a user meets it.

use serde_json::Value;

use crate::support::{json, number, printed, says};

/// Velocities uniform about the rigid limit of 232.295378 m/s in closed form: half perforate.
#[test]
fn the_probability_of_perforation_is_that_of_the_velocity() {
    let asked = [
        "rigid-mount",
        "--set",
        "v_i=232.295378",
        "--vary",
        "v_i=uniform:192.295378..272.295378",
        "--json",
    ];
    let (text, _) = says(
        "montecarlo",
        &[&asked[..], &["--samples", "3000", "--outputs", "percent_of_baseline"]].concat(),
        0,
    );
    let found: Value = serde_json::from_str(&text).unwrap();
    let chance = &found["perforation"];
    let at = |key: &str| chance[key].as_f64().unwrap();
    assert!(
        at("low_95") < 0.5 && at("high_95") > 0.5 && at("high_95") - at("low_95") < 0.04,
        "{chance}"
    );
    let count = found["outputs"][0]["count"].as_u64().unwrap();
    assert_eq!(count + found["outcomes"]["perforated"].as_u64().unwrap(), 3000);
}

#[test]
fn the_page_has_inputs_outcomes_and_quantiles_and_a_seed_fixes_the_digits() {
    let quick = ["--samples", "200"];
    let (page, _) = says("montecarlo", &quick, 0);
    for words in ["200 samples, seed 1", "v_i=lognormal:2%", "200 arrested", "confidence: 0 to"] {
        assert!(page.contains(words), "{page} lacks {words}");
    }
    assert!(page.contains("system mass") && page.contains("without values: residual velocity"));
    assert_eq!(page, says("montecarlo", &[&quick[..], &["--threads", "1"]].concat(), 0).0);
    assert_ne!(page, says("montecarlo", &[&quick[..], &["--seed", "2"]].concat(), 0).0);
    let (csv, _) =
        says("montecarlo", &[&quick[..], &["--csv", "-", "--outputs", "stroke_m"]].concat(), 0);
    assert!(csv.starts_with("scene,output,nominal,count,mean,"));
    assert_eq!(csv.lines().count(), 2);
    let (page, _) = says(
        "montecarlo",
        &["--vary", "h=normal:100%", "--outputs", "final_penetration_m", "--samples", "100"],
        0,
    );
    assert!(page.contains("truncated:"), "{page}");
}

/// A width of 50 % of the logarithm has a mean of exp(1/8) and a standard deviation of (e^(1/4) - 1)^(1/2) of the mean.
#[test]
fn widths_have_their_units_and_a_lognormal_one_is_of_the_logarithm() {
    let vary = |how: &str| {
        let how = format!("--set m_2=1 --vary {how} --outputs plate_mass_kg --samples 4000");
        let words: Vec<&str> = how.split(' ').collect();
        (printed("montecarlo", &words), json("montecarlo", &words)["outputs"][0].clone())
    };
    for (typed, shown) in [
        ("m_2=normal:5%", "m_2=normal:0.05kg"),
        ("v_i=normal:2%", "v_i=normal:2m/s"),
        ("h=uniform:24mm..27mm", "h=uniform:0.024m..0.027m"),
    ] {
        let (page, _) = vary(typed);
        assert!(page.contains(&format!("  {shown}\n")), "{page}");
    }
    let (_, found) = vary("m_2=lognormal:50%");
    let mean = 0.125_f64.exp();
    let deviation = mean * 0.25_f64.exp_m1().sqrt();
    assert!((number(&found["mean"]) / mean - 1.0).abs() < 0.05, "{found}");
    assert!((number(&found["deviation"]) / deviation - 1.0).abs() < 0.1, "{found}");
    let (help, _) = says("montecarlo", &["--help"], 0);
    let help = help.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(help.contains("standard deviation of the natural logarithm"), "{help}");
}

/// V50 is corrected for the known error of the class of shots; the bare limit stands beside it, and options replace the known error.
#[test]
fn a_limit_velocity_has_the_error_of_the_model() {
    let core = "--set nose=pointed --set m_p=5.3g --set R=3.1242mm --set h=12mm --set rho=2700 --set E=70GPa --set Y=260MPa \
                --set UTS=290MPa --set closure=cylindrical --set mount=rigid";
    let v50 = |more: &str| {
        let line = format!("{core} --outputs limit_velocity_m_s --samples 60 --json {more}");
        let words: Vec<&str> = line.split_whitespace().collect();
        serde_json::from_str::<Value>(&says("montecarlo", &words, 0).0).unwrap()
    };
    let found = v50("");
    let number = |it: &Value, key: &str| it[key].as_f64().unwrap();
    // The bias of the class: exp(0.0109838) - 1.
    assert!((number(&found["model_error"], "bias") - 0.011_044_356).abs() < 1e-8);
    let [both, bare] = [0, 1].map(|at| found["outputs"][at].clone());
    assert_eq!((&both["model_error"], &bare["model_error"]), (&"included".into(), &().into()));
    let corrected = number(&both, "nominal") / number(&bare, "nominal");
    assert!((corrected * 1.011_044_356 - 1.0).abs() < 1e-8);
    assert!(number(&both, "deviation") > 1.5 * number(&bare, "deviation"));
    let none = v50("--model-bias 0 --model-spread 0");
    assert_eq!(none["outputs"].as_array().unwrap().len(), 1);
    let (_, error) = says("montecarlo", &["--model-bias", "-4%"], 2);
    assert!(error.contains("add --outputs limit_velocity_m_s"), "{error}");
}

/// The bias and the scatter of a limit are those of its class, which `limit` shows as an expected value and a band of 90 %: 1.645 to 2
/// standard deviations to either side, for the scatter of a few rows is not known better.
#[test]
fn the_error_of_the_model_is_the_one_that_limit_shows() {
    for shot in ["m2-ap-core --material rha", "m2-ap-core --material aa6082-t651"] {
        let line = format!("--threat {shot} --set h=12mm --set mount=rigid");
        let shot: Vec<&str> = line.split(' ').collect();
        let limit = json("limit", &shot);
        let limit = |key: &str| number(&limit[key]);
        let more = ["--outputs", "limit_velocity_m_s", "--samples", "20"];
        let found = json("montecarlo", &[&shot[..], &more].concat());
        let error = |key: &str| number(&found["model_error"][key]);
        let expected = limit("limit_velocity_m_s") / (1.0 + error("bias"));
        assert!((expected / limit("expected_limit_m_s") - 1.0).abs() < 1e-12, "{line}");
        let half = 0.5 * (limit("expected_high_m_s") / limit("expected_low_m_s")).ln();
        let deviations = half / error("spread");
        assert!((1.645..2.0).contains(&deviations), "{line}: {deviations}");
    }
}

#[test]
fn bad_tolerances_are_refused_before_anything_runs() {
    for (arguments, told) in [
        (&["--vary", "v_i"][..], "NAME=DISTRIBUTION"),
        (&["--vary", "v_i=gauss:2%"], "not a distribution"),
        (&["--vary", "d=normal:2%"], "a percentage of 0"),
        (&["--vary", "v_i=2%", "--vary", "v_i=1%"], "scatters twice"),
        (&["--samples", "1"], "outside 2 to"),
        (&["--outputs", "depth"], "output depth"),
    ] {
        let (_, error) = says("montecarlo", arguments, 2);
        assert!(error.contains(told), "{error}");
    }
}
