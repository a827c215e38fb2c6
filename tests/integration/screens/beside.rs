//! A measured trace beside the runs of the workbench.

use std::path::PathBuf;
use std::sync::Arc;

use super::bench::Bench;
use cmra::files::read_traces::traces;
use cmra::tui::message::{Effect, EffectReport, FileTask, Message};
use cmra::tui::theme::GlyphSet;
use cmra_studies::report::series::Channel;
use insta::assert_snapshot;

/// Opens a file by its name, as a person does; the answer of the thread for files.
fn open(bench: &mut Bench, name: &str) {
    bench.keys("o");
    bench.keys(name);
    bench.keys("<Enter>");
    let asked = bench.effects.iter().rev().find_map(|effect| match effect {
        Effect::Files(FileTask::Traces(path)) => Some(path.clone()),
        _ => None,
    });
    let asked = asked.expect("a file to read");
    assert_eq!(asked, PathBuf::from("/home/ada/work").join(name));
    let read = traces(name.as_ref()).map(Arc::new).map_err(|error| error.to_string());
    bench.send(Message::Done(EffectReport::Traces(asked, read)));
}

#[test]
fn a_trace_is_drawn_beside_the_run_and_its_difference_stands_in_the_titles() {
    for glyphs in [GlyphSet::Ascii, GlyphSet::Braille] {
        let mut bench = Bench::open(glyphs, (120, 36));
        open(&mut bench, "tests/cases/traces/baseline-scipy.csv");
        assert!(!bench.app.has_dialog(), "{}", bench.screen());
        let screen = bench.screen();
        assert!(screen.contains("difference") && screen.contains("5 traces of"), "{screen}");
        assert_snapshot!(format!("beside_120x36_{glyphs}"), screen);
        // No name takes it away.
        bench.keys("o<C-u><Enter>");
        assert!(bench.app.pages.run.beside.is_none() && !bench.app.has_dialog());
        assert!(!bench.screen().contains("difference"), "{}", bench.screen());
    }
}

#[test]
fn a_file_that_is_none_says_so_in_the_dialog() {
    let mut bench = Bench::ascii(80, 24);
    open(&mut bench, "Cargo.toml");
    assert!(bench.app.has_dialog(), "{}", bench.screen());
    assert!(bench.screen().contains("no column of time"), "{}", bench.screen());
    assert!(bench.app.pages.run.beside.is_none());
}

/// At 80 columns the words are shorter, and the chart keeps its name.
#[test]
fn every_title_of_a_traced_quantity_has_its_difference() {
    let mut bench = Bench::ascii(80, 24);
    open(&mut bench, "tests/cases/traces/baseline-scipy.csv");
    let screen = bench.screen();
    for name in ["- Depth ", "- Force, peak ", "- Plate "] {
        let title = screen.lines().find_map(|line| line.split_once(name));
        assert!(title.is_some_and(|(_, rest)| rest.contains("difference ")), "{name}: {screen}");
    }
}

/// A quantity without a chart gets one.
#[test]
fn the_charts_are_those_of_the_traces() {
    let mut bench = Bench::ascii(80, 24);
    open(&mut bench, "tests/cases/traces/baseline-scipy.csv");
    let shown = bench.app.pages.run.charts.quantities;
    assert!(shown.contains(&Channel::Penetration) && shown.contains(&Channel::PlateDisplacement));
    bench.app.pages.run.charts.quantities =
        [Channel::SpringForce, Channel::DamperForce, Channel::Stress];
    open(&mut bench, "tests/cases/traces/yang-xi.csv");
    assert_eq!(bench.app.pages.run.charts.quantities[2], Channel::PlateDisplacement);
}
