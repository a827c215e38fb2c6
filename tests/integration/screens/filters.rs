//! `/` in tables: the rows that match are listed, Enter, Space and e act on them, and Esc lists all again.

use super::bench::Bench;
use super::{limit, search, stability, sweep};
use cmra::study::stability::cases::CASES;
use cmra::tui::theme::GlyphSet;

const NO_MATCH: &str = "no row matches: Esc shows all of them";

/// The rows of the table written by `e`, without its heading.
fn written(bench: &mut Bench) -> Vec<String> {
    bench.keys("e<Enter>");
    let (_, text, _) = bench.exported().expect("an export");
    bench.keys("<Esc>");
    text.lines().skip(1).map(str::to_owned).collect()
}

#[test]
fn the_table_of_runs_lists_those_that_match_and_keys_act_on_them() {
    let mut bench = Bench::ascii(120, 40);
    bench.keys(" jjL L<Tab><Tab>");
    assert_eq!(bench.app.run_order(), [0, 1, 2]);
    let before = bench.app.scene.clone();
    // The letter first, then the name with a word that begins so.
    bench.keys("/B<Enter>");
    assert_eq!((bench.app.run_order(), bench.app.pages.run.selected), (vec![2, 1], 2));
    bench.keys("/thesis<Enter>");
    assert!(bench.screen().contains("/thesis"), "{}", bench.screen());
    assert_eq!((bench.app.run_order(), bench.app.pages.run.selected), (vec![1], 1));
    bench.keys("e");
    let screen = bench.screen();
    assert!(screen.contains("[x] A") && screen.contains("[ ] B"), "{screen}");
    bench.keys("<Esc><Enter>");
    assert_eq!(bench.app.scene, bench.app.pins[0].scene);
    assert_ne!(bench.app.scene, before);
    // The scene has that name now; the selected row is still the pin.
    assert_eq!((bench.app.run_order(), bench.app.pages.run.selected), (vec![0, 1], 1));
    bench.keys(" ");
    assert_eq!(bench.app.pins.iter().map(|pin| pin.letter).collect::<String>(), "B");
    assert_eq!((bench.app.run_order(), bench.app.pages.run.selected), (vec![0], 0));
    bench.keys("/zz<Enter>");
    assert!(bench.app.run_order().is_empty());
    assert!(bench.screen().contains(NO_MATCH), "{}", bench.screen());
    for key in ["<Enter>", " ", "V", "e", "y"] {
        bench.keys(key);
        assert_eq!(bench.message(), NO_MATCH, "{key}");
    }
    assert_eq!(bench.app.pins.len(), 1);
    bench.keys("<Esc>");
    assert_eq!(bench.app.run_order(), [0, 1]);
    assert!(!bench.screen().contains("/zz"), "{}", bench.screen());
}

#[test]
fn the_stiff_scenes_are_filtered_sorted_and_written_as_they_are_listed() {
    for size in [(60, 16), (80, 24), (120, 40)] {
        let mut bench = stability::open(GlyphSet::Ascii, size);
        bench.keys("<Tab>");
        stability::answer(&mut bench);
        let third = CASES[2].name.to_string();
        bench.keys(&format!("/{third}<Enter>"));
        let tab = &bench.app.pages.numerics.stability;
        assert_eq!(tab.listed()[0].case.name.to_string(), third, "the whole name first");
        assert!(tab.listed().len() < 12, "{}", tab.listed().len());
        assert!(bench.screen().contains(&format!(" /{third} ")), "{}", bench.screen());
        assert!(bench.message().starts_with(&third), "{}", bench.message());
        let count = tab.listed().len();
        assert_eq!(written(&mut bench).len(), count);
        // Only the third one fails.
        bench.keys("/FAIL<Enter>");
        assert_eq!(bench.app.pages.numerics.stability.order(), [2]);
        bench.keys("/zzz<Enter>e");
        assert_eq!(bench.message(), NO_MATCH);
        bench.keys("<Esc>");
        let tab = &bench.app.pages.numerics.stability;
        assert_eq!((tab.order().len(), tab.selected), (12, 2), "the selection stays");
    }
}

#[test]
fn the_front_lists_the_designs_that_match_also_where_the_chart_stands_alone() {
    for size in [(60, 16), (80, 24), (120, 40)] {
        let mut bench = search::open(GlyphSet::Ascii, size);
        bench.keys("4");
        search::answer(&mut bench);
        let all = written(&mut bench).len();
        bench.keys("G/knee<Enter>");
        let tab = &bench.app.pages.search;
        assert_eq!((tab.choices(), tab.chosen()), (1, tab.knee()));
        let screen = bench.screen();
        assert!(screen.contains("Pareto front /knee") && screen.contains("> knee"), "{screen}");
        let design = bench.app.search_design().expect("a design");
        bench.keys("<Enter>");
        assert_eq!(*bench.app.scene, design.scene);
        bench.keys("u ");
        assert_eq!(*bench.app.pins[0].scene, design.scene);
        assert_eq!((written(&mut bench).len(), all), (1, 40), "40 designs");
        bench.keys("/zzz<Enter><Enter>");
        assert_eq!(bench.message(), NO_MATCH);
        bench.keys("<Esc>");
        let tab = &bench.app.pages.search;
        assert_eq!((tab.choices(), tab.chosen()), (40, tab.knee()), "the selection stays");
    }
}

#[test]
fn the_other_pages_of_search_list_what_matches_each_for_itself() {
    let mut bench = search::open(GlyphSet::Ascii, (80, 24));
    let solutions = bench.app.pages.search.choices();
    assert!(solutions > 0);
    bench.keys("/zzz<Enter>");
    assert_eq!(bench.app.pages.search.choices(), 0);
    assert!(bench.screen().contains("Goal seek /zzz"), "{}", bench.screen());
    assert!(bench.screen().contains(NO_MATCH), "{}", bench.screen());
    bench.keys("/d<Enter>");
    assert_eq!(bench.app.pages.search.choices(), solutions);
    assert_eq!(written(&mut bench).len(), solutions, "no line but the solutions");
    bench.keys("44");
    search::answer(&mut bench);
    let all = written(&mut bench);
    bench.keys("/gamma<Enter>");
    let own = written(&mut bench);
    assert!(own.len() == 1 && all.len() > 1 && own[0].contains(",gamma,"), "{own:?}");
    bench.keys("4");
    search::answer(&mut bench);
    let all = written(&mut bench);
    bench.keys("/stroke<Enter>");
    let some = written(&mut bench);
    assert!(!some.is_empty() && some.len() < all.len(), "{} of {}", some.len(), all.len());
    assert!(bench.screen().contains("Monte Carlo /stroke"), "{}", bench.screen());
    // Around to the goal seek, whose filter is still there.
    bench.keys("4");
    assert!(bench.screen().contains("Goal seek /d"), "{}", bench.screen());
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
    let found = bench.app.pages.explore.found[1].as_ref().expect("a map");
    let title = found.grid.plan().outputs()[outputs - 1].title();
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
