//! Threats, materials and absorbers in the list of presets.

use cmra::files::library;
use cmra::tui::message::PresetEntry;

use super::bench::Bench;

fn listing(columns: u16) -> Bench {
    let mut bench = Bench::ascii(columns, 24);
    let (entries, problems) = library::list(None);
    assert!(problems.is_empty(), "{problems:?}");
    bench.app.presets.extend(entries.into_iter().map(PresetEntry::of_part));
    bench
}

#[test]
fn a_threat_changes_its_part_of_the_scene_and_undo_takes_it_back() {
    let mut bench = listing(80);
    bench.keys("p/m80");
    let screen = bench.screen();
    for words in ["m80-ball", "threat", "m_p       29.5 g -> 9.5 g", "v_i       100 m/s -> 847 m/s"]
    {
        assert!(screen.contains(words), "{words} is missing from\n{screen}");
    }
    let before = bench.app.scene.clone();
    bench.keys("<Enter>");
    let shot = bench.app.scene.projectile;
    assert_eq!((shot.mass_kg, shot.velocity_m_s), (0.0095, 847.0));
    assert_eq!(bench.app.scene.target, before.target);
    // The preset that it is compared with stays.
    assert_eq!(bench.app.base.name, "thesis-baseline");
    bench.keys("u");
    assert_eq!(bench.app.scene, before);
}

#[test]
fn a_blunt_threat_warns() {
    let mut bench = listing(120);
    bench.keys("p/fsp<Enter>");
    assert!(bench.message().contains("blunt chisel nose"), "{}", bench.message());
}
