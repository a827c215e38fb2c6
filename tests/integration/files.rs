//! Scene files: what is refused and how, comments that survive saving, values that survive writing to the last bit.

use std::fs;

use cmra::files::atomic::OverwritePolicy;
use cmra::files::preset::save_file;
use cmra::files::{read, write};
use cmra_engine::model::scene::{
    Closure, Combination, ContactModel, Nose, PlateSize, Scene, Sweep, SweepAxis,
};
use cmra_engine::model::variables::{self, Allowed, Kind, VARIABLES, Value, validate};
use proptest::prelude::*;

use crate::support::{files_in, in_repository, scene_file};

#[test]
fn invalid_scenes_are_refused_with_place_and_cure() {
    let cases = files_in(&in_repository("tests/cases/invalid"), "toml");
    assert!(cases.len() >= 30, "{} cases", cases.len());
    for path in cases {
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        let text = fs::read_to_string(&path).unwrap();
        let expected: Vec<&str> =
            text.lines().filter_map(|line| line.strip_prefix("# expect: ")).collect();
        assert!(!expected.is_empty(), "{name} expects nothing");
        let message = scene_file(&path).expect_err(&format!("{name} is accepted")).to_string();
        for fragment in expected {
            assert!(message.contains(fragment), "{name}\n  expected: {fragment}\n  got: {message}");
        }
        for line in message.lines() {
            assert!(line.contains(&name), "{name}: no file name in: {line}");
            assert!(!line.ends_with('.'), "{name}: full stop in: {line}");
        }
    }
}

#[test]
fn valid_spellings_are_accepted() {
    let text = "\
        format = 1\n\
        plate = { mass_ratio = 2, cocking_m = 0 }\n\
        projectile.obliquity_deg = 30\n\
        [mechanism]\n\
        spring.coefficient = 1_000_000\n\
        damper = { coefficient = 0x10 }\n\
        stop.position_m = -0\n";
    let scene = read::scene(text, "here").unwrap();
    for (name, shown) in [("gamma", "2"), ("theta", "30"), ("k", "1e6"), ("b", "16")] {
        assert_eq!(variables::find(name).unwrap().show(&scene), shown, "{name}");
    }
    assert_eq!(scene.mechanism.stop.position_m, Some(0.0));
    // What is absent has its default.
    assert_eq!(scene.target, Scene::default().target);
    assert_eq!(read::scene("format = 1", "here").unwrap(), Scene::default());
}

const COMMENTED: &str = "\
# My notes on this plate.
#
# Keep them.
format = 1
title = 'Two plates'   # single quotes

[plate]                # below, not in the usual order
cocking_m   =  50e-3   # measured on Tuesday
mass_ratio = 2.000     # two of them

[mechanism.spring]
# coefficient = 2e5    # tried, too soft
coefficient = 3_000_000.0
# the end
";

const COMMENTED_AND_CHANGED: &str = "\
# My notes on this plate.
#
# Keep them.
format = 1
title = \"Three plates\"   # single quotes

[plate]                # below, not in the usual order
cocking_m   =  0.06   # measured on Tuesday
mass_ratio = 2.000     # two of them

[mechanism.spring]
# coefficient = 2e5    # tried, too soft
coefficient = 3_000_000.0

[interface]
law = \"plastic\"
# the end
";

#[test]
fn comments_order_and_formatting_survive_saving() {
    let mut scene = read::scene(COMMENTED, "mine").unwrap();
    assert_eq!(write::updated(COMMENTED, "mine", &scene).unwrap(), COMMENTED);
    scene.title = "Three plates".to_owned();
    scene.plate.cocking_m = 0.06;
    scene.interface.law = cmra_engine::model::scene::InterfaceLaw::Plastic;
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("mine.toml");
    fs::write(&path, COMMENTED).unwrap();
    save_file(&path, &scene, OverwritePolicy::Keep).unwrap_err();
    assert_eq!(fs::read_to_string(&path).unwrap(), COMMENTED);
    assert_eq!(write::updated(COMMENTED, "mine", &scene).unwrap(), COMMENTED_AND_CHANGED);
    // A scene that is saved over a file takes its title over.
    save_file(&path, &scene, OverwritePolicy::Replace).unwrap();
    scene.title = "Two plates".to_owned();
    let kept = COMMENTED_AND_CHANGED.replace("\"Three plates\"", "'Two plates'");
    assert_eq!(fs::read_to_string(&path).unwrap(), kept);
    assert_eq!(scene_file(&path).unwrap(), scene);
    // Saved under a name of its own it is called that.
    let other = place.path().join("my scene.toml");
    save_file(&other, &scene, OverwritePolicy::Keep).unwrap();
    assert_eq!(scene_file(&other).unwrap().title, "my scene");
}

#[test]
fn a_value_taken_away_takes_its_key_away() {
    let text = "format = 1\n[mechanism.stop]\nposition_m = 0.01 # here\nrestitution = 0.5\n";
    let mut scene = read::scene(text, "here").unwrap();
    scene.mechanism.stop.position_m = None;
    let updated = write::updated(text, "here", &scene).unwrap();
    assert_eq!(updated, "format = 1\n[mechanism.stop]\nrestitution = 0.5\n");
    assert_eq!(read::scene(&updated, "here").unwrap(), scene);
}

#[test]
fn a_fresh_file_names_symbols_beside_values() {
    let text = write::fresh(&Scene::default());
    for line in [
        "format = 1",
        "mass_kg = 0.0295            # m_p",
        "velocity_m_s = 100.0        # v_i",
        "flow_strength_pa = 1.52e8   # S_y",
        "mount = \"sprung\"            # sprung or rigid",
        "[mechanism.spring]",
        "coefficient = 1e5           # k",
        "# horizon_s =               # horizon, omitted",
    ] {
        assert!(text.lines().any(|found| found == line), "{line}\n{text}");
    }
}

/// Any value a variable may have, from two numbers between 0 and 1 and one of any size.
fn value_of(kind: &Kind, size: f64, share: f64) -> Value {
    match kind {
        Kind::Choice { words, .. } => {
            Value::Word(words[if share < 0.5 { 0 } else { words.len() - 1 }])
        }
        Kind::Switch { .. } => Value::Switch(share < 0.5),
        Kind::Number(number) => {
            if number.absent.is_some() && share < 0.3 {
                return Value::Absent;
            }
            let within = |low: f64, high: f64| low + share * (high - low);
            let wanted = match number.allowed {
                Allowed::Between(low, high) | Allowed::Below(low, high) => within(low, high),
                Allowed::Positive | Allowed::From(_) | Allowed::NonNegative => size.abs(),
                Allowed::Any | Allowed::Closing => size,
            };
            if number.allowed.contains(wanted) { Value::Number(wanted) } else { Value::Number(0.5) }
        }
    }
}

fn sweeps() -> impl Strategy<Value = Option<Sweep>> {
    let axis = (1e-9..1.0e9, any::<bool>(), 2usize..=1_000_000).prop_map(|(to, log, count)| {
        SweepAxis { name: "k".to_owned(), from: 1e-10, to, count, log, values: Vec::new() }
    });
    let sweep = (axis, any::<bool>()).prop_map(|(axis, named)| Sweep {
        axes: vec![axis],
        outputs: if named { vec!["stroke_m".to_owned()] } else { Vec::new() },
    });
    proptest::option::of(sweep)
}

prop_compose! {
    fn scenes()(
        numbers in proptest::collection::vec((proptest::num::f64::NORMAL, 0.0..1.0f64), VARIABLES.len()),
        title in "\\PC*",
        notes in ".*",
        sweep in sweeps(),
    ) -> Scene {
        let mut scene = Scene { title, notes, sweep, ..Scene::default() };
        for (variable, (size, share)) in VARIABLES.iter().zip(numbers) {
            variable.set(&mut scene, value_of(&variable.kind, size, share)).unwrap();
        }
        if validate(&scene).is_err() {
            // The rules between two values: the stop lies behind the plate's start, a bistable's unstable position beyond
            // its second stable one, a plate that is too fast for the projectile, another model needs a power law.
            scene.plate.velocity_m_s = -scene.plate.velocity_m_s.abs();
            scene.mechanism.stop.position_m = scene.mechanism.stop.position_m.map(f64::abs);
            scene.mechanism.spring.bistable.unstable_m = None;
            scene.mechanism.combination = Combination::Alone;
            scene.contact.model = ContactModel::Hydrodynamic;
            scene.target.closure = Closure::Given;
            // A plug needs more than a given strength, and only a hemisphere dishes a plate.
            scene.projectile.nose = Nose::Hemispherical;
            scene.stack.elements = scene.stack.elements.round();
            scene.stack.base_thickness_m = Some(0.01);
        }
        if validate(&scene).is_err() {
            // The mass ratio that follows from an extreme mass or face is none.
            scene.plate.size = PlateSize::Ratio(1.0);
        }
        scene
    }
}

/// Equal, and to the last bit.
fn assert_same(a: &Scene, b: &Scene) {
    assert_eq!(a, b);
    for variable in VARIABLES.iter() {
        if let (Value::Number(a), Value::Number(b)) = (variable.value(a), variable.value(b)) {
            assert_eq!(a.to_bits(), b.to_bits(), "{}", variable.key);
        }
    }
}

proptest! {
    #[test]
    fn any_scene_is_written_and_read_to_the_last_bit(scene in scenes()) {
        let fresh = write::fresh(&scene);
        assert_same(&read::scene(&fresh, "fresh").unwrap(), &scene);
        let updated = write::updated(COMMENTED, "mine", &scene).unwrap();
        assert_same(&read::scene(&updated, "updated").unwrap(), &scene);
        for line in COMMENTED.lines().filter(|line| line.starts_with('#')) {
            prop_assert!(updated.contains(line), "{line} is gone");
        }
    }

    #[test]
    fn any_text_is_read_or_refused(text in "(format = 1\n)?(\\PC|\n)*") {
        if let Err(errors) = read::scene(&text, "file") {
            prop_assert!(!errors.problems.is_empty());
        }
    }
}
