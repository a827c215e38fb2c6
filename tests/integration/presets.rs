//! Every bundled preset: complete, readable, explained, and written back without loss.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::ops::ControlFlow;
use std::sync::Arc;

use cmra::files::bundled::{BASELINE, BUNDLED};
use cmra::files::preset::{self, Preset};
use cmra::files::{read, write};
use cmra_engine::model::run::Sample;
use cmra_engine::model::scene::{ContactModel, Scene};
use cmra_engine::model::simulate::{RunSnapshot, Settings, simulate};
use cmra_engine::model::variables::{VARIABLES, changed, validate};
use cmra_studies::study::{quantities, thesis};

use serde::Deserialize;

use crate::support::{files_in, in_repository};

fn all() -> Vec<Preset> {
    let (presets, unreadable) = preset::list(None);
    assert!(unreadable.is_empty(), "{unreadable:?}");
    presets
}

#[test]
fn the_table_of_bundled_presets_is_the_folder() {
    let in_folder: BTreeSet<String> = files_in(&in_repository("presets"), "toml")
        .iter()
        .map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned())
        .collect();
    let in_table: BTreeSet<String> = BUNDLED.iter().map(|one| one.0.to_owned()).collect();
    assert_eq!(in_table, in_folder);
    assert_eq!(BUNDLED.len(), in_table.len(), "a name stands twice");
    assert_eq!(BUNDLED[0].0, BASELINE);
}

#[test]
fn every_preset_loads_validates_and_is_explained() {
    for preset in all() {
        let name = &preset.name;
        validate(&preset.scene).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(preset.comment.starts_with("Source: "), "{name}");
        assert!(preset.comment.contains("\nExpect: "), "{name}");
        let length = preset.scene.title.chars().count();
        assert!((1..=40).contains(&length), "{name}: title of {length}");
    }
}

#[test]
fn every_preset_is_written_and_read_without_loss() {
    for preset in all() {
        let name = &preset.name;
        let fresh = write::fresh(&preset.scene);
        assert_eq!(read::scene(&fresh, name).unwrap(), preset.scene, "{name}");
        let same = write::updated(&preset.text, name, &preset.scene).unwrap();
        assert_eq!(same, preset.text, "{name}: saving unchanged changes the text");
    }
}

#[test]
fn the_baseline_is_the_default_scene() {
    let baseline = preset::baseline().unwrap().scene;
    let defaults = Scene::default();
    for variable in VARIABLES.iter() {
        assert_eq!(variable.value(&baseline), variable.value(&defaults), "{}", variable.key);
    }
    assert_eq!(baseline.sweep, None);
}

/// Figures 9.2 to 9.12 are the only presets with a sweep but Figure 8.10. `cmra reproduce` shows the trends that section 9.3 describes.
#[test]
fn every_figure_agrees_with_its_caption() {
    // Held: gamma, d, b, k, n; NaN where the figure sweeps it. Ranges of Table 9.2.
    let nan = f64::NAN;
    let ranges = [
        ("gamma", 0.8, 7.0),
        ("d", 0.0, 0.5),
        ("b", 0.0, 2000.0),
        ("k", 0.0, 7.5e6),
        ("n", 0.1, 3.0),
    ];
    let figures = [
        (2, ["gamma", ""], [nan, 0.0, 0.0, 1e5, 1.0]),
        (3, ["d", ""], [1.0, nan, 0.0, 1e5, 1.0]),
        (4, ["b", ""], [1.0, 0.0, nan, 0.0, 1.0]),
        (5, ["k", ""], [1.0, 0.0, 0.0, nan, 1.0]),
        // The caption has k = 1e5; the text fits 1e6 better.
        (6, ["n", ""], [1.0, 0.0, 0.0, 1e6, nan]),
        (7, ["gamma", "k"], [nan, 0.0, 0.0, nan, 1.0]),
        (8, ["gamma", "n"], [nan, 0.0, 0.0, 1e5, nan]),
        (9, ["k", "n"], [1.0, 0.0, 0.0, nan, nan]),
        (10, ["d", "gamma"], [nan, nan, 0.0, 1e5, 1.0]),
        (11, ["d", "k"], [1.0, nan, 0.0, nan, 1.0]),
        (12, ["d", "n"], [1.0, nan, 0.0, 1e5, nan]),
    ];
    let swept = all().into_iter().filter(|it| it.scene.sweep.is_some() && it.name != "figure-8.10");
    let names: Vec<String> = swept.map(|preset| preset.name).collect();
    assert_eq!(names, figures.map(|(figure, ..)| format!("figure-9.{figure}")));
    for (figure, axes, held) in figures {
        let scene = preset::resolve(&format!("figure-9.{figure}"), None).unwrap().scene;
        let sweep = scene.sweep.as_ref().unwrap();
        let names: Vec<&str> = sweep.axes.iter().map(|axis| axis.name.as_str()).collect();
        let expected: Vec<&str> = axes.into_iter().filter(|name| !name.is_empty()).collect();
        assert_eq!(names, expected, "figure 9.{figure}");
        assert_eq!(sweep.outputs, ["percent_of_baseline", "max_plate_displacement_m"]);
        for axis in &sweep.axes {
            let (_, from, to) = *ranges.iter().find(|range| range.0 == axis.name).unwrap();
            assert_eq!([axis.from, axis.to].map(f64::to_bits), [from, to].map(f64::to_bits));
            assert!(!axis.log && axis.count >= 41);
        }
        let (spring, damper) = (&scene.mechanism.spring, scene.mechanism.damper);
        let found = [
            scene.mass_ratio(),
            scene.plate.cocking_m,
            damper.coefficient,
            spring.coefficient,
            spring.exponent,
        ];
        for (found, held) in found.into_iter().zip(held).filter(|(_, held)| !held.is_nan()) {
            assert_eq!(found.to_bits(), held.to_bits(), "figure 9.{figure}");
        }
        // The table of captions has the same values, but for Figure 9.6, where it is the caption's.
        let symbols = ["gamma", "d", "b", "k", "n"];
        for (symbol, value) in thesis::caption(&format!("figure-9.{figure}")) {
            let at = symbols.iter().position(|it| it == symbol).unwrap();
            let is_printed = figure == 6 && *symbol == "k";
            assert!(is_printed || held[at].to_bits() == value.to_bits(), "{figure}: {symbol}");
        }
        assert_eq!(scene.mechanism.damper.exponent.to_bits(), 1f64.to_bits());
    }
}

/// Expected results of a preset; a comment states their source.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Case {
    outcome: String,
    /// Results that must not exist.
    #[serde(default)]
    absent: Vec<String>,
    #[serde(default)]
    expected: BTreeMap<String, Expected>,
}

#[derive(Deserialize)]
struct Expected {
    value: f64,
    /// Relative.
    within: f64,
}

#[test]
fn valid_every_preset_gives_the_expected_results() {
    for preset in all() {
        let name = &preset.name;
        let path = in_repository(&format!("tests/cases/presets/{name}.toml"));
        let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(text.starts_with("# Source: "), "{name}");
        let case: Case = toml::from_str(&text).unwrap_or_else(|error| panic!("{name}: {error}"));
        let scene = Arc::new(preset.scene.clone());
        let run =
            simulate(&scene, &Settings::default(), &mut |_| ControlFlow::Continue(())).unwrap();
        assert!(run.end.is_complete(), "{name}: {}", run.end.words());
        assert_eq!(run.shot_outcome().word(), case.outcome, "{name}");
        // The listing's fixed steps do not keep it.
        let is_kept = run.ledger.residual().abs() < 1e-9;
        assert_eq!(is_kept, scene.contact.model != ContactModel::Appendix, "{name}: energy");
        let value = |key: &str| {
            let column = quantities::find(key).unwrap_or_else(|| panic!("{name}: {key}"));
            column.value(&run)
        };
        for key in &case.absent {
            assert_eq!(value(key), None, "{name}: {key}");
        }
        for (key, Expected { value: wanted, within }) in &case.expected {
            let found = value(key).unwrap_or_else(|| panic!("{name}: no {key}"));
            let error = (found - wanted).abs();
            assert!(
                error <= within * wanted.abs(),
                "{name}: {key} = {found}, expected {wanted} within {within}"
            );
        }
    }
}

/// A number in the text of a preset that is not a result of its own run: the preset, the words with the number first, what is changed
/// in the scene, and the result; `limit` is the ballistic limit.
#[rustfmt::skip]
const SAID: [(&str, &str, &str, &str); 21] = [
    ("appendix-listing", "5.982280 mm", "model=hydrodynamic", "final_penetration_m"),
    ("cocked-plastic", "86.3 m/s left", "g=10", "residual_velocity_m_s"),
    ("concept-bistable-shuttle", "4.568 mm", "spring=power-law k=0", "final_penetration_m"),
    ("concept-buckling-cantilever", "4.568 mm", "spring=power-law k=0", "final_penetration_m"),
    ("concept-buckling-four-bar", "4.568 mm", "spring=power-law k=0", "final_penetration_m"),
    ("figure-9.2", "64.27 % of baseline", "gamma=1", "percent_of_baseline"),
    ("figure-9.3", "64.27 % at d = 0", "d=0", "percent_of_baseline"),
    ("figure-9.3", "1.658338 mm", "d=0.5", "final_penetration_m"),
    ("figure-9.3", "23.3 %", "d=0.5", "percent_of_baseline"),
    ("figure-9.4", "4.568088 mm at b = 0", "b=0", "final_penetration_m"),
    ("figure-9.4", "5.836233 mm", "b=1000", "final_penetration_m"),
    ("figure-9.4", "6.356205 mm", "b=2000", "final_penetration_m"),
    ("figure-9.6", "7.113055 mm at n = 0.1", "n=0.1", "final_penetration_m"),
    ("figure-9.6", "6.919384 mm", "n=0.5", "final_penetration_m"),
    ("free-plate", "347.708052 m/s", "", "limit"),
    ("validation-ap-core", "506.7 m/s", "", "limit"),
    ("validation-ap-core", "399.2 m/s", "closure=double-yield dishing=on C_d=0.106", "limit"),
    ("validation-borvik-cavity", "298.5 m/s", "", "limit"),
    ("validation-borvik", "299.8 m/s", "", "limit"),
    ("validation-thin-sphere", "204.7 m/s", "", "limit"),
    ("validation-thin-sphere", "170.5 with 215", "Y=215e6", "limit"),
];

/// Numbers with a decimal point in the texts that are given, not computed, or that another test computes.
#[rustfmt::skip]
const GIVEN: [(&str, &[&str]); 12] = [
    ("cocked", &["8.7 kN", "25.1 kN", "28.5 times"]),
    ("concept-bistable-shuttle", &["44.1 J"]),
    ("concept-cocked-four-bar", &["14.87 mm"]),
    ("concept-emergent-four-bar", &["1.2 kg"]),
    ("figure-9.8", &["n = 0.22", "n = 0.5", "figure-9.6"]),
    ("figure-9.9", &["n = 1.5", "gamma = 1.5"]),
    ("rigid-mount", &["7.129 mm", "1.516e8 Pa", "7.1260 mm"]),
    ("validation-ap-core", &["1.4 % low", "3.2:"]),
    ("validation-borvik", &["2.6 % high", "0.6, the", "184.5 m/s"]),
    ("validation-borvik-cavity", &["2.2 % high", "0.6. With"]),
    ("validation-rod-6061", &["5.04 Y"]),
    ("yang-xi", &["2.714 ms", "46.2 mm"]),
];

/// Unit of a number in a text, and its size in the unit of results.
fn size_of(unit: &str) -> Option<f64> {
    Some(match unit {
        "mm" | "ms" => 1e-3,
        "us" => 1e-6,
        "kN" => 1e3,
        "m/s" | "%" | "J" | "" => 1.0,
        _ => return None,
    })
}

/// Whether a result is what a number with its digits says, in a unit.
fn is_said(number: &str, size: f64, result: f64) -> bool {
    let decimals = number.split_once('.').map_or(0, |(_, after)| after.len());
    let half = 0.5001 * 10f64.powi(-i32::try_from(decimals).unwrap());
    (result.abs() / size - number.parse::<f64>().unwrap()).abs() <= half
}

/// Every result of a run and of its plates, and where the plate is and how fast at its events.
fn all_results(scene: &Arc<Scene>) -> Vec<f64> {
    let go_on = &mut |_: &RunSnapshot<'_>| ControlFlow::Continue(());
    let run = simulate(scene, &Settings::default(), go_on).unwrap();
    let behind: Vec<_> = run.stack.iter().flat_map(|stack| stack.behind.iter().cloned()).collect();
    let mut first = run.clone();
    first.stack = None;
    let plates = [&run, &first].into_iter().chain(behind.iter().map(|run| &**run));
    let results =
        plates.flat_map(|run| quantities::QUANTITIES.iter().filter_map(|it| it.value(run)));
    let at_events = run
        .series
        .iter()
        .filter(|row| run.events.iter().any(|it| it.t_s.total_cmp(&row.t_s).is_eq()));
    let of_row = |row: &Sample| [row.plate_displacement_m, row.plate_velocity_m_s];
    // The row before an event as well: a stop changes the velocity at once.
    let hits = run.events.iter().map(|it| run.series.partition_point(|row| row.t_s < it.t_s));
    let before = hits.filter_map(|at| run.series.get(at.checked_sub(1)?));
    results.chain(at_events.chain(before).flat_map(of_row)).collect()
}

/// A number of the texts is a result of the preset's run, of a run of [`SAID`], or [`GIVEN`]; a text that is mistaken, or changed, fails.
#[test]
fn numbers_in_the_texts_of_presets_are_those_of_runs() {
    let mut wrong = Vec::new();
    for preset in all() {
        let name = &*preset.name;
        let text = preset.comment.split_once("Expect: ").unwrap().1;
        let mut text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        for (_, words, changes, key) in SAID.iter().filter(|said| said.0 == name) {
            let number = words.split(' ').next().unwrap();
            let unit = words.split(' ').nth(1).unwrap();
            let scene = changed(preset.scene.clone(), changes).unwrap();
            let result = if *key == "limit" {
                cmra_studies::study::limit::velocity_m_s(&scene).unwrap()
            } else {
                let scene = Arc::new(scene);
                let go_on = &mut |_: &RunSnapshot<'_>| ControlFlow::Continue(());
                let run = simulate(&scene, &Settings::default(), go_on).unwrap();
                quantities::find(key).unwrap().value(&run).unwrap()
            };
            if !is_said(number, size_of(unit).unwrap_or(1.0), result) {
                wrong.push(format!("{name}: {words}, and {changes} gives {key} = {result}"));
            }
            assert!(text.contains(words), "{name}: {words}");
            text = text.replacen(words, "", 1);
        }
        for words in GIVEN.iter().filter(|given| given.0 == name).flat_map(|given| given.1) {
            assert!(text.contains(words), "{name}: {words}");
            text = text.replacen(words, "", 1);
        }
        let results = all_results(&Arc::new(preset.scene.clone()));
        let words: Vec<&str> = text.split(' ').collect();
        for (at, word) in words.iter().enumerate() {
            let number = word.trim_matches(|c: char| !c.is_ascii_digit());
            let is_set = at > 0 && words[at - 1] == "=" || word.contains('=');
            if !number.contains('.') || number.parse::<f64>().is_err() || is_set {
                continue;
            }
            // In a list of numbers the last one has the unit.
            let mut units =
                words[at + 1..].iter().map(|it| it.trim_end_matches([',', '.', ':', ';', ')']));
            let size = units.find_map(size_of).unwrap_or(1.0);
            let sizes = [size, 1.0];
            let is_result = |size: f64| results.iter().any(|result| is_said(number, size, *result));
            if !sizes.into_iter().any(is_result) {
                wrong.push(format!("{name}: {number} is no result"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The edges of Figures 9.6 and 9.8 are where the depth falls most steeply with n; in Figure 9.4 it rises ever more slowly up to the end,
/// by more than 3 % in its last quarter.
#[test]
fn edges_and_levels_in_the_texts_of_figures_are_those_of_runs() {
    let depth_m = |changes: &str| {
        let scene = Arc::new(changed(Scene::default(), changes).unwrap());
        let go_on = &mut |_: &RunSnapshot<'_>| ControlFlow::Continue(());
        simulate(&scene, &Settings::BARE, go_on).unwrap().first_arrest.unwrap().penetration_m
    };
    for (k, edge, preset) in [("1e5", 0.22, "figure-9.8"), ("1e6", 0.56, "figure-9.6")] {
        let at = |i: i32| 0.01 * f64::from(i);
        let depths: Vec<f64> = (10..=100).map(|i| depth_m(&format!("k={k} n={}", at(i)))).collect();
        let falls = depths.windows(2).map(|pair| pair[0] - pair[1]);
        let steepest = falls.enumerate().max_by(|a, b| a.1.total_cmp(&b.1)).unwrap().0;
        let found = at(10 + i32::try_from(steepest).unwrap()) + 0.005;
        assert!((found - edge).abs() < 0.02, "{k}: {found}");
        let text = preset::resolve(preset, None).unwrap().comment;
        assert!(text.contains(&format!("{edge}")), "{preset}");
    }
    let depths: Vec<f64> = (0..=4).map(|i| depth_m(&format!("k=0 b={}", 500 * i))).collect();
    let rises: Vec<f64> = depths.windows(2).map(|pair| pair[1] - pair[0]).collect();
    assert!(rises.windows(2).all(|pair| pair[1] < pair[0]), "{rises:?}");
    assert!(rises[3] > 0.03 * depths[3], "{depths:?}");
    let text = preset::resolve("figure-9.4", None).unwrap().comment;
    assert!(text.contains("does not level off"), "{text}");
    // At the first arrest of the preset `cocked` the spring pulls 28.5 times as hard as the grip holds.
    let scene = Arc::new(preset::resolve("cocked", None).unwrap().scene);
    let run = simulate(&scene, &Settings::SERIES, &mut |_| ControlFlow::Continue(())).unwrap();
    let row = run.series.iter().find(|row| row.t_s >= run.first_arrest.unwrap().t_s).unwrap();
    let area_n = 8.7438e3;
    assert!((row.spring_force_n.abs() / 2.0 / (0.1 * area_n) - 28.5).abs() < 0.05);
    assert!((run.interface.demand_ratio.unwrap() * area_n / 25.1e3 - 1.0).abs() < 2e-3);
}
