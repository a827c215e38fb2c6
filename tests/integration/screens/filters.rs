//! `/` in tables and lists.

use super::bench::Bench;
use super::{limit, search, stability, sweep};
use cmra::study::stability::cases::CASES;
use cmra::tui::theme::GlyphSet;

#[test]
fn a_run_a_design_and_a_stiff_scene_are_found_by_their_names() {
    let mut bench = Bench::ascii(120, 40);
    bench.keys(" jjL L<Tab><Tab>/B<Enter>");
    assert_eq!(bench.app.pages.run.selected, 2);
    let mut bench = search::open(GlyphSet::Ascii, (80, 24));
    bench.keys("4");
    search::answer(&mut bench);
    bench.keys("G/knee<Enter>");
    let tab = &bench.app.pages.search;
    assert_eq!(tab.chosen(), tab.knee());
    let mut bench = stability::open(GlyphSet::Ascii, (80, 24));
    bench.keys("<Tab>");
    stability::answer(&mut bench);
    let third = CASES[2].name.to_string();
    bench.keys(&format!("/{third}<Enter>"));
    assert_eq!(bench.app.pages.numerics.stability.selected, 2);
    assert!(bench.message().starts_with(&third), "{}", bench.message());
}

#[test]
fn the_title_of_the_log_has_its_filter() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("7/energy<Enter>");
    assert!(bench.screen().contains("session /energy"), "{}", bench.screen());
    bench.keys("<Esc>");
    assert!(!bench.screen().contains("/energy"), "{}", bench.screen());
}

#[test]
fn a_quantity_a_shot_and_a_line_of_the_comparison_are_found() {
    let mut bench = sweep::open_map("figure-9.8", 5, GlyphSet::Ascii, (80, 24));
    bench.keys("2");
    sweep::answer(&mut bench);
    let outputs = bench.app.scene.sweep.as_ref().expect("a sweep").outputs.len();
    let found = bench.app.pages.explore.found().expect("a map");
    let title = found.plan().outputs()[outputs - 1].title();
    bench.keys(&format!("/{title}<Enter>"));
    assert_eq!(bench.app.pages.explore.output, outputs - 1, "{title}");
    let mut bench = limit::open(GlyphSet::Ascii, (120, 36));
    bench.keys("/residual<Enter>");
    assert!(bench.message().contains("residual velocity"), "{}", bench.message());
    let mut bench = limit::open(GlyphSet::Ascii, (80, 24));
    bench.keys("<Tab>r");
    search::answer(&mut bench);
    bench.keys("g/stroke<Enter>");
    assert!(bench.app.pages.limit.scrolled > 0, "{}", bench.screen());
    assert!(bench.screen().contains("stroke"), "{}", bench.screen());
}
