//! The Stability tab: keys, on a made-up map and battery whose digits never change a picture.

use std::sync::Arc;

use super::bench::{Bench, ended, made, stopped};
use cmra::files::atomic::OverwritePolicy;
use cmra::tui::theme::GlyphSet;
use cmra::worker::studies::{RequestVariant, StabilityMap, StiffScenes, StudyResult};
use cmra_engine::model::scene::Scene;
use cmra_studies::study::accuracy::reference::ReferenceSource;
use cmra_studies::study::stability::cases::CASES;
use cmra_studies::study::stability::map::{
    Cell, FixedStep, Map, MapVariable, SIZE, StabilityMapRequest,
};
use cmra_studies::study::stability::{FailureReason, Row};
use cmra_studies::study::sweep::{Axis, Spacing};

/// A map with a limit that falls with the square root of the value.
pub(super) fn map(method: FixedStep, variable: MapVariable) -> Map {
    let axis = |name, ends, count| Axis::new(name, ends, count, Spacing::Log).unwrap();
    let dt = axis("dt", (1e-9, 1e-4), 61);
    let variable = axis(variable.symbol(), variable.range(), 19);
    let limit = |value: f64| 2.83 / (value / 0.0295).sqrt();
    let cell = |value: f64, dt_s: f64| match dt_s / limit(value) {
        ratio if ratio < 0.5 && dt_s < 3e-6 => Cell::Accurate,
        ratio if ratio < 1.5 => Cell::Inaccurate,
        _ => Cell::BlownUp,
    };
    let (steps, values) = (dt.values(), variable.values());
    Map {
        method,
        cells: values.iter().flat_map(|k| steps.iter().map(|dt_s| cell(*k, *dt_s))).collect(),
        present: 1e5,
        dt,
        variable,
    }
}

/// Rows of the battery; the third falls short.
pub(super) fn rows(count: usize) -> Vec<Row> {
    let row = |(index, case)| Row {
        case,
        run: made(&Arc::new(Scene::default())),
        took_s: 120e-6,
        error: (index != 3).then_some(2e-13),
        basis: Some(ReferenceSource::Dop853),
        shortfall: (index == 2).then_some(FailureReason::Energy),
    };
    CASES.iter().take(count).enumerate().map(row).collect()
}

/// A whole map.
fn whole(method: FixedStep, variable: MapVariable) -> StabilityMapRequest {
    StabilityMapRequest { method, variable, size: SIZE }
}

/// The map that was requested, by its place among the studies.
fn asked(bench: &mut Bench, at: usize) -> StabilityMapRequest {
    StabilityMap::downcast(&bench.studies()[at].request).expect("a map").0
}

/// Answer what was requested.
pub(super) fn answer(bench: &mut Bench) {
    for study in bench.studies() {
        let found = if let Some(asked) = StabilityMap::downcast(&study.request) {
            StudyResult::from(map(asked.0.method, asked.0.variable))
        } else if StiffScenes::downcast(&study.request).is_some() {
            StudyResult::from(rows(12))
        } else {
            continue;
        };
        bench.reply(study.id, ended(found));
    }
}

/// The tab with its map.
pub(super) fn open(glyphs: GlyphSet, size: (u16, u16)) -> Bench {
    let mut bench = Bench::open(glyphs, size);
    bench.keys("55");
    answer(&mut bench);
    bench
}

#[test]
fn the_crosshair_starts_at_the_scene_and_describes_each_cell() {
    let mut bench = open(GlyphSet::Ascii, (120, 40));
    assert!(bench.message().starts_with("the scene: dt "), "{}", bench.message());
    assert!(bench.message().contains("accurate (1 %)"));
    bench.keys("kkkkkkkkkkkkLL");
    assert!(bench.message().ends_with(": diverged"), "{}", bench.message());
    bench.keys("HHHHHHHHjjjjjjjjjjjjjjjjjjjjjjjj");
    assert!(bench.message().starts_with("dt 1e-9 s, k 1000: accurate"), "{}", bench.message());
}

#[test]
fn variable_and_method_are_chosen_and_mapped_again() {
    let mut bench = open(GlyphSet::Ascii, (80, 24));
    bench.keys("v");
    assert_eq!(asked(&mut bench, 0), whole(FixedStep::Thesis, MapVariable::N));
    bench.keys("vv");
    assert_eq!(asked(&mut bench, 1), whole(FixedStep::Rk4, MapVariable::K));
    // A map that came back belongs to what was requested last.
    bench.app.jobs.studies.clear();
    bench.keys("1");
    bench.effects.clear();
    bench.keys("5");
    assert_eq!(asked(&mut bench, 0), whole(FixedStep::Rk4, MapVariable::K));
}

#[test]
fn an_edited_scene_is_mapped_when_the_tab_opens() {
    let mut bench = open(GlyphSet::Ascii, (80, 24));
    bench.keys("15");
    assert!(bench.studies().is_empty());
    bench.keys("1jjl5");
    assert!(bench.screen().contains("computing the map"), "{}", bench.screen());
    assert_eq!(bench.studies()[0].scene, bench.app.scene);
}

#[test]
fn the_stiff_scenes_run_once_can_be_stopped_and_name_failures() {
    let mut bench = open(GlyphSet::Ascii, (80, 24));
    bench.keys("<Tab>");
    let study = bench.studies().remove(0);
    assert!(StiffScenes::downcast(&study.request).is_some());
    let part = StudyResult::from(rows(4));
    bench.part(study.id, (4, 62), part);
    assert!(bench.screen().contains("checking the stiff scenes: 4 of 62 (Esc cancels)"));
    bench.keys("<Esc>");
    assert!(bench.has_cancelled());
    let body = stopped((5, 62), rows(5));
    bench.reply(study.id, body);
    assert!(bench.screen().contains("cancelled: press r (5 of 62) | 4 of 5 scenes pass"));
    bench.keys("jj");
    assert!(bench.message().contains("fails: energy"), "{}", bench.message());
    // Returning to a partial result completes it.
    bench.keys("<Tab><Tab>");
    answer(&mut bench);
    bench.keys("<Tab><Tab>");
    assert!(bench.studies().is_empty());
}

/// The table written last, and its path.
fn exported(bench: &mut Bench) -> (String, String) {
    let (to, text, _) = bench.exported().expect("an export");
    assert_eq!(to.existing, OverwritePolicy::Keep);
    (to.path.display().to_string(), text)
}

#[test]
fn map_and_battery_are_exported_each_where_it_is_shown() {
    let mut bench = open(GlyphSet::Ascii, (120, 40));
    assert!(bench.screen().contains("e export"), "{}", bench.screen());
    bench.keys("e<Enter>");
    let (path, text) = exported(&mut bench);
    assert_eq!(path, "/home/ada/work/thesis-baseline-map.csv");
    let shown = map(FixedStep::Thesis, MapVariable::K);
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let read: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(read.len(), shown.cells.len());
    for (record, cell) in read.iter().zip(&shown.cells) {
        assert_eq!(&record[5], cell.word());
    }
    assert_eq!(read[0][3].parse::<f64>().unwrap().to_bits(), shown.variable.value(0).to_bits());
    bench.keys("<Esc><Tab>e");
    assert!(bench.message().contains("nothing is finished yet"), "{}", bench.message());
    answer(&mut bench);
    bench.keys("e<Enter>");
    let (path, text) = exported(&mut bench);
    assert_eq!(path, "/home/ada/work/battery.csv");
    assert!(text.starts_with("scene,changes,outcome,"), "{text}");
    assert_eq!(text.lines().count(), 13);
}

/// Every file about a scene is named by its preset, changed or not.
#[test]
fn the_map_of_a_changed_scene_is_named_by_its_preset() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("jjl55");
    answer(&mut bench);
    bench.keys("e<Enter>");
    assert_eq!(exported(&mut bench).0, "/home/ada/work/thesis-baseline-map.csv");
}
