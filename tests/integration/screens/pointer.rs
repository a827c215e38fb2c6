//! The mouse, on whole screens: what a click hits is what is drawn there; and pasted text.

use super::bench::{Bench, target};
use super::sweep::{answer, open_map};
use super::{accuracy, search, stability};
use cmra::tui::keymap::Tab;
use cmra::tui::keymap::Target;
use cmra::tui::message::Message;
use cmra::tui::pages::search::study_page::search_words;
use cmra::tui::pages::{explore, numerics, run};
use cmra::tui::theme::GlyphSet;
use cmra_engine::model::variables::VARIABLES;
use cmra_studies::study::accuracy::method::Method;

/// Where a text stands on the screen.
pub(super) fn find(bench: &Bench, text: &str) -> (u16, u16) {
    let screen = bench.screen();
    let (row, line) = screen.lines().enumerate().find(|(_, line)| line.contains(text)).unwrap();
    let column = line[..line.find(text).unwrap()].chars().count();
    (u16::try_from(column).unwrap(), u16::try_from(row).unwrap())
}

pub(super) fn click(bench: &mut Bench, at: (u16, u16)) {
    let hit = target(&bench.app, at).unwrap_or_else(|| panic!("nothing at {at:?}"));
    bench.send(Message::Click(hit));
    bench.answer();
    answer(bench);
}

#[test]
fn a_click_on_a_tab_opens_it_at_every_width() {
    for width in [60, 80, 120] {
        let mut bench = Bench::ascii(width, 24);
        let at = find(&bench, "2:Explore");
        click(&mut bench, at);
        assert_eq!(bench.app.tab, Tab::Explore, "{width}");
        let at = find(&bench, "1");
        click(&mut bench, at);
        assert_eq!(bench.app.tab, Tab::Run, "{width}");
    }
}

/// A click is read with the frame on which a person saw its target; keys before it can have changed the page since.
#[test]
fn a_click_on_what_another_page_showed_does_no_harm() {
    let pages = ["", "2", "3v", "4", "44", "444", "4444", "5", "6", "7"];
    let open = |keys: &str| {
        let mut bench = Bench::ascii(100, 40);
        bench.press(keys);
        bench
    };
    let mut count = 0;
    for seen in pages {
        let bench = open(seen);
        let places = (0..40).flat_map(|row| (0..100).step_by(9).map(move |column| (column, row)));
        let mut targets: Vec<Target> = Vec::new();
        for hit in places.filter_map(|at| target(&bench.app, at)) {
            let is_of_page = !matches!(hit, Target::Tab(_) | Target::Page(_));
            if is_of_page && !targets.contains(&hit) {
                targets.push(hit);
            }
        }
        count += targets.len();
        for now in pages {
            let mut bench = open(now);
            for hit in &targets {
                bench.send(Message::Click(*hit));
            }
            assert!(bench.screen().contains("1:Run"), "{seen} {now}");
        }
    }
    assert!(count > 100, "{count}");
}

#[test]
fn a_click_selects_a_variable_and_takes_no_text_away() {
    let mut bench = Bench::ascii(80, 24);
    let at = find(&bench, "S_y");
    click(&mut bench, at);
    assert_eq!(VARIABLES[bench.app.pages.run.editor.selected].symbol, "S_y");
    assert!(bench.app.field().is_none());
    bench.press("<Enter>");
    // What is being typed is not taken away by a click.
    bench.press("1.6e8");
    let other = find(&bench, "v_i");
    click(&mut bench, other);
    assert_eq!(bench.app.field().unwrap().value(), "1.6e8");
    assert!(bench.message().contains("Enter takes it"), "{}", bench.message());
}

#[test]
fn a_click_in_a_chart_puts_the_crosshair_there() {
    let mut bench = Bench::ascii(160, 50);
    // The label of 60 us stands in the line below.
    let (column, _) = find(&bench, "-60-");
    let at = (column + 1, 20);
    click(&mut bench, at);
    let t_s = bench.app.pages.run.charts.cursor_s.unwrap();
    // A cell of the plot is some 2 us wide.
    assert!((t_s - 60e-6).abs() < 4e-6, "{t_s}");
    assert_eq!((bench.app.pane(), bench.app.pages.run.charts.selected), (run::CHARTS, 1));
}

#[test]
fn a_click_on_a_map_loads_the_design_that_is_drawn_there() {
    let mut bench = open_map("figure-9.7", 11, GlyphSet::Ascii, (120, 36));
    bench.press("2");
    answer(&mut bench);
    // The cell right of the axis in the lowest row of the plot is the first point of both axes.
    // It has the label of the axis at its left.
    let screen = bench.screen();
    let rows = screen.lines().enumerate().filter(|(_, line)| line.contains("||  0+"));
    let (row, line) = rows.last().unwrap();
    let label = line[..line.find("||  0+").unwrap()].chars().count() + 4;
    let (axis, row) = (u16::try_from(label).unwrap() + 1, u16::try_from(row).unwrap());
    click(&mut bench, (axis + 1, row));
    bench.keys("<Enter>");
    assert!((bench.app.scene.mass_ratio() - 0.8).abs() < 1e-12);
    assert_eq!(bench.app.scene.mechanism.spring.coefficient.to_bits(), 0.0_f64.to_bits());
    let hit = target(&bench.app, (axis + 1, 1 + 2)).unwrap();
    assert_eq!(hit, Target::Cell(explore::RESULTS, (0, 10)));
    bench.send(Message::Click(hit));
    bench.keys("<Enter>");
    assert!((bench.app.scene.mechanism.spring.coefficient - 7.5e6).abs() < 1.0);
}

#[test]
fn a_click_on_the_setup_selects_its_row() {
    let mut bench = open_map("figure-9.7", 11, GlyphSet::Ascii, (120, 36));
    bench.press("2");
    answer(&mut bench);
    let at = find(&bench, "  points ");
    click(&mut bench, (at.0 + 2, at.1));
    assert_eq!(bench.app.pane(), explore::SETUP);
    bench.press("<Enter>");
    bench.send(Message::Paste(" 21\n".to_owned()));
    bench.keys("<Enter>");
    assert_eq!(bench.app.scene.sweep.as_ref().unwrap().axes[0].count, 21);
}

#[test]
fn a_click_beside_everything_does_nothing() {
    let mut bench = Bench::ascii(80, 24);
    assert_eq!(target(&bench.app, (79, 23)), None);
    assert_eq!(target(&bench.app, (500, 500)), None);
    bench.press("p");
    // The wheel walks through the dialog's list.
    bench.send(Message::Wheel(false, None));
    bench.press("<Enter>");
    assert_eq!(bench.app.base.name, "rigid-mount");
}

#[test]
fn a_very_long_paste_is_refused_and_the_field_keeps_its_text() {
    let mut bench = Bench::ascii(80, 24);
    bench.press("<Enter>1");
    bench.send(Message::Paste("9".repeat(2_000_000)));
    assert_eq!(bench.app.field().unwrap().value(), "1");
    assert!(bench.message().contains("longer than"), "{}", bench.message());
}

#[test]
fn a_map_without_values_gives_the_reason_and_the_cure() {
    let mut bench = open_map("figure-9.7", 11, GlyphSet::Ascii, (80, 24));
    bench.press("/v_i<Enter><Enter>2000<Enter><Esc>2");
    bench.answer();
    answer(&mut bench);
    insta::assert_snapshot!("surface_all_perforated", bench.screen());
    assert!(bench.screen().contains("perforated") && bench.screen().contains("another output"));
}

/// The selected cell of the map is the one a click hits, wherever in the plot that is.
#[test]
fn a_click_in_the_map_of_stability_moves_the_crosshair_there() {
    // More rows and columns of cells than of the map.
    let mut bench = stability::open(GlyphSet::Ascii, (120, 60));
    let map = bench.app.pages.numerics.stability.map.result.clone().unwrap();
    let (steps, rows) = map.counts();
    // The plot stands right of the values of its rows and above axis and steps.
    let corners = [((7, 3), (0, rows - 1)), ((116, 3), (steps - 1, rows - 1)), ((7, 51), (0, 0))];
    for (at, cell) in corners {
        assert_eq!(target(&bench.app, at), Some(Target::Cell(numerics::STABILITY, cell)), "{at:?}");
        click(&mut bench, at);
        assert_eq!(bench.app.pages.numerics.stability.cursor, Some(cell));
    }
    let below = bench.app.pages.numerics.stability.cursor;
    bench.send(Message::Wheel(true, target(&bench.app, (7, 51))));
    assert_eq!(bench.app.pages.numerics.stability.cursor, below.map(|(step, row)| (step, row + 1)));
    bench.keys("<Tab>");
    stability::answer(&mut bench);
    let name = bench.app.pages.numerics.stability.rows()[1].case.name;
    let at = find(&bench, name);
    click(&mut bench, at);
    assert_eq!(bench.app.pages.numerics.stability.selected, 1);
}

#[test]
fn a_click_in_accuracy_selects_a_method() {
    let mut bench = accuracy::open(GlyphSet::Ascii, (120, 40));
    let at = find(&bench, "RK4 + events");
    click(&mut bench, at);
    assert_eq!(bench.app.pages.numerics.accuracy.method(), Method::Rk4Events);
}

#[test]
fn the_wheel_scrolls_the_log() {
    let mut bench = Bench::ascii(80, 24);
    bench.press("7");
    bench.send(Message::Wheel(false, target(&bench.app, (10, 10))));
    assert_eq!(bench.app.pages.log.scroll, 1);
    bench.send(Message::Wheel(true, target(&bench.app, (10, 10))));
    assert_eq!(bench.app.pages.log.scroll, 0);
}

#[test]
fn a_click_in_a_dialog_selects_and_one_beside_it_does_nothing() {
    let mut bench = Bench::ascii(80, 24);
    bench.press("p");
    let at = find(&bench, "heavy-plate");
    click(&mut bench, at);
    assert!(bench.screen().contains("shows on 1:Run"), "{}", bench.screen());
    assert_eq!(target(&bench.app, (0, 0)), None);
    bench.press("<Enter>");
    assert!((bench.app.scene.mass_ratio() - 5.0).abs() < 1e-12);
}

#[test]
fn a_click_on_a_design_of_a_front_selects_it() {
    let mut bench = Bench::ascii(160, 50);
    bench.press("4");
    search::answer(&mut bench);
    bench.press("4r<Tab>");
    search::answer(&mut bench);
    let before = bench.app.scene.clone();
    // The first design has the greatest stroke of all, at the upper left end of the front.
    bench.keys("lllll");
    assert_ne!(bench.app.pages.search.selected(), 0);
    let screen = bench.screen();
    let is_mark = |line: &str| line.chars().skip(34).position(|c| c == 'o').map(|at| at + 34);
    let mut rows = screen.lines().enumerate().skip(3);
    let (row, column) = rows.find_map(|(y, line)| Some((y, is_mark(line)?))).unwrap();
    let at = (u16::try_from(column).unwrap(), u16::try_from(row).unwrap());
    assert_eq!(target(&bench.app, at), Some(Target::Row(cmra::tui::pages::search::RESULTS, 0)));
    click(&mut bench, at);
    assert_eq!((bench.app.pages.search.selected(), bench.app.tab), (0, Tab::Search));
    assert_eq!(bench.app.scene, before);
}

#[test]
fn a_click_on_a_row_of_results_selects_it_also_below_the_warnings_of_another() {
    let mut bench = search::open(GlyphSet::Ascii, (120, 40));
    bench.keys("<Tab>");
    let results = cmra::tui::pages::search::RESULTS;
    let rows = search_words(&bench.app, 84).body;
    let solutions = rows.iter().take(bench.app.pages.search.choices());
    let texts: Vec<String> = solutions.map(|line| line.0[2..30].to_owned()).collect();
    for (row, text) in texts.iter().enumerate() {
        let hit = target(&bench.app, find(&bench, text));
        assert_eq!(hit, Some(Target::Row(results, row)), "{text}");
    }
    bench.keys("4r");
    search::answer(&mut bench);
    let at = find(&bench, "||  3  ");
    click(&mut bench, (at.0 + 4, at.1));
    assert_eq!(bench.app.pages.search.selected(), 2);
}
