//! A spring's measured curve in the workbench: choosing the kind requests the file, which becomes one edit.

use std::sync::Arc;

use cmra::model::scene::SpringKind;
use cmra::model::variables::VARIABLES;
use cmra::tui::message::{Effect, EffectReport, FileTask, Message};

use super::bench::Bench;

/// The workbench with the dialog open: `table` is the last of the spring's words.
fn asking() -> Bench {
    let mut bench = Bench::ascii(80, 24);
    bench.app.pages.run.editor.selected =
        VARIABLES.iter().position(|one| one.key == "mechanism.spring.kind").unwrap();
    bench.keys("<Enter>G<Enter>");
    bench
}

fn report(bench: &mut Bench, points: Result<&[[f64; 2]], &str>) {
    let points = points.map(Arc::from).map_err(str::to_owned);
    let path = bench.app.files.directory.join("measured/curve.csv");
    bench.send(Message::Done(EffectReport::Curve(path, points)));
}

#[test]
fn choosing_the_kind_asks_for_the_file_and_takes_its_points_as_one_edit() {
    let mut bench = asking();
    assert_eq!(bench.app.scene.mechanism.spring.kind, SpringKind::Table);
    let screen = bench.screen();
    for words in ["Measured curve of the spring", "0.01,1000", "3 points, x = 0 to 0.05 m"] {
        assert!(screen.contains(words), "{words} is missing from\n{screen}");
    }
    bench.effects.clear();
    bench.keys("measured/curve.csv<Enter>");
    let wanted = bench.app.files.directory.join("measured/curve.csv");
    assert!(
        matches!(&bench.effects[..], [Effect::Files(FileTask::ReadCurve(path))] if *path == wanted),
        "{:?}",
        bench.effects
    );
    // What is wrong with the file is reported where its name was typed, and nothing is lost.
    report(&mut bench, Err("`curve.csv`, line 3: `0.002;900` is not a point"));
    assert!(bench.screen().contains("line 3"), "{}", bench.screen());
    report(&mut bench, Ok(&[[0.0, 0.0], [0.0, 900.0]]));
    assert!(bench.screen().contains("must rise in x"), "{}", bench.screen());
    let before = Arc::clone(&bench.app.scene);
    report(&mut bench, Ok(&[[-0.1, -3e3], [0.0, 0.0], [0.1, 4e3]]));
    assert!(!bench.app.has_dialog() && bench.message().contains("3 points from curve.csv"));
    assert!(bench.app.scene.mechanism.spring.table.points[0][0] < -0.09);
    assert!(bench.screen().contains("3 points"), "{}", bench.screen());
    bench.keys("u");
    assert_eq!(bench.app.scene, before);
}

#[test]
fn leaving_the_dialog_keeps_the_points_there_are() {
    let mut bench = asking();
    bench.keys("<Enter>");
    assert!(bench.screen().contains("needs a file name"), "{}", bench.screen());
    bench.keys("<Esc>");
    assert!(!bench.app.has_dialog());
    assert_eq!(bench.app.scene.mechanism.spring.kind, SpringKind::Table);
    assert_eq!(bench.app.scene.mechanism.spring.table.points.len(), 3);
}
