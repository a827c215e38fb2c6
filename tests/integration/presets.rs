//! Every bundled preset: complete, readable, explained, and written back without loss.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::ops::ControlFlow;
use std::sync::Arc;

use cmra::files::bundled::{BASELINE, BUNDLED};
use cmra::files::preset::{self, Preset};
use cmra::files::{read, write};
use cmra::model::scene::{ContactModel, Scene};
use cmra::model::simulate::{Settings, simulate};
use cmra::model::variables::{VARIABLES, validate};
use cmra::study::quantities;

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

/// Of Figures 9.2 to 9.12, and no other preset has a sweep. `cmra reproduce` shows the trends that section 9.3 describes.
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
    let swept = all().into_iter().filter(|preset| preset.scene.sweep.is_some());
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
        assert_eq!(scene.mechanism.damper.exponent.to_bits(), 1f64.to_bits());
    }
}

/// What a preset must give, with where the numbers come from in a comment.
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
