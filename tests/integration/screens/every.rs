//! Every tab and the drawing of twelve scenes at four sizes in braille and ASCII: what holds on all of these screens.

use std::sync::Arc;

use super::bench::Bench;
use cmra::files::preset;
use cmra::tui::preset::ReferencePreset;
use cmra::tui::theme::GlyphSet;
use cmra_engine::model::scene::Scene;
use cmra_engine::model::variables::changed;

/// The scenes: presets, or changes of the baseline.
const SCENES: [(&str, &str); 12] = [
    ("thesis-baseline", ""),
    ("rigid-mount", ""),
    ("free-plate", ""),
    ("cocked", ""),
    ("oblique", ""),
    ("thin-plate-perforation", ""),
    ("validation-borvik", ""),
    ("stop", ""),
    ("cocked-plastic", ""),
    ("array-stacked", ""),
    ("thesis-baseline", "model=lumped k_load=1e6"),
    ("figure-8.11", ""),
];
const SIZES: [(u16, u16); 4] = [(60, 16), (80, 24), (120, 36), (160, 48)];
/// The tabs with their pages, and the drawing.
const KEYS: [&str; 15] =
    ["1", "1<Tab>z", "1v", "2", "3", "3v", "4", "44", "444", "4444", "5", "55", "6", "66", "7"];

fn scene(name: &str, pairs: &str) -> Scene {
    changed(preset::resolve(name, None).unwrap().scene, pairs).unwrap()
}

/// Faults of a screen.
fn faults(screen: &str, (columns, rows): (u16, u16)) -> Vec<String> {
    let mut faults = Vec::new();
    let lines: Vec<&str> = screen.lines().collect();
    if lines.len() != usize::from(rows) {
        faults.push(format!("{} lines", lines.len()));
    }
    let is_side = |letter: char| matches!(letter, '|' | '│');
    let is_end = |letter: char| matches!(letter, '|' | '│' | '+' | '┐' | '┘' | '┤' | '├');
    for line in &lines {
        let width = line.chars().count();
        if width > usize::from(columns) {
            faults.push(format!("{width} columns: {line}"));
        }
        // What begins with the side of a frame ends with one, unless text stands right of it.
        let ends = [line.chars().next(), line.chars().next_back()];
        if let [Some(first), Some(last)] = ends
            && is_side(first)
            && width == usize::from(columns)
            && !is_end(last)
        {
            faults.push(format!("a frame is open: {line}"));
        }
        // A title that has no room runs into its corner without a blank.
        let letters: Vec<char> = line.chars().collect();
        for pair in letters.windows(2) {
            if pair[0].is_alphabetic() && matches!(pair[1], '┐') {
                faults.push(format!("a title is cut: {line}"));
            }
        }
    }
    if !lines.last().is_some_and(|line| line.ends_with("q quit")) {
        faults.push(format!("the footer is cut: {:?}", lines.last()));
    }
    faults
}

#[test]
fn no_screen_of_twelve_scenes_is_cut() {
    let mut found = Vec::new();
    for (name, pairs) in SCENES {
        let scene = Arc::new(scene(name, pairs));
        for glyphs in [GlyphSet::Braille, GlyphSet::Ascii] {
            for size in SIZES {
                for keys in KEYS {
                    let mut bench = Bench::open(glyphs, size);
                    let base = ReferencePreset {
                        name: name.to_owned(),
                        is_mine: false,
                        scene: Arc::clone(&scene),
                    };
                    (bench.app.scene, bench.app.base) = (Arc::clone(&scene), base);
                    bench.keys("r");
                    bench.keys(keys);
                    let faults = faults(&bench.screen(), size);
                    let place = format!("{name} {pairs} {size:?} {glyphs} {keys}");
                    found.extend(faults.into_iter().map(|fault| format!("{place}: {fault}")));
                }
            }
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}
