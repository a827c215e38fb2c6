//! Threats, materials and absorbers in the list of presets.

use cmra::files::library;
use cmra::tui::preset::PresetEntry;
use cmra_engine::model::scene::PlateSize;

use super::bench::Bench;

fn listing(columns: u16) -> Bench {
    let mut bench = Bench::ascii(columns, 24);
    let (entries, problems) = library::list(None);
    assert!(problems.is_empty(), "{problems:?}");
    bench.app.files.presets.extend(entries.into_iter().map(PresetEntry::of_part));
    bench
}

/// The thesis's mass ratio is that of its own shot: with another shot and another plate somebody has to say how large the plate is.
#[test]
fn a_threat_and_a_material_ask_for_the_face_of_the_plate() {
    let mut bench = listing(80);
    bench.keys("pm80<Enter>");
    assert!(bench.app.field().is_none(), "a threat alone keeps the plate");
    bench.keys("psteel-4340<Enter>");
    assert!(bench.app.field().is_some(), "{}", bench.message());
    assert!(bench.message().contains("type the side of its face"), "{}", bench.message());
    bench.keys("150<Enter>");
    assert_eq!(bench.app.scene.plate.size, PlateSize::Face(0.15));
}

/// Enter loads what was typed for or moved to, and nothing else.
#[test]
fn the_picker_loads_nothing_that_was_not_chosen() {
    let mut bench = listing(80);
    let before = bench.app.scene.clone();
    bench.keys("p<Enter>");
    assert_eq!(bench.app.scene, before);
    assert!(bench.message().contains("nothing is loaded"), "{}", bench.message());
    bench.keys("m80");
    assert!(bench.screen().contains("m80-ball"), "{}", bench.screen());
    bench.keys("<Enter>");
    assert_ne!(bench.app.scene, before);
}

#[test]
fn a_threat_changes_its_part_of_the_scene_and_undo_takes_it_back() {
    let mut bench = listing(80);
    bench.keys("pm80");
    let screen = bench.screen();
    for words in ["m80-ball", "threat", "m_p       29.5 g -> 9.5 g", "v_i       100 m/s -> 847 m/s"]
    {
        assert!(screen.contains(words), "{words} is missing from\n{screen}");
    }
    let before = bench.app.scene.clone();
    bench.keys("<Enter>");
    let shot = bench.app.scene.projectile;
    assert_eq!((shot.mass_kg, shot.velocity_m_s), (0.0095, 847.0));
    // Its nose brings the closure and the drag coefficient with it, and nothing else of the plate.
    let target = bench.app.scene.target;
    assert_eq!((target.closure.word(), target.drag_coefficient), ("cylindrical", 0.212));
    assert_eq!(
        (target.thickness_m, target.yield_pa),
        (before.target.thickness_m, before.target.yield_pa)
    );
    // The preset that it is compared with stays.
    assert_eq!(bench.app.base.name, "thesis-baseline");
    bench.keys("u");
    assert_eq!(bench.app.scene, before);
}

#[test]
fn a_threat_that_deforms_warns() {
    let mut bench = listing(120);
    bench.keys("pm80<Enter>");
    assert!(bench.message().contains("lead core"), "{}", bench.message());
}
