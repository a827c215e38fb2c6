//! Panes, tabs and rows: where the keys go, what has room, what a click hits.

use std::sync::Arc;

use super::bench::{Bench, target};
use super::pointer::{click, find};
use super::{stability, sweep};
use cmra::tui::keymap::Tab;
use cmra::tui::keymap::Target;
use cmra::tui::message::Message;
use cmra::tui::pages::{explore, run};
use cmra::tui::theme::GlyphSet;
use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

#[test]
fn the_focus_belongs_to_the_tab() {
    let mut bench = sweep::open("figure-9.2", 5, GlyphSet::Ascii, (80, 24));
    bench.keys("2<Tab>");
    assert_eq!(bench.app.pane(), explore::SETUP);
    let before = Arc::clone(&bench.app.scene);
    bench.keys("30ll");
    assert_eq!(bench.app.pane(), cmra::tui::pages::limit::EFFICIENCY_MAP);
    assert_eq!(bench.app.scene, before);
    bench.keys("2");
    assert_eq!(bench.app.pane(), explore::SETUP, "each tab keeps its own");
}

#[test]
fn messages_never_move_the_panes() {
    for size in [(60, 16), (80, 24), (120, 40)] {
        let mut bench = Bench::ascii(size.0, size.1);
        let before = bench.app.layout().body;
        let long = "a message that is far too long for one row of any screen ".repeat(6);
        bench.app.say(cmra::tui::app::notice::Severity::Warning, long);
        assert_eq!(bench.app.layout().body, before);
    }
}

/// `z` and Space in the Log leave the Run tab as it is.
#[test]
fn keys_do_not_change_another_tab() {
    let mut bench = Bench::ascii(120, 40);
    let before = bench.screen();
    bench.keys("7z v<Esc>1");
    assert_eq!(bench.screen(), before);
    assert!(bench.app.pins.is_empty());
}

#[test]
fn the_smallest_screens_cut_no_word() {
    for size in [(20, 5), (25, 4), (12, 3), (40, 12)] {
        let bench = Bench::ascii(size.0, size.1);
        let screen = bench.screen();
        assert!(screen.contains("60x16"), "{screen}");
        assert!(!screen.contains("terminal la") || screen.contains("terminal larger"), "{screen}");
    }
}

#[test]
fn the_first_start_says_how_to_begin_until_the_first_edit() {
    let mut bench = Bench::ascii(80, 24);
    bench.app.first_run = true;
    let screen = bench.screen();
    assert!(screen.contains("Move j/k, change h/l, type Enter, 2 explore"), "{screen}");
    assert!(screen.contains(" gamma: mass ratio"), "the meaning stays: {screen}");
    bench.keys("jjl");
    assert!(!bench.screen().contains("Move j/k"), "{}", bench.screen());
}

/// From 100 columns a noun stands beside each symbol, whole.
#[test]
fn labels_of_variables_are_whole_nouns() {
    for size in [(100, 60), (120, 60), (200, 80)] {
        let bench = Bench::ascii(size.0, size.1);
        let screen = bench.screen();
        let list = screen.lines().filter_map(|line| line.get(..52)).collect::<Vec<_>>();
        assert!(list.iter().all(|line| !line.contains("..")), "{screen}");
        for row in ["h      plate thickness", "gamma  mass ratio", "k      stiffness"] {
            assert!(list.iter().any(|line| line.contains(row)), "{row}: {screen}");
        }
    }
}

/// A terminal sends `Esc` with a key right behind it as that key with Alt: both count.
#[test]
fn a_key_in_the_same_read_as_an_escape_is_that_key() {
    let alt = |c| Message::Key(KeyEvent::new(KeyCode::Char(c), KeyModifiers::ALT));
    let mut bench = Bench::ascii(80, 24);
    bench.press("?");
    bench.send(alt('2'));
    assert!(!bench.app.has_dialog());
    assert_eq!(bench.app.tab, Tab::Explore);
    bench.press("1<Enter>");
    bench.send(alt('2'));
    assert!(bench.app.field().is_none());
    assert_eq!(bench.app.tab, Tab::Explore);
}

#[test]
fn the_title_row_names_the_preset_in_full_as_far_as_it_has_room() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("jjl");
    let screen = bench.screen();
    assert!(screen.lines().next().unwrap().ends_with(" thesis-baseline *"), "{screen}");
}

#[test]
fn a_key_without_effect_says_so() {
    let mut bench = Bench::ascii(80, 24);
    for (keys, said) in [
        ("n", "`n` does nothing here: ? lists the keys"),
        ("J", "`J` does nothing here: ? lists the keys"),
        ("7<Enter>", "`Enter` does nothing here: ? lists the keys"),
    ] {
        bench.press(keys);
        assert!(bench.message().ends_with(said), "{}", bench.message());
    }
}

#[test]
fn lists_and_maps_have_their_ends_and_their_pages() {
    let mut bench = stability::open(GlyphSet::Ascii, (80, 24));
    let (column, row) = bench.app.pages.numerics.stability.cursor().unwrap();
    // On the scene itself its words stay in one row: a second one would move the map.
    assert!(bench.message().starts_with("the scene: "), "{}", bench.message());
    bench.keys("<PgUp>");
    assert_eq!(bench.app.pages.numerics.stability.cursor(), Some((column, row + 10)));
    bench.keys("<PgDn>");
    assert_eq!(bench.app.pages.numerics.stability.cursor(), Some((column, row)));
}

#[test]
fn a_click_selects_a_run_and_one_beside_them_takes_the_keys_there() {
    let mut bench = Bench::ascii(160, 45);
    bench.press(" ll ");
    let at = find(&bench, "+B");
    assert_eq!(target(&bench.app, at), Some(Target::Row(run::RUNS, 2)));
    click(&mut bench, at);
    assert_eq!((bench.app.pane(), bench.app.pages.run.selected), (run::RUNS, 2));
    let first = find(&bench, "oA ");
    click(&mut bench, first);
    assert_eq!(bench.app.pages.run.selected, 1);
    let heading = find(&bench, "Design variables");
    click(&mut bench, heading);
    assert_eq!(bench.app.pane(), run::VARIABLES);
}

#[test]
fn on_a_screen_too_small_the_mouse_does_nothing() {
    let mut bench = Bench::ascii(40, 12);
    let before = bench.app.pages.run.editor.selected;
    for at in [(0, 0), (10, 0), (20, 6)] {
        assert_eq!(target(&bench.app, at), None);
    }
    bench.send(Message::Wheel(false, None));
    bench.send(Message::Paste("1".to_owned()));
    assert_eq!((bench.app.pages.run.editor.selected, bench.app.tab), (before, Tab::Run));
}

/// A variable that an edit takes out of the list leaves the selection to a row of the list.
#[test]
fn the_selection_stays_in_the_list_of_variables() {
    let mut bench = Bench::ascii(80, 24);
    bench.keys("/m_2<Enter>h");
    assert!(bench.message().contains("cannot be stepped to less"), "{}", bench.message());
    let of_mass = bench.app.pages.run.editor.selected;
    bench.keys("<Enter>5<Enter>");
    bench.keys("/mount<Enter>l");
    bench.keys("<Esc>");
    let listed = bench.app.pages.run.editor.listed(&bench.app.scene);
    assert!(listed.contains(&of_mass), "{:?}\n{}", bench.app.scene.plate, bench.screen());
    bench.app.pages.run.editor.selected = of_mass;
    bench.keys("d");
    assert!(!bench.app.pages.run.editor.listed(&bench.app.scene).contains(&of_mass));
    assert!(bench.app.pages.run.editor.shows(&bench.app.scene), "{}", bench.screen());
}

#[test]
fn tabs_have_their_full_names_and_the_scene_where_there_is_room() {
    let name = "a-name-of-thirty-characters-xy";
    for (width, whole) in [(80, false), (100, true), (120, true), (160, true)] {
        let mut bench = Bench::ascii(width, 24);
        bench.app.base.name = name.to_owned();
        let title = bench.screen().lines().next().unwrap().to_owned();
        assert_eq!(title.contains(name), whole, "{title}");
        assert!(title.contains("7:Log"), "{title}");
    }
}
